//! Polygons: what bounds a patch, holes, exponents, and nodes in their place.

use tribos_core::coupling::flat::{PatchShape, PolygonPowerLaw, ShapeFriction};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::{CoulombLaw, LawError};
use tribos_core::patch::nodes::NodeList;
use tribos_core::patch::outline::{Edge, OutlineError, Polygon};
use tribos_core::twist::Twist;
use tribos_tests::sweep::Lcg;

/// A twist whose centre of rotation is anywhere from the patch to 10⁶ radii away, at any speed.
fn anyhow(rng: &mut Lcg, patch: &impl PatchShape<f64>) -> Twist<f64> {
    let speed = 10_f64.powf(rng.between(-6.0, 6.0));
    let turn = speed / patch.radius() * 10_f64.powf(rng.between(-6.0, 1.0));
    let angle = rng.between(0.0, core::f64::consts::TAU);
    let sense = 1.0_f64.copysign(rng.between(-1.0, 1.0));
    Twist::new(speed * angle.cos(), speed * angle.sin(), sense * turn)
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
fn loops_that_bound_no_patch_are_refused() {
    let refusal = |corners: &[[f64; 2]]| {
        let memory = vec![Edge::default(); corners.len()];
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
    let memory = || vec![Edge::default(); 12];
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

#[test]
fn exponents_without_a_finite_friction_are_refused() {
    for given in [-1.0, -2.0, 10.5, f64::NAN, f64::INFINITY] {
        let refused = PolygonPowerLaw::new(given).err();
        assert!(
            matches!(refused, Some(LawError::Exponent { .. })),
            "{given}"
        );
    }
    assert!(PolygonPowerLaw::new(-0.999_f32).is_ok() && PolygonPowerLaw::new(10.0_f32).is_ok());
}
