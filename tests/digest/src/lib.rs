//! One number for the bits of everything the kernel computes, to compare platforms with.
//!
//! [`CHAPTERS`] need no allocator and say what machine they need. Inputs come from integers and + − × /
//! alone, so that no platform's mathematics library takes part; the kernel's own roots and powers
//! come from the `libm` crate. What has to come out stands in `digests.txt`, one chapter a line.
//!
//! ```
//! let tables = &tribos_digest::CHAPTERS[0];
//! assert_eq!(Some((tables.run)()), tribos_digest::pinned(tables.name));
//! ```
#![no_std]

mod batches;
mod bodies;
mod bonds;
mod contacts;
mod hash;
mod holding;
mod inputs;
mod laws;
mod manifolds;
mod memory;
mod meshes;
mod motions;
mod patches;
mod planes;
mod polygon_powers;
mod polygons;
mod presliding;
mod pressures;
mod profiles;
mod sets;
mod special;
mod supports;
mod surfaces;
mod tiers;
mod touching;

/// Arguments per tier and exponent.
const ARGUMENTS: usize = 2000;

/// A digest and what it takes to compute it.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// What it digests.
    pub name: &'static str,
    /// Computes it.
    pub run: fn() -> u64,
    /// What the machine must have.
    pub needs: Needs,
}

/// What a machine must have for a chapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// 16 KiB of RAM and 256 KiB of flash will do.
    Little,
    /// Some hundred KiB: of stack, for tables that are made at run time, or of flash.
    Memory,
    /// A processor with double precision, and the stack: 10⁹ operations and more.
    Speed,
}

const fn little(name: &'static str, run: fn() -> u64) -> Chapter {
    let needs = Needs::Little;
    Chapter { name, run, needs }
}

const fn memory(name: &'static str, run: fn() -> u64) -> Chapter {
    let needs = Needs::Memory;
    Chapter { name, run, needs }
}

const fn speed(name: &'static str, run: fn() -> u64) -> Chapter {
    let needs = Needs::Speed;
    Chapter { name, run, needs }
}

/// All digests.
pub const CHAPTERS: [Chapter; 44] = [
    memory("tables f64", tiers::tables_f64),
    memory("tables f32", tiers::tables_f32),
    speed("compact", tiers::compact),
    speed("quadrature", tiers::quadrature),
    little("wrenches", bodies::wrenches),
    memory("sliders", bodies::sliders),
    speed("pressures f64", pressures::pressures_f64),
    speed("pressures f32", pressures::pressures_f32),
    little("closed forms", pressures::closed_forms),
    memory("tall", bodies::tall),
    little("nodes", surfaces::nodes),
    little("limit surfaces", surfaces::limit_surfaces),
    little("laws", surfaces::laws),
    memory("contacts", contacts::contacts),
    little("elementary", special::elementary),
    little("elliptic", special::elliptic),
    little("hypergeometric", special::hypergeometric),
    little("moving", laws::moving),
    little("resting", laws::resting),
    little("rate and state", memory::rate_and_state),
    little("bristles", memory::bristles),
    little("patches", patches::patches),
    memory("standard rule", patches::standard_rule),
    little("flash tables", profiles::flash_tables),
    little("plain forms", profiles::plain_forms),
    memory("polynomials", profiles::polynomials),
    little("modes", profiles::modes),
    little("planes", planes::planes),
    little("leaning", planes::leaning),
    little("sets", sets::sets),
    little("motions", motions::motions),
    speed("extreme motions", motions::extremes),
    little("touching", touching::touching),
    little("manifold", touching::manifold),
    little("holding", holding::holding),
    little("rubber", laws::rubber),
    little("polygons", polygons::polygons),
    little("polygon powers", polygon_powers::polygon_powers),
    little("meshes", meshes::meshes),
    speed("supports", supports::supports),
    little("presliding", presliding::presliding),
    little("bonds", bonds::bonds),
    memory("batches", batches::batches),
    little("manifold friction", manifolds::manifold_friction_bits),
];

const DIGESTS: &str = include_str!("../digests.txt");

/// The digest that a chapter has to have on every platform.
pub fn pinned(name: &str) -> Option<u64> {
    let of = |line: &'static str| line.rsplit_once(' ');
    let (_, digest) = DIGESTS.lines().filter_map(of).find(|(of, _)| *of == name)?;
    u64::from_str_radix(digest.strip_prefix("0x")?, 16).ok()
}

/// One digest over those of all chapters, in their order.
pub fn whole(digests: impl IntoIterator<Item = u64>) -> u64 {
    let mut hash = hash::Fnv::new();
    for digest in digests {
        hash.feed(digest);
    }
    hash.0
}
