//! One number for the bits of everything the kernel computes, to compare platforms with.
//!
//! Inputs come from integers and + − × / alone, so that no platform's mathematics library takes
//! part; the kernel's own roots and powers come from the `libm` crate.

mod contacts;
mod more;

pub use contacts::contacts;
pub use more::{laws, limit_surfaces, nodes};

use crate::sweep::Lcg;
use tribos_core::coupling::closed::{FlatPunch, Hertz, Ring};
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{self, Table32, Table64};
use tribos_core::coupling::tall::{AllRound, FrontBack, Lean, TallFriction};
use tribos_core::coupling::{Annulus, Coupling, Lateral, PatchFriction, compact};
use tribos_core::law::PowerLaw;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::real::Real;
use tribos_core::slider::{Motion, Slider};
use tribos_core::twist::Twist;

/// 64-bit Fowler–Noll–Vo hash, version 1a.
#[derive(Clone, Copy, Debug)]
struct Fnv(u64);

const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const FNV_PRIME: u64 = 0x0000_0100_0000_01b3;
/// All NaN count as this one: their payload is not part of any promise.
const CANONICAL_NAN: u64 = 0x7ff8_0000_0000_0000;
/// Arguments per tier and exponent.
const ARGUMENTS: usize = 2000;

impl Fnv {
    fn new() -> Self {
        Self(FNV_OFFSET)
    }

    fn feed(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(FNV_PRIME);
        }
    }

    /// A number as the bits of its f64, which is exact for f32.
    fn number<R: Real>(&mut self, x: R) {
        let wide = x.to_f64();
        self.feed(if wide.is_nan() {
            CANONICAL_NAN
        } else {
            wide.to_bits()
        });
    }
}

/// A speed m·2^k with 0 ≤ m < 1 and |k| ≤ 20, from integers and divisions.
fn speed<R: Real>(rng: &mut Lcg) -> R {
    let bits = rng.bits();
    let mantissa = (bits >> 40) as f64 / 16_777_216.0;
    let power = (1_u64 << (bits & 31)) as f64;
    R::from_f64(mantissa * power / 2048.0)
}

/// `count` pairs of sliding and rim speed, three in eight of them equal or nearly so.
fn arguments<R: Real>(seed: u64, count: usize) -> impl Iterator<Item = (R, R)> {
    let mut rng = Lcg::new(seed);
    (0..count).map(move |n| {
        let slide: R = speed(&mut rng);
        let rim = match n % 8 {
            0 => slide,
            1 => slide * R::from_f64(1.0 + 1.0 / 4096.0),
            2 => slide * (R::ONE - R::EPSILON),
            _ => speed(&mut rng),
        };
        (slide, rim)
    })
}

/// Wrench and Jacobian at one pair of speeds.
fn at<R: Real>(hash: &mut Fnv, tier: &dyn Coupling<R>, (slide, rim): (R, R)) {
    let wrench = tier.reduced_wrench(slide, rim);
    let jacobian = tier.reduced_jacobian(slide, rim);
    for x in [
        wrench.force,
        wrench.torque,
        jacobian.force_per_slide,
        jacobian.force_slide,
        jacobian.mixed,
        jacobian.torque_rim,
    ] {
        hash.number(x);
    }
}

/// Wrench and Jacobian of a tier over one stream of arguments.
fn coupling<R: Real>(hash: &mut Fnv, tier: &dyn Coupling<R>) {
    for speeds in arguments(7, ARGUMENTS) {
        at(hash, tier, speeds);
    }
}

/// Exponents of the sweep, all exact in binary.
const EXPONENTS: [f64; 6] = [-0.75, -0.25, 0.5, 1.0, 2.0, 3.5];

/// Hash of the f64 tables.
pub fn tables_f64() -> u64 {
    let mut hash = Fnv::new();
    coupling::<f64>(&mut hash, &table::Coulomb);
    for alpha in EXPONENTS {
        coupling(&mut hash, &Table64::new(alpha).expect("in range"));
    }
    hash.0
}

/// Hash of the f32 tables.
pub fn tables_f32() -> u64 {
    let mut hash = Fnv::new();
    coupling::<f32>(&mut hash, &table::Coulomb);
    for alpha in EXPONENTS {
        coupling(&mut hash, &Table32::new(alpha as f32).expect("in range"));
    }
    hash.0
}

/// Hash of the compact tier, f64 and f32.
pub fn compact() -> u64 {
    let mut hash = Fnv::new();
    coupling::<f64>(&mut hash, &compact::Coulomb);
    coupling::<f32>(&mut hash, &compact::Coulomb);
    for alpha in EXPONENTS {
        coupling(&mut hash, &compact::Power::new(alpha).expect("in range"));
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

/// Hash of wrenches and their Jacobians in the plane.
pub fn wrenches() -> u64 {
    let mut hash = Fnv::new();
    let puck = PatchFriction::new(table::Coulomb, 0.3, 0.04).expect("a coefficient");
    let mut rng = Lcg::new(11);
    for _ in 0..ARGUMENTS {
        let [x, y, spin] = [(); 3].map(|()| speed::<f64>(&mut rng) - speed::<f64>(&mut rng));
        let twist = Twist::new(x, y, spin);
        let wrench = puck.wrench(1.7, &twist);
        for v in [wrench.force.x, wrench.force.y, wrench.torque] {
            hash.number(v);
        }
        for &v in puck.wrench_jacobian(1.7, &twist).iter() {
            hash.number(v);
        }
    }
    hash.0
}

/// Pressures of the sweep.
const PRESSURES: [PowerPressure; 5] = [
    PowerPressure::RING,
    PowerPressure::FLAT_PUNCH,
    PowerPressure::UNIFORM,
    PowerPressure::HERTZ,
    PowerPressure::PARABOLOID,
];

/// Wrench, Jacobian and lateral function with its gradient.
fn patch<R: Real>(hash: &mut Fnv, tier: &dyn Lateral<R>) {
    for (slide, rim) in arguments(19, ARGUMENTS / 4) {
        at(hash, tier, (slide, rim));
        let gradient = tier.lateral_jacobian(slide, rim);
        for x in [tier.lateral(slide, rim), gradient.slide, gradient.rim] {
            hash.number(x);
        }
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
            let power = compact::Power::with_pressure(alpha, pressure).expect("in range");
            patch(&mut hash, &power);
        }
        let disk = Table64::new(alpha).expect("in range");
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
            let power = compact::Power::with_pressure(alpha, pressure).expect("in range");
            patch(&mut hash, &power);
        }
        let disk = Table32::new(alpha).expect("in range");
        patch(&mut hash, &Annulus::new(disk, 0.625).expect("in range"));
    }
    hash.0
}

/// Hash of the closed forms, f64 and f32.
pub fn closed_forms() -> u64 {
    let mut hash = Fnv::new();
    patch::<f64>(&mut hash, &Ring);
    patch::<f64>(&mut hash, &FlatPunch);
    patch::<f64>(&mut hash, &Hertz);
    patch::<f32>(&mut hash, &Ring);
    patch::<f32>(&mut hash, &FlatPunch);
    patch::<f32>(&mut hash, &Hertz);
    hash.0
}

/// Hash of the wrenches of tall bodies, upright to tipping.
pub fn tall() -> u64 {
    let mut hash = Fnv::new();
    for height in [0.0, 0.04, 0.16, 0.5] {
        leaning::<f64, _, AllRound>(&mut hash, table::Coulomb, height);
        leaning::<f64, _, FrontBack>(&mut hash, Hertz, height);
        leaning::<f32, _, AllRound>(&mut hash, table::Coulomb, height);
        let power = Table64::new(0.5).expect("in range");
        leaning::<f64, _, AllRound>(&mut hash, power, height);
    }
    hash.0
}

fn leaning<R: Real, C: Lateral<R>, L: Lean>(hash: &mut Fnv, coupling: C, height: f64) {
    let [coefficient, radius] = [0.25, 0.0625].map(R::from_f64);
    let foot = PatchFriction::new(coupling, coefficient, radius).expect("in range");
    let body = TallFriction::<R, C, L>::new(foot, R::from_f64(height)).expect("in range");
    let mut rng = Lcg::new(29);
    for _ in 0..ARGUMENTS / 4 {
        let [x, y, spin] = [(); 3].map(|()| speed::<R>(&mut rng) - speed::<R>(&mut rng));
        let got = body.wrench(R::from_f64(1.7), &Twist::new(x, y, spin));
        for v in [
            got.wrench.force.x,
            got.wrench.force.y,
            got.wrench.torque,
            got.lean.x,
            got.lean.y,
        ] {
            hash.number(v);
        }
        hash.feed(u64::from(got.whole().is_ok()));
    }
}

/// Hash of whole motions: 200 steps and the rest, f64 and f32, α = 0 and 1/2.
pub fn sliders() -> u64 {
    let mut hash = Fnv::new();
    motion(&mut hash, table::Coulomb, 1.0_f64, 5.0);
    motion(&mut hash, table::Coulomb, 1.0_f32, 5.0);
    motion(&mut hash, Table64::new(0.5).expect("in range"), 1.0, -20.0);
    hash.0
}

fn motion<R, P>(hash: &mut Fnv, profile: P, speed: R, spin: R)
where
    R: Real,
    P: tribos_core::coupling::Profile<R> + Coupling<R>,
{
    let radius = R::from_f64(0.08);
    let puck = Slider::new(profile, R::from_f64(2.943), radius, R::HALF).expect("in range");
    let mut state = Motion::launched(speed, spin);
    let mut fixed = state;
    for _ in 0..200 {
        state = puck.advance(&state, R::from_f64(1.0 / 512.0)).motion;
        fixed = puck.verlet_step(&fixed, R::from_f64(1.0 / 512.0));
        for m in [state, fixed] {
            for x in [m.time, m.speed, m.spin, m.distance, m.angle] {
                hash.number(x);
            }
        }
    }
    let rest = puck.to_rest(&Motion::launched(speed, spin));
    let rest = rest.expect("an exponent below one");
    for x in [
        rest.motion.time,
        rest.motion.distance,
        rest.motion.angle,
        rest.ratio,
    ] {
        hash.number(x);
    }
    hash.feed(u64::from(rest.substeps));
}

/// All hashes with their names.
pub fn bits() -> [(&'static str, u64); 14] {
    [
        ("tables f64", tables_f64()),
        ("tables f32", tables_f32()),
        ("compact", compact()),
        ("quadrature", quadrature()),
        ("wrenches", wrenches()),
        ("sliders", sliders()),
        ("pressures f64", pressures_f64()),
        ("pressures f32", pressures_f32()),
        ("closed forms", closed_forms()),
        ("tall", tall()),
        ("nodes", nodes()),
        ("limit surfaces", limit_surfaces()),
        ("laws", laws()),
        ("contacts", contacts()),
    ]
}
