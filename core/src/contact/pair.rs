//! Sliding and rolling at one contact, solved together.
//!
//! There are four cases, by which of the two slips. While one sticks, its equation eliminates it, and what is
//! left is isotropic in the plane: one projection with the mass that the other feels then. Where
//! both slip two multipliers are found, and the two motions take turns from there. The problem is
//! convex: the first case that does not contradict itself is the answer.

use super::block::{Block, Masses};
use super::both_slip::BothSlip;
use super::friction::{ContactFriction, TangentialLoad};
use super::modes::Modal;
use super::vector::cross;
use crate::real::Real;
use nalgebra::Vector3;

/// Turns of sliding and rolling while both slip. Each brings the pair nearer by k² m_t I, at most
/// 5/7 for touching solid spheres and plates, so that this many leave less than 1e-14. Bodies that turn more
/// easily may be left with more: each impulse obeys its threshold, and the residual of the problem tells the rest.
const MOST_ROUNDS: usize = 96;
/// Relative change below which the rounds end, in units of rounding.
const SETTLED_ULPS: f64 = 4.0;
/// What is left of one motion when the other is stopped below which the two count as the same, as
/// for a ball on an axle: rounding of the block, in units of it.
const SINGULAR_ULPS: f64 = 64.0;

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
        old: &Modal<R, F::Modes>,
        velocity: &Modal<R, F::Modes>,
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
            let held = self.hold(&self.slip, m);
            return self.take_turns(held);
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
        self.take_turns(held)
    }

    /// Both slip, from a guess of what sliding does.
    #[cold]
    fn take_turns(&self, mut held: TangentialLoad<R>) -> (TangentialLoad<R>, Vector3<R>) {
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

    /// The rolling torque at which the turns end, if both thresholds stay what they are now.
    fn near_balance(&self, sliding: &Vector3<R>, rolling: &Vector3<R>) -> Option<Vector3<R>> {
        let (n, k) = (self.normal, self.block.coupling);
        let [inv_mass, inv_inertia] =
            [self.block.mass_sliding, self.block.inertia].map(|m| R::ONE / m);
        let old = cross(n, &self.old_rolling);
        let both = BothSlip {
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

/// In sums of magnitudes: no square that could vanish for small grains.
#[inline(always)]
fn negligible<R: Real>(change: &Vector3<R>, value: &Vector3<R>) -> bool {
    sum(change) <= R::from_f64(SETTLED_ULPS) * R::EPSILON * sum(value)
}

#[inline(always)]
fn sum<R: Real>(v: &Vector3<R>) -> R {
    v.x.abs() + v.y.abs() + v.z.abs()
}
