//! Powders, grains and gases as a program runs them.

mod cost;
mod gas;
mod grains;
mod initial_grains;
mod materials;
mod packing_formats;
mod packing_read;
mod powder;
mod powder_start;
mod sheared;
