//! Limit surfaces of patches by name.

use super::surface_batch::Runs;
use super::text::files;
use super::{Area, Flat, FrictionError, Patch, Precision, SurfaceBatch};
use std::fmt;
use std::path::Path;
use std::sync::OnceLock;
use tribos_core::coupling::{
    Annulus, DryProfile, DryReducedFriction, ReducedFriction, ReducedJacobian, ReducedWrench,
    WornAnnulus, coulomb, coulomb::CoulombDisk,
};
use tribos_core::internals::DominantSpeed;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, RoundLimitSurface, ShapeLimitSurface,
};
use tribos_core::manifold_friction::Lanes;
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodePatch, NodeSlice};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// The limit surfaces of a contact area under dry friction: one for every force limit.
///
/// What takes long, a table of a pressure, is made once.
///
/// *Units*: N, m, N m. *Accuracy*: that of [`Area::limit_surface`], to the bit.
///
/// ```
/// use tribos::friction::{Area, Patch};
/// use tribos::prelude::*;
/// let tile = Area::round(Patch::Paraboloid, 0.04)?.limit_surfaces()?; // m
/// let push = Wrench::new(0.2, 0.0, 0.004); // N, N m
/// let held = |limit: f64| tile.under(limit, |set| set.contains(&push)); // N
/// assert!(!held(0.2)? && held(0.4)?);
/// // The usual approximation has the same largest force and torque.
/// let usual = tile.ellipsoid()?;
/// let spinning = Twist::new(0.0, 0.0, 1.0);
/// let torque = |surfaces: &tribos::friction::LimitSurfaces| surfaces.under(1.0, |set| set.support(&spinning));
/// assert!((torque(&usual)? - torque(&tile)?).abs() < 1e-17);
/// # Ok::<(), tribos::friction::FrictionError>(())
/// ```
#[derive(Debug)]
pub struct LimitSurfaces(Kind);

#[derive(Debug)]
enum Kind {
    Round {
        dry: Box<dyn BoxedDryFriction<f64>>,
        radius: f64,
        /// The patch, and the same as one of any shape once that is asked for.
        patch: Patch,
        flat: OnceLock<Box<Flat<f64>>>,
    },
    Flat(Flat<f64>),
    Ellipsoid {
        radius: f64,
        /// The largest torque per force limit and radius.
        spin_torque: f64,
    },
}

impl LimitSurfaces {
    /// Those of `area`.
    pub(super) fn new(area: &Area) -> Result<Self, FrictionError> {
        Ok(Self(match area {
            Area::Round(patch, radius) => Kind::Round {
                dry: DryRound::new(patch)?.held(),
                radius: *radius,
                patch: patch.clone(),
                flat: OnceLock::new(),
            },
            Area::Flat(flat) => Kind::Flat(flat.clone()),
        }))
    }

    /// What `work` makes of the surface of the force limit μN.
    pub fn under<T>(
        &self,
        force_limit: f64,
        work: impl FnOnce(&dyn FrictionSet<f64>) -> T,
    ) -> Result<T, FrictionError> {
        Ok(work(&*self.boxed(force_limit)?))
    }

    fn boxed(&self, force_limit: f64) -> Result<Box<dyn FrictionSet<f64> + '_>, FrictionError> {
        Ok(match &self.0 {
            Kind::Round { dry, radius, .. } => {
                Box::new(RoundLimitSurface::new(&**dry, force_limit, *radius)?)
            }
            Kind::Flat(flat) => Box::new(ShapeLimitSurface::new(flat, force_limit)?),
            Kind::Ellipsoid {
                radius,
                spin_torque,
            } => Box::new(LimitEllipsoid::new(force_limit, *radius, *spin_torque)?),
        })
    }

    /// The surfaces under many force limits, for batches.
    ///
    /// ```
    /// use tribos::friction::{Area, Patch};
    /// use tribos::prelude::*;
    /// let puck = Area::round(Patch::Disk, 0.04)?.limit_surfaces()?; // m
    /// let mut gauges = [0.0; 2];
    /// puck.under_each(&[0.5, 0.2])?.gauge_batch(&[Wrench::new(0.3, 0.0, 0.0); 2], &mut gauges); // N
    /// assert!(gauges[0] < 1.0 && gauges[1] > 1.0);
    /// # Ok::<(), tribos::friction::FrictionError>(())
    /// ```
    #[doc(hidden)]
    pub fn under_each<'a>(
        &'a self,
        force_limits: &'a [f64],
    ) -> Result<SurfaceBatch<'a>, FrictionError> {
        let (Kind::Round { dry, radius, .. }, [_, _, ..]) = (&self.0, force_limits) else {
            return Ok(SurfaceBatch::of_runs(self.runs(force_limits)?));
        };
        let is_wrong = |limit: &&f64| !(**limit >= 0.0 && limit.is_finite());
        if let Some(wrong) = force_limits.iter().find(is_wrong) {
            RoundLimitSurface::new(&**dry, *wrong, *radius)?;
        }
        let unit = RoundLimitSurface::new(&**dry, 1.0, *radius)?;
        Ok(SurfaceBatch::of_round(unit, force_limits))
    }

    /// A surface for each run of equal force limits, and the number of these.
    #[doc(hidden)]
    pub fn runs(&self, force_limits: &[f64]) -> Result<Runs<'_>, FrictionError> {
        let runs = force_limits.chunk_by(|a, b| a.to_bits() == b.to_bits());
        runs.map(|run| Ok((run.len(), self.boxed(run[0])?)))
            .collect()
    }

    /// The ellipsoids with the same largest force, and the same largest torque about the origin.
    pub fn ellipsoid(&self) -> Result<Self, FrictionError> {
        self.under(1.0, |set| {
            let radius = set.radius();
            let spin_torque = set.support(&Twist::new(0.0, 0.0, 1.0)) / radius;
            Self(Kind::Ellipsoid {
                radius,
                spin_torque,
            })
        })
    }

    /// The lowest and the highest torque about the origin with a force, NaN for a force that is not carried.
    pub fn torque_limits(
        &self,
        force_limit: f64,
        force: [f64; 2],
    ) -> Result<[f64; 2], FrictionError> {
        let flat = match &self.0 {
            Kind::Flat(flat) => flat,
            Kind::Round {
                patch,
                radius,
                flat,
                ..
            } => match flat.get() {
                Some(flat) => flat,
                None => {
                    let made = Area::round(patch.clone(), *radius)?.into_flat()?;
                    flat.get_or_init(|| Box::new(made))
                }
            },
            Kind::Ellipsoid { .. } => {
                return Err(FrictionError::Unserved(
                    "an ellipsoid has no torque limits: ask the exact set".into(),
                ));
            }
        };
        let surface = ShapeLimitSurface::new(flat, force_limit)?;
        Ok(surface.torque_limits(force).unwrap_or([f64::NAN; 2]))
    }
}

/// Dry friction of a round patch: a fitted form where there is one, else a table.
///
/// Contacts copy what they are made of, so that the tables are here and not behind a pointer. All else takes
/// what is made of the one type that the patch needs.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum DryRound<R: Precision> {
    Disk(CoulombDisk),
    Ring(coulomb::CoulombRing),
    Hertz(coulomb::CoulombHertz),
    Punch(coulomb::CoulombPunch),
    Paraboloid(coulomb::CoulombParaboloid),
    Annulus(Annulus<R, CoulombDisk>),
    Worn(WornAnnulus<R>),
    Power(DryProfile<R::Round>),
    Polynomial(R::Polynomial),
}

/// The same work with any of the kernel's types.
macro_rules! each {
    ($round:expr, $dry:ident => $work:expr) => {
        match $round {
            Self::Disk($dry) => $work,
            Self::Ring($dry) => $work,
            Self::Hertz($dry) => $work,
            Self::Punch($dry) => $work,
            Self::Paraboloid($dry) => $work,
            Self::Annulus($dry) => $work,
            Self::Worn($dry) => $work,
            Self::Power($dry) => $work,
            Self::Polynomial($dry) => $work,
        }
    };
}

impl<R: Precision> DryRound<R> {
    pub(super) fn new(patch: &Patch) -> Result<Self, FrictionError> {
        Ok(match patch {
            Patch::Disk => Self::Disk(CoulombDisk),
            Patch::Ring => Self::Ring(coulomb::CoulombRing),
            Patch::Hertz => Self::Hertz(coulomb::CoulombHertz),
            Patch::Punch => Self::Punch(coulomb::CoulombPunch),
            Patch::Paraboloid => Self::Paraboloid(coulomb::CoulombParaboloid),
            Patch::Annulus(inner) => Self::Annulus(Annulus::new(CoulombDisk, R::from_f64(*inner))?),
            Patch::WornAnnulus(inner) => Self::Worn(WornAnnulus::new(R::from_f64(*inner))?),
            Patch::Power(pressure) => Self::Power(DryProfile::new(R::round(R::ZERO, *pressure)?)?),
            Patch::Polynomial(coefficients) => Self::Polynomial(R::dry_polynomial(coefficients)?),
            Patch::Points(_) | Patch::Flat(_) => return Err(FrictionError::NoAxis),
        })
    }

    /// The limit surface of the kernel's own type behind a pointer: one indirect call a question, whatever its
    /// search costs.
    pub(super) fn limit_surface(
        self,
        force_limit: R,
        radius: R,
    ) -> Result<Box<AnySet<R>>, FrictionError> {
        each!(self, dry => boxed(dry, force_limit, radius))
    }

    /// The kernel's own type behind a pointer: no larger than what the patch needs.
    pub(super) fn held(self) -> Box<dyn BoxedDryFriction<R>> {
        each!(self, dry => Box::new(dry))
    }
}

/// A limit surface of any type.
pub(super) type AnySet<R> = dyn FrictionSet<R> + Send + Sync;

fn boxed<R: Real>(
    dry: impl BoxedDryFriction<R> + 'static,
    force_limit: R,
    radius: R,
) -> Result<Box<AnySet<R>>, FrictionError> {
    Ok(Box::new(RoundLimitSurface::new(dry, force_limit, radius)?))
}

impl<R: Precision> ReducedFriction<R> for DryRound<R> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        each!(self, dry => dry.reduced_wrench(slide, rim))
    }
    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        each!(self, dry => dry.reduced_jacobian(slide, rim))
    }
}

impl<R: Precision> DryReducedFriction<R> for DryRound<R> {
    fn reduced_point(&self, lead: DominantSpeed, ratio: R) -> [R; 3] {
        each!(self, dry => dry.reduced_point(lead, ratio))
    }
    fn reduced_points(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratios: R::SideBySide,
    ) -> [R::SideBySide; 3] {
        each!(self, dry => DryReducedFriction::<R>::reduced_points(dry, slides, ratios))
    }
    fn rough_point(&self, lead: DominantSpeed, ratio: R) -> Option<[R; 3]> {
        each!(self, dry => dry.rough_point(lead, ratio))
    }
    fn rough_points(
        &self,
        slides: <R::SideBySide as Lanes>::Mask,
        ratios: R::SideBySide,
    ) -> Option<[R::SideBySide; 3]> {
        each!(self, dry => DryReducedFriction::<R>::rough_points(dry, slides, ratios))
    }
    fn minor_powers(&self, lead: DominantSpeed) -> Option<[R; 6]> {
        each!(self, dry => dry.minor_powers(lead))
    }
    fn is_smooth(&self) -> bool {
        each!(self, dry => DryReducedFriction::<R>::is_smooth(dry))
    }
}

/// Dry friction of a round area of radius 1, behind a pointer.
pub trait BoxedDryFriction<R: Real>: DryReducedFriction<R> + fmt::Debug + Send + Sync {}

impl<R: Real, C: DryReducedFriction<R> + fmt::Debug + Send + Sync> BoxedDryFriction<R> for C {}

/// The points of a file.
#[doc(hidden)]
pub fn points_of(file: &Path) -> Result<Vec<Node<f64>>, FrictionError> {
    let rows = files::numbers(file, &["x", "y", "weight"], MOST_POINTS)?;
    let node = |&[x, y, weight]: &[f64; 3]| Node { x, y, weight };
    Ok(rows.iter().map(node).collect())
}

/// Most points of a file.
const MOST_POINTS: usize = 100_000;

/// Nodes in a list.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct OwnedNodes<R = f64> {
    nodes: Vec<Node<R>>,
    total: R,
}

impl<R: Real> OwnedNodes<R> {
    /// *Domain*: finite places, weights ≥ 0 of which at least one is positive, finite sum.
    pub fn new(nodes: Vec<Node<R>>) -> Result<Self, PatchError> {
        let total = NodeSlice::new(&nodes)?.total_weight();
        Ok(Self { nodes, total })
    }
}

impl<R: Real> OwnedNodes<R> {
    /// Moves the nodes, which keep their weights.
    pub(super) fn change(&mut self, change: impl FnMut(&mut Node<R>)) {
        self.nodes.iter_mut().for_each(change);
    }
}

impl<R: Real> NodePatch<R> for OwnedNodes<R> {
    fn nodes(&self) -> &[Node<R>] {
        &self.nodes
    }
    fn total_weight(&self) -> R {
        self.total
    }
}
