//! Padé approximants of first and second order.
//!
//! First order: values at ε = 0 and ∞, F'(0) = 1 and T → 1/(4ε). Second order: in addition
//! F''(0) = 0 and no term 1/ε in F, T'(0) = 0 and T''(0)/T(0) = −3/2. The coefficients follow
//! from matching the exact expansions F = ε − ε³/8 …, T = 2/3 (1 − 3ε²/4 …).
//!
//! *Source*: V. F. Zhuravlev, J. Appl. Math. Mech. 62 (1998) 705; A. A. Kireenkov, Mech. Solids 43
//! (2008) 412. Their coefficients may differ in detail for the second order.

use super::PURE_SPIN_TORQUE;

/// T(0) over the coefficient 1/4 of 1/ε at infinity.
const TORQUE_RATIO: f64 = 8.0 / 3.0;
/// −T''(0)/(2 T(0)).
const TORQUE_BEND: f64 = 3.0 / 4.0;
/// Linear coefficient of the torque: bend × 1/4 ÷ T(0).
const TORQUE_LINEAR: f64 = TORQUE_BEND / TORQUE_RATIO;

/// F = v/(v + w), T = ⅔ w/(w + 8v/3).
#[inline]
pub fn first_order(slide: f64, rim: f64) -> [f64; 2] {
    let force = slide / (slide + rim);
    let torque = PURE_SPIN_TORQUE * rim / (rim + TORQUE_RATIO * slide);
    [force, torque]
}

/// F = v(v + w)/(v² + vw + w²), T = ⅔ w(w + 9v/32)/(w² + 9vw/32 + 3v²/4).
#[inline]
pub fn second_order(slide: f64, rim: f64) -> [f64; 2] {
    let force_top = slide * (slide + rim);
    let torque_top = rim * (rim + TORQUE_LINEAR * slide);
    let torque_bottom = torque_top + TORQUE_BEND * slide * slide;
    [
        force_top / (force_top + rim * rim),
        PURE_SPIN_TORQUE * torque_top / torque_bottom,
    ]
}
