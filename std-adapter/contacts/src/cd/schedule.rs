//! Order in which the pairs of a packing are visited.
//!
//! Spheres are divided into blocks of consecutive numbers. Pairs inside a block come block by block, so
//! that blocks can be swept in parallel; pairs across blocks come after them, pairs with an image last.
//! Within each of these groups pairs are sorted by colours, such that no sphere has two pairs of the same
//! colour: consecutive updates then do not wait for each other's velocities, and four of them can be solved side
//! by side. The order depends only on the contacts, never on the number of threads.

use super::image::ImageVelocity;
use super::pairs::View;
use std::ops::Range;

/// Spheres per block: with their contacts a few hundred kilobytes, the size of a core's own cache.
pub(super) const BLOCK: usize = 1024;

/// A block of spheres and the pairs inside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Block {
    /// Numbers of the spheres.
    pub spheres: Range<usize>,
    /// Positions of its pairs in the order.
    pub pairs: Range<usize>,
}

/// Last colour, which spheres with very many contacts share.
const SHARED: u32 = u64::BITS - 1;

/// The order of visits.
#[derive(Clone, Debug, Default)]
pub(super) struct Schedule {
    /// Blocks in order.
    pub blocks: Vec<Block>,
    /// Position of the first pair with an image.
    pub images: usize,
    /// Group and colour of each pair, and its position in the order.
    keys: Vec<(u32, u32, u32)>,
    /// Colours already used at each sphere, group by group.
    taken: Vec<u64>,
}

impl Schedule {
    /// Finds the order of the pairs, and renumbers their images in it.
    pub fn arrange(&mut self, spheres: usize, view: View<'_>, images: &mut [ImageVelocity]) {
        let count = spheres.div_ceil(BLOCK).max(1);
        let across = count as u32;
        let block = |sphere: u32| sphere / BLOCK as u32;
        self.keys.clear();
        for (index, bodies) in (0..).map_while(|at| Some((at, view.bodies(at)?))) {
            let [a, b] = bodies.map(block);
            let group = if a == b { a } else { across };
            self.keys.push((group, 0, index as u32));
        }
        for (pair, _) in images.iter() {
            self.keys[*pair as usize].0 = across + 1;
        }
        self.colour(spheres, across, view);
        self.keys.sort_unstable();
        self.images = self.keys.len() - images.len();
        self.renumber(images);

        let mut start = 0;
        self.blocks.clear();
        for group in 0..count {
            let length = self.keys[start..].partition_point(|key| key.0 <= group as u32);
            self.blocks.push(Block {
                spheres: group * BLOCK..((group + 1) * BLOCK).min(spheres),
                pairs: start..start + length,
            });
            start += length;
        }
    }

    /// Positions of the pairs across blocks.
    pub fn across(&self) -> Range<usize> {
        self.blocks.last().map_or(0, |block| block.pairs.end)..self.images
    }

    /// Positions of the pairs that are swept together: those of each block, those across blocks, those with an image.
    pub fn parts(&self) -> impl Iterator<Item = Range<usize>> {
        let blocks = self.blocks.iter().map(|block| block.pairs.clone());
        blocks.chain([self.across(), self.images..self.keys.len()])
    }

    /// Numbers of the pairs before they were sorted, in the order of the sweep.
    pub fn order(&self) -> Vec<u32> {
        self.keys.iter().map(|key| key.2).collect()
    }

    /// Puts the images into the order of their pairs, which are the last ones.
    fn renumber(&self, images: &mut [ImageVelocity]) {
        let old = images.to_vec();
        for ((at, key), image) in self.keys.iter().enumerate().skip(self.images).zip(images) {
            let found = old.binary_search_by_key(&key.2, |(pair, _)| *pair);
            if let Some((_, velocity)) = found.ok().and_then(|found| old.get(found)) {
                *image = (at as u32, *velocity);
            }
        }
    }

    /// Gives each pair the first colour that neither of its spheres has yet, separately inside and across
    /// blocks. Spheres with very many contacts share the last colour.
    fn colour(&mut self, spheres: usize, across: u32, pairs: View<'_>) {
        self.taken.clear();
        self.taken.resize(2 * spheres, 0);
        for (at, key) in self.keys.iter_mut().enumerate() {
            let apart = if key.0 >= across { spheres } else { 0 };
            let Some(bodies) = pairs.bodies(at) else {
                continue;
            };
            let [a, b] = bodies.map(|body| body as usize + apart);
            let free = (self.taken[a] | self.taken[b]).trailing_ones();
            let colour = free.min(SHARED);
            self.taken[a] |= 1 << colour;
            self.taken[b] |= 1 << colour;
            key.1 = colour;
        }
    }
}
