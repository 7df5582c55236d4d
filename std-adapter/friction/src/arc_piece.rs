//! Pieces of disks and ellipses that straight borders cut.

use super::FrictionError;
use super::Precision;
use super::flat::Flat;
use tribos_core::coupling::flat::{Hessian, Motion, PatchShape, Reduced};
use tribos_core::patch::arcs::{ArcOutline, Side};
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::outline::OutlineError;
use tribos_core::patch::piece::{HalfPlane, PatchPiece};
use tribos_core::real::Real;

/// What of an ellipse under uniform pressure lies within a convex cell.
#[derive(Clone, Debug)]
pub struct ArcPiece<R: Real> {
    ellipse: Ellipse<R>,
    /// Corners, counterclockwise.
    cell: Vec<[R; 2]>,
    outline: ArcOutline<R, Vec<Side<R>>>,
}

impl<R: Precision> ArcPiece<R> {
    /// What of a whole ellipse lies within a half-plane, with its share of the load; the ellipse itself if all of it does.
    pub(super) fn of_ellipse(
        ellipse: &Ellipse<R>,
        side: &HalfPlane<R>,
    ) -> Result<Option<PatchPiece<R, Flat<R>>>, FrictionError> {
        let centre = ellipse.centre();
        let distance = side.distance_of([centre.x, centre.y]);
        let [a, b] = ellipse.semi_axes();
        // Half of its width across the border.
        let major = ellipse.major_axis();
        let along = side.distance_of([centre.x + major.x, centre.y + major.y]) - distance;
        let across = side.distance_of([centre.x - major.y, centre.y + major.x]) - distance;
        let reach = (along * a).hypot(across * b);
        if distance >= reach {
            let patch = Flat::Ellipse(*ellipse);
            let share = R::ONE;
            return Ok(Some(PatchPiece { patch, share }));
        }
        if distance <= -reach {
            return Ok(None);
        }
        if ellipse.pressure() != EllipsePressure::Uniform {
            return Err(FrictionError::Unserved(
                "a border runs through a round patch whose pressure is not uniform: give the patch as a mesh of triangles"
                    .into(),
            ));
        }
        let far = a + a;
        let corners = [[-far, -far], [far, -far], [far, far], [-far, far]];
        let cell = corners.map(|[x, y]| [centre.x + x, centre.y + y]);
        let area = R::from_f64(std::f64::consts::PI) * a * b;
        Self::cut(ellipse, &cell, side, area)
    }

    /// What of the piece lies within a half-plane, with its share of the piece's load.
    pub(super) fn within(
        &self,
        side: &HalfPlane<R>,
    ) -> Result<Option<PatchPiece<R, Flat<R>>>, FrictionError> {
        Self::cut(&self.ellipse, &self.cell, side, self.outline.area())
    }

    /// The part of a cell's piece, of this area, within a half-plane.
    fn cut(
        ellipse: &Ellipse<R>,
        cell: &[[R; 2]],
        side: &HalfPlane<R>,
        whole: R,
    ) -> Result<Option<PatchPiece<R, Flat<R>>>, FrictionError> {
        let cell = clipped(cell, side);
        if cell.len() < 3 {
            return Ok(None);
        }
        let memory = vec![Side::default(); 2 * cell.len() + 3];
        let outline = match ArcOutline::cut(ellipse, &cell, memory) {
            Ok(outline) => outline,
            // Nothing is left of it.
            Err(OutlineError::Flat { .. }) => return Ok(None),
            Err(error) => return Err(tribos_core::Error::from(error).into()),
        };
        let share = outline.area() / whole;
        let ellipse = *ellipse;
        let patch = Flat::ArcPiece(Box::new(Self {
            ellipse,
            cell,
            outline,
        }));
        Ok(Some(PatchPiece { patch, share }))
    }
}

/// The part of a convex polygon within a half-plane.
fn clipped<R: Real>(cell: &[[R; 2]], side: &HalfPlane<R>) -> Vec<[R; 2]> {
    let mut kept = Vec::with_capacity(cell.len() + 1);
    for (index, from) in cell.iter().enumerate() {
        let to = &cell[(index + 1) % cell.len()];
        if side.contains(*from) {
            kept.push(*from);
        }
        if let Some(at) = side.crossing([*from, *to]) {
            kept.push([0, 1].map(|i| from[i] + (to[i] - from[i]) * at));
        }
    }
    kept
}

impl<R: Real> PatchShape<R> for ArcPiece<R> {
    fn centre(&self) -> nalgebra::Vector2<R> {
        self.outline.centre()
    }
    fn radius(&self) -> R {
        self.outline.radius()
    }
    fn rounding(&self) -> R {
        self.outline.rounding()
    }
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        self.outline.reduced(motion)
    }
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        self.outline.reduced_with_hessian(motion)
    }
}
