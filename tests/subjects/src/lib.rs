//! Everything that the kernel computes, as one list: [`SUBJECTS`].
//!
//! A subject draws what it needs from the numbers of one seed, uses it as a program would, gives all
//! answers and judges those of which more is promised than their bits. The list is walked
//!
//! - on every platform, for a digest of the answers' bits ([`Subject::digest`]): what has to come out stands
//!   in `digests.txt`;
//! - by a fuzzer, which takes any number of inputs and reports the seeds of those that panic, take too long
//!   or break a property.
//!
//! Half of the inputs hold arbitrary bit patterns, half are mild: zero and magnitudes from 2⁻¹² to 2¹²,
//! within each domain. The properties are
//!
//! - finite results of mild inputs;
//! - results that are not NaN for every finite input, and NaN for NaN, if so documented;
//! - friction that dissipates, and what else the documentation of an item promises.
//!
//! Numbers come from integers, bit patterns and + − × / alone, so that no platform's mathematics library
//! takes part; the kernel's own roots and powers come from the `libm` crate. Nothing allocates.
//!
//! ```
//! let laws = &tribos_subjects::SUBJECTS[0];
//! assert_eq!(Some(laws.digest()), laws.pinned());
//! ```
#![no_std]

mod bonds;
mod contacts;
mod couplings;
mod digest;
mod floors;
mod input;
mod laws;
mod manifolds;
mod motions;
mod patches;
mod planes;
mod polygons;
mod presliding;
mod sets;
mod source;
mod special;
mod supports;
mod tables;

pub use digest::whole;
pub use input::{Broken, Input, Stop, Verdict};
pub use laws::{MEMORYLESS, MemorylessLaw};
pub use source::{Regime, Source, seed_of};

/// Takes one input in one precision.
pub type Walk = fn(&mut Input<'_>) -> Verdict;

/// A part of the kernel.
#[derive(Clone, Copy, Debug)]
pub struct Subject {
    /// Its name.
    pub name: &'static str,
    /// Its share of the inputs, per mille; slow subjects get fewer.
    pub share: u64,
    /// What the machine must have.
    pub needs: Needs,
    walks: [Walk; 2],
}

/// What a machine must have for a digest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// 16 KiB of RAM and 256 KiB of flash will do.
    Little,
    /// Some hundred KiB: of stack, for tables that are made at run time, or of flash.
    Memory,
}

/// Seed of the run whose first inputs make the digests.
pub const RUN: u64 = 7;

impl Subject {
    /// Takes the input of a seed, in f64 or f32; `out` receives the bits of all answers.
    ///
    /// # Errors
    /// The property that does not hold.
    pub fn take(&self, seed: u64, out: &mut dyn FnMut(u64)) -> Result<(), Broken> {
        let mut input = Input::new(seed, out);
        let walk = input.one_of(&self.walks);
        match walk(&mut input) {
            Err(Stop::Broken(broken)) => Err(broken),
            Ok(()) | Err(Stop::Refused) => Ok(()),
        }
    }
}

/// A subject by its walk in f64 and in f32.
macro_rules! subject {
    ($name:literal, $share:literal, $needs:ident, $($walk:ident)::+) => {
        subject!($name, $share, $needs, $($walk)::+::<f64>, $($walk)::+::<f32>)
    };
    ($name:literal, $share:literal, $needs:ident, $wide:expr, $narrow:expr) => {
        Subject { name: $name, share: $share, needs: Needs::$needs, walks: [$wide, $narrow] }
    };
}

/// All of them. As a static they are compiled here, once, not in every program that walks them.
pub static SUBJECTS: [Subject; 25] = [
    subject!("laws", 100, Little, laws::memoryless),
    subject!("laws with memory", 100, Little, laws::with_memory),
    subject!("bonds", 20, Little, bonds::bonds),
    subject!("elementary functions", 40, Little, special::elementary),
    subject!("elliptic integrals", 40, Little, special::elliptic),
    subject!(
        "hypergeometric functions",
        20,
        Little,
        special::gauss,
        special::gauss
    ),
    subject!("round patches", 60, Little, couplings::closed),
    subject!("combined patches", 20, Little, couplings::combined),
    subject!(
        "flash tables",
        30,
        Little,
        tables::flash_f64,
        tables::flash_f32
    ),
    subject!("tables", 2, Memory, tables::made_f64, tables::made_f32),
    subject!("quadrature", 4, Little, couplings::quadrature),
    subject!("patches", 30, Memory, patches::patches),
    subject!("planes", 100, Little, planes::planes),
    subject!("limit surfaces", 60, Little, sets::sets),
    subject!("contacts", 110, Memory, contacts::contacts),
    subject!("manifolds", 40, Little, contacts::manifold),
    subject!("manifold friction", 20, Little, manifolds::manifold),
    subject!("final motions", 40, Little, motions::modes),
    subject!("sliders", 13, Memory, motions::sliders),
    subject!("planar steps", 30, Little, planes::steps),
    subject!("feet", 20, Little, planes::feet),
    subject!("presliding", 40, Little, presliding::presliding),
    subject!("polygons", 35, Memory, polygons::polygons),
    subject!("floors", 20, Memory, floors::floors),
    subject!("supports", 8, Memory, supports::supports),
];
