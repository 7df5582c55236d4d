//! What stands for a generic parameter: one list for every proof.
//!
//! A type is listed once, with the traits that it is wanted for. A new law, tier, patch or friction
//! set enters every proof by its line here.

/// A type that stands for parameters bounded by any of its traits.
#[derive(Clone, Copy, Debug)]
pub struct Instance {
    /// As Rust writes it with the paths of the kernel; `R` is the scalar.
    pub of: &'static str,
    /// Names of traits; those of the standard library with their arguments.
    pub traits: &'static [&'static str],
    /// Large things that take any tier are built for some of them only.
    pub representative: bool,
    /// The only precision that it has, if so.
    pub precision: Option<&'static str>,
}

const fn instance(of: &'static str, traits: &'static [&'static str]) -> Instance {
    Instance {
        of,
        traits,
        representative: true,
        precision: None,
    }
}

const fn similar(instance: Instance) -> Instance {
    Instance {
        representative: false,
        ..instance
    }
}

const fn only(precision: &'static str, instance: Instance) -> Instance {
    Instance {
        precision: Some(precision),
        ..instance
    }
}

const LAW: &[&str] = &["LocalLaw"];
const BOND: &[&str] = &["LocalLaw", "BondLaw"];
const TIER: &[&str] = &["Coupling", "Lateral", "Profile", "SmoothProfile"];
const DRY: &[&str] = &[
    "Coupling",
    "Lateral",
    "Profile",
    "SmoothProfile",
    "DryCoupling",
];

const EDGES: &[&str] = &[
    "AsRef<[patch::outline::Edge<R>]>",
    "AsMut<[patch::outline::Edge<R>]>",
];
const TRIANGLES: &[&str] = &[
    "AsRef<[patch::mesh::Triangle<R>]>",
    "AsMut<[patch::mesh::Triangle<R>]>",
];
const CORNERS: &[&str] = &["AsRef<[[R; 2]]>"];

/// All of them.
pub const INSTANCES: &[Instance] = &[
    instance("R", &["Real", "Lanes"]),
    // Local laws.
    instance("law::CoulombLaw<R>", LAW),
    instance("law::DryFriction<R>", LAW),
    instance("law::PowerLaw<R>", LAW),
    instance("law::PlateauPower<R>", LAW),
    instance("law::Stribeck<R>", LAW),
    instance("law::Savkoor<R>", LAW),
    instance("law::SteadyLuGre<R>", LAW),
    instance("law::SteadyRateState<R>", LAW),
    // Bonds.
    instance("bond::Exponential<R>", BOND),
    instance("bond::Weibull<R>", BOND),
    similar(instance("bond::OneStrength<R>", BOND)),
    similar(instance("bond::Saturating<R>", BOND)),
    instance("bond::ReForming<R>", BOND),
    // What laws are made of.
    instance("law::Dieterich", &["Evolution"]),
    instance("law::Ruina", &["Evolution"]),
    // Tiers.
    instance("coupling::table::Coulomb", DRY),
    similar(instance("&'static coupling::table::Coulomb", DRY)),
    instance("coupling::compact::CompactCoulomb", DRY),
    instance("coupling::compact::CompactPower<R>", TIER),
    instance("coupling::closed::Ring", DRY),
    similar(instance("coupling::closed::FlatPunch", DRY)),
    similar(instance("coupling::closed::Hertz", DRY)),
    only("f32", similar(instance("coupling::table::Table32", TIER))),
    only("f64", similar(instance("coupling::table::Table64", TIER))),
    only(
        "f32",
        similar(instance("coupling::round::RoundTable32", TIER)),
    ),
    only(
        "f64",
        similar(instance("coupling::round::RoundTable64", TIER)),
    ),
    only(
        "f64",
        similar(instance("coupling::round::LateralPolynomialTable", TIER)),
    ),
    only(
        "f64",
        similar(instance(
            "coupling::round::PolynomialTable",
            &["Coupling", "Profile", "SmoothProfile"],
        )),
    ),
    similar(instance(
        "coupling::Dry<coupling::compact::CompactPower<R>>",
        DRY,
    )),
    only(
        "f32",
        instance("coupling::Dry<coupling::round::RoundTable32>", DRY),
    ),
    only(
        "f64",
        instance("coupling::Dry<coupling::round::RoundTable64>", DRY),
    ),
    instance(
        "coupling::quadrature::DiskQuadrature<law::PowerLaw<R>>",
        &["Coupling"],
    ),
    instance("coupling::tall::FrontBack", &["Lean"]),
    instance("coupling::tall::AllRound", &["Lean"]),
    // Patches.
    instance("patch::nodes::Nodes<R, 3>", &["NodePatch"]),
    instance("patch::nodes::NodeList<R, 12>", &["NodePatch", "NodeSink"]),
    instance("patch::nodes::NodeSlice<'static, R>", &["NodePatch"]),
    instance(
        "patch::nodes::NodeBuffer<'static, R>",
        &["NodePatch", "NodeSink"],
    ),
    // Patches with straight edges, in an array and in memory of the caller.
    instance("[patch::outline::Edge<R>; 4]", EDGES),
    instance("&'static mut [patch::outline::Edge<R>]", EDGES),
    // Corners alone, in the same two ways.
    instance("[[R; 2]; 4]", CORNERS),
    similar(instance("&'static [[R; 2]]", CORNERS)),
    instance("patch::outline::Uniform", &["FlatPressure"]),
    instance("patch::outline::Linear<R>", &["FlatPressure"]),
    instance(
        "patch::outline::Polygon<R, [patch::outline::Edge<R>; 4]>",
        &["DryPatch", "PowerPatch"],
    ),
    instance(
        "patch::outline::Polygon<R, [patch::outline::Edge<R>; 4], patch::outline::Linear<R>>",
        &["DryPatch", "PowerPatch"],
    ),
    instance("patch::bar::Bar<R>", &["DryPatch"]),
    // Meshes, in the same two kinds of memory.
    instance("[patch::mesh::Triangle<R>; 4]", TRIANGLES),
    instance("&'static mut [patch::mesh::Triangle<R>]", TRIANGLES),
    instance(
        "patch::mesh::Mesh<R, [patch::mesh::Triangle<R>; 4]>",
        &["DryPatch"],
    ),
    instance(
        "patch::points::Points<R, patch::nodes::Nodes<R, 3>>",
        &["DryPatch"],
    ),
    instance(
        "patch::feet::Feet<'static, R, patch::bar::Bar<R>>",
        &["DryPatch"],
    ),
    // Limit surfaces.
    instance(
        "limit_surface::LimitSurface<R, coupling::table::Coulomb>",
        &["FrictionSet"],
    ),
    instance("limit_surface::Ellipsoid<R>", &["FrictionSet"]),
    instance(
        "limit_surface::PatchSurface<R, patch::outline::Polygon<R, [patch::outline::Edge<R>; 4]>>",
        &["FrictionSet"],
    ),
    similar(instance(
        "limit_surface::PatchSurface<R, patch::bar::Bar<R>>",
        &["FrictionSet"],
    )),
    instance(
        "limit_surface::PatchSurface<R, patch::points::Points<R, patch::nodes::Nodes<R, 3>>>",
        &["FrictionSet"],
    ),
    instance(
        "limit_surface::Scaled<'static, R, limit_surface::Ellipsoid<R>>",
        &["FrictionSet"],
    ),
    // Manifolds of engines.
    instance("manifold_friction::CompactOutline<R>", &["Outline"]),
    instance("manifold_friction::DirectedOutline<R>", &["Outline"]),
    // Contacts.
    instance("contact::Sphere<R>", &["Body"]),
    instance("contact::Plate<R>", &["Body"]),
    instance("contact::Frictionless", &["ContactModes"]),
    instance("contact::Sliding", &["ContactModes"]),
    instance("contact::SlidingTorsion", &["ContactModes"]),
    instance("contact::SlidingRolling", &["ContactModes"]),
    instance("contact::AllModes", &["ContactModes"]),
    instance(
        "contact::Thresholds<R, contact::Frictionless>",
        &["ContactFriction"],
    ),
    instance(
        "contact::Thresholds<R, contact::Sliding>",
        &["ContactFriction"],
    ),
    instance(
        "contact::Thresholds<R, contact::SlidingTorsion>",
        &["ContactFriction"],
    ),
    instance(
        "contact::Thresholds<R, contact::SlidingRolling>",
        &["ContactFriction"],
    ),
    instance(
        "contact::Thresholds<R, contact::AllModes>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::LimitSurface<R, coupling::table::Coulomb>, contact::SlidingTorsion>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::LimitSurface<R, coupling::table::Coulomb>, contact::AllModes>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::Ellipsoid<R>, contact::SlidingTorsion>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::Ellipsoid<R>, contact::AllModes>",
        &["ContactFriction"],
    ),
];

/// What is built for all instances, not for the representative ones alone.
pub const THOROUGH: [&str; 2] = ["<coupling::PatchFriction", "<&"];

/// Constants that stand for constant parameters, by the name of the parameter; in f32, in f64.
pub const CONSTANTS: &[(&str, [&[&str]; 2])] = &[
    ("N", [&["4"], &["4"]]),
    ("CAPACITY", [&["12"], &["12"]]),
    ("BODIES", [&["3"], &["3"]]),
    ("CONTACTS", [&["2"], &["2"]]),
    ("STEPS", [&["3"], &["3"]]),
    // Those of `DiskTable32`, `RoundTable32`; `DiskTable64`, `RoundTable64`.
    ("CELLS", [&["34", "48"], &["52", "106"]]),
    ("TERMS", [&["6"], &["13"]]),
];

/// Traits of parameters that the source leaves unbounded, by the name of the parameter.
pub const UNBOUNDED: &[(&str, &str)] = &[
    ("R", "Real"),
    ("C", "Coupling"),
    ("L", "LocalLaw"),
    ("P", "NodePatch"),
    ("M", "ContactModes"),
];
