//! A sliding body: run here and now, for a moment at most if it is one in the plane.

use crate::command::explain::patience::{takes, within};
use crate::command::explain::{line, lines};
use crate::failure::Failure;
use std::time::Instant;
use tribos::motion::MotionScene;
use tribos::scene::{DiskScene, Scene};
use tribos::slide::{self, FrictionWork, PlanarScene};

/// Share of all work below which a motion counts as idle, and a bend of the path as straight.
const LITTLE: f64 = 0.01;

/// A body in motion.
pub fn motion(any: &Scene, scene: &dyn MotionScene) -> Result<String, Failure> {
    match any {
        Scene::Disk(scene) => disk(scene),
        Scene::Cylinder(scene) => planar(scene),
        Scene::Pipe(scene) => planar(scene),
        Scene::Plate(scene) => planar(scene),
        Scene::Curling(scene) => planar(scene),
        _ => Ok(match within(|go_on| scene.follow(go_on)) {
            Ok(run) => lines(&run?.told),
            Err(text) => text,
        }),
    }
}

/// A disk on its straight path.
fn disk(scene: &DiskScene) -> Result<String, Failure> {
    let begun = Instant::now();
    let spent = scene.run()?.spent(scene);
    let time = takes(begun.elapsed());
    let idle = if spent.spinning_share() < LITTLE && scene.spin != 0.0 {
        line(
            "could go",
            "the spin held next to no energy: check with --set spin=0",
        )
    } else {
        String::new()
    };
    Ok(account(&spent) + &time + &idle)
}

/// A body in the plane.
fn planar(scene: &dyn PlanarScene) -> Result<String, Failure> {
    let begun = Instant::now();
    let run = match within(|go_on| slide::follow_path(scene, go_on)) {
        Ok(run) => run?,
        Err(text) => return Ok(text),
    };
    let time = takes(begun.elapsed());
    let (along, aside) = (run.outcome.x, run.outcome.curl);
    let bend = (aside / along).abs();
    let mut text = account(&run.spent(scene)) + &time;
    text += &line(
        "path",
        format!(
            "{along:.4} m along and {aside:.4} m aside, most lean {:.4} of the limit",
            run.outcome.max_lean
        ),
    );
    if bend < LITTLE {
        text += &line(
            "could go",
            format!(
                "the path bends by {:.2} % of its length: where that is too little to matter, a `disk` has one unknown less",
                100.0 * bend
            ),
        );
    }
    Ok(text)
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
