//! Motions to rest under pressures: stops of the table, tiers among each other, closed forms.

use tribos_core::coupling::coulomb::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction, compact};
use tribos_core::modes::TerminalMotion;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_tests::patches::pressure;
use tribos_tests::pucks::relative;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn compact(order: f64, alpha: f64) -> compact::CompactPower<f64> {
    compact::CompactPower::with_pressure(alpha, pressure(order)).expect("in range")
}

fn table(order: f64, alpha: f64) -> RoundTable64 {
    RoundTable64::new(alpha, pressure(order)).expect("in range")
}

fn to_rest<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    profile: P,
    c: f64,
    motion: SliderState<f64>,
) -> [f64; 4] {
    let slider = Slider::new(
        profile,
        SliderParameters {
            deceleration: 1.0,
            radius: 1.0,
            inertia_ratio: c,
        },
    )
    .expect("in range");
    let rest = slider.to_rest(&motion).expect("an exponent below one");
    assert!(rest.motion.is_at_rest());
    [
        rest.motion.time,
        rest.motion.distance,
        rest.motion.angle,
        rest.ratio,
    ]
}

/// Distances of a stop from a row: times and ways relative, the ratio where it is a finite one.
fn see(row: &Row, name: &str, got: [f64; 4], stop: &mut Worst, direction: &mut Worst) {
    let place = || {
        let launched = [row.number("v0"), row.number("w0")];
        format!(
            "{name}, q {}, C {}, {launched:?}",
            row.text("q"),
            row.text("inertia_ratio")
        )
    };
    for (column, got) in ["stop_time", "distance", "angle"].into_iter().zip(got) {
        stop.see(row.reference(column).relative(got), place);
    }
    let wanted = row.reference("final_ratio");
    if wanted.high == 0.0 {
        assert!(
            got[3] < tolerance::STOP_PURE.limit,
            "{}: {}",
            place(),
            got[3]
        );
    } else if wanted.high == f64::INFINITY {
        assert!(
            1.0 / got[3] < tolerance::STOP_PURE.limit,
            "{}: {}",
            place(),
            got[3]
        );
    } else {
        direction.see(wanted.relative(got[3]), place);
    }
}

#[test]
fn stops_are_those_of_the_table() {
    let [mut stop, mut direction] = [
        "stop time, distance, angle under pressures",
        "final ratio under pressures",
    ]
    .map(Worst::of);
    for row in Table::read("ring_stops.csv").rows() {
        let [order, alpha, c] = ["q", "alpha", "inertia_ratio"].map(|column| row.number(column));
        let launched = SliderState::launched(row.number("v0"), row.number("w0"));
        let mut seen = |name: &str, got: [f64; 4]| see(&row, name, got, &mut stop, &mut direction);
        seen("table", to_rest(table(order, alpha), c, launched));
        // A ring that ends at equal speeds stays where the series is slow.
        if order > -1.0 || row.number("final_ratio") != 1.0 {
            seen("compact", to_rest(compact(order, alpha), c, launched));
        }
        match (order, alpha) {
            (-1.0, 0.0) => seen("form", to_rest(CoulombRing, c, launched)),
            (-0.5, 0.0) => seen("form", to_rest(CoulombPunch, c, launched)),
            (0.5, 0.0) => seen("form", to_rest(CoulombHertz, c, launched)),
            _ => {}
        }
    }
    stop.assert_within(&tolerance::STOP);
    direction.assert_within(&tolerance::PRESSURE_STOP_RATIO);
}

#[test]
fn rings_stop_alike_in_every_tier_and_end_at_their_fixed_point() {
    for (v, w) in [(1.0, 0.4), (1.0, 1.0), (0.3, 1.0), (1.0, -4.0)] {
        let launched = SliderState::launched(v, w);
        let one = to_rest(CoulombRing, 0.8, launched);
        for other in [
            to_rest(table(-1.0, 0.0), 0.8, launched),
            to_rest(compact(-1.0, 0.0), 0.8, launched),
        ] {
            for (a, b) in one.iter().zip(other) {
                assert!(
                    relative(*a, b) <= tolerance::STOP.limit,
                    "({v}, {w}): {one:?} {other:?}"
                );
            }
        }
        let modes = TerminalMotion::new(CoulombRing, 0.8_f64).expect("in range");
        let wanted = modes.finite_fixed_point().expect("inside");
        assert!(
            relative(one[3], wanted) <= tolerance::STOP_RATIO.limit,
            "{} {wanted}",
            one[3]
        );
    }
}

#[test]
fn a_dry_ring_with_equal_speeds_stops_in_closed_form() {
    // C = 1: v = w for ever, both decelerate by F(1) = 2/pi.
    let [time, distance, angle, ratio] = to_rest(CoulombRing, 1.0, SliderState::launched(1.0, 1.0));
    let deceleration = core::f64::consts::FRAC_2_PI;
    assert!(
        relative(time, 1.0 / deceleration) <= tolerance::STOP.limit,
        "{time}"
    );
    assert!(
        relative(distance, 0.5 / deceleration) <= tolerance::STOP.limit,
        "{distance}"
    );
    assert!(
        relative(angle, 0.5 / deceleration) <= tolerance::STOP.limit,
        "{angle}"
    );
    assert!(
        relative(ratio, 1.0) <= tolerance::STOP_RATIO.limit,
        "{ratio}"
    );
}

#[test]
fn stops_under_pressures_are_the_same_by_table_and_series() {
    for order in [-1.0, -0.5, 0.5, 1.0] {
        for c in [0.3, 0.6, 0.9] {
            let launched = SliderState::launched(1.0, 1.0);
            let [time, distance, angle, _] = to_rest(table(order, 0.0), c, launched);
            let [again, far, turned, _] = to_rest(compact(order, 0.0), c, launched);
            assert!(relative(time, again) <= tolerance::STOP.limit);
            assert!(relative(distance, far) <= tolerance::STOP.limit);
            assert!(relative(angle, turned) <= tolerance::STOP.limit);
            // Coupling lowers the force: pure sliding would stop at time 1 after a way of 1/2.
            assert!(time > 1.0 && distance > 0.5, "{time} {distance}");
        }
    }
}
