//! What happens to the files of an earlier result, and to those of somebody else.

use super::*;
use std::fs::{create_dir_all, write};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn contents<'a>(command: &'static str, files: &'a [&'a str]) -> Contents<'a> {
    Contents::of(command, files)
}

#[test]
fn a_new_result_takes_away_what_the_old_one_left_and_nothing_else() -> Outcome {
    let home = tempfile::tempdir()?;
    let out = home.path().join("out");
    let here = |name: &str| out.join(name).exists();
    let first = contents("run", &["summary.json", "still-#.png", "view.html"]);
    let held = OutputFolder::begin(&out, &first)?;
    for name in [
        "summary.json",
        "still-12.png",
        "still-life.png",
        "notes.txt",
        ".tribos-7.tmp",
    ] {
        write(out.join(name), "x")?;
    }
    drop(held);
    let second = contents("deposit", &["deposit.xyz", "summary.json"]);
    let held = OutputFolder::begin(&out, &second)?;
    assert!(!here("summary.json") && !here("still-12.png") && !here(".tribos-7.tmp"));
    assert!(here("still-life.png") && here("notes.txt"));
    let kept = Manifest::read(&out)?.ok_or("no manifest")?;
    assert_eq!((kept.command.as_str(), kept.files.len()), ("deposit", 2));
    // In the end it names what was written.
    write(out.join("deposit.xyz"), "x")?;
    drop(held);
    let kept = Manifest::read(&out)?.ok_or("no manifest")?;
    assert_eq!(kept.files, ["deposit.xyz"]);
    write(out.join("summary.json"), "mine")?;
    assert!(OutputFolder::begin(&out, &second).is_err());
    Ok(())
}

#[test]
fn files_of_somebody_else_are_not_replaced() -> Outcome {
    let home = tempfile::tempdir()?;
    let out = home.path();
    write(out.join("summary.json"), "mine")?;
    let refused = OutputFolder::begin(out, &contents("run", &["summary.json"]));
    let Err(RecordError::Refused(told)) = refused else {
        unreachable!("a stranger's file");
    };
    assert!(told.contains("summary.json is there"), "{told}");
    let held = OutputFolder::begin(out, &contents("run", &["series.csv"]))?;
    // Ours by now is series.csv alone.
    write(out.join("series.csv"), "ours")?;
    assert!(held.add(&["summary.json"]).is_err());
    drop(held);
    assert!(OutputFolder::begin(out, &contents("eval", &["summary.json"])).is_err());
    assert!(out.join("series.csv").exists());
    assert_eq!(std::fs::read(out.join("summary.json"))?, b"mine");
    Ok(())
}

#[test]
fn what_goes_on_stays_and_collections_are_not_replaced() -> Outcome {
    let home = tempfile::tempdir()?;
    let out = home.path();
    let sweep = contents("sweep", &["sweep.csv"]);
    let held = OutputFolder::begin(out, &sweep)?;
    write(out.join("sweep.csv"), "x")?;
    drop(held);
    drop(OutputFolder::reopen(out, &sweep)?);
    assert!(out.join("sweep.csv").exists());
    let about = Contents {
        about: 7.into(),
        ..sweep.clone()
    };
    drop(OutputFolder::reopen(out, &about)?);
    assert!(!out.join("sweep.csv").exists());
    assert!(OutputFolder::begin(out, &contents("run", &["series.csv"])).is_err());
    Ok(())
}

#[test]
fn runs_of_every_body_that_takes_long_are_kept() -> Outcome {
    for body in ["powder", "grains", "gas", "tip"] {
        let home = tempfile::tempdir()?;
        let out = home.path();
        let run = Contents {
            about: serde_json::json!({ "body": body }),
            ..contents("run", &["checkpoint.json", "summary.json"])
        };
        let held = OutputFolder::begin(out, &run)?;
        write(out.join("checkpoint.json"), "x")?;
        drop(held);
        // Broken off: neither the same command nor another one begins in its place.
        assert!(OutputFolder::begin(out, &run).is_err(), "{body}");
        let other = contents("measure", &["measures.json"]);
        assert!(OutputFolder::begin(out, &other).is_err(), "{body}");
        // Finished: the same command does, another one does not.
        let held = OutputFolder::reopen(out, &run)?;
        write(out.join("summary.json"), "x")?;
        drop(held);
        assert!(OutputFolder::begin(out, &other).is_err(), "{body}");
        assert!(out.join("checkpoint.json").exists() && out.join("summary.json").exists());
        drop(OutputFolder::begin(out, &run)?);
        assert!(!out.join("summary.json").exists(), "{body}");
    }
    Ok(())
}

#[test]
fn a_damaged_manifest_or_one_that_leads_out_of_the_folder_is_refused() -> Outcome {
    let home = tempfile::tempdir()?;
    let out = home.path().join("out");
    create_dir_all(&out)?;
    write(home.path().join("victim"), "x")?;
    let outside = Manifest::of(&contents("run", &["../victim"]));
    outside.write(&out)?;
    assert!(OutputFolder::begin(&out, &contents("run", &[])).is_err());
    assert!(home.path().join("victim").exists());
    Manifest::of(&contents("run", &["a"])).write(&out)?;
    let file = out.join(manifest::NAME);
    let text = std::fs::read_to_string(&file)?;
    write(&file, text.replace("\"a\"", "\"b\""))?;
    assert!(Manifest::read(&out).is_err());
    write(&file, text)?;
    assert!(Manifest::read(&out)?.is_some());
    Ok(())
}
