//! Four numbers in one register of AVX2, for processors that are found to have it.
#![allow(unsafe_code)] // Instructions that the target may lack; see each block.

use super::{Four, Task};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A register. It is made only inside of [`on_avx2`]: the type cannot be named outside of this module.
#[derive(Clone, Copy, Debug)]
struct Register(__m256d);

/// Runs a task on a processor that has AVX2.
///
/// *Panics* without it.
#[inline]
pub(crate) fn run<T: Task>(task: T) -> T::Output {
    assert!(std::arch::is_x86_feature_detected!("avx2"));
    // SAFETY: the processor has the instructions.
    unsafe { on_avx2(task) }
}

#[target_feature(enable = "avx2")]
fn on_avx2<T: Task>(task: T) -> T::Output {
    task.run::<Register>()
}

macro_rules! operations {
    ($($operator:ident $name:ident $instruction:ident;)*) => {
        $(
            impl $operator for Register {
                type Output = Self;
                #[inline(always)]
                fn $name(self, other: Self) -> Self {
                    // SAFETY: a register exists only where AVX2 was found.
                    Self(unsafe { $instruction(self.0, other.0) })
                }
            }
        )*
    };
}

operations! {
    Add add _mm256_add_pd;
    Sub sub _mm256_sub_pd;
    Mul mul _mm256_mul_pd;
    Div div _mm256_div_pd;
}

impl Neg for Register {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: a register exists only where AVX2 was found.
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

// SAFETY of all blocks below: a register exists only where AVX2 was found, and the constructors are called only
// inside of `on_avx2`, which no one else can name.
impl Four for Register {
    #[inline(always)]
    fn new([a, b, c, d]: [f64; 4]) -> Self {
        Self(unsafe { _mm256_setr_pd(a, b, c, d) })
    }
    #[inline(always)]
    fn splat(number: f64) -> Self {
        Self(unsafe { _mm256_set1_pd(number) })
    }
    #[inline(always)]
    fn lanes(self) -> [f64; 4] {
        let mut lanes = [0.0; 4];
        // The store takes any alignment and writes exactly four numbers.
        unsafe { _mm256_storeu_pd(lanes.as_mut_ptr(), self.0) };
        lanes
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn copysign(self, other: Self) -> Self {
        let sign = unsafe { _mm256_and_pd(other.0, _mm256_set1_pd(-0.0)) };
        Self(unsafe { _mm256_or_pd(self.abs().0, sign) })
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self {
        Self(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> Self {
        Self(unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Self {
        Self(unsafe { _mm256_cmp_pd::<_CMP_EQ_OQ>(self.0, other.0) })
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(unsafe { _mm256_and_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn and_not(self, other: Self) -> Self {
        Self(unsafe { _mm256_andnot_pd(other.0, self.0) })
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(unsafe { _mm256_or_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn select(self, yes: Self, no: Self) -> Self {
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, self.0) })
    }
    #[inline(always)]
    fn any(self) -> bool {
        unsafe { _mm256_movemask_pd(self.0) != 0 }
    }
    // Rows are read by halves: one unit of a processor alone moves numbers across a register.
    #[inline(always)]
    fn columns([a, b, c, d]: [[f64; 4]; 4]) -> [Self; 4] {
        let [ac, bd] = [
            halves([a[0], a[1]], [c[0], c[1]]),
            halves([b[0], b[1]], [d[0], d[1]]),
        ];
        let [ca, db] = [
            halves([a[2], a[3]], [c[2], c[3]]),
            halves([b[2], b[3]], [d[2], d[3]]),
        ];
        unsafe {
            [
                Self(_mm256_unpacklo_pd(ac, bd)),
                Self(_mm256_unpackhi_pd(ac, bd)),
                Self(_mm256_unpacklo_pd(ca, db)),
                Self(_mm256_unpackhi_pd(ca, db)),
            ]
        }
    }
    #[inline(always)]
    fn rows([x, y, z, w]: [Self; 4]) -> [[f64; 4]; 4] {
        let (ac, bd) = unsafe { (_mm256_unpacklo_pd(x.0, y.0), _mm256_unpackhi_pd(x.0, y.0)) };
        let (ca, db) = unsafe { (_mm256_unpacklo_pd(z.0, w.0), _mm256_unpackhi_pd(z.0, w.0)) };
        unsafe {
            [
                Self(_mm256_permute2f128_pd::<0x20>(ac, ca)).lanes(),
                Self(_mm256_permute2f128_pd::<0x20>(bd, db)).lanes(),
                Self(_mm256_permute2f128_pd::<0x31>(ac, ca)).lanes(),
                Self(_mm256_permute2f128_pd::<0x31>(bd, db)).lanes(),
            ]
        }
    }
    #[inline(always)]
    fn pairs([x, y]: [Self; 2]) -> [[f64; 2]; 4] {
        let (ac, bd) = unsafe { (_mm256_unpacklo_pd(x.0, y.0), _mm256_unpackhi_pd(x.0, y.0)) };
        [lower(ac), lower(bd), upper(ac), upper(bd)]
    }
}

#[inline(always)]
fn halves([a, b]: [f64; 2], [c, d]: [f64; 2]) -> __m256d {
    unsafe {
        _mm256_insertf128_pd::<1>(_mm256_castpd128_pd256(_mm_setr_pd(a, b)), _mm_setr_pd(c, d))
    }
}

#[inline(always)]
fn lower(register: __m256d) -> [f64; 2] {
    let mut half = [0.0; 2];
    // The store takes any alignment and writes exactly two numbers.
    unsafe { _mm_storeu_pd(half.as_mut_ptr(), _mm256_castpd256_pd128(register)) };
    half
}

#[inline(always)]
fn upper(register: __m256d) -> [f64; 2] {
    let mut half = [0.0; 2];
    // As above.
    unsafe { _mm_storeu_pd(half.as_mut_ptr(), _mm256_extractf128_pd::<1>(register)) };
    half
}
