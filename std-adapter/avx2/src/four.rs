//! Four numbers in a register.
#![allow(unsafe_code)] // Instructions of AVX, one in each function.

use crate::Avx2;
use core::arch::x86_64::*;
use core::fmt;
use core::ops::{Add, Div, Mul, Sub};

/// Four numbers in a register. A value can only be made with the proof [`Avx2`].
///
/// ```
/// use tribos_avx2::{Avx2, F64x4, Work, run};
/// /// 1/√x below 1, x elsewhere.
/// struct Roots([f64; 4]);
/// impl Work for Roots {
///     type Out = [f64; 4];
///     #[inline(always)]
///     fn with_avx2(self, proof: Avx2) -> [f64; 4] {
///         let (x, one) = (F64x4::new(proof, &self.0), F64x4::splat(proof, 1.0));
///         assert_eq!(x.below(one).bits(), 0b0001);
///         x.below(one).select(one / x.sqrt(), x).to_array()
///     }
///     fn without(self) -> [f64; 4] {
///         self.0.map(|x| if x < 1.0 { 1.0 / x.sqrt() } else { x })
///     }
/// }
/// let roots = run(Roots([0.25, 4.0, 1.0, f64::INFINITY]));
/// assert_eq!(roots, [2.0, 4.0, 1.0, f64::INFINITY]);
/// ```
#[derive(Clone, Copy)]
pub struct F64x4(__m256d);

/// One instruction for two operands.
macro_rules! operator {
    ($($operator:ident $name:ident $instruction:ident),*) => {$(
        impl $operator for F64x4 {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: the operands are there, so the processor has AVX2.
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }
    )*};
}
operator!(Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

impl F64x4 {
    /// These four numbers.
    #[inline(always)]
    pub fn new(_: Avx2, numbers: &[f64; 4]) -> Self {
        // SAFETY: the proof; four numbers are read from an array of four.
        Self(unsafe { _mm256_loadu_pd(numbers.as_ptr()) })
    }

    /// The same number four times.
    #[inline(always)]
    pub fn splat(_: Avx2, number: f64) -> Self {
        // SAFETY: the proof.
        Self(unsafe { _mm256_set1_pd(number) })
    }

    /// The numbers as an array.
    #[inline(always)]
    pub fn to_array(self) -> [f64; 4] {
        let mut numbers = [0.0; 4];
        self.store(&mut numbers);
        numbers
    }

    /// Writes the numbers.
    #[inline(always)]
    pub fn store(self, to: &mut [f64; 4]) {
        // SAFETY: the value is there, so the processor has AVX2; four numbers go to an array of four.
        unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
    }

    /// Square roots, rounded as those of one number.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        // SAFETY: as in `store`.
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    /// A mask for [`select`](Self::select): where these are less than `others`. NaN is not.
    #[inline(always)]
    pub fn below(self, others: Self) -> Self {
        // SAFETY: as in `store`.
        Self(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, others.0) })
    }

    /// `chosen` where this mask is set, `others` elsewhere.
    #[inline(always)]
    pub fn select(self, chosen: Self, others: Self) -> Self {
        // SAFETY: as in `store`.
        Self(unsafe { _mm256_blendv_pd(others.0, chosen.0, self.0) })
    }

    /// This mask as bits, the first number's is the lowest.
    #[inline(always)]
    pub fn bits(self) -> usize {
        // SAFETY: as in `store`.
        unsafe { _mm256_movemask_pd(self.0) as usize }
    }

    /// Rows as columns.
    ///
    /// ```
    /// use tribos_avx2::{Avx2, F64x4, Work, run};
    /// struct Turned([[f64; 4]; 4]);
    /// impl Work for Turned {
    ///     type Out = [[f64; 4]; 4];
    ///     fn with_avx2(self, proof: Avx2) -> [[f64; 4]; 4] {
    ///         let rows = self.0.map(|row| F64x4::new(proof, &row));
    ///         F64x4::transpose(rows).map(F64x4::to_array)
    ///     }
    ///     fn without(self) -> [[f64; 4]; 4] {
    ///         [0, 1, 2, 3].map(|column| self.0.map(|row| row[column]))
    ///     }
    /// }
    /// let rows = [0.0, 10.0, 20.0, 30.0].map(|ten| [ten, ten + 1.0, ten + 2.0, ten + 3.0]);
    /// assert_eq!(run(Turned(rows)), Turned(rows).without());
    /// ```
    #[inline(always)]
    pub fn transpose([a, b, c, d]: [Self; 4]) -> [Self; 4] {
        // SAFETY: as in `store`.
        unsafe {
            // Halves of two rows, then their numbers in turn.
            let [ac, bd] = [(a, c), (b, d)].map(|(x, y)| _mm256_permute2f128_pd::<0x20>(x.0, y.0));
            let [ac2, bd2] =
                [(a, c), (b, d)].map(|(x, y)| _mm256_permute2f128_pd::<0x31>(x.0, y.0));
            [
                Self(_mm256_unpacklo_pd(ac, bd)),
                Self(_mm256_unpackhi_pd(ac, bd)),
                Self(_mm256_unpacklo_pd(ac2, bd2)),
                Self(_mm256_unpackhi_pd(ac2, bd2)),
            ]
        }
    }
}

impl fmt::Debug for F64x4 {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.to_array().fmt(to)
    }
}
