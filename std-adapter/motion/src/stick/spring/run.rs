//! The run of a body on a spring: pulls and holds, the series, the sums.

use super::bristles::BristleMotion;
use super::dry::{DryBlock, DryMotion};
use super::motion::{SpringIntegrator, SpringSample};
use super::outcome::{HoldPeak, SpringSummary, healing, regime};
use super::rate_state::RateStateMotion;
use super::speed::SpeedMotion;
use super::stability::critical_stiffness;
use super::tally::RunStatistics;
use crate::error::MotionError;
use crate::motion_run::{MotionRun, MotionScene, SceneRun};
use crate::stick::scene::{SpringFriction, SpringScene};
use tribos_base::results::{Quantity, Summary, SweepView};
use tribos_core::law::{LocalLaw, LuGre, RateState, RateStateParameters, StaticAgeing};
use tribos_friction::Law;

/// Columns of the series.
const COLUMNS: [&str; 8] = [
    "time",
    "pull",
    "position",
    "velocity",
    "spring_force",
    "friction",
    "state",
    "slips",
];

/// Most steps of a run, and steps between two looks at the watch.
const MOST_STEPS: u64 = 20_000_000;
const BETWEEN: u64 = 1024;

/// The run of a scene, with these [`COLUMNS`].
type SpringRun = SceneRun<SpringSummary, { COLUMNS.len() }>;

impl SpringScene {
    /// Runs the scene to its end.
    ///
    /// *Columns* of the series: s, m, m, m/s, N, N, s or m, 0 or 1.
    ///
    /// *Accuracy*: dry friction to rounding, some ulp an arc; the others within the scene's `tolerance` a step.
    ///
    /// ```
    /// use tribos::scene::SpringScene;
    /// // m = 1 kg, k = 100 N/m, N = 9.81 N, mu_s = 0.5, mu_d = 0.3: T = 2 D/(kV) + 2 (pi - atan(D w/(kV)))/w.
    /// let scene = SpringScene::default();
    /// let (drop, omega) = (0.2 * 9.81, 10.0);
    /// let share: f64 = drop / (scene.stiffness * scene.pull_speed); // D/(kV), in s
    /// let period = 2.0 * share + 2.0 * (std::f64::consts::PI - (share * omega).atan()) / omega;
    /// let found = scene.run()?.outcome.period.ok_or("steady")?;
    /// assert!((found / period - 1.0).abs() < 1e-10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(&self) -> Result<SpringRun, MotionError> {
        watched(self, &mut |_| true)
    }
}

/// Runs a scene; `watch` sees the share of the time that is done, and ends the run by answering false.
fn watched(
    scene: &SpringScene,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<SpringRun, MotionError> {
    scene.check()?;
    let mut body = follower(scene)?;
    let mut course = SpringRunState::new(scene, &*body, watch);
    for piece in pieces(scene) {
        course.follow(&mut *body, &piece)?;
        if course.ran_away {
            break;
        }
    }
    Ok(course.end(&*body))
}

/// The body of a scene at its start.
fn follower(scene: &SpringScene) -> Result<Box<dyn SpringIntegrator>, MotionError> {
    let (speed, tolerance) = (scene.pull_speed, scene.tolerance);
    let [mass, stiffness, load] = [scene.mass, scene.stiffness, scene.load];
    let dry = |mu_static, mu_dynamic, growth| -> Result<Box<dyn SpringIntegrator>, MotionError> {
        Ok(Box::new(DryMotion::new(DryBlock {
            mass,
            stiffness,
            load,
            mu_dynamic,
            mu_static: StaticAgeing::new(mu_static, growth, scene.ageing_cutoff_time)?,
        })))
    };
    Ok(match scene.friction_law {
        SpringFriction::Dry => match scene.law {
            None => dry(scene.mu_static, scene.mu_dynamic, scene.ageing_rate)?,
            Some(law) => match coefficients(&law) {
                Some([mu_static, mu_dynamic]) => dry(mu_static, mu_dynamic, 0.0)?,
                None => {
                    let law = law.build::<f64>()?;
                    let masses = [mass, stiffness, load];
                    Box::new(SpeedMotion::new(law, masses, speed, tolerance))
                }
            },
        },
        SpringFriction::RateState => {
            let parameters = scene.rate_state();
            let viscous = 0.0;
            let dry = RateStateParameters {
                viscous,
                ..parameters
            };
            let laws = [RateState::new(parameters)?, RateState::new(dry)?];
            let masses = [mass, stiffness, load];
            let speeds = [speed, scene.start()];
            let ages = scene.evolution;
            Box::new(RateStateMotion::new(laws, ages, masses, speeds, tolerance))
        }
        SpringFriction::Bristles => {
            let law = LuGre::new(scene.lugre())?;
            Box::new(BristleMotion::new(law, [mass, stiffness], speed, tolerance))
        }
    })
}

/// Coefficients at rest and in motion of a law that is dry.
fn coefficients(law: &Law) -> Option<[f64; 2]> {
    let value = |name: &str| law.values().find(|(known, _)| *known == name);
    let [at_rest, in_motion] = match law.name() {
        "dry" => ["mu_s", "mu_d"],
        "coulomb" => ["mu", "mu"],
        _ => return None,
    };
    Some([value(at_rest)?.1, value(in_motion)?.1])
}

/// A pull or a hold.
struct PullOrHold {
    speed: f64,
    duration: f64,
    is_last: bool,
}

/// Pull, hold, pull, …, each hold longer than the one before.
fn pieces(scene: &SpringScene) -> Vec<PullOrHold> {
    let pull = |is_last| PullOrHold {
        speed: scene.pull_speed,
        duration: scene.pull_time,
        is_last,
    };
    let Some(mut hold) = scene.hold_time else {
        return vec![pull(true)];
    };
    let mut all = vec![pull(false)];
    for index in 1..=scene.hold_count {
        all.push(PullOrHold {
            speed: 0.0,
            duration: hold,
            is_last: false,
        });
        all.push(pull(index == scene.hold_count));
        hold *= scene.hold_time_ratio;
    }
    all
}

/// A run on its way.
struct SpringRunState<'a> {
    scene: &'a SpringScene,
    watch: &'a mut dyn FnMut(f64) -> bool,
    /// Time of all pulls and holds.
    duration: f64,
    rows: Vec<[f64; COLUMNS.len()]>,
    /// Of the whole run; of the third and the last quarter of the last pull.
    whole: RunStatistics,
    quarters: [RunStatistics; 2],
    work: f64,
    /// The largest force since the last hold, if there was one.
    hold: Option<HoldPeak>,
    holds: Vec<HoldPeak>,
    steps: u64,
    ran_away: bool,
    start: f64,
}

impl<'a> SpringRunState<'a> {
    fn new(
        scene: &'a SpringScene,
        body: &dyn SpringIntegrator,
        watch: &'a mut dyn FnMut(f64) -> bool,
    ) -> Self {
        let tally = RunStatistics::new(scene.pull_speed, body.holds_exactly());
        let first = body.moment();
        Self {
            scene,
            watch,
            duration: pieces(scene).iter().map(|piece| piece.duration).sum(),
            rows: vec![first.row()],
            whole: tally.clone(),
            quarters: [tally.clone(), tally],
            work: 0.0,
            hold: None,
            holds: Vec::new(),
            steps: 0,
            ran_away: false,
            start: first.position,
        }
    }

    /// One piece, with a row at the end of each interval and stops at the quarters.
    fn follow(
        &mut self,
        body: &mut dyn SpringIntegrator,
        piece: &PullOrHold,
    ) -> Result<(), MotionError> {
        let begin = body.moment();
        if piece.speed == 0.0 {
            self.hold = Some(HoldPeak {
                hold: piece.duration,
                force_before: begin.spring_force,
                peak_force: f64::NEG_INFINITY,
            });
        }
        let samples = u64::from(self.scene.samples);
        // Intervals in quarters of a sample, so that every quarter of the piece is one of the ends.
        for index in 1..=4 * samples {
            let is_row = index % 4 == 0;
            if !is_row && !(piece.is_last && (index == 2 * samples || index == 3 * samples)) {
                continue;
            }
            let share = index as f64 / (4 * samples) as f64;
            let until = begin.time + share * piece.duration;
            let quarter = match index {
                _ if !piece.is_last || index <= 2 * samples => None,
                _ if index <= 3 * samples => Some(0),
                _ => Some(1),
            };
            self.advance(body, piece, until, quarter)?;
            if is_row || self.ran_away {
                self.rows.push(body.moment().row());
            }
            if self.ran_away {
                return Ok(());
            }
        }
        if piece.speed != 0.0 {
            self.holds.extend(self.hold.take());
        }
        Ok(())
    }

    fn advance(
        &mut self,
        body: &mut dyn SpringIntegrator,
        piece: &PullOrHold,
        until: f64,
        quarter: Option<usize>,
    ) -> Result<(), MotionError> {
        let mut before = body.moment();
        while before.time < until {
            let impulse = body.step(piece.speed, until)?;
            let after = body.moment();
            self.work += piece.speed * impulse;
            self.whole.see(&before, &after, impulse);
            if let Some(quarter) = quarter {
                self.quarters[quarter].see(&before, &after, impulse);
            }
            if let (Some(hold), true) = (&mut self.hold, piece.speed != 0.0) {
                hold.peak_force = hold.peak_force.max(after.spring_force);
            }
            self.steps += 1;
            if body.runs_away() {
                self.ran_away = true;
                return Ok(());
            }
            let (steps, time) = (self.steps, after.time);
            if steps > MOST_STEPS {
                return Err(MotionError::TooManyStepsAt { steps, time });
            }
            if steps.is_multiple_of(BETWEEN) && !(self.watch)(time / self.duration) {
                return Err(MotionError::InterruptedAt { time });
            }
            before = after;
        }
        Ok(())
    }

    fn end(self, body: &dyn SpringIntegrator) -> SpringRun {
        let last = body.moment();
        let [third, fourth] = &self.quarters;
        // A run that ends early has its whole course only.
        let counted = if fourth.time > 0.0 {
            [third, fourth]
        } else {
            [&self.whole; 2]
        };
        let sum =
            |part: fn(&RunStatistics) -> f64| counted.iter().map(|tally| part(tally)).sum::<f64>();
        let worst = |pick: fn(f64, f64) -> f64, part: fn(&RunStatistics) -> f64| {
            pick(part(counted[0]), part(counted[1]))
        };
        let mut both = counted[0].clone();
        if let (Some([first, _]), Some([_, end])) = (counted[0].starts, counted[1].starts) {
            both.starts = Some([first, end]);
            both.slips = counted[0].slips + counted[1].slips;
        } else if both.starts.is_none() {
            (both.starts, both.slips) = (counted[1].starts, counted[1].slips);
        }
        let swings = [third, fourth].map(|tally| tally.velocity.swing());
        let time = sum(|tally| tally.time);
        let least_force = worst(f64::min, |tally| tally.force.least);
        let most_force = worst(f64::max, |tally| tally.force.most);
        SceneRun {
            columns: &COLUMNS,
            rows: self.rows,
            outcome: SpringSummary {
                regime: regime(
                    &[counted[0].clone(), counted[1].clone()],
                    self.scene.pull_speed,
                    self.scene.weakens(),
                ),
                ran_away: self.ran_away,
                end_time: last.time,
                mean_force: sum(|tally| tally.impulse) / time,
                least_force,
                most_force,
                amplitude: 0.5 * (most_force - least_force),
                most_speed: worst(f64::max, |tally| tally.velocity.most),
                period: both.period(),
                slips: self.whole.slips,
                slip_share: sum(|tally| tally.slip_time) / time,
                swing_ratio: swings[1] / swings[0],
                distance: last.position - self.start,
                work: self.work,
                healing: healing(&self.holds, self.scene.load),
                holds: self.holds,
                critical_stiffness: self.scene.critical_stiffness(),
                steps: self.steps,
            },
        }
    }
}

impl SpringScene {
    /// Whether steady friction falls with the speed of the pull.
    fn weakens(&self) -> bool {
        match self.friction_law {
            SpringFriction::RateState => {
                let law = RateState::<f64>::new(self.rate_state());
                law.is_ok_and(|law| law.steady().slope(self.pull_speed) < 0.0)
            }
            _ => false,
        }
    }

    /// The stiffness below which rate and state cannot be pulled steadily; none for other laws.
    pub fn critical_stiffness(&self) -> Option<f64> {
        let is_asked = self.friction_law == SpringFriction::RateState;
        is_asked
            .then(|| critical_stiffness(&self.rate_state(), self.load, self.mass, self.pull_speed))
    }
}

impl SpringSample {
    /// A row of the series.
    pub(super) fn row(&self) -> [f64; COLUMNS.len()] {
        [
            self.time,
            self.pull,
            self.position,
            self.velocity,
            self.spring_force,
            self.friction,
            self.state,
            f64::from(u8::from(self.slips)),
        ]
    }
}

impl MotionScene for SpringScene {
    fn quantities(&self) -> &'static [Quantity] {
        SpringSummary::QUANTITIES
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "amplitude",
            title: "Amplitude of the spring force",
            share: ["stick_slip", "/regime", "stick-slip"],
        }
    }

    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError> {
        let result = watched(self, watch)?;
        let outcome = &result.outcome;
        let mut told = vec![
            ("regime", outcome.regime.to_string()),
            (
                "force",
                format!(
                    "{:.6} N in the mean, {:.6} to {:.6} N",
                    outcome.mean_force, outcome.least_force, outcome.most_force
                ),
            ),
            (
                "slips",
                match outcome.period {
                    Some(period) => format!("{}, one every {period:.6} s", outcome.slips),
                    None => outcome.slips.to_string(),
                },
            ),
            (
                "slip share",
                format!("{:.2} % of the time", 100.0 * outcome.slip_share),
            ),
        ];
        if let Some(critical) = self.critical_stiffness() {
            let share = self.stiffness / critical;
            let words = if critical > 0.0 {
                format!("{critical:.6} N/m; this spring has {share:.4} of it")
            } else {
                "none: friction strengthens with the speed, every spring pulls steadily".into()
            };
            told.push(("critical", words));
        }
        if let Some(healing) = outcome.healing {
            told.push(("healing", format!("{healing:.5} per e-fold of the hold")));
        }
        if outcome.ran_away {
            told.push((
                "ending",
                format!(
                    "the speed leaves all bounds at {:.6} s: give `mass` or `radiation_damping`",
                    outcome.end_time
                ),
            ));
        }
        Ok(result.shown(told, (&["spring_force"], "spring force [N]")))
    }

    fn carried(&self) -> Vec<(&'static str, String)> {
        let (unknowns, law, method) = match self.friction_law {
            SpringFriction::Dry => match self.law {
                None => (
                    "2: position and velocity",
                    format!("dry, mu_s = {}, mu_d = {}", self.mu_static, self.mu_dynamic),
                    "closed form: rest, and harmonic arcs between computed instants",
                ),
                Some(law) => (
                    "2: velocity and spring force",
                    law.to_string(),
                    "RODAS, order 4, adaptive; the instants of rest and release are roots",
                ),
            },
            SpringFriction::RateState if self.mass == 0.0 => (
                "2: logarithms of speed and age",
                format!("rate and state, {}", self.evolution),
                "RODAS, order 4, adaptive, quasi-static: the spring force is what the law says",
            ),
            SpringFriction::RateState => (
                "3: logarithms of speed and age, spring force",
                format!("rate and state, {}", self.evolution),
                "RODAS, order 4, adaptive",
            ),
            SpringFriction::Bristles => (
                "3: velocity, deflection of the bristles, spring force",
                "LuGre".into(),
                "RODAS, order 4, adaptive",
            ),
        };
        vec![
            ("unknowns", unknowns.into()),
            ("law", law),
            ("method", method.into()),
        ]
    }
}
