//! Invalid arguments are refused with their status.

use crate::programs::{archive, compile_for_host, has, header, printed, scratch};
use std::collections::BTreeSet;
use std::ffi::CStr;
use std::fmt::Write;
use std::fs;
use std::process::Command;
use tribos_c::double::contact::*;
use tribos_c::double::feet::*;
use tribos_c::double::law::*;
use tribos_c::double::nodes::*;
use tribos_c::double::patch::*;
use tribos_c::double::polygon::*;
use tribos_c::double::shape::*;
use tribos_c::double::slider::*;
use tribos_c::double::surface::*;
use tribos_c::double::vectors::*;
use tribos_c::status::{tribos_status, tribos_status_text};
use tribos_c::table::tribos_power_compact_f64;

/// Functions that refuse numbers that are all 1 before they come to a null pointer: they make no table, edges or shape.
const REFUSE_ONES: [&str; 4] = ["_power_", "_polygon_", "_nodes_", "_shape_"];

/// Calls of one function with null for each of its pointers in turn and for all of them; the other pointers
/// point to numbers that are all 1.
fn calls(prototype: &str) -> String {
    let (name, arguments) = prototype.split_once('(').expect("a function");
    let (_, name) = name.rsplit_once(' ').expect("a type");
    let ones = if name.ends_with("_f64") {
        "doubles"
    } else {
        "floats"
    };
    let arguments: Vec<_> = arguments.split(',').collect();
    let call = |is_null: &dyn Fn(usize) -> bool| {
        let value = |(i, argument): (usize, &&str)| match argument.contains('*') {
            true if is_null(i) => "0",
            // Feet and parts name their shapes.
            true if ["_foot_", "_part_"]
                .iter()
                .any(|kind| argument.contains(kind)) =>
            {
                "feet"
            }
            true => ones,
            false if argument.contains("inner_ratio") => "0.5",
            false => "1",
        };
        let values: Vec<_> = arguments.iter().enumerate().map(value).collect();
        format!("{name}({})", values.join(", "))
    };
    let refused = if REFUSE_ONES.iter().any(|part| name.contains(part)) {
        "!= TRIBOS_STATUS_OK"
    } else {
        "== TRIBOS_STATUS_NULL_POINTER"
    };
    let mut text = format!(
        "    check(\"{name}\", {} == TRIBOS_STATUS_NULL_POINTER);\n",
        call(&|_| true)
    );
    for (null, argument) in arguments.iter().enumerate() {
        if argument.contains('*') {
            let one = call(&|i| i == null);
            let _ = writeln!(text, "    check(\"{name}\", {one} {refused});");
        }
    }
    text
}

#[test]
fn every_function_refuses_null() {
    if !has("cc") {
        return;
    }
    let Some(archive) = archive(None) else { return };
    let header = header();
    let prototypes = header
        .split(";\n")
        .filter_map(|text| text.find("\ntribos_status tribos_").map(|at| &text[at..]));
    let calls: String = prototypes.map(calls).collect();
    assert!(calls.matches("check(").count() > 500);
    let source = scratch("null.c");
    let text = format!(
        "#include \"tribos.h\"\n#include <stdio.h>\n\
         static double ones_f64[8192];\nstatic float ones_f32[8192];\n\
         static double zeros[64];\nstatic int refused = 1;\n\
         static void check(const char *name, int right)\n{{\n    if (!right) {{\n        \
         puts(name);\n        refused = 0;\n    }}\n}}\n\
         int main(void)\n{{\n    void *doubles = ones_f64, *floats = ones_f32, *feet = zeros;\n    int i;\n\n    \
         for (i = 0; i < 8192; ++i) {{\n        ones_f64[i] = 1;\n        ones_f32[i] = 1;\n    }}\n\
         {calls}    return !refused;\n}}\n"
    );
    fs::write(&source, text).expect("a file");
    let program = scratch("null");
    compile_for_host(
        &[source.to_str().expect("a plain path")],
        &archive,
        &program,
    );
    assert_eq!(printed(&mut Command::new(program)), "");
}

#[test]
fn every_status_has_its_own_number_and_text() {
    let text = |status| {
        // SAFETY: texts are constants that end with 0.
        let text = unsafe { CStr::from_ptr(tribos_status_text(status)) };
        text.to_str().expect("plain text")
    };
    let numbers: BTreeSet<_> = tribos_status::all().iter().map(|s| *s as i32).collect();
    let texts: BTreeSet<_> = numbers.iter().map(|n| text(*n)).collect();
    assert_eq!(numbers.len(), tribos_status::all().len());
    assert_eq!(texts.len(), tribos_status::all().len());
    for unknown in [-1, 5, 99, i32::MIN, i32::MAX] {
        assert_eq!(text(unknown), "no such status");
    }
    let in_header = header().matches("  TRIBOS_STATUS_").count();
    assert_eq!(in_header, tribos_status::all().len());
}

/// Bars, points, worn annuli, and several shapes as one.
unsafe fn other_shapes(expect: &mut impl FnMut(tribos_status, tribos_status)) {
    use tribos_status as S;
    let point = |x| tribos_point_f64 { x, y: 0.0 };
    let [mut shape, mut all] = [std::mem::zeroed::<tribos_shape_f64>(); 2];
    let mut bar = |x, lean| tribos_shape_bar_f64(&point(0.0), &point(x), lean, &mut shape);
    expect(bar(0.0, 0.0), S::Outline);
    expect(bar(6.0, 1.1), S::Negative);
    expect(bar(6.0, f64::NAN), S::NotFinite);
    expect(bar(6.0, -1.0), S::Ok);
    let mut points = |x, weight| {
        let mut nodes =
            [[0.0, 1.0], [x, weight]].map(|[x, weight]| tribos_node_f64 { x, y: 0.0, weight });
        tribos_shape_points_f64(nodes.as_mut_ptr(), 2, &mut shape)
    };
    expect(points(0.0, 1.0), S::FeetInLine);
    expect(points(1.0, -1.0), S::NodeWeight);
    let mut worn = |ratio| tribos_shape_worn_annulus_f64(&point(0.0), ratio, 1.0, &mut shape);
    expect(worn(1.0), S::InnerRatio);
    expect(worn(0.5), S::Ok);
    let two = |shape| tribos_shape_two_coefficients_f64(shape, 1.0, 2.0, &point(1.0));
    expect(two(&mut shape), S::Choice);
    let part = |shape, limit| tribos_part_f64 { shape, limit };
    let mut feet = |limit| tribos_shape_feet_f64(&part(&shape, limit), 1, &mut all);
    expect(feet(0.0), S::Unloaded);
    expect(feet(-1.0), S::NodeWeight);
    expect(feet(1.0), S::Ok);
    let own = part(&raw const shape, 1.0);
    expect(tribos_shape_feet_f64(&own, 1, &mut shape), S::Choice);
    expect(
        tribos_shape_feet_f64(&part(&all, 1.0), 1, &mut shape),
        S::Choice,
    );
    let mut unbuilt = std::mem::zeroed::<tribos_shape_f64>();
    let own = part(&raw const unbuilt, 1.0);
    expect(tribos_shape_feet_f64(&own, 1, &mut unbuilt), S::NotBuilt);
    expect(two(&mut all), S::Choice);
}

/// Shapes and feet.
unsafe fn shapes(expect: &mut impl FnMut(tribos_status, tribos_status)) {
    use tribos_status as S;
    let point = |x, y| tribos_point_f64 { x, y };
    let (origin, uniform) = (point(0.0, 0.0), 1);
    let mut shape = std::mem::zeroed::<tribos_shape_f64>();
    let mut ellipse =
        |pressure, a, b| tribos_shape_ellipse_f64(pressure, &origin, &point(a, b), &mut shape);
    expect(ellipse(uniform, 1.0, 0.0), S::SemiAxes);
    expect(ellipse(uniform, 1.0, 1e-7), S::SemiAxes);
    expect(ellipse(4, 1.0, 0.5), S::Choice);
    let rest = tribos_twist_f64 {
        x: 0.0,
        y: 0.0,
        spin: 0.0,
    };
    let mut wrench = tribos_wrench_f64 {
        x: 7.0,
        y: 7.0,
        torque: 7.0,
    };
    let foot = |shape, limit, surface| tribos_foot_f64 {
        shape,
        limit,
        surface,
    };
    let unbuilt = foot(&shape, 1.0, rest);
    expect(
        tribos_feet_wrench_f64(&unbuilt, 1, &rest, &mut wrench),
        S::NotBuilt,
    );
    let nothing = foot(std::ptr::null(), 1.0, rest);
    expect(
        tribos_feet_wrench_f64(&nothing, 1, &rest, &mut wrench),
        S::NullPointer,
    );
    expect(
        tribos_shape_ellipse_f64(uniform, &origin, &point(1.0, 0.5), &mut shape),
        S::Ok,
    );
    let mut two =
        |along, x| tribos_shape_two_coefficients_f64(&mut shape, along, 1.0, &point(x, 0.0));
    expect(two(0.0, 1.0), S::NotPositive);
    expect(two(1.0, 0.0), S::NotPositive);
    expect(two(1e-7, 1.0), S::SemiAxes);
    expect(two(0.5, 1.0), S::Ok);
    expect(two(0.5, 1.0), S::Axes);

    let on = |limit, x| {
        let surface = tribos_twist_f64 { x, ..rest };
        let mut motion = std::mem::zeroed::<tribos_steady_motion_f64>();
        let feet = [foot(&shape, limit, rest), foot(&shape, limit, surface)];
        move |push| {
            let push = tribos_wrench_f64 {
                x: push,
                y: 0.0,
                torque: 0.0,
            };
            tribos_feet_steady_motion_f64(feet.as_ptr(), 2, &push, &mut motion)
        }
    };
    expect(on(-1.0, 1.0)(0.0), S::ForceLimit);
    expect(on(0.0, 1.0)(0.0), S::Unloaded);
    expect(on(1.0, f64::INFINITY)(0.0), S::NotFinite);
    expect(on(1.0, 1.0)(0.1), S::Ok);
    expect(on(1.0, 1.0)(3.0), S::Accelerates);
    expect(on(1.0, 1.0)(f64::NAN), S::Missed);
    assert_eq!([wrench.x, wrench.y, wrench.torque], [7.0; 3]);
}

/// One refused call for each status.
#[test]
fn every_refusal_is_told_by_its_status() {
    use tribos_status as S;
    let mut seen = BTreeSet::from([S::Ok as i32, S::NullPointer as i32]);
    let mut expect = |got: S, wanted: S| {
        assert_eq!(got, wanted);
        seen.insert(wanted as i32);
    };
    let twist = tribos_twist_f64 {
        x: 1.0,
        y: 0.0,
        spin: 1.0,
    };
    let mut wrench = tribos_wrench_f64 {
        x: 7.0,
        y: 7.0,
        torque: 7.0,
    };
    let mut x = 7.0;
    // SAFETY: all pointers point to variables.
    unsafe {
        let patch = |coefficient, radius| tribos_round_f64 {
            coefficient,
            radius,
        };
        let mut disk = |p| tribos_disk_wrench_f64(&p, 1.0, &twist, &mut wrench);
        expect(disk(patch(-1.0, 1.0)), S::Coefficient);
        expect(disk(patch(1.0, 0.0)), S::Radius);
        let sound = patch(1.0, 1.0);
        expect(
            tribos_annulus_wrench_f64(&sound, 1.0, 1.0, &twist, &mut wrench),
            S::InnerRatio,
        );
        let mut lent = std::mem::zeroed::<tribos_power_compact_f64>();
        let unbuilt = tribos_power_compact_wrench_f64(&lent, &sound, 1.0, &twist, &mut wrench);
        expect(unbuilt, S::NotBuilt);
        let mut power = |alpha, order| tribos_power_compact_build_f64(alpha, order, &mut lent);
        expect(power(-1.0, 0.0), S::Exponent);
        expect(power(0.0, 9.0), S::PressureOrder);

        let dry = |mu_static, mu_dynamic| tribos_dry_f64 {
            mu_static,
            mu_dynamic,
        };
        expect(
            tribos_dry_friction_f64(&dry(0.1, 0.2), 1.0, &mut x),
            S::Order,
        );
        let stribeck = |stribeck_speed, viscous| tribos_stribeck_f64 {
            dry: dry(0.2, 0.1),
            stribeck_speed,
            exponent: 1.0,
            viscous,
        };
        expect(
            tribos_stribeck_friction_f64(&stribeck(0.0, 0.0), 1.0, &mut x),
            S::NotPositive,
        );
        expect(
            tribos_stribeck_friction_f64(&stribeck(1.0, -1.0), 1.0, &mut x),
            S::Negative,
        );
        expect(
            tribos_stribeck_minimum_f64(&stribeck(1.0, 0.0), &mut x),
            S::NoMinimum,
        );

        let law = tribos_coulomb_f64 { mu: 0.1 };
        let mut at = |node: tribos_node_f64, count| {
            tribos_nodes_coulomb_wrench_f64(&law, &node, count, 1.0, &twist, &mut wrench)
        };
        let node = |x, weight| tribos_node_f64 { x, y: 0.0, weight };
        expect(at(node(f64::NAN, 1.0), 1), S::NodePosition);
        expect(at(node(0.0, -1.0), 1), S::NodeWeight);
        expect(at(node(0.0, 0.0), 1), S::Unloaded);
        expect(at(node(0.0, 1.0), usize::MAX), S::Count);

        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 2.0], [5.0, 5.0]]
            .map(|[x, y]| tribos_point_f64 { x, y });
        let mut nodes = [node(0.0, 0.0); 8];
        let mut filled = 0;
        let mut polygon = |from: usize, count, divisions| {
            let corners = points[from..].as_ptr();
            tribos_polygon_nodes_f64(
                corners,
                count,
                divisions,
                nodes.as_mut_ptr(),
                8,
                &mut filled,
            )
        };
        expect(polygon(0, 3, 1), S::Ok);
        expect(polygon(0, 3, 2), S::Full);
        expect(polygon(0, 2, 1), S::Corners);
        expect(polygon(0, 3, 0), S::Divisions);
        let line = [points[0]; 3];
        let to = nodes.as_mut_ptr();
        expect(
            tribos_polygon_nodes_f64(line.as_ptr(), 3, 1, to, 8, &mut filled),
            S::Hidden,
        );
        expect(
            tribos_tripod_nodes_f64(line.as_ptr(), &points[0], to),
            S::FeetInLine,
        );
        expect(
            tribos_tripod_nodes_f64(points.as_ptr(), &points[4], to),
            S::Tips,
        );
        let mut rule = |rings, rim_exponent| {
            let rule = tribos_disk_rule_f64 {
                radius: 1.0,
                rings,
                angles: 1,
                rim_exponent,
                tilt_x: 0.0,
                tilt_y: 0.0,
            };
            tribos_disk_nodes_f64(&rule, to, 8, &mut filled)
        };
        expect(rule(0, 0.0), S::Rings);
        expect(rule(1, -1.0), S::RimExponent);

        let mut edges = [tribos_edge_f64 { opaque: [0.0; 7] }; 4];
        let mut sole = std::mem::zeroed::<tribos_polygon_f64>();
        let mut outline = |corners: &[tribos_point_f64], counts: &[usize], room| {
            let (corners, memory) = (corners.as_ptr(), edges.as_mut_ptr());
            let (counts, loops) = (counts.as_ptr(), counts.len());
            tribos_polygon_new_f64(corners, counts, loops, memory, room, &mut sole)
        };
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let square = square.map(|[x, y]| tribos_point_f64 { x, y });
        expect(outline(&square, &[4], 3), S::Full);
        expect(outline(&square, &[], 4), S::Corners);
        expect(outline(&square, &[2, 2], 4), S::Corners);
        expect(outline(&square, &[usize::MAX, 1], 4), S::Count);
        let [a, b, c, d] = square;
        expect(outline(&[a, c, b, d], &[4], 4), S::Outline);
        let nowhere = tribos_point_f64 { x: f64::NAN, ..a };
        expect(outline(&[a, b, nowhere], &[3], 4), S::NodePosition);
        let far = |x| tribos_point_f64 { x, ..c };
        let widest = [far(-f64::MAX), b, far(f64::MAX)];
        expect(outline(&widest, &[3], 4), S::NotFinite);
        expect(outline(&square, &[4], 4), S::Ok);
        let centre = |x| tribos_point_f64 { x, y: 0.5 };
        let before = edges.map(|edge| edge.opaque);
        expect(
            tribos_polygon_lean_f64(&mut sole, &centre(0.7)),
            S::Negative,
        );
        expect(
            tribos_polygon_lean_f64(&mut sole, &centre(f64::NAN)),
            S::NotFinite,
        );
        assert_eq!(
            (before, sole.centre.x),
            (edges.map(|edge| edge.opaque), 0.5)
        );
        expect(tribos_polygon_lean_f64(&mut sole, &centre(0.6)), S::Ok);
        expect(tribos_polygon_lean_f64(&mut sole, &centre(0.6)), S::Leans);
        expect(
            tribos_polygon_wrench_f64(&sole, -1.0, 1.0, &twist, &mut wrench),
            S::Coefficient,
        );
        let push = wrench;
        expect(
            tribos_polygon_gauge_f64(&sole, -1.0, &push, &mut x),
            S::ForceLimit,
        );

        shapes(&mut expect);
        other_shapes(&mut expect);

        let mut power = |force_limit, spin_torque| {
            let set = tribos_ellipsoid_f64 {
                force_limit,
                radius: 1.0,
                spin_torque,
            };
            tribos_ellipsoid_support_f64(&set, &twist, &mut x)
        };
        expect(power(-1.0, 1.0), S::ForceLimit);
        expect(power(1.0, 0.0), S::SpinTorque);

        let mut motion = tribos_motion_f64 {
            time: 0.0,
            speed: 1.0,
            spin: 1.0,
            distance: 0.0,
            angle: 0.0,
        };
        let mut step = |deceleration, inertia_ratio| {
            let slider = tribos_slider_f64 {
                deceleration,
                radius: 1.0,
                inertia_ratio,
            };
            tribos_slider_verlet_step_f64(&slider, &mut motion, 1e-3)
        };
        expect(step(0.0, 1.0), S::Deceleration);
        expect(step(1.0, 0.0), S::Inertia);
        let slider = tribos_slider_f64 {
            deceleration: 1.0,
            radius: 1.0,
            inertia_ratio: 1.0,
        };
        let mut rest = tribos_rest_f64 {
            motion,
            ratio: 0.0,
            evaluations: 0,
        };
        motion.speed = f64::INFINITY;
        expect(
            tribos_slider_to_rest_f64(&slider, &motion, &mut rest),
            S::NoRest,
        );

        let up = tribos_vector_f64 {
            x: 0.0,
            y: 0.0,
            z: 1.0,
        };
        let mut touch = tribos_touch_f64 {
            normal: up,
            gap: 0.0,
            arms: [1.0; 2],
            lever: 0.5,
        };
        expect(
            tribos_touch_plate_f64(0.0, &up, 1.0, &mut touch),
            S::NoNormal,
        );
        expect(
            tribos_touch_plate_f64(1.0, &up, 0.0, &mut touch),
            S::NotFinite,
        );
        let ball = tribos_sphere_f64 {
            velocity: up,
            spin: up,
            inv_mass: 1.0,
            inv_inertia: 1.0,
        };
        let mut contact = std::mem::zeroed::<tribos_contact_f64>();
        let mut prepare = |attraction, restitution, dt| {
            let law = tribos_normal_law_f64 {
                cohesion: 0.0,
                cohesion_range: 0.0,
                attraction,
                restitution,
            };
            tribos_contact_spheres_f64(&touch, &law, &ball, &ball, dt, &mut contact)
        };
        expect(prepare(2, 0.0, 1.0), S::Choice);
        expect(prepare(0, 2.0, 1.0), S::NotAFraction);
        expect(prepare(0, 0.0, 0.0), S::TimeStep);
    }
    // No refused call has written anything.
    assert_eq!([wrench.x, wrench.y, wrench.torque, x], [7.0; 4]);
    assert_eq!(seen.len(), tribos_status::all().len());
}
