//! Friction of an ellipse, by one integral over the lines through the centre of rotation.
//!
//! A velocity is the mean of its parts along all directions, |q| = ½ ∫|q·n| dθ over half a turn. Since q is linear in
//! place, q·n vanishes on the line along n through the centre of rotation c, and over the ellipse it is spread like the
//! distance from that line. With the ellipse stretched to the unit disk (n to ν, c to d) that distance is
//! t = d × ν, and loads p ∝ (1−ρ²)^q have, at distances s from any diameter, the density
//!
//! ```text
//! p(s) = C (1 − s²)^m/2,     m = 2q + 1 = 0 … 3 for punch, uniform pressure, Hertz and paraboloid
//! ```
//!
//! With x the angle of ν from d, |n| = Δ = |M ν|, lengths in semi-axes a, and the integral of the force by parts,
//!
//! ```text
//! force  = z × ∫ p(t) n/Δ dt,     torque = −b²/(m+2) ∫ p(t) (1−t²)/Δ³ dx,     D″ = 1/|ω| ∫ p(t) W W/Δ³ dx
//! ```
//!
//! over the lines that cut the ellipse, W = (n, t b). All terms of the power and the torque are positive: nothing cancels.
//!
//! Inside the ellipse t = |d| sin x and all lines count; punch and Hertz then are complete elliptic integrals
//! ([`super::ellipse_closed`]). Outside t = sin σ and sin x = t/|d|. The
//! integrand in z = tan(angle/2) is analytic but for places known in advance ([`super::panels`]): Δ = 0,
//! and tangents to the edge.

use super::ellipse_closed::closed;
use super::motion::Motion;
use super::panels::{Complex, Panels};
use super::{Hessian, PatchShape, Reduced};
use crate::patch::ellipse::{Ellipse, EllipsePressure};
use crate::real::Real;
use nalgebra::Vector2;

/// Factor of the rounding of a sum of so many lines.
const ROUNDING: f64 = 4.0;

impl<R: Real> PatchShape<R> for Ellipse<R> {
    fn centre(&self) -> Vector2<R> {
        Ellipse::centre(self)
    }

    fn radius(&self) -> R {
        Ellipse::radius(self)
    }

    fn rounding(&self) -> R {
        R::EPSILON * R::from_f64(ROUNDING)
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        let seen = EllipseMotion::new(self, motion);
        let sums = match closed(self, &seen) {
            Some(closed) => closed.wrench(),
            None => seen.wrench(),
        };
        seen.reduced(self, sums)
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        let seen = EllipseMotion::new(self, motion);
        let (wrench, second) = match closed(self, &seen) {
            Some(closed) => (closed.wrench(), closed.hessian()),
            None => seen.wrench_and_hessian(),
        };
        (seen.reduced(self, wrench), seen.bent(self, second))
    }
}

impl EllipsePressure {
    /// m: p(t) goes like its power of √(1−t²).
    #[inline(always)]
    pub(super) fn order(self) -> u32 {
        match self {
            Self::FlatPunch => 0,
            Self::Uniform => 1,
            Self::Hertz => 2,
            Self::Paraboloid => 3,
        }
    }

    /// p(0) = C, for a load of 1 over −1 < t < 1.
    #[inline(always)]
    pub(super) fn density<R: Real>(self) -> R {
        let pi = R::PI;
        match self {
            Self::FlatPunch => R::HALF,
            Self::Uniform => R::TWO / pi,
            Self::Hertz => R::from_f64(0.75),
            Self::Paraboloid => R::from_f64(8.0 / 3.0) / pi,
        }
    }
}

/// A motion as the ellipse sees it: along its axes, which are turned over so that both components of the
/// centre of rotation are positive.
#[derive(Clone, Copy, Debug)]
pub(super) struct EllipseMotion<R> {
    /// Place of the centre of rotation times |rim|, in semi-axes a.
    across: [R; 2],
    /// The same for the ellipse stretched to a unit disk.
    pub(super) pole: [R; 2],
    /// Its length, |d| |rim|.
    far: R,
    /// |spin| a
    pub(super) rim: R,
    /// Semi-axis b over a.
    ratio: R,
    /// m, see [`EllipsePressure::order`].
    order: u32,
    density: R,
    /// Signs of the place and of the spin.
    signs: [R; 3],
}

/// A line through the centre of rotation and its part of the integrals.
struct Line<R> {
    /// n/Δ
    along: [R; 2],
    /// 1/Δ
    inverse: R,
    /// Signed distance from the centre, in the unit disk.
    at: R,
    /// √(1 − t²)
    root: R,
    /// Weight of dt, with the sign of what is ahead.
    step: R,
    /// Weight of dx, outside times |d|.
    turn: R,
}

impl<R: Real> Line<R> {
    /// Its part of the means of n/Δ and of the torque.
    #[inline(always)]
    fn of_wrench(&self, ratio: R, density: R) -> [R; 3] {
        let weight = density * self.step;
        let arm = ratio * self.inverse;
        let torque = density * self.root * self.root * arm * arm * self.inverse * self.turn;
        [weight * self.along[0], weight * self.along[1], torque]
    }

    /// Its part of the second derivatives.
    #[inline(always)]
    fn of_hessian(&self, ratio: R, density: R) -> [R; 6] {
        let weight = density * self.inverse * self.turn;
        let [x, y] = self.along;
        let n = self.at * ratio * self.inverse;
        [x * x, x * y, y * y, x * n, y * n, n * n].map(|part| weight * part)
    }
}

impl<R: Real> EllipseMotion<R> {
    #[inline]
    fn new(ellipse: &Ellipse<R>, motion: &Motion<R>) -> Self {
        let (major, minor) = (ellipse.major_axis(), ellipse.minor());
        // z × v is the place of the centre of rotation times the spin.
        let (x, y) = (-motion.velocity.y, motion.velocity.x);
        let along = x * major.x + y * major.y;
        let across = x * minor.x + y * minor.y;
        let ratio = ellipse.ratio();
        let place = [along.abs(), across.abs()];
        let [px, py] = place;
        let pole = [px, py / ratio];
        let pressure = ellipse.pressure();
        Self {
            across: place,
            pole,
            far: pole[0].hypot(pole[1]),
            rim: motion.rim.abs(),
            ratio,
            order: pressure.order(),
            density: pressure.density(),
            signs: [along, across, motion.rim].map(|part| R::ONE.copysign(part)),
        }
    }

    /// True if the centre of rotation lies in the ellipse and not on its edge.
    #[inline(always)]
    pub(super) fn is_inside(&self) -> bool {
        self.far / self.rim < R::ONE
    }

    /// Means of n/Δ, and the torque.
    fn wrench(&self) -> [R; 3] {
        let sums = self.sum(|line, density| line.of_wrench(self.ratio, density));
        self.mean_wrench(sums)
    }

    /// The same and second derivatives of the power.
    fn wrench_and_hessian(&self) -> ([R; 3], [R; 6]) {
        let [x, y, torque, xx, xy, yy, xn, yn, nn] = self.sum(|line, density| {
            let [x, y, torque] = line.of_wrench(self.ratio, density);
            let [xx, xy, yy, xn, yn, nn] = line.of_hessian(self.ratio, density);
            [x, y, torque, xx, xy, yy, xn, yn, nn]
        });
        let speed = if self.is_inside() { self.rim } else { self.far };
        let hessian = [xx, xy, yy, xn, yn, nn].map(|sum| sum / speed);
        (self.mean_wrench([x, y, torque]), hessian)
    }

    #[inline(always)]
    fn mean_wrench(&self, [x, y, torque]: [R; 3]) -> [R; 3] {
        let torque = torque / (R::from_f64(f64::from(self.order)) + R::TWO);
        if self.is_inside() {
            [x, y, torque]
        } else {
            [x, y, torque * (self.rim / self.far)]
        }
    }

    /// Sum over all lines that cut the ellipse, of a function of a line and p(t).
    #[inline(always)]
    fn sum<const N: usize>(&self, of: impl Fn(&Line<R>, R) -> [R; N]) -> [R; N] {
        let mut sums = [R::ZERO; N];
        let mut add = |line: Line<R>| {
            let root = line.root;
            let density = self.density
                * match self.order {
                    0 => R::ONE,
                    1 => root,
                    2 => root * root,
                    _ => root * root * root,
                };
            for (sum, part) in sums.iter_mut().zip(of(&line, density)) {
                *sum += part;
            }
        };
        if self.is_inside() {
            self.each_line_inside(&mut add);
        } else {
            self.each_line_outside(&mut add);
        }
        sums
    }

    /// All lines through a point of the ellipse, by their angle y = 2 atan z from the minor axis.
    #[inline(always)]
    fn each_line_inside(&self, add: &mut impl FnMut(Line<R>)) {
        let [dx, dy] = self.pole.map(|part| part / self.rim);
        let d = self.far / self.rim;
        let within = (R::ONE - d) * (R::ONE + d);
        let b = self.ratio;
        // Lines along the minor axis, and tangents to the edge.
        let focus = ((R::ONE - b) * (R::ONE + b)).sqrt();
        let thin = Complex::new(R::ZERO, b / (R::ONE + focus));
        let edge = Complex::new(dy, within.sqrt()).over(R::ONE + dx);
        let marks = [thin, edge, edge.inverse().negative()];
        Panels {
            end: R::ONE,
            start: R::ZERO,
            least: R::ZERO,
            most: R::ONE,
            marks,
        }
        .each(&mut |z, _, weight| {
            let share = R::ONE / (R::ONE + z * z);
            let (sin, cos) = (R::TWO * z * share, (R::ONE - z) * (R::ONE + z) * share);
            let (x, y) = (-sin, b * cos);
            let inverse = R::ONE / (x * x + y * y).sqrt();
            let ahead = dy * cos - dx * sin;
            let turn = R::TWO * weight * share;
            add(Line {
                along: [x * inverse, y * inverse],
                inverse,
                at: dx * cos + dy * sin,
                root: (within + ahead * ahead).sqrt(),
                step: ahead * turn,
                turn,
            });
        });
    }

    /// The lines between two tangents, by t = sin σ, z = tan(σ/2).
    #[inline(always)]
    fn each_line_outside(&self, add: &mut impl FnMut(Line<R>)) {
        let [along, _] = self.across;
        let near = self.rim / self.far;
        let beyond = (R::ONE - near) * (R::ONE + near);
        // Sine and cosine of the angle from d to the minor axis, where t = d₁.
        let [sin_minor, cos_minor] = self.pole.map(|part| part / self.far);
        let (start, excess) = if along < self.rim {
            let at = along / self.rim;
            let start = at / (R::ONE + ((R::ONE - at) * (R::ONE + at)).sqrt());
            (start, R::ZERO)
        } else {
            (R::ONE, near - sin_minor)
        };
        let start_share = R::ONE / (R::ONE + start * start);
        let b = self.ratio;
        let [thin, image] = self.thin_marks();
        // About a point of the edge all lines count, and the roots end with the integral.
        let tangents = if beyond > R::ZERO {
            let tangent = Complex::new(near, beyond.sqrt());
            [tangent, tangent.mirrored()]
        } else {
            [image.negative(); 2]
        };
        let marks = [thin, image, tangents[0], tangents[1]];
        let (end, least, most) = (R::ONE, R::ZERO, R::ONE);
        Panels {
            end,
            start,
            least,
            most,
            marks,
        }
        .each(&mut |z, apart, weight| {
            let share = R::ONE / (R::ONE + z * z);
            let (at, root) = (R::TWO * z * share, (R::ONE - z) * (R::ONE + z) * share);
            let cos = (beyond + near * near * root * root).sqrt();
            // Half the angle from the minor axis, with all digits where Δ is small.
            let rise = R::TWO * apart * (R::ONE - z * start) * share * start_share;
            let tan = (near * rise + excess) / (cos + cos_minor);
            let (x, y) = (-(tan + tan), b * (R::ONE - tan) * (R::ONE + tan));
            let scaled = R::ONE / (x * x + y * y).sqrt();
            let step = R::TWO * weight * share * root;
            add(Line {
                along: [x * scaled, y * scaled],
                inverse: scaled * (R::ONE + tan * tan),
                at,
                root,
                step,
                turn: step / cos,
            });
        });
    }

    /// Where Δ = 0: t is the centre of rotation over the focal distance, as a complex number.
    fn thin_marks(&self) -> [Complex<R>; 2] {
        let b = self.ratio;
        let focal = self.rim * ((R::ONE - b) * (R::ONE + b)).sqrt();
        let [x, y] = self.across;
        Complex::new(x, y).over(focal).tangent_of_half_arcsine()
    }

    /// In the coordinates of the patch.
    #[inline]
    fn reduced(&self, ellipse: &Ellipse<R>, [x, y, torque]: [R; 3]) -> Reduced<R> {
        let [sign_x, sign_y, sense] = self.signs;
        let (major, minor) = (ellipse.major_axis(), ellipse.minor());
        Reduced {
            force: minor * (sign_x * x) - major * (sign_y * y),
            torque: -(sense * torque),
        }
    }

    /// The same of second derivatives.
    fn bent(&self, ellipse: &Ellipse<R>, [xx, xy, yy, xn, yn, nn]: [R; 6]) -> Hessian<R> {
        let [sign_x, sign_y, sense] = self.signs;
        let (xy, xn, yn) = (
            sign_x * sign_y * xy,
            sense * sign_y * xn,
            sense * sign_x * yn,
        );
        let major = ellipse.major_axis();
        let (c, s) = (major.x, major.y);
        let both = R::TWO * c * s * xy;
        Hessian {
            xx: c * c * xx - both + s * s * yy,
            xy: c * s * (xx - yy) + (c * c - s * s) * xy,
            yy: s * s * xx + both + c * c * yy,
            xn: c * xn - s * yn,
            yn: s * xn + c * yn,
            nn,
        }
    }
}

#[cfg(test)]
#[path = "ellipse_tests.rs"]
mod tests;
