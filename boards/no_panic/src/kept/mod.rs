//! Every public function of the kernel, by name and address.
//!
//! A function whose address is taken must be compiled for all arguments: no knowledge of a
//! caller's arguments can remove a branch.
#![allow(clippy::type_complexity)] // Types of functions, to settle their generic arguments.

mod contacts;
mod couplings;
mod laws;
mod motions;
mod patches;
mod scalars;
mod surfaces;

use tribos_core::coupling::table::CoulombTable;

/// Receiver of the functions.
pub trait Keeper {
    /// `name` is the compiler's, with all types spelled out.
    fn keep(&mut self, name: &'static str, address: *const ());
}

/// Passes functions to a keeper: paths, or `path => type` if arguments are generic.
macro_rules! keep {
    ($keeper:ident: $($function:expr),+ $(,)?) => {
        $($keeper.keep(core::any::type_name_of_val(&$function), $function as *const ());)+
    };
    ($keeper:ident: $function:expr => $pointer:ty) => {
        let function = $function;
        let pointer: $pointer = function;
        $keeper.keep(core::any::type_name_of_val(&function), pointer as *const ());
    };
}
use keep;

/// All of them, in both precisions.
pub fn everything(keeper: &mut impl Keeper) {
    in_precision::<f32>(keeper);
    in_precision::<f64>(keeper);
    couplings::tables(keeper);
    patches::pressures(keeper);
    scalars::gauss(keeper);
}

fn in_precision<R: CoulombTable>(keeper: &mut impl Keeper) {
    scalars::all::<R>(keeper);
    laws::all::<R>(keeper);
    patches::all::<R>(keeper);
    couplings::all::<R>(keeper);
    surfaces::all::<R>(keeper);
    contacts::all::<R>(keeper);
    motions::all::<R>(keeper);
}
