//! Round patches: all tiers of a pressure and an exponent, by name, and their errors against a row of
//! the tables.

use crate::reference::Reference;
use crate::tables::Row;
use crate::tolerance::Bound;
use crate::worst::Worst;
use tribos_core::coupling::coulomb::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{LateralFriction, ReducedFriction, compact, coulomb};
use tribos_core::law::PowerLaw;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// A tier's name and the tier, with force, torque and lateral function.
pub type PatchTier<R> = (&'static str, Box<dyn LateralFriction<R>>);
/// The same with force and torque alone.
pub type Tier<R> = (&'static str, Box<dyn ReducedFriction<R>>);

/// A scalar whose tables of pressures can be built at run time.
pub trait RoundTabulated: Real {
    /// The table of one pressure.
    fn round_table(alpha: f64, pressure: PowerPressure) -> Option<Box<dyn LateralFriction<Self>>>;
    /// The table of the uniform disk.
    fn disk_table(alpha: f64) -> Option<Box<dyn LateralFriction<Self>>>;
    /// The table of a pressure that dips towards the middle, which exists in f64 alone.
    fn polynomial_table(_alpha: f64) -> Option<Box<dyn LateralFriction<Self>>> {
        None
    }
}

impl RoundTabulated for f64 {
    fn round_table(alpha: f64, pressure: PowerPressure) -> Option<Box<dyn LateralFriction<f64>>> {
        Some(Box::new(RoundTable64::new(alpha, pressure).ok()?))
    }
    fn disk_table(alpha: f64) -> Option<Box<dyn LateralFriction<f64>>> {
        Some(Box::new(DiskTable64::new(alpha).ok()?))
    }
    fn polynomial_table(alpha: f64) -> Option<Box<dyn LateralFriction<f64>>> {
        let pressure = PolynomialPressure::new([0.2, 1.0, -0.5]).ok()?;
        Some(Box::new(
            LateralPolynomialTable::new(alpha, &pressure).ok()?,
        ))
    }
}

impl RoundTabulated for f32 {
    fn round_table(alpha: f64, pressure: PowerPressure) -> Option<Box<dyn LateralFriction<f32>>> {
        Some(Box::new(RoundTable32::new(alpha as f32, pressure).ok()?))
    }
    fn disk_table(alpha: f64) -> Option<Box<dyn LateralFriction<f32>>> {
        Some(Box::new(DiskTable32::new(alpha as f32).ok()?))
    }
}

/// The pressure of order `order`.
///
/// # Panics
/// If it is refused.
pub fn pressure(order: f64) -> PowerPressure {
    PowerPressure::new(order).expect("an order in range")
}

/// All tiers of one pressure and exponent.
///
/// # Panics
/// If order or exponent are refused.
pub fn tiers<R: RoundTabulated>(order: f64, alpha: f64) -> Vec<PatchTier<R>> {
    let patch = pressure(order);
    let mut tiers: Vec<PatchTier<R>> = Vec::new();
    if alpha <= DiskTable64::MAX_EXPONENT {
        let table = R::round_table(alpha, patch).expect("an exponent in range");
        tiers.push(("round table", table));
    }
    let power = compact::CompactPower::with_pressure(R::from_f64(alpha), patch);
    let power = power.expect("an exponent in range");
    tiers.push(("round compact", Box::new(power)));
    if alpha == 0.0 {
        if order == -1.0 {
            tiers.push(("form ring", Box::new(CoulombRing)));
        } else if order == -0.5 {
            tiers.push(("form punch", Box::new(CoulombPunch)));
        } else if order == 0.5 {
            tiers.push(("form Hertz", Box::new(CoulombHertz)));
        } else if order == 1.0 {
            tiers.push(("form paraboloid", Box::new(coulomb::CoulombParaboloid)));
        }
    }
    if order == 0.0 {
        tiers.extend(disks(alpha));
    }
    tiers
}

/// All tiers specific to the uniform disk.
///
/// # Panics
/// If the exponent is refused.
pub fn disks<R: RoundTabulated>(alpha: f64) -> Vec<PatchTier<R>> {
    let mut tiers: Vec<PatchTier<R>> = Vec::new();
    if alpha <= DiskTable64::MAX_EXPONENT {
        let disk = R::disk_table(alpha).expect("an exponent in range");
        tiers.push(("disk table", disk));
    }
    if alpha == 0.0 {
        tiers.push(("form disk", Box::new(coulomb::CoulombDisk)));
    }
    tiers
}

/// The uniform disk's tiers with rounding accuracy, the compact power last.
///
/// # Panics
/// If the exponent is refused.
pub fn exact<R: RoundTabulated + 'static>(alpha: f64) -> Vec<Tier<R>> {
    let plain = |(name, tier): PatchTier<R>| (name, tier as Box<dyn ReducedFriction<R>>);
    let mut tiers: Vec<Tier<R>> = disks(alpha).into_iter().map(plain).collect();
    let power = compact::CompactPower::new(R::from_f64(alpha)).expect("an exponent in range");
    tiers.push(("compact", Box::new(power)));
    tiers
}

/// Those of [`exact`] and the quadrature.
///
/// # Panics
/// If the exponent is refused.
pub fn all<R: RoundTabulated + 'static>(alpha: f64) -> Vec<Tier<R>> {
    let mut tiers = exact(alpha);
    let law = PowerLaw::new(R::from_f64(alpha), R::ONE).expect("an exponent in range");
    tiers.push(("quadrature", Box::new(DiskQuadrature::new(law))));
    tiers
}

/// Names of what [`numbers`] returns, and columns of tables.
pub const RESULTS: [&str; 9] = ["F", "T", "G", "drag", "F_v", "F_w", "T_w", "vG_v", "vG_w"];

/// Force, torque and lateral function, F/v, the derivatives of both, and those of vG.
pub fn numbers<R: Real>(tier: &dyn LateralFriction<R>, slide: R, rim: R) -> [f64; 9] {
    let [force, torque, drag, force_slide, mixed, torque_rim] = plain_numbers(tier, slide, rim);
    let lateral = tier.lateral_jacobian(slide, rim);
    let [g, along, across] = [tier.lateral(slide, rim), lateral.slide, lateral.rim].map(R::to_f64);
    [
        force,
        torque,
        g,
        drag,
        force_slide,
        mixed,
        torque_rim,
        along,
        across,
    ]
}

/// [`numbers`] without the lateral ones.
pub fn plain_numbers<R: Real>(
    tier: &(impl ReducedFriction<R> + ?Sized),
    slide: R,
    rim: R,
) -> [f64; 6] {
    let w = tier.reduced_wrench(slide, rim);
    let j = tier.reduced_jacobian(slide, rim);
    let rates = [j.force_per_slide, j.force_slide, j.mixed, j.torque_rim];
    let [a, b, c, d] = rates;
    [w.force, w.torque, a, b, c, d].map(R::to_f64)
}

/// Largest errors of one tier over rows with F, T, G and the derivatives dF, dT along v.
#[derive(Clone, Debug)]
pub struct RowErrors {
    wrench: [Worst; 3],
    ulps: [Worst; 2],
    derivatives: [Worst; 2],
}

impl RowErrors {
    /// No rows so far.
    pub fn of(tier: &str) -> Self {
        let of = |quantity: &str| Worst::of(format!("{tier}, {quantity}"));
        Self {
            wrench: ["F", "T", "G"].map(of),
            ulps: ["F (ulp)", "T (ulp)"].map(of),
            derivatives: ["dF", "dT"].map(of),
        }
    }

    /// Adds one row: errors of F, T and G are relative, those of the derivatives in units of the larger of
    /// themselves and F/v.
    pub fn see(&mut self, tier: &dyn LateralFriction<f64>, row: &Row, place: impl Fn() -> String) {
        let ratio = row.number("eps");
        let got = tier.reduced_wrench(ratio, 1.0);
        let got = [got.force, got.torque, tier.lateral(ratio, 1.0)];
        for ((worst, column), got) in self.wrench.iter_mut().zip(["F", "T", "G"]).zip(got) {
            worst.see(row.reference(column).relative(got), &place);
        }
        for ((worst, column), got) in self.ulps.iter_mut().zip(["F", "T"]).zip(got) {
            worst.see(row.reference(column).ulps(got), &place);
        }
        let got = tier.reduced_jacobian(ratio, 1.0);
        let drag = if ratio == 0.0 {
            row.number("dF")
        } else {
            row.number("F") / ratio
        };
        let got = [got.force_slide, got.mixed];
        for ((worst, column), got) in self.derivatives.iter_mut().zip(["dF", "dT"]).zip(got) {
            let wanted = row.reference(column);
            worst.see(slope_error(&wanted, got, drag), &place);
        }
    }

    /// Fails if the error of F, T or G exceeds `wrench`, or that of the derivatives `derivatives`.
    ///
    /// # Panics
    /// If they do.
    #[track_caller]
    pub fn assert_within(&self, wrench: &Bound, derivatives: &Bound) {
        for worst in &self.wrench {
            worst.assert_within(wrench);
        }
        for worst in &self.derivatives {
            worst.assert_within(derivatives);
        }
    }

    /// Fails if the error of F or T exceeds its bound in ulp.
    ///
    /// # Panics
    /// If it does.
    #[track_caller]
    pub fn assert_ulps(&self, bounds: &[Bound; 2]) {
        for (worst, bound) in self.ulps.iter().zip(bounds) {
            worst.assert_within(bound);
        }
    }
}

/// Error in units of the larger of |`wanted`| and `drag`; an infinite slope must be infinite.
pub fn slope_error(wanted: &Reference, got: f64, drag: f64) -> f64 {
    let size = wanted.high.abs();
    wanted.over(got, if size > drag { size } else { drag })
}
