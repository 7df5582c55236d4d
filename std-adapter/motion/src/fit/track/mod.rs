//! Friction, radius and launch of a body that was filmed while it slides on a level floor.
//!
//! The motion is the crate's own: under Coulomb's law or a power of the speed on a round patch the slider's steps from
//! frame to frame, exact to rounding; under other laws and on patches with straight edges the journey in the plane
//! to 1e-9. A round body goes straight, and only coefficient, speed and rim speed enter; place, direction, angle and, with
//! the rim speed kept, radius are linear.
//!
//! - x, y and angle are fitted together, each with its own noise, which their residuals tell unless it is given.
//! - The first search is robust (Huber 1964); then readings beyond 6 standard deviations are left out, at most 5 % of
//!   the frames.
//! - Intervals are those of the profile: the sum of squares, with all other parameters at their best, rises by t² of
//!   the noise. They join all minima that the frames do not exclude.
//! - The noise of positions and of angles is that of their own residuals, and t has its degrees of freedom.
//! - Without the angle the film tells the ratio v/(|ω|R) in place of radius and spin, and the coefficient trades with it:
//!   intervals join all that a scan of the ratio from 1/148 to 148 allows. Where that includes no spin, the motion without spin
//!   is reported.
//!
//! A tilted floor, a body that leans and a load off its centre are not in it; a path that bends is reported.
//!
//! ```
//! use tribos::fit::track::{Track, TrackOptions, fit_track};
//! // A puck that is known not to spin: 1 m/s, μ = 0.2, g = 9.81 m/s². Without that, one that spins under a larger
//! // coefficient would fit as well.
//! let times: Vec<f64> = (0..30).map(|k| f64::from(k) / 60.0).collect();
//! let x = times.iter().map(|t| t - 0.5 * 0.2 * 9.81 * t * t).collect();
//! let track = Track::new(times, x, vec![0.0; 30], None)?;
//! let options = TrackOptions { fixed: vec![("ratio".into(), 1000.0)], ..TrackOptions::default() };
//! let found = fit_track(&track, &options)?;
//! let mu = found.value("mu").ok_or("no mu")?;
//! assert!((mu - 0.2).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod body;
mod errors;
mod film;
mod fit;
mod law;
mod march;
mod model;
mod profile;
mod scan;
mod shown;
mod start;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
mod untold;
mod weighted;
mod words;

pub use film::Track;
pub use law::TrackLaw;

use super::{Estimate, FitError};
use tribos_friction::Patch;

/// How a film is fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackOptions {
    /// Law of the local speed.
    pub law: TrackLaw,
    /// The patch on which the body slides; the radius of a round one is found or fixed as `R`.
    pub patch: Patch,
    /// Gravity, in m/s².
    pub gravity: f64,
    /// I/(M R²) of a round body; one with edges is of uniform thickness.
    pub inertia_ratio: f64,
    /// Parameters that keep these values.
    pub fixed: Vec<(String, f64)>,
    /// Number of starts, at least 1.
    pub starts: usize,
    /// Frames at the beginning that are not used.
    pub skip: usize,
    /// First time that is used, in s.
    pub from: Option<f64>,
    /// Last time that is used, in s.
    pub to: Option<f64>,
    /// Standard deviation of a coordinate in m; none to take it from the residuals.
    pub noise_position: Option<f64>,
    /// Standard deviation of the angle in rad; none to take it from the residuals.
    pub noise_angle: Option<f64>,
}

impl Default for TrackOptions {
    /// A solid disk under Coulomb's law and 9.81 m/s², all frames, 8 starts.
    fn default() -> Self {
        Self {
            law: TrackLaw::Coulomb,
            patch: Patch::Disk,
            gravity: 9.81,
            inertia_ratio: 0.5,
            fixed: Vec::new(),
            starts: 8,
            skip: 0,
            from: None,
            to: None,
            noise_position: None,
            noise_angle: None,
        }
    }
}

/// A motion fitted to a film.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackFit {
    /// The law, as other commands take it.
    pub law: String,
    /// Parameters of the law, `R` or `ratio`, and the launch at the first frame.
    pub parameters: Vec<Estimate>,
    /// Number of frames that were taken.
    pub frames: usize,
    /// Those of them of which a reading was left out.
    pub dropped: Vec<usize>,
    /// Number of readings minus number of free parameters.
    pub freedoms: usize,
    /// Starts from which a search was possible.
    pub starts: usize,
    /// Number of starts that ended at the best minimum.
    pub at_best: usize,
    /// Whether only rounding limited further descent.
    pub converged: bool,
    /// Root mean square of the residuals of a coordinate, in m.
    pub rms_position: f64,
    /// Root mean square of the residuals of the angle, in rad.
    pub rms_angle: Option<f64>,
    /// Reading less fitted motion: x of all frames, y of all, and the angle of all if there is one.
    pub residuals: Vec<f64>,
    /// Fitted speed at each frame, in m/s.
    pub speeds: Vec<f64>,
    /// v/(|spin| R) at the first frame.
    pub ratio: f64,
    /// Time of the film at which the body stops sliding, in s; none if it does not soon.
    pub rest_time: Option<f64>,
    /// The frames that were taken.
    pub track: Track,
    /// What is to be known of this fit.
    pub warnings: Vec<String>,
}

impl TrackFit {
    /// The value of a parameter.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.estimate(name).map(|estimate| estimate.value)
    }

    /// A parameter by its name.
    pub fn estimate(&self, name: &str) -> Option<&Estimate> {
        self.parameters
            .iter()
            .find(|estimate| estimate.parameter.name == name)
    }

    /// The values of all parameters.
    fn values(&self) -> Vec<f64> {
        self.parameters
            .iter()
            .map(|estimate| estimate.value)
            .collect()
    }
}

/// Fits the motion of a body to the frames of a film.
///
/// *Cost*: 0.1 to 0.3 s for a round body under Coulomb's law and 100 frames; seconds for other laws and for boxes.
pub fn fit_track(track: &Track, options: &TrackOptions) -> Result<TrackFit, FitError> {
    fit::fit(track, options)
}
