//! Batches have the bits of single calls, and write no more than they are asked for.

use std::fmt::Debug;
use tribos_c::status::tribos_status;
use tribos_c::table::{tribos_power_table_f32, tribos_power_table_f64};
use tribos_c::{double, single};

/// More twists than two conversions take, so that every remainder occurs.
const MOST: usize = 40;
/// Components out of the ordinary: zeros of both signs, no number, ends of the number range.
const ODD: [f64; 8] = [
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    1e-310,
    1e300,
    -1e-30,
    -3.0,
];
const ALPHA: f32 = 0.375;
const COEFFICIENT: f32 = 0.3;
const RADIUS: f32 = 0.04;
const LOAD: f32 = 1.7;

/// Components of twist `n`. The first half of the twists is ordinary, so that groups go in lanes.
fn components(n: usize) -> [f64; 3] {
    [0, 1, 2].map(|i| {
        let k = 3 * n + i;
        let step = (7 * k + k * k) % 23;
        if n > MOST / 2 && step < 6 {
            ODD[k % ODD.len()]
        } else {
            (step as f64 - 10.5) * (0.1 + (k % 5) as f64)
        }
    })
}

/// Panics unless each number of elements gives the results of `one`, and leaves the memory behind them. Texts
/// have all digits, and tell zeros of either sign apart.
fn compare<O: Copy + Debug>(
    kept: O,
    one: impl Fn(usize, *mut O) -> tribos_status,
    batch: impl Fn(usize, *mut O) -> tribos_status,
) {
    let singly: [O; MOST] = core::array::from_fn(|n| {
        let mut result = kept;
        assert_eq!(one(n, &mut result), tribos_status::Ok);
        result
    });
    for count in 0..=MOST {
        let (mut wanted, mut got) = ([kept; MOST], [kept; MOST]);
        wanted[..count].copy_from_slice(&singly[..count]);
        assert_eq!(batch(count, got.as_mut_ptr()), tribos_status::Ok);
        assert_eq!(
            format!("{got:?}"),
            format!("{wanted:?}"),
            "{count} elements"
        );
    }
}

#[test]
fn batches_in_double_precision_have_the_bits_of_single_calls() {
    use double::{
        batch::*, patch::*, patch_batch::*, patch_surface::*, planar::*, surface::*, vectors::*,
    };
    let round = tribos_round_f64 {
        coefficient: COEFFICIENT.into(),
        radius: RADIUS.into(),
    };
    let load = f64::from(LOAD);
    let twists: [_; MOST] = core::array::from_fn(|n| {
        let [x, y, spin] = components(n);
        tribos_twist_f64 { x, y, spin }
    });
    let wrench = tribos_wrench_f64 {
        x: 7.0,
        y: 7.0,
        torque: 7.0,
    };
    let jacobian = tribos_jacobian_f64 {
        rows: [[7.0; 3]; 3],
    };
    // SAFETY: all pointers point to variables, and each array has room for the twists.
    unsafe {
        let mut table = std::mem::zeroed::<tribos_power_table_f64>();
        let built = tribos_power_table_build_f64(ALPHA.into(), &mut table);
        assert_eq!(built, tribos_status::Ok);
        compare(
            wrench,
            |n, to| tribos_disk_wrench_f64(&round, load, &twists[n], to),
            |count, to| tribos_disk_wrench_batch_f64(&round, load, twists.as_ptr(), count, to),
        );
        compare(
            jacobian,
            |n, to| tribos_disk_jacobian_f64(&round, load, &twists[n], to),
            |count, to| tribos_disk_jacobian_batch_f64(&round, load, twists.as_ptr(), count, to),
        );
        compare(
            wrench,
            |n, to| tribos_power_table_wrench_f64(&table, &round, load, &twists[n], to),
            |count, to| {
                tribos_power_table_wrench_batch_f64(
                    &table,
                    &round,
                    load,
                    twists.as_ptr(),
                    count,
                    to,
                )
            },
        );
        compare(
            jacobian,
            |n, to| tribos_power_table_jacobian_f64(&table, &round, load, &twists[n], to),
            |count, to| {
                tribos_power_table_jacobian_batch_f64(
                    &table,
                    &round,
                    load,
                    twists.as_ptr(),
                    count,
                    to,
                )
            },
        );
        // Wrenches and bodies, each with its load.
        let pushes: [_; MOST] = core::array::from_fn(|n| {
            let [x, y, torque] = components(MOST - n);
            tribos_wrench_f64 { x, y, torque }
        });
        let loads: [_; MOST] = core::array::from_fn(|n| [0.0, 1.0, 1.7, 5.0, 30.0][n % 5]);
        let surface = |load| tribos_disk_surface_f64 {
            force_limit: round.coefficient * load,
            radius: round.radius,
        };
        let unit = surface(1.0);
        let (nearest, twist) = (
            tribos_projection_f64 {
                wrench,
                normal: twists[0],
                slides: 7,
            },
            twists[0],
        );
        let (given, pushed) = (loads.as_ptr(), pushes.as_ptr());
        compare(
            nearest,
            |n, to| tribos_disk_surface_project_f64(&surface(loads[n]), &pushes[n], 0.0, to),
            |count, to| tribos_disk_surface_project_batch_f64(&unit, given, pushed, count, 0.0, to),
        );
        compare(
            nearest,
            |n, to| tribos_hertz_project_f64(&round, loads[n], &pushes[n], 0.5, to),
            |count, to| tribos_hertz_project_batch_f64(&round, given, pushed, count, 0.5, to),
        );
        let body = tribos_planar_body_f64 {
            mass: 0.5,
            inertia: 0.25,
        };
        compare(
            tribos_planar_step_f64 {
                twist,
                friction: wrench,
                is_at_rest: 7,
            },
            |n, to| {
                let disk = surface(loads[n]);
                tribos_planar_disk_step_f64(&body, &disk, &twists[n], &pushes[n], 0.125, to)
            },
            |count, to| {
                let moved = twists.as_ptr();
                tribos_planar_disk_step_batch_f64(
                    &body, &unit, given, moved, pushed, count, 0.125, to,
                )
            },
        );
    }
}

#[test]
fn batches_in_single_precision_have_the_bits_of_single_calls() {
    use single::{
        batch::*, patch::*, patch_batch::*, patch_surface::*, planar::*, surface::*, vectors::*,
    };
    let round = tribos_round_f32 {
        coefficient: COEFFICIENT,
        radius: RADIUS,
    };
    let load = LOAD;
    let twists: [_; MOST] = core::array::from_fn(|n| {
        let [x, y, spin] = components(n).map(|component| component as f32);
        tribos_twist_f32 { x, y, spin }
    });
    let wrench = tribos_wrench_f32 {
        x: 7.0,
        y: 7.0,
        torque: 7.0,
    };
    let jacobian = tribos_jacobian_f32 {
        rows: [[7.0; 3]; 3],
    };
    // SAFETY: all pointers point to variables, and each array has room for the twists.
    unsafe {
        let mut table = std::mem::zeroed::<tribos_power_table_f32>();
        let built = tribos_power_table_build_f32(ALPHA, &mut table);
        assert_eq!(built, tribos_status::Ok);
        compare(
            wrench,
            |n, to| tribos_disk_wrench_f32(&round, load, &twists[n], to),
            |count, to| tribos_disk_wrench_batch_f32(&round, load, twists.as_ptr(), count, to),
        );
        compare(
            jacobian,
            |n, to| tribos_disk_jacobian_f32(&round, load, &twists[n], to),
            |count, to| tribos_disk_jacobian_batch_f32(&round, load, twists.as_ptr(), count, to),
        );
        compare(
            wrench,
            |n, to| tribos_power_table_wrench_f32(&table, &round, load, &twists[n], to),
            |count, to| {
                tribos_power_table_wrench_batch_f32(
                    &table,
                    &round,
                    load,
                    twists.as_ptr(),
                    count,
                    to,
                )
            },
        );
        compare(
            jacobian,
            |n, to| tribos_power_table_jacobian_f32(&table, &round, load, &twists[n], to),
            |count, to| {
                tribos_power_table_jacobian_batch_f32(
                    &table,
                    &round,
                    load,
                    twists.as_ptr(),
                    count,
                    to,
                )
            },
        );
        // Wrenches and bodies, each with its load.
        let pushes: [_; MOST] = core::array::from_fn(|n| {
            let [x, y, torque] = components(MOST - n).map(|component| component as f32);
            tribos_wrench_f32 { x, y, torque }
        });
        let loads: [_; MOST] = core::array::from_fn(|n| [0.0, 1.0, 1.7, 5.0, 30.0][n % 5]);
        let surface = |load| tribos_disk_surface_f32 {
            force_limit: round.coefficient * load,
            radius: round.radius,
        };
        let unit = surface(1.0);
        let (nearest, twist) = (
            tribos_projection_f32 {
                wrench,
                normal: twists[0],
                slides: 7,
            },
            twists[0],
        );
        let (given, pushed) = (loads.as_ptr(), pushes.as_ptr());
        compare(
            nearest,
            |n, to| tribos_disk_surface_project_f32(&surface(loads[n]), &pushes[n], 0.0, to),
            |count, to| tribos_disk_surface_project_batch_f32(&unit, given, pushed, count, 0.0, to),
        );
        compare(
            nearest,
            |n, to| tribos_hertz_project_f32(&round, loads[n], &pushes[n], 0.5, to),
            |count, to| tribos_hertz_project_batch_f32(&round, given, pushed, count, 0.5, to),
        );
        let body = tribos_planar_body_f32 {
            mass: 0.5,
            inertia: 0.25,
        };
        compare(
            tribos_planar_step_f32 {
                twist,
                friction: wrench,
                is_at_rest: 7,
            },
            |n, to| {
                let disk = surface(loads[n]);
                tribos_planar_disk_step_f32(&body, &disk, &twists[n], &pushes[n], 0.125, to)
            },
            |count, to| {
                let moved = twists.as_ptr();
                tribos_planar_disk_step_batch_f32(
                    &body, &unit, given, moved, pushed, count, 0.125, to,
                )
            },
        );
    }
}
