//! The limit surface: all wrenches that dry friction can carry.
//!
//! Friction opposes the motion; a push is the wrench that moves the patch against friction. Each call
//! builds the surface again: it validates two numbers and computes three points of the disk, in addition
//! to the 2 or 3 of a gauge, a normal or a projection. A batch builds it once.

use super::vectors::{tribos_twist_f64, tribos_wrench_f64};
use crate::memory::{answer, read};
use crate::status::tribos_status;
use tribos_core::Error;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, Projection, Region, RoundLimitSurface,
};
use tribos_core::real::Real;

/// The exact limit surface of a uniform disk.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_disk_surface_f64 {
    /// mu x load, finite and not negative. With 0 the set is the zero wrench.
    pub force_limit: f64,
    /// Radius of the disk, positive and finite.
    pub radius: f64,
}

/// The ellipsoid (|force|/f)^2 + (torque/(f radius spin_torque))^2 <= 1, which planners use instead.
/// For the disk the exact surface lies inside it, down to gauge 0.934.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_ellipsoid_f64 {
    /// Force limit f = mu x load, finite and not negative.
    pub force_limit: f64,
    /// Radius of the patch, positive and finite.
    pub radius: f64,
    /// Reduced torque of pure spinning, positive and finite: 2/3 for the uniform disk.
    pub spin_torque: f64,
}

/// The wrench of a set that is nearest to a given wrench.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_projection_f64 {
    /// The nearest wrench; bit-identical to the given one if that is inside or on the surface.
    pub wrench: tribos_wrench_f64,
    /// Outward normal at the wrench, |velocity|^2 + (spin radius)^2 = 1; zero if the contact sticks.
    pub normal: tribos_twist_f64,
    /// 1 if the wrench is on the surface and the contact slides; 0 if it is inside and the contact sticks.
    pub slides: u32,
}

impl From<Projection<f64>> for tribos_projection_f64 {
    fn from(projection: Projection<f64>) -> Self {
        let (normal, slides) = match projection.region {
            Region::Inside => (
                tribos_twist_f64 {
                    x: 0.0,
                    y: 0.0,
                    spin: 0.0,
                },
                0,
            ),
            Region::OnSurface { normal } => (normal.into(), 1),
        };
        Self {
            wrench: projection.wrench.into(),
            normal,
            slides,
        }
    }
}

/// Parameters of a set.
pub(super) trait Set: Copy {
    type Set: FrictionSet<f64>;
    fn set(self) -> Result<Self::Set, Error>;
}

impl Set for tribos_disk_surface_f64 {
    type Set = RoundLimitSurface<f64, CoulombDisk>;
    #[inline(always)]
    fn set(self) -> Result<Self::Set, Error> {
        RoundLimitSurface::new(CoulombDisk, self.force_limit, self.radius)
    }
}

impl Set for tribos_ellipsoid_f64 {
    type Set = LimitEllipsoid<f64>;
    #[inline(always)]
    fn set(self) -> Result<Self::Set, Error> {
        LimitEllipsoid::new(self.force_limit, self.radius, self.spin_torque)
    }
}

#[inline(always)]
unsafe fn set_of<S: Set>(set: *const S) -> Result<S::Set, tribos_status> {
    Ok(read(set)?.set()?)
}

/// Projects a wrench; a length of 0 represents the radius of the set.
#[inline(always)]
pub(super) fn projected<S: FrictionSet<f64>>(
    set: &S,
    wrench: tribos_wrench_f64,
    length: f64,
) -> tribos_projection_f64 {
    let length = if length == f64::ZERO {
        set.radius()
    } else {
        length
    };
    set.project_with_length(&wrench.into(), length).into()
}

/// Power that the patch dissipates with a twist: the largest wrench . twist of the set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_support_f64(
    surface: *const tribos_disk_surface_f64,
    twist: *const tribos_twist_f64,
    power: *mut f64,
) -> tribos_status {
    answer(power, || Ok(set_of(surface)?.support(&read(twist)?.into())))
}

/// Friction on a patch that moves with a twist. Special values: zero at rest.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_wrench_f64(
    surface: *const tribos_disk_surface_f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        Ok(set_of(surface)?.wrench(&read(twist)?.into()).into())
    })
}

/// The smallest factor g >= 0 with wrench/g in the set: below 1 friction holds the patch, above 1 the patch
/// slides. Special values: 0 for the zero wrench, infinite for an infinite one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_gauge_f64(
    surface: *const tribos_disk_surface_f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(gauge, || Ok(set_of(surface)?.gauge(&read(wrench)?.into())))
}

/// The motion caused by a push, scaled to |velocity|^2 + (spin radius)^2 = 1.
/// Special values: zero for the zero wrench.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_motion_f64(
    surface: *const tribos_disk_surface_f64,
    push: *const tribos_wrench_f64,
    twist: *mut tribos_twist_f64,
) -> tribos_status {
    answer(twist, || {
        let push = read(push)?.into();
        Ok(set_of(surface)?.twist_normal_to(&push).into())
    })
}

/// The wrench scaled to the surface. Special values: the zero wrench is unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_scale_f64(
    surface: *const tribos_disk_surface_f64,
    wrench: *const tribos_wrench_f64,
    scaled: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(scaled, || {
        let wrench = read(wrench)?.into();
        Ok(set_of(surface)?.scale_to_surface(&wrench).into())
    })
}

/// The nearest wrench of the set in the norm sqrt(|d force|^2 + (d torque/length)^2); a length of
/// 0 represents the radius. Special values: NaN for a negative or infinite length.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_disk_surface_project_f64(
    surface: *const tribos_disk_surface_f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        Ok(projected(&set_of(surface)?, read(wrench)?, length))
    })
}

/// As tribos_disk_surface_support_f64, for the ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ellipsoid_support_f64(
    ellipsoid: *const tribos_ellipsoid_f64,
    twist: *const tribos_twist_f64,
    power: *mut f64,
) -> tribos_status {
    answer(power, || {
        Ok(set_of(ellipsoid)?.support(&read(twist)?.into()))
    })
}

/// As tribos_disk_surface_wrench_f64, for the ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ellipsoid_wrench_f64(
    ellipsoid: *const tribos_ellipsoid_f64,
    twist: *const tribos_twist_f64,
    wrench: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(wrench, || {
        Ok(set_of(ellipsoid)?.wrench(&read(twist)?.into()).into())
    })
}

/// As tribos_disk_surface_gauge_f64, for the ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ellipsoid_gauge_f64(
    ellipsoid: *const tribos_ellipsoid_f64,
    wrench: *const tribos_wrench_f64,
    gauge: *mut f64,
) -> tribos_status {
    answer(
        gauge,
        || Ok(set_of(ellipsoid)?.gauge(&read(wrench)?.into())),
    )
}

/// As tribos_disk_surface_motion_f64, for the ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ellipsoid_motion_f64(
    ellipsoid: *const tribos_ellipsoid_f64,
    push: *const tribos_wrench_f64,
    twist: *mut tribos_twist_f64,
) -> tribos_status {
    answer(twist, || {
        let push = read(push)?.into();
        Ok(set_of(ellipsoid)?.twist_normal_to(&push).into())
    })
}

/// As tribos_disk_surface_scale_f64, for the ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ellipsoid_scale_f64(
    ellipsoid: *const tribos_ellipsoid_f64,
    wrench: *const tribos_wrench_f64,
    scaled: *mut tribos_wrench_f64,
) -> tribos_status {
    answer(scaled, || {
        let wrench = read(wrench)?.into();
        Ok(set_of(ellipsoid)?.scale_to_surface(&wrench).into())
    })
}

/// As tribos_disk_surface_project_f64, for the ellipsoid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_ellipsoid_project_f64(
    ellipsoid: *const tribos_ellipsoid_f64,
    wrench: *const tribos_wrench_f64,
    length: f64,
    projection: *mut tribos_projection_f64,
) -> tribos_status {
    answer(projection, || {
        Ok(projected(&set_of(ellipsoid)?, read(wrench)?, length))
    })
}
