//! Patches bounded by straight lines and arcs of circles or ellipses, under uniform pressure.

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
pub struct Side<R: Real>(pub(crate) Course<R>);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course<R: Real> {
    Straight(Edge<R>),
    Curved(Arc<R>),
}

impl<R: Real> Default for Side<R> {
    fn default() -> Self {
        Self(Course::Straight(Edge::default()))
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
    sides: S,
    count: usize,
    centre: Vector2<R>,
    radius: R,
    /// Area in units of radius².
    reduced_area: R,
    /// Length of the boundary in radii.
    boundary: R,
}

/// Rounding errors by which ends of borders may miss each other, of the largest distance.
const OPEN_ULPS: f64 = 64.0;
/// Rounding errors of the boundary squared that are no area.
const FLAT_ULPS: f64 = 64.0;
/// Longest arc of a side: a third of a turn, and some rounding errors.
const LONGEST_ARC: f64 = 2.0944;
/// Sides of the longest arc.
const MOST_PARTS: u32 = 4;

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

/// Sides that are being put together, about the first point of them.
pub(super) struct Maker<R: Real, S> {
    memory: S,
    count: usize,
    origin: Option<Vector2<R>>,
    /// Sum of end − start, and of the lengths.
    apart: Vector2<R>,
    boundary: R,
}

impl<R: Real, S: AsRef<[Side<R>]> + AsMut<[Side<R>]>> Maker<R, S> {
    fn new(memory: S) -> Self {
        Self {
            memory,
            count: 0,
            origin: None,
            apart: Vector2::new(R::ZERO, R::ZERO),
            boundary: R::ZERO,
        }
    }

    fn add(&mut self, corner: usize, border: &Border<R>) -> Result<(), OutlineError> {
        let in_loop = 0;
        let is_finite = |numbers: &[R]| numbers.iter().all(|number| number.is_finite());
        match *border {
            Border::Line { from, to } => {
                if !(is_finite(&from) && is_finite(&to)) {
                    return Err(OutlineError::Position { in_loop, corner });
                }
                if from == to {
                    return Err(OutlineError::Repeated { in_loop, corner });
                }
                self.line(Vector2::from(from), Vector2::from(to))
            }
            Border::Arc {
                centre,
                half_diameters: [p, q],
                from,
                to,
            } => {
                let is_known =
                    is_finite(&centre) && is_finite(&p) && is_finite(&q) && is_finite(&[from, to]);
                if !is_known
                    || (to - from).abs() > R::from_f64(LONGEST_ARC * f64::from(MOST_PARTS - 1))
                {
                    return Err(OutlineError::Position { in_loop, corner });
                }
                if from == to {
                    return Err(OutlineError::Repeated { in_loop, corner });
                }
                let half_diameters = [p, q].map(Vector2::from);
                self.arc(Vector2::from(centre), half_diameters, [from, to])
            }
        }
    }

    pub(super) fn line(&mut self, from: Vector2<R>, to: Vector2<R>) -> Result<(), OutlineError> {
        let origin = *self.origin.get_or_insert(from);
        self.push(Course::Straight(Edge::new(from - origin, to - origin)))
    }

    /// An arc in parts of a third of a turn.
    pub(super) fn arc(
        &mut self,
        centre: Vector2<R>,
        [p, q]: [Vector2<R>; 2],
        [from, to]: [R; 2],
    ) -> Result<(), OutlineError> {
        let turn = to - from;
        let mut parts = 1;
        while parts < MOST_PARTS && turn.abs() > R::from_f64(LONGEST_ARC * f64::from(parts)) {
            parts += 1;
        }
        let step = turn / R::from_f64(f64::from(parts));
        let half = R::HALF * R::HALF * step.abs();
        let reach = half.sin() / half.cos();
        for part in 0..parts {
            let angle = from + step * (R::from_f64(f64::from(part)) + R::HALF);
            let (cos, sin) = (angle.cos(), angle.sin());
            let across = (q * cos - p * sin) * R::ONE.copysign(step);
            let half_diameters = [p * cos + q * sin, across];
            self.half_arc(centre, half_diameters, reach)?;
        }
        Ok(())
    }

    /// The arc about its first half-diameter, by the tangent of a quarter of its angle.
    pub(super) fn half_arc(
        &mut self,
        centre: Vector2<R>,
        half_diameters: [Vector2<R>; 2],
        reach: R,
    ) -> Result<(), OutlineError> {
        let mut arc = Arc {
            middle: centre,
            half_diameters,
            reach,
        };
        let origin = *self.origin.get_or_insert(arc.point(-reach));
        arc.middle = centre - origin;
        self.push(Course::Curved(arc))
    }

    fn push(&mut self, course: Course<R>) -> Result<(), OutlineError> {
        let side = Side(course);
        let [from, to] = side.ends();
        self.apart += to - from;
        let chord = (to.x - from.x).hypot(to.y - from.y);
        self.boundary += match course {
            Course::Straight(_) => chord,
            Course::Curved(arc) => arc.length(),
        };
        let room = self.memory.as_ref().len();
        match self.memory.as_mut().get_mut(self.count) {
            Some(slot) => *slot = side,
            None => {
                return Err(OutlineError::Room {
                    given: self.count.saturating_add(1),
                    room,
                });
            }
        }
        self.count = self.count.saturating_add(1);
        Ok(())
    }

    fn finished(mut self) -> Result<ArcOutline<R, S>, OutlineError> {
        let in_loop = 0;
        let Some(origin) = self.origin else {
            let given = 0;
            return Err(OutlineError::Corners { in_loop, given });
        };
        if !self.boundary.is_finite() {
            return Err(OutlineError::Extent);
        }
        let gap = self.apart.x.abs() + self.apart.y.abs();
        if gap > R::from_f64(OPEN_ULPS) * R::EPSILON * self.boundary {
            return Err(OutlineError::Open);
        }
        // Area and centroid, in units of the boundary.
        let unit = self.boundary;
        let sides = self
            .memory
            .as_mut()
            .get_mut(..self.count)
            .unwrap_or_default();
        let mut area = R::ZERO;
        let mut first = Vector2::new(R::ZERO, R::ZERO);
        for side in sides.iter() {
            side.each_step(|at, step| {
                let (at, step) = (at / unit, step / unit);
                let swept = R::HALF * (at.x * step.y - at.y * step.x);
                area += swept;
                first += at * (swept * R::from_f64(2.0 / 3.0));
            });
        }
        let is_area = area > R::from_f64(FLAT_ULPS) * R::EPSILON;
        if !is_area {
            return Err(OutlineError::Flat { in_loop });
        }
        let centroid = first * (unit / area);
        let mut radius = R::ZERO;
        for side in sides.iter() {
            let far = side.farthest(&centroid);
            if far > radius {
                radius = far;
            }
        }
        for side in sides.iter_mut() {
            *side = side.about(&centroid, radius);
        }
        let centre = origin + centroid;
        if !(centre.x + centre.y + radius).is_finite() {
            return Err(OutlineError::Extent);
        }
        let scale = unit / radius;
        Ok(ArcOutline {
            sides: self.memory,
            count: self.count,
            centre,
            radius,
            reduced_area: area * scale * scale,
            boundary: scale,
        })
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

    fn length(&self) -> R {
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
    fn ends(&self) -> [Vector2<R>; 2] {
        match &self.0 {
            Course::Straight(edge) => [edge.start(), edge.end()],
            Course::Curved(arc) => [-arc.reach, arc.reach].map(|z| arc.point(z)),
        }
    }

    /// Points of Gauss' rule and what they count: lines of up to third degree are exact.
    fn each_step(&self, mut visit: impl FnMut(Vector2<R>, Vector2<R>)) {
        each_node(|node: R, weight| {
            let [at, step] = match &self.0 {
                Course::Straight(edge) => {
                    let [from, to] = [edge.start(), edge.end()];
                    let half = (to - from) * R::HALF;
                    [from + half * (R::ONE + node), half]
                }
                Course::Curved(arc) => {
                    let [at, slope] = arc.point_and_slope(arc.reach * node);
                    [at, slope * arc.reach]
                }
            };
            visit(at, step * weight);
        });
    }

    fn farthest(&self, from: &Vector2<R>) -> R {
        let distance = |at: Vector2<R>| (at.x - from.x).hypot(at.y - from.y);
        let mut far = R::ZERO;
        let mut keep = |at| {
            let here = distance(at);
            if here > far {
                far = here;
            }
        };
        match &self.0 {
            Course::Straight(edge) => [edge.start(), edge.end()].into_iter().for_each(keep),
            Course::Curved(arc) => {
                for place in 0..=PLACES {
                    let part = f64::from(place) / f64::from(PLACES);
                    keep(arc.point(arc.reach * R::from_f64(2.0 * part - 1.0)));
                }
            }
        }
        far
    }

    fn about(&self, centre: &Vector2<R>, radius: R) -> Self {
        Self(match &self.0 {
            Course::Straight(edge) => Course::Straight(edge.about(centre, radius)),
            Course::Curved(arc) => Course::Curved(Arc {
                middle: (arc.middle - centre) / radius,
                half_diameters: arc.half_diameters.map(|half| half / radius),
                reach: arc.reach,
            }),
        })
    }
}
