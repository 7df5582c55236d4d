//! No file makes a reader panic: 20,000 seeded ones a reader.

use tribos_subjects::RUN;
use tribos_tests::fuzz::{READERS, run};

const FILES: u64 = 20_000;

#[test]
fn no_file_makes_a_reader_panic() {
    for target in &READERS {
        let report = run(target, RUN, 0..FILES);
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
}
