//! Laws, pressures and their coupling: forces, torques and Jacobians against independent sources.

mod annuli;
mod appendix_a;
#[cfg(feature = "library")]
mod areas;
mod batches;
mod dense;
mod disk_friction;
#[cfg(feature = "library")]
mod friction;
mod hard_cases;
mod laws;
mod laws_one_by_one;
mod lugre;
mod mesh_friction;
mod node_rules;
mod nodes;
mod patches;
mod plane;
mod polygon_friction;
mod polygons;
mod pressures;
mod pressures_dense;
mod properties;
mod ranges;
mod rate_and_state;
mod single_precision;
mod special_functions;
mod tall;
mod thesis;
mod total_functions;
