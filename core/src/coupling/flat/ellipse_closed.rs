//! The centre of rotation in an ellipse under Hertz' pressure or a flat punch: complete elliptic integrals.
//!
//! p(t) is a polynomial, and with c, s the components of ν along the axes and Δ² = c² + b² s² all sums are made of
//!
//! ```text
//! P_ij = ∫cⁱsʲ/Δ,     Q_ij = ∫cⁱsʲ/Δ³     over half a turn
//! ```
//!
//! of even i and j up to 4; odd ones vanish.

use super::ellipse::EllipseMotion;
use crate::patch::ellipse::{Ellipse, EllipsePressure};
use crate::real::Real;

/// The integrals for one place of the centre of rotation.
pub(super) struct Closed<R> {
    /// Place in the unit disk.
    pole: [R; 2],
    rim: R,
    ratio: R,
    density: R,
    /// p(t) = density (1 − `bend` t²): 0 or 1.
    bend: R,
    /// P₂₀, P₀₂, P₄₀, P₂₂, P₀₄
    over_delta: [R; 5],
    /// The same of Q, over b² where s counts: Q₂₀, b² Q₀₂, Q₄₀, Q₂₂, b² Q₀₄, and b² Q₀₀.
    over_cube: [R; 6],
}

/// The closed form, if there is one.
#[inline]
pub(super) fn closed<R: Real>(ellipse: &Ellipse<R>, seen: &EllipseMotion<R>) -> Option<Closed<R>> {
    let pressure = ellipse.pressure();
    let bend = match pressure {
        EllipsePressure::FlatPunch => R::ZERO,
        EllipsePressure::Hertz => R::ONE,
        EllipsePressure::Uniform | EllipsePressure::Paraboloid => return None,
    };
    if !seen.is_inside() {
        return None;
    }
    let ratio = ellipse.ratio();
    let both = ellipse.integrals();
    let (cos_sq, sin_sq, mixed) = (both.b, both.d, both.c);
    let third = R::TWO / (R::TWO + R::ONE);
    let over_delta = [
        R::TWO * cos_sq,
        R::TWO * sin_sq,
        R::TWO * cos_sq - third * (sin_sq - mixed),
        third * (sin_sq - mixed),
        third * (mixed + sin_sq + sin_sq),
    ];
    let b_sq = ratio * ratio;
    let over_cube = [
        sin_sq,
        cos_sq,
        sin_sq - mixed,
        mixed,
        cos_sq - b_sq * mixed,
        both.e(),
    ]
    .map(|part| R::TWO * part);
    Some(Closed {
        pole: seen.pole.map(|part| part / seen.rim),
        rim: seen.rim,
        ratio,
        density: pressure.density(),
        bend,
        over_delta,
        over_cube,
    })
}

impl<R: Real> Closed<R> {
    /// As [`EllipseMotion::wrench`].
    #[inline]
    pub fn wrench(&self) -> [R; 3] {
        let [p20, p02, p40, p22, p04] = self.over_delta;
        let [x, y] = self.pole;
        let (x_sq, y_sq) = (x * x, y * y);
        let ahead = p20 - self.bend * (x_sq * p22 + y_sq * p40 - R::TWO * y_sq * p22);
        let aside = p02 - self.bend * (x_sq * p04 + y_sq * p22 - R::TWO * x_sq * p22);
        let [square, fourth] = self.powers();
        let [.., whole] = self.over_cube;
        let torque = whole - (R::ONE + self.bend) * square + self.bend * fourth;
        let order = R::TWO * self.bend + R::TWO;
        [
            self.density * x * ahead,
            self.density * self.ratio * y * aside,
            self.density / order * torque,
        ]
    }

    /// b² ∫t²/Δ³ and b² ∫t⁴/Δ³.
    #[inline]
    fn powers(&self) -> [R; 2] {
        let [q20, q02, q40, q22, q04, _] = self.over_cube;
        let b_sq = self.ratio * self.ratio;
        let [x, y] = self.pole;
        let (x_sq, y_sq) = (x * x, y * y);
        let six = R::from_f64(6.0);
        [
            x_sq * q02 + b_sq * y_sq * q20,
            x_sq * x_sq * q04 + b_sq * y_sq * (six * x_sq * q22 + y_sq * q40),
        ]
    }

    /// As [`EllipseMotion::hessian`].
    pub fn hessian(&self) -> [R; 6] {
        let [q20, q02, q40, q22, q04, _] = self.over_cube;
        let (b, bend) = (self.ratio, self.bend);
        let b_sq = b * b;
        let [x, y] = self.pole;
        let (x_sq, y_sq) = (x * x, y * y);
        let three = R::TWO + R::ONE;
        let [square, fourth] = self.powers();
        let scale = self.density / self.rim;
        [
            q20 - bend * (x_sq * q22 + y_sq * q40),
            R::TWO * bend * b * x * y * q22,
            q02 - bend * (x_sq * q04 + b_sq * y_sq * q22),
            b * y * (bend * (three * x_sq * q22 + y_sq * q40) - q20),
            x * (q02 - bend * (x_sq * q04 + three * b_sq * y_sq * q22)),
            square - bend * fourth,
        ]
        .map(|part| scale * part)
    }
}
