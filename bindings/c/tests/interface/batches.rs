//! Batches have the bits of single calls, and write no more than they are asked for.

use std::fmt::Debug;
use tribos_c::status::tribos_status;
use tribos_c::table::{tribos_power_table_f32, tribos_power_table_f64};
use tribos_core::real::Real;

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
const ALPHA: f64 = 0.375;
const COEFFICIENT: f64 = 0.3;
const RADIUS: f64 = 0.04;
const LOAD: f64 = 1.7;

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

/// A test of one precision. The other has other suffixes: of types, of the build, of single calls with their batches.
macro_rules! same_bits {
    (
        $test:ident: $half:ident, $real:ty,
        [$round:ident, $twist:ident, $wrench:ident, $jacobian:ident, $table:ident],
        [$surface:ident, $projection:ident, $body:ident, $step:ident],
        $table_build:ident,
        [$disk_wrench:ident, $disk_wrenches:ident], [$disk_jacobian:ident, $disk_jacobians:ident],
        [$table_wrench:ident, $table_wrenches:ident], [$table_jacobian:ident, $table_jacobians:ident],
        [$disk_project:ident, $disk_projects:ident], [$hertz_project:ident, $hertz_projects:ident],
        [$disk_step:ident, $disk_steps:ident]
    ) => {
        #[test]
        fn $test() {
            use tribos_c::$half::{batch::*, patch::*, patch_batch::*, patch_surface::*};
            use tribos_c::$half::{planar::*, surface::*, vectors::*};
            let of = <$real as Real>::from_f64;
            let parts = |n| components(n).map(of);
            let (round, load) = (
                $round {
                    coefficient: of(COEFFICIENT),
                    radius: of(RADIUS),
                },
                of(LOAD),
            );
            let twists: [_; MOST] = core::array::from_fn(|n| {
                let [x, y, spin] = parts(n);
                $twist { x, y, spin }
            });
            let wrench = $wrench {
                x: 7.0,
                y: 7.0,
                torque: 7.0,
            };
            let jacobian = $jacobian {
                rows: [[7.0; 3]; 3],
            };
            let moved = twists.as_ptr();
            // SAFETY: all pointers point to variables, and each array has room for the twists.
            unsafe {
                let mut table = std::mem::zeroed::<$table>();
                assert_eq!($table_build(of(ALPHA), &mut table), tribos_status::Ok);
                compare(
                    wrench,
                    |n, to| $disk_wrench(&round, load, &twists[n], to),
                    |count, to| $disk_wrenches(&round, load, moved, count, to),
                );
                compare(
                    jacobian,
                    |n, to| $disk_jacobian(&round, load, &twists[n], to),
                    |count, to| $disk_jacobians(&round, load, moved, count, to),
                );
                compare(
                    wrench,
                    |n, to| $table_wrench(&table, &round, load, &twists[n], to),
                    |count, to| $table_wrenches(&table, &round, load, moved, count, to),
                );
                compare(
                    jacobian,
                    |n, to| $table_jacobian(&table, &round, load, &twists[n], to),
                    |count, to| $table_jacobians(&table, &round, load, moved, count, to),
                );
                // Wrenches and bodies, each with its load.
                let pushes: [_; MOST] = core::array::from_fn(|n| {
                    let [x, y, torque] = parts(MOST - n);
                    $wrench { x, y, torque }
                });
                let loads: [_; MOST] = core::array::from_fn(|n| [0.0, 1.0, 1.7, 5.0, 30.0][n % 5]);
                let (given, pushed) = (loads.as_ptr(), pushes.as_ptr());
                let surface = |load| $surface {
                    force_limit: round.coefficient * load,
                    radius: round.radius,
                };
                let unit = surface(1.0);
                let nearest = $projection {
                    wrench,
                    normal: twists[0],
                    slides: 7,
                };
                compare(
                    nearest,
                    |n, to| $disk_project(&surface(loads[n]), &pushes[n], 0.0, to),
                    |count, to| $disk_projects(&unit, given, pushed, count, 0.0, to),
                );
                compare(
                    nearest,
                    |n, to| $hertz_project(&round, loads[n], &pushes[n], 0.5, to),
                    |count, to| $hertz_projects(&round, given, pushed, count, 0.5, to),
                );
                let body = $body {
                    mass: 0.5,
                    inertia: 0.25,
                };
                compare(
                    $step {
                        twist: twists[0],
                        friction: wrench,
                        is_at_rest: 7,
                    },
                    |n, to| {
                        $disk_step(&body, &surface(loads[n]), &twists[n], &pushes[n], 0.125, to)
                    },
                    |count, to| $disk_steps(&body, &unit, given, moved, pushed, count, 0.125, to),
                );
            }
        }
    };
}

same_bits! {
    batches_in_double_precision_have_the_bits_of_single_calls: double, f64,
    [tribos_round_f64, tribos_twist_f64, tribos_wrench_f64, tribos_jacobian_f64, tribos_power_table_f64],
    [tribos_disk_surface_f64, tribos_projection_f64, tribos_planar_body_f64, tribos_planar_step_f64],
    tribos_power_table_build_f64,
    [tribos_disk_wrench_f64, tribos_disk_wrench_batch_f64],
    [tribos_disk_jacobian_f64, tribos_disk_jacobian_batch_f64],
    [tribos_power_table_wrench_f64, tribos_power_table_wrench_batch_f64],
    [tribos_power_table_jacobian_f64, tribos_power_table_jacobian_batch_f64],
    [tribos_disk_surface_project_f64, tribos_disk_surface_project_batch_f64],
    [tribos_hertz_project_f64, tribos_hertz_project_batch_f64],
    [tribos_planar_disk_step_f64, tribos_planar_disk_step_batch_f64]
}

same_bits! {
    batches_in_single_precision_have_the_bits_of_single_calls: single, f32,
    [tribos_round_f32, tribos_twist_f32, tribos_wrench_f32, tribos_jacobian_f32, tribos_power_table_f32],
    [tribos_disk_surface_f32, tribos_projection_f32, tribos_planar_body_f32, tribos_planar_step_f32],
    tribos_power_table_build_f32,
    [tribos_disk_wrench_f32, tribos_disk_wrench_batch_f32],
    [tribos_disk_jacobian_f32, tribos_disk_jacobian_batch_f32],
    [tribos_power_table_wrench_f32, tribos_power_table_wrench_batch_f32],
    [tribos_power_table_jacobian_f32, tribos_power_table_jacobian_batch_f32],
    [tribos_disk_surface_project_f32, tribos_disk_surface_project_batch_f32],
    [tribos_hertz_project_f32, tribos_hertz_project_batch_f32],
    [tribos_planar_disk_step_f32, tribos_planar_disk_step_batch_f32]
}
