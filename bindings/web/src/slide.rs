//! Free motions on a round patch, to rest or over a time.

use crate::exchange::Refused;
use crate::modes::FinalMotion;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::real::Real;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// A free motion, or why there is none.
pub type Free = Result<End, Refused>;

/// The end of a free motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Time, speeds and way.
    pub motion: SliderState<f64>,
    /// The ratio of sliding to rim speed in the limit of rest; NaN if the body still moves.
    pub ratio: f64,
    /// Whether the body has come to rest.
    pub is_at_rest: bool,
}

/// What nothing finite comes of.
const NOT_FINITE: End = End {
    motion: SliderState {
        time: f64::NAN,
        speed: f64::NAN,
        spin: f64::NAN,
        distance: f64::NAN,
        angle: f64::NAN,
    },
    ratio: f64::NAN,
    is_at_rest: false,
};

impl End {
    /// To rest; NaN for a motion that is not finite.
    pub fn to_rest<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
        profile: P,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
    ) -> Free {
        let alpha = profile.exponent();
        if alpha >= 1.0 {
            return Err(Refused::Because(
                "a body never comes to rest where friction fades with the speed: this needs alpha < 1; \
                 advance follows it over a given time",
            ));
        }
        let rest = Slider::new(profile, parameters)?.to_rest(from);
        Ok(rest.map_or(NOT_FINITE, |rest| Self {
            motion: rest.motion,
            ratio: rest.ratio,
            is_at_rest: true,
        }))
    }

    /// After a time, also past rest; NaN for a motion or a time that is not finite.
    pub fn advance<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
        profile: P,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
        time: f64,
    ) -> Free {
        let slider = Slider::new(profile, parameters)?;
        if !(from.speed.is_finite() && from.spin.is_finite() && time.is_finite()) {
            return Ok(NOT_FINITE);
        }
        let end = slider.advance(from, time);
        // From the time of rest on the body stays where it is.
        let motion = end.rest.map_or(end.motion, |rest| rest.motion);
        Ok(Self {
            motion: SliderState { time, ..motion },
            ratio: end.rest.map_or(f64::NAN, |rest| rest.ratio),
            is_at_rest: end.rest.is_some() || (from.speed == 0.0 && from.spin == 0.0),
        })
    }
}

/// Free motion on a round patch under a power of the speed.
pub trait Glides {
    /// See [`End::to_rest`].
    fn to_rest(&self, parameters: SliderParameters<f64>, from: &SliderState<f64>) -> Free;
    /// See [`End::advance`].
    fn advance(
        &self,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
        time: f64,
    ) -> Free;
    /// Fixed points and last motion.
    fn modes(&self, inertia_ratio: f64, initial_ratio: f64) -> Result<FinalMotion, Refused>;
}

impl<P> Glides for P
where
    P: PowerLawFriction<f64> + ReducedFriction<f64>,
{
    fn to_rest(&self, parameters: SliderParameters<f64>, from: &SliderState<f64>) -> Free {
        End::to_rest(self, parameters, from)
    }
    fn advance(
        &self,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
        time: f64,
    ) -> Free {
        End::advance(self, parameters, from, time)
    }
    fn modes(&self, inertia_ratio: f64, initial_ratio: f64) -> Result<FinalMotion, Refused> {
        FinalMotion::new(self, inertia_ratio, initial_ratio)
    }
}

/// A body by what its free motion depends on, and its launch.
#[derive(Clone, Copy, Debug)]
pub struct LaunchedBody {
    /// Deceleration of pure sliding and I/(M R²).
    pub parameters: SliderParameters<f64>,
    /// Velocity and spin.
    pub twist: [f64; 3],
}

impl LaunchedBody {
    /// Speed and direction of the launch.
    fn start(&self) -> (SliderState<f64>, [f64; 2]) {
        let [vx, vy, spin] = self.twist;
        let speed = Real::hypot(vx, vy);
        let direction = if speed == 0.0 {
            [0.0; 2]
        } else {
            [vx / speed, vy / speed]
        };
        (SliderState::launched(speed, spin), direction)
    }

    /// Time, distance, x, y, angle and last ratio at rest on a patch.
    pub fn rest(&self, patch: &dyn Glides) -> Result<[f64; 6], Refused> {
        let (start, [x, y]) = self.start();
        let end = patch.to_rest(self.parameters, &start)?;
        let SliderState {
            time,
            distance,
            angle,
            ..
        } = end.motion;
        Ok([time, distance, distance * x, distance * y, angle, end.ratio])
    }

    /// Time, x, y, angle, velocity, spin after a time, and 1 at rest.
    pub fn after(&self, patch: &dyn Glides, time: f64) -> Result<[f64; 8], Refused> {
        let (start, direction) = self.start();
        let end = patch.advance(self.parameters, &start, time)?;
        let [t, x, y, angle, vx, vy, spin] = row(&end.motion, direction);
        let rests = if end.is_at_rest { 1.0 } else { 0.0 };
        Ok([t, x, y, angle, vx, vy, spin, rests])
    }

    /// Rows at even times from the launch to rest. Every one is reached from the launch by itself, so that no
    /// error grows along the path.
    pub fn path(&self, patch: &dyn Glides, rows: &mut [[f64; 7]]) -> Result<(), Refused> {
        let (start, direction) = self.start();
        let last = rows.len().saturating_sub(1);
        let end = patch.to_rest(self.parameters, &start)?;
        for (index, place) in rows.iter_mut().enumerate() {
            let time = end.motion.time * (index as f64 / last as f64);
            let motion = if index == last {
                end.motion
            } else {
                patch.advance(self.parameters, &start, time)?.motion
            };
            *place = row(&motion, direction);
        }
        Ok(())
    }
}

/// Time, x, y, angle, velocity and spin.
fn row(motion: &SliderState<f64>, [x, y]: [f64; 2]) -> [f64; 7] {
    let SliderState {
        time,
        speed,
        spin,
        distance,
        angle,
    } = *motion;
    [
        time,
        distance * x,
        distance * y,
        angle,
        speed * x,
        speed * y,
        spin,
    ]
}
