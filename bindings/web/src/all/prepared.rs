//! Friction of a patch under a law, with its limit surfaces and free motions.

use super::shape::{Nodes, Shape, said};
use crate::exchange::Refused;
use crate::modes::FinalMotion;
use crate::patch::{Contact, Glides, Sets, Work};
use crate::slide::{End, Free};
use alloc::boxed::Box;
use alloc::format;
use core::cell::OnceCell;
use core::fmt;
use tribos::friction::{self, Law, Patch, RoundPower, Tier, Visitor, upright, visit};
use tribos_core::Error;
use tribos_core::coupling::flat::{
    DryPatch, FlatFriction, FlatPower, FlatPowerFriction, PowerPatch,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::round::{PolynomialTable, RoundTable64};
use tribos_core::coupling::{Annulus, Dry, DryCoupling, PatchFriction, closed, table::Coulomb};
use tribos_core::limit_surface::{LimitSurface, PatchSurface};
use tribos_core::slider::{Motion, SliderParameters};
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Friction of a patch under a law.
pub struct Prepared {
    /// Its friction at one motion.
    pub contact: Box<dyn Contact>,
    /// Whether it has an axis.
    pub is_round: bool,
    /// The patch.
    pub shape: Shape,
    /// The law.
    pub law: Law,
    sets: OnceCell<Result<Box<dyn Sets>, Refused>>,
    glides: OnceCell<Result<Box<dyn Glides>, Refused>>,
}

impl fmt::Debug for Prepared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Prepared")
            .field("shape", &self.shape)
            .field("law", &self.law)
            .finish_non_exhaustive()
    }
}

impl Prepared {
    /// Refuses a law that does not serve the patch.
    pub fn new(shape: Shape, law: &str) -> Result<Self, Refused> {
        let law: Law = law.parse().map_err(said)?;
        Ok(Self {
            contact: contact(&shape, &law)?,
            is_round: matches!(shape, Shape::Round(..)),
            shape,
            law,
            sets: OnceCell::new(),
            glides: OnceCell::new(),
        })
    }

    /// Coefficient and exponent of a power of the speed; NaN for other laws.
    pub fn power(&self) -> [f64; 2] {
        self.law.power_of_speed().unwrap_or([f64::NAN; 2])
    }

    /// Its limit surfaces, of dry friction.
    pub fn sets(&self) -> Result<&dyn Sets, Refused> {
        let made = self.sets.get_or_init(|| {
            if self.power()[1] == 0.0 {
                sets(&self.shape)
            } else {
                Err(said(format!(
                    "{} has no limit surface: its friction depends on the speed",
                    self.law
                )))
            }
        });
        made.as_deref().map_err(Refused::clone)
    }

    /// Its free motions, of a power of the speed on a round patch.
    pub fn glides(&self) -> Result<&dyn Glides, Refused> {
        let made = self.glides.get_or_init(|| {
            let (patch, alpha) = self.round_power()?;
            let slide = Tier::serving::<f64>(patch, &self.law, None)
                .and_then(|tier| visit(patch, alpha, tier, Kept))
                .map_err(said)?;
            let profile = upright(patch, alpha).map_err(said)?;
            let powered: Box<dyn Glides> = Box::new(Powered { slide, profile });
            Ok(powered)
        });
        made.as_deref().map_err(Refused::clone)
    }

    /// The round patch and the exponent of its law.
    pub fn round_power(&self) -> Result<(&Patch, f64), Refused> {
        let Shape::Round(patch, _) = &self.shape else {
            return Err(Refused::Because(
                "only a round patch slides straight: give a disk, ring, annulus or the like; rollout \
                 follows the others",
            ));
        };
        match self.law.power_of_speed() {
            Some([_, alpha]) => Ok((patch, alpha)),
            None => Err(said(format!(
                "{} is not a power of the speed: this needs Coulomb's law or mu |v|^alpha",
                self.law.name()
            ))),
        }
    }
}

/// Free motions in the quickest tier, final motion from closed forms where there are any. Behind a pointer, so
/// that the module has the integrator once and not for each patch.
struct Powered {
    slide: Box<dyn RoundPower<f64>>,
    profile: Box<dyn RoundPower<f64>>,
}

impl Glides for Powered {
    fn to_rest(&self, parameters: SliderParameters<f64>, from: &Motion<f64>) -> Free {
        End::to_rest(&*self.slide, parameters, from)
    }
    fn advance(&self, parameters: SliderParameters<f64>, from: &Motion<f64>, time: f64) -> Free {
        End::advance(&*self.slide, parameters, from, time)
    }
    fn modes(&self, inertia_ratio: f64, initial_ratio: f64) -> Result<FinalMotion, Refused> {
        FinalMotion::new(&*self.profile, inertia_ratio, initial_ratio)
    }
}

/// Puts the kernel's type behind a pointer.
struct Kept;

impl Visitor<f64> for Kept {
    type Output = Box<dyn RoundPower<f64>>;
    fn visit<P: RoundPower<f64> + 'static>(self, friction: P) -> Self::Output {
        Box::new(friction)
    }
}

impl<P: DryPatch<f64>> Contact for FlatFriction<f64, P> {
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        FlatFriction::wrench(self, load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.wrench_and_jacobian(load, twist).1
    }
}

impl<P: PowerPatch<f64>> Contact for FlatPowerFriction<f64, P> {
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        FlatPowerFriction::wrench(self, load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.wrench_and_jacobian(load, twist).1
    }
}

/// Points under any law of the local speed.
struct AtPoints(NodeFriction<friction::AnyLaw<f64>, Nodes>);

impl Contact for AtPoints {
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        self.0.wrench(load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.0.wrench_jacobian(load, twist)
    }
}

/// Makes the kernel's type of a power of the speed on a round patch.
struct Boxed {
    coefficient: f64,
    radius: f64,
}

impl Visitor<f64> for Boxed {
    type Output = Result<Box<dyn Contact>, Refused>;
    fn visit<P: RoundPower<f64> + 'static>(self, friction: P) -> Self::Output {
        let made = PatchFriction::new(friction, self.coefficient, self.radius)?;
        Ok(Box::new(made))
    }
}

/// Friction of `shape` under `law`.
fn contact(shape: &Shape, law: &Law) -> Result<Box<dyn Contact>, Refused> {
    law.made::<f64>().map_err(said)?;
    if let Shape::Round(patch, radius) = shape {
        return round(patch, *radius, law);
    }
    let power = law.power_of_speed();
    if let (Shape::Points(points), false) = (shape, matches!(power, Some([_, 0.0]))) {
        let law = law.made().map_err(said)?;
        let nodes = points.nodes().clone();
        return Ok(Box::new(AtPoints(NodeFriction::new(law, nodes))));
    }
    match power {
        Some([mu, 0.0]) => dry(shape, mu),
        Some([gamma, alpha]) => of_power(shape, gamma, alpha),
        None => Err(said(format!(
            "{} is not served on straight edges: Coulomb's law is, and on polygons powers of the \
             speed; or put points on the patch",
            law.name()
        ))),
    }
}

fn round(patch: &Patch, radius: f64, law: &Law) -> Result<Box<dyn Contact>, Refused> {
    let tier = Tier::serving::<f64>(patch, law, None).map_err(said)?;
    match (tier, law.power_of_speed()) {
        (Tier::Table | Tier::Compact, Some([coefficient, alpha])) => {
            let visitor = Boxed {
                coefficient,
                radius,
            };
            visit(patch, alpha, tier, visitor).map_err(said)?
        }
        _ => {
            let friction = friction::Friction::<f64>::new(patch, law, Some(tier));
            Ok(Box::new(friction.map_err(said)?.with_radius(radius)?))
        }
    }
}

fn dry(shape: &Shape, mu: f64) -> Result<Box<dyn Contact>, Refused> {
    fn boxed<P: DryPatch<f64> + 'static>(patch: P, mu: f64) -> Result<Box<dyn Contact>, Refused> {
        Ok(Box::new(FlatFriction::new(patch, mu)?))
    }
    match shape.clone() {
        Shape::Round(..) => Err(said(friction::Refusal::NoAxis)),
        Shape::Polygon(patch) => boxed(patch, mu),
        Shape::Leaning(patch) => boxed(patch, mu),
        Shape::Bar(patch) => boxed(patch, mu),
        Shape::Points(patch) => boxed(patch, mu),
    }
}

fn of_power(shape: &Shape, gamma: f64, alpha: f64) -> Result<Box<dyn Contact>, Refused> {
    let power = FlatPower::new(alpha)?;
    match shape.clone() {
        Shape::Polygon(patch) => Ok(Box::new(FlatPowerFriction::new(patch, gamma, power)?)),
        Shape::Leaning(patch) => Ok(Box::new(FlatPowerFriction::new(patch, gamma, power)?)),
        _ => Err(Refused::Because(
            "on bars friction is Coulomb's: give mu alone, or use a polygon or points",
        )),
    }
}

struct FlatSets<P>(P);

impl<P: DryPatch<f64>> Sets for FlatSets<P> {
    fn with(&self, force_limit: f64, work: Work<'_>) -> Result<(), Refused> {
        work(&PatchSurface::new(&self.0, force_limit)?);
        Ok(())
    }
}

/// The limit surfaces of dry friction on `shape`.
fn sets(shape: &Shape) -> Result<Box<dyn Sets>, Refused> {
    match shape.clone() {
        Shape::Round(patch, radius) => round_sets(&patch, radius),
        Shape::Polygon(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Leaning(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Bar(patch) => Ok(Box::new(FlatSets(patch))),
        Shape::Points(patch) => Ok(Box::new(FlatSets(patch))),
    }
}

/// The sets of a round patch, whose dry friction is behind a pointer for the same reason.
struct KeptSets {
    coupling: Box<dyn DryCoupling<f64>>,
    radius: f64,
}

impl Sets for KeptSets {
    fn with(&self, force_limit: f64, work: Work<'_>) -> Result<(), Refused> {
        let coupling = &*self.coupling;
        work(&LimitSurface::new(coupling, force_limit, self.radius)?);
        Ok(())
    }
}

fn round_sets(patch: &Patch, radius: f64) -> Result<Box<dyn Sets>, Refused> {
    let coupling: Box<dyn DryCoupling<f64>> = match patch {
        Patch::Disk => Box::new(Coulomb),
        Patch::Ring => Box::new(closed::Ring),
        Patch::Hertz => Box::new(closed::Hertz),
        Patch::Punch => Box::new(closed::FlatPunch),
        Patch::Annulus(inner) => Box::new(Annulus::new(Coulomb, *inner).map_err(Error::from)?),
        Patch::Polynomial(coefficients) => {
            let pressure = friction::polynomial(coefficients).map_err(said)?;
            let table = PolynomialTable::new(0.0, &pressure).map_err(said)?;
            Box::new(Dry::new(table)?)
        }
        _ => {
            let pressure = patch.pressure().ok_or(friction::Refusal::NoAxis);
            let table = RoundTable64::new(0.0, pressure.map_err(said)?).map_err(said)?;
            Box::new(Dry::new(table)?)
        }
    };
    Ok(Box::new(KeptSets { coupling, radius }))
}

/// The profile that launches are computed from.
pub fn profile(prepared: &Prepared) -> Result<Box<dyn RoundPower<f64>>, Refused> {
    let (patch, alpha) = prepared.round_power()?;
    upright(patch, alpha).map_err(said)
}
