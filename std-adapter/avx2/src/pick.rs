//! Whole numbers of some lanes.
#![allow(unsafe_code)] // One instruction.

use crate::Avx2;
use core::arch::x86_64::*;

/// The numbers in some of eight lanes, each modulo 8.
///
/// ```
/// use tribos_avx2::{Avx2, Work, pick, run};
/// struct Turned([u32; 8]);
/// impl Work for Turned {
///     type Out = [u32; 8];
///     fn with_avx2(self, proof: Avx2) -> [u32; 8] {
///         pick(proof, &self.0, &[7, 6, 5, 4, 0, 0, 8, u32::MAX])
///     }
///     fn without(self) -> [u32; 8] {
///         [7, 6, 5, 4, 0, 0, 8, u32::MAX as usize].map(|lane| self.0[lane % 8])
///     }
/// }
/// let numbers = [10, u32::MAX, 12, 13, 14, 15, 16, 17];
/// assert_eq!(run(Turned(numbers)), Turned(numbers).without());
/// ```
#[inline(always)]
pub fn pick(_: Avx2, numbers: &[u32; 8], lanes: &[u32; 8]) -> [u32; 8] {
    let mut picked = [0; 8];
    // SAFETY: the proof; eight numbers are read from arrays of eight, and written to one.
    unsafe {
        let lanes = _mm256_loadu_si256(lanes.as_ptr().cast());
        let numbers = _mm256_loadu_si256(numbers.as_ptr().cast());
        let moved = _mm256_permutevar8x32_epi32(numbers, lanes);
        _mm256_storeu_si256(picked.as_mut_ptr().cast(), moved);
    }
    picked
}
