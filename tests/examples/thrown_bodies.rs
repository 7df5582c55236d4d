//! Prints engines/manifold/exact.csv: where thrown bodies come to rest, exactly.
//!
//! Coulomb friction under uniform pressure; the tall cylinder leans as its friction demands. The launch is along x
//! at 1 m/s, spin is counterclockwise seen from above, and `left_m` is the displacement to the left of the launch.
//!
//!     cargo run --release -p tribos-tests --example thrown_bodies > engines/manifold/exact.csv

use std::error::Error;
use std::f64::consts::TAU;
use tribos::friction::Flat;
use tribos::slide::planar::{Launch, PlanarSimulation, Plate, Resistance, TallCylinder};
use tribos_core::patch::outline::{Edge, Polygon};

/// Acceleration of gravity, in m/s².
const GRAVITY: f64 = 9.81;
/// Speed of the launch, in m/s.
const SPEED: f64 = 1.0;
/// Spins of the launch, in rad/s.
const SPINS: [f64; 5] = [0.0, 5.0, 12.5, 25.0, 50.0];
/// Radius of puck and cylinder, and of the circle around the triangle, in m.
const RADIUS: f64 = 0.08;
/// Coefficient of the plates: a deceleration of 3 m/s².
const PLATE_MU: f64 = 3.0 / GRAVITY;
/// Coefficients of the puck and of the tall cylinder.
const PUCK_MU: f64 = 0.3;
const TALL_MU: f64 = 0.2;
/// Height of the tall cylinder, in m.
const TALL: f64 = 0.16;

fn main() -> Result<(), Box<dyn Error>> {
    let plates: [(&str, Vec<[f64; 2]>, f64); 4] = [
        ("box", rectangle(0.1, 0.1), PLATE_MU),
        ("plank", rectangle(0.2, 0.05), PLATE_MU),
        ("triangle", regular(3), PLATE_MU),
        ("puck16", regular(16), PUCK_MU),
    ];
    println!("body,spin_rad_s,travel_m,left_m,turn_rad");
    for (name, corners, mu) in plates {
        let edges = vec![Edge::default(); corners.len()];
        let outline = Polygon::with_holes(&[&corners], edges)?;
        let plate = Plate::new(Flat::Polygon(outline), mu, GRAVITY)?;
        throws(name, &plate)?;
    }
    throws("puck", &TallCylinder::solid(PUCK_MU, RADIUS).body(GRAVITY)?)?;
    let tall = TallCylinder {
        height: TALL,
        ..TallCylinder::solid(TALL_MU, RADIUS)
    };
    throws("tall", &tall.body(GRAVITY)?)
}

/// A line of the table for each spin.
fn throws(name: &str, body: &impl Resistance) -> Result<(), Box<dyn Error>> {
    for spin in SPINS {
        let velocity = [SPEED, 0.0];
        let end = PlanarSimulation::new(body, &Launch { velocity, spin }, 1e-4)?.to_end()?;
        let [travel, left] = end.point.position.map(to_tenths_of_micrometres);
        let turn = end.point.angle;
        println!("{name},{spin},{travel:.7},{left:.7},{turn:.6}");
    }
    Ok(())
}

/// A length in m, rounded, without a sign of zero.
fn to_tenths_of_micrometres(length: f64) -> f64 {
    (length * 1e7).round() / 1e7 + 0.0
}

/// Corners of a rectangle of these sides along x and y, in m.
fn rectangle(along: f64, across: f64) -> Vec<[f64; 2]> {
    let (x, y) = (0.5 * along, 0.5 * across);
    vec![[x, y], [-x, y], [-x, -y], [x, -y]]
}

/// Corners of a regular polygon on the circle of [`RADIUS`], the first one ahead.
fn regular(count: u32) -> Vec<[f64; 2]> {
    let at = |corner| TAU * f64::from(corner) / f64::from(count);
    let corner = |angle: f64| [RADIUS * angle.cos(), RADIUS * angle.sin()];
    (0..count).map(|n| corner(at(n))).collect()
}
