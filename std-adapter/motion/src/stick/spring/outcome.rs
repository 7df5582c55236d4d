//! The summary of a body on a spring.

use super::tally::RunStatistics;
use tribos_base::record::json_number;

use serde_json::{Map, Value, json};

/// How a body follows the pull in the end.
///
/// ```
/// use tribos::scene::SpringScene;
/// use tribos::stick::spring::{StickSlipRegime, run};
/// let block = SpringScene::default(); // mu_s = 0.5, mu_d = 0.3
/// assert_eq!(run(&block)?.outcome.regime, StickSlipRegime::StickSlip);
/// # Ok::<(), tribos::stick::StickError>(())
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

/// A hold and the force that it took to slide on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoldPeak {
    /// How long the pull stood still, in s.
    pub time: f64,
    /// Spring force when the hold began, in N.
    pub before: f64,
    /// Largest spring force after it, in N.
    pub peak: f64,
}

/// Results of a run; forces, period and shares are of the second half of the last pull.
///
/// ```
/// use tribos::scene::SpringScene;
/// use tribos::stick::spring::{SpringSummary, run};
/// let SpringSummary { most_force, period, .. } = run(&SpringScene::default())?.outcome;
/// assert!(most_force > 0.5 * 9.81 && period.is_some()); // mu_s N, and a little beyond
/// # Ok::<(), tribos::stick::StickError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpringSummary {
    /// How the body follows the pull.
    pub regime: StickSlipRegime,
    /// Whether its speed left all bounds, which ends a run without mass and viscous term.
    pub ran_away: bool,
    /// Time at the end, in s.
    pub end_time: f64,
    /// Mean spring force, in N.
    pub mean_force: f64,
    /// Least spring force, in N.
    pub least_force: f64,
    /// Largest spring force, in N.
    pub most_force: f64,
    /// Largest speed, in m/s.
    pub most_speed: f64,
    /// Mean time between starts of slips, in s; none if fewer than two begin.
    pub period: Option<f64>,
    /// Number of slips that begin in the whole run.
    pub slips: u64,
    /// Share of the time in which the body slips.
    pub slip_share: f64,
    /// Swing of the speed in the last quarter over that in the quarter before; 1 while it lasts.
    pub swing_ratio: f64,
    /// Distance over which the body has moved in the whole run, in m.
    pub distance: f64,
    /// Work of the pull in the whole run, in J.
    pub work: f64,
    /// The holds.
    pub holds: Vec<HoldPeak>,
    /// Growth of peak force over load per e-fold of the hold, by least squares; none of fewer than two.
    pub healing: Option<f64>,
    /// Steps taken.
    pub steps: u64,
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
    let points = || holds.iter().map(|hold| (log(hold.time), hold.peak / load));
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

impl SpringSummary {
    /// The summary without the scene.
    pub(super) fn json(&self, critical: Option<f64>) -> Map<String, Value> {
        let mut map = Map::new();
        map.insert("regime".into(), self.regime.to_string().into());
        map.insert("ran_away".into(), self.ran_away.into());
        let some = |value: Option<f64>| value.map_or(Value::Null, json_number);
        for (name, value) in [
            ("end_time", self.end_time),
            ("mean_force", self.mean_force),
            ("least_force", self.least_force),
            ("most_force", self.most_force),
            ("amplitude", 0.5 * (self.most_force - self.least_force)),
            ("most_speed", self.most_speed),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("period".into(), some(self.period));
        map.insert("slips".into(), self.slips.into());
        for (name, value) in [
            ("slip_share", self.slip_share),
            ("swing_ratio", self.swing_ratio),
            ("distance", self.distance),
            ("work", self.work),
        ] {
            map.insert(name.into(), json_number(value));
        }
        let holds = self.holds.iter().map(|hold| {
            json!({
                "hold": json_number(hold.time),
                "force_before": json_number(hold.before),
                "peak_force": json_number(hold.peak),
            })
        });
        map.insert("holds".into(), Value::Array(holds.collect()));
        map.insert("healing".into(), some(self.healing));
        map.insert("critical_stiffness".into(), some(critical));
        map.insert("steps".into(), self.steps.into());
        map
    }
}
