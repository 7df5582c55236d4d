//! Contacts of spheres and plates, one or a few at a time.

use crate::{Input, Verdict};
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, Contact, ContactBody, ContactFriction, ContactGeometry,
    ContactModes, ContactVector, CoupledFriction, IndependentFriction, NormalLaw, SphereBody,
    TimeStep, WallBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::internals::{InPlane, Masses, TangentialLoad, project_on_disc};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::manifold::{ContactSystem, InitialGuess, SolverSettings, SystemBody};
use tribos_core::real::Real;

/// One update of one contact under one friction.
pub fn contacts<R: Real>(input: &mut Input<'_>) -> Verdict {
    let [mu, rolling, torsion] = [(); 3].map(|()| input.size::<R>());
    match input.below(8) {
        0 => updated::<R, _>(input, &IndependentFriction::none()),
        1 => {
            let law = input.taken(IndependentFriction::sliding(mu))?;
            updated(input, &law)
        }
        2 => {
            let law = input.taken(IndependentFriction::sliding_torsion(mu, torsion))?;
            updated(input, &law)
        }
        3 => {
            let law = input.taken(IndependentFriction::sliding_rolling(mu, rolling))?;
            updated(input, &law)
        }
        4 => {
            let law = input.taken(IndependentFriction::all(mu, rolling, torsion))?;
            let own = [law.mu(), law.mu_rolling(), law.mu_torsion()];
            input.holds(own == [mu, rolling, torsion], "coefficients are kept", &own)?;
            updated(input, &law)
        }
        5 => {
            let set = RoundLimitSurface::new(CoulombDisk, mu, input.positive());
            let set = input.taken(set)?;
            updated(input, &CoupledFriction::sliding_torsion(set))
        }
        6 => {
            let set = RoundLimitSurface::new(CoulombDisk, mu, input.positive());
            let set = input.taken(set)?;
            let law = input.taken(CoupledFriction::all(set, rolling))?;
            updated(input, &law)
        }
        _ => {
            let set = LimitEllipsoid::new(mu, input.positive(), input.positive());
            let set = input.taken(set)?;
            let law = input.taken(CoupledFriction::all(set, rolling))?;
            let own = [law.mu(), law.mu_rolling(), law.mu_torsion()];
            let is_kept = own[0] == law.set().force_limit() && own[1] == rolling;
            input.holds(is_kept, "coefficients are kept", &own)?;
            updated(input, &law)
        }
    }
}

fn sphere<R: Real>(input: &mut Input<'_>) -> SphereBody<R> {
    SphereBody {
        velocity: input.vector(),
        spin: input.vector(),
        inv_mass: input.size(),
        inv_inertia: input.size(),
    }
}

fn plate<R: Real>(input: &mut Input<'_>) -> WallBody<R> {
    WallBody {
        velocity: input.vector(),
        inv_mass: input.size(),
    }
}

fn normal_law<R: Real>(input: &mut Input<'_>) -> Verdict<NormalLaw<R>> {
    let attraction = input.one_of(&[Attraction::Pull, Attraction::Resistance]);
    let cohesion = match input.below(2) {
        0 => Cohesion::NONE,
        _ => {
            let given = [input.size(), input.size()];
            let cohesion = input.taken(Cohesion::new(given[0], given[1], attraction))?;
            let is_kept = [cohesion.strength(), cohesion.range()] == given;
            let is_kept = is_kept && cohesion.attraction() == attraction;
            input.holds(is_kept, "cohesion is kept", &given)?;
            input.give([cohesion.energy()]);
            cohesion
        }
    };
    let restitution = if input.one_in(2) {
        R::ZERO
    } else {
        input.unit()
    };
    let law = input.taken(NormalLaw::new(cohesion, restitution))?;
    let is_kept = law.restitution() == restitution && *law.cohesion() == cohesion;
    input.holds(is_kept, "a normal law is kept", &[restitution])?;
    Ok(law)
}

fn updated<R: Real, F: ContactFriction<R>>(input: &mut Input<'_>, friction: &F) -> Verdict {
    let law = normal_law::<R>(input)?;
    if let Some(limits) = friction.independent_limits() {
        let resist = limits.iter().all(|limit| *limit >= R::ZERO);
        input.holds(resist, "coefficients ≥ 0", &limits)?;
    }
    held(input, friction);
    let (across, radius) = (input.vector(), input.positive::<R>());
    let mut a = sphere::<R>(input);
    let dt = input.positive();
    if input.one_in(2) {
        let touch = ContactGeometry::spheres(&across, [radius, input.positive()]);
        let touch = input.taken(touch)?;
        let mut b = sphere(input);
        between(input, friction, &law, &touch, dt, &mut a, &mut b)
    } else {
        // The direction of a pair of spheres is the plate's unit normal.
        let aside = input.taken(ContactGeometry::spheres(&across, [R::ONE; 2]))?;
        let touch = ContactGeometry::plate(input.number(), &aside.normal, radius);
        let touch = input.taken(touch)?;
        let mut b = plate(input);
        between(input, friction, &law, &touch, dt, &mut a, &mut b)
    }
}

/// What friction holds of a load, and the disc of rolling.
fn held<R: Real, F: ContactFriction<R>>(input: &mut Input<'_>, friction: &F) {
    let (sliding, torsion) = (input.vector(), input.number());
    let masses = Masses {
        sliding: input.positive(),
        torsion: input.positive(),
    };
    let (bound, lever) = (input.size(), input.positive());
    let load = TangentialLoad { sliding, torsion };
    let hold = friction.hold(&load, bound, lever, &masses);
    input.give(hold.sliding.iter().copied());
    input.give([hold.torsion]);
    input.give(
        friction
            .hold_rolling(&sliding, bound, lever)
            .iter()
            .copied(),
    );
    input.give(project_on_disc(&sliding, bound).iter().copied());
    input.give(InPlane::<R>::default().0.iter().copied());
}

fn between<R: Real, F: ContactFriction<R>, B: ContactBody<R>>(
    input: &mut Input<'_>,
    friction: &F,
    law: &NormalLaw<R>,
    touch: &ContactGeometry<R>,
    dt: R,
    a: &mut SphereBody<R>,
    b: &mut B,
) -> Verdict {
    let normal = touch.normal;
    let unit = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
    let close = (unit - R::ONE).abs() <= R::from_f64(16.0) * R::EPSILON;
    input.holds(close, "a unit normal", &[normal.x, normal.y, normal.z])?;
    input.give([touch.gap, touch.lever].into_iter().chain(touch.arms));
    let mut contact: Contact<R, F::Modes> = Contact::new(touch, law, a, b, dt);
    for _ in 0..2 {
        contact.update(friction, a, b);
    }
    let impulse = *contact.impulse();
    input.finite("impulse", components(&impulse))?;
    input.finite("velocity after a contact", a.velocity.iter().copied())?;
    told(input, &contact, a, b);
    if input.is_mild() {
        input.holds(
            contact.bound() >= R::ZERO,
            "bound ≥ 0",
            &[contact.bound(), impulse.normal],
        )?;
    }
    // Warm start, and application of the impulse to the sphere.
    contact.set_impulse(&impulse);
    contact.project_impulse(friction);
    contact.set_impulse_in_plane(&impulse.plus_scaled(R::HALF, &impulse));
    contact.apply(&impulse, a, b);
    input.finite("impulse", components(contact.impulse()))?;
    let resumed: Contact<R, F::Modes> = Contact::resume(&contact.prepared(), contact.impulse());
    let same = resumed.impulse() == contact.impulse();
    input.holds(
        same || !input.is_mild(),
        "a resumed contact is the same",
        &components(resumed.impulse()),
    )
}

/// What a contact tells beside its impulse.
fn told<R: Real, M: ContactModes<R>, B: ContactBody<R>>(
    input: &mut Input<'_>,
    contact: &Contact<R, M>,
    a: &SphereBody<R>,
    b: &B,
) {
    let (impulse, normal) = (contact.impulse(), contact.normal());
    let motion = contact.velocity(a, b);
    input.give(components(&motion.minus(impulse)));
    let lever = contact.effective_radius();
    input.give([motion.dot(impulse), motion.dot_with_lever(impulse, lever)]);
    input.give(impulse.linear(normal).iter().copied());
    input.give(impulse.angular(normal).iter().copied());
    let block = contact.block();
    input.give([block.mass_normal, block.mass_sliding, block.inertia]);
    input.give([block.coupling, block.masses().gyration()]);
    input.give([
        contact.bound(),
        contact.cohesion(),
        contact.approach_limit(),
    ]);
    input.give(contact.centre_distances());
    input.give_bits(u64::from(contact.holds_gap_open()));
    input.give(a.spin.iter().copied());
    input.give([
        b.inv_mass_normal(),
        b.inv_mass_tangential(),
        b.inv_inertia(),
    ]);
    input.give([
        a.inv_mass_normal(),
        a.inv_mass_tangential(),
        a.inv_inertia(),
    ]);
}

fn components<R: Real, M: ContactModes<R>>(modal: &ContactVector<R, M>) -> [R; 8] {
    let (s, r) = (modal.sliding(), modal.rolling());
    let torsion = modal.torsion();
    [modal.normal, s.x, s.y, s.z, r.x, r.y, r.z, torsion]
}

/// Three bodies with up to three contacts, over several steps.
pub fn manifold<R: Real>(input: &mut Input<'_>) -> Verdict {
    let [mu, rolling, torsion] = [(); 3].map(|()| input.size::<R>());
    if input.one_in(2) {
        let set = RoundLimitSurface::new(CoulombDisk, mu, input.positive());
        let set = input.taken(set)?;
        let friction = input.taken(CoupledFriction::all(set, rolling))?;
        return system(input, friction);
    }
    let friction = IndependentFriction::<R, AllModes>::all(mu, rolling, torsion);
    let friction = input.taken(friction)?;
    system(input, friction)
}

fn system<R: Real, F: ContactFriction<R>>(input: &mut Input<'_>, friction: F) -> Verdict {
    let law = normal_law(input)?;
    let step = TimeStep::new(input.positive());
    let step = input.taken(step)?;
    let mut pile = ContactSystem::<R, _, 3, 3>::new(law, friction);
    let room = "room for a body";
    let balls = [(); 2].map(|()| pile.push_sphere(sphere(input)).ok());
    let [a, b] = [
        input.present(room, balls[0])?,
        input.present(room, balls[1])?,
    ];
    let floor = pile.push_plate(plate(input)).ok();
    let floor = input.present(room, floor)?;
    let is_full = pile.push_plate(plate(input)).is_err();
    input.holds(is_full, "a full manifold refuses", &[step.dt()])?;
    let mut last = None;
    for (one, other) in [(a, b), (a, floor), (b, floor)] {
        let radii = [input.positive(), input.positive()];
        let touch = ContactGeometry::spheres(&input.vector(), radii);
        if let Ok(touch) = input.taken(touch) {
            let contact = pile.push_contact(one, other, touch).ok();
            let contact = input.present("room for a contact", contact)?;
            last = Some((contact, touch));
        }
    }
    pile.set_gravity(input.vector());
    let set = pile.set_force(a, input.vector(), input.vector());
    input.present("a body that is pushed", set.ok())?;
    let stop = SolverSettings {
        max_iterations: input.below(8) as u32,
        tolerance: input.size(),
    };
    for start in [InitialGuess::Zero, InitialGuess::Last] {
        let report = pile.solve(step, start, stop);
        let is_bounded = report.iterations <= stop.max_iterations.max(1);
        input.holds(is_bounded, "bounded sweeps", &[report.residual])?;
        input.give_bits(u64::from(report.iterations) | u64::from(report.converged) << 32);
        let Some((contact, touch)) = last else {
            continue;
        };
        let force = input.present("force of a contact", pile.force(contact))?;
        input.give(components(&force));
        let gap = input.number();
        let set = pile.set_geometry(contact, ContactGeometry { gap, ..touch });
        input.present("a contact that moves", set.ok())?;
        let solved = input.present("a contact that was solved", pile.contact(contact))?;
        input.give([solved.bound()]);
    }
    for body in [a, b, floor] {
        if let Some(SystemBody::Sphere(ball)) = pile.body_mut(body) {
            ball.spin *= R::HALF;
        }
        let member = input.present("a body", pile.body(body))?;
        input.finite("velocity in a manifold", member.velocity().iter().copied())?;
        input.give(member.angular_velocity().iter().copied());
        input.give([member.inv_mass_normal(), member.inv_mass_tangential()]);
        input.give([member.inv_inertia()]);
    }
    pile.clear_contacts();
    let is_gone = last.is_none_or(|(contact, _)| pile.contact(contact).is_none());
    input.holds(is_gone, "contacts are cleared", &[step.dt()])
}
