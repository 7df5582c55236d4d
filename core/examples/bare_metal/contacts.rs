//! Round contacts, limit surfaces, sliders.

use tribos_core::Real;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{self, Table32, Table64};
use tribos_core::coupling::tall::{AllRound, FrontBack, Lean, TallFriction, leaning_wrench};
use tribos_core::coupling::{
    Annulus, Coupling, Dry, Lateral, LeanProfile, PatchFriction, closed, compact,
};
use tribos_core::law::PowerLaw;
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use tribos_core::modes::Modes;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::slider::{Motion, Slider};
use tribos_core::twist::{Twist, Wrench};

/// A law with α = 1/2, prepared by the compiler: 23 KiB of flash, no RAM.
static HALF_POWER: Table64 = match Table64::new(0.5) {
    Ok(table) => table,
    Err(_) => panic!("the exponent is in range"),
};
/// The same in f32: 3 KiB.
static HALF_POWER_F32: Table32 = match Table32::new(0.5) {
    Ok(table) => table,
    Err(_) => panic!("the exponent is in range"),
};
/// A paraboloid under dry friction: 46 KiB and 6 KiB.
static PARABOLOID: RoundTable64 = match RoundTable64::new(0.0, PowerPressure::PARABOLOID) {
    Ok(table) => table,
    Err(_) => panic!("the exponent is in range"),
};
static PARABOLOID_F32: RoundTable32 = match RoundTable32::new(0.0, PowerPressure::PARABOLOID) {
    Ok(table) => table,
    Err(_) => panic!("the exponent is in range"),
};

/// What has types of its own in f64.
pub fn wide(a: f64, b: f64) -> Option<f64> {
    let mut sum = lateral_sum(&table::Coulomb, a, b) + lateral_sum(&HALF_POWER, a, b);
    sum += lateral_sum(&Table64::new(a).ok()?, a, b) + lateral_sum(&PARABOLOID, a, b);
    let pressure = PolynomialPressure::new([a, b, -a]).ok()?;
    sum += lateral_sum(&LateralPolynomialTable::new(a, &pressure).ok()?, a, b);
    sum += Modes::new(&HALF_POWER, a).ok()?.finite_fixed_point()?;
    let dry = Dry::new(&PARABOLOID).ok()?;
    sum += set_sum(&LimitSurface::new(&dry, a, b).ok()?, a, b);
    let lean = LeanProfile::new(&dry, a).ok()?;
    sum += Modes::new(lean, b).ok()?.finite_fixed_point()?;
    let slider = Slider::new(table::Coulomb, a, b, 0.5).ok()?;
    sum += slider.to_rest(&Motion::launched(a, b))?.motion.time;
    Some(sum + slider.verlet_step(&Motion::launched(a, b), b).speed)
}

/// What has types of its own in f32.
pub fn single(a: f32, b: f32) -> Option<f32> {
    let mut sum = lateral_sum(&table::Coulomb, a, b) + lateral_sum(&HALF_POWER_F32, a, b);
    sum += lateral_sum(&Table32::new(a).ok()?, a, b) + lateral_sum(&PARABOLOID_F32, a, b);
    sum += Modes::new(&HALF_POWER_F32, a).ok()?.finite_fixed_point()?;
    let slider = Slider::new(&HALF_POWER_F32, a, b, 0.5).ok()?;
    Some(sum + slider.advance(&Motion::launched(a, b), b).motion.time)
}

/// What serves any scalar.
pub fn either<R: table::CoulombTable>(a: R, b: R) -> Option<R> {
    let hertz = compact::Power::with_pressure(a, PowerPressure::HERTZ).ok()?;
    let mut sum = lateral_sum(&compact::Coulomb, a, b) + lateral_sum(&hertz, a, b);
    sum += lateral_sum(&closed::Ring, a, b) + lateral_sum(&closed::FlatPunch, a, b);
    sum += lateral_sum(&closed::Hertz, a, b);
    sum += lateral_sum(&Annulus::new(table::Coulomb, a).ok()?, a, b);
    sum += wrench_sum(&DiskQuadrature::new(PowerLaw::new(a, b).ok()?), a, b);
    sum += tall_sum::<R, FrontBack>(a, b)? + tall_sum::<R, AllRound>(a, b)?;
    sum += leaning_wrench(&closed::Ring, [a, b], [b, a]).lateral;
    sum += set_sum(&LimitSurface::new(table::Coulomb, a, b).ok()?, a, b);
    sum += set_sum(&LimitSurface::new(closed::Ring, a, b).ok()?, a, b);
    Some(sum + set_sum(&Ellipsoid::new(a, b, b).ok()?, a, b))
}

/// Wrench and Jacobian of one coupling.
fn wrench_sum<R: Real>(coupling: &impl Coupling<R>, v: R, w: R) -> R {
    let wrench = coupling.reduced_wrench(v, w);
    let jacobian = coupling.reduced_jacobian(v, w);
    wrench.force + wrench.torque + jacobian.force_slide + jacobian.mixed + jacobian.torque_rim
}

/// The same and what is lateral.
fn lateral_sum<R: Real>(coupling: &impl Lateral<R>, v: R, w: R) -> R {
    let change = coupling.lateral_jacobian(v, w);
    let lateral = coupling.lateral(v, w) + change.slide + change.rim;
    wrench_sum(coupling, v, w) + lateral + coupling.mean_square_radius()
}

fn tall_sum<R: table::CoulombTable, L: Lean>(a: R, b: R) -> Option<R> {
    let foot = PatchFriction::new(table::Coulomb, a, b).ok()?;
    let tall = TallFriction::<R, _, L>::new(foot, b).ok()?;
    let wrench = tall.wrench(a, &Twist::new(a, b, a)).whole().ok()?;
    Some(wrench.force.x + wrench.torque)
}

/// Both ways through a friction set.
fn set_sum<R: Real>(set: &impl FrictionSet<R>, v: R, w: R) -> R {
    let Wrench { force, torque } = set.wrench(&Twist::new(v, w, v));
    let push = Wrench {
        force: -(force + force),
        torque: -torque,
    };
    let motion = set.twist_normal_to(&set.scale_to_surface(&push));
    let carried = set.project_with_length(&push, w).wrench;
    set.support(&motion) + set.gauge(&carried)
}
