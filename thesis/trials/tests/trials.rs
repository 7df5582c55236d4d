//! Each method comes as close to the known answers as its parameters promise.

use anyhow::Result;
use tribos_trials::{Ball, Column, Cooling, Method, Slope, run};

#[test]
fn a_column_presses_on_the_floor_with_its_weight() -> Result<()> {
    let column = Column {
        spheres: 5,
        top: 3.0,
        time: 10.0,
    };
    let rigid = run(&column, Method::rigid(1e-9, 0.1))?;
    assert!(
        rigid.errors[0] < 1e-7 && rigid.errors[1] < 1e-6,
        "{rigid:?}"
    );
    let soft = run(&column, Method::soft(1e4))?;
    // The lowest contact carries all the weight.
    assert!(soft.errors[0] < 1e-3, "{soft:?}");
    assert!((soft.errors[1] / 1e-4 - 1.0).abs() < 1e-3, "{soft:?}");
    Ok(())
}

#[test]
fn a_sliding_ball_ends_rolling_at_five_sevenths_of_its_speed() -> Result<()> {
    for mu in [0.1, 0.4] {
        let ball = Ball { mu, speed: 2.0 };
        let rigid = run(&ball, Method::rigid(1e-9, 0.01))?;
        assert!(
            rigid.errors[0] < 1e-12 && rigid.errors[1] < 0.05,
            "{rigid:?}"
        );
        let finer = run(&ball, Method::rigid(1e-9, 0.001))?;
        assert!(finer.errors[1] < 0.2 * rigid.errors[1], "{finer:?}");
        let soft = run(&ball, Method::soft(1e4))?;
        assert!(soft.errors.iter().all(|error| *error < 1e-2), "{soft:?}");
    }
    Ok(())
}

#[test]
fn spheres_on_a_slope_stand_below_their_thresholds_and_move_above() -> Result<()> {
    let slope = Slope {
        mu: 0.5,
        mu_rolling: 0.2,
        slope: 0.1,
        time: 20.0,
    };
    for method in [Method::rigid(1e-9, 0.1), Method::soft(1e4)] {
        let held = run(&slope, method)?;
        assert!(held.errors[0] < 1e-6, "{method}: {held:?}");
        let steep = Slope {
            slope: 0.6,
            time: 3.0,
            ..slope
        };
        let moved = run(&steep, method)?;
        assert!(moved.errors[0] > 0.01, "{method}: {moved:?}");
    }
    Ok(())
}

#[test]
fn events_know_no_lasting_contacts() {
    let ball = Ball {
        mu: 0.1,
        speed: 1.0,
    };
    assert!(run(&ball, Method::Events).is_err());
}

#[test]
fn every_method_cools_a_gas_alike() -> Result<()> {
    let gas = Cooling {
        count: 300,
        fraction: 0.05,
        restitution: 0.9,
        collisions: 4.0,
        seeds: [1, 4],
        reference: 1.0,
    };
    let gas = gas.referred([11, 8])?;
    for method in [Method::Events, Method::rigid(1e-4, 0.05), Method::soft(1e4)] {
        let found = run(&gas, method)?;
        // One start scatters by 0.7 %.
        assert!(found.errors[0] < 0.02, "{method}: {found:?}");
        assert!(found.updates > 600.0);
    }
    Ok(())
}
