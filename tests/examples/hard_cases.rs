//! Prints the hard cases of contact dynamics as docs/tables/hard-cases.csv has them; with the argument `refusals`
//! the inputs that are refused and the messages, with `waves` the waves of relaxation in a row of bodies.

use tribos::cd::IterationOrder;
use tribos_tests::{hard, sound};

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("refusals") => refusals(),
        Some("waves") => waves(),
        _ => cases(),
    }
}

fn cases() {
    println!(
        "case,contacts,tolerance,sweeps_first,sweeps_then,ended_by,residual,overlap_R,quantity,error"
    );
    for case in hard::cases() {
        let ended = match (case.met, case.handed_over) {
            (false, _) => "tolerance missed",
            (true, true) => "handed over",
            (true, false) => "sweeps",
        };
        let [first, then] = case.sweeps;
        println!(
            "{},{},{:.0e},{first:.0},{then:.1},{ended},{:.1e},{:.1e},{},{:.1e}",
            quoted(&case.name),
            case.contacts,
            case.tolerance,
            case.residual,
            case.overlap,
            quoted(case.what),
            case.error
        );
    }
}

/// A field of a CSV file.
fn quoted(field: &str) -> String {
    if field.contains(',') {
        format!("\"{field}\"")
    } else {
        field.to_owned()
    }
}

fn refusals() {
    println!("| input | answer |\n|---|---|");
    for (input, answer) in hard::refusals() {
        let answer = answer.map_or(String::from("none"), |error| error.to_string());
        println!("| {input} | {answer} |");
    }
}

fn waves() {
    println!("| order | period, steps | damping, 1/step |\n|---|---|---|");
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
