//! `tribos run`, `explain` and `sweep` of bodies that hold, let go and hold again.

use crate::program::{Outcome, number, summary_of};

#[test]
fn the_block_on_a_spring_has_the_period_of_its_closed_form_and_complete_results() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = summary_of("spring-block", folder.path(), &[])?;
    // 2 D/(kV) + (2/w)(pi - atan(w D/(kV))) with D = 1.962 N, k V = 5 N/s, w = 10/s.
    assert!((number(&summary, "period") / 1.148_865_389_396_482_9 - 1.0).abs() < 1e-10);
    assert_eq!(summary["regime"], "stick-slip");
    assert_eq!(summary["scene"]["friction_law"], "dry");
    let series = std::fs::read_to_string(folder.path().join("series.csv"))?;
    assert!(series.starts_with("time,pull,position,velocity,spring_force,friction,state,slips\n"));
    assert_eq!(series.lines().count(), 402);
    for plot in ["motion.svg", "motion.png"] {
        assert!(folder.path().join(plot).metadata()?.len() > 1000);
    }
    Ok(())
}

#[test]
fn paper_creeps_above_the_critical_stiffness_and_sticks_and_slips_below() -> Outcome {
    let folder = tempfile::tempdir()?;
    let soft = summary_of("spring-paper", folder.path(), &[])?;
    assert_eq!(soft["regime"], "stick-slip");
    // N (b - a - eta V)/D_c
    let critical = number(&soft, "critical_stiffness");
    assert!((critical / (10.0 * (0.02 - 20e-6) / 1e-6) - 1.0).abs() < 1e-12);
    let folder = tempfile::tempdir()?;
    let stiff = summary_of("spring-paper", folder.path(), &["stiffness=3e5"])?;
    assert_eq!(stiff["regime"], "creeps");
    let folder = tempfile::tempdir()?;
    let healing = number(&summary_of("spring-holds", folder.path(), &[])?, "healing");
    assert!((healing / 0.03 - 1.0).abs() < 0.05, "{healing}");
    Ok(())
}

#[test]
fn the_incline_and_the_turntable_hold_and_let_go() -> Outcome {
    let folder = tempfile::tempdir()?;
    let incline = summary_of("incline", folder.path(), &["patch=hertz"])?;
    assert!((number(&incline, "release_slope") - 0.5).abs() < 1e-13);
    let folder = tempfile::tempdir()?;
    let held = summary_of("incline", folder.path(), &["end_angle=0.46"])?;
    assert_eq!(
        (&held["ending"], number(&held, "distance")),
        (&"holds".into(), 0.0)
    );
    let folder = tempfile::tempdir()?;
    let table = summary_of("turntable", folder.path(), &[])?;
    assert_eq!(table["ending"], "leaves");
    let share = number(&table, "release_share");
    assert!(share < 1.0 && share > 0.9, "{share}");
    Ok(())
}
