//! Whether loops of corners bound a patch: no edge touches another one, holes lie inside.

use super::outline_error::OutlineError;
use crate::real::Real;
use nalgebra::Vector2;

/// Corners of a loop.
pub(super) type Corners<'a, R> = &'a [[R; 2]];

/// The loops of an outline, the outer one first.
pub(super) trait OutlineLoops<'a, R: 'a>: Iterator<Item = Corners<'a, R>> + Clone {}

impl<'a, R: 'a, L: Iterator<Item = Corners<'a, R>> + Clone> OutlineLoops<'a, R> for L {}

/// All sides of a loop, the last one back to the first corner.
pub(super) fn sides<R>(corners: &[[R; 2]]) -> impl Iterator<Item = [&[R; 2]; 2]> + Clone {
    let next = corners.iter().skip(1).chain(corners.first());
    corners.iter().zip(next).map(|(from, to)| [from, to])
}

/// Where the loops lie: their first corner, and the largest distance along an axis from there.
pub(super) struct OutlineExtent<R: Real> {
    pub(super) origin: Vector2<R>,
    pub(super) unit: R,
}

impl<R: Real> OutlineExtent<R> {
    /// A corner in these units.
    pub(super) fn at(&self, [x, y]: &[R; 2]) -> Vector2<R> {
        let Self { origin, unit } = self;
        Vector2::new((*x - origin.x) / *unit, (*y - origin.y) / *unit)
    }

    /// The scale of loops with finite corners.
    fn of<'a>(loops: impl OutlineLoops<'a, R>) -> Result<Self, OutlineError> {
        let mut corners = loops.flat_map(|corners| corners.iter());
        let [x, y] = corners.clone().next().copied().unwrap_or_default();
        let origin = Vector2::new(x, y);
        let mut unit = R::ZERO;
        for [x, y] in &mut corners {
            for distance in [(*x - origin.x).abs(), (*y - origin.y).abs()] {
                if distance > unit {
                    unit = distance;
                }
            }
        }
        if unit.is_finite() {
            Ok(Self { origin, unit })
        } else {
            Err(OutlineError::Extent)
        }
    }
}

/// The scale of loops that bound a patch.
pub(super) fn checked<'a, R: Real>(
    loops: impl OutlineLoops<'a, R>,
) -> Result<OutlineExtent<R>, OutlineError> {
    if loops.clone().next().is_none() {
        let (in_loop, given) = (0, 0);
        return Err(OutlineError::Corners { in_loop, given });
    }
    for (in_loop, corners) in loops.clone().enumerate() {
        check_corners(in_loop, corners)?;
    }
    let scale = OutlineExtent::of(loops.clone())?;
    for (first, one) in loops.clone().enumerate() {
        check_folds(first, one, &scale)?;
        for (second, other) in loops.clone().enumerate().skip(first) {
            check_crossings([first, second], [one, other], &scale)?;
        }
    }
    check_holes(loops, &scale)?;
    Ok(scale)
}

/// Enough finite corners, of which no neighbours coincide.
fn check_corners<R: Real>(in_loop: usize, corners: &[[R; 2]]) -> Result<(), OutlineError> {
    let given = corners.len();
    if given < 3 {
        return Err(OutlineError::Corners { in_loop, given });
    }
    for (corner, [from, to]) in sides(corners).enumerate() {
        if !from.iter().all(|part| part.is_finite()) {
            return Err(OutlineError::Position { in_loop, corner });
        }
        if from == to {
            return Err(OutlineError::Repeated { in_loop, corner });
        }
    }
    Ok(())
}

/// No edge goes back along the one before.
fn check_folds<R: Real>(
    in_loop: usize,
    corners: &[[R; 2]],
    scale: &OutlineExtent<R>,
) -> Result<(), OutlineError> {
    let after = sides(corners).skip(1).chain(sides(corners).take(1));
    for (edge, (one, other)) in sides(corners).zip(after).enumerate() {
        let [a, b] = one.map(|corner| scale.at(corner));
        let [_, c] = other.map(|corner| scale.at(corner));
        let (before, next) = (b - a, c - b);
        if side_of(&a, &b, &c) == Side::On && before.x * next.x + before.y * next.y < R::ZERO {
            let next = edge + 1;
            let next = if next < corners.len() { next } else { 0 };
            let edges = [[in_loop, edge], [in_loop, next]];
            return Err(OutlineError::Crossing { edges });
        }
    }
    Ok(())
}

/// No edge of one loop meets an edge of the other; in one loop, but its neighbours.
fn check_crossings<R: Real>(
    [first, second]: [usize; 2],
    [one, other]: [Corners<'_, R>; 2],
    scale: &OutlineExtent<R>,
) -> Result<(), OutlineError> {
    let last = one.len().saturating_sub(1);
    for (i, a) in sides(one).enumerate() {
        for (j, b) in sides(other).enumerate() {
            let are_neighbours = i.abs_diff(j) <= 1 || i.abs_diff(j) == last;
            if first == second && (j <= i || are_neighbours) {
                continue;
            }
            if segments_intersect(a.map(|end| scale.at(end)), b.map(|end| scale.at(end))) {
                let edges = [[first, i], [second, j]];
                return Err(OutlineError::Crossing { edges });
            }
        }
    }
    Ok(())
}

/// Every loop but the first lies inside of it and outside of the others.
fn check_holes<'a, R: Real>(
    loops: impl OutlineLoops<'a, R>,
    scale: &OutlineExtent<R>,
) -> Result<(), OutlineError> {
    for (in_loop, hole) in loops.clone().enumerate().skip(1) {
        for corner in hole.iter().take(1) {
            for (index, around) in loops.clone().enumerate() {
                if index != in_loop && contains(around, corner, scale) != (index == 0) {
                    return Err(OutlineError::Hole { in_loop });
                }
            }
        }
    }
    Ok(())
}

/// True if a ray from the point along the first axis crosses the loop an odd number of times.
fn contains<R: Real>(corners: &[[R; 2]], point: &[R; 2], scale: &OutlineExtent<R>) -> bool {
    let point = scale.at(point);
    let crossed = sides(corners).filter(|side| {
        let [a, b] = side.map(|end| scale.at(end));
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

/// On which side of the line through two points a third one lies.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Left,
    Right,
    /// As far as rounding can say.
    On,
}

fn side_of<R: Real>(a: &Vector2<R>, b: &Vector2<R>, c: &Vector2<R>) -> Side {
    let left = (b.x - a.x) * (c.y - a.y);
    let right = (b.y - a.y) * (c.x - a.x);
    let rounding = R::TWO * R::TWO * R::EPSILON * (left.abs() + right.abs());
    let area = left - right;
    if area > rounding {
        Side::Left
    } else if area < -rounding {
        Side::Right
    } else {
        Side::On
    }
}

/// True if two segments have a point in common.
fn segments_intersect<R: Real>([a, b]: [Vector2<R>; 2], [c, d]: [Vector2<R>; 2]) -> bool {
    let of_first = [side_of(&a, &b, &c), side_of(&a, &b, &d)];
    let of_second = [side_of(&c, &d, &a), side_of(&c, &d, &b)];
    let are_apart = |[one, other]: [Side; 2]| one == other && one != Side::On;
    // Segments of one line are apart if their boxes are.
    let overlap = |[p, q]: [R; 2], [r, s]: [R; 2]| {
        let ordered = |p: R, q: R| if p < q { [p, q] } else { [q, p] };
        let ([low, high], [other_low, other_high]) = (ordered(p, q), ordered(r, s));
        low <= other_high && other_low <= high
    };
    !are_apart(of_first)
        && !are_apart(of_second)
        && overlap([a.x, b.x], [c.x, d.x])
        && overlap([a.y, b.y], [c.y, d.y])
}
