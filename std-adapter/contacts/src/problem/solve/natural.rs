//! The natural map r − P_K(r − ũ), which is zero at solutions only, and its derivative.

use super::cone::{Cone, Local, MOST, Square};

/// The map at one contact.
pub(super) fn map(cone: &Cone, r: &Local, u: &Local) -> Local {
    let trial = trial(cone, r, u);
    let nearest = cone.project(&trial).point;
    std::array::from_fn(|at| r[at] - nearest[at])
}

fn trial(cone: &Cone, r: &Local, u: &Local) -> Local {
    let corrected = cone.corrected(u);
    std::array::from_fn(|at| r[at] - corrected[at])
}

/// The map, and its derivative (I − P′) dr + P′ (I + e_N m gᵀ) du with g = u_T/|u_T|.
pub(super) fn linearised(cone: &Cone, r: &Local, u: &Local) -> (Local, Square, Square) {
    let trial = trial(cone, r, u);
    let end = cone.project(&trial);
    let slope = cone.derivative(&trial, &end);
    let map = std::array::from_fn(|at| r[at] - end.point[at]);
    // Change of the corrected normal velocity with the others.
    let mut normal = [0.0; MOST];
    for mode in cone.modes() {
        let length = mode.length(u);
        if length > 0.0 {
            for at in mode.range() {
                normal[at] = mode.threshold * u[at] / length;
            }
        }
    }
    let (mut impulse, mut velocity) = (Square::default(), Square::default());
    for (row, slope) in slope.iter().enumerate().take(cone.size()) {
        for (column, (slope_of, normal)) in slope.iter().zip(&normal).enumerate().take(cone.size())
        {
            let same = f64::from(u8::from(row == column));
            impulse[row][column] = same - slope_of;
            velocity[row][column] = slope_of + slope[0] * normal;
        }
    }
    (map, impulse, velocity)
}
