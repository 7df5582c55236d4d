//! Spheres that each begin a cache line.

use std::ops::{Deref, DerefMut};
use tribos_core::contact::SphereBody;

/// A sphere aligned to 64 bytes, its own size: reading it from memory fetches one cache line, not two.
///
/// ```
/// use tribos::cd::internals::Aligned;
/// assert_eq!((size_of::<Aligned>(), align_of::<Aligned>()), (64, 64));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Aligned(pub SphereBody<f64>);

impl Deref for Aligned {
    type Target = SphereBody<f64>;

    #[inline(always)]
    fn deref(&self) -> &SphereBody<f64> {
        &self.0
    }
}

impl DerefMut for Aligned {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut SphereBody<f64> {
        &mut self.0
    }
}
