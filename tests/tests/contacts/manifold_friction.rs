//! Friction of contact manifolds: nearest point of the set, lanes, travel of thrown bodies.

use tribos_core::manifold_friction::{
    DirectionalLimitCurve, FrictionImpulse, FrictionLimits, InverseEffectiveMasses,
    IsotropicLimitCurve, LimitCurve, ManifoldArea, manifold_friction_in, project_friction,
};

/// Numbers in [0, 1) from Knuth's linear congruential generator.
struct Draw(u64);

impl Draw {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A power of ten between these.
    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(from + (to - from) * self.unit())
    }
}

/// Height over √(1 − x²) of a limit curve, from the documented end values 1 + c₀ and w.
fn curve(spinning: f64, slipping: f64) -> [f64; 3] {
    let (h1, h2) = (0.5 - 0.5 * spinning, -0.1126 + 0.1339 * slipping);
    [h1, h2, slipping.sqrt() - 1.0 - h1 - h2]
}

fn torque([h1, h2, h4]: [f64; 3], force: f64) -> f64 {
    let x_sq = force * force;
    (1.0 - x_sq).max(0.0).sqrt() * (1.0 + x_sq * (h1 + x_sq * (h2 + h4 * x_sq * x_sq)))
}

/// The nearest point by search: force and torque over their limits.
fn nearest(h: [f64; 3], weight: f64, [p, q]: [f64; 2]) -> [f64; 2] {
    let at = |angle: f64| [angle.sin(), torque(h, angle.sin())];
    // Difference of two squared distances without the part that both share.
    let farther = |[x, y]: [f64; 2], [u, v]: [f64; 2]| {
        (x - u) * (x + u - 2.0 * p) + weight * (y - v) * (y + v - 2.0 * q)
    };
    let grid = |n: usize| std::f64::consts::FRAC_PI_2 * n as f64 / 400.0;
    let mut best = 0;
    for n in 1..=400 {
        if farther(at(grid(n)), at(grid(best))) < 0.0 {
            best = n;
        }
    }
    let (mut low, mut high) = (grid(best.saturating_sub(1)), grid((best + 1).min(400)));
    for _ in 0..60 {
        let [one, two] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        if farther(at(one), at(two)) < 0.0 {
            high = two
        } else {
            low = one
        }
    }
    at(0.5 * (low + high))
}

/// Largest distance between results and the search, in limits, for mass ratios of 0.01 to 100.
fn worst_error<const STEPS: usize, O: LimitCurve<f32>>(h: [f64; 3], outline: &O) -> f64 {
    let mut draw = Draw(7);
    let mut worst = 0.0_f64;
    for n in 0..6000 {
        let weight = draw.decades(-2.0, 2.0);
        let candidate = if n % 2 == 0 {
            [draw.decades(-2.0, 4.0), draw.decades(-2.0, 4.0)]
        } else {
            let (angle, out) = (draw.unit() * 1.57, 1.0 + draw.decades(-6.0, 0.5));
            [angle.sin() * out, torque(h, angle.sin()) * out]
        };
        let [p, q] = candidate;
        if p < 1.0 && q <= torque(h, p) {
            continue;
        }
        // F = 2 N s, T = 0.1 N m s, k = 1/kg: kt T² = weight k F².
        let impulse = FrictionImpulse {
            tangential: [(1.2 * p) as f32, (1.6 * p) as f32],
            angular: (-0.1 * q) as f32,
        };
        let budget = FrictionLimits {
            impulse: 2.0,
            torsion_radius: 0.05,
            dynamic_over_static: 1.0,
        };
        let inverse = InverseEffectiveMasses {
            tangential: 1.0,
            angular: (weight * 400.0) as f32,
        };
        let carried = manifold_friction_in::<STEPS, _, _>(&impulse, &budget, &inverse, outline);
        let [x, y] = carried.tangential.map(f64::from);
        let [force, turn] = nearest(h, weight, candidate);
        worst =
            worst.max((x.hypot(y) / 2.0 - force).hypot(f64::from(carried.angular) / -0.1 - turn));
    }
    worst
}

fn in_all_directions(spinning: f32, slipping: f32) -> DirectionalLimitCurve<f32> {
    DirectionalLimitCurve {
        spinning: [spinning, 0.0, spinning],
        slipping: [slipping, 0.0, slipping],
    }
}

#[test]
fn the_result_is_the_nearest_point_of_the_set() {
    let area = (curve(1.49, 0.566), IsotropicLimitCurve::area());
    let points = ([-0.5203, 0.2304, 0.0135], IsotropicLimitCurve::points());
    let ellipsoid = worst_error::<2, _>([0.0; 3], &IsotropicLimitCurve::ellipsoid());
    let [of_area, of_points] = [area, points].map(|(h, outline)| worst_error::<2, _>(h, &outline));
    println!("two steps: area {of_area:.1e}, points {of_points:.1e}, ellipsoid {ellipsoid:.1e}");
    assert!(of_area < 5e-4 && of_points < 5e-4 && ellipsoid < 5e-4);
    let [of_area, of_points] = [area, points].map(|(h, outline)| worst_error::<3, _>(h, &outline));
    println!("three steps: area {of_area:.1e}, points {of_points:.1e}");
    assert!(of_area < 1e-5 && of_points < 1e-5);
    for (name, spinning, slipping, bound) in [
        ("plank 4 : 1 across", 1.91, 0.074, 3e-4),
        ("plank 4 : 1 along", 0.90, 1.185, 3e-4),
        ("plank 2 : 1 across", 1.754, 0.237, 3e-4),
        ("bar across", 1.99, 0.05, 3e-2),
    ] {
        let curve = curve(spinning, slipping);
        let error =
            worst_error::<3, _>(curve, &in_all_directions(spinning as f32, slipping as f32));
        println!("{name} {error:.1e}");
        assert!(error < bound, "{name} {error}");
    }
}

#[cfg(any(target_feature = "sse2", target_feature = "neon"))]
#[test]
fn lanes_have_the_bits_of_the_scalar() {
    use wide::f32x4;
    let mut draw = Draw(11);
    let plank =
        ManifoldArea::of_corners(&[[-0.1_f32, -0.025], [0.1, -0.02], [0.1, 0.03], [-0.1, 0.025]]);
    let wide_plank = DirectionalLimitCurve {
        spinning: plank.outline.spinning.map(f32x4::splat),
        slipping: plank.outline.slipping.map(f32x4::splat),
    };
    for _ in 0..50_000 {
        let mut number = || {
            let size = if draw.unit() < 0.1 {
                0.0
            } else {
                draw.decades(-9.0, 6.0)
            };
            (if draw.unit() < 0.5 { size } else { -size }) as f32
        };
        let lanes: [[f32; 7]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| number()));
        let side_by_side = |k: usize| f32x4::new(lanes.map(|lane| lane[k]));
        let (candidate, budget, inverse) = (
            FrictionImpulse {
                tangential: [side_by_side(0), side_by_side(1)],
                angular: side_by_side(2),
            },
            FrictionLimits {
                impulse: side_by_side(3).abs(),
                torsion_radius: side_by_side(4).abs(),
                dynamic_over_static: f32x4::splat(0.75),
            },
            InverseEffectiveMasses {
                tangential: side_by_side(5).abs(),
                angular: side_by_side(6).abs(),
            },
        );
        let compact = project_friction(&candidate, &budget, &inverse, &IsotropicLimitCurve::area());
        let directed = project_friction(&candidate, &budget, &inverse, &wide_plank);
        for (n, [p1, p2, twist, force, lever, k, kt]) in lanes.into_iter().enumerate() {
            let candidate = FrictionImpulse {
                tangential: [p1, p2],
                angular: twist,
            };
            let budget = FrictionLimits {
                impulse: force.abs(),
                torsion_radius: lever.abs(),
                dynamic_over_static: 0.75,
            };
            let inverse = InverseEffectiveMasses {
                tangential: k.abs(),
                angular: kt.abs(),
            };
            let one = project_friction(&candidate, &budget, &inverse, &IsotropicLimitCurve::area());
            same_bits(&one, &compact, n);
            let one = project_friction(&candidate, &budget, &inverse, &plank.outline);
            same_bits(&one, &directed, n);
        }
    }
}

#[cfg(any(target_feature = "sse2", target_feature = "neon"))]
fn same_bits(one: &FrictionImpulse<f32>, lanes: &FrictionImpulse<wide::f32x4>, n: usize) {
    let bits = |x: f32| {
        if x.is_nan() {
            f32::NAN.to_bits()
        } else {
            x.to_bits()
        }
    };
    let [p1, p2] = lanes.tangential.map(|p| p.to_array()[n]);
    let twist = lanes.angular.to_array()[n];
    assert_eq!(one.tangential.map(bits), [bits(p1), bits(p2)]);
    assert_eq!(bits(one.angular), bits(twist));
}

/// Travel in m of a body of 1 kg, half sides a and b, thrown along a at 1 m/s with this spin; μg = 3 m/s².
/// Steps of 0.1 ms whose friction is one projection from zero impulses.
fn travel([a, b]: [f64; 2], spin: f64) -> f64 {
    let area = ManifoldArea::of_corners(&[[-a, -b], [a, -b], [a, b], [-a, b]]);
    let (inertia, step) = ((a * a + b * b) / 3.0, 1e-4);
    let budget = FrictionLimits {
        impulse: 3.0 * step,
        torsion_radius: area.torsion_radius,
        dynamic_over_static: 1.0,
    };
    let inverse = InverseEffectiveMasses {
        tangential: 1.0,
        angular: 1.0 / inertia,
    };
    let (mut velocity, mut spin, mut angle, mut travel) = ([1.0_f64, 0.0], spin, 0.0_f64, 0.0);
    while velocity != [0.0, 0.0] || spin != 0.0 {
        let (sin, cos) = angle.sin_cos();
        let stopping = FrictionImpulse {
            tangential: [
                cos * velocity[0] + sin * velocity[1],
                cos * velocity[1] - sin * velocity[0],
            ],
            angular: inertia * spin,
        };
        let friction = project_friction(&stopping, &budget, &inverse, &area.outline);
        let [x, y] = friction.tangential;
        let (last, turned) = (velocity, spin);
        velocity = [last[0] - (cos * x - sin * y), last[1] - (sin * x + cos * y)];
        spin -= friction.angular / inertia;
        if friction == stopping {
            (velocity, spin) = ([0.0, 0.0], 0.0);
        }
        travel += 0.5 * step * (last[0] + velocity[0]);
        angle += 0.5 * step * (turned + spin);
    }
    travel
}

/// Spin in rad/s and exact travel in m: closed-form force and torque of a uniform rectangle, integrated by a
/// program of its own in steps of scale and direction; 4 digits.
const BOX: [(f64, f64); 4] = [
    (5.0, 0.1702),
    (12.5, 0.1898),
    (25.0, 0.2591),
    (50.0, 0.4413),
];
const PLANK: [(f64, f64); 4] = [
    (5.0, 0.1742),
    (12.5, 0.2167),
    (25.0, 0.3251),
    (50.0, 0.5700),
];

#[test]
fn thrown_boxes_and_planks_travel_as_far_as_their_areas_let_them() {
    for (sides, throws) in [([0.05, 0.05], BOX), ([0.1, 0.025], PLANK)] {
        for (spin, exact) in throws {
            let error = travel(sides, spin) / exact - 1.0;
            println!("{sides:?} {spin} rad/s: {:+.2} %", 100.0 * error);
            assert!(error.abs() < 0.01, "{sides:?} at {spin} rad/s: {error:+.4}");
        }
    }
}
