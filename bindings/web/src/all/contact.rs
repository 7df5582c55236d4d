//! Contacts of spheres and plates that may open, slide, roll and spin.

use super::shape::{Shape, said};
use crate::exchange::Refused;
use alloc::format;
use nalgebra::Vector3;
use tribos::friction;
use tribos_core::Error;
use tribos_core::contact::{
    AllModes, Attraction, Body, Cohesion, Contact, ContactFriction, CoupledFriction, Frictionless,
    NormalLaw, Plate, Sliding, SlidingRolling, SlidingTorsion, Sphere, Thresholds, TimeStep, Touch,
};
use tribos_core::coupling::{
    Annulus, Coupling, DryCoupling, ReducedJacobian, ReducedWrench, closed, table::Coulomb,
};
use tribos_core::internals::Lead;
use tribos_core::limit_surface::{FrictionSet, LimitSurface, Projection};
use tribos_core::twist::{Twist, Wrench};

/// Friction of a contact, by the modes that it resists.
#[derive(Clone, Copy, Debug)]
enum AnyFriction {
    None(Thresholds<f64, Frictionless>),
    Sliding(Thresholds<f64, Sliding>),
    SlidingRolling(Thresholds<f64, SlidingRolling>),
    SlidingTorsion(Thresholds<f64, SlidingTorsion>),
    All(Thresholds<f64, AllModes>),
    Coupled(CoupledFriction<f64, RoundSet, SlidingTorsion>),
    CoupledRolling(CoupledFriction<f64, RoundSet, AllModes>),
}

/// Dry friction that needs no memory, behind a pointer, so that the module has its limit surface once.
#[derive(Clone, Copy)]
struct Closed(&'static (dyn DryCoupling<f64> + Send + Sync));

impl core::fmt::Debug for Closed {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Closed").finish_non_exhaustive()
    }
}

impl Coupling<f64> for Closed {
    fn reduced_wrench(&self, slide: f64, rim: f64) -> ReducedWrench<f64> {
        self.0.reduced_wrench(slide, rim)
    }
    fn reduced_jacobian(&self, slide: f64, rim: f64) -> ReducedJacobian<f64> {
        self.0.reduced_jacobian(slide, rim)
    }
}

impl DryCoupling<f64> for Closed {
    fn reduced_point(&self, lead: Lead, ratio: f64) -> [f64; 3] {
        self.0.reduced_point(lead, ratio)
    }
}

/// Exact sets of round patches whose size is known without memory.
#[derive(Clone, Copy, Debug)]
enum RoundSet {
    Closed(LimitSurface<f64, Closed>),
    Annulus(LimitSurface<f64, Annulus<f64, Coulomb>>),
}

impl RoundSet {
    fn new(text: &str, radius: f64, mu: f64) -> Result<Self, Refused> {
        let Shape::Round(kind, r) = Shape::round(text, radius)? else {
            return Err(said(friction::Refusal::NoAxis));
        };
        let closed: &'static (dyn DryCoupling<f64> + Send + Sync) = match kind {
            friction::Patch::Disk => &Coulomb,
            friction::Patch::Ring => &closed::Ring,
            friction::Patch::Hertz => &closed::Hertz,
            friction::Patch::Punch => &closed::FlatPunch,
            friction::Patch::Annulus(inner) => {
                let annulus = Annulus::new(Coulomb, inner).map_err(Error::from)?;
                return Ok(Self::Annulus(LimitSurface::new(annulus, mu, r)?));
            }
            other => {
                return Err(said(format!(
                    "contacts have the exact set of disk, ring, annulus, hertz and punch, not of {other}"
                )));
            }
        };
        Ok(Self::Closed(LimitSurface::new(Closed(closed), mu, r)?))
    }

    fn set(&self) -> &dyn FrictionSet<f64> {
        match self {
            Self::Closed(set) => set,
            Self::Annulus(set) => set,
        }
    }
}

impl FrictionSet<f64> for RoundSet {
    fn force_limit(&self) -> f64 {
        self.set().force_limit()
    }
    fn radius(&self) -> f64 {
        self.set().radius()
    }
    fn support(&self, twist: &Twist<f64>) -> f64 {
        self.set().support(twist)
    }
    fn wrench(&self, twist: &Twist<f64>) -> Wrench<f64> {
        self.set().wrench(twist)
    }
    fn gauge(&self, wrench: &Wrench<f64>) -> f64 {
        self.set().gauge(wrench)
    }
    fn twist_normal_to(&self, push: &Wrench<f64>) -> Twist<f64> {
        self.set().twist_normal_to(push)
    }
    fn scale_to_surface(&self, wrench: &Wrench<f64>) -> Wrench<f64> {
        self.set().scale_to_surface(wrench)
    }
    fn project_with_length(&self, wrench: &Wrench<f64>, length: f64) -> Projection<f64> {
        self.set().project_with_length(wrench, length)
    }
}

/// What a contact resists, in numbers.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a> {
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
#[derive(Clone, Copy, Debug)]
pub struct ContactLaw {
    normal: NormalLaw<f64>,
    friction: AnyFriction,
}

fn thresholds([mu, rolling, torsion]: [f64; 3]) -> Result<AnyFriction, Refused> {
    // Modes without a threshold cost nothing; negative and missing numbers are refused by the full form.
    let full = Thresholds::all(mu, rolling, torsion)?;
    Ok(match [mu == 0.0, rolling == 0.0, torsion == 0.0] {
        [true, true, true] => AnyFriction::None(Thresholds::none()),
        [_, true, true] => AnyFriction::Sliding(Thresholds::sliding(mu)?),
        [_, false, true] => AnyFriction::SlidingRolling(Thresholds::sliding_rolling(mu, rolling)?),
        [_, true, false] => AnyFriction::SlidingTorsion(Thresholds::sliding_torsion(mu, torsion)?),
        [_, false, false] => AnyFriction::All(full),
    })
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

fn sphere(row: &[f64; GIVEN], at: usize) -> Sphere<f64> {
    Sphere {
        velocity: vector(row, at),
        spin: vector(row, at + 3),
        inv_mass: row[at + 6],
        inv_inertia: row[at + 7],
    }
}

impl ContactLaw {
    /// Refuses what the kernel refuses.
    pub fn new(given: &Given<'_>) -> Result<Self, Refused> {
        let [strength, range] = given.cohesion;
        let cohesion = Cohesion::new(strength, range, given.attraction)?;
        let [mu, rolling, _] = given.coefficients;
        let friction = match given.patch {
            ("", _) => thresholds(given.coefficients)?,
            (text, radius) => {
                let set = RoundSet::new(text, radius, mu)?;
                if rolling == 0.0 {
                    AnyFriction::Coupled(CoupledFriction::sliding_torsion(set))
                } else {
                    AnyFriction::CoupledRolling(CoupledFriction::all(set, rolling)?)
                }
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
        let touch = Touch::spheres(&displacement, radii).map_err(Error::from)?;
        // To the bit as given: a gap of 0 is closed.
        let touch = Touch {
            normal,
            gap,
            ..touch
        };
        self.solve(&touch, first, second, dt)
    }

    /// A contact of a sphere and a plate, of which velocity and 1/mass count.
    pub fn plate(&self, row: &[f64; GIVEN], dt: f64) -> Result<[f64; ANSWER], Refused> {
        let (first, second) = (sphere(row, 0), sphere(row, FIELDS));
        let plate = Plate {
            velocity: second.velocity,
            inv_mass: second.inv_mass,
        };
        let (normal, gap) = (vector(row, 2 * FIELDS), row[2 * FIELDS + 3]);
        let touch = Touch::plate(row[8] + gap, &-normal, row[8]).map_err(Error::from)?;
        self.solve(&Touch { gap, ..touch }, first, plate, dt)
    }

    fn solve<B: Body<f64>>(
        &self,
        touch: &Touch<f64>,
        first: Sphere<f64>,
        second: B,
        dt: f64,
    ) -> Result<[f64; ANSWER], Refused> {
        let dt = TimeStep::new(dt)?.dt();
        Ok(match &self.friction {
            AnyFriction::None(friction) => self.update(friction, touch, first, second, dt),
            AnyFriction::Sliding(friction) => self.update(friction, touch, first, second, dt),
            AnyFriction::SlidingRolling(friction) => {
                self.update(friction, touch, first, second, dt)
            }
            AnyFriction::SlidingTorsion(friction) => {
                self.update(friction, touch, first, second, dt)
            }
            AnyFriction::All(friction) => self.update(friction, touch, first, second, dt),
            AnyFriction::Coupled(friction) => self.update(friction, touch, first, second, dt),
            AnyFriction::CoupledRolling(friction) => {
                self.update(friction, touch, first, second, dt)
            }
        })
    }

    #[inline(never)]
    fn update<F: ContactFriction<f64>, B: Body<f64>>(
        &self,
        friction: &F,
        touch: &Touch<f64>,
        mut a: Sphere<f64>,
        mut b: B,
        dt: f64,
    ) -> [f64; ANSWER] {
        let mut contact = Contact::<f64, F::Modes>::new(touch, &self.normal, &a, &b, dt);
        contact.update(friction, &mut a, &mut b);
        let impulse = contact.impulse();
        let vectors = [
            a.velocity,
            a.spin,
            b.velocity(),
            b.spin(),
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
