//! What the limits reach, distance against turns.

use std::f64::consts::TAU;
use tribos::slide::inverse::{LaunchLimits, LaunchSolution, Pose, RestMap};
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_report::figure::{Axis, Color, Figure, Legend, ReferenceLine, Region, Series};

/// Points along a curve of launches.
const POINTS: usize = 48;
/// Shares of the limits for which a curve is drawn.
const SHARES: [f64; 3] = [0.25, 0.5, 0.75];

/// Points (turns, distance).
type Curve = Vec<(f64, f64)>;

/// The reach of the limits with curves of equal speed and equal spin, the target's distance and
/// the solutions.
pub fn figure<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    map: &RestMap<P>,
    limits: &LaunchLimits,
    target: &Pose,
    solutions: &[LaunchSolution],
) -> Figure {
    let (speed, spin) = (limits.max_speed(), limits.max_spin());
    let distance = target.x.hypot(target.y);
    let mut figure = Figure::new(
        "Where a launch within the limits comes to rest",
        Axis::linear("turns on the way"),
        Axis::linear("distance in m"),
    )
    .region(Region {
        label: String::new(),
        outline: border(map, speed, spin),
        fill: Color::pale(0),
        label_at: (0.0, 0.0),
    })
    .guide(ReferenceLine::horizontal(distance, "wanted"))
    .legend(Legend::Below);
    for share in SHARES {
        let label = format!("launched at {:.3} m/s", share * speed);
        figure = figure.series(Series::line(label, equal_speed(map, share * speed, spin)));
    }
    for share in SHARES {
        let label = format!("at {:.3} rad/s in either sense", share * spin);
        let one = equal_spin(map, speed, share * spin);
        let other: Curve = one.iter().rev().map(|(turns, d)| (-turns, *d)).collect();
        // Both senses meet nowhere: a gap between them.
        let curve = [one, vec![(f64::NAN, f64::NAN)], other].concat();
        figure = figure.series(Series::dashed(label, curve));
    }
    let marks = solutions.iter().map(|s| (s.turns(), distance)).collect();
    figure.series(Series::points("launches to the target", marks).color(Color(0, 0, 0)))
}

/// Rest of a launch straight ahead.
fn rest<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    map: &RestMap<P>,
    speed: f64,
    spin: f64,
) -> (f64, f64) {
    let [distance, angle] = map.reach(speed, spin);
    ((angle / TAU).copysign(spin), distance)
}

/// From full spin in one sense to full spin in the other.
fn equal_speed<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    map: &RestMap<P>,
    speed: f64,
    spin: f64,
) -> Curve {
    let share = |i| 2.0 * i as f64 / POINTS as f64 - 1.0;
    (0..=POINTS)
        .map(|i| rest(map, speed, share(i) * spin))
        .collect()
}

/// From spin in place to full speed.
fn equal_spin<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    map: &RestMap<P>,
    speed: f64,
    spin: f64,
) -> Curve {
    (0..=POINTS)
        .map(|i| rest(map, i as f64 / POINTS as f64 * speed, spin))
        .collect()
}

/// The image of the limits: in place, up at full spin, across at full speed, down.
fn border<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
    map: &RestMap<P>,
    speed: f64,
    spin: f64,
) -> Curve {
    let side = equal_spin(map, speed, spin);
    let other = side.iter().map(|(turns, d)| (-turns, *d));
    let top = equal_speed(map, speed, spin);
    other.chain(top).chain(side.iter().rev().copied()).collect()
}
