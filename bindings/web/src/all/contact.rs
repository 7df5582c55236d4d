//! Contacts of spheres and plates that may open, slide, roll and spin.

use crate::exchange::Refused;
use nalgebra::Vector3;
use tribos_core::Error;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactBody, ContactFriction, ContactGeometry, NormalLaw,
    SphereBody, TimeStep, WallBody,
};
use tribos_friction::{AnyContactFriction, Area, ContactVisitor};

/// What a contact resists, in numbers.
#[derive(Clone, Copy, Debug)]
pub struct ContactParameters<'a> {
    /// Coefficients of sliding, rolling and torsion.
    pub coefficients: [f64; 3],
    /// Name of a round patch and R_c/r_eff, in place of torsion; an empty name for none.
    pub patch: (&'a str, f64),
    /// Speed after an impact over speed before.
    pub restitution: f64,
    /// Strength in N and range in m of cohesion.
    pub cohesion: [f64; 2],
    /// Whether cohesion resists opening alone.
    pub attraction: Attraction,
}

/// Laws of a contact: along the normal, and friction.
#[derive(Clone, Debug)]
pub struct ContactLaw {
    normal: NormalLaw<f64>,
    friction: AnyContactFriction,
}

/// Numbers of a body in a row: velocity, spin, 1/mass, 1/inertia, radius.
const FIELDS: usize = 9;
/// Both bodies, normal and gap.
pub const GIVEN: usize = 2 * FIELDS + 4;
/// Velocities and spins of both, sliding and rolling impulse, normal and torsion impulse.
pub const ANSWER: usize = 20;

/// A row as three numbers from `at` on.
fn vector(row: &[f64; GIVEN], at: usize) -> Vector3<f64> {
    Vector3::new(row[at], row[at + 1], row[at + 2])
}

fn sphere(row: &[f64; GIVEN], at: usize) -> SphereBody<f64> {
    SphereBody {
        velocity: vector(row, at),
        spin: vector(row, at + 3),
        inv_mass: row[at + 6],
        inv_inertia: row[at + 7],
    }
}

impl ContactLaw {
    /// Refuses what the kernel refuses.
    pub fn new(given: &ContactParameters<'_>) -> Result<Self, Refused> {
        let [strength, range] = given.cohesion;
        let cohesion = Cohesion::new(strength, range, given.attraction)?;
        let [mu, rolling, _] = given.coefficients;
        let friction = match given.patch {
            ("", _) => AnyContactFriction::thresholds(given.coefficients)?,
            (text, radius) => {
                AnyContactFriction::coupled(&Area::round(text.parse()?, radius)?, mu, rolling)?
            }
        };
        Ok(Self {
            normal: NormalLaw::new(cohesion, given.restitution)?,
            friction,
        })
    }

    /// A contact of two spheres in one time step.
    pub fn spheres(&self, row: &[f64; GIVEN], dt: f64) -> Result<[f64; ANSWER], Refused> {
        let (first, second) = (sphere(row, 0), sphere(row, FIELDS));
        let (normal, gap) = (vector(row, 2 * FIELDS), row[2 * FIELDS + 3]);
        let radii = [row[8], row[FIELDS + 8]];
        let displacement = normal * (radii[0] + radii[1] + gap);
        let touch = ContactGeometry::spheres(&displacement, radii).map_err(Error::from)?;
        // To the bit as given: a gap of 0 is closed.
        let touch = ContactGeometry {
            normal,
            gap,
            ..touch
        };
        self.solve(&touch, first, second, dt)
    }

    /// A contact of a sphere and a plate, of which velocity and 1/mass count.
    pub fn plate(&self, row: &[f64; GIVEN], dt: f64) -> Result<[f64; ANSWER], Refused> {
        let (first, second) = (sphere(row, 0), sphere(row, FIELDS));
        let plate = WallBody {
            velocity: second.velocity,
            inv_mass: second.inv_mass,
        };
        let (normal, gap) = (vector(row, 2 * FIELDS), row[2 * FIELDS + 3]);
        let touch = ContactGeometry::plate(row[8] + gap, &-normal, row[8]).map_err(Error::from)?;
        self.solve(&ContactGeometry { gap, ..touch }, first, plate, dt)
    }

    fn solve<B: ContactBody<f64>>(
        &self,
        touch: &ContactGeometry<f64>,
        first: SphereBody<f64>,
        second: B,
        dt: f64,
    ) -> Result<[f64; ANSWER], Refused> {
        let dt = TimeStep::new(dt)?.dt();
        Ok(self.friction.visit(Pair {
            law: &self.normal,
            touch,
            bodies: (first, second),
            dt,
        }))
    }
}

/// Two bodies that touch.
struct Pair<'a, B> {
    law: &'a NormalLaw<f64>,
    touch: &'a ContactGeometry<f64>,
    bodies: (SphereBody<f64>, B),
    dt: f64,
}

impl<B: ContactBody<f64>> ContactVisitor for Pair<'_, B> {
    type Output = [f64; ANSWER];

    #[inline(never)]
    fn visit<F: ContactFriction<f64>>(self, friction: &F) -> [f64; ANSWER] {
        let (mut a, mut b) = self.bodies;
        let mut contact = Contact::<f64, F::Modes>::new(self.touch, self.law, &a, &b, self.dt);
        contact.update(friction, &mut a, &mut b);
        let impulse = contact.impulse();
        let vectors = [
            a.velocity,
            a.spin,
            b.velocity(),
            b.angular_velocity(),
            impulse.sliding(),
            impulse.rolling(),
        ];
        let mut row = [0.0; ANSWER];
        for (numbers, vector) in row.as_chunks_mut::<3>().0.iter_mut().zip(vectors) {
            *numbers = vector.into();
        }
        [row[18], row[19]] = [impulse.normal, impulse.torsion()];
        row
    }
}
