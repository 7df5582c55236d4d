//! Curling models against observation: the table of `docs/curling.md`.
//!
//! ```text
//! cargo run --release -p tribos --example curling
//! ```

use tribos::slide::SlideError;
use tribos::slide::curling::{
    BackHeavy, CurlingModel, CurlingRock, Dry, Film, FrontBack, IceLaw, LeftRight, PivotSlide,
    ScratchGuide,
};
use tribos::slide::planar::{Arrival, Journey, Launch};

/// Launch speed of a draw that stops after 28.35 m without spin under Penner's law, m/s.
const DRAW: f64 = 1.9866;
/// Spins of a draw, rad/s.
const SPINS: [f64; 3] = [0.75, 1.5, 3.0];
/// Launch of a slow shot with fast spin: about 3.5 m forward under Penner's law.
const SLOW: [f64; 2] = [0.16, 20.0];

fn main() -> Result<(), SlideError> {
    let ice = IceLaw::PENNER;
    let models: [&dyn CurlingModel; 8] = [
        &Dry {
            coefficient: IceLaw::DRY.coefficient,
        },
        &LeftRight { ice },
        &FrontBack { ice },
        &BackHeavy {
            ice,
            back_to_front: 10.0,
        },
        &BackHeavy {
            ice,
            back_to_front: f64::INFINITY,
        },
        &Film {
            ice,
            front: 1.0,
            back: 0.0,
        },
        &PivotSlide {
            ice,
            weight: PivotSlide::WEIGHT,
        },
        &ScratchGuide {
            ice,
            strength: ScratchGuide::STRENGTH,
            onset: ScratchGuide::ONSET,
        },
    ];
    println!(
        "| model | curl at 0.75 / 1.5 / 3 rad/s, m | distance, m | time, s | slow shot: forward, left, m | time, s | v/(ωR) at the end |"
    );
    println!("|---|---|---|---|---|---|---|");
    for model in models {
        let mut draws = Vec::new();
        for spin in SPINS {
            draws.push(shot(model, DRAW, spin)?);
        }
        let slow = shot(model, SLOW[0], SLOW[1])?;
        let curls: Vec<String> = draws
            .iter()
            .map(|d| format!("{:+.3}", d.point.position[1]))
            .collect();
        let [.., draw, _] = draws.as_slice() else {
            continue;
        };
        println!(
            "| {} | {} | {:.2} | {:.2} | {:.2}, {:+.2} | {:.1} | {:.2} |",
            model.name(),
            curls.join(" / "),
            draw.point.position[0],
            draw.point.time,
            slow.point.position[0],
            slow.point.position[1],
            slow.point.time,
            slow.point.ratio,
        );
        eprintln!("{:?} steps {} {}", model, draw.steps, slow.steps);
    }
    Ok(())
}

fn shot(model: &dyn CurlingModel, speed: f64, spin: f64) -> Result<Arrival, SlideError> {
    let body = model.resistance(&CurlingRock::STANDARD)?;
    let launch = Launch {
        velocity: [speed, 0.0],
        spin,
    };
    Journey::new(&body, &launch, 1e-4)?.to_end()
}
