//! One update of a prepared contact: the impulse that satisfies its laws with all other contacts fixed.
//!
//! Impulse and bodies are changed in place. Modes without friction have no impulse. The solution
//! is in closed form, unless sliding and rolling are coupled and both slip (at most 24 Newton steps, then
//! halvings) or friction is that of a patch (searches on its limit surface).

use super::contact::{
    AsBody, tribos_contact_f64, tribos_impulse_f64, tribos_plate_f64, tribos_sphere_f64,
    tribos_thresholds_f64,
};
use crate::memory::{answer, read};
use crate::status::tribos_status;
use tribos_core::contact::{Contact, ContactFriction, CoupledFriction, IndependentFriction};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::RoundLimitSurface;

/// Friction with validated parameters, or the reason for their refusal.
type Checked<F> = Result<F, tribos_status>;

/// Updates the impulse and both bodies.
#[inline(always)]
unsafe fn update<F, A, B>(
    contact: *const tribos_contact_f64,
    friction: Checked<F>,
    (first, second): (*mut A, *mut B),
    impulse: *mut tribos_impulse_f64,
) -> tribos_status
where
    F: ContactFriction<f64>,
    A: Copy + From<A::Kernel> + AsBody,
    B: Copy + From<B::Kernel> + AsBody,
{
    answer(impulse, || {
        let (contact, old) = (read(contact)?.into(), read(impulse)?.into());
        let (mut a, mut b) = (read(first)?.body(), read(second)?.body());
        let mut contact = Contact::resume(&contact, &old);
        contact.update(&friction?, &mut a, &mut b);
        first.write(a.into());
        second.write(b.into());
        Ok(contact.impulse().into())
    })
}

unsafe fn sliding(f: *const tribos_thresholds_f64) -> Checked<impl ContactFriction<f64>> {
    Ok(IndependentFriction::sliding(read(f)?.sliding)?)
}

unsafe fn sliding_torsion(f: *const tribos_thresholds_f64) -> Checked<impl ContactFriction<f64>> {
    let f = read(f)?;
    Ok(IndependentFriction::sliding_torsion(f.sliding, f.torsion)?)
}

unsafe fn sliding_rolling(f: *const tribos_thresholds_f64) -> Checked<impl ContactFriction<f64>> {
    let f = read(f)?;
    Ok(IndependentFriction::sliding_rolling(f.sliding, f.rolling)?)
}

unsafe fn all(f: *const tribos_thresholds_f64) -> Checked<impl ContactFriction<f64>> {
    let f = read(f)?;
    Ok(IndependentFriction::all(f.sliding, f.rolling, f.torsion)?)
}

/// Sliding and torsion under one threshold, that of a uniform disk.
unsafe fn patch(f: *const tribos_thresholds_f64) -> Checked<impl ContactFriction<f64>> {
    let f = read(f)?;
    let set = RoundLimitSurface::new(CoulombDisk, f.sliding, f.torsion)?;
    Ok(CoupledFriction::sliding_torsion(set))
}

/// Updates a contact of two spheres, with a normal impulse only.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_frictionless_spheres_f64(
    contact: *const tribos_contact_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_sphere_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(
        contact,
        Ok(IndependentFriction::none()),
        (first, second),
        impulse,
    )
}

/// Updates a contact of two spheres, with normal impulse and sliding friction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_sliding_spheres_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_sphere_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, sliding(friction), (first, second), impulse)
}

/// Updates a contact of two spheres, with normal impulse, sliding and torsion friction, each with its
/// own threshold.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_sliding_torsion_spheres_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_sphere_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, sliding_torsion(friction), (first, second), impulse)
}

/// Updates a contact of two spheres, with normal impulse, sliding and rolling friction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_sliding_rolling_spheres_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_sphere_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, sliding_rolling(friction), (first, second), impulse)
}

/// Updates a contact of two spheres, with normal impulse, sliding, rolling and torsion friction, each
/// with its own threshold.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_all_spheres_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_sphere_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, all(friction), (first, second), impulse)
}

/// Updates a contact of two spheres, with normal impulse, and sliding and torsion under the common
/// threshold of a uniform disk: `sliding` is mu, `torsion` is the radius of the disk over the lever, not
/// a coefficient.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_patch_spheres_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_sphere_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, patch(friction), (first, second), impulse)
}

/// Updates a contact of a sphere with a plate, with a normal impulse only.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_frictionless_plate_f64(
    contact: *const tribos_contact_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_plate_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(
        contact,
        Ok(IndependentFriction::none()),
        (first, second),
        impulse,
    )
}

/// Updates a contact of a sphere with a plate, with normal impulse and sliding friction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_sliding_plate_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_plate_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, sliding(friction), (first, second), impulse)
}

/// Updates a contact of a sphere with a plate, with normal impulse, sliding and torsion friction, each
/// with its own threshold.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_sliding_torsion_plate_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_plate_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, sliding_torsion(friction), (first, second), impulse)
}

/// Updates a contact of a sphere with a plate, with normal impulse, sliding and rolling friction.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_sliding_rolling_plate_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_plate_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, sliding_rolling(friction), (first, second), impulse)
}

/// Updates a contact of a sphere with a plate, with normal impulse, sliding, rolling and torsion
/// friction, each with its own threshold.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_all_plate_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_plate_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, all(friction), (first, second), impulse)
}

/// Updates a contact of a sphere with a plate, with normal impulse, and sliding and torsion under the
/// common threshold of a uniform disk: `sliding` is mu, `torsion` is the radius of the disk over the
/// lever, not a coefficient.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_update_patch_plate_f64(
    contact: *const tribos_contact_f64,
    friction: *const tribos_thresholds_f64,
    first: *mut tribos_sphere_f64,
    second: *mut tribos_plate_f64,
    impulse: *mut tribos_impulse_f64,
) -> tribos_status {
    update(contact, patch(friction), (first, second), impulse)
}
