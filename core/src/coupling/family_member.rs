//! One pressure of the family (1−r²)^q under |u|^α: its hypergeometric functions.
//!
//! With n = q + (3+α)/2 and K = n T(0),
//!
//! ```text
//! v ≤ w:  Φ = K ₂F₁((1−α)/2, −(1+α)/2 − q; 2; x)
//! v > w:  Φ =   ₂F₁((1−α)/2, −(1+α)/2; q+2; x)
//! ```
//!
//! The two meet at x = 1, which fixes K without a Γ function. For q = 0 they are one function.

use super::half_octave_table::{CompanionFunction, Pair};
use crate::special::Gauss;

/// Exponent and order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FamilyMember {
    pub alpha: f64,
    pub order: f64,
}

impl FamilyMember {
    /// 1/n = T(0)/F'(0).
    pub const fn inv_moment(&self) -> f64 {
        1.0 / (self.order + 0.5 * (3.0 + self.alpha))
    }

    /// Where spinning leads.
    pub const fn spinning(&self) -> Pair {
        let Self { alpha, order } = *self;
        let gauss = Gauss::new(0.5 * (1.0 - alpha), -0.5 * (1.0 + alpha) - order, 2.0);
        let scale = if order == 0.0 {
            1.0
        } else {
            self.sliding().gauss.at(1.0, 0.0).value / gauss.at(1.0, 0.0).value
        };
        self.pair(gauss, scale, CompanionFunction::Blend)
    }

    /// Where sliding leads.
    pub const fn sliding(&self) -> Pair {
        let Self { alpha, order } = *self;
        let gauss = Gauss::new(0.5 * (1.0 - alpha), -0.5 * (1.0 + alpha), order + 2.0);
        self.pair(gauss, 1.0, CompanionFunction::Theta)
    }

    const fn pair(&self, gauss: Gauss, scale: f64, partner: CompanionFunction) -> Pair {
        Pair {
            gauss,
            scale,
            alpha: self.alpha,
            inv_moment: self.inv_moment(),
            partner,
        }
    }
}
