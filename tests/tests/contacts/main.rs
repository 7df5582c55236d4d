//! Limit surfaces, single contacts, manifolds and contact dynamics.

mod any_pressure;
mod cd_hard;
mod cd_invariants;
mod cd_physics;
mod cd_restitution;
mod cd_sleep;
mod cd_solvers;
mod cd_sound;
mod cd_threads;
mod contact_extremes;
mod contact_hard_cases;
mod contact_oracle;
mod contact_physics;
mod contact_properties;
mod ellipsoid;
mod limit_surface;
mod manifold;
mod manifold_extremes;
mod manifold_friction;
mod patch_surface;
mod point_surface;
mod problems;
mod sets;
mod surface_batch;
