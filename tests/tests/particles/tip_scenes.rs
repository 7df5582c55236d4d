//! The tips that are shipped do what their names say.

use tribos::scene::{TipScene, library_scene};
use tribos::tip::{Reversal, TipSimulation, TipSummary};
use tribos_tests::tips::to_the_end;

type Error = Box<dyn std::error::Error>;

/// Runs a shipped scene with other keys.
fn outcome(name: &str, overrides: &[&str]) -> Result<TipSummary, Error> {
    let shipped = library_scene(name).ok_or("no such scene")?;
    let overrides: Vec<String> = overrides.iter().map(|&set| set.into()).collect();
    let scene = TipScene::parse(name, shipped.text, &overrides)?;
    let mut run = TipSimulation::new(&scene)?;
    to_the_end(&mut run)?;
    Ok(run.outcome())
}

/// Shorter stages and longer steps: a tenth of the work.
const SHORT: [&str; 4] = [
    "time_step=0.01",
    "equilibration=10",
    "drive_time=40",
    "rest_time=40",
];

#[test]
fn shortened_the_irreversible_tip_does_not_turn_back() -> Result<(), Error> {
    let turned = outcome("tip-irreversible", &SHORT)?;
    assert_eq!(turned.verdict, Reversal::Irreversible, "{turned:?}");
    assert!(turned.final_angle_degrees.abs() > 30.0, "{turned:?}");
    Ok(())
}

#[test]
fn shortened_the_reversible_tip_turns_back() -> Result<(), Error> {
    let back = outcome("tip-reversible", &SHORT)?;
    assert_eq!(back.verdict, Reversal::Reversible, "{back:?}");
    assert!(back.driven_angle_degrees > 0.5, "it was turned: {back:?}");
    Ok(())
}

#[test]
#[ignore = "some minutes; cargo test --release -p tribos-tests --test particles tip_scenes -- --ignored"]
fn whole_the_shipped_tips_turn_back_and_do_not() -> Result<(), Error> {
    let turned = outcome("tip-irreversible", &[])?;
    assert_eq!(turned.verdict, Reversal::Irreversible, "{turned:?}");
    assert_eq!(
        outcome("tip-reversible", &[])?.verdict,
        Reversal::Reversible
    );
    Ok(())
}
