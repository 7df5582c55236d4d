//! Exact dry friction of polygons: against line integrals of 150 digits, and its invariants.

use nalgebra::{SymmetricEigen, Vector3};
use tribos_core::Real;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::CoulombLaw;
use tribos_core::patch::nodes::NodeList;
use tribos_core::patch::outline::{OutlineError, Polygon};
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};
use tribos_tests::outlines::{Outline, outlines};
use tribos_tests::reference::Reference;
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const COMPONENTS: [&str; 3] = ["force_x", "force_y", "torque"];
const HESSIAN: [[&str; 3]; 3] = [["xx", "xy", "xn"], ["xy", "yy", "yn"], ["xn", "yn", "nn"]];

/// Errors of one row: of μN and μN (R + |centre|), and of the largest entry of the Jacobian with
/// R + |centre| as the unit of length.
pub(crate) struct Errors {
    pub(crate) wrench: f64,
    pub(crate) jacobian: f64,
}

pub(crate) fn errors<R: Real>(
    row: &Row<'_>,
    patch: &impl PatchShape<R>,
    (wrench, jacobian): (Wrench<R>, WrenchJacobian<R>),
) -> Errors {
    let centre = patch.centre();
    let arm = patch.radius().to_f64() + centre.x.to_f64().hypot(centre.y.to_f64());
    let scale = [1.0, 1.0, arm];
    let mut of_wrench: f64 = 0.0;
    let parts = [wrench.force.x, wrench.force.y, wrench.torque];
    for ((name, part), scale) in COMPONENTS.iter().zip(parts).zip(scale) {
        of_wrench = of_wrench.max(row.reference(name).distance(part.to_f64()) / scale);
    }
    let (mut of_jacobian, mut largest): (f64, f64) = (0.0, 0.0);
    for (i, names) in HESSIAN.iter().enumerate() {
        for (j, name) in names.iter().enumerate() {
            let Reference { high, low } = row.reference(name);
            let expected = Reference {
                high: -high,
                low: -low,
            };
            let unit = scale[i] * scale[j];
            let error = expected.distance(jacobian[(i, j)].to_f64());
            of_jacobian = of_jacobian.max(error / unit);
            largest = largest.max(high.abs() / unit);
        }
    }
    Errors {
        wrench: of_wrench,
        jacobian: of_jacobian / largest,
    }
}

pub(crate) fn twist_of<R: Real>(row: &Row<'_>) -> Twist<R> {
    let [x, y, spin] =
        ["velocity_x", "velocity_y", "spin"].map(|name| R::from_f64(row.number(name)));
    Twist::new(x, y, spin)
}

fn found<R: Real>(outline: &Outline, row: &Row<'_>) -> Errors {
    let twist = twist_of(row);
    let slope = ["slope_x", "slope_y"].map(|name| R::from_f64(row.number(name)));
    let (patch, one) = (outline.patch::<R>(), R::ONE);
    if slope == [R::ZERO; 2] {
        let friction = ShapeFriction::new(&patch, one).expect("valid");
        return errors(row, &patch, friction.wrench_and_jacobian(one, &twist));
    }
    let patch = patch.with_slope(slope).expect("carried");
    let friction = ShapeFriction::new(&patch, one).expect("valid");
    errors(row, &patch, friction.wrench_and_jacobian(one, &twist))
}

#[test]
fn the_wrench_and_the_jacobian_are_those_of_150_digits() {
    let table = Table::read("polygons.csv");
    let outlines = outlines();
    let mut worst = [
        ("uniform, wrench", tolerance::POLYGON),
        ("uniform, Jacobian", tolerance::POLYGON_JACOBIAN),
        ("linear, wrench", tolerance::POLYGON_LINEAR),
        ("linear, Jacobian", tolerance::POLYGON_LINEAR_JACOBIAN),
        ("sliver, wrench", tolerance::SLIVER),
        ("sliver, Jacobian", tolerance::SLIVER_JACOBIAN),
    ]
    .map(|(name, bound)| (Worst::of(name), bound));
    for (number, row) in table.rows().enumerate() {
        let name = row.text("shape");
        let outline = outlines.iter().find(|one| one.name == name).expect(name);
        let first = if name == "sliver" {
            4
        } else if row.number("slope_x") == 0.0 && row.number("slope_y") == 0.0 {
            0
        } else {
            2
        };
        let Errors { wrench, jacobian } = found::<f64>(outline, &row);
        let place = || format!("{name}, row {number}, {:?}", twist_of::<f64>(&row));
        worst[first].0.see(wrench, place);
        worst[first + 1].0.see(jacobian, place);
    }
    for (worst, bound) in &worst {
        worst.assert_within(bound);
    }
}

/// A twist whose centre of rotation is anywhere from the patch to 10⁶ radii away, at any speed.
pub(crate) fn anyhow(rng: &mut Lcg, patch: &impl PatchShape<f64>) -> Twist<f64> {
    let speed = 10_f64.powf(rng.between(-6.0, 6.0));
    let turn = speed / patch.radius() * 10_f64.powf(rng.between(-6.0, 1.0));
    let angle = rng.between(0.0, core::f64::consts::TAU);
    let sense = if rng.between(-1.0, 1.0) < 0.0 {
        -1.0
    } else {
        1.0
    };
    Twist::new(speed * angle.cos(), speed * angle.sin(), sense * turn)
}

/// The twist or wrench with its normal component in units of `length` on the other side.
pub(crate) fn of_twist(twist: &Twist<f64>, arm: f64) -> Vector3<f64> {
    Vector3::new(twist.velocity.x, twist.velocity.y, twist.spin * arm)
}

#[test]
fn the_jacobian_is_symmetric_without_power_along_the_twist_and_takes_power_elsewhere() {
    let mut rng = Lcg::new(1);
    for outline in outlines() {
        let patch = outline.patch::<f64>();
        let arm = patch.radius() + patch.centre().norm();
        let friction = ShapeFriction::new(&patch, 0.7).expect("valid");
        for _ in 0..500 {
            let twist = anyhow(&mut rng, &patch);
            let (wrench, jacobian) = friction.wrench_and_jacobian(3.0, &twist);
            assert_eq!(wrench, friction.wrench(3.0, &twist), "{}", outline.name);
            assert!(wrench.power(&twist) < 0.0);
            // With the arm as the unit of length all entries are alike.
            let unit = nalgebra::Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / arm));
            let even = unit * jacobian * unit;
            let size = even.amax();
            assert_eq!(even, even.transpose());
            let at = of_twist(&twist, arm);
            assert!(
                (even * at).amax() < 1e-11 * size * at.amax(),
                "{} {twist:?}",
                outline.name
            );
            let most = SymmetricEigen::new(even).eigenvalues.max();
            assert!(most < 1e-11 * size, "{} {most} of {size}", outline.name);
        }
    }
}

#[test]
fn single_precision_follows_double_precision() {
    let mut wrenches = Worst::of("f32, wrench");
    let mut jacobians = Worst::of("f32, Jacobian");
    let mut rng = Lcg::new(2);
    for outline in outlines().iter().filter(|outline| outline.name != "sliver") {
        let (single, double) = (outline.patch::<f32>(), outline.patch::<f64>());
        let arm = double.radius() + double.centre().norm();
        let of_single = ShapeFriction::new(&single, 1.0).expect("valid");
        let of_double = ShapeFriction::new(&double, 1.0).expect("valid");
        for _ in 0..1000 {
            let twist = anyhow(&mut rng, &double);
            let [x, y, spin] =
                [twist.velocity.x, twist.velocity.y, twist.spin].map(|part| part as f32);
            let (wrench, jacobian) = of_single.wrench_and_jacobian(1.0, &Twist::new(x, y, spin));
            let twist = Twist::new(f64::from(x), f64::from(y), f64::from(spin));
            let (expected, expected_jacobian) = of_double.wrench_and_jacobian(1.0, &twist);
            let error = (f64::from(wrench.force.x) - expected.force.x)
                .abs()
                .max((f64::from(wrench.force.y) - expected.force.y).abs())
                .max((f64::from(wrench.torque) - expected.torque).abs() / arm);
            wrenches.see(error, || format!("{}, {twist:?}", outline.name));
            let unit = nalgebra::Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / arm));
            let expected = unit * expected_jacobian * unit;
            let error = (unit * jacobian.map(f64::from) * unit - expected).amax() / expected.amax();
            jacobians.see(error, || format!("{}, {twist:?}", outline.name));
        }
    }
    wrenches.assert_within(&tolerance::POLYGON_SINGLE);
    jacobians.assert_within(&tolerance::POLYGON_SINGLE_JACOBIAN);
}

#[test]
fn many_nodes_come_close_to_it() {
    let corners = [[0.0, 0.0], [3.0, 0.25], [1.0, 2.0]];
    let nodes: NodeList<f64, 7168> = NodeList::polygon(&corners, 32).expect("room");
    let sampled = NodeFriction::new(CoulombLaw::new(1.0).expect("valid"), nodes);
    let exact = ShapeFriction::new(Polygon::new(corners).expect("valid"), 1.0).expect("valid");
    let mut rng = Lcg::new(3);
    for _ in 0..200 {
        let twist = anyhow(&mut rng, exact.patch());
        let (a, b) = (sampled.wrench(1.0, &twist), exact.wrench(1.0, &twist));
        assert!((a.force - b.force).norm() < 2e-4, "{twist:?}");
        assert!((a.torque - b.torque).abs() < 5e-4, "{twist:?}");
    }
}

#[test]
fn a_small_torque_keeps_its_digits_and_rest_is_rest() {
    let square =
        Polygon::new([[-1.0_f64, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).expect("valid");
    let friction = ShapeFriction::new(square, 1.0).expect("valid");
    // To first order the torque is −ω ∫(x·v)²/|v|³ dA/A = −ω/3 at unit speed.
    for spin in [1e-300, 1e-200, 1e-30, 1e-9] {
        let torque = friction.wrench(1.0, &Twist::new(0.6, 0.8, spin)).torque;
        assert!((torque / spin + 1.0 / 3.0).abs() < 1e-15, "{spin} {torque}");
    }
    assert_eq!(friction.wrench(1.0, &Twist::ZERO), Wrench::ZERO);
    let (rest, jacobian) = friction.wrench_and_jacobian(1.0, &Twist::ZERO);
    assert!(rest == Wrench::ZERO && jacobian.amax() == 0.0);
}

#[test]
fn speeds_at_the_ends_of_the_range_meet_the_same_friction() {
    let corners = [[0.0_f64, 0.0], [3.0, 0.25], [1.0, 2.0]];
    let friction = ShapeFriction::new(Polygon::new(corners).expect("valid"), 1.0).expect("valid");
    for twist in [Twist::new(0.75, -0.5, 0.625), Twist::new(3.0, 1.0, 0.03125)] {
        let (usual, jacobian) = friction.wrench_and_jacobian(1.0, &twist);
        for exponent in [-1040, -1000, -700, -400, 400, 700, 1020] {
            let scale = 2_f64.powi(exponent / 2) * 2_f64.powi(exponent - exponent / 2);
            let (wrench, scaled) = friction.wrench_and_jacobian(1.0, &(twist * scale));
            let distance =
                (wrench.force - usual.force).norm() + (wrench.torque - usual.torque).abs();
            assert!(distance < 1e-15, "{exponent}: {distance}");
            if (-1000..1000).contains(&exponent) {
                let difference = (scaled * scale - jacobian).amax();
                assert!(
                    difference < 1e-14 * jacobian.amax(),
                    "{exponent}: {difference}"
                );
            }
        }
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for twist in [
            Twist::new(bad, 0.0, 1.0),
            Twist::new(0.0, bad, 0.0),
            Twist::new(1.0, 0.0, bad),
        ] {
            let (wrench, jacobian) = friction.wrench_and_jacobian(1.0, &twist);
            assert!(wrench.force.x.is_nan() && wrench.torque.is_nan() && jacobian[(0, 0)].is_nan());
        }
    }
}

#[test]
fn loops_that_bound_no_patch_are_refused() {
    let refusal = |corners: &[[f64; 2]]| {
        let memory = vec![tribos_core::patch::outline::Edge::default(); corners.len()];
        Polygon::with_holes(&[corners], memory).err()
    };
    let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
    assert!(matches!(
        refusal(&line),
        Some(OutlineError::Crossing { .. })
    ));
    let two = refusal(&line[..2]);
    assert_eq!(
        two,
        Some(OutlineError::Corners {
            in_loop: 0,
            given: 2
        })
    );
    let spike = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [3.0, 2.0], [1.0, 2.0]];
    assert!(matches!(
        refusal(&spike),
        Some(OutlineError::Crossing { .. })
    ));
    let touching = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]];
    assert!(matches!(
        refusal(&touching),
        Some(OutlineError::Crossing { .. })
    ));
    let twice = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    assert_eq!(
        refusal(&twice),
        Some(OutlineError::Repeated {
            in_loop: 0,
            corner: 1
        })
    );
    let endless = [[0.0, 0.0], [f64::INFINITY, 0.0], [0.0, 2.0]];
    assert_eq!(
        refusal(&endless),
        Some(OutlineError::Position {
            in_loop: 0,
            corner: 1
        })
    );
    let wide = [[-1e308, 0.0], [1e308, 0.0], [0.0, 1.0]];
    assert_eq!(refusal(&wide), Some(OutlineError::Extent));
}

#[test]
fn holes_lie_inside_and_apart() {
    let square = |x: f64, half: f64| {
        [
            [x - half, -half],
            [x + half, -half],
            [x + half, half],
            [x - half, half],
        ]
    };
    let memory = || vec![tribos_core::patch::outline::Edge::default(); 12];
    let of = |loops: &[&[[f64; 2]]]| Polygon::with_holes(loops, memory());
    let (whole, left, right) = (square(0.0, 1.0), square(-0.5, 0.25), square(0.5, 0.25));
    let frame = of(&[&whole, &left, &right]).expect("valid");
    assert!((frame.area() - 3.5).abs() < 1e-15);
    let outside = of(&[&whole, &square(3.0, 0.5)]).err();
    assert_eq!(outside, Some(OutlineError::Hole { in_loop: 1 }));
    let nested = of(&[&whole, &left, &square(-0.5, 0.125)]).err();
    assert_eq!(nested, Some(OutlineError::Hole { in_loop: 2 }));
    let across = of(&[&whole, &square(1.0, 0.5)]).err();
    assert!(matches!(across, Some(OutlineError::Crossing { .. })));
    let room = Polygon::with_holes(&[&whole[..], &left[..]], vec![Default::default(); 7]).err();
    assert_eq!(room, Some(OutlineError::Room { given: 8, room: 7 }));
    // A square with a square hole: the difference of both, either way round.
    let mut backwards = left;
    backwards.reverse();
    let friction =
        |loops: &[&[[f64; 2]]]| ShapeFriction::new(of(loops).expect("valid"), 1.0).expect("valid");
    let holed = [friction(&[&whole, &left]), friction(&[&whole, &backwards])];
    let twist = Twist::new(0.3, -0.2, 0.9);
    let [a, b] = holed.map(|one| one.wrench(4.0 - 0.25, &twist));
    let (outer, inner) = (
        friction(&[&whole]).wrench(4.0, &twist),
        friction(&[&left]).wrench(0.25, &twist),
    );
    for wrench in [a, b] {
        let rest = wrench + inner - outer;
        assert!(rest.force.norm() < 4e-15 && rest.torque.abs() < 4e-15);
    }
}
