//! The trapezoid rule over the disk: the thesis' own way to evaluate any exponent.
//!
//! With u the velocity of the element at (r, φ),
//! F = ⟨|u|^(α−1) u_x⟩ and T = ⟨|u|^(α−1) (r × u)⟩ over the area. The kink at the centre of
//! rotation keeps the rule at first order: the relative error of F is 1/(2n) as ε → 0.

use core::f64::consts::{PI, TAU};

/// n rings × n angles, nodes made once.
#[derive(Clone, Debug)]
pub struct Trapezoid {
    alpha: f64,
    /// Take a root instead of a power where α = 0 allows it.
    root: bool,
    /// (cos φ, sin φ)
    directions: Vec<[f64; 2]>,
}

impl Trapezoid {
    /// Rule with `n` intervals in each direction for the exponent `alpha`.
    pub fn new(n: usize, alpha: f64) -> Self {
        let angle = |j: usize| TAU * j as f64 / n as f64;
        let directions = (0..n).map(|j| [angle(j).cos(), angle(j).sin()]).collect();
        Self {
            alpha,
            root: alpha == 0.0,
            directions,
        }
    }

    /// The same as a program for any exponent computes it: a power at every node, as the thesis
    /// did, whatever α is.
    pub fn for_any_exponent(n: usize, alpha: f64) -> Self {
        Self {
            root: false,
            ..Self::new(n, alpha)
        }
    }

    /// `[F, T]` for any α > −1; times the power of the speed, as the law has it.
    pub fn wrench(&self, slide: f64, rim: f64) -> [f64; 2] {
        if self.root {
            self.sum(slide, rim, |speed_sq| 1.0 / speed_sq.sqrt())
        } else {
            let exponent = 0.5 * (self.alpha - 1.0);
            self.sum(slide, rim, |speed_sq| speed_sq.powf(exponent))
        }
    }

    /// The double sum; `friction_per_speed` is |u|^(α−1) from |u|².
    fn sum(&self, slide: f64, rim: f64, friction_per_speed: impl Fn(f64) -> f64) -> [f64; 2] {
        let n = self.directions.len();
        let step = 1.0 / n as f64;
        let (mut force, mut torque) = (0.0, 0.0);
        // The centre r = 0 carries no area; the rim carries half a cell.
        for i in 1..=n {
            let r = i as f64 * step;
            let (mut ring_force, mut ring_torque) = (0.0, 0.0);
            for &[cos, sin] in &self.directions {
                let (ux, uy) = (slide - rim * r * sin, rim * r * cos);
                let speed_sq = ux * ux + uy * uy;
                // The centre of rotation itself carries no stress.
                let g = if speed_sq > 0.0 {
                    friction_per_speed(speed_sq)
                } else {
                    0.0
                };
                ring_force += g * ux;
                ring_torque += g * (uy * cos - ux * sin);
            }
            let weight = if i == n { 0.5 * r } else { r };
            force += weight * ring_force;
            torque += weight * r * ring_torque;
        }
        let cell = step * TAU / n as f64 / PI;
        [cell * force, cell * torque]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;

    #[test]
    fn the_rule_converges_for_two_exponents() {
        let [exact, _] = reference::wrench(0.7, 1.0);
        let found = Trapezoid::new(256, 0.0).wrench(0.7, 1.0)[0];
        assert!((found - exact.high).abs() < 1e-3);
        // α = 1 is linear: F = v, T = w/2.
        let [force, torque] = Trapezoid::new(256, 1.0).wrench(0.7, 1.0);
        assert!((force - 0.7).abs() < 1e-4 && (torque - 0.5).abs() < 1e-4);
    }
}
