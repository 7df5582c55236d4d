//! Lists of neighbours: every pair that counting all of them finds, and no other.

use nalgebra::Vector3;
use tribos::space::pairs::{Cells, neighbours};
use tribos::space::{PeriodicBox, SpaceError};
use tribos_tests::sweep::Lcg;

/// Spheres in a box.
struct Packing {
    space: PeriodicBox,
    positions: Vec<Vector3<f64>>,
    radii: Vec<f64>,
}

/// Shortest distance over all images next to the straight one.
fn distance(lengths: [Option<f64>; 3], a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let square = |axis: usize| {
        let straight = b[axis] - a[axis];
        let images = lengths[axis].map_or(vec![straight], |length| {
            (-7..=7).map(|k| straight + f64::from(k) * length).collect()
        });
        images
            .into_iter()
            .map(|d| d * d)
            .fold(f64::INFINITY, f64::min)
    };
    (square(0) + square(1) + square(2)).sqrt()
}

/// Every pair looked at. Gaps within rounding of `skin` may be judged either way, random ones are
/// not that near.
fn brute_force(packing: &Packing, skin: f64) -> Vec<[u32; 2]> {
    let Packing {
        space,
        positions,
        radii,
    } = packing;
    let mut out = Vec::new();
    for i in 0..positions.len() {
        for j in i + 1..positions.len() {
            let gap = distance(space.lengths(), &positions[i], &positions[j]) - radii[i] - radii[j];
            if gap < skin {
                out.push([i as u32, j as u32]);
            }
        }
    }
    out
}

/// Random places from a period before the cell to a period behind it; an open axis is `open` long.
fn scattered(
    rng: &mut Lcg,
    lengths: [Option<f64>; 3],
    open: f64,
    mut radius: impl FnMut(&mut Lcg, usize) -> f64,
    count: usize,
) -> Packing {
    let place = |rng: &mut Lcg| {
        Vector3::from_fn(|axis, _| match lengths[axis] {
            Some(length) => rng.between(-length, 2.0 * length),
            None => rng.between(-open, open),
        })
    };
    Packing {
        space: PeriodicBox::new(lengths).unwrap(),
        positions: (0..count).map(|_| place(rng)).collect(),
        radii: (0..count).map(|i| radius(rng, i)).collect(),
    }
}

const KINDS: [[Option<f64>; 3]; 6] = [
    [None; 3],
    [Some(20.0), Some(20.0), None],
    [Some(9.0), Some(11.0), Some(13.0)],
    [None, None, Some(6.5)],
    // One, two and three cells fit on these axes.
    [Some(5.1), Some(6.5), Some(9.5)],
    [Some(5.1), Some(40.0), None],
];

#[test]
fn equal_spheres_are_all_found() {
    let mut rng = Lcg::new(11);
    let mut cells = Cells::default();
    let mut found = 0;
    for lengths in KINDS {
        for count in [0, 1, 2, 3, 10, 60, 300] {
            for skin in [0.5, 0.1, 0.0, -0.7, -3.0] {
                let packing = scattered(&mut rng, lengths, 8.0, |_, _| 1.0, count);
                let (positions, radii) = (&packing.positions, &packing.radii);
                let got = neighbours(&packing.space, positions, radii, skin).unwrap();
                assert_eq!(
                    got,
                    brute_force(&packing, skin),
                    "{lengths:?} {count} {skin}"
                );
                // Old contents of the buffers do not matter.
                let again = cells.find(&packing.space, positions, radii, skin).unwrap();
                assert_eq!(got, again);
                found += got.len();
            }
        }
    }
    assert!(found > 10_000, "{found}");
}

#[test]
fn similar_spheres_are_all_found() {
    let mut rng = Lcg::new(15);
    let mut found = 0;
    for lengths in KINDS {
        for [least, most] in [[0.8, 0.81], [0.7, 0.9], [0.5, 1.0]] {
            for skin in [0.5, 0.1, -0.7, -1.3] {
                let radius = |rng: &mut Lcg, _| rng.between(least, most);
                let packing = scattered(&mut rng, lengths, 6.0, radius, 200);
                let (positions, radii) = (&packing.positions, &packing.radii);
                let got = neighbours(&packing.space, positions, radii, skin).unwrap();
                assert_eq!(
                    got,
                    brute_force(&packing, skin),
                    "{lengths:?} {least} {most} {skin}"
                );
                found += got.len();
            }
        }
    }
    assert!(found > 10_000, "{found}");
}

/// Pairs of spheres in order of x, compared only as long as their places along x are near.
fn by_order(packing: &Packing, skin: f64) -> Vec<[u32; 2]> {
    let Packing {
        positions, radii, ..
    } = packing;
    let mut order: Vec<usize> = (0..positions.len()).collect();
    order.sort_by(|&a, &b| positions[a].x.total_cmp(&positions[b].x));
    let largest = radii.iter().copied().fold(0.0, f64::max);
    let mut out = Vec::new();
    for (at, &a) in order.iter().enumerate() {
        let near = |b: &usize| positions[*b].x - positions[a].x <= 2.0 * largest + skin;
        for &b in order[at + 1..].iter().take_while(|b| near(b)) {
            if (positions[b] - positions[a]).norm() - radii[a] - radii[b] < skin {
                out.push([a.min(b) as u32, a.max(b) as u32]);
            }
        }
    }
    out.sort_unstable();
    out
}

#[test]
fn large_packings_give_the_same_pairs_on_any_number_of_threads() {
    let mut rng = Lcg::new(16);
    for largest in [1.0, 4.0] {
        let radius = |rng: &mut Lcg, i: usize| match i % 1000 {
            0 => largest,
            _ => rng.between(0.8, 1.0),
        };
        let packing = scattered(&mut rng, [None; 3], 30.0, radius, 20_000);
        let expected = by_order(&packing, 0.2);
        assert!(expected.len() > 20_000, "{}", expected.len());
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let pool = pool.build().unwrap();
            let (positions, radii) = (&packing.positions, &packing.radii);
            let got = pool.install(|| neighbours(&packing.space, positions, radii, 0.2));
            assert_eq!(got.unwrap(), expected, "{largest} {threads}");
        }
    }
}

#[test]
fn uneven_spheres_are_all_found() {
    let mut rng = Lcg::new(12);
    let mut found = 0;
    for lengths in [[None; 3], [Some(70.0), Some(60.0), None]] {
        for spread in [1.0, 10.0, 1e3, 1e6] {
            for skin in [1e-3, 0.2, -0.05] {
                let radius = |rng: &mut Lcg, i: usize| match i % 40 {
                    0 => 10.0,
                    1 => 0.0,
                    _ => rng.log_between(1.0 / spread, 1.0),
                };
                let packing = scattered(&mut rng, lengths, 30.0, radius, 400);
                let got =
                    neighbours(&packing.space, &packing.positions, &packing.radii, skin).unwrap();
                assert_eq!(
                    got,
                    brute_force(&packing, skin),
                    "{lengths:?} {spread} {skin}"
                );
                found += got.len();
            }
        }
    }
    assert!(found > 1_500, "{found}");
}

#[test]
fn outliers_and_heaps_are_found() {
    let mut rng = Lcg::new(13);
    for far in [1e3, 1e9, 1e150] {
        let mut packing = scattered(&mut rng, [Some(12.0), None, None], 8.0, |_, _| 1.0, 200);
        packing.positions[7].z = far;
        packing.positions[8] = Vector3::new(3.0, far, -far);
        packing.positions[9] = Vector3::new(3.0 + 1e-3, far, -far);
        let got = neighbours(&packing.space, &packing.positions, &packing.radii, 0.1).unwrap();
        assert_eq!(got, brute_force(&packing, 0.1), "{far}");
        assert!(got.contains(&[8, 9]));
    }
    // Everything in one place.
    let heap = [Vector3::new(1.0, 2.0, 3.0); 4];
    let all = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    for space in [PeriodicBox::OPEN, PeriodicBox::new([Some(9.0); 3]).unwrap()] {
        assert_eq!(neighbours(&space, &heap, &[0.0; 4], 1e-9).unwrap(), all);
        assert!(
            neighbours(&space, &heap, &[0.0; 4], 0.0)
                .unwrap()
                .is_empty()
        );
    }
}

/// Touching spheres on a lattice whose planes fall on the borders of cells and of the box.
#[test]
fn places_on_borders_are_found() {
    let side = 6_i32;
    let positions: Vec<Vector3<f64>> = (0..side.pow(3))
        .map(|n| {
            let [x, y, z] = [n % side, n / side % side, n / side / side];
            Vector3::new(f64::from(x), f64::from(y), f64::from(z)) * 2.0
        })
        .collect();
    let radii = vec![1.0; positions.len()];
    let space = PeriodicBox::new([Some(12.0); 3]).unwrap();
    let touching = neighbours(&space, &positions, &radii, 1e-12).unwrap();
    // Six neighbours each, across the faces of the box too.
    assert_eq!(touching.len(), 3 * positions.len());
    assert!(
        neighbours(&space, &positions, &radii, 0.0)
            .unwrap()
            .is_empty()
    );
}

#[test]
fn bad_input_is_refused_by_name() {
    let space = PeriodicBox::new([None, Some(5.0), None]).unwrap();
    let origin = Vector3::zeros();
    let ask = |positions: &[Vector3<f64>], radii: &[f64], skin| {
        neighbours(&space, positions, radii, skin).unwrap_err()
    };
    assert!(matches!(
        ask(&[origin, Vector3::new(0.0, 0.0, f64::NAN)], &[1.0; 2], 0.1),
        SpaceError::Position { particle: 1, axis: 2, given } if given.is_nan()
    ));
    assert_eq!(
        ask(&[origin; 2], &[1.0, -1.0], 0.1),
        SpaceError::Radius {
            particle: 1,
            given: -1.0
        }
    );
    assert_eq!(
        ask(&[origin; 2], &[1.0], 0.1),
        SpaceError::Lengths {
            positions: 2,
            radii: 1
        }
    );
    assert_eq!(
        ask(&[origin; 3], &[1.0, 0.5, 1.5], 0.25),
        SpaceError::Reach {
            axis: 1,
            reach: 2.75,
            length: 5.0
        }
    );
    assert_eq!(
        ask(&[origin], &[1.0], f64::INFINITY),
        SpaceError::Skin {
            given: f64::INFINITY
        }
    );
    // A lone sphere has nobody to meet over two images.
    assert_eq!(neighbours(&space, &[origin], &[1e9], 0.1), Ok(vec![]));
    for given in [0.0, -1.0, f64::INFINITY] {
        let error = PeriodicBox::new([None, None, Some(given)]);
        assert_eq!(error, Err(SpaceError::Period { axis: 2, given }));
    }
    assert!(PeriodicBox::new([Some(f64::NAN), None, None]).is_err());
}

#[test]
fn displacements_are_minimum_images() {
    let mut rng = Lcg::new(14);
    let lengths = [Some(3.0), None, Some(7.0)];
    let space = PeriodicBox::new(lengths).unwrap();
    for _ in 0..10_000 {
        let mut place = || Vector3::from_fn(|_, _| rng.between(-10.0, 10.0));
        let (a, b) = (place(), place());
        let way = space.displacement(&a, &b);
        assert!((way.norm() - distance(lengths, &a, &b)).abs() < 1e-13);
        assert_eq!(way, -space.displacement(&b, &a));
        let inside = space.wrap(&a);
        assert_eq!(inside.y, a.y);
        assert!((0.0..3.0).contains(&inside.x) && (0.0..7.0).contains(&inside.z));
        assert!(space.displacement(&a, &inside).xz().norm() < 1e-13);
        assert_eq!(space.wrap(&inside), inside);
    }
    // A coordinate just below zero does not round to the far face.
    assert_eq!(
        space.wrap(&Vector3::new(-1e-300, 0.0, 7.0)),
        Vector3::zeros()
    );
    let lost = space.displacement(&Vector3::repeat(f64::NAN), &Vector3::zeros());
    assert!(lost.iter().all(|x| x.is_nan()));
    assert!(space.wrap(&Vector3::repeat(f64::INFINITY)).x.is_nan());
}
