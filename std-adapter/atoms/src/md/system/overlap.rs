//! Atoms that start on top of each other.

use super::{System, SystemError};
use crate::md::interaction::Interaction;

impl<I: Interaction> System<I> {
    /// Refuses forces that would throw an atom farther than the cut-off in the first step.
    pub(super) fn refuse_overlaps(&mut self) -> Result<(), SystemError> {
        let time_sq = self.time_step * self.time_step;
        let limit = self.interaction.cutoff();
        let is_thrown = |atom: usize| {
            let way = self.forces[atom].norm() / self.atoms.mass(atom) * time_sq;
            way.is_nan() || way > limit
        };
        if (0..self.atoms.len()).any(is_thrown) {
            let (pair, distance) = self.closest();
            return Err(SystemError::Overlap { pair, distance });
        }
        Ok(())
    }

    /// The closest pair of the list.
    fn closest(&mut self) -> ([usize; 2], f64) {
        let mut closest = ([0; 2], f64::INFINITY);
        for chunk in self.list.chunks_mut() {
            let atoms: Vec<usize> = chunk.window().iter().map(|s| s.atom as usize).collect();
            let (sites, rows) = chunk.sites_and_rows();
            for (here, blocks) in rows {
                for &there in blocks.as_flattened() {
                    let there = there as usize;
                    let [a, b] = [here, there].map(|site| sites[site].place);
                    let way: [f64; 3] = std::array::from_fn(|axis| b[axis] - a[axis]);
                    let distance = way.iter().map(|x| x * x).sum::<f64>().sqrt();
                    if distance < closest.1 {
                        closest = ([atoms[here], atoms[there]], distance);
                    }
                }
            }
        }
        closest.0.sort_unstable();
        closest
    }
}
