//! Patches in the plane against tables of 130 and more digits, closed forms, and the other precision.

use super::shape::{PlaneLaw, Shape};
use super::{ALL, COEFFICIENT, Case, Family, LOAD, families, hold, once};
use nalgebra::{Matrix3, Vector2, Vector3};
use std::collections::BTreeSet;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::reference::Reference;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const COMPONENTS: [&str; 3] = ["force_x", "force_y", "torque"];
const HESSIAN: [[&str; 3]; 3] = [["xx", "xy", "xn"], ["xy", "yy", "yn"], ["xn", "yn", "nn"]];

/// The tables, and the column with the name of the shape.
const TABLES: [(&str, &str); 3] = [
    ("polygons.csv", "shape"),
    ("polygon_powers.csv", "shape"),
    ("meshes.csv", "mesh"),
];

fn optional(row: &Row<'_>, column: &str) -> Option<f64> {
    row.has(column).then(|| row.number(column))
}

/// The patch and law of a row, if they are of this family.
fn of_row(family: &Family, row: &Row<'_>, name: &str) -> Option<(Shape, PlaneLaw)> {
    let (_, shape) = family.shapes.iter().find(|(of, _)| of == row.text(name))?;
    let slope = ["slope_x", "slope_y"].map(|column| optional(row, column).unwrap_or(0.0));
    let shape = match (shape, slope == [0.0; 2]) {
        (Shape::Outline(outline, Some(_)), false) => Shape::Outline(outline.clone(), Some(slope)),
        (Shape::Outline(_, None) | Shape::Faces(_), true) => shape.clone(),
        _ => return None,
    };
    let law = optional(row, "alpha").map_or(PlaneLaw::Dry, PlaneLaw::Power);
    let kind = |law: PlaneLaw| match law {
        PlaneLaw::Dry => 0,
        PlaneLaw::Power(alpha) if (-0.5..=0.0).contains(&alpha) => 1,
        PlaneLaw::Power(alpha) if (0.0..=3.0).contains(&alpha) => 2,
        PlaneLaw::Power(_) => 3,
    };
    (kind(law) == kind(family.laws[0])).then_some((shape, law))
}

/// Errors of wrench and Jacobian under unit load and coefficient.
fn errors(row: &Row<'_>, case: &Case, twist: &Twist<f64>) -> [f64; 2] {
    let found = (case.at)(1.0, twist);
    let pace = case.speed(twist).powf(case.law.alpha());
    let scale = [1.0, 1.0, case.arm()];
    let mut of_wrench = 0.0_f64;
    for ((name, part), scale) in COMPONENTS
        .iter()
        .zip(Vector3::from(found.wrench).iter())
        .zip(scale)
    {
        of_wrench = of_wrench.max(row.reference(name).distance(*part) / (scale * pace));
    }
    let (mut of_jacobian, mut largest) = (0.0_f64, 0.0_f64);
    for (i, names) in HESSIAN.iter().enumerate() {
        for (j, name) in names.iter().enumerate() {
            let Reference { high, low } = row.reference(name);
            let expected = Reference {
                high: -high,
                low: -low,
            };
            let unit = scale[i] * scale[j];
            of_jacobian = of_jacobian.max(expected.distance(found.jacobian[(i, j)]) / unit);
            largest = largest.max(high.abs() / unit);
        }
    }
    let of_jacobian = of_jacobian / largest;
    // What the Jacobian of a falling law changes by if the centre of rotation moves by a rounding error.
    let moved = if case.law.alpha() < 0.0 {
        let pole = Vector2::new(-twist.velocity.y, twist.velocity.x) / twist.spin;
        let clearance = case.shape.clearance(&pole).max(f64::EPSILON);
        4.0 * f64::EPSILON * clearance.powf(case.law.alpha())
    } else {
        0.0
    };
    [of_wrench, (of_jacobian - moved).max(0.0)]
}

#[test]
fn wrenches_and_jacobians_are_those_of_130_digits() {
    let mut seen = BTreeSet::new();
    for family in families() {
        let names = ["wrench", "Jacobian"].map(|part| format!("{}, {part}", family.name));
        let mut worst = names.map(Worst::of);
        for (file, name) in TABLES {
            let table = Table::read(file);
            for (number, row) in table.rows().enumerate() {
                let Some((shape, law)) = of_row(&family, &row, name) else {
                    continue;
                };
                let case = Case::new(&family, (row.text(name), &shape), law, 1.0);
                let case = case.expect("a patch of the kernel");
                let [x, y, spin] = ["velocity_x", "velocity_y", "spin"].map(|of| row.number(of));
                let twist = Twist::new(x, y, spin);
                for (worst, error) in worst.iter_mut().zip(errors(&row, &case, &twist)) {
                    worst.see(error, || format!("{}, {law:?}, {twist:?}", case.name));
                }
                seen.insert((file, number));
            }
        }
        for (worst, bound) in worst.iter().zip(&family.bounds) {
            worst.assert_if_seen(bound);
        }
    }
    let rows: usize = TABLES
        .iter()
        .map(|(table, _)| Table::read(table).rows().count())
        .sum();
    assert_eq!(seen.len(), rows, "every row is of one family");
}

#[test]
fn single_precision_follows_double_precision() {
    let bounds = |family: &Family| family.single;
    hold("f32", 92, bounds, |case, rng, see| {
        let single = case.shape.friction::<f32>(case.law, COEFFICIENT);
        let single = single.expect("a patch of the kernel");
        for _ in 0..200 {
            let rounded = Vector3::from(case.anyhow(rng)).map(|part| part as f32);
            let twist = Twist::from(rounded.map(f64::from));
            let found = single(LOAD as f32, &Twist::from(rounded));
            let expected = (case.at)(LOAD, &twist);
            let wrench = Wrench::from(Vector3::from(found.wrench).map(f64::from));
            let jacobian = found.jacobian.map(f64::from);
            let errors = [
                case.apart(&twist, [&wrench, &expected.wrench]),
                case.jacobians_apart([&jacobian, &expected.jacobian]),
            ];
            see(errors.map(Some), &twist);
        }
    });
}

#[test]
fn sliding_alone_meets_the_whole_load_at_the_centre_of_pressure() {
    hold(
        "slide",
        ALL,
        |_| Some([tolerance::IDENTITY; 2]),
        |case, rng, see| {
            for _ in 0..50 {
                let twist = Twist {
                    spin: 0.0,
                    ..case.anyhow(rng)
                };
                let speed = twist.velocity.norm();
                let force = -twist.velocity / speed * case.limit(&twist);
                let torque = case.centre.x * force.y - case.centre.y * force.x;
                let found = (case.at)(LOAD, &twist).alone;
                let error = case.apart(&twist, [&found, &Wrench { force, torque }]);
                see([Some(error), None], &twist);
            }
        },
    );
}

#[test]
fn viscous_friction_has_the_moments_of_the_pressure() {
    hold(
        "viscous",
        37,
        |_| Some([tolerance::IDENTITY; 2]),
        |case, rng, see| {
            if case.law != PlaneLaw::Power(1.0) {
                return;
            }
            // Force and torque of v + ω × x, linear in both.
            let [x, y, xx, _, yy] = case.shape.moments();
            let damping = Matrix3::new(1.0, 0.0, -y, 0.0, 1.0, x, -y, x, xx + yy);
            let damping = damping * -(COEFFICIENT * LOAD);
            let at_rest = (case.at)(LOAD, &Twist::ZERO).jacobian;
            let error = case.jacobians_apart([&at_rest, &damping]);
            see([None, Some(error)], &Twist::ZERO);
            for _ in 0..100 {
                let twist = case.anyhow(rng);
                let found = (case.at)(LOAD, &twist);
                let wrench = Wrench::from(damping * Vector3::from(twist));
                let errors = [
                    case.apart(&twist, [&found.wrench, &wrench]),
                    case.jacobians_apart([&found.jacobian, &damping]),
                ];
                see(errors.map(Some), &twist);
            }
        },
    );
}

#[test]
fn the_small_torque_of_a_slow_spin_keeps_its_digits() {
    hold(
        "slow spin",
        46,
        |family| match family.name {
            "polygon" => Some([tolerance::SLOW_SPIN_DRY; 2]),
            _ => Some([tolerance::SLOW_SPIN; 2]),
        },
        |case, _, see| {
            // Elsewhere the centre of pressure is at the origin but for rounding.
            let is_centred = ["square", "centred"].contains(&case.name);
            if !is_centred && !matches!(case.shape, Shape::Round { .. })
                || case.centre.norm() > f64::EPSILON
            {
                return;
            }
            // To first order −ω ⟨r² + (α − 1) a²⟩ at unit speed, with the arm a of the velocity.
            let [_, _, xx, xy, yy] = case.shape.moments();
            let arm_sq = 0.64 * xx - 0.96 * xy + 0.36 * yy;
            let spread = xx + yy + (case.law.alpha() - 1.0) * arm_sq;
            for spin in [1e-300, 1e-200, 1e-30, 1e-9] {
                let twist = Twist::new(0.6, 0.8, spin / case.radius);
                let expected = -COEFFICIENT * LOAD * spread * twist.spin;
                let torque = (case.at)(LOAD, &twist).alone.torque;
                let error = (torque / expected - 1.0).abs() * (spread / (xx + yy)).abs();
                see([Some(error), None], &twist);
            }
        },
    );
}

#[test]
fn a_power_of_zero_is_dry_friction() {
    hold("power of zero", 39, once, |case, rng, see| {
        if case.law != PlaneLaw::Power(0.0) {
            return;
        }
        let dry = case.shape.friction::<f64>(PlaneLaw::Dry, COEFFICIENT);
        let dry = dry.expect("a patch of the kernel");
        for n in 0..400 {
            let twist = case.either(n, rng);
            let (found, expected) = ((case.at)(LOAD, &twist), dry(LOAD, &twist));
            let errors = [
                case.apart(&twist, [&found.wrench, &expected.wrench]),
                case.jacobians_apart([&found.jacobian, &expected.jacobian]),
            ];
            see(errors.map(Some), &twist);
        }
    });
}

/// Central differences, extrapolated to sixth order.
fn differences(case: &Case, twist: &Twist<f64>, step: f64) -> Matrix3<f64> {
    let units = Vector3::new(1.0, 1.0, 1.0 / case.arm());
    let central = |column: usize, step: f64| {
        let mut change = Vector3::zeros();
        change[column] = step * units[column];
        let end = |sign: f64| {
            let moved = Vector3::from(*twist) + change * sign;
            Vector3::from((case.at)(LOAD, &Twist::from(moved)).alone)
        };
        (end(1.0) - end(-1.0)) / (2.0 * change[column])
    };
    let columns = [0, 1, 2].map(|column| {
        let [coarse, middle, fine] = [1.0, 0.5, 0.25].map(|share| central(column, share * step));
        let (better, best) = ((middle * 4.0 - coarse) / 3.0, (fine * 4.0 - middle) / 3.0);
        (best * 16.0 - better) / 15.0
    });
    Matrix3::from_columns(&columns)
}

#[test]
fn differences_of_the_wrench_are_the_jacobian() {
    hold(
        "differences",
        ALL,
        |_| Some([tolerance::DIFFERENCES; 2]),
        |case, rng, see| {
            for _ in 0..20 {
                let (twist, clearance) = case.clear(rng);
                if clearance < 0.1 {
                    continue;
                }
                // The rim speed is 1: the centre of rotation moves by the step, in radii.
                let found = differences(case, &twist, clearance.min(1.0) / 64.0);
                let jacobian = (case.at)(LOAD, &twist).jacobian;
                let error = case.jacobians_apart([&found, &jacobian]);
                see([None, Some(error)], &twist);
            }
        },
    );
}

#[test]
fn the_moments_of_a_leaning_square_are_known() {
    let leaning = super::outlined(false, Some([0.4, -0.3]));
    let (_, shape) = leaning
        .iter()
        .find(|(name, _)| name == "square")
        .expect("a square");
    // The square of side 2, its corners √2 from the centre: means under 1 + s·x.
    let [x, y] = [0.4, -0.3].map(|slope| slope / 2.0_f64.sqrt() / 3.0);
    let expected = [x, y, 1.0 / 3.0, 0.0, 1.0 / 3.0];
    for (got, wanted) in shape.moments().iter().zip(expected) {
        assert!((got - wanted).abs() < 1e-15, "{got} {wanted}");
    }
}
