//! The summary of a body on a spring.

use super::tally::RunStatistics;
use tribos_base::results::{Reporting::*, summary};

/// How a body follows the pull in the end.
///
/// ```
/// use tribos::scene::SpringScene;
/// use tribos::stick::spring::StickSlipRegime;
/// let block = SpringScene::default(); // mu_s = 0.5, mu_d = 0.3
/// assert_eq!(block.run()?.outcome.regime, StickSlipRegime::StickSlip);
/// # Ok::<(), tribos::stick::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StickSlipRegime {
    /// It never lets go.
    Rests,
    /// It slides steadily where friction falls with the speed: Heslot's creep regime.
    Creeps,
    /// It slides steadily where friction does not fall.
    Steady,
    /// Its speed swings about that of the pull and does not fade, without rest.
    Oscillates,
    /// It rests, or nearly, and slips by turns.
    StickSlip,
}

summary! {
    /// A hold and the force that it took to slide on.
    #[derive(Copy)]
    pub struct HoldPeak = part;

    /// How long the pull stood still.
    hold: f64, "s";
    /// Spring force when the hold began.
    force_before: f64, "N";
    /// Largest spring force after it.
    peak_force: f64, "N";
}

summary! {
    /// Results of a run; forces, period and shares are of the second half of the last pull.
    ///
    /// ```
    /// use tribos::scene::SpringScene;
    /// use tribos::stick::spring::SpringSummary;
    /// let SpringSummary { most_force, period, .. } = SpringScene::default().run()?.outcome;
    /// assert!(most_force > 0.5 * 9.81 && period.is_some()); // mu_s N, and a little beyond
    /// # Ok::<(), tribos::stick::MotionError>(())
    /// ```
    pub struct SpringSummary;

    /// How the body follows the pull.
    regime: StickSlipRegime, "-";
    /// Whether its speed left all bounds, which ends a run without mass and viscous term.
    ran_away: bool, "-";
    /// Time at the end.
    end_time: f64, "s";
    /// Mean spring force.
    mean_force: f64, "N", Shown("mean");
    /// Least spring force.
    least_force: f64, "N", Swept;
    /// Largest spring force.
    most_force: f64, "N", Swept;
    /// Half the difference of both.
    amplitude: f64, "N", Shown("amplitude");
    /// Largest speed.
    most_speed: f64, "m/s", Swept;
    /// Mean time between starts of slips; none if fewer than two begin.
    period: Option<f64>, "s", Shown("period");
    /// Number of slips that begin in the whole run.
    slips: u64, "-", Swept;
    /// Share of the time in which the body slips.
    slip_share: f64, "-", Shown("slip share");
    /// Swing of the speed in the last quarter over that in the quarter before; 1 while it lasts.
    swing_ratio: f64, "-";
    /// Distance over which the body has moved in the whole run.
    distance: f64, "m", Swept;
    /// Work of the pull in the whole run.
    work: f64, "J", Swept;
    /// The holds.
    holds: Vec<HoldPeak>, "-";
    /// Growth of peak force over load per e-fold of the hold, by least squares; none of fewer than two.
    healing: Option<f64>, "-";
    /// Stiffness below which rate and state cannot be pulled steadily; none for other laws.
    critical_stiffness: Option<f64>, "N/m", Swept;
    /// Steps taken.
    steps: u64, "-", Swept;
}

/// Swing of the speed, in speeds of the pull, that counts as steady.
const STEADY: f64 = 0.01;
/// Ratio of the swings of the last two quarters below which an oscillation fades.
const FADES: f64 = 0.9;

/// The regime from both quarters of the second half, in this order.
pub(super) fn regime(quarters: &[RunStatistics; 2], speed: f64, weakens: bool) -> StickSlipRegime {
    let [third, last] = quarters;
    let slips = third.slip_time + last.slip_time;
    let time = third.time + last.time;
    let swings = quarters.each_ref().map(|quarter| quarter.velocity.swing());
    if slips == 0.0 {
        StickSlipRegime::Rests
    } else if slips < time * (1.0 - f64::EPSILON.sqrt()) {
        StickSlipRegime::StickSlip
    } else if swings[1] >= STEADY * speed && swings[1] >= FADES * swings[0] {
        StickSlipRegime::Oscillates
    } else if weakens {
        StickSlipRegime::Creeps
    } else {
        StickSlipRegime::Steady
    }
}

/// Holds whose times differ by less, in the mean of ln, have no slope.
const ALIKE: f64 = 1e-9;

/// Slope of peak/load over ln(hold) by least squares.
pub(super) fn healing(holds: &[HoldPeak], load: f64) -> Option<f64> {
    let points = || {
        holds
            .iter()
            .map(|hold| (log(hold.hold), hold.peak_force / load))
    };
    let count = holds.len() as f64;
    let mean = |part: fn((f64, f64)) -> f64| points().map(part).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let over: f64 = points().map(|point| (point.0 - x) * (point.1 - y)).sum();
    let under: f64 = points().map(|point| (point.0 - x) * (point.0 - x)).sum();
    (under > ALIKE * ALIKE * count).then(|| over / under)
}

fn log(x: f64) -> f64 {
    tribos_core::Real::ln(x)
}
