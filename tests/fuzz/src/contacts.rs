//! Contacts of spheres and plates, one or a few at a time.

use super::check::{finite, holds};
use super::{Broken, Source};
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, Contact, ContactBody, ContactFriction, ContactGeometry,
    ContactModes, ContactVector, CoupledFriction, IndependentFriction, NormalLaw, SphereBody,
    TimeStep, WallBody,
};
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_core::manifold::{ContactSystem, InitialGuess, SolverSettings};
use tribos_core::real::Real;

/// One update of one contact under one friction.
pub fn contacts(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        of::<f64>(source)
    } else {
        of::<f32>(source)
    }
}

fn of<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let [mu, rolling, torsion] = [(); 3].map(|()| source.size::<R>());
    match source.below(7) {
        0 => updated::<R, _>(source, &IndependentFriction::none()),
        1 => IndependentFriction::sliding(mu).map_or(Ok(()), |law| updated(source, &law)),
        2 => IndependentFriction::sliding_torsion(mu, torsion)
            .map_or(Ok(()), |law| updated(source, &law)),
        3 => IndependentFriction::sliding_rolling(mu, rolling)
            .map_or(Ok(()), |law| updated(source, &law)),
        4 => IndependentFriction::all(mu, rolling, torsion)
            .map_or(Ok(()), |law| updated(source, &law)),
        5 => {
            let set = RoundLimitSurface::new(CoulombDisk, mu, source.positive());
            set.map_or(Ok(()), |set| {
                updated(source, &CoupledFriction::sliding_torsion(set))
            })
        }
        _ => {
            let set = LimitEllipsoid::new(mu, source.positive(), source.positive());
            let Ok(set) = set else {
                return Ok(());
            };
            CoupledFriction::all(set, rolling).map_or(Ok(()), |law| updated(source, &law))
        }
    }
}

fn sphere<R: Real>(source: &mut Source) -> SphereBody<R> {
    SphereBody {
        velocity: source.vector(),
        spin: source.vector(),
        inv_mass: source.size(),
        inv_inertia: source.size(),
    }
}

fn plate<R: Real>(source: &mut Source) -> WallBody<R> {
    WallBody {
        velocity: source.vector(),
        inv_mass: source.size(),
    }
}

fn normal_law<R: Real>(source: &mut Source) -> Option<NormalLaw<R>> {
    let attraction = source.one_of(&[Attraction::Pull, Attraction::Resistance]);
    let cohesion = match source.below(2) {
        0 => Cohesion::NONE,
        _ => Cohesion::new(source.size(), source.size(), attraction).ok()?,
    };
    let restitution = if source.one_in(2) {
        R::ZERO
    } else {
        source.unit()
    };
    NormalLaw::new(cohesion, restitution).ok()
}

fn updated<R: Real, F: ContactFriction<R>>(
    source: &mut Source,
    friction: &F,
) -> Result<(), Broken> {
    let Some(law) = normal_law::<R>(source) else {
        return Ok(());
    };
    if let Some(limits) = friction.independent_limits() {
        let resist = limits.iter().all(|limit| *limit >= R::ZERO);
        holds(resist, "coefficients ≥ 0", &limits)?;
    }
    let (across, radius) = (source.vector(), source.positive::<R>());
    let mut a = sphere::<R>(source);
    let dt = source.positive();
    if source.one_in(2) {
        let Ok(touch) = ContactGeometry::spheres(&across, [radius, source.positive()]) else {
            return Ok(());
        };
        let mut b = sphere(source);
        between(source, friction, &law, &touch, dt, &mut a, &mut b)
    } else {
        // The direction of a pair of spheres is the plate's unit normal.
        let Ok(aside) = ContactGeometry::spheres(&across, [R::ONE; 2]) else {
            return Ok(());
        };
        let Ok(touch) = ContactGeometry::plate(source.number(), &aside.normal, radius) else {
            return Ok(());
        };
        let mut b = plate(source);
        between(source, friction, &law, &touch, dt, &mut a, &mut b)
    }
}

fn between<R: Real, F: ContactFriction<R>, B: ContactBody<R>>(
    source: &mut Source,
    friction: &F,
    law: &NormalLaw<R>,
    touch: &ContactGeometry<R>,
    dt: R,
    a: &mut SphereBody<R>,
    b: &mut B,
) -> Result<(), Broken> {
    let normal = touch.normal;
    let unit = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
    let close = (unit - R::ONE).abs() <= R::from_f64(16.0) * R::EPSILON;
    holds(close, "a unit normal", &[normal.x, normal.y, normal.z])?;
    let mut contact: Contact<R, F::Modes> = Contact::new(touch, law, a, b, dt);
    for _ in 0..2 {
        contact.update(friction, a, b);
    }
    let impulse = *contact.impulse();
    finite(source, "impulse", components(&impulse))?;
    finite(
        source,
        "velocity after a contact",
        a.velocity.iter().copied(),
    )?;
    if source.is_mild() {
        holds(
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
    finite(source, "impulse", components(contact.impulse()))?;
    let resumed: Contact<R, F::Modes> = Contact::resume(&contact.prepared(), contact.impulse());
    let same = resumed.impulse() == contact.impulse();
    holds(
        same || !source.is_mild(),
        "a resumed contact is the same",
        &components(resumed.impulse()),
    )
}

fn components<R: Real, M: ContactModes<R>>(modal: &ContactVector<R, M>) -> [R; 8] {
    let (s, r) = (modal.sliding(), modal.rolling());
    let torsion = modal.torsion();
    [modal.normal, s.x, s.y, s.z, r.x, r.y, r.z, torsion]
}

/// Three bodies with up to three contacts, over several steps.
pub fn manifolds(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        manifold::<f64>(source)
    } else {
        manifold::<f32>(source)
    }
}

fn manifold<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let [mu, rolling, torsion] = [(); 3].map(|()| source.size::<R>());
    let (Some(law), Ok(friction)) = (
        normal_law(source),
        IndependentFriction::<R, AllModes>::all(mu, rolling, torsion),
    ) else {
        return Ok(());
    };
    let Ok(step) = TimeStep::new(source.positive()) else {
        return Ok(());
    };
    let mut pile = ContactSystem::<R, _, 3, 3>::new(law, friction);
    let bodies = [
        pile.push_sphere(sphere(source)),
        pile.push_sphere(sphere(source)),
        pile.push_plate(plate(source)),
    ];
    let [Ok(a), Ok(b), Ok(floor)] = bodies else {
        return Err("three bodies have no room for three".into());
    };
    holds(
        pile.push_plate(plate(source)).is_err(),
        "a full manifold refuses",
        &[mu],
    )?;
    for (one, other) in [(a, b), (a, floor), (b, floor)] {
        let radii = [source.positive(), source.positive()];
        if let Ok(touch) = ContactGeometry::spheres(&source.vector(), radii) {
            let _ = pile.push_contact(one, other, touch);
        }
    }
    pile.set_gravity(source.vector());
    let _ = pile.set_force(a, source.vector(), source.vector());
    let stop = SolverSettings {
        max_iterations: source.below(8) as u32,
        tolerance: source.size(),
    };
    for start in [InitialGuess::Zero, InitialGuess::Last] {
        let report = pile.solve(step, start, stop);
        holds(
            report.iterations <= stop.max_iterations.max(1),
            "bounded sweeps",
            &[report.residual],
        )?;
    }
    for body in [a, b, floor] {
        let member = pile.body(body).ok_or("a body is gone")?;
        finite(
            source,
            "velocity in a manifold",
            member.velocity().iter().copied(),
        )?;
    }
    Ok(())
}
