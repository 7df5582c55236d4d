//! Contacts that open, slide, roll and spin, alone and in a manifold.

use super::{Keeper, keep};
use tribos_core::Real;
use tribos_core::contact::{
    AllModes, Body, Cohesion, Contact, ContactFriction, ContactModes, CoupledFriction,
    Frictionless, Modal, NormalLaw, Plate, Sliding, SlidingRolling, SlidingTorsion, Sphere,
    Thresholds, TimeStep, Touch,
};
use tribos_core::coupling::table::{Coulomb, CoulombTable};
use tribos_core::internals::Masses;
use tribos_core::internals::{
    AboutNormal, Absent, AxialPart, Block, InPlane, PlanarPart, project_on_disc,
};
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use tribos_core::manifold::{Manifold, Member};

/// Contacts of one precision.
pub fn all<R: CoulombTable>(keeper: &mut impl Keeper) {
    parts::<R>(keeper);
    thresholds::<R>(keeper);
    body::<R, Sphere<R>>(keeper);
    body::<R, Plate<R>>(keeper);
    body::<R, Member<R>>(keeper);
    planar::<R, Absent>(keeper);
    planar::<R, InPlane<R>>(keeper);
    axial::<R, Absent>(keeper);
    axial::<R, AboutNormal<R>>(keeper);
    friction::<R, Thresholds<R, Frictionless>>(keeper);
    friction::<R, Thresholds<R, Sliding>>(keeper);
    friction::<R, Thresholds<R, SlidingTorsion>>(keeper);
    friction::<R, Thresholds<R, SlidingRolling>>(keeper);
    friction::<R, Thresholds<R, AllModes>>(keeper);
    coupled::<R, LimitSurface<R, Coulomb>>(keeper);
    coupled::<R, Ellipsoid<R>>(keeper);
}

fn parts<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Touch::<R>::spheres,
        Touch::<R>::plate,
        TimeStep::<R>::new,
        TimeStep::<R>::dt,
        Cohesion::<R>::new,
        Cohesion::<R>::strength,
        Cohesion::<R>::range,
        Cohesion::<R>::attraction,
        Cohesion::<R>::energy,
        NormalLaw::<R>::new,
        NormalLaw::<R>::cohesion,
        NormalLaw::<R>::restitution,
        Block::<R>::masses,
        Masses::<R>::gyration,
        project_on_disc::<R>,
        <InPlane<R> as Default>::default,
    );
    keep!(keeper: Block::<R>::new => fn(&Touch<R>, &Sphere<R>, &Plate<R>) -> Block<R>);
    keep!(keeper: Block::<R>::new => fn(&Touch<R>, &Sphere<R>, &Sphere<R>) -> Block<R>);
}

fn thresholds<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Thresholds::<R, Frictionless>::none,
        Thresholds::<R, Sliding>::sliding,
        Thresholds::<R, SlidingTorsion>::sliding_torsion,
        Thresholds::<R, SlidingRolling>::sliding_rolling,
        Thresholds::<R, AllModes>::all,
        Thresholds::<R, AllModes>::mu,
        Thresholds::<R, AllModes>::mu_rolling,
        Thresholds::<R, AllModes>::mu_torsion,
    );
}

fn body<R: Real, B: Body<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <B as Body<R>>::velocity,
        <B as Body<R>>::spin,
        <B as Body<R>>::inv_mass_normal,
        <B as Body<R>>::inv_mass_tangential,
        <B as Body<R>>::inv_inertia,
        <B as Body<R>>::push,
        <B as Body<R>>::turn,
    );
}

fn planar<R: Real, P: PlanarPart<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: <P as PlanarPart<R>>::vector, <P as PlanarPart<R>>::of);
}

fn axial<R: Real, P: AxialPart<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: <P as AxialPart<R>>::component, <P as AxialPart<R>>::of);
}

/// One set of modes: the set, a contact under it, a manifold of such.
fn friction<R: Real, F: ContactFriction<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <F as ContactFriction<R>>::hold,
        <F as ContactFriction<R>>::hold_rolling,
        Contact::<R, F::Modes>::admit::<F>,
    );
    modal::<R, F::Modes>(keeper);
    contact::<R, F::Modes>(keeper);
    between::<R, F, Sphere<R>, Sphere<R>>(keeper);
    between::<R, F, Sphere<R>, Plate<R>>(keeper);
    manifold::<R, F>(keeper);
}

fn modal<R: Real, M: ContactModes<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Modal::<R, M>::new,
        Modal::<R, M>::sliding,
        Modal::<R, M>::rolling,
        Modal::<R, M>::torsion,
        Modal::<R, M>::plus_scaled,
        Modal::<R, M>::minus,
        Modal::<R, M>::dot,
        Modal::<R, M>::dot_with_lever,
        Modal::<R, M>::linear,
        Modal::<R, M>::angular,
    );
}

fn contact<R: Real, M: ContactModes<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Contact::<R, M>::prepared,
        Contact::<R, M>::resume,
        Contact::<R, M>::arms,
        Contact::<R, M>::normal,
        Contact::<R, M>::lever,
        Contact::<R, M>::block,
        Contact::<R, M>::cohesion,
        Contact::<R, M>::allowance,
        Contact::<R, M>::rests_open,
        Contact::<R, M>::impulse,
        Contact::<R, M>::bound,
        Contact::<R, M>::set_impulse,
        Contact::<R, M>::set_impulse_in_plane,
    );
}

fn between<R: Real, F: ContactFriction<R>, A: Body<R>, B: Body<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: Contact::<R, F::Modes>::new
        => fn(&Touch<R>, &NormalLaw<R>, &A, &B, R) -> Contact<R, F::Modes>);
    keep!(keeper: Contact::<R, F::Modes>::velocity
        => fn(&Contact<R, F::Modes>, &A, &B) -> Modal<R, F::Modes>);
    keep!(keeper: Contact::<R, F::Modes>::apply
        => fn(&Contact<R, F::Modes>, &Modal<R, F::Modes>, &mut A, &mut B));
    keep!(keeper: Contact::<R, F::Modes>::update::<F>
        => fn(&mut Contact<R, F::Modes>, &F, &mut A, &mut B) -> Modal<R, F::Modes>);
}

fn coupled<R: Real, S: FrictionSet<R> + Copy + Send + Sync>(keeper: &mut impl Keeper) {
    keep!(keeper:
        CoupledFriction::<R, S, SlidingTorsion>::sliding_torsion,
        CoupledFriction::<R, S, AllModes>::all,
        CoupledFriction::<R, S, AllModes>::set,
        CoupledFriction::<R, S, AllModes>::mu,
        CoupledFriction::<R, S, AllModes>::mu_rolling,
        CoupledFriction::<R, S, AllModes>::mu_torsion,
    );
    friction::<R, CoupledFriction<R, S, SlidingTorsion>>(keeper);
    friction::<R, CoupledFriction<R, S, AllModes>>(keeper);
}

fn manifold<R: Real, F: ContactFriction<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Manifold::<R, F, 3, 2>::new,
        Manifold::<R, F, 3, 2>::push_sphere,
        Manifold::<R, F, 3, 2>::push_plate,
        Manifold::<R, F, 3, 2>::push_contact,
        Manifold::<R, F, 3, 2>::set_gravity,
        Manifold::<R, F, 3, 2>::set_force,
        Manifold::<R, F, 3, 2>::set_touch,
        Manifold::<R, F, 3, 2>::clear_contacts,
        Manifold::<R, F, 3, 2>::body,
        Manifold::<R, F, 3, 2>::body_mut,
        Manifold::<R, F, 3, 2>::contact,
        Manifold::<R, F, 3, 2>::force,
        Manifold::<R, F, 3, 2>::solve,
    );
}
