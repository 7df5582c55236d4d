//! Sliding and rolling of one contact under a threshold each, in coordinates of the contact plane.
//!
//! Impulses are in units of their thresholds, and the rolling torque is turned by a right angle: two
//! unit circles, whatever the size of the grains.

use super::both_slip::BothSlip;
use super::disc::COLLAR_ULPS;
use super::plane::{Planar, PlaneAxes, add_scaled, dot, minus, scaled, unit};
use crate::real::Real;
use nalgebra::Vector3;

/// Square of the share of its threshold from which on an impulse is taken to have slipped before.
const SLIPPED_BEFORE: f64 = 0.95;

/// Vectors of sliding and of rolling in space.
pub(super) type Motions<'a, R> = [&'a Vector3<R>; 2];

/// One contact's sliding and rolling with everything else fixed.
pub(super) struct TwoCircles<'a, R: Real> {
    axes: PlaneAxes<R>,
    limits: [R; 2],
    /// Impulses so far.
    old: Motions<'a, R>,
    old_share: [Planar<R>; 2],
    /// What would stop each motion by itself, with its sign turned.
    excess: [Planar<R>; 2],
    both: BothSlip<R>,
}

/// One motion's impulse, in units of its threshold.
enum Impulse<R> {
    /// All of it.
    Slips(Planar<R>),
    /// What is added to the impulse so far.
    Sticks(Planar<R>),
}
use Impulse::{Slips, Sticks};

impl<'a, R: Real> TwoCircles<'a, R> {
    /// From thresholds, effective masses, coupling k, impulses so far and the velocities under them.
    ///
    /// `None` where impulses are so small a share of their thresholds that they vanish.
    #[inline(always)]
    pub(super) fn new(
        normal: &Vector3<R>,
        limits: [R; 2],
        ([mass, inertia], coupling): ([R; 2], R),
        old: Motions<'a, R>,
        velocities: Motions<'_, R>,
    ) -> Option<Self> {
        let axes = PlaneAxes::across(normal);
        let [inv_force, inv_torque] = limits.map(|limit| R::ONE / limit);
        let (to_force, to_torque) = (mass * inv_force, inertia * inv_torque);
        let in_range = to_force > R::MIN_POSITIVE && to_torque > R::MIN_POSITIVE;
        if !in_range {
            return None;
        }
        let couplings = [
            coupling * mass * (limits[1] * inv_force),
            coupling * inertia * (limits[0] * inv_torque),
        ];
        let p = scaled(axes.coordinates(old[0]), inv_force);
        let t = scaled(axes.turned_coordinates(old[1]), inv_torque);
        let slip = scaled(axes.coordinates(velocities[0]), to_force);
        let roll = scaled(axes.turned_coordinates(velocities[1]), to_torque);
        let both = BothSlip {
            sliding: minus(add_scaled(p, -couplings[0], t), slip),
            rolling: minus(add_scaled(t, -couplings[1], p), roll),
            couplings,
        };
        Some(Self {
            axes,
            limits,
            old,
            old_share: [p, t],
            excess: [slip, roll],
            both,
        })
    }

    /// The impulses that obey their thresholds; `left` is 1 − κ₁ κ₂.
    ///
    /// `None` where squares leave the number range, and for what is not a number.
    #[inline(always)]
    pub(super) fn solve(&self, left: R) -> Option<[Vector3<R>; 2]> {
        let ([p, t], [slip, roll]) = (self.old_share, self.excess);
        let [to_sliding, to_rolling] = self.both.couplings;
        // Both slip as before: at their thresholds, and against their impulses.
        let slipped = R::from_f64(SLIPPED_BEFORE);
        let at_thresholds = dot(p, p) >= slipped && dot(t, t) >= slipped;
        if at_thresholds && dot(p, slip) < R::ZERO && dot(t, roll) < R::ZERO {
            let found = self.slipping([unit(p), unit(t)]);
            if found.is_some() {
                return found;
            }
        }

        // What stops one motion while the other sticks.
        let inverse = R::ONE / left;
        let change_p = scaled(add_scaled(slip, to_sliding, roll), -inverse);
        let change_t = scaled(add_scaled(roll, to_rolling, slip), -inverse);
        let (stuck_p, stuck_t) = (
            add_scaled(p, R::ONE, change_p),
            add_scaled(t, R::ONE, change_t),
        );
        let (sticks_p, sticks_t) = (inside(stuck_p), inside(stuck_t));
        if sticks_p && sticks_t {
            let change_t = minus(scaled(change_p, to_rolling), roll);
            return Some(self.impulses(Sticks(change_p), Sticks(change_t)));
        }
        // Rolling sticks.
        let slid = unit(stuck_p);
        let twist = self.both.twist(slid);
        if !sticks_p && inside(twist) {
            let change = minus(scaled(minus(slid, p), to_rolling), roll);
            return Some(self.impulses(Slips(slid), Sticks(change)));
        }
        // Sliding sticks.
        let turned = unit(stuck_t);
        let pull = self.both.pull(turned);
        if !sticks_t && inside(pull) {
            let change = minus(scaled(minus(turned, t), to_sliding), slip);
            return Some(self.impulses(Sticks(change), Slips(turned)));
        }
        self.slipping(self.both.nearer([slid, turned]))
    }

    /// The impulses if both slip, from a guess of them.
    #[inline(always)]
    pub(super) fn both_slip(&self, [sliding, rolling]: Motions<'_, R>) -> Option<[Vector3<R>; 2]> {
        let guess = [
            self.axes.coordinates(sliding),
            self.axes.turned_coordinates(rolling),
        ];
        self.slipping(self.both.nearer(guess.map(unit)))
    }

    #[inline(always)]
    fn slipping(&self, guess: [Planar<R>; 2]) -> Option<[Vector3<R>; 2]> {
        let [p, t] = self.both.solve(guess)?;
        Some(self.impulses(Slips(p), Slips(t)))
    }

    /// Impulses in space.
    #[inline(always)]
    fn impulses(&self, sliding: Impulse<R>, rolling: Impulse<R>) -> [Vector3<R>; 2] {
        let [force, torque] = self.limits;
        [
            match sliding {
                Slips(p) => self.axes.vector(scaled(p, force)),
                Sticks(change) => self.old[0] + self.axes.vector(scaled(change, force)),
            },
            match rolling {
                Slips(t) => self.axes.turned_vector(scaled(t, torque)),
                Sticks(change) => self.old[1] + self.axes.turned_vector(scaled(change, torque)),
            },
        ]
    }
}

/// True in the unit circle.
#[inline(always)]
fn inside<R: Real>(v: Planar<R>) -> bool {
    dot(v, v) <= R::ONE + R::from_f64(COLLAR_ULPS) * R::EPSILON
}
