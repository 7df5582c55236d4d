//! What the crate promises, on simulated tables.

mod exact;
mod grounds;
mod removal;
mod rest;
mod runs;
mod table;
mod throws;
