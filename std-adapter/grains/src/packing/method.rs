//! Words of scenes of packings: how contacts are solved, which law walls have.

use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::words::words;
use tribos_contacts::soft::Stiffness;
use tribos_core::contact::Attraction;

/// How the contacts of a step are found and solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactMethod {
    /// Rigid spheres with constraint forces.
    ContactDynamics,
    /// Springs and dashpots.
    Soft,
}
words!(ContactMethod { ContactDynamics = "contact-dynamics", Soft = "soft" });

/// Elastic force of a soft contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalForce {
    /// In proportion to the overlap.
    Linear,
    /// To the power 3/2 of the overlap.
    Hertz,
}
words!(NormalForce { Linear = "linear", Hertz = "hertz" });

/// What spheres do at substrate and piston.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallLaw {
    /// The law of spheres.
    Full,
    /// Cohesion without friction.
    Smooth,
    /// Neither.
    Bare,
}
words!(WallLaw { Full = "full", Smooth = "smooth", Bare = "none" });

/// How the thresholds of sliding and torsion depend on each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrictionCoupling {
    /// Not at all (thesis, eqs. 4.1 and 4.2).
    Independent,
    /// By an ellipsoid with these thresholds for axes.
    Ellipsoid,
    /// By the limit surface of a round contact under uniform pressure with these thresholds.
    Exact,
}
words!(FrictionCoupling {
    Independent = "independent",
    Ellipsoid = "ellipsoid",
    Exact = "exact",
});

impl NormalForce {
    /// Normal spring of this stiffness; Hertz's modulus is the stiffness over the mean radius.
    pub(crate) fn spring(self, stiffness: f64, radius: f64) -> Stiffness {
        match self {
            Self::Linear => Stiffness::Linear(stiffness),
            Self::Hertz => Stiffness::Hertz(stiffness / radius),
        }
    }
}

/// Refuses what soft contacts cannot do. `restitution` is the least of all contacts.
pub(crate) fn soft_rules(
    judge: &mut SceneDiagnostics<'_>,
    attraction: Attraction,
    restitution: f64,
) {
    if attraction == Attraction::Resistance {
        let message = "`attraction` must be \"pull\" with method = \"soft\": a resistance to opening \
                       needs constraint forces";
        judge.refuse(&["attraction", "method"], message);
    }
    if restitution > 0.0 && judge.is_given("damping_ratio") {
        let message = "give `damping_ratio` or a `restitution` above 0, not both";
        judge.refuse(&["damping_ratio", "restitution"], message);
    }
}
