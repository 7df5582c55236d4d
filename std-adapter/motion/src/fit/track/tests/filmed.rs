//! Films of a disk whose motion is integrated apart from the library: its force and torque are integrals over rays,
//! tabulated over the ratio of the speeds, and its motion is that of small Runge–Kutta steps.

use super::super::Track;
use std::sync::LazyLock;
use tribos_base::random::Random;

/// Directions of the integral, and places of the table.
const DIRECTIONS: usize = 720;
const PLACES: usize = 4000;
/// Steps between two frames.
const STEPS: usize = 60;
pub const GRAVITY: f64 = 9.81;
/// Frames per second.
pub const RATE: f64 = 60.0;

/// Force and torque over μN and μNR at w/(v + w) = k/PLACES.
pub struct Disk(Vec<[f64; 2]>);

/// The table of all films.
pub static DISK: LazyLock<Disk> = LazyLock::new(Disk::new);

impl Disk {
    fn new() -> Self {
        let at = |k: usize| {
            let w = k as f64 / PLACES as f64;
            if k == 0 {
                [1.0, 0.0]
            } else {
                wrench((1.0 - w) / w)
            }
        };
        Self((0..=PLACES).map(at).collect())
    }

    fn wrench(&self, v: f64, w: f64) -> [f64; 2] {
        let place = PLACES as f64 * w / (v + w);
        let k = (place as usize).min(PLACES - 1);
        let share = place - k as f64;
        [0, 1].map(|i| (1.0 - share) * self.0[k][i] + share * self.0[k + 1][i])
    }

    /// Distance and angle at the frames.
    fn motion(&self, body: &Filmed, frames: usize) -> Vec<[f64; 2]> {
        let h = 1.0 / (RATE * STEPS as f64);
        let kappa = body.mu * GRAVITY;
        let rate = |[v, w]: [f64; 2]| {
            let [force, torque] = self.wrench(v.max(0.0), w.max(0.0));
            [-kappa * force, -2.0 * kappa * torque]
        };
        let moved = |at: [f64; 2], by: [f64; 2], h: f64| [at[0] + h * by[0], at[1] + h * by[1]];
        let (mut at, mut path) = ([body.speed, body.spin.abs() * body.radius], [0.0; 2]);
        let mut seen = vec![path];
        for _ in 1..frames {
            for _ in 0..STEPS {
                if at[0] + at[1] < 2.0 * kappa * h {
                    at = [0.0; 2];
                    continue;
                }
                let a = rate(at);
                let b = rate(moved(at, a, 0.5 * h));
                let c = rate(moved(at, b, 0.5 * h));
                let d = rate(moved(at, c, h));
                let mean = [0, 1].map(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
                let next = moved(at, mean, h).map(|x| x.max(0.0));
                for i in 0..2 {
                    path[i] += 0.5 * h * (at[i] + next[i]) + h * h * (a[i] - d[i]) / 12.0;
                }
                at = next;
            }
            seen.push([path[0], path[1] / body.radius * body.spin.signum()]);
        }
        seen
    }

    /// Frames from launch to some frames after the stop.
    pub fn film(&self, body: &Filmed, random: &mut Random, has_angle: bool) -> Track {
        let longest =
            (RATE * (body.speed + body.spin.abs() * body.radius) / (body.mu * GRAVITY)) as usize;
        let path = self.motion(body, 3 * longest + 20);
        let end = path.last().map_or(0.0, |last| last[0]);
        let stop = path
            .iter()
            .position(|at| at[0] >= end)
            .unwrap_or(path.len());
        let frames = &path[..(stop + 10).min(path.len())];
        let times = (0..frames.len()).map(|k| 1.5 + k as f64 / RATE).collect();
        let (sin, cos) = (body.direction.sin(), body.direction.cos());
        let [position, turn] = body.noise;
        let x = frames
            .iter()
            .map(|at| 0.3 + cos * at[0] + position * normal(random));
        let x = x.collect();
        let y = frames
            .iter()
            .map(|at| -0.2 + sin * at[0] + position * normal(random));
        let y = y.collect();
        let angle = frames.iter().map(|at| 0.7 + at[1] + turn * normal(random));
        let angle: Vec<f64> = angle.collect();
        Track::new(times, x, y, has_angle.then_some(angle)).unwrap()
    }
}

/// Force and torque of a disk of radius 1 that turns about a point at the distance d from its centre.
///
/// In polar coordinates about that point all elements of a ray slide across it. A ray at the angle φ is inside the disk
/// between ρ = −d cos φ ± √(1 − d² sin² φ), and force and torque about the centre are
/// ∫ −cos φ ρ²/2 dφ/π and ∫ (d cos φ ρ²/2 + ρ³/3) dφ/π between these bounds.
fn wrench(d: f64) -> [f64; 2] {
    let step = std::f64::consts::TAU / DIRECTIONS as f64;
    let mut sums = [0.0; 2];
    for k in 0..DIRECTIONS {
        let turned = (k as f64 + 0.5) * step;
        // From outside, rays meet the disk where d sin φ = sin θ, twice for each θ of a half turn.
        let (cos, half, weight) = if d <= 1.0 {
            let (sin, cos) = turned.sin_cos();
            (cos, (1.0 - d * d * sin * sin).sqrt(), 1.0)
        } else {
            let (sin, half) = turned.sin_cos();
            let cos = -(1.0 - sin * sin / (d * d)).sqrt();
            (cos, half.abs(), 0.5 * half.abs() / (d * cos.abs()))
        };
        let far = -d * cos + half;
        let near = if d <= 1.0 { 0.0 } else { -d * cos - half };
        let (square, cube) = (
            far * far - near * near,
            far * far * far - near * near * near,
        );
        sums[0] -= weight * cos * square / 2.0;
        sums[1] += weight * (d * cos * square / 2.0 + cube / 3.0);
    }
    sums.map(|sum| sum * step / std::f64::consts::PI)
}

/// A disk and its launch.
#[derive(Clone, Copy, Debug)]
pub struct Filmed {
    pub mu: f64,
    pub radius: f64,
    pub speed: f64,
    pub direction: f64,
    pub spin: f64,
    /// Of a coordinate in m, and of the angle in rad.
    pub noise: [f64; 2],
}

impl Filmed {
    /// 0.5 to 3 m/s, μ 0.05 to 0.5, R 2 to 5 cm, ratios of speed to rim speed from 0.2 to 5; 1 mm and 1 degree.
    pub fn random(random: &mut Random) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
        let (mu, radius) = (between(0.05, 0.5), between(0.02, 0.05));
        let speed = between(0.5, 3.0);
        let ratio = 5.0_f64.powf(between(-1.0, 1.0));
        let sign = between(-1.0, 1.0).signum();
        Self {
            mu,
            radius,
            speed,
            direction: between(-3.0, 3.0),
            spin: sign * speed / (ratio * radius),
            noise: [1e-3, 1.0_f64.to_radians()],
        }
    }
}

/// A normal deviate (Marsaglia's polar method).
pub fn normal(random: &mut Random) -> f64 {
    loop {
        let [x, y] = [(); 2].map(|()| 2.0 * random.unit() - 1.0);
        let square: f64 = x * x + y * y;
        if square > 0.0 && square < 1.0 {
            return x * (-2.0 * square.ln() / square).sqrt();
        }
    }
}
