//! Error of a stop against its cost: the kernel's steppers and two methods of engines.
//!
//! `cargo run --release -p tribos-benches --bin slider_front -- [--out DIR] [--quick]` writes
//! `slider_front.csv` and `slider_front.md` to DIR (default: docs/front). The reference is
//! `to_rest`, which an independent integration confirms to 1e-13 (tests/tables/stops.csv).

use std::hint::black_box;
use std::path::Path;
use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::picture::{self, Place};
use tribos_benches::stepping::{DISK, SPEED, SPINS, Stepper, Stop};
use tribos_benches::timing::{self, Task};
use tribos_benches::written::{self, Sheet, short};
use tribos_core::coupling::table::Coulomb;
use tribos_core::slider::{Motion, Slider};

/// Rounds of all methods, and of a quick look.
/// Errors below rounding are shown at it.
const ROUNDING: f64 = 1e-16;
const ROUNDS: usize = 31;
const QUICK_ROUNDS: usize = 3;
/// Steps in s.
const ADVANCE_STEPS: [f64; 3] = [1e-2, 1e-3, 1e-4];
const VERLET_STEPS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
const ENGINE_STEP: f64 = 1e-3;

/// One stop by one stepper.
#[derive(Debug)]
struct Row {
    stepper: Stepper,
    spin: f64,
    microseconds: f64,
    time_error: f64,
    distance_error: f64,
}

fn main() -> ExitCode {
    match Options::read(std::env::args().skip(1)).and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("slider_front: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let slider = Slider::new(Coulomb, DISK.deceleration, DISK.radius, DISK.inertia_ratio)
        .map_err(|error| error.to_string())?;
    let cases: Vec<(Stepper, f64)> = SPINS
        .iter()
        .flat_map(|&spin| steppers().into_iter().map(move |stepper| (stepper, spin)))
        .collect();
    let rounds = if options.quick { QUICK_ROUNDS } else { ROUNDS };
    let tasks = cases
        .iter()
        .map(|&(stepper, spin)| task(&slider, stepper, spin))
        .collect();
    let medians = timing::interleaved(tasks, rounds).medians();

    let timed = cases.iter().zip(medians);
    let rows: Vec<Row> = timed
        .map(|(&(stepper, spin), seconds)| row(&slider, stepper, spin, seconds))
        .collect();
    let sheet = sheet(&rows, rounds);
    written::write(&options.out, "slider_front.csv", &sheet.csv())?;
    written::write(&options.out, "slider_front.md", &sheet.markdown())?;
    draw(&options.out, &rows)?;
    print!("{}", sheet.markdown());
    Ok(())
}

/// Work against the error of the distance at the middle spin.
fn draw(out: &Path, rows: &[Row]) -> Result<(), String> {
    let places = rows
        .iter()
        .filter(|row| row.spin == SPINS[1])
        .map(|row| Place {
            label: match row.stepper.step() {
                Some(step) => format!("{} {step:e} s", row.stepper.name()),
                None => row.stepper.name().into(),
            },
            group: row.stepper.name().into(),
            at: (row.microseconds, row.distance_error.abs().max(ROUNDING)),
        });
    let axes = ["time per stop [µs]", "relative error of the distance"];
    let title = format!("A disk brought to rest, spin {} rad/s", SPINS[1]);
    picture::scatter(out, "slider_front", &title, axes, places.collect())
}

/// All steppers with all their steps.
fn steppers() -> Vec<Stepper> {
    let mut all = vec![Stepper::ToRest];
    all.extend(ADVANCE_STEPS.map(Stepper::Advance));
    all.extend(VERLET_STEPS.map(Stepper::Verlet));
    all.extend([
        Stepper::Decoupled(ENGINE_STEP),
        Stepper::Ellipsoid(ENGINE_STEP),
    ]);
    all
}

fn task(slider: &Slider<f64, Coulomb>, stepper: Stepper, spin: f64) -> Task<'_> {
    let launch = Motion::launched(SPEED, spin);
    Task::new(stepper.name(), 1, move || {
        black_box(stepper.stop(black_box(slider), black_box(&launch)));
    })
}

/// Relative errors against `to_rest`.
fn row(slider: &Slider<f64, Coulomb>, stepper: Stepper, spin: f64, seconds: f64) -> Row {
    let launch = Motion::launched(SPEED, spin);
    let Stop { time, distance } = stepper.stop(slider, &launch);
    let exact = Stepper::ToRest.stop(slider, &launch);
    Row {
        stepper,
        spin,
        microseconds: 1e6 * seconds,
        time_error: time / exact.time - 1.0,
        distance_error: distance / exact.distance - 1.0,
    }
}

fn sheet(rows: &[Row], rounds: usize) -> Sheet {
    let cells = |row: &Row| {
        vec![
            row.stepper.name().into(),
            row.stepper
                .step()
                .map_or("-".into(), |dt| format!("{dt:e}")),
            row.spin.to_string(),
            short(row.microseconds),
            short(row.time_error),
            short(row.distance_error),
        ]
    };
    Sheet {
        about: format!(
            "Stop of a disk (R = 0.08 m, mu = 0.3, C = 1/2, 1 m/s) against to_rest: median of \
             {rounds} interleaved rounds, relative errors; by `cargo run --release -p \
             tribos-benches --bin slider_front`"
        ),
        header: vec![
            "method",
            "dt s",
            "spin rad/s",
            "us per stop",
            "time error",
            "distance error",
        ],
        rows: rows.iter().map(cells).collect(),
    }
}
