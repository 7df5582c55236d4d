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
//! quasi-static. The step of each pad is the gradient of a convex function of the pose q, so that
//! q ← q + (S₁ + S₂)⁻¹ (w − z₁ − z₂) approaches the balance monotonically; where there is none, the pinch
//! lets go. One pad that slips while the other holds is Iwan's assembly of two elements, which obeys Masing's
//! rule: a branch of the loop is the first loading twice as large.

use super::StickError;
use super::held::{HeldRun, HeldScene};
use crate::friction::limit_surface;
use crate::record::json_number;
use crate::scene::ClampScene;
use serde_json::{Map, Value};
use std::f64::consts::TAU;
use tribos_core::Real;
use tribos_core::law::Grip;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::presliding::{Anchor, Pose, Presliding};
use tribos_core::twist::{Displacement, Wrench};

/// Columns of the series: s, N, N m, m, rad, J of heat so far, and whether each pad slips.
pub const CLAMP_COLUMNS: [&str; 8] = [
    "time",
    "force",
    "torque",
    "position",
    "angle",
    "heat",
    "first_slips",
    "second_slips",
];

/// Results of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClampOutcome {
    /// When the pinch lets go, in s; none if it holds to the end.
    pub release: Option<f64>,
    /// Heat of the last whole cycle, in J.
    pub loss: f64,
    /// Heat of the whole run, in J.
    pub heat: f64,
    /// Change of the position over the last whole cycle, in m.
    pub drift: f64,
    /// Largest and least position in the last whole cycle, in m.
    pub swing: [f64; 2],
}

/// Series and summary of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct ClampRun {
    /// Rows of the series, with the columns of [`CLAMP_COLUMNS`].
    pub rows: Vec<[f64; CLAMP_COLUMNS.len()]>,
    /// The summary.
    pub outcome: ClampOutcome,
}

/// Runs a scene to its end, or to the release.
///
/// *Accuracy*: the balance to 1e-12 of the pads' limits; the way of slips that turn is of first order in the
/// interval of the series, of those along a line it is exact but for where the interval meets the turn of the
/// load.
///
/// ```
/// use tribos::{scene::ClampScene, stick::clamp::run};
/// // 6 N and 10 N hold less than 17 N: it lets go where the force passes 16 N.
/// let outcome = run(&ClampScene { force_amplitude: 17.0, ..ClampScene::default() })?.outcome;
/// let release = outcome.release.ok_or("holds")?; // s
/// let force = 17.0 * (std::f64::consts::TAU * release).sin();
/// assert!((force - 16.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run(scene: &ClampScene) -> Result<ClampRun, StickError> {
    scene.check()?;
    let mut pinch = Pinch::new(scene)?;
    let mut rows = vec![pinch.row(0.0, &Wrench::ZERO, [Grip::Stick; 2])];
    let mut release = None;
    let samples = scene.samples;
    'cycles: for cycle in 0..scene.cycles {
        for index in 1..=samples {
            let share = f64::from(index) / f64::from(samples);
            let time = scene.period * (f64::from(cycle) + share);
            let load = load(scene, cycle, share);
            let Some(grips) = pinch.settle(&load) else {
                let held = f64::from(index - 1) / f64::from(samples);
                release = Some(release_between(scene, cycle, [held, share])?);
                break 'cycles;
            };
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
    let outcome = ClampOutcome {
        release,
        loss: rows[end][5] - rows[begin][5],
        heat: pinch.heat,
        drift: rows[end][3] - rows[begin][3],
        swing: [
            positions().fold(f64::INFINITY, f64::min),
            positions().fold(f64::NEG_INFINITY, f64::max),
        ],
    };
    Ok(ClampRun { rows, outcome })
}

/// The time, between two shares of a cycle, at which the load leaves what the pads carry together. They have
/// one shape, so that their sets add up to that of the sum of their coefficients.
fn release_between(
    scene: &ClampScene,
    cycle: u32,
    [mut held, mut lost]: [f64; 2],
) -> Result<f64, StickError> {
    let limit = (scene.mu_first + scene.mu_second) * scene.load;
    let both = limit_surface(&scene.patch, limit, scene.radius, None)?;
    loop {
        let middle = 0.5 * (held + lost);
        if middle <= held || middle >= lost {
            return Ok(scene.period * (f64::from(cycle) + lost));
        }
        if both.gauge(&load(scene, cycle, middle)) > 1.0 {
            lost = middle;
        } else {
            held = middle;
        }
    }
}

/// The load at a share of a cycle.
fn load(scene: &ClampScene, cycle: u32, share: f64) -> Wrench<f64> {
    let grown = 1.0 + scene.growth * f64::from(cycle);
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
struct Pinch {
    pads: [Pad; 2],
    pose: Pose<f64>,
    heat: f64,
    /// Largest force that both hold, and the lever of torques.
    limit: f64,
    lever: f64,
}

/// What the balance may leave, as a share of the limits.
const BALANCED: f64 = 1e-12;
/// Iterations after which there is no balance; a hundred are usual where one pad slips.
const MOST_ITERATIONS: u32 = 20_000;

impl Pinch {
    fn new(scene: &ClampScene) -> Result<Self, StickError> {
        let default = 0.5 * scene.radius * scene.radius;
        let lever_sq = scene.torsion_lever_squared.unwrap_or(default);
        let origin = Pose::new(0.0, 0.0, 0.0);
        let pad = |mu: f64, stiffness: f64| -> Result<Pad, StickError> {
            let bonds = Presliding::new(stiffness, stiffness * lever_sq)?;
            let set = limit_surface(&scene.patch, mu * scene.load, scene.radius, None)?;
            let anchor = Anchor::at(origin);
            Ok(Pad { set, bonds, anchor })
        };
        Ok(Self {
            pads: [
                pad(scene.mu_first, scene.stiffness_first)?,
                pad(scene.mu_second, scene.stiffness_second)?,
            ],
            pose: origin,
            heat: 0.0,
            limit: (scene.mu_first + scene.mu_second) * scene.load,
            lever: Real::sqrt(lever_sq),
        })
    }

    /// Moves the body to where the pads balance the load; none if they cannot.
    fn settle(&mut self, load: &Wrench<f64>) -> Option<[Grip; 2]> {
        let sliding: f64 = self.pads.iter().map(|pad| pad.bonds.stiffness()).sum();
        let torsion: f64 = self
            .pads
            .iter()
            .map(|pad| pad.bonds.torsional_stiffness())
            .sum();
        let mut pose = self.pose;
        for _ in 0..MOST_ITERATIONS {
            let steps = self
                .pads
                .each_ref()
                .map(|pad| pad.bonds.step(&*pad.set, &pad.anchor, &pose));
            let left = *load + steps[0].friction + steps[1].friction;
            let size = left.force.norm().max(left.torque.abs() / self.lever);
            if size <= BALANCED * self.limit {
                for (pad, step) in self.pads.iter_mut().zip(&steps) {
                    pad.anchor = step.anchor;
                    self.heat += step.dissipated;
                }
                self.pose = pose;
                return Some(steps.map(|step| step.grip));
            }
            let force = left.force / sliding;
            pose = pose.moved(&Displacement::new(force.x, force.y, left.torque / torsion));
        }
        None
    }

    fn row(&self, time: f64, load: &Wrench<f64>, grips: [Grip; 2]) -> [f64; CLAMP_COLUMNS.len()] {
        let slips = grips.map(|grip| if grip == Grip::Slip { 1.0 } else { 0.0 });
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

impl ClampOutcome {
    fn json(&self) -> Map<String, Value> {
        let mut map = Map::new();
        let ending = if self.release.is_some() {
            "lets go"
        } else {
            "holds"
        };
        map.insert("ending".into(), ending.into());
        let release = self.release.map_or(Value::Null, json_number);
        map.insert("release_time".into(), release);
        for (name, value) in [
            ("loss_per_cycle", self.loss),
            ("heat", self.heat),
            ("drift_per_cycle", self.drift),
            ("least_position", self.swing[0]),
            ("most_position", self.swing[1]),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map
    }
}

impl HeldScene for ClampScene {
    fn follow(&self) -> Result<HeldRun, StickError> {
        let result = run(self)?;
        let outcome = &result.outcome;
        let ending = match outcome.release {
            Some(time) => format!("lets go at {time:.6} s"),
            None => format!("holds {} cycles", self.cycles),
        };
        let told = vec![
            ("ending", ending),
            ("loss", format!("{:.6e} J a cycle", outcome.loss)),
            ("drift", format!("{:.3e} m a cycle", outcome.drift)),
            (
                "swing",
                format!("{:.6e} to {:.6e} m", outcome.swing[0], outcome.swing[1]),
            ),
        ];
        Ok(HeldRun {
            columns: &CLAMP_COLUMNS,
            rows: result.rows.iter().map(|row| row.to_vec()).collect(),
            outcome: outcome.json(),
            told,
            drawn: (&["position"], "position [m]"),
        })
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
            let result = run(&scene).unwrap();
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
                (outcome.loss - loss).abs() < 1e-9 * (1e-3 + loss),
                "{amplitude}: {outcome:?}"
            );
            assert!(
                (outcome.swing[1] - end).abs() < 1e-12 && (outcome.swing[0] + end).abs() < 1e-12
            );
            assert!(outcome.drift.abs() < 1e-12 && outcome.release.is_none());
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
        let result = run(&scene).unwrap();
        assert_eq!((result.outcome.heat, result.outcome.release), (0.0, None));
        let at = |cycle: usize| &result.rows[20 * cycle + 5];
        assert!((at(1)[3] - at(999)[3]).abs() < 1e-15);
        assert!(result.rows.iter().all(|row| row[6] == 0.0 && row[7] == 0.0));
    }

    #[test]
    fn a_load_that_grows_releases_the_pinch_at_the_sum_of_both_limits() {
        for (torque, mean) in [(0.0, 0.0), (0.0, 5.0)] {
            let scene = ClampScene {
                growth: 0.1,
                force_mean: mean,
                torque_amplitude: torque,
                cycles: 10,
                samples: 400,
                ..ClampScene::default()
            };
            let result = run(&scene).unwrap();
            let most = result
                .rows
                .iter()
                .map(|row| row[1].abs())
                .fold(0.0, f64::max);
            let time = result.outcome.release.unwrap();
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
}
