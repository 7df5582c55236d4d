//! Laws and onsets against independent numbers.

use super::*;
use crate::law::{LawError, LocalLaw};
use crate::patch::PatchError;
use crate::patch::nodes::{Node, NodeList, Nodes};
use crate::patch::polar::PolarQuadrature;
use crate::patch::polygon::polygon_into;
use crate::twist::Twist;

type Disk = NodeList<f64, 512>;

fn disk() -> Disk {
    PolarQuadrature::standard(1.0).unwrap().nodes().unwrap()
}

fn ring() -> Nodes<f64, 256> {
    let node = |i: usize| {
        let angle = core::f64::consts::TAU * (i as f64 + 0.5) / 256.0;
        let (x, y) = (Real::cos(angle), Real::sin(angle));
        Node { x, y, weight: 1.0 }
    };
    Nodes::new(core::array::from_fn(node)).unwrap()
}

/// A rectangle of these half sides, with nodes of no weight at its corners.
fn rectangle([a, b]: [f64; 2]) -> NodeList<f64, 520> {
    let mut list = NodeList::new();
    let corners = [[-a, -b], [a, -b], [a, b], [-a, b]];
    polygon_into(&mut list, &corners, 6).unwrap();
    for [x, y] in corners {
        list.push(Node { x, y, weight: 0.0 }).unwrap();
    }
    list
}

fn stool() -> Nodes<f64, 3> {
    let (x, y) = (0.75_f64.sqrt(), -0.5);
    Nodes::tripod([[0.0, 1.0], [-x, y], [x, y]], [0.0, 0.0]).unwrap()
}

/// Directions of displacement, and force along x and y with the torque at the onset, per load.
type Expected = [([f64; 3], [f64; 3]); 3];

fn check<L: BondLaw<f64> + Copy>(
    bonds: &Bonds<f64, L, impl crate::patch::nodes::NodePatch<f64>>,
    expected: &Expected,
    tolerance: f64,
) {
    for ([x, y, turn], [fx, fy, torque]) in *expected {
        for sign in [1.0, -1.0] {
            let direction = Twist::new(sign * x, sign * y, sign * turn);
            let push = bonds.onset(3.0, &direction).unwrap().push;
            let errors = [
                push.force.x - 3.0 * sign * fx,
                push.force.y - 3.0 * sign * fy,
                push.torque - 3.0 * sign * torque,
            ];
            for error in errors {
                assert!(error.abs() < 3.0 * tolerance, "{direction:?} {error:e}");
            }
        }
    }
}

const TURN: [f64; 3] = [0.0, 0.0, 1.0];
const BOTH: [f64; 3] = [1.0, 0.0, 1.0];
const OBLIQUE: [f64; 3] = [0.6, 0.8, -1.5];

// Numbers of scipy 1.x: f d exp(−d^m) of k = x0 = 1 on product Gauss–Legendre rules of 120 × 480 points (square:
// 400 × 400; a ring of 4000 points), smallest eigenvalue of the 3 × 3 Hessian brought to zero by `brentq`.

#[test]
fn a_disk_lets_go_where_its_stiffness_is_singular() {
    let broad = Bonds::new(ExponentialBond::new(1.0, 1.0).unwrap(), disk()).unwrap();
    let expected = [
        (TURN, [0.0, 0.0, 0.2354003796773]),
        (BOTH, [0.2829692706149, 0.0, 0.1108246872419]),
        (
            OBLIQUE,
            [0.1312932575543, 0.1750576767596, -0.1579789028959],
        ),
    ];
    check(&broad, &expected, 2e-6);
    let sharp = Bonds::new(WeibullBond::new(1.0, 1.0, 8.0).unwrap(), disk()).unwrap();
    let expected = [
        (TURN, [0.0, 0.0, 0.3929936975365]),
        (BOTH, [0.4308966208547, 0.0, 0.200152561504]),
        (
            OBLIQUE,
            [0.2061190166205, 0.2748253554941, -0.2511891421672],
        ),
    ];
    check(&sharp, &expected, 2e-6);
}

#[test]
fn a_ring_a_square_and_a_stool_let_go_too() {
    let law = WeibullBond::new(1.0, 1.0, 2.0).unwrap();
    let expected = [
        (TURN, [0.0, 0.0, 0.4288819424804]),
        (BOTH, [0.2515257167993, 0.0, 0.2515257167993]),
        (
            OBLIQUE,
            [0.1077066125869, 0.1436088167826, -0.3193274607783],
        ),
    ];
    check(&Bonds::new(law, ring()).unwrap(), &expected, 1e-6);
    let expected = [
        (TURN, [0.0, 0.0, 0.3033229555297]),
        (BOTH, [0.2901757408652, 0.0, 0.1684468115734]),
        (
            OBLIQUE,
            [0.1324216027519, 0.1766808549169, -0.2190204528673],
        ),
    ];
    let square = Bonds::new(law, rectangle([1.0, 1.0])).unwrap();
    check(&square, &expected, 1e-5);
    // The second row turns about a foot.
    let expected = [
        (TURN, [0.0, 0.0, 0.4288819424804]),
        (BOTH, [0.2476151049416, 0.0, 0.2476151049416]),
        (
            OBLIQUE,
            [0.1073598342023, 0.1405286000023, -0.3155283129351],
        ),
    ];
    check(&Bonds::new(law, stool()).unwrap(), &expected, 1e-12);
    // Without an axis of symmetry.
    let expected = [
        (TURN, [0.0, 0.0, 0.2051200516633]),
        (BOTH, [0.307059376227, 0.0, 0.1067957897352]),
        (
            OBLIQUE,
            [0.1624445326751, 0.1680881604804, -0.1296367385295],
        ),
    ];
    let long = rectangle([1.0, 0.5]);
    let broad = ExponentialBond::new(1.0, 1.0).unwrap();
    check(&Bonds::new(broad, long).unwrap(), &expected, 1e-5);
}

/// T_s/(F_s R)
fn ratio<L: BondLaw<f64>>(law: L) -> f64 {
    let bonds = Bonds::new(law, disk()).unwrap().with_rim(1.0).unwrap();
    let push = |x, turn| bonds.onset(1.0, &Twist::new(x, 0.0, turn)).unwrap().push;
    push(0.0, 1.0).torque / push(1.0, 0.0).force.x
}

/// The two ends are 2/3 and 1/2; exponential bonds have the maximum of 2 y⁻² (6 − (6 + 6y + 3y² + y³) e⁻ʸ) e
/// over y, 0.639885; the others are the numbers above.
#[test]
fn the_ratio_of_torque_to_force_tells_the_spread_of_strengths() {
    let scaled = |m: f64| WeibullBond::new(1.0, Real::pow(m, 1.0 / m), m).unwrap();
    for (found, expected) in [
        (ratio(PlasticBond::new(1.0, 1.0).unwrap()), 2.0 / 3.0),
        (ratio(ExponentialBond::new(1.0, 1.0).unwrap()), 0.639885),
        (ratio(scaled(2.0)), 0.623075),
        (ratio(scaled(8.0)), 0.577509),
        (ratio(BrittleBond::new(1.0, 1.0).unwrap()), 0.5),
    ] {
        assert!((found - expected).abs() < 3e-5, "{found} {expected}");
    }
    // One strength lies on the other side of a narrow distribution.
    assert!((ratio(scaled(400.0)) - 0.5).abs() < 6e-3);
}

#[test]
fn bonds_of_one_strength_have_a_straight_onset_curve() {
    let law = BrittleBond::new(4.0, 0.25).unwrap(); // F_s = N
    let round = Bonds::new(law, disk()).unwrap().with_rim(1.0).unwrap();
    for turn in [-5.0, -1.0, 0.0, 0.1, 1.0, 3.0, 1e6] {
        let onset = round.onset(1.0, &Twist::new(0.6, 0.8, turn)).unwrap();
        let (force, torque) = (onset.push.force.norm(), onset.push.torque.abs());
        assert!((force + torque / 0.5 - 1.0).abs() < 1e-13, "{turn}");
        assert_eq!(onset.release, FailureMode::Breaks);
    }
    // A square of side 2: polar moment 2/3, farthest corner √2; ring and stool hold with the full arm.
    let torque = |push: Option<SlipOnset<f64>>| push.unwrap().push.torque;
    let turn = Twist::new(0.0, 0.0, -1.0);
    let square = Bonds::new(law, rectangle([1.0, 1.0])).unwrap();
    assert!((torque(square.onset(1.0, &turn)) + 2.0 / 3.0 / 2.0_f64.sqrt()).abs() < 1e-13);
    let feet = Bonds::new(law, stool()).unwrap();
    assert!((torque(feet.onset(1.0, &turn)) + 1.0).abs() < 1e-13);
}

#[test]
fn yielding_bonds_hold_what_dry_friction_holds() {
    let bonds = Bonds::new(PlasticBond::new(2.0, 0.5).unwrap(), disk()).unwrap();
    // Coulomb's friction of the disk at equal speeds: 8/(3π) and 16/(9π).
    let onset = bonds.onset(1.0, &Twist::new(-1.0, 0.0, 1.0)).unwrap();
    let pi = core::f64::consts::PI;
    assert!((onset.push.force.x + 8.0 / (3.0 * pi)).abs() < 1e-3);
    assert!((onset.push.torque - 8.0 / (9.0 * pi)).abs() < 1e-3);
    assert_eq!(onset.release, FailureMode::Yields);
    assert_eq!(onset.displacement.velocity.x, f64::NEG_INFINITY);
    assert_eq!(onset.displacement.velocity.y, 0.0);
    // Far beyond their strain the bonds already hold almost that.
    let far = bonds.wrench(1.0, &Twist::new(-1e4, 0.0, 1e4));
    assert!((far.force.x + onset.push.force.x).abs() < 1e-4);
}

/// From de Hoog's inversion of the Laplace transform of the renewal equation, mpmath with 40 digits.
#[test]
fn re_formed_bonds_have_the_mean_age_of_a_renewal_process() {
    for (stages, strain, age) in [
        (1, 0.3, 0.2591817793182821),
        (1, 2.5, 0.9179150013761012),
        (5, 0.3, 0.2955434674638375),
        (5, 0.9, 0.5962414661013835),
        (5, 1.5, 0.599027354646721),
        (5, 2.5, 0.6000545285540431),
        (8, 0.3, 0.2991380208889105),
        (8, 0.9, 0.6013803203684376),
        (8, 1.5, 0.553050696049523),
        (8, 2.5, 0.5616359553750375),
    ] {
        let law = ReformingBond::new(7.0, 1.0, stages).unwrap();
        let error = law.friction(strain) / 7.0 - age;
        assert!(error.abs() < 1e-12, "{stages} {strain} {error:e}");
    }
}

/// The ratios are from the renewal equation on a grid of 2e-4 by trapezoids (numpy, scipy.stats.gamma).
#[test]
fn static_friction_is_up_to_twice_the_dynamic_one() {
    for (stages, peak, ratio) in [
        (5, 1.0926, 1.00578841),
        (8, 0.8378, 1.0741055),
        (16, 0.7786, 1.2246101),
        (64, 0.8216, 1.5119304),
        (256, 0.8844, 1.7131354),
    ] {
        let law = ReformingBond::new(3.0, 0.5, stages).unwrap();
        assert!((law.peak() / 0.5 - peak).abs() < 3e-4, "{stages}");
        let found = law.friction(law.peak()) / law.plateau();
        assert!((found - ratio).abs() < 1e-6, "{stages} {found}");
    }
    for stages in [1, 2, 3, 4] {
        let law = ReformingBond::new(3.0, 0.5, stages).unwrap();
        assert_eq!(law.peak(), f64::INFINITY);
        let grows = |strain: f64| law.slope(strain) > 0.0;
        assert!((1..60).all(|i| grows(0.05 * f64::from(i))), "{stages}");
    }
    let narrow = ReformingBond::new(3.0, 0.5, 1000).unwrap();
    let one = ReformingBond::one_strength(3.0, 0.5).unwrap();
    assert!(narrow.friction(narrow.peak()) / narrow.plateau() > 1.8);
    assert_eq!(one.friction(one.peak()) / one.plateau(), 2.0);
}

fn for_all_laws(check: impl Fn(usize, &dyn BondLaw<f64>)) {
    let laws: [&dyn BondLaw<f64>; 7] = [
        &ExponentialBond::new(3.0, 0.5).unwrap(),
        &WeibullBond::new(3.0, 0.5, 3.0).unwrap(),
        &BrittleBond::new(3.0, 0.5).unwrap(),
        &PlasticBond::new(3.0, 0.5).unwrap(),
        &ReformingBond::new(3.0, 0.5, 1).unwrap(),
        &ReformingBond::new(3.0, 0.5, 20).unwrap(),
        &ReformingBond::one_strength(3.0, 0.5).unwrap(),
    ];
    for (which, law) in laws.into_iter().enumerate() {
        check(which, law);
    }
}

#[test]
fn slopes_are_the_derivatives_of_forces_and_start_with_the_stiffness() {
    for_all_laws(|which, law| {
        assert_eq!(law.stiffness(), 3.0);
        assert!((law.friction(1e-9) / 3e-9 - 1.0).abs() < 1e-7, "{which}");
        assert!((law.slope(1e-9) / 3.0 - 1.0).abs() < 1e-7, "{which}");
        // No strain of these is a multiple of the strength.
        for strain in [0.05, 0.3, 0.49, 0.61, 1.1, 2.2] {
            let step = 1e-5;
            let rate = (law.friction(strain + step) - law.friction(strain - step)) / (2.0 * step);
            let error = law.slope(strain) - rate;
            assert!(error.abs() < 1e-6, "{which} {strain} {error:e}");
        }
    });
}

#[test]
fn the_peak_is_where_the_force_ceases_to_grow() {
    for_all_laws(|which, law| {
        let peak = law.peak();
        if peak.is_finite() {
            let top = law.friction(peak);
            assert!(law.friction(0.999 * peak) < top, "{which}");
            assert!(law.friction(1.001 * peak) < top, "{which}");
            assert_eq!(law.is_brittle(), law.friction(1.001 * peak) < 0.9 * top);
        }
    });
}

#[test]
fn laws_end_at_their_plateau_start_at_zero_and_keep_nan() {
    for_all_laws(|which, law| {
        assert_eq!(law.friction(0.0), 0.0, "{which}");
        for far in [1e300, f64::INFINITY] {
            assert!((law.friction(far) - law.plateau()).abs() < 1e-14, "{which}");
            assert!(!law.slope(far).is_nan() && !law.transverse_stiffness(far).is_nan());
        }
        let nan = f64::NAN;
        assert!(
            law.friction(nan).is_nan()
                && law.slope(nan).is_nan()
                && law.transverse_stiffness(nan).is_nan()
        );
    });
}

#[test]
fn the_energy_is_the_work_of_the_force() {
    let broad = ExponentialBond::new(3.0_f64, 0.5).unwrap();
    let brittle = BrittleBond::new(3.0, 0.5).unwrap();
    let plastic = PlasticBond::new(3.0, 0.5).unwrap();
    for strain in [1e-3, 0.2, 0.4, 0.7, 3.0] {
        let rate = |energy: &dyn Fn(f64) -> f64| {
            let step = 1e-6;
            (energy(strain + step) - energy(strain - step)) / (2.0 * step)
        };
        for (rate, force) in [
            (rate(&|d| broad.energy(d)), broad.friction(strain)),
            (rate(&|d| brittle.energy(d)), brittle.friction(strain)),
            (rate(&|d| plastic.energy(d)), plastic.friction(strain)),
        ] {
            assert!((rate - force).abs() < 1e-8, "{strain} {rate} {force}");
        }
    }
    assert_eq!([broad.energy(0.0), plastic.energy(0.0)], [0.0, 0.0]);
    assert_eq!(plastic.energy(f64::INFINITY), f64::INFINITY);
}

#[test]
fn the_stiffness_is_minus_the_derivative_of_the_wrench() {
    let bonds = Bonds::new(
        WeibullBond::new(3.0, 0.5, 2.0).unwrap(),
        rectangle([0.3, 0.2]),
    )
    .unwrap();
    for at in [
        [0.1, -0.2, 0.4],
        [0.0, 0.0, 0.3],
        [0.7, 0.2, -3.0],
        [0.0; 3],
    ] {
        let displaced = |i: usize, by: f64| {
            let mut parts = at;
            parts[i] += by;
            let [x, y, turn] = parts;
            bonds.wrench(2.0, &Twist::new(x, y, turn))
        };
        let [x, y, turn] = at;
        let stiffness = bonds.stiffness(2.0, &Twist::new(x, y, turn));
        assert_eq!(stiffness, stiffness.transpose());
        for i in 0..3 {
            let rate = (displaced(i, 1e-5) - displaced(i, -1e-5)) * (0.5 / 1e-5);
            for (row, rate) in [rate.force.x, rate.force.y, rate.torque].iter().enumerate() {
                let error = stiffness[(row, i)] + rate;
                assert!(error.abs() < 1e-7, "{at:?} {row} {i} {error:e}");
            }
        }
    }
}

#[test]
fn single_precision_gives_the_same_onset() {
    let law = |k: f32| {
        (
            ExponentialBond::new(k, 0.5).unwrap(),
            WeibullBond::new(k, 0.5, 8.0).unwrap(),
        )
    };
    let nodes: NodeList<f32, 512> = PolarQuadrature::standard(1.0).unwrap().nodes().unwrap();
    let (broad, sharp) = law(2.0);
    let turn = Twist::new(0.3_f32, 0.0, -1.0);
    let (x, y) = (
        Bonds::new(broad, nodes.clone())
            .unwrap()
            .onset(1.0, &turn)
            .unwrap(),
        Bonds::new(sharp, nodes).unwrap().onset(1.0, &turn).unwrap(),
    );
    let turn = Twist::new(0.3_f32 as f64, 0.0, -1.0);
    let broad = Bonds::new(ExponentialBond::new(2.0, 0.5).unwrap(), disk()).unwrap();
    let sharp = Bonds::new(WeibullBond::new(2.0, 0.5, 8.0).unwrap(), disk()).unwrap();
    for (single, double) in [(x, broad.onset(1.0, &turn)), (y, sharp.onset(1.0, &turn))] {
        let (single, double) = (single.push, double.unwrap().push);
        assert!((f64::from(single.torque) - double.torque).abs() < 1e-5);
        assert!((f64::from(single.force.x) - double.force.x).abs() < 1e-5);
    }
    let (single, double) = (
        ReformingBond::new(2.0_f32, 0.5, 64).unwrap(),
        ReformingBond::new(2.0, 0.5, 64).unwrap(),
    );
    for strain in [0.01_f32, 0.3, 0.45, 0.9, 1.01, 1.5, 7.0] {
        let exact = double.friction(f64::from(strain));
        assert!(
            (f64::from(single.friction(strain)) / exact - 1.0).abs() < 1e-5,
            "{strain}"
        );
    }
}

#[test]
fn onsets_do_not_depend_on_the_length_of_the_direction() {
    let law = ReformingBond::new(2.0, 0.5, 32).unwrap();
    let bonds = Bonds::new(law, disk()).unwrap();
    let onset = |scale: f64| {
        bonds
            .onset(1.0, &(Twist::new(0.3, -0.4, 0.6) * scale))
            .unwrap()
    };
    let one = onset(1.0);
    for scale in [1e-200, 1e-3, 1e200] {
        let other = onset(scale);
        assert!((other.push.torque - one.push.torque).abs() < 1e-12);
        assert!((other.displacement.spin / one.displacement.spin - 1.0).abs() < 1e-12);
    }
    for none in [
        Twist::ZERO,
        Twist::new(f64::NAN, 0.0, 1.0),
        Twist::new(1.0, 0.0, f64::INFINITY),
    ] {
        assert_eq!(bonds.onset(1.0, &none), None);
    }
}

/// Two feet far from the centre of rotation and four at the distance `near`, which carry all but 1e-21. What holds
/// the body to the end are those four: springs up to their peak at one displacement.
#[test]
fn a_search_that_ends_before_the_bonds_let_go_is_told_from_an_onset() {
    let turned = |near: f64| {
        let node = |x, y, weight| Node { x, y, weight };
        let inner = [[near, 0.0], [-near, 0.0], [0.0, near], [0.0, -near]];
        let [a, b, c, d] = inner.map(|[x, y]| node(x, y, 0.25));
        let feet = [a, b, c, d, node(1.0, 0.0, 1e-21), node(-1.0, 0.0, 1e-21)];
        let bonds = Bonds::new(
            ExponentialBond::new(1.0, 1.0).unwrap(),
            Nodes::new(feet).unwrap(),
        );
        let onset = bonds.unwrap().onset(1.0, &Twist::new(0.0, 0.0, 1.0));
        onset.unwrap()
    };
    let found = turned(1e-8);
    assert_eq!(found.release, FailureMode::Softens);
    assert!((found.displacement.spin * 1e-8 - 1.0).abs() < 1e-4);
    let missed = turned(1e-10);
    assert_eq!(missed.release, FailureMode::Holds);
    assert!((3e8..1e10).contains(&missed.displacement.spin));
    // Numbers that are no stiffness are not read as one.
    let far = [[1e200, 0.0], [-1e200, 0.0]].map(|[x, y]| Node { x, y, weight: 0.5 });
    let bonds = Bonds::new(
        ExponentialBond::new(1.0, 1.0).unwrap(),
        Nodes::new(far).unwrap(),
    )
    .unwrap();
    assert_eq!(bonds.onset(1.0, &Twist::new(0.0, 0.0, 1.0)), None);
}

#[test]
fn what_no_law_and_no_patch_can_be_is_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(ExponentialBond::new(bad, 1.0).is_err() && ExponentialBond::new(1.0, bad).is_err());
        assert!(BrittleBond::new(bad, 1.0).is_err() && BrittleBond::new(1.0, bad).is_err());
        assert!(PlasticBond::new(bad, 1.0).is_err() && PlasticBond::new(1.0, bad).is_err());
        assert!(
            WeibullBond::new(bad, 1.0, 1.0).is_err() && WeibullBond::new(1.0, bad, 1.0).is_err()
        );
        assert!(WeibullBond::new(1.0, 1.0, bad).is_err());
        assert!(
            ReformingBond::new(bad, 1.0, 8).is_err() && ReformingBond::new(1.0, bad, 8).is_err()
        );
        assert!(ReformingBond::one_strength(1.0, bad).is_err());
        let bonds = Bonds::new(ExponentialBond::new(1.0, 1.0).unwrap(), stool()).unwrap();
        assert!(bonds.with_rim(bad).is_err());
    }
    let none = LawError::NotPositive {
        parameter: "number of stages",
        given: 0.0,
    };
    assert_eq!(ReformingBond::new(1.0, 1.0, 0), Err(none));
    assert!(
        ReformingBond::new(1.0, 1.0, 1001).is_err() && ReformingBond::new(1.0, 1.0, 1000).is_ok()
    );
    let tip = [[0.1, 1.0], [0.1, 2.0], [0.4, 0.0]].map(|[x, weight]| Node { x, y: 0.0, weight });
    let one_place = Bonds::new(
        ExponentialBond::new(1.0, 1.0).unwrap(),
        Nodes::new(tip).unwrap(),
    );
    assert_eq!(one_place.err(), Some(PatchError::OnePlace));
}
