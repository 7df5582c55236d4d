//! The scalars that friction can be chosen in.

use super::Refusal;
use super::catalogue::{Made, Maker, Values};
use super::quadrature::polynomial;
use super::visit::Smooth;
use std::fmt::Debug;
use tribos_core::coupling::round::{
    LateralPolynomialTable, PolynomialTable, RoundTable32, RoundTable64,
};
use tribos_core::coupling::table::{Table32, Table64};
use tribos_core::coupling::{Coupling, Dry, DryCoupling, Lateral, ReducedJacobian, ReducedWrench};
use tribos_core::internals::{Lead, SmoothProfile};
use tribos_core::law::LawError;
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;

/// A scalar in which friction can be chosen at run time: `f64` or `f32`.
///
/// ```
/// use tribos::friction::{Friction, Law, Patch, Precision, Refusal};
/// use tribos::kernel::coupling::Coupling;
/// fn torque<R: Precision>() -> Result<f64, Refusal> {
///     let ring = Friction::<R>::new(&Patch::Ring, &Law::coulomb(0.3)?, None)?;
///     Ok(ring.reduced_wrench(R::ZERO, R::ONE).torque.to_f64())
/// }
/// assert!((torque::<f64>()? - 1.0).abs() < 1e-15 && (torque::<f32>()? - 1.0).abs() < 1e-6);
/// # Ok::<(), Refusal>(())
/// ```
pub trait Precision: sealed::Tables {}

impl Precision for f64 {}
impl Precision for f32 {}

pub(super) mod sealed {
    use super::*;

    /// The kernel's tables and laws in one precision.
    pub trait Tables: Real + Debug {
        const HAS_POLYNOMIALS: bool;
        type Disk: SmoothProfile<Self> + Lateral<Self> + Send + Sync + 'static;
        type Round: SmoothProfile<Self> + Lateral<Self> + Copy + Debug + Send + Sync + 'static;
        /// Under dry friction alone.
        type Polynomial: DryCoupling<Self> + Copy + Debug + Send + Sync + 'static;
        fn disk(alpha: Self) -> Result<Self::Disk, LawError>;
        fn round(alpha: Self, pressure: PowerPressure) -> Result<Self::Round, LawError>;
        /// Hands the table of a polynomial pressure to `visitor`, if there is one.
        fn polynomial<V: Smooth<Self>>(
            alpha: Self,
            coefficients: &[f64],
            visitor: V,
        ) -> Result<V::Output, Refusal>;
        fn dry_polynomial(coefficients: &[f64]) -> Result<Self::Polynomial, Refusal>;
        fn make(maker: &Maker, values: Values<Self>) -> Made<Self>;
    }

    impl Tables for f64 {
        const HAS_POLYNOMIALS: bool = true;
        type Disk = Table64;
        type Round = RoundTable64;
        type Polynomial = Dry<PolynomialTable>;
        fn disk(alpha: f64) -> Result<Table64, LawError> {
            Table64::new(alpha)
        }
        fn round(alpha: f64, pressure: PowerPressure) -> Result<RoundTable64, LawError> {
            RoundTable64::new(alpha, pressure)
        }
        fn polynomial<V: Smooth<f64>>(
            alpha: f64,
            coefficients: &[f64],
            visitor: V,
        ) -> Result<V::Output, Refusal> {
            let table = LateralPolynomialTable::new(alpha, &polynomial(coefficients)?)?;
            visitor.smooth(table)
        }
        fn dry_polynomial(coefficients: &[f64]) -> Result<Dry<PolynomialTable>, Refusal> {
            let table = PolynomialTable::new(0.0, &polynomial(coefficients)?)?;
            Ok(Dry::new(table)?)
        }
        fn make(maker: &Maker, values: Values<f64>) -> Made<f64> {
            (maker.double)(values)
        }
    }

    /// Dry friction in single precision from a table in double precision.
    #[derive(Clone, Copy, Debug)]
    pub struct Narrowed(Dry<PolynomialTable>);

    impl Coupling<f32> for Narrowed {
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

    impl DryCoupling<f32> for Narrowed {
        fn reduced_point(&self, lead: Lead, ratio: f32) -> [f32; 3] {
            let point = self.0.reduced_point(lead, ratio.into());
            point.map(|part| part as f32)
        }
    }

    impl Tables for f32 {
        const HAS_POLYNOMIALS: bool = false;
        type Disk = Table32;
        type Round = RoundTable32;
        type Polynomial = Narrowed;
        fn disk(alpha: f32) -> Result<Table32, LawError> {
            Table32::new(alpha)
        }
        fn round(alpha: f32, pressure: PowerPressure) -> Result<RoundTable32, LawError> {
            RoundTable32::new(alpha, pressure)
        }
        fn polynomial<V: Smooth<f32>>(_: f32, _: &[f64], _: V) -> Result<V::Output, Refusal> {
            Err(Refusal::SinglePrecision)
        }
        fn dry_polynomial(coefficients: &[f64]) -> Result<Narrowed, Refusal> {
            f64::dry_polynomial(coefficients).map(Narrowed)
        }
        fn make(maker: &Maker, values: Values<f32>) -> Made<f32> {
            (maker.single)(values)
        }
    }
}
