//! Patches with straight edges: the exact wrench of dry friction and of power laws at any planar twist.

use super::given::Given;
use super::output::{Fields, Format};
use super::{Arguments, warn_of_beyond};
use crate::command::number::{self, in_range};
use crate::failure::Failure;
use tribos::friction::{Flat, FlatPatch, Precision};
use tribos_core::coupling::flat::{FlatFriction, FlatPower, FlatPowerFriction};
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

pub(super) const TWIST: [&str; 3] = ["velocity_x", "velocity_y", "spin"];
const WRENCH: [&str; 3] = ["force_x", "force_y", "torque"];
const JACOBIAN: [[&str; 3]; 3] = [
    [
        "dforce_x_dvelocity_x",
        "dforce_x_dvelocity_y",
        "dforce_x_dspin",
    ],
    [
        "dforce_y_dvelocity_x",
        "dforce_y_dvelocity_y",
        "dforce_y_dspin",
    ],
    [
        "dtorque_dvelocity_x",
        "dtorque_dvelocity_y",
        "dtorque_dspin",
    ],
];

/// A position `X,Y`.
pub fn centre(text: &str) -> Result<[f64; 2], String> {
    let (x, y) = text
        .split_once(',')
        .ok_or("give two coordinates in m, such as 0.03,0")?;
    Ok([number::finite(x)?, number::finite(y)?])
}

/// Wrench and Jacobian at a load and a twist.
type Friction<R> = Box<dyn Fn(R, &Twist<R>) -> (Wrench<R>, WrenchJacobian<R>)>;

/// Evaluates and prints what the arguments ask of `patch`.
pub fn evaluate<R: Precision>(arguments: &Arguments, patch: &FlatPatch) -> Result<(), Failure> {
    let law = law(arguments)?;
    let friction = friction::<R>(patch.loaded::<R>(arguments.centre)?, law)?;
    let load = in_range("load", arguments.load)?;
    let given = contact(arguments, law);
    let at = |twist| line(&friction, load, twist, arguments.jacobian);
    match (&arguments.twists, arguments.speed, arguments.spin) {
        (Some(file), ..) => arguments.all(file, &TWIST, &given, at),
        (None, Some(speed), Some(spin)) => {
            let format = arguments.format.unwrap_or(Format::Text);
            let (fields, is_beyond) = at([speed, 0.0, spin])?;
            warn_of_beyond(u64::from(is_beyond));
            arguments.deliver(&format.one(&fields, &given), format, &given)
        }
        _ => Err(Failure::input("give --speed and --spin, or --twists FILE")),
    }
}

/// Friction of a patch under the law of this coefficient and exponent.
fn friction<R: Precision>(
    flat: Flat<R>,
    [coefficient, alpha]: [f64; 2],
) -> Result<Friction<R>, Failure> {
    let coefficient = in_range("coefficient", coefficient)?;
    if alpha == 0.0 {
        let dry = FlatFriction::new(flat, coefficient).map_err(Failure::input)?;
        return Ok(Box::new(move |load, twist| {
            dry.wrench_and_jacobian(load, twist)
        }));
    }
    let power = FlatPower::new(in_range("alpha", alpha)?).map_err(Failure::input)?;
    match flat {
        Flat::Polygon(patch) => {
            let friction =
                FlatPowerFriction::new(patch, coefficient, power).map_err(Failure::input)?;
            Ok(Box::new(move |load, twist| {
                friction.wrench_and_jacobian(load, twist)
            }))
        }
        Flat::Leaning(patch) => {
            let friction =
                FlatPowerFriction::new(patch, coefficient, power).map_err(Failure::input)?;
            Ok(Box::new(move |load, twist| {
                friction.wrench_and_jacobian(load, twist)
            }))
        }
        Flat::Bar(_) | Flat::Mesh(_) => Err(Failure::input(
            "bars and meshes serve dry friction: leave out --alpha and --law, or give a box or a polygon",
        )),
    }
}

/// Coefficient and exponent of the law; options that have no meaning here are refused.
fn law(arguments: &Arguments) -> Result<[f64; 2], Failure> {
    let refused = |reason: &str| Err(Failure::input(reason.to_owned()));
    if arguments.tilt.is_some() {
        return refused("--tilt is for round patches; --centre X,Y moves the centre of pressure");
    }
    if arguments.tier.is_some() {
        return refused(
            "a patch with straight edges has one tier, which is exact: leave out --tier",
        );
    }
    if arguments.radius != 1.0 {
        return refused("a patch with straight edges has its own size: leave out --radius");
    }
    match &arguments.law {
        None => Ok([arguments.coefficient, arguments.alpha]),
        Some(law) => law.power_of_speed().ok_or_else(|| {
            Failure::input(format!(
                "patches with straight edges serve dry friction and powers of the speed, not {}: give \
                 --law coulomb or power, --alpha, or points",
                law.name()
            ))
        }),
    }
}

fn contact(arguments: &Arguments, [coefficient, alpha]: [f64; 2]) -> Vec<Given> {
    let mut given = vec![Given::Word("patch", arguments.patch.to_string())];
    if let Some([x, y]) = arguments.centre {
        given.push(Given::Word("centre", format!("{x},{y} m")));
    }
    given.push(Given::Number("load", arguments.load, "N"));
    if alpha == 0.0 {
        given.push(Given::Number("coefficient", coefficient, ""));
    } else {
        given.push(Given::Number("coefficient", coefficient, "(s/m)^alpha"));
        given.push(Given::Number("alpha", alpha, ""));
    }
    given
}

fn line<R: Precision>(
    friction: &Friction<R>,
    load: R,
    given: [f64; 3],
    with_jacobian: bool,
) -> Result<(Fields, bool), Failure> {
    let mut parts = [R::ZERO; 3];
    for ((part, name), value) in parts.iter_mut().zip(TWIST).zip(given) {
        *part = in_range(name, value)?;
    }
    let [x, y, spin] = parts;
    let (wrench, jacobian) = friction(load, &Twist::new(x, y, spin));
    Ok(answer(given, &wrench, with_jacobian.then_some(&jacobian)))
}

/// The columns of a wrench on the body, and whether one is no finite number.
pub(super) fn answer<R: Precision>(
    given: [f64; 3],
    wrench: &Wrench<R>,
    jacobian: Option<&WrenchJacobian<R>>,
) -> (Fields, bool) {
    let mut fields: Fields = TWIST.into_iter().zip(given).collect();
    let parts = [wrench.force.x, wrench.force.y, wrench.torque];
    // No minus before a zero.
    fields.extend(WRENCH.into_iter().zip(parts.map(|x| x.to_f64() + 0.0)));
    if let Some(jacobian) = jacobian {
        for (i, names) in JACOBIAN.iter().enumerate() {
            for (j, name) in names.iter().enumerate() {
                fields.push((name, jacobian[(i, j)].to_f64()));
            }
        }
    }
    let is_beyond = fields.iter().any(|(_, x)| !x.is_finite());
    (fields, is_beyond)
}
