//! Sliding and rolling at one contact, solved together.
//!
//! There are four cases, by which of the two slips. While one sticks, its equation eliminates it, and what is
//! left is isotropic in the plane: one projection with the mass that the other feels then. Where
//! both slip two multipliers are found, and the two motions take turns from there. The problem is
//! convex: the first case that does not contradict itself is the answer.
//!
//! Turns bring the pair nearer by k² m_t I each. For bodies whose k² m_t I is nearer to 1 than that
//! of spheres one multiplier is bracketed instead. A multiplier λ ≥ 0 of the rolling limit raises 1/I to
//! 1/I + λ = 1/(s I): rolling takes the share s ≤ 1 of the torque that would stop it, this equation
//! eliminates it as where it sticks, and sliding feels the mass m/(1 − s k² m I). The torque grows
//! with s, for its square less that of the limit is the slope of the dual function, which is concave
//! (Boyd & Vandenberghe, Convex Optimization (2004), section 5.1.2): the share at which it meets the
//! limit lies between one that stays within and one that does not, whatever the masses.

use super::block::{Block, Masses};
use super::dual_slip::DualSlipSystem;
use super::friction::{ContactFriction, TangentialLoad};
use super::modes::ContactVector;
use super::vector::{cross, dot};
use crate::real::Real;
use nalgebra::Vector3;

/// Turns of sliding and rolling while both slip. Each leaves k² m_t I of the distance, so that as many leave
/// 1e-12 of it above [`WEAK`], and 1e-14 for touching solid spheres and plates, whose k² m_t I is at most 5/7.
const MOST_ROUNDS: usize = 96;
/// 1 − k² m_t I below which there are no turns. Where the last one changes no more than
/// [`SETTLED_ULPS`], it is within so many of the answer, divided by this.
const WEAK: f64 = 0.25;
/// Relative change below which the rounds end, in units of rounding.
const SETTLED_ULPS: f64 = 4.0;
/// What is left of one motion when the other is stopped below which the two count as the same, as
/// for a ball on an axle: rounding of the block, in units of it.
const SINGULAR_ULPS: f64 = 64.0;
/// Quotient of bounds above which their logarithms are halved, not they.
const FAR_APART: f64 = 4.0;

/// One contact's sliding and rolling with everything else fixed.
pub(super) struct CoupledSlip<'a, R, F> {
    pub friction: &'a F,
    pub block: &'a Block<R>,
    pub normal: &'a Vector3<R>,
    pub lever: R,
    /// P
    pub bound: R,
    /// Impulses so far; torsion as it would be if it stuck.
    pub old: TangentialLoad<R>,
    pub old_rolling: Vector3<R>,
    /// Velocities under them.
    pub slip: Vector3<R>,
    pub roll: Vector3<R>,
}

impl<'a, R: Real, F: ContactFriction<R>> CoupledSlip<'a, R, F> {
    /// Collects the data of the contact, given its `old` impulses and the `velocity` under them.
    #[inline(always)]
    pub fn new(
        friction: &'a F,
        (block, normal, lever): (&'a Block<R>, &'a Vector3<R>, R),
        bound: R,
        old: &ContactVector<R, F::Modes>,
        velocity: &ContactVector<R, F::Modes>,
    ) -> Self {
        Self {
            friction,
            block,
            normal,
            lever,
            bound,
            old: TangentialLoad {
                sliding: old.sliding(),
                torsion: old.torsion() - block.inertia * velocity.torsion(),
            },
            old_rolling: old.rolling(),
            slip: velocity.sliding(),
            roll: velocity.rolling(),
        }
    }

    /// The impulses that obey their thresholds.
    #[inline(never)]
    pub fn solve(&self) -> (TangentialLoad<R>, Vector3<R>) {
        let (m, inertia, k) = (
            self.block.mass_sliding,
            self.block.inertia,
            self.block.coupling,
        );
        // 1 − k² m I, the share of each mass' inverse that is left when the other motion is stopped.
        // Without k² where its square is out of range, which the share is not.
        let square = k * k;
        let shared = if square > R::MIN_POSITIVE && square < R::INFINITY {
            square * m * inertia
        } else {
            (k * m) * (k * inertia)
        };
        let left = R::ONE - shared;
        let distinct = left > R::from_f64(SINGULAR_ULPS) * R::EPSILON;
        if !distinct {
            return self.share(shared);
        }

        // Rolling sticks: sliding feels the mass m/left.
        let slip = self.slip - cross(&self.roll, self.normal) * (k * inertia);
        let held = self.hold(&slip, m / left);
        let rolling = self.rolling_that_sticks(&held.sliding);
        let turned = self.hold_rolling(&rolling);
        if turned == rolling {
            return (held, rolling);
        }

        // Sliding sticks: rolling feels the moment I/left.
        let roll = self.roll - cross(self.normal, &self.slip) * (k * m);
        let turned = self.hold_rolling(&(self.old_rolling - roll * (inertia / left)));
        let slip = self.slip_after(&turned);
        let sliding = self.old.sliding - slip * m;
        let held = self.hold(&slip, m);
        if held.sliding == sliding {
            return (held, turned);
        }
        if left < R::from_f64(WEAK) {
            return self.share(shared);
        }
        self.alternate_slip(held)
    }

    /// Both slip, from a guess of what sliding does.
    #[cold]
    fn alternate_slip(&self, mut held: TangentialLoad<R>) -> (TangentialLoad<R>, Vector3<R>) {
        let turned = self.hold_rolling(&self.rolling_that_sticks(&held.sliding));
        let mut rolling = self.near_balance(&held.sliding, &turned).unwrap_or(turned);
        held = self.hold(&self.slip_after(&rolling), self.block.mass_sliding);
        for _ in 0..MOST_ROUNDS {
            let turned = self.hold_rolling(&self.rolling_that_sticks(&held.sliding));
            let slid = self.hold(&self.slip_after(&turned), self.block.mass_sliding);
            let settled = negligible(&(turned - rolling), &turned)
                && negligible(&(slid.sliding - held.sliding), &slid.sliding);
            (held, rolling) = (slid, turned);
            if settled {
                break;
            }
        }
        (held, rolling)
    }

    /// Both slip, or are one motion, for any `shared` = k² m I: the share of rolling is bracketed.
    #[cold]
    #[inline(never)]
    fn share(&self, shared: R) -> (TangentialLoad<R>, Vector3<R>) {
        // What sliding feels stays finite.
        let least_left = R::from_f64(SINGULAR_ULPS) * R::EPSILON;
        let distinct = R::ONE - shared > least_left;
        let whole = if distinct {
            R::ONE
        } else {
            (R::ONE - least_left) / shared
        };
        let mut beyond = self.shared(whole, shared);
        let mut turned = self.hold_rolling(&beyond.rolling);
        if turned == beyond.rolling {
            return (beyond.held, turned);
        }
        // A share that stays within the limit, by steps that reach 0 after a dozen.
        let mut step = R::HALF;
        let mut within = loop {
            let part = step * (sum(&turned) / sum(&beyond.rolling));
            let trial = self.shared(beyond.share * part, shared);
            let limited = self.hold_rolling(&trial.rolling);
            let outside = limited != trial.rolling;
            if !(outside && trial.share > R::ZERO) {
                break trial;
            }
            (beyond, turned, step) = (trial, limited, step * step);
        };
        // Halved, by logarithms while that is quicker, until no number lies between.
        loop {
            let (low, high) = (within.share, beyond.share);
            let middle = if high > R::from_f64(FAR_APART) * low {
                low.sqrt() * high.sqrt()
            } else {
                R::HALF * (low + high)
            };
            if !(low < middle && middle < high) {
                return self.between(&within, &beyond);
            }
            let trial = self.shared(middle, shared);
            let inside = self.hold_rolling(&trial.rolling) == trial.rolling;
            *if inside { &mut within } else { &mut beyond } = trial;
        }
    }

    /// The impulses when rolling takes a share of the torque that would stop it.
    fn shared(&self, share: R, shared: R) -> Shared<R> {
        let mass = self.block.mass_sliding / (R::ONE - share * shared);
        let alone = self.rolling_that_sticks(&self.old.sliding) * share;
        let held = self.hold(&self.slip_after(&alone), mass);
        let rolling = self.rolling_that_sticks(&held.sliding) * share;
        Shared {
            share,
            held,
            rolling,
        }
    }

    /// The impulses between two that balance under one multiplier, where rolling meets its limit: all that
    /// lies between them balances as they do, and both may jump from one number to the next.
    fn between(&self, within: &Shared<R>, beyond: &Shared<R>) -> (TangentialLoad<R>, Vector3<R>) {
        let limit = self.hold_rolling(&beyond.rolling);
        let size = sum(&beyond.rolling);
        let way = (beyond.rolling - within.rolling) / size;
        let [start, limit] = [within.rolling, limit].map(|torque| torque / size);
        // |start + x way| = |limit|
        let [square, along] = [dot(&way, &way), dot(&start, &way)];
        let room = dot(&limit, &limit) - dot(&start, &start);
        let root = (along * along + square * room).sqrt();
        let part = if along > R::ZERO {
            room / (along + root)
        } else {
            (root - along) / square
        };
        let part = if part > R::ZERO && part <= R::ONE {
            part
        } else {
            R::ZERO
        };
        let [from, to] = [&within.held, &beyond.held];
        let load = TangentialLoad {
            sliding: from.sliding + (to.sliding - from.sliding) * part,
            torsion: from.torsion + (to.torsion - from.torsion) * part,
        };
        let masses = self.block.masses();
        let held = self.friction.hold(&load, self.bound, self.lever, &masses);
        let rolling = within.rolling + (beyond.rolling - within.rolling) * part;
        (held, self.hold_rolling(&rolling))
    }

    /// The rolling torque at which the turns end, if both thresholds stay what they are now.
    fn near_balance(&self, sliding: &Vector3<R>, rolling: &Vector3<R>) -> Option<Vector3<R>> {
        let (n, k) = (self.normal, self.block.coupling);
        let [inv_mass, inv_inertia] =
            [self.block.mass_sliding, self.block.inertia].map(|m| R::ONE / m);
        let old = cross(n, &self.old_rolling);
        let both = DualSlipSystem {
            inv_mass,
            inv_inertia,
            coupling: k,
            sliding: self.old.sliding * inv_mass - self.slip - old * k,
            rolling: old * inv_inertia - cross(n, &self.roll) - self.old.sliding * k,
        };
        let turned = both.rolling([sliding, &cross(n, rolling)])?;
        sum(&turned).is_finite().then(|| cross(&turned, n))
    }

    /// Sliding velocity after a rolling torque.
    #[inline(always)]
    fn slip_after(&self, rolling: &Vector3<R>) -> Vector3<R> {
        self.slip + cross(&(rolling - self.old_rolling), self.normal) * self.block.coupling
    }

    /// The rolling torque that stops rolling under a sliding force.
    #[inline(always)]
    fn rolling_that_sticks(&self, sliding: &Vector3<R>) -> Vector3<R> {
        let turn = cross(self.normal, &(sliding - self.old.sliding)) * self.block.coupling;
        self.old_rolling - (self.roll + turn) * self.block.inertia
    }

    /// The sliding force and torsion torque that resist `slip` of a given mass.
    #[inline(always)]
    fn hold(&self, slip: &Vector3<R>, mass: R) -> TangentialLoad<R> {
        let trial = TangentialLoad {
            sliding: self.old.sliding - slip * mass,
            torsion: self.old.torsion,
        };
        let masses = Masses {
            sliding: mass,
            torsion: self.block.inertia,
        };
        self.friction.hold(&trial, self.bound, self.lever, &masses)
    }

    #[inline(always)]
    fn hold_rolling(&self, trial: &Vector3<R>) -> Vector3<R> {
        self.friction.hold_rolling(trial, self.bound, self.lever)
    }
}

/// Impulses of which rolling has a given share.
struct Shared<R> {
    /// s
    share: R,
    held: TangentialLoad<R>,
    /// Not yet limited.
    rolling: Vector3<R>,
}

/// In sums of magnitudes: no square that could vanish for small grains.
#[inline(always)]
fn negligible<R: Real>(change: &Vector3<R>, value: &Vector3<R>) -> bool {
    sum(change) <= R::from_f64(SETTLED_ULPS) * R::EPSILON * sum(value)
}

#[inline(always)]
fn sum<R: Real>(v: &Vector3<R>) -> R {
    v.x.abs() + v.y.abs() + v.z.abs()
}
