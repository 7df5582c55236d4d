//! What stands for a generic parameter: one list for every proof.
//!
//! A type is listed once, with the traits that it is wanted for. A new tier or friction set enters every
//! proof by its line here, as does a patch with parameters beside the scalar; others enter by themselves
//! ([`EVERY`]).

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

const BOND: &[&str] = &["LocalLaw", "BondLaw"];
const TIER: &[&str] = &[
    "ReducedFriction",
    "LateralFriction",
    "PowerLawFriction",
    "SmoothProfile",
];
const DRY: &[&str] = &[
    "ReducedFriction",
    "LateralFriction",
    "PowerLawFriction",
    "SmoothProfile",
    "DryReducedFriction",
];

const EDGES: &[&str] = &[
    "AsRef<[patch::outline::Edge<R>]>",
    "AsMut<[patch::outline::Edge<R>]>",
];
const TRIANGLES: &[&str] = &[
    "AsRef<[patch::mesh::Triangle<R>]>",
    "AsMut<[patch::mesh::Triangle<R>]>",
];
const SIDES: &[&str] = &[
    "AsRef<[patch::arcs::Side<R>]>",
    "AsMut<[patch::arcs::Side<R>]>",
];
const CORNERS: &[&str] = &["AsRef<[[R; 2]]>"];

/// All of them.
pub const INSTANCES: &[Instance] = &[
    instance("R", &["Real", "Lanes"]),
    // Bonds.
    instance("bond::ExponentialBond<R>", BOND),
    instance("bond::WeibullBond<R>", BOND),
    similar(instance("bond::BrittleBond<R>", BOND)),
    similar(instance("bond::PlasticBond<R>", BOND)),
    instance("bond::ReformingBond<R>", BOND),
    // What laws are made of.
    instance("law::AgeingLaw", &["StateEvolution"]),
    instance("law::SlipLaw", &["StateEvolution"]),
    // Tiers.
    instance("coupling::coulomb::CoulombDisk", DRY),
    similar(instance("&'static coupling::coulomb::CoulombDisk", DRY)),
    instance(
        "coupling::WornAnnulus<R>",
        &[
            "ReducedFriction",
            "PowerLawFriction",
            "SmoothProfile",
            "DryReducedFriction",
        ],
    ),
    instance("coupling::compact::CompactPower<R>", TIER),
    instance("coupling::coulomb::CoulombRing", DRY),
    similar(instance("coupling::coulomb::CoulombPunch", DRY)),
    similar(instance("coupling::coulomb::CoulombHertz", DRY)),
    similar(instance("coupling::coulomb::CoulombParaboloid", DRY)),
    only(
        "f32",
        similar(instance("coupling::table::DiskTable32", TIER)),
    ),
    only(
        "f64",
        similar(instance("coupling::table::DiskTable64", TIER)),
    ),
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
            &["ReducedFriction", "PowerLawFriction", "SmoothProfile"],
        )),
    ),
    similar(instance(
        "coupling::DryProfile<coupling::compact::CompactPower<R>>",
        DRY,
    )),
    only(
        "f32",
        instance("coupling::DryProfile<coupling::round::RoundTable32>", DRY),
    ),
    only(
        "f64",
        instance("coupling::DryProfile<coupling::round::RoundTable64>", DRY),
    ),
    instance(
        "coupling::quadrature::DiskQuadrature<law::PowerLaw<R>>",
        &["ReducedFriction"],
    ),
    instance(
        "coupling::load_transfer::LongitudinalGradient",
        &["PressureGradient"],
    ),
    instance(
        "coupling::load_transfer::FullGradient",
        &["PressureGradient"],
    ),
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
    instance("patch::outline::UniformPressure", &["PressureField"]),
    instance("patch::outline::LinearPressure<R>", &["PressureField"]),
    instance(
        "patch::outline::Polygon<R, [patch::outline::Edge<R>; 4]>",
        &["PatchShape", "PowerLawPatch"],
    ),
    instance(
        "patch::outline::Polygon<R, [patch::outline::Edge<R>; 4], patch::outline::LinearPressure<R>>",
        &["PatchShape", "PowerLawPatch"],
    ),
    // Meshes, in the same two kinds of memory.
    instance("[patch::mesh::Triangle<R>; 4]", TRIANGLES),
    instance("&'static mut [patch::mesh::Triangle<R>]", TRIANGLES),
    instance(
        "patch::mesh::Mesh<R, [patch::mesh::Triangle<R>; 4]>",
        &["PatchShape"],
    ),
    instance(
        "patch::points::PointPatch<R, patch::nodes::Nodes<R, 3>>",
        &["PatchShape"],
    ),
    instance(
        "patch::feet::CompoundPatch<'static, R, patch::bar::Bar<R>>",
        &["PatchShape"],
    ),
    instance("patch::ellipse::Ellipse<R>", &["PatchShape", "AffineImage"]),
    instance(
        "patch::bar::Bar<R, patch::outline::LinearPressure<R>>",
        &["PatchShape", "AffineImage"],
    ),
    instance(
        "patch::anisotropic::AnisotropicPatch<R, patch::ellipse::Ellipse<R>>",
        &["PatchShape"],
    ),
    instance(
        "patch::round::RoundPatch<R, coupling::coulomb::CoulombDisk>",
        &["PatchShape"],
    ),
    // Sides of curved patches, in an array and in memory of the caller.
    instance("[patch::arcs::Side<R>; 8]", SIDES),
    instance("&'static mut [patch::arcs::Side<R>]", SIDES),
    instance(
        "patch::arcs::ArcOutline<R, [patch::arcs::Side<R>; 8]>",
        &["PatchShape"],
    ),
    // Radii that follow the load.
    instance("patch::elastic::HertzSphere<R>", &["LoadedRadius"]),
    instance("patch::elastic::SoftFinger<R>", &["LoadedRadius"]),
    similar(instance(
        "patch::elastic::AdhesiveSphere<R>",
        &["LoadedRadius"],
    )),
    // Limit surfaces.
    instance(
        "limit_surface::RoundLimitSurface<R, coupling::coulomb::CoulombDisk>",
        &["FrictionSet"],
    ),
    instance("limit_surface::LimitEllipsoid<R>", &["FrictionSet"]),
    instance(
        "limit_surface::ShapeLimitSurface<R, patch::outline::Polygon<R, [patch::outline::Edge<R>; 4]>>",
        &["FrictionSet"],
    ),
    similar(instance(
        "limit_surface::ShapeLimitSurface<R, patch::bar::Bar<R>>",
        &["FrictionSet"],
    )),
    instance(
        "limit_surface::ShapeLimitSurface<R, patch::points::PointPatch<R, patch::nodes::Nodes<R, 3>>>",
        &["FrictionSet"],
    ),
    instance(
        "limit_surface::ScaledSet<'static, R, limit_surface::LimitEllipsoid<R>>",
        &["FrictionSet"],
    ),
    // Manifolds of engines.
    instance("manifold_friction::IsotropicLimitCurve<R>", &["LimitCurve"]),
    instance(
        "manifold_friction::DirectionalLimitCurve<R>",
        &["LimitCurve"],
    ),
    // Contacts.
    instance("contact::SphereBody<R>", &["ContactBody"]),
    instance("contact::WallBody<R>", &["ContactBody"]),
    instance("contact::Frictionless", &["ContactModes"]),
    instance("contact::SlidingOnly", &["ContactModes"]),
    instance("contact::SlidingTorsion", &["ContactModes"]),
    instance("contact::SlidingRolling", &["ContactModes"]),
    instance("contact::AllModes", &["ContactModes"]),
    instance(
        "contact::IndependentFriction<R, contact::Frictionless>",
        &["ContactFriction"],
    ),
    instance(
        "contact::IndependentFriction<R, contact::SlidingOnly>",
        &["ContactFriction"],
    ),
    instance(
        "contact::IndependentFriction<R, contact::SlidingTorsion>",
        &["ContactFriction"],
    ),
    instance(
        "contact::IndependentFriction<R, contact::SlidingRolling>",
        &["ContactFriction"],
    ),
    instance(
        "contact::IndependentFriction<R, contact::AllModes>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::RoundLimitSurface<R, coupling::coulomb::CoulombDisk>, contact::SlidingTorsion>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::RoundLimitSurface<R, coupling::coulomb::CoulombDisk>, contact::AllModes>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::LimitEllipsoid<R>, contact::SlidingTorsion>",
        &["ContactFriction"],
    ),
    instance(
        "contact::CoupledFriction<R, limit_surface::LimitEllipsoid<R>, contact::AllModes>",
        &["ContactFriction"],
    ),
];

/// Traits for which every type with the scalar as its only parameter stands, unless it is listed.
pub const EVERY: [&str; 2] = ["LocalLaw", "PatchShape"];

/// What is built for all instances, not for the representative ones alone.
pub const THOROUGH: [&str; 2] = ["<coupling::RoundFriction", "<&"];

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
    ("C", "ReducedFriction"),
    ("L", "LocalLaw"),
    ("P", "NodePatch"),
    ("M", "ContactModes"),
];
