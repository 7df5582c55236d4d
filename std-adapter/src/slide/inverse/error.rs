//! Why there is no launch.

use super::{Limits, Pose, Solution};
use tribos_core::Error;

/// Why a rest pose was not inverted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum InverseError {
    /// The kernel refused the body.
    #[error(transparent)]
    Body(#[from] Error),
    /// α ≥ 1.
    #[error("a body under |v|^{alpha} never comes to rest; the inverse problem needs alpha < 1")]
    NeverRests {
        /// The exponent.
        alpha: f64,
    },
    /// A limit is negative, infinite or NaN.
    #[error("the largest {name} must be finite and not negative, not {given}")]
    Limit {
        /// Which one.
        name: &'static str,
        /// What was given.
        given: f64,
    },
    /// The target is not finite, or so far that the launch leaves the number range.
    #[error(
        "the target x {} m, y {} m, angle {} rad is not finite or its launch is not",
        given.x, given.y, given.angle
    )]
    Target {
        /// What was given.
        given: Pose,
    },
    /// More solutions than anyone reads.
    #[error(
        "{count} numbers of turns lead there; lower the largest spin or ask for an exact angle"
    )]
    TooMany {
        /// Their number.
        count: u64,
    },
    /// No launch within the limits.
    #[error(transparent)]
    OutOfReach(Box<OutOfReach>),
}

/// A target beyond the limits: what it takes, and what the limits allow.
///
/// ```
/// use tribos::slide::inverse::{InverseError, Limits, OutOfReach, Pose, RestMap, Turns};
/// use tribos::kernel::coupling::table::Coulomb;
/// let disk = RestMap::new(Coulomb, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let (target, limits) = (Pose { x: 10.0, y: 0.0, angle: 0.0 }, Limits::new(3.0, 100.0)?);
/// let thrown = disk.launches(&target, Turns::Exact, &limits);
/// let Err(InverseError::OutOfReach(why)) = thrown else { unreachable!() };
/// let OutOfReach { needed, distances, .. } = *why;
/// // Without spin the way is v²/(2 mu g).
/// assert!((needed.speed - (2.0_f64 * 0.3 * 9.81 * 10.0).sqrt()).abs() < 1e-12);
/// let farthest = distances.ok_or(InverseError::Target { given: target })?[1];
/// assert!((farthest - 3.0 * 3.0 / (2.0 * 0.3 * 9.81)).abs() < 1e-12);
/// # Ok::<(), tribos::slide::inverse::InverseError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfReach {
    /// The launch that exceeds the limits least.
    pub needed: Solution,
    /// The limits.
    pub limits: Limits,
    /// Distance of the target, m.
    pub distance: f64,
    /// Shortest and farthest distance within the limits with the angle of `needed`, m; none if
    /// the body cannot turn that far.
    pub distances: Option<[f64; 2]>,
    /// Farthest distance within the limits at any angle, m.
    pub farthest: f64,
    /// Largest angle within the limits at any distance, rad.
    pub most: f64,
}

impl std::error::Error for OutOfReach {}

impl std::fmt::Display for OutOfReach {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let needed = self.needed;
        let (most_speed, most_spin) = (self.limits.max_speed(), self.limits.max_spin());
        write!(
            f,
            "out of reach: {} m away after turning {} rad takes {} m/s and {} rad/s, the limits are \
             {} m/s and {} rad/s",
            shown(self.distance),
            shown(needed.angle),
            beyond(needed.speed, most_speed),
            beyond(needed.launch.spin, most_spin),
            given(most_speed),
            given(most_spin),
        )?;
        match self.distances {
            Some([nearest, farthest]) => write!(
                f,
                "; with this angle they reach from {} to {} m",
                shown(nearest),
                shown(farthest)
            )?,
            None => f.write_str("; they do not turn it that far")?,
        }
        write!(
            f,
            " (at full speed and spin {} m and {} rad)",
            shown(self.farthest),
            shown(self.most)
        )
    }
}

/// Magnitudes that six decimals tell.
const EVERYDAY: std::ops::Range<f64> = 1e-3..1e9;

fn is_everyday(x: f64) -> bool {
    x == 0.0 || EVERYDAY.contains(&x.abs())
}

/// Six decimals, or seven digits where those would lose them.
fn shown(x: f64) -> String {
    if is_everyday(x) {
        format!("{x:.6}")
    } else {
        format!("{x:.6e}")
    }
}

/// A limit as it was given.
fn given(x: f64) -> String {
    if is_everyday(x) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// What is needed; with all digits where fewer would not show that it is beyond the limit.
fn beyond(needed: f64, limit: f64) -> String {
    let text = shown(needed);
    let is_rounded_away = text.parse().is_ok_and(|x: f64| x.abs() <= limit);
    if needed.abs() > limit && is_rounded_away {
        format!("{needed:?}")
    } else {
        text
    }
}
