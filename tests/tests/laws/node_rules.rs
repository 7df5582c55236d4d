//! Rules that stand for continuous pressures: how fast they converge, and to what.
//!
//! Oracles: the compact tier of the uniform disk, closed forms of the Hertz and punch pressures,
//! and a table of four pressures.

use core::f64::consts::{PI, TAU};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{RoundFriction, compact, coulomb};
use tribos_core::law::{CoulombLaw, PowerLaw};
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance::Bound;
use tribos_tests::worst::Worst;

/// Standard rule, Coulomb, any twist and q from -1/2 to 1, of the load and the load × radius.
const STANDARD: Bound = Bound {
    limit: 5e-3,
    reason: "promised in patch::polar; centre of rotation next to a node",
};
/// Standard rule with the centre of rotation half a radius outside the disk, of the largest speed^α.
const STANDARD_OUTSIDE: Bound = Bound {
    limit: 1e-7,
    reason: "promised in patch::polar; alpha = -1/2 and the load at the rim are the worst",
};
/// Odd exponents: the integrand is a polynomial.
const POLYNOMIAL: Bound = Bound {
    limit: 1e-14,
    reason: "exact but for the rounding of 512 nodes",
};
/// Observed order of convergence with the centre inside against 2 + alpha.
const ORDER: Bound = Bound {
    limit: 0.15,
    reason: "fluctuates with the places of 2000 centres among the nodes; next order",
};

/// f32 against f64, 512 nodes, of the load.
const SINGLE: Bound = Bound {
    limit: 5e-6,
    reason: "512 roundings add up; direction of nodes near the centre of rotation",
};

/// Most nodes of any rule here.
const ROOM: usize = 64 * 128;

fn law(alpha: f64) -> PowerLaw<f64> {
    PowerLaw::new(alpha, 1.0).expect("in range")
}

fn dry() -> CoulombLaw<f64> {
    CoulombLaw::new(1.0).expect("in range")
}

fn rule(rings: u32, angles: u32, q: f64) -> PolarQuadrature<f64> {
    let uniform = PolarQuadrature::new(1.0, rings, angles).expect("in range");
    uniform.with_rim_exponent(q).expect("in range")
}

fn disk(rings: u32, angles: u32, q: f64) -> NodeList<f64, ROOM> {
    rule(rings, angles, q).nodes().expect("room for all")
}

/// A twist with unit rim speed and v = `eps` in any direction.
fn anyhow(rng: &mut Lcg, eps: f64) -> Twist<f64> {
    let angle = rng.between(0.0, TAU);
    Twist::new(eps * angle.cos(), eps * angle.sin(), 1.0)
}

/// The larger of the differences of force and torque.
fn distance(a: &Wrench<f64>, b: &Wrench<f64>) -> f64 {
    (a.force - b.force).norm().max((a.torque - b.torque).abs())
}

/// The wrench with magnitudes `force` and `torque` against `twist`.
fn against(twist: &Twist<f64>, force: f64, torque: f64) -> Wrench<f64> {
    let speed = twist.velocity.norm();
    Wrench {
        force: -twist.velocity * (force / speed),
        torque: -torque,
    }
}

/// Root mean square and largest error over 2000 centres of rotation with eps in `range`.
fn errors(alpha: f64, rings: u32, angles: u32, range: [f64; 2]) -> [f64; 2] {
    let nodes = NodeFriction::new(law(alpha), disk(rings, angles, 0.0));
    let tier = compact::CompactPower::new(alpha).expect("in range");
    let exact = RoundFriction::new(tier, 1.0, 1.0).expect("a coefficient");
    let mut rng = Lcg::new(3);
    let (mut sum, mut largest) = (0.0, 0.0_f64);
    for _ in 0..2000 {
        let eps = rng.between(range[0], range[1]);
        let twist = anyhow(&mut rng, eps);
        let error = distance(&nodes.wrench(1.0, &twist), &exact.wrench(1.0, &twist));
        sum += error * error / 2000.0;
        largest = largest.max(error);
    }
    [sum.sqrt(), largest]
}

const INSIDE: [f64; 2] = [0.01, 0.9];

#[test]
fn centre_inside_converges_with_order_two_plus_alpha() {
    let mut worst = Worst::of("order of the polar rule, centre inside");
    for alpha in [-0.5, 0.0, 0.5] {
        let errors = [(8, 16), (16, 32), (32, 64)].map(|(r, a)| errors(alpha, r, a, INSIDE));
        println!("alpha {alpha}, rms and largest: {errors:.7?}");
        for pair in errors.windows(2) {
            let order = (pair[0][0] / pair[1][0]).log2();
            let place = || format!("alpha {alpha}: {order:.3}");
            worst.see((order - 2.0 - alpha).abs(), place);
        }
        // A node next to the centre resists with at most its share for alpha >= 0 only.
        assert!(alpha < 0.0 || errors.iter().all(|[rms, largest]| *largest < 4.0 * rms));
    }
    worst.assert_within(&ORDER);
}

#[test]
fn centre_outside_converges_geometrically() {
    for alpha in [-0.5, 0.0, 0.5] {
        let at = |r, a| errors(alpha, r, a, [1.2, 1.3])[1];
        let errors = [at(4, 8), at(8, 16), at(16, 32), at(32, 64)];
        println!("alpha {alpha}, largest: {errors:?}");
        // Doubling the order squares the error, roughly: the slope itself doubles.
        let slopes = [0, 1, 2].map(|i| (errors[i] / errors[i + 1]).log2());
        assert!(
            slopes[1] > 1.3 * slopes[0] && slopes[2] > 1.3 * slopes[1],
            "{slopes:?}"
        );
        assert!(errors[3] < 3e-9, "{errors:?}");
    }
}

#[test]
fn odd_exponents_are_exact() {
    let mut worst = Worst::of("polar rule, alpha 1 and 3");
    for alpha in [1.0, 3.0] {
        worst.see(errors(alpha, 16, 32, INSIDE)[1], || {
            format!("alpha {alpha}")
        });
    }
    worst.assert_within(&POLYNOMIAL);
}

#[test]
fn standard_rule_keeps_its_bound_for_every_pressure() {
    let mut worst = Worst::of("standard rule, Coulomb, centre anywhere");
    let mut rng = Lcg::new(4);
    let tier = coulomb::CoulombDisk;
    let exact = RoundFriction::new(tier, 1.0, 1.0).expect("a coefficient");
    let nodes = [0.0, 0.5, -0.5].map(|q| {
        let rule = PolarQuadrature::standard(1.0).expect("a radius");
        let rule = rule.with_rim_exponent(q).expect("in range");
        let list = rule.nodes::<{ PolarQuadrature::<f64>::STANDARD_NODES }>();
        NodeFriction::new(dry(), list.expect("room for all"))
    });
    let [uniform, hertz, punch] = &nodes;
    for _ in 0..20_000 {
        let twist = rng.between(0.001, 1.3);
        let twist = anyhow(&mut rng, twist);
        let found = uniform.wrench(1.0, &twist);
        let error = distance(&found, &exact.wrench(1.0, &twist));
        worst.see(error, || format!("uniform, {twist:?}"));
        let e = twist.velocity.norm();
        if e > 1.0 {
            continue;
        }
        // Closed forms with the centre inside.
        let (sq, fourth) = (e * e, e * e * e * e);
        let force = 0.375 * PI * e * (1.0 - sq / 4.0);
        let torque = 0.1875 * PI * (1.0 - sq + 0.375 * fourth);
        let error = distance(&hertz.wrench(1.0, &twist), &against(&twist, force, torque));
        worst.see(error, || format!("Hertz, {twist:?}"));
        let (force, torque) = (0.25 * PI * e, 0.25 * PI * (1.0 - sq / 2.0));
        let error = distance(&punch.wrench(1.0, &twist), &against(&twist, force, torque));
        worst.see(error, || format!("punch, {twist:?}"));
    }
    worst.assert_within(&STANDARD);
}

/// The table's patch with pressure × (1 + `tilt` x), 16 × 32 nodes, a ring with 512.
fn tabulated(row: &Row<'_>, tilt: f64) -> NodeList<f64, ROOM> {
    let q = row.number("q");
    if q > -1.0 {
        return rule(16, 32, q).nodes_tilted(tilt, 0.0).expect("room");
    }
    let ring: NodeList<f64, ROOM> = NodeList::ring(1.0, 512).expect("room");
    ring.nodes()
        .iter()
        .fold(NodeList::new(), |mut list, &node| {
            let weight = node.weight * (1.0 + tilt * node.x);
            let pushed = list.push(tribos_core::patch::nodes::Node { weight, ..node });
            pushed.expect("room");
            list
        })
}

#[test]
fn four_pressures_and_their_tilts_agree_with_the_table() {
    let mut outside = Worst::of("standard rule, four pressures, tilted, centre outside");
    let mut inside = Worst::of("the same, centre inside");
    for row in Table::read("node_pressures.csv").rows() {
        let (alpha, eps) = (row.number("alpha"), row.number("eps"));
        let [force, torque, sideways] = ["F", "T", "Fperp"].map(|name| row.number(name));
        let twist = Twist::new(eps, 0.0, 1.0);
        for tilt in [0.0, 0.6, -1.0] {
            let nodes = NodeFriction::new(law(alpha), tabulated(&row, tilt));
            let found = nodes.wrench(1.0, &twist);
            let mut expected = against(&twist, force, torque);
            expected.force.y = -tilt * sideways;
            let scale = eps.max(1.0).powf(alpha);
            let error = distance(&found, &expected) / scale;
            let place = || {
                format!(
                    "{}, alpha {alpha}, eps {eps}, tilt {tilt}",
                    row.text("pressure")
                )
            };
            if eps >= 1.5 {
                outside.see(error, place);
            } else if alpha >= 0.0 && eps < 1.0 && row.number("q") > -1.0 {
                inside.see(error, place);
            }
        }
    }
    outside.assert_within(&STANDARD_OUTSIDE);
    inside.assert_within(&STANDARD);
}

#[test]
fn a_shape_may_be_any_pressure() {
    // Uniform rule with p(r) = 1 - r² against the parabolic rule.
    let shaped: NodeList<f64, 512> = rule(16, 32, 0.0)
        .nodes_shaped(|x, y| 1.0 - x * x - y * y)
        .expect("room");
    let twist = Twist::new(1.2, 0.9, 1.0);
    let found = NodeFriction::new(dry(), shaped).wrench(1.0, &twist);
    let expected = NodeFriction::new(dry(), disk(16, 32, 1.0)).wrench(1.0, &twist);
    assert!(distance(&found, &expected) < 1e-8);
    // A tilt that would pull is refused where a node lies there.
    let pulling = rule(8, 16, 0.0).nodes_tilted::<ROOM>(1.5, 0.0);
    assert!(matches!(pulling, Err(PatchError::NodeWeight { .. })));
}

#[test]
fn rules_without_meaning_are_refused() {
    let with = |r, rings, angles| PolarQuadrature::new(r, rings, angles);
    assert!(matches!(with(0.0, 1, 1), Err(PatchError::Radius { .. })));
    assert!(matches!(
        with(f64::NAN, 1, 1),
        Err(PatchError::Radius { .. })
    ));
    assert_eq!(with(1.0, 0, 1), Err(PatchError::RuleOrder { given: 0 }));
    assert_eq!(
        with(1.0, 1, 1025),
        Err(PatchError::RuleOrder { given: 1025 })
    );
    for q in [-1.0, 65.0, f64::NAN] {
        let refused = rule(2, 2, 0.0).with_rim_exponent(q);
        assert!(matches!(refused, Err(PatchError::RimExponent { .. })));
    }
    let full = rule(4, 8, 0.0).nodes::<31>();
    assert_eq!(full, Err(PatchError::Full { capacity: 31 }));
}

#[test]
fn single_precision_follows_double() {
    let narrow = PolarQuadrature::standard(1.0_f32).expect("a radius");
    let narrow: NodeList<f32, 512> = narrow.nodes().expect("room");
    let one = CoulombLaw::new(1.0_f32).expect("in range");
    let narrow = NodeFriction::new(one, narrow);
    let wide = NodeFriction::new(dry(), disk(16, 32, 0.0));
    let mut worst = Worst::of("f32 nodes");
    let mut rng = Lcg::new(7);
    for _ in 0..500 {
        let eps = rng.between(0.01, 2.0);
        let twist = anyhow(&mut rng, eps);
        let [x, y] = [twist.velocity.x as f32, twist.velocity.y as f32];
        let same = Twist::new(f64::from(x), f64::from(y), 1.0);
        let found = narrow.wrench(1.0, &Twist::new(x, y, 1.0));
        let expected = wide.wrench(1.0, &same);
        let force = (found.force.map(f64::from) - expected.force).norm();
        let torque = (f64::from(found.torque) - expected.torque).abs();
        worst.see(force.max(torque), || format!("{twist:?}"));
    }
    worst.assert_within(&SINGLE);
}
