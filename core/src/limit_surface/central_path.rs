//! How far a ray of wrenches goes until no sharing of a load carries it, from both sides.
//!
//! In units of force limit and radius, with t = (v, ω) the motion of the centre, u = v + ω × d that of a
//! corner and e·t = 1,
//!
//! ```text
//! greatest s with x + s e carried  =  least z(0) − x·t   over t and planes z   with   |u| ≤ z(d) at every corner
//! ```
//!
//! z is a plane above the speeds, written by its heights above three corners around the centre, so that corners
//! which carry little lose no digits. A barrier −Σ ln(z² − |u|²) makes this a smooth problem of five unknowns,
//! however many corners there are (Nesterov and Nemirovskii, Interior-point polynomial algorithms, SIAM 1994).
//! Newton's method follows its minimum while the objective's weight τ grows. Shares 2z/(τ D) and forces 2u/(τ D),
//! D the barrier's argument, tend to those that carry the wrench. Neither bound relies on the method: the
//! upper one is the support at the motion, the lower one the wrench of these forces, after the shares
//! are put right.
//!
//! Next to the largest force all corners move almost along it, ever faster. Speeds, planes and forces are
//! therefore counted from a *lead*, the part g = u·e of the velocities along the force e, which is itself a
//! plane: with z = g + w and b the velocity across,
//!
//! ```text
//! |u| − g = b²/(|u| + g),     z − |u| = w − b²/(|u| + g),     Σ(share − force·e) = 1 − |x|
//! ```
//!
//! and nothing cancels. Without a lead g counts as velocity across.

use super::load_sharing::{LoadSharing, cross};
use super::quadratic::{Factors, dot, norm};
use super::search::pivot;
use crate::real::Real;
use nalgebra::{Matrix3, Vector2, Vector3};

/// Growth of the objective's weight.
const GROWTH: f64 = 100.0;
/// The weight ends where rounding of the barrier reaches this part of a Newton step's length.
const LAST_WEIGHT: f64 = 1.0 / 128.0;
/// Most Newton steps at one weight; 12 were seen.
const MOST_STEPS: usize = 60;
/// Newton decrement below which the minimum is near enough.
const CENTRED: f64 = 0.01;
/// Newton decrement below which full steps converge.
const QUADRATIC: f64 = 0.25;
/// Bounds this near, of 1, are as near as they get.
const NEAR_ULPS: f64 = 256.0;

/// Wrenches `from` + s `along` about the centre, in units of force limit and radius, with the first axis
/// along `direction`.
#[derive(Debug)]
pub(super) struct WrenchRay<R: Real> {
    pub(super) direction: Vector2<R>,
    /// 1 if speeds are counted from those along the first axis, 0 if not.
    pub(super) lead: R,
    /// From the wrench of a force `lead` along the first axis.
    pub(super) from: Vector3<R>,
    /// Of length 1.
    pub(super) along: Vector3<R>,
    /// Wrenches of this gauge may be added to `from` and are still carried.
    pub(super) margin: R,
    /// A torque that is carried without force.
    pub(super) torque: R,
}

/// Two motions across the ray, and one along it.
struct Axes<R: Real> {
    direction: Vector2<R>,
    lead: R,
    along: Vector3<R>,
    across: [Vector3<R>; 2],
}

/// The unknowns: parts of the motion across the ray, and the heights of the plane.
type Unknowns<R> = [R; 5];

/// A lower and an upper bound of the greatest s ≥ 0.
pub(super) fn reach<R: Real, S: AsRef<[[R; 2]]>>(
    sharing: &LoadSharing<R, S>,
    ray: &WrenchRay<R>,
) -> [R; 2] {
    let axes = Axes::of(ray);
    let mut at = [R::ZERO; 5];
    // A plane that is higher than twice the greatest speed above the lead.
    let mut fastest = R::ZERO;
    sharing.for_each(|d, _| {
        let speed = speed(&axes.velocity(&axes.along, d));
        if speed > fastest {
            fastest = speed;
        }
    });
    let [_, _, heights @ ..] = &mut at;
    *heights = [(R::TWO + axes.lead) * fastest + R::EPSILON; 3];
    let mut bounds = [R::ZERO, R::INFINITY];
    let mut weight = R::ONE;
    let last = R::from_f64(LAST_WEIGHT) / R::EPSILON;
    loop {
        at = centred(sharing, ray, &axes, weight, at);
        let [low, high] = bounds_at(sharing, ray, &axes, weight, &at);
        let [lower, upper] = &mut bounds;
        if low > *lower {
            *lower = low;
        }
        if high < *upper {
            *upper = high;
        }
        let is_near = *upper - *lower <= R::from_f64(NEAR_ULPS) * R::EPSILON * *upper;
        // Not true for NaN either.
        let goes_on = weight < last && !is_near && at.iter().all(|x| x.is_finite());
        if !goes_on {
            break;
        }
        weight *= R::from_f64(GROWTH);
    }
    bounds
}

impl<R: Real> Axes<R> {
    /// Two directions across that of the ray, and each other.
    fn of(ray: &WrenchRay<R>) -> Self {
        let (x, y, z) = (ray.along.x, ray.along.y, ray.along.z);
        let zero = R::ZERO;
        let side = if x.abs() <= y.abs() && x.abs() <= z.abs() {
            Vector3::new(zero, z, -y)
        } else if y.abs() <= z.abs() {
            Vector3::new(-z, zero, x)
        } else {
            Vector3::new(y, -x, zero)
        };
        let first = side * (R::ONE / norm(&side));
        let second = Vector3::new(
            y * first.z - z * first.y,
            z * first.x - x * first.z,
            x * first.y - y * first.x,
        );
        Self {
            direction: ray.direction,
            lead: ray.lead,
            along: ray.along,
            across: [first, second],
        }
    }

    /// A corner's place.
    fn turned(&self, d: &Vector2<R>) -> Vector2<R> {
        let (c, s) = (self.direction.x, self.direction.y);
        Vector2::new(c * d.x + s * d.y, c * d.y - s * d.x)
    }

    /// Velocity of a corner.
    fn velocity(&self, motion: &Vector3<R>, d: &Vector2<R>) -> Vector2<R> {
        let d = self.turned(d);
        Vector2::new(motion.x - motion.z * d.y, motion.y + motion.z * d.x)
    }

    /// Speed above the lead.
    fn excess(&self, u: &Vector2<R>) -> R {
        let (speed, lead) = (speed(u), self.lead * u.x);
        if lead > R::ZERO {
            u.y * u.y / (speed + lead)
        } else {
            speed - lead
        }
    }

    /// `height` above the lead where the plane is counted from there, else the velocity's part against it.
    fn lean(&self, height: R, u: &Vector2<R>) -> R {
        if self.lead > R::ZERO { height } else { -u.x }
    }

    /// The motion of the centre.
    fn motion(&self, [p, q, ..]: &Unknowns<R>) -> Vector3<R> {
        let [first, second] = self.across;
        self.along + first * *p + second * *q
    }
}

pub(super) fn speed<R: Real>(u: &Vector2<R>) -> R {
    u.x.hypot(u.y)
}

/// What the barrier is made of at a corner.
struct Slack<R: Real> {
    /// Heights of the plane, above the lead and in all.
    height: R,
    plane: R,
    u: Vector2<R>,
    /// The barrier's argument.
    argument: R,
}

fn slack<R: Real>(axes: &Axes<R>, at: &Unknowns<R>, d: &Vector2<R>, [a, b, c]: [R; 3]) -> Slack<R> {
    let [_, _, x, y, z] = *at;
    let height = a * x + b * y + c * z;
    let u = axes.velocity(&axes.motion(at), d);
    let plane = height + axes.lead * u.x;
    let gap = height - axes.excess(&u);
    // NaN stays.
    let argument = if plane <= R::ZERO {
        -R::ONE
    } else {
        gap * (plane + speed(&u))
    };
    Slack {
        height,
        plane,
        u,
        argument,
    }
}

/// The minimum at one weight, by damped Newton steps, which never leave the domain.
fn centred<R: Real, S: AsRef<[[R; 2]]>>(
    sharing: &LoadSharing<R, S>,
    ray: &WrenchRay<R>,
    axes: &Axes<R>,
    weight: R,
    start: Unknowns<R>,
) -> Unknowns<R> {
    let mut at = start;
    for _ in 0..MOST_STEPS {
        let rows = newton(sharing, ray, axes, weight, &at);
        let gradient = rows.map(last);
        let step = solved(rows);
        let mut decrement = R::ZERO;
        for (g, s) in gradient.iter().zip(&step) {
            decrement += *g * *s;
        }
        let decrement = decrement.abs().sqrt();
        let mut factor = if decrement > R::from_f64(QUADRATIC) {
            R::ONE / (R::ONE + decrement)
        } else {
            R::ONE
        };
        // Rounding alone takes a damped step out of the domain.
        let mut next = moved(&at, &step, factor);
        for _ in 0..MOST_STEPS {
            if is_inside(sharing, axes, &next) {
                break;
            }
            factor = R::HALF * factor;
            next = moved(&at, &step, factor);
        }
        if !is_inside(sharing, axes, &next) {
            break;
        }
        at = next;
        if decrement <= R::from_f64(CENTRED) {
            break;
        }
    }
    at
}

fn moved<R: Real>(at: &Unknowns<R>, step: &Unknowns<R>, factor: R) -> Unknowns<R> {
    let mut next = *at;
    for (x, s) in next.iter_mut().zip(step) {
        *x -= factor * *s;
    }
    next
}

fn is_inside<R: Real, S: AsRef<[[R; 2]]>>(
    sharing: &LoadSharing<R, S>,
    axes: &Axes<R>,
    at: &Unknowns<R>,
) -> bool {
    let mut all = true;
    sharing.for_each(|d, parts| {
        all &= slack(axes, at, d, parts).argument > R::ZERO;
    });
    all
}

/// Hessian of objective and barrier, with the gradient as sixth column.
fn newton<R: Real, S: AsRef<[[R; 2]]>>(
    sharing: &LoadSharing<R, S>,
    ray: &WrenchRay<R>,
    axes: &Axes<R>,
    weight: R,
    at: &Unknowns<R>,
) -> [[R; 6]; 5] {
    let zero = R::ZERO;
    let [first, second] = axes.across;
    let mut rows = [[zero; 6]; 5];
    let [a, b, c] = sharing.base();
    let objective = [-dot(&ray.from, &first), -dot(&ray.from, &second), a, b, c];
    for (row, slope) in rows.iter_mut().zip(objective) {
        if let Some(gradient) = row.last_mut() {
            *gradient = weight * slope;
        }
    }
    let (lead, rest) = (axes.lead, R::ONE - axes.lead);
    sharing.for_each(|d, [a, b, c]| {
        let slack = slack(axes, at, d, [a, b, c]);
        let [one, other] = [axes.velocity(&first, d), axes.velocity(&second, d)];
        // How height and velocity follow the unknowns.
        let height_by = [zero, zero, a, b, c];
        let x_by = [one.x, other.x, zero, zero, zero];
        let y_by = [one.y, other.y, zero, zero, zero];
        let (plane, u) = (slack.plane, &slack.u);
        let lean = axes.lean(slack.height, u);
        let inverse = R::TWO / slack.argument;
        let mut slope = [zero; 5];
        for ((s, p), (x, y)) in slope.iter_mut().zip(height_by).zip(x_by.iter().zip(y_by)) {
            *s = inverse * (plane * p + lean * *x - u.y * y);
        }
        for (row, ((s, p), (x, y))) in rows
            .iter_mut()
            .zip(slope.iter().zip(height_by).zip(x_by.iter().zip(y_by)))
        {
            let columns = slope.iter().zip(height_by).zip(x_by.iter().zip(y_by));
            for (entry, ((t, q), (v, w))) in row.iter_mut().zip(columns) {
                let bend = p * q + lead * (p * *v + *x * q) - rest * (*x * *v) - y * w;
                *entry += *s * *t - inverse * bend;
            }
            if let Some(gradient) = row.last_mut() {
                *gradient -= *s;
            }
        }
    });
    rows
}

fn last<R: Real>(row: [R; 6]) -> R {
    let [.., last] = row;
    last
}

/// The solution of five symmetric equations; zero along directions in which nothing changes.
fn solved<R: Real>(mut rows: [[R; 6]; 5]) -> Unknowns<R> {
    let entry = |row: &[R; 6], column: usize| row.get(column).copied().unwrap_or(R::ZERO);
    let mut least = [R::ZERO; 5];
    for (column, (least, row)) in least.iter_mut().zip(&rows).enumerate() {
        *least = pivot::<R>() * entry(row, column);
    }
    for (column, least) in least.into_iter().enumerate() {
        let Some(pivot_row) = rows.get(column).copied() else {
            break;
        };
        let pivot = entry(&pivot_row, column);
        for (index, row) in rows.iter_mut().enumerate() {
            if index == column {
                let inverse = if pivot <= least {
                    R::ZERO
                } else {
                    R::ONE / pivot
                };
                row.iter_mut().for_each(|x| *x *= inverse);
            } else if pivot > least {
                let factor = entry(row, column) / pivot;
                for (x, p) in row.iter_mut().zip(pivot_row) {
                    *x -= factor * p;
                }
            }
        }
    }
    rows.map(last)
}

/// The bounds that hold wherever the search stands.
fn bounds_at<R: Real, S: AsRef<[[R; 2]]>>(
    sharing: &LoadSharing<R, S>,
    ray: &WrenchRay<R>,
    axes: &Axes<R>,
    weight: R,
    at: &Unknowns<R>,
) -> [R; 2] {
    let motion = axes.motion(at);
    let mut support = R::ZERO;
    // The lead itself has the same mean under every pressure.
    let excess = |d: &Vector2<R>| axes.excess(&axes.velocity(&motion, d));
    let greatest = sharing.greatest(excess);
    for share in &greatest.shares {
        support += share.part * excess(&share.at);
    }
    // From outside whatever the search for the corners left.
    support += greatest.excess;
    let upper = (support - dot(&ray.from, &motion)) / dot(&ray.along, &motion);
    let step = solved(newton(sharing, ray, axes, weight, at));
    let carried = carried(sharing, axes, at, &step);
    let lower = carried.map_or(R::ZERO, |wrench| on_ray(ray, &wrench));
    [lower, upper]
}

/// Share of a corner, and its force from that of a force `lead` · share along the first axis, after one more
/// Newton step, to first order in it, without the factor 2/τ.
///
/// To this order they satisfy all equations, however much rounding there is in the barrier.
fn dual<R: Real>(
    axes: &Axes<R>,
    at: &Unknowns<R>,
    step: &Unknowns<R>,
    d: &Vector2<R>,
    parts: [R; 3],
) -> (R, Vector2<R>) {
    let slack = slack(axes, at, d, parts);
    let (plane, u) = (slack.plane, &slack.u);
    let [p, q, x, y, z] = *step;
    let [first, second] = axes.across;
    let [a, b, c] = parts;
    let height_step = a * x + b * y + c * z;
    let u_step = axes.velocity(&(first * p + second * q), d);
    let lean = axes.lean(slack.height, u);
    let lean_step = axes.lean(height_step, &u_step);
    // How the barrier's argument shrinks, of itself.
    let shrinks =
        (plane * height_step + lean * u_step.x - u.y * u_step.y) * (R::TWO / slack.argument);
    let later = |now: R, step: R| (now * (R::ONE + shrinks) - step) / slack.argument;
    let plane_step = height_step + axes.lead * u_step.x;
    let force = Vector2::new(-later(lean, lean_step), later(u.y, u_step.y));
    (later(plane, plane_step), force)
}

/// How far a force exceeds its share, as the factor by which all forces must be nearer to the lead.
fn strain<R: Real>(axes: &Axes<R>, share: R, force: &Vector2<R>) -> R {
    if axes.lead > R::ZERO {
        // |force| ≤ share, squared, with what is missing along the lead.
        let missing = -force.x;
        force.y * force.y / (missing * (R::TWO * share - missing))
    } else {
        speed(force) / share
    }
}

/// A wrench that the forces of the central path carry, with shares that add up as they must.
fn carried<R: Real, S: AsRef<[[R; 2]]>>(
    sharing: &LoadSharing<R, S>,
    axes: &Axes<R>,
    at: &Unknowns<R>,
    step: &Unknowns<R>,
) -> Option<Vector3<R>> {
    let [x, y, z] = sharing.base();
    // Moments of the shares.
    let mut m = [R::ZERO; 6];
    sharing.for_each(|d, [a, b, c]| {
        let (share, _) = dual(axes, at, step, d, [a, b, c]);
        for (sum, product) in m.iter_mut().zip([a * a, a * b, a * c, b * b, b * c, c * c]) {
            *sum += product * share;
        }
    });
    let [aa, ab, ac, bb, bc, cc] = m;
    // Times a plane such that their centre has the coordinates it must have.
    let plane = if sharing.is_fixed() {
        Vector3::new(x / aa, y / bb, R::ZERO)
    } else {
        let m = Matrix3::new(aa, ab, ac, ab, bb, bc, ac, bc, cc);
        Factors::of(&m, pivot()).solve(&Vector3::new(x, y, z))
    };
    let mut wrench = Vector3::new(R::ZERO, R::ZERO, R::ZERO);
    // No force may exceed its share.
    let (mut is_right, mut most) = (true, R::ONE);
    sharing.for_each(|d, [a, b, c]| {
        let (share, force) = dual(axes, at, step, d, [a, b, c]);
        let factor = a * plane.x + b * plane.y + c * plane.z;
        let strain = strain(axes, share, &force);
        if strain > most {
            most = strain;
        }
        let is_short = axes.lead == R::ZERO || force.x < R::ZERO;
        is_right &= share > R::ZERO && factor >= R::ZERO && is_short;
        // Forces along the lead have no torque about the centre, all together.
        let torque = cross(&axes.turned(d), &force);
        wrench += Vector3::new(force.x, force.y, torque) * factor;
    });
    is_right.then(|| wrench * (R::ONE / most))
}

/// The s for which the ray's wrench is a mean of a carried one nearby and of carried ones around its start.
fn on_ray<R: Real>(ray: &WrenchRay<R>, wrench: &Vector3<R>) -> R {
    let way = wrench - ray.from;
    let s = dot(&way, &ray.along);
    let off = way - ray.along * s;
    let aside = off.x.hypot(off.y) + off.z.abs() / ray.torque;
    let lower = s / (R::ONE + aside / ray.margin);
    if lower > R::ZERO { lower } else { R::ZERO }
}
