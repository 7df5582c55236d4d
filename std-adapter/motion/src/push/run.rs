//! What a scene of a pushed body asks for, computed.

use super::cone::MotionCone;
use super::contact::PointContact;
use super::error::PushError;
use super::line::{LineContact, StablePush};
use super::outline::{Shape, nearest_side};
use super::path::{Pose, PushPath, PushedSide, Pusher, with_pusher};
use super::solve::QuasiStaticPush;
use crate::push::scene::PushScene;
use serde_json::{Map, Value};
use tribos_base::record::json_number;
use tribos_core::Real;
use tribos_core::limit_surface::UnknownPressureSet;
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::{Area, Coefficients, FrictionError, Patch};

/// The scene of a pushed body that comes with the program.
#[doc(hidden)]
pub const PUSH_BOX: &str = include_str!("../../push-box.toml");

/// A scene of a pushed body with its answers.
#[derive(Clone, Debug)]
pub struct PushResult {
    /// The body's outline, for pictures.
    pub outline: Vec<Vec<[f64; 2]>>,
    /// Motions that the (first) contact can give without sliding.
    pub cone: MotionCone,
    /// The push at the start, by a point at the first contact.
    pub first: QuasiStaticPush,
    /// The push over the largest one along its ray: 1 while the body moves, 0 at rest.
    pub gauge: f64,
    /// The largest torque that friction carries without force, in N m.
    pub yaw_limit: f64,
    /// The same if only the centre of pressure is known; none for round patches.
    pub yaw_limit_of_any_pressure: Option<f64>,
    /// What a straight pusher has to give for the body to move with it.
    pub grip: Option<StablePush>,
    /// The path, under a pusher that is a point or holds the body.
    pub journey: PushPath,
}

impl PushScene {
    /// Computes what the scene asks for.
    ///
    /// The path of a straight pusher that does not hold the body is not followed: it has its start alone.
    pub fn run(&self) -> Result<PushResult, PushError> {
        self.check()?;
        let mu = Coefficients::along_and_across(
            [self.mu, self.mu_across.unwrap_or(self.mu)],
            self.axis,
        )?;
        let area = Area::named(&self.patch, self.radius, pair(self.centre_x, self.centre_y))?;
        let set = mu.on(area)?.limit_surface(mu.largest() * self.load)?;
        let shape = Shape::of(&self.patch, self.radius)?;
        let [x, y] = [self.contact_x, self.contact_y];
        let mu = self.mu_pusher;
        let line = match pair(self.end_x, self.end_y) {
            None => None,
            Some(end) => Some(inward_line([[x, y], end], mu, &shape)?),
        };
        let (contact, side) = match &line {
            Some(line) => (line.ends()[0], endless()),
            None => point(self, &shape)?,
        };
        let cone = contact.motion_cone(&*set)?;
        let twist = Twist::new(self.velocity_x, self.velocity_y, self.spin);
        let at_contact = contact.velocity(&twist);
        let first = contact.push(&*set, at_contact.into())?;
        let grip = line.map(|line| line.stable_push(&*set, &twist));
        let journey = match &grip {
            None => Pusher {
                contact,
                side,
                start: Pose::default(),
                velocity: at_contact.into(),
                duration: duration(self),
                samples: self.samples,
                tolerance: self.tolerance,
            }
            .path(&*set)?,
            Some(grip) => with_pusher(&contact, grip, &twist, duration(self), self.samples),
        };
        Ok(PushResult {
            gauge: set.gauge(&first.wrench),
            yaw_limit: set.scale_to_surface(&Wrench::new(0.0, 0.0, 1.0)).torque,
            yaw_limit_of_any_pressure: any_pressure(self, &shape)?,
            outline: shape.loops,
            cone,
            first,
            grip,
            journey,
        })
    }
}

fn pair(x: Option<f64>, y: Option<f64>) -> Option<[f64; 2]> {
    Some([x?, y?])
}

const fn endless() -> PushedSide {
    let (right, left) = (f64::INFINITY, f64::INFINITY);
    PushedSide::Straight { right, left }
}

/// How long the pusher moves, in s.
fn duration(scene: &PushScene) -> f64 {
    let speed = Real::hypot(scene.velocity_x, scene.velocity_y);
    match (scene.duration, scene.distance) {
        (Some(duration), _) => duration,
        (None, Some(distance)) if speed > 0.0 => distance / speed,
        // A rotation alone covers no distance: one second of it.
        _ => 1.0,
    }
}

/// The line in the order in which the body lies to its left.
fn inward_line(
    ends: [[f64; 2]; 2],
    coefficient: f64,
    shape: &Shape,
) -> Result<LineContact, PushError> {
    let [[x0, y0], [x1, y1]] = ends;
    let middle = [0.5 * (x0 + x1), 0.5 * (y0 + y1)];
    let [inward, _] = nearest_side(shape, middle);
    let is_left = (x1 - x0) * inward[1] - (y1 - y0) * inward[0] >= 0.0;
    let ends = if is_left { ends } else { [ends[1], ends[0]] };
    LineContact::new(ends, coefficient)
}

/// A point contact, with the normal of its side where none is given.
fn point(scene: &PushScene, shape: &Shape) -> Result<(PointContact, PushedSide), PushError> {
    let at = [scene.contact_x, scene.contact_y];
    let [inward, reach] = nearest_side(shape, at);
    let given = pair(scene.normal_x, scene.normal_y);
    let normal = given.unwrap_or(inward);
    let contact = PointContact::new(at, normal, scene.mu_pusher)?;
    let side = match (given, matches!(scene.patch, Patch::Flat(_))) {
        (Some(_), _) => endless(),
        (None, true) => {
            let [right, left] = reach;
            PushedSide::Straight { right, left }
        }
        (None, false) => PushedSide::Round,
    };
    Ok((contact, side))
}

/// The yaw limit if of the pressure only the centre is known.
fn any_pressure(scene: &PushScene, shape: &Shape) -> Result<Option<f64>, PushError> {
    // Of friction that differs along two axes nothing is known under any pressure.
    let (Some(centroid), None) = (shape.centroid, scene.mu_across) else {
        return Ok(None);
    };
    let centre = pair(scene.centre_x, scene.centre_y).unwrap_or(centroid);
    let limit = scene.mu * scene.load;
    let corners = shape.loops.concat();
    let foot = UnknownPressureSet::new(corners, centre, limit).map_err(FrictionError::from)?;
    Ok(foot.torque_limits([0.0; 2]).map(|yaw| yaw.possible[1]))
}

impl PushResult {
    /// Names of the values of a row.
    pub const COLUMNS: [&'static str; 13] = [
        "time",
        "x",
        "y",
        "angle",
        "contact_x",
        "contact_y",
        "velocity_x",
        "velocity_y",
        "spin",
        "force_x",
        "force_y",
        "torque",
        "slip",
    ];

    /// The path as a table: time, pose, and in the frame of the body contact, twist, push and slip to the left.
    pub fn rows(&self) -> impl Iterator<Item = [f64; 13]> + '_ {
        let tangent = self.cone.contact.tangent();
        self.journey.moments.iter().map(move |moment| {
            let (pose, push) = (&moment.pose, &moment.push);
            [
                moment.time,
                pose.x,
                pose.y,
                pose.angle,
                moment.contact.x,
                moment.contact.y,
                push.twist.velocity.x,
                push.twist.velocity.y,
                push.twist.spin,
                push.wrench.force.x,
                push.wrench.force.y,
                push.wrench.torque,
                push.slip.dot(&tangent),
            ]
        })
    }

    /// The summary as JSON.
    pub fn json(&self, scene: &PushScene) -> Value {
        let mut map = Map::new();
        let mut number = |name: &str, value: f64| map.insert(name.into(), json_number(value));
        let first = &self.first;
        let [right, left] = self.cone.angles();
        number("velocity_x", first.twist.velocity.x);
        number("velocity_y", first.twist.velocity.y);
        number("spin", first.twist.spin);
        number("slip", first.slip.dot(&self.cone.contact.tangent()));
        number("force_x", first.wrench.force.x);
        number("force_y", first.wrench.force.y);
        number("torque", first.wrench.torque);
        number("gauge", self.gauge);
        number("motion_cone_right", right);
        number("motion_cone_left", left);
        number("yaw_limit", self.yaw_limit);
        if let Some(limit) = self.yaw_limit_of_any_pressure {
            number("yaw_limit_of_any_pressure", limit);
        }
        if let Some(grip) = &self.grip {
            number("grip_place", grip.place);
            number("grip_friction", grip.friction);
        }
        if let Some(last) = self.journey.moments.last() {
            number("end_time", last.time);
            number("end_x", last.pose.x);
            number("end_y", last.pose.y);
            number("end_angle", last.pose.angle);
        }
        map.insert("mode".into(), first.mode.to_string().into());
        let stable = self.grip.map(|grip| grip.is_stable);
        map.insert("stable".into(), stable.map_or(Value::Null, Value::Bool));
        map.insert("ending".into(), self.journey.end.to_string().into());
        map.insert("steps".into(), self.journey.steps.into());
        map.insert("scene".into(), scene.json());
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }
}
