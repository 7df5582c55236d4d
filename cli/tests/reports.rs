//! The report and the phase diagram are complete and agree with the thesis.

#[allow(dead_code)]
mod browser;

use assert_cmd::Command;
use browser::Browser;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

type Outcome = Result<(), Box<dyn std::error::Error>>;

#[test]
fn the_whole_report_is_made_through_kills_and_no_claim_differs() -> Outcome {
    let folder = tempfile::tempdir()?;
    for seconds in [0.3, 2.0, 9.0] {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_tribos"))
            .args(["reproduce", "--checkpoint", "0.5", "--out"])
            .arg(folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()?;
        std::thread::sleep(Duration::from_secs_f64(seconds));
        child.kill()?;
        child.wait()?;
        nothing_is_half_written(folder.path())?;
    }
    Command::cargo_bin("tribos")?
        .args(["reproduce", "--out"])
        .arg(folder.path())
        .assert()
        .success();
    nothing_is_half_written(folder.path())?;
    // What the kills hit, undisturbed.
    let whole = tempfile::tempdir()?;
    Command::cargo_bin("tribos")?
        .args(["reproduce", "--out"])
        .arg(whole.path())
        .args(["3.4", "4.5", "4.6"])
        .assert()
        .success();
    for name in ["3.4", "4.5", "4.6"] {
        for ending in ["csv", "svg", "png"] {
            let file = format!("figure-{name}.{ending}");
            let read = |folder: &Path| std::fs::read(folder.join(&file));
            assert!(read(folder.path())? == read(whole.path())?, "{file}");
        }
    }
    let claims = std::fs::read_to_string(folder.path().join("claims.csv"))?;
    assert!(!claims.contains("\"differs\""));
    assert!(claims.lines().count() > 260);
    assert_eq!(claims.matches("thesis in error").count(), 17);
    assert_eq!(claims.matches("\"not checked\"").count(), 20);
    let unstated = claims.matches("\"differs, with cause: ");
    assert_eq!(unstated.count(), 10);
    let page = std::fs::read_to_string(folder.path().join("index.html"))?;
    for name in [
        "2.5", "2.7", "2.8", "3.3", "3.4", "3.6", "3.7", "3.8", "3.9", "3.10", "3.11", "3.13",
        "3.16", "3.17", "3.19", "4.2", "4.3", "4.5", "4.6", "4.7", "5.1", "5.2",
    ] {
        assert!(page.contains(&format!("Figure {name}:")), "{name}");
        for ending in ["csv", "svg", "png"] {
            let file = folder.path().join(format!("figure-{name}.{ending}"));
            assert!(file.metadata()?.len() > 100, "{}", file.display());
        }
    }
    for name in [
        "table-3.1",
        "table-3.2",
        "table-4.1",
        "section-5.1",
        "section-5.1-modes",
    ] {
        assert!(folder.path().join(format!("{name}.csv")).exists());
    }
    assert!(page.contains("0.653001789206"));
    the_page_is_shown(&folder.path().join("index.html"))
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
    assert_eq!(browser.value(shown)?, 28);
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
            .args([
                "modes",
                "--alpha",
                "0",
                "--inertia-ratio",
                "0.5",
                "--format",
                "json",
                "--diagram",
            ])
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
