//! What the floor promises, kept in Rapier's own 2-D worlds.

mod bodies;
mod contacts;
#[path = "../../../feet/tests/exact/mod.rs"]
#[allow(dead_code, reason = "what another adapter needs")]
mod exact;
mod game;
mod materials;
mod rest;
mod saved;
mod throws;
