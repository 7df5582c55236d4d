//! The law by brute force: Coulomb friction of many small cells, in steps of 0.1 ms.

/// A cell of a body, from its centre of mass.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    pub x: f64,
    pub y: f64,
    /// Friction limit over the body's mass in m/s².
    pub limit: f64,
}

/// Cells of a rectangle, `count` along each side.
pub fn rectangle(half: [f64; 2], count: usize, deceleration: f64) -> Vec<Cell> {
    let at = |k: usize| (2 * k + 1) as f64 / count as f64 - 1.0;
    let limit = deceleration / (count * count) as f64;
    let cell = |k: usize| Cell {
        x: half[0] * at(k / count),
        y: half[1] * at(k % count),
        limit,
    };
    (0..count * count).map(cell).collect()
}

/// Travel and time until rest of a body thrown along its first axis; `gyration` is its radius of gyration.
pub fn to_rest(cells: &[Cell], gyration: f64, speed: f64, spin: f64) -> [f64; 2] {
    const DT: f64 = 1e-4;
    let inertia = gyration * gyration;
    // In axes that do not turn.
    let slope = |[vx, vy, w]: [f64; 3], angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let mut sum = [0.0; 3];
        for cell in cells {
            let [x, y] = [cos * cell.x - sin * cell.y, sin * cell.x + cos * cell.y];
            let [ux, uy] = [vx - w * y, vy + w * x];
            let size = ux.hypot(uy).max(f64::MIN_POSITIVE);
            let [fx, fy] = [-cell.limit * ux / size, -cell.limit * uy / size];
            sum = [
                sum[0] + fx,
                sum[1] + fy,
                sum[2] + (x * fy - y * fx) / inertia,
            ];
        }
        sum
    };
    let moved = |u: [f64; 3], by: [f64; 3], dt: f64| [0, 1, 2].map(|i| u[i] + by[i] * dt);
    let whole: f64 = cells.iter().map(|cell| cell.limit).sum();
    let mut u = [speed, 0.0, spin];
    let [mut angle, mut x, mut y, mut time] = [0.0; 4];
    while u[0].hypot(u[1]).hypot(gyration * u[2]) > 2.0 * DT * whole {
        let mid = moved(u, slope(u, angle), 0.5 * DT);
        let end = moved(u, slope(mid, angle + 0.5 * DT * u[2]), DT);
        [x, y] = [x + DT * mid[0], y + DT * mid[1]];
        angle += DT * mid[2];
        u = end;
        time += DT;
    }
    [x.hypot(y), time]
}
