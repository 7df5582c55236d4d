//! Reduced wrenches of round patches and their derivatives.

use super::check::{all_nan, finite, holds, numbers};
use super::{Broken, Source, planes};
use std::sync::OnceLock;
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::table::{self, DiskTable32, DiskTable64};
use tribos_core::coupling::{
    Annulus, LateralFriction, PowerLawFriction, ReducedFriction, ReducedJacobian, RoundFriction,
    compact,
};
use tribos_core::internals::Speeds;
use tribos_core::law::PowerLaw;
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Speeds of a batch: a group that the kernel may take in lanes, and some more.
const BATCH: usize = 11;
const EXPONENTS: [f64; 6] = [-0.9, -0.5, 0.25, 1.0, 1.5, 3.0];

fn tables() -> &'static [DiskTable64] {
    static TABLES: OnceLock<Vec<DiskTable64>> = OnceLock::new();
    TABLES.get_or_init(|| {
        EXPONENTS
            .iter()
            .flat_map(|&a| DiskTable64::new(a))
            .collect()
    })
}

fn small_tables() -> &'static [DiskTable32] {
    static TABLES: OnceLock<Vec<DiskTable32>> = OnceLock::new();
    TABLES.get_or_init(|| {
        EXPONENTS
            .iter()
            .flat_map(|&a| DiskTable32::new(a as f32))
            .collect()
    })
}

fn round_tables() -> &'static [RoundTable64] {
    static TABLES: OnceLock<Vec<RoundTable64>> = OnceLock::new();
    TABLES.get_or_init(|| {
        let pressures = [
            PowerPressure::RING,
            PowerPressure::HERTZ,
            PowerPressure::PARABOLOID,
        ];
        let of = |alpha: f64| pressures.map(|pressure| RoundTable64::new(alpha, pressure));
        EXPONENTS
            .iter()
            .flat_map(|&alpha| of(alpha))
            .flatten()
            .collect()
    })
}

/// One tier at one pair of speeds.
pub fn couplings(source: &mut Source) -> Result<(), Broken> {
    match source.below(12) {
        0 => lateral::<f64>(source, &table::CoulombDisk),
        1 => lateral::<f32>(source, &table::CoulombDisk),
        2 => exact::<f64>(source, &compact::CompactCoulombDisk),
        3 => exact::<f32>(source, &compact::CompactCoulombDisk),
        4 => closed::<f64>(source),
        5 => closed::<f32>(source),
        6 => {
            let index = source.below(tables().len());
            exact(source, &tables()[index])
        }
        7 => {
            let index = source.below(small_tables().len());
            exact(source, &small_tables()[index])
        }
        8 => {
            let index = source.below(round_tables().len());
            lateral(source, &round_tables()[index])
        }
        9 => {
            let power = compact::CompactPower::new(source.one_of(&EXPONENTS));
            power.map_or(Ok(()), |power| exact::<f64>(source, &power))
        }
        10 => annulus(source),
        _ => quadrature(source),
    }
}

fn closed<R: Real>(source: &mut Source) -> Result<(), Broken> {
    match source.below(3) {
        0 => lateral::<R>(source, &CoulombRing),
        1 => lateral::<R>(source, &CoulombPunch),
        _ => lateral::<R>(source, &CoulombHertz),
    }
}

/// Finite speeds give forces ≥ 0 and derivatives that are not NaN; NaN gives NaN.
fn exact<R: Real>(source: &mut Source, tier: &impl ReducedFriction<R>) -> Result<(), Broken> {
    let (slide, rim) = (source.number::<R>(), source.number::<R>());
    let wrench = tier.reduced_wrench(slide, rim);
    let [drag, _] = tier.reduced_drag(slide, rim);
    let jacobian = tier.reduced_jacobian(slide, rim);
    let slopes = [
        jacobian.force_per_slide,
        jacobian.force_slide,
        jacobian.mixed,
        jacobian.torque_rim,
    ];
    let values = [slide, rim, wrench.force, wrench.torque];
    if slide.is_nan() || rim.is_nan() {
        all_nan("wrench", [wrench.force, wrench.torque])?;
        return all_nan("Jacobian", slopes);
    }
    if slide.is_finite() && rim.is_finite() {
        let resists = wrench.force >= R::ZERO && wrench.torque >= R::ZERO;
        holds(resists, "force and torque ≥ 0", &values)?;
        let is_ordinary = |speed: R| R::from_f64(1e-9) < speed && speed < R::from_f64(1e9);
        let opposes = drag >= R::ZERO || !is_ordinary(slide) || !is_ordinary(rim);
        holds(opposes, "drag ≥ 0", &values)?;
        numbers("Jacobian", slopes)?;
        finite(source, "wrench", [wrench.force, wrench.torque])?;
    }
    batches(source, tier)
}

/// Batches answer as single calls, to the bit.
fn batches<R: Real>(source: &mut Source, tier: &impl ReducedFriction<R>) -> Result<(), Broken> {
    let (slides, rims) = (numbers_of(source), numbers_of(source));
    let [mut forces, mut torques] = [[R::ZERO; BATCH]; 2];
    let mut slopes = [ReducedJacobian::default(); BATCH];
    tier.reduced_wrench_batch(&slides, &rims, &mut forces, &mut torques);
    tier.reduced_jacobian_batch(&slides, &rims, &mut slopes);
    for at in 0..BATCH {
        let (slide, rim) = (slides[at], rims[at]);
        let (wrench, one) = (
            tier.reduced_wrench(slide, rim),
            tier.reduced_jacobian(slide, rim),
        );
        let all = slopes[at];
        same("reduced force", forces[at], wrench.force)?;
        same("reduced torque", torques[at], wrench.torque)?;
        same("F/v", all.force_per_slide, one.force_per_slide)?;
        same("∂F/∂v", all.force_slide, one.force_slide)?;
        same("∂F/∂w", all.mixed, one.mixed)?;
        same("∂T/∂w", all.torque_rim, one.torque_rim)?;
    }
    let Ok(patch) = RoundFriction::new(tier, source.size(), source.positive()) else {
        return Ok(());
    };
    let (load, twists) = (
        source.size(),
        [(); BATCH].map(|()| planes::twist::<R>(source)),
    );
    let mut wrenches = [Wrench::ZERO; BATCH];
    let mut jacobians = [WrenchJacobian::from_element(R::ZERO); BATCH];
    patch.wrench_batch(load, &twists, &mut wrenches);
    patch.jacobian_batch(load, &twists, &mut jacobians);
    columns(&patch, load, &twists, &wrenches)?;
    for ((twist, all), slopes) in twists.iter().zip(&wrenches).zip(&jacobians) {
        let one = patch.wrench(load, twist);
        same("force", all.force.x, one.force.x)?;
        same("force", all.force.y, one.force.y)?;
        same("torque", all.torque, one.torque)?;
        for (all, one) in slopes.iter().zip(patch.wrench_jacobian(load, twist).iter()) {
            same("Jacobian", *all, *one)?;
        }
    }
    Ok(())
}

/// The same wrenches from the components of the twists.
fn columns<R: Real>(
    patch: &RoundFriction<R, impl ReducedFriction<R>>,
    load: R,
    twists: &[Twist<R>; BATCH],
    wrenches: &[Wrench<R>; BATCH],
) -> Result<(), Broken> {
    let (vx, vy) = (
        twists.map(|twist| twist.velocity.x),
        twists.map(|twist| twist.velocity.y),
    );
    let spins = twists.map(|twist| twist.spin);
    let [mut fx, mut fy, mut torques] = [[R::ZERO; BATCH]; 3];
    patch.wrench_columns(load, [&vx, &vy, &spins], [&mut fx, &mut fy, &mut torques]);
    for (((wrench, fx), fy), torque) in wrenches.iter().zip(fx).zip(fy).zip(torques) {
        same("force", fx, wrench.force.x)?;
        same("force", fy, wrench.force.y)?;
        same("torque", torque, wrench.torque)?;
    }
    Ok(())
}

fn numbers_of<R: Real>(source: &mut Source) -> [R; BATCH] {
    [(); BATCH].map(|()| source.number())
}

fn same<R: Real>(what: &str, batch: R, one: R) -> Result<(), Broken> {
    let is_same = batch.to_f64().to_bits() == one.to_f64().to_bits();
    let is_same = is_same || batch.is_nan() && one.is_nan();
    holds(is_same, what, &[batch, one])
}

fn lateral<R: Real>(source: &mut Source, tier: &impl LateralFriction<R>) -> Result<(), Broken> {
    let mut again = source.clone();
    exact(source, tier)?;
    let (slide, rim) = (again.number::<R>(), again.number::<R>());
    let (value, gradient) = (tier.lateral(slide, rim), tier.lateral_jacobian(slide, rim));
    if slide.is_nan() || rim.is_nan() {
        return all_nan("lateral force", [value]);
    }
    if slide.is_finite() && rim.is_finite() {
        numbers("lateral force", [value])?;
    }
    let _ = gradient;
    finite(source, "lateral force", [value])
}

fn annulus(source: &mut Source) -> Result<(), Broken> {
    let ratio = if source.is_mild() {
        source.unit::<f64>() * 0.9
    } else {
        source.number()
    };
    let Ok(ring) = Annulus::new(table::CoulombDisk, ratio) else {
        return Ok(());
    };
    let (slide, rim) = (source.number(), source.number());
    let (wrench, jacobian) = (
        ring.reduced_wrench(slide, rim),
        ring.reduced_jacobian(slide, rim),
    );
    finite(
        source,
        "wrench of an annulus",
        [wrench.force, wrench.torque],
    )?;
    let speeds = Speeds::new(slide, rim);
    let [phi, chi] = ring.factors(&speeds);
    if slide.is_finite() && rim.is_finite() && slide * rim != 0.0 {
        finite(source, "factors of an annulus", [phi, chi])?;
    }
    let _ = jacobian;
    // The annulus is the difference of two disks, so that its result may be negative by a rounding error.
    let least = -1e-12;
    let resists = wrench.force >= least && wrench.torque >= least;
    holds(
        resists || !source.is_mild(),
        "force and torque ≥ 0",
        &[slide, rim, wrench.force, wrench.torque],
    )?;
    batches(source, &ring)
}

fn quadrature(source: &mut Source) -> Result<(), Broken> {
    let alpha = source.one_of(&EXPONENTS);
    let Ok(law) = PowerLaw::new(alpha, 1.0) else {
        return Ok(());
    };
    let disk = DiskQuadrature::new(law);
    let (slide, rim) = (source.number::<f64>(), source.number::<f64>());
    let wrench = disk.reduced_wrench(slide, rim);
    if slide.is_nan() || rim.is_nan() {
        all_nan("quadrature", [wrench.force, wrench.torque])?;
    }
    finite(source, "quadrature", [wrench.force, wrench.torque])?;
    let _ = disk.reduced_jacobian(slide, rim);
    let resists = wrench.force >= 0.0 && wrench.torque >= 0.0;
    holds(
        resists || !source.is_mild(),
        "force and torque ≥ 0",
        &[slide, rim, wrench.force, wrench.torque],
    )?;
    batches(source, &disk)
}
