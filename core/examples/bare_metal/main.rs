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

mod contacts;
mod impulses;
mod laws;
mod nodes;

use core::hint::black_box;
use tribos_core::coupling::{PatchFriction, table};
use tribos_core::twist::Twist;

/// Force and torque on a puck, the call of a controller's loop.
fn controller(speed: f32, spin: f32) -> Option<[f32; 3]> {
    let puck = PatchFriction::new(table::Coulomb, 0.3, 0.04).ok()?;
    let wrench = puck.wrench(1.7, &Twist::new(speed, 0.0, spin));
    Some([wrench.force.x, wrench.force.y, wrench.torque])
}

/// Every other public computation once, in both precisions.
fn everything(a: f64, b: f64) -> Option<f64> {
    let (x, y) = (a as f32, b as f32);
    let wide = contacts::wide(a, b)?
        + contacts::either(a, b)?
        + nodes::all(a, b)?
        + laws::all(a, b)?
        + impulses::all(a, b)?;
    let single = contacts::single(x, y)?
        + contacts::either(x, y)?
        + nodes::all(x, y)?
        + laws::all(x, y)?
        + impulses::all(x, y)?;
    Some(wide + f64::from(single))
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
    println!(
        "i {:?} {:?}",
        impulses::all(0.4, 0.3),
        impulses::all(0.4f32, 0.3)
    );
    println!("checksum of everything else: {:?}", everything(0.4, 0.3));
    black_box(());
}
