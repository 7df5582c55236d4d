use super::*;

/// Moments of a square of half side 1: ⟨r⟩ = (√2 + arsinh 1)/3, ⟨x²⟩ = 1/3, ⟨x²/r³⟩ = arsinh 1.
#[test]
fn a_square_has_its_closed_moments() {
    let arsinh = 1.0_f64.asinh();
    let mean = (2.0_f64.sqrt() + arsinh) / 3.0;
    for corners in [
        [[4.0, 5.0], [6.0, 5.0], [6.0, 7.0], [4.0, 7.0]],
        [[4.0, 7.0], [6.0, 7.0], [6.0, 5.0], [4.0, 5.0]],
    ] {
        let square = ManifoldArea::<f64>::of_corners(&corners);
        assert!((square.centre[0] - 5.0).abs() < 1e-14 && (square.centre[1] - 6.0).abs() < 1e-14);
        assert!(
            (square.torsion_radius / mean - 1.0).abs() < 1e-9,
            "{}",
            square.torsion_radius
        );
        let DirectionalLimitCurve {
            spinning: [a, b, c],
            slipping: [u, v, w],
        } = square.outline;
        assert!((a * mean * arsinh - 1.0).abs() < 1e-8 && (c - a).abs() < 1e-12 && b.abs() < 1e-12);
        assert!(
            (u * mean * mean - 1.0 / 3.0).abs() < 1e-9 && (w - u).abs() < 1e-12 && v.abs() < 1e-12
        );
    }
}

/// Midpoint sums over a triangle turned in its plane.
#[test]
fn a_triangle_has_the_moments_of_its_points() {
    let corners = [[0.3, -0.2], [1.1, 0.5], [-0.4, 0.9]];
    let triangle = ManifoldArea::<f64>::of_corners(&corners);
    let (mut count, mut mean, mut slipping, mut spinning) = (0.0, 0.0, [0.0; 3], [0.0; 3]);
    const N: usize = 1500;
    for i in 0..N {
        for j in 0..N - i {
            let (u, v) = (
                (i as f64 + 1.0 / 3.0) / N as f64,
                (j as f64 + 1.0 / 3.0) / N as f64,
            );
            let at = |k: usize| {
                (1.0 - u - v) * corners[0][k] + u * corners[1][k] + v * corners[2][k]
                    - triangle.centre[k]
            };
            let (x, y) = (at(0), at(1));
            let r = x.hypot(y);
            count += 1.0;
            mean += r;
            for (k, product) in [x * x, x * y, y * y].into_iter().enumerate() {
                slipping[k] += product;
                spinning[k] += product / (r * r * r);
            }
        }
    }
    mean /= count;
    assert!((triangle.torsion_radius / mean - 1.0).abs() < 1e-3);
    let [xx, xy, yy] = spinning.map(|sum| sum / count);
    let det = (xx * yy - xy * xy) * mean;
    for (ours, theirs) in triangle
        .outline
        .spinning
        .into_iter()
        .zip([yy / det, -xy / det, xx / det])
    {
        assert!((ours - theirs).abs() < 5e-3, "{ours} {theirs}");
    }
    for (ours, theirs) in triangle
        .outline
        .slipping
        .into_iter()
        .zip(slipping.map(|s| s / count / mean / mean))
    {
        assert!((ours - theirs).abs() < 2e-3, "{ours} {theirs}");
    }
}

#[test]
fn few_corners_are_a_line_or_a_point() {
    let line = ManifoldArea::<f32>::of_corners(&[[1.0, 1.0], [1.0, 5.0]]);
    assert_eq!((line.centre, line.torsion_radius), ([1.0, 3.0], 1.0));
    assert_eq!(
        ManifoldArea::<f32>::of_corners(&[[1.0, 1.0], [1.0, 3.0], [1.0, 5.0]]),
        line
    );
    assert_eq!(
        ManifoldArea::<f32>::of_corners(&[[1.0, 1.0]]).torsion_radius,
        0.0
    );
    assert_eq!(ManifoldArea::<f32>::of_corners(&[]).torsion_radius, 0.0);
    assert!(
        ManifoldArea::<f32>::of_corners(&[[f32::NAN, 1.0], [1.0, 3.0], [0.0, 0.0]])
            .torsion_radius
            .is_nan()
    );
}

#[test]
fn one_budget_without_twist_is_coulombs() {
    let inverse = InverseEffectiveMasses {
        tangential: 1.0_f32,
        angular: 10.0,
    };
    let budget = FrictionLimits {
        impulse: 2.0,
        torsion_radius: 0.1,
        dynamic_over_static: 1.0,
    };
    let slides = FrictionImpulse {
        tangential: [30.0, -40.0],
        angular: 0.0,
    };
    let carried = project_friction(&slides, &budget, &inverse, &IsotropicLimitCurve::area());
    assert!(
        (carried.tangential[0] - 1.2).abs() < 1e-6 && (carried.tangential[1] + 1.6).abs() < 1e-6
    );
    assert_eq!(carried.angular, 0.0);
    let spins = FrictionImpulse {
        tangential: [0.0, 0.0],
        angular: -7.0,
    };
    let carried = project_friction(&spins, &budget, &inverse, &IsotropicLimitCurve::area());
    assert!((carried.angular + 0.2).abs() < 1e-7);
    assert_eq!(carried.tangential, [0.0, 0.0]);
}

#[test]
fn static_friction_holds_more_than_it_carries_in_motion() {
    let inverse = InverseEffectiveMasses {
        tangential: 1.0_f32,
        angular: 10.0,
    };
    let budget = FrictionLimits {
        impulse: 1.0,
        torsion_radius: 0.1,
        dynamic_over_static: 0.5,
    };
    let held = FrictionImpulse {
        tangential: [1.9, 0.0],
        angular: 0.0,
    };
    assert_eq!(
        project_friction(&held, &budget, &inverse, &IsotropicLimitCurve::area()),
        held
    );
    let moved = FrictionImpulse {
        tangential: [2.1, 0.0],
        angular: 0.0,
    };
    let carried = project_friction(&moved, &budget, &inverse, &IsotropicLimitCurve::area());
    assert!((carried.tangential[0] - 1.0).abs() < 1e-6);
}

#[test]
fn one_point_has_no_torque_and_no_load_no_friction() {
    let inverse = InverseEffectiveMasses {
        tangential: 1.0_f32,
        angular: 10.0,
    };
    let candidate = FrictionImpulse {
        tangential: [0.5, 0.0],
        angular: 3.0,
    };
    let point = FrictionLimits {
        impulse: 1.0,
        torsion_radius: 0.0,
        dynamic_over_static: 1.0,
    };
    let carried = project_friction(&candidate, &point, &inverse, &IsotropicLimitCurve::area());
    assert_eq!((carried.tangential, carried.angular), ([0.5, 0.0], 0.0));
    let none = FrictionLimits {
        impulse: 0.0,
        ..point
    };
    let carried = project_friction(&candidate, &none, &inverse, &IsotropicLimitCurve::points());
    assert_eq!((carried.tangential, carried.angular), ([0.0, 0.0], 0.0));
    let nan = FrictionImpulse {
        tangential: [f32::NAN, 0.0],
        angular: 3.0,
    };
    let carried = project_friction(
        &nan,
        &FrictionLimits {
            torsion_radius: 0.1,
            ..point
        },
        &inverse,
        &IsotropicLimitCurve::area(),
    );
    assert!(carried.tangential[0].is_nan() && carried.angular.is_nan());
}
