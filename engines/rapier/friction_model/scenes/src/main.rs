//! Rapier's friction models: thrown bodies, rest and time, as comma-separated values.
//!
//!     scenes throws|rest MODEL
//!     scenes cost

mod cost;
mod rest;
mod throws;
mod world;

use rapier3d::prelude::FrictionModel;

fn model(name: &str) -> FrictionModel {
    match name {
        "Simplified" => FrictionModel::Simplified,
        "Coulomb" => FrictionModel::Coulomb,
        #[cfg(feature = "area")]
        "Area" => FrictionModel::Area,
        _ => panic!("no friction model {name}"),
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["throws", name] => throws::print(model(name)),
        ["rest", name] => rest::print(model(name)),
        ["cost"] => cost::print(model("Simplified"), model("Area")),
        _ => panic!("usage: scenes throws|rest MODEL, or scenes cost"),
    }
}
