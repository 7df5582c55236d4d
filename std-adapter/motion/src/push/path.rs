//! The path of a body that is pushed at constant velocity.

use super::contact::PointContact;
use super::error::{PushError, finite};
use super::line::StablePush;
use super::solve::{ContactMode, QuasiStaticPush};
use tribos_core::Real;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::nalgebra::{Vector2, Vector3};
use tribos_core::twist::Twist;

/// Steps are at least this part of the duration.
const SHORTEST: f64 = 1e-12;
/// Error of a step of fourth order over the difference to two steps of half its length.
const RICHARDSON: f64 = 1.0 / 15.0;
/// Rounding of a pose and of the pusher's place in it, in ulps of the largest coordinate: the difference of two
/// ways of stepping is no smaller.
const ROUNDING_ULPS: f64 = 8.0;
/// A step whose error is this part of what it may be is doubled.
const EASY: f64 = 1.0 / 64.0;

/// Place and angle of a body: where its centre, or the origin of its patch, is, and its turn counterclockwise.
///
/// *Units*: m and rad. A launch is thrown from the default, the origin.
///
/// ```
/// use tribos::push::Pose;
/// let quarter = Pose { x: 1.0, y: 0.0, angle: std::f64::consts::FRAC_PI_2 };
/// let corner = quarter.place([0.2, 0.0].into());
/// assert!((corner.x - 1.0).abs() < 1e-15 && (corner.y - 0.2).abs() < 1e-15);
/// assert!((quarter.in_body(corner).x - 0.2).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Place along the first axis.
    pub x: f64,
    /// Place along the second axis.
    pub y: f64,
    /// Angle turned counterclockwise, not reduced to one turn.
    pub angle: f64,
}

/// The side of a body that a pusher touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PushedSide {
    /// Straight; the pusher may slide so far to the right and to the left, in m. Infinite if it has no end.
    Straight {
        /// To the right of the contact.
        right: f64,
        /// To the left of it.
        left: f64,
    },
    /// A circle about the origin.
    Round,
}

/// A pusher that moves at constant velocity, and how its path is followed.
///
/// ```
/// use tribos::friction::Area;
/// use tribos::push::{Pusher, PathEnd, PointContact, Pose, PushedSide};
/// let table = Area::named(&"box:0.2x0.1".parse()?, 1.0, None)?.limit_surface(2.0)?; // N
/// let drive = Pusher {
///     contact: PointContact::new([0.02, -0.05], [0.0, 1.0], 0.3)?,
///     side: PushedSide::Straight { right: 0.08, left: 0.12 },
///     start: Pose::default(),
///     velocity: [0.0, 0.01], // m/s
///     duration: 10.0,
///     samples: 50,
///     tolerance: 1e-7, // m
/// };
/// let journey = drive.path(&*table)?;
/// assert_eq!((journey.end, journey.moments.len()), (PathEnd::Done, 51));
/// let last = journey.moments[50];
/// assert!(last.pose.angle > 0.3 && last.pose.y > 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pusher {
    /// Where the pusher touches the body at the start, in the frame of the body.
    pub contact: PointContact,
    /// The side on which it is.
    pub side: PushedSide,
    /// Pose of the body at the start.
    pub start: Pose,
    /// Velocity of the pusher in the frame of the floor, in m/s.
    pub velocity: [f64; 2],
    /// How long it pushes, in s.
    pub duration: f64,
    /// Number of recorded times after the start, evenly spaced.
    pub samples: u32,
    /// Largest error of the path, in m; of the angle, over the patch's radius.
    pub tolerance: f64,
}

/// A moment of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathSample {
    /// Time since the start, in s.
    pub time: f64,
    /// Pose of the body.
    pub pose: Pose,
    /// Where the pusher touches it, in the frame of the body.
    pub contact: Vector2<f64>,
    /// The push, in the frame of the body.
    pub push: QuasiStaticPush,
}

/// How a path ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathEnd {
    /// At its duration.
    Done,
    /// The pusher came to the end of the side.
    Slipped,
    /// The body has turned so far that the pusher moves away from it.
    Separated,
    /// A straight pusher does not hold the body; how it moves is not computed.
    Loose,
}

impl std::fmt::Display for PathEnd {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Done => "done",
            Self::Slipped => "the pusher slid off the side",
            Self::Separated => "the pusher moved away",
            Self::Loose => "the pusher does not hold the body",
        })
    }
}

/// The path of a pushed body.
#[derive(Clone, Debug, PartialEq)]
pub struct PushPath {
    /// At the start, at each of the times, and at the end.
    pub moments: Vec<PathSample>,
    /// How it ended.
    pub end: PathEnd,
    /// How many steps of the integration it took.
    pub steps: usize,
}

impl Pose {
    fn position(&self) -> Vector2<f64> {
        Vector2::new(self.x, self.y)
    }

    /// Where a place of the body is.
    pub fn place(&self, in_body: Vector2<f64>) -> Vector2<f64> {
        self.position() + turned(in_body, self.angle)
    }

    /// Which place of the body is there.
    pub fn in_body(&self, place: Vector2<f64>) -> Vector2<f64> {
        turned(place - self.position(), -self.angle)
    }
}

fn turned(v: Vector2<f64>, angle: f64) -> Vector2<f64> {
    let (s, c) = (Real::sin(angle), Real::cos(angle));
    Vector2::new(c * v.x - s * v.y, s * v.x + c * v.y)
}

impl Pusher {
    /// Follows a body of this friction.
    ///
    /// The pusher is a point, such as a thin finger. Steps are of fourth order (Runge and Kutta) and halved until their
    /// error, by comparison with two half steps, is at most the tolerance times their part of the duration; the kinks
    /// where sticking begins or ends are passed in short steps. *Domain*: finite numbers; duration and
    /// tolerance > 0. *Accuracy*: the tolerance, as long as neighbouring paths do not move apart. The path is the same
    /// on every platform.
    pub fn path(&self, set: &dyn FrictionSet<f64>) -> Result<PushPath, PushError> {
        let path = Path::new(set, self)?;
        let mut state = [self.start.x, self.start.y, self.start.angle].into();
        let (mut moments, mut steps) = (vec![path.moment(0.0, &state)?], 0);
        let shortest = SHORTEST * self.duration;
        let mut step = self.duration / f64::from(self.samples.max(1));
        let mut end = ended(&moments[0]);
        let mut time = 0.0;
        for sample in 1..=self.samples.max(1) {
            if end.is_some() {
                break;
            }
            let until = self.duration * (f64::from(sample) / f64::from(self.samples.max(1)));
            while end.is_none() && time < until {
                // A rest that is too short for a step is taken along.
                let left = until - time;
                let length = if step > left - shortest { left } else { step };
                let (next, error) = path.step_with_error(time, &state, length)?;
                steps += 1;
                let allowed = self.tolerance * length / self.duration + path.rounding(time, &state);
                let at = path.moment(time + length, &next)?;
                let is_off = !path.is_on_side(&at);
                if (error > allowed || is_off) && length > 2.0 * shortest {
                    step = 0.5 * length;
                    continue;
                }
                if error > allowed {
                    let tolerance = self.tolerance;
                    return Err(PushError::Steps { time, tolerance });
                }
                time = if length == left { until } else { time + length };
                state = next;
                end = if is_off {
                    Some(PathEnd::Slipped)
                } else {
                    ended(&at)
                };
                if error < EASY * allowed {
                    step = 2.0 * length.max(step);
                }
            }
            moments.push(path.moment(time, &state)?);
        }
        let end = end.unwrap_or(PathEnd::Done);
        Ok(PushPath {
            moments,
            end,
            steps,
        })
    }
}

/// The path of a body that keeps its place at a pusher with this motion, in the frame of the body; the start
/// alone if the pusher does not hold it.
pub(super) fn with_pusher(
    contact: &PointContact,
    grip: &StablePush,
    twist: &Twist<f64>,
    duration: f64,
    samples: u32,
) -> PushPath {
    let push = QuasiStaticPush {
        mode: ContactMode::Sticking,
        twist: *twist,
        contact_velocity: contact.velocity(twist),
        slip: Vector2::zeros(),
        wrench: grip.wrench,
    };
    let moment = |sample: u32| {
        let time = duration * (f64::from(sample) / f64::from(samples));
        let angle = twist.spin * time;
        // The mean of the velocity's direction over the turn: sin(a)/a and (1 − cos a)/a.
        let (along, across) = if angle == 0.0 {
            (1.0, 0.0)
        } else {
            let half = Real::sin(0.5 * angle);
            (Real::sin(angle) / angle, 2.0 * half * half / angle)
        };
        let v = twist.velocity * time;
        PathSample {
            time,
            pose: Pose {
                x: along * v.x - across * v.y,
                y: across * v.x + along * v.y,
                angle,
            },
            contact: contact.position(),
            push,
        }
    };
    let (last, end) = if grip.is_stable {
        (samples, PathEnd::Done)
    } else {
        (0, PathEnd::Loose)
    };
    PushPath {
        moments: (0..=last).map(moment).collect(),
        end,
        steps: 0,
    }
}

fn ended(at: &PathSample) -> Option<PathEnd> {
    (at.push.mode == ContactMode::Separating).then_some(PathEnd::Separated)
}

/// Place of the patch's origin, and angle.
type State = Vector3<f64>;

struct Path<'a> {
    set: &'a dyn FrictionSet<f64>,
    drive: &'a Pusher,
    velocity: Vector2<f64>,
    /// Where the pusher is at the start.
    pusher: Vector2<f64>,
}

impl<'a> Path<'a> {
    fn new(set: &'a dyn FrictionSet<f64>, drive: &'a Pusher) -> Result<Self, PushError> {
        let [x, y] = drive.velocity;
        let start = &drive.start;
        for (what, number) in [
            ("x of the pusher's velocity", x),
            ("y of the pusher's velocity", y),
            ("x of the start", start.x),
            ("y of the start", start.y),
            ("the angle of the start", start.angle),
        ] {
            finite(what, number)?;
        }
        for (what, given) in [
            ("the duration", drive.duration),
            ("the tolerance", drive.tolerance),
        ] {
            if !(given > 0.0 && given.is_finite()) {
                let domain = "a finite number > 0";
                return Err(PushError::Number {
                    what,
                    domain,
                    given,
                });
            }
        }
        Ok(Self {
            set,
            drive,
            velocity: Vector2::new(x, y),
            pusher: start.place(drive.contact.position()),
        })
    }

    fn moment(&self, time: f64, state: &State) -> Result<PathSample, PushError> {
        let pose = Pose {
            x: state.x,
            y: state.y,
            angle: state.z,
        };
        // The pusher's own path is exact: the contact is where it is.
        let contact = pose.in_body(self.pusher + self.velocity * time);
        let velocity = turned(self.velocity, -pose.angle);
        let touching = match self.drive.side {
            PushedSide::Straight { .. } => self.drive.contact.moved_to(contact),
            PushedSide::Round => {
                let inward = [-contact.x, -contact.y];
                PointContact::new(contact.into(), inward, self.drive.contact.coefficient())?
            }
        };
        Ok(PathSample {
            time,
            pose,
            contact,
            push: touching.push(self.set, velocity.into())?,
        })
    }

    fn rate(&self, time: f64, state: &State) -> Result<State, PushError> {
        let twist = self.moment(time, state)?.push.twist;
        let velocity = turned(twist.velocity, state.z);
        Ok(Vector3::new(velocity.x, velocity.y, twist.spin))
    }

    /// One step of fourth order.
    fn rk4_step(&self, time: f64, from: &State, length: f64) -> Result<State, PushError> {
        let half = 0.5 * length;
        let first = self.rate(time, from)?;
        let second = self.rate(time + half, &(from + first * half))?;
        let third = self.rate(time + half, &(from + second * half))?;
        let fourth = self.rate(time + length, &(from + third * length))?;
        Ok(from + (first + (second + third) * 2.0 + fourth) * (length / 6.0))
    }

    /// Two steps of half the length, and their error.
    fn step_with_error(
        &self,
        time: f64,
        from: &State,
        length: f64,
    ) -> Result<(State, f64), PushError> {
        let half = 0.5 * length;
        let whole = self.rk4_step(time, from, length)?;
        let middle = self.rk4_step(time, from, half)?;
        let halves = self.rk4_step(time + half, &middle, half)?;
        let off = halves - whole;
        let turn = off.z * self.set.radius();
        let error = Real::hypot(Real::hypot(off.x, off.y), turn);
        Ok((halves, RICHARDSON * error))
    }

    /// What rounding alone makes of a step's error.
    fn rounding(&self, time: f64, state: &State) -> f64 {
        let pusher = self.pusher + self.velocity * time;
        let turn = state.z.abs() * self.set.radius();
        let place = state.x.abs().max(state.y.abs()).max(pusher.amax());
        ROUNDING_ULPS * f64::EPSILON * place.max(turn)
    }

    fn is_on_side(&self, at: &PathSample) -> bool {
        match self.drive.side {
            PushedSide::Straight { right, left } => {
                let contact = &self.drive.contact;
                let along = contact.tangent().dot(&(at.contact - contact.position()));
                -right <= along && along <= left
            }
            PushedSide::Round => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_friction::Area;

    #[test]
    fn the_end_of_a_side_is_found_to_any_tolerance() {
        let table = Area::named(&"box:0.3x0.2".parse().unwrap(), 1.0, None)
            .unwrap()
            .limit_surface(8.0)
            .unwrap();
        for tolerance in [1e-5, 1e-7, 1e-9, 1e-11] {
            let journey = Pusher {
                contact: PointContact::new([0.05, -0.1], [0.0, 1.0], 0.1).unwrap(),
                side: PushedSide::Straight {
                    right: 0.01,
                    left: 0.01,
                },
                start: Pose::default(),
                velocity: [0.0, 0.02],
                duration: 100.0,
                samples: 100,
                tolerance,
            }
            .path(&*table)
            .unwrap();
            assert_eq!(journey.end, PathEnd::Slipped);
            let last = journey.moments.last().unwrap();
            assert!(
                (last.contact.x - 0.04).abs() < 1e-11 + tolerance,
                "{tolerance}"
            );
            assert!(journey.steps < 20_000, "{tolerance} {}", journey.steps);
        }
    }
}
