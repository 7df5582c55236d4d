//! What the adapter promises, kept in Rapier's own worlds.

mod engine;
#[path = "../../../feet/tests/exact/mod.rs"]
#[allow(dead_code, reason = "what another adapter needs")]
mod exact;
mod feet;
mod foot;
mod grounds;
mod order;
mod pushes;
mod rest;
mod saved;
mod table;
mod throws;
mod turntable;
