//! Progress: plain lines in a pipe, a bar with the time left in a terminal, nothing with --quiet.
#![cfg(unix)]

use crate::program::{Error, Outcome};
use std::process::{Command, Output};

/// A tip that takes some seconds.
const TIP: [&str; 20] = [
    "run",
    "tip-reversible",
    "--set",
    "substrate_columns=12",
    "--set",
    "substrate_rows=14",
    "--set",
    "tip_side_atoms=3",
    "--set",
    "substrate_layers=4",
    "--set",
    "tip_layers=4",
    "--set",
    "equilibration=1",
    "--set",
    "drive_time=120",
    "--set",
    "rest_time=1",
    "--frames",
    "0",
];

fn tip(more: &[&str]) -> Result<(Output, tempfile::TempDir), Error> {
    let folder = tempfile::tempdir()?;
    let mut command = Command::new(env!("CARGO_BIN_EXE_tribos"));
    command.args(TIP).args(more).arg("--out").arg(folder.path());
    Ok((command.output()?, folder))
}

#[test]
fn a_pipe_gets_plain_lines_with_the_time_left() -> Outcome {
    let (output, _folder) = tip(&[])?;
    assert!(output.status.success());
    let told = String::from_utf8(output.stderr)?;
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
    let (output, _folder) = tip(&["--quiet"])?;
    assert!(output.status.success());
    assert_eq!(String::from_utf8(output.stderr)?, "");
    assert!(String::from_utf8(output.stdout)?.contains("verdict"));
    let refused = Command::new(env!("CARGO_BIN_EXE_tribos"))
        .args(["-q", "run", "dsik", "--out", "x"])
        .output()?;
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8(refused.stderr)?.starts_with("error: "));
    Ok(())
}

#[test]
fn a_terminal_gets_a_bar_that_is_gone_at_the_end() -> Outcome {
    let folder = tempfile::tempdir()?;
    // `script` of util-linux runs a command in a terminal of its own.
    let command = format!(
        "'{}' {} --out '{}'",
        env!("CARGO_BIN_EXE_tribos"),
        TIP.join(" "),
        folder.path().display()
    );
    let output = Command::new("script")
        .args(["-qec", &command, "/dev/null"])
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
