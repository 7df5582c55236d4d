//! `tribos reproduce` is the program `tribos-thesis`: the one beside it, or that on the PATH.
#![cfg(unix)]

use crate::program::{Error, Outcome, assert_has, texts};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;

/// Says where it stands and what it was given, and ends with a code of its own.
const SCRIPT: &str = "#!/bin/sh\necho \"$0: $@\"\necho told >&2\nexit 7\n";

/// The command, copied into a folder.
fn installed(folder: &Path) -> Result<Command, Error> {
    fs::create_dir_all(folder)?;
    let place = folder.join("tribos");
    fs::copy(env!("CARGO_BIN_EXE_tribos"), &place)?;
    Ok(Command::new(place))
}

fn put(folder: &Path) -> Outcome {
    fs::create_dir_all(folder)?;
    let place = folder.join("tribos-thesis");
    fs::write(&place, SCRIPT)?;
    Ok(fs::set_permissions(
        place,
        fs::Permissions::from_mode(0o755),
    )?)
}

#[test]
fn a_report_is_made_by_the_program_beside_or_on_the_path_or_told_where_to_get_it() -> Outcome {
    let home = tempfile::tempdir()?;
    let [own, other] = ["own", "other"].map(|name| home.path().join(name));
    let path = format!("{}:/usr/bin:/bin", other.display());
    let said = |arguments: &str| -> Result<_, Error> {
        let mut tribos = installed(&own)?;
        let tribos = tribos.arg("reproduce").args(arguments.split_whitespace());
        let output = tribos.env("PATH", &path).output()?;
        let [out, err] = texts(&output)?;
        Ok((output.status.code(), out, err))
    };
    let (code, _, err) = said("--out out 3.4")?;
    assert_eq!((code, err.lines().count()), (Some(1), 1), "{err}");
    assert_has(
        &err,
        &[
            "error: ",
            "cargo install --path thesis",
            "cargo run --release -p tribos-thesis",
        ],
    );

    for folder in [&other, &own] {
        put(folder)?;
        let from = folder.join("tribos-thesis");
        for (arguments, passed) in [
            ("--out out 3.4 --full", "--out out 3.4 --full"),
            ("3.4 --help", "3.4 --help"),
            ("--quiet --list", "--quiet --list"),
            ("", ""),
        ] {
            let (code, out, err) = said(arguments)?;
            assert_eq!((code, err.as_str()), (Some(7), "told\n"), "{arguments}");
            assert_eq!(out, format!("{}: {passed}\n", from.display()));
        }
    }
    Ok(())
}

#[test]
fn its_exhibits_complete_as_the_program_lists_them() -> Outcome {
    let home = tempfile::tempdir()?;
    let mut tribos = installed(home.path())?;
    put(home.path())?;
    let script = "#!/bin/sh\n[ \"$1\" = --list ] && printf '3.4\\ntable-3.1\\ntable-3.2\\n'\n";
    fs::write(home.path().join("tribos-thesis"), script)?;
    let asked = tribos
        .args(["--", "tribos", "reproduce", "table-3."])
        .envs([("TRIBOS_COMPLETE", "fish"), ("_CLAP_COMPLETE_INDEX", "2")])
        .output()?;
    let [out, err] = texts(&asked)?;
    let words: Vec<&str> = out
        .lines()
        .filter_map(|line| line.split('\t').next())
        .collect();
    assert_eq!(words, ["table-3.1", "table-3.2"], "{out}{err}");
    Ok(())
}
