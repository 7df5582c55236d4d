//! Names of groups and datasets.

/// Groups of problems between impulses: without rolling, and with it.
pub const LOCAL: [&str; 2] = ["fclib_local", "fclib_local_rolling"];
/// Groups of problems between bodies.
pub const GLOBAL: [&str; 2] = ["fclib_global", "fclib_global_rolling"];
/// Groups of equality constraints.
pub const CONSTRAINTS: [&str; 3] = ["G", "V", "R"];

/// Number of components of a contact.
pub const SIZE: &str = "spacedim";
/// The friction coefficient.
pub const SLIDING: &str = "vectors/mu";
/// The rolling threshold.
pub const ROLLING: &str = "vectors/mu_r";
/// The torsion threshold, our extension.
pub const TORSION: &str = "vectors/mu_n";
/// The cohesion, our extension.
pub const COHESION: &str = "vectors/cohesion";
/// 1 where sliding and torsion share an ellipsoid, else 0; our extension.
pub const ELLIPSOID: &str = "vectors/ellipsoid";
