//! A sliding body: run here and now, for a moment at most if it is one in the plane.

use crate::command::explain::patience::{takes, within};
use crate::command::explain::{line, lines};
use crate::failure::Failure;
use serde_json::Value;
use std::time::Instant;
use tribos::motion::MotionScene;
use tribos::slide::FrictionWork;

/// Share of all work below which a motion counts as idle, and a bend of the path as straight.
const LITTLE: f64 = 0.01;

/// A body in motion.
pub fn motion(scene: &dyn MotionScene) -> Result<String, Failure> {
    let begun = Instant::now();
    let run = match within(|go_on| scene.follow(go_on)) {
        Ok(run) => run?,
        Err(text) => return Ok(text),
    };
    let Some(spent) = run.spent else {
        return Ok(lines(&run.told));
    };
    let text = account(&spent) + &takes(begun.elapsed());
    let entry = |name: &str| run.outcome.get(name).and_then(Value::as_f64);
    Ok(text
        + &match (entry("x"), entry("curl"), entry("max_lean")) {
            (Some(along), Some(aside), Some(lean)) => path(along, aside, lean),
            _ => idle_spin(scene, &spent),
        })
}

/// A spin that a straight path could do without.
fn idle_spin(scene: &dyn MotionScene, spent: &FrictionWork) -> String {
    if spent.spinning_share() < LITTLE && scene.json()["spin"].as_f64() != Some(0.0) {
        line(
            "could go",
            "the spin held next to no energy: check with --set spin=0",
        )
    } else {
        String::new()
    }
}

/// A path, and its bend if it has next to none.
fn path(along: f64, aside: f64, lean: f64) -> String {
    let mut text = line(
        "path",
        format!("{along:.4} m along and {aside:.4} m aside, most lean {lean:.4} of the limit"),
    );
    let bend = (aside / along).abs();
    if bend < LITTLE {
        text += &line(
            "could go",
            format!(
                "the path bends by {:.2} % of its length: where that is too little to matter, a `disk` has one unknown less",
                100.0 * bend
            ),
        );
    }
    text
}

fn account(spent: &FrictionWork) -> String {
    let share = 100.0 * spent.spinning_share();
    let all = spent.sliding + spent.spinning;
    line(
        "energy",
        format!(
            "friction took {all:.4e} J: {:.1} % of it slowed the sliding, {share:.1} % the spin",
            100.0 - share
        ),
    )
}
