//! Sliding and rolling at one contact, solved together.
//!
//! There are four cases, by which of the two slips. While one sticks, its equation eliminates it, and
//! what is left is isotropic in the plane: one projection with the mass that the other feels then.
//! Where both slip two directions are found. The problem is convex: the first case that does not
//! contradict itself is the answer. Thresholds that are independent are [`TwoCircles`]; where sliding
//! is coupled to torsion the two motions take turns from there.

use super::block::{Block, Masses};
use super::friction::{ContactFriction, TangentialLoad};
use super::modes::Modal;
use super::two_circles::TwoCircles;
use super::vector::{cross, magnitude};
use crate::real::Real;
use nalgebra::Vector3;

/// Turns of sliding and rolling while both slip. Each brings the pair nearer by k² m_t I, at most
/// 5/7 for touching solid spheres and plates, so that this many leave less than 1e-14.
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
        // An open contact carries nothing.
        if self.bound == R::ZERO {
            let rolling = self.old_rolling - self.roll * self.block.inertia;
            let held = self.hold(&self.slip, self.block.mass_sliding);
            return (held, self.hold_rolling(&rolling));
        }
        let left = self.left();
        let distinct = left > R::from_f64(SINGULAR_ULPS) * R::EPSILON;
        if !distinct {
            let held = self.hold(&self.slip, self.block.mass_sliding);
            return self.take_turns(held);
        }
        match self.within_circles(left) {
            Some(found) => found,
            None => self.by_cases(left),
        }
    }

    /// 1 − k² m I, the share of each mass' inverse that is left when the other motion is stopped.
    #[inline(always)]
    fn left(&self) -> R {
        let (m, inertia) = (self.block.mass_sliding, self.block.inertia);
        let k = self.block.coupling;
        // Without k² where its square is out of range, which the share is not.
        let square = k * k;
        let shared = if square > R::MIN_POSITIVE && square < R::INFINITY {
            square * m * inertia
        } else {
            (k * m) * (k * inertia)
        };
        R::ONE - shared
    }

    /// The impulses if sliding and rolling have thresholds of their own.
    #[inline(always)]
    fn within_circles(&self, left: R) -> Option<(TangentialLoad<R>, Vector3<R>)> {
        let [sliding, rolling, _] = self.friction.independent_limits()?;
        let limits = [sliding * self.bound, rolling * (self.bound * self.lever)];
        let [sliding, rolling] = self.two_circles(limits)?.solve(left)?;
        let load = TangentialLoad {
            sliding,
            torsion: self.old.torsion,
        };
        let torsion = self.hold_load(&load, self.block.mass_sliding).torsion;
        Some((TangentialLoad { sliding, torsion }, rolling))
    }

    /// The impulses under any friction, and where squares leave the number range.
    #[inline(never)]
    fn by_cases(&self, left: R) -> (TangentialLoad<R>, Vector3<R>) {
        let (m, inertia, k) = (
            self.block.mass_sliding,
            self.block.inertia,
            self.block.coupling,
        );
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
        let limits = [magnitude(&held.sliding), magnitude(&turned)];
        let mut rolling = self
            .two_circles(limits)
            .and_then(|circles| circles.both_slip([&held.sliding, &turned]))
            .map_or(turned, |[_, rolling]| rolling);
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

    /// The contact in coordinates, under thresholds of force and torque.
    #[inline(always)]
    fn two_circles(&self, limits: [R; 2]) -> Option<TwoCircles<'_, R>> {
        let block = self.block;
        TwoCircles::new(
            self.normal,
            limits,
            ([block.mass_sliding, block.inertia], block.coupling),
            [&self.old.sliding, &self.old_rolling],
            [&self.slip, &self.roll],
        )
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
        self.hold_load(&trial, mass)
    }

    #[inline(always)]
    fn hold_load(&self, trial: &TangentialLoad<R>, mass: R) -> TangentialLoad<R> {
        let masses = Masses {
            sliding: mass,
            torsion: self.block.inertia,
        };
        self.friction.hold(trial, self.bound, self.lever, &masses)
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
