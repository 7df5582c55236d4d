//! Four balls, a floor and three fingers: positions and contacts.

use nalgebra::Vector3;
use tribos_core::contact::AllModes;
use tribos_core::contact::{
    Cohesion, ContactBody, ContactGeometry, IndependentFriction, NormalLaw, SphereBody, TimeStep,
    WallBody,
};
use tribos_core::manifold::{
    BodyHandle, ContactHandle, ContactSystem, InitialGuess, SolverReport, SolverSettings,
};

/// Radius and mass of a ball: m, kg.
const RADIUS: f32 = 0.02;
const MASS: f32 = 0.05;
const GRAVITY: f32 = 9.81;
/// Force of a finger, N, and its mass, kg.
const PRESS: f32 = 3.0;
const FINGER: f32 = 0.1;
/// Initial gap of every contact, m.
const APART: f32 = 1e-3;
/// Sliding, rolling and torsion.
const FRICTION: [f32; 3] = [0.4, 0.01, 0.01];
/// Largest number of sweeps of a step, which bounds its time: an impact may take longer and
/// continues in the next step.
pub const SWEEPS: u32 = 20;
/// When the sweeps end.
const STOP: SolverSettings<f32> = SolverSettings {
    max_iterations: SWEEPS,
    tolerance: 1e-4,
};

pub const BALLS: usize = 4;
const FINGERS: usize = 3;
const BODIES: usize = BALLS + FINGERS + 1;
pub const CONTACTS: usize = 12;
/// Unit vectors at 90°, 210° and 330° in the plane of the floor.
const SPOKES: [[f32; 2]; 3] = [[0.0, 1.0], [-0.866_025_4, -0.5], [0.866_025_4, -0.5]];
/// 1/√3: three balls that touch each other lie 2R/√3 from their middle.
const INV_SQRT_3: f32 = 0.577_350_26;
/// √(2/3): the fourth lies 2R √(2/3) above them.
const SQRT_2_3: f32 = 0.816_496_6;

type Friction = IndependentFriction<f32, AllModes>;

/// A body and its position.
#[derive(Clone, Copy)]
struct Placed {
    body: BodyHandle,
    place: Vector3<f32>,
}

/// A plate with the unit normal that points to the balls.
#[derive(Clone, Copy)]
struct Side {
    placed: Placed,
    outward: Vector3<f32>,
}

/// Contact partners.
#[derive(Clone, Copy)]
enum Pair {
    Balls(usize, usize),
    Plate(usize, usize),
}

/// The balls 0, 1, 2 on the floor, 3 on top of them; plate 0 is the floor, 1 to 3 the fingers.
const PAIRS: [Pair; CONTACTS] = [
    Pair::Plate(0, 0),
    Pair::Plate(1, 0),
    Pair::Plate(2, 0),
    Pair::Plate(0, 1),
    Pair::Plate(1, 2),
    Pair::Plate(2, 3),
    Pair::Balls(0, 1),
    Pair::Balls(1, 2),
    Pair::Balls(2, 0),
    Pair::Balls(0, 3),
    Pair::Balls(1, 3),
    Pair::Balls(2, 3),
];

/// The pile.
pub struct Pile {
    manifold: ContactSystem<f32, Friction, BODIES, CONTACTS>,
    balls: [Placed; BALLS],
    sides: [Side; FINGERS + 1],
    contacts: [Option<ContactHandle>; CONTACTS],
    step: TimeStep<f32>,
}

impl Pile {
    /// Separate bodies at rest; the fingers press, gravity pulls.
    pub fn new(dt: f32) -> Option<Self> {
        let [sliding, rolling, torsion] = FRICTION;
        let friction = IndependentFriction::all(sliding, rolling, torsion).ok()?;
        let law = NormalLaw::new(Cohesion::NONE, 0.0).ok()?;
        let mut manifold = ContactSystem::new(law, friction);
        let ring = (2.0 * RADIUS + APART) * INV_SQRT_3;
        let top = RADIUS + 2.0 * RADIUS * SQRT_2_3 + 2.0 * APART;
        let [first, second, third] =
            SPOKES.map(|[x, y]| Vector3::new(x * ring, y * ring, RADIUS + APART));
        let mut balls = [None; BALLS];
        for (slot, place) in
            balls
                .iter_mut()
                .zip([first, second, third, Vector3::new(0.0, 0.0, top)])
        {
            let body = manifold.push_sphere(ball()).ok()?;
            *slot = Some(Placed { body, place });
        }
        let mut sides = [None; FINGERS + 1];
        let up = Vector3::new(0.0, 0.0, 1.0);
        let inwards = SPOKES.map(|[x, y]| Vector3::new(-x, -y, 0.0));
        for (number, slot) in sides.iter_mut().enumerate() {
            let finger = number.checked_sub(1).and_then(|number| inwards.get(number));
            *slot = Some(match finger {
                None => side(&mut manifold, up, 0.0, 0.0)?,
                Some(inward) => {
                    let distance = ring + RADIUS + APART;
                    let side = side(&mut manifold, *inward, distance, 1.0 / FINGER)?;
                    let force = inward * PRESS;
                    manifold.set_force(side.placed.body, force, still()).ok()?;
                    side
                }
            });
        }
        manifold.set_gravity(Vector3::new(0.0, 0.0, -GRAVITY));
        let mut pile = Self {
            manifold,
            balls: all(balls)?,
            sides: all(sides)?,
            contacts: [None; CONTACTS],
            step: TimeStep::new(dt).ok()?,
        };
        pile.find_contacts()?;
        Some(pile)
    }

    /// Creates the contacts, or updates their positions.
    fn find_contacts(&mut self) -> Option<()> {
        for (pair, slot) in PAIRS.iter().zip(&mut self.contacts) {
            let ([first, second], touch) = match *pair {
                Pair::Balls(a, b) => {
                    let (a, b) = (self.balls.get(a)?, self.balls.get(b)?);
                    let touch = ContactGeometry::spheres(&(b.place - a.place), [RADIUS; 2]).ok()?;
                    ([a.body, b.body], touch)
                }
                Pair::Plate(a, side) => {
                    let (a, side) = (self.balls.get(a)?, self.sides.get(side)?);
                    let height = dot(&(a.place - side.placed.place), &side.outward);
                    let touch = ContactGeometry::plate(height, &side.outward, RADIUS).ok()?;
                    ([a.body, side.placed.body], touch)
                }
            };
            match slot {
                None => *slot = Some(self.manifold.push_contact(first, second, touch).ok()?),
                Some(contact) => self.manifold.set_geometry(*contact, touch).ok()?,
            }
        }
        Some(())
    }

    /// A step in time; `None` if bodies have gone through each other.
    pub fn advance(&mut self) -> Option<SolverReport<f32>> {
        self.find_contacts()?;
        let report = self.manifold.solve(self.step, InitialGuess::Last, STOP);
        let sides = self.sides.iter_mut().map(|side| &mut side.placed);
        for placed in self.balls.iter_mut().chain(sides) {
            placed.place += self.manifold.body(placed.body)?.velocity() * self.step.dt();
        }
        Some(report)
    }

    /// The fastest ball, m/s, with the speed of its rim.
    pub fn speed(&self) -> Option<f32> {
        let mut fastest = 0.0;
        for ball in &self.balls {
            let body = self.manifold.body(ball.body)?;
            let (velocity, rim) = (body.velocity(), body.angular_velocity() * RADIUS);
            let speed = norm(&velocity) + norm(&rim);
            fastest = if speed <= fastest { fastest } else { speed };
        }
        Some(fastest)
    }

    /// Force of floor and fingers on the balls against gravity, N.
    pub fn carried(&self) -> Option<f32> {
        let mut sum = 0.0;
        for (pair, contact) in PAIRS.iter().zip(self.contacts) {
            if let Pair::Plate(_, side) = pair {
                let force = self.manifold.force(contact?)?;
                // On the plate, along gravity.
                let outward = self.sides.get(*side)?.outward;
                sum -= -outward.z * force.normal + force.sliding().z;
            }
        }
        Some(sum)
    }

    /// Contacts that carry something.
    pub fn closed(&self) -> usize {
        let forces = self.contacts.iter().flatten();
        let forces = forces.filter_map(|&contact| self.manifold.force(contact));
        forces.filter(|force| force.normal > 0.0).count()
    }
}

/// Weight of all balls, N.
pub const WEIGHT: f32 = BALLS as f32 * MASS * GRAVITY;

fn still() -> Vector3<f32> {
    Vector3::new(0.0, 0.0, 0.0)
}

fn ball() -> SphereBody<f32> {
    SphereBody {
        velocity: still(),
        spin: still(),
        inv_mass: 1.0 / MASS,
        inv_inertia: 2.5 / (MASS * RADIUS * RADIUS),
    }
}

/// A plate at a distance from the middle.
fn side(
    manifold: &mut ContactSystem<f32, Friction, BODIES, CONTACTS>,
    outward: Vector3<f32>,
    distance: f32,
    inv_mass: f32,
) -> Option<Side> {
    let plate = WallBody {
        velocity: still(),
        inv_mass,
    };
    let body = manifold.push_plate(plate).ok()?;
    let place = outward * -distance;
    Some(Side {
        placed: Placed { body, place },
        outward,
    })
}

/// An array, if no element is missing.
fn all<T: Copy, const N: usize>(slots: [Option<T>; N]) -> Option<[T; N]> {
    let first = slots.first().copied().flatten()?;
    let mut whole = [first; N];
    for (to, from) in whole.iter_mut().zip(slots) {
        *to = from?;
    }
    Some(whole)
}

fn dot(a: &Vector3<f32>, b: &Vector3<f32>) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

fn norm(v: &Vector3<f32>) -> f32 {
    tribos_core::Real::sqrt(dot(v, v))
}
