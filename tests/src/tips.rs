//! Tips small enough to run in a moment.

use tribos::run::Simulation;
use tribos::scene::TipScene;
use tribos::tip::TipRun;

type Error = Box<dyn std::error::Error>;

/// 748 atoms: a hexagon of three a side.
const TINY: &str = "body = \"tip\"\ncolumns = 12\nrows = 14\nsubstrate_layers = 4\ntip_layers = 4\n\
                    side = 3\nspacing = 1.1";

/// The scene of a text.
pub fn scene(text: &str) -> Result<TipScene, Error> {
    Ok(TipScene::parse("tip.toml", text, &[])?)
}

/// A tiny tip with some more lines.
pub fn tiny(text: &str) -> Result<TipScene, Error> {
    scene(&format!("{TINY}\n{text}"))
}

/// Steps until the run is over.
pub fn to_the_end(run: &mut TipRun) -> Result<(), Error> {
    while run.step()? {}
    Ok(())
}
