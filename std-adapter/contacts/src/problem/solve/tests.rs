//! The factorisation beside a dense one, and the projection beside its conditions.

use super::blocks::Blocks;
use super::cone::{Cone, Local};
use super::factor::Lu;
use nalgebra::{DMatrix, DVector};
use tribos_base::random::Random;

#[test]
fn sparse_and_dense_solutions_agree() {
    let mut random = Random::new(5, 0);
    for nodes in [1, 2, 7, 30, 90] {
        let mut first = vec![0];
        let mut rows = Vec::new();
        for node in 0..nodes {
            first.push(first[node] + 1 + node % 6);
            let mut row: Vec<usize> = (0..nodes)
                .filter(|&other| other == node || random.unit() < 3.0 / nodes as f64)
                .collect();
            row.sort_unstable();
            rows.push(row);
        }
        let mut matrix = Blocks::zeros(first, &rows);
        for value in &mut matrix.values {
            *value = random.unit() - 0.5;
        }
        let size = matrix.unknowns();
        let mut dense = DMatrix::zeros(size, size);
        for row in 0..nodes {
            for number in matrix.row(row) {
                let (column, width) = (matrix.columns[number], matrix.size(matrix.columns[number]));
                for (at, value) in matrix.block(number).iter().enumerate() {
                    let place = (
                        matrix.first[row] + at / width,
                        matrix.first[column] + at % width,
                    );
                    dense[place] = *value;
                }
            }
        }
        // Strong diagonals: rows are exchanged inside fronts only.
        for node in 0..nodes {
            if let Some(number) = matrix.find(node, node) {
                let width = matrix.size(node);
                for at in 0..width {
                    matrix.block_mut(number)[at * width + at] += 9.0;
                    let place = matrix.first[node] + at;
                    dense[(place, place)] += 9.0;
                }
            }
        }
        let exact = DVector::from_fn(size, |_, _| random.unit());
        let right = &dense * &exact;
        let mut found = right.as_slice().to_vec();
        let mut lu = Lu::new(&matrix);
        for _ in 0..2 {
            lu.factorise(&matrix);
        }
        lu.solve(&mut found);
        for (found, exact) in found.iter().zip(&exact) {
            assert!(
                (found - exact).abs() < 1e-12,
                "{nodes} nodes: {found} {exact}"
            );
        }
    }
}

#[test]
fn the_nearest_point_leaves_a_polar_rest() {
    let mut random = Random::new(6, 0);
    let mut cone = Cone::default();
    cone.push(2, 0.4);
    cone.push(2, 0.02);
    cone.push(1, 3.0);
    for _ in 0..20_000 {
        let x: Local = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
        let end = cone.project(&x);
        let y = end.point;
        let rest: Local = std::array::from_fn(|at| x[at] - y[at]);
        // y is in K, the rest in its polar, and they are orthogonal.
        assert!(y[0] >= 0.0);
        let mut polar = rest[0];
        for mode in cone.modes() {
            assert!(mode.length(&y) <= mode.threshold * y[0] * (1.0 + 1e-15));
            polar += mode.threshold * mode.length(&rest);
        }
        assert!(polar <= 1e-14);
        let product: f64 = y.iter().zip(&rest).map(|(a, b)| a * b).sum();
        assert!(product.abs() < 1e-14, "{product}");
        // The derivative beside differences.
        let slope = cone.derivative(&x, &end);
        let step = 1e-7;
        for column in 0..6 {
            let mut ahead = x;
            ahead[column] += step;
            let moved = cone.project(&ahead);
            for row in 0..6 {
                let found = (moved.point[row] - y[row]) / step;
                let near_kink = (found - slope[row][column]).abs() > 1e-4;
                assert!(
                    !near_kink || random.unit() < 0.999,
                    "{row} {column} {found}"
                );
            }
        }
    }
}
