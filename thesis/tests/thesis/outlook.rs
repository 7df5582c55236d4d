//! The map of section 5.2: its table and its statistics.

use tribos::scene::FrictionCoupling;
use tribos_thesis::exhibits::outlook::map::{Estimate, Map};
use tribos_thesis::exhibits::outlook::table::{
    CORNERS, CompactionParameters, Line, PRESSURES, SPREADS, kept, parse,
};

fn line(seed: u64, corner: [f64; 2], coupling: FrictionCoupling, porosity: f64) -> Line {
    Line {
        made: CompactionParameters {
            seed,
            spread: 0.0,
            pressure: 0.01,
            corner,
            coupling,
        },
        blocked: true,
        porosity,
        contacts: 1.0,
        steps: 1.0,
        unmet: 0.0,
        sweeps: 2.0 * porosity,
        pull: 0.0,
        seconds: 1.0,
    }
}

const CELL: (f64, f64) = (0.0, 0.01);

#[test]
fn sums_are_taken_deposit_by_deposit_and_leave_out_what_is_not_complete() {
    let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    let mut lines = Vec::new();
    // Deposits differ by 0.1, their excess does not.
    for (seed, base) in [(1, 0.4), (2, 0.5)] {
        for (corner, more) in corners.into_iter().zip([0.0, 0.1, 0.2, 0.28]) {
            lines.push(line(
                seed,
                corner,
                FrictionCoupling::Independent,
                base + more,
            ));
        }
    }
    lines.push(line(3, [0.0, 0.0], FrictionCoupling::Independent, 0.9));
    lines.push(line(2, [0.0, 1.0], FrictionCoupling::Exact, 0.3));
    let map = Map::new(lines);
    let excess = map.excess(CELL, FrictionCoupling::Independent);
    assert_eq!(excess.values.len(), 2);
    assert!((excess.mean() + 0.02).abs() < 1e-15 && excess.error() < 1e-15);
    assert!(excess.differs_from_zero());
    let coupled = map.coupled(CELL, [0.0, 1.0], FrictionCoupling::Exact);
    assert_eq!(coupled.values.len(), 1);
    assert!((coupled.mean() + 0.3).abs() < 1e-15 && coupled.error().is_nan());
    assert!(!coupled.differs_from_zero());
    assert!((map.cost(FrictionCoupling::Exact, |line| line.sweeps) - 0.5).abs() < 1e-15);
}

#[test]
fn intervals_are_students() {
    // numpy: mean 0.3, standard error 0.1; scipy.stats.t.ppf(0.975, 2) = 4.302653.
    let three = Estimate {
        values: vec![0.3 - 0.1 * 3f64.sqrt(), 0.3, 0.3 + 0.1 * 3f64.sqrt()],
    };
    assert!((three.error() - 0.1).abs() < 1e-15);
    assert!((three.half_width() - 0.4303).abs() < 1e-12);
    assert!(!three.differs_from_zero());
}

#[test]
fn every_kept_run_is_one_of_the_map_and_there_once() -> anyhow::Result<()> {
    let lines = kept()?;
    for (at, line) in lines.iter().enumerate() {
        let CompactionParameters {
            spread,
            pressure,
            corner,
            coupling,
            ..
        } = line.made;
        assert!(
            SPREADS.contains(&spread) && PRESSURES.contains(&pressure),
            "{:?}",
            line.made
        );
        assert!(CORNERS.contains(&corner) && (0.0..1.0).contains(&line.porosity));
        assert!(corner[1] > 0.0 || coupling == FrictionCoupling::Independent);
        assert!(
            lines[..at].iter().all(|other| other.made != line.made),
            "{:?}",
            line.made
        );
    }
    Ok(())
}

#[test]
fn a_full_map_has_eight_runs_a_cell_and_seed() {
    assert_eq!(CompactionParameters::all().len(), 5 * 24 * 8);
}

#[test]
fn a_table_without_a_column_is_refused() {
    assert!(parse("seed,pressure\n1,0.01\n").is_err());
    assert!(parse("# only a comment\n").is_err());
}
