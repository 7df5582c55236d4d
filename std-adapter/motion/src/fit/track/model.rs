//! A film as a model of least squares: coordinates of all frames from law, radius and launch.

use super::super::parameter::{FitParameter, Model, Range};
use super::body::Body;
use super::film::Track;
use super::march::FilmedPlace;
use super::start::Guess;
use crate::slide::Launch;
use std::sync::{Arc, Mutex, PoisonError};

const fn any(name: &'static str, unit: &'static str, meaning: &'static str) -> FitParameter {
    FitParameter {
        name,
        unit,
        meaning,
        range: Range::Any,
    }
}

const RADIUS: FitParameter = FitParameter {
    range: Range::Positive,
    ..any("R", "m", "radius of the patch")
};
const RATIO: FitParameter = FitParameter {
    range: Range::Positive,
    ..any("ratio", "-", "v/(|spin| R) at the first frame")
};
const PLACE: [FitParameter; 4] = [
    any("x0", "m", "place at the first frame"),
    any("y0", "m", "place at the first frame"),
    any("vx", "m/s", "velocity at the first frame"),
    any("vy", "m/s", "velocity at the first frame"),
];
const TURN: [FitParameter; 2] = [
    any("angle0", "rad", "angle at the first frame"),
    any("spin", "rad/s", "spin at the first frame"),
];

/// What a film tells of the spin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turning {
    /// The angle of a round body: its radius and spin.
    Radius,
    /// No angle: the ratio of sliding to spinning at the first frame.
    Ratio,
    /// The angle of a body with edges, whose size is known.
    Edges,
}

/// Values of the parameters after those of the law.
#[derive(Clone, Copy, Debug)]
struct Start {
    place: [f64; 2],
    velocity: [f64; 2],
    angle: f64,
    spin: f64,
    /// R, or the ratio, or neither.
    size: f64,
}

/// The model of a film.
pub(super) struct TrackModel<'a> {
    track: &'a Track,
    /// Times since the first frame.
    times: Vec<f64>,
    pub body: &'a Body,
    pub turning: Turning,
    parameters: Vec<FitParameter>,
    guess: Guess,
    /// Motions that were followed last, the newest first.
    kept: Mutex<Vec<Followed>>,
}

/// What decides a motion, and the motion.
struct Followed {
    key: Vec<f64>,
    places: Arc<[FilmedPlace]>,
}

/// Motions that are kept: one Jacobian asks for no more.
const KEPT: usize = 32;

impl<'a> TrackModel<'a> {
    pub fn new(track: &'a Track, body: &'a Body) -> Self {
        let turning = match (track.angle(), body.is_round()) {
            (Some(_), true) => Turning::Radius,
            (Some(_), false) => Turning::Edges,
            (None, _) => Turning::Ratio,
        };
        let size: &[FitParameter] = match turning {
            Turning::Radius => &[RADIUS],
            Turning::Ratio => &[RATIO],
            Turning::Edges => &[],
        };
        let turn: &[FitParameter] = match turning {
            Turning::Ratio => &[],
            Turning::Radius | Turning::Edges => &TURN,
        };
        let parts = [body.law.parameters(), size, &PLACE, turn];
        let first = track.times().first().copied().unwrap_or(0.0);
        Self {
            track,
            times: track.times().iter().map(|t| t - first).collect(),
            body,
            turning,
            parameters: parts.concat(),
            guess: Guess::of(track, body),
            kept: Mutex::new(Vec::new()),
        }
    }

    /// Number of frames.
    pub fn frames(&self) -> usize {
        self.times.len()
    }

    /// The coordinates as they were filmed, in the order of the predictions.
    pub fn measured(&self) -> Vec<f64> {
        let angle = self.track.angle().unwrap_or_default();
        [self.track.x(), self.track.y(), angle].concat()
    }

    /// Lengths over which predictions change, of the parameters that are not positive.
    pub fn scale(&self, name: &str) -> f64 {
        let speed = libm::hypot(self.guess.velocity[0], self.guess.velocity[1]);
        match name {
            "x0" | "y0" => self.track.extent(),
            "vx" | "vy" => speed,
            "spin" => self.guess.spin.abs(),
            _ => 1.0,
        }
    }

    fn start_of(&self, values: &[f64]) -> Option<Start> {
        let (_, rest) = values.split_at_checked(self.body.law.parameters().len())?;
        Some(match (self.turning, rest) {
            (Turning::Radius, &[size, x, y, vx, vy, angle, spin]) => Start {
                place: [x, y],
                velocity: [vx, vy],
                angle,
                spin,
                size,
            },
            (Turning::Ratio, &[size, x, y, vx, vy]) => Start {
                place: [x, y],
                velocity: [vx, vy],
                angle: 0.0,
                spin: 0.0,
                size,
            },
            (Turning::Edges, &[x, y, vx, vy, angle, spin]) => Start {
                place: [x, y],
                velocity: [vx, vy],
                angle,
                spin,
                size: 1.0,
            },
            _ => return None,
        })
    }

    /// Speed and rim speed at the first frame.
    pub fn speeds(&self, values: &[f64]) -> [f64; 2] {
        let Some(start) = self.start_of(values) else {
            return [f64::NAN; 2];
        };
        let speed = libm::hypot(start.velocity[0], start.velocity[1]);
        let rim = match self.turning {
            Turning::Ratio => speed / start.size,
            Turning::Radius | Turning::Edges => start.spin.abs() * start.size,
        };
        [speed, rim]
    }

    /// The motion at times since the first frame, in the coordinates of the launch.
    pub fn motion(&self, values: &[f64], times: &[f64]) -> Option<Vec<FilmedPlace>> {
        let law = values.get(..self.body.law.parameters().len())?;
        let Start {
            velocity,
            angle,
            spin,
            ..
        } = self.start_of(values)?;
        match self.turning {
            Turning::Edges => {
                let launch = Launch { velocity, spin };
                self.body.plate(law[0], &launch, angle, times)
            }
            Turning::Radius | Turning::Ratio => self.body.roll_out(law, self.speeds(values), times),
        }
    }

    /// The motion at the frames, followed once for launches that differ in place and direction alone.
    fn followed(&self, values: &[f64]) -> Option<Arc<[FilmedPlace]>> {
        let law = values.get(..self.body.law.parameters().len())?;
        let start = self.start_of(values)?;
        let mut key = law.to_vec();
        match self.turning {
            Turning::Edges => {
                key.extend([
                    start.velocity[0],
                    start.velocity[1],
                    start.angle,
                    start.spin,
                ]);
            }
            Turning::Radius | Turning::Ratio => key.extend(self.speeds(values)),
        }
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(at) = kept.iter().position(|known| known.key == key) {
            kept[..=at].rotate_right(1);
            return kept.first().map(|known| Arc::clone(&known.places));
        }
        let places: Arc<[FilmedPlace]> = self.motion(values, &self.times)?.into();
        kept.truncate(KEPT - 1);
        let known = Followed {
            key,
            places: Arc::clone(&places),
        };
        kept.insert(0, known);
        Some(places)
    }

    /// Speed of the centre at each frame.
    pub fn speed_at_frames(&self, values: &[f64]) -> Option<Vec<f64>> {
        let places = self.followed(values)?;
        Some(places.iter().map(|place| place.speed).collect())
    }

    /// Direction of the launch, and the factor of the way turned.
    fn frame_of_launch(&self, start: &Start) -> ([f64; 2], f64) {
        let [vx, vy] = start.velocity;
        let speed = libm::hypot(vx, vy);
        match self.turning {
            Turning::Edges => ([1.0, 0.0], 1.0),
            _ if speed > 0.0 => {
                let direction = [vx / speed, vy / speed];
                (direction, 1.0_f64.copysign(start.spin) / start.size)
            }
            _ => ([1.0, 0.0], 1.0_f64.copysign(start.spin) / start.size),
        }
    }
}

impl Model for TrackModel<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &self.parameters
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        self.body.law.usual(parameter)
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let start = self.start_of(values)?;
        let places = self.followed(values)?;
        let ([cos, sin], per_turned) = self.frame_of_launch(&start);
        let x = |place: &FilmedPlace| start.place[0] + cos * place.way[0] - sin * place.way[1];
        let y = |place: &FilmedPlace| start.place[1] + sin * place.way[0] + cos * place.way[1];
        let mut all: Vec<f64> = places.iter().map(x).collect();
        all.extend(places.iter().map(y));
        if self.turning != Turning::Ratio {
            all.extend(places.iter().map(|at| start.angle + per_turned * at.turned));
        }
        Some(all)
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        let u = |k: usize| unit.get(k).copied().unwrap_or(0.5);
        let guess = &self.guess;
        let speed = libm::hypot(guess.velocity[0], guess.velocity[1]);
        // Half to double the coefficient, a third to three times the radius.
        let mu = guess.mu * libm::pow(4.0, u(0) - 0.5);
        let mut values = self.body.law.like(mu, speed, u(2));
        match self.turning {
            Turning::Radius => values.push(guess.radius * libm::pow(9.0, u(1) - 0.5)),
            // Ratios from 1/16 to 16.
            Turning::Ratio => values.push(libm::pow(256.0, u(1) - 0.5)),
            Turning::Edges => {}
        }
        values.extend(guess.place);
        values.extend(guess.velocity);
        if self.turning != Turning::Ratio {
            values.extend([guess.angle, guess.spin]);
        }
        values
    }
}
