//! Law × patch → wrench: force and torque of friction as functions of the twist (sliding and spin).
//!
//! A caller picks pressure and law by type:
//!
//! | law | uniform disk | (1−r²)^q: ring, punch, Hertz, … | accuracy |
//! |---|---|---|---|
//! | Coulomb | [`coulomb::CoulombDisk`] | [`coulomb`], five pressures | a few ulp |
//! | \|v\|^α, α ≤ 10 | [`table::DiskTable64`], [`table::DiskTable32`] | [`round::RoundTable64`], [`round::RoundTable32`] | a few ulp |
//! | \|v\|^α, α ≤ 128 | [`compact::CompactPower`] | [`compact::CompactPower::with_pressure`] | 1e-14, slow |
//! | any local law | [`quadrature::DiskQuadrature`] | [`nodes::NodeFriction`] | 1e-8, nodes 1e-3 |
//!
//! An [`Annulus`] is made of any disk, a worn one is [`WornAnnulus`], a polynomial in r² is a [`round::PolynomialTable`], and points or a pressure
//! map are [`nodes::NodeFriction`].
//!
//! Polygons, bars and meshes under Coulomb's law have closed forms, a few ulp without a table: [`flat`]; polygons
//! under |v|^α need 127 prepared numbers.
//!
//! Coulomb's forms are code and 0.4 to 0.8 KiB of numbers, and as many again where Jacobians are asked for (f32: 100 to
//! 200 bytes). Tables take 14 KiB a law on the uniform disk and 48 KiB elsewhere (f32: 3 and 7 KiB) and the same time for
//! every pressure and exponent; the series is code only, 4 times as slow, next to equal speeds 100 times.
//!
//! [`RoundFriction`] adds radius and coefficient, [`LoadedFriction`] a radius that follows the load. A pressure that leans makes spinning friction
//! lateral ([`LateralFriction`]); [`load_transfer::LoadTransferFriction`] finds the lean of a tall body. A tier that a program
//! does not name costs nothing.
//!
//! `docs/tables/accuracy.csv` gives the measured bound of each with the argument where it is attained.

mod annulus;
mod batch;
pub(crate) mod disk;
mod dry;
pub(crate) mod equal_speeds;
mod extended_range;
mod extreme_range;
mod family_member;
mod friction;
mod half_octave_table;
mod lateral;
mod lean_profile;
mod loaded;
mod polynomial;
mod pressure_family;
mod profile;
mod regime_table;
mod rings;
mod speeds;
mod worn;

pub mod compact;
pub mod coulomb;
pub mod flat;
pub mod load_transfer;
pub mod nodes;
pub mod quadrature;
pub mod round;
pub mod table;

pub use annulus::Annulus;
pub use dry::DryProfile;
pub use friction::{Magnitudes, MagnitudesJacobian, RoundFriction};
pub use lateral::LateralFriction;
pub use loaded::LoadedFriction;
pub(crate) use pressure_family::inertia_ends;
pub use profile::{PowerLawFriction, unscaled_wrench};
pub use worn::WornAnnulus;

/// See [`crate::internals`].
pub(crate) mod internals {
    pub use super::coulomb::form::FittedRows;
    pub use super::coulomb::terms::DISK_SLOPE_ROUGH;
    pub use super::flat::moving_edge::{BEND, BEND_SINGLE};
    pub use super::lateral::LateralJacobian;
    pub use super::lean_profile::LeanProfile;
    pub use super::profile::SmoothProfile;
    pub use super::speeds::{DominantSpeed, Speeds};
}

pub(crate) use internals::{DominantSpeed, LateralJacobian, SmoothProfile, Speeds};

use crate::lanes::{Lanes, Numbers};
use crate::real::Real;

/// Magnitudes of friction force and torque, reduced: F per coefficient × load, T per
/// coefficient × load × radius. Both oppose the motion.
///
/// *Units*: speed^α for the power law, none for Coulomb. With rim speed 1 they are the
/// dimensionless functions 𝓕(ε), 𝓣(ε) of the velocity ratio ε = v/(ωR).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, ReducedWrench, coulomb::CoulombDisk};
/// // A disk that spins in place: no force, and the mean radius 2/3 as the arm of the torque.
/// let ReducedWrench { force, torque } = CoulombDisk.reduced_wrench(0.0_f64, 1.0);
/// assert!(force == 0.0 && (torque - 2.0 / 3.0).abs() < 1e-15);
/// // One that slides without spin: all of the force.
/// assert!((CoulombDisk.reduced_wrench(1.0_f64, 0.0).force - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReducedWrench<R> {
    /// F
    pub force: R,
    /// T
    pub torque: R,
}

/// Derivatives of a [`ReducedWrench`] with respect to sliding speed v and rim speed w.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, ReducedJacobian, coulomb::CoulombDisk};
/// let (v, w) = (0.3_f64, 0.4);
/// let ReducedJacobian { force_slide, mixed, torque_rim, .. } = CoulombDisk.reduced_jacobian(v, w);
/// // Dry friction does not care how fast both motions are, as long as their ratio stays.
/// assert!((v * force_slide + w * mixed).abs() < 1e-12);
/// assert!((v * mixed + w * torque_rim).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReducedJacobian<R> {
    /// F/v, the drag of a small sideways velocity (finite at v = 0).
    pub force_per_slide: R,
    /// ∂F/∂v
    pub force_slide: R,
    /// ∂F/∂w = ∂T/∂v
    pub mixed: R,
    /// ∂T/∂w
    pub torque_rim: R,
}

/// Friction of a round patch of radius 1 under unit load.
///
/// All methods are total. Signs of the arguments are ignored. At rest (v = w = 0) the wrench is
/// zero and the Jacobian the limit of damping: infinite where the law is steeper than linear.
/// NaN in either argument gives NaN in every result, and so do two infinite speeds. One infinite
/// speed gives Coulomb's limit of the ratio; for other laws a limit that depends on more than the
/// ratio is NaN, and the Jacobian is NaN for any infinite speed. A result that leaves the number
/// range is infinite or zero; one that does not is right, whatever its factors do.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, compact::CompactPower, coulomb::CoulombDisk};
/// // Force on a disk that spins at rim speed 1 and is pushed aside slowly, over that slow speed.
/// fn drag(disk: &impl ReducedFriction<f64>) -> f64 {
///     disk.reduced_wrench(1e-4, 1.0).force / 1e-4
/// }
/// // Spinning makes dry friction viscous, F = ε − ε³/8 + …, in every tier.
/// assert!((drag(&CoulombDisk) - 1.0).abs() < 2e-9);
/// assert!((drag(&CompactPower::new(0.0)?) - 1.0).abs() < 2e-9);
/// assert!((CoulombDisk.reduced_jacobian(0.0_f64, 1.0).force_slide - 1.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
pub trait ReducedFriction<R: Real> {
    /// Force and torque for sliding speed `slide` and rim speed `rim` = |ω|R.
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R>;

    /// Analytic derivatives at the same arguments.
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R>;

    /// [`ReducedFriction::reduced_wrench`] of many speeds, to the same bits: `slides` and `rims` in, `forces`
    /// and `torques` out. Elements beyond the shortest slice are not changed.
    ///
    /// *Cost*: Coulomb's forms and tables take about half the time of single calls where the processor has vectors.
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, coulomb::CoulombDisk};
    /// let (slides, rims) = ([1.0_f64, 0.0], [0.0, 1.0]); // sliding alone, spinning in place
    /// let (mut forces, mut torques) = ([0.0; 2], [0.0; 2]);
    /// CoulombDisk.reduced_wrench_batch(&slides, &rims, &mut forces, &mut torques);
    /// assert!((forces[0] - 1.0).abs() < 1e-15 && forces[1] == 0.0);
    /// assert!(torques[0] == 0.0 && (torques[1] - 2.0 / 3.0).abs() < 1e-15);
    /// ```
    #[inline]
    fn reduced_wrench_batch(&self, slides: &[R], rims: &[R], forces: &mut [R], torques: &mut [R]) {
        batch::reduced_wrenches(self, [slides, rims], [forces, torques]);
    }

    /// [`ReducedFriction::reduced_jacobian`] of many speeds, to the same bits. Elements beyond the shortest
    /// slice are not changed.
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, ReducedJacobian, coulomb::CoulombDisk};
    /// let (slides, rims) = ([1.0_f64, 2.0], [0.5, 1.0]);
    /// let mut jacobians = [ReducedJacobian::default(); 2];
    /// CoulombDisk.reduced_jacobian_batch(&slides, &rims, &mut jacobians);
    /// // Dry friction forgets how fast both motions are: half the slope at twice the speeds.
    /// assert_eq!(jacobians[1].force_slide * 2.0, jacobians[0].force_slide);
    /// ```
    #[inline]
    fn reduced_jacobian_batch(
        &self,
        slides: &[R],
        rims: &[R],
        jacobians: &mut [ReducedJacobian<R>],
    ) {
        batch::reduced_jacobians(self, [slides, rims], jacobians);
    }

    /// F/v and T for v² and w. *Domain*: ordinary speeds, whose squares are far from the ends of the
    /// number range; `rim` may be 0.
    #[doc(hidden)]
    #[inline]
    fn reduced_drag(&self, slide_sq: R, rim: R) -> [R; 2] {
        let slide = slide_sq.sqrt();
        let ReducedWrench { force, torque } = self.reduced_wrench(slide, rim);
        [force / slide, torque]
    }

    /// [`ReducedFriction::reduced_drag`] of a group, to the same bits; nothing where a coupling has no
    /// lanes, or a lane needs care.
    #[doc(hidden)]
    #[inline]
    fn reduced_drags(&self, _slide_squares: &[R; 8], _rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
        None
    }

    /// [`ReducedFriction::reduced_wrench`] of a group, as [`ReducedFriction::reduced_drags`].
    #[doc(hidden)]
    #[inline]
    fn reduced_wrenches(&self, _slides: &[R; 8], _rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
        None
    }

    /// [`ReducedFriction::reduced_jacobian`] of a group, as [`ReducedFriction::reduced_drags`]; in the order of
    /// the fields.
    #[doc(hidden)]
    #[inline]
    fn reduced_jacobians(&self, _slides: &[R; 8], _rims: &[R; 8]) -> Option<[[R; 8]; 4]> {
        None
    }
}

/// A coupling whose wrench depends on the ratio of the two speeds alone: dry friction, α = 0.
///
/// Its wrenches form the limit surface, a closed convex set with a support function
/// D(v, w) = v F + w T.
///
/// ```
/// use tribos_core::coupling::{DryReducedFriction, coulomb::CoulombDisk};
/// // Power that friction takes, per coefficient and load.
/// fn dissipation(dry: &impl DryReducedFriction<f64>, slide: f64, rim: f64) -> f64 {
///     let wrench = dry.reduced_wrench(slide, rim);
///     slide * wrench.force + rim * wrench.torque
/// }
/// // It doubles with the speeds.
/// let [slow, fast] = [1.0, 2.0].map(|scale| dissipation(&CoulombDisk, 0.3 * scale, 0.4 * scale));
/// assert!((fast - 2.0 * slow).abs() < 1e-15);
/// ```
pub trait DryReducedFriction<R: Real>: ReducedFriction<R> {
    /// The larger and the smaller component where the larger speed is 1 and the smaller one `ratio`,
    /// and the slope of the smaller one.
    #[doc(hidden)]
    #[inline]
    fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
        let (slide, rim) = match lead {
            DominantSpeed::Sliding => (R::ONE, ratio),
            DominantSpeed::Spinning => (ratio, R::ONE),
        };
        let ReducedWrench { force, torque } = self.reduced_wrench(slide, rim);
        let rates = self.reduced_jacobian(slide, rim);
        match lead {
            DominantSpeed::Sliding => [force, torque, rates.torque_rim],
            DominantSpeed::Spinning => [torque, force, rates.force_slide],
        }
    }

    /// [`DryReducedFriction::reduced_point`] of several ratios side by side, to the same bits; sliding leads where
    /// `slides`.
    #[doc(hidden)]
    #[inline]
    fn reduced_points(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratios: R::SideBySide,
    ) -> [R::SideBySide; 3] {
        let leads = R::SideBySide::select(slides, Lanes::splat(1.0), Lanes::splat(0.0)).to_array();
        let mut points = [ratios.to_array(); 3];
        points_one_by_one(self, leads.as_ref(), points.each_mut().map(AsMut::as_mut));
        points.map(R::SideBySide::new)
    }

    /// [`DryReducedFriction::reduced_point`] to half of its digits, for a search's first step; nothing where it would
    /// cost as much.
    #[doc(hidden)]
    #[inline]
    fn rough_point(&self, _: DominantSpeed, _ratio: R) -> Option<[R; 3]> {
        None
    }

    /// [`DryReducedFriction::rough_point`] of several ratios side by side.
    #[doc(hidden)]
    #[inline]
    fn rough_points(
        &self,
        _slides: <R::SideBySide as Lanes>::Mask,
        _ratios: R::SideBySide,
    ) -> Option<[R::SideBySide; 3]> {
        None
    }

    /// Coefficients of m/h by powers of h², right to 1e-4, where they are known beforehand.
    #[doc(hidden)]
    #[inline]
    fn minor_powers(&self, _lead: DominantSpeed) -> Option<[R; 6]> {
        None
    }

    /// True if a Newton step along the curve leaves at most the square of it, everywhere.
    #[doc(hidden)]
    #[inline]
    fn is_smooth(&self) -> bool {
        false
    }
}

/// Points in place of their ratios, which stand for the larger components; sliding leads where `leads` is positive.
///
/// Never inlined: from numbers that one call after the other leaves in the same place, LLVM 22 makes a vector on AArch64
/// after all of the calls (llvm/llvm-project#152979, which looks for calls within one block only).
#[inline(never)]
fn points_one_by_one<R: Real, C: DryReducedFriction<R> + ?Sized>(
    coupling: &C,
    leads: &[R],
    [majors, minors, rates]: [&mut [R]; 3],
) {
    let points = majors.iter_mut().zip(minors).zip(rates);
    for (slides, ((major, minor), rate)) in leads.iter().zip(points) {
        let lead = if *slides > R::ZERO {
            DominantSpeed::Sliding
        } else {
            DominantSpeed::Spinning
        };
        [*major, *minor, *rate] = coupling.reduced_point(lead, *major);
    }
}

impl<R: Real, C: DryReducedFriction<R> + ?Sized> DryReducedFriction<R> for &C {
    #[inline]
    fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
        (**self).reduced_point(lead, ratio)
    }
    #[inline]
    fn reduced_points(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratios: R::SideBySide,
    ) -> [R::SideBySide; 3] {
        (**self).reduced_points(slides, ratios)
    }
    #[inline]
    fn rough_point(&self, lead: DominantSpeed, ratio: R) -> Option<[R; 3]> {
        (**self).rough_point(lead, ratio)
    }
    #[inline]
    fn rough_points(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratios: R::SideBySide,
    ) -> Option<[R::SideBySide; 3]> {
        (**self).rough_points(slides, ratios)
    }
    #[inline]
    fn minor_powers(&self, lead: DominantSpeed) -> Option<[R; 6]> {
        (**self).minor_powers(lead)
    }
    #[inline]
    fn is_smooth(&self) -> bool {
        (**self).is_smooth()
    }
}

impl<R: Real, C: ReducedFriction<R> + ?Sized> ReducedFriction<R> for &C {
    #[inline]
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        (**self).reduced_wrench(slide, rim)
    }
    #[inline]
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        (**self).reduced_jacobian(slide, rim)
    }
    #[inline]
    fn reduced_drag(&self, slide_sq: R, rim: R) -> [R; 2] {
        (**self).reduced_drag(slide_sq, rim)
    }
    #[inline]
    fn reduced_drags(&self, slide_squares: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
        (**self).reduced_drags(slide_squares, rims)
    }
    #[inline]
    fn reduced_wrenches(&self, slides: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
        (**self).reduced_wrenches(slides, rims)
    }
    #[inline]
    fn reduced_jacobians(&self, slides: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 4]> {
        (**self).reduced_jacobians(slides, rims)
    }
}
