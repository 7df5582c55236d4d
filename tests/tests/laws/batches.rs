//! Batches have the bits of single calls.

use tribos_core::Real;
use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::coupling::round::{RoundTable32, RoundTable64};
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::patch::PowerPressure;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::batches::{GROUP, compare};

/// Inputs of each comparison of the quick test; `tests/examples/batches.rs` takes more.
const COUNT: usize = 150_000;

#[test]
fn forms_of_dry_friction_have_the_bits_of_single_calls() {
    compare::<f64, _>(&CoulombDisk, COUNT, 1);
    compare::<f32, _>(&CoulombDisk, COUNT, 2);
    compare::<f64, _>(&CoulombRing, COUNT / 2, 13);
    compare::<f32, _>(&CoulombRing, COUNT / 2, 14);
    compare::<f64, _>(&CoulombPunch, COUNT / 2, 15);
    compare::<f32, _>(&CoulombPunch, COUNT / 2, 16);
    compare::<f64, _>(&CoulombHertz, COUNT / 2, 17);
    compare::<f32, _>(&CoulombHertz, COUNT / 2, 18);
    compare::<f64, _>(&CoulombParaboloid, COUNT / 2, 19);
    compare::<f32, _>(&CoulombParaboloid, COUNT / 2, 20);
}

#[test]
fn tables_of_a_power_have_the_bits_of_single_calls() {
    for (seed, alpha) in [(3, -0.9), (4, 0.0), (5, 0.37), (6, 1.0), (7, 9.5)] {
        compare(&DiskTable64::new(alpha).unwrap(), COUNT, seed);
        compare(&DiskTable32::new(alpha as f32).unwrap(), COUNT, seed);
    }
}

#[test]
fn tables_of_round_pressures_have_the_bits_of_single_calls() {
    for (seed, alpha) in [(8, -0.5), (9, 0.0), (10, 0.37)] {
        for pressure in [PowerPressure::RING, PowerPressure::HERTZ] {
            compare(
                &RoundTable64::new(alpha, pressure).unwrap(),
                COUNT / 2,
                seed,
            );
            compare(
                &RoundTable32::new(alpha as f32, pressure).unwrap(),
                COUNT / 2,
                seed,
            );
        }
    }
}

#[test]
fn couplings_without_lanes_have_batches() {
    compare::<f64, _>(&CompactPower::new(0.5).unwrap(), COUNT / 40, 11);
    compare::<f32, _>(&CompactPower::new(0.5).unwrap(), COUNT / 40, 12);
}

/// True if an ordinary group goes in lanes.
fn goes_in_lanes<R: Real>(coupling: impl ReducedFriction<R>) -> bool {
    let speeds = [0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0].map(R::from_f64);
    let others = [0.0, 0.3, 0.4, 1.1, 1.9, 3.0, 8.0, 1.0].map(R::from_f64);
    coupling.reduced_drags(&speeds, &others).is_some()
}

#[test]
fn forms_and_tables_go_in_lanes_where_there_are_vectors() {
    let has = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));
    assert_eq!(goes_in_lanes::<f64>(CoulombDisk), has);
    assert_eq!(goes_in_lanes::<f32>(&CoulombDisk), has);
    assert_eq!(goes_in_lanes(DiskTable64::new(0.37).unwrap()), has);
    assert_eq!(goes_in_lanes(DiskTable32::new(0.37).unwrap()), has);
    assert_eq!(goes_in_lanes::<f64>(CoulombHertz), has);
    assert!(!goes_in_lanes(CompactPower::new(0.5).unwrap()));
}

#[test]
fn elements_beyond_the_shorter_slice_stay() {
    let puck = RoundFriction::new(CoulombDisk, 0.3, 0.04).unwrap();
    let twists = [Twist::new(1.0, 0.5, 3.0); GROUP + 1];
    let one = puck.wrench(1.7, &twists[0]);
    for inputs in 0..=GROUP + 1 {
        for outputs in 0..=GROUP + 1 {
            let mut wrenches = [Wrench::ZERO; GROUP + 1];
            puck.wrench_batch(1.7, &twists[..inputs], &mut wrenches[..outputs]);
            let done = inputs.min(outputs);
            assert!(wrenches[..done].iter().all(|wrench| *wrench == one));
            assert!(
                wrenches[done..]
                    .iter()
                    .all(|wrench| *wrench == Wrench::ZERO)
            );
        }
    }
}

#[test]
fn components_beyond_the_shortest_slice_stay() {
    const MOST: usize = GROUP + 1;
    let puck = RoundFriction::new(CoulombDisk, 0.3, 0.04).unwrap();
    let one = puck.wrench(1.7, &Twist::new(1.0, 0.5, 3.0));
    let (vx, vy, spins) = ([1.0; MOST], [0.5; MOST], [3.0; MOST]);
    for lengths in [
        [MOST; 6],
        [MOST, MOST, GROUP, MOST, MOST, MOST],
        [1, 2, 3, 4, 5, 6],
        [0; 6],
    ] {
        let [a, b, c, d, e, f] = lengths;
        let [mut fx, mut fy, mut torques] = [[f64::NAN; MOST]; 3];
        let twists = [&vx[..a], &vy[..b], &spins[..c]];
        puck.wrench_columns(1.7, twists, [&mut fx[..d], &mut fy[..e], &mut torques[..f]]);
        let done = lengths.into_iter().min().unwrap();
        for at in 0..MOST {
            let found = [fx[at], fy[at], torques[at]];
            if at < done {
                assert_eq!(found, [one.force.x, one.force.y, one.torque]);
            } else {
                assert!(found.iter().all(|component| component.is_nan()));
            }
        }
    }
}
