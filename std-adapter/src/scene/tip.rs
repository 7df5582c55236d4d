//! The scene of a tip that is turned on a substrate (thesis, section 5.3).

use super::body::BODY;
use super::entries::Entries;
use super::key::{Key, Reader};
use super::planar::Taker;
use super::problem::Problem;
use super::tip_keys::*;
use crate::md::pair::Shift;
use crate::md::system::Integrator;
use crate::tip::{LAYERS_OF_A_KIND, Outline, Shape};
use serde_json::{Map, Value};

/// What the strength of the drive means; all driven atoms have the same angular acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// Force over the distance from the axis.
    Angular,
    /// Mean force of the driven atoms.
    Mean,
    /// Force on the outermost atom.
    Largest,
}

/// How the driven layers are held along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lift {
    /// At their height.
    Fixed,
    /// All as one, under a force on each atom, negative towards the substrate.
    Loaded(f64),
}

/// What keeps the temperature of the bath layers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bath {
    /// Nosé–Hoover with this relaxation time.
    NoseHoover {
        /// In τ.
        relaxation: f64,
        /// Whether the tip's common rotation is left alone.
        spares_spin: bool,
    },
    /// Langevin with this rate.
    Langevin(f64),
    /// Nothing.
    None,
}

/// A validated scene. *Units*: σ, ε and m of the Lennard-Jones atoms are 1, times in σ√(m/ε).
///
/// ```
/// use tribos::scene::{Bath, Lift, Reading, Scene, TipScene, parse_scene};
/// let text = "body = \"tip\"\nlambda = 0.017\nhold = \"level\"\nload = 0.5\n\
///             thermostat = \"none\"\nequilibration = 20\ndrive_time = 200\n\
///             rest_time = 100\ntime_step = 0.005";
/// let Scene::Tip(scene) = parse_scene("tip.toml", text, &[])? else { unreachable!() };
/// assert_eq!((scene.reading, scene.bath), (Reading::Angular, Bath::None));
/// assert_eq!(scene.lift, Lift::Loaded(-0.5)); // down
/// assert_eq!(scene.stage_steps(), [4_000, 40_000, 20_000]);
/// assert!(TipScene::KEYS.iter().all(|key| scene.json().get(key.name).is_some()));
/// # Ok::<(), tribos::scene::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct TipScene {
    /// Crystal and tip.
    pub shape: Shape,
    /// λ
    pub lambda: f64,
    /// What λ means.
    pub reading: Reading,
    /// How the driven layers are held.
    pub lift: Lift,
    /// Of the potential.
    pub cutoff: f64,
    /// What is done there.
    pub shift: Shift,
    /// ε between tip and substrate.
    pub adhesion: f64,
    /// Of the thermostats.
    pub temperature: f64,
    /// The thermostats.
    pub bath: Bath,
    /// γ of the driven atoms.
    pub damping: f64,
    /// Times of the three stages: before, with and after the drive.
    pub stages: [f64; 3],
    /// Δt
    pub time_step: f64,
    /// Which velocities are kept.
    pub integrator: Integrator,
    /// Of the lists of neighbours.
    pub skin: f64,
    /// Of the first velocities and of noise.
    pub seed: u64,
    /// Steps from one line of the series to the next.
    pub samples: u64,
    pub(super) values: Map<String, Value>,
}

/// Distance at the potential's minimum, 2^(1/6) (thesis, section 5.3).
const MINIMUM: f64 = 1.122_462_048_309_373;
/// 6330 atoms as six layers of 28 × 28 and six hexagons of ten a side: an inference from the number.
const LATERAL: f64 = 28.0;
const LAYERS: f64 = 6.0;
const SIDE_ATOMS: f64 = 10.0;
/// Temperature and time of the drive in the thesis.
const THESIS_TEMPERATURE: f64 = 0.1;
const THESIS_DRIVE: f64 = 200.0;
/// A usual choice; the thesis gives none.
const USUAL_CUTOFF: f64 = 2.5;
const USUAL_STEP: f64 = 0.005;
const USUAL_SKIN: f64 = 0.3;
const USUAL_DAMPING: f64 = 0.1;
const USUAL_RELAXATION: f64 = 0.5;
const USUAL_FRICTION: f64 = 1.0;
const SETTLING: f64 = 50.0;
const RETURN: f64 = 100.0;
const SAMPLE_STEPS: f64 = 100.0;
/// Three stages of so many steps are counted without rounding; a run takes years.
const MOST_STEPS: f64 = 1e15;
const FIRST_SEED: f64 = 1.0;

impl TipScene {
    /// The keys of a scene with body = "tip".
    pub const KEYS: &'static [Key] = &[
        BODY,
        LAMBDA,
        READING,
        SPACING,
        COLUMNS,
        ROWS,
        SUBSTRATE_LAYERS,
        TIP_LAYERS,
        SIDE,
        OUTLINE,
        ORIENTATION,
        RAISE,
        HOLD,
        LOAD,
        CUTOFF,
        SHIFT,
        ADHESION,
        TEMPERATURE,
        THERMOSTAT,
        RELAXATION,
        FRICTION,
        SPIN,
        DAMPING,
        EQUILIBRATION,
        DRIVE,
        REST,
        TIME_STEP,
        INTEGRATOR,
        SKIN,
        SEED,
        SAMPLES,
    ];

    pub(super) fn from_entries(
        entries: Entries,
        problems: Vec<Problem>,
    ) -> Result<Self, Vec<Problem>> {
        let mut take = Taker {
            reader: Reader::new(Self::KEYS, entries, problems),
            values: Map::new(),
        };
        take.word(BODY);
        let shape = shape(&mut take);
        let lambda = take.required(LAMBDA);
        let reading =
            [Reading::Angular, Reading::Mean, Reading::Largest][take.word(READING).min(2)];
        let lift = lift(&mut take);
        let cutoff = take.or(CUTOFF, USUAL_CUTOFF);
        let shift = [Shift::None, Shift::Energy, Shift::Force][take.word(SHIFT).min(2)];
        let adhesion = take.or(ADHESION, 1.0);
        let temperature = take.or(TEMPERATURE, THESIS_TEMPERATURE);
        let bath = bath(&mut take);
        let damping = take.or(DAMPING, USUAL_DAMPING);
        let stages = [
            take.or(EQUILIBRATION, SETTLING),
            take.or(DRIVE, THESIS_DRIVE),
            take.or(REST, RETURN),
        ];
        let time_step = take.or(TIME_STEP, USUAL_STEP);
        let integrator =
            [Integrator::LeapFrog, Integrator::VelocityVerlet][take.word(INTEGRATOR).min(1)];
        let skin = take.or(SKIN, USUAL_SKIN);
        let seed = take.or(SEED, FIRST_SEED) as u64;
        let samples = take.or(SAMPLES, SAMPLE_STEPS) as u64;
        check_fit(&mut take, &shape, cutoff, skin);
        check_steps(&mut take, stages, time_step);
        check_bath(&mut take, bath, time_step);
        take.reader.finish(Self {
            shape,
            lambda,
            reading,
            lift,
            cutoff,
            shift,
            adhesion,
            temperature,
            bath,
            damping,
            stages,
            time_step,
            integrator,
            skin,
            seed,
            samples,
            values: take.values,
        })
    }

    /// Steps before, with and after the drive.
    pub fn stage_steps(&self) -> [u64; 3] {
        self.stages
            .map(|time| (time / self.time_step).round() as u64)
    }
}

fn shape(take: &mut Taker) -> Shape {
    let outlines = [Outline::Hexagon, Outline::Disk, Outline::Cone];
    let shape = Shape {
        spacing: take.or(SPACING, MINIMUM),
        columns: take.or(COLUMNS, LATERAL) as usize,
        rows: take.or(ROWS, LATERAL) as usize,
        substrate_layers: take.or(SUBSTRATE_LAYERS, LAYERS) as usize,
        tip_layers: take.or(TIP_LAYERS, LAYERS) as usize,
        side: take.or(SIDE, SIDE_ATOMS) as usize,
        outline: outlines[take.word(OUTLINE).min(2)],
        orientation: take.or(ORIENTATION, 0.0).to_radians(),
        raise: take.or(RAISE, 0.0),
    };
    if !shape.rows.is_multiple_of(2) {
        let message = format!("`rows` must be even, not {}", shape.rows);
        take.reader.object(ROWS.name, message);
    }
    let least = 2 * LAYERS_OF_A_KIND;
    for (key, layers) in [
        (SUBSTRATE_LAYERS, shape.substrate_layers),
        (TIP_LAYERS, shape.tip_layers),
    ] {
        if layers < least {
            let message = format!("`{}` must be at least {least}, not {layers}", key.name);
            take.reader.object(key.name, message);
        }
    }
    shape
}

fn lift(take: &mut Taker) -> Lift {
    let is_level = take.word(HOLD) == 1;
    match take.optional(LOAD) {
        Some(_) if !is_level => {
            let message =
                "`load` needs hold = \"level\": driven layers held in place carry any load";
            take.reader.object(LOAD.name, message.into());
            Lift::Fixed
        }
        load if is_level => Lift::Loaded(-load.unwrap_or(0.0)),
        _ => Lift::Fixed,
    }
}

fn bath(take: &mut Taker) -> Bath {
    let kind = take.word(THERMOSTAT);
    let relaxation = take.or(RELAXATION, USUAL_RELAXATION);
    let friction = take.or(FRICTION, USUAL_FRICTION);
    let spares_spin = take.word(SPIN) == 0;
    match kind {
        0 => Bath::NoseHoover {
            relaxation,
            spares_spin,
        },
        1 => Bath::Langevin(friction),
        _ => Bath::None,
    }
}

/// The tip must not see its own images, nor the list reach round the box.
fn check_fit(take: &mut Taker, shape: &Shape, cutoff: f64, skin: f64) {
    if shape.columns == 0 || shape.rows == 0 || !(cutoff + skin).is_finite() {
        return;
    }
    let [x, y] = shape.periods();
    // Corners of two layers that are stacked to either side of the axis, however the tip is turned.
    let aside = shape.spacing / 3.0_f64.sqrt();
    let width = 2.0 * ((shape.side as f64 - 1.0) * shape.spacing + aside);
    for (key, period) in [(COLUMNS, x), (ROWS, y)] {
        let least = (width + cutoff).max(2.0 * cutoff).max(cutoff + skin);
        if period < least {
            let message = format!(
                "`{}`: the period is {period:.3} sigma, but tip and cut-off need {least:.3}",
                key.name
            );
            take.reader.object(key.name, message);
        }
    }
}

/// A thermostat cannot relax within a step: its unknown would swing faster than it is followed.
fn check_bath(take: &mut Taker, bath: Bath, time_step: f64) {
    if let Bath::NoseHoover { relaxation, .. } = bath
        && relaxation < time_step
    {
        let message = format!(
            "`{}` is {relaxation:e}, less than a `time_step` of {time_step}; give at least that",
            RELAXATION.name
        );
        take.reader.object(RELAXATION.name, message);
    }
}

/// Every stage must have a number of steps that can be counted.
fn check_steps(take: &mut Taker, stages: [f64; 3], time_step: f64) {
    for (key, time) in [EQUILIBRATION, DRIVE, REST].into_iter().zip(stages) {
        let steps = time / time_step;
        if steps > MOST_STEPS {
            let message = format!(
                "`{}` is {steps:e} steps of `time_step`, more than {MOST_STEPS:e}",
                key.name
            );
            take.reader.object(key.name, message);
        }
    }
}
