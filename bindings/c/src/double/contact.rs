//! Contacts of rigid bodies that open, slide, roll and spin: impulses under friction thresholds.
//!
//! In each time step: find the contacts of the bodies, prepare each from the velocities at the start
//! of the step, apply the forces to the bodies, then update. One update is the exact solution of one
//! contact; repeated updates of all contacts solve a system of them (non-linear Gauss-Seidel).

use super::vectors::tribos_vector_f64;
use crate::choice::tribos_attraction;
use crate::fields::same_fields;
use crate::memory::{answer, read};
use crate::status::tribos_status;
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, Contact, ContactBody, ContactGeometry, ContactModes,
    ContactVector, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::internals::{Block, PreparedContact};

/// A sphere that can move and rotate freely.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_sphere_f64 {
    /// Velocity of the centre.
    pub velocity: tribos_vector_f64,
    /// Angular velocity.
    pub spin: tribos_vector_f64,
    /// 1/mass; 0 for an infinite mass.
    pub inv_mass: f64,
    /// 1/(moment of inertia about any axis through the centre).
    pub inv_inertia: f64,
}

/// A plate that impulses move only along its normal: a wall or a piston.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_plate_f64 {
    /// Velocity; its component in the plane is prescribed and unaffected by impulses.
    pub velocity: tribos_vector_f64,
    /// 1/mass; 0 for a wall.
    pub inv_mass: f64,
}

/// Geometry of a contact.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_touch_f64 {
    /// Unit normal, from the first body to the second.
    pub normal: tribos_vector_f64,
    /// Distance of the surfaces; negative where they overlap.
    pub gap: f64,
    /// Distances of the two centres from the contact point; 0 for a plate.
    pub arms: [f64; 2],
    /// 1/(1/R1 + 1/R2), the lever of rolling and torsion friction; the radius at a plate.
    pub lever: f64,
}

/// The contact law along the normal.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_normal_law_f64 {
    /// Pull of cohesion, a force, finite and not negative.
    pub cohesion: f64,
    /// Largest gap at which cohesion acts, finite and not negative.
    pub cohesion_range: f64,
    /// A value of tribos_attraction.
    pub attraction: u32,
    /// Coefficient of restitution: speed after an impact over speed before, 0 to 1.
    pub restitution: f64,
}

/// Friction coefficients, finite and not negative; a function reads those of its modes and ignores
/// the others. P is the normal impulse plus cohesion.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_thresholds_f64 {
    /// Sliding force over P.
    pub sliding: f64,
    /// Rolling torque over P x lever.
    pub rolling: f64,
    /// Torsion torque over P x lever.
    pub torsion: f64,
}

/// An impulse on the second body; its opposite acts on the first. A new contact starts with zeros.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_impulse_f64 {
    /// Impulse along the normal; positive separates the bodies.
    pub normal: f64,
    /// Force impulse in the contact plane, in world axes.
    pub sliding: tribos_vector_f64,
    /// Torque impulse in the contact plane.
    pub rolling: tribos_vector_f64,
    /// Torque impulse about the normal.
    pub torsion: f64,
}

/// A contact prepared for one time step. The fields may be read; changed values are not validated.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct tribos_contact_f64 {
    /// Unit normal, from the first body to the second.
    pub normal: tribos_vector_f64,
    /// Distances of the centres from the contact point.
    pub arms: [f64; 2],
    /// Lever of rolling and torsion friction.
    pub lever: f64,
    /// Effective mass along the normal.
    pub mass_normal: f64,
    /// Effective mass in the contact plane.
    pub mass_sliding: f64,
    /// Effective moment of inertia of rolling and of torsion.
    pub inertia: f64,
    /// Coupling of sliding and rolling, 0 for equal spheres.
    pub coupling: f64,
    /// Impulse of cohesion in this step, 0 beyond its range.
    pub cohesion: f64,
    /// Approach speed at which the contact counts as closed; the negative speed of a rebound.
    pub allowance: f64,
    /// 1 if cohesion keeps the gap, which is open, as it is; else 0.
    pub rests_open: u32,
}

same_fields!(tribos_sphere_f64, SphereBody<f64> { velocity, spin, inv_mass, inv_inertia });
same_fields!(tribos_plate_f64, WallBody<f64> { velocity, inv_mass });
same_fields!(tribos_touch_f64, ContactGeometry<f64> { normal, gap, arms, lever });

impl From<PreparedContact<f64>> for tribos_contact_f64 {
    fn from(c: PreparedContact<f64>) -> Self {
        Self {
            normal: c.normal.into(),
            arms: c.arms,
            lever: c.lever,
            mass_normal: c.block.mass_normal,
            mass_sliding: c.block.mass_sliding,
            inertia: c.block.inertia,
            coupling: c.block.coupling,
            cohesion: c.cohesion,
            allowance: c.allowance,
            rests_open: c.rests_open.into(),
        }
    }
}

impl From<tribos_contact_f64> for PreparedContact<f64> {
    #[inline(always)]
    fn from(c: tribos_contact_f64) -> Self {
        Self {
            normal: c.normal.into(),
            arms: c.arms,
            lever: c.lever,
            block: Block {
                mass_normal: c.mass_normal,
                mass_sliding: c.mass_sliding,
                inertia: c.inertia,
                coupling: c.coupling,
            },
            cohesion: c.cohesion,
            allowance: c.allowance,
            rests_open: c.rests_open != 0,
        }
    }
}

impl<M: ContactModes<f64>> From<tribos_impulse_f64> for ContactVector<f64, M> {
    #[inline(always)]
    fn from(i: tribos_impulse_f64) -> Self {
        Self::new(i.normal, i.sliding.into(), i.rolling.into(), i.torsion)
    }
}

impl<M: ContactModes<f64>> From<&ContactVector<f64, M>> for tribos_impulse_f64 {
    #[inline(always)]
    fn from(i: &ContactVector<f64, M>) -> Self {
        Self {
            normal: i.normal,
            sliding: i.sliding().into(),
            rolling: i.rolling().into(),
            torsion: i.torsion(),
        }
    }
}

fn normal_law(law: tribos_normal_law_f64) -> Result<NormalLaw<f64>, tribos_status> {
    const PULL: u32 = tribos_attraction::Pull as u32;
    const RESISTANCE: u32 = tribos_attraction::Resistance as u32;
    let attraction = match law.attraction {
        PULL => Attraction::Pull,
        RESISTANCE => Attraction::Resistance,
        _ => return Err(tribos_status::Choice),
    };
    let cohesion = Cohesion::new(law.cohesion, law.cohesion_range, attraction)?;
    Ok(NormalLaw::new(cohesion, law.restitution)?)
}

/// Prepares a contact of two bodies in their state at the start of the step.
#[inline(always)]
unsafe fn prepared<A: AsBody + Copy, B: AsBody + Copy>(
    touch: *const tribos_touch_f64,
    law: *const tribos_normal_law_f64,
    (first, second): (*const A, *const B),
    dt: f64,
) -> Result<tribos_contact_f64, tribos_status> {
    let (first, second) = (read(first)?.body(), read(second)?.body());
    let (touch, law) = (read(touch)?.into(), normal_law(read(law)?)?);
    let dt = TimeStep::new(dt)?.dt();
    // The prepared quantities do not depend on the modes.
    let contact = Contact::<f64, AllModes>::new(&touch, &law, &first, &second, dt);
    Ok(contact.prepared().into())
}

/// A structure of the header that represents a body of the kernel.
pub(super) trait AsBody {
    /// Type of the body in the kernel.
    type Kernel: ContactBody<f64>;
    /// Converts to the kernel's body.
    fn body(self) -> Self::Kernel;
}

impl AsBody for tribos_sphere_f64 {
    type Kernel = SphereBody<f64>;
    #[inline(always)]
    fn body(self) -> SphereBody<f64> {
        self.into()
    }
}

impl AsBody for tribos_plate_f64 {
    type Kernel = WallBody<f64>;
    #[inline(always)]
    fn body(self) -> WallBody<f64> {
        self.into()
    }
}

/// Contact geometry of two spheres; `displacement` is the vector from the first centre to the second.
/// Accuracy: the normal to 4 ulp, the gap to 2 ulp of the distance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_touch_spheres_f64(
    displacement: *const tribos_vector_f64,
    first_radius: f64,
    second_radius: f64,
    touch: *mut tribos_touch_f64,
) -> tribos_status {
    answer(touch, || {
        let displacement = read(displacement)?.into();
        Ok(ContactGeometry::spheres(&displacement, [first_radius, second_radius])?.into())
    })
}

/// Contact geometry of a sphere, the first body, and a plate at distance `height` from its centre; `outward`
/// is the plate's unit normal into the space of the sphere and is not normalised.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_touch_plate_f64(
    height: f64,
    outward: *const tribos_vector_f64,
    radius: f64,
    touch: *mut tribos_touch_f64,
) -> tribos_status {
    answer(touch, || {
        Ok(ContactGeometry::plate(height, &read(outward)?.into(), radius)?.into())
    })
}

/// Prepares a contact of two spheres for a step of length dt.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_contact_spheres_f64(
    touch: *const tribos_touch_f64,
    law: *const tribos_normal_law_f64,
    first: *const tribos_sphere_f64,
    second: *const tribos_sphere_f64,
    dt: f64,
    contact: *mut tribos_contact_f64,
) -> tribos_status {
    answer(contact, || prepared(touch, law, (first, second), dt))
}

/// Prepares a contact of a sphere with a plate, the second body.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tribos_contact_plate_f64(
    touch: *const tribos_touch_f64,
    law: *const tribos_normal_law_f64,
    first: *const tribos_sphere_f64,
    second: *const tribos_plate_f64,
    dt: f64,
    contact: *mut tribos_contact_f64,
) -> tribos_status {
    answer(contact, || prepared(touch, law, (first, second), dt))
}
