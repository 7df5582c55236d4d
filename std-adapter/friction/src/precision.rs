//! The scalars that friction can be chosen in.

use super::FrictionError;
use super::catalogue::{LawConstructor, LawResult, Values};
use super::quadrature::polynomial;
use super::visit::Smooth;
use std::fmt::Debug;
use tribos_core::coupling::round::{
    LateralPolynomialTable, PolynomialTable, RoundTable32, RoundTable64,
};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{
    DryProfile, DryReducedFriction, LateralFriction, ReducedFriction, ReducedJacobian,
    ReducedWrench,
};
use tribos_core::internals::{DominantSpeed, SmoothProfile};
use tribos_core::law::LawError;
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;

/// A scalar in which friction can be chosen at run time: `f64` or `f32`.
///
/// ```
/// use tribos::friction::{AnyFriction, Law, Patch, Precision, FrictionError};
/// use tribos::kernel::coupling::ReducedFriction;
/// fn torque<R: Precision>() -> Result<f64, FrictionError> {
///     let ring = AnyFriction::<R>::new(&Patch::Ring, &Law::coulomb(0.3)?, None)?;
///     Ok(ring.reduced_wrench(R::ZERO, R::ONE).torque.to_f64())
/// }
/// assert!((torque::<f64>()? - 1.0).abs() < 1e-15 && (torque::<f32>()? - 1.0).abs() < 1e-6);
/// # Ok::<(), FrictionError>(())
/// ```
pub trait Precision: sealed::Tables {}

impl Precision for f64 {}
impl Precision for f32 {}

pub(super) mod sealed {
    use super::*;

    /// The kernel's tables and laws in one precision.
    pub trait Tables: Real + Debug {
        const HAS_POLYNOMIALS: bool;
        type Disk: SmoothProfile<Self> + LateralFriction<Self> + Send + Sync + 'static;
        type Round: SmoothProfile<Self>
            + LateralFriction<Self>
            + Copy
            + Debug
            + Send
            + Sync
            + 'static;
        /// Under dry friction alone.
        type Polynomial: DryReducedFriction<Self> + Copy + Debug + Send + Sync + 'static;
        fn disk(alpha: Self) -> Result<Self::Disk, LawError>;
        fn round(alpha: Self, pressure: PowerPressure) -> Result<Self::Round, LawError>;
        /// Hands the table of a polynomial pressure to `visitor`, if there is one.
        fn polynomial<V: Smooth<Self>>(
            alpha: Self,
            coefficients: &[f64],
            visitor: V,
        ) -> Result<V::Output, FrictionError>;
        fn dry_polynomial(coefficients: &[f64]) -> Result<Self::Polynomial, FrictionError>;
        fn make(maker: &LawConstructor, values: Values<Self>) -> LawResult<Self>;
    }

    impl Tables for f64 {
        const HAS_POLYNOMIALS: bool = true;
        type Disk = DiskTable64;
        type Round = RoundTable64;
        type Polynomial = DryProfile<PolynomialTable>;
        fn disk(alpha: f64) -> Result<DiskTable64, LawError> {
            DiskTable64::new(alpha)
        }
        fn round(alpha: f64, pressure: PowerPressure) -> Result<RoundTable64, LawError> {
            RoundTable64::new(alpha, pressure)
        }
        fn polynomial<V: Smooth<f64>>(
            alpha: f64,
            coefficients: &[f64],
            visitor: V,
        ) -> Result<V::Output, FrictionError> {
            let table = LateralPolynomialTable::new(alpha, &polynomial(coefficients)?)?;
            visitor.smooth(table)
        }
        fn dry_polynomial(
            coefficients: &[f64],
        ) -> Result<DryProfile<PolynomialTable>, FrictionError> {
            let table = PolynomialTable::new(0.0, &polynomial(coefficients)?)?;
            Ok(DryProfile::new(table)?)
        }
        fn make(maker: &LawConstructor, values: Values<f64>) -> LawResult<f64> {
            (maker.double)(values)
        }
    }

    /// Dry friction in single precision from a table in double precision.
    #[derive(Clone, Copy, Debug)]
    pub struct Narrowed(DryProfile<PolynomialTable>);

    impl ReducedFriction<f32> for Narrowed {
        fn reduced_wrench(&self, slide: f32, rim: f32) -> ReducedWrench<f32> {
            let wrench = self.0.reduced_wrench(slide.into(), rim.into());
            ReducedWrench {
                force: wrench.force as f32,
                torque: wrench.torque as f32,
            }
        }
        fn reduced_jacobian(&self, slide: f32, rim: f32) -> ReducedJacobian<f32> {
            let jacobian = self.0.reduced_jacobian(slide.into(), rim.into());
            ReducedJacobian {
                force_per_slide: jacobian.force_per_slide as f32,
                force_slide: jacobian.force_slide as f32,
                mixed: jacobian.mixed as f32,
                torque_rim: jacobian.torque_rim as f32,
            }
        }
    }

    impl DryReducedFriction<f32> for Narrowed {
        fn reduced_point(&self, lead: DominantSpeed, ratio: f32) -> [f32; 3] {
            let point = self.0.reduced_point(lead, ratio.into());
            point.map(|part| part as f32)
        }
    }

    impl Tables for f32 {
        const HAS_POLYNOMIALS: bool = false;
        type Disk = DiskTable32;
        type Round = RoundTable32;
        type Polynomial = Narrowed;
        fn disk(alpha: f32) -> Result<DiskTable32, LawError> {
            DiskTable32::new(alpha)
        }
        fn round(alpha: f32, pressure: PowerPressure) -> Result<RoundTable32, LawError> {
            RoundTable32::new(alpha, pressure)
        }
        fn polynomial<V: Smooth<f32>>(_: f32, _: &[f64], _: V) -> Result<V::Output, FrictionError> {
            Err(FrictionError::SinglePrecision)
        }
        fn dry_polynomial(coefficients: &[f64]) -> Result<Narrowed, FrictionError> {
            f64::dry_polynomial(coefficients).map(Narrowed)
        }
        fn make(maker: &LawConstructor, values: Values<f32>) -> LawResult<f32> {
            (maker.single)(values)
        }
    }
}
