//! What the adapter promises, kept in Rapier's own worlds.

mod engine;
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
