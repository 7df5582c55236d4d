//! Contact areas ready for the kernel: a round patch with its radius, or a shape with its own size.

use super::surface::{BoxedDryFriction, DryRound, LimitSurfaces};
use super::{Flat, FrictionError, OwnedNodes, Patch, Precision, polynomial, surface};
use tribos_core::coupling::flat::PatchShape;
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::PatchError;
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::Node;
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::round::RoundPatch;

/// A contact area: any patch, with its size. Lengths are in m.
///
/// ```
/// use tribos::friction::{Area, Patch};
/// let puck = Area::<f64>::round(Patch::Disk, 0.04)?;
/// let corners = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.2], [0.0, 0.2]];
/// let parcel = Area::polygon(&[&corners], None)?;
/// assert_eq!((puck.radius(), puck.centre()), (0.04, [0.0, 0.0]));
/// assert!((parcel.radius() - 0.15_f64.hypot(0.1)).abs() < 1e-16);
/// assert!(puck.is_round() && !parcel.is_round());
/// let named = Area::named(&"box:0.3x0.2".parse()?, 1.0, Some([0.02, 0.0]))?; // a radius is for round patches
/// assert_eq!(named.centre(), [0.02, 0.0]);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Clone, Debug)]
pub enum Area<R: Precision = f64> {
    /// With an axis: a patch in radii, and its radius.
    Round(Patch, R),
    /// Of any other shape.
    Flat(Flat<R>),
}

impl<R: Precision> Area<R> {
    /// The area of a patch by name, its file read: `radius` is that of a round one, `centre` the centre of
    /// pressure of a box or a polygon.
    pub fn named(
        patch: &Patch,
        radius: R,
        centre: Option<[f64; 2]>,
    ) -> Result<Self, FrictionError> {
        if let Patch::Flat(flat) = patch {
            return Ok(Self::Flat(flat.loaded(centre)?));
        }
        if centre.is_some() {
            let reason = "a centre of pressure is for boxes and polygons";
            return Err(FrictionError::Syntax(reason.into()));
        }
        if let Patch::Points(file) = patch {
            let narrow = |node: Node<f64>| Node {
                x: R::from_f64(node.x),
                y: R::from_f64(node.y),
                weight: R::from_f64(node.weight),
            };
            return Self::points(surface::points_of(file)?.into_iter().map(narrow).collect());
        }
        Self::round(patch.clone(), radius)
    }

    /// A patch with an axis. *Domain*: 0 < `radius` < ∞.
    pub fn round(patch: Patch, radius: R) -> Result<Self, FrictionError> {
        if !patch.has_axis() {
            return Err(FrictionError::NoAxis);
        }
        if let Patch::WornAnnulus(_) = &patch {
            let made = RoundPatch::new(DryRound::new(&patch)?, [R::ZERO; 2], radius)?;
            return Ok(Self::Flat(Flat::Round(Box::new(made))));
        }
        if let Patch::Polynomial(coefficients) = &patch {
            // Refuses what is negative anywhere.
            polynomial(coefficients)?;
        }
        if !(radius > R::ZERO && radius.is_finite()) {
            let given = radius.to_f64();
            return Err(tribos_core::Error::from(PatchError::Radius { given }).into());
        }
        Ok(Self::Round(patch, radius))
    }

    /// A polygon, its outer loop first, then its holes; with a centre of pressure under linear pressure.
    pub fn polygon(loops: &[&[[R; 2]]], centre: Option<[R; 2]>) -> Result<Self, FrictionError> {
        let made = Flat::polygon(loops, centre).map_err(tribos_core::Error::from)?;
        Ok(Self::Flat(made))
    }

    /// A line that carries its load evenly.
    pub fn bar(start: [R; 2], end: [R; 2]) -> Result<Self, FrictionError> {
        let bar = Bar::new(start, end).map_err(tribos_core::Error::from)?;
        Ok(Self::Flat(Flat::Bar(bar)))
    }

    /// Triangles that name their corners among `vertices`, each under linear pressure.
    pub fn mesh(vertices: &[Vertex<R>], triangles: &[[usize; 3]]) -> Result<Self, FrictionError> {
        let memory = vec![Triangle::default(); triangles.len()];
        let mesh = Mesh::with_vertices(vertices, triangles, memory);
        Ok(Self::Flat(Flat::Mesh(
            mesh.map_err(tribos_core::Error::from)?,
        )))
    }

    /// Points with weights of which only the ratios count.
    pub fn points(nodes: Vec<Node<R>>) -> Result<Self, FrictionError> {
        let points = OwnedNodes::new(nodes).and_then(PointPatch::new);
        let points = points.map_err(tribos_core::Error::from)?;
        Ok(Self::Flat(Flat::Points(points)))
    }

    /// The area under friction that differs along two axes, with the larger coefficient as that of its friction.
    pub fn with_axes(self, friction: AxisCoefficients<R>) -> Result<Self, FrictionError> {
        let made = AnisotropicPatch::new(self.into_flat()?, friction)?;
        Ok(Self::Flat(Flat::Anisotropic(Box::new(made))))
    }

    /// The area as one of any shape.
    #[doc(hidden)]
    pub fn into_flat(self) -> Result<Flat<R>, FrictionError> {
        match self {
            Self::Flat(flat) => Ok(flat),
            Self::Round(patch, radius) => {
                let made = RoundPatch::new(DryRound::new(&patch)?, [R::ZERO; 2], radius)?;
                Ok(Flat::Round(Box::new(made)))
            }
        }
    }

    /// Whether the friction is the same in all directions.
    pub fn is_round(&self) -> bool {
        matches!(self, Self::Round(..))
    }

    /// Distance of the farthest point from the centre of pressure.
    pub fn radius(&self) -> R {
        match self {
            Self::Round(_, radius) => *radius,
            Self::Flat(flat) => flat.radius(),
        }
    }

    /// The centre of pressure, in the coordinates that twist and wrench refer to.
    pub fn centre(&self) -> [R; 2] {
        match self {
            Self::Round(..) => [R::ZERO; 2],
            Self::Flat(flat) => flat.centre().into(),
        }
    }

    /// All wrenches that dry friction carries on it, exact to rounding, under the force limit μN, in N.
    ///
    /// The set of points has flat facets, whose normal is the rotation about a point.
    ///
    /// ```
    /// use tribos::friction::Area;
    /// use tribos::prelude::*;
    /// let table = Area::named(&"box:0.2x0.1".parse()?, 1.0, None)?.limit_surface(2.0)?; // N, m
    /// let motion = table.twist_normal_to(&Wrench::new(0.0, 2.0, 0.08)); // N, N, N m
    /// assert!(motion.velocity.y > 0.0 && motion.spin > 0.0);
    /// let puck = Area::named(&Patch::Disk, 0.04, None)?.limit_surface(0.5)?;
    /// assert!((puck.gauge(&Wrench::new(0.0, 0.0, 0.5 * 0.04 * 2.0 / 3.0)) - 1.0).abs() < 1e-14);
    /// # Ok::<(), tribos::friction::FrictionError>(())
    /// ```
    pub fn limit_surface(
        &self,
        force_limit: R,
    ) -> Result<Box<dyn FrictionSet<R> + Send + Sync>, FrictionError> {
        Ok(match self {
            Self::Flat(flat) => Box::new(ShapeLimitSurface::new(flat.clone(), force_limit)?),
            Self::Round(patch, radius) => {
                DryRound::new(patch)?.limit_surface(force_limit, *radius)?
            }
        })
    }

    /// Dry friction of a round area, in units of its radius.
    #[doc(hidden)]
    pub fn dry(&self) -> Result<Box<dyn BoxedDryFriction<R>>, FrictionError> {
        match self {
            Self::Flat(_) => Err(FrictionError::NoAxis),
            Self::Round(patch, _) => Ok(DryRound::new(patch)?.held()),
        }
    }
}

impl Area {
    /// Its limit surfaces under dry friction, for every force limit.
    pub fn limit_surfaces(&self) -> Result<LimitSurfaces, FrictionError> {
        LimitSurfaces::new(self)
    }
}
