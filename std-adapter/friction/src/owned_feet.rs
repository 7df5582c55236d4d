//! Several areas under one body, in a list.

use super::Precision;
use super::flat::Flat;
use tribos_core::coupling::flat::{Hessian, Motion, PatchShape, PointLoad, Reduced};
use tribos_core::patch::PatchError;
use tribos_core::patch::feet::{CompoundPatch, PatchPart};

/// The kernel's patch of several feet, with the feet.
#[derive(Clone, Debug)]
pub struct OwnedFeet<R: Precision> {
    parts: Vec<PatchPart<R, Flat<R>>>,
    centre: nalgebra::Vector2<R>,
    radius: R,
}

impl<R: Precision> OwnedFeet<R> {
    /// *Domain*: that of [`CompoundPatch::new`].
    pub(super) fn new(parts: Vec<PatchPart<R, Flat<R>>>) -> Result<Self, PatchError> {
        let all = CompoundPatch::new(&parts)?;
        let (centre, radius) = (all.centre(), all.radius());
        Ok(Self {
            parts,
            centre,
            radius,
        })
    }

    /// The feet.
    pub(super) fn feet(&self) -> &[PatchPart<R, Flat<R>>] {
        &self.parts
    }

    /// What `work` makes of the kernel's patch, which was valid when it was made.
    fn with<T>(&self, work: impl FnOnce(&CompoundPatch<'_, R, Flat<R>>) -> T) -> Option<T> {
        CompoundPatch::new(&self.parts).ok().map(|all| work(&all))
    }
}

impl<R: Precision> PatchShape<R> for OwnedFeet<R> {
    fn centre(&self) -> nalgebra::Vector2<R> {
        self.centre
    }
    fn radius(&self) -> R {
        self.radius
    }
    fn rounding(&self) -> R {
        self.with(|all| all.rounding()).unwrap_or(R::EPSILON)
    }
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        self.with(|all| all.reduced(motion)).unwrap_or(Reduced {
            force: nalgebra::Vector2::repeat(R::NAN),
            torque: R::NAN,
        })
    }
    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        let nan = R::NAN;
        self.with(|all| all.reduced_with_hessian(motion))
            .unwrap_or((
                Reduced {
                    force: nalgebra::Vector2::repeat(nan),
                    torque: nan,
                },
                Hessian {
                    xx: nan,
                    xy: nan,
                    yy: nan,
                    xn: nan,
                    yn: nan,
                    nn: nan,
                },
            ))
    }
    fn nearest_point(&self, place: &nalgebra::Vector2<R>) -> Option<PointLoad<R>> {
        self.with(|all| all.nearest_point(place)).flatten()
    }
}
