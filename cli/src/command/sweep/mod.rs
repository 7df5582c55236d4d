//! `tribos sweep`: a scene run for all combinations of some keys and seeds.

mod grid;
mod jobs;
mod kind;
mod plot;
mod table;

use crate::failure::Failure;
use grid::Grid;
use std::num::NonZero;
use std::path::PathBuf;
use table::Table;
use tribos::record::write_atomically;

/// Runs the scene of a powder or a tip for every combination of the values of its keys, each with several seeds,
/// and writes a table of means and standard deviations: sweep.csv. Of two keys with several numbers
/// each there is a surface, of one a line, of the final porosity or angle: sweep.svg and sweep.png.
///
/// Every run leaves its summary in DIR/runs. A sweep that was interrupted goes on where it stopped:
/// runs whose summary is there are not taken again.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// The scene, with body = "powder" or "tip": a TOML file, or a name that `tribos scene list`
    /// has.
    scene: PathBuf,
    /// A key of the scene with its values; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE,...")]
    sets: Vec<String>,
    /// Runs for each combination: the scene's seed and those after it.
    #[arg(long, default_value = "1")]
    seeds: NonZero<u32>,
    /// Runs at a time.
    #[arg(long, default_value = "1")]
    jobs: NonZero<usize>,
    /// Folder for the results; made if missing, files in it are replaced.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  Final porosity over rolling and torsion friction (fig. 4.7, small system):
    tribos sweep scenes/compaction-small.toml --set rolling=0,0.1,0.2,0.4,1 \\
        --set torsion=0,0.1,0.2,0.4,1 --seeds 2 --jobs 4 --out out/figure-4.7
  Over the range of cohesion, with error bars from five deposits:
    tribos sweep scenes/compaction-small.toml --set cohesion_range=1e-4,1e-3,1e-2 \\
        --seeds 5 --out out/range
  Both readings of cohesion at a gap:
    tribos sweep scenes/compaction-small.toml --set attraction=pull,resistance --out out/pull
  Whether a tip turns back, over the torque, three seeds each (fig. 5.2):
    tribos sweep scenes/tip-irreversible.toml --set lambda=0.01,0.017,0.02,0.03 \\
        --seeds 3 --jobs 2 --out out/tip";

impl Arguments {
    /// Runs, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let grid = Grid::parse(&self.sets)?;
        let tasks = jobs::tasks(&self.scene, &grid, self.seeds.get(), &self.out)?;
        let summaries = jobs::run(&tasks, self.jobs.get())?;
        let table = Table::new(
            jobs::kind(&tasks),
            &grid,
            &summaries,
            self.seeds.get() as usize,
        );
        write_atomically(&self.out.join("sweep.csv"), table.csv().as_bytes())?;
        plot::write(&grid, &table, &self.out)?;
        super::print(&format!(
            "{}written to    {}\n",
            table.text(),
            self.out.display()
        ))
    }
}
