//! The kernel in a program without standard library, allocator or panic.
//!
//! Linked for a bare-metal target this is a proof: the panic handler calls a function that does
//! not exist, so that a panic that survives optimisation anywhere in the calls below fails to
//! link, and there is no allocator to link either. `cargo run --example bare_metal` on a host
//! prints what a controller would send to its motor.
//!
//!     cargo build --release -p tribos-core --example bare_metal --target thumbv7em-none-eabihf
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]
#![allow(unsafe_code)] // Exported symbols and the panic handler of the bare-metal build.

use core::hint::black_box;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::{self, Table32, Table64};
use tribos_core::coupling::{Coupling, PatchFriction, compact};
use tribos_core::law::PowerLaw;
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use tribos_core::modes::Modes;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::patch::polar::{self, PolarRule};
use tribos_core::patch::polygon::polygon;
use tribos_core::patch::tripod::tripod;
use tribos_core::slider::{Motion, Slider};
use tribos_core::twist::{Twist, Wrench};

/// A law with α = 1/2, prepared by the compiler: 23 KiB of flash, no RAM.
static HALF_POWER: Table64 = match Table64::new(0.5) {
    Ok(table) => table,
    Err(_) => panic!("the exponent is in range"),
};
/// The same in f32: 3 KiB.
static HALF_POWER_F32: Table32 = match Table32::new(0.5) {
    Ok(table) => table,
    Err(_) => panic!("the exponent is in range"),
};

/// Force and torque on a puck, the call of a controller's loop.
fn controller(speed: f32, spin: f32) -> Option<[f32; 3]> {
    let puck = PatchFriction::new(table::Coulomb, 0.3, 0.04).ok()?;
    let wrench = puck.wrench(1.7, &Twist::new(speed, 0.0, spin));
    Some([wrench.force.x, wrench.force.y, wrench.torque])
}

/// Every other public computation once, in both precisions.
fn everything(a: f64, b: f64) -> Option<f64> {
    let (x, y) = (a as f32, b as f32);
    let mut sum = wrench_sum(&table::Coulomb, a, b) + wrench_sum(&HALF_POWER, a, b);
    sum += wrench_sum(&compact::Coulomb, a, b) + wrench_sum(&compact::Power::new(a).ok()?, a, b);
    sum += wrench_sum(&DiskQuadrature::new(PowerLaw::new(a, b).ok()?), a, b);
    sum += wrench_sum(&Table64::new(a).ok()?, a, b);
    let mut sum_f32 = wrench_sum(&table::Coulomb, x, y) + wrench_sum(&HALF_POWER_F32, x, y);
    sum_f32 += wrench_sum(&compact::Coulomb, x, y);
    sum_f32 += wrench_sum(&compact::Power::new(x).ok()?, x, y);
    sum_f32 += wrench_sum(&DiskQuadrature::new(PowerLaw::new(x, y).ok()?), x, y);
    sum_f32 += wrench_sum(&Table32::new(x).ok()?, x, y);
    sum += Modes::new(&HALF_POWER, a).ok()?.finite_fixed_point()?;
    sum_f32 += Modes::new(&HALF_POWER_F32, x).ok()?.finite_fixed_point()?;
    let slider = Slider::new(table::Coulomb, a, b, 0.5).ok()?;
    sum += slider.to_rest(&Motion::launched(a, b))?.motion.time;
    sum += slider.verlet_step(&Motion::launched(a, b), b).speed;
    let slider = Slider::new(&HALF_POWER_F32, x, y, 0.5).ok()?;
    sum_f32 += slider.advance(&Motion::launched(x, y), y).motion.time;
    sum += set_sum(&LimitSurface::new(table::Coulomb, a, b).ok()?, a, b);
    sum += set_sum(&Ellipsoid::new(a, b, b).ok()?, a, b);
    sum_f32 += set_sum(&LimitSurface::new(table::Coulomb, x, y).ok()?, x, y);
    sum_f32 += set_sum(&Ellipsoid::new(x, y, y).ok()?, x, y);
    sum += nodes_sum(a, b)?;
    sum_f32 += nodes_sum(x, y)?;
    Some(sum + f64::from(sum_f32))
}

/// All kinds of node patches.
fn nodes_sum<R: tribos_core::Real>(a: R, b: R) -> Option<R> {
    let feet = [[a, b], [-a, b], [b, -a]];
    let disk = PolarRule::new(a, 2, 6).ok()?.with_rim_exponent(b).ok()?;
    let disk: NodeList<R, 12> = disk.nodes_tilted(a, b).ok()?;
    let ring: NodeList<R, 6> = polar::ring(a, 6).ok()?;
    let foot: NodeList<R, 28> = polygon(&feet, 2).ok()?;
    let stool = tripod(feet, [R::ZERO; 2]).ok()?;
    let mut sum = node_friction_sum(&disk, a, b)? + node_friction_sum(&ring, a, b)?;
    sum += node_friction_sum(&foot, a, b)? + node_friction_sum(&stool, a, b)?;
    Some(sum)
}

/// Wrench and Jacobian of one node patch.
fn node_friction_sum<R: tribos_core::Real>(patch: &impl NodePatch<R>, a: R, b: R) -> Option<R> {
    let friction = NodeFriction::new(PowerLaw::new(a, b).ok()?, patch);
    let twist = Twist::new(a, b, b);
    Some(friction.wrench(a, &twist).torque + friction.wrench_jacobian(a, &twist).m33)
}

/// Wrench and Jacobian of one coupling.
fn wrench_sum<R: tribos_core::Real>(coupling: &impl Coupling<R>, v: R, w: R) -> R {
    let wrench = coupling.reduced_wrench(v, w);
    let jacobian = coupling.reduced_jacobian(v, w);
    wrench.force + wrench.torque + jacobian.force_slide + jacobian.mixed + jacobian.torque_rim
}

/// Both ways through a friction set.
fn set_sum<R: tribos_core::Real>(set: &impl FrictionSet<R>, v: R, w: R) -> R {
    let Wrench { force, torque } = set.wrench(&Twist::new(v, w, v));
    let push = Wrench {
        force: -(force + force),
        torque: -torque,
    };
    let motion = set.twist_normal_to(&set.scale_to_surface(&push));
    let carried = set.project_with_length(&push, w).wrench;
    set.support(&motion) + set.gauge(&carried)
}

#[cfg(target_os = "none")]
mod bare {
    use super::{black_box, controller, everything};

    unsafe extern "C" {
        /// Defined nowhere.
        fn a_panic_is_reachable() -> !;
    }

    #[panic_handler]
    fn panic(_: &core::panic::PanicInfo) -> ! {
        // SAFETY: never linked, hence never called.
        unsafe { a_panic_is_reachable() }
    }

    /// Entry point of the image.
    #[unsafe(no_mangle)]
    pub extern "C" fn _start() -> ! {
        black_box(controller(black_box(1.0), black_box(20.0)));
        black_box(everything(black_box(0.4), black_box(0.3)));
        loop {}
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("force x, y [N], torque [N m]: {:?}", controller(1.0, 20.0));
    println!("checksum of everything else: {:?}", everything(0.4, 0.3));
    black_box(());
}
