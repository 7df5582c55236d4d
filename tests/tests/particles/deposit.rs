//! Ballistic deposits: a forest without overlaps, as dense as independent programs find.

use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos::powder::deposit::{Ballistic, Deposit, DepositTarget, STREAM};
use tribos::random::Random;
use tribos::run::PlacementError;
use tribos::space::PeriodicBox;
use tribos::space::pairs::neighbours;
use tribos_tests::sweep::Lcg;

/// Room for roundings, in radii.
const ROUNDING: f64 = 1e-11;

fn small() -> Ballistic {
    Ballistic::new(20.0, 1.0, 3.0).unwrap()
}

/// Every sphere touches its parent or the substrate and overlaps nothing; returns the pairs that
/// touch.
fn check_forest(deposit: &Deposit) -> usize {
    let space = deposit.space;
    let (positions, radii) = (&deposit.positions, &deposit.radii);
    for (i, parent) in deposit.parents.iter().enumerate() {
        let gap = match *parent {
            None => positions[i].z - radii[i],
            Some(parent) => {
                let parent = parent as usize;
                assert!(parent < i);
                let way = space.displacement(&positions[parent], &positions[i]);
                way.norm() - radii[parent] - radii[i]
            }
        };
        assert!(gap.abs() < ROUNDING, "{i} {parent:?} {gap}");
        assert!(positions[i].z - radii[i] > -ROUNDING, "{i}");
        assert_eq!(positions[i], space.wrap(&positions[i]));
    }
    let overlaps = neighbours(&space, positions, radii, -ROUNDING).unwrap();
    assert_eq!(overlaps, [[0; 2]; 0]);
    let top = (positions.iter().zip(radii)).fold(0.0, |top: f64, (x, r)| top.max(x.z + r));
    assert_eq!(deposit.height, top);
    neighbours(&space, positions, radii, ROUNDING)
        .unwrap()
        .len()
}

#[test]
fn a_deposit_is_a_forest_without_overlaps() {
    for capture in [2.0, 2.01, 2.2, 2.5, 3.0, 5.0, 10.0] {
        for seed in 0..20 {
            let ballistic = Ballistic::new(24.0, 1.0, capture).unwrap();
            let deposit = ballistic.grow(DepositTarget::Count(400), seed).unwrap();
            let held = deposit.parents.iter().flatten().count();
            assert_eq!(check_forest(&deposit), held, "{capture} {seed}");
            assert_eq!(deposit.positions.len(), 400);
        }
    }
}

#[test]
fn unequal_spheres_form_a_forest_too() {
    for radii in [[0.9, 1.1], [0.2, 1.8], [0.01, 1.0]] {
        for gap in [0.0, 0.1, 1.0, 4.0] {
            for seed in 0..10 {
                let capture = radii[0] + radii[1] + gap;
                let ballistic = Ballistic::uneven(30.0, radii, capture).unwrap();
                let deposit = ballistic.grow(DepositTarget::Count(500), seed).unwrap();
                let held = deposit.parents.iter().flatten().count();
                assert_eq!(check_forest(&deposit), held, "{radii:?} {gap} {seed}");
                let [low, high] = radii;
                assert!(deposit.radii.iter().all(|r| (low..high).contains(r)));
                let mean = deposit.radii.iter().sum::<f64>() / 500.0;
                // Five standard deviations of a mean of 500.
                assert!((mean - 0.5 * (low + high)).abs() < 5.0 * (high - low) / 6000_f64.sqrt());
            }
        }
    }
}

/// The same deposit by looking at every sphere and its images.
fn slow_deposit(width: f64, radii: [f64; 2], capture: f64, count: usize, seed: u64) -> Deposit {
    let mut random = Random::new(seed, STREAM);
    let mut all: Vec<(Vector3<f64>, f64, Option<u32>)> = Vec::new();
    let gap = capture - radii[0] - radii[1];
    let substrate = capture - 0.5 * (radii[0] + radii[1]);
    while all.len() < count {
        let [x, y] = [(); 2].map(|()| width * random.unit());
        let radius = match radii {
            [low, high] if low < high => low + (high - low) * random.unit(),
            [low, _] => low,
        };
        // Highest meeting at a given gap with any image.
        let highest = |gap: f64| {
            let mut best = (f64::NEG_INFINITY, 0, Vector3::zeros());
            for (i, (centre, other, _)) in all.iter().enumerate() {
                let reach = radius + other + gap;
                for shift_x in [-width, 0.0, width] {
                    for shift_y in [-width, 0.0, width] {
                        let image = centre + Vector3::new(shift_x, shift_y, 0.0);
                        let aside = (x - image.x).hypot(y - image.y);
                        let z = image.z + (reach * reach - aside * aside).sqrt();
                        if z > best.0 {
                            best = (z, i, image);
                        }
                    }
                }
            }
            best
        };
        let captured = highest(gap);
        let met = if captured.0 > radius + substrate {
            captured
        } else {
            highest(0.0)
        };
        let (position, parent) = if met.0 > radius {
            let (z, i, image) = met;
            let direction = (Vector3::new(x, y, z) - image).normalize();
            (image + direction * (radius + all[i].1), Some(i as u32))
        } else {
            (Vector3::new(x, y, radius), None)
        };
        let inside = |x: f64| x.rem_euclid(width);
        all.push((
            Vector3::new(inside(position.x), inside(position.y), position.z),
            radius,
            parent,
        ));
    }
    Deposit {
        positions: all.iter().map(|sphere| sphere.0).collect(),
        radii: all.iter().map(|sphere| sphere.1).collect(),
        parents: all.iter().map(|sphere| sphere.2).collect(),
        width,
        space: PeriodicBox::new([Some(width), Some(width), None]).unwrap(),
        height: f64::NAN,
    }
}

#[test]
fn columns_find_what_looking_everywhere_finds() {
    for (width, radii, capture) in [
        (20.0, [1.0, 1.0], 3.0),
        (20.0, [1.0, 1.0], 2.0),
        (20.0, [1.0, 1.0], 2.2),
        // Two columns on a side, then three.
        (12.0, [1.0, 1.0], 6.0),
        (16.0, [1.0, 1.0], 5.0),
        (20.0, [0.3, 1.5], 2.5),
    ] {
        for seed in [1, 2] {
            let ballistic = Ballistic::uneven(width, radii, capture).unwrap();
            let fast = ballistic.grow(DepositTarget::Count(300), seed).unwrap();
            let slow = slow_deposit(width, radii, capture, 300, seed);
            assert_eq!(fast.parents, slow.parents, "{width} {capture} {seed}");
            assert_eq!(fast.radii, slow.radii);
            for (a, b) in fast.positions.iter().zip(&slow.positions) {
                assert!(fast.space.displacement(a, b).norm() < 1e-10);
            }
        }
    }
}

/// Mean and standard deviation.
fn statistics(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
    (mean, (square / (n - 1.0)).sqrt())
}

/// Solid fractions of the bulk of an independent program, five deposits each. Tolerance: three
/// standard deviations of the difference of two means of five, from the scatter of a hundred.
#[test]
fn bulk_densities_are_those_of_an_independent_program() {
    for (capture, independent, scatter) in [
        (2.0, 0.153, 0.0068),
        (3.0, 0.078, 0.0045),
        (5.0, 0.032, 0.0025),
        (10.0, 0.010, 0.0011),
    ] {
        let ballistic = Ballistic::new(30.0, 1.0, capture).unwrap();
        let bulk = |seed| {
            1.0 - ballistic
                .grow(DepositTarget::Height(120.0), seed)
                .unwrap()
                .bulk_porosity()
        };
        let (mean, _) = statistics(&(1..=5).map(bulk).collect::<Vec<_>>());
        let tolerance = 3.0 * scatter * 0.4_f64.sqrt();
        assert!((mean - independent).abs() < tolerance, "{capture} {mean}");
    }
}

/// Spheres that stick where they touch: the space-filling fraction is about 15 %, and the mean
/// number of contacts 2 (Lubachevsky, Privman & Roy 1992, arXiv cond-mat/9207014).
#[test]
fn classical_ballistic_deposits_fill_fifteen_percent() {
    let ballistic = Ballistic::new(60.0, 1.0, 2.0).unwrap();
    let deposit = ballistic.grow(DepositTarget::Height(300.0), 1).unwrap();
    let solid = 1.0 - deposit.bulk_porosity();
    assert!((solid - 0.15).abs() < 0.005, "{solid}");
    let pairs = check_forest(&deposit) as f64;
    assert!((2.0 * pairs / deposit.radii.len() as f64 - 2.0).abs() < 0.05);
}

/// Spheres and porosities of some deposits.
fn sample(width: f64, until: DepositTarget) -> [(f64, f64); 2] {
    let ballistic = Ballistic::new(width, 1.0, 3.0).unwrap();
    let deposits: Vec<Deposit> = (1..=40)
        .map(|seed| ballistic.grow(until, seed).unwrap())
        .collect();
    let counts: Vec<f64> = deposits.iter().map(|d| d.radii.len() as f64).collect();
    let porosities: Vec<f64> = deposits.iter().map(Deposit::porosity).collect();
    [statistics(&counts), statistics(&porosities)]
}

/// Thesis, sections 4.5 and 4.7: spheres and initial porosity of three systems, each of which is
/// one deposit among ours. The base of the last follows from its spheres, porosity and aspect
/// ratio.
#[test]
fn cut_deposits_are_the_systems_of_the_thesis() {
    for (width, height, spheres, stated) in [
        (20.0, 61.5, 470.0, 0.92),
        (25.0, 87.5, 1015.0, 0.92),
        (40.0, 140.0, 4193.0, 0.923),
    ] {
        let [(count, scatter), (porosity, spread)] = sample(width, DepositTarget::Cut(height));
        let away = (spheres - count) / scatter;
        assert!(away.abs() < 1.0, "{width}: {count} {scatter}");
        assert!((0.02..0.08).contains(&(scatter / count)));
        assert!((porosity - stated).abs() < 0.005, "{width}: {porosity}");
        assert!(spread < 0.01);
    }
}

/// A deposit that ends with the first sphere at the height is loose below it.
#[test]
fn deposits_that_end_at_a_height_are_loose_below_it() {
    let [(count, scatter), (porosity, _)] = sample(20.0, DepositTarget::Height(61.5));
    assert!((0.04..0.10).contains(&(scatter / count)));
    assert!((porosity - 0.92).abs() < 0.01, "{porosity}");
    let grown = (1..=40).map(|seed| small().grow(DepositTarget::Height(61.5), seed).unwrap());
    let (mut above, mut heights) = (0.0, Vec::new());
    for deposit in grown {
        above += (deposit.porosity() - deposit.bulk_porosity()) / 40.0;
        heights.push(deposit.height);
    }
    // An independent program found 0.005 to 0.01.
    assert!((0.004..0.011).contains(&above), "{above}");
    // The piston starts at the highest point, less than a diameter above the wanted height.
    assert!(heights.iter().all(|height| (61.5..63.5).contains(height)));
}

#[test]
fn a_cut_takes_away_what_is_above_and_nothing_else() {
    for (radii, height) in [([1.0, 1.0], 30.0), ([0.4, 1.6], 25.0), ([1.0, 1.0], 2.5)] {
        let ballistic = Ballistic::uneven(20.0, radii, 3.0).unwrap();
        for seed in 0..10 {
            let cut = ballistic.grow(DepositTarget::Cut(height), seed).unwrap();
            let held = cut.parents.iter().flatten().count();
            assert_eq!(check_forest(&cut), held);
            assert!(cut.height <= height && cut.height > height - 2.0 * radii[1]);
            // Any deposit with this seed that is much higher, cut by hand.
            let high = ballistic
                .grow(DepositTarget::Height(3.0 * height + 20.0), seed)
                .unwrap();
            let mut kept = vec![false; high.radii.len()];
            for i in 0..kept.len() {
                let on = high.parents[i].is_none_or(|parent| kept[parent as usize]);
                kept[i] = on && high.positions[i].z + high.radii[i] <= height;
            }
            let positions: Vec<Vector3<f64>> = (0..kept.len())
                .filter(|&i| kept[i])
                .map(|i| high.positions[i])
                .collect();
            assert_eq!(cut.positions, positions, "{radii:?} {height} {seed}");
        }
    }
    let nothing = small().grow(DepositTarget::Cut(1.9), 1);
    assert_eq!(nothing, Err(PlacementError::Empty));
}

#[test]
fn volumes_of_slabs_are_exact() {
    let radii = [0.5, 1.5];
    let ballistic = Ballistic::uneven(16.0, radii, 3.0).unwrap();
    let deposit = ballistic.grow(DepositTarget::Count(200), 5).unwrap();
    let solid = |low, high| deposit.solid_fraction(low, high) * 256.0 * (high - low);
    let whole: f64 = deposit
        .radii
        .iter()
        .map(|r| 4.0 / 3.0 * PI * r.powi(3))
        .sum();
    assert!((solid(0.0, deposit.height) / whole - 1.0).abs() < 1e-13);
    assert!((deposit.porosity() + whole / (256.0 * deposit.height) - 1.0).abs() < 1e-13);
    // Slabs add up, and a thin one holds the area of its section.
    let mut rng = Lcg::new(3);
    for _ in 0..100 {
        let cut = rng.between(0.0, deposit.height);
        let parts = solid(0.0, cut) + solid(cut, deposit.height);
        assert!((parts / whole - 1.0).abs() < 1e-12);
        let (low, high) = (cut - 5e-6, cut + 5e-6);
        let section: f64 = (deposit.positions.iter().zip(&deposit.radii))
            .map(|(x, r)| PI * (r * r - (x.z - cut).powi(2)).max(0.0))
            .sum();
        assert!((solid(low, high) / 1e-5 - section).abs() < 1e-3);
    }
}

#[test]
fn the_same_seed_gives_the_same_bits_for_ever() {
    let deposit = small().grow(DepositTarget::Count(50), 7).unwrap();
    assert_eq!(deposit, small().grow(DepositTarget::Count(50), 7).unwrap());
    assert_ne!(deposit, small().grow(DepositTarget::Count(50), 8).unwrap());
    // A deposit to a height is the beginning of one that has more.
    let low = small().grow(DepositTarget::Height(20.0), 7).unwrap();
    let high = small().grow(DepositTarget::Height(40.0), 7).unwrap();
    assert_eq!(low.positions[..], high.positions[..low.positions.len()]);
    // Numbers of the generator, by a program of its own in Python integers.
    let mut random = Random::new(1, 0);
    assert_eq!(
        [(); 3].map(|()| random.bits()),
        [
            0x3b5a_9eff_d6b2_d506,
            0x6cef_0f13_3971_96d0,
            0x3e0d_e6fb_4727_a421
        ]
    );
    assert_eq!(
        Random::new(1, 0).unit(),
        (0x3b5a_9eff_d6b2_d506_u64 >> 11) as f64 / 2_f64.powi(53)
    );
}

#[test]
fn impossible_deposits_are_refused() {
    let narrow = Ballistic::new(5.9, 1.0, 3.0).unwrap_err();
    assert_eq!(
        narrow,
        PlacementError::NarrowBase {
            width: 5.9,
            farthest: 3.0
        }
    );
    assert!(Ballistic::new(6.0, 1.0, 3.0).is_ok());
    assert!(Ballistic::uneven(6.0, [0.9, 1.1], 3.0).is_err());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Ballistic::new(bad, 1.0, 3.0).is_err());
        assert!(Ballistic::new(20.0, bad, 3.0).is_err());
        assert!(Ballistic::new(20.0, 1.0, bad).is_err());
        assert!(small().grow(DepositTarget::Height(bad), 1).is_err());
        assert!(small().grow(DepositTarget::Cut(bad), 1).is_err());
    }
    assert_eq!(
        Ballistic::new(20.0, 1.0, 1.9),
        Err(PlacementError::CaptureRadius {
            given: 1.9,
            least: 2.0
        })
    );
    assert_eq!(
        Ballistic::uneven(20.0, [1.1, 1.0], 3.0),
        Err(PlacementError::Radii {
            low: 1.1,
            high: 1.0
        })
    );
    assert_eq!(
        small().grow(DepositTarget::Count(0), 1),
        Err(PlacementError::Empty)
    );
    let too_many = small().grow(DepositTarget::Count(usize::MAX), 1);
    assert_eq!(too_many, Err(PlacementError::TooMany));
}
