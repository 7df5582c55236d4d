//! Limit surfaces, exact and approximate.

use crate::exchange::Refused;
use crate::friction::{row_of, row_of_twist, twist_of};
use crate::patch::{Patch, Work};
use tribos_core::limit_surface::{FrictionSet, Projection, Region};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// The set itself.
pub const EXACT: u32 = 0;
/// The ellipsoid with the same largest force and torque.
pub const ELLIPSOID: u32 = 1;

/// A limit surface as JavaScript names it.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// Its patch.
    pub patch: Patch,
    /// μN, in N.
    pub force_limit: f64,
    /// [`EXACT`], [`ELLIPSOID`], or another number for separate limits.
    pub model: u32,
    /// Lever of an approximation, in m.
    pub lever: f64,
    /// Its largest torque over force limit and lever.
    pub spin_torque: f64,
}

impl Surface {
    /// Works with the set.
    #[inline]
    pub fn with<T>(&self, work: impl FnOnce(&dyn FrictionSet<f64>) -> T) -> Result<T, Refused> {
        let (mut work, mut result) = (Some(work), None);
        self.hand(&mut |set| result = work.take().map(|work| work(set)))?;
        result.ok_or(Refused::Because("there is no limit surface"))
    }

    /// Hands the set to `work`.
    #[inline(never)]
    fn hand(&self, work: Work<'_>) -> Result<(), Refused> {
        #[cfg(feature = "all")]
        if self.model != EXACT {
            work(&*self.approximate()?);
            return Ok(());
        }
        self.patch.set(self.force_limit, work)
    }

    #[cfg(feature = "all")]
    fn approximate(&self) -> Result<alloc::boxed::Box<dyn FrictionSet<f64>>, Refused> {
        use crate::all::separate::Separate;
        use alloc::boxed::Box;
        let (force_limit, radius) = (self.force_limit, self.lever);
        let ellipsoid =
            tribos_core::limit_surface::LimitEllipsoid::new(force_limit, radius, self.spin_torque)?;
        if self.model == ELLIPSOID {
            return Ok(Box::new(ellipsoid));
        }
        Ok(Box::new(Separate {
            force_limit,
            torque_limit: ellipsoid.torque_limit(),
            radius,
        }))
    }
}

/// Lever, and largest torque over force limit and lever: what an approximation of the exact set needs.
pub fn shape(patch: Patch) -> Result<[f64; 2], Refused> {
    let mut shape = [f64::NAN; 2];
    patch.set(1.0, &mut |set| {
        let lever = set.radius();
        shape = [lever, set.support(&Twist::new(0.0, 0.0, 1.0)) / lever];
    })?;
    Ok(shape)
}

/// Wrench, normal, and 1 if it slides.
pub fn projected(projection: &Projection<f64>) -> [f64; 7] {
    let (normal, slides) = match &projection.region {
        Region::Inside => ([0.0; 3], 0.0),
        Region::OnSurface { normal } => (row_of_twist(normal), 1.0),
    };
    let [fx, fy, torque] = row_of(&projection.wrench);
    let [vx, vy, spin] = normal;
    [fx, fy, torque, vx, vy, spin, slides]
}

/// The pushes that keep a patch in motion, from pure spin in the negative sense to that in the positive one,
/// sliding along `direction`.
pub fn meridian(set: &dyn FrictionSet<f64>, direction: f64, rows: &mut [[f64; 3]]) {
    let (x, y) = (Real::cos(direction), Real::sin(direction));
    let last = rows.len().saturating_sub(1) as f64;
    for (index, row) in rows.iter_mut().enumerate() {
        let part = index as f64 / last;
        let angle = (part - 0.5) * f64::PI;
        // Both ends are pure spins, to the last bit.
        let is_end = index == 0 || part == 1.0;
        let slide = if is_end { 0.0 } else { Real::cos(angle) };
        let twist = twist_of([slide * x, slide * y, Real::sin(angle) / set.radius()]);
        *row = row_of(&opposite(&set.wrench(&twist)));
    }
}

fn opposite(wrench: &Wrench<f64>) -> Wrench<f64> {
    let negative = |x: f64| if x == 0.0 { 0.0 } else { -x };
    let Wrench { force, torque } = wrench;
    Wrench::new(negative(force.x), negative(force.y), negative(*torque))
}
