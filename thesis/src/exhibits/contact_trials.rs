//! Two free spheres at one contact, step by step: experiments on the laws of figures 4.2 and 4.3.
//!
//! Only their relative motion is followed: the axis through the centres keeps its direction.

use anyhow::{Result, anyhow};
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, Contact, ContactGeometry, IndependentFriction, NormalLaw,
    SphereBody,
};

/// Strength and range of cohesion: the unit of force, and the default of powders in R.
pub const STRENGTH: f64 = 1.0;
pub const RANGE: f64 = 1e-2;
/// μ, μ_t and μ_n: three different ones.
pub const FRICTION: [f64; 3] = [0.3, 0.2, 0.4];

/// A step in which a contact is watched, in √(ρR⁴/F_coh).
const STEP: f64 = 1e-3;
/// Steps that tell whether a contact holds.
const PATIENCE: usize = 100;
/// Halvings from an interval to rounding.
const HALVINGS: usize = 50;
/// Speed beyond rounding: a load above its threshold by 10⁻⁹ comes to more.
const MOVING: f64 = 1e-11;
/// A step that cuts the way across the range into 10⁴ pieces, at the speed that just breaks.
const FINE_STEP: f64 = 1e-5;

/// A part of the contact's motion that friction resists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// In the contact plane.
    Sliding,
    /// About an axis in it.
    Rolling,
    /// About the normal.
    Torsion,
}

/// What pulls and turns the spheres, half of it on each, or what the contact answers with.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Load {
    /// Force along the normal: F_n, positive if it pushes.
    pub normal: f64,
    /// Forces and torques of the three modes.
    pub modes: [f64; 3],
}

impl Load {
    /// A normal force and one other.
    pub fn new(normal: f64, mode: Mode, size: f64) -> Self {
        let mut load = Self {
            normal,
            ..Self::default()
        };
        load.modes[mode as usize] = size;
        load
    }
}

/// A pair of spheres.
#[derive(Debug, Clone)]
pub struct Pair {
    spheres: [SphereBody<f64>; 2],
    radii: [f64; 2],
    /// Distance of the surfaces.
    pub gap: f64,
    law: NormalLaw<f64>,
    friction: IndependentFriction<f64, AllModes>,
}

/// From the first sphere to the second, and the direction of sliding and axis of rolling.
const NORMAL: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);
const ACROSS: Vector3<f64> = Vector3::new(1.0, 0.0, 0.0);

impl Pair {
    /// At rest, of density 1.
    pub fn new(attraction: Attraction, radii: [f64; 2]) -> Result<Self> {
        let [mu, rolling, torsion] = FRICTION;
        let cohesion = Cohesion::new(STRENGTH, RANGE, attraction)?;
        let sphere = |radius: f64| {
            let mass = 4.0 / 3.0 * PI * radius.powi(3);
            SphereBody {
                velocity: Vector3::zeros(),
                spin: Vector3::zeros(),
                inv_mass: 1.0 / mass,
                inv_inertia: 2.5 / (mass * radius * radius),
            }
        };
        Ok(Self {
            spheres: radii.map(sphere),
            radii,
            gap: 0.0,
            law: NormalLaw::new(cohesion, 0.0)?,
            friction: IndependentFriction::all(mu, rolling, torsion)?,
        })
    }

    /// Two of radius 1.
    pub fn equal(attraction: Attraction) -> Result<Self> {
        Self::new(attraction, [1.0; 2])
    }

    /// The same pair, unable to turn: it slides instead of rolling.
    pub fn stiff(mut self) -> Self {
        for sphere in &mut self.spheres {
            sphere.inv_inertia = 0.0;
        }
        self
    }

    /// Relative velocity: of the gap and of the three modes, as in [`Load`].
    pub fn velocity(&self) -> Load {
        let [a, b] = &self.spheres;
        let (drift, turning) = (b.velocity - a.velocity, b.spin - a.spin);
        Load {
            normal: drift.dot(&NORMAL),
            modes: [
                drift.dot(&ACROSS),
                turning.dot(&ACROSS),
                turning.dot(&NORMAL),
            ],
        }
    }

    /// Sets the relative velocity, half of it each.
    pub fn set_velocity(&mut self, velocity: Load) {
        let [sliding, rolling, torsion] = velocity.modes;
        let drift = NORMAL * velocity.normal + ACROSS * sliding;
        let turning = ACROSS * rolling + NORMAL * torsion;
        for (sphere, half) in self.spheres.iter_mut().zip([-0.5, 0.5]) {
            sphere.velocity = drift * half;
            sphere.spin = turning * half;
        }
    }

    /// A step under a load; returns what the contact answers on the second sphere.
    pub fn step(&mut self, load: Load, dt: f64) -> Result<Load> {
        // The load presses the spheres together, and moves the second against the first.
        let [sliding, rolling, torsion] = load.modes;
        let force = ACROSS * sliding - NORMAL * load.normal;
        let torque = ACROSS * rolling + NORMAL * torsion;
        for (sphere, sign) in self.spheres.iter_mut().zip([-1.0, 1.0]) {
            sphere.velocity += force * (sign * sphere.inv_mass * dt);
            sphere.spin += torque * (sign * sphere.inv_inertia * dt);
        }

        // The contact answers.
        let distance = self.radii[0] + self.radii[1] + self.gap;
        let touch = ContactGeometry::spheres(&(NORMAL * distance), self.radii)?;
        let [a, b] = &mut self.spheres;
        let mut contact = Contact::<f64, AllModes>::new(&touch, &self.law, a, b, dt);
        contact.update(&self.friction, a, b);
        let impulse = contact.impulse();
        let (sliding, rolling, torsion) = (impulse.sliding(), impulse.rolling(), impulse.torsion());

        self.gap += self.velocity().normal * dt;
        Ok(Load {
            normal: impulse.normal / dt,
            modes: [sliding.dot(&ACROSS), rolling.dot(&ACROSS), torsion].map(|share| share / dt),
        })
    }
}

/// The load that a pair at rest just bears: `load` of its size between 0 and `most`.
pub fn bearable(pair: &Pair, most: f64, load: impl Fn(f64) -> Load) -> Result<f64> {
    threshold(most, |size| {
        let mut pair = pair.clone();
        for _ in 0..PATIENCE {
            pair.step(load(size), STEP)?;
        }
        let Load { normal, modes } = pair.velocity();
        let fastest = modes.iter().fold(normal.abs(), |most, v| most.max(v.abs()));
        Ok(fastest > MOVING)
    })
}

/// What a moving contact answers with, under a normal force.
pub fn answer(pair: &Pair, normal: f64, velocity: Load) -> Result<Load> {
    let mut pair = pair.clone();
    pair.set_velocity(velocity);
    let load = Load {
        normal,
        ..Load::default()
    };
    pair.step(load, STEP)
}

/// Normal force at a gap, with the spheres at rest or parting at a `speed`.
pub fn force_at(attraction: Attraction, gap: f64, speed: f64) -> Result<f64> {
    let mut pair = Pair::equal(attraction)?;
    pair.gap = gap;
    let parting = Load {
        normal: speed,
        ..Load::default()
    };
    Ok(answer(&pair, 0.0, parting)?.normal)
}

/// The largest gap at which parting spheres are held back, up to `most`.
pub fn reach(attraction: Attraction, most: f64) -> Result<f64> {
    threshold(most, |gap| Ok(force_at(attraction, gap, 1.0)? == 0.0))
}

/// The energy with which spheres in contact have to part so that the contact breaks, up to `most`.
pub fn breaking_energy(attraction: Attraction, most: f64) -> Result<f64> {
    threshold(most, |energy| {
        let mut pair = Pair::equal(attraction)?;
        let reduced = 1.0 / (pair.spheres[0].inv_mass + pair.spheres[1].inv_mass);
        pair.set_velocity(Load {
            normal: (2.0 * energy / reduced).sqrt(),
            ..Load::default()
        });
        while pair.velocity().normal > 0.0 && pair.gap <= RANGE {
            pair.step(Load::default(), FINE_STEP)?;
        }
        Ok(pair.gap > RANGE)
    })
}

/// Work that a contact does against a constant `pull` which opens it: until its force ends.
pub fn work_against(attraction: Attraction, pull: f64) -> Result<f64> {
    let mut pair = Pair::equal(attraction)?;
    let load = Load {
        normal: -pull,
        ..Load::default()
    };
    let mut work = 0.0;
    loop {
        let before = pair.gap;
        let force = pair.step(load, FINE_STEP)?.normal;
        work -= force * (pair.gap - before);
        if force == 0.0 {
            return Ok(work);
        }
    }
}

/// Where `gives` changes from false to true between 0 and `most`, by halving.
fn threshold(most: f64, mut gives: impl FnMut(f64) -> Result<bool>) -> Result<f64> {
    let (mut low, mut high) = (0.0, most);
    if !gives(high)? {
        return Err(anyhow!("no threshold up to {most}"));
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if gives(middle)? {
            high = middle;
        } else {
            low = middle;
        }
    }
    Ok(0.5 * (low + high))
}
