//! What the floor promises, kept in Rapier's own 2-D worlds.

mod bodies;
mod contacts;
mod exact;
mod game;
mod materials;
mod rest;
mod saved;
mod throws;
