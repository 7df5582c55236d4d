//! Prints the tables of docs/contact-dynamics.md, section "Hard cases".

use tribos::cd::IterationOrder;
use tribos_tests::{hard, sound};

fn main() {
    println!(
        "| case | contacts | tolerance | sweeps: first, then | residual | overlap, R | what | error |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for case in hard::cases() {
        let missed = if case.met { "" } else { ", tolerance missed" };
        let [first, then] = case.sweeps;
        println!(
            "| {} | {} | {:.0e} | {first:.0}, {then:.1}{missed} | {:.1e} | {:.1e} | {} | {:.1e} |",
            case.name,
            case.contacts,
            case.tolerance,
            case.residual,
            case.overlap,
            case.what,
            case.error
        );
    }
    println!("\n| input | answer |\n|---|---|");
    for (input, answer) in hard::refusals() {
        let answer = answer.map_or(String::from("none"), |error| error.to_string());
        println!("| {input} | {answer} |");
    }
    println!("\n| order | period, steps | damping, 1/step |\n|---|---|---|");
    let (period, damping) = sound::expected(sound::random_q());
    println!(
        "| theory, random, q = {:.4} | {period:.2} | {damping:.5} |",
        sound::random_q()
    );
    for (name, order) in [
        ("random, seed 0", IterationOrder::Random { seed: 0 }),
        ("random, seed 1", IterationOrder::Random { seed: 1 }),
        ("as numbered", IterationOrder::Fixed),
        ("alternating", IterationOrder::Alternating),
    ] {
        let (period, damping) = sound::measured(order);
        println!("| {name} | {period:.2} | {damping:.5} |");
    }
}
