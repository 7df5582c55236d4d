//! Contacts at points: tripods and wrenches by hand, no points at all, refused ones.

use nalgebra::Vector2;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::internals::tripod_shares;
use tribos_core::law::{CoulombLaw, PowerLaw};
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodeList, Nodes};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::{Lcg, special_f64};

fn node(x: f64, y: f64, weight: f64) -> Node<f64> {
    Node { x, y, weight }
}

fn dry(mu: f64) -> CoulombLaw<f64> {
    CoulombLaw::new(mu).expect("in range")
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
    // Dry friction at the ends of the range of speeds.
    for scale in [1e-323, 1e-310, 1e-154, 1e153, 1e307] {
        let wrench = NodeFriction::new(dry(1.0), pivot).wrench(1.0, &Twist::new(-scale, 0.0, 0.0));
        assert_eq!(entries(&wrench), [1.0, 0.0, 0.0], "{scale:e}");
        let wrench = NodeFriction::new(dry(1.0), pivot).wrench(1.0, &Twist::new(0.0, 0.0, scale));
        assert_eq!(entries(&wrench), [0.0, -1.0, -0.75], "{scale:e}");
    }
    let rest = Twist::ZERO;
    assert_eq!(
        entries(&NodeFriction::new(dry(1.0), pivot).wrench(1.0, &rest)),
        [0.0; 3]
    );
}

#[test]
fn without_nodes_only_what_is_no_number_resists() {
    let nothing = NodeFriction::new(dry(0.7), NodeList::<f64, 2>::new());
    for x in special_f64() {
        for spin in special_f64() {
            let found = entries(&nothing.wrench(1.0, &Twist::new(x, 0.0, spin)));
            let expected = if x.is_finite() && spin.is_finite() {
                0.0
            } else {
                f64::NAN
            };
            let is_same = |part: f64| part == expected || part.is_nan() && expected.is_nan();
            assert!(found.into_iter().all(is_same), "{x:e} {spin:e} {found:?}");
        }
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
