//! The scene of a granular gas in a periodic cube.

use super::{edge, lattice};
use crate::packing::PlacementError;
use crate::packing::method::NormalForce;
use tribos_base::scene::key::{Domain::*, MOST_SEEDS, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::{as_written, scene};
use tribos_base::scene::words::{Word, words};
use tribos_contacts::event::{Impact, Tangential};
use tribos_contacts::soft::STEPS_PER_COLLISION;

/// How the motion of a gas is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GasMethod {
    /// From collision to collision, with free flight between them.
    Events,
    /// By time steps of contact dynamics, with impacts that rebound.
    ContactDynamics,
    /// By time steps of spheres on springs and dashpots, whose collisions last.
    Soft,
}
words!(GasMethod { Events = "events", ContactDynamics = "contact-dynamics", Soft = "soft" });

scene! {
    /// A gas of equal solid spheres that lose energy when they collide. *Units*: lengths in radii R, masses in the
    /// mass m of a sphere, energies and temperatures in T0, the temperature at the start: times are in
    /// R √(m/T0).
    ///
    /// The default is a dilute gas of 1000 spheres that cools homogeneously.
    ///
    /// ```
    /// use tribos::{gas::GasSimulation, run::run_to_end, scene::GasScene};
    /// let scene = GasScene { count: 200, collisions: 2.0, ..GasScene::default() };
    /// let mut gas = GasSimulation::new(&scene)?;
    /// run_to_end(&mut gas, |_, _| ())?;
    /// assert!((0.5..1.0).contains(&gas.outcome().temperature));
    /// # Ok::<(), tribos::run::PackingRunError>(())
    /// ```
    pub struct GasScene = "gas", "A gas of spheres that cools",
        rules, as_written;

    /// Number of spheres.
    count: usize = 1000, "-", Count { from: 1.0, up_to: 1e6 };
    /// Packing fraction: share of the cube that the spheres fill.
    packing_fraction was fraction: f64 = 0.05, "-", Between { above: 0.0, up_to: 0.6 };
    /// Coefficient of restitution: normal speed after a collision over that before.
    restitution: f64 = 0.9, "-", Fraction;
    /// Tangential restitution, from -1 (smooth) to 1; if left out spheres are smooth, or stop under friction.
    tangential_restitution was tangential: Option<f64> = None, "-", Between { above: -1.0, up_to: 1.0 };
    /// Sliding coefficient mu that limits the tangential impulse; if left out there is no such limit.
    mu was friction: Option<f64> = None, "-", NotNegative;
    /// Temperature of the spins at the start.
    rotational_temperature was rotational: f64 = 0.0, "T0", NotNegative;
    /// Contact time t_c: a collision sooner after a sphere's last one loses no energy; 0 for none.
    contact_time: f64 = 0.0, "R sqrt(m/T0)", NotNegative, OnlyWith("method", "events");
    /// Seed of the places and velocities at the start.
    seed: u64 = 1, "-", Count { from: 1.0, up_to: MOST_SEEDS };
    /// Collisions a sphere without loss, before the run, that mix the start.
    // Velocities forget a start within a few collisions, places within some ten.
    mixing_collisions was mixing: f64 = 20.0, "-", NotNegative;
    /// Collisions a sphere after which a run ends; one of a pair counts for both.
    collisions: f64 = 30.0, "-", Positive;
    /// Time after which a run ends if it has not before; if left out there is no such bound.
    duration: Option<f64> = None, "R sqrt(m/T0)", Positive;
    /// Collisions a sphere from one line of the series to the next.
    sample_every was sample: f64 = 0.5, "-", Positive;
    /// How the motion is computed.
    method: GasMethod = GasMethod::Events, "-", OneOf(GasMethod::WORDS);
    /// Largest distance that a sphere may move in a time step.
    max_displacement was motion: f64 = 0.05, "R", Between { above: 0.0, up_to: 1.0 }, PartOf("method", "contact-dynamics");
    /// Stiffness of soft contacts: a head-on collision at a relative speed of 1 overlaps by 1/sqrt(2 stiffness).
    // At a packing fraction of 0.05 a collision takes 1 % of the time between two.
    stiffness: f64 = 1e4, "T0/R^2", Positive, PartOf("method", "soft");
    /// Elastic force of soft contacts: linear in the overlap, or Hertz's with the modulus `stiffness`/R.
    normal_law: NormalForce = NormalForce::Linear, "-", OneOf(NormalForce::WORDS), PartOf("method", "soft");
    /// Least number of steps of a collision of soft contacts.
    // Restitution is right to 0.5 % with so many.
    steps_per_collision: f64 = STEPS_PER_COLLISION, "-", Between { above: 2.0, up_to: 1e4 },
        PartOf("method", "soft");
}

/// Most lines of a series.
const MOST_LINES: f64 = 1e7;

/// The cube must have room, and the method must know the law.
fn rules(scene: &GasScene, judge: &mut SceneDiagnostics<'_>) {
    let length = edge(scene.count, scene.packing_fraction);
    if !lattice::is_wide(length) {
        let message = format!(
            "`count` and `packing_fraction` give a cube of {length:.3} R, but cells need 6 R: take more spheres"
        );
        judge.refuse(&["count", "packing_fraction"], message);
    } else if lattice::lattice(scene.count, length).is_none() {
        let fraction = scene.packing_fraction;
        let message = format!("`packing_fraction` is {fraction}: `count` spheres find no place");
        judge.refuse(&["packing_fraction", "count"], message);
    }
    let tangential = scene.tangential_restitution.is_some_and(|beta| beta != 0.0);
    let sticks = scene.tangential_restitution.is_some() && scene.mu.is_none();
    if scene.method != GasMethod::Events && (tangential || sticks) {
        let message = format!(
            "method = \"{}\" has no tangential restitution: leave `tangential_restitution` out and give `mu`, or neither",
            scene.method
        );
        judge.refuse(&["tangential_restitution", "method"], message);
    }
    if scene.method == GasMethod::Soft && scene.restitution == 0.0 {
        let message = "`restitution` must be above 0 with method = \"soft\": no dashpot takes all; take 0.01 or more";
        judge.refuse(&["restitution", "method"], message);
    }
    if scene.collisions / scene.sample_every > MOST_LINES {
        let message =
            format!("`collisions` over `sample_every` must not exceed {MOST_LINES:e} lines");
        judge.refuse(&["sample_every", "collisions"], message);
    }
}

impl GasScene {
    /// The law of a collision.
    #[doc(hidden)]
    pub fn impact(&self) -> Result<Impact, PlacementError> {
        let tangential = match (self.tangential_restitution, self.mu) {
            (None, None) => Tangential::Smooth,
            (Some(restitution), None) => Tangential::Rough { restitution },
            (beta, Some(mu)) => Tangential::Coulomb {
                mu,
                restitution: beta.unwrap_or(0.0),
            },
        };
        Ok(Impact::new(self.restitution, tangential)?)
    }
}
