//! The pile, followed to rest and held.

use crate::pile::{BALLS, CONTACTS, Pile, SWEEPS, WEIGHT};
use tribos_boards::{BOARD, Checks, Decimal, instructions, println, stack_used};

/// A step, s.
const DT: f32 = 4e-3;
/// Steps to settle in, and steps to be held for.
const SETTLING: u32 = 250;
const HELD: u32 = 250;
/// Instructions that a step may take with an FPU, half of 4 ms at 168 MHz. Without an FPU the loop would
/// be slower, and there is no guarantee.
const BUDGET: u64 = 336_000;
/// Speed that counts as rest, m/s: 60 µm in a minute.
const SLOW: f32 = 1e-6;
/// Tolerance of the carried load, as a fraction of the weight.
const EQUAL: f32 = 1e-3;

/// Results of the steps of a phase.
#[derive(Default)]
struct Phase {
    steps: u32,
    sweeps: u32,
    most_sweeps: u32,
    unconverged: u32,
    instructions: u64,
    worst: u64,
    /// Of the last step.
    residual: f32,
    /// Fastest ball, m/s.
    fastest: f32,
}

/// Runs and reports everything; `None` if a parameter is refused.
pub fn print() -> Option<()> {
    println!(
        "stack: {BALLS} balls, {CONTACTS} contacts, at {} Hz, at most {SWEEPS} sweeps, f32, on {BOARD}",
        Decimal::<0>(1.0 / DT)
    );
    println!();
    let mut pile = Pile::new(DT)?;
    let settling = follow(&mut pile, SETTLING)?;
    tell("settling", &settling);
    let held = follow(&mut pile, HELD)?;
    tell("held", &held);
    let mut last = None;
    let depth = stack_used(&mut || last = pile.advance());
    last?;
    let carried = pile.carried()?;
    println!();
    println!(
        "floor and fingers carry {} N, the weight is {} N",
        Decimal::<5>(carried),
        Decimal::<5>(WEIGHT)
    );
    println!("memory {} B, stack of a step {depth} B", size_of::<Pile>());
    println!();
    let mut checks = Checks::default();
    checks.check("all contacts are closed", pile.closed() == CONTACTS);
    checks.check(
        "the contacts carry the weight to a thousandth",
        (carried / WEIGHT - 1.0).abs() < EQUAL,
    );
    checks.check(
        "every step of the held pile converged",
        held.unconverged == 0,
    );
    checks.check("the held pile is slower than 1 um/s", held.fastest < SLOW);
    let worst = settling.worst.max(held.worst);
    if cfg!(target_abi = "eabihf") {
        println!("budget of a step {BUDGET} instructions");
        checks.check("the worst step is within the budget", worst <= BUDGET);
    }
    checks.finish();
    Some(())
}

fn follow(pile: &mut Pile, steps: u32) -> Option<Phase> {
    let mut phase = Phase::default();
    for _ in 0..steps {
        let mut report = None;
        let count = instructions(&mut || report = pile.advance());
        let report = report?;
        // Without -icount there is no count, and the budget fails.
        let count = count.unwrap_or(u64::from(u32::MAX));
        phase.steps += 1;
        phase.sweeps += report.iterations;
        phase.most_sweeps = phase.most_sweeps.max(report.iterations);
        phase.unconverged += u32::from(!report.converged);
        phase.instructions += count;
        phase.worst = phase.worst.max(count);
        phase.residual = report.residual;
        // NaN is kept, because it is not slower than anything.
        let speed = pile.speed()?;
        let is_slower = speed <= phase.fastest;
        phase.fastest = if is_slower { phase.fastest } else { speed };
    }
    Some(phase)
}

fn tell(name: &str, phase: &Phase) {
    let steps = phase.steps;
    let mean = phase.instructions.checked_div(u64::from(steps));
    println!("{name}, {steps} steps");
    println!(
        "  sweeps: mean {}, most {}; {} steps ended before they converged",
        Decimal::<1>(phase.sweeps as f32 / steps as f32),
        phase.most_sweeps,
        phase.unconverged
    );
    println!(
        "  residual of the last step {} per million, fastest ball {} mm/s",
        Decimal::<2>(phase.residual * 1e6),
        Decimal::<6>(phase.fastest * 1e3)
    );
    println!(
        "  instructions a step: mean {}, worst {}",
        mean.unwrap_or(0),
        phase.worst
    );
}
