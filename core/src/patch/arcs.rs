//! Patches bounded by straight lines and arcs of circles or ellipses, under uniform pressure.

use super::arcs_maker::Maker;
use super::edge::Edge;
use super::ellipse::Ellipse;
use super::outline_error::OutlineError;
use crate::real::Real;
use crate::special::legendre::each_node;
use nalgebra::Vector2;

/// A part of a boundary. The patch lies to its left.
///
/// *Units*: length, and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Border<R> {
    /// A straight line.
    Line {
        /// Where it begins.
        from: [R; 2],
        /// Where it ends.
        to: [R; 2],
    },
    /// The arc `centre` + p cos φ + q sin φ.
    Arc {
        /// The centre of its circle or ellipse.
        centre: [R; 2],
        /// p and q: for a circle two radii that are at right angles.
        half_diameters: [[R; 2]; 2],
        /// φ at its beginning.
        from: R,
        /// φ at its end, at most a whole turn away; smaller than `from` for an arc that runs backwards.
        to: R,
    },
}

/// A part of a boundary as [`ArcOutline`] keeps it: a line, or an arc of at most a third of a turn.
///
/// Lengths are in units of the patch's radius, about its centre. A default side is room for one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side<R: Real>(pub(crate) SideCourse<R>);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SideCourse<R: Real> {
    Straight(Edge<R>),
    Curved(Arc<R>),
}

impl<R: Real> Side<R> {
    /// Whether it is curved.
    #[cfg(feature = "defmt")]
    pub(crate) fn is_arc(&self) -> bool {
        matches!(self.0, SideCourse::Curved(_))
    }
}

impl<R: Real> Default for Side<R> {
    fn default() -> Self {
        Self(SideCourse::Straight(Edge::default()))
    }
}

/// The arc middle + p cos ψ + q sin ψ for |tan(ψ/2)| ≤ reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Arc<R: Real> {
    pub(crate) middle: Vector2<R>,
    pub(crate) half_diameters: [Vector2<R>; 2],
    pub(crate) reach: R,
}

/// A patch bounded by lines and arcs, under uniform pressure.
///
/// The storage `S` holds the sides: an array, or memory of the caller.
///
/// *Units*: length. *Accuracy* of its friction, of μN and μN R about the centre: 1e-14 (f32: 4e-6) for any motion; the
/// Jacobian 1e-13 (f32: 2e-5) of its largest entry, next to the centre of rotation half of
/// those digits of its distance from the boundary; for pieces up to 10 times as long as wide. *Cost*: a line is an edge of a
/// polygon; an arc of up to a third of a turn takes 16 roots and 48 divisions, about 5 boxes, with the
/// centre of rotation within its own size of it two to four times that, and next to it up to 15 times.
///
/// ```
/// use tribos_core::coupling::flat::ShapeFriction;
/// use tribos_core::patch::arcs::{ArcOutline, Border, Side};
/// use tribos_core::twist::Twist;
/// let (zero, radius) = (0.0_f64, 0.1); // m
/// let arc = Border::Arc {
///     centre: [zero; 2],
///     half_diameters: [[radius, zero], [zero, radius]],
///     from: zero,
///     to: core::f64::consts::PI,
/// };
/// let line = Border::Line { from: [-radius, zero], to: [radius, zero] };
/// let half_disk = ArcOutline::new(&[arc, line], [Side::default(); 3])?;
/// assert!((half_disk.centre().y - 4.0 * radius / (3.0 * core::f64::consts::PI)).abs() < 1e-16);
/// let pivoting = ShapeFriction::new(half_disk, 0.5)?.wrench(10.0, &Twist::new(0.0, 0.0, 1.0)); // N; rad/s
/// assert!((pivoting.torque + 0.5 * 10.0 * radius * 2.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcOutline<R: Real, S> {
    pub(super) sides: S,
    pub(super) count: usize,
    pub(super) centre: Vector2<R>,
    pub(super) radius: R,
    /// Area in units of radius².
    pub(super) reduced_area: R,
    /// Length of the boundary in radii.
    pub(super) boundary: R,
}

impl<R: Real, S: AsRef<[Side<R>]> + AsMut<[Side<R>]>> ArcOutline<R, S> {
    /// The patch to the left of these borders, which form closed loops that do not cross; `memory` has room for a side
    /// a line and up to three an arc, one for each third of a turn.
    ///
    /// *Domain*: finite borders; ends that meet; an area that is not lost in rounding. That borders do not cross is for
    /// the caller to see to.
    pub fn new(borders: &[Border<R>], memory: S) -> Result<Self, OutlineError> {
        let mut made = Maker::new(memory);
        for (corner, border) in borders.iter().enumerate() {
            made.add(corner, border)?;
        }
        made.finished()
    }

    /// The part of an ellipse within a convex polygon whose corners run counterclockwise, under uniform pressure
    /// whatever that of the ellipse; `memory` has room for two sides a corner and three more.
    ///
    /// *Domain*: finite corners; a common area that is not lost in rounding.
    ///
    /// ```
    /// use tribos_core::patch::arcs::{ArcOutline, Side};
    /// use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
    /// let foot = Ellipse::new([0.0_f64, 0.0], [0.1, 0.05], EllipsePressure::Uniform)?; // m
    /// let left_of_a_joint = [[-1.0, -1.0], [0.0, -1.0], [0.0, 1.0], [-1.0, 1.0]];
    /// let half = ArcOutline::cut(&foot, &left_of_a_joint, [Side::default(); 8])?;
    /// assert!((half.area() - core::f64::consts::PI * 0.1 * 0.05 / 2.0).abs() < 1e-16);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn cut(ellipse: &Ellipse<R>, corners: &[[R; 2]], memory: S) -> Result<Self, OutlineError> {
        let mut made = Maker::new(memory);
        super::arcs_cut::cut(&mut made, ellipse, corners)?;
        made.finished()
    }
}

impl<R: Real, S: AsRef<[Side<R>]>> ArcOutline<R, S> {
    /// The sides.
    pub fn sides(&self) -> &[Side<R>] {
        self.sides.as_ref().get(..self.count).unwrap_or_default()
    }

    /// The centre of pressure.
    pub fn centre(&self) -> Vector2<R> {
        self.centre
    }

    /// Distance of the farthest point from the centre, to a part in a thousand.
    pub fn radius(&self) -> R {
        self.radius
    }

    /// The area.
    pub fn area(&self) -> R {
        self.reduced_area * self.radius * self.radius
    }

    #[inline(always)]
    pub(crate) fn reduced_area(&self) -> R {
        self.reduced_area
    }

    #[inline(always)]
    pub(crate) fn boundary(&self) -> R {
        self.boundary
    }
}

impl<R: Real> Arc<R> {
    /// The point at z = tan(ψ/2).
    #[inline(always)]
    pub(crate) fn point(&self, z: R) -> Vector2<R> {
        let [p, q] = &self.half_diameters;
        let share = R::ONE / (R::ONE + z * z);
        let (cos, sin) = ((R::ONE - z) * (R::ONE + z) * share, R::TWO * z * share);
        self.middle + p * cos + q * sin
    }

    /// The point and its derivative by z.
    #[inline(always)]
    pub(crate) fn point_and_slope(&self, z: R) -> [Vector2<R>; 2] {
        let [p, q] = &self.half_diameters;
        let share = R::ONE / (R::ONE + z * z);
        let (cos, sin) = ((R::ONE - z) * (R::ONE + z) * share, R::TWO * z * share);
        let rate = R::TWO * share;
        [
            self.middle + p * cos + q * sin,
            q * (cos * rate) - p * (sin * rate),
        ]
    }

    pub(super) fn length(&self) -> R {
        let mut length = R::ZERO;
        each_node(|node: R, weight| {
            let [_, slope] = self.point_and_slope(self.reach * node);
            length += weight * slope.x.hypot(slope.y);
        });
        length * self.reach
    }
}

/// Places on an arc among which the farthest one is looked for: the error is (1/2) (π/96)² of the radius.
const PLACES: u32 = 64;

impl<R: Real> Side<R> {
    pub(super) fn ends(&self) -> [Vector2<R>; 2] {
        match &self.0 {
            SideCourse::Straight(edge) => [edge.start(), edge.end()],
            SideCourse::Curved(arc) => [-arc.reach, arc.reach].map(|z| arc.point(z)),
        }
    }

    /// Points of Gauss' rule and what they count: lines of up to third degree are exact.
    pub(super) fn each_step(&self, mut visit: impl FnMut(Vector2<R>, Vector2<R>)) {
        each_node(|node: R, weight| {
            let [at, step] = match &self.0 {
                SideCourse::Straight(edge) => {
                    let [from, to] = [edge.start(), edge.end()];
                    let half = (to - from) * R::HALF;
                    [from + half * (R::ONE + node), half]
                }
                SideCourse::Curved(arc) => {
                    let [at, slope] = arc.point_and_slope(arc.reach * node);
                    [at, slope * arc.reach]
                }
            };
            visit(at, step * weight);
        });
    }

    pub(super) fn farthest(&self, from: &Vector2<R>) -> R {
        let distance = |at: Vector2<R>| (at.x - from.x).hypot(at.y - from.y);
        let mut far = R::ZERO;
        let mut keep = |at| {
            let here = distance(at);
            if here > far {
                far = here;
            }
        };
        match &self.0 {
            SideCourse::Straight(edge) => [edge.start(), edge.end()].into_iter().for_each(keep),
            SideCourse::Curved(arc) => {
                for place in 0..=PLACES {
                    let part = f64::from(place) / f64::from(PLACES);
                    keep(arc.point(arc.reach * R::from_f64(2.0 * part - 1.0)));
                }
            }
        }
        far
    }

    pub(super) fn about(&self, centre: &Vector2<R>, radius: R) -> Self {
        Self(match &self.0 {
            SideCourse::Straight(edge) => SideCourse::Straight(edge.about(centre, radius)),
            SideCourse::Curved(arc) => SideCourse::Curved(Arc {
                middle: (arc.middle - centre) / radius,
                half_diameters: arc.half_diameters.map(|half| half / radius),
                reach: arc.reach,
            }),
        })
    }
}
