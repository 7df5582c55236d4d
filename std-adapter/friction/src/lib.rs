//! Friction chosen at run time: a patch, a law and a tier by name.
//!
//! ```
//! use tribos::friction::{AnyFriction, Law, Patch, Tier};
//! use tribos::kernel::twist::Twist;
//! let patch: Patch = "hertz".parse()?;
//! let law: Law = "power:gamma=0.3,alpha=0.5".parse()?;
//! let ball = AnyFriction::<f64>::new(&patch, &law, None)?; // None: the quickest tier that serves both
//! assert_eq!(ball.tier(), Tier::Exact);
//! let contact = ball.with_radius(0.01)?; // m
//! let wrench = contact.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)); // N; m/s, m/s, rad/s
//! assert!(wrench.force.x < 0.0 && wrench.torque < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | type | what it is |
//! |---|---|
//! | [`Patch`] | a contact patch by name: `disk`, `annulus:0.8`, `hertz`, … |
//! | [`Law`] | a law of the local speed by name, with its parameters: `stribeck:mu_s=0.4,mu_d=0.2,vs=0.05` |
//! | [`Tier`] | how force and torque are evaluated: `exact` or `quadrature` |
//! | [`AnyFriction`] | the three together: the kernel's coupling |
//! | [`Area`] | any patch with its size, by name or by its corners, triangles or points |
//! | [`AreaFriction`] | an area under a law: wrench and Jacobian at any planar twist |
//! | [`LimitSurfaces`] | what an area carries under dry friction, for every force limit |
//! | [`StictionTest`] | whether a patch holds a push: for certain, not at all, or undecided |
//! | [`LAWS`] | all laws of the kernel: formula, parameters, units, source |
//!
//! One place decides which tier serves which exponent:
//!
//! | tier | serves |
//! |---|---|
//! | exact | −1 < α ≤ 128 on every round patch; on polynomial pressures α ≤ 10, in 64 bit only |
//! | quadrature | every local law; 1e-8 on disk and annulus, elsewhere nodes, 1e-3 of the load |
//!
//! A loop over many evaluations is quicker with the kernel's own type, which pays for no dispatch.

mod arc_piece;
mod area;
mod area_friction;
mod catalogue;
mod coefficients;
mod contact_friction;
mod contact_radius;
#[cfg(feature = "scenes")]
mod feet_files;
#[cfg(feature = "scenes")]
mod files;
mod flat;
mod floor;
mod hold;
mod image;
mod law;
mod owned_feet;
mod patch;
mod precision;
mod quadrature;
mod refusal;
#[cfg(feature = "scenes")]
mod setting;
mod surface;
mod surface_batch;
mod text;
mod tier;
mod visit;

pub use area::Area;
pub use area_friction::AreaFriction;
pub use catalogue::{LAWS, LawEntry, LawParameter};
#[doc(hidden)]
pub use catalogue::{LawConstructor, find};
pub use coefficients::Coefficients;
#[doc(hidden)]
pub use contact_friction::{AnyContactFriction, ContactVisitor};
pub use contact_radius::ContactRadius;
#[cfg(feature = "scenes")]
#[doc(hidden)]
pub use feet_files::load_of_feet;
#[doc(hidden)]
pub use flat::Flat;
pub use flat::FlatPatch;
#[doc(hidden)]
pub use flat::triangles_of;
pub use floor::{Floor, FootOnFloor, Surface};
pub use hold::StictionTest;
#[doc(hidden)]
pub use law::AnyLaw;
pub use law::Law;
pub use patch::Patch;
#[doc(hidden)]
pub use precision::Precision;
#[doc(hidden)]
pub use quadrature::{polynomial, pressure_nodes, round_nodes};
pub use refusal::FrictionError;
#[doc(hidden)]
pub use refusal::finite_number;
#[cfg(feature = "scenes")]
#[doc(hidden)]
pub use setting::{LAW, PATCH};
pub use surface::LimitSurfaces;
#[doc(hidden)]
pub use surface::points_of;
#[doc(hidden)]
pub use surface::{BoxedDryFriction, OwnedNodes};
#[doc(hidden)]
pub use surface_batch::SurfaceBatch;
pub use tier::Tier;
#[doc(hidden)]
pub use tier::{Evaluation, LARGEST_EXPONENT, valid_exponent};
#[doc(hidden)]
pub use visit::visit_disk;
#[doc(hidden)]
pub use visit::{RoundPower, Visitor, leaning, upright, visit};

use quadrature::{DiskOfAnyLaw, NodeQuadrature};
use std::fmt;
use tribos_core::coupling::{
    Annulus, LateralFriction, ReducedFriction, ReducedJacobian, ReducedWrench, RoundFriction,
};
use tribos_core::internals::LateralJacobian;
use tribos_core::real::Real;

/// Friction of a round patch of radius 1 under unit load: a patch, a law and a tier.
///
/// It is the kernel's coupling for the three, so that all that takes a [`ReducedFriction`] or a [`LateralFriction`]
/// takes it. A law that is a power of the speed also has a [`RoundPower`], for final motion and
/// sliders. *Units*: reduced wrenches are per load and per [`AnyFriction::coefficient`].
///
/// ```
/// use tribos::friction::{AnyFriction, Law, Patch, Tier};
/// use tribos::kernel::coupling::ReducedFriction;
/// let dry = AnyFriction::<f64>::new(&Patch::Disk, &Law::coulomb(0.3)?, None)?;
/// assert_eq!((dry.tier(), dry.coefficient(), dry.accuracy()), (Tier::Exact, 0.3, 0.0));
/// assert!((dry.reduced_wrench(0.0, 1.0).torque - 2.0 / 3.0).abs() < 1e-14); // the mean radius
/// assert!(dry.power().is_some_and(|power| power.exponent() == 0.0));
/// let law: Law = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".parse()?;
/// let oiled = AnyFriction::<f64>::new(&Patch::Disk, &law, None)?;
/// assert_eq!((oiled.tier(), oiled.coefficient()), (Tier::Quadrature, 1.0));
/// assert!((oiled.reduced_wrench(9.0, 0.0).force - 0.2).abs() < 1e-9); // sliding fast: mu_d
/// assert!(oiled.power().is_none() && oiled.exponent_at_rest() == 0.0);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
pub struct AnyFriction<R: Precision = f64> {
    kind: Kind<R>,
    law: Law,
    tier: Tier,
    coefficient: R,
    exponent_at_rest: f64,
}

/// The speed below which a journey holds its law, e⁻⁶⁰⁰.
const SLOWEST: f64 = 2.65e-261;

enum Kind<R: Real> {
    Power(Box<dyn RoundPower<R>>),
    Quadrature(Box<dyn LateralFriction<R> + Send + Sync>),
    Nodes(NodeQuadrature<R>),
}

impl<R: Precision> AnyFriction<R> {
    /// Friction of `law` on `patch`, in the tier asked for or in the quickest that serves both.
    pub fn new(patch: &Patch, law: &Law, tier: Option<Tier>) -> Result<Self, FrictionError> {
        let tier = Tier::choose::<R>(patch, law, tier)?;
        let any = |law: &Law| Ok::<_, FrictionError>(DiskOfAnyLaw::new(law.build::<R>()?));
        let kind = match (patch, tier) {
            (_, Tier::Exact) => {
                Kind::Power(visit(patch, law.exponent(), tier, visit::BoxingVisitor)?)
            }
            (Patch::Disk, _) => Kind::Quadrature(Box::new(any(law)?)),
            (Patch::Annulus(inner), _) => {
                Kind::Quadrature(Box::new(Annulus::new(any(law)?, R::from_f64(*inner))?))
            }
            _ => Kind::Nodes(NodeQuadrature::new(patch, law)?),
        };
        let coefficient = match kind {
            Kind::Power(_) => R::from_f64(law.coefficient()),
            _ => R::ONE,
        };
        Ok(Self {
            kind,
            law: *law,
            tier,
            coefficient,
            exponent_at_rest: law.exponent_near(SLOWEST),
        })
    }

    /// The tier that evaluates it.
    pub fn tier(&self) -> Tier {
        self.tier
    }

    /// What reduced wrenches are multiplied by: γ of a power of the speed outside of quadrature,
    /// otherwise 1, because the law is inside.
    pub fn coefficient(&self) -> R {
        self.coefficient
    }

    /// The contact of this friction on a patch of `radius`.
    pub fn with_radius(self, radius: R) -> Result<RoundFriction<R, Self>, tribos_core::Error> {
        let coefficient = self.coefficient;
        RoundFriction::new(self, coefficient, radius)
    }

    /// The reduced friction of a power of the speed, where the law is one and the tier is exact.
    pub fn power(&self) -> Option<&dyn RoundPower<R>> {
        match &self.kind {
            Kind::Power(power) => Some(&**power),
            _ => None,
        }
    }

    /// The relative accuracy of the tier where it is coarser than rounding, otherwise 0.
    pub fn accuracy(&self) -> f64 {
        match self.kind {
            Kind::Power(_) => 0.0,
            Kind::Quadrature(_) => quadrature::DISK_ACCURACY,
            Kind::Nodes(_) => quadrature::NODES_ACCURACY,
        }
    }

    /// The power of the speed that friction follows towards rest: α, or d ln(friction)/d ln(speed)
    /// of another law at e⁻⁶⁰⁰ of the unit of speed.
    pub fn exponent_at_rest(&self) -> f64 {
        self.exponent_at_rest
    }

    fn lateral_coupling(&self) -> &dyn LateralFriction<R> {
        match &self.kind {
            Kind::Power(power) => power.as_lateral(),
            Kind::Quadrature(coupling) => &**coupling,
            Kind::Nodes(nodes) => nodes,
        }
    }
}

impl<R: Precision> fmt::Debug for AnyFriction<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Friction")
            .field("law", &self.law)
            .field("tier", &self.tier)
            .finish_non_exhaustive()
    }
}

impl<R: Precision> ReducedFriction<R> for AnyFriction<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        self.lateral_coupling().reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        self.lateral_coupling().reduced_jacobian(slide, rim)
    }
    fn reduced_drag(&self, slide_sq: R, rim: R) -> [R; 2] {
        self.lateral_coupling().reduced_drag(slide_sq, rim)
    }
    fn reduced_drags(&self, slide_squares: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
        self.lateral_coupling().reduced_drags(slide_squares, rims)
    }
    fn reduced_wrenches(&self, slides: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 2]> {
        self.lateral_coupling().reduced_wrenches(slides, rims)
    }
    fn reduced_jacobians(&self, slides: &[R; 8], rims: &[R; 8]) -> Option<[[R; 8]; 4]> {
        self.lateral_coupling().reduced_jacobians(slides, rims)
    }
}

impl<R: Precision> LateralFriction<R> for AnyFriction<R> {
    fn lateral(&self, slide: R, rim: R) -> R {
        self.lateral_coupling().lateral(slide, rim)
    }
    fn lateral_jacobian(&self, slide: R, rim: R) -> LateralJacobian<R> {
        self.lateral_coupling().lateral_jacobian(slide, rim)
    }
    fn mean_square_radius(&self) -> R {
        self.lateral_coupling().mean_square_radius()
    }
}
