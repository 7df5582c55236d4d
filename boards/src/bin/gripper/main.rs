//! A parallel gripper at 1 kHz, with friction compensation of its joint and a model of its grip.
//!
//! The firmware is `controller` and the predicted `object`; `joint` and a second object, in finer
//! steps and with other parameters, simulate the machine. It ends with an error if a promise of the
//! report does not hold.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(target_os = "none", allow(unsafe_code))]

tribos_boards::main!(run);

#[cfg(target_os = "none")]
mod controller;
#[cfg(target_os = "none")]
mod cost;
#[cfg(target_os = "none")]
mod grasp;
#[cfg(target_os = "none")]
mod joint;
#[cfg(target_os = "none")]
mod object;
#[cfg(target_os = "none")]
mod report;
#[cfg(target_os = "none")]
mod tracking;
#[cfg(all(target_os = "none", not(feature = "panic-exit")))]
#[path = "../../unlinkable.rs"]
mod unlinkable;

/// A tick of the controller, s.
#[cfg(target_os = "none")]
const PERIOD: f32 = 1e-3;

#[cfg(target_os = "none")]
fn run() {
    if report::print().is_none() {
        tribos_boards::println!("a parameter is outside its domain");
        tribos_boards::exit(1);
    }
}
