//! Contacts of spheres and plates.

use super::prepared::text;
use crate::all::contact::{ANSWER, ContactLaw, ContactParameters, GIVEN};
use crate::all::store::{self, Item, OTHER};
use crate::exchange::{Refused, answer, status};
use tribos_core::contact::Attraction;

/// Laws of a contact. An empty name of a patch for none; `resists` is 0 for cohesion that pulls, 1 for one that
/// resists opening alone.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_contact_law(
    mu: f64,
    mu_rolling: f64,
    mu_torsion: f64,
    patch: *const u8,
    patch_length: usize,
    patch_radius: f64,
    restitution: f64,
    cohesion: f64,
    cohesion_range: f64,
    resists: u32,
) -> u32 {
    let made = text(patch, patch_length).and_then(|name| {
        ContactLaw::new(&ContactParameters {
            coefficients: [mu, mu_rolling, mu_torsion],
            patch: (name, patch_radius),
            restitution,
            cohesion: [cohesion, cohesion_range],
            attraction: if resists == 0 {
                Attraction::Pull
            } else {
                Attraction::Resistance
            },
        })
    });
    status(made.map(|law| answer([store::keep(Item::Contact(law)).into()])))
}

/// A contact of two spheres in one time step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn collide_spheres(law: u32, dt: f64, given: *const [f64; GIVEN]) -> u32 {
    collide(law, |law| law.spheres(&*given, dt))
}

/// A contact of a sphere and a plate in one time step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn collide_plate(law: u32, dt: f64, given: *const [f64; GIVEN]) -> u32 {
    collide(law, |law| law.plate(&*given, dt))
}

fn collide(handle: u32, of: impl FnOnce(&ContactLaw) -> Result<[f64; ANSWER], Refused>) -> u32 {
    let made = store::item(handle).and_then(|item| match &*item {
        Item::Contact(law) => of(law),
        _ => Err(OTHER),
    });
    status(made.map(answer))
}
