//! Laws of springs that yield: one, and several side by side.

use super::super::parameter::Range;
use super::bristles::YIELDING;
use super::form::{Form, around, parameter};
use super::record::Memory;

/// A spring that yields at a force, F = σ₀ z with |F| ≤ F_c.
pub(super) struct ElasticPlastic {
    limit: f64,
    stiffness: f64,
}

impl Memory for ElasticPlastic {
    const FORM: Form = YIELDING;
    const FORGETS: bool = true;
    /// The force.
    type State = f64;

    fn new(values: &[f64]) -> Option<Self> {
        let &[limit, stiffness] = values else {
            return None;
        };
        Some(Self { limit, stiffness })
    }

    fn first(&self, _: f64, friction: f64) -> f64 {
        friction.max(-self.limit).min(self.limit)
    }

    fn shifted(&self, force: f64, _: usize, share: f64) -> f64 {
        (force + share * self.limit)
            .max(-self.limit)
            .min(self.limit)
    }

    fn advance(&self, force: f64, velocity: f64, dt: f64) -> f64 {
        let moved = force + self.stiffness * velocity * dt;
        moved.max(-self.limit).min(self.limit)
    }

    fn friction(&self, force: f64, _: f64) -> f64 {
        force
    }
}

/// Number of springs.
const SPRINGS: usize = 3;

/// Three springs side by side that yield one after the other, with all that was bent before in their memory.
///
/// *Source*: the parallel model of Maxwell slip, F. Al-Bender, V. Lampaert, J. Swevers, IEEE Trans. Automatic Control 50
/// (2005) 1883, without its rate dependence (Masing 1923, Iwan 1966).
pub(super) struct Maxwell([ElasticPlastic; SPRINGS]);

impl Memory for Maxwell {
    const FORM: Form = Form {
        parameters: &[
            parameter(
                "k1",
                "N/m",
                "stiffness of the spring that yields first",
                Range::Positive,
            ),
            parameter("f1", "N", "force at which it yields", Range::Positive),
            parameter(
                "k2",
                "N/m",
                "stiffness of the second spring",
                Range::Positive,
            ),
            parameter("f2", "N", "force at which it yields", Range::Positive),
            parameter(
                "k3",
                "N/m",
                "stiffness of the third spring",
                Range::Positive,
            ),
            parameter("f3", "N", "force at which it yields", Range::Positive),
        ],
        linear: &[],
        ordered: None,
        reference: None,
        start: |guess, unit| {
            // Each yields at several times the deflection of the one before.
            let share = guess.coulomb / SPRINGS as f64;
            let deflection = |k: usize| {
                let spread = libm::pow(6.0, k as f64 - 1.0);
                spread * around(unit[2 * k], 2.5) * guess.coulomb / guess.stiffness
            };
            let spring = |k: usize| {
                let force = share * around(unit[2 * k + 1], 2.0);
                [force / deflection(k), force]
            };
            (0..SPRINGS).flat_map(spring).collect()
        },
    };
    const FORGETS: bool = true;
    const PARTS: usize = SPRINGS;
    type State = [f64; SPRINGS];

    fn new(values: &[f64]) -> Option<Self> {
        let mut springs = values.chunks_exact(2);
        let mut spring = || {
            let &[stiffness, limit] = springs.next()? else {
                return None;
            };
            Some(ElasticPlastic { limit, stiffness })
        };
        Some(Self([spring()?, spring()?, spring()?]))
    }

    /// Springs by the deflection at which they yield.
    fn put_in_order(values: &mut [f64]) {
        let mut springs: Vec<[f64; 2]> = values.as_chunks().0.to_vec();
        springs.sort_by(|[k, f], [l, g]| (f / k).total_cmp(&(g / l)));
        for (value, sorted) in values.iter_mut().zip(springs.as_flattened()) {
            *value = *sorted;
        }
    }

    fn first(&self, velocity: f64, friction: f64) -> Self::State {
        let whole: f64 = self.0.iter().map(|spring| spring.limit).sum();
        std::array::from_fn(|k| self.0[k].first(velocity, friction * self.0[k].limit / whole))
    }

    fn shifted(&self, mut forces: Self::State, part: usize, share: f64) -> Self::State {
        if let Some((force, spring)) = forces.get_mut(part).zip(self.0.get(part)) {
            *force = spring.shifted(*force, 0, share);
        }
        forces
    }

    fn advance(&self, forces: Self::State, velocity: f64, dt: f64) -> Self::State {
        std::array::from_fn(|k| self.0[k].advance(forces[k], velocity, dt))
    }

    fn friction(&self, forces: Self::State, _: f64) -> f64 {
        forces.iter().sum()
    }
}
