//! The C programs print what the kernel computes.

use crate::programs::{
    BOARD, archive, compile_for_board, compile_for_host, folder, has, header, printed, scratch,
};
use std::fs;
use std::path::Path;
use std::process::Command;
use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
use tribos_core::law::{Bristle, LuGre, LuGreParameters};
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_core::twist::Twist;

const DEMO: [&str; 2] = ["demo.c", "digest.c"];

/// Expected output of the demonstration, computed by the kernel itself, and of the digest.
fn expected() -> String {
    let puck = RoundFriction::new(CoulombDisk, 0.3_f32, 0.04).expect("a puck");
    let wrench = puck.wrench(1.7, &Twist::new(1.0, 0.0, 20.0));
    let joint = LuGre::new(LuGreParameters {
        coulomb_force: 1.0_f32,
        static_force: 1.5,
        stribeck_speed: 1e-3,
        stiffness: 1e5,
        bristle_damping: 316.0,
        viscous_damping: 0.4,
    });
    let joint = joint.expect("a joint");
    let (mut bristle, mut forces) = (Bristle::RELAXED, [0.0; 100]);
    for force in &mut forces {
        (bristle, *force) = joint.step(bristle, 1e-3, 1e-3);
    }
    let coin = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: 0.3 * 9.81,
            radius: 0.08,
            inertia_ratio: 0.5,
        },
    )
    .expect("a coin");
    let rest = coin.to_rest(&SliderState::launched(1.0_f64, 5.0));
    let rest = rest.expect("a rest").motion;
    format!(
        "puck: force  {:.6} N\n      torque {:.6} N m\n\
         joint: force in the first ms {:.6} N\n       force after 100 ms    {:.6} N\n\
         coin: rests after {:.6} s\n      distance    {:.6} m\n\
         mu = -0.3: the coefficient must be finite and not negative\n\
         digest {:016x}\n",
        wrench.force.x,
        wrench.torque,
        forces[0],
        forces[99],
        rest.time,
        rest.distance,
        crate::digest::digest(),
    )
}

#[test]
fn the_program_prints_the_digest_of_the_kernel_itself() {
    if !has("cc") {
        return;
    }
    let Some(archive) = archive(None) else { return };
    let program = scratch("host");
    compile_for_host(&[&["host.c"], &DEMO[..]].concat(), &archive, &program);
    assert_eq!(printed(&mut Command::new(program)), expected());
}

#[test]
fn the_board_prints_the_digest_of_the_kernel_itself() {
    let tools = ["arm-none-eabi-gcc", "qemu-system-arm"];
    if !tools.into_iter().all(has) {
        return;
    }
    let Some(archive) = archive(Some(BOARD)) else {
        return;
    };
    let image = scratch("board.elf");
    compile_for_board(&[&["board.c"], &DEMO[..]].concat(), &archive, &image);
    no_panic_is_left_in(&image);
    let mut board = Command::new("qemu-system-arm");
    board.args([
        "-M",
        "mps2-an386",
        "-nographic",
        "-monitor",
        "none",
        "-serial",
        "none",
    ]);
    board.args(["-semihosting-config", "enable=on,target=native", "-kernel"]);
    let output = board.arg(image).output().expect("an emulator");
    let said = [output.stdout, output.stderr].concat();
    assert!(output.status.success(), "{}", crate::programs::text(&said));
    assert_eq!(crate::programs::text(&said), expected());
}

/// The image calls every function of the header. If any of them could reach a panic, the image would
/// contain the panic handler.
fn no_panic_is_left_in(image: &Path) {
    let names = printed(Command::new("arm-none-eabi-nm").arg(image));
    assert!(names.contains("tribos_disk_wrench_f64"));
    let panics: Vec<_> = names
        .lines()
        .filter(|name| name.contains("panic"))
        .collect();
    assert!(panics.is_empty(), "{panics:?}");
}

#[test]
fn the_digest_calls_every_function_of_the_header() {
    let source = [
        "digest_real.h",
        "digest_polygons.h",
        "digest_shapes.h",
        "digest_surfaces.h",
    ]
    .map(|name| fs::read_to_string(folder("examples").join(name)).expect("the digest"))
    .concat();
    let mut count = 0;
    for line in header().lines() {
        let Some(rest) = line.strip_prefix("tribos_status tribos_") else {
            continue;
        };
        let (name, _) = rest.split_once('(').expect("a function");
        let name = name.strip_suffix("_f64").or(name.strip_suffix("_f32"));
        let call = format!("NAME({})(", name.expect("a precision"));
        assert!(source.contains(&call), "{call} is not in the digest");
        count += 1;
    }
    assert!(count >= 150, "{count} functions");
}

#[test]
fn the_examples_of_the_documentation_run() {
    if !has("cc") {
        return;
    }
    let Some(archive) = archive(None) else { return };
    let pages = ["c.md", "puck.md"].map(|name| folder("../../docs").join(name));
    let pages = pages.map(|page| fs::read_to_string(page).expect("a page"));
    let examples = pages.iter().flat_map(|page| page.split("```c\n").skip(1));
    let mut count = 0;
    for example in examples {
        let (example, after) = example.split_once("```").expect("its end");
        let source = scratch("page.c");
        fs::write(&source, example).expect("a file");
        let program = scratch("page");
        let file = source.to_str().expect("a plain path");
        compile_for_host(&[file], &archive, &program);
        let said = printed(&mut Command::new(program));
        let told = ["prints `", "```text\n"].map(|quote| format!("{quote}{}", said.trim_end()));
        assert!(
            told.iter().any(|told| after.trim_start().starts_with(told)),
            "{said}"
        );
        count += 1;
    }
    assert!(count >= 5, "{count} programs");
}
