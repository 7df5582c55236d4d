//! Sets of patches against their definitions.

use super::*;
use crate::patch::mesh::{Mesh, Vertex};
use crate::patch::nodes::{Node, Nodes};
use crate::patch::outline::Polygon;
use crate::patch::points::PointPatch;

/// A number of −1 … 1 that golden angles and their like spread evenly.
fn part(i: u32, k: f64) -> f64 {
    2.0 * (f64::from(i) * k).fract() - 1.0
}

/// A rectangle of sides 2 and 2/`aspect`, or a U of such walls, turned by `angle`.
fn slender<R: Real, const N: usize>(
    corners: [[f64; 2]; N],
    angle: f64,
) -> ShapeLimitSurface<R, Polygon<R, [crate::patch::outline::Edge<R>; N]>> {
    let (c, s) = (libm::cos(angle), libm::sin(angle));
    let turned = corners.map(|[x, y]| [c * x - s * y, s * x + c * y].map(R::from_f64));
    ShapeLimitSurface::new(Polygon::new(turned).unwrap(), R::ONE).unwrap()
}

/// Largest distance of the friction of a normal from the wrench below it, and whether a projection stays.
fn normals_of<R: Real, const N: usize>(corners: [[f64; 2]; N]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..600 {
        let surface = slender::<R, N>(corners, 3.2 * part(i / 30, 0.754_877_666_25));
        // Some pushes lie next to the rim or next to an axis.
        let narrow = libm::exp(6.0 * part(i, 0.671_043_606_7) - 6.0);
        let torque = surface.arm.to_f64() * part(i, 0.819_172_513_4);
        let [x, y] = [part(i, 0.569_840_290_99), part(i, 0.445_041_867_9)];
        let [x, y, torque] = match i % 3 {
            0 => [x, y * narrow, torque * narrow],
            1 => [x, y, torque * narrow],
            _ => [x, y, torque],
        }
        .map(R::from_f64);
        let push = Wrench::new(x, y, torque);
        let gauge = surface.gauge(&push);
        let friction = surface.wrench(&surface.twist_normal_to(&push)) + push * (R::ONE / gauge);
        let off = [
            friction.force.x,
            friction.force.y,
            friction.torque / surface.arm,
        ];
        for part in off {
            worst = worst.max(part.to_f64().abs());
        }
        // Far outside and near, in several lengths.
        let far = R::from_f64(1.0 + libm::exp(7.0 * part(i, 0.324_717_957_2)));
        let length = surface.radius * R::from_f64(libm::exp(2.0 * part(i, 0.618_033_988_7)));
        let once = surface.project_with_length(&(push * (far / gauge)), length);
        let twice = surface.project_with_length(&once.wrench, length);
        assert_eq!(once.wrench, twice.wrench, "{corners:?} {i}");
        assert!(surface.contains(&once.wrench), "{corners:?} {i}");
    }
    worst
}

#[test]
fn thin_strips_and_walls_have_the_normals_of_their_surface() {
    let strip = |a: f64| {
        [
            [-1.0, -1.0 / a],
            [1.0, -1.0 / a],
            [1.0, 1.0 / a],
            [-1.0, 1.0 / a],
        ]
    };
    // Three walls of length 2 and this aspect ratio.
    let walls = |a: f64| {
        let (outer, inner) = (1.0, 1.0 - 2.0 / a);
        [
            [-outer, -outer],
            [outer, -outer],
            [outer, outer],
            [inner, outer],
            [inner, -inner],
            [-inner, -inner],
            [-inner, outer],
            [-outer, outer],
        ]
    };
    for aspect in [10.0, 100.0, 1000.0, 1e4] {
        let lost = aspect / 10.0;
        let double = [
            normals_of::<f64, 4>(strip(aspect)),
            normals_of::<f64, 8>(walls(aspect)),
        ];
        for off in double {
            assert!(off < 1e-13 * lost, "{aspect}: {double:?}");
        }
        if aspect < 200.0 {
            let single = [
                normals_of::<f32, 4>(strip(aspect)),
                normals_of::<f32, 8>(walls(aspect)),
            ];
            for off in single {
                assert!(off < 2e-5 * lost, "{aspect}: {single:?}");
            }
        }
    }
}

#[test]
fn a_dozen_steps_find_the_motion_under_any_push() {
    let (a, b, c) = ([1.0, 1.0], [4.0, 1.0], [10.0, 1.0]);
    let mut worst = [0; 2];
    let mut residual = 0.0_f64;
    for [x, y] in [a, b, c] {
        let patch = Polygon::new([[-x, -y], [x, -y], [x, y], [-x, y]]).unwrap();
        let surface = ShapeLimitSurface::new(patch, 1.0).unwrap();
        let length_sq = (surface.radius / surface.arm) * (surface.radius / surface.arm);
        for i in 0..20_000 {
            let wrench = Vector3::new(
                part(i, 0.754_877_666_25),
                part(i, 0.569_840_290_99),
                part(i, 0.819_172_513_4),
            );
            // Some pushes lie next to an axis.
            let narrow = libm::exp(6.0 * part(i, 0.671_043_606_7) - 6.0);
            let wrench = match i % 3 {
                0 => Vector3::new(wrench.x, wrench.y * narrow, wrench.z * narrow),
                1 => Vector3::new(wrench.x * narrow, wrench.y * narrow, wrench.z),
                _ => wrench,
            };
            let radial = GaugeObjective {
                wrench: wrench * (1.0 / norm(&wrench)),
            };
            let found = surface.above(&radial);
            worst[0] = worst[0].max(found.steps);
            residual = residual.max(norm(&radial.gradient(&found.at, &found.power)));
            let goal = ProjectionObjective {
                wrench: radial.wrench * (1.5 + part(i, 0.445_041_867_9)),
                reach: 1.0,
                length_sq,
            };
            let far = dot(&goal.wrench, &found.at) - found.power.value;
            if far > 0.0 {
                let start = found.at * (far / dot(&found.at, &goal.displacement(&found.at)));
                let found = surface.least(&goal, start);
                worst[1] = worst[1].max(found.steps);
                residual = residual.max(norm(&goal.gradient(&found.at, &found.power)));
            }
        }
    }
    assert!(worst[0] <= 12 && worst[1] <= 12, "{worst:?} {residual:e}");
    assert!(residual < 1e-13, "{residual:e} {worst:?}");
}

#[test]
fn every_search_on_points_ends_with_a_wrench_that_balances() {
    let at = |x, y, weight| Node { x, y, weight };
    let even = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[x, y]| at(x, y, 1.0));
    let uneven = [
        [0.0, 0.0, 1.0],
        [1.0, 0.1, 0.1],
        [-0.3, 1.0, 0.01],
        [0.0, -1.0, 3.0],
    ];
    let line = [-1.0, -0.25, 0.5, 1.0].map(|x| at(x, 0.0, 1.0));
    for nodes in [even, uneven.map(|[x, y, weight]| at(x, y, weight)), line] {
        let points = PointPatch::new(Nodes::new(nodes).unwrap()).unwrap();
        let surface = ShapeLimitSurface::new(points, 1.0).unwrap();
        for i in 0..10_000 {
            let narrow = libm::exp(12.0 * part(i, 0.671_043_606_7) - 12.0);
            let wrench = Vector3::new(
                part(i, 0.754_877_666_25),
                part(i, 0.569_840_290_99) * if i % 3 == 0 { narrow } else { 1.0 },
                part(i, 0.819_172_513_4) * if i % 3 == 1 { narrow } else { 1.0 },
            );
            let radial = GaugeObjective {
                wrench: wrench * (1.0 / norm(&wrench)),
            };
            let above = surface.above(&radial);
            let left = norm(&radial.gradient(&above.at, &above.power));
            assert!(above.steps <= 16 && left < 1e-12, "{wrench:?} {left:e}");
            // Up to 10¹² limits, with lengths of 10⁻³ … 10³ arms.
            let size = libm::pow(10.0, 6.0 + 6.0 * part(i, 0.445_041_867_9));
            let arms = libm::pow(10.0, 3.0 * part(i, 0.549_700_477_9));
            let far = radial.wrench * size;
            let far = Wrench::new(far.x, far.y, far.z * surface.arm);
            if let ProjectionCase::Back { goal, found, .. } =
                surface.project_outside(&far, arms * surface.arm)
            {
                let left = norm(&goal.gradient(&found.at, &found.power));
                assert!(left < 1e-7, "{far:?} {arms} {left:e}");
            }
        }
    }
}

#[test]
fn torques_far_beyond_points_have_their_nearest_wrench_for_long_lengths() {
    let nodes = [
        [0.634_9, -7.132_7, 0.509_99],
        [-1.175_3, -8.123_8, 0.525_18],
        [-5.205_5, -3.459_4, 0.493_39],
        [0.466_2, 4.975_4, 0.193_84],
    ]
    .map(|[x, y, weight]| Node { x, y, weight });
    let points = PointPatch::new(Nodes::new(nodes).unwrap()).unwrap();
    let surface = ShapeLimitSurface::new(points, 1.0).unwrap();
    for i in 0..4000 {
        let force = [part(i, 0.754_877_666_25), part(i, 0.569_840_290_99)];
        let length = surface.radius * libm::pow(10.0, 2.5 + 2.5 * part(i, 0.549_700_477_9));
        let torque = length * libm::pow(10.0, 2.0 + 2.0 * part(i, 0.445_041_867_9));
        let push = Wrench::new(force[0], force[1], torque);
        let near = surface.project_with_length(&push, length).wrench;
        // No wrench of the set is further along the way to what was asked for.
        let away = push - near;
        let twist = Twist::new(away.force.x, away.force.y, away.torque / (length * length));
        let (carried, most) = (near.power(&twist), surface.support(&twist));
        let lost = (most - carried) / most;
        assert!(lost <= 1e-8, "{push:?} {length:e}: {lost:e}");
    }
}

/// Projects wrenches onto the set of one triangle, from outside.
fn projections_stay<R: Real>(corners: [[f64; 3]; 3]) {
    let corners = corners.map(|[x, y, pressure]| {
        let [x, y, pressure] = [x, y, pressure].map(R::from_f64);
        Vertex { x, y, pressure }
    });
    let surface = ShapeLimitSurface::new(Mesh::new([corners]).unwrap(), R::ONE).unwrap();
    for i in 0..300 {
        let [x, y, torque] = [0.569_840_290_99, 0.445_041_867_9, 0.819_172_513_4]
            .map(|k| R::from_f64(3.0 * part(i, k)));
        let push = Wrench::new(x, y, torque * surface.radius);
        let once = surface.project(&push);
        let twice = surface.project(&once.wrench);
        assert!(surface.contains(&once.wrench), "{corners:?} {i}");
        assert_eq!(once.wrench, twice.wrench, "{corners:?} {i}");
    }
}

#[test]
fn projections_on_needles_of_a_mesh_stay() {
    // 200 times as long as wide, with a steep pressure.
    let needle = [
        [7.000_369_715_209_068, 7.283_936_634_342_219, 0.072],
        [4.416_798_850_636_358, 7.613_816_530_513_803, 0.141],
        [-7.198_836_496_332_012, 9.482_720_688_066_08, 0.948],
    ];
    projections_stay::<f64>(needle);
    for i in 1..40 {
        let width = libm::exp(-3.0 * (part(i, 0.671_043_606_7) + 1.0));
        let load = |turn: f64| 1.0 + part(i, turn);
        let corners = [
            [-0.9, -0.5 * width, load(0.569_840_290_99)],
            [0.8, -0.3 * width, load(0.445_041_867_9)],
            [0.2, 0.9 * width, load(0.819_172_513_4)],
        ];
        projections_stay::<f64>(corners);
        // Beyond, single precision does not know the needle's width.
        if width > 0.1 {
            projections_stay::<f32>(corners);
        }
    }
}
