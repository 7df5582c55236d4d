//! Feet at points, far beyond what they carry: friction of a small time step.

use tribos_c::double::nodes::tribos_node_f64;
use tribos_c::double::patch_surface::{tribos_nodes_gauge_f64, tribos_nodes_project_f64};
use tribos_c::double::surface::tribos_projection_f64;
use tribos_c::double::vectors::{tribos_twist_f64, tribos_wrench_f64};
use tribos_c::status::tribos_status;

/// mu N of four feet, in N.
const LIMIT: f64 = 15.0;
/// Wrench in units of the limit, as 5 kg at some m/s need to stop in 1 ms to 1 ns.
const TIMES: [f64; 4] = [1e3, 1e5, 1e7, 1e9];

#[test]
fn what_feet_are_brought_to_is_no_more_than_they_carry() {
    let nodes = [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]
        .map(|[x, y]| tribos_node_f64 { x, y, weight: 1.0 });
    for times in TIMES {
        for k in 0..100 {
            let angle = f64::from(k) * 0.61;
            let size = times * LIMIT;
            let wrench = tribos_wrench_f64 {
                x: size * angle.cos(),
                y: size * angle.sin(),
                torque: 0.5 * size * (3.0 * angle).sin(),
            };
            let mut nearest = tribos_projection_f64 {
                wrench,
                normal: tribos_twist_f64 {
                    x: 0.0,
                    y: 0.0,
                    spin: 0.0,
                },
                slides: 0,
            };
            let mut gauge = 0.0;
            // SAFETY: all pointers are to live values of their types.
            let said = unsafe {
                [
                    tribos_nodes_project_f64(
                        nodes.as_ptr(),
                        4,
                        LIMIT,
                        &wrench,
                        0.245,
                        &mut nearest,
                    ),
                    tribos_nodes_gauge_f64(nodes.as_ptr(), 4, LIMIT, &nearest.wrench, &mut gauge),
                ]
            };
            assert_eq!(said, [tribos_status::Ok; 2]);
            assert_eq!(nearest.slides, 1);
            assert!(gauge < 1.0 + 1e-9, "{times} limits, {angle} rad: {gauge}");
        }
    }
}
