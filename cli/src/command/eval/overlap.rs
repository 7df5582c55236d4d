//! Which atoms are too near each other.

use crate::failure::Failure;
use tribos::md::neighbours::VerletList;

/// The refusal of forces that are no numbers, with the nearest two atoms.
pub fn failure(list: &mut VerletList, ids: &[u64]) -> Failure {
    let mut nearest = None;
    for chunk in list.chunks_mut() {
        let atoms: Vec<u32> = chunk.window().iter().map(|slot| slot.atom).collect();
        let (sites, rows) = chunk.sites_and_rows();
        for (here, blocks) in rows {
            // Blocks are filled up with a site that is no atom's.
            for &other in blocks.as_flattened() {
                let Some(&atom) = atoms.get(other as usize) else {
                    continue;
                };
                let ends = [here, other as usize].map(|site| sites[site].place);
                let way: [f64; 3] = std::array::from_fn(|axis| ends[0][axis] - ends[1][axis]);
                let distance = way.iter().map(|x| x * x).sum::<f64>().sqrt();
                if distance.is_finite() && nearest.is_none_or(|(least, _)| distance < least) {
                    nearest = Some((distance, [atoms[here], atom]));
                }
            }
        }
    }
    match nearest {
        Some((distance, pair)) => {
            let mut pair = pair.map(|atom| ids[atom as usize]);
            pair.sort_unstable();
            let [first, second] = pair;
            Failure::input(format!(
                "atoms {first} and {second} are {distance:?} apart, too near: the forces are not \
                 finite; move them apart or take one away"
            ))
        }
        None => Failure::input("the forces are not finite; check the numbers of the potential"),
    }
}
