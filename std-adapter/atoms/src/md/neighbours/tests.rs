//! Lists hold the pairs that linked cells find, in any unit, far from the origin, on any processor.

use super::*;
use tribos_base::random::Random;
use tribos_base::space::pairs::neighbours;

const CUTOFF: f64 = 2.5;
const SKIN: f64 = 0.3;

/// Atoms per volume of a melt.
const DENSITY: f64 = 0.85;

/// Random places in a box of these lengths.
fn places(lengths: [f64; 3]) -> Vec<Vector3<f64>> {
    let mut random = Random::new(31, 0);
    let count = (DENSITY * lengths.iter().product::<f64>()) as usize;
    let mut place = || Vector3::from(lengths).map(|length| length * random.unit());
    (0..count).map(|_| place()).collect()
}

/// Pairs of atoms in the rows, ascending.
fn listed(list: &mut VerletList) -> Vec<[u32; 2]> {
    let mut pairs = Vec::new();
    for chunk in list.chunks_mut() {
        let mut atoms: Vec<u32> = chunk.window().iter().map(|slot| slot.atom).collect();
        atoms.push(u32::MAX);
        let (_, rows) = chunk.sites_and_rows();
        for (here, blocks) in rows {
            let pair = |&there: &u32| {
                let mut pair = [atoms[here], atoms[there as usize]];
                pair.sort_unstable();
                pair
            };
            pairs.extend(blocks.as_flattened().iter().map(pair));
        }
    }
    pairs.retain(|pair| pair[1] != u32::MAX);
    pairs.sort_unstable();
    pairs
}

#[test]
fn the_pairs_are_those_of_linked_cells() {
    // Layers of cells are larger than a chunk in the first.
    let boxes = [[60.0, 61.0, 9.0], [20.0, 7.0, 33.0]];
    for lengths in boxes {
        // In nanometres, too; and open boxes near and far from the origin.
        let kinds = [
            (1.0, true, 0.0),
            (1e-9, true, 0.0),
            (1.0, false, 0.0),
            (1.0, false, 1e7),
        ];
        for (unit, is_periodic, offset) in kinds {
            let lengths = lengths.map(|length| unit * length);
            let places: Vec<_> = places(lengths.map(|length| length / unit))
                .into_iter()
                .map(|place| (place * unit).add_scalar(offset))
                .collect();
            let space = PeriodicBox::new(lengths.map(|length| is_periodic.then_some(length)));
            let space = space.expect("lengths are positive");
            let [cutoff, skin] = [CUTOFF, SKIN].map(|length| unit * length);
            let mut list = VerletList::new(space, cutoff, skin).expect("the box is large");
            list.update(&places, &vec![0; places.len()])
                .expect("few atoms");
            let radii = vec![0.0; places.len()];
            let expected = neighbours(&space, &places, &radii, cutoff + skin);
            let expected = expected.expect("the box is large");
            assert!(listed(&mut list) == expected, "{lengths:?} {offset}");
            let pairs: usize = list.chunks_mut().iter().map(|chunk| chunk.pairs()).sum();
            assert_eq!(pairs, expected.len());
        }
    }
}

#[test]
fn far_outliers_are_neighbours_too() {
    // The unit of the last place in single precision is many reaches where these pairs are.
    let mut places = places([20.0; 3]);
    let corner = Vector3::repeat(1e15);
    places.extend([corner, corner.add_scalar(1.0), -corner]);
    let mut list = VerletList::new(PeriodicBox::OPEN, CUTOFF, SKIN).expect("lengths");
    list.update(&places, &vec![0; places.len()])
        .expect("few atoms");
    let radii = vec![0.0; places.len()];
    let expected = neighbours(list.space(), &places, &radii, CUTOFF + SKIN).expect("open");
    assert!(listed(&mut list) == expected);
}

#[test]
fn the_processor_does_not_change_the_rows() {
    let places = places([21.0, 17.0, 23.0]);
    let space = PeriodicBox::new([Some(21.0), Some(17.0), Some(23.0)]).expect("positive");
    let mut list = VerletList::new(space, CUTOFF, SKIN).expect("the box is large");
    let species = vec![0; places.len()];
    list.update(&places, &species).expect("few atoms");
    let count = list.cells.slots().len();
    for (index, chunk) in list.chunks.iter_mut().enumerate() {
        let rows = |chunk: &mut Chunk| -> Vec<(usize, Vec<[u32; LANES]>)> {
            let (_, rows) = chunk.sites_and_rows();
            rows.map(|(here, blocks)| (here, blocks.to_vec())).collect()
        };
        let expected = rows(chunk);
        let start = index * SLOTS_PER_CHUNK;
        let build = Build {
            chunk,
            cells: &list.cells,
            owned: start..(start + SLOTS_PER_CHUNK).min(count),
            reaches: [CUTOFF, CUTOFF + SKIN],
            atoms: (&places, &species),
        };
        lanes::LaneLoop::go::<wide::f64x4>(build, ());
        assert!(rows(chunk) == expected);
    }
}
