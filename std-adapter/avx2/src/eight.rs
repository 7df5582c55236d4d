//! Eight numbers of single precision in a register.
#![allow(unsafe_code)] // Instructions of AVX, one in each function.

use crate::Avx2;
use core::arch::x86_64::*;
use core::ops::{Add, Mul, Sub};

/// Eight numbers of single precision in a register. A value can only be made with the proof [`Avx2`].
///
/// ```
/// use tribos_avx2::{Avx2, F32x8, Work, run};
/// /// Which squares of these numbers are above 10.
/// struct Squares([f32; 8]);
/// impl Work for Squares {
///     type Out = usize;
///     fn with_avx2(self, proof: Avx2) -> usize {
///         let x = F32x8::new(proof, &self.0);
///         0xff & !(x * x).not_above(F32x8::splat(proof, 10.0))
///     }
///     fn without(self) -> usize {
///         (0..8).filter(|&lane| self.0[lane] * self.0[lane] > 10.0).map(|lane| 1 << lane).sum()
///     }
/// }
/// assert_eq!(run(Squares([0.0, 4.0, 1.0, -4.0, f32::NAN, 9.0, 3.0, 0.0])), 0b0010_1010);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct F32x8(__m256);

/// One instruction for two operands.
macro_rules! operator {
    ($($operator:ident $name:ident $instruction:ident),*) => {$(
        impl $operator for F32x8 {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: the operands are there, so the processor has AVX2.
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }
    )*};
}
operator!(Add add _mm256_add_ps, Sub sub _mm256_sub_ps, Mul mul _mm256_mul_ps);

impl F32x8 {
    /// These eight numbers.
    #[inline(always)]
    pub fn new(_: Avx2, numbers: &[f32; 8]) -> Self {
        // SAFETY: the proof; eight numbers are read from an array of eight.
        Self(unsafe { _mm256_loadu_ps(numbers.as_ptr()) })
    }

    /// The same number eight times.
    #[inline(always)]
    pub fn splat(_: Avx2, number: f32) -> Self {
        // SAFETY: the proof.
        Self(unsafe { _mm256_set1_ps(number) })
    }

    /// The numbers in some lanes, each modulo 8.
    ///
    /// ```
    /// use tribos_avx2::{Avx2, F32x8, Work, run};
    /// struct Turned([f32; 8]);
    /// impl Work for Turned {
    ///     type Out = [f32; 8];
    ///     fn with_avx2(self, proof: Avx2) -> [f32; 8] {
    ///         F32x8::new(proof, &self.0).pick(&[7, 6, 5, 4, 0, 0, 8, u32::MAX])
    ///     }
    ///     fn without(self) -> [f32; 8] {
    ///         [7, 6, 5, 4, 0, 0, 8, u32::MAX as usize].map(|lane| self.0[lane % 8])
    ///     }
    /// }
    /// let numbers = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];
    /// assert_eq!(run(Turned(numbers)), Turned(numbers).without());
    /// ```
    #[inline(always)]
    pub fn pick(self, lanes: &[u32; 8]) -> [f32; 8] {
        let mut picked = [0.0; 8];
        // SAFETY: the value is there, so the processor has AVX2; eight numbers are read from an array of eight, and
        // written to one.
        unsafe {
            let lanes = _mm256_loadu_si256(lanes.as_ptr().cast());
            _mm256_storeu_ps(picked.as_mut_ptr(), _mm256_permutevar8x32_ps(self.0, lanes));
        }
        picked
    }

    /// A bit for each number, from the lowest: whether it is not above that of `others`. NaN is not.
    #[inline(always)]
    pub fn not_above(self, others: Self) -> usize {
        // SAFETY: the values are there, so the processor has AVX2.
        unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_NGT_UQ>(self.0, others.0)) as usize }
    }
}
