//! A fixed sequence of points spread evenly over the unit cube.

/// Bases of the Halton sequence, one per coordinate.
const BASES: [u32; 8] = [2, 3, 5, 7, 11, 13, 17, 19];

/// Point `index` of the Halton sequence (1960) in `dimensions` ≤ 8 coordinates; the first is the
/// middle of the cube.
pub(super) fn halton(index: usize, dimensions: usize) -> Vec<f64> {
    /// The middle, for the first guess.
    const MIDDLE: f64 = 0.5;
    if index == 0 {
        return vec![MIDDLE; dimensions];
    }
    let bases = BASES.iter().cycle().take(dimensions);
    bases
        .map(|&base| radical_inverse(index, base as usize))
        .collect()
}

/// The digits of `index` mirrored at the point.
fn radical_inverse(mut index: usize, base: usize) -> f64 {
    let (mut sum, mut place) = (0.0, 1.0);
    while index > 0 {
        place /= base as f64;
        sum += (index % base) as f64 * place;
        index /= base;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_fill_the_cube() {
        assert_eq!(halton(0, 2), [0.5, 0.5]);
        assert_eq!(halton(3, 2), [0.75, 1.0 / 9.0]);
        // As many as the laws have parameters; later coordinates fill more slowly.
        for dimension in 0..6 {
            let below = (1..=64).filter(|&k| halton(k, 6)[dimension] < 0.5).count();
            assert!((28..=36).contains(&below), "{dimension}: {below}");
        }
    }
}
