//! Random pairs of spheres for the contact tests.

use crate::sweep::Lcg;
use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactFriction, ContactGeometry, ContactModes, ContactVector,
    IndependentFriction, NormalLaw, SphereBody,
};
use tribos_core::real::Real;

/// Two spheres near each other, the law along the normal, and a time step.
#[derive(Clone, Copy, Debug)]
pub struct Meeting<R> {
    /// Contact geometry.
    pub touch: ContactGeometry<R>,
    /// The spheres.
    pub spheres: [SphereBody<R>; 2],
    /// Cohesion and restitution.
    pub law: NormalLaw<R>,
    /// Length of the step.
    pub dt: R,
}

/// A vector with components uniform in ±`size`.
pub fn vector<R: Real>(rng: &mut Lcg, size: f64) -> Vector3<R> {
    Vector3::from([(); 3].map(|()| R::from_f64(rng.between(-size, size))))
}

/// A solid sphere of density 1, up to the factor 4π/3.
pub fn solid<R: Real>(rng: &mut Lcg, radius: f64, speed: f64) -> SphereBody<R> {
    let inv_mass = 1.0 / radius.powi(3);
    SphereBody {
        velocity: vector(rng, speed),
        spin: vector(rng, speed / radius),
        inv_mass: R::from_f64(inv_mass),
        inv_inertia: R::from_f64(2.5 * inv_mass / (radius * radius)),
    }
}

impl<R: Real> Meeting<R> {
    /// Spheres of the given radii, drawn so that every branch of the normal law is frequent.
    pub fn random(rng: &mut Lcg, radii: [f64; 2]) -> Self {
        let away = [0.0, 0.01, -0.01, 0.05][rng.bits() as usize % 4];
        let direction: Vector3<f64> = vector(rng, 1.0);
        let displacement = direction * ((radii[0] + radii[1]) * (1.0 + away) / direction.norm());
        let touch =
            ContactGeometry::spheres(&displacement.map(R::from_f64), radii.map(R::from_f64));
        let attraction = [Attraction::Pull, Attraction::Resistance][rng.bits() as usize % 2];
        let strength = rng.log_between(1e-2, 1e2);
        let [strength, range] = [strength, 0.1].map(R::from_f64);
        let cohesion = Cohesion::new(strength, range, attraction).expect("in range");
        let restitution = R::from_f64([0.0, 0.0, 0.5][rng.bits() as usize % 3]);
        Self {
            touch: touch.expect("apart"),
            spheres: radii.map(|radius| solid(rng, radius, 1.0)),
            law: NormalLaw::new(cohesion, restitution).expect("in range"),
            dt: R::from_f64(rng.log_between(1e-2, 1.0)),
        }
    }

    /// The contact before its first update.
    pub fn contact<F: ContactFriction<R>>(&self, _: &F) -> Contact<R, F::Modes> {
        let [a, b] = &self.spheres;
        Contact::new(&self.touch, &self.law, a, b, self.dt)
    }

    /// Relative speed of the spheres at the contact; spins count by their speed at r_eff.
    pub fn speed(&self) -> f64 {
        let all = IndependentFriction::all(R::ZERO, R::ZERO, R::ZERO).expect("in range");
        let [a, b] = &self.spheres;
        let velocity = self.contact(&all).velocity(a, b);
        size(&velocity, R::ONE / self.touch.lever)
    }

    /// Scale of the rounding of an impulse: the impulse, P, and the relative momentum.
    pub fn scale<F: ContactFriction<R>>(&self, friction: &F) -> f64 {
        let contact = self.updated(friction).0;
        let met = contact.block().mass_normal.to_f64() * self.speed();
        size(contact.impulse(), contact.effective_radius()) + contact.bound().to_f64() + met
    }

    /// The contact and the spheres after one update.
    pub fn updated<F: ContactFriction<R>>(
        &self,
        friction: &F,
    ) -> (Contact<R, F::Modes>, [SphereBody<R>; 2]) {
        let (mut contact, [mut a, mut b]) = (self.contact(friction), self.spheres);
        contact.update(friction, &mut a, &mut b);
        (contact, [a, b])
    }
}

/// Equal, unequal and very unequal radii, alternately.
pub fn radii(rng: &mut Lcg) -> [f64; 2] {
    match rng.bits() % 3 {
        0 => [1.0, 1.0],
        1 => [rng.between(0.3, 3.0), rng.between(0.3, 3.0)],
        _ => [1.0, rng.log_between(1e-3, 1e3)],
    }
}

/// All components: normal, sliding, rolling, torsion.
pub fn components<R: Real, M: ContactModes<R>>(modal: &ContactVector<R, M>) -> [R; 8] {
    let (s, r) = (modal.sliding(), modal.rolling());
    let torsion = modal.torsion();
    [modal.normal, s.x, s.y, s.z, r.x, r.y, r.z, torsion]
}

/// |p| + |T|/lever of all modes, a scale of impulses.
pub fn size<R: Real, M: ContactModes<R>>(modal: &ContactVector<R, M>, lever: R) -> f64 {
    modal.dot_with_lever(modal, lever).to_f64().sqrt()
}
