//! Every public function of the kernel in one image, which does not link if any of them can panic.
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]
#![allow(unsafe_code)] // The exported entry and the panic handler of the image.

#[cfg(target_os = "none")]
#[path = "../image.rs"]
mod image;

/// Entry point of the image.
#[cfg(target_os = "none")]
#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    image::everything(&mut image::Opaque);
    loop {}
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!("for microcontrollers; `prove` builds it: cargo run -p tribos-no-panic --bin prove");
}
