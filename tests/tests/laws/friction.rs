//! Friction chosen by name is the kernel's own, to the bit, and one place says what is served.

use tribos::friction::{
    AnyFriction, FrictionError, LARGEST_EXPONENT, Law, Patch, Precision, Tier, leaning, upright,
};
use tribos::random::Random;
use tribos::run::SceneRun;
use tribos::scene::DiskScene;
use tribos::slide::planar::{Gradient, Launch, PlanarSimulation, TallBody, TallCylinder};
use tribos::slide::{MotionError, SlideStopReason, SlideSummary};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable32, RoundTable64};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{
    Annulus, LateralFriction, PowerLawFriction, ReducedFriction, compact, coulomb,
};
use tribos_core::internals::LeanProfile;
use tribos_core::law::{
    DryFriction, LocalLaw, PlateauPowerLaw, PlateauPowerLawParameters, Stribeck, StribeckParameters,
};
use tribos_core::modes::TerminalMotion;
use tribos_core::patch::nodes::NodeList;
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::twist::Twist;
use tribos_tests::laws::usual;

const PLATEAU: &str = "plateau:gamma=0.1,alpha=-0.4,vp=1e-3,vd=1e-4";
const STRIBECK: &str = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05,k=0.02";
const ROUND: [&str; 8] = [
    "disk",
    "ring",
    "annulus:0.5",
    "hertz",
    "punch",
    "paraboloid",
    "power:0.25",
    "polynomial:1,-0.5",
];

/// Seeded pairs of speeds over twelve decades, at rest and without either motion.
fn speeds() -> Vec<[f64; 2]> {
    let mut pairs = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let mut random = Random::new(2026, 0);
    let mut speed = || libm::pow(10.0, 12.0 * random.unit() - 6.0);
    pairs.extend((0..60).map(|_| [speed(), speed()]));
    pairs
}

fn law(text: &str) -> Law {
    text.parse().unwrap()
}

fn patch(text: &str) -> Patch {
    text.parse().unwrap()
}

/// Wrench, Jacobian and lateral force are those of `kernel`, to the bit.
fn assert_same<R: Precision>(
    name: &str,
    room: &dyn LateralFriction<R>,
    kernel: &dyn LateralFriction<R>,
) {
    for pair in speeds() {
        let [v, w] = pair.map(R::from_f64);
        let numbers = |coupling: &dyn LateralFriction<R>| {
            let (f, j) = (
                coupling.reduced_wrench(v, w),
                coupling.reduced_jacobian(v, w),
            );
            let l = coupling.lateral_jacobian(v, w);
            let wrench = [f.force, f.torque, coupling.lateral(v, w), l.slide, l.rim];
            let jacobian = [j.force_per_slide, j.force_slide, j.mixed, j.torque_rim];
            wrench
                .into_iter()
                .chain(jacobian)
                .map(|x| x.to_f64().to_bits())
                .collect::<Vec<_>>()
        };
        assert_eq!(numbers(room), numbers(kernel), "{name} at {pair:?}");
    }
    assert_eq!(
        room.mean_square_radius(),
        kernel.mean_square_radius(),
        "{name}"
    );
}

/// The kernel's type for a power on a patch in 64 bit, written down once more.
fn kernel(name: &str, alpha: f64, tier: Tier) -> Option<Box<dyn LateralFriction<f64>>> {
    let dry = alpha == 0.0;
    let in_table = alpha <= DiskTable64::MAX_EXPONENT;
    let polynomial = PolynomialPressure::new([1.0, -0.5]).unwrap();
    let pressure = match name {
        _ if tier == Tier::Quadrature => return None,
        "polynomial:1,-0.5" if !in_table => return None,
        "polynomial:1,-0.5" => {
            return Some(Box::new(
                LateralPolynomialTable::new(alpha, &polynomial).unwrap(),
            ));
        }
        "ring" if dry => return Some(Box::new(coulomb::CoulombRing)),
        "hertz" if dry => return Some(Box::new(coulomb::CoulombHertz)),
        "punch" if dry => return Some(Box::new(coulomb::CoulombPunch)),
        "paraboloid" if dry => return Some(Box::new(coulomb::CoulombParaboloid)),
        "ring" => PowerPressure::RING,
        "hertz" => PowerPressure::HERTZ,
        "punch" => PowerPressure::FLAT_PUNCH,
        "paraboloid" => PowerPressure::PARABOLOID,
        "power:0.25" => PowerPressure::new(0.25).unwrap(),
        _ => PowerPressure::UNIFORM,
    };
    let power = || compact::CompactPower::with_pressure(alpha, pressure).unwrap();
    let disk = || DiskTable64::new(alpha).unwrap();
    Some(match name {
        "disk" if dry => Box::new(coulomb::CoulombDisk),
        "disk" if in_table => Box::new(disk()),
        "annulus:0.5" if dry => Box::new(Annulus::new(coulomb::CoulombDisk, 0.5).unwrap()),
        "annulus:0.5" if in_table => Box::new(Annulus::new(disk(), 0.5).unwrap()),
        "annulus:0.5" => Box::new(Annulus::new(power(), 0.5).unwrap()),
        _ if in_table => Box::new(RoundTable64::new(alpha, pressure).unwrap()),
        _ => Box::new(power()),
    })
}

#[test]
fn powers_of_the_speed_are_the_kernel_s_own_types_or_refused() {
    for name in ROUND {
        for alpha in [
            0.0,
            0.5,
            -0.3,
            3.0,
            10.0,
            10.0_f64.next_up(),
            20.0,
            LARGEST_EXPONENT,
        ] {
            let power = Law::power(0.3, alpha).unwrap();
            let tier = Tier::Exact;
            let made = AnyFriction::<f64>::new(&patch(name), &power, Some(tier));
            let what = format!("{name}, alpha {alpha}, {tier}");
            match (made, kernel(name, alpha, tier)) {
                (Ok(room), Some(kernel)) => {
                    assert_eq!((room.tier(), room.coefficient()), (tier, 0.3), "{what}");
                    assert_same(&what, &room, &*kernel);
                }
                (
                    Err(FrictionError::Tier {
                        tier: refused,
                        cure,
                        ..
                    }),
                    None,
                ) => {
                    assert_eq!(refused, tier, "{what}");
                    // The cure cures.
                    let cured = AnyFriction::<f64>::new(&patch(name), &power, cure);
                    assert_eq!(cured.unwrap().tier(), cure.unwrap(), "{what}");
                }
                (made, kernel) => panic!("{what}: {made:?}, kernel {}", kernel.is_some()),
            }
            // The quickest tier that serves it is chosen.
            let chosen = AnyFriction::<f64>::new(&patch(name), &power, None)
                .unwrap()
                .tier();
            let mut tiers = Tier::ALL.into_iter();
            let expected = tiers.find(|tier| kernel(name, alpha, *tier).is_some());
            assert_eq!(
                chosen,
                expected.unwrap_or(Tier::Quadrature),
                "{name}, alpha {alpha}"
            );
        }
    }
}

#[test]
fn single_precision_has_its_own_tables() {
    let half = Law::power(0.3, 0.5).unwrap();
    let disk = AnyFriction::<f32>::new(&Patch::Disk, &half, None).unwrap();
    assert_same("disk", &disk, &DiskTable32::new(0.5).unwrap());
    let hertz = AnyFriction::<f32>::new(&Patch::Hertz, &half, None).unwrap();
    assert_same(
        "hertz",
        &hertz,
        &RoundTable32::new(0.5, PowerPressure::HERTZ).unwrap(),
    );
    let polynomial = |tier| AnyFriction::<f32>::new(&patch("polynomial:1,-0.5"), &half, tier);
    assert_eq!(polynomial(None).unwrap().tier(), Tier::Quadrature);
    assert_eq!(
        polynomial(Some(Tier::Exact)).err(),
        Some(FrictionError::SinglePrecision)
    );
}

#[test]
fn other_laws_are_the_kernel_s_quadratures() {
    let dry = DryFriction::new(0.4, 0.2).unwrap();
    let stribeck = Stribeck::new(StribeckParameters {
        dry,
        speed: 0.05,
        exponent: 2.0,
        viscous: 0.02,
    })
    .unwrap();
    let plateau = PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha: -0.4,
        coefficient: 0.1,
        plateau_speed: 1e-3,
        drop_speed: 1e-4,
        rest_share: 0.5,
    })
    .unwrap();
    fn agree(text: &str, law: impl LocalLaw<f64> + Copy) {
        let spec: Law = text.parse().unwrap();
        let friction = |name: &str| AnyFriction::<f64>::new(&patch(name), &spec, None).unwrap();
        let [disk, annulus, hertz] = ["disk", "annulus:0.5", "hertz"].map(friction);
        let quadrature = DiskQuadrature::new(law);
        let band = Annulus::new(&quadrature, 0.5).unwrap();
        let rule = PolarQuadrature::new(1.0, 32, 64)
            .unwrap()
            .with_rim_exponent(0.5)
            .unwrap();
        let nodes: NodeList<f64, 2048> = rule.nodes().unwrap();
        let nodes = NodeFriction::new(law, nodes);
        for [v, w] in speeds() {
            let at = |coupling: &dyn ReducedFriction<f64>| {
                (
                    coupling.reduced_wrench(v, w),
                    coupling.reduced_jacobian(v, w),
                )
            };
            let text = format!("{text} at {v}, {w}");
            assert_eq!(
                format!("{:?}", at(&disk)),
                format!("{:?}", at(&quadrature)),
                "{text}"
            );
            assert_eq!(
                format!("{:?}", at(&annulus)),
                format!("{:?}", at(&band)),
                "{text}"
            );
            let wrench = nodes.wrench(1.0, &Twist::new(v, 0.0, w));
            let room = hertz.reduced_wrench(v, w);
            assert_eq!(
                [room.force, room.torque],
                [-wrench.force.x, -wrench.torque],
                "{text}"
            );
        }
        let refused = AnyFriction::<f64>::new(&Patch::Disk, &spec, Some(Tier::Exact));
        assert!(
            matches!(refused, Err(FrictionError::Tier { cure: None, .. })),
            "{text}"
        );
    }
    agree(STRIBECK, stribeck);
    agree(PLATEAU, plateau);
}

#[test]
fn every_local_law_serves_every_round_patch() {
    for text in usual() {
        for name in ROUND {
            let friction = AnyFriction::<f64>::new(&patch(name), &law(text), None).unwrap();
            // Sliding without spin, all of the patch has one speed.
            let slide = friction.coefficient() * friction.reduced_wrench(0.3, 0.0).force;
            let local = law(text).build::<f64>().unwrap().friction(0.3);
            assert!(
                (slide / local - 1.0).abs() < 1e-8,
                "{text} on {name}: {slide}, not {local}"
            );
        }
    }
}

#[test]
fn the_lateral_force_of_a_quadrature_is_that_of_the_table() {
    for (alpha, tolerance) in [(0.0, 2e-7), (0.5, 2e-7), (2.0, 2e-7), (-0.3, 2e-5)] {
        let power = Law::power(1.0, alpha).unwrap();
        for name in ["disk", "annulus:0.5"] {
            let by = |tier| AnyFriction::<f64>::new(&patch(name), &power, Some(tier)).unwrap();
            let (table, any) = (by(Tier::Exact), by(Tier::Quadrature));
            for ratio in [1e-3, 0.1, 0.4, 0.9, 1.0, 1.1, 3.0, 50.0] {
                let [exact, near] = [&table, &any].map(|c| c.lateral(ratio, 1.0));
                let error = (near / exact - 1.0).abs();
                assert!(
                    error < tolerance,
                    "{name}, {alpha}, {ratio}: {near}, not {exact}"
                );
                let [exact, near] = [&table, &any].map(|c| c.lateral_jacobian(ratio, 1.0));
                let size = exact.slide.abs() + exact.rim.abs();
                let error = (near.slide - exact.slide).abs() + (near.rim - exact.rim).abs();
                assert!(
                    error < 1e-4 * size,
                    "{name}, {alpha}, {ratio}: {near:?}, not {exact:?}"
                );
            }
        }
        // Nodes are coarse, and coarser where friction falls with the speed.
        let by = |tier| AnyFriction::<f64>::new(&Patch::Hertz, &power, Some(tier)).unwrap();
        let [exact, near] = [Tier::Exact, Tier::Quadrature].map(|tier| by(tier).lateral(0.4, 1.0));
        assert!(
            (near / exact - 1.0).abs() < 2e-2,
            "hertz, {alpha}: {near}, not {exact}"
        );
    }
}

#[test]
fn final_motion_takes_closed_forms_then_tables_then_series() {
    let growth = |profile: &dyn PowerLawFriction<f64>| {
        TerminalMotion::new(profile, 0.7)
            .unwrap()
            .growth(0.8)
            .to_bits()
    };
    let same = |name: &str, alpha: f64, kernel: &dyn PowerLawFriction<f64>| {
        let room = upright(&patch(name), alpha).unwrap();
        assert_eq!(growth(&&*room), growth(kernel), "{name}, {alpha}");
    };
    same("disk", 0.0, &coulomb::CoulombDisk);
    same("ring", 0.0, &coulomb::CoulombRing);
    same(
        "ring",
        0.5,
        &RoundTable64::new(0.5, PowerPressure::RING).unwrap(),
    );
    same(
        "annulus:0.5",
        0.0,
        &Annulus::new(coulomb::CoulombDisk, 0.5).unwrap(),
    );
    same("disk", 20.0, &compact::CompactPower::new(20.0).unwrap());
    let leant = LeanProfile::new(coulomb::CoulombHertz, 0.6).unwrap();
    assert_eq!(
        growth(&&*leaning(&Patch::Hertz, 0.6).unwrap()),
        growth(&leant)
    );
    assert_eq!(
        upright(&patch("points:a.csv"), 0.0).err(),
        Some(FrictionError::NoAxis)
    );
    assert!(upright(&patch("polynomial:1"), 20.0).is_err());
    assert_eq!(
        upright(&Patch::Disk, 200.0).err(),
        Some(FrictionError::Exponent { given: 200.0 })
    );
}

fn scene(more: &[&str]) -> DiskScene {
    let text = "speed = 1.0\nspin = 5.0\ngamma = 0.3\nalpha = 0\ngravity = 9.81\nradius = 0.08\n\
                mass = 0.1\ninertia_ratio = 0.5";
    let more: Vec<String> = more.iter().map(|item| (*item).into()).collect();
    DiskScene::parse("disk.toml", text, &more).unwrap()
}

fn run_under(disk: &DiskScene, law: Law) -> Result<SceneRun<SlideSummary, 8>, MotionError> {
    let law = Some(law);
    DiskScene { law, ..*disk }.run()
}

#[test]
fn every_local_law_brings_a_disk_to_rest() {
    for text in usual() {
        let end = run_under(&scene(&[]), law(text)).unwrap().outcome;
        assert_eq!(end.ending, SlideStopReason::Rest, "{text}");
        assert!(end.energy_error < 1e-7, "{text}: {}", end.energy_error);
        // Friction lies between its extremes at speeds up to that of the rim.
        let made = law(text).build::<f64>().unwrap();
        let friction = (0..200).map(|k| made.friction(1.5 * libm::pow(10.0, -0.04 * f64::from(k))));
        let [least, most] =
            friction.fold([f64::INFINITY, 0.0_f64], |[a, b], x| [a.min(x), b.max(x)]);
        let slide = |mu: f64| 1.0 / (2.0 * mu * 9.81);
        assert!(end.distance > slide(most), "{text}: {}", end.distance);
        // Spinning takes friction away from sliding, but never half of it here.
        assert!(
            end.distance < 2.0 * slide(least),
            "{text}: {}",
            end.distance
        );
    }
}

#[test]
fn a_law_that_is_coulomb_s_in_disguise_moves_as_coulomb_s() {
    let coulomb = scene(&[]).run().unwrap();
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-7;
    for text in [
        "dry:mu_s=0.4,mu_d=0.3",
        "stribeck:mu_s=0.3,mu_d=0.3,vs=0.05",
    ] {
        let other = run_under(&scene(&[]), law(text)).unwrap();
        let [a, b] = [&coulomb.outcome, &other.outcome];
        assert!(
            close(a.end_time, b.end_time) && close(a.distance, b.distance),
            "{a:?} {b:?}"
        );
        assert!(
            close(a.angle, b.angle) && close(a.final_ratio, b.final_ratio),
            "{a:?} {b:?}"
        );
        assert_eq!(coulomb.rows.len(), other.rows.len());
        for (a, b) in coulomb.rows.iter().zip(&other.rows).skip(1) {
            assert!((a[3] - b[3]).abs() < 1e-7, "{a:?} {b:?}");
        }
    }
    // A tall body leans and bends its path as under Coulomb's law.
    let launch = Launch {
        velocity: [1.0, 0.0],
        spin: 5.0,
    };
    let cylinder = TallCylinder {
        height: 0.16,
        ..TallCylinder::solid(0.2, 0.08)
    };
    let exact = PlanarSimulation::new(&cylinder.body(9.81).unwrap(), &launch, 1e-4)
        .unwrap()
        .to_end()
        .unwrap();
    let foot = AnyFriction::new(&Patch::Disk, &law("dry:mu_s=0.2,mu_d=0.2"), None).unwrap();
    let foot = foot.with_radius(0.08).unwrap();
    let body = TallBody::new(foot, 0.08, Gradient::AllRound, [9.81, 0.5]).unwrap();
    let near = PlanarSimulation::new(&body, &launch, 1e-4)
        .unwrap()
        .to_end()
        .unwrap();
    for axis in [0, 1] {
        let [a, b] = [&exact, &near].map(|end| end.point.position[axis]);
        assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    }
}

#[test]
fn a_stribeck_disk_without_spin_takes_the_time_of_the_integral() {
    let text = STRIBECK;
    let made = law(text).build::<f64>().unwrap();
    // t = ∫ dv/(g mu(v)) and x = ∫ v dv/(g mu(v)) from 0 to 1 m/s, by the midpoint rule.
    const PARTS: u32 = 1_000_000;
    let [mut time, mut way] = [0.0; 2];
    for k in 0..PARTS {
        let v = (f64::from(k) + 0.5) / f64::from(PARTS);
        let pace = 1.0 / (9.81 * made.friction(v) * f64::from(PARTS));
        time += pace;
        way += v * pace;
    }
    let end = run_under(&scene(&["spin=0"]), law(text)).unwrap().outcome;
    assert!(
        (end.end_time / time - 1.0).abs() < 1e-8,
        "{} {time}",
        end.end_time
    );
    assert!(
        (end.distance / way - 1.0).abs() < 1e-8,
        "{} {way}",
        end.distance
    );
    // With spin both motions end together, in the ratio of Coulomb friction: near rest mu is mu_s.
    let end = run_under(&scene(&[]), law(text)).unwrap().outcome;
    let coulomb = scene(&[]).run().unwrap().outcome;
    assert!(
        (end.final_ratio - coulomb.final_ratio).abs() < 1e-6,
        "{} {}",
        end.final_ratio,
        coulomb.final_ratio
    );
    // A duration cuts the motion; the thesis' method is for powers alone.
    let cut = run_under(&scene(&["duration=0.1"]), law(text)).unwrap();
    assert_eq!(cut.outcome.ending, SlideStopReason::Duration);
    assert!(
        (cut.outcome.end_time - 0.1).abs() < 1e-15,
        "{}",
        cut.outcome.end_time
    );
    assert!(run_under(&scene(&["integrator=verlet"]), law(text)).is_err());
}
