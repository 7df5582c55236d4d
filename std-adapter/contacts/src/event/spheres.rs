//! Hard spheres in a periodic cube, from collision to collision.

use super::body::{Body, DIAMETER_SQ};
use super::cells::Cells;
use super::impact::{Impact, Motion};
use super::queue::{CELL, Event, Queue};
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;
use tribos_base::space::pairs::neighbours;

/// Overlap of spheres that is refused, in R: more than the rounding of a start from elsewhere.
const OVERLAP: f64 = 1e-6;
/// Time stands still if [`BURST`] collisions in a row, of any spheres, take less than this share of the time in
/// which a sphere crosses its radius. By chance it takes 1e-6 of it with 1e6 spheres. In a collapse the
/// intervals shrink until rounding ends them, some ten collisions later.
const STILL: f64 = 1e-12;
const BURST: u64 = 12;

/// Hard spheres of radius 1 and mass 1 in a periodic cube.
///
/// *Domain*: edge ≥ 6 (1 + 1e-9), at least one sphere, no overlap. *Accuracy*: free flight is exact up to rounding;
/// the same start gives the same bits.
///
/// ```
/// use tribos::event::{Advance, HardSpheres, Impact, Motion, Tangential};
/// use tribos::nalgebra::Vector3;
/// let law = Impact::new(1.0, Tangential::Smooth)?;
/// let at = |x| Vector3::new(x, 5.0, 5.0);
/// let moving = |speed| Motion { velocity: Vector3::x() * speed, spin: Vector3::zeros() };
/// let bodies = [(at(2.0), moving(1.0)), (at(6.0), moving(0.0))];
/// let mut gas = HardSpheres::new(10.0, &bodies, law, 0.0)?;
/// assert_eq!(gas.advance(1, f64::INFINITY), Advance::Collisions);
/// assert_eq!((gas.time(), gas.motion(1).velocity.x), (2.0, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct HardSpheres {
    pub(super) length: f64,
    pub(super) law: Impact,
    /// Collisions that follow the last one of a sphere within this time lose no energy.
    pub(super) contact_time: f64,
    pub(super) bodies: Vec<Body>,
    pub(super) cells: Cells,
    pub(super) queue: Queue,
    pub(super) totals: Totals,
}

/// Sums since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Totals {
    pub time: f64,
    pub collisions: u64,
    pub lost: f64,
    /// Sum of normal impulse times distance of the centres.
    pub virial: f64,
    /// Collisions within the contact time.
    pub cured: u64,
    /// Number of collisions, and the time, at which the current watch for a standstill began.
    pub watch: (u64, f64),
    /// Time that is too short for a burst of collisions.
    pub still: f64,
}

/// Why [`HardSpheres::advance`] returned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Advance {
    /// The number of collisions was reached.
    Collisions,
    /// The time was reached.
    Time,
    /// Time stands still while collisions go on: an inelastic collapse.
    Collapse,
    /// Nothing moves towards anything.
    Rest,
}

/// Why spheres are refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EventError {
    /// The cube is too small, or has too many spheres.
    #[error("the edge of the cube must be finite and at least 6 radii and a trifle, not {0}")]
    Length(f64),
    /// The contact time is negative or not finite.
    #[error("the contact time must be finite and >= 0, not {0}")]
    ContactTime(f64),
    /// A number of a sphere is not finite.
    #[error("sphere {0}: its place, velocity and spin must be finite")]
    NotFinite(usize),
    /// There are none, or more than can be numbered.
    #[error("there must be 1 to 100000000 spheres, not {0}")]
    Count(usize),
    /// Two spheres overlap.
    #[error("spheres {0} and {1} overlap")]
    Overlap(u32, u32),
}

/// Most spheres.
const MOST: usize = 100_000_000;

impl HardSpheres {
    /// Spheres at their places with their motions, at time 0, in a cube of this edge.
    pub fn new(
        length: f64,
        bodies: &[(Vector3<f64>, Motion)],
        law: Impact,
        contact_time: f64,
    ) -> Result<Self, EventError> {
        if !(1..=MOST).contains(&bodies.len()) {
            return Err(EventError::Count(bodies.len()));
        }
        if !length.is_finite() || length < Cells::LEAST {
            return Err(EventError::Length(length));
        }
        if !contact_time.is_finite() || contact_time < 0.0 {
            return Err(EventError::ContactTime(contact_time));
        }
        let finite = |vector: &Vector3<f64>| vector.iter().all(|x| x.is_finite());
        let is_good = |(place, motion): &(Vector3<f64>, Motion)| {
            [place, &motion.velocity, &motion.spin]
                .into_iter()
                .all(finite)
        };
        if let Some(bad) = bodies.iter().position(|body| !is_good(body)) {
            return Err(EventError::NotFinite(bad));
        }
        check_overlaps(length, bodies)?;
        let cells = Cells::new(length, bodies.len());
        let bodies = bodies.iter().map(|(place, motion)| {
            let place = place.map(|x| x - length * (x / length).floor());
            Body {
                place,
                motion: *motion,
                time: 0.0,
                last: f64::NEG_INFINITY,
                cell: [0, 1, 2].map(|axis| cells.of(place[axis])),
                count: 0,
            }
        });
        Ok(Self::of(
            length,
            law,
            contact_time,
            bodies.collect(),
            Totals::default(),
        ))
    }

    /// Spheres with their histories, and all their events.
    pub(super) fn of(
        length: f64,
        law: Impact,
        contact_time: f64,
        bodies: Vec<Body>,
        totals: Totals,
    ) -> Self {
        let mut cells = Cells::new(length, bodies.len());
        for (sphere, body) in bodies.iter().enumerate() {
            cells.insert(sphere as u32, body.cell);
        }
        let mut gas = Self {
            length,
            law,
            contact_time,
            queue: Queue::new(bodies.len()),
            bodies,
            cells,
            totals,
        };
        if gas.totals.collisions == 0 {
            gas.totals.still = gas.still();
        }
        for sphere in 0..gas.bodies.len() as u32 {
            gas.predict_crossing(sphere);
            // Each pair once.
            gas.predict_around(sphere, |other| other > sphere);
        }
        gas
    }

    /// Goes on until there have been this many collisions since the start, or until this time.
    pub fn advance(&mut self, collisions: u64, until: f64) -> Advance {
        while self.totals.collisions < collisions {
            let Some(next) = self.queue.first() else {
                return self.advance_all_to(until, Advance::Rest);
            };
            if next.time > until {
                return self.advance_all_to(until, Advance::Time);
            }
            let Some(event) = self.queue.pop() else {
                return Advance::Rest;
            };
            if !self.is_live(&event) {
                continue;
            }
            if event.b == CELL {
                self.cross(event);
            } else if self.collide(event) && self.is_stalled() {
                return Advance::Collapse;
            }
            let bodies = &self.bodies;
            self.queue.sweep(|event| is_live(bodies, event));
        }
        Advance::Collisions
    }

    /// Lets all spheres fly on to a time, if there is one.
    fn advance_all_to(&mut self, until: f64, why: Advance) -> Advance {
        if until.is_finite() && until > self.totals.time {
            self.totals.time = until;
        }
        why
    }

    fn is_live(&self, event: &Event) -> bool {
        is_live(&self.bodies, event)
    }

    /// A sphere goes over into the next cell and looks for partners in the nine cells ahead.
    fn cross(&mut self, event: Event) {
        let sphere = event.a;
        let body = &self.bodies[sphere as usize];
        let from = body.cell;
        let Some((_, axis, direction)) = body.crossing(self.cells.edge) else {
            return;
        };
        let mut to = from;
        to[axis] += direction;
        self.cells.remove(sphere, from);
        self.bodies[sphere as usize].cell = to;
        self.cells.insert(sphere, to);
        self.later(event.time);
        self.predict_crossing(sphere);
        let [u, w] = [(axis + 1) % 3, (axis + 2) % 3];
        for (along_u, along_w) in (-1..=1).flat_map(|u| (-1..=1).map(move |w| (u, w))) {
            let mut cell = to;
            cell[axis] += direction;
            cell[u] += along_u;
            cell[w] += along_w;
            self.predict_in(sphere, cell, |other| other != sphere);
        }
    }

    /// Two spheres collide; false if they only graze by rounding.
    fn collide(&mut self, event: Event) -> bool {
        let pair = [event.a, event.b].map(|sphere| self.bodies[sphere as usize]);
        let [mut a, mut b] = pair;
        let shift = self.shift(&a, &b);
        let time = event.time;
        let apart = b.place_at(time) - a.place_at(time) + shift;
        let distance = apart.norm();
        let normal = apart / distance;
        let approach = (a.motion.velocity - b.motion.velocity).dot(&normal);
        if approach <= 0.0 || approach.is_nan() {
            return false;
        }
        let quick = time - a.last < self.contact_time || time - b.last < self.contact_time;
        let law = if quick { Impact::ELASTIC } else { self.law };
        for body in [&mut a, &mut b] {
            body.place = body.place_at(time);
            (body.time, body.last) = (time, time);
            body.count = body.count.wrapping_add(1);
            self.wrap(body);
        }
        let lost = law.collide(&normal, &mut a.motion, &mut b.motion);
        self.later(time);
        let totals = &mut self.totals;
        totals.collisions += 1;
        totals.lost += lost;
        totals.cured += u64::from(quick);
        totals.virial += 0.5 * (1.0 + law.restitution()) * approach * distance;
        for (sphere, body) in [(event.a, a), (event.b, b)] {
            self.bodies[sphere as usize] = body;
        }
        for sphere in [event.a, event.b] {
            self.predict_crossing(sphere);
            self.predict_around(sphere, |other| other != sphere);
        }
        true
    }

    /// Moves place and cell back into the cube together.
    fn wrap(&self, body: &mut Body) {
        let count = self.cells.count as i32;
        for axis in 0..3 {
            let turns = body.cell[axis].div_euclid(count);
            body.cell[axis] -= turns * count;
            body.place[axis] -= f64::from(turns) * self.length;
        }
    }

    /// The current time never falls; events may lie before it by rounding.
    fn later(&mut self, time: f64) {
        if time > self.totals.time {
            self.totals.time = time;
        }
    }

    /// Whether time has stood still for a burst of collisions.
    fn is_stalled(&mut self) -> bool {
        if self
            .totals
            .collisions
            .is_multiple_of(self.bodies.len() as u64)
        {
            self.totals.still = self.still();
        }
        let Totals {
            time,
            collisions,
            still,
            watch: (from, since),
            ..
        } = self.totals;
        if time - since > still {
            self.totals.watch = (collisions, time);
        }
        collisions - from >= BURST && time - since <= still
    }

    /// The time that is too short for a burst, at the current temperature.
    fn still(&self) -> f64 {
        STILL / self.temperature_translational().sqrt()
    }

    /// The way from `a`'s image beside `b` to `a`: cells say which images are neighbours.
    fn shift(&self, a: &Body, b: &Body) -> Vector3<f64> {
        let count = self.cells.count as i32;
        let turns = |axis: usize| (b.cell[axis] - a.cell[axis] + 1).div_euclid(count);
        Vector3::from([0, 1, 2].map(|axis| -f64::from(turns(axis)) * self.length))
    }

    fn predict_crossing(&mut self, sphere: u32) {
        let body = &self.bodies[sphere as usize];
        if let Some((time, ..)) = body.crossing(self.cells.edge) {
            self.queue.push(Event {
                time,
                a: sphere,
                b: CELL,
                counts: [body.count, 0],
            });
        }
    }

    /// Predicts collisions with spheres in the cells around.
    fn predict_around(&mut self, sphere: u32, is_wanted: impl Fn(u32) -> bool) {
        let [x, y, z] = self.bodies[sphere as usize].cell;
        for dz in -1..=1 {
            for dy in -1..=1 {
                for dx in -1..=1 {
                    self.predict_in(sphere, [x + dx, y + dy, z + dz], &is_wanted);
                }
            }
        }
    }

    /// Predicts collisions with the spheres of a cell.
    fn predict_in(&mut self, sphere: u32, cell: [i32; 3], is_wanted: impl Fn(u32) -> bool) {
        for other in self.cells.spheres(cell) {
            if !is_wanted(other) {
                continue;
            }
            let [a, b] = [sphere.min(other), sphere.max(other)];
            let [one, two] = [a, b].map(|index| &self.bodies[index as usize]);
            if let Some(time) = one.meeting(two, &self.shift(one, two)) {
                self.queue.push(Event {
                    time,
                    a,
                    b,
                    counts: [one.count, two.count],
                });
            }
        }
    }

    /// Current time.
    pub fn time(&self) -> f64 {
        self.totals.time
    }

    /// Number of collisions of pairs since the start.
    pub fn collisions(&self) -> u64 {
        self.totals.collisions
    }

    /// Number of collisions within the contact time.
    pub fn lossless_collisions(&self) -> u64 {
        self.totals.cured
    }

    /// Energy lost since the start.
    pub fn dissipated_energy(&self) -> f64 {
        self.totals.lost
    }

    /// Sum over the collisions of normal impulse times distance of the centres: the pressure of a gas at
    /// temperature T over a time t is (N T + virial/(3 t))/V.
    pub fn virial(&self) -> f64 {
        self.totals.virial
    }

    /// Edge of the cube.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Number of spheres.
    pub fn count(&self) -> usize {
        self.bodies.len()
    }

    /// Centres at the current time, within the cube.
    pub fn places(&self) -> Vec<Vector3<f64>> {
        let length = self.length;
        let inside = |x: f64| {
            let inside = x - length * (x / length).floor();
            if inside < length { inside } else { 0.0 }
        };
        let place = |body: &Body| body.place_at(self.totals.time).map(inside);
        self.bodies.iter().map(place).collect()
    }

    /// Velocity and spin of a sphere; zero of one that does not exist.
    pub fn motion(&self, sphere: usize) -> Motion {
        let rest = Motion {
            velocity: Vector3::zeros(),
            spin: Vector3::zeros(),
        };
        self.bodies.get(sphere).map_or(rest, |body| body.motion)
    }

    /// Velocities and spins of all spheres.
    pub fn motions(&self) -> impl Iterator<Item = &Motion> {
        self.bodies.iter().map(|body| &body.motion)
    }

    fn temperature_translational(&self) -> f64 {
        let squares = self.motions().map(|motion| motion.velocity.norm_squared());
        squares.sum::<f64>() / (3.0 * self.bodies.len() as f64)
    }
}

/// Whether the spheres of an event have had no other collision since it was predicted.
fn is_live(bodies: &[Body], event: &Event) -> bool {
    let [a, b] = event.counts;
    bodies[event.a as usize].count == a && (event.b == CELL || bodies[event.b as usize].count == b)
}

/// Refuses spheres that overlap.
fn check_overlaps(length: f64, bodies: &[(Vector3<f64>, Motion)]) -> Result<(), EventError> {
    let space = PeriodicBox::new([Some(length); 3]).map_err(|_| EventError::Length(length))?;
    let places: Vec<_> = bodies.iter().map(|(place, _)| *place).collect();
    let radii = vec![1.0; places.len()];
    let near = neighbours(&space, &places, &radii, 0.0);
    let near = near.map_err(|_| EventError::Length(length))?;
    let least = DIAMETER_SQ * (1.0 - OVERLAP);
    let overlap = near.into_iter().find(|&[a, b]| {
        let apart = space.displacement(&places[a as usize], &places[b as usize]);
        apart.norm_squared() < least
    });
    overlap.map_or(Ok(()), |[a, b]| Err(EventError::Overlap(a, b)))
}
