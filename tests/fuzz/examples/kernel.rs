//! Takes one input of every target of the kernel: the program whose symbols tell what is fuzzed.

use tribos_fuzz::{KERNEL, take};

fn main() {
    for target in KERNEL {
        println!("{}: {:?}", target.name, take(&target, 1));
    }
}
