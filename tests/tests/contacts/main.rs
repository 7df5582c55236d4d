//! Limit surfaces, single contacts, manifolds and contact dynamics.

mod any_pressure;
#[cfg(feature = "library")]
mod cd_hard;
#[cfg(feature = "library")]
mod cd_invariants;
#[cfg(feature = "library")]
mod cd_physics;
#[cfg(feature = "library")]
mod cd_restitution;
#[cfg(feature = "library")]
mod cd_sleep;
#[cfg(feature = "library")]
mod cd_solvers;
#[cfg(feature = "library")]
mod cd_sound;
#[cfg(feature = "library")]
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
#[cfg(feature = "library")]
mod problems;
mod sets;
mod surface_batch;
