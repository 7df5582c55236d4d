//! The header of manifold friction has the bits of the kernel, in every language it claims.

use crate::programs::{folder, has, printed, scratch};
use std::path::Path;
use std::process::Command;
use tribos_core::manifold_friction::{
    FrictionImpulse, FrictionLimits, InverseEffectiveMasses, IsotropicLimitCurve, ManifoldArea,
    project_friction,
};

/// The generator and hash of `manifold.c`.
struct Digest {
    state: u64,
    hash: u64,
}

impl Digest {
    fn bits(&mut self) -> u32 {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005);
        self.state = self.state.wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 32) as u32
    }

    fn size(&mut self) -> f32 {
        let bits = self.bits();
        (bits >> 8) as f32 / 16_777_216.0 * (1_u32 << (bits & 15)) as f32 / 4096.0
    }

    fn either(&mut self) -> f32 {
        let size = self.size();
        if self.bits() & 1 == 1 { size } else { -size }
    }

    fn feed(&mut self, x: f32) {
        let bits = if x.is_nan() { 0x7fc0_0000 } else { x.to_bits() };
        for byte in bits.to_le_bytes() {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    fn impulse(&mut self, impulse: &FrictionImpulse<f32>) {
        let [p1, p2] = impulse.tangential;
        [p1, p2, impulse.angular]
            .into_iter()
            .for_each(|x| self.feed(x));
    }
}

fn of_the_kernel() -> u64 {
    let mut digest = Digest {
        state: 5,
        hash: 0xcbf2_9ce4_8422_2325,
    };
    let compact = [
        IsotropicLimitCurve::area(),
        IsotropicLimitCurve::points(),
        IsotropicLimitCurve::ellipsoid(),
    ];
    for _ in 0..4000 {
        let count = (digest.bits() % 6) as usize;
        let mut corners = [[0.0; 2]; 5];
        for corner in &mut corners[..count] {
            *corner = [digest.size(), digest.size()];
        }
        let area = ManifoldArea::of_corners(&corners[..count]);
        let [x, y] = area.centre;
        let matrices = area
            .outline
            .spinning
            .into_iter()
            .chain(area.outline.slipping);
        [x, y, area.torsion_radius]
            .into_iter()
            .chain(matrices)
            .for_each(|x| digest.feed(x));
        let inverse = InverseEffectiveMasses {
            tangential: digest.size(),
            angular: digest.size() * 1024.0,
        };
        let (force, lever) = (digest.size(), digest.size());
        let slip = if digest.bits() & 1 == 1 { 1.0 } else { 0.75 };
        let budget = FrictionLimits {
            impulse: force,
            torsion_radius: lever,
            dynamic_over_static: slip,
        };
        let tangential = [digest.either(), digest.either()];
        let candidate = FrictionImpulse {
            tangential,
            angular: digest.either(),
        };
        for outline in &compact {
            digest.impulse(&project_friction(&candidate, &budget, &inverse, outline));
        }
        digest.impulse(&project_friction(
            &candidate,
            &budget,
            &inverse,
            &area.outline,
        ));
    }
    digest.hash
}

fn compiled(compiler: &str, flags: &[&str], source: &Path, program: &Path) -> bool {
    if !has(compiler) {
        return false;
    }
    let mut cc = Command::new(compiler);
    cc.current_dir(folder("examples")).args(flags);
    cc.args([
        "-Wall",
        "-Wextra",
        "-Werror",
        "-pedantic",
        "-O2",
        "-ffp-contract=off",
    ]);
    cc.arg("-I../include").arg(source);
    cc.args(["-lm", "-o"]).arg(program);
    let output = cc.output().expect("a compiler");
    assert!(
        output.status.success(),
        "{cc:?}\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    true
}

#[test]
fn the_header_of_manifold_friction_has_the_kernels_bits() {
    let wanted = format!("{:016x}\n", of_the_kernel());
    let source = Path::new("manifold.c");
    for (compiler, flags) in [
        ("cc", &["-std=c99"][..]),
        ("cc", &["-std=c99", "-march=native"]),
        ("c++", &["-x", "c++", "-std=c++17"]),
        // What a device's compiler wants before each function.
        ("cc", &["-std=c99", "-DTRIBOS_FN=static __inline__"]),
    ] {
        let program = scratch("manifold");
        if compiled(compiler, flags, source, &program) {
            assert_eq!(
                printed(&mut Command::new(&program)),
                wanted,
                "{compiler} {flags:?}"
            );
        }
    }
    let program = scratch("manifold-aarch64");
    let flags = ["-std=c99", "-static"];
    if has("qemu-aarch64") && compiled("aarch64-linux-gnu-gcc", &flags, source, &program) {
        let mut emulated = Command::new("qemu-aarch64");
        assert_eq!(printed(emulated.arg(&program)), wanted, "NEON");
    }
}

#[test]
fn the_program_of_the_page_prints_what_follows_it() {
    let page = folder("../../docs/inside-an-engine.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let (_, after) = page.split_once("```c\n").expect("a program");
    let (program, after) = after.split_once("```\n").expect("its end");
    let (_, said) = after.split_once("```text\n").expect("what it prints");
    let (said, _) = said.split_once("```\n").expect("its end");
    let (source, built) = (scratch("inside-an-engine.c"), scratch("inside-an-engine"));
    std::fs::write(&source, program).expect("a file");
    if compiled("cc", &["-std=c99"], &source, &built) {
        assert_eq!(printed(&mut Command::new(&built)), said);
    }
}
