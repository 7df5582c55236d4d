//! The scene of a cohesive powder under a piston (thesis, section 4.5).

use crate::packing::PlacementError;
use crate::packing::method::{ContactMethod, FrictionCoupling, NormalForce, WallLaw, soft_rules};
use crate::packing::{COLUMNS, COLUMNS_ALONE, PackingColumns, SIZES, SizeDistribution};
use crate::powder::deposit::{Ballistic, DepositTarget};
use std::path::PathBuf;
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain, Domain::*, Form, MOST_SEEDS, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::{Setting, scene};
use tribos_base::scene::words::{Word, meant, words};
use tribos_contacts::cd::{ContactSolver, IterationOrder, SolverMethod, StepLimits, StopRule};
use tribos_contacts::soft::{STEPS_PER_COLLISION, Stiffness};
use tribos_core::contact::Attraction;

/// When a packing counts as blocked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockedCriterion {
    /// Forces balance and the piston stands.
    Balance,
    /// The piston stands (thesis, section 4.5).
    Piston,
}
words!(BlockedCriterion { Balance = "balance", Piston = "piston" });

/// Method for the contacts of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SweepMethod {
    /// Gauss–Seidel sweeps with momentum.
    Accelerated,
    /// Plain non-linear Gauss–Seidel sweeps.
    GaussSeidel,
}
words!(SweepMethod { Accelerated = "accelerated", GaussSeidel = "gauss-seidel" });

/// Order in which a plain sweep visits the contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SweepOrder {
    /// Forward and backward by turns.
    Alternating,
    /// Always the same.
    Fixed,
    /// Another one for each sweep.
    Random,
}
words!(SweepOrder { Alternating = "alternating", Fixed = "fixed", Random = "random" });

/// When plain sweeps stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SweepStop {
    /// When the change of all contacts together is small.
    Global,
    /// When the change of every contact is small.
    Local,
    /// After a fixed number.
    Fixed,
}
words!(SweepStop { Global = "global", Local = "local", Fixed = "fixed" });

/// Share of the last step's forces that a step starts from, from 0 to 1.
///
/// In files also "on", which is 1, and "off", which is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WarmStart(f64);

impl From<f64> for WarmStart {
    fn from(share: f64) -> Self {
        Self(share)
    }
}

const WARM_START: Domain = Domain::Form(&Form {
    name: "share",
    valid: "\"on\" or \"off\"",
    read: |text| match bool::of_word(text) {
        Some(starts) => Ok(vec![f64::from(starts)]),
        None => {
            let hint = meant(text, bool::WORDS);
            Err(format!(
                "must be a number from 0 to 1, or \"on\" or \"off\", got \"{text}\"{hint}"
            ))
        }
    },
    numbers: Some(&Domain::Fraction),
    names_absence: true,
});

impl Setting for WarmStart {
    fn written(&self) -> Written {
        match self.0 {
            1.0 => true.written(),
            0.0 => false.written(),
            share => share.written(),
        }
    }

    fn read(written: &Written) -> Option<Self> {
        let share = || Some(f64::from(bool::read(written)?));
        f64::read(written).or_else(share).map(Self)
    }
}

/// Stream of random orders of sweeps: another seed than the deposit's is of no use.
const ORDER_SEED: u64 = 1;

scene! {
    /// A cohesive powder under a piston. *Units*: lengths in mean radii R of the spheres, forces in
    /// F_coh, the density of the spheres is 1: times are in √(ρR⁴/F_coh).
    ///
    /// The default is the thesis' small system: 470 spheres on a base of 20 R by 20 R.
    ///
    /// ```
    /// use tribos::{powder::PowderSimulation, run::run_to_end, scene::PowderScene};
    /// let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..Default::default() };
    /// let mut compaction = PowderSimulation::new(&scene)?;
    /// run_to_end(&mut compaction, |_, _| ())?;
    /// let outcome = compaction.outcome();
    /// assert!(outcome.porosity_final < outcome.porosity_initial);
    /// # Ok::<(), tribos::run::PackingRunError>(())
    /// ```
    pub struct PowderScene = "powder", "A powder under a piston",
        rules, in_force;

    /// Side of the square base, periodic in x and y.
    width: f64 = 20.0, "R", Positive, Required;
    /// Height at which the deposit is cut and the piston starts, unless `count` or `initial_state` is given.
    height: f64 = 61.5, "R", Positive, UnlessEither("count", "initial_state");
    /// Number of spheres, in place of `height`.
    count: Option<usize> = None, "-", Count { from: 1.0, up_to: 1e6 };
    /// Spheres to start from in place of a deposit: a file (XYZ, a table, LAMMPS, VTK, MercuryDPM and others; see `tribos packing`), or the folder of a run, whose last state goes on.
    initial_state was start: Option<PathBuf> = None, "-", Path;
    /// Columns of a table that `initial_state` names, or arrays of a file of VTK, where the file does not say them: names in their
    /// order, `-` for one that is not read, `NAME=COLUMN` or `NAME=all:VALUE`.
    columns: Option<PackingColumns> = None, "-", COLUMNS;
    /// Distance of centres at which a falling sphere is captured, at least the largest diameter.
    // Thesis, section 4.5.
    capture_radius: f64 = 3.0, "R", Positive;
    /// Spread of the radii, which are uniform from 1 - spread to 1 + spread.
    radius_spread: f64 = 0.0, "R", Below { from: 0.0, below: 1.0 }, Without("initial_state");
    /// Distribution of the radii about their mean, in place of `radius_spread`.
    size_distribution was sizes: Option<SizeDistribution> = None, "-", SIZES, Without("initial_state");
    /// Seed of the deposit's random numbers.
    seed: u64 = 1, "-", Count { from: 1.0, up_to: MOST_SEEDS };
    /// Sliding coefficient mu: largest sliding force over P = F_n + F_coh.
    // Thesis, section 4.6.
    mu was sliding: f64 = 0.3, "-", NotNegative;
    /// Rolling coefficient mu_t: largest rolling torque over P r_eff; a length in Chrono and MuJoCo.
    mu_rolling was rolling: f64 = 0.0, "-", NotNegative;
    /// Torsion coefficient mu_n: largest torsion torque over P r_eff; a length in Chrono and MuJoCo.
    mu_torsion was torsion: f64 = 0.0, "-", NotNegative;
    /// How the thresholds of sliding and torsion depend on each other.
    coupling: FrictionCoupling = FrictionCoupling::Independent, "-", OneOf(FrictionCoupling::WORDS);
    /// Share of the spheres that are of a second material, chosen at random; those of `initial_state` that have materials keep them.
    second_fraction was share_second: f64 = 0.0, "-", Fraction;
    /// Density of the second material; that of the first if it is left out.
    second_density was density_second: Option<f64> = None, "rho", Positive;
    /// Sliding coefficient of the second material; that of the first if it is left out.
    mu_second was sliding_second: Option<f64> = None, "-", NotNegative;
    /// Sliding coefficient between the two materials; the geometric mean of theirs if it is left out.
    mu_mixed was sliding_mixed: Option<f64> = None, "-", NotNegative;
    /// Pressure on the piston.
    // Thesis, section 4.5.
    pressure: f64 = 1.0 / 400.0, "F_coh/R^2", Positive;
    /// Acceleration of the spheres, downwards; the piston has its pressure alone.
    gravity: f64 = 0.0, "F_coh/(rho R^3)", NotNegative;
    /// Gap d_c up to which cohesion acts.
    // Van der Waals attraction, F = A R/(12 D²) beyond the closest distance D₀ = 0.165 nm
    // (Israelachvili, Intermolecular and Surface Forces), takes the work F(D₀) D₀ to break: d_c is
    // D₀. A hundredth of R belongs to spheres of 16 nm, a nano-powder.
    cohesion_range: f64 = 1e-2, "R", NotNegative;
    /// Cohesion at a gap: a constant pull, or a resistance to opening.
    attraction: Attraction = Attraction::Pull, "-", OneOf(Attraction::WORDS);
    /// Coefficient of restitution: speed after an impact over speed before, at walls too.
    restitution: f64 = 0.0, "-", Fraction;
    /// Law at substrate and piston: that of spheres, cohesion only, or neither.
    wall_contact was wall: WallLaw = WallLaw::Full, "-", OneOf(WallLaw::WORDS);
    /// Mass of the piston.
    // Thesis, section 4.5.
    piston_mass: f64 = 1000.0, "rho R^3", Positive;
    /// Rigid spheres with constraint forces, or soft ones with springs and dashpots.
    method: ContactMethod = ContactMethod::ContactDynamics, "-", OneOf(ContactMethod::WORDS);
    /// Stiffness of soft contacts: the overlap under the force F_coh is R over this number.
    // Overlaps of a thousandth of the radius: ten times stiffer ones do not change the porosity.
    stiffness: f64 = 1e3, "F_coh/R", Positive, PartOf("method", "soft");
    /// Damping ratio of soft contacts in all modes, unless `restitution` is above 0.
    damping_ratio was damping: f64 = 1.0, "-", NotNegative, PartOf("method", "soft");
    /// Elastic force of soft contacts: linear in the overlap, or Hertz's with the modulus `stiffness`/R.
    normal_law: NormalForce = NormalForce::Linear, "-", OneOf(NormalForce::WORDS),
        PartOf("method", "soft");
    /// Least number of steps of a collision of soft contacts.
    // Restitution is right to 0.5 % with so many.
    steps_per_collision: f64 = STEPS_PER_COLLISION, "-", Between { above: 2.0, up_to: 1e4 },
        PartOf("method", "soft");
    /// Method for the contacts of a step.
    solver: SweepMethod = SweepMethod::Accelerated, "-", OneOf(SweepMethod::WORDS),
        PartOf("method", "contact-dynamics");
    /// Order of the contacts in a sweep of gauss-seidel.
    sweep_order was order: SweepOrder = SweepOrder::Alternating, "-", OneOf(SweepOrder::WORDS),
        OnlyWith("solver", "gauss-seidel");
    /// When gauss-seidel stops: by the change of all or of any contacts, or after `max_iterations`.
    stop_rule was stop: SweepStop = SweepStop::Global, "-", OneOf(SweepStop::WORDS),
        OnlyWith("solver", "gauss-seidel");
    /// Change of a sweep, relative to P, at which sweeps stop.
    // A tenfold smaller or larger tolerance leaves the final porosity as it is.
    tolerance: f64 = 1e-4, "-", Between { above: 0.0, up_to: 1.0 }, NotWith("stop_rule", "fixed");
    /// Most sweeps of a step, N_I; all of them with stop_rule = "fixed".
    // A bound for steps in which the tolerance is out of reach.
    max_iterations was sweeps: usize = 1000, "-", Count { from: 1.0, up_to: 1e6 }, PartOf("method", "contact-dynamics");
    /// Share of the last step's forces that a step starts from; "on" is 1, "off" is 0.
    // A number with `into`.
    warm_start: WarmStart = WarmStart(1.0), "-", WARM_START, PartOf("method", "contact-dynamics");
    /// Largest distance that a sphere may move in a step; soft contacts divide it into stable ones.
    // A twentieth of a radius keeps the angle by which a normal turns in a step small.
    max_displacement was motion: f64 = 0.05, "R", Between { above: 0.0, up_to: 0.5 };
    /// Longest time step.
    // The pressure moves the piston by 10⁻⁵ R in it from rest.
    max_time_step was time_step: f64 = 0.2, "sqrt(rho R^4/F_coh)", Positive;
    /// Sleep threshold: slower groups that nothing touches are left alone; with 0 none is.
    // A speed with which a sphere would cross a hundredth of its radius in 10⁵ units of time.
    still_speed: f64 = 1e-7, "sqrt(F_coh/rho)/R", NotNegative,
        PartOf("method", "contact-dynamics");
    /// Criterion of the end: forces balance and the piston stands, or the piston stands.
    blocked_criterion was blocked: BlockedCriterion = BlockedCriterion::Balance, "-", OneOf(BlockedCriterion::WORDS);
    /// Steps after which a run ends that is not blocked before.
    // Runs of the thesis' systems block within some thousand steps.
    max_steps was steps: u64 = 200_000, "-", Count { from: 1.0, up_to: 1e9 };
    /// Time after which a run ends that is not blocked before; if left out there is no such bound.
    duration: Option<f64> = None, "sqrt(rho R^4/F_coh)", Positive;
    /// Steps from one line of the series to the next.
    sample_every was samples: u64 = 20, "-", Count { from: 1.0, up_to: 1e9 };
}

/// Width, capture radius and spread of the radii must fit together, and so must method and cohesion.
fn rules(scene: &PowderScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.method == ContactMethod::Soft {
        for key in ["sweep_order", "stop_rule", "tolerance"] {
            if judge.is_given(key) {
                let message = format!("`{key}` is not used with method = \"soft\"; leave it out");
                judge.refuse(&[key, "method"], message);
            }
        }
        soft_rules(judge, scene.attraction, scene.restitution);
    }
    if scene.columns.is_some() && scene.initial_state.is_none() {
        judge.refuse(&["columns"], COLUMNS_ALONE);
    }
    if let Some(start) = &scene.initial_state {
        if scene.count.is_some() || scene.size_distribution.is_some() || scene.radius_spread > 0.0 {
            let message = format!(
                "`initial_state` has its own spheres, those of {}; leave out `count`, `size_distribution` and `radius_spread`",
                start.display()
            );
            judge.refuse(&["initial_state"], message);
        }
    } else if scene.size_distribution.is_some() && scene.radius_spread > 0.0 {
        judge.refuse(
            &["size_distribution", "radius_spread"],
            "give `radius_spread` or `size_distribution`, not both",
        );
    } else if let Err(error) = scene.ballistic() {
        let (keys, message): (&[&'static str], _) = match error {
            PlacementError::Sizes(error) => (&["size_distribution"], error.to_string()),
            _ => (
                &[
                    "capture_radius",
                    "width",
                    "radius_spread",
                    "size_distribution",
                ],
                format!("`capture_radius`, `width` and the radii do not fit together: {error}"),
            ),
        };
        judge.refuse(keys, message);
    }
}

/// A number of spheres or a start stands in place of the height, a start or a distribution in place of the
/// keys of the deposit, restitution in place of damping, springs in place of sweeps.
fn in_force(scene: &PowderScene, key: &str, written: Option<Written>) -> Option<Written> {
    let starts = scene.initial_state.is_some();
    let soft = scene.method == ContactMethod::Soft;
    written.filter(|_| match key {
        "height" => scene.count.is_none() && !starts,
        "radius_spread" => scene.size_distribution.is_none() && !starts,
        "capture_radius" => !starts,
        // A file may lack materials, which are drawn then.
        "seed" => !starts || scene.second_fraction > 0.0,
        "damping_ratio" => scene.restitution == 0.0,
        "sweep_order" | "stop_rule" | "tolerance" => !soft,
        _ => true,
    })
}

impl PowderScene {
    /// Force on the piston.
    ///
    /// ```
    /// let scene = tribos::scene::PowderScene::default();
    /// assert!((scene.load() - 1.0).abs() < 1e-15); // 400 R² under F_coh/400 a square radius
    /// ```
    pub fn load(&self) -> f64 {
        self.pressure * self.width * self.width
    }

    /// How the deposit grows, if width, capture radius and spread fit together.
    pub fn ballistic(&self) -> Result<Ballistic, PlacementError> {
        if let Some(sizes) = &self.size_distribution {
            return Ballistic::sized(self.width, sizes.radii()?, self.capture_radius);
        }
        let radii = [1.0 - self.radius_spread, 1.0 + self.radius_spread];
        Ballistic::uneven(self.width, radii, self.capture_radius)
    }

    /// Smallest radius of the deposit; 0 if the distribution is refused.
    pub(crate) fn least_radius(&self) -> f64 {
        match &self.size_distribution {
            Some(sizes) => sizes.radii().map_or(0.0, |radii| radii.bounds()[0]),
            None => 1.0 - self.radius_spread,
        }
    }

    /// When the deposit is complete.
    pub fn until(&self) -> DepositTarget {
        self.count
            .map_or(DepositTarget::Cut(self.height), DepositTarget::Count)
    }

    /// How contacts are solved.
    pub fn contact_solver(&self) -> ContactSolver {
        let tolerance = self.tolerance;
        let method = match self.solver {
            SweepMethod::Accelerated => SolverMethod::Accelerated { tolerance },
            SweepMethod::GaussSeidel => SolverMethod::GaussSeidel {
                order: match self.sweep_order {
                    SweepOrder::Alternating => IterationOrder::Alternating,
                    SweepOrder::Fixed => IterationOrder::Fixed,
                    SweepOrder::Random => IterationOrder::Random { seed: ORDER_SEED },
                },
                stop: match self.stop_rule {
                    SweepStop::Global => StopRule::Global(tolerance),
                    SweepStop::Local => StopRule::Local(tolerance),
                    SweepStop::Fixed => StopRule::Fixed,
                },
            },
        };
        ContactSolver {
            method,
            most_sweeps: self.max_iterations,
            warm_start: self.warm_start.0,
        }
    }

    /// Normal spring of soft contacts.
    #[doc(hidden)]
    pub fn spring(&self) -> Stiffness {
        // The mean radius is 1.
        self.normal_law.spring(self.stiffness, 1.0)
    }

    /// Bounds of the time step.
    pub fn step_limits(&self) -> StepLimits {
        StepLimits {
            motion: self.max_displacement,
            longest: self.max_time_step,
        }
    }
}
