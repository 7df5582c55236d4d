//! Power laws on polygons: against line integrals of 130 digits, dry friction, and their invariants.

use nalgebra::{Matrix3, SymmetricEigen, Vector2, Vector3};
use tribos_core::Real;
use tribos_core::coupling::flat::{
    PatchShape, PolygonPowerLaw, PowerLawPatch, ShapeFriction, ShapePowerFriction,
};
use tribos_core::law::LawError;
use tribos_core::patch::outline::Polygon;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};
use tribos_tests::outlines::{Outline, outlines};
use tribos_tests::reference::Reference;
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const COMPONENTS: [&str; 3] = ["force_x", "force_y", "torque"];
const HESSIAN: [[&str; 3]; 3] = [["xx", "xy", "xn"], ["xy", "yy", "yn"], ["xn", "yn", "nn"]];

fn friction<R: Real, P: PowerLawPatch<R>>(patch: P, alpha: f64) -> ShapePowerFriction<R, P> {
    let power = PolygonPowerLaw::new(R::from_f64(alpha)).expect("valid");
    ShapePowerFriction::new(patch, R::ONE, power).expect("valid")
}

/// Speed of the centre of pressure plus rim speed, and the patch's reach from the origin.
fn scales(patch: &impl PatchShape<f64>, twist: &Twist<f64>) -> (f64, f64) {
    let (centre, radius) = (patch.centre(), patch.radius());
    let velocity = twist.velocity + Vector2::new(-centre.y, centre.x) * twist.spin;
    let speed = velocity.norm() + (twist.spin * radius).abs();
    (speed, radius + centre.norm())
}

/// Distance of the centre of rotation from the nearest edge, in radii; no less than its rounding.
fn apart(outline: &Outline, radius: f64, twist: &Twist<f64>) -> f64 {
    let centre = Vector2::new(-twist.velocity.y, twist.velocity.x) / twist.spin;
    let mut least = f64::INFINITY;
    for corners in &outline.loops {
        for (i, &from) in corners.iter().enumerate() {
            let (from, to) = (from.into(), corners[(i + 1) % corners.len()].into());
            let (from, to): (Vector2<f64>, Vector2<f64>) = (from, to);
            let share = (centre - from).dot(&(to - from)) / (to - from).norm_squared();
            least = least.min((from + (to - from) * share.clamp(0.0, 1.0) - centre).norm());
        }
    }
    (least / radius).max(f64::EPSILON)
}

fn twist_of(row: &Row<'_>) -> Twist<f64> {
    let [x, y, spin] = ["velocity_x", "velocity_y", "spin"].map(|name| row.number(name));
    Twist::new(x, y, spin)
}

/// Errors of one row: of the scale of the wrench, and of the largest entry of the Jacobian with the
/// reach as the unit of length.
fn errors(
    row: &Row<'_>,
    patch: &impl PatchShape<f64>,
    (wrench, jacobian): (Wrench<f64>, WrenchJacobian<f64>),
) -> [f64; 2] {
    let (speed, arm) = scales(patch, &twist_of(row));
    let pace = speed.powf(row.number("alpha"));
    let scale = [1.0, 1.0, arm];
    let mut of_wrench: f64 = 0.0;
    let parts = [wrench.force.x, wrench.force.y, wrench.torque];
    for ((name, part), scale) in COMPONENTS.iter().zip(parts).zip(scale) {
        of_wrench = of_wrench.max(row.reference(name).distance(part) / (scale * pace));
    }
    let (mut of_jacobian, mut largest): (f64, f64) = (0.0, 0.0);
    for (i, names) in HESSIAN.iter().enumerate() {
        for (j, name) in names.iter().enumerate() {
            let Reference { high, low } = row.reference(name);
            let expected = Reference {
                high: -high,
                low: -low,
            };
            let unit = scale[i] * scale[j];
            of_jacobian = of_jacobian.max(expected.distance(jacobian[(i, j)]) / unit);
            largest = largest.max(high.abs() / unit);
        }
    }
    [of_wrench, of_jacobian / largest]
}

fn found(outline: &Outline, row: &Row<'_>) -> [f64; 2] {
    let (twist, alpha) = (twist_of(row), row.number("alpha"));
    let slope = ["slope_x", "slope_y"].map(|name| row.number(name));
    let patch = outline.patch::<f64>();
    let met = if slope == [0.0; 2] {
        friction(&patch, alpha).wrench_and_jacobian(1.0, &twist)
    } else {
        let patch = patch.clone().with_slope(slope).expect("carried");
        let met = friction(&patch, alpha).wrench_and_jacobian(1.0, &twist);
        return errors(row, &patch, met);
    };
    errors(row, &patch, met)
}

#[test]
fn the_wrench_and_the_jacobian_are_those_of_130_digits() {
    let table = Table::read("polygon_powers.csv");
    let outlines = outlines();
    let mut worst = [
        ("−1/2 ≤ α ≤ 3, uniform, wrench", tolerance::POLYGON_POWER),
        (
            "−1/2 ≤ α ≤ 3, uniform, Jacobian",
            tolerance::POLYGON_POWER_JACOBIAN,
        ),
        (
            "−1/2 ≤ α ≤ 3, linear, wrench",
            tolerance::POLYGON_POWER_LINEAR,
        ),
        (
            "−1/2 ≤ α ≤ 3, linear, Jacobian",
            tolerance::POLYGON_POWER_LINEAR_JACOBIAN,
        ),
        ("other α, wrench", tolerance::POLYGON_POWER_ENDS),
        ("other α, Jacobian", tolerance::POLYGON_POWER_ENDS_JACOBIAN),
    ]
    .map(|(name, bound)| (Worst::of(name), bound));
    for (number, row) in table.rows().enumerate() {
        let (name, alpha) = (row.text("shape"), row.number("alpha"));
        let outline = outlines.iter().find(|one| one.name == name).expect(name);
        let twist = twist_of(&row);
        let [wrench, jacobian] = found(outline, &row);
        let is_uniform = row.number("slope_x") == 0.0 && row.number("slope_y") == 0.0;
        let first = match (-0.5..=3.0).contains(&alpha) {
            true if is_uniform => 0,
            true => 2,
            false => 4,
        };
        let place = || format!("{name}, row {number}, alpha {alpha}, {twist:?}");
        worst[first].0.see(wrench, place);
        // What the Jacobian changes by if the centre of rotation moves by a rounding error.
        let moved = if alpha < 0.0 {
            let apart = apart(outline, outline.patch::<f64>().radius(), &twist);
            4.0 * f64::EPSILON * apart.powf(alpha)
        } else {
            0.0
        };
        worst[first + 1].0.see((jacobian - moved).max(0.0), place);
    }
    for (worst, bound) in &worst {
        worst.assert_within(bound);
    }
}

/// A twist whose centre of rotation is anywhere from the patch to 10⁶ radii away, at any speed.
fn anyhow(rng: &mut Lcg, patch: &impl PatchShape<f64>) -> Twist<f64> {
    let speed = 10_f64.powf(rng.between(-3.0, 3.0));
    let turn = speed / patch.radius() * 10_f64.powf(rng.between(-6.0, 1.0));
    let angle = rng.between(0.0, core::f64::consts::TAU);
    let sense = if rng.between(-1.0, 1.0) < 0.0 {
        -1.0
    } else {
        1.0
    };
    Twist::new(speed * angle.cos(), speed * angle.sin(), sense * turn)
}

/// The matrix with `arm` as the unit of length.
fn even(jacobian: &Matrix3<f64>, arm: f64) -> Matrix3<f64> {
    let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / arm));
    unit * jacobian * unit
}

fn distance(a: &Wrench<f64>, b: &Wrench<f64>, arm: f64) -> f64 {
    let force = (a.force - b.force).amax();
    force.max((a.torque - b.torque).abs() / arm)
}

/// Errors where α = 0, of the load and of the largest entry of the Jacobian.
fn from_dry<P: PowerLawPatch<f64>>(patch: P, twist: &Twist<f64>, arm: f64) -> [f64; 2] {
    let (wrench, jacobian) = friction(&patch, 0.0).wrench_and_jacobian(1.0, twist);
    let dry = ShapeFriction::new(&patch, 1.0).expect("valid");
    let (expected, of_dry) = dry.wrench_and_jacobian(1.0, twist);
    let of_dry = even(&of_dry, arm);
    let error = (even(&jacobian, arm) - of_dry).amax() / of_dry.amax();
    [distance(&wrench, &expected, arm), error]
}

#[test]
fn without_an_exponent_it_is_dry_friction() {
    let mut worst = [
        ("α = 0, uniform, wrench", tolerance::POLYGON_POWER),
        (
            "α = 0, uniform, Jacobian",
            tolerance::POLYGON_POWER_JACOBIAN,
        ),
        ("α = 0, linear, wrench", tolerance::POLYGON_POWER_LINEAR),
        (
            "α = 0, linear, Jacobian",
            tolerance::POLYGON_POWER_LINEAR_JACOBIAN,
        ),
    ]
    .map(|(name, bound)| (Worst::of(name), bound));
    let mut rng = Lcg::new(1);
    for outline in outlines().iter().filter(|outline| outline.name != "sliver") {
        let patch = outline.patch::<f64>();
        let slope = 0.5 / patch.radius();
        let tilted = patch
            .clone()
            .with_slope([slope, -0.5 * slope])
            .expect("carried");
        let arm = patch.radius() + patch.centre().norm();
        for _ in 0..1000 {
            let twist = anyhow(&mut rng, &patch);
            let [a, b] = from_dry(&patch, &twist, arm);
            let [c, d] = from_dry(&tilted, &twist, arm);
            for ((worst, _), error) in worst.iter_mut().zip([a, b, c, d]) {
                worst.see(error, || format!("{}, {twist:?}", outline.name));
            }
        }
    }
    for (worst, bound) in &worst {
        worst.assert_within(bound);
    }
}

#[test]
fn viscous_friction_is_a_polynomial() {
    let mut rng = Lcg::new(2);
    for outline in outlines().iter().filter(|outline| outline.name != "sliver") {
        let patch = outline.patch::<f64>();
        let viscous = friction(&patch, 1.0);
        let (centre, radius) = (patch.centre(), patch.radius());
        // The mean square of the distance, from a spin about the centre.
        let about = Twist::new(centre.y, -centre.x, 1.0);
        let spread = -viscous.wrench(1.0, &about).torque;
        let at_rest = viscous.wrench_and_jacobian(1.0, &Twist::ZERO).1;
        for _ in 0..300 {
            let twist = anyhow(&mut rng, &patch);
            let (wrench, jacobian) = viscous.wrench_and_jacobian(1.0, &twist);
            let velocity = twist.velocity + Vector2::new(-centre.y, centre.x) * twist.spin;
            let torque = -spread * twist.spin + centre.y * velocity.x - centre.x * velocity.y;
            let expected = Wrench {
                force: -velocity,
                torque,
            };
            let (speed, arm) = scales(&patch, &twist);
            let error = distance(&wrench, &expected, arm) / speed;
            assert!(
                error < tolerance::POLYGON_POWER.limit,
                "{} {error}",
                outline.name
            );
            let difference = (even(&jacobian, radius) - even(&at_rest, radius)).amax();
            assert!(difference < 1e-12 * even(&at_rest, radius).amax());
        }
    }
}

#[test]
fn the_jacobian_times_the_twist_is_alpha_times_the_wrench_and_friction_dissipates() {
    let mut rng = Lcg::new(3);
    for outline in outlines().iter().filter(|outline| outline.name != "sliver") {
        let patch = outline.patch::<f64>();
        for alpha in [-0.75, -0.2, 0.3, 1.5, 4.0, 7.3] {
            let friction = friction(&patch, alpha);
            for _ in 0..100 {
                let twist = anyhow(&mut rng, &patch);
                let (wrench, jacobian) = friction.wrench_and_jacobian(3.0, &twist);
                assert_eq!(wrench, friction.wrench(3.0, &twist), "{}", outline.name);
                assert!(wrench.power(&twist) < 0.0);
                let (speed, arm) = scales(&patch, &twist);
                let rate = jacobian * Vector3::from(twist) - Vector3::from(wrench) * alpha;
                let of = even(&jacobian, arm).amax() * speed;
                let rate = rate.component_div(&Vector3::new(1.0, 1.0, arm)).amax();
                assert!(rate < 1e-11 * of, "{} {alpha} {twist:?}", outline.name);
                let even = even(&jacobian, arm);
                assert_eq!(even, even.transpose());
                let most = SymmetricEigen::new(even).eigenvalues.max();
                let is_damping = most < 1e-11 * even.amax();
                // A law that weakens with the speed has a direction that gains, the twist itself.
                assert_eq!(is_damping, alpha >= 0.0, "{} {alpha} {most}", outline.name);
            }
        }
    }
}

#[test]
fn differences_of_the_wrench_are_the_jacobian() {
    let mut rng = Lcg::new(4);
    for outline in outlines().iter().filter(|outline| outline.name != "sliver") {
        let patch = outline.patch::<f64>();
        let slope = [0.3 / patch.radius(), 0.4 / patch.radius()];
        let tilted = patch.clone().with_slope(slope).expect("carried");
        for alpha in [-0.25, 0.5, 2.0, 3.5] {
            let friction = friction(&tilted, alpha);
            // Away from the patch, where the wrench is smooth.
            for ratio in [1.5, 1.999, 2.001, 2.5, 5.0, 100.0] {
                let angle = rng.between(0.0, core::f64::consts::TAU);
                let reach = ratio * tilted.radius();
                let at = tilted.centre() + Vector2::new(angle.cos(), angle.sin()) * reach;
                let twist = Twist::new(at.y, -at.x, 1.0) * (1.0 / reach);
                let (_, jacobian) = friction.wrench_and_jacobian(1.0, &twist);
                let arm = tilted.radius() + tilted.centre().norm();
                let steps = [1.0, 1.0, 1.0 / arm].map(|unit| 1e-5 * unit);
                let mut found = Matrix3::zeros();
                for (column, step) in steps.into_iter().enumerate() {
                    let mut change = Vector3::zeros();
                    change[column] = step;
                    let change = Twist::from(change);
                    let ends = [twist + change, twist + change * -1.0];
                    let [a, b] = ends.map(|end| Vector3::from(friction.wrench(1.0, &end)));
                    found.set_column(column, &((a - b) / (2.0 * step)));
                }
                let error = (even(&found, arm) - even(&jacobian, arm)).amax();
                let size = even(&jacobian, arm).amax();
                assert!(
                    error < 1e-8 * size,
                    "{} {alpha} {ratio}: {error} of {size}",
                    outline.name
                );
            }
        }
    }
}

#[test]
fn single_precision_follows_double_precision() {
    let mut wrenches = Worst::of("f32, wrench");
    let mut jacobians = Worst::of("f32, Jacobian");
    let mut rng = Lcg::new(5);
    for outline in outlines().iter().filter(|outline| outline.name != "sliver") {
        let (single, double) = (outline.patch::<f32>(), outline.patch::<f64>());
        for alpha in [0.0625, 0.5, 1.0, 2.25, 3.0] {
            let of_single = friction(&single, alpha);
            let of_double = friction(&double, alpha);
            for _ in 0..200 {
                let twist = anyhow(&mut rng, &double);
                let [x, y, spin] =
                    [twist.velocity.x, twist.velocity.y, twist.spin].map(|part| part as f32);
                let (wrench, jacobian) =
                    of_single.wrench_and_jacobian(1.0, &Twist::new(x, y, spin));
                let twist = Twist::new(f64::from(x), f64::from(y), f64::from(spin));
                let (expected, of_expected) = of_double.wrench_and_jacobian(1.0, &twist);
                let (speed, arm) = scales(&double, &twist);
                let force = wrench.force.map(f64::from);
                let torque = f64::from(wrench.torque);
                let error = distance(&Wrench { force, torque }, &expected, arm);
                let place = || format!("{}, alpha {alpha}, {twist:?}", outline.name);
                wrenches.see(error / speed.powf(alpha), place);
                let (jacobian, expected) = (jacobian.map(f64::from), even(&of_expected, arm));
                let error = (even(&jacobian, arm) - expected).amax() / expected.amax();
                jacobians.see(error, place);
            }
        }
    }
    wrenches.assert_within(&tolerance::POLYGON_POWER_SINGLE);
    jacobians.assert_within(&tolerance::POLYGON_POWER_SINGLE_JACOBIAN);
}

#[test]
fn a_side_that_is_cut_in_many_is_still_one_side() {
    let square = [[-1.0_f64, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut cut = [[0.0; 2]; 128];
    for (i, corner) in cut.iter_mut().enumerate() {
        let ([ax, ay], [bx, by]) = (square[i / 32], square[(i / 32 + 1) % 4]);
        let share = (i % 32) as f64 / 32.0;
        *corner = [ax + share * (bx - ax), ay + share * (by - ay)];
    }
    let (square, cut) = (
        Polygon::new(square).expect("valid"),
        Polygon::new(cut).expect("valid"),
    );
    let mut rng = Lcg::new(6);
    for alpha in [-0.5, 0.0, 0.5, 1.0, 3.0] {
        for _ in 0..200 {
            let twist = anyhow(&mut rng, &square);
            let (a, of_a) = friction(&square, alpha).wrench_and_jacobian(1.0, &twist);
            let (b, of_b) = friction(&cut, alpha).wrench_and_jacobian(1.0, &twist);
            let (speed, arm) = scales(&square, &twist);
            let error = distance(&a, &b, arm) / speed.powf(alpha);
            assert!(
                error < tolerance::POLYGON_POWER.limit,
                "{alpha} {twist:?} {error}"
            );
            let error = (even(&of_a, arm) - even(&of_b, arm)).amax() / even(&of_a, arm).amax();
            assert!(
                error < tolerance::POLYGON_POWER_JACOBIAN.limit,
                "{alpha} {error}"
            );
        }
    }
}

#[test]
fn a_small_torque_keeps_its_digits_and_rest_is_rest() {
    let square =
        Polygon::new([[-1.0_f64, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).expect("valid");
    for alpha in [-0.5, 0.0, 0.5, 1.0, 2.5] {
        let friction = friction(square, alpha);
        // To first order the torque is −ω times the mean of (α + (1−α) along²) over the square.
        for spin in [1e-300, 1e-200, 1e-30, 1e-9] {
            let torque = friction.wrench(1.0, &Twist::new(0.6, 0.8, spin)).torque;
            let expected = -(1.0 + alpha) / 3.0;
            assert!(
                (torque / spin - expected).abs() < 2e-15,
                "{alpha} {spin} {torque}"
            );
        }
        let (rest, jacobian) = friction.wrench_and_jacobian(1.0, &Twist::ZERO);
        assert!(rest == Wrench::ZERO);
        assert_eq!(jacobian.amax() == 0.0, alpha != 1.0);
    }
}

#[test]
fn speeds_at_the_ends_of_the_range_scale_the_wrench() {
    let corners = [[0.0_f64, 0.0], [3.0, 0.25], [1.0, 2.0]];
    let patch = Polygon::new(corners).expect("valid");
    // The exponents are multiples of four, so that α-th powers of the scales are exact.
    for (alpha, exponents) in [
        (0.5, [-1040, -1000, -400, 400, 1020]),
        (-0.5, [-1040, -800, -400, 400, 1020]),
    ] {
        let friction = friction(patch, alpha);
        for twist in [Twist::new(0.75, -0.5, 0.625), Twist::new(3.0, 1.0, 0.03125)] {
            let usual = friction.wrench(1.0, &twist);
            for exponent in exponents {
                let scale = 2_f64.powi(exponent / 2) * 2_f64.powi(exponent - exponent / 2);
                let pace = 2_f64.powi((f64::from(exponent) * alpha) as i32);
                let wrench = friction.wrench(1.0, &(twist * scale));
                let error = (wrench.force / pace - usual.force).amax()
                    + (wrench.torque / pace - usual.torque).abs();
                assert!(error < 1e-14, "{alpha} {exponent}: {error}");
            }
        }
    }
    let friction = friction(patch, 1.5);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for twist in [
            Twist::new(bad, 0.0, 1.0),
            Twist::new(0.0, bad, 0.0),
            Twist::new(1.0, 0.0, bad),
        ] {
            let (wrench, jacobian) = friction.wrench_and_jacobian(1.0, &twist);
            assert!(wrench.force.x.is_nan() && wrench.torque.is_nan() && jacobian[(0, 0)].is_nan());
        }
    }
}

#[test]
fn exponents_without_a_finite_friction_are_refused() {
    for given in [-1.0, -2.0, 10.5, f64::NAN, f64::INFINITY] {
        let refused = PolygonPowerLaw::new(given).err();
        assert!(
            matches!(refused, Some(LawError::Exponent { .. })),
            "{given}"
        );
    }
    assert!(PolygonPowerLaw::new(-0.999_f32).is_ok() && PolygonPowerLaw::new(10.0_f32).is_ok());
}
