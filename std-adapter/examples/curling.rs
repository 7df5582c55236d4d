//! Curling models against observation: the table of `docs/curling.md`.
//!
//! ```text
//! cargo run --release -p tribos --example curling
//! ```

use tribos::scene::{CurlingScene, IceModel};
use tribos::slide::{MotionError, PlanarSummary};

/// Speed of a draw that stops after 28.35 m without spin under Penner's law, m/s.
const DRAW: f64 = 1.9866;
/// Spins of a draw, rad/s.
const SPINS: [f64; 3] = [0.75, 1.5, 3.0];
/// Launch of a slow shot with fast spin: about 3.5 m forward under Penner's law.
const SLOW: [f64; 2] = [0.16, 20.0];
/// Friction at the back over that in front, which is next to none.
const NONE_IN_FRONT: f64 = 1e300;

/// Of the table: a draw at three spins, at 1.5 rad/s, and the slow shot, in SI.
const HEADING: &str = "\
| model | curl, 0.75 / 1.5 / 3 rad/s | forward, time | slow: forward, left, time | v/(ωR) at rest |
|---|---|---|---|---|";

fn main() -> Result<(), MotionError> {
    use IceModel::{BackHeavy, Dry, Film, FrontBack, LeftRight, PivotSlide, ScratchGuide};
    let rock = |model| CurlingScene {
        model,
        ..CurlingScene::default()
    };
    let back_heavy = |back_to_front| CurlingScene {
        back_to_front,
        ..rock(BackHeavy)
    };
    println!("{HEADING}");
    for scene in [Dry, LeftRight, FrontBack].map(rock) {
        println!("{}", line(&scene)?);
    }
    for scene in [10.0, NONE_IN_FRONT].map(back_heavy) {
        println!("{}", line(&scene)?);
    }
    for scene in [Film, PivotSlide, ScratchGuide].map(rock) {
        println!("{}", line(&scene)?);
    }
    for back_to_front in [10.0, 100.0, f64::INFINITY] {
        let spin = spin_for_a_metre(&back_heavy(back_to_front.min(NONE_IN_FRONT)))?;
        println!("back-heavy {back_to_front:e}: 1 m at {spin:.2} rad/s");
    }
    Ok(())
}

/// One model's line of the table.
fn line(rock: &CurlingScene) -> Result<String, MotionError> {
    let mut curls = Vec::new();
    for spin in SPINS {
        curls.push(format!("{:+.3}", shot(rock, DRAW, spin)?.curl));
    }
    let draw = shot(rock, DRAW, SPINS[1])?;
    let [speed, spin] = SLOW;
    let slow = shot(rock, speed, spin)?;
    Ok(format!(
        "| {} | {} | {:.2}, {:.1} | {:.2}, {:+.2}, {:.1} | {:.2} |",
        rock.model,
        curls.join(" / "),
        draw.x,
        draw.end_time,
        slow.x,
        slow.curl,
        slow.end_time,
        slow.final_ratio,
    ))
}

/// The spin at which a draw curls by 1 m, by bisection to a hundredth.
fn spin_for_a_metre(rock: &CurlingScene) -> Result<f64, MotionError> {
    let (mut low, mut high) = (0.0, 10.0);
    while high - low > 5e-3 {
        let middle = 0.5 * (low + high);
        if shot(rock, DRAW, middle)?.curl < 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(high)
}

fn shot(rock: &CurlingScene, speed: f64, spin: f64) -> Result<PlanarSummary, MotionError> {
    let scene = CurlingScene {
        speed,
        spin,
        ..*rock
    };
    Ok(scene.run()?.outcome)
}
