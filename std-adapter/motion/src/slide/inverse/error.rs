//! Why no launch was found.

use super::{LaunchLimits, LaunchSolution, Pose};
use tribos_core::Error;

/// Why a rest pose could not be inverted.
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
    /// A launch limit is negative, infinite or NaN.
    #[error("the largest {name} must be finite and not negative, not {given}")]
    Limit {
        /// Name of the limit.
        name: &'static str,
        /// Value given.
        given: f64,
    },
    /// The target is not finite, or so far away that the launch exceeds the range of numbers.
    #[error(
        "the target x {} m, y {} m, angle {} rad is not finite or its launch is not",
        given.x, given.y, given.angle
    )]
    Target {
        /// Target given.
        given: Pose,
    },
    /// There are more solutions than can usefully be listed.
    #[error(
        "{count} numbers of turns lead there; lower the largest spin or ask for an exact angle"
    )]
    TooMany {
        /// Number of solutions.
        count: u64,
    },
    /// No launch within the limits reaches the target.
    #[error(transparent)]
    OutOfReach(Box<OutOfReach>),
}

/// A target beyond the launch limits: the launch it needs, and the reach of the limits.
///
/// ```
/// use tribos::slide::inverse::{InverseError, LaunchLimits, OutOfReach, Pose, RestMap, Turns};
/// use tribos::kernel::coupling::table::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let (target, limits) = (Pose { x: 10.0, y: 0.0, angle: 0.0 }, LaunchLimits::new(3.0, 100.0)?);
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
    /// The launch that exceeds the limits by the least.
    pub needed: LaunchSolution,
    /// The launch limits.
    pub limits: LaunchLimits,
    /// Distance of the target, in m.
    pub distance: f64,
    /// Shortest and longest distance within the limits for the angle of `needed`, in m; `None` if
    /// the body cannot turn that far.
    pub distances: Option<[f64; 2]>,
    /// Longest distance within the limits at any angle, in m.
    pub farthest: f64,
    /// Largest angle within the limits at any distance, in rad.
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

/// Range of magnitudes that six decimals represent well.
const EVERYDAY: std::ops::Range<f64> = 1e-3..1e9;

fn is_everyday(x: f64) -> bool {
    x == 0.0 || EVERYDAY.contains(&x.abs())
}

/// Six decimals, or seven significant digits where six decimals would lose them.
fn shown(x: f64) -> String {
    if is_everyday(x) {
        format!("{x:.6}")
    } else {
        format!("{x:.6e}")
    }
}

/// A limit in the form in which it was given.
fn given(x: f64) -> String {
    if is_everyday(x) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// The needed value, with all digits where fewer would not show that it exceeds the limit.
fn beyond(needed: f64, limit: f64) -> String {
    let text = shown(needed);
    let is_rounded_away = text.parse().is_ok_and(|x: f64| x.abs() <= limit);
    if needed.abs() > limit && is_rounded_away {
        format!("{needed:?}")
    } else {
        text
    }
}
