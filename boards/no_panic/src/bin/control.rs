//! The same image with one function that may panic: the proof is valid only if this does not
//! link.
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]
#![allow(unsafe_code)] // The exported entry and the panic handler of the image.

#[cfg(target_os = "none")]
#[path = "../image.rs"]
mod image;

/// Outside the array for an `index` above 2.
#[cfg(target_os = "none")]
fn element(array: &[f32; 3], index: usize) -> f32 {
    array[index]
}

/// Entry point of the image.
#[cfg(target_os = "none")]
#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    image::everything(&mut image::Opaque);
    image::Opaque.keep("element", element as *const ());
    loop {}
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("for microcontrollers; `prove` builds it: cargo run -p tribos-no-panic --bin prove");
}
