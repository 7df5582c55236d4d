//! A boundary of lines and arcs that is being put together.

use super::arcs::{Arc, ArcOutline, Border, Side, SideCourse};
use super::edge::Edge;
use super::outline_error::OutlineError;
use crate::real::Real;
use nalgebra::Vector2;

/// Rounding errors by which ends of borders may miss each other, of the largest distance.
const OPEN_ULPS: f64 = 64.0;
/// Rounding errors of the boundary squared that are no area.
const FLAT_ULPS: f64 = 64.0;
/// Longest arc of a side: a third of a turn, and some rounding errors.
const LONGEST_ARC: f64 = 2.0944;
/// Sides of the longest arc.
const MOST_PARTS: u32 = 4;

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
    pub(super) fn new(memory: S) -> Self {
        Self {
            memory,
            count: 0,
            origin: None,
            apart: Vector2::new(R::ZERO, R::ZERO),
            boundary: R::ZERO,
        }
    }

    pub(super) fn add(&mut self, corner: usize, border: &Border<R>) -> Result<(), OutlineError> {
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
        self.push(SideCourse::Straight(Edge::new(from - origin, to - origin)))
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
        self.push(SideCourse::Curved(arc))
    }

    fn push(&mut self, course: SideCourse<R>) -> Result<(), OutlineError> {
        let side = Side(course);
        let [from, to] = side.ends();
        self.apart += to - from;
        let chord = (to.x - from.x).hypot(to.y - from.y);
        self.boundary += match course {
            SideCourse::Straight(_) => chord,
            SideCourse::Curved(arc) => arc.length(),
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

    pub(super) fn finished(mut self) -> Result<ArcOutline<R, S>, OutlineError> {
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
