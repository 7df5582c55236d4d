//! Loops of four numbers at a time with AVX2, chosen at run time.
//!
//! A program built for any x86-64 has registers of two numbers; nearly all processors since 2013 have four.
//! [`run`] asks the processor and calls a loop with a proof that it has them, [`Avx2`]; with the proof, [`F64x4`]
//! and [`F32x8`] compute. The call and the instructions need unsafe code, which this crate keeps apart from a library that
//! denies it.
//!
//! AVX2 alone has no fused multiply-add, and the compiler neither fuses nor reorders on its own: every operation
//! rounds as the scalar one does, so that results do not depend on the processor.

#[cfg(target_arch = "x86_64")]
mod eight;
#[cfg(target_arch = "x86_64")]
mod four;
#[cfg(target_arch = "x86_64")]
mod pick;

#[cfg(target_arch = "x86_64")]
pub use eight::F32x8;
#[cfg(target_arch = "x86_64")]
pub use four::F64x4;
#[cfg(target_arch = "x86_64")]
pub use pick::pick;

/// Proof that the processor has AVX2.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

/// A loop that exists twice.
///
/// Both functions, and all that they call in their inner loops, should be `#[inline(always)]`: what is not inlined
/// has no AVX2.
pub trait Work {
    /// What the loop computes.
    type Out;

    /// The loop on a processor with AVX2: compiled for it, also where it only has arrays and plain loops.
    fn with_avx2(self, proof: Avx2) -> Self::Out;

    /// The loop on any processor.
    fn without(self) -> Self::Out;
}

/// Runs `work` with AVX2 where the processor has it.
///
/// ```
/// use tribos_avx2::{Avx2, Work, run};
/// struct Dot<'a>(&'a [[f64; 4]], &'a [[f64; 4]]);
/// impl Work for Dot<'_> {
///     type Out = [f64; 4];
///     #[inline(always)]
///     fn with_avx2(self, _: Avx2) -> [f64; 4] {
///         self.without()
///     }
///     #[inline(always)]
///     fn without(self) -> [f64; 4] {
///         let mut sum = [0.0; 4];
///         for (a, b) in self.0.iter().zip(self.1) {
///             for lane in 0..4 {
///                 sum[lane] += a[lane] * b[lane];
///             }
///         }
///         sum
///     }
/// }
/// let (thirds, tenths) = ([[1.0 / 3.0; 4]; 9], [[0.1; 4]; 9]);
/// assert_eq!(run(Dot(&thirds, &tenths)), Dot(&thirds, &tenths).without()); // to the bit
/// ```
#[inline]
pub fn run<W: Work>(work: W) -> W::Out {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        #[allow(unsafe_code)] // One call.
        // SAFETY: the processor has AVX2, all that the function asks for.
        return unsafe { with_avx2(work) };
    }
    work.without()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<W: Work>(work: W) -> W::Out {
    work.with_avx2(Avx2(()))
}
