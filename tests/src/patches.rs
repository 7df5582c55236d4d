//! Round patches by pressure: all tiers for a pressure (1−r²)^q, by name, and their errors against
//! a row of the tables.

use crate::reference::Reference;
use crate::tables::Row;
use crate::tolerance::Bound;
use crate::worst::Worst;
use tribos_core::coupling::LateralFriction;
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::compact;
use tribos_core::coupling::round::{RoundTable32, RoundTable64};
use tribos_core::coupling::table::{self, DiskTable32, DiskTable64};
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;

/// A tier's name and the tier, with force, torque and lateral function.
pub type PatchTier<R> = (&'static str, Box<dyn LateralFriction<R>>);

/// A scalar whose tables of pressures can be built at run time.
pub trait RoundTabulated: Real {
    /// The table of one pressure.
    fn round_table(alpha: f64, pressure: PowerPressure) -> Option<Box<dyn LateralFriction<Self>>>;
    /// The table of the uniform disk.
    fn disk_table(alpha: f64) -> Option<Box<dyn LateralFriction<Self>>>;
}

impl RoundTabulated for f64 {
    fn round_table(alpha: f64, pressure: PowerPressure) -> Option<Box<dyn LateralFriction<f64>>> {
        Some(Box::new(RoundTable64::new(alpha, pressure).ok()?))
    }
    fn disk_table(alpha: f64) -> Option<Box<dyn LateralFriction<f64>>> {
        Some(Box::new(DiskTable64::new(alpha).ok()?))
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
            tiers.push(("closed ring", Box::new(CoulombRing)));
        } else if order == -0.5 {
            tiers.push(("closed punch", Box::new(CoulombPunch)));
        } else if order == 0.5 {
            tiers.push(("closed Hertz", Box::new(CoulombHertz)));
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
        tiers.push(("coulomb table", Box::new(table::CoulombDisk)));
        tiers.push(("coulomb compact", Box::new(compact::CompactCoulombDisk)));
    }
    tiers
}

/// Largest errors of one tier over rows with F, T, G and the derivatives dF, dT along v.
#[derive(Clone, Debug)]
pub struct RowErrors {
    wrench: [Worst; 3],
    derivatives: [Worst; 2],
}

impl RowErrors {
    /// No rows so far.
    pub fn of(wrench: [&'static str; 3], derivatives: [&'static str; 2]) -> Self {
        Self {
            wrench: wrench.map(Worst::of),
            derivatives: derivatives.map(Worst::of),
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
}

/// Error in units of the larger of |`wanted`| and `drag`; an infinite slope must be infinite.
pub fn slope_error(wanted: &Reference, got: f64, drag: f64) -> f64 {
    let size = wanted.high.abs();
    wanted.over(got, if size > drag { size } else { drag })
}
