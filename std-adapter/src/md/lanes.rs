//! Four pairs of an atom side by side.

use super::neighbours::{LANES, Site};

/// One number for each of the pairs computed at once; every operation rounds as the scalar one
/// does.
pub(super) type Lanes = wide::f64x4;
const _: () = assert!(size_of::<Lanes>() == LANES * size_of::<f64>());

/// Displacements from each site of a block to `own`, axis by axis.
#[inline(always)]
pub(super) fn ways(own: &Site, block: &[u32; LANES], sites: &[Site]) -> [Lanes; 3] {
    let [a, b, c, d] = block.map(|other| &sites[other as usize].place);
    std::array::from_fn(|axis| {
        Lanes::splat(own.place[axis]) - Lanes::new([a[axis], b[axis], c[axis], d[axis]])
    })
}

/// Takes a force on an atom from its neighbours.
#[inline(always)]
pub(super) fn take(sites: &mut [Site], block: &[u32; LANES], pull: [Lanes; 3]) {
    let [x, y, z] = pull.map(Lanes::to_array);
    for (lane, &other) in block.iter().enumerate() {
        let other = &mut sites[other as usize].force;
        other[0] -= x[lane];
        other[1] -= y[lane];
        other[2] -= z[lane];
    }
}

/// Sum over the lanes, halves first.
#[inline(always)]
pub(super) fn across(lanes: Lanes) -> f64 {
    let [a, b, c, d] = lanes.to_array();
    (a + c) + (b + d)
}
