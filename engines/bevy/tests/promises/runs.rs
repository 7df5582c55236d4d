//! Two runs of the same scene.

use crate::table::*;
use bevy::prelude::*;

/// The bits of all motions of eight pucks that collide, step by step.
fn run() -> Vec<[u32; 9]> {
    let mut table = Table::level();
    let pucks: Vec<_> = (0..8)
        .map(|n| {
            let n = n as f32;
            let place = Vec3::new(0.2 * n, 0.0, 0.03 * n);
            let puck = table.puck(place, Vec3::new(1.0 - 0.3 * n, 0.0, 0.1), 5.0 * n);
            table.give(puck, disk(MU));
            puck
        })
        .collect();
    let mut all = Vec::new();
    for _ in 0..120 {
        table.steps(1);
        for &puck in &pucks {
            let [linear, angular] = table.velocity(puck);
            let mut bits = [0; 9];
            let numbers = [table.place(puck), linear, angular].map(|vector| vector.to_array());
            for (bits, number) in bits.iter_mut().zip(numbers.as_flattened()) {
                *bits = number.to_bits();
            }
            all.push(bits);
        }
    }
    all
}

#[test]
fn two_runs_have_the_same_bits() {
    assert!(run() == run());
}
