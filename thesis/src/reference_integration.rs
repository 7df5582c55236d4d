//! Bodies on many points, summed and stepped in the plainest way: an oracle that shares no code with
//! the kernel.

use std::f64::consts::TAU;

/// Points that share the load: place in radii of the contact, and share.
#[derive(Debug, Clone)]
pub struct Points(Vec<[f64; 3]>);

/// Runge–Kutta step, as a share of the time in which the present speed would fade.
const STEP: f64 = 0.02;
/// A body below this fraction of its launch speed has arrived.
const SLOW: f64 = 1e-5;

/// Time, place and angle at rest, in radii and radians, and the last velocity ratio.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    pub time: f64,
    pub place: [f64; 2],
    pub angle: f64,
    pub ratio: f64,
}

impl Points {
    /// A thin ring.
    pub fn ring(count: usize) -> Self {
        let share = 1.0 / count as f64;
        let on = |i: usize| TAU * (i as f64 + 0.5) * share;
        let points = (0..count).map(|i| [on(i).cos(), on(i).sin(), share]);
        Self(points.collect())
    }

    /// A disk under uniform pressure: rings of equal width, alike on both sides of the x axis.
    pub fn disk(rings: usize, angles: usize) -> Self {
        let place = |i: usize, j: usize| {
            let radius = (i as f64 + 0.5) / rings as f64;
            let angle = TAU * (j as f64 + 0.5) / angles as f64;
            let share = 2.0 * radius / (rings * angles) as f64;
            [radius * angle.cos(), radius * angle.sin(), share]
        };
        let points = (0..rings).flat_map(|i| (0..angles).map(move |j| place(i, j)));
        Self(points.collect())
    }

    /// Force along x and y and torque, for |u|^α against the velocity u of every point and the
    /// pressure p (1 + l·r). The velocity is (v_x, v_y, ωR).
    pub fn friction(&self, [vx, vy, w]: [f64; 3], alpha: f64, [lx, ly]: [f64; 2]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for &[x, y, share] in &self.0 {
            let (ux, uy) = (vx - w * y, vy + w * x);
            let speed = ux.hypot(uy);
            if speed == 0.0 {
                continue;
            }
            let per_speed = if alpha == 0.0 {
                1.0 / speed
            } else {
                speed.powf(alpha - 1.0)
            };
            let pull = share * (1.0 + lx * x + ly * y) * per_speed;
            let force = [-pull * ux, -pull * uy];
            sum[0] += force[0];
            sum[1] += force[1];
            sum[2] += x * force[1] - y * force[0];
        }
        sum
    }

    /// The same under the gradient of a raised centre of mass.
    pub fn leaning(&self, velocity: [f64; 3], alpha: f64, lean: f64) -> [f64; 3] {
        self.friction(velocity, alpha, self.gradient(velocity, alpha, lean))
    }

    /// The gradient that bears the moment of friction about a raised centre of mass: l = −λ times
    /// the force.
    pub fn gradient(&self, velocity: [f64; 3], alpha: f64, lean: f64) -> [f64; 2] {
        let level = self.friction(velocity, alpha, [0.0; 2]);
        let by = |gradient| {
            let all = self.friction(velocity, alpha, gradient);
            [all[0] - level[0], all[1] - level[1]]
        };
        let ([xx, yx], [xy, yy]) = (by([1.0, 0.0]), by([0.0, 1.0]));
        // (1 + λ ∂force/∂l) l = −λ force
        let [a, b] = [1.0 + lean * xx, lean * xy];
        let [c, d] = [lean * yx, 1.0 + lean * yy];
        let [p, q] = [-lean * level[0], -lean * level[1]];
        let whole = a * d - b * c;
        [(d * p - b * q) / whole, (a * q - c * p) / whole]
    }

    /// F against the velocity and T against the spin at v = ε, ωR = 1.
    pub fn reduced(&self, alpha: f64, ratio: f64) -> [f64; 2] {
        let [along, _, torque] = self.friction([ratio, 0.0, 1.0], alpha, [0.0; 2]);
        [-along, -torque]
    }
}

/// Follows dv/dt = force, C dw/dt = torque to rest.
pub fn to_rest(
    friction: impl Fn([f64; 3]) -> [f64; 3],
    alpha: f64,
    inertia_ratio: f64,
    launch: [f64; 3],
) -> Stop {
    slowed(friction, [alpha, inertia_ratio], launch, SLOW)
}

/// Follows the motion until the speeds have fallen to this fraction of the launch.
pub fn slowed(
    friction: impl Fn([f64; 3]) -> [f64; 3],
    [alpha, inertia_ratio]: [f64; 2],
    launch: [f64; 3],
    fraction: f64,
) -> Stop {
    let size = |[vx, vy, w, ..]: [f64; 6]| vx.hypot(vy).hypot(w);
    // (v_x, v_y, w, x, y, angle)
    let rate = |[vx, vy, w, ..]: [f64; 6]| {
        let [fx, fy, torque] = friction([vx, vy, w]);
        [fx, fy, torque / inertia_ratio, vx, vy, w]
    };
    let mut state = [launch[0], launch[1], launch[2], 0.0, 0.0, 0.0];
    let (start, mut time) = (size(state), 0.0);
    while size(state) > fraction * start {
        let step = STEP * size(state).powf(1.0 - alpha);
        state = runge_kutta(state, step, rate);
        time += step;
    }
    let [vx, vy, w, x, y, angle] = state;
    Stop {
        time,
        place: [x, y],
        angle,
        ratio: vx.hypot(vy) / w.abs(),
    }
}

/// The classical step of fourth order.
fn runge_kutta(state: [f64; 6], step: f64, rate: impl Fn([f64; 6]) -> [f64; 6]) -> [f64; 6] {
    let moved = |by: f64, rates: [f64; 6]| std::array::from_fn(|i| state[i] + by * rates[i]);
    let first = rate(state);
    let second = rate(moved(0.5 * step, first));
    let third = rate(moved(0.5 * step, second));
    let fourth = rate(moved(step, third));
    std::array::from_fn(|i| {
        state[i] + step / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i])
    })
}
