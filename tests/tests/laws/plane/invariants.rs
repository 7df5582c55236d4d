//! What friction of any patch in the plane obeys: dissipation, Euler's theorem, frames, cuts, units, and
//! numbers that are none.

use super::shape::{Frame, PlaneLaw, Shape};
use super::{ALL, COEFFICIENT, Family, LOAD, hold, once, twice};
use nalgebra::{Matrix2, SymmetricEigen, Vector2, Vector3};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::tolerance::{self, Bound};

/// Largest eigenvalue of the Jacobian of a falling law, of its largest entry: no rounding error.
const GAIN: f64 = 1e-11;

#[test]
fn friction_dissipates_and_its_jacobian_is_symmetric_and_alpha_times_the_wrench_along_the_twist() {
    hold(
        "Euler",
        ALL,
        |_| Some([tolerance::IDENTITY; 2]),
        |case, rng, see| {
            let alpha = case.law.alpha();
            for n in 0..200 {
                let twist = case.either(n, rng);
                let found = (case.at)(LOAD, &twist);
                assert_eq!(found.alone, found.wrench, "{} {twist:?}", case.family.name);
                assert!(
                    found.wrench.power(&twist) < 0.0,
                    "{} {twist:?}",
                    case.family.name
                );
                assert_eq!(found.jacobian, found.jacobian.transpose());
                let even = case.even(&found.jacobian);
                // Friction is homogeneous of degree α in the twist.
                let unit = Vector3::new(1.0, 1.0, case.arm());
                let along = Vector3::from(twist).component_mul(&unit);
                let rate = even * along - Vector3::from(found.wrench).component_div(&unit) * alpha;
                let euler = rate.amax() / (3.0 * even.amax() * along.amax());
                // It damps unless the law falls with the speed: then the twist itself gains.
                let most = SymmetricEigen::new(even).eigenvalues.max() / even.amax();
                assert!(
                    alpha >= 0.0 || most > GAIN,
                    "{} {twist:?}",
                    case.family.name
                );
                // Dry friction is at most that of all elements in one direction.
                let is_largest = alpha == 0.0;
                let most_force = case.limit(&twist) * (1.0 + case.family.bounds[0].limit);
                assert!(
                    !is_largest || found.wrench.force.norm() <= most_force,
                    "{} {twist:?}",
                    case.name
                );
                let gain = if alpha < 0.0 { 0.0 } else { most.max(0.0) };
                see([None, Some(euler.max(gain))], &twist);
            }
        },
    );
}

#[test]
fn a_patch_in_another_frame_has_the_same_friction() {
    let turn = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        Matrix2::new(cos, -sin, sin, cos)
    };
    let mirror = Matrix2::new(1.0, 0.0, 0.0, -1.0);
    let frames = [
        (turn(2.1), Vector2::zeros()),
        (turn(-0.7) * mirror, Vector2::zeros()),
        (turn(0.4), Vector2::new(0.75, -0.5)),
    ];
    hold("frames", ALL, framed, |case, rng, see| {
        for (turn, shift) in frames {
            let shift = shift * case.radius;
            let frame = Frame { turn, shift };
            let Some(shape) = case.shape.moved(&frame) else {
                continue;
            };
            let there = shape
                .friction::<f64>(case.law, COEFFICIENT)
                .expect("as here");
            let back = frame.of_wrenches();
            for _ in 0..50 {
                let (twist, clearance) = case.clear(rng);
                let here = (case.at)(LOAD, &twist);
                let motion =
                    back.transpose().try_inverse().expect("a frame") * Vector3::from(twist);
                let there = there(LOAD, &Twist::from(motion));
                let undo = back.try_inverse().expect("a frame");
                let wrench = Wrench::from(undo * Vector3::from(there.wrench));
                let jacobian = undo * there.jacobian * undo.transpose();
                // Next to a kink friction is as uncertain as the centre of rotation over their distance.
                let sharp = clearance.min(1.0);
                let errors = [
                    case.apart(&twist, [&wrench, &here.wrench]) * sharp,
                    case.jacobians_apart([&jacobian, &here.jacobian]) * sharp,
                ];
                see(errors.map(Some), &twist);
            }
        }
    });
}

/// Both sides of a comparison may be wrong, but for round patches in the same way.
fn framed(family: &Family) -> Option<[Bound; 2]> {
    let [wrench, jacobian] = twice(family)?;
    let is_round = matches!(family.shapes[0].1, Shape::Round { .. });
    let turned = tolerance::ROUND_TURNED_JACOBIAN;
    Some([wrench, if is_round { turned } else { jacobian }])
}

/// Both sides of the comparison are wrong where a plank or a dome makes that add up.
fn of_pieces(family: &Family) -> Option<[Bound; 2]> {
    match family.name {
        "falling law, polygon" | "layer, leaning across" | "mesh" => twice(family),
        _ => once(family),
    }
}

#[test]
fn a_patch_in_more_pieces_is_the_same_patch() {
    // Bars and round patches are whole.
    hold("cut", ALL - 34, of_pieces, |case, rng, see| {
        let Some(shape) = case.shape.cut() else {
            return;
        };
        let cut = shape
            .friction::<f64>(case.law, COEFFICIENT)
            .expect("as the whole");
        for n in 0..100 {
            let twist = case.either(n, rng);
            let (found, whole) = (cut(LOAD, &twist), (case.at)(LOAD, &twist));
            let errors = [
                case.apart(&twist, [&found.wrench, &whole.wrench]),
                case.jacobians_apart([&found.jacobian, &whole.jacobian]),
            ];
            see(errors.map(Some), &twist);
        }
    });
}

/// 2^`exponent`, of the whole range.
fn power_of_two(exponent: i32) -> f64 {
    2_f64.powi(exponent / 2) * 2_f64.powi(exponent - exponent / 2)
}

#[test]
fn speeds_at_the_ends_of_the_range_scale_the_friction() {
    hold(
        "ends of the range",
        303,
        |_| Some([tolerance::UNITS, tolerance::UNITS_JACOBIAN]),
        |case, _, see| {
            let alpha = case.law.alpha();
            for twist in [Twist::new(0.75, -0.5, 0.625), Twist::new(3.0, 1.0, 0.03125)] {
                let usual = (case.at)(LOAD, &twist);
                // Multiples of four, so that quarters of exponents are powers of two as well, and the largest even one.
                for exponent in [-1040, -1000, -700, -400, 400, 700, 1020, 1022] {
                    let (degree, at) = (f64::from(exponent) * alpha, f64::from(exponent));
                    // Speeds of nodes and of the rim lose digits below the normal range.
                    let is_lost = exponent < -1000
                        && matches!(case.shape, Shape::Round { .. } | Shape::Nodes(_));
                    if is_lost || degree.fract() != 0.0 || degree.abs() > 900.0 {
                        continue;
                    }
                    let pace = power_of_two(degree as i32);
                    let found = (case.at)(LOAD, &(twist * power_of_two(exponent)));
                    let wrench = found.wrench * (1.0 / pace);
                    let slopes = (degree - at).abs() <= 1000.0;
                    let slopes = slopes.then(|| {
                        let scaled = found.jacobian * power_of_two(exponent - degree as i32);
                        case.jacobians_apart([&scaled, &usual.jacobian])
                    });
                    let error = case.apart(&twist, [&wrench, &usual.wrench]);
                    see([Some(error), slopes], &twist);
                }
            }
        },
    );
}

#[test]
fn rest_is_rest_and_what_is_no_number_stays_none() {
    hold("rest and NaN", ALL, once, |case, _, see| {
        let name = case.family.name;
        let rest = (case.at)(LOAD, &Twist::ZERO);
        assert!(
            rest.alone == Wrench::ZERO && rest.wrench == Wrench::ZERO,
            "{name}"
        );
        assert!(rest.jacobian.iter().all(|entry| !entry.is_nan()), "{name}");
        // Shapes have no damping at rest that is not the law's own.
        if let Shape::Outline(..) | Shape::Faces(_) | Shape::Bar(_) = case.shape {
            assert_eq!(
                rest.jacobian.amax() == 0.0,
                case.law != PlaneLaw::Power(1.0),
                "{name}"
            );
        }
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            // Round patches have limits where one speed is infinite.
            if matches!(case.shape, Shape::Round { .. }) && !bad.is_nan() {
                continue;
            }
            for twist in [
                Twist::new(bad, 0.0, 1.0),
                Twist::new(0.0, bad, 0.0),
                Twist::new(1.0, 0.0, bad),
            ] {
                let found = (case.at)(LOAD, &twist);
                for wrench in [found.alone, found.wrench] {
                    assert!(
                        Vector3::from(wrench).iter().all(|part| part.is_nan()),
                        "{name}, {twist:?}"
                    );
                }
                assert!(
                    found.jacobian.iter().all(|part| part.is_nan()),
                    "{name}, {twist:?}"
                );
            }
        }
        let moving = Twist::new(1.0, 0.0, 1.0);
        assert!(
            (case.at)(f64::NAN, &moving).alone.force.x.is_nan(),
            "{name}"
        );
        see([None; 2], &moving);
    });
}
