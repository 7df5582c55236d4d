//! Bits of profiles: speeds, scales, what decides the final motion; every tier at the ends.

use crate::hash::Fnv;
use crate::inputs::{Lcg, arguments, ends, pairs_of_ends, speed, unit};
use crate::tiers::at;
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{
    LateralPolynomialTable, PolynomialTable, RoundTable32, RoundTable64,
};
use tribos_core::coupling::table::{self, DiskTable32, DiskTable64};
use tribos_core::coupling::unscaled_wrench;
use tribos_core::coupling::{Annulus, DryProfile, LateralFriction, PowerLawFriction, compact};
use tribos_core::internals::{DominantSpeed, LeanProfile, SmoothProfile, Speeds};
use tribos_core::law::PowerLaw;
use tribos_core::modes::{Stability, TerminalMode, TerminalMotion, inertia_interval};
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;

const fn made<T: Copy, E: Copy>(table: Result<T, E>) -> T {
    match table {
        Ok(table) => table,
        Err(_) => panic!("the exponent is in range"),
    }
}

static HALF_64: DiskTable64 = made(DiskTable64::new(0.5));
static HALF_32: DiskTable32 = made(DiskTable32::new(0.5));
static HERTZ_64: RoundTable64 = made(RoundTable64::new(-0.25, PowerPressure::HERTZ));
static RIM_32: RoundTable32 = made(RoundTable32::new(2.0, PowerPressure::RING));

/// Digest of tables that the compiler made.
pub fn flash_tables() -> u64 {
    let mut hash = Fnv::new();
    smooth(&mut hash, &HALF_64, 200);
    smooth(&mut hash, &HALF_32, 200);
    smooth(&mut hash, &HERTZ_64, 200);
    smooth(&mut hash, &RIM_32, 200);
    smooth::<f64, _>(&mut hash, &table::CoulombDisk, 200);
    smooth::<f32, _>(&mut hash, &table::CoulombDisk, 200);
    hash.0
}

/// Digest of tables for mixtures of pressures, made at run time.
pub fn polynomials() -> u64 {
    let mut hash = Fnv::new();
    let mixed = PolynomialPressure::new([0.25, 1.0, -0.5]).expect("positive");
    for alpha in [0.0, 0.5] {
        let table = PolynomialTable::new(alpha, &mixed).expect("in range");
        profile(&mut hash, &table, 60);
        for speeds in arguments(167, 60) {
            at(&mut hash, &table, speeds);
        }
        slopes(&mut hash, &table, 60);
        let table = LateralPolynomialTable::new(alpha, &mixed).expect("in range");
        smooth(&mut hash, &table, 60);
    }
    hash.0
}

/// Digest of the forms without tables: closed, compact, dry, annular, by quadrature.
pub fn plain_forms() -> u64 {
    let mut hash = Fnv::new();
    plain_forms_of::<f64>(&mut hash);
    plain_forms_of::<f32>(&mut hash);
    for alpha in [-0.75, 0.5, 2.0] {
        let power = compact::CompactPower::new(alpha).expect("in range");
        smooth::<f64, _>(&mut hash, &power, 4);
        let power = compact::CompactPower::with_pressure(alpha as f32, PowerPressure::PARABOLOID);
        smooth::<f32, _>(&mut hash, &power.expect("in range"), 4);
    }
    hash.0
}

fn plain_forms_of<R: Real>(hash: &mut Fnv) {
    smooth::<R, _>(hash, &compact::CompactCoulombDisk, 30);
    smooth::<R, _>(hash, &CoulombRing, 20);
    smooth::<R, _>(hash, &CoulombPunch, 20);
    smooth::<R, _>(hash, &CoulombHertz, 20);
    smooth::<R, _>(hash, &DryProfile::new::<R>(CoulombHertz).expect("dry"), 10);
    let annulus = Annulus::new(table::CoulombDisk, R::from_f64(0.625)).expect("in range");
    both::<R, _>(hash, &annulus, 20);
    profile::<R, _>(hash, &annulus, 20);
    let lean = R::from_f64(0.25);
    let leaning = LeanProfile::<R, _>::new(table::CoulombDisk, lean).expect("in range");
    profile(hash, &leaning, 10);
    let law = PowerLaw::new(R::HALF, R::ONE).expect("in range");
    let disk = DiskQuadrature::new(law);
    hash.number(disk.law().alpha());
    let mut some = arguments(103, 8).chain(pairs_of_ends().step_by(21));
    some.by_ref()
        .for_each(|speeds: (R, R)| at(hash, &disk, speeds));
    for x in ends::<R>() {
        hash.verdict(&Annulus::new(table::CoulombDisk, x));
        hash.verdict(&compact::CompactPower::new(x));
        hash.verdict(&LeanProfile::<R, _>::new(CoulombHertz, x));
    }
}

fn smooth<R: Real, P: SmoothProfile<R> + LateralFriction<R>>(
    hash: &mut Fnv,
    tier: &P,
    count: usize,
) {
    both(hash, tier, count);
    profile(hash, tier, count);
    slopes(hash, tier, count);
}

fn slopes<R: Real, P: SmoothProfile<R>>(hash: &mut Fnv, tier: &P, count: usize) {
    for (slide, rim) in arguments(107, count) {
        let speeds = Speeds::new(slide, rim);
        hash.numbers(tier.factors_and_slope(&speeds));
        hash.numbers(tier.factors_and_rough_slope(&speeds));
    }
}

/// Wrench, Jacobian and lateral function, also at the ends.
fn both<R: Real, C: LateralFriction<R>>(hash: &mut Fnv, tier: &C, count: usize) {
    let some = pairs_of_ends().step_by(if count < 10 { 25 } else { 5 });
    for (slide, rim) in arguments(109, count).chain(some) {
        at(hash, tier, (slide, rim));
        hash.lateral(tier.lateral(slide, rim), tier.lateral_jacobian(slide, rim));
    }
    hash.number(tier.mean_square_radius());
}

/// What only a profile tells.
fn profile<R: Real, P: PowerLawFriction<R>>(hash: &mut Fnv, tier: &P, count: usize) {
    hash.number(tier.exponent());
    hash.numbers(tier.inertia_ends());
    for (slide, rim) in arguments(113, count) {
        let speeds = Speeds::new(slide, rim);
        hash.numbers([tier.inertia_excess(&speeds, R::HALF)]);
        hash.numbers(tier.factors(&speeds));
        hash.numbers(tier.drag_and_torque(&speeds));
        hash.numbers([tier.speed_scale(slide), tier.rate_scale(rim)]);
    }
    for x in ends() {
        let wrench = unscaled_wrench(tier, x, R::ONE);
        hash.numbers([wrench.force, wrench.torque]);
        hash.numbers([tier.speed_scale(x), tier.rate_scale(x)]);
    }
}

/// Digest of speeds and of fixed points of sliders, f64 and f32.
pub fn modes() -> u64 {
    let mut hash = Fnv::new();
    speeds::<f64>(&mut hash);
    speeds::<f32>(&mut hash);
    modes_of::<f64, _>(&mut hash, &table::CoulombDisk);
    modes_of::<f32, _>(&mut hash, &table::CoulombDisk);
    modes_of(&mut hash, &HALF_64);
    modes_of(&mut hash, &HALF_32);
    modes_of(&mut hash, &HERTZ_64);
    modes_of(&mut hash, &RIM_32);
    modes_of::<f64, _>(&mut hash, &CoulombHertz);
    modes_of::<f32, _>(&mut hash, &CoulombRing);
    for alpha in [-0.75, 0.0, 0.5, 1.0, 2.0] {
        for order in ends::<f64>() {
            let (least, most) = inertia_interval(alpha, order);
            hash.numbers([least, most]);
            let (least, most) = inertia_interval(alpha as f32, order as f32);
            hash.numbers([least, most]);
        }
    }
    hash.0
}

fn speeds<R: Real>(hash: &mut Fnv) {
    for (slide, rim) in arguments(127, 100).chain(pairs_of_ends()) {
        let speeds = Speeds::<R>::new(slide, rim);
        hash.feed(
            u64::from(speeds.at_rest()) | u64::from(speeds.lead() == DominantSpeed::Sliding) << 1,
        );
        hash.numbers([speeds.ratio(), speeds.complement()]);
    }
}

fn modes_of<R: Real, P: PowerLawFriction<R>>(hash: &mut Fnv, profile: &P) {
    for c in [0.125, 0.4, 0.5, 0.625, 0.75, 1.0] {
        let modes = TerminalMotion::new(profile, R::from_f64(c)).expect("in range");
        hash.maybe(modes.finite_fixed_point());
        let (least, most) = modes.inertia_interval();
        hash.numbers([least, most]);
        let points = modes.fixed_points();
        hash.feed(stability(points.spinning) | stability(points.sliding) << 2);
        if let Some((ratio, kind)) = points.finite {
            hash.number(ratio);
            hash.feed(stability(kind));
        }
    }
    let modes = TerminalMotion::new(profile, R::HALF).expect("in range");
    let mut rng = Lcg::new(131);
    let some = [(); 6].map(|()| speed::<R>(&mut rng) + unit(&mut rng));
    for ratio in some.into_iter().chain(ends()) {
        hash.numbers([modes.growth(ratio), modes.inertia_ratio_of(ratio)]);
        match modes.terminal_mode(ratio) {
            TerminalMode::Spinning => hash.feed(0),
            TerminalMode::Sliding => hash.feed(1),
            TerminalMode::Together { ratio } => hash.number(ratio),
        }
        hash.verdict(&TerminalMotion::new(profile, ratio));
    }
}

fn stability(of: Stability) -> u64 {
    match of {
        Stability::Stable => 0,
        Stability::Semistable => 1,
        Stability::Unstable => 2,
    }
}
