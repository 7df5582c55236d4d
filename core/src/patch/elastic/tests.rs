//! Radii of elastic contacts against published tables, integrals and the equations that they solve.

extern crate std;

use super::*;
use crate::coupling::coulomb::{CoulombDisk, CoulombHertz};
use crate::coupling::round::RoundTable64;
use crate::coupling::{LoadedFriction, ReducedFriction};
use crate::patch::{PatchError, PowerPressure};
use crate::twist::{Twist, Wrench};

/// Largest error in units of rounding.
fn ulps<R: Real>(got: R, wanted: f64) -> f64 {
    ((got.to_f64() - wanted) / wanted).abs() / R::EPSILON.to_f64()
}

/// 1 + x of evenly spread loads over twelve decades.
fn loads() -> impl Iterator<Item = f64> {
    (0..240).map(|i| libm::pow(10.0, -6.0 + 0.05 * f64::from(i)))
}

#[test]
fn spheres_have_the_radius_of_hertz() {
    for load in loads() {
        for [modulus, radius] in [[2.1e11, 0.005], [1e4, 0.3], [7e10, 1e-7]] {
            // Sphere on plane: N = 4 E* a³/(3 R) (Johnson 1985, eq. 4.24).
            let ball = HertzSphere::new(modulus, radius).unwrap();
            let a = ball.radius(load);
            assert!(ulps(4.0 * modulus / (3.0 * radius) * a * a * a, load) < 12.0);
            assert!(ulps(ball.slope(load), a / (3.0 * load)) < 4.0);
            let single = HertzSphere::new(modulus as f32, radius as f32).unwrap();
            assert!(ulps(single.radius(load as f32), a) < 4.0);
        }
    }
    // A steel ball of 10 mm on steel under 1 N: a = (3 × 5 mm × 1 N/(4 × 113.187 GPa))^⅓ = 32.118 µm.
    let steel = Elasticity {
        young: 206e9,
        poisson: 0.3,
    };
    let ball = HertzSphere::new(effective_modulus(steel, steel).unwrap(), 5e-3).unwrap();
    assert!(
        (ball.radius(1.0) - 32.118e-6).abs() < 1e-9,
        "{}",
        ball.radius(1.0)
    );
}

/// Semi-axes a = m (3N/(4 E* (A + B)))^⅓, b = n of the same, by the angle arccos((B − A)/(A + B)): Whittemore and
/// Petrenko 1921, as in Timoshenko and Goodier, Theory of Elasticity (1951), p. 379.
const PUBLISHED: [[f64; 3]; 10] = [
    [90.0, 1.0, 1.0],
    [80.0, 1.128, 0.893],
    [70.0, 1.284, 0.802],
    [65.0, 1.378, 0.759],
    [60.0, 1.486, 0.717],
    [55.0, 1.611, 0.678],
    [50.0, 1.754, 0.641],
    [45.0, 1.926, 0.604],
    [40.0, 2.136, 0.567],
    [30.0, 2.731, 0.493],
];

#[test]
fn ellipses_have_the_published_axes() {
    for [angle, m, n] in PUBLISHED {
        let difference = libm::cos(angle * core::f64::consts::PI / 180.0);
        // A + B = 1 and 3N/(4 E*) = 1.
        let curvatures = [1.0 - difference, 1.0 + difference];
        let patch = HertzEllipse::new(0.75, curvatures).unwrap();
        let [a, b] = patch.semi_axes(1.0);
        // Three digits, of which the last is uncertain: the integrals below agree with the axes at 70° that it misses.
        assert!(
            (a / m - 1.0).abs() < 3e-3 && (b / n - 1.0).abs() < 3e-3,
            "{angle} {a} {b}"
        );
        // The other way round they change places.
        let [y, x] = HertzEllipse::new(0.75, [curvatures[1], curvatures[0]])
            .unwrap()
            .semi_axes(1.0);
        assert_eq!([x, y], [a, b]);
    }
}

/// ∫sin²φ/Δ and ∫cos²φ/Δ over a quarter turn, Δ² = cos²φ + κ² sin²φ, by the midpoint rule, which converges faster
/// than any power for periodic functions.
fn integrals(ratio: f64) -> [f64; 2] {
    let count = 20_000;
    let (mut sums, mut lost) = ([0.0_f64; 2], [0.0_f64; 2]);
    for i in 0..count {
        let angle = (f64::from(i) + 0.5) / f64::from(count) * core::f64::consts::FRAC_PI_2;
        let (s, c) = (libm::sin(angle), libm::cos(angle));
        let delta = (c * c + ratio * ratio * s * s).sqrt();
        for (k, square) in [s * s, c * c].into_iter().enumerate() {
            // With what rounding lost of the sums before (Kahan).
            let term = square / delta - lost[k];
            let sum = sums[k] + term;
            lost[k] = (sum - sums[k]) - term;
            sums[k] = sum;
        }
    }
    sums.map(|sum| sum * core::f64::consts::FRAC_PI_2 / f64::from(count))
}

#[test]
fn ellipses_solve_the_conditions_of_hertz() {
    let mut worst = [0.0_f64; 2];
    for i in 0..=300 {
        // Axes down to a thousandth, which the rule above resolves.
        let ratio = libm::pow(10.0, -f64::from(i) / 100.0);
        let [d, b] = integrals(ratio);
        let patch = HertzEllipse::new(1.0, [ratio * ratio * d / b, 1.0]).unwrap();
        worst[0] = worst[0].max(ulps(patch.axes_ratio(), ratio));
        // a³ = 3 N D/(2π E* A), b³ = 3 N κ B/(2π E* B).
        let [long, short] = patch.semi_axes(2.0);
        let cube = 3.0 * 2.0 / core::f64::consts::PI;
        worst[1] = worst[1].max(ulps(short * short * short, cube * ratio * b));
        worst[1] = worst[1].max(ulps(long * long * long, cube * b / (ratio * ratio)));
        let single = HertzEllipse::new(1.0, [(ratio * ratio * d / b) as f32, 1.0_f32]).unwrap();
        assert!(ulps(single.axes_ratio(), ratio) < 16.0, "{ratio}");
    }
    // Half of it is the rounding of the rule's terms.
    assert!(worst[0] < 40.0 && worst[1] < 64.0, "{worst:?}");
}

/// A/B, κ, and both semi-axes for N = E* = 2B = 1: mpmath with 40 digits, findroot on κ² D/B in log κ.
#[allow(clippy::excessive_precision, reason = "all digits of the table")]
const EXACT: [[f64; 4]; 12] = [
    [1.0, 1.0, 0.908_560_296_416_069_83, 0.908_560_296_416_069_83],
    [
        0.9375,
        0.957_887_585_096_441_59,
        0.938_302_373_657_356_76,
        0.898_788_194_792_904_46,
    ],
    [
        0.75,
        0.825_542_265_933_929_85,
        1.047_874_230_917_663_5,
        0.865_064_467_005_541_97,
    ],
    [
        0.5,
        0.630_595_701_428_099_7,
        1.275_820_798_198_390_1,
        0.804_527_111_136_471_88,
    ],
    [
        0.25,
        0.399_887_015_134_587_95,
        1.764_828_586_099_864_6,
        0.705_732_035_519_669_99,
    ],
    [
        0.0625,
        0.165_653_048_735_380_07,
        3.238_611_360_120_247_7,
        0.536_485_845_472_954_92,
    ],
    [
        0.007_812_5,
        0.047_600_790_439_060_902,
        7.489_133_068_350_932_5,
        0.356_488_653_756_813_91,
    ],
    [
        0.000_976_562_5,
        0.014_538_960_916_656_823,
        16.528_693_420_190_379,
        0.240_310_027_639_550_7,
    ],
    [
        9.536_743_164_062_5e-7,
        3.373_330_514_550_925_4e-4,
        203.212_833_982_356_92,
        0.068_550_405_382_105_585,
    ],
    [
        1.164_153_218_269_348_1e-10,
        2.979_924_542_879_002_5e-6,
        4_755.398_859_347_695_1,
        0.014_170_729_772_149_01,
    ],
    [
        8.881_784_197_001_252_3e-16,
        6.802_795_688_013_143_2e-9,
        274_282.969_184_312_2,
        1.865_891_000_062_480_9e-3,
    ],
    [
        1.355_252_715_606_880_5e-20,
        2.334_528_283_161_027e-11,
        12_055_661.189_034_127,
        2.814_428_201_800_686_9e-4,
    ],
];

#[test]
fn ellipses_have_the_axes_of_many_digits() {
    for [wanted, ratio, long, short] in EXACT {
        let patch = HertzEllipse::new(1.0, [wanted, 1.0]).unwrap();
        let [a, b] = patch.semi_axes(1.0);
        let single = HertzEllipse::new(1.0_f32, [wanted as f32, 1.0]).unwrap();
        let [c, d] = single.semi_axes(1.0);
        let most = if ratio > 1e-2 { 4.0 } else { 16.0 };
        let off = [
            ulps(patch.axes_ratio(), ratio),
            ulps(a, long),
            ulps(b, short),
            ulps(single.axes_ratio(), ratio),
            ulps(c, long),
            ulps(d, short),
        ];
        assert!(off.iter().all(|off| *off < most), "{ratio} {off:?}");
    }
}

#[test]
fn every_ratio_of_curvatures_is_solved_and_the_axes_fall_with_it() {
    fn check<R: Real>() {
        let mut last = R::INFINITY;
        for i in 0..=4000 {
            let wanted = R::from_f64(libm::pow(10.0, -0.005 * f64::from(i)) * (1.0 + 1e-15));
            let wanted = if i == 4000 {
                R::from_f64(1e-20 * 1.000_001)
            } else {
                wanted
            };
            let wanted = if wanted > R::ONE { R::ONE } else { wanted };
            let patch = HertzEllipse::new(R::ONE, [wanted, R::ONE]).unwrap();
            assert!(
                patch.axes_ratio() < last && patch.axes_ratio() > R::ZERO,
                "{wanted:?}"
            );
            last = patch.axes_ratio();
        }
    }
    check::<f64>();
    check::<f32>();
    let line = HertzEllipse::new(1.0, [1e-21, 1.0]).unwrap_err();
    let least = HertzEllipse::<f64>::LEAST_RATIO;
    assert_eq!(
        line,
        PatchError::CurvatureRatio {
            given: 1e-21,
            least
        }
        .into()
    );
    for curvatures in [
        [0.0, 1.0],
        [1.0, -1.0],
        [f64::NAN, 1.0],
        [1.0, f64::INFINITY],
    ] {
        assert!(HertzEllipse::new(1.0, curvatures).is_err());
    }
}

#[test]
fn a_circle_is_a_sphere() {
    let (ball, patch) = (
        HertzSphere::new(3e6, 0.02).unwrap(),
        HertzEllipse::new(3e6, [50.0; 2]).unwrap(),
    );
    for load in loads() {
        for (axis, slope) in patch.semi_axes(load).into_iter().zip(patch.slopes(load)) {
            assert!(ulps(axis, ball.radius(load)) < 8.0 && ulps(slope, ball.slope(load)) < 8.0);
        }
    }
    assert_eq!(patch.semi_axes(-1.0), [0.0; 2]);
    assert_eq!(patch.slopes(0.0), [f64::INFINITY; 2]);
}

/// The gap of two faces is half of Σκ over their sections, in every direction of the plane.
#[test]
fn relative_curvatures_are_those_of_the_gap() {
    for i in 0..200 {
        let part = |k: f64| 2.0 * (f64::from(i) * k).fract() - 0.7;
        let first = [part(0.754_877_666_25), part(0.569_840_290_99)];
        let second = [part(0.819_172_513_4), part(0.671_043_606_7)];
        let angle = 3.0 * part(0.445_041_867_9);
        let [small, large] = relative_curvatures(first, second, angle);
        let along = |[a, b]: [f64; 2], turn: f64| {
            let (s, c) = (libm::sin(turn), libm::cos(turn));
            a * c * c + b * s * s
        };
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for k in 0..3600 {
            let turn = f64::from(k) * core::f64::consts::PI / 3600.0;
            let whole = along(first, turn) + along(second, turn - angle);
            (least, most) = (least.min(whole), most.max(whole));
        }
        assert!(
            (least - small).abs() < 1e-5 && (most - large).abs() < 1e-5,
            "{i}"
        );
    }
}

#[test]
fn spheres_that_stick_solve_the_equation_of_johnson_kendall_and_roberts() {
    let pi = core::f64::consts::PI;
    for [modulus, radius, work] in [[1e4, 0.01, 0.05], [7e10, 1e-6, 0.1], [2e6, 5e-3, 0.04]] {
        let ball = AdhesiveSphere::new(modulus, radius, work).unwrap();
        assert!(ulps(-ball.pull_off(), 1.5 * pi * work * radius) < 4.0);
        let last = libm::cbrt(9.0 * pi * work * radius * radius / (8.0 * modulus));
        assert!(ulps(ball.radius(ball.pull_off()), last) < 8.0);
        // N = 4 E* a³/(3 R) − √(8π w E* a³) on the branch that holds.
        for i in 1..200 {
            let a = last * libm::pow(1.05, f64::from(i));
            let cube = a * a * a;
            let load =
                4.0 * modulus * cube / (3.0 * radius) - (8.0 * pi * work * modulus * cube).sqrt();
            // The load is a difference, whose rounding the radius shows.
            let near = (1.0 + 2.0 * load / (3.0 * pi * work * radius)).sqrt();
            assert!(
                ulps(ball.radius(load), a) < 8.0 * (1.0 + 1.0 / near),
                "{i} {a} {load}"
            );
            let rate =
                4.0 * modulus * a * a / radius - 1.5 * (8.0 * pi * work * modulus * a).sqrt();
            let slope = ball.slope(load) * rate;
            assert!(
                (slope - 1.0).abs() < 1e-13 * (1.0 + 1.0 / (near * near)),
                "{i} {slope}"
            );
            let growth = ball.growth(load) * a / load;
            assert!((growth / ball.slope(load) - 1.0).abs() < 1e-13);
            let single = AdhesiveSphere::new(modulus as f32, radius as f32, work as f32).unwrap();
            let off = ulps(
                single.radius(load as f32),
                ball.radius(f64::from(load as f32)),
            );
            assert!(off < 16.0 * (1.0 + 1.0 / (near * near)), "{i} {off}");
        }
        assert_eq!(ball.radius(1.000_001 * ball.pull_off()), 0.0);
        assert_eq!(ball.slope(ball.pull_off()), f64::INFINITY);
        // Without adhesion to speak of it is Hertz'.
        let dry = AdhesiveSphere::new(modulus, radius, 1e-30).unwrap();
        let hertz = HertzSphere::new(modulus, radius).unwrap();
        assert!((dry.radius(1.0) / hertz.radius(1.0) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn loads_that_are_none_and_numbers_that_are_none_have_documented_answers() {
    fn check(of: &impl LoadedRadius<f64>, beyond: f64) {
        let all = |load: f64| [of.radius(load), of.slope(load), of.growth(load)];
        assert_eq!(all(beyond), [0.0; 3]);
        assert!(all(f64::INFINITY)[1] == 0.0 && !all(f64::INFINITY)[2].is_nan());
        assert!(
            all(f64::NAN).iter().all(|x| x.is_nan()),
            "{:?}",
            all(f64::NAN)
        );
    }
    check(&HertzSphere::new(1e6, 0.01).unwrap(), -1.0);
    check(&SoftFinger::new(1e-3, 0.2).unwrap(), -1.0);
    check(&SoftFinger::new(1e-3, 0.0).unwrap(), -1.0);
    let gel = AdhesiveSphere::new(1e4, 0.01, 0.05).unwrap();
    check(&gel, -1.0);
    assert!(gel.slope(0.0) > 0.0 && gel.growth(0.0) == 0.0);
    let stiff = SoftFinger::new(1e-3, 0.0).unwrap();
    assert_eq!([stiff.radius(0.0), stiff.slope(0.0)], [1e-3, 0.0]);
    assert!(
        SoftFinger::new(1e-3, 1.0 / 3.0).is_ok() && SoftFinger::new(1e-3_f32, 1.0 / 3.0).is_ok()
    );
    assert!(SoftFinger::new(1e-3, -0.1).is_err() && SoftFinger::new(0.0, 0.1).is_err());
    let rubber = |poisson| Elasticity {
        young: 1e6,
        poisson,
    };
    assert!(effective_modulus(rubber(0.5), rubber(0.6)).is_err());
    let rigid = Elasticity {
        young: f64::INFINITY,
        poisson: 0.3,
    };
    assert!(
        effective_modulus(rigid, rigid).is_err() && effective_modulus(rigid, rubber(0.5)).is_ok()
    );
}

/// The slope by the load against a difference of sixth order, relative to the largest part of the wrench.
fn slope_error<C: ReducedFriction<f64>, A: LoadedRadius<f64>>(
    friction: &LoadedFriction<f64, C, A>,
    load: f64,
    twist: &Twist<f64>,
) -> f64 {
    let h = 1e-3 * load.abs();
    let difference = |step: f64| {
        let [less, more] = [load - step, load + step].map(|load| friction.wrench(load, twist));
        (more - less) * (0.5 / step)
    };
    let [one, two, three] = [h, 2.0 * h, 3.0 * h].map(difference);
    let by_difference = one * 1.5 - two * 0.6 + three * 0.1;
    let (slope, radius) = (
        friction.slope_by_load(load, twist),
        friction.area().radius(load),
    );
    let size = |wrench: &Wrench<f64>| wrench.force.norm().hypot(wrench.torque / radius);
    size(&(slope - by_difference)) / size(&slope)
}

#[test]
fn the_slope_by_load_is_that_of_differences() {
    fn worst<C: ReducedFriction<f64> + Copy>(coupling: C) -> f64 {
        let ball =
            LoadedFriction::new(coupling, 0.8, HertzSphere::new(1e6, 0.01).unwrap()).unwrap();
        let gel = AdhesiveSphere::new(1e5, 0.01, 0.05).unwrap();
        let sticky = LoadedFriction::new(coupling, 0.8, gel).unwrap();
        let finger =
            LoadedFriction::new(coupling, 0.8, SoftFinger::new(3e-3, 0.2).unwrap()).unwrap();
        let mut worst = 0.0_f64;
        for i in 0..300 {
            let part = |k: f64| 2.0 * (f64::from(i) * k).fract() - 1.0;
            // Sliding and spinning in all ratios but next to equal speeds, where higher derivatives grow.
            let ratio = libm::exp(3.0 * part(0.754_877_666_25));
            let load = libm::exp(3.0 * part(0.569_840_290_99));
            for (which, area) in [
                (0, ball.area().radius(load)),
                (1, gel.radius(load)),
                (2, finger.area().radius(load)),
            ] {
                if (ratio - 1.0).abs() < 0.2 {
                    continue;
                }
                let angle = 3.0 * part(0.819_172_513_4);
                let twist = Twist::new(
                    ratio * libm::cos(angle),
                    ratio * libm::sin(angle),
                    part(0.618_034).signum() / area,
                );
                let error = match which {
                    0 => slope_error(&ball, load, &twist),
                    1 => slope_error(&sticky, load, &twist),
                    _ => slope_error(&finger, load, &twist),
                };
                worst = worst.max(error);
            }
        }
        worst
    }
    let table = RoundTable64::new(0.4, PowerPressure::HERTZ).unwrap();
    let all = [worst(CoulombDisk), worst(CoulombHertz), worst(table)];
    std::println!("{all:?}");
    assert!(all.iter().all(|worst| *worst < 1e-9), "{all:?}");
}

#[test]
fn friction_under_a_load_is_that_of_its_radius() {
    let friction =
        LoadedFriction::new(CoulombDisk, 0.8, HertzSphere::new(1e6, 0.01).unwrap()).unwrap();
    let twist = Twist::new(0.3, -0.1, 200.0);
    let (own, fixed) = (
        friction.wrench(2.0, &twist),
        friction.at(2.0).unwrap().wrench(2.0, &twist),
    );
    assert!((own.force - fixed.force).norm() < 1e-15 && (own.torque - fixed.torque).abs() < 1e-18);
    assert!(friction.at(0.0).is_err());
    // At rest, without load and without contact there is none; at the first touch a patch begins as a point.
    for (load, twist) in [(2.0, Twist::ZERO), (-1.0, Twist::new(0.0, 0.0, 1.0))] {
        assert_eq!(friction.wrench(load, &twist).torque, 0.0);
    }
    assert_eq!(friction.slope_by_load(2.0, &Twist::ZERO), Wrench::ZERO);
    let touch = friction.slope_by_load(0.0, &Twist::new(0.3, 0.0, 200.0));
    assert!((touch.force.x + 0.8).abs() < 1e-15 && touch.torque == 0.0);
    // Spinning alone, μ c a (1 + ⅓) with c = ⅔.
    let spun = friction
        .slope_by_load(2.0, &Twist::new(0.0, 0.0, -3.0))
        .torque;
    assert!(
        ulps(
            spun,
            0.8 * 2.0 / 3.0 * friction.area().radius(2.0) * 4.0 / 3.0
        ) < 8.0
    );
    let nan = friction.slope_by_load(f64::NAN, &twist);
    assert!(nan.force.x.is_nan() && nan.torque.is_nan());
}
