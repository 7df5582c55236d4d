//! No input breaks a property: 20,000 seeded ones a target, fewer of whole motions.

use tribos_tests::fuzz::{KERNEL, READERS, Target, run};

const INPUTS: u64 = 20_000;
/// A motion to rest takes a thousand times as long as anything else.
const MOTIONS: u64 = 1_000;

fn assert_nothing_is_found(target: &Target, inputs: u64) {
    let report = run(target, 7, 0..inputs);
    let first = report.findings.first();
    assert!(
        report.found == 0,
        "{} of {} inputs; --only \"{}\" --repeat {:?}",
        report.found,
        report.inputs,
        target.name,
        first.map(|finding| (finding.seed, &finding.broken))
    );
}

#[test]
fn no_input_of_the_kernel_breaks_a_property() {
    for target in &KERNEL {
        let inputs = match target.name {
            "sliders" => MOTIONS,
            _ => INPUTS,
        };
        assert_nothing_is_found(target, inputs);
    }
}

#[test]
fn no_file_makes_a_reader_panic() {
    for target in &READERS {
        assert_nothing_is_found(target, INPUTS);
    }
}
