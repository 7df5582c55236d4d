//! What the crate promises, on simulated tables.

#[path = "../../../feet/tests/exact/mod.rs"]
#[allow(dead_code, reason = "what another adapter needs")]
mod exact;
mod grounds;
mod removal;
mod rest;
mod runs;
mod table;
mod throws;
