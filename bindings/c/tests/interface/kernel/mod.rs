//! `tribos_kernel.h`, which is written here, and Python's terms, which are the same numbers.

mod numbers;
mod rows;
mod text;

use crate::programs::{folder, has, scratch};
use numbers::Type;
use rows::{Draw, name, of_polygon, of_round};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs, thread};

/// Rows of each function and type; `TRIBOS_ROWS` asks for another number.
const ROWS: usize = 20_000;

/// A committed file is the one that is written from the kernel's numbers.
fn is_up_to_date(path: &str, generated: &str) {
    let file = folder(path);
    if env::var_os("TRIBOS_WRITE_HEADER").is_some() {
        fs::write(&file, generated).expect("a writable file");
    }
    let committed = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        committed == generated,
        "{} is out of date: run\n    \
         TRIBOS_WRITE_HEADER=1 cargo test -p tribos-c --test interface kernel",
        file.display()
    );
}

#[test]
fn the_committed_header_of_kernels_is_that_of_the_numbers() {
    is_up_to_date("include/tribos_kernel.h", &text::header());
}

#[test]
fn the_committed_terms_of_python_are_those_of_the_kernel() {
    is_up_to_date("../python/python/tribos/_terms.py", &text::python());
}

/// The program of rows, compiled; nothing without the compiler.
fn compiled(compiler: &str, flags: &[&str]) -> Option<PathBuf> {
    let program = scratch(&format!("kernel-{compiler}"));
    if !has(compiler) {
        return None;
    }
    let mut cc = Command::new(compiler);
    cc.args(flags).args([
        "-Wall",
        "-Wextra",
        "-Werror",
        "-pedantic",
        "-O2",
        "-ffp-contract=off",
    ]);
    cc.arg("-I")
        .arg(folder("include"))
        .arg(folder("tests/interface/kernel/rows.c"));
    let output = cc
        .args(["-lm", "-o"])
        .arg(&program)
        .output()
        .expect("a compiler");
    assert!(
        output.status.success(),
        "{cc:?}\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    Some(program)
}

/// What the program makes of rows, the parts of one after the other.
fn answers<R: Type>(program: &Path, kind: &str, rows: &[impl AsRef<[R]>]) -> Vec<R> {
    let mut child = Command::new(program)
        .args([kind, R::SUFFIX])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("a program");
    let numbers = rows.iter().flat_map(|row| row.as_ref());
    let memory: Vec<u8> = numbers.flat_map(|number| number.to_memory()).collect();
    let mut input = child.stdin.take().expect("a pipe");
    let writer = thread::spawn(move || input.write_all(&memory));
    let output = child.wait_with_output().expect("an answer");
    writer.join().expect("a thread").expect("a whole question");
    assert!(output.status.success(), "{}", output.status);
    output
        .stdout
        .chunks(size_of::<R>())
        .map(R::from_memory)
        .collect()
}

/// Compares the bits of every number; one NaN is like another.
fn assert_same<R: Type, const IN: usize, const OUT: usize>(
    (program, kind): (&Path, &str),
    rows: &[[R; IN]],
    of_kernel: impl Fn(&[R; IN]) -> Option<[R; OUT]>,
) {
    let found = answers(program, kind, rows);
    assert_eq!(found.len(), rows.len() * OUT, "{kind}");
    let (mut differ, mut first) = ([0_usize; OUT], None);
    for (row, found) in rows.iter().zip(found.chunks(OUT)) {
        let wanted = of_kernel(row).into_iter().flatten();
        for (n, (wanted, found)) in wanted.zip(found).enumerate() {
            if wanted.bits() != found.bits() && !(wanted.is_nan() && found.is_nan()) {
                differ[n] += 1;
                first.get_or_insert((name(n), row, wanted, *found));
            }
        }
    }
    let counts: Vec<_> = (0..OUT)
        .filter(|n| differ[*n] > 0)
        .map(|n| (name(n), differ[n]))
        .collect();
    assert!(
        first.is_none(),
        "{kind} {}: {counts:?} of {}, first {first:?}",
        R::SUFFIX,
        rows.len()
    );
}

fn has_the_bits<R: Type>(program: &Path) {
    let count = env::var("TRIBOS_ROWS").map_or(ROWS, |count| count.parse().expect("a number"));
    let mut draw = Draw::new(9);
    // Five pressures share the rows of round patches.
    let rows: Vec<_> = (0..5 * count).map(|_| draw.round::<R>()).collect();
    assert_same((program, "round"), &rows, of_round);
    let rows: Vec<_> = (0..count).map(|_| draw.polygon::<R>()).collect();
    assert_same((program, "polygon"), &rows, of_polygon);
}

#[test]
fn the_header_of_kernels_has_the_kernels_bits() {
    let mut compilers = vec![
        ("cc", &["-std=c99"][..]),
        ("c++", &["-x", "c++", "-std=c++17"]),
    ];
    // A second compiler where there is one.
    if Command::new("clang").arg("--version").output().is_ok() {
        compilers.push(("clang", &["-std=c99"]));
    }
    for (compiler, flags) in compilers {
        if let Some(program) = compiled(compiler, flags) {
            has_the_bits::<f32>(&program);
            has_the_bits::<f64>(&program);
        }
    }
}
