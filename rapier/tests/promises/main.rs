//! What the adapter promises, kept in Rapier's own worlds.

mod engine;
mod foot;
mod pushes;
mod rest;
mod table;
mod throws;
mod turntable;
