//! Parts of a step: forces over the listed pairs, and occasionally a new list.

use super::melt::SKIN;
use super::problems::TimedRun;
use crate::clock::Clock;
use nalgebra::Vector3;
use std::hint::black_box;
use tribos::md::interaction::{Evaluation, Interaction};
use tribos::md::neighbours::VerletList;

/// Least time of a sample in s.
const SAMPLE: f64 = 0.05;

/// Times in s.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    /// Pairs listed.
    pub pairs: f64,
    /// Forces of all pairs.
    pub forces: f64,
    /// Making the list.
    pub list: f64,
}

/// For the atoms at the end of a run.
pub fn measure(ran: &TimedRun) -> Result<Parts, String> {
    let interaction = &ran.interaction;
    let list = VerletList::new(ran.space, interaction.cutoff(), SKIN);
    let mut list = list.map_err(|error| error.to_string())?;
    let (places, species) = (&ran.atoms.positions, &ran.atoms.species);
    let told = list.update(places, species);
    told.map_err(|error| error.to_string())?;
    let pairs: usize = list.chunks_mut().iter().map(|chunk| chunk.pairs()).sum();
    let mut forces = vec![Vector3::zeros(); ran.atoms.len()];
    let forces = once(|| {
        black_box(interaction.forces(&mut list, black_box(&mut forces), Evaluation::Forces));
    });
    let list = once(|| {
        // It was built once: it will be again.
        let _ = black_box(list.build(black_box(places), species));
    });
    Ok(Parts {
        pairs: pairs as f64,
        forces,
        list,
    })
}

/// Mean time of one call.
fn once(mut call: impl FnMut()) -> f64 {
    call();
    let (clock, mut calls) = (Clock::start(), 0.0);
    loop {
        call();
        calls += 1.0;
        let seconds = clock.seconds();
        if seconds > SAMPLE {
            return seconds / calls;
        }
    }
}
