//! Lists of atoms hold every pair that looking at all of them finds, once, and stay valid while atoms
//! move less than the skin allows.

use nalgebra::Vector3;
use tribos::md::neighbours::{ListError, VerletList};
use tribos::space::PeriodicBox;
use tribos_tests::sweep::Lcg;

/// Axes, cut-off and skin: open, mixed, small boxes with the cut-off at half of them, lists that see
/// more than one image.
const KINDS: [([Option<f64>; 3], f64, f64); 7] = [
    ([None; 3], 1.7, 0.3),
    ([Some(12.0), Some(9.0), None], 2.5, 0.4),
    ([Some(5.0), Some(5.0), Some(5.0)], 2.5, 0.5),
    ([Some(5.0), Some(5.0), Some(5.0)], 2.5, 2.5),
    ([Some(6.0), None, Some(20.0)], 3.0, 1e-3),
    ([Some(5.1), Some(7.7), Some(10.3)], 2.5, 1.0),
    ([None, None, Some(4.0)], 2.0, 1.9),
];

/// Pairs nearer than the cut-off, over all images that could be.
fn counted(lengths: [Option<f64>; 3], places: &[Vector3<f64>], cutoff: f64) -> Vec<[u32; 2]> {
    let along = |way: f64, length: Option<f64>| match length {
        None => way * way,
        Some(length) => (-9..=9)
            .map(|k| way + f64::from(k) * length)
            .map(|way| way * way)
            .fold(f64::INFINITY, f64::min),
    };
    let mut pairs = Vec::new();
    for i in 0..places.len() {
        for j in i + 1..places.len() {
            let way = places[j] - places[i];
            let r_sq: f64 = (0..3).map(|axis| along(way[axis], lengths[axis])).sum();
            if r_sq < cutoff * cutoff {
                pairs.push([i as u32, j as u32]);
            }
        }
    }
    pairs
}

/// Those that the list holds; more than one entry a pair would show.
fn listed(list: &mut VerletList) -> Vec<[u32; 2]> {
    let cutoff_sq = list.cutoff() * list.cutoff();
    let mut pairs = Vec::new();
    for chunk in list.chunks_mut() {
        let atoms: Vec<u32> = chunk.window().iter().map(|slot| slot.atom).collect();
        let (sites, rows) = chunk.sites_and_rows();
        for (here, blocks) in rows {
            for &other in blocks.as_flattened() {
                let place = |at: usize| Vector3::from_row_slice(&sites[at].place[..3]);
                let [a, b] = [place(here), place(other as usize)];
                if (a - b).norm_squared() < cutoff_sq {
                    let mut pair = [atoms[here], atoms[other as usize]];
                    pair.sort_unstable();
                    pairs.push(pair);
                }
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// Places from periods before the cell to periods behind it.
fn scattered(rng: &mut Lcg, lengths: [Option<f64>; 3], count: usize) -> Vec<Vector3<f64>> {
    let mut place = || {
        Vector3::from_fn(|axis, _| match lengths[axis] {
            Some(length) => rng.between(-3.0 * length, 4.0 * length),
            None => rng.between(-5.0, 5.0),
        })
    };
    (0..count).map(|_| place()).collect()
}

fn list(lengths: [Option<f64>; 3], cutoff: f64, skin: f64) -> VerletList {
    VerletList::new(PeriodicBox::new(lengths).unwrap(), cutoff, skin).unwrap()
}

#[test]
fn a_list_holds_every_pair_once() {
    let mut rng = Lcg::new(11);
    for (lengths, cutoff, skin) in KINDS {
        for count in [0, 1, 2, 40, 250] {
            let places = scattered(&mut rng, lengths, count);
            let mut list = list(lengths, cutoff, skin);
            list.update(&places, &vec![0; count]).unwrap();
            let expected = counted(lengths, &places, cutoff);
            assert_eq!(
                listed(&mut list),
                expected,
                "{lengths:?} {cutoff} {skin} {count}"
            );
        }
    }
}

#[test]
fn a_list_that_is_kept_still_holds_every_pair() {
    let mut rng = Lcg::new(12);
    for (lengths, cutoff, skin) in KINDS {
        let mut places = scattered(&mut rng, lengths, 150);
        let mut list = list(lengths, cutoff, skin);
        let mut kept = 0;
        for _ in 0..60 {
            let built = list.update(&places, &[0; 150]).unwrap();
            kept += u32::from(!built);
            assert_eq!(
                listed(&mut list),
                counted(lengths, &places, cutoff),
                "{lengths:?}"
            );
            for place in &mut places {
                let step = 0.06 * skin;
                *place += Vector3::from_fn(|_, _| rng.between(-step, step));
            }
        }
        assert!(
            list.builds() > 1 && kept > 20,
            "{lengths:?}: {} builds",
            list.builds()
        );
    }
}

#[test]
fn two_atoms_that_meet_across_the_skin_make_a_list_stale() {
    let mut list = list([None; 3], 1.0, 0.2);
    let places = |way: f64| {
        vec![
            Vector3::new(way, 0.0, 0.0),
            Vector3::new(1.21 - way, 0.0, 0.0),
        ]
    };
    list.update(&places(0.0), &[0; 2]).unwrap();
    assert!(listed(&mut list).is_empty());
    assert!(!list.update(&places(0.099), &[0; 2]).unwrap());
    assert!(list.update(&places(0.11), &[0; 2]).unwrap());
    assert_eq!(listed(&mut list), [[0, 1]]);
}

#[test]
fn far_outliers_cost_no_memory() {
    let mut rng = Lcg::new(13);
    let mut places = scattered(&mut rng, [None; 3], 100);
    places.push(Vector3::new(1e9, -1e12, 3.0));
    places.push(Vector3::new(1e9 + 1.0, -1e12, 3.0));
    let mut list = list([None; 3], 2.5, 0.3);
    list.update(&places, &[0; 102]).unwrap();
    assert_eq!(listed(&mut list), counted([None; 3], &places, 2.5));
}

#[test]
fn boxes_too_small_are_refused() {
    let new = |cutoff, skin| {
        let space = PeriodicBox::new([None, Some(5.0), None]).unwrap();
        VerletList::new(space, cutoff, skin)
    };
    assert!(new(2.5, 2.5).is_ok());
    assert!(matches!(
        new(2.51, 0.1),
        Err(ListError::Cutoff { axis: 1, .. })
    ));
    assert!(matches!(
        new(2.5, 2.6),
        Err(ListError::Skin { axis: 1, .. })
    ));
    assert!(matches!(new(0.0, 0.1), Err(ListError::Length { .. })));
    assert!(matches!(new(1.0, f64::NAN), Err(ListError::Length { .. })));
}
