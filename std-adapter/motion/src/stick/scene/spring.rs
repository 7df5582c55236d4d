//! The scene of a body on a spring.

use crate::stick::spring::{StateEvolutionKind, StickSlipRegime};
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::scene;
use tribos_base::scene::words::{Word, words};
use tribos_core::Real;
use tribos_core::law::{LocalLaw, LuGreParameters, RateStateParameters};
use tribos_friction::{LAW, Law};

/// What resists a body on a spring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpringFriction {
    /// Dry friction: μ_s at rest, growing with its time or not, μ_d in motion.
    Dry,
    /// Rate and state.
    RateState,
    /// LuGre's bristles.
    Bristles,
}
words!(SpringFriction {
    Dry = "dry",
    RateState = "rate-state",
    Bristles = "lugre",
});
words!(StateEvolutionKind { Ageing = "ageing", Slip = "slip" });
words!(StickSlipRegime {
    Rests = "rests",
    Creeps = "creeps",
    Steady = "steady",
    Oscillates = "oscillates",
    StickSlip = "stick-slip",
});

scene! {
    /// A body on a spring whose other end is pulled, held, and pulled again.
    ///
    /// The default is a block of 1 kg that sticks and slips.
    ///
    /// ```
    /// use tribos::{scene::{SpringFriction, SpringScene}, stick::spring::StickSlipRegime};
    /// // Paper on paper under a stiff spring, without mass.
    /// let friction = SpringFriction::RateState;
    /// let paper = SpringScene {
    ///     friction_law: friction, mass: 0.0, load: 10.0, pull_speed: 1e-6, pull_time: 100.0, ..SpringScene::default()
    /// };
    /// let critical = paper.critical_stiffness().ok_or("another law")?; // 2e5 N/m
    /// let stiff = SpringScene { stiffness: 1.5 * critical, ..paper };
    /// assert_eq!(stiff.run()?.outcome.regime, StickSlipRegime::Creeps);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[derive(Copy)]
    pub struct SpringScene = "spring", "A body on a spring that is pulled",
        rules, in_force;

    /// What resists the body.
    friction_law was friction: SpringFriction = SpringFriction::Dry, "-", OneOf(SpringFriction::WORDS);
    /// Mass of the body; 0 for a quasi-static one under rate and state.
    mass: f64 = 1.0, "kg", NotNegative, Required;
    /// Load of the body on the floor.
    load: f64 = 9.81, "N", Positive, Required;
    /// Stiffness of the spring.
    stiffness: f64 = 100.0, "N/m", Positive, Required;
    /// Speed of the end of the spring.
    pull_speed: f64 = 0.05, "m/s", Positive, Required;
    /// How long it is pulled; with holds, before the first and after each.
    pull_time: f64 = 20.0, "s", Positive, Required;
    /// How long the end of the spring stands still first; it never does if left out.
    hold_time was hold: Option<f64> = None, "s", Positive;
    /// Number of holds.
    hold_count was holds: u32 = 1, "-", Count { from: 1.0, up_to: 1000.0 };
    /// Duration of each hold over that of the one before.
    hold_time_ratio was hold_growth: f64 = 10.0, "-", Positive;
    /// Static coefficient, of dry friction, of a contact not older than `ageing_cutoff_time`.
    mu_static: f64 = DRY[0], "-", NotNegative;
    /// Dynamic coefficient, of dry friction.
    mu_dynamic: f64 = DRY[1], "-", NotNegative;
    /// Growth of the static coefficient for each e-fold of the time of rest, of dry friction.
    ageing_rate was growth: f64 = DRY[2], "-", NotNegative;
    /// Time of rest from which it grows, of dry friction.
    ageing_cutoff_time was cut_off: f64 = DRY[3], "s", Positive;
    /// Law of the speed in place of dry friction.
    law: Option<Law> = None, "-", LAW;
    /// Coefficient of steady sliding with `reference_speed`, of rate and state.
    mu_reference: f64 = 0.35, "-", NotNegative, PartOf("friction_law", "rate-state");
    /// Direct effect a of the speed, of rate and state.
    a: f64 = 0.01, "-", Positive, PartOf("friction_law", "rate-state");
    /// Effect b of the age, of rate and state.
    b: f64 = 0.03, "-", NotNegative, PartOf("friction_law", "rate-state");
    /// Reference speed, of rate and state.
    reference_speed: f64 = 1e-6, "m/s", Positive, PartOf("friction_law", "rate-state");
    /// Memory length D_c, of rate and state.
    slip_distance: f64 = 1e-6, "m", Positive, PartOf("friction_law", "rate-state");
    /// Viscous term of the inertial branch, of rate and state.
    radiation_damping was viscous: f64 = 0.0, "s/m", NotNegative, PartOf("friction_law", "rate-state");
    /// How the age evolves, of rate and state: Dieterich's ageing law or Ruina's slip law.
    evolution: StateEvolutionKind = StateEvolutionKind::Ageing, "-", OneOf(StateEvolutionKind::WORDS), PartOf("friction_law", "rate-state");
    /// Speed of the steady sliding that rate and state starts from; 0.9 `pull_speed` if left out.
    start_speed: Option<f64> = None, "m/s", Positive, PartOf("friction_law", "rate-state");
    /// Coulomb force of the bristles.
    coulomb_force: f64 = 0.5, "N", Positive, PartOf("friction_law", "lugre");
    /// Static force of the bristles.
    static_force: f64 = 0.8, "N", Positive, PartOf("friction_law", "lugre");
    /// Stribeck speed of the bristles.
    stribeck_speed: f64 = 0.01, "m/s", Positive, PartOf("friction_law", "lugre");
    /// Stiffness of the bristles.
    bristle_stiffness: f64 = 1e5, "N/m", Positive, PartOf("friction_law", "lugre");
    /// Damping of the bristles.
    bristle_damping: f64 = 316.0, "N s/m", NotNegative, PartOf("friction_law", "lugre");
    /// Viscous damping beside the bristles.
    viscous_damping: f64 = 0.4, "N s/m", NotNegative, PartOf("friction_law", "lugre");
    /// Error of a step, in units of the motion's scales; dry friction needs none.
    tolerance: f64 = 1e-9, "-", Between { above: 0.0, up_to: 0.01 };
    /// Number of intervals of time in the series, for each pull and each hold.
    samples: u32 = 400, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

/// Coefficients of dry friction at rest and in motion, growth, and the time from which it grows: of the size of
/// wood on wood.
const DRY: [f64; 4] = [0.5, 0.3, 0.0, 1.0];
/// Their keys.
const DRY_KEYS: [&str; 4] = [
    "mu_static",
    "mu_dynamic",
    "ageing_rate",
    "ageing_cutoff_time",
];

/// Times beyond this one, in s, leave too few digits for what follows.
const LONGEST_HOLD: f64 = 1e12;

fn rules(scene: &SpringScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.mass == 0.0 && scene.friction_law != SpringFriction::RateState {
        let message =
            "only friction_law = \"rate-state\" has a motion without mass: give `mass` > 0";
        judge.refuse(&["mass", "friction_law"], message);
    }
    if scene.is_dry() && scene.mu_dynamic > scene.mu_static {
        let message = format!(
            "`mu_dynamic` must not exceed `mu_static`, {}",
            scene.mu_static
        );
        judge.refuse(&["mu_dynamic", "mu_static"], message);
    }
    let is_lugre = scene.friction_law == SpringFriction::Bristles;
    if is_lugre && scene.coulomb_force > scene.static_force {
        let most = scene.static_force;
        let message = format!("`coulomb_force` must not exceed `static_force`, {most}");
        judge.refuse(&["coulomb_force", "static_force"], message);
    }
    let longest = scene.hold_time.map(|first| {
        first
            * Real::pow(
                scene.hold_time_ratio,
                f64::from(scene.hold_count.saturating_sub(1)),
            )
    });
    if longest.is_some_and(|time| time > LONGEST_HOLD) {
        let message = format!(
            "the longest hold, hold_time * hold_time_ratio^(hold_count - 1), must not exceed {LONGEST_HOLD:e} s"
        );
        judge.refuse(&["hold_count", "hold_time_ratio", "hold_time"], message);
    }
    no_dry_friction(scene, judge);
    match scene.law.map(|law| (law, law.build::<f64>())) {
        Some((_, Err(refusal))) => judge.refuse(&["law"], format!("`law`: {refusal}")),
        Some((law, Ok(made))) if !made.friction(0.0).is_finite() => {
            let message = format!(
                "friction of {} grows without bound at rest: such a body never lets go; give a law \
                 that is finite there, or friction_law = \"rate-state\"",
                law.name()
            );
            judge.refuse(&["law"], message);
        }
        _ => {}
    }
}

/// Refuses parameters of dry friction where something else resists.
fn no_dry_friction(scene: &SpringScene, judge: &mut SceneDiagnostics<'_>) {
    let values = [
        scene.mu_static,
        scene.mu_dynamic,
        scene.ageing_rate,
        scene.ageing_cutoff_time,
    ];
    let is_dry = scene.friction_law == SpringFriction::Dry;
    if !is_dry && scene.law.is_some() {
        let message =
            "`law` is for friction \"dry\" only, whose place it takes; leave one of them out";
        judge.refuse(&["law", "friction_law"], message);
    }
    for (key, (value, usual)) in DRY_KEYS.into_iter().zip(values.into_iter().zip(DRY)) {
        if value != usual && (!is_dry || scene.law.is_some()) {
            let message =
                format!("`{key}` is for friction \"dry\" without `law` only; leave it out");
            judge.refuse(&[key], message);
        }
    }
}

/// Where rate and state starts is a speed; where friction is not dry it has no coefficients.
fn in_force(scene: &SpringScene, key: &str, written: Option<Written>) -> Option<Written> {
    match key {
        "start_speed" => Some(Written::Number(scene.start())),
        _ if DRY_KEYS.contains(&key) => written.filter(|_| scene.is_dry()),
        _ => written,
    }
}

/// Speed at which rate and state starts, in speeds of the pull: near enough to be drawn to steady sliding,
/// far enough to leave it where that is unstable.
const START: f64 = 0.9;

impl SpringScene {
    /// Whether friction is dry.
    pub(crate) fn is_dry(&self) -> bool {
        self.friction_law == SpringFriction::Dry && self.law.is_none()
    }

    /// The speed that rate and state starts with.
    pub(crate) fn start(&self) -> f64 {
        self.start_speed.unwrap_or(START * self.pull_speed)
    }

    /// Parameters of rate and state.
    pub(crate) fn rate_state(&self) -> RateStateParameters<f64> {
        RateStateParameters {
            mu: self.mu_reference,
            a: self.a,
            b: self.b,
            reference_speed: self.reference_speed,
            slip_distance: self.slip_distance,
            viscous: self.radiation_damping,
        }
    }

    /// Parameters of the bristles.
    pub(crate) fn lugre(&self) -> LuGreParameters<f64> {
        LuGreParameters {
            coulomb_force: self.coulomb_force,
            static_force: self.static_force,
            stribeck_speed: self.stribeck_speed,
            stiffness: self.bristle_stiffness,
            bristle_damping: self.bristle_damping,
            viscous_damping: self.viscous_damping,
        }
    }
}
