//! The limit surface: gauge, motion and projection, checked with points that lie on it.

use super::round::{TABLE_STRIDE, form_bytes, timed};
use super::tables::{self, Source};
use super::{Case, Entry, Label, Refused};
use crate::reference::Wide;
use tribos_core::coupling::{DryReducedFriction, ReducedFriction, coulomb};
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::real::Real;
use tribos_core::twist::Wrench;

/// How far outside the surface the projected points are, in units of the largest force.
const OUTSIDE: f64 = 0.5;

fn wrench<R: Real>(force: R, torque: R) -> Wrench<R> {
    Wrench::new(force, R::ZERO, torque)
}

/// A point of the surface and its outward normal.
#[derive(Clone, Copy)]
struct Point {
    wrench: [f64; 2],
    normal: [f64; 2],
}

impl Point {
    fn new([slide, rim]: [f64; 2], wrench: [f64; 2]) -> Self {
        let length = slide.hypot(rim);
        Self {
            wrench,
            normal: [slide / length, rim / length],
        }
    }

    fn outside(self) -> [f64; 2] {
        [0, 1].map(|i| self.wrench[i] + OUTSIDE * self.normal[i])
    }
}

/// Gauge, motion and projection of one surface; the wrenches stand in the place of the speeds.
fn rows_of<R: Real, C>(
    [patch, file]: [&'static str; 2],
    tier: [&'static str; 3],
    bytes: usize,
    coupling: C,
) -> Result<[Entry; 3], Refused>
where
    C: DryReducedFriction<R> + DryReducedFriction<f64> + Copy + 'static,
{
    let surface = RoundLimitSurface::new(coupling, R::ONE, R::ONE)?;
    let exact = tables::cases(Source::File(file), 0.0);
    let exact: Vec<Point> = exact
        .iter()
        .map(|case| Point::new(case.speeds, case.exact.map(|y| y.high)))
        .collect();
    let point = |speeds: [f64; 2]| {
        let found = ReducedFriction::<f64>::reduced_wrench(&coupling, speeds[0], speeds[1]);
        Point::new(speeds, [found.force, found.torque])
    };
    let points: Vec<Point> = timed(TABLE_STRIDE).into_iter().map(point).collect();
    let [on, off]: [Vec<[f64; 2]>; 2] = [
        points.iter().map(|point| point.wrench).collect(),
        points.iter().map(|point| point.outside()).collect(),
    ];
    let cases = |given: fn(Point) -> [f64; 2], wanted: fn(Point) -> [f64; 2]| -> Vec<Case> {
        let case = |&point: &Point| Case {
            speeds: given(point),
            exact: wanted(point).map(Wide::new),
        };
        exact.iter().map(case).collect()
    };
    let label = |tier| Label {
        patch,
        law: "Coulomb",
        tier,
        judge: "tables",
    };
    let gauges = cases(|point| point.wrench, |_| [1.0, 0.0]);
    let motions = cases(|point| point.wrench, |point| point.normal);
    let projections = cases(Point::outside, |point| point.wrench);
    let [gauge, motion, projection] = tier.map(label);
    Ok([
        Entry::new(gauge, bytes, &gauges, &on, move |force, torque| {
            [surface.gauge(&wrench::<R>(force, torque)), R::ZERO]
        }),
        Entry::new(motion, bytes, &motions, &on, move |force, torque| {
            let twist = surface.twist_normal_to(&wrench::<R>(force, torque));
            [twist.velocity.x, twist.spin]
        }),
        Entry::new(
            projection,
            bytes,
            &projections,
            &off,
            move |force, torque| {
                let carried = surface.project(&wrench::<R>(force, torque)).wrench;
                [carried.force.x, carried.torque]
            },
        ),
    ])
}

const FORM: [&str; 3] = ["form gauge", "form motion", "form projection"];

/// The disk, the ring and Hertz' pressure.
pub fn rows<R: Real>() -> Result<Vec<Entry>, Refused> {
    let bytes = form_bytes::<R>();
    let mut rows = Vec::new();
    let disk = ["disk surface", "uniform"];
    rows.extend(rows_of::<R, _>(disk, FORM, bytes, coulomb::CoulombDisk)?);
    let ring = ["ring surface", "ring"];
    rows.extend(rows_of::<R, _>(ring, FORM, bytes, coulomb::CoulombRing)?);
    let hertz = ["Hertz surface", "hertz"];
    rows.extend(rows_of::<R, _>(hertz, FORM, bytes, coulomb::CoulombHertz)?);
    Ok(rows)
}
