//! The report and the phase diagram are complete, and no comparison with the thesis fails.

use crate::browser::Browser;
use crate::program::{Error, Outcome};
#[allow(dead_code)]
use assert_cmd::Command;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::Duration;

/// Exhibits for the test of kills: quick ones, and a compaction of some seconds.
const KILLED: [&str; 4] = ["3.4", "3.9", "4.5", "4.6"];

/// Rows of each kind of verdict in a quick report.
const COUNTS: [usize; 9] = [49, 126, 149, 33, 34, 11, 16, 26, 0];

fn reproduce(folder: &Path) -> std::process::Command {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_tribos"));
    command.args(["reproduce", "--out"]).arg(folder);
    command
}

#[test]
fn a_report_that_is_killed_and_gone_on_with_has_the_same_bits() -> Outcome {
    let folder = tempfile::tempdir()?;
    for seconds in [0.2, 1.0, 3.0] {
        let mut child = reproduce(folder.path())
            .args(["--checkpoint", "0.5"])
            .args(KILLED)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()?;
        std::thread::sleep(Duration::from_secs_f64(seconds));
        child.kill()?;
        child.wait()?;
        nothing_is_half_written(folder.path())?;
    }
    let undisturbed = tempfile::tempdir()?;
    for folder in [&folder, &undisturbed] {
        let output = reproduce(folder.path()).args(KILLED).output()?;
        assert!(output.status.success(), "{output:?}");
        nothing_is_half_written(folder.path())?;
    }
    let mut files = 0;
    for entry in std::fs::read_dir(undisturbed.path())? {
        let name = entry?.file_name();
        let read = |folder: &Path| std::fs::read(folder.join(&name));
        if undisturbed.path().join(&name).is_file() {
            let same = read(folder.path())? == read(undisturbed.path())?;
            assert!(same, "{}", name.display());
            files += 1;
        }
    }
    // A figure twice and its numbers; the page, the claims, the list of the files.
    assert_eq!(files, 3 * KILLED.len() + 3);
    Ok(())
}

/// The report in the folder that TRIBOS_REPORT names, made by `tribos reproduce`; or one made now.
#[test]
fn the_whole_report_is_made_and_no_comparison_fails() -> Outcome {
    let made = tempfile::tempdir()?;
    let folder = match std::env::var_os("TRIBOS_REPORT") {
        Some(folder) => PathBuf::from(folder),
        None => {
            let output = reproduce(made.path()).output()?;
            assert!(output.status.success(), "{output:?}");
            made.path().to_owned()
        }
    };
    let claims = Claims::read(&folder.join("claims.csv"))?;
    claims.are_as_they_were();
    claims.reproduced_rows_have_a_number_and_an_allowance()?;
    let page = std::fs::read_to_string(folder.join("index.html"))?;
    for name in [
        "2.5", "2.7", "2.8", "3.1", "3.3", "3.4", "3.6", "3.7", "3.8", "3.9", "3.10", "3.11",
        "3.13", "3.16", "3.17", "3.19", "4.2", "4.3", "4.5", "4.6", "4.7", "5.1", "5.2",
    ] {
        assert!(page.contains(&format!("Figure {name}:")), "{name}");
        for ending in ["csv", "svg", "png"] {
            let file = folder.join(format!("figure-{name}.{ending}"));
            assert!(file.metadata()?.len() > 100, "{}", file.display());
        }
    }
    for name in [
        "table-3.1",
        "table-3.2",
        "table-4.1",
        "section-3.1-board",
        "section-3.1-inverse",
        "section-3.5.2",
        "section-5.1",
        "section-5.1-modes",
        "section-5.1-lateral",
        "section-2.1",
        "section-2.3",
        "section-3.1",
        "section-5.3",
        "section-5.3-map",
        "section-5.3-metals",
        "section-4.1",
        "section-4.2",
        "section-4.4.1",
        "section-4.4.2",
        "section-5.2",
        "appendix-b",
    ] {
        assert!(folder.join(format!("{name}.csv")).exists());
    }
    assert!(page.contains("0.653002") && !page.contains("0.653001789206"));
    assert!(page.contains("What of the thesis has no exhibit") && page.contains("figure 3.12"));
    assert!(page.contains("<p class=\"lead\">Of ") && page.contains("Soft particles ("));
    let text = page.split("<script").next().unwrap_or_default();
    assert!(!text.contains('`'));
    the_page_is_shown(&folder.join("index.html"))
}

/// The rows of claims.csv: exhibit, place, claim, thesis, ours, uncertainty, difference, verdict,
/// evidence.
struct Claims(Vec<Vec<String>>);

impl Claims {
    fn read(file: &Path) -> Result<Self, Error> {
        let text = std::fs::read_to_string(file)?;
        let fields = |line: &str| {
            let inside = line.trim_matches('"').split("\",\"");
            inside.map(str::to_owned).collect::<Vec<String>>()
        };
        let rows: Vec<Vec<String>> = text.lines().skip(1).map(fields).collect();
        assert!(rows.iter().all(|row| row.len() == 9));
        Ok(Self(rows))
    }

    /// How many rows have this verdict.
    fn count(&self, verdict: &str) -> usize {
        self.0.iter().filter(|row| row[7] == verdict).count()
    }

    /// A row that changes its verdict has to be looked at.
    fn are_as_they_were(&self) {
        let counts = [
            "reproduced",
            "trend reproduced",
            "ours, checked",
            "definition",
            "differs, cause known",
            "differs",
            "thesis in error",
            "not checkable",
            "failed",
        ]
        .map(|verdict| self.count(verdict));
        assert_eq!(counts, COUNTS);
        assert_eq!(counts.iter().sum::<usize>(), self.0.len());
    }

    fn reproduced_rows_have_a_number_and_an_allowance(&self) -> Outcome {
        for row in self.0.iter().filter(|row| row[7] == "reproduced") {
            assert!(!row[1].is_empty() && !row[3].is_empty(), "{row:?}");
            let allowance = row[8].strip_prefix("± ").ok_or("no allowance")?;
            let (allowance, reason) = allowance.split_once(": ").ok_or("no reason")?;
            let (allowance, difference): (f64, f64) = (allowance.parse()?, row[6].parse()?);
            // Both are shown with two digits.
            assert!(difference <= 1.05 * allowance, "{row:?}");
            assert!(!reason.is_empty(), "{row:?}");
        }
        Ok(())
    }
}

/// Every figure is there, films play, and the browser has nothing to complain of.
fn the_page_is_shown(page: &Path) -> Outcome {
    let Some(mut browser) = Browser::start(1200, 1600)? else {
        return Ok(());
    };
    let films = "document.querySelectorAll('.tribos-player[data-state=ready]').length";
    browser.open(page, &format!("{films} === 2"))?;
    let shown = "[...document.querySelectorAll('figure > .card > svg')] \
        .filter(svg => svg.getBoundingClientRect().height > 100).length";
    assert_eq!(browser.value(shown)?, 45);
    browser.click(".tribos-player .play")?;
    browser.wait("document.querySelector('.tribos-player').player.frame > 3")?;
    let picture = browser.screenshot("report.png")?;
    assert!(picture.colors() > 100);
    assert_eq!(browser.complaints(), [""; 0]);
    Ok(())
}

#[test]
fn single_exhibits_are_found_under_several_names() -> Outcome {
    let folder = tempfile::tempdir()?;
    for (name, file) in [
        ("fig3.9", "figure-3.9.csv"),
        ("Table 3.2", "table-3.2.csv"),
        ("Section 5.1", "section-5.1.csv"),
        ("Section 5.1 modes", "section-5.1-modes.csv"),
    ] {
        Command::cargo_bin("tribos")?
            .args(["reproduce", name, "--out"])
            .arg(folder.path())
            .assert()
            .success();
        assert!(folder.path().join(file).exists());
    }
    assert!(!folder.path().join("figure-3.4.csv").exists());
    Ok(())
}

#[test]
fn modes_answers_in_json_and_draws() -> Outcome {
    let folder = tempfile::tempdir()?;
    for ending in ["svg", "png", "csv"] {
        let file = folder.path().join(format!("diagram.{ending}"));
        let output = Command::cargo_bin("tribos")?
            .args("modes --alpha 0 --inertia-ratio 0.5 --format json --diagram".split(' '))
            .arg(&file)
            .output()?;
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout)?;
        let points = answer["fixed_points"].as_array().ok_or("no points")?;
        assert_eq!(points.len(), 3);
        assert_eq!(points[1]["stability"], "stable");
        let ratio = points[1]["ratio"].as_f64().ok_or("no ratio")?;
        assert!((ratio - 0.653_001_789_205_597_6).abs() < 1e-15);
        assert_eq!(answer["final_mode"], "together");
        assert!(file.metadata()?.len() > 1000);
    }
    Ok(())
}

/// Every file under its final name is whole: it ends as its format does.
fn nothing_is_half_written(folder: &Path) -> Outcome {
    for entry in std::fs::read_dir(folder).into_iter().flatten() {
        let path = entry?.path();
        let end: &[u8] = match path.extension().and_then(|ending| ending.to_str()) {
            Some("csv") => b"\n",
            Some("svg") => b"</svg>",
            Some("html") => b"</html>",
            Some("png") => b"IEND\xaeB`\x82",
            // Folders, and what is being written under another name.
            _ => continue,
        };
        let bytes = std::fs::read(&path)?;
        assert!(
            bytes.trim_ascii_end().ends_with(end.trim_ascii_end()),
            "{}",
            path.display()
        );
    }
    Ok(())
}
