//! Coefficients of MuJoCo, Newton and Gazebo, with what each of them loses of a law.

use super::reduced::{Reduced, reduced};
use super::shape::Shape;
use super::{FittedLaw, Usage, number};

/// A simulator: its words, and what it does beside.
struct Simulator {
    name: &'static str,
    /// Names of coefficient of a contact, force and damping of a joint, inertia of a joint.
    contact: &'static str,
    joint: [&'static str; 2],
    inertia: Option<&'static str>,
    /// What to mind at a contact.
    of_contacts: &'static str,
    /// What it does with a ramp of the friction at rest, in place of the law's.
    at_rest: &'static str,
}

const MUJOCO: Simulator = Simulator {
    name: "MuJoCo",
    contact: "friction, first number",
    joint: ["frictionloss", "damping"],
    inertia: Some("armature"),
    of_contacts: "Of two geoms MuJoCo takes the larger coefficient: give it to both. The second number, for condim 4, is a \
        length: the largest torque over the load, 2/3 mu R for a disk of radius R.",
    at_rest: "the ramp at rest is that of solref and impratio, in a joint of solreffriction",
};

const NEWTON: Simulator = Simulator {
    name: "Newton",
    contact: "mu",
    joint: ["friction", "damping"],
    inertia: Some("armature"),
    of_contacts: "Solvers join the coefficients of both shapes: give it to both.",
    at_rest: "solvers but SemiImplicit have a ramp of their own",
};

const GAZEBO: Simulator = Simulator {
    name: "Gazebo",
    contact: "mu, mu2",
    joint: ["friction", "damping"],
    inertia: None,
    of_contacts: "Of two surfaces Gazebo takes the smaller coefficient: give it to both.",
    at_rest: "the ramp at rest is that of the physics engine",
};

/// Attributes of a geom or a joint in MJCF.
pub(super) fn mujoco(law: &FittedLaw<'_>, shape: &Shape) -> Usage {
    told(&MUJOCO, law, shape, |found| {
        let comment = xml(&MUJOCO.table(law, shape, found));
        if is_contact(law, shape) {
            /// Torsional and rolling coefficients that MuJoCo has by itself, in m.
            const USUAL: &str = "0.005 0.0001";
            return format!("{comment}<geom friction=\"{:?} {USUAL}\"/>\n", found.dry);
        }
        let armature = law.given("inertia").map(|x| format!(" armature=\"{x:?}\""));
        format!(
            "{comment}<joint frictionloss=\"{:?}\" damping=\"{:?}\"{}/>\n",
            found.dry,
            found.viscous,
            armature.unwrap_or_default()
        )
    })
}

/// Arguments of shapes or joints of Newton's model builder.
pub(super) fn newton(law: &FittedLaw<'_>, shape: &Shape) -> Usage {
    told(&NEWTON, law, shape, |found| {
        let table = NEWTON.table(law, shape, found);
        let comment: String = table.lines().map(|line| format!("# {line}\n")).collect();
        if is_contact(law, shape) {
            let ramp = found.ramp.map(|vt| {
                let gain = number(found.dry / vt);
                format!(
                    "\nload = 10.0  # of one contact, N\ncontact.kf = {gain} * load  # N s/m: the ramp at rest in SolverSemiImplicit"
                )
            });
            return format!(
                "{comment}import newton\n\ncontact = newton.ModelBuilder.ShapeConfig(mu={:?}){}\n",
                found.dry,
                ramp.unwrap_or_default()
            );
        }
        let armature = law.given("inertia").map(|x| format!(", armature={x:?}"));
        format!(
            "{comment}import newton\n\njoint = newton.ModelBuilder.JointDofConfig(friction={:?}, damping={:?}{})\n",
            found.dry,
            found.viscous,
            armature.unwrap_or_default()
        )
    })
}

/// Elements of a collision or a joint in SDF.
pub(super) fn gazebo(law: &FittedLaw<'_>, shape: &Shape) -> Usage {
    told(&GAZEBO, law, shape, |found| {
        let comment = xml(&GAZEBO.table(law, shape, found));
        if is_contact(law, shape) {
            let mu = number(found.dry);
            return format!(
                "{comment}<surface>\n  <friction>\n    <ode>\n      <mu>{mu}</mu>\n      <mu2>{mu}</mu2>\n    </ode>\n  </friction>\n</surface>\n"
            );
        }
        format!(
            "{comment}<dynamics>\n  <friction>{:?}</friction>\n  <damping>{:?}</damping>\n</dynamics>\n",
            found.dry, found.viscous
        )
    })
}

/// Coefficients, and the force of adhesion, belong to contacts; forces and torques to joints.
fn is_contact(law: &FittedLaw<'_>, shape: &Shape) -> bool {
    law.is_per_load || matches!(shape, Shape::Amontons { .. })
}

/// The text, or the sentence on why there is none.
fn told(
    simulator: &Simulator,
    law: &FittedLaw<'_>,
    shape: &Shape,
    text: impl Fn(&Reduced) -> String,
) -> Usage {
    match reduced(shape) {
        // Viscous friction alone has no coefficient.
        Ok(found) if found.dry == 0.0 && is_contact(law, shape) => Usage::NotPossible(format!(
            "{} has no viscous friction of a contact; a joint has a damping.",
            simulator.name
        )),
        Ok(found) => Usage::Text(text(&found)),
        Err(why) => Usage::NotPossible(format!("{} {why}", simulator.name)),
    }
}

/// A comment of XML.
fn xml(table: &str) -> String {
    let lines: String = table.lines().map(|line| format!("     {line}\n")).collect();
    format!("<!--\n{lines}-->\n")
}

impl Simulator {
    /// What is held, by which attribute, and what is lost: a line each.
    fn table(&self, law: &FittedLaw<'_>, shape: &Shape, found: &Reduced) -> String {
        let of_contact = is_contact(law, shape);
        let what = if of_contact {
            "a contact"
        } else {
            "a joint, in N and m or N m and rad"
        };
        let mut text = format!("{} fitted, for {what} of {}\n", law.law, self.name);
        let mut row = |kind: &str, words: &str| text += &format!("{kind:<6}{words}\n");
        let [force, damping] = self.joint;
        // Dry friction is always held, a viscous term only by a joint.
        let name = if of_contact { self.contact } else { force };
        row("held", &format!("{} by {name}", found.dry_from));
        match (of_contact, found.viscous_from) {
            (_, "") => {}
            (false, from) => row("held", &format!("{from} by {damping}")),
            (true, from) if found.viscous > 0.0 => {
                row(
                    "lost",
                    &format!("{from}: a contact of {} has no viscous friction", self.name),
                );
            }
            _ => {}
        }
        for lost in &found.lost {
            row("lost", lost);
        }
        if found.ramp.is_some() {
            row("lost", &format!("vt: {}", self.at_rest));
        }
        self.apparatus(law, of_contact, &mut row);
        if let (Shape::Amontons { mu, adhesion }, "MuJoCo") = (shape, self.name)
            && *mu > 0.0
        {
            let force = adhesion / mu;
            row(
                "note",
                &format!("An adhesion actuator that pulls with {force:?} N has the same friction."),
            );
        }
        if of_contact {
            row("note", self.of_contacts);
        } else {
            row(
                "note",
                "The force does not grow with the load of the joint.",
            );
        }
        text
    }

    /// Inertia and offset of the drive, where they were fitted.
    fn apparatus(&self, law: &FittedLaw<'_>, of_contact: bool, row: &mut impl FnMut(&str, &str)) {
        if law.given("inertia").is_some() {
            match self.inertia {
                Some(name) if !of_contact => row("held", &format!("inertia by {name}")),
                _ => row("lost", "inertia: add it to that of the link"),
            }
        }
        if law.given("offset").is_some() {
            row("lost", "offset: it belongs to the sensor, not to friction");
        }
    }
}
