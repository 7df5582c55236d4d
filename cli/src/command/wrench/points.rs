//! Points under any planar twist, and any local law.

use super::contact::Points;
use super::flat::{TWIST, answer};
use super::given::Given;
use super::output::{Fields, Format};
use super::{Arguments, warn_of_beyond};
use crate::command::columns::Rows;
use crate::command::number::in_range;
use crate::failure::Failure;
use std::path::Path;
use tribos::friction::{AnyLaw, Law, Precision};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::twist::{Twist, Wrench};

/// True if the twists are planar, or the Jacobian is asked for: the body then need not slide along x.
pub fn is_asked_for(arguments: &Arguments) -> Result<bool, Failure> {
    let mut is_planar = false;
    if let Some(file) = &arguments.twists
        && file.as_os_str() != "-"
    {
        Rows::open(file, |header| {
            is_planar = header.contains(&TWIST[0]);
            if is_planar {
                &TWIST
            } else {
                &["speed", "spin"]
            }
        })?;
    }
    Ok(is_planar || arguments.jacobian)
}

/// Evaluates and prints the wrench on the body, about the origin of the points.
pub fn evaluate<R: Precision>(arguments: &Arguments, path: &Path) -> Result<(), Failure> {
    if arguments.tilt.is_some() || arguments.centre.is_some() {
        return Err(Failure::input(
            "points have their own weights: leave out --tilt and --centre",
        ));
    }
    if arguments.radius != 1.0 {
        return Err(Failure::input(
            "points have their own size: leave out --radius",
        ));
    }
    let law = match arguments.law {
        Some(law) => law,
        None => Law::power(1.0, arguments.alpha)?,
    };
    for (name, x) in law.values() {
        in_range::<R>(name, x)?;
    }
    let friction = NodeFriction::new(law.made()?, Points::read(path)?);
    let coefficient: R = in_range("coefficient", arguments.coefficient)?;
    let load = coefficient * in_range::<R>("load", arguments.load)?;
    let given = [
        Given::Word("patch", arguments.patch.to_string()),
        Given::Number("load", arguments.load, "N"),
        Given::Word("law", law.to_string()),
        Given::Number("coefficient", arguments.coefficient, ""),
    ];
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

fn line<R: Precision>(
    friction: &NodeFriction<AnyLaw<R>, Points<R>>,
    load: R,
    given: [f64; 3],
    with_jacobian: bool,
) -> Result<(Fields, bool), Failure> {
    let mut parts = [R::ZERO; 3];
    for ((part, name), value) in parts.iter_mut().zip(TWIST).zip(given) {
        *part = in_range(name, value)?;
    }
    let [x, y, spin] = parts;
    let twist = Twist::new(x, y, spin);
    let wrench: Wrench<R> = friction.wrench(load, &twist);
    let jacobian = with_jacobian.then(|| friction.wrench_jacobian(load, &twist));
    Ok(answer(given, &wrench, jacobian.as_ref()))
}
