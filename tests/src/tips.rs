//! Scenes of tips small enough to run quickly.

use tribos::run::Simulation;
use tribos::scene::TipScene;
use tribos::tip::TipSimulation;

type Error = Box<dyn std::error::Error>;

/// 748 atoms: a hexagon with three atoms per side.
const TINY: &str = "body = \"tip\"\nsubstrate_columns = 12\nsubstrate_rows = 14\nsubstrate_layers = 4\ntip_layers = 4\n\
                    tip_side_atoms = 3\nspacing = 1.1";

/// Parses the text of a scene.
pub fn scene(text: &str) -> Result<TipScene, Error> {
    Ok(TipScene::parse("tip.toml", text, &[])?)
}

/// A tiny tip with additional lines.
pub fn tiny(text: &str) -> Result<TipScene, Error> {
    scene(&format!("{TINY}\n{text}"))
}

/// Runs all steps of a simulation.
pub fn to_the_end(run: &mut TipSimulation) -> Result<(), Error> {
    while run.step()? {}
    Ok(())
}
