//! One step of elastic, perfectly plastic bonds.

use super::pose::{Anchor, Axes, Pose};
use super::{Presliding, Stiffness};
use crate::law::StickSlip;
use crate::limit_surface::{FrictionSet, without_gain};
use crate::real::Real;
use crate::twist::{Displacement, Wrench};

/// Presliding at a new pose of the patch, in the axes of the floor.
///
/// ```
/// use tribos_core::limit_surface::LimitEllipsoid;
/// use tribos_core::presliding::{Anchor, Pose, Presliding, PreslidingStep};
/// let (foot, bonds) = (LimitEllipsoid::new(10.0_f64, 0.1, 0.6)?, Presliding::new(1e4, 50.0)?);
/// let touched = Anchor::at(Pose::new(0.0, 0.0, 0.0)); // m, m, rad
/// // Turned by 0.02 rad it would take 1 N m; it can have 0.6 N m and slips by the rest.
/// let PreslidingStep { friction, slip, dissipated, .. } =
///     bonds.step(&foot, &touched, &Pose::new(0.0, 0.0, 0.02));
/// assert!((friction.torque + 0.6).abs() < 1e-12 && (slip.turn - 0.4 / 50.0).abs() < 1e-12);
/// assert!((dissipated - 0.6 * 0.4 / 50.0).abs() < 1e-12); // J
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreslidingStep<R: Real> {
    /// The state after the step: the given one to the bit if the bonds held.
    pub anchor: Anchor<R>,
    /// Friction on the patch at the end of the step. *Units*: force, force × length.
    pub friction: Wrench<R>,
    /// Displacement by which the bonds slipped; zero if they held.
    pub slip: Displacement<R>,
    /// Energy that became heat, friction along the slip. *Units*: force × length. Not negative.
    pub dissipated: R,
    /// Whether the bonds held.
    pub grip: StickSlip,
}

/// Bonds after a step, as displacement and in one set of axes: the increment form.
///
/// ```
/// use tribos_core::limit_surface::LimitEllipsoid;
/// use tribos_core::presliding::Presliding;
/// use tribos_core::twist::{Displacement, Twist};
/// let (foot, bonds) = (LimitEllipsoid::new(10.0_f64, 0.1, 0.6)?, Presliding::new(1e4, 50.0)?);
/// // A velocity-based engine adds what each step brings.
/// let mut strain = Displacement::ZERO;
/// for _ in 0..100 {
///     let moved = Displacement::along(&Twist::new(0.01, 0.0, 0.0), 1e-3); // m/s; s
///     strain = bonds.advance(&foot, &strain, &moved).strain;
/// }
/// assert!((strain.shift.x - 10.0 / 1e4).abs() < 1e-12); // 1 mm of strain, as often as it slides
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled<R: Real> {
    /// Displacement of the bonds that is left.
    pub strain: Displacement<R>,
    /// Friction on the patch.
    pub friction: Wrench<R>,
    /// Displacement by which the bonds slipped; zero if they held.
    pub slip: Displacement<R>,
    /// Energy that became heat. Not negative.
    pub dissipated: R,
    /// Whether the bonds held.
    pub grip: StickSlip,
}

impl<R: Real> Presliding<R> {
    /// Friction on a patch that is now in `pose`, and where its bonds are anchored from now on.
    ///
    /// `set` is in the axes of the patch, about its centre; poses, friction and slip are in the axes of
    /// the floor. On a floor that moves, give the poses relative to it.
    ///
    /// *Units*: length, radians; force, force × length. *Accuracy*: k ε max(|x|, |x_a|) from the rounding of
    /// positions, and that of the set's projection. First order in the step where friction slips and turns;
    /// exact while it holds, and where it slips in one direction. *Cost*: one projection, a sine
    /// and a cosine. *Special values*: NaN for NaN and infinities.
    pub fn step<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        anchor: &Anchor<R>,
        pose: &Pose<R>,
    ) -> PreslidingStep<R> {
        let strain = anchor.deflection(pose);
        let axes = Axes::at(pose.angle);
        let settled = settled(self.factors(), set, &axes.displacement_to_patch(&strain));
        settled.on_floor(self.factors(), axes, anchor, pose)
    }

    /// Friction after the patch has `moved`, given the `strain` of its bonds before: the increment form.
    ///
    /// All is in the axes of the set. A patch that turns far takes its set along but not its bonds:
    /// use [`Presliding::step`] there, or turn the strain back. Sums of increments round, poses do not.
    ///
    /// *Units*, *Accuracy*, *Special values*: as for [`Presliding::step`]. *Cost*: one projection.
    #[doc(hidden)]
    pub fn advance<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        strain: &Displacement<R>,
        moved: &Displacement<R>,
    ) -> Settled<R> {
        settled(self.factors(), set, &(*strain + *moved))
    }
}

/// The return mapping of a trial displacement, in the axes of the set.
#[inline]
fn settled<R: Real, S: FrictionSet<R> + ?Sized>(
    stiffness: &Stiffness<R>,
    set: &S,
    trial: &Displacement<R>,
) -> Settled<R> {
    let wanted = stiffness.wrench(trial);
    let carried = set.project_with_length(&wanted, stiffness.length).wrench;
    if carried == wanted {
        return Settled::held(trial, &wanted);
    }
    let carried = without_gain(&carried, &wanted, stiffness.length);
    Settled::slipped(stiffness, &wanted, &carried)
}

impl<R: Real> Settled<R> {
    /// Bonds that keep their strain.
    #[inline]
    pub(super) fn held(strain: &Displacement<R>, wrench: &Wrench<R>) -> Self {
        Self {
            strain: *strain,
            friction: -*wrench,
            slip: Displacement::ZERO,
            dissipated: R::ZERO,
            grip: StickSlip::Stick,
        }
    }

    /// Bonds that were to pull with `wanted` and do so with `carried`.
    #[inline]
    pub(super) fn slipped(
        stiffness: &Stiffness<R>,
        wanted: &Wrench<R>,
        carried: &Wrench<R>,
    ) -> Self {
        let slip = stiffness.strain(&(*wanted - *carried));
        Self {
            strain: stiffness.strain(carried),
            friction: -*carried,
            slip,
            dissipated: not_below_zero(slip.work(carried)),
            grip: StickSlip::Slip,
        }
    }

    /// The same for a patch in `pose`, whose axes are those of the set.
    #[inline]
    pub(super) fn on_floor(
        &self,
        stiffness: &Stiffness<R>,
        axes: Axes<R>,
        anchor: &Anchor<R>,
        pose: &Pose<R>,
    ) -> PreslidingStep<R> {
        // Bonds that hold keep the bits of their anchor, and their friction is that of the pose.
        let (anchor, friction) = match self.grip {
            StickSlip::Stick => (*anchor, -stiffness.wrench(&anchor.deflection(pose))),
            StickSlip::Slip => {
                let strain = axes.displacement_to_floor(&self.strain);
                let followed = Anchor::with_deflection(pose, &strain);
                (followed, axes.wrench_to_floor(&self.friction))
            }
        };
        PreslidingStep {
            anchor,
            friction,
            slip: axes.displacement_to_floor(&self.slip),
            dissipated: self.dissipated,
            grip: self.grip,
        }
    }
}

/// Heat, which the second law keeps from being negative where it rounds; NaN stays.
#[inline]
pub(crate) fn not_below_zero<R: Real>(heat: R) -> R {
    if heat < R::ZERO { R::ZERO } else { heat }
}
