//! Why no launch was found.

use super::{LaunchLimits, LaunchSolution};

/// A target beyond the launch limits: the launch it needs, and the reach of the limits.
///
/// ```
/// use tribos::slide::inverse::{MotionError, LaunchLimits, OutOfReach, Pose, RestMap, Turns};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let (target, limits) = (Pose { x: 10.0, y: 0.0, angle: 0.0 }, LaunchLimits::new(3.0, 100.0)?);
/// let thrown = disk.launches(&target, Turns::Exact, &limits);
/// let Err(MotionError::OutOfReach(why)) = thrown else { unreachable!() };
/// let OutOfReach { needed, distances, .. } = *why;
/// // Without spin the way is v²/(2 mu g).
/// assert!((needed.speed - (2.0_f64 * 0.3 * 9.81 * 10.0).sqrt()).abs() < 1e-12);
/// let farthest = distances.ok_or(MotionError::Target { given: target })?[1];
/// assert!((farthest - 3.0 * 3.0 / (2.0 * 0.3 * 9.81)).abs() < 1e-12);
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
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
