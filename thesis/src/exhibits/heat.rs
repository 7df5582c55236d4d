//! Heat that flows into a half space, by finite differences: why friction on ice falls like v^(−1/2).

/// Cells, their width, and the step of the explicit scheme in squares of the width.
const CELLS: usize = 200;
const WIDTH: f64 = 0.025;
const STEP: f64 = 0.4;

/// The surface temperatures at the given ascending times under a heat flux of 1 into a half space
/// whose conductivity and heat capacity are 1.
pub fn surface(times: &[f64]) -> Vec<f64> {
    let mut cells = [0.0_f64; CELLS];
    let dt = STEP * WIDTH * WIDTH;
    let mut time = 0.0;
    let mut seen = Vec::new();
    for &wanted in times {
        while time < wanted {
            let mut flux = 1.0;
            for cell in 0..CELLS - 1 {
                let on = (cells[cell] - cells[cell + 1]) / WIDTH;
                cells[cell] += dt / WIDTH * (flux - on);
                flux = on;
            }
            time += dt;
        }
        // The surface lies half a cell above the first cell's middle.
        seen.push(cells[0] + 0.5 * WIDTH);
    }
    seen
}
