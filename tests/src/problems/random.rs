//! Random contact problems of five kinds.

use super::builder::Builder;
use nalgebra::{Rotation3, Vector3, Vector6};
use tribos::problem::{ContactComponents, ContactThresholds, Friction, GlobalProblem};
use tribos::random::Random;

/// Names of the kinds; the number of a problem selects its kind in turn.
pub const KINDS: [&str; 5] = ["packing", "arch", "wedge", "grasp", "tower"];

/// Problem `number`: its kind and itself, the same on every machine.
///
/// A quarter of all thresholds is zero; some contacts are cohesive, some have an ellipsoid for sliding and
/// torsion; masses differ by up to 1e4.
pub fn random(number: u64) -> (&'static str, GlobalProblem) {
    let mut draw = Draw(Random::new(number, 23));
    let layouts = [2, 3, 4, 5, 6].map(|size| ContactComponents::of_size(size).expect("a layout"));
    let layout = layouts[(number / KINDS.len() as u64) as usize % layouts.len()];
    let kind = (number % KINDS.len() as u64) as usize;
    let problem = match kind {
        0 => packing(&mut draw, layout),
        1 => arch(&mut draw, layout),
        2 => wedge(&mut draw, layout),
        3 => grasp(&mut draw, layout),
        _ => tower(&mut draw, layout),
    };
    (KINDS[kind], problem)
}

/// Draws from a seeded stream.
struct Draw(Random);

impl Draw {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.unit()
    }

    fn count(&mut self, low: usize, high: usize) -> usize {
        self.within(low as f64, (high + 1) as f64) as usize
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.within(-1.0, 1.0))
    }

    /// Mass of a body, and its moment of inertia at a radius.
    fn mass(&mut self, radius: f64) -> (f64, f64) {
        let mass = 10.0_f64.powi(self.count(0, 4) as i32 - 2) * self.within(0.5, 2.0);
        (mass, 0.4 * mass * radius * radius)
    }

    fn threshold(&mut self, most: f64) -> f64 {
        if self.0.unit() < 0.25 {
            0.0
        } else {
            self.within(0.0, most)
        }
    }

    fn law(&mut self) -> ContactThresholds {
        ContactThresholds {
            sliding: self.threshold(1.2),
            rolling: self.threshold(0.3),
            torsion: self.threshold(0.3),
            cohesion: (self.within(-0.4, 0.1)).max(0.0),
            friction: if self.0.unit() < 0.3 {
                Friction::Ellipsoid
            } else {
                Friction::Separate
            },
        }
    }
}

/// A fall under gravity, with some motion of its own.
fn falling(draw: &mut Draw) -> Vector6<f64> {
    let (velocity, spin) = (draw.vector() * 0.3 - Vector3::z(), draw.vector() * 0.3);
    Vector6::new(velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z)
}

/// Spheres that overlap a little, between fixed walls.
fn packing(draw: &mut Draw, layout: ContactComponents) -> GlobalProblem {
    let mut builder = Builder::new(layout);
    let count = draw.count(3, 20);
    let side = 1.6 * (count as f64).cbrt();
    let mut places = Vec::new();
    for _ in 0..count {
        let place = draw.vector() * (0.5 * side);
        let (mass, motion) = (draw.mass(1.0), falling(draw));
        builder.body(place, mass, motion);
        places.push(place);
    }
    for a in 0..count {
        for b in 0..a {
            let apart = places[b] - places[a];
            if apart.norm() < 2.0 {
                let point = places[a] + 0.5 * apart;
                builder.contact([Some(a), Some(b)], (point, apart), draw.law());
            }
        }
        for axis in 0..3 {
            if places[a][axis] < 0.8 - 0.5 * side {
                let up = Vector3::ith(axis, 1.0);
                builder.contact([None, Some(a)], (places[a] - up, up), draw.law());
            }
        }
    }
    builder.finish()
}

/// Blocks between two fixed springers, with four contacts at each joint.
fn arch(draw: &mut Draw, layout: ContactComponents) -> GlobalProblem {
    let mut builder = Builder::new(layout);
    let count = draw.count(3, 9);
    let (law, thickness) = (draw.law(), draw.within(0.2, 0.6));
    let step = std::f64::consts::PI / count as f64;
    let radial = |angle: f64| {
        let turned = Rotation3::from_axis_angle(&Vector3::y_axis(), -angle);
        turned * Vector3::x()
    };
    for block in 0..count {
        let place = radial((block as f64 + 0.5) * step);
        let (mass, motion) = (draw.mass(0.3), Vector6::new(0.0, 0.0, -1.0, 0.0, 0.0, 0.0));
        builder.body(place, mass, motion + 0.1 * falling(draw));
    }
    for joint in 0..=count {
        let out = radial(joint as f64 * step);
        let along = out.cross(&Vector3::y());
        let before = joint.checked_sub(1);
        let after = (joint < count).then_some(joint);
        for (side, height) in [(-1.0, -0.5), (-1.0, 0.5), (1.0, -0.5), (1.0, 0.5)] {
            let point = out * (1.0 + height * thickness) + Vector3::y() * (0.2 * side);
            builder.contact([before, after], (point, along), law);
        }
    }
    builder.finish()
}

/// A body between two fixed walls that lean against it.
fn wedge(draw: &mut Draw, layout: ContactComponents) -> GlobalProblem {
    let mut builder = Builder::new(layout);
    let (mass, motion) = (draw.mass(1.0), falling(draw));
    let body = builder.body(Vector3::zeros(), mass, motion);
    for side in [-1.0, 1.0] {
        let lean = draw.within(-0.3, 1.2);
        let wall = Vector3::new(-side * libm::cos(lean), 0.0, libm::sin(lean));
        for _ in 0..draw.count(1, 4) {
            let point = -wall + 0.5 * draw.vector();
            builder.contact([None, Some(body)], (point, wall), draw.law());
        }
    }
    builder.finish()
}

/// A body that fingers, themselves free, press from all sides.
fn grasp(draw: &mut Draw, layout: ContactComponents) -> GlobalProblem {
    let mut builder = Builder::new(layout);
    let (mass, motion) = (draw.mass(1.0), falling(draw));
    let body = builder.body(Vector3::zeros(), mass, motion);
    for _ in 0..draw.count(2, 6) {
        let inwards = -draw.vector().normalize();
        let push = inwards * draw.within(0.0, 3.0);
        let motion = Vector6::new(push.x, push.y, push.z, 0.0, 0.0, 0.0);
        let finger = builder.body(-2.0 * inwards, draw.mass(0.5), motion);
        for _ in 0..draw.count(1, 3) {
            let point = -inwards + 0.1 * draw.vector();
            builder.contact([Some(finger), Some(body)], (point, inwards), draw.law());
        }
    }
    builder.finish()
}

/// Blocks on each other on the ground, four contacts between two of them.
fn tower(draw: &mut Draw, layout: ContactComponents) -> GlobalProblem {
    let mut builder = Builder::new(layout);
    for block in 0..draw.count(2, 8) {
        let (mass, motion) = (draw.mass(0.7), falling(draw));
        let above = builder.body(Vector3::z() * (block as f64 + 0.5), mass, motion);
        let law = draw.law();
        for (x, y) in [(-0.5, -0.5), (-0.5, 0.5), (0.5, -0.5), (0.5, 0.5)] {
            let point = Vector3::new(x, y, block as f64);
            let below = block.checked_sub(1);
            builder.contact([below, Some(above)], (point, Vector3::z()), law);
        }
    }
    builder.finish()
}
