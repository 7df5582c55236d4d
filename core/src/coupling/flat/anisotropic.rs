//! Friction that differs along two axes: isotropic friction of the stretched patch.

use super::motion::Motion;
use super::{Hessian, PatchShape, PointLoad, Reduced};
use crate::patch::anisotropic::AnisotropicPatch;
use crate::real::Real;
use nalgebra::Vector2;

impl<R: Real, P> AnisotropicPatch<R, P> {
    /// Parts along the axis and across it.
    #[inline(always)]
    fn parts(&self, v: &Vector2<R>) -> [R; 2] {
        let e = &self.axis;
        [e.x * v.x + e.y * v.y, e.x * v.y - e.y * v.x]
    }

    /// The vector with these parts.
    #[inline(always)]
    fn joined(&self, [along, across]: [R; 2]) -> Vector2<R> {
        let e = &self.axis;
        Vector2::new(along * e.x - across * e.y, along * e.y + across * e.x)
    }

    /// The motion of the stretched patch.
    #[inline(always)]
    fn motion(&self, motion: &Motion<R>) -> Motion<R> {
        let ([along, across], [v, w]) = (self.parts(&motion.velocity), self.shares);
        Motion {
            velocity: Vector2::new(v * along, w * across),
            rim: motion.rim * self.inner,
        }
    }

    #[inline(always)]
    fn friction(&self, stretched: &Reduced<R>) -> Reduced<R> {
        let [along, across] = self.shares;
        Reduced {
            force: self.joined([along * stretched.force.x, across * stretched.force.y]),
            torque: stretched.torque * self.inner,
        }
    }

    fn hessian(&self, stretched: &Hessian<R>) -> Hessian<R> {
        let [v, w] = self.shares;
        let [xx, xy, yy] = [
            stretched.xx * v * v,
            stretched.xy * v * w,
            stretched.yy * w * w,
        ];
        let mixed = self.joined([stretched.xn * v, stretched.yn * w]) * self.inner;
        // Turned back to the coordinates of the patch.
        let first = self.joined([xx, xy]);
        let second = self.joined([xy, yy]);
        let columns = [
            self.joined([first.x, second.x]),
            self.joined([first.y, second.y]),
        ];
        Hessian {
            xx: columns[0].x,
            xy: columns[0].y,
            yy: columns[1].y,
            xn: mixed.x,
            yn: mixed.y,
            nn: stretched.nn * self.inner * self.inner,
        }
    }
}

impl<R: Real, P: PatchShape<R>> PatchShape<R> for AnisotropicPatch<R, P> {
    fn centre(&self) -> Vector2<R> {
        self.centre
    }

    fn radius(&self) -> R {
        self.radius
    }

    fn rounding(&self) -> R {
        self.stretched.rounding()
    }

    #[inline]
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        let motion = self.motion(motion);
        if motion.is_rest() {
            return Reduced::none();
        }
        self.friction(&self.stretched.reduced(&motion))
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        let motion = self.motion(motion);
        if motion.is_rest() {
            return (Reduced::none(), Hessian::none());
        }
        let (reduced, hessian) = self.stretched.reduced_with_hessian(&motion);
        (self.friction(&reduced), self.hessian(&hessian))
    }

    fn nearest_point(&self, place: &Vector2<R>) -> Option<PointLoad<R>> {
        let ([along, across], [v, w]) = (self.parts(place), self.shares);
        let inv = R::ONE / self.inner;
        let there = Vector2::new(w * along * inv, v * across * inv);
        let PointLoad { place, share } = self.stretched.nearest_point(&there)?;
        let place = self.joined([place.x / w * self.inner, place.y / v * self.inner]);
        Some(PointLoad { place, share })
    }
}

#[cfg(test)]
mod tests {
    use crate::coupling::flat::ShapeFriction;
    use crate::patch::affine_image::AffineImage;
    use crate::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
    use crate::patch::mesh::{Mesh, Vertex};
    use crate::patch::nodes::{Node, Nodes};
    use crate::patch::outline::Polygon;
    use crate::patch::points::PointPatch;
    use crate::twist::{Twist, Wrench};

    const MU: [f64; 2] = [0.3, 0.9];
    const AXIS: [f64; 2] = [0.8, 0.6];
    const LOAD: f64 = 7.0;

    fn friction<P: AffineImage<f64>>(
        patch: P,
        mu: [f64; 2],
    ) -> ShapeFriction<f64, AnisotropicPatch<f64, P>> {
        let coefficients = AxisCoefficients::new(mu, AXIS).unwrap();
        let patch = AnisotropicPatch::new(patch, coefficients).unwrap();
        ShapeFriction::new(patch, coefficients.largest()).unwrap()
    }

    /// Nodes and weights of Gauss's rule on −1 to 1, by Newton's method on the Legendre polynomial.
    fn gauss<const N: usize>() -> [[f64; 2]; N] {
        core::array::from_fn(|i| {
            let mut x = libm::cos(core::f64::consts::PI * (i as f64 + 0.75) / (N as f64 + 0.5));
            let mut slope = 0.0;
            for _ in 0..60 {
                let (mut p, mut before) = (x, 1.0);
                for n in 2..=N {
                    let n = n as f64;
                    (p, before) = (((2.0 * n - 1.0) * x * p - (n - 1.0) * before) / n, p);
                }
                slope = N as f64 * (x * p - before) / (x * x - 1.0);
                x -= p / slope;
            }
            [x, 2.0 / ((1.0 - x * x) * slope * slope)]
        })
    }

    /// What the definition gives at one place under one newton.
    fn at_place([x, y]: [f64; 2], mu: [f64; 2], twist: &Twist<f64>) -> Wrench<f64> {
        let (u, w) = (
            twist.velocity.x - twist.spin * y,
            twist.velocity.y + twist.spin * x,
        );
        let [e, f] = AXIS;
        let (along, across) = (u * e + w * f, w * e - u * f);
        let speed = libm::hypot(mu[0] * along, mu[1] * across);
        let (along, across) = (
            -mu[0] * mu[0] * along / speed,
            -mu[1] * mu[1] * across / speed,
        );
        let (fx, fy) = (along * e - across * f, along * f + across * e);
        Wrench::new(fx, fy, x * fy - y * fx)
    }

    fn near(found: &Wrench<f64>, expected: &Wrench<f64>, within: f64) {
        let off = *found - *expected;
        let off = off.force.amax().max(off.torque.abs());
        assert!(off < within, "{found:?} {expected:?} {off:e}");
    }

    /// Twists whose centre of rotation lies outside of a box of sides 0.6 and 0.4.
    const TWISTS: [[f64; 3]; 5] = [
        [0.1, 0.2, 0.0],
        [0.1, -0.8, 1.0],
        [1.0, 0.1, -0.7],
        [-0.3, 3.0, 0.2],
        [0.0, 1.0, -1.5],
    ];

    #[test]
    fn a_box_has_the_friction_of_its_definition() {
        let corners = [[-0.3, -0.2], [0.3, -0.2], [0.3, 0.2], [-0.3, 0.2]];
        let slope = [0.9, -1.2];
        let even = Polygon::new(corners).unwrap();
        let leaning = even.with_slope(slope).unwrap();
        let vertex = |[x, y]: [f64; 2]| Vertex {
            x,
            y,
            pressure: 1.0 + slope[0] * x + slope[1] * y,
        };
        let [a, b, c, d] = corners.map(vertex);
        let mesh = Mesh::new([[a, b, c], [a, c, d]]).unwrap();
        let rule = gauss::<40>();
        for mu in [MU, [0.9, 0.3], [0.9, 0.05]] {
            for twist in TWISTS.map(|[x, y, n]| Twist::new(x, y, n)) {
                let (mut same, mut lean) = (Wrench::ZERO, Wrench::ZERO);
                for [x, dx] in rule {
                    for [y, dy] in rule {
                        let place = [0.3 * x, 0.2 * y];
                        let part = at_place(place, mu, &twist) * (0.25 * dx * dy * LOAD);
                        same += part;
                        lean += part * (1.0 + slope[0] * place[0] + slope[1] * place[1]);
                    }
                }
                near(&friction(even, mu).wrench(LOAD, &twist), &same, 2e-13);
                near(&friction(leaning, mu).wrench(LOAD, &twist), &lean, 2e-13);
                near(&friction(mesh, mu).wrench(LOAD, &twist), &lean, 2e-13);
            }
        }
    }

    #[test]
    fn points_have_the_friction_of_their_definition() {
        let places = [[0.1, 0.3], [-0.2, 0.05], [0.15, -0.3], [-0.1, -0.25]];
        let nodes = Nodes::new(places.map(|[x, y]| Node { x, y, weight: 1.0 })).unwrap();
        let feet = friction(PointPatch::new(nodes).unwrap(), MU);
        for twist in TWISTS.map(|[x, y, n]| Twist::new(x, y, n)) {
            let mut sum = Wrench::ZERO;
            for place in places {
                sum += at_place(place, MU, &twist) * (0.25 * LOAD);
            }
            near(&feet.wrench(LOAD, &twist), &sum, 1e-14);
        }
    }

    #[test]
    fn the_jacobian_is_the_slope_of_the_wrench() {
        let corners = [[-0.3, -0.2], [0.5, -0.1], [0.3, 0.2], [-0.2, 0.3]];
        let friction = friction(Polygon::new(corners).unwrap(), MU);
        for twist in TWISTS.map(|[x, y, n]| Twist::new(x, y, n)) {
            let (_, jacobian) = friction.wrench_and_jacobian(LOAD, &twist);
            for column in 0..3 {
                let mut step = [0.0; 3];
                step[column] = 1e-5;
                let step = Twist::new(step[0], step[1], step[2]);
                let [more, less] =
                    [twist + step, twist - step].map(|at| friction.wrench(LOAD, &at));
                let slope = (more - less) * (0.5 / 1e-5);
                let found = jacobian.column(column);
                near(&slope, &Wrench::new(found[0], found[1], found[2]), 1e-6);
            }
        }
    }
}
