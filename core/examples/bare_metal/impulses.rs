//! Contacts that open, slide, roll and spin.

use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, AxialPart, Body, Cohesion, Contact, ContactFriction, CoupledFriction, Modal, Modes,
    NormalLaw, PlanarPart, Plate, Sphere, Thresholds, TimeStep, Touch,
};
use tribos_core::coupling::table::{Coulomb, CoulombTable};
use tribos_core::limit_surface::{Ellipsoid, LimitSurface};
use tribos_core::manifold::{Manifold, Start, Stop};

/// All sets of modes under both kinds of attraction, the coupled sets, and a manifold.
pub fn all<R: CoulombTable>(a: R, b: R) -> Option<R> {
    let exact = LimitSurface::new(Coulomb, a, b).ok()?;
    let usual = Ellipsoid::new(a, b, b).ok()?;
    let mut sum = met(Thresholds::none(), a, b)?;
    sum += met(Thresholds::sliding(a).ok()?, a, b)?;
    sum += met(Thresholds::sliding_torsion(a, b).ok()?, a, b)?;
    sum += met(Thresholds::sliding_rolling(a, b).ok()?, a, b)?;
    sum += met(Thresholds::all(a, b, a).ok()?, a, b)?;
    sum += met(CoupledFriction::sliding_torsion(exact), a, b)?;
    sum += met(CoupledFriction::all(exact, b).ok()?, a, b)?;
    sum += met(CoupledFriction::sliding_torsion(usual), a, b)?;
    Some(sum + met(CoupledFriction::all(usual, b).ok()?, a, b)?)
}

/// One contact of unequal spheres, one at a plate, and both in a manifold.
fn met<R: CoulombTable, F: ContactFriction<R>>(friction: F, a: R, b: R) -> Option<R> {
    let mut sum = R::ZERO;
    let moved = Vector3::new(a, b, -a);
    let ball = Sphere {
        velocity: moved,
        spin: -moved,
        inv_mass: a,
        inv_inertia: b,
    };
    let other = Sphere {
        velocity: -moved,
        ..ball
    };
    let wall = Plate {
        velocity: moved,
        inv_mass: R::ZERO,
    };
    let beside = Touch::spheres(&Vector3::new(a, b, a), [a, b]).ok()?;
    let above = Touch::plate(a, &Vector3::new(R::ZERO, R::ZERO, R::ONE), b).ok()?;
    for attraction in [Attraction::Pull, Attraction::Resistance] {
        let law = NormalLaw::new(Cohesion::new(a, b, attraction).ok()?, b).ok()?;
        sum += one(friction, &law, &beside, ball, other, a)
            + one(friction, &law, &above, ball, wall, a);
        let mut manifold = Manifold::<R, F, 3, 2>::new(law, friction);
        let first = manifold.push_sphere(ball).ok()?;
        let second = manifold.push_sphere(other).ok()?;
        let floor = manifold.push_plate(wall).ok()?;
        let contact = manifold.push_contact(first, second, beside).ok()?;
        manifold.push_contact(first, floor, above).ok()?;
        manifold.set_gravity(moved);
        manifold.set_force(floor, moved, moved).ok()?;
        let stop = Stop {
            sweeps: 5,
            tolerance: b,
        };
        let report = manifold.solve(TimeStep::new(a).ok()?, Start::Last, stop);
        manifold.set_touch(contact, beside).ok()?;
        sum +=
            report.residual + manifold.force(contact)?.normal + manifold.body(first)?.velocity().x;
        manifold.clear_contacts();
    }
    Some(sum)
}

fn one<R: CoulombTable, F: ContactFriction<R>>(
    friction: F,
    law: &NormalLaw<R>,
    touch: &Touch<R>,
    mut first: impl Body<R>,
    mut second: impl Body<R>,
    dt: R,
) -> R {
    let mut contact = Contact::new(touch, law, &first, &second, dt);
    contact.set_impulse(&Modal {
        sliding: <F::Modes as Modes<R>>::Sliding::of(first.velocity()),
        ..Modal::default()
    });
    contact.admit(&friction);
    let change = contact.update(&friction, &mut first, &mut second);
    change.normal + change.torsion.component() + change.rolling.vector().x + second.spin().x
}
