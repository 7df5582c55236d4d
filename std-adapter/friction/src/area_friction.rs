//! Friction of any contact area under any law: which type of the kernel evaluates it is decided here.

use super::{
    AnyFriction, AnyLaw, Area, Flat, FrictionError, Law, OwnedNodes, Patch, Precision, RoundPower,
    Tier, Visitor, visit,
};
use std::fmt;
use tribos_core::coupling::flat::{
    PolygonPowerLaw, PowerLawPatch, ShapeFriction, ShapePowerFriction,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::patch::nodes::Node;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Friction of a contact area under a law: wrench and Jacobian at any planar twist.
///
/// | area | Coulomb's law | powers of the speed | other laws |
/// |---|---|---|---|
/// | round | tiers | tiers | quadrature |
/// | polygons | exact | exact | – |
/// | points | exact | sum | sum |
/// | bars, meshes, others | exact | – | – |
///
/// *Units*: N, m/s, rad/s, N m; wrench and twist refer to the origin of the area. *Accuracy*: the bits of the
/// kernel's own type. *Cost*: that of the kernel's type and one indirect call, for a batch as for one twist.
///
/// ```
/// use tribos::friction::{Area, AreaFriction, Law, Patch, FrictionError};
/// use tribos::kernel::twist::Twist;
/// let parcel = Area::<f64>::named(&"box:0.3x0.2".parse()?, 1.0, None)?;
/// let friction = AreaFriction::new(&parcel, &Law::coulomb(0.4)?, None)?;
/// let turning = Twist::new(0.5, 0.0, 3.0); // m/s, m/s, rad/s
/// let wrench = friction.wrench(20.0, &turning); // N
/// assert!(wrench.force.x < 0.0 && wrench.torque < 0.0);
/// // What a patch does not serve is refused with what does.
/// let oil: Law = "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05".parse()?;
/// assert!(matches!(AreaFriction::new(&parcel, &oil, None), Err(FrictionError::Unserved(_))));
/// assert!(AreaFriction::new(&Area::round(Patch::Disk, 0.1)?, &oil, None).is_ok());
/// # Ok::<(), FrictionError>(())
/// ```
pub struct AreaFriction<R: Precision = f64> {
    kernel: Box<dyn AtTwist<R>>,
    law: Law,
    tier: Option<Tier>,
}

impl<R: Precision> AreaFriction<R> {
    /// Friction of `law` on `area`. A tier is for round areas: the one asked for, or the quickest that serves
    /// both.
    pub fn new(area: &Area<R>, law: &Law, tier: Option<Tier>) -> Result<Self, FrictionError> {
        let flat = match area {
            Area::Round(patch, radius) => return Self::round(patch, *radius, law, tier),
            Area::Flat(flat) => flat,
        };
        if tier.is_some() {
            return Err(FrictionError::Unserved(
                "tier is for round patches: leave it out for straight edges and points, which have \
                 one way of evaluation each"
                    .into(),
            ));
        }
        let made = law.build::<R>()?;
        let kernel: Box<dyn AtTwist<R>> = match (flat, law.power_of_speed()) {
            (_, Some([mu, 0.0])) => Box::new(ShapeFriction::new(flat.clone(), R::from_f64(mu))?),
            (Flat::Points(points), _) => Box::new(NodeFriction::new(made, points.nodes().clone())),
            (Flat::Polygon(patch), Some(power)) => of_power(patch.clone(), power)?,
            (Flat::Leaning(patch), Some(power)) => of_power(patch.clone(), power)?,
            (_, Some(_)) => {
                return Err(FrictionError::Unserved(
                    "this patch serves dry friction alone: give Coulomb's law, or use a box, a polygon \
                     or points"
                        .into(),
                ));
            }
            (_, None) => {
                return Err(FrictionError::Unserved(format!(
                    "patches with straight edges serve Coulomb's law, and polygons powers of the speed, \
                     not {}: give one of these, or put points on the patch",
                    law.name()
                )));
            }
        };
        let law = *law;
        Ok(Self { kernel, law, tier })
    }

    /// Friction of points as a sum over them, under every law; one point is enough.
    pub fn at_points(nodes: Vec<Node<R>>, law: &Law) -> Result<Self, FrictionError> {
        let nodes = OwnedNodes::new(nodes)?;
        Ok(Self {
            kernel: Box::new(NodeFriction::new(law.build()?, nodes)),
            law: *law,
            tier: None,
        })
    }

    fn round(
        patch: &Patch,
        radius: R,
        law: &Law,
        tier: Option<Tier>,
    ) -> Result<Self, FrictionError> {
        let tier = Tier::choose::<R>(patch, law, tier)?;
        let kernel = match (tier, law.power_of_speed()) {
            (Tier::Exact, Some([coefficient, alpha])) => {
                let coefficient = R::from_f64(coefficient);
                let boxed = PowerLawVisitor {
                    coefficient,
                    radius,
                };
                visit(patch, alpha, tier, boxed)??
            }
            _ => Box::new(AnyFriction::new(patch, law, Some(tier))?.with_radius(radius)?),
        };
        Ok(Self {
            kernel,
            law: *law,
            tier: Some(tier),
        })
    }

    /// The law.
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// The tier that evaluates a round area.
    pub fn tier(&self) -> Option<Tier> {
        self.tier
    }

    /// The wrench on the area, against its twist. *Domain* and *Special values*: those of the kernel.
    #[inline]
    pub fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        self.kernel.wrench(load, twist)
    }

    /// ∂wrench/∂twist, symmetric.
    #[inline]
    pub fn wrench_jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R> {
        self.kernel.jacobian(load, twist)
    }

    /// The wrenches of some twists under one load, to the same bits. Elements beyond the shorter slice are not
    /// changed.
    #[inline]
    pub fn wrench_batch(&self, load: R, twists: &[Twist<R>], wrenches: &mut [Wrench<R>]) {
        self.kernel.wrench_batch(load, twists, wrenches);
    }

    /// Their derivatives.
    #[inline]
    pub fn jacobian_batch(
        &self,
        load: R,
        twists: &[Twist<R>],
        jacobians: &mut [WrenchJacobian<R>],
    ) {
        self.kernel.jacobian_batch(load, twists, jacobians);
    }
}

impl<R: Precision> fmt::Debug for AreaFriction<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AreaFriction")
            .field("law", &self.law)
            .field("tier", &self.tier)
            .finish_non_exhaustive()
    }
}

/// A type of the kernel at a twist.
trait AtTwist<R: Real>: Send + Sync {
    fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R>;
    fn jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R>;

    fn wrench_batch(&self, load: R, twists: &[Twist<R>], wrenches: &mut [Wrench<R>]) {
        for (wrench, twist) in wrenches.iter_mut().zip(twists) {
            *wrench = self.wrench(load, twist);
        }
    }

    fn jacobian_batch(&self, load: R, twists: &[Twist<R>], jacobians: &mut [WrenchJacobian<R>]) {
        for (jacobian, twist) in jacobians.iter_mut().zip(twists) {
            *jacobian = self.jacobian(load, twist);
        }
    }
}

impl<R: Real, C: ReducedFriction<R> + Send + Sync> AtTwist<R> for RoundFriction<R, C> {
    #[inline]
    fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        RoundFriction::wrench(self, load, twist)
    }
    #[inline]
    fn jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R> {
        self.wrench_jacobian(load, twist)
    }
    fn wrench_batch(&self, load: R, twists: &[Twist<R>], wrenches: &mut [Wrench<R>]) {
        RoundFriction::wrench_batch(self, load, twists, wrenches);
    }
    fn jacobian_batch(&self, load: R, twists: &[Twist<R>], jacobians: &mut [WrenchJacobian<R>]) {
        RoundFriction::jacobian_batch(self, load, twists, jacobians);
    }
}

impl<R: Precision> AtTwist<R> for ShapeFriction<R, Flat<R>> {
    #[inline]
    fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        ShapeFriction::wrench(self, load, twist)
    }
    #[inline]
    fn jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R> {
        self.wrench_and_jacobian(load, twist).1
    }
}

impl<R: Real, P: PowerLawPatch<R> + Send + Sync> AtTwist<R> for ShapePowerFriction<R, P> {
    #[inline]
    fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        ShapePowerFriction::wrench(self, load, twist)
    }
    #[inline]
    fn jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R> {
        self.wrench_and_jacobian(load, twist).1
    }
}

impl<R: Real> AtTwist<R> for NodeFriction<AnyLaw<R>, OwnedNodes<R>> {
    #[inline]
    fn wrench(&self, load: R, twist: &Twist<R>) -> Wrench<R> {
        NodeFriction::wrench(self, load, twist)
    }
    #[inline]
    fn jacobian(&self, load: R, twist: &Twist<R>) -> WrenchJacobian<R> {
        self.wrench_jacobian(load, twist)
    }
}

/// A power of the speed on a polygon.
fn of_power<R: Precision>(
    patch: impl PowerLawPatch<R> + Send + Sync + 'static,
    [gamma, alpha]: [f64; 2],
) -> Result<Box<dyn AtTwist<R>>, FrictionError> {
    let power = PolygonPowerLaw::new(R::from_f64(alpha))?;
    let friction = ShapePowerFriction::new(patch, R::from_f64(gamma), power)?;
    Ok(Box::new(friction))
}

/// Puts the kernel's type of a power of the speed on a round patch behind a pointer.
struct PowerLawVisitor<R> {
    coefficient: R,
    radius: R,
}

impl<R: Precision> Visitor<R> for PowerLawVisitor<R> {
    type Output = Result<Box<dyn AtTwist<R>>, FrictionError>;
    fn visit<P: RoundPower<R> + 'static>(self, friction: P) -> Self::Output {
        let made = RoundFriction::new(friction, self.coefficient, self.radius)?;
        Ok(Box::new(made))
    }
}
