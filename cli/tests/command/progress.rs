//! Progress: plain lines in a pipe, a bar with the time left in a terminal, nothing with --quiet.
#![cfg(unix)]

use crate::program::{Outcome, succeed};
use std::process::Command;

/// A tip that takes some seconds.
const TIP: &str = "run tip-reversible --set substrate_columns=12 --set substrate_rows=14 --set tip_side_atoms=3 \
                   --set substrate_layers=4 --set tip_layers=4 --set equilibration=1 --set drive_time=120 \
                   --set rest_time=1 --frames 0 --out out";

#[test]
fn a_pipe_gets_plain_lines_with_the_time_left() -> Outcome {
    let folder = tempfile::tempdir()?;
    let [_, told] = succeed(folder.path(), TIP)?;
    assert!(!told.contains('\r') && !told.contains('\x1b'), "{told:?}");
    let last = told.lines().last().ok_or("nothing was told")?;
    assert!(
        last.contains("time ") && last.contains(" %, ") && last.ends_with(" left"),
        "{told}"
    );
    Ok(())
}

#[test]
fn quiet_takes_progress_away_and_leaves_the_result() -> Outcome {
    let folder = tempfile::tempdir()?;
    let [told, said] = succeed(folder.path(), format!("{TIP} --quiet"))?;
    assert_eq!(said, "");
    assert!(told.contains("verdict"));
    Ok(())
}

#[test]
fn a_terminal_gets_a_bar_that_is_gone_at_the_end() -> Outcome {
    let folder = tempfile::tempdir()?;
    // `script` of util-linux runs a command in a terminal of its own.
    let command = format!("'{}' {TIP}", env!("CARGO_BIN_EXE_tribos"));
    let output = Command::new("script")
        .args(["-qec", &command, "/dev/null"])
        .current_dir(folder.path())
        .env("TERM", "xterm")
        .stdin(std::process::Stdio::null())
        .output();
    let output = match output {
        Ok(output) if output.status.success() => output,
        _ => {
            println!("skipped: no util-linux script");
            return Ok(());
        }
    };
    let shown = String::from_utf8(output.stdout)?;
    let drawn: Vec<&str> = shown
        .split('\r')
        .filter(|part| part.starts_with('['))
        .collect();
    assert!(drawn.len() > 2, "{shown:?}");
    for line in &drawn[1..] {
        assert!(
            line.contains(" % ") && line.contains(" left  time "),
            "{line:?}"
        );
        assert!(
            line.chars().count() <= 79 && !line.contains('\n'),
            "{line:?}"
        );
    }
    // Blanks over the last bar, then the result at the start of the line.
    let (_, result) = shown.rsplit_once("\r       ").ok_or("the bar stays")?;
    assert!(
        result
            .trim_start()
            .trim_start_matches('\r')
            .starts_with("verdict "),
        "{result:?}"
    );
    Ok(())
}
