//! Times the kernel's own batches of wrenches on twists from a file, for `benches/speed.py` to compare with.
//!
//! `batch PATCH FILE ROUNDS` prints the nanoseconds per wrench of the quickest round; the file has f64 in the
//! machine's order, three a twist.

use std::hint::black_box;
use std::time::Instant;
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::patch::outline::Polygon;
use tribos_core::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [patch, file, rounds] = arguments.as_slice() else {
        return Err("give PATCH FILE ROUNDS".into());
    };
    let bytes = std::fs::read(file)?;
    let numbers: Vec<f64> = bytes
        .as_chunks()
        .0
        .iter()
        .map(|&bytes| f64::from_ne_bytes(bytes))
        .collect();
    let rows = numbers.as_chunks::<3>().0.iter();
    let twists: Vec<Twist<f64>> = rows.map(|&[x, y, spin]| Twist::new(x, y, spin)).collect();
    let mut wrenches = vec![Wrench::ZERO; twists.len()];
    let rounds: u32 = rounds.parse()?;
    let quickest = |work: &mut dyn FnMut()| {
        let times = (0..rounds).map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        });
        times.fold(f64::INFINITY, f64::min)
    };
    let seconds = match patch.as_str() {
        "disk" => {
            let disk = RoundFriction::new(CoulombDisk, 0.3, 0.04)?;
            quickest(&mut || disk.wrench_batch(black_box(1.7), &twists, black_box(&mut wrenches)))
        }
        "square" => {
            let half = 0.04;
            let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
            let square = ShapeFriction::new(Polygon::new(corners)?, 0.3)?;
            quickest(&mut || {
                for (wrench, twist) in black_box(&mut wrenches).iter_mut().zip(&twists) {
                    *wrench = square.wrench(black_box(1.7), twist);
                }
            })
        }
        _ => return Err(format!("there are disk and square, not {patch}").into()),
    };
    println!("{}", seconds / twists.len() as f64 * 1e9);
    Ok(())
}
