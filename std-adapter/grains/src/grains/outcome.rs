//! Summary of a run of grains.

use super::measure::{COLUMNS, GrainsLine};
use crate::packing::{ContactStatistics, Dissipation, PackingEnergy, PackingStopReason};
use tribos_base::results::{Reporting::*, summary};
use tribos_base::statistics::{Averages, TimeAverage, mean_and_error};

summary! {
    /// Results of a run of grains, in the units of its scene. The parts of `end`, `statistics`, `dissipation` and
    /// `energy` are listed with their meanings in docs/results.md.
    ///
    /// [`GrainsScene`](crate::grains::scene::GrainsScene) has an example.
    pub struct GrainsSummary;

    /// Why the run ended; none if it has not.
    ending: Option<PackingStopReason>, "-";
    /// Number of grains that move freely.
    grains: usize, "-";
    /// Mass of these grains.
    mass: f64, "kg";
    /// Time at the end.
    time: f64, "s", Swept;
    /// Number of steps taken.
    steps: u64, "-", Swept;
    /// Total number of sweeps.
    iterations_total: u64, "-", Swept;
    /// Steps in which any tolerance or rule was not met.
    steps_unmet: u64, "-";
    /// Steps that sweeps handed over to a solver with factorisations; left out where there are none.
    steps_handed_over: Option<u64> = optional, "-";
    /// Number of contacts between grains at the end.
    contacts: usize, "-";
    /// The last line of the series.
    end: GrainsLine = flat, "-";
    /// Slopes of the lower and the upper half of the free surface along x: a heap has one of each sign, and its
    /// `surface_angle` says nothing. Left out without a free surface.
    surface_angles: Option<[f64; 2]> = optional, "deg";
    /// Standard error of `surface_angle`, from the scatter of the surface about its slope. Left out without a free surface.
    surface_angle_error: Option<f64> = optional, "deg";
    /// Flow out of a hopper between its first and last tenth. Left out without a hopper.
    flow: Option<HopperFlow> = optional, "-";
    /// Means over time of all columns of the series. A sweep reports these, and what they leave out from the end.
    averages: Averages, "-";
    /// Deepest overlap in all steps.
    max_overlap: f64, "m";
    /// Numbers and forces of the contacts at the end.
    statistics: ContactStatistics, "-";
    /// Energy that the contacts took.
    dissipation: Dissipation, "-";
    /// Energy balance.
    energy: PackingEnergy, "-";
    /// Wall-clock time.
    wall_seconds: f64, "s";
}

/// Means over time of a series of grains. The stress ratio is that of the mean stresses, and the inertial number that
/// under the mean stress: rigid grains bear theirs in impacts, and many lines have none.
pub fn averages(rows: &[[f64; COLUMNS.len()]], from: Option<f64>) -> Averages {
    let column = |of: fn(&GrainsLine) -> f64| {
        let lines = rows.iter().map(|row| GrainsLine::from(*row));
        lines.map(|line| of(&line)).collect::<Vec<f64>>()
    };
    let mut all = Averages::of(COLUMNS, rows, from);
    let ratios = column(|line| line.stress_ratio);
    if ratios.iter().all(|ratio| *ratio == 0.0) {
        return all;
    }
    // Under a plate the stress is that on the plate.
    let plate = column(|line| line.plate_stress);
    let (name, normal) = if plate.iter().any(|stress| *stress != 0.0) {
        ("plate_stress", plate)
    } else {
        ("stress_zz", column(|line| line.stress_zz))
    };
    let times = column(|line| line.time);
    let ratio = TimeAverage::weighted(&times, &ratios, &normal, from);
    all.set("stress_ratio", ratio);
    let lines = rows.iter().map(|row| GrainsLine::from(*row)).zip(&normal);
    // d √ρ of any line that has a number.
    let scale =
        lines.map(|(line, stress)| line.inertial_number * stress.sqrt() / line.shear_rate.abs());
    let scale = scale.fold(f64::NAN, f64::max);
    if let (Some(rate), Some(stress)) = (all.get("shear_rate"), all.get(name)) {
        let number = rate.mean.abs() * scale / stress.mean.sqrt();
        let number = TimeAverage {
            mean: number,
            error: number * 0.5 * stress.error / stress.mean,
            settled: stress.settled && rate.settled,
            ..*stress
        };
        all.set("inertial_number", number);
    }
    all
}

summary! {
    /// Flow out of a hopper, while between a tenth and nine tenths of what flowed out in all have done so.
    #[derive(Copy)]
    pub struct HopperFlow = part;

    /// Mass that flows out per time.
    rate: f64, "kg/s", ShownAs("flow_rate", "flow rate");
    /// Its standard error, from the scatter of the rates of eight parts of the time.
    error: f64, "kg/s";
    /// Time from which on it is taken.
    from: f64, "s";
    /// Time until which it is.
    until: f64, "s";
    /// Time of the last line in which anything flowed out.
    last: f64, "s";
    /// Mass that has not flowed out at the end: what clogs, or lies in dead zones.
    left: f64, "kg", ShownAs("flow_left", "left");
}

/// Parts of the time of a flow whose rates tell its error: less than 3 % of the mass each would be single grains.
const PARTS: usize = 8;

impl HopperFlow {
    /// The flow of a series of times and masses below the slot, of a mass in all: 0 where nothing flows, NaN where it flows
    /// too fast for the lines.
    pub(super) fn of(times: &[f64], below: &[f64], mass: f64) -> Self {
        let [first, last] = [below.first(), below.last()].map(|mass| mass.copied().unwrap_or(0.0));
        let share = |tenths: f64| first + tenths / 10.0 * (last - first);
        let begin = below.partition_point(|mass| *mass <= share(1.0));
        let end = below
            .partition_point(|mass| *mass < share(9.0))
            .max(begin + 1);
        // Between the lines that are nearest to the ends of the parts.
        let line = |part: usize| begin + part * (end - 1 - begin) / PARTS;
        let at = |line: usize| [times, below].map(|of| of.get(line).copied().unwrap_or(f64::NAN));
        let rate = |ends: [usize; 2]| {
            let [[from, before], [until, after]] = ends.map(|part| at(line(part)));
            (after - before) / (until - from)
        };
        let rates: Vec<f64> = (0..PARTS).map(|part| rate([part, part + 1])).collect();
        let [from, until] = [0, PARTS].map(|part| at(line(part))[0]);
        let stands = times.len() > 1 && first == last;
        Self {
            rate: if stands { 0.0 } else { rate([0, PARTS]) },
            error: mean_and_error(&rates)[1],
            from,
            until,
            last: at(below.partition_point(|mass| *mass < last))[0],
            left: mass - last,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_steady_flow_has_its_rate_without_its_ends() {
        // 2 kg/s from 1 s to 11 s, slow before and after.
        let times: Vec<f64> = (0..150).map(|i| 0.1 * f64::from(i)).collect();
        let mass = |time: &f64| 0.1 * time.min(1.0) + 2.0 * (time - 1.0).clamp(0.0, 10.0);
        let below: Vec<f64> = times.iter().map(mass).collect();
        let flow = HopperFlow::of(&times, &below, 25.0);
        assert!((flow.last - 11.0).abs() < 1e-12 && (flow.left - 4.9).abs() < 1e-12);
        assert!(
            (flow.rate - 2.0).abs() < 1e-12 && flow.error < 1e-12,
            "{flow:?}"
        );
        assert!(flow.from > 1.9 && flow.until < 10.1, "{flow:?}");
        // What does not flow has the rate 0, without an error; a run without time has none.
        let clogged = HopperFlow::of(&times, &[0.0; 150], 3.0);
        assert!(clogged.rate == 0.0 && clogged.error.is_nan() && clogged.left == 3.0);
        assert!(HopperFlow::of(&[0.0], &[0.0], 3.0).rate.is_nan());
        // Eight parts of 0.99 and 2.97 kg/s in turn, between a tenth and nine tenths of 200 kg: 1.98 ± 0.99/√7 kg/s.
        let mut below = vec![0.0, 20.5];
        for line in 0..80 {
            let rate = if line / 10 % 2 == 0 { 0.99 } else { 2.97 };
            below.push(below[line + 1] + rate);
        }
        below.push(200.0);
        let times: Vec<f64> = (0..below.len()).map(|i| i as f64).collect();
        let flow = HopperFlow::of(&times, &below, 200.0);
        assert_eq!([flow.from, flow.until], [1.0, 81.0]);
        assert!((flow.rate - 1.98).abs() < 1e-12, "{flow:?}");
        assert!(
            (flow.error - 0.99 / 7.0_f64.sqrt()).abs() < 1e-12,
            "{flow:?}"
        );
    }
}
