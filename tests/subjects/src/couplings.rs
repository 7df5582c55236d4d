//! Round patches: reduced wrenches, their derivatives, profiles, batches.

use crate::planes::{parts, twist};
use crate::{Input, Verdict};
use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::{
    Annulus, DryProfile, LateralFriction, PowerLawFriction, ReducedFriction, ReducedJacobian,
    RoundFriction, WornAnnulus, unscaled_wrench,
};
use tribos_core::internals::{DominantSpeed, LeanProfile, SmoothProfile, Speeds};
use tribos_core::law::PowerLaw;
use tribos_core::patch::PowerPressure;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Speeds of a batch: a group that the kernel may take in lanes, and some more.
const BATCH: usize = 11;
/// Exponents of the power law.
pub(crate) const EXPONENTS: [f64; 6] = [-0.9, -0.5, 0.25, 1.0, 1.5, 3.0];
/// Pressures.
pub(crate) const PRESSURES: [PowerPressure; 5] = [
    PowerPressure::RING,
    PowerPressure::FLAT_PUNCH,
    PowerPressure::UNIFORM,
    PowerPressure::HERTZ,
    PowerPressure::PARABOLOID,
];

/// One tier without a table of its own.
pub fn closed<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(7) {
        0 => smooth::<R>(input, &CoulombDisk),
        1 => smooth::<R>(input, &CoulombParaboloid),
        2 => smooth::<R>(input, &CoulombRing),
        3 => smooth::<R>(input, &CoulombPunch),
        4 => smooth::<R>(input, &CoulombHertz),
        5 => {
            let alpha = R::from_f64(input.one_of(&EXPONENTS));
            let pressure = input.one_of(&PRESSURES);
            let power = input.taken(CompactPower::with_pressure(alpha, pressure))?;
            smooth(input, &power)
        }
        _ => {
            let power = CompactPower::new(input.number::<R>());
            let power = input.taken(power)?;
            let speeds = [input.number(), input.number()];
            profile(input, &power, speeds)
        }
    }
}

/// One patch that is made of another.
pub fn combined<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(5) {
        0 => {
            let dry = input.taken(DryProfile::new::<R>(CoulombHertz))?;
            smooth::<R>(input, &dry)
        }
        1 => {
            let lean = LeanProfile::<R, _>::new(CoulombDisk, input.unit());
            let lean = input.taken(lean)?;
            let speeds = [input.number(), input.number()];
            profile(input, &lean, speeds)
        }
        2 => annulus::<R>(input, CoulombDisk),
        3 => {
            let ratio = inner_ratio::<R>(input);
            let band = input.taken(WornAnnulus::new(ratio))?;
            let own = band.inner_ratio();
            input.holds(own == ratio, "its inner ratio", &[own])?;
            let speeds = [input.number(), input.number()];
            input.give(band.factors_and_rough_slope(&Speeds::new(speeds[0], speeds[1])));
            profile(input, &band, speeds)?;
            exact(input, &band, speeds)?;
            batches(input, &band)
        }
        _ => {
            let alpha = R::from_f64(input.one_of(&EXPONENTS));
            let power = input.taken(CompactPower::new(alpha))?;
            annulus(input, power)
        }
    }
}

/// All that a tier tells at one pair of speeds, and a batch.
pub(crate) fn smooth<R: Real>(
    input: &mut Input<'_>,
    tier: &(impl SmoothProfile<R> + LateralFriction<R>),
) -> Verdict {
    let at = [input.number(), input.number()];
    let speeds = Speeds::new(at[0], at[1]);
    input.give(tier.factors_and_slope(&speeds));
    input.give(tier.factors_and_rough_slope(&speeds));
    if at.iter().all(|speed| speed.is_finite()) {
        input.numbers("factors", tier.factors(&speeds))?;
    }
    profile(input, tier, at)?;
    exact(input, tier, at)?;
    lateral(input, tier, at)?;
    batches(input, tier)
}

/// Finite speeds give forces ≥ 0 and derivatives that are not NaN; NaN gives NaN.
fn exact<R: Real>(
    input: &mut Input<'_>,
    tier: &impl ReducedFriction<R>,
    [slide, rim]: [R; 2],
) -> Verdict {
    let wrench = tier.reduced_wrench(slide, rim);
    let [drag, _] = tier.reduced_drag(slide * slide, rim);
    let slopes = slopes(tier.reduced_jacobian(slide, rim));
    let values = [slide, rim, wrench.force, wrench.torque];
    input.give(slopes.into_iter().chain([drag]));
    if slide.is_nan() || rim.is_nan() {
        input.all_nan("wrench", [wrench.force, wrench.torque])?;
        return input.all_nan("Jacobian", slopes);
    }
    input.give(values);
    if slide.is_finite() && rim.is_finite() {
        let resists = wrench.force >= R::ZERO && wrench.torque >= R::ZERO;
        input.holds(resists, "force and torque ≥ 0", &values)?;
        let is_ordinary = |speed: R| R::from_f64(1e-9) < speed && speed < R::from_f64(1e9);
        let opposes = drag >= R::ZERO || !is_ordinary(slide) || !is_ordinary(rim);
        input.holds(opposes, "drag ≥ 0", &values)?;
        input.numbers("Jacobian", slopes)?;
        input.finite("wrench", [wrench.force, wrench.torque])?;
    }
    Ok(())
}

fn slopes<R: Real>(of: ReducedJacobian<R>) -> [R; 4] {
    [of.force_per_slide, of.force_slide, of.mixed, of.torque_rim]
}

/// Finite speeds give a lateral force.
fn lateral<R: Real>(
    input: &mut Input<'_>,
    tier: &impl LateralFriction<R>,
    [slide, rim]: [R; 2],
) -> Verdict {
    let (value, gradient) = (tier.lateral(slide, rim), tier.lateral_jacobian(slide, rim));
    input.give([gradient.slide, gradient.rim, tier.mean_square_radius()]);
    if slide.is_nan() || rim.is_nan() {
        return input.all_nan("lateral force", [value]);
    }
    if slide.is_finite() && rim.is_finite() {
        input.numbers("lateral force", [value])?;
    }
    input.finite("lateral force", [value])
}

/// What only a profile tells.
pub(crate) fn profile<R: Real>(
    input: &mut Input<'_>,
    tier: &impl PowerLawFriction<R>,
    [slide, rim]: [R; 2],
) -> Verdict {
    let speeds = Speeds::new(slide, rim);
    let lead = u64::from(speeds.lead() == DominantSpeed::Sliding);
    input.give_bits(u64::from(speeds.at_rest()) << 1 | lead);
    input.give([speeds.ratio(), speeds.complement(), tier.exponent()]);
    input.give(tier.inertia_ends());
    let factors = tier.factors(&speeds);
    if speeds.at_rest() {
        // They are of the larger speed, which is 1 in motion.
        input.give(factors);
    } else {
        input.finite("factors", factors)?;
    }
    let inertia = tier.inertia_excess(&speeds, R::HALF);
    input.give(tier.drag_and_torque(&speeds).into_iter().chain([inertia]));
    input.give(tier.drag(slide * slide, rim));
    input.give([tier.speed_scale(slide), tier.rate_scale(rim)]);
    let wrench = unscaled_wrench(tier, slide, rim);
    input.give([wrench.force, wrench.torque]);
    Ok(())
}

/// Batches answer as single calls, to the bit.
pub(crate) fn batches<R: Real>(input: &mut Input<'_>, tier: &impl ReducedFriction<R>) -> Verdict {
    let [slides, rims] = [(); 2].map(|()| [(); BATCH].map(|()| input.number::<R>()));
    let [mut forces, mut torques] = [[R::ZERO; BATCH]; 2];
    let mut together = [ReducedJacobian::default(); BATCH];
    tier.reduced_wrench_batch(&slides, &rims, &mut forces, &mut torques);
    tier.reduced_jacobian_batch(&slides, &rims, &mut together);
    for at in 0..BATCH {
        let one = tier.reduced_wrench(slides[at], rims[at]);
        same(
            input,
            "reduced wrench",
            [forces[at], torques[at]],
            [one.force, one.torque],
        )?;
        let one = slopes(tier.reduced_jacobian(slides[at], rims[at]));
        same(input, "reduced Jacobian", slopes(together[at]), one)?;
    }
    let patch = RoundFriction::new(tier, input.size(), input.positive());
    let patch = input.taken(patch)?;
    let (load, twists) = (input.size(), [(); BATCH].map(|()| twist::<R>(input)));
    let mut wrenches = [Wrench::ZERO; BATCH];
    let mut jacobians = [WrenchJacobian::from_element(R::ZERO); BATCH];
    patch.wrench_batch(load, &twists, &mut wrenches);
    patch.jacobian_batch(load, &twists, &mut jacobians);
    for ((twist, all), slopes) in twists.iter().zip(&wrenches).zip(&jacobians) {
        same(
            input,
            "wrench",
            parts(all),
            parts(&patch.wrench(load, twist)),
        )?;
        let one = patch.wrench_jacobian(load, twist);
        same(
            input,
            "Jacobian",
            slopes.iter().copied(),
            one.iter().copied(),
        )?;
    }
    columns(input, &patch, load, &twists, &wrenches)
}

/// The same wrenches from the components of the twists.
fn columns<R: Real>(
    input: &mut Input<'_>,
    patch: &RoundFriction<R, impl ReducedFriction<R>>,
    load: R,
    twists: &[Twist<R>; BATCH],
    wrenches: &[Wrench<R>; BATCH],
) -> Verdict {
    let vx = twists.map(|twist| twist.velocity.x);
    let vy = twists.map(|twist| twist.velocity.y);
    let spins = twists.map(|twist| twist.spin);
    let [mut fx, mut fy, mut torques] = [[R::ZERO; BATCH]; 3];
    patch.wrench_columns(load, [&vx, &vy, &spins], [&mut fx, &mut fy, &mut torques]);
    for (at, wrench) in wrenches.iter().enumerate() {
        same(
            input,
            "columns",
            [fx[at], fy[at], torques[at]],
            parts(wrench),
        )?;
    }
    Ok(())
}

fn same<R: Real>(
    input: &mut Input<'_>,
    what: &'static str,
    batch: impl IntoIterator<Item = R>,
    one: impl IntoIterator<Item = R>,
) -> Verdict {
    for (batch, one) in batch.into_iter().zip(one) {
        let is_same = batch.to_f64().to_bits() == one.to_f64().to_bits();
        let is_same = is_same || batch.is_nan() && one.is_nan();
        input.holds(is_same, what, &[batch, one])?;
    }
    Ok(())
}

/// Inner over outer radius of an annulus: refused, of any width, or in half of the inputs a thin band.
pub(crate) fn inner_ratio<R: Real>(input: &mut Input<'_>) -> R {
    if input.one_in(2) {
        let thinnest = 1.0 - Annulus::<R, CoulombDisk>::MAX_INNER_RATIO;
        R::from_f64(1.0 - thinnest * f64::from(1_u32 << input.below(THIN)))
    } else if input.is_mild() {
        input.unit()
    } else {
        input.number()
    }
}

/// Octaves of the widths of thin bands: from 1e-6 to 1/30.
const THIN: usize = 16;

fn annulus<R: Real>(
    input: &mut Input<'_>,
    disk: impl SmoothProfile<R> + LateralFriction<R> + Copy,
) -> Verdict {
    let ratio = inner_ratio(input);
    let ring = input.taken(Annulus::new(disk, ratio))?;
    let [slide, rim] = [input.number(), input.number()];
    let wrench = ring.reduced_wrench(slide, rim);
    input.finite("wrench of an annulus", [wrench.force, wrench.torque])?;
    if input.is_mild() {
        // Up to 15/16 the annulus is the difference of two disks, divided by 1 − k² > 1/9.
        let disk = disk.reduced_wrench(slide, rim);
        let scale = R::from_f64(9.0) * (disk.force + disk.torque);
        input.at_most("force ≥ 0", -wrench.force, R::ZERO, scale)?;
        input.at_most("torque ≥ 0", -wrench.torque, R::ZERO, scale)?;
    }
    profile(input, &ring, [slide, rim])?;
    lateral(input, &ring, [slide, rim])?;
    batches(input, &ring)
}

/// The disk by quadrature.
pub fn quadrature<R: Real>(input: &mut Input<'_>) -> Verdict {
    let alpha = R::from_f64(input.one_of(&EXPONENTS));
    let law = input.taken(PowerLaw::new(alpha, R::ONE))?;
    let disk = DiskQuadrature::new(law);
    let (slide, rim) = (input.number::<R>(), input.number::<R>());
    let wrench = disk.reduced_wrench(slide, rim);
    if slide.is_nan() || rim.is_nan() {
        input.all_nan("quadrature", [wrench.force, wrench.torque])?;
    }
    input.finite("quadrature", [wrench.force, wrench.torque])?;
    input.give(slopes(disk.reduced_jacobian(slide, rim)));
    let resists = wrench.force >= R::ZERO && wrench.torque >= R::ZERO;
    let values = [slide, rim, disk.law().alpha(), wrench.force, wrench.torque];
    input.holds(resists || !input.is_mild(), "force and torque ≥ 0", &values)?;
    batches(input, &disk)
}
