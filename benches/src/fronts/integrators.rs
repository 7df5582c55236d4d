//! A stop of a sliding, spinning disk: error against step and cost, and the order.
//!
//! The reference is `to_rest`, which an independent integration confirms to 1e-13
//! (tests/tables/stops.csv).

use super::{Finding, Front, Setting};
use crate::power_law::exponent;
use crate::stepping::{DISK, SPEED, SPINS, Stepper, Stop};
use crate::timing::{self, Task};
use crate::written::{self, Sheet, short};
use std::hint::black_box;
use std::path::Path;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_report::figure::{Axis, Figure, Legend, Panels, Series};

/// Rounds of all methods, and of a quick look.
const ROUNDS: usize = 31;
const QUICK_ROUNDS: usize = 3;
/// Steps in s, from coarse to fine; fewer where a method is exact, or wrong by its model.
const STEPS: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];
const VERLET_STEPS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
const FEW_STEPS: [f64; 3] = [1e-2, 1e-3, 1e-4];
/// The step at which methods are compared.
const COMPARED: f64 = 1e-3;
/// Below the first error rounding hides the effect of the step; errors below the second are drawn at it.
const ROUNDING: f64 = 1e-12;
const LEAST: f64 = 1e-16;
/// Launch speeds over [`SPEED`] for the orders: the instant of rest within the last step is random.
const LAUNCHES: [f64; 5] = [0.9, 0.947, 1.0, 1.031, 1.083];
const PICTURE: &str = "integrators.svg";
/// Distance over spin, by the methods that a game could use.
const TRAVEL: &str = "travel.svg";
/// Spins of its curves, rad/s.
const TRAVEL_SPINS: (f64, usize) = (50.0, 100);
/// Size of a panel in pixels.
const PANEL: (u32, u32) = (640, 460);

type Disk = Slider<f64, CoulombDisk>;

/// Relative errors of time and distance.
type Misses = [f64; 2];

/// One stop by one stepper.
#[derive(Debug)]
struct Row {
    stepper: Stepper,
    spin: f64,
    microseconds: f64,
    errors: Misses,
}

/// Makes the front.
pub fn run(setting: &Setting<'_>) -> Result<Finding, String> {
    let slider = Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: DISK.deceleration,
            radius: DISK.radius,
            inertia_ratio: DISK.inertia_ratio,
        },
    )
    .map_err(|error| error.to_string())?;
    let rounds = if setting.quick { QUICK_ROUNDS } else { ROUNDS };
    let rows = measure(&slider, rounds);
    let orders: Vec<[f64; 2]> = families().iter().map(|f| orders(&slider, f)).collect();
    let stops = stops(&rows, rounds);
    let body = format!(
        "![Error against step and time]({PICTURE})\n\n{}\n{LEGEND}\n{}",
        compared(&rows, &orders).markdown(),
        stops.markdown()
    );
    setting.table("integrators", &stops)?;
    setting.page(Front::Integrators, &body)?;
    draw(setting.out, &rows)?;
    written::write(setting.out, TRAVEL, &travel(&slider)?)?;
    Ok(Finding {
        line: line(&rows, &orders),
        picture: PICTURE,
    })
}

/// Description of the methods and their timing.
const LEGEND: &str = "\
`to_rest` and `advance` are exact but for rounding; `verlet` and the `implicit step` \
(`PlanarBody::step` on the disk's limit surface) are the kernel's steps of second order. `explicit \
Euler` takes the exact friction of the speeds before the step and stops each speed at zero, as games \
do; `decoupled clamps` give sliding and spinning a full budget each; `ellipsoid` is the friction of \
greatest dissipation on an ellipsoid. The last two follow a law of their own: no step makes them \
right. `advance` tells when in its last step rest came, and so does the gauge of the friction that ends \
the last implicit step; all others count whole steps, which makes their time of first order at best. \
The distance of implicit steps is by the trapezoid rule.

Orders are exponents of the step, by least squares of logarithms, of the root mean square error over \
15 launches (three spins, five speeds); - where errors are rounding. In the lower table they compare a \
row with the next coarser step of the same launch, which depends on where in its last step rest comes.
";

/// The steps of every method.
fn families() -> Vec<Vec<Stepper>> {
    vec![
        vec![Stepper::ToRest],
        FEW_STEPS.map(Stepper::Advance).into(),
        VERLET_STEPS.map(Stepper::Verlet).into(),
        STEPS.map(Stepper::Implicit).into(),
        STEPS.map(Stepper::Explicit).into(),
        FEW_STEPS.map(Stepper::Decoupled).into(),
        FEW_STEPS.map(Stepper::Ellipsoid).into(),
    ]
}

/// All steppers at all spins: times, and errors against `to_rest`.
fn measure(slider: &Disk, rounds: usize) -> Vec<Row> {
    let cases: Vec<(Stepper, f64)> = SPINS
        .iter()
        .flat_map(|&spin| families().concat().into_iter().map(move |s| (s, spin)))
        .collect();
    let task = |&(stepper, spin): &(Stepper, f64)| {
        let launch = SliderState::launched(SPEED, spin);
        Task::new(stepper.name(), 1, move || {
            black_box(stepper.stop(black_box(slider), black_box(&launch)));
        })
    };
    let medians = timing::interleaved(cases.iter().map(task).collect(), rounds).medians();
    let row = |(&(stepper, spin), seconds): (&(Stepper, f64), f64)| Row {
        stepper,
        spin,
        microseconds: 1e6 * seconds,
        errors: errors(slider, stepper, SPEED, spin),
    };
    cases.iter().zip(medians).map(row).collect()
}

/// Errors of one stop.
fn errors(slider: &Disk, stepper: Stepper, speed: f64, spin: f64) -> Misses {
    let launch = SliderState::launched(speed, spin);
    let Stop { time, distance } = stepper.stop(slider, &launch);
    let exact = Stepper::ToRest.stop(slider, &launch);
    [time / exact.time - 1.0, distance / exact.distance - 1.0]
}

/// Exponents of the step in the errors of time and distance, over many launches.
fn orders(slider: &Disk, family: &[Stepper]) -> [f64; 2] {
    let launches: Vec<[f64; 2]> = SPINS
        .iter()
        .flat_map(|&spin| LAUNCHES.map(|speed| [speed * SPEED, spin]))
        .collect();
    let typical = |stepper: &Stepper| {
        let of_launch = |&[speed, spin]: &[f64; 2]| errors(slider, *stepper, speed, spin);
        let all: Vec<Misses> = launches.iter().map(of_launch).collect();
        [0, 1].map(|i| (all.iter().map(|e| e[i] * e[i]).sum::<f64>() / all.len() as f64).sqrt())
    };
    let typical: Vec<[f64; 2]> = family.iter().map(typical).collect();
    [0, 1].map(|i| {
        let steps = family.iter().filter_map(|stepper| stepper.step());
        let points = steps.zip(&typical).map(|(dt, errors)| [dt, errors[i]]);
        exponent(points.filter(|&[_, error]| error > ROUNDING))
    })
}

/// A figure of an order, - for none.
fn told(order: f64) -> String {
    if order.is_finite() {
        // No minus before a zero.
        format!("{:.2}", order + 0.0).replace("-0.00", "0.00")
    } else {
        "-".into()
    }
}

/// Methods at one step and the middle spin, with their orders.
fn compared(rows: &[Row], orders: &[[f64; 2]]) -> Sheet {
    let families = families().into_iter().zip(orders);
    let known =
        families.filter_map(|(family, order)| Some((compared_row(rows, family[0].name())?, order)));
    Sheet::of(
        format!(
            "Methods: order, and one stop from {SPEED} m/s and {} rad/s in steps of {COMPARED:e} s",
            SPINS[1]
        ),
        known,
        &[
            ("method", &|(row, _)| row.stepper.name().into()),
            ("order of time", &|(_, order)| told(order[0])),
            ("order of distance", &|(_, order)| told(order[1])),
            ("time error", &|(row, _)| short(row.errors[0])),
            ("distance error", &|(row, _)| short(row.errors[1])),
            ("us per stop", &|(row, _)| short(row.microseconds)),
        ],
    )
}

/// The row of a method at the step and spin of comparison.
fn compared_row<'a>(rows: &'a [Row], name: &str) -> Option<&'a Row> {
    rows.iter().find(|row| {
        let step = row.stepper.step().unwrap_or(COMPARED);
        row.stepper.name() == name && row.spin == SPINS[1] && step == COMPARED
    })
}

/// Every stop.
fn stops(rows: &[Row], rounds: usize) -> Sheet {
    let order = |index: usize, i: usize| {
        let row = &rows[index];
        let coarser = index.checked_sub(1).map(|before| &rows[before]);
        let coarser = coarser.filter(|coarser| coarser.stepper.name() == row.stepper.name());
        let known = coarser.filter(|_| row.errors[i].abs() > ROUNDING);
        let point = |row: &Row| Some([row.stepper.step()?, row.errors[i].abs()]);
        told(exponent(known.into_iter().chain([row]).filter_map(point)))
    };
    let step = |row: &Row| {
        row.stepper
            .step()
            .map_or("-".into(), |dt| format!("{dt:e}"))
    };
    Sheet::of(
        format!(
            "Stop of a disk (R = 0.08 m, mu = 0.3, C = 1/2, 1 m/s) against to_rest: median of \
             {rounds} interleaved rounds, relative errors"
        ),
        rows.iter().enumerate(),
        &[
            ("method", &|(_, row)| row.stepper.name().into()),
            ("dt s", &|(_, row)| step(row)),
            ("spin rad/s", &|(_, row)| row.spin.to_string()),
            ("us per stop", &|(_, row)| short(row.microseconds)),
            ("time error", &|(_, row)| short(row.errors[0])),
            ("distance error", &|(_, row)| short(row.errors[1])),
            ("order of time", &|(index, _)| order(*index, 0)),
            ("order of distance", &|(index, _)| order(*index, 1)),
        ],
    )
}

/// Errors of distance and time at the middle spin, against the step and against the cost.
fn draw(out: &Path, rows: &[Row]) -> Result<(), String> {
    let title = format!("A disk brought to rest, {} rad/s", SPINS[1]);
    // The one without steps last, so that the others have the same colours in all panels.
    let mut families = families();
    families.sort_by_key(|family| family[0].step().is_none());
    let mut panels = Panels::new(title, 2).cell(PANEL.0, PANEL.1);
    for (quantity, i) in [("distance", 1), ("time", 0)] {
        for (label, by_step) in [("step [s]", true), ("time per stop [µs]", false)] {
            let error = Axis::log10(format!("relative error of {quantity}"));
            let mut figure = Figure::new(quantity, Axis::log10(label), error).legend(Legend::Below);
            for family in &families {
                let name = family[0].name();
                let of_line = |row: &&Row| row.stepper.name() == name && row.spin == SPINS[1];
                let point = |row: &Row| {
                    let x = if by_step {
                        row.stepper.step()?
                    } else {
                        row.microseconds
                    };
                    Some((x, row.errors[i].abs().max(LEAST)))
                };
                let line: Vec<_> = rows.iter().filter(of_line).filter_map(point).collect();
                if !line.is_empty() {
                    figure = figure.series(Series::line_points(name, line));
                }
            }
            panels = panels.figure(figure);
        }
    }
    let svg = panels.svg().map_err(|error| error.to_string())?;
    written::write(out, PICTURE, &svg)
}

/// The distance that a disk travels, over its spin at launch.
fn travel(slider: &Disk) -> Result<String, String> {
    let methods = [
        ("area integral (Tribos)", Stepper::ToRest),
        ("ellipsoid", Stepper::Ellipsoid(COMPARED)),
        ("independent budgets", Stepper::Decoupled(COMPARED)),
    ];
    let (most, count) = TRAVEL_SPINS;
    let mut figure = Figure::new(
        format!("A disk of 8 cm, friction coefficient 0.3, thrown at {SPEED} m/s"),
        Axis::linear("spin at launch [rad/s]").range(0.0, most),
        Axis::linear("distance to rest [m]"),
    )
    .legend(Legend::Below);
    for (name, stepper) in methods {
        let point = |i: usize| {
            let spin = most * i as f64 / count as f64;
            let launch = SliderState::launched(SPEED, spin);
            (spin, stepper.stop(slider, &launch).distance)
        };
        figure = figure.series(Series::line(name, (0..=count).map(point).collect()));
    }
    figure.svg().map_err(|error| error.to_string())
}

/// Summary of the front.
fn line(rows: &[Row], orders: &[[f64; 2]]) -> String {
    let error = |name| short(compared_row(rows, name).map_or(f64::NAN, |row| row.errors[1].abs()));
    let order = |name| {
        let place = families()
            .iter()
            .position(|family| family[0].name() == name);
        told(place.map_or(f64::NAN, |place| orders[place][1]))
    };
    format!(
        "In steps of 1 ms the distance of a spinning disk errs by {} with `advance`, by {} with the \
         implicit step (order {}), {} with Verlet (order {}), {} with explicit Euler (order {}), {} \
         on an ellipsoid and {} with decoupled clamps, which no smaller step repairs.",
        error("advance"),
        error("implicit step"),
        order("implicit step"),
        error("verlet"),
        order("verlet"),
        error("explicit Euler"),
        order("explicit Euler"),
        error("ellipsoid"),
        error("decoupled clamps"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measured_orders_are_those_of_the_methods() {
        let slider = Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration: DISK.deceleration,
                radius: DISK.radius,
                inertia_ratio: DISK.inertia_ratio,
            },
        );
        let slider = slider.unwrap();
        // Fine enough that the few steps before rest do not matter.
        let steps = [4e-4, 2e-4, 1e-4];
        let of = |stepper: fn(f64) -> Stepper| orders(&slider, &steps.map(stepper))[1];
        let implicit = of(Stepper::Implicit);
        let explicit = of(Stepper::Explicit);
        let clamps = of(Stepper::Decoupled);
        assert!((1.7..2.3).contains(&implicit), "{implicit}");
        assert!((0.8..1.2).contains(&explicit), "{explicit}");
        assert!(clamps.abs() < 0.2, "{clamps}");
    }
}
