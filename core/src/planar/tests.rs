//! Steps on points of any number, load and length of step, judged by the support function alone.

extern crate std;

use super::{PlanarBody, PointContacts};
use crate::contact::TimeStep;
use crate::limit_surface::{FrictionSet, ShapeLimitSurface};
use crate::patch::nodes::{Node, NodeList, NodePatch};
use crate::patch::points::PointPatch;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

const MOST: usize = 16;
/// Twists of the test that always runs, and of the whole one.
const FEW: u32 = 60;
const MANY: u32 = 20_000;

/// A number of −1 … 1 that golden angles and their like spread evenly.
fn part(i: u32, k: f64) -> f64 {
    2.0 * (f64::from(i) * k).fract() - 1.0
}

/// Places and loads of 2, 3, 4, 5, 8 and 16 feet: in a line, even, with one in the middle, of loads that span
/// four decades, spread over an area off the origin.
fn feet() -> [NodeList<f64, MOST>; 6] {
    let at = |x, y, weight| Node { x, y, weight };
    let of = |nodes: &mut dyn Iterator<Item = Node<f64>>| {
        let mut list = NodeList::new();
        for node in nodes {
            list.push(node).unwrap();
        }
        list
    };
    let pair = [at(-0.2, 0.0, 1.0), at(0.1, 0.0, 2.0)];
    let line = [at(-1.0, 0.5, 1.0), at(0.2, 0.5, 0.1), at(1.0, 0.5, 1.0)];
    let chair = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]].map(|[x, y]| at(x, y, 1.0));
    let middle = at(0.0, 0.0, 3.0);
    let ring = |i: u32| {
        let angle = core::f64::consts::FRAC_PI_4 * f64::from(i);
        at(
            0.1 * libm::cos(angle),
            0.1 * libm::sin(angle),
            libm::exp(-1.3 * f64::from(i)),
        )
    };
    let disk = |i: u32| {
        let (angle, r) = (2.399_963_23 * f64::from(i), 0.025 * f64::from(i).sqrt());
        at(
            0.02 + r * libm::cos(angle),
            r * libm::sin(angle),
            1.0 + 0.1 * f64::from(i),
        )
    };
    [
        of(&mut pair.into_iter()),
        of(&mut line.into_iter()),
        of(&mut chair.into_iter()),
        of(&mut chair.into_iter().chain([middle])),
        of(&mut (0..8).map(ring)),
        of(&mut (0..16).map(disk)),
    ]
}

/// What is known of a set beside its projection: Σ cᵢ |uᵢ|, with lengths in units of the farthest point.
struct Judge<'a> {
    nodes: &'a NodeList<f64, MOST>,
    radius: f64,
}

impl Judge<'_> {
    fn support(&self, [x, y, n]: [f64; 3]) -> f64 {
        let speeds = self.nodes.nodes().iter().map(|node| {
            let (px, py) = (node.x / self.radius, node.y / self.radius);
            let (u, v) = (x - n * py, y + n * px);
            node.weight * (u * u + v * v).sqrt()
        });
        speeds.sum::<f64>() / self.nodes.total_weight()
    }

    /// The largest wrench · twist over the support: of rotations about every point and of directions spread
    /// evenly, from the best of which random steps climb on.
    fn gauge(&self, wrench: [f64; 3], climbs: u32) -> f64 {
        let along = |twist: [f64; 3]| {
            let power = wrench.iter().zip(twist).map(|(w, t)| w * t).sum::<f64>();
            power.abs() / self.support(twist)
        };
        let about = |node: &Node<f64>| [node.y / self.radius, -node.x / self.radius, 1.0];
        let spread = (0..64).map(|i| {
            let n = part(i, 0.754_877_666_25);
            let (angle, across) = (2.399_963_23 * f64::from(i), (1.0 - n * n).sqrt());
            [across * libm::cos(angle), across * libm::sin(angle), n]
        });
        // NaN stays.
        let (mut best, mut most) = ([0.0; 3], wrench.iter().sum::<f64>() * 0.0);
        for twist in self.nodes.nodes().iter().map(about).chain(spread) {
            let reached = along(twist);
            if reached > most {
                (best, most) = (twist, reached);
            }
        }
        let mut step = 0.25;
        for i in 0..climbs {
            let by =
                [0.754_877_666_25, 0.569_840_290_99, 0.819_172_513_4].map(|k| step * part(i, k));
            let twist = [best[0] + by[0], best[1] + by[1], best[2] + by[2]];
            let reached = along(twist);
            if reached > most {
                (best, most) = (twist, reached);
            } else {
                step *= 0.97;
            }
        }
        most
    }
}

/// Farthest out of its set, and largest growth of the kinetic energy, of the steps of a body without push, whose
/// weight is 2 to the power of `octaves`.
fn worst<R: Real>(nodes: &NodeList<f64, MOST>, twists: u32, octaves: i32) -> [f64; 2] {
    let mut own = NodeList::<R, MOST>::new();
    for node in nodes.nodes() {
        let [x, y, weight] = [node.x, node.y, node.weight].map(R::from_f64);
        own.push(Node { x, y, weight }).unwrap();
    }
    let radius = nodes
        .nodes()
        .iter()
        .fold(0.0, |most: f64, node| most.max(libm::hypot(node.x, node.y)));
    let judge = Judge { nodes, radius };
    let scale = R::from_f64(libm::exp2(f64::from(octaves)));
    let [mass, inertia, limit] = [5.0, 0.3, 15.0].map(|part| R::from_f64(part) * scale);
    let body = PlanarBody::new(mass, inertia).unwrap();
    let set = ShapeLimitSurface::new(PointPatch::new(own.clone()).unwrap(), limit).unwrap();
    let mut foot: PointContacts<R, _, MOST> = PointContacts::new(own, limit).unwrap();
    let energy = |twist: &Twist<R>| {
        let [x, y, n] = [twist.velocity.x, twist.velocity.y, twist.spin].map(R::to_f64);
        5.0 * (x * x + y * y) + 0.3 * n * n
    };
    let mut worst = [0.0_f64; 2];
    for i in 0..twists {
        let twist = [0.671_043_606_7, 0.549_700_477_9, 0.445_041_867_9].map(|k| part(i, k));
        let twist = Twist::new(3.0 * twist[0], 3.0 * twist[1], 30.0 * twist[2]);
        let twist = Twist::new(
            R::from_f64(twist.velocity.x),
            R::from_f64(twist.velocity.y),
            R::from_f64(twist.spin),
        );
        for decade in 1..10 {
            let dt = TimeStep::new(R::from_f64(libm::pow(10.0, -f64::from(decade)))).unwrap();
            foot.release();
            let steps = [
                body.step(&set, &twist, &Wrench::ZERO, dt),
                body.step_on_points(&mut foot, &twist, &Wrench::ZERO, dt),
            ];
            for step in steps {
                let Wrench { force, torque } = step.friction;
                let wrench = [
                    force.x / limit,
                    force.y / limit,
                    torque / limit / R::from_f64(radius),
                ];
                let gauge = judge.gauge(wrench.map(R::to_f64), if i % 16 == 0 { 600 } else { 0 });
                assert!(gauge >= 0.0, "{twist:?} {decade} {step:?}");
                let growth = energy(&step.twist) / energy(&twist) - 1.0;
                worst = [worst[0].max(gauge - 1.0), worst[1].max(growth)];
            }
        }
    }
    worst
}

/// The same for all feet, at an ordinary load and at one next to the least normal number.
fn check(twists: u32) {
    for nodes in &feet() {
        let double = [0, -1020].map(|octaves| worst::<f64>(nodes, twists, octaves));
        let single = [0, -120].map(|octaves| worst::<f32>(nodes, twists, octaves));
        let count = nodes.nodes().len();
        std::println!("{count} feet: {double:?}, in f32 {single:?}");
        // Sums of up to 16 forces, each rounded, and of the judge's.
        let few = |worst: &[f64; 2], ulp: f64| worst.iter().all(|off| *off < 16.0 * ulp);
        assert!(
            double.iter().all(|worst| few(worst, f64::EPSILON)),
            "{count} {double:?}"
        );
        assert!(
            single
                .iter()
                .all(|worst| few(worst, f64::from(f32::EPSILON))),
            "{count} {single:?}"
        );
    }
}

#[test]
fn no_step_on_points_leaves_their_set_or_gains_energy() {
    check(FEW);
}

#[test]
#[ignore = "over a minute: cargo test --release -p tribos-core no_step_on_points -- --ignored"]
fn no_step_on_points_of_very_many_leaves_their_set_or_gains_energy() {
    check(MANY);
}

/// Wrenches in all directions whose gauge, by the search on the limit surface, is 1 + `beyond`, with a length of the
/// norm and the nearest wrench of a foot without forces.
fn answers<R: Real>(
    nodes: &NodeList<f64, MOST>,
    beyond: f64,
    mut judge: impl FnMut(f64, &Wrench<R>, &Wrench<R>, R),
) {
    let (mut own, mut exact) = (NodeList::<R, MOST>::new(), NodeList::<f64, MOST>::new());
    for node in nodes.nodes() {
        let [x, y, weight] = [node.x, node.y, node.weight].map(R::from_f64);
        own.push(Node { x, y, weight }).unwrap();
        let [x, y, weight] = [x, y, weight].map(R::to_f64);
        exact.push(Node { x, y, weight }).unwrap();
    }
    let set = ShapeLimitSurface::new(PointPatch::new(exact).unwrap(), 15.0).unwrap();
    let gauge = |wrench: &Wrench<R>| {
        let parts = [wrench.force.x, wrench.force.y, wrench.torque].map(R::to_f64);
        set.gauge(&Wrench::new(parts[0], parts[1], parts[2]))
    };
    let limit = R::from_f64(15.0);
    let mut foot: PointContacts<R, _, MOST> = PointContacts::new(own, limit).unwrap();
    for i in 0..100 {
        let arm = 0.3 * libm::exp(3.0 * part(i, 0.324_717_957_2));
        let length = R::from_f64(0.2 * libm::exp(2.0 * part(i, 0.819_172_513_4)));
        let of = |size: f64| {
            let [x, y, n] = [0.671_043_606_7, 0.549_700_477_9, 0.445_041_867_9].map(|k| part(i, k));
            let [x, y, n] = [x, y, arm * n].map(|part| R::from_f64(size * part));
            Wrench::new(x, y, n)
        };
        let wrench = of((1.0 + beyond) / gauge(&of(1.0)));
        foot.release();
        let answer = foot.nearest(&wrench, length);
        judge(gauge(&answer), &wrench, &answer, length);
    }
}

/// The gauge of points is exact to 8e-13; 64 rounding errors of a wrench in single precision are at most four times
/// as many of its gauge, with these lengths.
#[test]
fn forces_are_found_for_what_points_carry_and_no_wrench_outside_is_held() {
    fn check<R: Real>(nodes: &NodeList<f64, MOST>, [near, least, rounding]: [f64; 3]) {
        for decade in 1..17 {
            let room = libm::pow(10.0, -f64::from(decade));
            answers::<R>(nodes, -room, |_, wrench, answer, length| {
                if room >= near {
                    assert_eq!(answer, wrench, "{room:e}");
                }
                let off = (*answer - *wrench) * (R::ONE / R::from_f64(15.0));
                let off = off.force.x.hypot(off.force.y).hypot(off.torque / length);
                assert!(off.to_f64() < least, "{room:e} {off:?}");
            });
            answers::<R>(nodes, room, |gauge, wrench, answer, _| {
                assert!(gauge < 1.0 + rounding, "{room:e} {gauge}");
                assert!(answer != wrench || room < rounding, "{room:e} {wrench:?}");
            });
        }
    }
    for nodes in &feet() {
        check::<f64>(nodes, [1e-7, 1e-8, 1e-12]);
        check::<f32>(nodes, [1e-5, 1e-4, 3e-5]);
    }
}
