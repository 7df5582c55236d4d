//! A sliding body: run here and now, which takes a moment.

use crate::command::explain::line;
use crate::failure::Failure;
use tribos::scene::SliderScene;
use tribos::slide::{self, PlanarScene, Spent};

/// Share of all work below which a motion counts as idle, and a bend of the path as straight.
const LITTLE: f64 = 0.01;

/// A disk on its straight path.
pub fn disk(scene: &SliderScene) -> Result<String, Failure> {
    let spent = slide::run(scene, |_| ())?.spent(scene);
    let idle = if spent.spinning_share() < LITTLE && scene.spin != 0.0 {
        line(
            "could go",
            "the spin held next to no energy: check with --set spin=0",
        )
    } else {
        String::new()
    };
    Ok(account(&spent) + &idle)
}

/// A body in the plane.
pub fn planar(scene: &dyn PlanarScene) -> Result<String, Failure> {
    let run = slide::run_path(scene)?;
    let [along, aside] = run.outcome.arrival.point.position;
    let bend = (aside / along).abs();
    let mut text = account(&run.spent());
    text += &line(
        "path",
        format!(
            "{along:.4} m along and {aside:.4} m aside, most lean {:.4} of the limit",
            run.outcome.arrival.most_lean
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

fn account(spent: &Spent) -> String {
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
