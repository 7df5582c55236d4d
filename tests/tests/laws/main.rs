//! Laws, pressures and their coupling: forces, torques and Jacobians against independent sources.

mod annuli;
mod appendix_a;
mod dense;
mod disk_friction;
mod friction;
mod hard_cases;
mod laws;
mod laws_one_by_one;
mod lugre;
mod node_rules;
mod nodes;
mod patches;
mod polygon_friction;
mod polygons;
mod pressure_properties;
mod pressures;
mod pressures_dense;
mod pressures_total;
mod properties;
mod ranges;
mod rate_and_state;
mod single_precision;
mod special_functions;
mod tall;
mod thesis;
mod total_functions;
