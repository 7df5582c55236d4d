//! The scene of grains in a box: loads and walls that follow time.

mod rules;

use super::materials::{MATERIALS, PAIRS, PropertyList};
use super::ramp::{RAMP, RAMP_NOT_NEGATIVE, Ramp};
use super::texts::{COORDINATES, Coordinates, GrainTypes, TYPES};
use crate::packing::method::{ContactMethod, FrictionCoupling, NormalForce, WallLaw};
use crate::packing::{COLUMNS, PackingColumns, Radii, SIZES, SettingError, SizeDistribution};
use rules::{in_force, rules};
use std::f64::consts::PI;
use std::path::PathBuf;
use tribos_base::scene::key::{Domain::*, MOST_SEEDS, Need::*};
use tribos_base::scene::table::scene;
use tribos_base::scene::words::{Word, words};
use tribos_contacts::soft::{STEPS_PER_COLLISION, Stiffness};
use tribos_core::contact::Attraction;

/// What bounds the grains along a horizontal axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SideBoundary {
    /// Space repeats.
    Periodic,
    /// A wall on each side.
    Walls,
}
words!(SideBoundary { Periodic = "periodic", Walls = "walls" });

/// What bounds the grains along the vertical axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndBoundary {
    /// A floor, open above.
    Floor,
    /// A floor and a plate above.
    Walls,
    /// Space repeats.
    Periodic,
}
words!(EndBoundary { Floor = "floor", Walls = "walls", Periodic = "periodic" });

/// What holds the grains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Container {
    /// The box.
    Box,
    /// Two inclined planes above the floor of the box, with a slot between them.
    Hopper,
    /// A lying drum that turns about y, as wide as the box.
    Drum,
}
words!(Container { Box = "box", Hopper = "hopper", Drum = "drum" });

/// An axis of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Along `width`.
    X,
    /// Along `depth`.
    Y,
    /// Upwards.
    Z,
}
words!(Axis { X = "x", Y = "y", Z = "z" });

scene! {
    /// Grains in a box under gravity, pistons, moving plates and shaking. *Units*: SI; any other
    /// consistent set of units works, because no constant of nature is inside.
    ///
    /// x runs along `width`, y along `depth`, z upwards. Loads are numbers or ramps in time, see
    /// [`Ramp`].
    ///
    /// ```
    /// use tribos::{grains::GrainsSimulation, run::run_to_end, scene::GrainsScene};
    /// // Twenty beads of 1 cm fall on a floor and carry their weight to it.
    /// let scene = GrainsScene { width: 0.1, count: 20, duration: 1.0, ..Default::default() };
    /// let mut beads = GrainsSimulation::new(&scene)?;
    /// run_to_end(&mut beads, |_, _| ())?;
    /// let outcome = beads.outcome();
    /// assert!((outcome.end.floor_force / (outcome.mass * 9.81) - 1.0).abs() < 0.01);
    /// # Ok::<(), tribos::run::PackingRunError>(())
    /// ```
    pub struct GrainsScene = "grains", "Grains in a box",
        rules, in_force;

    /// Length of the box along x.
    width: f64 = 0.1, "m", Positive, Required;
    /// Length of the box along y; as long as `width` if it is left out. A two-dimensional box has none.
    depth: Option<f64> = None, "m", Positive;
    /// Height of the box: where the plate above starts, or the period; a floor alone does not use it. If it
    /// is left out, a plate starts at the highest grain.
    height: Option<f64> = None, "m", Positive;
    /// What bounds the box along x.
    boundary_x was x: SideBoundary = SideBoundary::Periodic, "-", OneOf(SideBoundary::WORDS);
    /// What bounds the box along y.
    boundary_y was y: SideBoundary = SideBoundary::Periodic, "-", OneOf(SideBoundary::WORDS);
    /// What bounds the box along z: a floor, floor and plate, or nothing.
    boundary_z was z: EndBoundary = EndBoundary::Floor, "-", OneOf(EndBoundary::WORDS);
    /// 3, or 2 for spheres that stay in the plane y = 0 and spin about y.
    dimension: u32 = 3, "-", Count { from: 2.0, up_to: 3.0 };
    /// What holds the grains: the box, a hopper in it, or a drum of diameter `width` about y.
    container: Container = Container::Box, "-", OneOf(Container::WORDS);
    /// Width of the slot of the hopper.
    orifice_width was outlet: f64 = 0.05, "m", Positive, OnlyWith("container", "hopper");
    /// Height of the slot above the floor.
    orifice_height was outlet_height: f64 = 0.1, "m", Positive, OnlyWith("container", "hopper");
    /// Angle of the plates of the hopper with the horizontal.
    hopper_angle was slope: f64 = 45.0, "degree", Below { from: 0.0, below: 90.0 }, OnlyWith("container", "hopper");
    /// Time at which the slot is opened.
    open_time was opening: f64 = 0.0, "s", NotNegative, OnlyWith("container", "hopper");
    /// Rate of rotation of the drum.
    drum_angular_velocity was drum_rate: Ramp = Ramp::from(1.0), "rad/s", RAMP, OnlyWith("container", "drum");
    /// Number of grains, unless `initial_state` has them.
    count: usize = 100, "-", Count { from: 1.0, up_to: 1e6 }, UnlessGiven("initial_state");
    /// Grains to start from in place of random ones: a file (XYZ, a table, LAMMPS, VTK, MercuryDPM and others; see `tribos packing`), or the folder of a run, whose last state goes on.
    initial_state was start: Option<PathBuf> = None, "-", Path;
    /// Columns of a table that `initial_state` names, or arrays of a file of VTK, where the file does not say them: names in their
    /// order, `-` for one that is not read, `NAME=COLUMN` or `NAME=all:VALUE`.
    columns: Option<PackingColumns> = None, "-", COLUMNS;
    /// Mean radius of the grains.
    radius: f64 = 0.005, "m", Positive, Required;
    /// Spread of the radii, in mean radii: they are uniform from 1 - spread to 1 + spread.
    radius_spread: f64 = 0.0, "-", Below { from: 0.0, below: 1.0 }, Without("initial_state");
    /// Distribution of the radii about their mean, in place of `radius_spread`.
    size_distribution was sizes: Option<SizeDistribution> = None, "-", SIZES, Without("initial_state");
    /// Density of the grains; those of `initial_state` that have one keep it.
    density: f64 = 2500.0, "kg/m^3", Positive, Required;
    /// Seed of the random start.
    seed: u64 = 1, "-", Count { from: 1.0, up_to: MOST_SEEDS };
    /// Distance of neighbours at the start, in diameters of the largest grain; the rest is random.
    initial_spacing was spacing: f64 = 1.2, "-", Between { above: 1.0, up_to: 100.0 };
    /// Height above the floor from which random grains are placed upwards.
    initial_height: f64 = 0.0, "m", NotNegative, Without("initial_state");
    /// Materials by name, up to 6, as `glass: mu=0.5, density=2500; steel: mu=0.2, density=7800, share=0.3, radius=1.5`: the n-th is type
    /// n of `initial_state`. `share` of the grains, drawn at random, are of a material, the rest of the first; `radius` is in mean radii.
    /// `mu`, `mu_rolling`, `mu_torsion`, `restitution`, `cohesion`, `density`, `stiffness`, `young_modulus` and `poisson_ratio` are
    /// those of the scene where they are left out.
    materials: Option<PropertyList> = None, "-", MATERIALS;
    /// What holds between two `materials`, or at walls, as `glass-steel: mu=0.3, restitution=0.5; steel-walls: mu=0.1`: coefficients,
    /// `restitution` and `cohesion` are the geometric means of both and springs in series where they are left out, and at walls those of
    /// two grains of the material.
    pairs: Option<PropertyList> = None, "-", PAIRS;
    /// Share of the grains that are of a second material, chosen at random; those of `initial_state` that have materials keep them.
    second_fraction was share_second: f64 = 0.0, "-", Fraction;
    /// Radius of these, in mean radii of the others.
    second_radius was radius_second: f64 = 1.0, "-", Between { above: 0.0, up_to: 100.0 };
    /// Density of the second material; that of the first if it is left out.
    second_density was density_second: Option<f64> = None, "kg/m^3", Positive;
    /// Sliding coefficient of the second material; that of the first if it is left out.
    mu_second was sliding_second: Option<f64> = None, "-", NotNegative;
    /// Sliding coefficient between the two materials; the geometric mean of theirs if it is left out.
    mu_mixed was sliding_mixed: Option<f64> = None, "-", NotNegative;
    /// Radius of grains glued to the floor in a square lattice, side by side, with their centres in its plane.
    rough_floor: Option<f64> = None, "m", Positive, Without("initial_state");
    /// Radius of grains glued to the plate above in the same way, which move with it.
    rough_lid: Option<f64> = None, "m", Positive, OnlyWith("boundary_z", "walls");
    /// Types of `initial_state` whose grains stay where they are in the box, whatever pushes them: rough bottoms and
    /// obstacles. Those that `rough_floor` glues are of type 7.
    fixed_kinds: GrainTypes = GrainTypes::FLOOR, "-", TYPES;
    /// Types of `initial_state` whose grains move as one body with the driven velocity and rotation. The intruder is of type 8.
    driven_kinds: GrainTypes = GrainTypes::DRIVEN, "-", TYPES;
    /// Radius of an intruder, a sphere that moves with the driven velocity through the grains.
    intruder_radius: Option<f64> = None, "m", Positive, Without("initial_state");
    /// Place of its centre at the start.
    intruder_position: Option<Coordinates> = None, "m", COORDINATES, Without("initial_state");
    /// Velocity of driven grains along x.
    driven_velocity_x: Ramp = Ramp::from(0.0), "m/s", RAMP;
    /// Velocity of driven grains along y.
    driven_velocity_y: Ramp = Ramp::from(0.0), "m/s", RAMP;
    /// Velocity of driven grains along z.
    driven_velocity_z: Ramp = Ramp::from(0.0), "m/s", RAMP;
    /// Rate of rotation of the driven grains as one body, right-handed about an axis through the mean of their centres: an impeller.
    driven_angular_velocity: Ramp = Ramp::from(0.0), "rad/s", RAMP;
    /// Direction of this axis.
    driven_axis: Coordinates = Coordinates([0.0, 0.0, 1.0]), "-", COORDINATES;
    /// Walls of triangles beside those of the box: an STL file, as text or binary, with the coordinates of the box.
    mesh: Option<PathBuf> = None, "-", Path;
    /// Factor from the lengths of `mesh` to those of the box, such as 0.001 for millimetres.
    mesh_scale: f64 = 1.0, "-", Positive;
    /// Velocity of the mesh.
    mesh_velocity: Coordinates = Coordinates([0.0; 3]), "m/s", COORDINATES;
    /// Rate of rotation of the mesh, right-handed about its axis.
    mesh_angular_velocity: f64 = 0.0, "rad/s", Finite;
    /// Direction of the axis of this rotation.
    mesh_axis: Coordinates = Coordinates([0.0, 0.0, 1.0]), "-", COORDINATES;
    /// A point of the axis at the start, which moves with the mesh; torques on it are about this point.
    mesh_centre: Coordinates = Coordinates([0.0; 3]), "m", COORDINATES;
    /// Cohesion F_coh: largest pull of a contact.
    cohesion: f64 = 0.0, "N", NotNegative;
    /// Surface energy gamma of the grains, from which cohesion follows in place of `cohesion`: 4 pi gamma r_eff, or 3 pi gamma r_eff
    /// with `adhesion` = "jkr"; r_eff is half the mean radius, for all pairs and at walls.
    surface_energy: Option<f64> = None, "J/m^2", Positive;
    /// Whose pull-off force follows from `surface_energy`: of stiff and small grains (Derjaguin, Muller, Toporov), or of soft
    /// and large ones (Johnson, Kendall, Roberts).
    adhesion: Adhesion = Adhesion::Dmt, "-", OneOf(Adhesion::WORDS);
    /// Gap up to which cohesion acts.
    cohesion_range: f64 = 0.0, "m", NotNegative;
    /// Cohesion at a gap: a constant pull, or a resistance to opening.
    attraction: Attraction = Attraction::Pull, "-", OneOf(Attraction::WORDS);
    /// Coefficient of restitution: speed after an impact over speed before, at walls too.
    restitution: f64 = 0.0, "-", Fraction;
    /// Sliding coefficient mu: largest sliding force over P = F_n + F_coh.
    // Glass beads, steel and sand lie between 0.2 and 0.6.
    mu was sliding: f64 = 0.5, "-", NotNegative;
    /// Rolling coefficient mu_t: largest rolling torque over P r_eff; a length in Chrono and MuJoCo.
    mu_rolling was rolling: f64 = 0.0, "-", NotNegative;
    /// Torsion coefficient mu_n: largest torsion torque over P r_eff; a length in Chrono and MuJoCo.
    mu_torsion was torsion: f64 = 0.0, "-", NotNegative;
    /// How the thresholds of sliding and torsion depend on each other.
    coupling: FrictionCoupling = FrictionCoupling::Independent, "-", OneOf(FrictionCoupling::WORDS);
    /// Law at walls: that of grains, cohesion only, or neither.
    wall_contact was wall: WallLaw = WallLaw::Full, "-", OneOf(WallLaw::WORDS);
    /// Gravity, downwards; 0 where nothing bears the grains, as in a sheared box.
    // Standard gravity, to three digits.
    gravity: Ramp = Ramp::from(9.81), "m/s^2", RAMP_NOT_NEGATIVE;
    /// Angle by which gravity leans from -z towards x.
    gravity_angle: Ramp = Ramp::from(0.0), "degree", RAMP;
    /// Stress on the wall at the far end of x, which moves as a piston; where x is periodic, on the box.
    wall_stress_x was pressure_x: Option<Ramp> = None, "Pa", RAMP_NOT_NEGATIVE;
    /// Stress on the wall at the far end of y, which moves as a piston; where y is periodic, on the box.
    wall_stress_y was pressure_y: Option<Ramp> = None, "Pa", RAMP_NOT_NEGATIVE;
    /// Stress on the plate above, which moves as a piston without weight; where z is periodic, on the box.
    wall_stress_z was pressure_z: Option<Ramp> = None, "Pa", RAMP_NOT_NEGATIVE;
    /// Mass of every piston, and of each axis of a box under a stress; that of all grains together if it is left out.
    piston_mass: Option<f64> = None, "kg", Positive;
    /// Speed of the wall at the far end of x along x, or at which the period along x grows; negative compresses.
    wall_velocity_x was velocity_x: Option<Ramp> = None, "m/s", RAMP;
    /// Speed of the wall at the far end of y along y, or at which the period along y grows; negative compresses.
    wall_velocity_y was velocity_y: Option<Ramp> = None, "m/s", RAMP;
    /// Speed of the plate above along z, or at which the period along z grows; negative compresses.
    wall_velocity_z was velocity_z: Option<Ramp> = None, "m/s", RAMP;
    /// Speed of the plate above along x, which shears the grains.
    lid_speed_x was plate_speed: Ramp = Ramp::from(0.0), "m/s", RAMP, OnlyWith("boundary_z", "walls");
    /// Rate at which a box without walls along x and z is sheared: speed along x over height along z.
    shear_rate: Option<f64> = None, "1/s", Finite, OnlyWith("boundary_z", "periodic");
    /// Inertial number I of a slow deformation, in place of a rate: the box is sheared at I sqrt(P/density)/(2 radius) under P =
    /// `wall_stress_z`; without that key z is shortened at this rate, of its length at the start, under P = `wall_stress_x`.
    inertial_number: Option<f64> = None, "-", Between { above: 0.0, up_to: 10.0 }, OnlyWith("boundary_z", "periodic");
    /// Speed of the walls along x and y upwards, which mobilizes their friction; negative downwards.
    side_wall_speed_z was wall_speed: Ramp = Ramp::from(0.0), "m/s", RAMP;
    /// Amplitude with which the box is shaken: all walls that are neither piston nor moved otherwise.
    shake_amplitude: f64 = 0.0, "m", NotNegative;
    /// Frequency of the shaking.
    shake_frequency: f64 = 25.0, "1/s", NotNegative;
    /// Direction of the shaking.
    shake_axis: Axis = Axis::Z, "-", OneOf(Axis::WORDS);
    /// Time after which all ramps start again; without it they are followed once.
    ramp_period was repeat: Option<f64> = None, "s", Positive;
    /// Rigid grains with constraint forces, or soft ones with springs and dashpots.
    method: ContactMethod = ContactMethod::ContactDynamics, "-", OneOf(ContactMethod::WORDS);
    /// Stiffness of soft contacts: force over overlap.
    // A bead of 1 cm under its weight overlaps by a quarter of a thousandth of its radius.
    stiffness: f64 = 1e4, "N/m", Positive, PartOf("method", "soft");
    /// Young's modulus of the grains, in place of `stiffness`: contacts are Hertz's with E* = young_modulus/(2 (1 - poisson_ratio^2)).
    young_modulus: Option<f64> = None, "Pa", Positive, PartOf("method", "soft");
    /// Poisson's ratio beside `young_modulus`.
    // Of glass, steel and stone 0.2 to 0.3.
    poisson_ratio: f64 = 0.25, "-", Between { above: -1.0, up_to: 0.5 }, PartOf("method", "soft");
    /// Damping ratio of soft contacts in all modes, unless `restitution` is above 0.
    damping_ratio was damping: f64 = 1.0, "-", NotNegative, PartOf("method", "soft");
    /// Elastic force of soft contacts: linear in the overlap, or Hertz's with the modulus `stiffness`/`radius`.
    normal_law: NormalForce = NormalForce::Linear, "-", OneOf(NormalForce::WORDS),
        PartOf("method", "soft");
    /// Least number of steps of a collision of soft contacts.
    // Restitution is right to 0.5 % with so many.
    steps_per_collision: f64 = STEPS_PER_COLLISION, "-", Between { above: 2.0, up_to: 1e4 },
        PartOf("method", "soft");
    /// Change of a sweep, relative to P, at which sweeps stop.
    tolerance: f64 = 1e-4, "-", Between { above: 0.0, up_to: 1.0 }, PartOf("method", "contact-dynamics");
    /// Most sweeps of a step.
    max_iterations was sweeps: usize = 1000, "-", Count { from: 1.0, up_to: 1e6 }, PartOf("method", "contact-dynamics");
    /// Largest distance that a grain may move in a step, in mean radii; soft contacts divide it into stable ones.
    // A twentieth of a radius keeps the angle by which a normal turns in a step small.
    max_displacement was motion: f64 = 0.05, "-", Between { above: 0.0, up_to: 0.5 };
    /// Longest time step; if it is left out, the time in which gravity moves a grain by `max_displacement` from
    /// rest, and at most a hundredth of `duration`.
    max_time_step was time_step: Option<f64> = None, "s", Positive;
    /// Time after which the run ends.
    duration: f64 = 1.0, "s", Positive, Required;
    /// Speed below which the grains are at rest: the run ends once their root mean square speed was lower
    /// for 100 steps.
    rest_speed was rest: Option<f64> = None, "m/s", Positive;
    /// Steps after which a run ends in any case.
    max_steps was steps: u64 = 10_000_000, "-", Count { from: 1.0, up_to: 1e9 };
    /// Steps from one line of the series to the next.
    sample_every was samples: u64 = 50, "-", Count { from: 1.0, up_to: 1e9 };
    /// Time from which on means over time are taken; for each column the time after which it has settled if it is left out.
    average_from: Option<f64> = None, "s", NotNegative;
}

/// Whose law gives the pull-off force of two spheres of one surface energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adhesion {
    /// Derjaguin, Muller and Toporov, J. Colloid Interface Sci. 53 (1975) 314: 2 π w r_eff, with w = 2 γ.
    Dmt,
    /// Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301: 3/2 π w r_eff.
    Jkr,
}
words!(Adhesion { Dmt = "dmt", Jkr = "jkr" });

impl Adhesion {
    /// Pull-off force in γ r_eff.
    fn pull_off(self) -> f64 {
        match self {
            Self::Dmt => 4.0 * PI,
            Self::Jkr => 3.0 * PI,
        }
    }
}

impl GrainsScene {
    /// Distribution of the radii, in mean radii, if `size_distribution` gives one.
    pub(crate) fn radii(&self) -> Result<Option<Radii>, SettingError> {
        self.size_distribution
            .as_ref()
            .map(SizeDistribution::radii)
            .transpose()
    }

    /// Smallest radius, in mean radii; 0 if the distribution is refused.
    pub(crate) fn least_radius(&self) -> f64 {
        match self.radii() {
            Ok(Some(radii)) => radii.bounds()[0],
            Ok(None) => 1.0 - self.radius_spread,
            Err(_) => 0.0,
        }
    }

    /// Normal spring of soft contacts, between grains of the first material.
    #[doc(hidden)]
    pub fn spring(&self) -> Stiffness {
        self.material().stiffness
    }

    /// Least restitution of any contact.
    fn least_restitution(&self) -> f64 {
        let mixture = self.mixture();
        mixture.all().map(|law| law.restitution).fold(1.0, f64::min)
    }

    /// Largest pull of a contact.
    pub(crate) fn pull_off(&self) -> f64 {
        match self.surface_energy {
            Some(gamma) => self.adhesion.pull_off() * gamma * 0.5 * self.radius,
            None => self.cohesion,
        }
    }

    /// Whether the grains stay in a plane.
    pub(crate) fn is_flat(&self) -> bool {
        self.dimension == 2
    }

    /// Depth of the box; of a two-dimensional one the mean diameter, so that stresses keep their unit.
    pub(crate) fn box_depth(&self) -> f64 {
        if self.is_flat() {
            2.0 * self.radius
        } else {
            self.depth.unwrap_or(self.width)
        }
    }

    /// Whether space repeats along an axis.
    pub(crate) fn is_periodic(&self, axis: Axis) -> bool {
        match axis {
            Axis::X => self.boundary_x == SideBoundary::Periodic,
            Axis::Y => self.boundary_y == SideBoundary::Periodic,
            Axis::Z => self.boundary_z == EndBoundary::Periodic,
        }
    }

    /// Whether a stress or a speed changes the lengths of a periodic box.
    pub(super) fn deforms(&self) -> bool {
        let driven = |axis: &Axis| self.pressure(*axis).is_some() || self.velocity(*axis).is_some();
        let all = [Axis::X, Axis::Y, Axis::Z];
        all.iter()
            .any(|axis| self.is_periodic(*axis) && driven(axis))
    }

    /// Rate at which the box is sheared, if it is.
    pub(crate) fn sheared(&self) -> Option<f64> {
        let slow = || {
            self.wall_stress_z
                .as_ref()
                .and_then(|stress| self.slow_rate(stress))
        };
        self.shear_rate.or_else(slow)
    }

    /// Rate at which `inertial_number` shortens z, in its length at the start.
    pub(super) fn compression(&self) -> Option<f64> {
        if self.wall_stress_z.is_some() {
            return None;
        }
        self.wall_stress_x
            .as_ref()
            .and_then(|stress| self.slow_rate(stress))
    }

    /// Rate of deformation of the inertial number under a stress: I sqrt(P/density)/d.
    fn slow_rate(&self, stress: &Ramp) -> Option<f64> {
        let root = libm::sqrt(stress.constant()? / self.density);
        Some(self.inertial_number? * root / (2.0 * self.radius))
    }

    /// Whether anything but images bounds the box; a plane has no period along y.
    fn has_walls(&self) -> bool {
        let mut axes = [Axis::X, Axis::Y, Axis::Z].into_iter();
        axes.any(|axis| !(self.is_periodic(axis) || axis == Axis::Y && self.is_flat()))
    }

    /// Whether the scene adds bodies that no force moves.
    fn has_bound(&self) -> bool {
        self.rough_floor.is_some()
            || self.rough_lid.is_some()
            || self.intruder_radius.is_some()
            || self.mesh.is_some()
    }

    /// Why nothing moves along an axis that a stress or a speed could drive.
    fn no_control(&self, axis: Axis) -> Option<&'static str> {
        if self.container == Container::Drum || (axis == Axis::Y && self.is_flat()) {
            Some("has no wall and no period to move: a drum and a plane have none")
        } else if axis == Axis::Z && self.boundary_z == EndBoundary::Floor {
            Some("needs boundary_z = \"walls\" or \"periodic\"; above a floor the box is open")
        } else if self.is_periodic(axis) && self.method != ContactMethod::Soft && self.has_walls() {
            Some(
                "deforms a periodic box of rigid grains, which then has no walls; method = \"soft\" may have some",
            )
        } else if self.is_periodic(axis)
            && self.method != ContactMethod::Soft
            && self.mixture().all().any(|law| law.restitution > 0.0)
        {
            Some(
                "deforms the box: rigid grains in it need restitution = 0, in `materials` and `pairs` too; method = \"soft\" takes any",
            )
        } else {
            None
        }
    }

    /// Stress on the moving wall of an axis.
    pub(crate) fn pressure(&self, axis: Axis) -> Option<&Ramp> {
        match axis {
            Axis::X => self.wall_stress_x.as_ref(),
            Axis::Y => self.wall_stress_y.as_ref(),
            Axis::Z => self.wall_stress_z.as_ref(),
        }
    }

    /// Speed of the moving wall of an axis.
    pub(crate) fn velocity(&self, axis: Axis) -> Option<&Ramp> {
        match axis {
            Axis::X => self.wall_velocity_x.as_ref(),
            Axis::Y => self.wall_velocity_y.as_ref(),
            Axis::Z => self.wall_velocity_z.as_ref(),
        }
    }
}
