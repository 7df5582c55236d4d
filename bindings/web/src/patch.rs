//! A disk by its numbers, or a prepared patch by its handle.

use crate::exchange::Refused;
use crate::friction::Contact;
use crate::slide::Glides;
use tribos_core::coupling::RoundFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};

/// Work with a limit surface.
pub type Work<'a> = &'a mut dyn FnMut(&dyn FrictionSet<f64>);

/// A patch as JavaScript names it.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// A prepared patch, or 0 for a disk under Coulomb friction.
    pub handle: u32,
    /// Radius of the disk, in m.
    pub radius: f64,
    /// Coefficient of friction of the disk.
    pub mu: f64,
}

impl Patch {
    /// Works with its friction.
    #[inline]
    pub fn contact<T>(&self, work: impl FnOnce(&dyn Contact) -> T) -> Result<T, Refused> {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| Ok(work(&patch.contact)));
        }
        Ok(work(&RoundFriction::new(
            CoulombDisk,
            self.mu,
            self.radius,
        )?))
    }

    /// Works with its limit surface for the force limit μN.
    #[inline(never)]
    pub fn set(&self, force_limit: f64, work: Work<'_>) -> Result<(), Refused> {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| {
                Ok(patch.sets()?.under(force_limit, work)?)
            });
        }
        work(&RoundLimitSurface::new(
            CoulombDisk,
            force_limit,
            self.radius,
        )?);
        Ok(())
    }

    /// Works with its free motions.
    #[inline]
    pub fn glides<T>(
        &self,
        work: impl FnOnce(&dyn Glides) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| work(patch.glides()?));
        }
        work(&CoulombDisk)
    }

    /// Whether it turns with the body.
    pub fn turns(&self) -> bool {
        #[cfg(feature = "all")]
        if self.handle != 0 {
            return crate::all::store::with(self.handle, |patch| Ok(!patch.area.is_round()))
                .unwrap_or(false);
        }
        false
    }
}
