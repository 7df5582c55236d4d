//! One slider followed from launch to end, with its energy balance.

use super::outcome::terminal;
use super::{COLUMNS, MotionError, SlideStopReason, SlideSummary, energy_at_launch};
use crate::slide::scene::{DiskScene, SliderIntegrator};
use tribos_base::run::Simulation;
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::modes::TerminalMotion;
use tribos_core::slider::{Slider, SliderParameters, SliderRest, SliderState};

/// Index of the velocity ratio among the columns.
const RATIO: usize = 5;
/// Logarithm beyond which a time exceeds the range of f64.
const LARGEST_LN: f64 = 709.0;
/// Largest number of steps whose series fits a file of reasonable size.
pub(super) const MOST_STEPS: f64 = 1e7;
/// Verlet steps per recorded step of the exact method, when the scene gives no time step.
const VERLET_REFINEMENT: f64 = 50.0;
/// Relative margin added to a chosen step: far above rounding and far below any visible effect.
pub(super) const SLIVER: f64 = 1e-12;
/// Iterations of the search for the end of a fading run. Every third halves a bracket of one e-fold of the time: at the
/// last one it is 2⁻⁶⁶ of the time, below its rounding, so that this count decides nothing.
const MOST_CORRECTIONS: u32 = 200;
/// Fraction of the initial energy whose loss is neglected.
const NOTHING: f64 = 1e-18;
/// Length of the integration pieces of the work, in e-folds of the energy: the rule is exact to 1e-15 on them.
const PIECE: f64 = 0.125;
/// A piece is accepted if its work equals the energy lost within this fraction of the initial energy.
const SETTLED: f64 = 1e-14;
/// Halvings per step: eight isolate a kink, and the limit ends the search if the motion itself is wrong.
const MOST_HALVINGS: u32 = 64;
/// Nodes and weights of the 5-point Gauss–Legendre rule on [0, 1], which integrates the power.
const POWER_NODES: [[f64; 2]; 5] = [
    [0.046_910_077_030_668, 0.118_463_442_528_094_54],
    [0.230_765_344_947_158_45, 0.239_314_335_249_683_23],
    [0.5, 0.284_444_444_444_444_44],
    [0.769_234_655_052_841_5, 0.239_314_335_249_683_23],
    [0.953_089_922_969_332, 0.118_463_442_528_094_54],
];

/// Length of the steps.
#[derive(Clone, Copy, Debug)]
enum StepLength {
    /// Constant time step.
    Fixed(f64),
    /// This fraction of the time in which the current speeds would fade.
    OfFading(f64),
}

/// The simulation of one slider.
///
/// ```
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// use tribos::run::Simulation;
/// use tribos::scene::DiskScene;
/// use tribos::slide::{SlideStopReason, SlideSimulation};
/// let mut disk = SlideSimulation::new(CoulombDisk, &DiskScene::default())?;
/// let mut before = disk.record(); // time, speed, spin, …
/// while disk.step()? {
///     before = disk.record();
/// }
/// // Sliding and spinning stop in the same instant.
/// assert!(before[1] > 0.0 && before[2] > 0.0);
/// assert_eq!(disk.record()[1..3], [0.0, 0.0]);
/// assert_eq!((disk.outcome()?.ending, disk.progress()), (SlideStopReason::Rest, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SlideSimulation<P> {
    slider: Slider<f64, P>,
    scene: DiskScene,
    length: StepLength,
    /// Time of rest or of fading, or the requested duration.
    end: f64,
    /// State at rest, if the motion comes to rest.
    coming: Option<SliderRest<f64>>,
    start: SliderState<f64>,
    motion: SliderState<f64>,
    rest: Option<SliderRest<f64>>,
    /// Work of friction, integrated from its power.
    dissipated: f64,
    steps: u64,
}

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> SlideSimulation<P> {
    /// Prepares a run; the whole motion is computed once to choose and validate the time step.
    pub fn new(profile: P, scene: &DiskScene) -> Result<Self, MotionError> {
        scene.check()?;
        let deceleration = scene.gamma * scene.gravity;
        let slider = Slider::new(
            profile,
            SliderParameters {
                deceleration,
                radius: scene.radius,
                inertia_ratio: scene.inertia_ratio,
            },
        )?;
        let start = SliderState::launched(scene.speed, scene.spin);
        energy_at_launch(scene.mass * slider.energy_per_mass(&start))?;
        let mut simulation = Self {
            scene: *scene,
            length: StepLength::OfFading(fading_fraction(scene)),
            end: f64::INFINITY,
            coming: slider.to_rest(&start),
            slider,
            start,
            motion: start,
            rest: None,
            dissipated: 0.0,
            steps: 0,
        };
        simulation.end = simulation
            .estimate_end_time()?
            .min(scene.duration.unwrap_or(f64::INFINITY));
        simulation.length = simulation.choose_length()?;
        Ok(simulation)
    }

    /// Time of rest (α < 1), or the time at which both speeds have faded.
    fn estimate_end_time(&self) -> Result<f64, MotionError> {
        if let Some(rest) = &self.coming {
            return Ok(rest.motion.time);
        }
        if let Some(duration) = self.scene.duration {
            return Ok(duration);
        }
        self.fading_time()
    }

    /// Time at which the slower of the two motions to fade reaches the scene's fraction of its initial value.
    fn fading_time(&self) -> Result<f64, MotionError> {
        // The logarithm's excess decreases with the logarithm of the time.
        let excess = |ln_time: f64| {
            let time = Real::exp(ln_time);
            self.ln_excess(&self.slider.advance(&self.start, time).motion)
        };
        let energy = self.slider.energy_per_mass(&self.start);
        let first = 2.0 * energy / self.slider.dissipation_per_mass(&self.start);
        if !(first.is_finite() && first > 0.0) {
            return Err(MotionError::NotFinite { step: 0 });
        }
        let (mut low, mut high) = (Real::ln(first) - 1.0, Real::ln(first));
        let (mut above, mut below) = (excess(low), excess(high));
        while above < 0.0 {
            (high, below) = (low, above);
            low -= 1.0;
            above = excess(low);
        }
        while below > 0.0 && high < LARGEST_LN {
            (low, above) = (high, below);
            high += 1.0;
            below = excess(high);
        }
        let mut step = 0;
        while high - low > f64::EPSILON * high.abs() && above > 0.0 && below < 0.0 {
            step += 1;
            // Regula falsi, with a bisection every third iteration.
            let share = if step % 3 == 0 {
                0.5
            } else {
                above / (above - below)
            };
            let middle = low + share * (high - low);
            if middle <= low || middle >= high || step > MOST_CORRECTIONS {
                break;
            }
            let at = excess(middle);
            if at > 0.0 {
                (low, above) = (middle, at);
            } else {
                (high, below) = (middle, at);
            }
        }
        let is_found = above >= 0.0 && below <= 0.0;
        if is_found {
            let nearest = if above < -below { low } else { high };
            Ok(Real::exp(nearest))
        } else {
            Err(MotionError::NotFinite { step: 0 })
        }
    }

    /// Logarithm of the larger of both speeds, each divided by the value below which it counts as faded.
    fn ln_excess(&self, motion: &SliderState<f64>) -> f64 {
        let over = |now: f64, start: f64| {
            if start == 0.0 {
                f64::NEG_INFINITY
            } else {
                Real::ln(now.abs() / (self.scene.stop_fraction * start.abs()))
            }
        };
        let slide = over(motion.speed, self.start.speed);
        let spin = over(motion.spin, self.start.spin);
        if slide > spin || slide.is_nan() {
            slide
        } else {
            spin
        }
    }

    /// The scene's time step, or one that suits the motion.
    fn choose_length(&self) -> Result<StepLength, MotionError> {
        let refinement = match self.scene.integrator {
            SliderIntegrator::Exact => 1.0,
            SliderIntegrator::Verlet => VERLET_REFINEMENT,
        };
        let Some(time_step) = self.scene.time_step else {
            let never_rests = self.scene.alpha >= 1.0 && self.scene.duration.is_none();
            return Ok(if never_rests {
                StepLength::OfFading(fading_fraction(&self.scene) / refinement)
            } else {
                // A little longer, so that rounding does not leave a tiny last step.
                StepLength::Fixed(
                    self.end * (1.0 + SLIVER) / (f64::from(self.scene.samples) * refinement),
                )
            });
        };
        let steps = self.end / time_step;
        if steps > MOST_STEPS {
            let at_least = self.end / MOST_STEPS;
            return Err(MotionError::TooManySteps {
                time_step,
                steps,
                most: MOST_STEPS,
                at_least,
            });
        }
        Ok(StepLength::Fixed(time_step))
    }

    fn length_of(&self, motion: &SliderState<f64>) -> f64 {
        match self.length {
            StepLength::Fixed(length) => length,
            StepLength::OfFading(fraction) => {
                let energy = self.slider.energy_per_mass(motion);
                fraction * 2.0 * energy / self.slider.dissipation_per_mass(motion)
            }
        }
    }

    /// Work of friction during `duration` after `motion`, along the exact motion. The integration pieces cover
    /// an eighth of an e-fold of the energy each, until the remaining energy is negligible.
    ///
    /// Where the power has a kink (at equal speeds), its integral differs from the energy lost, and the
    /// piece is halved. If the motion itself were wrong, the difference would persist for any piece length.
    fn work(&self, motion: &SliderState<f64>, duration: f64) -> f64 {
        let initial = self.slider.energy_per_mass(&self.start);
        let (mut state, mut left, mut work) = (*motion, duration, 0.0);
        let (mut size, mut halvings) = (f64::INFINITY, 0);
        while left > 0.0 {
            let energy = self.slider.energy_per_mass(&state);
            if energy <= NOTHING * initial {
                break;
            }
            let power = self.slider.dissipation_per_mass(&state);
            let piece = left.min(PIECE * energy / power).min(size);
            let (part, end) = self.work_of_piece(&state, piece);
            let lost = energy - self.slider.energy_per_mass(&end);
            let is_settled = (part - lost).abs() <= SETTLED * initial;
            if !is_settled && halvings < MOST_HALVINGS {
                halvings += 1;
                size = 0.5 * piece;
                continue;
            }
            let makes_way = piece > 0.0 && (lost > 0.0 || piece >= left);
            if !makes_way {
                // The numbers are out of range.
                return f64::NAN;
            }
            size = 2.0 * piece;
            work += part;
            left -= piece;
            state = end;
        }
        self.scene.mass * work
    }

    /// Work per mass by the rule, and the motion at the end of the piece.
    fn work_of_piece(&self, motion: &SliderState<f64>, piece: f64) -> (f64, SliderState<f64>) {
        let (mut state, mut at, mut work) = (*motion, 0.0, 0.0);
        for [node, weight] in POWER_NODES {
            state = self.slider.advance(&state, (node - at) * piece).motion;
            at = node;
            work += weight * piece * self.slider.dissipation_per_mass(&state);
        }
        let end = self.slider.advance(&state, (1.0 - at) * piece).motion;
        (work, end)
    }

    fn exact_step(&mut self, duration: f64, is_last: bool) {
        let rest = self
            .coming
            .filter(|rest| rest.motion.time <= self.motion.time + duration);
        let moving = rest.map_or(duration, |rest| rest.motion.time - self.motion.time);
        self.dissipated += self.work(&self.motion, moving);
        self.motion = match &rest {
            Some(rest) => rest.motion,
            // The end does not depend on the steps that lead to it.
            None if is_last => self.slider.advance(&self.start, self.end).motion,
            None => self.slider.advance(&self.motion, duration).motion,
        };
        self.rest = rest;
    }

    /// Trapezoid rule for the power, which has the order of the method itself.
    fn verlet_step(&mut self, duration: f64) {
        let before = self.motion;
        self.motion = self.slider.verlet_step(&before, duration);
        let power = self.slider.dissipation_per_mass(&before)
            + self.slider.dissipation_per_mass(&self.motion);
        self.dissipated += 0.5 * self.scene.mass * duration * power;
        if self.motion.is_at_rest() {
            let ratio = self.slider.ratio(&before);
            self.rest = Some(SliderRest {
                motion: self.motion,
                ratio,
                evaluations: 0,
            });
        }
    }

    /// The current velocity ratio; its limit at rest.
    fn ratio(&self) -> f64 {
        match &self.rest {
            Some(rest) => rest.ratio,
            None => self.slider.ratio(&self.motion),
        }
    }

    /// Summary of the run so far.
    pub fn outcome(&self) -> Result<SlideSummary, MotionError> {
        let energy = |motion| self.scene.mass * self.slider.energy_per_mass(motion);
        let initial = energy(&self.start);
        let lost = initial - energy(&self.motion);
        let ratio_at_start = self.slider.ratio(&self.start);
        let modes = TerminalMotion::new(self.slider.profile(), self.scene.inertia_ratio)?;
        let (limit_ratio, final_mode) = terminal(modes.terminal_mode(ratio_at_start));
        Ok(SlideSummary {
            ending: if self.rest.is_some() {
                SlideStopReason::Rest
            } else if self.scene.duration.is_some() {
                SlideStopReason::Duration
            } else {
                SlideStopReason::Faded
            },
            stop_time: self.rest.is_some().then_some(self.motion.time),
            end_time: self.motion.time,
            distance: self.motion.distance,
            angle: self.motion.angle,
            final_ratio: self.ratio(),
            limit_ratio,
            final_mode,
            steps: self.steps,
            initial_energy: initial,
            energy_dissipated: self.dissipated,
            energy_error: (self.dissipated - lost).abs() / initial,
        })
    }
}

/// Fraction of the fading time per step with which the scene's number of samples covers the fading motion.
fn fading_fraction(scene: &DiskScene) -> f64 {
    -Real::ln(scene.stop_fraction) / f64::from(scene.samples)
}

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> Simulation for SlideSimulation<P> {
    type Record = [f64; COLUMNS.len()];
    type Error = MotionError;

    fn record(&self) -> Self::Record {
        let SliderState {
            time,
            speed,
            spin,
            distance,
            angle,
        } = self.motion;
        let ratio = self.ratio();
        let energy = self.scene.mass * self.slider.energy_per_mass(&self.motion);
        [
            time,
            speed,
            spin,
            distance,
            angle,
            ratio,
            energy,
            self.dissipated,
        ]
    }

    fn step(&mut self) -> Result<bool, MotionError> {
        let left = match self.scene.duration {
            Some(end) => end - self.motion.time,
            None if self.scene.alpha >= 1.0 => self.end - self.motion.time,
            None => f64::INFINITY,
        };
        let length = self.length_of(&self.motion);
        let is_last = length * (1.0 + SLIVER) >= left;
        let duration = if is_last { left } else { length };
        let before = self.motion.time;
        match self.scene.integrator {
            SliderIntegrator::Exact => self.exact_step(duration, is_last),
            SliderIntegrator::Verlet => self.verlet_step(duration),
        }
        self.steps += 1;
        let stands_still = self.motion.time <= before;
        if stands_still
            || !self
                .record()
                .iter()
                .enumerate()
                // The ratio is infinite where nothing spins.
                .all(|(column, x)| column == RATIO || x.is_finite())
        {
            return Err(MotionError::NotFinite { step: self.steps });
        }
        Ok(self.rest.is_none() && !is_last)
    }

    fn progress(&self) -> f64 {
        (self.motion.time / self.end).clamp(0.0, 1.0)
    }
}
