//! Bits of the accuracy tiers over the uniform disk.

use crate::ARGUMENTS;
use crate::hash::Fnv;
use crate::inputs::arguments;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::{self, DiskTable32, DiskTable64};
use tribos_core::coupling::{ReducedFriction, compact};
use tribos_core::law::PowerLaw;
use tribos_core::real::Real;

/// Wrench and Jacobian at one pair of speeds.
pub(crate) fn at<R: Real>(hash: &mut Fnv, tier: &dyn ReducedFriction<R>, (slide, rim): (R, R)) {
    hash.reduced(
        tier.reduced_wrench(slide, rim),
        tier.reduced_jacobian(slide, rim),
    );
}

/// Wrench and Jacobian of a tier over one stream of arguments.
fn coupling<R: Real>(hash: &mut Fnv, tier: &dyn ReducedFriction<R>) {
    for speeds in arguments(7, ARGUMENTS) {
        at(hash, tier, speeds);
    }
}

/// Exponents of the sweep, all exact in binary.
pub(crate) const EXPONENTS: [f64; 6] = [-0.75, -0.25, 0.5, 1.0, 2.0, 3.5];

/// Hash of the f64 tables.
pub fn tables_f64() -> u64 {
    let mut hash = Fnv::new();
    coupling::<f64>(&mut hash, &table::CoulombDisk);
    for alpha in EXPONENTS {
        coupling(&mut hash, &DiskTable64::new(alpha).expect("in range"));
    }
    hash.0
}

/// Hash of the f32 tables.
pub fn tables_f32() -> u64 {
    let mut hash = Fnv::new();
    coupling::<f32>(&mut hash, &table::CoulombDisk);
    for alpha in EXPONENTS {
        coupling(
            &mut hash,
            &DiskTable32::new(alpha as f32).expect("in range"),
        );
    }
    hash.0
}

/// Hash of the compact tier, f64 and f32.
pub fn compact() -> u64 {
    let mut hash = Fnv::new();
    coupling::<f64>(&mut hash, &compact::CompactCoulombDisk);
    coupling::<f32>(&mut hash, &compact::CompactCoulombDisk);
    for alpha in EXPONENTS {
        coupling(
            &mut hash,
            &compact::CompactPower::new(alpha).expect("in range"),
        );
    }
    hash.0
}

/// Hash of the quadrature, f64 and f32.
pub fn quadrature() -> u64 {
    let mut hash = Fnv::new();
    for alpha in [0.0, 0.5, 2.0] {
        let wide = PowerLaw::new(alpha, 1.5).expect("in range");
        coupling(&mut hash, &DiskQuadrature::new(wide));
        let single = PowerLaw::new(alpha as f32, 1.5).expect("in range");
        coupling(&mut hash, &DiskQuadrature::new(single));
    }
    hash.0
}
