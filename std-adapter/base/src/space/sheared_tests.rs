//! Boxes whose images are displaced, against sums over the lattice of images.

use super::PeriodicBox;
use super::pairs::{Cells, neighbours};
use crate::random::Random;
use nalgebra::Vector3;

type Answer = Result<(), Box<dyn std::error::Error>>;

/// Displacement to the nearest image, of all those some periods around.
fn nearest(sides: [f64; 3], offset: f64, straight: Vector3<f64>) -> Vector3<f64> {
    let steps = |most: i32| (-most..=most).map(f64::from);
    let mut best = Vector3::repeat(f64::INFINITY);
    for levels in steps(4) {
        for y in steps(4) {
            for x in steps(8) {
                let image = Vector3::new(
                    x * sides[0] + levels * offset,
                    y * sides[1],
                    levels * sides[2],
                );
                let way = straight - image;
                if way.norm() < best.norm() {
                    best = way;
                }
            }
        }
    }
    best
}

fn places(random: &mut Random, count: usize, sides: [f64; 3]) -> Vec<Vector3<f64>> {
    // Up to a period outside of the cell.
    let mut place = |side: f64| side * (3.0 * random.unit() - 1.0);
    (0..count)
        .map(|_| Vector3::from(sides.map(&mut place)))
        .collect()
}

#[test]
fn displacements_and_neighbours_are_those_of_the_lattice_of_images() -> Answer {
    let mut random = Random::new(5, 0);
    for (sides, count) in [
        ([9.0, 7.0, 8.0], 40),
        ([20.0, 5.0, 30.0], 150),
        ([6.0, 6.0, 6.0], 12),
    ] {
        let space = PeriodicBox::new(sides.map(Some))?;
        for share in [0.0, 1e-9, 0.3, 0.5, 0.77, 0.999] {
            let offset = share * sides[0];
            let sheared = space.sheared(offset);
            let centres = places(&mut random, count, sides);
            let radii: Vec<_> = (0..count)
                .map(|i| 0.3 + 0.7 * (i as f64 / count as f64))
                .collect();
            let mut expected = Vec::new();
            for i in 0..count {
                for j in i + 1..count {
                    let way = nearest(sides, offset, centres[j] - centres[i]);
                    if way.norm() - radii[i] - radii[j] < 0.4 {
                        let found = sheared.displacement(&centres[i], &centres[j]);
                        assert!((found - way).norm() < 1e-12, "{found} {way}");
                        expected.push([i as u32, j as u32]);
                    }
                }
            }
            assert_eq!(neighbours(&sheared, &centres, &radii, 0.4)?, expected);
            assert!(!expected.is_empty());
            let mut cells = Cells::default();
            let wrapped: Vec<_> = centres.iter().map(|x| sheared.wrap(x)).collect();
            assert_eq!(cells.find(&sheared, &wrapped, &radii, 0.4)?, expected);
        }
    }
    Ok(())
}

#[test]
fn wrapped_places_lie_in_the_cell_and_differ_by_whole_images() -> Answer {
    let mut random = Random::new(6, 0);
    let sides = [9.0, 7.0, 8.0];
    for offset in [0.1, 4.4, 8.9] {
        let space = PeriodicBox::new(sides.map(Some))?.sheared(offset);
        let mut all = places(&mut random, 200, sides);
        all.push(Vector3::new(1.0, 1.0, -1e-20));
        all.push(Vector3::new(1.0, 1.0, 8.0));
        for x in all {
            let inside = space.wrap(&x);
            for (axis, side) in sides.into_iter().enumerate() {
                assert!((0.0..side).contains(&inside[axis]), "{inside}");
            }
            assert!(
                space.displacement(&x, &inside).norm() < 1e-12,
                "{x} {inside}"
            );
            assert!(nearest(sides, offset, inside - x).norm() < 1e-12);
        }
    }
    Ok(())
}
