//! Bits of contacts piece by piece, and of a manifold over thousands of steps.

use crate::contacts::{components, sphere};
use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, signed, speed, triples_of_ends};
use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactBody, ContactFriction, ContactGeometry, CoupledFriction,
    IndependentFriction, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::internals::{InPlane, project_on_disc};
use tribos_core::internals::{Masses, TangentialLoad};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::manifold::{BodyHandle, ContactSystem, InitialGuess, SolverSettings, SystemBody};
use tribos_core::real::Real;

/// Digest of single contacts, f64 and f32.
pub fn touching() -> u64 {
    in_both(touching_of::<f64>, touching_of::<f32>)
}

fn touching_of<R: Real>(hash: &mut Fnv) {
    let [mu, mu_t, mu_n] = [0.5, 0.125, 0.25].map(R::from_f64);
    let exact = RoundLimitSurface::new(CoulombDisk, mu, mu_n).expect("in range");
    let usual = LimitEllipsoid::new(mu, mu_n, R::HALF).expect("in range");
    let all = IndependentFriction::all(mu, mu_t, mu_n).expect("in range");
    hash.numbers([all.mu(), all.mu_rolling(), all.mu_torsion()]);
    let coupled = CoupledFriction::all(exact, mu_t).expect("in range");
    hash.numbers([coupled.mu(), coupled.mu_rolling(), coupled.mu_torsion()]);
    hash.number(coupled.set().force_limit());
    pieces::<R, _>(hash, &IndependentFriction::none());
    pieces(hash, &IndependentFriction::sliding(mu).expect("in range"));
    let torsion = IndependentFriction::sliding_torsion(mu, mu_n).expect("in range");
    pieces(hash, &torsion);
    pieces(
        hash,
        &IndependentFriction::sliding_rolling(mu, mu_t).expect("in range"),
    );
    pieces(hash, &all);
    pieces(hash, &CoupledFriction::sliding_torsion(usual));
    pieces(hash, &coupled);
    constructors::<R>(hash);
}

/// All that a contact tells and takes: updates of sphere on plate, guesses, holds at the ends.
fn pieces<R: Real, F: ContactFriction<R>>(hash: &mut Fnv, friction: &F) {
    let mut rng = Lcg::new(157);
    let mut last = None;
    for round in 0..60 {
        let attraction = [Attraction::Pull, Attraction::Resistance][round % 2];
        let [strength, range, dt] = [0.75, 0.25, 0.0625].map(R::from_f64);
        let cohesion = Cohesion::new(strength, range, attraction).expect("in range");
        let law = NormalLaw::new(cohesion, R::from_f64(0.25)).expect("in range");
        let height = R::from_f64([1.0, 1.125, 0.5][round % 3]);
        let outward = sphere(&mut rng, R::ONE).velocity;
        let Ok(touch) = ContactGeometry::plate(height, &outward, R::ONE) else {
            continue;
        };
        let mut ball = sphere(&mut rng, R::ONE);
        let velocity = sphere(&mut rng, R::ONE).velocity;
        let inv_mass = R::HALF;
        let mut plate = WallBody { velocity, inv_mass };
        let mut contact: Contact<R, F::Modes> = Contact::new(&touch, &law, &ball, &plate, dt);
        // The last round's impulse as a guess.
        if let Some(guess) = last {
            contact.set_impulse(&guess);
            contact.project_impulse(friction);
            contact.apply(contact.impulse(), &mut ball, &mut plate);
        }
        hash.numbers(components(&contact.update(friction, &mut ball, &mut plate)));
        told(hash, &contact, &ball, &plate);
        let twice = contact.impulse().plus_scaled(R::HALF, contact.impulse());
        contact.set_impulse_in_plane(&twice);
        hash.numbers(components(contact.impulse()));
        last = Some(*contact.impulse());
    }
    holds(hash, friction);
}

fn told<R, M>(hash: &mut Fnv, contact: &Contact<R, M>, ball: &SphereBody<R>, plate: &WallBody<R>)
where
    R: Real,
    M: tribos_core::contact::ContactModes<R>,
{
    let impulse = contact.impulse();
    hash.numbers(components(impulse));
    let motion = contact.velocity(ball, plate);
    hash.numbers(components(&motion.minus(impulse)));
    hash.numbers([
        motion.dot(impulse),
        motion.dot_with_lever(impulse, contact.effective_radius()),
    ]);
    hash.numbers(impulse.linear(contact.normal()).iter().copied());
    hash.numbers(impulse.angular(contact.normal()).iter().copied());
    let block = contact.block();
    hash.numbers([block.mass_normal, block.mass_sliding, block.inertia]);
    hash.numbers([block.coupling, block.masses().gyration()]);
    hash.numbers([
        contact.bound(),
        contact.cohesion(),
        contact.approach_limit(),
    ]);
    hash.numbers(contact.centre_distances());
    hash.feed(u64::from(contact.holds_gap_open()));
    for x in ball.velocity.iter().chain(ball.spin.iter()) {
        hash.number(*x);
    }
    hash.numbers(plate.velocity.iter().copied());
    hash.numbers([plate.inv_mass_normal(), plate.inv_mass_tangential()]);
    hash.number(plate.inv_inertia() + ball.inv_mass_tangential());
}

fn holds<R: Real, F: ContactFriction<R>>(hash: &mut Fnv, friction: &F) {
    let masses = Masses {
        sliding: R::TWO,
        torsion: R::HALF,
    };
    for [x, y, torsion] in triples_of_ends::<R>(211) {
        let sliding = Vector3::new(x, y, R::ZERO);
        let bound = R::ONE;
        let held = friction.hold(
            &TangentialLoad { sliding, torsion },
            bound,
            R::HALF,
            &masses,
        );
        hash.numbers(held.sliding.iter().copied());
        hash.number(held.torsion);
        let rolling = friction.hold_rolling(&sliding, torsion, R::HALF);
        hash.numbers(rolling.iter().copied());
    }
}

fn constructors<R: Real>(hash: &mut Fnv) {
    let zero = InPlane::<R>::default();
    hash.numbers(zero.0.iter().copied());
    for (x, y) in pairs_of_ends::<R>() {
        let disc = project_on_disc(&Vector3::new(x, R::ONE, y), y);
        hash.numbers(disc.iter().copied());
        let outward = Vector3::new(x, y, R::ONE);
        for touch in [
            ContactGeometry::plate(x, &outward, y),
            ContactGeometry::spheres(&outward, [x, y]),
        ] {
            hash.verdict(&touch);
            if let Ok(touch) = touch {
                hash.numbers(touch.normal.iter().copied());
                hash.numbers([touch.gap, touch.lever]);
                hash.numbers(touch.arms);
            }
        }
        let cohesion = Cohesion::new(x, y, Attraction::Pull);
        hash.verdict(&cohesion);
        if let Ok(cohesion) = cohesion {
            hash.numbers([cohesion.energy(), cohesion.strength(), cohesion.range()]);
            hash.feed(u64::from(cohesion.attraction() == Attraction::Pull));
            let law = NormalLaw::new(cohesion, x);
            hash.maybe(law.ok().map(|law| law.restitution()));
            hash.maybe(law.ok().map(|law| law.cohesion().range()));
        }
        hash.verdict(&IndependentFriction::sliding_torsion(x, y));
        hash.maybe(TimeStep::new(x).ok().map(TimeStep::dt));
    }
}

/// Steps of the manifold in each precision.
const STEPS: usize = 2000;

/// Digest of a manifold of three spheres on a plate, f64 and f32.
pub fn manifold() -> u64 {
    let mut hash = Fnv::new();
    let usual = |mu| LimitEllipsoid::new(mu, 0.25, 0.5).expect("in range");
    let friction = CoupledFriction::all(usual(0.5_f64), 0.125).expect("in range");
    pile(&mut hash, friction, STEPS / 4);
    pile(
        &mut hash,
        IndependentFriction::all(0.5_f32, 0.125, 0.25).expect("in range"),
        STEPS,
    );
    hash.0
}

/// A plate shakes under one ball, which carries another, while forces vary.
fn pile<R: Real, F: ContactFriction<R>>(hash: &mut Fnv, friction: F, steps: usize) {
    let real = R::from_f64;
    let law = NormalLaw::new(Cohesion::NONE, real(0.125)).expect("in range");
    let mut pile = ContactSystem::<R, F, 3, 2>::new(law, friction);
    let mut rng = Lcg::new(163);
    let velocity = Vector3::new(R::ZERO, R::ZERO, R::ZERO);
    let inv_mass = R::HALF;
    let plate = pile
        .push_plate(WallBody { velocity, inv_mass })
        .expect("room");
    let balls = [(); 2].map(|()| pile.push_sphere(sphere(&mut rng, R::ONE)).expect("room"));
    pile.set_gravity(Vector3::new(R::ZERO, real(0.25), -R::ONE));
    let step = TimeStep::new(real(0.0625)).expect("positive");
    let up = Vector3::new(R::ZERO, R::ZERO, R::ONE);
    let resting = ContactGeometry::plate(R::ONE, &-up, R::ONE).expect("they touch");
    let below = pile.push_contact(balls[0], plate, resting).expect("room");
    let between = ContactGeometry::spheres(&(up * real(2.03125)), [R::ONE; 2]).expect("apart");
    let above = pile
        .push_contact(balls[0], balls[1], between)
        .expect("room");
    for count in 0..steps {
        // Forces that keep the pile together, and twist it.
        let sway = Vector3::from([(); 3].map(|()| signed::<R>(&mut rng) / real(1_048_576.0)));
        pile.set_force(plate, up * real(3.0) + sway, velocity)
            .expect("it is there");
        pile.set_force(balls[1], -up, sway).expect("it is there");
        let gap = real((count % 5) as f64 / 32.0 - 0.0625);
        pile.set_geometry(above, ContactGeometry { gap, ..between })
            .expect("it is there");
        let start = [InitialGuess::Last, InitialGuess::Zero][usize::from(count % 7 == 0)];
        let stop = SolverSettings {
            max_iterations: 4,
            tolerance: real(0.0009765625),
        };
        let report = pile.solve(step, start, stop);
        hash.number(report.residual);
        hash.feed(u64::from(report.iterations) | u64::from(report.converged) << 32);
        for contact in [below, above] {
            let force = pile.force(contact).expect("it is there");
            hash.numbers(components(&force));
        }
        if let Some(SystemBody::Sphere(ball)) = pile.body_mut(balls[1]) {
            // Air takes a little of the spin.
            ball.spin *= real(0.96875);
        }
    }
    members(hash, &pile, [plate, balls[0], balls[1]]);
    let told = pile.contact(below).map(|contact| contact.bound());
    hash.maybe(told);
    pile.clear_contacts();
    hash.maybe(pile.contact(below).map(|contact| contact.bound()));
    let radius = speed(&mut rng);
    let full = pile.push_sphere(sphere(&mut rng, radius));
    hash.verdict(&full);
}

fn members<R, F>(hash: &mut Fnv, pile: &ContactSystem<R, F, 3, 2>, bodies: [BodyHandle; 3])
where
    R: Real,
    F: ContactFriction<R>,
{
    for member in bodies.into_iter().filter_map(|body| pile.body(body)) {
        hash.numbers(member.velocity().iter().copied());
        hash.numbers(member.angular_velocity().iter().copied());
        hash.numbers([member.inv_mass_normal(), member.inv_mass_tangential()]);
        hash.number(member.inv_inertia());
    }
    hash.verdict(&TimeStep::new(ends::<R>()[0]));
}
