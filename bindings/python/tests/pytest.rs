//! Runs the tests of the Python package, where there is a Python that has numpy and pytest.
//!
//! `TRIBOS_PYTHON` names the interpreter (`python3` otherwise). With `TRIBOS_PYTHON_INSTALLED` set the package
//! that is installed there is tested, else one that is built here.

use std::env;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What the tests cannot do without.
const NEEDED: &str = "import sys, numpy, pytest; assert sys.version_info >= (3, 10)";

#[test]
fn tests_in_python_pass() {
    let python = env::var_os("TRIBOS_PYTHON").unwrap_or_else(|| "python3".into());
    let installed = env::var_os("TRIBOS_PYTHON_INSTALLED").is_some();
    if !installed && !succeeds(Command::new(&python).args(["-c", NEEDED])) {
        println!("skipped: {python:?} is no Python from 3.10 on with numpy and pytest");
        return;
    }
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut tests = Command::new(&python);
    // Bytecode and caches stay out of the repository.
    tests
        .args(["-m", "pytest", "-q", "-p", "no:cacheprovider"])
        .arg(package.join("tests"))
        .arg("-c")
        .arg(package.join("pyproject.toml"))
        // Side by side, a file in one process, where that is installed.
        .args(spread(&python))
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .env("TRIBOS_REPOSITORY", package.join("../.."))
        .current_dir(folder.path());
    if !installed {
        tests.env("PYTHONPATH", built(package, folder.path()));
    }
    assert!(succeeds(&mut tests), "the tests in Python failed");
}

fn spread(python: &OsStr) -> &'static [&'static str] {
    if succeeds(
        Command::new(python)
            .args(["-c", "import xdist"])
            .stderr(Stdio::null()),
    ) {
        &["-n", "auto", "--maxprocesses", "4", "--dist", "loadfile"]
    } else {
        &[]
    }
}

fn succeeds(command: &mut Command) -> bool {
    command.status().is_ok_and(|status| status.success())
}

/// A folder that holds the package with its library, built as this test is and found beside it.
fn built(package: &Path, folder: &Path) -> PathBuf {
    let here = env::current_exe().expect("a path of this program");
    let beside = fs::read_dir(here.parent().expect("a folder")).expect("its folder");
    let library = beside
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| is_library(path))
        .expect("the library beside this program");
    let target = folder.join("tribos");
    copy_sources(&package.join("python/tribos"), &target);
    let name = if cfg!(windows) {
        "_native.pyd"
    } else {
        "_native.abi3.so"
    };
    fs::copy(library, target.join(name)).expect("copied");
    folder.to_path_buf()
}

/// Sources of a package and of those in it.
fn copy_sources(from: &Path, to: &Path) {
    fs::create_dir(to).expect("a folder for the package");
    for entry in fs::read_dir(from).expect("the package") {
        let path = entry.expect("an entry").path();
        let target = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy_sources(&path, &target);
        } else if ["py", "typed"]
            .map(OsStr::new)
            .map(Some)
            .contains(&path.extension())
        {
            fs::copy(&path, target).expect("copied");
        }
    }
}

fn is_library(path: &Path) -> bool {
    let stem = path.file_stem().and_then(OsStr::to_str).unwrap_or_default();
    let is_shared = path
        .extension()
        .is_some_and(|end| ["so", "dylib", "dll"].map(OsStr::new).contains(&end));
    is_shared && stem.trim_start_matches("lib") == "tribos_native"
}
