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
use tribos::slide::planar::{PlanarLaunch, PlanarResult, PlanarSimulation};

/// PlanarLaunch speed of a draw that stops after 28.35 m without spin under Penner's law, m/s.
const DRAW: f64 = 1.9866;
/// Spins of a draw, rad/s.
const SPINS: [f64; 3] = [0.75, 1.5, 3.0];
/// PlanarLaunch of a slow shot with fast spin: about 3.5 m forward under Penner's law.
const SLOW: [f64; 2] = [0.16, 20.0];

/// Of the table: a draw at three spins, at 1.5 rad/s, and the slow shot, in SI.
const HEADING: &str = "\
| model | curl, 0.75 / 1.5 / 3 rad/s | forward, time | slow: forward, left, time | v/(ωR) at rest |
|---|---|---|---|---|";

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
    println!("{HEADING}");
    for model in models {
        println!("{}", line(model)?);
    }
    for back_to_front in [10.0, 100.0, f64::INFINITY] {
        let model = BackHeavy { ice, back_to_front };
        let spin = spin_for_a_metre(&model)?;
        println!("back-heavy {back_to_front}: 1 m at {spin:.2} rad/s");
    }
    Ok(())
}

/// One model's line of the table.
fn line(model: &dyn CurlingModel) -> Result<String, SlideError> {
    let mut curls = Vec::new();
    for spin in SPINS {
        let curl = shot(model, DRAW, spin)?.point.position[1];
        curls.push(format!("{curl:+.3}"));
    }
    let draw = shot(model, DRAW, SPINS[1])?.point;
    let [speed, spin] = SLOW;
    let slow = shot(model, speed, spin)?.point;
    Ok(format!(
        "| {} | {} | {:.2}, {:.1} | {:.2}, {:+.2}, {:.1} | {:.2} |",
        model.name(),
        curls.join(" / "),
        draw.position[0],
        draw.time,
        slow.position[0],
        slow.position[1],
        slow.time,
        slow.ratio,
    ))
}

/// The spin at which a draw curls by 1 m, by bisection to a hundredth.
fn spin_for_a_metre(model: &dyn CurlingModel) -> Result<f64, SlideError> {
    let (mut low, mut high) = (0.0, 10.0);
    while high - low > 5e-3 {
        let middle = 0.5 * (low + high);
        if shot(model, DRAW, middle)?.point.position[1] < 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(high)
}

fn shot(model: &dyn CurlingModel, speed: f64, spin: f64) -> Result<PlanarResult, SlideError> {
    let body = model.resistance(&CurlingRock::STANDARD)?;
    let launch = PlanarLaunch {
        velocity: [speed, 0.0],
        spin,
    };
    PlanarSimulation::new(&body, &launch, 1e-4)?.to_end()
}
