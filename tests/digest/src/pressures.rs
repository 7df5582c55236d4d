//! Bits of round patches under other pressures.

use crate::ARGUMENTS;
use crate::hash::Fnv;
use crate::inputs::arguments;
use crate::tiers::{EXPONENTS, at};
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{Annulus, LateralFriction, compact};
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

/// Pressures of the sweep.
const PRESSURES: [PowerPressure; 5] = [
    PowerPressure::RING,
    PowerPressure::FLAT_PUNCH,
    PowerPressure::UNIFORM,
    PowerPressure::HERTZ,
    PowerPressure::PARABOLOID,
];

/// Wrench, Jacobian and lateral function with its gradient.
fn patch<R: Real>(hash: &mut Fnv, tier: &dyn LateralFriction<R>) {
    for (slide, rim) in arguments(19, ARGUMENTS / 4) {
        at(hash, tier, (slide, rim));
        hash.lateral(tier.lateral(slide, rim), tier.lateral_jacobian(slide, rim));
    }
}

/// Hash of the f64 tables of pressures, with annuli and a polynomial.
pub fn pressures_f64() -> u64 {
    let mut hash = Fnv::new();
    let mixed = PolynomialPressure::new([0.25, 1.0, -0.5]).expect("positive");
    for alpha in EXPONENTS {
        for pressure in PRESSURES {
            let table = RoundTable64::new(alpha, pressure).expect("in range");
            patch(&mut hash, &table);
            let power = compact::CompactPower::with_pressure(alpha, pressure).expect("in range");
            patch(&mut hash, &power);
        }
        let disk = DiskTable64::new(alpha).expect("in range");
        patch(&mut hash, &Annulus::new(disk, 0.625).expect("in range"));
        let polynomial = LateralPolynomialTable::new(alpha, &mixed).expect("in range");
        patch(&mut hash, &polynomial);
    }
    hash.0
}

/// Hash of the f32 tables of pressures, with annuli.
pub fn pressures_f32() -> u64 {
    let mut hash = Fnv::new();
    for alpha in EXPONENTS.map(|alpha| alpha as f32) {
        for pressure in PRESSURES {
            let table = RoundTable32::new(alpha, pressure).expect("in range");
            patch(&mut hash, &table);
            let power = compact::CompactPower::with_pressure(alpha, pressure).expect("in range");
            patch(&mut hash, &power);
        }
        let disk = DiskTable32::new(alpha).expect("in range");
        patch(&mut hash, &Annulus::new(disk, 0.625).expect("in range"));
    }
    hash.0
}

/// Hash of the closed forms, f64 and f32.
pub fn closed_forms() -> u64 {
    let mut hash = Fnv::new();
    patch::<f64>(&mut hash, &CoulombRing);
    patch::<f64>(&mut hash, &CoulombPunch);
    patch::<f64>(&mut hash, &CoulombHertz);
    patch::<f32>(&mut hash, &CoulombRing);
    patch::<f32>(&mut hash, &CoulombPunch);
    patch::<f32>(&mut hash, &CoulombHertz);
    hash.0
}
