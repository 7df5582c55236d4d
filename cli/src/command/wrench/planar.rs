//! The wrench on the body at any planar twist: straight edges, meshes, points.

use super::given::ContactParameter;
use super::output::{Fields, Format, Line};
use super::{Arguments, contact, warn_of_beyond};
use crate::command::number::{self, in_range};
use crate::failure::Failure;
use std::path::Path;
use tribos::friction::{Area, AreaFriction, FlatPatch, Floor, Law, Patch, Precision, Surface};
use tribos::record::Rows;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

const TWIST: [&str; 3] = ["velocity_x", "velocity_y", "spin"];
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

/// True if points are asked for their wrench on the body: the twists are planar, or the Jacobian is wanted.
pub fn is_asked_of_points(arguments: &Arguments) -> Result<bool, Failure> {
    let mut is_planar = false;
    if let Some(file) = &arguments.twists
        && file.as_os_str() != "-"
    {
        Rows::asked_for(file, |header| {
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

/// Evaluates and prints what the arguments ask of a patch with straight edges or a mesh, of one with two coefficients,
/// or of any on several surfaces.
pub fn of_edges<R: Precision>(arguments: &Arguments) -> Result<(), Failure> {
    refuse_options(arguments)?;
    let coefficients = arguments.coefficient;
    let law = match arguments.law {
        Some(law) => law,
        None => {
            in_range::<R>("coefficient", coefficients.largest())?;
            Law::power(coefficients.largest(), arguments.alpha)?
        }
    };
    for (name, x) in law.values() {
        in_range::<R>(name, x)?;
    }
    let (own_load, own_radius) = (arguments.load()?, arguments.radius()?);
    let radius = in_range::<R>("radius", own_radius)?;
    let area = Area::named(&arguments.patch, radius, arguments.centre)?;
    let mut given = vec![ContactParameter::Word("patch", arguments.patch.to_string())];
    if arguments.patch.has_axis() {
        given.push(ContactParameter::Number("radius", own_radius, "m"));
    }
    if let Some([x, y]) = arguments.centre {
        given.push(ContactParameter::Word("centre", format!("{x},{y} m")));
    }
    given.push(ContactParameter::Number("load", own_load, "N"));
    if let Some([coefficient, alpha]) = law.power_of_speed() {
        let is_dry = alpha == 0.0;
        let unit = if is_dry { "" } else { "(s/m)^alpha" };
        given.push(match coefficients.is_isotropic() {
            true => ContactParameter::Number("coefficient", coefficient, unit),
            false => ContactParameter::Word("coefficient", coefficients.to_string()),
        });
        if !is_dry {
            given.push(ContactParameter::Number("alpha", alpha, ""));
        }
    }
    let load = in_range("load", own_load)?;
    if let (Patch::Flat(FlatPatch::Feet(file)), None, Some([mu, 0.0]), true) = (
        &arguments.patch,
        &arguments.surface,
        law.power_of_speed(),
        coefficients.is_isotropic(),
    ) {
        // Each on its own surface.
        let floor = Floor::feet_of(file, mu * own_load)?;
        return deliver(arguments, &OnFloor::<R>::Moving(floor), &given);
    }
    let Some(file) = &arguments.surface else {
        let friction = AreaFriction::new(&coefficients.on(area)?, &law, None)?;
        let on_floor = OnFloor::AtRest(friction, load);
        return match arguments.patch.has_axis() && coefficients.is_isotropic() {
            true => deliver_resistance(arguments, &on_floor, &given),
            false => deliver(arguments, &on_floor, &given),
        };
    };
    given.push(ContactParameter::Word(
        "surface",
        file.display().to_string(),
    ));
    let area = Area::<f64>::named(&arguments.patch, own_radius, arguments.centre)?;
    let floor = Floor::under(&area, &coefficients, own_load, &Surface::read(file)?)?;
    deliver(arguments, &OnFloor::<R>::Moving(floor), &given)
}

/// Friction on a floor at rest under a load, or on one of several surfaces.
enum OnFloor<R: Precision> {
    AtRest(AreaFriction<R>, R),
    Moving(Floor),
}

impl<R: Precision> OnFloor<R> {
    fn wrench(&self, twist: &Twist<R>) -> Wrench<R> {
        match self {
            Self::AtRest(friction, load) => friction.wrench(*load, twist),
            Self::Moving(floor) => {
                let Wrench { force, torque } = floor.wrench(&in_double(twist));
                let [x, y, torque] = [force.x, force.y, torque].map(R::from_f64);
                Wrench::new(x, y, torque)
            }
        }
    }

    fn jacobian(&self, twist: &Twist<R>) -> WrenchJacobian<R> {
        match self {
            Self::AtRest(friction, load) => friction.wrench_jacobian(*load, twist),
            Self::Moving(floor) => floor.wrench_jacobian(&in_double(twist)).map(R::from_f64),
        }
    }
}

fn in_double<R: Precision>(twist: &Twist<R>) -> Twist<f64> {
    let Twist { velocity, spin } = *twist;
    Twist::new(velocity.x.to_f64(), velocity.y.to_f64(), spin.to_f64())
}

/// The same of the points of a file.
pub fn of_points<R: Precision>(arguments: &Arguments, path: &Path) -> Result<(), Failure> {
    if arguments.tilt.is_some() || arguments.centre.is_some() {
        return Err(Failure::input(
            "points have their own weights: leave out --tilt and --centre",
        ));
    }
    if arguments.has_radius() {
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
    let friction = AreaFriction::at_points(contact::points(path, &|_| R::ONE)?, &law)?;
    let coefficient: R = in_range("coefficient", arguments.coefficient.largest())?;
    let load = coefficient * in_range::<R>("load", arguments.load()?)?;
    let given = [
        ContactParameter::Word("patch", arguments.patch.to_string()),
        ContactParameter::Number("load", arguments.load()?, "N"),
        ContactParameter::Word("law", law.to_string()),
        ContactParameter::Number("coefficient", arguments.coefficient.largest(), ""),
    ];
    deliver(arguments, &OnFloor::AtRest(friction, load), &given)
}

/// Refuses options that have no meaning for straight edges.
fn refuse_options(arguments: &Arguments) -> Result<(), Failure> {
    let reason = if arguments.tilt.is_some() {
        "--tilt is for round patches; --centre X,Y moves the centre of pressure"
    } else if arguments.tier.is_some() {
        "a patch with straight edges has one tier, which is exact: leave out --tier"
    } else if arguments.has_radius() && !arguments.patch.has_axis() {
        "a patch with straight edges has its own size: leave out --radius"
    } else {
        return Ok(());
    };
    Err(Failure::input(reason))
}

fn deliver<R: Precision>(
    arguments: &Arguments,
    friction: &OnFloor<R>,
    given: &[ContactParameter],
) -> Result<(), Failure> {
    let at = |twist| line(friction, twist, arguments.jacobian);
    match &arguments.twists {
        Some(file) => arguments.all(file, &TWIST, given, at),
        None => {
            let format = arguments.format.unwrap_or(Format::Text);
            let [speed, spin] = arguments.twist();
            let (fields, is_beyond) = at([speed, 0.0, spin])?;
            warn_of_beyond(u64::from(is_beyond));
            arguments.deliver(&format.one(&fields, given), format, given)
        }
    }
}

/// The same as resistance along the velocity and about the normal: what other round patches answer with.
fn deliver_resistance<R: Precision>(
    arguments: &Arguments,
    friction: &OnFloor<R>,
    given: &[ContactParameter],
) -> Result<(), Failure> {
    let at = |[speed, spin]: [f64; 2]| -> Result<_, Failure> {
        let twist = Twist::new(in_range("speed", speed)?, R::ZERO, in_range("spin", spin)?);
        let Wrench { force, torque } = friction.wrench(&twist);
        let jacobian = arguments.jacobian.then(|| {
            let all = friction.jacobian(&twist);
            // No zero is negative.
            [(0, 0), (0, 2), (2, 0), (2, 2)].map(|at| 0.0 - all[at].to_f64())
        });
        let line = Line {
            twist: [speed, spin],
            force: 0.0 - force.x.to_f64(),
            torque: 0.0 - torque.to_f64(),
            lateral: None,
            jacobian,
            is_beyond: false,
        };
        let fields = line.fields();
        let is_beyond = fields.iter().any(|(_, x)| !x.is_finite());
        Ok((fields, is_beyond))
    };
    match &arguments.twists {
        Some(file) => arguments.all(file, &["speed", "spin"], given, at),
        None => {
            let format = arguments.format.unwrap_or(Format::Text);
            let (fields, is_beyond) = at(arguments.twist())?;
            warn_of_beyond(u64::from(is_beyond));
            arguments.deliver(&format.one(&fields, given), format, given)
        }
    }
}

fn line<R: Precision>(
    friction: &OnFloor<R>,
    given: [f64; 3],
    with_jacobian: bool,
) -> Result<(Fields, bool), Failure> {
    let mut parts = [R::ZERO; 3];
    for ((part, name), value) in parts.iter_mut().zip(TWIST).zip(given) {
        *part = in_range(name, value)?;
    }
    let [x, y, spin] = parts;
    let twist = Twist::new(x, y, spin);
    let wrench = friction.wrench(&twist);
    let jacobian = with_jacobian.then(|| friction.jacobian(&twist));
    Ok(answer(given, &wrench, jacobian.as_ref()))
}

/// The columns of a wrench on the body, and whether one is no finite number.
fn answer<R: Precision>(
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
