//! Square roots by the quickest way that rounds correctly.
//!
//! IEEE 754 leaves a square root no freedom, so that an instruction and a careful routine give the
//! same bits. `libm` takes the instruction of x86-64 and AArch64 but not those of 32-bit Arm and of
//! NVIDIA's GPUs, where a root in software costs about sixty instructions; `core` has no stable function
//! for it. This crate is these instructions, apart from a kernel that forbids unsafe code.
//!
//! The floating-point unit of Arm must work as it does after reset: a program that sets flush-to-zero in
//! FPSCR loses subnormal numbers here as everywhere else.
//!
//! For `nvptx64` the compiler must allow unstable features, as it must for any program of a GPU.
#![no_std]
#![cfg_attr(target_arch = "nvptx64", feature(asm_experimental_arch))]

/// The instruction of NVIDIA's GPUs that rounds to nearest.
#[cfg(target_arch = "nvptx64")]
macro_rules! sqrt_rn {
    ($x:ident, $real:ty, $register:ident, $instruction:literal) => {{
        let root: $real;
        // SAFETY: nothing but the named register changes.
        #[allow(unsafe_code)] // One instruction.
        unsafe {
            core::arch::asm!(
                concat!($instruction, " {root}, {x};"),
                x = in($register) $x,
                root = lateout($register) root,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        root
    }};
}

/// Square root, correctly rounded.
///
/// *Special values*: NaN below zero and for NaN; √−0 = −0.
///
/// ```
/// use tribos_sqrt::sqrtf;
/// assert_eq!(sqrtf(2.0), core::f32::consts::SQRT_2);
/// let smallest = f32::from_bits(1); // 2^-149
/// assert_eq!(sqrtf(4.0 * smallest), 2.0 * sqrtf(smallest));
/// assert!(sqrtf(-1.0).is_nan());
/// assert!(sqrtf(-0.0).is_sign_negative());
/// ```
#[inline]
pub fn sqrtf(x: f32) -> f32 {
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    return vsqrt(x);
    #[cfg(target_arch = "nvptx64")]
    return sqrt_rn!(x, f32, reg32, "sqrt.rn.f32");
    #[cfg(not(any(
        all(target_arch = "arm", target_abi = "eabihf"),
        target_arch = "nvptx64"
    )))]
    return libm::sqrtf(x);
}

/// Square root, correctly rounded.
///
/// *Special values*: NaN below zero and for NaN; √−0 = −0.
///
/// ```
/// use tribos_sqrt::sqrt;
/// assert_eq!(sqrt(2.0), core::f64::consts::SQRT_2);
/// let smallest = f64::from_bits(1); // 2^-1074
/// assert_eq!(sqrt(4.0 * smallest), 2.0 * sqrt(smallest));
/// assert!(sqrt(-1.0).is_nan());
/// assert!(sqrt(-0.0).is_sign_negative());
/// ```
#[inline]
pub fn sqrt(x: f64) -> f64 {
    #[cfg(target_arch = "nvptx64")]
    return sqrt_rn!(x, f64, reg64, "sqrt.rn.f64");
    #[cfg(not(target_arch = "nvptx64"))]
    return libm::sqrt(x);
}

/// The instruction that every floating-point unit of 32-bit Arm has.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
#[allow(unsafe_code)] // One instruction.
fn vsqrt(x: f32) -> f32 {
    let root: u32;
    // Units for single precision alone have no register class of their own in Rust.
    // SAFETY: of what the compiler may use only the named core register and s0 change; the
    // exception flags are not read by Rust.
    unsafe {
        core::arch::asm!(
            "vmov s0, {bits}",
            "vsqrt.f32 s0, s0",
            "vmov {bits}, s0",
            bits = inlateout(reg) x.to_bits() => root,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    f32::from_bits(root)
}
