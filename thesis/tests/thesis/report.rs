//! The report is complete, no comparison with the thesis fails, and what ends it early loses nothing.

use crate::browser::Browser;
use crate::{Error, Outcome};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::verdict::KINDS;
use tribos_thesis::EXHIBITS;

/// Exhibits for the test of kills: quick ones, and a compaction of some seconds.
const KILLED: [&str; 4] = ["3.4", "3.9", "4.5", "4.6"];

/// Rows of each kind of verdict in a quick report.
const COUNTS: [usize; 10] = [45, 133, 172, 39, 37, 2, 5, 23, 24, 0];

/// Pages beside the front page.
const PAGES: [&str; 5] = [
    "chapter-2.html",
    "chapter-3.html",
    "chapter-4.html",
    "chapter-5.html",
    "appendices.html",
];

/// Columns of claims.csv before its numbers.
const WORDS: usize = 8;

fn reproduce(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tribos-thesis"));
    command.arg("--out").arg(folder);
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
            let [ours, theirs] = [read(folder.path())?, read(undisturbed.path())?];
            let same = match name.to_str() {
                // When it was made, and in how many seconds.
                Some("index.html") => without_the_date(&ours)? == without_the_date(&theirs)?,
                _ => ours == theirs,
            };
            assert!(same, "{}", name.display());
            files += 1;
        }
    }
    // A figure twice and its numbers; two chapters, the front page, the claims, the list of the files.
    assert_eq!(files, 3 * KILLED.len() + 5);
    Ok(())
}

/// The front page but for the row on its date.
fn without_the_date(page: &[u8]) -> Result<String, Error> {
    let page = String::from_utf8(page.to_vec())?;
    let lines: Vec<&str> = page.lines().collect();
    let others = lines
        .iter()
        .filter(|line| !line.starts_with("<tr><td>made</td>"));
    let others: Vec<&str> = others.copied().collect();
    assert_eq!(others.len() + 1, lines.len());
    Ok(others.join("\n"))
}

/// The report in the folder that TRIBOS_REPORT names, made by this program; or one made now.
#[test]
#[ignore = "some minutes; cargo test --release -p tribos-thesis --test thesis report -- --ignored"]
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
    let read = |name: &str| std::fs::read_to_string(folder.join(name));
    let front = read("index.html")?;
    let mut page = front.clone();
    for chapter in PAGES {
        assert!(
            front.contains(&format!("<a href=\"{chapter}\">")),
            "{chapter}"
        );
        page += &read(chapter)?;
    }
    links_lead_somewhere(&folder)?;
    claims.differences_are_told(&front);
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
        "section-4.6-choices",
        "section-5.2",
        "appendix-b",
    ] {
        assert!(folder.join(format!("{name}.csv")).exists());
    }
    assert!(page.contains("0.653002") && !page.contains("0.653001789206"));
    assert!(page.contains("What of the thesis has no exhibit") && page.contains("figure 3.12"));
    assert!(front.contains("<li><b>What holds</b>") && page.contains("Soft particles ("));
    assert_eq!(front.matches("<figcaption>").count(), 3);
    assert!(
        !front.contains(['`', '{'])
            || !front
                .split("</style>")
                .nth(1)
                .is_some_and(|body| body.contains(['`', '{']))
    );
    the_pages_are_shown(&folder)
}

/// Every link within the report has a file, and a place in it.
fn links_lead_somewhere(folder: &Path) -> Outcome {
    let mut links = 0;
    for from in PAGES.iter().chain(&["index.html"]) {
        let page = std::fs::read_to_string(folder.join(from))?;
        for target in page.split(" href=\"").skip(1) {
            let target = target.split('"').next().unwrap_or_default();
            if target.starts_with("data:") {
                continue;
            }
            let (file, place) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { from } else { file };
            assert!(folder.join(file).is_file(), "{from}: {target}");
            if !place.is_empty() {
                let there = std::fs::read_to_string(folder.join(file))?;
                assert!(
                    there.contains(&format!("id=\"{place}\"")),
                    "{from}: {target}"
                );
            }
            links += 1;
        }
    }
    assert!(links > 600, "{links}");
    Ok(())
}

/// The rows of claims.csv; see its second line.
struct Claims(Vec<Vec<String>>);

impl Claims {
    fn read(file: &Path) -> Result<Self, Error> {
        let text = std::fs::read_to_string(file)?;
        let fields = |line: &str| {
            let inside = line.trim_matches('"').split("\",\"");
            let mut fields: Vec<String> = inside.map(str::to_owned).collect();
            let numbers = fields[WORDS - 1].split_once("\",").map(|(last, numbers)| {
                let numbers = numbers
                    .split(',')
                    .map(|number| number.trim_matches('"').to_owned());
                (last.to_owned(), numbers.collect::<Vec<String>>())
            });
            if let Some((last, numbers)) = numbers {
                fields[WORDS - 1] = last;
                fields.extend(numbers);
            }
            fields
        };
        let rows: Vec<Vec<String>> = text.lines().skip(2).map(fields).collect();
        assert!(rows.iter().all(|row| row.len() > WORDS + 8));
        Ok(Self(rows))
    }

    /// How many rows have this verdict.
    fn count(&self, verdict: &str) -> usize {
        self.0.iter().filter(|row| row[6] == verdict).count()
    }

    /// A row that changes its verdict has to be looked at.
    fn are_as_they_were(&self) {
        let counts = KINDS.map(|verdict| self.count(verdict));
        assert_eq!(counts, COUNTS);
        assert_eq!(counts.iter().sum::<usize>(), self.0.len());
    }

    fn reproduced_rows_have_a_number_and_an_allowance(&self) -> Outcome {
        for row in self.0.iter().filter(|row| row[6] == "reproduced") {
            assert!(!row[1].is_empty() && !row[3].is_empty(), "{row:?}");
            let allowance = row[7].strip_prefix("± ").ok_or("no allowance")?;
            let (_, reason) = allowance.split_once(": ").ok_or("no reason")?;
            let number = |at: usize| row[WORDS + at].parse::<f64>();
            let [thesis, ours] = [number(0)?, number(1)?];
            let [difference, allowance] = [number(2)?, number(3)?];
            assert_eq!((ours - thesis).abs(), difference, "{row:?}");
            assert!(difference <= allowance && !reason.is_empty(), "{row:?}");
        }
        Ok(())
    }

    /// Each row that differs for an open reason, or may, stands in the front page's table.
    fn differences_are_told(&self, front: &str) {
        let open = |row: &&Vec<String>| ["differs", "undecided"].contains(&row[6].as_str());
        for row in self.0.iter().filter(open) {
            assert!(front.contains(&format!("#{}\"", row[0])), "{row:?}");
        }
    }
}

/// Every figure is there, letters can be read, films play, and the browser has nothing to complain of.
fn the_pages_are_shown(folder: &Path) -> Outcome {
    let Some(mut browser) = Browser::start(1200, 900)? else {
        return Ok(());
    };
    let shown = "[...document.querySelectorAll('figure > .card > svg')] \
        .filter(svg => svg.getBoundingClientRect().height > 100).length";
    let smallest = "Math.min(...[...document.querySelectorAll('figure > .card > svg text')].map(text => { \
        const { a, b } = text.getScreenCTM(); \
        return parseFloat(getComputedStyle(text).fontSize) * Math.hypot(a, b); }))";
    let wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth";
    let mut figures = 0;
    for page in PAGES {
        browser.open(&folder.join(page), "document.readyState === 'complete'")?;
        figures += browser.value(shown)?.as_u64().unwrap_or_default();
        let size = browser.value(smallest)?.as_f64().unwrap_or_default();
        assert!(size >= 10.9, "{page}: letters of {size} px");
        assert_eq!(browser.value(wide)?, 0, "{page}");
    }
    assert_eq!(figures, EXHIBITS.len() as u64);
    browser.open(
        &folder.join("index.html"),
        "document.readyState === 'complete'",
    )?;
    assert_eq!(browser.value(shown)?, 3);
    // What a reader with a minute needs is on the first screen.
    let bottom = "document.querySelector('.pictures').getBoundingClientRect().bottom";
    let bottom = browser.value(bottom)?.as_f64().unwrap_or(f64::NAN);
    assert!(bottom <= 900.0, "{bottom}");
    assert!(browser.screenshot("report.png")?.colors() > 100);
    let films = "document.querySelectorAll('.tribos-player[data-state=ready]').length";
    for page in ["chapter-4.html", "chapter-5.html"] {
        browser.open(&folder.join(page), &format!("{films} === 1"))?;
        browser.click(".tribos-player .play")?;
        browser.wait("document.querySelector('.tribos-player').player.frame > 3")?;
    }
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
        let output = reproduce(folder.path()).arg(name).output()?;
        assert!(output.status.success(), "{name}: {output:?}");
        assert!(folder.path().join(file).exists());
    }
    assert!(!folder.path().join("figure-3.4.csv").exists());
    Ok(())
}

#[test]
fn bad_arguments_are_refused_before_any_work() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("taken"), "text")?;
    for (arguments, words) in [
        ("--out out 9.9", "the names are section-2.1"),
        ("", "--out"),
        ("--out out --quick --full", "cannot be used with"),
        ("--out out --checkpoint -1", "give a number >= 0"),
        ("--out taken 2.5", "taken is a file; give a folder"),
        ("--out= 2.5", "a value is required for '--out <DIR>'"),
    ] {
        let said = fails(folder.path(), arguments, 2)?;
        assert!(said.contains(words), "{arguments}: {said}");
    }
    assert_eq!(std::fs::read_dir(folder.path())?.count(), 1);
    Ok(())
}

#[test]
fn a_strangers_file_and_the_results_of_others_are_not_replaced() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    std::fs::create_dir(&out)?;
    std::fs::write(out.join("figure-2.7.csv"), "mine")?;
    let said = fails(folder.path(), "--out out 2.7", 2)?;
    assert!(said.contains("does not say that tribos wrote it"), "{said}");
    assert_eq!(std::fs::read(out.join("figure-2.7.csv"))?, b"mine");
    // A sweep, and a finished run of a powder.
    for (command, about) in [("sweep", Value::Null), ("run", json!({ "body": "powder" }))] {
        let out = folder.path().join(command);
        let contents = Contents {
            about,
            ..Contents::of(command, &["summary.json"])
        };
        let theirs = OutputFolder::begin(&out, &contents)?;
        std::fs::write(out.join("summary.json"), "{}")?;
        drop(theirs);
        let said = fails(folder.path(), &format!("--out {command} 2.7"), 2)?;
        let words = format!("holds the results of `tribos {command}`; give another --out");
        assert!(said.contains(&words), "{said}");
        assert!(out.join("summary.json").exists() && !out.join("claims.csv").exists());
    }
    // Nor is a report by them.
    let report = folder.path().join("report");
    assert!(reproduce(&report).arg("2.7").status()?.success());
    let theirs = OutputFolder::begin(&report, &Contents::of("run", &["summary.json"]));
    let said = theirs.map_or_else(|refusal| refusal.to_string(), |_| String::new());
    assert!(
        said.contains("holds the results of `tribos reproduce`"),
        "{said}"
    );
    Ok(())
}

/// With files of at most two kilobytes: a larger write is an error, as on a full disk.
#[cfg(unix)]
#[test]
fn a_report_without_room_says_where_it_stopped_and_goes_on() -> Outcome {
    let folder = tempfile::tempdir()?;
    let program = env!("CARGO_BIN_EXE_tribos-thesis");
    let line = format!("trap '' XFSZ; ulimit -f 4; exec '{program}' --out out 3.4");
    let limited = Command::new("sh")
        .args(["-c", &line])
        .current_dir(folder.path())
        .output()?;
    let said = String::from_utf8(limited.stderr)?;
    assert_eq!(limited.status.code(), Some(1), "{said}");
    for words in [
        "cannot write out/figure-3.4.",
        "File too large",
        "whole and kept",
        "the same command again",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    assert_eq!(said.matches("File too large").count(), 1, "{said}");
    nothing_is_half_written(&folder.path().join("out"))?;
    let whole = reproduce(&folder.path().join("out")).arg("3.4").output()?;
    assert!(whole.status.success(), "{whole:?}");
    Ok(())
}

/// SIGINT ends a report with the code that shells have for it; what is finished is kept.
#[cfg(unix)]
#[test]
fn an_interrupted_report_says_so_and_goes_on() -> Outcome {
    let folder = tempfile::tempdir()?;
    let child = reproduce(folder.path())
        .args(["--checkpoint", "0.5", "4.6"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()?;
    std::thread::sleep(Duration::from_secs(1));
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status()?.success());
    let output = child.wait_with_output()?;
    let said = String::from_utf8(output.stderr)?;
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(
        said.ends_with("what was finished is kept\n  Give the same command again.\n"),
        "{said}"
    );
    Ok(())
}

/// Every line that the documentation prints is one that the program takes, and so are its own examples.
#[test]
fn printed_commands_are_taken() -> Outcome {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut texts = vec![std::fs::read_to_string(root.join("README.md"))?];
    for page in std::fs::read_dir(root.join("docs"))? {
        let page = page?.path();
        if page.extension().is_some_and(|ending| ending == "md") {
            texts.push(std::fs::read_to_string(page)?);
        }
    }
    let help = Command::new(env!("CARGO_BIN_EXE_tribos-thesis"))
        .arg("--help")
        .output()?;
    texts.push(String::from_utf8(help.stdout)?);
    let calls = ["tribos reproduce ", "tribos-thesis -- ", "  tribos-thesis "];
    let mut taken = 0;
    for text in &texts {
        for call in calls {
            for rest in text.split(call).skip(1) {
                let rest = rest.split(['`', '\n', '#']).next().unwrap_or_default();
                // A word of a sentence, or a placeholder.
                let is_whole = rest.contains("--") && !rest.contains(char::is_uppercase);
                if is_whole {
                    let output = Command::new(env!("CARGO_BIN_EXE_tribos-thesis"))
                        .args(rest.split_whitespace())
                        .args((!rest.contains("--list")).then_some("--list"))
                        .output()?;
                    assert!(output.status.success(), "{rest}: {output:?}");
                    taken += 1;
                }
            }
        }
    }
    assert!(taken > 8, "{taken}");
    Ok(())
}

/// What the program says when it ends with this code.
fn fails(folder: &Path, arguments: &str, code: i32) -> Result<String, Error> {
    let output = Command::new(env!("CARGO_BIN_EXE_tribos-thesis"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()?;
    let said = String::from_utf8(output.stderr)?;
    assert_eq!(output.status.code(), Some(code), "{arguments}: {said}");
    Ok(said)
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
