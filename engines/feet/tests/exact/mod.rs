//! Where and when thrown bodies come to rest, for the tests of every adapter: the reference answers, and the law by brute
//! force.

/// Coefficient of friction and gravity in m/s² of the scenes `puck` and `ring`, and the radius of these in m.
pub const MU: f32 = 0.3;
pub const GRAVITY: f32 = 9.81;
pub const RADIUS: f32 = 0.08;
/// Gravity in m/s² of the scenes `box` and `plank`, and half their sides in m.
pub const BOX_GRAVITY: f32 = 10.0;
pub const HALF_SIDES: [(&str, [f32; 2]); 2] = [("box", [0.05, 0.05]), ("plank", [0.1, 0.025])];

const SPINS: [f32; 5] = [0.0, 5.0, 12.5, 25.0, 50.0];
/// Scene, spin, quantity, unit, value.
const ANSWERS: &str = include_str!("../../../../tests/answers/v1/answers.csv");

/// How far in metres, and when in seconds, a body comes to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throw {
    pub travel: f64,
    pub stop: f64,
}

impl Throw {
    #[track_caller]
    pub fn assert_near(&self, exact: &Self, tolerance: f64, what: &str) {
        for (is, should) in [(self.travel, exact.travel), (self.stop, exact.stop)] {
            let error = is / should - 1.0;
            assert!(
                error.abs() < tolerance,
                "{what}: {is} for {should}, {error:+.5}"
            );
        }
    }
}

/// The answer for a body that is thrown at 1 m/s.
pub fn answer(scene: &str, spin: f32) -> Throw {
    let of = |quantity: &str| -> f64 {
        let key = format!("{scene},{spin},{quantity},");
        let line = ANSWERS.lines().find(|line| line.starts_with(&key));
        let value = line.and_then(|line| line.rsplit(',').next());
        value
            .and_then(|value| value.parse().ok())
            .expect("an answer")
    };
    Throw {
        travel: of("along_m").hypot(of("left_m")),
        stop: of("stop_s"),
    }
}

/// A body of a scene stops where and when it should, however it spins at first.
#[track_caller]
pub fn assert_stops(scene: &str, tolerance: f64, thrown: impl Fn(f32) -> Throw) {
    for spin in SPINS {
        let what = format!("{scene} at {spin} rad/s");
        thrown(spin).assert_near(&answer(scene, spin), tolerance, &what);
    }
}

/// A body that slides down a slope beyond the friction angle, by `pull` and `hold` in m/s² for and against, gains the
/// difference.
#[track_caller]
pub fn assert_gains(gained: f32, [pull, hold]: [f32; 2], time: f32) {
    let right = (pull - hold) * time;
    assert!(
        (gained / right - 1.0).abs() < 0.01,
        "{gained} m/s for {right}"
    );
}

/// A cell of a body from its centre of mass in metres, and its share of the load.
pub type Cell = ([f64; 2], f64);

/// Cells of a rectangle, `count` along each side, by half its sides in metres.
pub fn rectangle([a, b]: [f64; 2], count: usize) -> Vec<Cell> {
    let at = |k: usize| (2 * k + 1) as f64 / count as f64 - 1.0;
    let share = 1.0 / (count * count) as f64;
    let cell = |k: usize| ([a * at(k / count), b * at(k % count)], share);
    (0..count * count).map(cell).collect()
}

/// A body on `cells` thrown at 1 m/s along its first axis, each cell resisting along its own velocity, in steps of 0.1 ms;
/// `gyration_sq` is inertia over mass in m².
pub fn on_cells(cells: &[Cell], gyration_sq: f64, spin: f32) -> Throw {
    const DT: f64 = 1e-4;
    let limit = f64::from(MU) * f64::from(GRAVITY);
    // In axes that do not turn.
    let slope = |[vx, vy, w]: [f64; 3], angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let mut sum = [0.0; 3];
        for &([x, y], share) in cells {
            let [x, y] = [cos * x - sin * y, sin * x + cos * y];
            let [ux, uy] = [vx - w * y, vy + w * x];
            let size = ux.hypot(uy).max(f64::MIN_POSITIVE);
            let [fx, fy] = [ux, uy].map(|u| -limit * share * u / size);
            sum = [
                sum[0] + fx,
                sum[1] + fy,
                sum[2] + (x * fy - y * fx) / gyration_sq,
            ];
        }
        sum
    };
    let moved = |u: [f64; 3], by: [f64; 3], dt: f64| [0, 1, 2].map(|i| u[i] + by[i] * dt);
    let mut u = [1.0, 0.0, f64::from(spin)];
    let [mut angle, mut x, mut y, mut time] = [0.0_f64; 4];
    while u[0].hypot(u[1]).hypot(gyration_sq.sqrt() * u[2]) > 2.0 * DT * limit {
        let mid = moved(u, slope(u, angle), 0.5 * DT);
        let end = moved(u, slope(mid, angle + 0.5 * DT * u[2]), DT);
        [x, y] = [x + DT * mid[0], y + DT * mid[1]];
        angle += DT * mid[2];
        u = end;
        time += DT;
    }
    Throw {
        travel: x.hypot(y),
        stop: time,
    }
}
