//! One bare-metal program an item, written and built.

use super::items::Item;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A microcontroller with single-precision floating point in hardware.
pub const TARGET: &str = "thumbv7em-none-eabihf";

/// How far the compiler optimises, and the cargo profile for it.
pub const LEVELS: [(&str, &str); 2] = [("3", "release"), ("s", "small")];

const MANIFEST: &str = r#"[package]
name = "flash-programs"
version = "0.0.0"
edition = "2024"
publish = false

[workspace]

[dependencies]
tribos-core = { path = "CORE" }
# Of the version in the lock file.
nalgebra = { version = "*", default-features = false, features = ["libm-force"] }

# Debug records tell which functions were inlined; they take no flash.
[profile.release]
opt-level = 3
lto = "fat"
codegen-units = 1
panic = "abort"
debug = 1

[profile.small]
inherits = "release"
opt-level = "s"
"#;

const PROGRAM: &str = r#"#![no_std]
#![no_main]
#![allow(unused, clippy::all)]
use core::hint::black_box;
use calls::*;
use nalgebra::Vector3;
use tribos_core::contact::{Body, Cohesion, Contact, ContactFriction, CoupledFriction, NormalLaw, Plate, Sphere, Thresholds, TimeStep, Touch};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::tall::{AllRound, FrontBack, TallFriction};
use tribos_core::coupling::{Annulus, Coupling, PatchFriction, closed, compact, round, table};
use tribos_core::law::*;
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use tribos_core::manifold::{Manifold, Start, Stop};
use tribos_core::modes::Modes;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::patch::polar::{self, PolarRule};
use tribos_core::patch::polygon::polygon;
use tribos_core::patch::tripod::tripod;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::slider::{Motion, Slider};
use tribos_core::twist::{Twist, Wrench};

type R = PRECISION;
type Table = table::TableBITS;
type RoundTable = round::RoundTableBITS;

mod calls {
    use super::*;
    pub fn couple(coupling: &impl Coupling<R>, a: R, b: R) -> Option<R> {
        let wrench = coupling.reduced_wrench(a, b);
        Some(wrench.force + wrench.torque)
    }
    pub fn on_nodes(patch: impl NodePatch<R>, a: R, b: R) -> Option<R> {
        let friction = NodeFriction::new(Coulomb::new(0.5).ok()?, patch);
        Some(friction.wrench(a, &Twist::new(a, b, b)).torque)
    }
    pub fn disk() -> Option<PatchFriction<R, table::Coulomb>> {
        PatchFriction::new(table::Coulomb, 0.5, 0.0625).ok()
    }
    pub fn slider() -> Option<Slider<R, table::Coulomb>> {
        Slider::new(table::Coulomb, 3.0, 0.0625, 0.5).ok()
    }
    pub fn push(a: R, b: R) -> Wrench<R> {
        let Twist { velocity, spin } = Twist::new(a, b, b);
        Wrench { force: velocity, torque: spin }
    }
    pub fn ball(a: R, b: R) -> Sphere<R> {
        let still = Vector3::new(a, b, -b);
        Sphere { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 2.5 }
    }
    pub fn floor() -> Plate<R> {
        Plate { velocity: Vector3::new(0.0, 0.0, 0.0), inv_mass: 0.0 }
    }
    pub fn struck<F: ContactFriction<R>>(friction: F, a: R, b: R) -> Option<R> {
        let touch = Touch::plate(1.0, &Vector3::new(0.0, 0.0, 1.0), 1.0).ok()?;
        let law = NormalLaw::new(Cohesion::NONE, 0.0).ok()?;
        let (mut ball, mut floor) = (ball(a, b), floor());
        let mut contact = Contact::new(&touch, &law, &ball, &floor, b);
        contact.update(&friction, &mut ball, &mut floor);
        Some(ball.velocity.x + ball.spin.y)
    }
    pub fn gripped<F: ContactFriction<R>>(friction: F, a: R, b: R) -> Option<R> {
        let law = NormalLaw::new(Cohesion::NONE, 0.0).ok()?;
        let mut all = Manifold::<R, F, 3, 2>::new(law, friction);
        let ball = all.push_sphere(ball(a, b)).ok()?;
        for side in [1.0, -1.0] {
            let plate = all.push_plate(floor()).ok()?;
            let touch = Touch::plate(1.0, &Vector3::new(0.0, 0.0, side), 1.0).ok()?;
            all.push_contact(ball, plate, touch).ok()?;
        }
        let report = all.solve(TimeStep::new(a).ok()?, Start::Last, Stop { sweeps: 10, tolerance: b });
        Some(all.body(ball)?.velocity().x + report.residual)
    }
}

STATICS

fn item(a: R, b: R) -> Option<R> {
    BODY
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    black_box(item(black_box(0.5), black_box(0.25)));
    loop {}
}
"#;

/// An item in one precision.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// What it names.
    pub item: Item,
    /// "f32" or "f64".
    pub precision: &'static str,
    /// For the name of its file.
    pub number: usize,
}

impl Program {
    fn file(&self) -> String {
        format!("program_{}", self.number)
    }

    fn source(&self) -> String {
        PROGRAM
            .replace("PRECISION", self.precision)
            .replace("BITS", self.precision.trim_start_matches('f'))
            .replace("STATICS", self.item.statics)
            .replace("BODY", self.item.body)
    }
}

/// Where the programs live, and where their images go.
#[derive(Clone, Debug)]
pub struct Workshop {
    folder: PathBuf,
}

impl Workshop {
    /// Writes all programs into `folder`, with the workspace's own versions of dependencies.
    pub fn write(folder: &Path, programs: &[Program]) -> Result<Self, String> {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let manifest = MANIFEST.replace("CORE", &root.join("core").display().to_string());
        let bin = folder.join("src/bin");
        // Programs of an earlier run may have other numbers.
        let _ = fs::remove_dir_all(&bin);
        let written = (|| {
            fs::create_dir_all(&bin)?;
            fs::write(folder.join("Cargo.toml"), manifest)?;
            fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
            for program in programs {
                fs::write(bin.join(program.file() + ".rs"), program.source())?;
            }
            Ok::<_, std::io::Error>(())
        })();
        written.map_err(|error| format!("cannot write {}: {error}", folder.display()))?;
        Ok(Self {
            folder: folder.into(),
        })
    }

    /// Builds all programs for [`TARGET`] with a cargo profile.
    pub fn build(&self, profile: &str) -> Result<(), String> {
        installed()?;
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
        let status = Command::new(cargo)
            .args(["build", "--quiet", "--bins", "--target", TARGET])
            .args(["--profile", profile, "--target-dir"])
            .arg(self.folder.join("target"))
            .current_dir(&self.folder)
            .status()
            .map_err(|error| format!("cannot run cargo: {error}"))?;
        if status.success() {
            Ok(())
        } else {
            Err("the programs do not build; see above".into())
        }
    }

    /// The image of a program.
    pub fn image(&self, program: &Program, profile: &str) -> Result<Vec<u8>, String> {
        let path = self.folder.join("target").join(TARGET);
        let path = path.join(profile).join(program.file());
        fs::read(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))
    }
}

/// Refuses if the target's core library is missing.
fn installed() -> Result<(), String> {
    let output = Command::new("rustc")
        .args(["--print", "target-libdir", "--target", TARGET])
        .output()
        .map_err(|error| format!("cannot run rustc: {error}"))?;
    let folder = String::from_utf8_lossy(&output.stdout);
    if output.status.success() && Path::new(folder.trim()).is_dir() {
        Ok(())
    } else {
        Err(format!(
            "the target is missing; install it with: rustup target add {TARGET}"
        ))
    }
}
