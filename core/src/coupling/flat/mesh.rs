//! Friction of a mesh of triangles.
//!
//! A triangle whose distance from the centre of rotation is at least 8 times its own size (the
//! distance of its farthest corner from its middle) is summed by a rule on its area: ρ/r is smooth
//! there, and no digits cancel, however small the triangle is. Fewer points serve the farther ones:
//!
//! ```text
//! distance/size from        8       21      43      190
//! points                    25      16      12      7
//! error, of its load        8e-15   1e-14   1e-14   8e-15
//! D″, of load/distance      9e-14   9e-14   8e-14   5e-14
//! ```
//!
//! (largest among ten triangles and pressures a ratio, needles among them, against 484 points with
//! 25 digits). A triangle that is nearer takes the closed forms of [`super::cone`], of which it loses at
//! most the square of that ratio in rounding errors of its own load; where the whole mesh slides more than
//! it turns, the line integrals of [`super::pole_far`].

use super::cone::about_centre;
use super::motion::{Motion, SplitMotion};
use super::pair_of_numbers::Pair2;
use super::pole_far::TranslatingMotion;
use super::sums::WrenchSums;
use super::{Hessian, PatchShape, Reduced};
use crate::patch::mesh::{Mesh, Triangle};
use crate::real::Real;
use crate::special::triangle::{OF_DEGREE_5, OF_DEGREE_6, OF_DEGREE_8, OF_DEGREE_10, Pair};
use nalgebra::Vector2;

/// Distances from the centre of rotation in sizes of a triangle, squared, from which 7, 12, 16 and 25
/// points are enough.
const ENOUGH: [f64; 4] = [190.0 * 190.0, 43.0 * 43.0, 21.0 * 21.0, NEAREST];
const NEAREST: f64 = 8.0 * 8.0;
/// The same in single precision for 7 and 16 points: the closed forms lose digits that count from 3 sizes on.
const ENOUGH_SINGLE: [f64; 2] = [12.0 * 12.0, NEAREST_SINGLE];
const NEAREST_SINGLE: f64 = 3.0 * 3.0;
/// Largest rounding of the power: beyond, single precision does not know the shape of a needle.
const MOST_LOST: f64 = 1.0 / 1024.0;

impl<R: Real, S: AsRef<[Triangle<R>]>> PatchShape<R> for Mesh<R, S> {
    fn centre(&self) -> Vector2<R> {
        Mesh::centre(self)
    }

    fn radius(&self) -> R {
        Mesh::radius(self)
    }

    /// Cones over the edges of a needle cancel each other; 8 times this was seen of single triangles up to 10⁴ times
    /// as long as wide.
    fn rounding(&self) -> R {
        let mut lost = R::ZERO;
        for triangle in self.triangles() {
            lost += R::EPSILON * triangle.load_of_cones();
        }
        let most = R::from_f64(MOST_LOST);
        if lost <= R::EPSILON {
            R::EPSILON
        } else if lost < most {
            lost
        } else {
            most
        }
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        summed::<R, false>(self.triangles(), motion).0
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        summed::<R, true>(self.triangles(), motion)
    }
}

fn summed<R: Real, const WITH_HESSIAN: bool>(
    triangles: &[Triangle<R>],
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let mut sums = WrenchSums::new();
    match motion.split() {
        SplitMotion::Turns { centre, spin } => {
            for triangle in triangles {
                turn::<R, WITH_HESSIAN>(&mut sums, triangle, &centre);
            }
            sums.turned(&centre, spin)
        }
        SplitMotion::Slides {
            direction,
            turn,
            speed,
        } => {
            let slide = TranslatingMotion {
                direction: &direction,
                spin: turn,
            };
            for triangle in triangles {
                slip::<R, WITH_HESSIAN>(&mut sums, triangle, &slide);
            }
            sums.slid(&slide, speed)
        }
    }
}

/// Adds a triangle about a centre of rotation.
#[inline(always)]
fn turn<R: Real, const WITH_HESSIAN: bool>(
    sums: &mut WrenchSums<R>,
    triangle: &Triangle<R>,
    centre: &Vector2<R>,
) {
    let start = triangle.corner() - centre;
    let from = start + triangle.middle_from_corner();
    let far_sq = from.x * from.x + from.y * from.y;
    let Some(rule) = rule(far_sq, triangle.size_sq()) else {
        sums.add_found(about_centre::<R, WITH_HESSIAN>(triangle, centre));
        return;
    };
    let plane = BarycentricMap::new(triangle, [start.x, start.y], triangle.sides());
    for pair in rule {
        let (at, share) = plane.at(pair);
        sums.turn::<WITH_HESSIAN>(at, share);
    }
}

/// Adds a triangle that slides.
#[inline(always)]
fn slip<R: Real, const WITH_HESSIAN: bool>(
    sums: &mut WrenchSums<R>,
    triangle: &Triangle<R>,
    slide: &TranslatingMotion<'_, R>,
) {
    // Distances from the centre of rotation times the spin are speeds.
    let spin = slide.spin;
    let [x, y] = slide.turned(&(triangle.corner() + triangle.middle_from_corner()));
    let (along, across) = (R::ONE - spin * y, spin * x);
    let far_sq = along * along + across * across;
    let Some(rule) = rule_of_slide(far_sq, triangle.size_sq(), spin * spin) else {
        let edges = triangle.edges();
        let pressure = triangle.pressure();
        let reach = triangle.longest_half() * spin.abs();
        let [a, b, c] = slide.linear(&edges, &pressure, reach);
        if WITH_HESSIAN {
            let [d, e, f] = slide.bent(&edges, &pressure, reach);
            sums.add_found([a, b, c, d, e, f]);
        } else {
            sums.add_found([a, b, c]);
        }
        return;
    };
    let sides = triangle.sides().map(|side| {
        let [x, y] = slide.turned(&side);
        Vector2::new(x, y)
    });
    let plane = BarycentricMap::new(triangle, slide.turned(&triangle.corner()), sides);
    for pair in rule {
        let (at, share) = plane.at(pair);
        sums.slide::<WITH_HESSIAN>(Pair2::of(spin), at, share);
    }
}

/// The rule that is enough at this distance, squared; `None` next to the centre of rotation.
#[inline(always)]
fn rule<R: Real>(far_sq: R, size_sq: R) -> Option<&'static [Pair]> {
    let is_within = |limit: f64| far_sq < R::from_f64(limit) * size_sq;
    if R::IS_SINGLE {
        let [seven, sixteen] = ENOUGH_SINGLE;
        return if is_within(sixteen) {
            None
        } else if is_within(seven) {
            Some(&OF_DEGREE_8)
        } else {
            Some(&OF_DEGREE_5)
        };
    }
    if is_within(NEAREST) {
        return None;
    }
    let [seven, twelve, sixteen, _] = ENOUGH;
    Some(if !is_within(seven) {
        &OF_DEGREE_5
    } else if !is_within(twelve) {
        &OF_DEGREE_6
    } else if !is_within(sixteen) {
        &OF_DEGREE_8
    } else {
        &OF_DEGREE_10
    })
}

/// What 7, 12, 16 and 25 points ask of a patch that slides: (distance/size)^10, ^6, ^8 and ^10 over
/// d⁴, d², d² and d² with the distance d of the centre of rotation in radii; in single precision of 7
/// and 16 points.
const SLIDING: [f64; 4] = [1e24, 4e10, 2.7e11, 7.7e9];
const SLIDING_SINGLE: [f64; 2] = [2.3e9, 1.4e4];

/// The rule that is enough where the squared speed of a triangle's middle and the squared spin are
/// given. The second derivatives about the normal hold x² beside the pressure, of which less of the
/// rule's degree is left for 1/q: the errors of the table count 4 d² times as much.
#[inline(always)]
fn rule_of_slide<R: Real>(far_sq: R, size_sq: R, spin_sq: R) -> Option<&'static [Pair]> {
    let ratio = far_sq / (spin_sq * size_sq + R::MIN_POSITIVE);
    let (fourth, sixth) = (ratio * ratio, ratio * ratio * ratio);
    let (eighth, tenth) = (fourth * fourth, fourth * sixth);
    // Never true for what is infinite times zero: any rule is enough there.
    let is_below = |power: R, limit: f64| power < R::from_f64(limit);
    if R::IS_SINGLE {
        let [seven, sixteen] = SLIDING_SINGLE;
        return if ratio < R::from_f64(NEAREST_SINGLE) || is_below(eighth * spin_sq, sixteen) {
            None
        } else if is_below(tenth * (spin_sq * spin_sq), seven) {
            Some(&OF_DEGREE_8)
        } else {
            Some(&OF_DEGREE_5)
        };
    }
    let [seven, twelve, sixteen, most] = SLIDING;
    if ratio < R::from_f64(NEAREST) || is_below(tenth * spin_sq, most) {
        None
    } else if is_below(eighth * spin_sq, sixteen) {
        Some(&OF_DEGREE_10)
    } else if is_below(sixth * spin_sq, twelve) {
        Some(&OF_DEGREE_8)
    } else if is_below(tenth * (spin_sq * spin_sq), seven) {
        Some(&OF_DEGREE_6)
    } else {
        Some(&OF_DEGREE_5)
    }
}

/// Place and load as functions of the shares of the second and the third corner.
struct BarycentricMap<R> {
    /// x, y and the load, each at the first corner and its changes to the others.
    parts: [[Pair2<R>; 3]; 3],
}

impl<R: Real> BarycentricMap<R> {
    #[inline(always)]
    fn new(triangle: &Triangle<R>, [x, y]: [R; 2], [second, third]: [Vector2<R>; 2]) -> Self {
        let area = R::HALF * triangle.twice_area();
        let [p, q, r] = triangle.pressures();
        let parts = [
            [x, second.x, third.x],
            [y, second.y, third.y],
            [area * p, area * (q - p), area * (r - p)],
        ];
        Self {
            parts: parts.map(|part| part.map(Pair2::of)),
        }
    }

    #[inline(always)]
    fn at(&self, &[weights, second, third]: &Pair) -> ([Pair2<R>; 2], Pair2<R>) {
        let [weights, second, third] =
            [weights, second, third].map(|lanes| Pair2(lanes.map(R::from_f64)));
        let [x, y, load] = self
            .parts
            .map(|[start, by_second, by_third]| start + second * by_second + third * by_third);
        ([x, y], weights * load)
    }
}
