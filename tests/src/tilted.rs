//! An oracle for leaning pressures that shares no code with the kernel: the friction of surface
//! elements, integrated over the patch in two dimensions.
//!
//! Elements lie on rays from the centre of rotation if that is on the patch, otherwise around the
//! patch's own centre, so that the integrands are always smooth and the rules
//! (Gauss–Legendre along the rays, trapezoid around) converge geometrically.

/// The integrand: pressure (1−r²)^`order` with unit load, leaning by `gradient`, and the law |u|^`alpha`.
#[derive(Clone, Copy, Debug)]
pub struct Tilted {
    /// Order q of the pressure: −1 (the ring), 0, 1/2 or 1.
    pub order: f64,
    /// Exponent of the law, a multiple of 1/2.
    pub alpha: f64,
    /// Gradient l, per radius, in the frame of the velocity.
    pub gradient: [f64; 2],
}

/// Directions of the trapezoid rule.
const DIRECTIONS: usize = 256;
/// Nodes along a ray.
const NODES: usize = 48;

impl Tilted {
    /// Force (x, y) and torque of the friction on a patch of radius 1 with coefficient 1.
    ///
    /// *Domain*: spin ≠ 0. For order −1 the rotation centre must be off the rim, for 1/2 outside the
    /// patch, otherwise anywhere except within 1/5 of the rim, where digits are lost.
    pub fn wrench(&self, velocity: [f64; 2], spin: f64) -> [f64; 3] {
        let center = [-velocity[1] / spin, velocity[0] / spin];
        let nodes = gauss_legendre(NODES);
        let mut sum = [0.0; 3];
        for n in 0..DIRECTIONS {
            let angle = (n as f64 + 0.5) * std::f64::consts::TAU / DIRECTIONS as f64;
            let direction = [angle.cos(), angle.sin()];
            for (position, weight) in self.ray(&nodes, center, direction) {
                let element = self.element(position, center, spin);
                for (sum, x) in sum.iter_mut().zip(element) {
                    *sum += weight / DIRECTIONS as f64 * x;
                }
            }
        }
        sum
    }

    /// Positions along one ray with their shares of 2π times the upright load per unit angle.
    fn ray(
        &self,
        nodes: &[(f64, f64)],
        center: [f64; 2],
        direction: [f64; 2],
    ) -> Vec<([f64; 2], f64)> {
        let [cx, cy] = center;
        let [dx, dy] = direction;
        if self.order == -1.0 {
            return vec![(direction, 1.0)];
        }
        let nodes = nodes.iter().copied();
        let load = 2.0 * (self.order + 1.0);
        let c_sq = cx * cx + cy * cy;
        if c_sq < 1.0 {
            // From the centre of rotation to the rim: s = S t^2 removes the singular powers of s.
            let along = cx * dx + cy * dy;
            let length = (along * along + 1.0 - c_sq).sqrt() - along;
            return nodes
                .map(|(t, weight)| {
                    let s = length * t * t;
                    let at = [cx + s * dx, cy + s * dy];
                    let inside = 1.0 - at[0] * at[0] - at[1] * at[1];
                    let pressure = load * inside.powf(self.order);
                    (at, weight * 2.0 * length * t * s * pressure)
                })
                .collect();
        }
        // Around the middle: r^2 = 1 - t^2 removes the singular power of 1 - r^2.
        nodes
            .map(|(t, weight)| {
                let r = (1.0 - t * t).sqrt();
                let pressure = load * t.powf(2.0 * self.order);
                ([r * dx, r * dy], weight * t * pressure)
            })
            .collect()
    }

    /// Force and torque of one element under its share of the load.
    fn element(&self, [x, y]: [f64; 2], [cx, cy]: [f64; 2], spin: f64) -> [f64; 3] {
        let [ux, uy] = [-spin * (y - cy), spin * (x - cx)];
        let speed = ux.hypot(uy);
        let lean = 1.0 + self.gradient[0] * x + self.gradient[1] * y;
        let drag = -lean * speed.powf(self.alpha - 1.0);
        let [fx, fy] = [drag * ux, drag * uy];
        [fx, fy, x * fy - y * fx]
    }
}

/// Nodes and weights on [0, 1], by Newton's method on Legendre's polynomials.
fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let order = count as f64;
    (0..count)
        .map(|n| {
            let mut x = (std::f64::consts::PI * (n as f64 + 0.75) / (order + 0.5)).cos();
            let mut slope = 0.0;
            for _ in 0..8 {
                let (mut before, mut value) = (1.0, x);
                for k in 2..=count {
                    let k = k as f64;
                    (before, value) = (
                        value,
                        ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
                    );
                }
                slope = order * (x * value - before) / (x * x - 1.0);
                x -= value / slope;
            }
            (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_integrates_powers() {
        for power in [0, 1, 2, 15, 80] {
            let sum: f64 = gauss_legendre(NODES)
                .iter()
                .map(|(x, w)| w * x.powi(power))
                .sum();
            let wanted = 1.0 / (f64::from(power) + 1.0);
            assert!((sum - wanted).abs() < 1e-15, "{power}: {sum}");
        }
    }

    #[test]
    fn linear_friction_has_its_moments() {
        // u is linear: F = -(v + omega x <r>), T = -omega <r^2> - ..., with <x> = l_x <r^2>/2.
        for (order, mean_square) in [(-1.0, 1.0), (0.0, 0.5), (0.5, 0.4), (1.0, 1.0 / 3.0)] {
            let tilted = Tilted {
                order,
                alpha: 1.0,
                gradient: [0.3, -0.2],
            };
            let [fx, fy, torque] = tilted.wrench([1.5, 0.5], 1.0);
            let [x, y] = [0.3, -0.2].map(|l| 0.5 * l * mean_square);
            let wanted = [-(1.5 - y), -(0.5 + x), -(mean_square + x * 0.5 - y * 1.5)];
            for (got, wanted) in [fx, fy, torque].into_iter().zip(wanted) {
                assert!(
                    (got - wanted).abs() < 1e-13,
                    "order {order}: {got} {wanted}"
                );
            }
        }
    }
}
