//! The measured items: what each program prepares and calls.

mod bodies;
mod holding;
mod impulses;
mod laws;
mod manifold_friction;
mod patches;
mod tiers;

use bodies::BODIES;
use holding::HOLDING;
use impulses::IMPULSES;
use laws::laws;
use manifold_friction::MANIFOLD_FRICTION;
use patches::PATCHES;
use tiers::TIERS;

/// Something that a program may name.
///
/// The code fragments see the scalar `R`, the numbers `a` and `b`, and the `Input` named `given` of
/// the template `programs/common.txt`.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// Law, tier, patch, …
    pub group: &'static str,
    /// Name of the item in reports.
    pub name: &'static str,
    /// Modules of the kernel that the program may contain, beside [`PLUMBING`], separated by spaces.
    modules: &'static str,
    /// In which precisions it is built.
    pub precisions: &'static [&'static str],
    /// The call that is measured.
    pub code: Code,
}

impl Item {
    /// The modules one by one.
    pub fn modules(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.modules.split_whitespace()
    }
}

/// Fragments of Rust.
#[derive(Clone, Copy, Debug)]
pub struct Code {
    /// Statics of the program.
    pub statics: &'static str,
    /// The object that is prepared once; `?` on an option refuses.
    pub prepare: &'static str,
    /// Code that runs before each call and is not counted.
    pub ready: &'static str,
    /// The call on the `object`: an `R`.
    pub call: &'static str,
}

impl Code {
    const fn new(prepare: &'static str, call: &'static str) -> Self {
        Self {
            statics: "",
            prepare,
            ready: "",
            call,
        }
    }

    const fn with_statics(self, statics: &'static str) -> Self {
        Self { statics, ..self }
    }

    const fn with_ready(self, ready: &'static str) -> Self {
        Self { ready, ..self }
    }
}

const NARROW: &[&str] = &["f32"];
const WIDE: &[&str] = &["f64"];
const BOTH: &[&str] = &["f32", "f64"];

/// Modules that are no feature of their own: `coupling` itself has its traits only, and `wide` and
/// `beyond` serve the ends of the number range in every coupling.
pub const PLUMBING: [&str; 13] = [
    "coupling",
    "real",
    "real::sealed",
    "lanes",
    "lanes::vectors",
    "lanes::numbers",
    "twist",
    "law::error",
    "law::limits",
    "patch::error",
    "coupling::speeds",
    "coupling::extended_range",
    "coupling::extreme_range",
];

/// Modules of every round patch under a power law.
macro_rules! round {
    ($($more:literal),*) => {
        concat!(
            "coupling::profile coupling::pressure_family coupling::lateral coupling::friction patch::power",
            $(" ", $more),*
        )
    };
}
use round;

const fn item(
    [group, name]: [&'static str; 2],
    precisions: &'static [&'static str],
    modules: &'static str,
    code: Code,
) -> Item {
    Item {
        group,
        name,
        modules,
        precisions,
        code,
    }
}

/// Names nothing of the kernel.
pub const BASELINE: Item = item(["baseline", "nothing"], BOTH, "", Code::new("()", "a + b"));

/// All items, the baseline first.
pub fn all() -> impl Iterator<Item = Item> {
    let items = [BASELINE].into_iter().chain(laws()).chain(TIERS);
    let bodies = PATCHES.into_iter().chain(BODIES).chain(HOLDING);
    let impulses = IMPULSES.into_iter().chain(MANIFOLD_FRICTION);
    items.chain(bodies).chain(impulses)
}
