//! Prints `index digest` of every subject, or with an argument the lines of `digests.txt`.

use tribos_subjects::SUBJECTS;

fn main() {
    let are_pins = std::env::args().len() > 1;
    for (index, subject) in SUBJECTS.iter().enumerate() {
        let digest = subject.digest();
        if are_pins {
            println!("{} {digest:#018x}", subject.name);
        } else {
            println!("{index} {digest:016x}");
        }
    }
}
