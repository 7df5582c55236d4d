//! A tip of atoms turned on its substrate by a torque, and let go.

use tribos::run::run_to_end;
use tribos::scene::TipScene;
use tribos::tip::TipSimulation;

#[rustfmt::skip] // As short as documentation shows it.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = TipScene { lambda: 0.02, drive_time: 20.0, rest_time: 20.0, ..TipScene::default() };
    let mut run = TipSimulation::new(&scene)?;
    run_to_end(&mut run, |_line, _done| ())?;
    let outcome = run.outcome();
    println!("{:.2}° driven, {:.2}° after", outcome.driven_angle_degrees, outcome.final_angle_degrees);
    Ok(())
}
