//! A body pinched between two elastic pads, under a force and a torque that swing: micro-slip, its loss,
//! and the release.
//!
//! Each pad holds with the kernel's elastic bonds ([`tribos_core::presliding`]): its wrench is that of its
//! strain until the limit surface, then it slips. The body is where both together balance the load,
//!
//! ```text
//! z₁(q) + z₂(q) = w(t),
//! ```
//!
//! quasi-static. Pads of one shape hold together what lies in the sum of their limit surfaces (Melan's theorem):
//! where the load leaves it, and there alone, the pinch lets go. Below, the step of each pad is the gradient of a
//! convex function of the pose q, whose least value is the balance; quasi-Newton steps find it where one pad slips that is
//! a million times stiffer than the other. One pad that slips while the other holds is Iwan's assembly of two elements, which obeys Masing's
//! rule: a branch of the loop is the first loading twice as large.

use crate::error::MotionError;
use crate::motion_run::{MotionRun, MotionScene, SceneRun};
use crate::stick::scene::ClampScene;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;
use tribos_base::bracket::Bracket;
use tribos_base::results::{Quantity, Reporting::*, Summary, SweepView, summary};
use tribos_core::Real;
use tribos_core::law::StickSlip;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::presliding::{Anchor, Pose, Presliding, PreslidingStep};
use tribos_core::twist::{Displacement, Wrench};
use tribos_friction::Area;

/// Columns of the series.
const COLUMNS: [&str; 8] = [
    "time",
    "force",
    "torque",
    "position",
    "angle",
    "heat",
    "first_slips",
    "second_slips",
];

summary! {
    /// Results of a run of a body in a pinch.
    #[derive(Copy)]
    pub struct ClampSummary;

    /// Whether the pinch `lets go` or `holds`.
    ending: &'static str, "-";
    /// Time at which it lets go; none if it holds to the end.
    release_time: Option<f64>, "s", Shown("release");
    /// Heat of the last whole cycle.
    loss_per_cycle: f64, "J", Shown("loss");
    /// Heat of the whole run.
    heat: f64, "J", Swept;
    /// Change of the position over the last whole cycle.
    drift_per_cycle: f64, "m", Shown("drift");
    /// Least position in the last whole cycle.
    least_position: f64, "m", Swept;
    /// Largest position in the last whole cycle.
    most_position: f64, "m", Swept;
}

/// The run of a scene, with these [`COLUMNS`].
type ClampRun = SceneRun<ClampSummary, { COLUMNS.len() }>;

impl ClampScene {
    /// Runs the scene to its end, or to the release.
    ///
    /// *Columns* of the series: s, N, N m, m, rad, J of heat so far, and whether each pad slips.
    ///
    /// *Accuracy*: the balance to 1e-12 of the pads' limits; the way of slips that turn is of first order in the
    /// interval of the series, of those along a line it is exact but for where the interval meets the turn of the
    /// load.
    ///
    /// ```
    /// use tribos::scene::ClampScene;
    /// // 6 N and 10 N hold less than 17 N: it lets go where the force passes 16 N.
    /// let outcome = ClampScene { force_amplitude: 17.0, ..ClampScene::default() }.run()?.outcome;
    /// let release = outcome.release_time.ok_or("holds")?; // s
    /// let force = 17.0 * (std::f64::consts::TAU * release).sin();
    /// assert!((force - 16.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(&self) -> Result<ClampRun, MotionError> {
        watched(self, &mut |_| true)
    }
}

/// Runs a scene; `watch` sees the share of the cycles that is done, and ends the run by answering false.
fn watched(
    scene: &ClampScene,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<ClampRun, MotionError> {
    scene.check()?;
    let mut pinch = ClampedBody::new(scene)?;
    let mut rows = vec![pinch.row(0.0, &Wrench::ZERO, [StickSlip::Stick; 2])];
    let mut release = None;
    let samples = scene.samples;
    'cycles: for cycle in 0..scene.cycles {
        for index in 1..=samples {
            let share = f64::from(index) / f64::from(samples);
            let time = scene.period * (f64::from(cycle) + share);
            let held = f64::from(index - 1) / f64::from(samples);
            release = pinch.release_between(scene, cycle, [held, share]);
            if release.is_some() {
                break 'cycles;
            }
            let load = load(scene, cycle, share);
            let grips = pinch
                .settle(&load)
                .map_err(|left| MotionError::Unbalanced { time, left })?;
            if !watch((f64::from(cycle) + share) / f64::from(scene.cycles)) {
                return Err(MotionError::InterruptedAt { time });
            }
            rows.push(pinch.row(time, &load, grips));
        }
    }
    let whole = (rows.len() - 1) / samples as usize;
    let (begin, end) = (
        whole.saturating_sub(1) * samples as usize,
        whole * samples as usize,
    );
    let last = &rows[begin..=end];
    let positions = || last.iter().map(|row| row[3]);
    let outcome = ClampSummary {
        ending: if release.is_some() {
            "lets go"
        } else {
            "holds"
        },
        release_time: release,
        loss_per_cycle: rows[end][5] - rows[begin][5],
        heat: pinch.heat,
        drift_per_cycle: rows[end][3] - rows[begin][3],
        least_position: positions().fold(f64::INFINITY, f64::min),
        most_position: positions().fold(f64::NEG_INFINITY, f64::max),
    };
    Ok(SceneRun {
        columns: &COLUMNS,
        rows,
        outcome,
    })
}

/// The load at a share of a cycle.
fn load(scene: &ClampScene, cycle: u32, share: f64) -> Wrench<f64> {
    let grown = 1.0 + scene.amplitude_growth * f64::from(cycle);
    let swing = grown * Real::sin(TAU * share);
    Wrench::new(
        scene.force_mean + scene.force_amplitude * swing,
        0.0,
        scene.torque_mean + scene.torque_amplitude * swing,
    )
}

/// One pad and where its bonds are anchored.
struct Pad {
    set: Box<dyn FrictionSet<f64>>,
    bonds: Presliding<f64>,
    anchor: Anchor<f64>,
}

/// The body between its pads.
struct ClampedBody {
    pads: [Pad; 2],
    pose: Pose<f64>,
    heat: f64,
    /// What both hold together, the largest force of that, and the lever of torques.
    both: Box<dyn FrictionSet<f64>>,
    limit: f64,
    lever: f64,
}

/// The pads at a pose of the body, and what they leave of the load; a torque over the lever.
struct Trial {
    pose: Pose<f64>,
    steps: [PreslidingStep<f64>; 2],
    left: Vector3<f64>,
}

/// Shares of a cycle at which the load turns.
const TURNS: [f64; 2] = [0.25, 0.75];
/// What the balance may leave, as a share of the limits; more where the rounding of a pose is more, up to a cap.
const BALANCED: f64 = 1e-12;
const MOST_ROUNDED: f64 = 1e-8;
/// Iterations of the search for the balance, a few are usual, and steps along a line: each halves it, or goes on
/// to four times its length.
const MOST_ITERATIONS: u32 = 400;
const MOST_TRIALS: u32 = 100;
const FARTHER: f64 = 4.0;
/// Share of the slope at the start of a line that its end may have.
const FLATTER: f64 = 0.5;

impl ClampedBody {
    fn new(scene: &ClampScene) -> Result<Self, MotionError> {
        let default = 0.5 * scene.radius * scene.radius;
        let lever_sq = scene.torsion_lever_squared.unwrap_or(default);
        let origin = Pose::new(0.0, 0.0, 0.0);
        let area = Area::named(&scene.patch, scene.radius, None)?;
        let pad = |mu: f64, stiffness: f64| -> Result<Pad, MotionError> {
            let bonds = Presliding::new(stiffness, stiffness * lever_sq)?;
            let set = area.limit_surface(mu * scene.load)?;
            let anchor = Anchor::at(origin);
            Ok(Pad { set, bonds, anchor })
        };
        let limit = (scene.mu_first + scene.mu_second) * scene.load;
        Ok(Self {
            both: area.limit_surface(limit)?,
            pads: [
                pad(scene.mu_first, scene.stiffness_first)?,
                pad(scene.mu_second, scene.stiffness_second)?,
            ],
            pose: origin,
            heat: 0.0,
            limit,
            lever: Real::sqrt(lever_sq),
        })
    }

    /// The time, between two shares of a cycle, at which the load leaves what the pads carry together; none if
    /// they hold it. They have one shape, so that their sets add up to that of the sum of their coefficients.
    fn release_between(&self, scene: &ClampScene, cycle: u32, shares: [f64; 2]) -> Option<f64> {
        let leaves = |share: f64| self.both.gauge(&load(scene, cycle, share)) > 1.0;
        let [held, end] = shares;
        // Between its turns the load is monotone, and what is held is convex.
        let turns = TURNS.into_iter().filter(|turn| *turn > held && *turn < end);
        let lost = turns.chain([end]).find(|share| leaves(*share))?;
        let lost = Bracket::new(held, lost).halved(usize::MAX, leaves).high;
        Some(scene.period * (f64::from(cycle) + lost))
    }

    /// Moves the body to where the pads balance the load, which they hold; else the force that is left.
    fn settle(&mut self, load: &Wrench<f64>) -> Result<[StickSlip; 2], f64> {
        let stiffness: f64 = self.pads.iter().map(|pad| pad.bonds.stiffness()).sum();
        let mut inverse = Matrix3::identity() / stiffness;
        let mut moved = Vector3::zeros();
        let mut here = self.trial(load, &moved);
        for _ in 0..MOST_ITERATIONS {
            let size = here.left.xy().norm().max(here.left.z.abs());
            let place = here
                .pose
                .position
                .norm()
                .max(here.pose.angle.abs() * self.lever);
            let rounded = (f64::EPSILON * stiffness * place).min(MOST_ROUNDED * self.limit);
            if size <= (BALANCED * self.limit).max(rounded) {
                for (pad, step) in self.pads.iter_mut().zip(&here.steps) {
                    pad.anchor = step.anchor;
                    self.heat += step.dissipated;
                }
                self.pose = here.pose;
                return Ok(here.steps.map(|step| step.grip));
            }
            let along = inverse * here.left;
            let (length, there) = self.along(load, &moved, &along, here.left.dot(&along));
            let (step, fall) = (along * length, here.left - there.left);
            moved += step;
            here = there;
            // Broyden, Fletcher, Goldfarb and Shanno: the inverse of the stiffness that this step has met.
            let work = step.dot(&fall);
            if work > 0.0 {
                let project = Matrix3::identity() - fall * step.transpose() / work;
                inverse = project.transpose() * inverse * project + step * step.transpose() / work;
            }
        }
        Err(here.left.xy().norm().max(here.left.z.abs()))
    }

    /// The pads where the body has moved from its pose by a vector whose last component is its turn times the lever.
    fn trial(&self, load: &Wrench<f64>, moved: &Vector3<f64>) -> Trial {
        let by = Displacement::new(moved.x, moved.y, moved.z / self.lever);
        let pose = self.pose.moved(&by);
        let steps = self
            .pads
            .each_ref()
            .map(|pad| pad.bonds.step(&*pad.set, &pad.anchor, &pose));
        let left = *load + steps[0].friction + steps[1].friction;
        let left = Vector3::new(left.force.x, left.force.y, left.torque / self.lever);
        Trial { pose, steps, left }
    }

    /// A point along a line at which the force that is left along it has fallen to a share of `slope`, and how far
    /// that is: it falls all the way, to zero at the least value.
    fn along(
        &self,
        load: &Wrench<f64>,
        from: &Vector3<f64>,
        line: &Vector3<f64>,
        slope: f64,
    ) -> (f64, Trial) {
        let (mut low, mut high, mut length) = (0.0, f64::INFINITY, 1.0);
        let mut there = self.trial(load, &(from + line));
        for _ in 0..MOST_TRIALS {
            let left = there.left.dot(line);
            if left.abs() <= FLATTER * slope {
                break;
            }
            if left > 0.0 {
                low = length;
            } else {
                high = length;
            }
            length = if high.is_finite() {
                0.5 * (low + high)
            } else {
                FARTHER * length
            };
            there = self.trial(load, &(from + line * length));
        }
        (length, there)
    }

    fn row(&self, time: f64, load: &Wrench<f64>, grips: [StickSlip; 2]) -> [f64; COLUMNS.len()] {
        let slips = grips.map(|grip| if grip == StickSlip::Slip { 1.0 } else { 0.0 });
        let (x, angle) = (self.pose.position.x, self.pose.angle);
        [
            time,
            load.force.x,
            load.torque,
            x,
            angle,
            self.heat,
            slips[0],
            slips[1],
        ]
    }
}

impl MotionScene for ClampScene {
    fn quantities(&self) -> &'static [Quantity] {
        ClampSummary::QUANTITIES
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "loss_per_cycle",
            title: "Heat of a cycle",
            share: ["lets_go", "/ending", "lets go"],
        }
    }

    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError> {
        let result = watched(self, watch)?;
        let outcome = &result.outcome;
        let ending = match outcome.release_time {
            Some(time) => format!("lets go at {time:.6} s"),
            None => format!("holds {} cycles", self.cycles),
        };
        let told = vec![
            ("ending", ending),
            ("loss", format!("{:.6e} J a cycle", outcome.loss_per_cycle)),
            (
                "drift",
                format!("{:.3e} m a cycle", outcome.drift_per_cycle),
            ),
            (
                "swing",
                format!(
                    "{:.6e} to {:.6e} m",
                    outcome.least_position, outcome.most_position
                ),
            ),
        ];
        Ok(result.shown(told, (&["position"], "position [m]")))
    }

    fn carried(&self) -> Vec<(&'static str, String)> {
        vec![
            (
                "unknowns",
                "3: place and angle in the pinch, quasi-static".into(),
            ),
            (
                "law",
                format!(
                    "elastic bonds up to mu = {} and {}",
                    self.mu_first, self.mu_second
                ),
            ),
            ("patch", format!("{}, one on each side", self.patch)),
            (
                "method",
                "balance of both pads, each a return mapping".into(),
            ),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two elements in parallel: F₁ = 6 N at 2e4 N/m slips at 0.3 mm, F₂ = 10 N at 1e4 N/m at 1 mm.
    #[test]
    fn the_loss_of_a_cycle_is_that_of_two_elements_and_its_branches_obey_masings_rule() {
        for amplitude in [8.0, 9.5, 11.0, 14.0, 15.9] {
            let scene = ClampScene {
                force_amplitude: amplitude,
                samples: 400,
                ..ClampScene::default()
            };
            let result = scene.run().unwrap();
            let outcome = result.outcome;
            // Both are elastic up to 9 N; then the second alone.
            let first_loading = |force: f64| {
                if force <= 9.0 {
                    force / 3e4
                } else {
                    (force - 6.0) / 1e4
                }
            };
            let end = first_loading(amplitude);
            let loss = 4.0 * 6.0 * (end - 3e-4_f64).max(0.0);
            assert!(
                (outcome.loss_per_cycle - loss).abs() < 1e-9 * (1e-3 + loss),
                "{amplitude}: {outcome:?}"
            );
            assert!(
                (outcome.most_position - end).abs() < 1e-12
                    && (outcome.least_position + end).abs() < 1e-12
            );
            assert!(outcome.drift_per_cycle.abs() < 1e-12 && outcome.release_time.is_none());
            // From a quarter to three quarters of the last cycle the load falls.
            let falls = &result.rows[1700..=1900];
            for row in falls {
                let expected = end - 2.0 * first_loading(0.5 * (amplitude - row[1]));
                assert!(
                    (row[3] - expected).abs() < 1e-12,
                    "{amplitude} {row:?} {expected}"
                );
            }
        }
    }

    #[test]
    fn below_the_weaker_pad_nothing_slips_and_nothing_drifts_in_any_number_of_cycles() {
        let scene = ClampScene {
            force_amplitude: 3.0,
            force_mean: 4.0,
            torque_amplitude: 0.003,
            cycles: 1000,
            samples: 20,
            ..ClampScene::default()
        };
        let result = scene.run().unwrap();
        assert_eq!(
            (result.outcome.heat, result.outcome.release_time),
            (0.0, None)
        );
        let at = |cycle: usize| &result.rows[20 * cycle + 5];
        assert!((at(1)[3] - at(999)[3]).abs() < 1e-15);
        assert!(result.rows.iter().all(|row| row[6] == 0.0 && row[7] == 0.0));
    }

    #[test]
    fn a_load_that_grows_releases_the_pinch_at_the_sum_of_both_limits() {
        for (torque, mean) in [(0.0, 0.0), (0.0, 5.0)] {
            let scene = ClampScene {
                amplitude_growth: 0.1,
                force_mean: mean,
                torque_amplitude: torque,
                cycles: 10,
                samples: 400,
                ..ClampScene::default()
            };
            let result = scene.run().unwrap();
            let most = result
                .rows
                .iter()
                .map(|row| row[1].abs())
                .fold(0.0, f64::max);
            let time = result.outcome.release_time.unwrap();
            let (cycle, share) = (time.floor(), time.fract());
            let carried = load(&scene, cycle as u32, share).force.x.abs();
            // Under a torque the force is less than the sum of both limits.
            assert!(
                carried <= 16.0 + 1e-9 && carried >= most,
                "{carried} {most}"
            );
            assert!(most <= 16.0 + 1e-9 && most > 15.9, "{most}");
        }
    }

    #[test]
    fn pads_hold_what_both_carry_however_much_stiffer_one_is() {
        // The first slips at 6 N, at next to no displacement; the second carries the rest.
        for ratio in [1e-5, 2e3, 1e5] {
            let scene = ClampScene {
                stiffness_first: 1e4 * ratio,
                force_amplitude: 15.9,
                samples: 40,
                ..ClampScene::default()
            };
            let [first, second] = [6.0 / scene.stiffness_first, 10.0 / scene.stiffness_second];
            let (weak, strong) = if first < second {
                (6.0, first)
            } else {
                (10.0, second)
            };
            let soft = if first < second { 1e4 } else { 1e4 * ratio };
            let end = (15.9 - weak) / soft;
            let outcome = scene.run().unwrap().outcome;
            assert_eq!(outcome.release_time, None, "{ratio}");
            let loss = 4.0 * weak * (end - strong);
            assert!(
                (outcome.loss_per_cycle / loss - 1.0).abs() < 1e-7,
                "{ratio}: {outcome:?} {loss}"
            );
            assert!(
                (outcome.most_position / end - 1.0).abs() < 1e-7,
                "{ratio}: {outcome:?} {end}"
            );
        }
    }

    #[test]
    fn a_load_that_leaves_between_two_rows_is_seen() {
        // Rows at thirds of a cycle, where the sine is 0.87.
        let scene = ClampScene {
            force_amplitude: 17.0,
            samples: 3,
            ..ClampScene::default()
        };
        let release = scene.run().unwrap().outcome.release_time.unwrap();
        assert!(
            (17.0 * libm::sin(TAU * release) - 16.0).abs() < 1e-9,
            "{release}"
        );
    }

    #[test]
    fn a_run_ends_when_it_is_asked_to() {
        let scene = ClampScene::default();
        let ended = watched(&scene, &mut |share| share < 0.5);
        assert!(matches!(ended, Err(MotionError::InterruptedAt { time }) if time == 2.5));
    }
}
