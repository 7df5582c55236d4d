//! Twelve contacts at once in real time: three balls on a floor, pressed together by three fingers,
//! and a fourth on top.
//!
//! They start apart, fall and close, settle and are held. The program ends with an error if the
//! contacts do not carry the weight, if something still moves, or if a step takes too long.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(target_os = "none", allow(unsafe_code))]

tribos_boards::main!(run);

#[cfg(target_os = "none")]
mod pile;
#[cfg(target_os = "none")]
mod report;
#[cfg(all(target_os = "none", not(feature = "panic-exit")))]
#[path = "../../unlinkable.rs"]
mod unlinkable;

#[cfg(target_os = "none")]
fn run() {
    if report::print().is_none() {
        tribos_boards::println!(
            "a parameter is outside its domain, or balls went through each other"
        );
        tribos_boards::exit(1);
    }
}
