//! The limit surface of patches of any shape: pushes and motions, projection, derivatives, extremes.

use nalgebra::{Matrix3, Vector3};
use tribos_core::contact::TimeStep;
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::outlines::outlines;
use tribos_tests::sweep::Lcg;

const LIMIT: f64 = 0.51;

type Surface = ShapeLimitSurface<f64, Polygon<f64, Vec<Edge<f64>>>>;

fn surfaces() -> Vec<(String, Surface)> {
    let surface = |patch| ShapeLimitSurface::new(patch, LIMIT).expect("valid");
    outlines()
        .iter()
        .filter(|outline| outline.name != "sliver")
        .map(|outline| (outline.name.clone(), surface(outline.patch())))
        .collect()
}

/// A wrench in any direction, at times next to an axis, of roughly this size.
fn anyhow(rng: &mut Lcg, surface: &Surface, size: f64) -> Wrench<f64> {
    let mut part = || {
        let part = rng.between(-1.0, 1.0);
        if rng.between(0.0, 1.0) < 0.25 {
            part * 10_f64.powf(rng.between(-8.0, 0.0))
        } else {
            part
        }
    };
    let unit = size * LIMIT;
    Wrench::new(
        unit * part(),
        unit * part(),
        size * surface.torque_limit() * part(),
    )
}

#[test]
fn derivatives_are_those_of_differences() {
    let mut rng = Lcg::new(3);
    let step = 1e-5;
    for (name, surface) in surfaces() {
        let arm = surface.torque_limit() / LIMIT;
        let length = 0.8 * arm;
        let axes = [
            (LIMIT, 0.0, 0.0),
            (0.0, LIMIT, 0.0),
            (0.0, 0.0, LIMIT * arm),
        ];
        let axes = axes.map(|(x, y, n)| Wrench::new(x, y, n) * step);
        for _ in 0..60 {
            let wrench = anyhow(&mut rng, &surface, 3.0);
            // Next to the zero wrench the gauge has a tip.
            if surface.gauge(&wrench) < 0.3 {
                continue;
            }
            let (normal, hessian) = surface.gauge_derivatives(&wrench);
            let (projection, rate) = surface.project_with_jacobian(&wrench, length);
            assert_eq!(projection, surface.project_with_length(&wrench, length));
            let near_border = (surface.gauge(&wrench) - 1.0).abs() < 0.05;
            for axis in axes {
                let [ahead, behind] = [wrench + axis, wrench - axis];
                let change = surface.gauge(&ahead) - surface.gauge(&behind);
                let expected = 2.0 * axis.power(&normal);
                assert!(
                    (change - expected).abs() < 1e-6 * step,
                    "{name} {wrench:?} {change} {expected}"
                );
                let along = Vector3::new(axis.force.x, axis.force.y, axis.torque);
                let turned =
                    surface.gauge_derivatives(&ahead).0 - surface.gauge_derivatives(&behind).0;
                let expected = hessian * along * 2.0;
                let unit = Vector3::new(LIMIT, LIMIT, LIMIT * arm);
                let turned = Vector3::new(turned.velocity.x, turned.velocity.y, turned.spin);
                let error = (turned - expected).component_mul(&unit).amax();
                assert!(error < 2e-4 * step, "{name} {wrench:?} {error}");
                if !near_border {
                    let carried = surface.project_with_length(&ahead, length).wrench
                        - surface.project_with_length(&behind, length).wrench;
                    let carried = Vector3::new(carried.force.x, carried.force.y, carried.torque);
                    let error = (carried - rate * along * 2.0).component_div(&unit).amax();
                    assert!(error < 2e-4 * step, "{name} {wrench:?} {error}");
                }
            }
        }
    }
}

#[test]
fn the_surface_of_a_square_passes_through_its_closed_forms() {
    let square =
        Polygon::new([[-1.0_f64, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).expect("valid");
    let surface = ShapeLimitSurface::new(square, 1.0).expect("valid");
    let spinning = (2.0_f64.sqrt() + 1.0_f64.asinh()) / 3.0;
    assert!((surface.torque_limit() - spinning).abs() < 1e-15);
    assert!((surface.gauge(&Wrench::new(0.6, 0.8, 0.0)) - 1.0).abs() < 1e-15);
    assert!((surface.gauge(&Wrench::new(0.0, 0.0, spinning)) - 1.0).abs() < 1e-15);
    let straight = surface.twist_normal_to(&Wrench::new(0.6, 0.8, 0.0));
    assert!((straight.velocity.x - 0.6).abs() < 1e-14 && straight.spin.abs() < 1e-14);
    let inside = surface.project_with_jacobian(&Wrench::new(0.1, 0.1, 0.1), 1.0);
    assert_eq!(inside.1, Matrix3::identity());
}

#[test]
fn a_box_on_a_table_sticks_to_the_last_bit_and_slides_no_further_than_it_must() {
    let (a, b) = (0.1, 0.05);
    let patch = Polygon::new([[-a, -b], [a, -b], [a, b], [-a, b]]).expect("valid");
    let table = ShapeLimitSurface::new(patch, 3.0).expect("valid");
    let body = PlanarBody::new(1.0, (a * a + b * b) / 3.0).expect("valid");
    let dt = TimeStep::new(1.0 / 240.0).expect("valid");
    let held = body.step(&table, &Twist::ZERO, &Wrench::new(2.0, 0.0, 0.05), dt);
    assert!(held.is_at_rest && held.twist == Twist::ZERO);
    let mut twist = Twist::new(1.0, 0.3, 12.0);
    let mut steps = 0;
    while twist != Twist::ZERO {
        let after = body.step(&table, &twist, &Wrench::ZERO, dt).twist;
        let energy = |t: &Twist<f64>| t.velocity.norm_squared() + body.inertia() * t.spin * t.spin;
        assert!(energy(&after) < energy(&twist));
        twist = after;
        steps += 1;
        assert!(steps < 1000);
    }
}

#[test]
fn without_force_limit_nothing_is_carried() {
    let (_, surface) = surfaces().swap_remove(0);
    let none = ShapeLimitSurface::new(surface.patch(), 0.0).expect("valid");
    let push = Wrench::new(0.1, 0.2, 0.3);
    assert_eq!(none.gauge(&push), f64::INFINITY);
    assert_eq!(none.project(&push).wrench, Wrench::ZERO);
    assert!(ShapeLimitSurface::new(surface.patch(), -1.0).is_err());
    let nowhere = surface.project_with_length(&push, 0.0).wrench;
    assert!(nowhere.torque.is_nan());
}

#[test]
fn huge_wrenches_are_brought_to_the_surface_and_infinite_ones_move_nothing() {
    let (_, surface) = surfaces().swap_remove(0);
    let carried = surface.project(&Wrench::new(1e299, 2e299, 3e299)).wrench;
    assert!((surface.gauge(&carried) - 1.0).abs() < 1e-13);
    for infinite in [f64::INFINITY, f64::NEG_INFINITY] {
        let push = Wrench::new(0.1, infinite, 0.0);
        assert!(surface.twist_normal_to(&push).spin.is_nan());
    }
}
