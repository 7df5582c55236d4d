//! Prepared things by their handles.

use super::contact::ContactLaw;
use super::prepared::Prepared;
use crate::exchange::Refused;
use alloc::rc::Rc;
use alloc::vec::Vec;
use core::cell::RefCell;
use std::boxed::Box;
use tribos_core::limit_surface::UnknownPressureSet;
use tribos_friction::{AnyLaw, Floor, Law};

/// A thing that is kept.
#[derive(Debug)]
pub enum Item {
    /// Friction of a patch under a law.
    Patch(Box<Prepared>),
    /// A law of the local speed, by its name and as the kernel has it.
    Law(Law, AnyLaw<f64>),
    /// Laws of a contact.
    Contact(ContactLaw),
    /// A body on surfaces.
    Floor(Floor),
    /// A support of which load and centre of pressure are known.
    AnyPressure(UnknownPressureSet<f64, Vec<[f64; 2]>>),
}

std::thread_local! {
    /// Handle n stands at n − 1.
    static STORE: RefCell<Vec<Option<Rc<Item>>>> = const { RefCell::new(Vec::new()) };
}

/// Keeps a thing. Returns its handle, which is not 0.
pub fn keep(item: Item) -> u32 {
    let item = Some(Rc::new(item));
    STORE.with_borrow_mut(|store| {
        let free = store.iter().position(Option::is_none);
        let at = free.unwrap_or_else(|| {
            store.push(None);
            store.len() - 1
        });
        store[at] = item;
        at as u32 + 1
    })
}

/// Forgets a thing.
pub fn release(handle: u32) {
    STORE.with_borrow_mut(|store| {
        if let Some(slot) = store.get_mut((handle as usize).wrapping_sub(1)) {
            *slot = None;
        }
    });
}

/// Number of things that are kept.
pub fn kept() -> usize {
    STORE.with_borrow(|store| store.iter().flatten().count())
}

/// The thing itself.
pub fn item(handle: u32) -> Result<Rc<Item>, Refused> {
    let found = STORE.with_borrow(|store| store.get((handle as usize).wrapping_sub(1)).cloned());
    found
        .flatten()
        .ok_or(Refused::Because("this object was freed"))
}

/// Why a handle of another kind is refused.
pub const OTHER: Refused = Refused::Because("this object is of another kind");

/// Works with a prepared patch.
pub fn with<T>(
    handle: u32,
    work: impl FnOnce(&Prepared) -> Result<T, Refused>,
) -> Result<T, Refused> {
    match &*item(handle)? {
        Item::Patch(patch) => work(patch),
        _ => Err(OTHER),
    }
}
