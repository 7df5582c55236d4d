//! Contacts of spheres and plates.

use super::stream::{Precision, Range, Stream};
use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactBody, ContactFriction, ContactGeometry, ContactVector,
    CoupledFriction, IndependentFriction, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::RoundLimitSurface;
use tribos_core::real::Real;

/// An impulse in all modes.
#[derive(Clone, Copy)]
struct Impulse<R: Real> {
    normal: R,
    sliding: Vector3<R>,
    rolling: Vector3<R>,
    torsion: R,
}

/// All inputs of a contact except its bodies.
struct Case<R: Real> {
    law: NormalLaw<R>,
    dt: R,
    mu: [R; 3],
    start: Impulse<R>,
}

fn sphere<R: Precision>(s: &mut Stream) -> SphereBody<R> {
    SphereBody {
        velocity: s.vector(Range::Mild),
        spin: s.vector(Range::Mild),
        inv_mass: s.draw(Range::Fit),
        inv_inertia: s.draw(Range::Fit),
    }
}

pub fn both<R: Precision>(s: &mut Stream) {
    let p: [R; 11] = s.draws(Range::Fit);
    let (first, second) = (sphere(s), sphere(s));
    let displacement = s.vector(Range::Mild);
    let start = Impulse {
        normal: s.draw(Range::Mild),
        sliding: s.vector(Range::Mild),
        rolling: s.vector(Range::Mild),
        torsion: s.draw(Range::Mild),
    };
    let floor = WallBody {
        velocity: second.velocity,
        inv_mass: p[10],
    };
    let attraction = match s.bits() >> 63 {
        0 => Attraction::Pull,
        _ => Attraction::Resistance,
    };
    let law = Cohesion::new(p[0], p[1], attraction)
        .and_then(|cohesion| NormalLaw::new(cohesion, p[2] / R::TWO));
    let case = law
        .ok()
        .zip(TimeStep::new(p[8]).ok())
        .map(|(law, dt)| Case {
            law,
            dt: dt.dt(),
            mu: [p[3], p[4], p[5]],
            start,
        });

    let touch = ContactGeometry::spheres(&displacement, [p[6], p[7]]);
    met(s, touch.ok(), case.as_ref(), first, second);
    let up = Vector3::new(R::ZERO, R::ZERO, R::ONE);
    let touch = ContactGeometry::plate(p[9], &up, p[6]);
    met(s, touch.ok(), case.as_ref(), first, floor);
}

/// One contact under every kind of friction.
fn met<R: Precision>(
    s: &mut Stream,
    touch: Option<ContactGeometry<R>>,
    case: Option<&Case<R>>,
    a: SphereBody<R>,
    b: impl ContactBody<R> + Fed<R> + Copy,
) {
    let Some(touch) = s.ok(touch.ok_or(())) else {
        return;
    };
    s.numbers(touch.normal.iter().copied());
    s.numbers([touch.gap, touch.arms[0], touch.arms[1], touch.lever]);
    let Some(case) = s.ok(case.ok_or(())) else {
        return;
    };
    let [sliding, rolling, torsion] = case.mu;
    feed_contact(s, &touch, case, &a, &b);
    update(s, Some(IndependentFriction::none()), &touch, case, a, b);
    update(
        s,
        IndependentFriction::sliding(sliding).ok(),
        &touch,
        case,
        a,
        b,
    );
    let both = IndependentFriction::sliding_torsion(sliding, torsion);
    update(s, both.ok(), &touch, case, a, b);
    let both = IndependentFriction::sliding_rolling(sliding, rolling);
    update(s, both.ok(), &touch, case, a, b);
    let all = IndependentFriction::all(sliding, rolling, torsion);
    update(s, all.ok(), &touch, case, a, b);
    let set = RoundLimitSurface::new(CoulombDisk, sliding, torsion);
    let patch = set.map(CoupledFriction::sliding_torsion);
    update(s, patch.ok(), &touch, case, a, b);
}

fn feed_contact<R: Precision>(
    s: &mut Stream,
    touch: &ContactGeometry<R>,
    case: &Case<R>,
    a: &impl ContactBody<R>,
    b: &impl ContactBody<R>,
) {
    type Smooth = tribos_core::contact::Frictionless;
    let contact = Contact::<R, Smooth>::new(touch, &case.law, a, b, case.dt);
    let block = contact.block();
    s.numbers(contact.normal().iter().copied());
    s.numbers(contact.centre_distances());
    s.numbers([
        contact.effective_radius(),
        block.mass_normal,
        block.mass_sliding,
        block.inertia,
        block.coupling,
        contact.cohesion(),
        contact.approach_limit(),
    ]);
    s.feed_bits(contact.holds_gap_open().into());
}

/// One update from the same initial state.
fn update<R: Precision, F: ContactFriction<R>>(
    s: &mut Stream,
    friction: Option<F>,
    touch: &ContactGeometry<R>,
    case: &Case<R>,
    mut a: SphereBody<R>,
    mut b: impl ContactBody<R> + Fed<R>,
) {
    let Some(friction) = s.ok(friction.ok_or(())) else {
        return;
    };
    let mut contact = Contact::<R, F::Modes>::new(touch, &case.law, &a, &b, case.dt);
    let start = &case.start;
    let start = ContactVector::new(start.normal, start.sliding, start.rolling, start.torsion);
    contact.set_impulse_in_plane(&start);
    contact.update(&friction, &mut a, &mut b);
    let impulse = contact.impulse();
    s.number(impulse.normal);
    s.numbers(impulse.sliding().iter().copied());
    s.numbers(impulse.rolling().iter().copied());
    s.number(impulse.torsion());
    a.feed(s);
    b.feed(s);
}

/// A body whose state goes into the hash.
trait Fed<R> {
    fn feed(&self, s: &mut Stream);
}

impl<R: Real> Fed<R> for SphereBody<R> {
    fn feed(&self, s: &mut Stream) {
        s.numbers(self.velocity.iter().copied());
        s.numbers(self.spin.iter().copied());
    }
}

impl<R: Real> Fed<R> for WallBody<R> {
    fn feed(&self, s: &mut Stream) {
        s.numbers(self.velocity.iter().copied());
    }
}
