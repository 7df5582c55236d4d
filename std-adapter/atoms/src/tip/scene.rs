//! The scene of a tip that is turned or slid on a substrate (thesis, section 5.3).

use crate::md::pair::Shift;
use crate::md::system::Integrator;
use crate::tip::{CrystalFace, LAYERS_OF_A_KIND, Shape, TipOutline, TipPotential};
use tribos_base::record::brief;
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{self, Domain, Domain::*, MOST_SEEDS, Need::*, reads};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::scene;
use tribos_base::scene::words::{Word, words};

/// What moves the tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DriveKind {
    /// A torque about the vertical on the driven layers.
    Torque,
    /// A support that pulls the driven layers through a spring.
    Slide,
}
words!(DriveKind { Torque = "torque", Slide = "slide" });

/// What the strength of the drive means; all driven atoms have the same angular acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorqueNormalisation {
    /// Force over the distance from the axis.
    Angular,
    /// Mean force of the driven atoms.
    Mean,
    /// Force on the outermost atom.
    Largest,
}
words!(TorqueNormalisation { Angular = "angular", Mean = "mean", Largest = "largest" });

/// How the driven layers are held along z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrivenHold {
    /// Each atom at its height.
    Plane,
    /// All at a common height that is free under a load.
    Level,
}
words!(DrivenHold { Plane = "plane", Level = "level" });

/// What keeps the temperature of the bath layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThermostatKind {
    /// A Nosé–Hoover thermostat.
    NoseHoover,
    /// A Langevin thermostat.
    Langevin,
    /// Nothing.
    None,
}
words!(ThermostatKind { NoseHoover = "nose-hoover", Langevin = "langevin", None = "none" });

/// Whether the tip's common motion is heat for its thermostat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThermostatBias {
    /// The rotation of a turned tip, or the velocity of a slid one, is left alone.
    Spared,
    /// The common motion counts as heat.
    Counts,
}
words!(ThermostatBias { Spared = "spared", Counts = "counts" });

/// A potential of atoms, as [`TipPotential`] reads it.
const POTENTIAL: Domain = Form(&key::Form {
    name: "potential",
    valid: "\"lennard-jones\", \"sutton-chen:Cu\" or another metal, or \"eam:FILE\"",
    read: reads::<TipPotential>,
    numbers: None,
    names_absence: true,
});
tribos_base::spelled!(TipPotential);

words!(TipOutline { Hexagon = "hexagon", Disk = "disk", Cone = "cone" });
words!(CrystalFace { Fcc111 = "fcc111", Fcc100 = "fcc100", Fcc110 = "fcc110" });
words!(Shift { None = "none", Energy = "energy", Force = "force" });
words!(Integrator { LeapFrog = "leap-frog", VelocityVerlet = "velocity-verlet" });

/// Steps of the stages of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StageSteps {
    /// Steps before the drive is switched on.
    pub before: u64,
    /// Steps with the drive.
    pub driven: u64,
    /// Steps after the drive.
    pub after: u64,
}

impl StageSteps {
    /// Steps of the whole run.
    pub fn total(&self) -> u64 {
        self.before + self.driven + self.after
    }
}

/// Frozen or driven layers, and as many with a thermostat.
const LEAST_LAYERS: f64 = (2 * LAYERS_OF_A_KIND) as f64;
/// Largest distance of neighbours in a Lennard-Jones crystal, in σ: nothing holds a wider one.
const WIDEST: f64 = 2.0;
/// Three stages of so many steps are counted without rounding; a run takes years.
const MOST_STEPS: f64 = 1e15;

scene! {
    /// A tip that is turned or slid on a substrate. *Units*: with the Lennard-Jones potential σ, ε and m
    /// of the atoms are 1, times are in τ = σ√(m/ε). With a metal every σ stands for Å, every ε for eV,
    /// every τ for ps and every ε/k_B for K.
    ///
    /// The default is the thesis' tip of 6330 atoms under its weakest drive.
    ///
    /// ```
    /// use tribos::{run::Simulation, scene::TipScene, tip::TipSimulation};
    /// let scene = TipScene {
    ///     substrate_columns: 8,
    ///     substrate_rows: 8,
    ///     substrate_layers: 4,
    ///     tip_layers: 4,
    ///     tip_side_atoms: 2,
    ///     ..TipScene::default()
    /// };
    /// let mut run = TipSimulation::new(&scene)?;
    /// assert!(run.step()?); // to the next line of the series
    /// # Ok::<(), tribos::tip::TipError>(())
    /// ```
    pub struct TipScene = "tip", "A tip turned or slid on a substrate",
        rules, in_force;

    /// Potential of all atoms. With a metal lengths are in A, energies in eV, times in ps, temperatures
    /// in K and forces in eV/A where other keys say sigma, eps, tau, eps/k_B and eps/sigma.
    potential: TipPotential = TipPotential::default(), "-", POTENTIAL;
    /// Distance of neighbours in a Lennard-Jones crystal, at most 2; the default is that of the potential's
    /// minimum. A metal's follows from its potential, see `lattice_expansion`.
    // 2^(1/6) (thesis, section 5.3).
    spacing: f64 = 1.122_462_048_309_373, "sigma", Between { above: 0.5, up_to: 10.0 };
    /// Part by which the crystals of a metal are wider than at zero temperature and pressure.
    lattice_expansion was expansion: f64 = 0.0, "-", Between { above: -0.2, up_to: 0.2 };
    /// Face of the substrate's crystal that is parallel to its layers; close-packed rows are along x.
    face: CrystalFace = CrystalFace::Fcc111, "-", OneOf(CrystalFace::WORDS);
    /// Face of the tip's crystal that is parallel to its layers.
    tip_face: CrystalFace = CrystalFace::Fcc111, "-", OneOf(CrystalFace::WORDS);
    /// Atoms along x in a layer of the substrate, periodic.
    // 6330 atoms as six layers of 28 × 28 and six hexagons of ten a side: an inference from the
    // number.
    substrate_columns was columns: usize = 28, "-", Count { from: 1.0, up_to: 1000.0 };
    /// Rows of atoms along y, an even number for fcc111, periodic.
    substrate_rows was rows: usize = 28, "-", Count { from: 1.0, up_to: 1000.0 };
    /// Layers of the substrate: two frozen, two with a thermostat, the rest free.
    substrate_layers: usize = 6, "-", Count { from: LEAST_LAYERS, up_to: 100.0 };
    /// Layers of the tip: two driven, two with a thermostat, the rest free.
    tip_layers: usize = 6, "-", Count { from: LEAST_LAYERS, up_to: 100.0 };
    /// Atoms on a side of the tip's top layer, or from its middle to its rim.
    tip_side_atoms was side: usize = 10, "-", Count { from: 1.0, up_to: 300.0 };
    /// Outline of the tip's layers.
    outline: TipOutline = TipOutline::Hexagon, "-", OneOf(TipOutline::WORDS);
    /// Angle by which the tip's close-packed rows are turned out of those of the substrate.
    tip_orientation was orientation: f64 = 0.0, "degree", Between { above: -180.0, up_to: 180.0 };
    /// Height of the driven layers above their place in the crystal.
    raise: f64 = 0.0, "sigma", Finite;
    /// What moves the tip: a torque on the driven layers, or a support that pulls them through a spring.
    drive: DriveKind = DriveKind::Torque, "-", OneOf(DriveKind::WORDS);
    /// Speed of the support.
    speed: Option<f64> = None, "sigma/tau", Positive, PartOf("drive", "slide");
    /// Direction in which the support moves, from the close-packed rows of the substrate along x.
    drive_angle was direction: f64 = 0.0, "degree", Between { above: -360.0, up_to: 360.0 }, PartOf("drive", "slide");
    /// Stiffness of the spring between the support and the driven layers.
    stiffness: f64 = 10.0, "eps/sigma^2", Positive, PartOf("drive", "slide");
    /// Way of the support from one turning point to the next; if left out it does not turn.
    stroke: Option<f64> = None, "sigma", Positive, PartOf("drive", "slide");
    /// Torque: force on each driven atom, see `reading`.
    lambda: f64 = 0.017, "eps/sigma^2", Finite, UnlessGiven("speed");
    /// Meaning of lambda: the force at a distance of sigma from the axis, or the mean or largest force.
    reading: TorqueNormalisation = TorqueNormalisation::Angular, "-", OneOf(TorqueNormalisation::WORDS);
    /// How driven layers are held: z of each atom fixed, or z common and free under `load`.
    driven_constraint was hold: DrivenHold = DrivenHold::Plane, "-", OneOf(DrivenHold::WORDS);
    /// Force on each driven atom towards the substrate; if left out it is 0.
    load: Option<f64> = None, "eps/sigma", Finite, OnlyWith("driven_constraint", "level");
    /// Cut-off radius of the Lennard-Jones potential; a metal has its own.
    // A usual choice; the thesis gives none, here and where no other source is named.
    cutoff: f64 = 2.5, "sigma", Between { above: 1.0, up_to: 10.0 };
    /// How the Lennard-Jones potential is shifted at the cut-off.
    shift: Shift = Shift::None, "-", OneOf(<Shift as Word>::WORDS);
    /// Depth of the Lennard-Jones potential between tip and substrate.
    adhesion_energy was adhesion: f64 = 1.0, "eps", Positive;
    /// Target temperature of the thermostats.
    // Thesis, section 5.3.
    temperature: f64 = 0.1, "eps/k_B", NotNegative;
    /// Thermostat of the bath layers.
    thermostat: ThermostatKind = ThermostatKind::NoseHoover, "-", OneOf(ThermostatKind::WORDS);
    /// Relaxation time of the Nose-Hoover thermostat.
    thermostat_time was relaxation: f64 = 0.5, "tau", Positive;
    /// Rate of the Langevin thermostat.
    langevin_rate was friction: f64 = 1.0, "1/tau", Positive;
    /// Whether the tip's common motion is heat for its thermostat: the rotation of a turned tip
    /// (Nose-Hoover only), the velocity of a slid one.
    spin: ThermostatBias = ThermostatBias::Spared, "-", OneOf(ThermostatBias::WORDS);
    /// Damping rate gamma of the driven atoms: the force on each is -gamma m v, with v relative to
    /// the support of a slid tip.
    drive_damping_rate was damping: f64 = 0.1, "1/tau", NotNegative;
    /// Time before the drive is switched on.
    equilibration: f64 = 50.0, "tau", NotNegative;
    /// Time that the drive lasts.
    // Thesis, section 5.3.
    drive_time: f64 = 200.0, "tau", NotNegative;
    /// Time after the drive.
    rest_time: f64 = 100.0, "tau", NotNegative;
    /// Time step of the integrator.
    time_step: f64 = 0.005, "tau", Between { above: 0.0, up_to: 0.05 };
    /// Integrator, which says at what times velocities are kept.
    integrator: Integrator = Integrator::LeapFrog, "-", OneOf(Integrator::WORDS);
    /// Distance that neighbour lists reach beyond the cut-off.
    skin: f64 = 0.3, "sigma", Positive;
    /// Seed of the first velocities and of noise.
    seed: u64 = 1, "-", Count { from: 1.0, up_to: MOST_SEEDS };
    /// Steps from one line of the series to the next.
    sample_every was samples: u64 = 100, "-", Count { from: 1.0, up_to: 1e9 };
}

fn rules(scene: &TipScene, judge: &mut SceneDiagnostics<'_>) {
    metal(scene, judge);
    if scene.face == CrystalFace::Fcc111 && !scene.substrate_rows.is_multiple_of(2) {
        judge.refuse(
            &["substrate_rows", "face"],
            format!(
                "`substrate_rows` must be even with face = \"fcc111\", not {}",
                scene.substrate_rows
            ),
        );
    }
    tip_fits(scene, judge);
    steps_count(scene, judge);
    slide_turns(scene, judge);
    // A thermostat cannot relax within a step: its unknown would swing faster than it is followed.
    let (relaxation, step) = (scene.thermostat_time, scene.time_step);
    if scene.thermostat == ThermostatKind::NoseHoover && relaxation < step {
        let message = format!(
            "`thermostat_time` is {relaxation}, less than a `time_step` of {step}; give at least that"
        );
        judge.refuse(&["thermostat_time", "time_step"], message);
    }
}

/// The tip must not see its own images, nor the list reach round the box.
fn tip_fits(scene: &TipScene, judge: &mut SceneDiagnostics<'_>) {
    let (shape, cutoff) = (scene.shape(), scene.reach());
    let [x, y] = shape.periods();
    // Corners of two layers that are stacked to either side of the axis, however the tip is turned.
    let width = 2.0 * shape.reach();
    let unit = if scene.potential.is_metal() {
        "A"
    } else {
        "sigma"
    };
    let least = (width + cutoff).max(2.0 * cutoff).max(cutoff + scene.skin);
    for (key, period) in [("substrate_columns", x), ("substrate_rows", y)] {
        if period < least {
            let message = format!(
                "`{key}`: the period is {period:.3} {unit}, but `tip_side_atoms`, `cutoff` and `skin` need {least:.3}"
            );
            judge.refuse(
                &[key, "tip_side_atoms", "spacing", "cutoff", "skin"],
                message,
            );
        }
    }
}

/// A slid tip has a speed, moves less than half a spacing in a step of its support, and does not
/// turn more than once in one.
fn slide_turns(scene: &TipScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.drive == DriveKind::Torque {
        return;
    }
    let Some(speed) = scene.speed else {
        let message = "`speed` is missing: speed of the support [sigma/tau], a finite number > 0";
        judge.refuse(&["speed", "drive"], message);
        return;
    };
    let step = speed * scene.time_step;
    let most = 0.5 * scene.spacings()[0];
    if step > most {
        let message = format!(
            "`speed` is {} sigma a `time_step`, more than half the spacing, {most:.3}",
            brief(&step)
        );
        judge.refuse(&["speed", "time_step", "spacing"], message);
    }
    if let Some(stroke) = scene.stroke.filter(|&stroke| stroke < step) {
        let message = format!(
            "`stroke` is {stroke}, less than the {} sigma of a `time_step`",
            brief(&step)
        );
        judge.refuse(&["stroke", "speed", "time_step"], message);
    }
}

/// Keys of Lennard-Jones atoms have no say with a metal: left out, or what they are.
fn metal(scene: &TipScene, judge: &mut SceneDiagnostics<'_>) {
    if !scene.potential.is_metal() {
        if scene.spacing > WIDEST {
            let spacing = scene.spacing;
            let message = format!(
                "`spacing` must be at most {WIDEST} sigma with potential = \"lennard-jones\", not {spacing}"
            );
            judge.refuse(&["spacing", "potential"], message);
        }
        if scene.lattice_expansion != 0.0 {
            let message = "`lattice_expansion` is for metals only; set `spacing`, or leave it out";
            judge.refuse(&["lattice_expansion", "potential"], message);
        }
        return;
    }
    let usual = TipScene::default();
    for (key, given, own, default) in [
        ("spacing", scene.spacing, scene.spacings()[0], usual.spacing),
        ("cutoff", scene.cutoff, scene.reach(), usual.cutoff),
        (
            "adhesion_energy",
            scene.adhesion_energy,
            usual.adhesion_energy,
            usual.adhesion_energy,
        ),
    ] {
        if given != own && given != default {
            let message = format!(
                "`{key}` is for \"lennard-jones\" only; a metal has its own, {own}: leave it out"
            );
            judge.refuse(&[key, "potential"], message);
        }
    }
    if scene.shift != usual.shift {
        let message = "`shift` is for \"lennard-jones\" only; leave it out";
        judge.refuse(&["shift", "potential"], message);
    }
}

/// A slid tip has no strength of a torque; a metal has its own crystal and cut-off.
fn in_force(scene: &TipScene, key: &str, written: Option<Written>) -> Option<Written> {
    match key {
        "spacing" => Some(Written::Number(scene.spacings()[0])),
        "cutoff" => Some(Written::Number(scene.reach())),
        "lambda" if scene.drive == DriveKind::Slide => None,
        _ => written,
    }
}

/// Every stage must have a number of steps that can be counted.
fn steps_count(scene: &TipScene, judge: &mut SceneDiagnostics<'_>) {
    for (key, time) in [
        ("equilibration", scene.equilibration),
        ("drive_time", scene.drive_time),
        ("rest_time", scene.rest_time),
    ] {
        let steps = time / scene.time_step;
        if steps > MOST_STEPS {
            let message = format!(
                "`{key}` is {} steps of `time_step`, more than {MOST_STEPS:e}",
                brief(&steps)
            );
            judge.refuse(&[key, "time_step"], message);
        }
    }
}

impl TipScene {
    /// Crystal and tip.
    pub fn shape(&self) -> Shape {
        let [spacing, tip_spacing] = self.spacings();
        Shape {
            face: self.face,
            tip_face: self.tip_face,
            spacing,
            tip_spacing,
            columns: self.substrate_columns,
            rows: self.substrate_rows,
            substrate_layers: self.substrate_layers,
            tip_layers: self.tip_layers,
            side: self.tip_side_atoms,
            outline: self.outline,
            orientation: self.tip_orientation.to_radians(),
            raise: self.raise,
        }
    }

    /// Distances of neighbours in the crystals of substrate and tip.
    pub fn spacings(&self) -> [f64; 2] {
        match self.potential.spacings() {
            Some(spacings) => spacings.map(|spacing| spacing * (1.0 + self.lattice_expansion)),
            None => [self.spacing; 2],
        }
    }

    /// Cut-off of the potential.
    pub fn reach(&self) -> f64 {
        self.potential.cutoff().unwrap_or(self.cutoff)
    }

    /// Force along z on each driven atom of a level tip.
    pub fn lift(&self) -> f64 {
        -self.load.unwrap_or(0.0)
    }

    /// Steps before, with and after the drive.
    ///
    /// ```
    /// use tribos::scene::{StageSteps, TipScene};
    /// let steps: StageSteps = TipScene::default().stage_steps(); // of 0.005
    /// assert_eq!((steps.before, steps.driven, steps.after), (10_000, 40_000, 20_000));
    /// ```
    pub fn stage_steps(&self) -> StageSteps {
        let steps = |time: f64| (time / self.time_step).round() as u64;
        StageSteps {
            before: steps(self.equilibration),
            driven: steps(self.drive_time),
            after: steps(self.rest_time),
        }
    }
}
