//! Checkpoints that were damaged: none is gone on from.

use tribos::powder::PowderSimulation;
use tribos::random::Random;
use tribos::run::Simulation;
use tribos::scene::{PowderScene, TipScene};
use tribos::tip::TipSimulation;

const POWDER: &str = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmu_rolling = 0.1";
const TIP: &str = "body = \"tip\"\nlambda = 0.02\nsubstrate_columns = 8\nsubstrate_rows = 8\ntip_side_atoms = 2\n\
                   substrate_layers = 4\ntip_layers = 4\nequilibration = 0.1\ndrive_time = 0.1\n\
                   rest_time = 0.1\nsample_every = 5\n";
/// Damaged copies of each kind of run.
const COPIES: u64 = 1000;

fn powder() -> PowderScene {
    PowderScene::parse("powder.toml", POWDER, &[]).expect("a powder")
}

fn tip() -> TipScene {
    TipScene::parse("tip.toml", TIP, &[]).expect("a tip")
}

/// A damaged copy: bits, a block of zeros, a block twice, a cut, or a block of another checkpoint.
fn damaged(whole: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    let mut below = |bound: usize| (random.unit() * bound as f64) as usize;
    let mut copy = whole.to_vec();
    let at = below(whole.len());
    let length = 1 + below(4096).min(whole.len() - at - 1);
    match below(7) {
        0 | 1 => copy[at] ^= 1 << below(8),
        2 => copy[at..at + length].fill(0),
        3 => copy[at..at + length].fill(b'0'),
        4 => {
            let block = whole[at..at + length].to_vec();
            copy.splice(at..at, block);
        }
        5 => copy.truncate(at),
        _ => {
            let end = (at + length).min(other.len());
            let start = at.min(end);
            copy.splice(at..at + length, other[start..end].iter().copied());
        }
    }
    copy
}

/// How many damaged copies are read, of how many that differ from the whole.
fn read(whole: &str, other: &str, reads: impl Fn(&str) -> bool) -> [usize; 2] {
    assert!(reads(whole));
    let mut random = Random::new(7, 0);
    let mut counts = [0; 2];
    for _ in 0..COPIES {
        let copy = damaged(whole.as_bytes(), other.as_bytes(), &mut random);
        if copy == whole.as_bytes() {
            continue;
        }
        counts[1] += 1;
        // What is no text is refused before it is a checkpoint.
        let is_read = String::from_utf8(copy).is_ok_and(|text| reads(&text));
        counts[0] += usize::from(is_read);
    }
    counts
}

#[test]
fn no_damaged_checkpoint_of_a_powder_is_read() {
    let scene = powder();
    let mut run = PowderSimulation::new(&scene).unwrap();
    let mut kept = Vec::new();
    for _ in 0..2 {
        for _ in 0..30 {
            run.step().unwrap();
        }
        kept.push(run.checkpoint());
    }
    let [taken, tried] = read(&kept[0], &kept[1], |text| {
        PowderSimulation::resume(&scene, text).is_ok()
    });
    assert_eq!(taken, 0);
    assert!(tried > 900, "{tried}");
}

#[test]
fn no_damaged_checkpoint_of_a_tip_is_read() {
    let scene = tip();
    let mut run = TipSimulation::new(&scene).unwrap();
    let mut kept = Vec::new();
    for _ in 0..2 {
        for _ in 0..3 {
            run.step().unwrap();
        }
        kept.push(run.checkpoint());
    }
    let [taken, tried] = read(&kept[0], &kept[1], |text| {
        TipSimulation::resume(&scene, text).is_ok()
    });
    assert_eq!(taken, 0);
    assert!(tried > 900, "{tried}");
    // Nor one of the other kind of run.
    assert!(PowderSimulation::resume(&powder(), &kept[0]).is_err());
}
