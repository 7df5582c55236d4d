//! Programs of fitted laws in C compile and print friction of the law.

use crate::programs::{archive, compile_for_host, folder, has, printed, scratch};
use std::fs;
use std::process::Command;

/// Velocity and friction of a line.
fn numbers(line: &str) -> [f64; 2] {
    let mut found = line.split([' ', ':']).filter_map(|word| word.parse().ok());
    [(); 2].map(|()| found.next().expect("a number"))
}

/// The page has the programs, and behind those of each law the numbers from formulas of their own.
#[test]
fn programs_of_fitted_laws_have_friction_of_the_law() {
    if !has("cc") {
        return;
    }
    let Some(archive) = archive(None) else { return };
    let page = folder("../../std-adapter/motion/src/fit/usage/programs.md");
    let page = fs::read_to_string(page).expect("the page");
    let mut count = 0;
    for block in page.split("```c\n").skip(1) {
        let (program, after) = block.split_once("```").expect("its end");
        let (_, wanted) = after.split_once("```text\n").expect("numbers");
        let (wanted, _) = wanted.split_once("```").expect("their end");
        let source = scratch("fitted.c");
        // Programs print for people; here all digits count.
        fs::write(&source, program.replace("%.9f", "%.17g")).expect("a file");
        let image = scratch("fitted");
        let file = source.to_str().expect("a plain path");
        compile_for_host(&[file], &archive, &image);
        let said = printed(&mut Command::new(image)).replace("m/s", "");
        assert_eq!(said.lines().count(), wanted.lines().count(), "{program}");
        for (said, wanted) in said.lines().zip(wanted.lines()) {
            let ([at, friction], [place, exact]) = (numbers(said), numbers(wanted));
            let error = (friction / exact - 1.0).abs();
            assert!(
                at == place && error < 1e-12,
                "{said} for {wanted}\n{program}"
            );
        }
        count += 1;
    }
    assert!(count >= 15, "{count} programs");
}
