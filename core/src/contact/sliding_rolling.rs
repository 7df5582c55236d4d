//! Sliding and rolling at one contact, solved together.
//!
//! While one sticks, its equation eliminates it, and what is left is isotropic in the plane: one projection
//! with the mass that the other feels then. The problem is convex: the first case that does not contradict itself
//! is the answer.
//!
//! Where both slip one multiplier is found. A multiplier λ ≥ 0 of the rolling limit raises 1/I to
//! 1/I + λ = 1/(s I): rolling takes the share s ≤ 1 of the torque T that would stop it, this equation
//! eliminates it as where it sticks, and sliding feels the mass m/(1 − s k² m I). The torque s |T| grows
//! with s, for its square less that of the limit is the slope of the dual function, which is concave
//! (Boyd & Vandenberghe, Convex Optimization (2004), section 5.1.2): the share at which it meets the
//! limit b lies between one that stays within and one that does not, whatever the masses. Secants of
//! s − b/|T|, which is nearly linear in s (Moré & Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553),
//! close in on it from both sides.

use super::block::{Block, Masses};
use super::friction::{ContactFriction, TangentialLoad};
use super::modes::ContactVector;
use super::vector::{cross, dot, magnitude};
use crate::real::Real;
use nalgebra::Vector3;

/// What is left of one motion when the other is stopped below which the two count as the same, as
/// for a ball on an axle: rounding of the block, in units of it.
const SINGULAR_ULPS: f64 = 64.0;
/// Secants at most before halvings: most contacts take 6.
const MOST_SECANTS: usize = 24;
/// Least distance of an end from the root, of its share: rounding hides smaller ones, and a step across the root
/// closes the bracket.
const APART_ULPS: f64 = 4.0;
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
        self.solve_sticking()
            .unwrap_or_else(|| self.share(self.shared_inverse()))
    }

    /// 1 less the share of each mass' inverse that is left when the other motion is stopped: k² m I.
    fn shared_inverse(&self) -> R {
        let (m, inertia, k) = (
            self.block.mass_sliding,
            self.block.inertia,
            self.block.coupling,
        );
        // Without k² where its square is out of range, which the product is not.
        let square = k * k;
        if square > R::MIN_POSITIVE && square < R::INFINITY {
            square * m * inertia
        } else {
            (k * m) * (k * inertia)
        }
    }

    /// The impulses where one of the two motions sticks, or both; `None` where both slip or are one motion.
    #[inline(always)]
    pub fn solve_sticking(&self) -> Option<(TangentialLoad<R>, Vector3<R>)> {
        let (m, inertia, k) = (
            self.block.mass_sliding,
            self.block.inertia,
            self.block.coupling,
        );
        let left = R::ONE - self.shared_inverse();
        let distinct = left > R::from_f64(SINGULAR_ULPS) * R::EPSILON;
        if !distinct {
            return None;
        }

        // Rolling sticks: sliding feels the mass m/left.
        let slip = self.slip - cross(&self.roll, self.normal) * (k * inertia);
        let held = self.hold(&slip, m / left);
        let rolling = self.rolling_that_sticks(&held.sliding);
        let turned = self.hold_rolling(&rolling);
        if turned == rolling {
            return Some((held, rolling));
        }

        // Sliding sticks: rolling feels the moment I/left.
        let roll = self.roll - cross(self.normal, &self.slip) * (k * m);
        let turned = self.hold_rolling(&(self.old_rolling - roll * (inertia / left)));
        let slip = self.slip_after(&turned);
        let sliding = self.old.sliding - slip * m;
        let held = self.hold(&slip, m);
        (held.sliding == sliding).then_some((held, turned))
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
        let turned = self.hold_rolling(&beyond.rolling);
        if turned == beyond.rolling {
            return (beyond.held, turned);
        }
        let limit = magnitude(&turned);
        let mut within = self.shared(R::ZERO, shared);
        // Nothing resists rolling, as where the contact is open.
        let resists = limit > R::ZERO;
        if !resists {
            return (within.held, turned);
        }
        let mut distances = [
            within.distance(limit, R::ONE),
            beyond.distance(limit, -R::ONE),
        ];
        let (mut secants, mut last) = (0, None);
        // Until no number lies between the two shares.
        loop {
            let (low, high) = (within.share, beyond.share);
            let root = low + (high - low) * (distances[0] / (distances[0] + distances[1]));
            let next = if secants < MOST_SECANTS && low < root && root < high {
                root
            } else {
                middle(low, high)
            };
            if !(low < next && next < high) {
                return self.between(&within, &beyond);
            }
            secants += 1;
            let trial = self.shared(next, shared);
            // An end that stays twice counts half, so that a secant crosses to it (the Illinois rule).
            let inside = self.hold_rolling(&trial.rolling) == trial.rolling;
            let weight = if last == Some(inside) {
                R::HALF
            } else {
                R::ONE
            };
            last = Some(inside);
            if inside {
                let distance = trial.distance(limit, R::ONE);
                (within, distances) = (trial, [distance, weight * distances[1]]);
            } else {
                let distance = trial.distance(limit, -R::ONE);
                (beyond, distances) = (trial, [weight * distances[0], distance]);
            }
        }
    }

    /// The impulses when rolling takes a share of the torque that would stop it.
    fn shared(&self, share: R, shared: R) -> Shared<R> {
        let mass = self.block.mass_sliding / (R::ONE - share * shared);
        let alone = self.rolling_that_sticks(&self.old.sliding) * share;
        let held = self.hold(&self.slip_after(&alone), mass);
        let stopping = self.rolling_that_sticks(&held.sliding);
        Shared {
            share,
            held,
            stopping,
            rolling: stopping * share,
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
        // As long as the limit, to which both ends are near.
        let torque = start + way * part;
        let length = dot(&torque, &torque).sqrt();
        let rolling = if length > R::ZERO {
            torque * (dot(&limit, &limit).sqrt() / length * size)
        } else {
            torque
        };
        (held, self.hold_rolling(&rolling))
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
    /// T, which would stop rolling.
    stopping: Vector3<R>,
    /// s T, not yet limited.
    rolling: Vector3<R>,
}

impl<R: Real> Shared<R> {
    /// b/|T| − s for the limit b where s |T| stays within it, s − b/|T| where it does not, and no less than the
    /// rounding of both.
    fn distance(&self, limit: R, stays: R) -> R {
        let distance = stays * (limit / magnitude(&self.stopping) - self.share);
        let least = R::from_f64(APART_ULPS) * R::EPSILON * self.share;
        if distance > least { distance } else { least }
    }
}

/// Half-way between two shares, by logarithms while that is quicker.
fn middle<R: Real>(low: R, high: R) -> R {
    if low == R::ZERO {
        // Down to 0 after a dozen.
        R::HALF * high * high
    } else if high > R::from_f64(FAR_APART) * low {
        low.sqrt() * high.sqrt()
    } else {
        R::HALF * (low + high)
    }
}

#[inline(always)]
fn sum<R: Real>(v: &Vector3<R>) -> R {
    v.x.abs() + v.y.abs() + v.z.abs()
}
