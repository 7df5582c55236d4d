//! What a report keeps, and goes on from.

use crate::Outcome;
use std::fmt;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use tribos::run::folder::{Lock, LockMode};
use tribos_report::claim::{Claim, Statement};
use tribos_report::page::{FigureRef, Section};
use tribos_thesis::runs::{Case, Runs, System};
use tribos_thesis::section_cache::{FOLDER, SectionCache};
use tribos_thesis::{Effort, Reader};

fn open(report: &Path) -> anyhow::Result<SectionCache> {
    let lock = Lock::take(report, LockMode::Shared)?;
    SectionCache::open(lock.into(), Duration::ZERO)
}

#[test]
fn a_section_is_kept_with_its_effort_while_its_files_are_there() -> Outcome {
    let folder = tempfile::tempdir()?;
    let kept = open(folder.path())?;
    // Numbers of all magnitudes, whose last bits count.
    let odd = |i: u32| f64::from_bits(0x3F31_9E37_79B9_7F4A_u64.wrapping_mul(2 * u64::from(i) + 1));
    let claims = (0..1000).map(odd).filter(|number| number.is_finite());
    let claims = claims.map(|number| {
        let statement = Statement::parse("a — b");
        Claim::own(statement, number, 0.0, f64::MAX)
    });
    let section = Section {
        claims: claims.collect(),
        heading: "Ångström".into(),
        figure: Some(FigureRef {
            files: vec!["a.csv".into()],
            ..FigureRef::default()
        }),
        ..Section::default()
    };
    kept.keep("3.4", Effort::Quick, &section)?;
    assert_eq!(kept.section("3.4", Effort::Quick), None);
    std::fs::write(folder.path().join("a.csv"), "x\n")?;
    assert!(kept.section("3.4", Effort::Quick) == Some(section));
    assert_eq!(kept.section("3.4", Effort::Full), None);
    Ok(())
}

#[test]
fn what_another_program_left_is_taken_away() -> Outcome {
    let folder = tempfile::tempdir()?;
    let other = folder.path().join(FOLDER).join("0.0.0-0123456789abcdef");
    std::fs::create_dir_all(&other)?;
    let mine = ["mine", "kept/mine", "kept/holiday-2026"].map(|name| folder.path().join(name));
    for mine in &mine {
        std::fs::create_dir_all(mine)?;
    }
    let kept = open(folder.path())?;
    assert!(!other.exists() && mine.iter().all(|mine| mine.exists()));
    std::fs::create_dir_all(kept.run("x"))?;
    assert!(open(folder.path())?.run("x").exists());
    Ok(())
}

struct SilentReader;

impl Reader for SilentReader {
    fn result(&self, _: fmt::Arguments<'_>) {}
    fn progress(&self, _: fmt::Arguments<'_>) {}
    fn is_cancelled(&self) -> bool {
        false
    }
}

fn runs_in(folder: &Path) -> anyhow::Result<Runs<'static>> {
    Ok(Runs::new(Effort::Quick, open(folder)?, &SilentReader))
}

#[test]
fn a_case_is_run_once_and_answers_in_the_order_asked() -> Outcome {
    let folder = tempfile::tempdir()?;
    let runs = runs_in(folder.path())?;
    let case = |seed| {
        Case::new(System::Small, [0.0; 2], seed).with("steps=2", |scene| scene.max_steps = 2)
    };
    let first = runs.of(&[case(2), case(1), case(2)])?;
    assert!(Arc::ptr_eq(&first[0], &first[2]) && !Arc::ptr_eq(&first[0], &first[1]));
    assert!(Arc::ptr_eq(&first[1], &runs.one(&case(1))?));
    assert_eq!(first[0].scene.seed, 2);
    assert_eq!(first[1].scene.seed, 1);
    assert_eq!(first[1].outcome.steps, 2);
    // Another process finds it at its end.
    let again = runs_in(folder.path())?.one(&case(1))?;
    assert_eq!(again.outcome.statistics, first[1].outcome.statistics);
    assert_eq!(again.states[1].positions, first[1].states[1].positions);
    Ok(())
}
