//! Answers of version 2 that the kernel and contact dynamics know.

use super::march::{self, Body};
use super::sheet::Sheet;
use serde_json::Value;
use tribos::cd::{World, WorldMaterials, WorldSetup, solid};
use tribos::friction::FlatPatch;
use tribos_core::contact::{Cohesion, IndependentFriction, NormalLaw, SphereBody};
use tribos_core::nalgebra::Vector3;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::tables::Table;

/// Digits of the answers that are promised.
const CLOSE: f64 = 1e-12;

/// A number of a case.
fn number(case: &Value, key: &str) -> f64 {
    case[key].as_f64().expect("a number")
}

/// A box whose centre of mass lies off its middle, above the centre of its linear pressure.
struct Eccentric {
    face: Sheet,
    offset: [f64; 2],
}

impl Body for Eccentric {
    fn friction(&self, twist: &Twist<f64>) -> Wrench<f64> {
        let [x, y] = self.offset;
        let Twist { velocity, spin } = *twist;
        let middle = Twist::new(velocity.x + spin * y, velocity.y - spin * x, spin);
        let Wrench { force, torque } = self.face.friction(&middle);
        Wrench::new(force.x, force.y, torque - x * force.y + y * force.x)
    }

    fn scale(&self, twist: &Twist<f64>) -> f64 {
        self.face.scale(twist)
    }

    fn gyration_sq(&self) -> f64 {
        self.face.gyration_sq()
    }

    fn strength(&self) -> f64 {
        self.face.strength()
    }
}

fn eccentric(case: &Value) -> Vec<f64> {
    let [x, y] = ["corner_1_x", "corner_1_y"].map(|key| number(case, key));
    let offset = ["offset_x", "offset_y"].map(|key| number(case, key));
    let patch = FlatPatch::Box([2.0 * x, 2.0 * y]).loaded(Some(offset));
    let law = ["mu", "g"].map(|key| number(case, key));
    let face = Sheet::new(patch.expect("a patch"), law, (x * x + y * y) / 3.0);
    march::to_rest(
        &Eccentric { face, offset },
        number(case, "speed"),
        number(case, "spin"),
    )
}

/// Angle and time until rest of a body that only spins, from the torque of its patch.
fn spins(case: &Value, patch: &FlatPatch, gyration_sq: f64) -> Vec<f64> {
    let law = ["mu", "g"].map(|key| number(case, key));
    let face = Sheet::new(patch.loaded(None).expect("a patch"), law, gyration_sq);
    let spin = number(case, "spin");
    let slowing = -face.friction(&Twist::new(0.0, 0.0, spin)).torque / gyration_sq;
    vec![spin * spin / (2.0 * slowing), spin / slowing]
}

fn wheel(case: &Value) -> Vec<f64> {
    let [radius, half] = ["radius", "half_width"].map(|key| number(case, key));
    let gyration_sq = (3.0 * radius * radius + 4.0 * half * half) / 12.0;
    spins(case, &FlatPatch::Bar(2.0 * half), gyration_sq)
}

/// Two balls in empty space after the step in which they meet.
fn collide(case: &Value) -> Vec<f64> {
    let [radius, speed, angle] = ["radius", "speed", "angle"].map(|key| number(case, key));
    let normal = NormalLaw::new(Cohesion::NONE, 0.0).expect("a law");
    let friction = IndependentFriction::sliding(number(case, "mu")).expect("a coefficient");
    let ball = |velocity: f64, spin: f64| SphereBody {
        velocity: Vector3::x() * velocity,
        spin: Vector3::z() * spin,
        ..solid(radius, 1700.0)
    };
    let (sin, cos) = libm::sincos(angle);
    // They touch from the first moment on.
    let away = Vector3::new(-cos, -sin, 0.0) * (2.0 * radius);
    let mut setup = WorldSetup::new(WorldMaterials::uniform(normal, friction))
        .sphere(away, radius, ball(speed, number(case, "spin")))
        .sphere(Vector3::zeros(), radius, ball(0.0, 0.0));
    setup.step_limits.longest = 1e-6;
    let mut world = World::new(setup).expect("a world");
    world.step().expect("a step");
    let [a, b] = [0, 1].map(|at| world.state().spheres[at]);
    vec![
        a.velocity.x,
        a.velocity.y,
        a.spin.z,
        b.velocity.x,
        b.velocity.y,
        b.spin.z,
    ]
}

#[test]
fn version_2_is_what_kernel_and_contact_dynamics_compute() {
    let text = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/answers/v2/problems.json"
    ));
    let problems: Value = serde_json::from_str(&text.expect("a file")).expect("JSON");
    let table = Table::read("../answers/v2/answers.csv");
    let rows: Vec<_> = table.rows().collect();
    let case = |row: &tribos_tests::tables::Row<'_>| {
        [row.text("item").to_owned(), row.text("case").to_owned()]
    };
    let mut seen = 0;
    for answers in rows.chunk_by(|a, b| case(a) == case(b)) {
        let [item, name] = case(&answers[0]);
        let parameters = &problems[&item][&name];
        let got = match item.as_str() {
            "eccentric" => eccentric(parameters),
            "top" => {
                let disk = FlatPatch::Ellipse([number(parameters, "radius"); 2]);
                spins(parameters, &disk, number(parameters, "gyration_sq"))
            }
            "wheel" => wheel(parameters),
            "collide" => collide(parameters),
            _ => continue,
        };
        assert_eq!(got.len(), answers.len(), "{item} {name}");
        let most = answers.iter().map(|row| row.number("value").abs());
        let most = most.fold(0.0, f64::max);
        for (row, got) in answers.iter().zip(&got) {
            let wanted = row.number("value");
            let unit = if row.text("quantity") == "left_m" {
                most
            } else {
                wanted.abs()
            };
            let off = (got - wanted).abs() / unit;
            println!(
                "{item} {name} {}: {got} for {wanted}, {off:.1e}",
                row.text("quantity")
            );
            assert!(
                off <= CLOSE,
                "{item} {name} {}: {off:e}",
                row.text("quantity")
            );
        }
        seen += 1;
    }
    assert_eq!(seen, 8);
}
