//! Prints the hashes of `tribos_tests::bits`, to compare a target with `tests/determinism.rs`.

fn main() {
    for (name, hash) in tribos_tests::bits::bits() {
        println!("{name}: {hash:#018x}");
    }
}
