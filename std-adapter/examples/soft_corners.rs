//! Porosity of compacted deposits: soft spheres beside contact dynamics, pair by pair.
//!
//!     cargo run --release -p tribos --example soft_corners -- 1e3,1e4 1,2,3,4,5
//!
//! The arguments are stiffnesses in F_coh/R and seeds of the deposit. A third one names corners of rolling and
//! torsion, `00,01,10,11` if it is left out.

use std::error::Error;
use tribos::powder::PowderSimulation;
use tribos::run::run_to_end;
use tribos::scene::PowderScene;
use tribos::statistics::mean_and_error;

type Answer<T> = Result<T, Box<dyn Error>>;

/// The small system of the thesis.
const SCENE: &str = include_str!("../../scenes/compaction-small.toml");

/// Final porosity in percent; the run is told in a line.
fn porosity(corner: &str, seed: &str, method: &[String]) -> Answer<f64> {
    let (rolling, torsion) = corner.split_at(1);
    let mut keys = vec![
        format!("rolling={rolling}"),
        format!("torsion={torsion}"),
        format!("seed={seed}"),
    ];
    keys.extend_from_slice(method);
    let scene = PowderScene::parse("compaction-small.toml", SCENE, &keys)?;
    let mut compaction = PowderSimulation::new(&scene)?;
    run_to_end(&mut compaction, |_, _| ())?;
    let outcome = compaction.outcome();
    let (plus, minus) = (outcome.stress_zz_plus, outcome.stress_zz_minus);
    let porosity = 100.0 * outcome.porosity_final;
    println!(
        "{} porosity {porosity:.2} {:?} time {:.0} steps {} overlap {:.1e} stress {plus:+.2} {minus:+.2} \
         imbalance {:.1e} of {:.1e}, {:.1} s",
        keys.join(" "),
        outcome.ending,
        outcome.time,
        outcome.steps,
        outcome.max_overlap,
        outcome.energy.imbalance,
        outcome.energy.work,
        outcome.wall_seconds,
    );
    Ok(porosity)
}

fn main() -> Answer<()> {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let list = |place: usize, usual: &str| -> Vec<String> {
        let text = given.get(place).map_or(usual, |text| text.as_str());
        text.split(',').map(str::to_owned).collect()
    };
    let (stiffnesses, seeds) = (list(0, "1e3"), list(1, "1,2,3,4,5"));
    for corner in list(2, "00,01,10,11") {
        let mut differences = vec![Vec::new(); stiffnesses.len()];
        for seed in &seeds {
            let rigid = porosity(&corner, seed, &[])?;
            for (stiffness, differences) in stiffnesses.iter().zip(&mut differences) {
                let method = ["method=soft".to_owned(), format!("stiffness={stiffness}")];
                differences.push(porosity(&corner, seed, &method)? - rigid);
            }
        }
        for (stiffness, differences) in stiffnesses.iter().zip(&differences) {
            let [mean, error] = mean_and_error(differences);
            println!("corner {corner}, k = {stiffness}: {mean:+.2} ± {error:.2} points");
        }
    }
    Ok(())
}
