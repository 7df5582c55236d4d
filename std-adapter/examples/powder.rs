//! A cohesive powder compacted under a piston, with checkpoints from which it can be resumed.

use tribos::powder::PowderSimulation;
use tribos::run::{Session, StartMode};
use tribos::scene::PowderScene;

#[rustfmt::skip] // As short as documentation shows it.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = PowderScene { width: 12.0, height: 20.0, mu_rolling: 0.1, ..Default::default() };
    let run: PowderSimulation = Session::in_folder("out/powder-example")?
        .start(StartMode::ResumeIfPossible)
        .on_checkpoint(|run: &PowderSimulation, file| println!("step {}: {}", run.steps(), file.display()))
        .run(&scene)?;
    println!("porosity {:.4}", run.outcome().porosity_final);
    Ok(())
}
