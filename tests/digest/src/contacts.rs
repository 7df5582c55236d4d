//! Bits of impulses of contacts, and of a manifold.

use crate::ARGUMENTS;
use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, speed};
use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactFriction, ContactGeometry, ContactModes, ContactVector,
    CoupledFriction, IndependentFriction, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_core::manifold::{ContactSystem, InitialGuess, SolverSettings};
use tribos_core::real::Real;

/// Hash of updates of contacts under every friction, f64 and f32.
pub fn contacts() -> u64 {
    in_both(contacts_of::<f64>, contacts_of::<f32>)
}

fn contacts_of<R: Real>(hash: &mut Fnv) {
    let [mu, mu_t, mu_n] = [0.5, 0.125, 0.25].map(R::from_f64);
    let exact = RoundLimitSurface::new(CoulombDisk, mu, mu_n).expect("in range");
    let usual = LimitEllipsoid::new(mu, mu_n, R::HALF).expect("in range");
    met::<R, _>(hash, &IndependentFriction::none());
    met(hash, &IndependentFriction::sliding(mu).expect("in range"));
    met(
        hash,
        &IndependentFriction::sliding_rolling(mu, mu_t).expect("in range"),
    );
    met(
        hash,
        &IndependentFriction::all(mu, mu_t, mu_n).expect("in range"),
    );
    met(hash, &CoupledFriction::sliding_torsion(exact));
    met(hash, &CoupledFriction::all(usual, mu_t).expect("in range"));
}

pub(crate) fn sphere<R: Real>(rng: &mut Lcg, radius: R) -> SphereBody<R> {
    let mut vector = || Vector3::from([(); 3].map(|()| speed::<R>(rng) - speed::<R>(rng)));
    let inv_mass = R::ONE / (radius * radius * radius);
    SphereBody {
        velocity: vector(),
        spin: vector(),
        inv_mass,
        inv_inertia: R::from_f64(2.5) * inv_mass / (radius * radius),
    }
}

fn met<R: Real, F: ContactFriction<R>>(hash: &mut Fnv, friction: &F) {
    let [dt, strength, range] = [0.0625, 0.75, 0.25].map(R::from_f64);
    let mut rng = Lcg::new(47);
    for round in 0..ARGUMENTS / 4 {
        let attraction = [Attraction::Pull, Attraction::Resistance][round % 2];
        let cohesion = Cohesion::new(strength, range, attraction).expect("in range");
        let restitution = R::from_f64((round % 3) as f64 * 0.25);
        let law = NormalLaw::new(cohesion, restitution).expect("in range");
        let radii = [R::ONE, R::from_f64([1.0, 0.25, 1.75][round % 3])];
        let across = sphere(&mut rng, R::ONE).velocity;
        let Ok(touch) = ContactGeometry::spheres(&across, radii) else {
            continue;
        };
        let touch = ContactGeometry {
            gap: R::from_f64([0.0, 0.125, -0.5][round / 2 % 3]),
            ..touch
        };
        let (mut a, mut b) = (sphere(&mut rng, radii[0]), sphere(&mut rng, radii[1]));
        let mut contact = Contact::new(&touch, &law, &a, &b, dt);
        contact.update(friction, &mut a, &mut b);
        // The second update of one that was laid aside.
        let mut contact = Contact::resume(&contact.prepared(), contact.impulse());
        contact.update(friction, &mut a, &mut b);
        for x in components(contact.impulse()) {
            hash.number(x);
        }
        for x in a.velocity.iter().chain(b.spin.iter()) {
            hash.number(*x);
        }
    }
    hash.numbers(friction.independent_limits().into_iter().flatten());
    manifold(hash, friction);
}

/// A ball between two plates, followed for some steps.
fn manifold<R: Real, F: ContactFriction<R>>(hash: &mut Fnv, friction: &F) {
    let law = NormalLaw::new(Cohesion::NONE, R::ZERO).expect("in range");
    let mut grip = ContactSystem::<R, F, 3, 2>::new(law, *friction);
    let mut rng = Lcg::new(53);
    let ball = grip.push_sphere(sphere(&mut rng, R::ONE)).expect("room");
    let along = |sign: f64| Vector3::new(R::from_f64(sign), R::ZERO, R::ZERO);
    let still = along(0.0);
    for side in [1.0, -1.0] {
        let (velocity, inv_mass) = (still, R::HALF);
        let plate = grip
            .push_plate(WallBody { velocity, inv_mass })
            .expect("room");
        grip.set_force(plate, along(8.0 * side), still)
            .expect("it is there");
        let touch = ContactGeometry::plate(R::ONE, &along(side), R::ONE).expect("they touch");
        grip.push_contact(ball, plate, touch).expect("room");
    }
    grip.set_gravity(Vector3::new(R::ZERO, R::ZERO, -R::ONE));
    let step = TimeStep::new(R::from_f64(0.125)).expect("positive");
    let stop = SolverSettings {
        max_iterations: 20,
        tolerance: R::from_f64(0.0009765625),
    };
    for _ in 0..8 {
        let report = grip.solve(step, InitialGuess::Last, stop);
        hash.number(report.residual);
        hash.feed(u64::from(report.iterations));
    }
    if let Some(tribos_core::manifold::SystemBody::Sphere(ball)) = grip.body(ball) {
        for x in ball.velocity.iter().chain(ball.spin.iter()) {
            hash.number(*x);
        }
    }
}

/// All components: normal, sliding, rolling, torsion.
pub(crate) fn components<R: Real, M: ContactModes<R>>(modal: &ContactVector<R, M>) -> [R; 8] {
    let (s, r) = (modal.sliding(), modal.rolling());
    let torsion = modal.torsion();
    [modal.normal, s.x, s.y, s.z, r.x, r.y, r.z, torsion]
}
