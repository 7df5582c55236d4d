//! Contacts at points: wrenches by hand, invariances, derivatives, the ends of the number range.

use nalgebra::{Matrix3, Rotation2, Vector2, Vector3};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::internals::tripod_shares;
use tribos_core::law::{CoulombLaw, LocalLaw, PowerLaw};
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch, Nodes};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

/// Sums of a dozen terms against the same sums in another order or frame, of the load.
const REORDERED: Bound = Bound {
    limit: 2e-15,
    reason: "a dozen roundings of terms up to the load; positions rounded by the turn",
};
/// Central differences, of the largest entry; step 2⁻²⁰ of the speed.
const DIFFERENCES: Bound = Bound {
    limit: 2e-9,
    reason: "nodes at least 0.1 away from the centre of rotation: truncation 1e-10; rounding 1e-16 x 2^20 / 0.1",
};

fn node(x: f64, y: f64, weight: f64) -> Node<f64> {
    Node { x, y, weight }
}

fn power(alpha: f64) -> PowerLaw<f64> {
    PowerLaw::new(alpha, 0.7).expect("in range")
}

fn dry(mu: f64) -> CoulombLaw<f64> {
    CoulombLaw::new(mu).expect("in range")
}

/// Twelve nodes somewhere in a square of side 2, one of them without load.
fn scattered(rng: &mut Lcg) -> Nodes<f64, 12> {
    let mut somewhere = || rng.between(-1.0, 1.0);
    let mut nodes = [(); 12].map(|()| node(somewhere(), somewhere(), somewhere().abs()));
    nodes[3].weight = 0.0;
    Nodes::new(nodes).expect("valid nodes")
}

fn twist(rng: &mut Lcg) -> Twist<f64> {
    let mut any = || rng.between(-1.0, 1.0);
    Twist::new(any(), any(), any())
}

fn entries(wrench: &Wrench<f64>) -> [f64; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

#[test]
fn tripod_resists_as_computed_by_hand() {
    // Feet (1, 0), (0, 1), (-1, -1) around their centroid: a third of 12 N each, mu = 1/2.
    let feet = [[1.0, 0.0], [0.0, 1.0], [-1.0, -1.0]];
    let stool = Nodes::tripod(feet, [0.0, 0.0]).expect("it stands");
    let friction = NodeFriction::new(dry(0.5), stool);
    // Spinning: every foot resists with 2 N at its distance 1, 1, sqrt 2.
    let spinning = friction.wrench(12.0, &Twist::new(0.0, 0.0, 5.0));
    assert!((spinning.torque + 2.0 * (2.0 + 2.0_f64.sqrt())).abs() < 1e-14);
    // Forces of 2 N along (0, -1), (1, 0) and (-1, 1)/sqrt 2.
    let rest = 2.0 - 2.0_f64.sqrt();
    assert!((spinning.force - Vector2::new(rest, -rest)).norm() < 1e-14);
    // Sliding: 6 N against the velocity, through the centroid.
    let sliding = friction.wrench(12.0, &Twist::new(3.0, -4.0, 0.0));
    assert!((sliding.force - Vector2::new(-3.6, 4.8)).norm() < 1e-14);
    assert!(sliding.torque.abs() < 1e-14);
}

#[test]
fn a_tripods_feet_carry_what_balances_its_weight() {
    let feet = [[0.2, 0.1], [1.3, -0.4], [0.5, 1.7]];
    let mut rng = Lcg::new(5);
    let (mut standing, mut tipping) = (0, 0);
    for _ in 0..1000 {
        let centre = [rng.between(0.0, 1.5), rng.between(-0.5, 2.0)];
        match tripod_shares(feet, centre) {
            Ok(shares) => {
                standing += 1;
                for axis in 0..2 {
                    let moment: f64 = shares.iter().zip(feet).map(|(p, r)| p * r[axis]).sum();
                    assert!((moment - centre[axis]).abs() < 1e-14, "{centre:?}");
                }
                assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                assert!(shares.iter().all(|&p| p >= 0.0));
            }
            Err(PatchError::FootPulls { foot }) => {
                tipping += 1;
                // The centre lies beyond the line through the other two, seen from that foot.
                let [a, b] = [feet[(foot + 1) % 3], feet[(foot + 2) % 3]];
                let side =
                    |p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                assert!(side(centre) * side(feet[foot]) < 0.0);
            }
            Err(other) => panic!("{centre:?}: {other}"),
        }
    }
    assert!(standing > 100 && tipping > 100);
    let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
    assert_eq!(tripod_shares(line, [1.0, 1.0]), Err(PatchError::FeetInLine));
    assert_eq!(
        tripod_shares(feet, [f64::NAN, 0.0]),
        Err(PatchError::FeetInLine)
    );
}

#[test]
fn jacobian_agrees_with_differences_and_is_symmetric() {
    let mut rng = Lcg::new(8);
    let mut worst = Worst::of("Jacobian of nodes against differences");
    for alpha in [-0.5, 0.0, 0.5, 1.0, 2.5] {
        for _ in 0..100 {
            let (patch, twist) = (scattered(&mut rng), twist(&mut rng));
            if nearest_speed(&patch, &twist) < 0.1 {
                continue;
            }
            let friction = NodeFriction::new(power(alpha), patch);
            let jacobian = friction.wrench_jacobian(3.0, &twist);
            assert_eq!(jacobian, jacobian.transpose());
            let expected = differences(&friction, &twist);
            let error = (jacobian - expected).amax() / expected.amax();
            worst.see(error, || format!("alpha {alpha}, {twist:?}"));
        }
    }
    worst.assert_within(&DIFFERENCES);
}

/// Speed of the slowest node.
fn nearest_speed(patch: &impl NodePatch<f64>, twist: &Twist<f64>) -> f64 {
    let speed = |n: &Node<f64>| {
        let [x, y] = [
            twist.velocity.x - twist.spin * n.y,
            twist.velocity.y + twist.spin * n.x,
        ];
        x.hypot(y)
    };
    patch
        .nodes()
        .iter()
        .map(speed)
        .fold(f64::INFINITY, f64::min)
}

/// Central differences of the wrench under a load of 3.
fn differences<L: LocalLaw<f64>, P: NodePatch<f64>>(
    friction: &NodeFriction<L, P>,
    twist: &Twist<f64>,
) -> Matrix3<f64> {
    let step = 2.0_f64.powi(-20);
    let at = |d: Vector3<f64>| {
        let moved = Vector3::new(twist.velocity.x, twist.velocity.y, twist.spin) + d;
        Vector3::from(friction.wrench(3.0, &Twist::from(moved)))
    };
    let columns = [Vector3::x(), Vector3::y(), Vector3::z()]
        .map(|e| (at(e * step) - at(-e * step)) / (2.0 * step));
    Matrix3::from_columns(&columns)
}

#[test]
fn jacobian_never_feeds_energy_in_for_laws_that_never_weaken() {
    let mut rng = Lcg::new(9);
    for alpha in [0.0, 0.5, 1.0, 3.0] {
        for _ in 0..200 {
            let friction = NodeFriction::new(power(alpha), scattered(&mut rng));
            let jacobian = friction.wrench_jacobian(1.0, &twist(&mut rng));
            let largest = jacobian.symmetric_eigenvalues().max();
            assert!(largest <= tolerance::EIGENVALUE.limit * jacobian.norm());
        }
    }
}

#[test]
fn turning_the_patch_and_its_motion_turns_the_wrench() {
    let mut rng = Lcg::new(10);
    let mut worst = Worst::of("nodes turned");
    for alpha in [-0.3, 0.0, 0.5, 2.0] {
        for _ in 0..200 {
            let (patch, twist) = (scattered(&mut rng), twist(&mut rng));
            let turn = Rotation2::new(rng.between(0.0, 6.0));
            let turned = Nodes::<f64, 12>::new(std::array::from_fn(|i| {
                let Node { x, y, weight } = patch.nodes()[i];
                let at = turn * Vector2::new(x, y);
                node(at.x, at.y, weight)
            }));
            let velocity = turn * twist.velocity;
            let moved = Twist::new(velocity.x, velocity.y, twist.spin);
            let expected = NodeFriction::new(power(alpha), patch).wrench(1.0, &twist);
            let found = NodeFriction::new(power(alpha), turned.expect("valid")).wrench(1.0, &moved);
            // A node's direction is as uncertain as its velocity: rounding over speed.
            let scale = nearest_speed(&patch, &twist).min(1.0);
            let error = (found.force - turn * expected.force).norm()
                + (found.torque - expected.torque).abs();
            worst.see(error * scale, || format!("alpha {alpha}, {twist:?}"));
        }
    }
    worst.assert_within(&REORDERED);
}

#[test]
fn friction_dissipates_and_dry_friction_knows_no_speed() {
    let mut rng = Lcg::new(11);
    for alpha in [-0.5, 0.0, 0.5, 3.0] {
        for _ in 0..500 {
            let (patch, twist) = (scattered(&mut rng), twist(&mut rng));
            let wrench = NodeFriction::new(power(alpha), patch).wrench(2.0, &twist);
            let power = wrench.power(&twist);
            assert!(power < 0.0, "alpha {alpha}: {power}");
            // No more than all nodes' friction in one direction.
            if alpha == 0.0 {
                assert!(wrench.force.norm() <= 0.7 * 2.0 * (1.0 + 1e-15));
                let faster = Twist::new(
                    4.0 * twist.velocity.x,
                    4.0 * twist.velocity.y,
                    4.0 * twist.spin,
                );
                let same = NodeFriction::new(dry(0.7), patch).wrench(2.0, &faster);
                let slow = NodeFriction::new(dry(0.7), patch).wrench(2.0, &twist);
                assert_eq!(same, slow);
            }
        }
    }
}

#[test]
fn torque_moves_with_the_point_of_reference() {
    let mut rng = Lcg::new(12);
    for _ in 0..200 {
        let (patch, twist) = (scattered(&mut rng), twist(&mut rng));
        let [dx, dy] = [0.25, -0.5];
        let moved = patch
            .nodes()
            .iter()
            .fold(NodeList::<f64, 12>::new(), |mut list, n| {
                let pushed = list.push(node(n.x - dx, n.y - dy, n.weight));
                pushed.expect("room for it");
                list
            });
        let there = Twist::new(
            twist.velocity.x - twist.spin * dy,
            twist.velocity.y + twist.spin * dx,
            twist.spin,
        );
        let here = NodeFriction::new(power(1.5), patch).wrench(1.0, &twist);
        let found = NodeFriction::new(power(1.5), moved).wrench(1.0, &there);
        assert!((found.force - here.force).norm() < 1e-14);
        let torque = here.torque - (dx * here.force.y - dy * here.force.x);
        assert!((found.torque - torque).abs() < 1e-14);
    }
}

#[test]
fn a_node_at_the_centre_of_rotation_carries_nothing() {
    let pivot = Nodes::new([node(0.5, 0.0, 3.0), node(1.5, 0.0, 1.0)]).expect("valid");
    // v = (0, -1), omega = 2: the centre of rotation is the first node.
    let twist = Twist::new(0.0, -1.0, 2.0);
    let wrench = NodeFriction::new(dry(1.0), pivot).wrench(1.0, &twist);
    assert_eq!(entries(&wrench), [0.0, -0.25, -0.375]);
    // Its dry friction has no derivative and is left out; its viscous friction stays.
    let jacobian = NodeFriction::new(dry(1.0), pivot).wrench_jacobian(1.0, &twist);
    assert_eq!((jacobian.m11, jacobian.m22), (-0.125, 0.0));
    let viscous = PowerLaw::new(1.0, 1.0).expect("in range");
    let jacobian = NodeFriction::new(viscous, pivot).wrench_jacobian(1.0, &twist);
    assert_eq!(
        (jacobian.m11, jacobian.m22, jacobian.m33),
        (-1.0, -1.0, -0.75)
    );
    let rest = Twist::ZERO;
    assert_eq!(
        entries(&NodeFriction::new(dry(1.0), pivot).wrench(1.0, &rest)),
        [0.0; 3]
    );
}

#[test]
fn nan_stays_nan_and_every_input_gives_a_result() {
    let patch = Nodes::new([node(0.5, 0.1, 3.0), node(-1.5, 0.2, 0.0)]).expect("valid");
    let empty = NodeList::<f64, 2>::new();
    for alpha in [-0.5, 0.0, 2.0] {
        let friction = NodeFriction::new(power(alpha), patch);
        let nothing = NodeFriction::new(power(alpha), &empty);
        for x in special_f64() {
            for spin in special_f64() {
                let twist = Twist::new(x, 0.0, spin);
                let wrench = friction.wrench(1.0, &twist);
                let jacobian = friction.wrench_jacobian(1.0, &twist);
                let ordinary = x.is_finite() && spin.is_finite();
                if !ordinary {
                    assert!(entries(&wrench).iter().all(|e| e.is_nan()), "{twist:?}");
                    assert!(jacobian.iter().all(|e| e.is_nan()), "{twist:?}");
                    assert!(nothing.wrench(1.0, &twist).torque.is_nan());
                } else {
                    assert_eq!(
                        entries(&nothing.wrench(1.0, &twist)).map(f64::abs),
                        [0.0; 3]
                    );
                }
            }
        }
        let moving = Twist::new(1.0, 0.0, 1.0);
        assert!(friction.wrench(f64::NAN, &moving).force.x.is_nan());
    }
}

#[test]
fn dry_friction_is_right_at_the_ends_of_the_number_range() {
    let patch = Nodes::new([node(1.0, 0.0, 1.0), node(-1.0, 0.0, 1.0)]).expect("valid");
    let friction = NodeFriction::new(dry(0.5), patch);
    for scale in [1e-323, 1e-310, 1e-200, 1e-154, 1.0, 1e153, 1e200, 1e307] {
        let near = |twist: Twist<f64>, expected: [f64; 3]| {
            let found = entries(&friction.wrench(2.0, &twist));
            for (f, e) in found.iter().zip(expected) {
                assert!(
                    (f - e).abs() <= tolerance::ROUNDING.limit,
                    "{scale:e}: {found:?}"
                );
            }
        };
        near(Twist::new(3.0 * scale, 0.0, 0.0), [-1.0, 0.0, 0.0]);
        near(Twist::new(0.0, 0.0, scale), [0.0, 0.0, -1.0]);
    }
}

#[test]
fn invalid_nodes_are_refused_with_their_number() {
    let good = node(0.0, 0.0, 1.0);
    let weight = |w| Nodes::new([good, node(0.0, 0.0, w)]);
    assert!(matches!(
        weight(-1.0),
        Err(PatchError::NodeWeight { index: 1, .. })
    ));
    assert!(matches!(
        weight(f64::NAN),
        Err(PatchError::NodeWeight { index: 1, .. })
    ));
    assert!(matches!(
        weight(f64::INFINITY),
        Err(PatchError::NodeWeight { index: 1, .. })
    ));
    let place = Nodes::new([node(f64::NAN, 0.0, 1.0), good]);
    assert!(matches!(
        place,
        Err(PatchError::NodePosition { index: 0, .. })
    ));
    assert_eq!(Nodes::new([node(0.0, 0.0, 0.0)]), Err(PatchError::Unloaded));
    assert_eq!(Nodes::<f64, 0>::new([]), Err(PatchError::Unloaded));
    let huge = Nodes::new([node(0.0, 0.0, f64::MAX), node(0.0, 0.0, f64::MAX)]);
    assert!(matches!(huge, Err(PatchError::NodeWeight { index: 1, .. })));

    let mut list = NodeList::<f64, 1>::new();
    assert!(list.push(node(0.0, 0.0, -1.0)).is_err());
    assert_eq!(list.push(good), Ok(()));
    let before = list.clone();
    assert_eq!(list.push(good), Err(PatchError::Full { capacity: 1 }));
    assert_eq!(list, before);
}
