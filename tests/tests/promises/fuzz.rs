//! No input breaks a property: half a million seeded ones of the kernel, among them those of the digests,
//! and 20,000 files a reader.

use tribos_subjects::RUN;
use tribos_tests::fuzz::{READERS, Target, kernel, run};

/// Inputs per unit of a subject's share.
const INPUTS: u64 = 500;
const FILES: u64 = 20_000;

fn assert_nothing_is_found(target: &Target, inputs: u64) {
    let report = run(target, RUN, 0..inputs);
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
    for target in kernel() {
        assert_nothing_is_found(&target, INPUTS * target.share);
    }
}

#[test]
fn no_file_makes_a_reader_panic() {
    for target in &READERS {
        assert_nothing_is_found(target, FILES);
    }
}
