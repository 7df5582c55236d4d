//! Bits of limit surfaces: every question, every kind of surface, both precisions.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, speed, triples_of_ends, twist};
use nalgebra::Vector2;
use tribos_core::coupling::closed::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::table;
use tribos_core::coupling::{Annulus, DryProfile, DryReducedFriction, compact};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, Region, RoundLimitSurface};
use tribos_core::real::Real;
use tribos_core::twist::Wrench;

/// Digest of limit surfaces, f64 and f32.
pub fn sets() -> u64 {
    in_both(sets_of::<f64>, sets_of::<f32>)
}

fn sets_of<R: Real>(hash: &mut Fnv) {
    exact::<R, _>(hash, table::CoulombDisk, 16);
    exact::<R, _>(hash, compact::CompactCoulombDisk, 2);
    exact::<R, _>(hash, CoulombRing, 2);
    exact::<R, _>(hash, CoulombPunch, 4);
    exact::<R, _>(hash, CoulombHertz, 4);
    exact::<R, _>(hash, DryProfile::new::<R>(CoulombHertz).expect("dry"), 2);
    let annulus = Annulus::new(table::CoulombDisk, R::HALF).expect("in range");
    exact::<R, _>(hash, annulus, 4);
    let [mu, lever, spin] = [0.75, 0.25, 0.125].map(R::from_f64);
    let usual = LimitEllipsoid::new(mu, lever, spin).expect("in range");
    hash.number(usual.torque_limit());
    questions(hash, &usual, 40);
    for (x, y) in pairs_of_ends::<R>().step_by(3) {
        hash.verdict(&RoundLimitSurface::new(CoulombHertz, x, y));
        hash.verdict(&LimitEllipsoid::new(x, y, R::HALF));
        hash.verdict(&LimitEllipsoid::new(R::ONE, x, y));
    }
}

fn exact<R: Real, C: DryReducedFriction<R>>(hash: &mut Fnv, coupling: C, count: usize) {
    let [limit, radius] = [0.75, 0.25].map(R::from_f64);
    let set = RoundLimitSurface::new(coupling, limit, radius).expect("in range");
    hash.numbers([set.torque_limit(), set.force_limit(), set.radius()]);
    hash.number(set.coupling().reduced_wrench(R::ONE, R::HALF).force);
    let inner = set.ellipsoid();
    hash.maybe(inner.ok().map(|inner| inner.torque_limit()));
    questions(hash, &set, count);
}

/// All that can be asked of a set, about pushes near it, far from it and at the ends.
pub(crate) fn questions<R: Real, S: FrictionSet<R>>(hash: &mut Fnv, set: &S, count: usize) {
    hash.numbers([set.force_limit(), set.radius()]);
    let mut rng = Lcg::new(151);
    let every = 4096 / count;
    for motion in (0..count).map(|_| twist::<R>(&mut rng)) {
        hash.number(set.support(&motion));
        let met = set.wrench(&motion);
        hash.wrench(&met);
        // The set's own answers, and pushes of its size.
        push(hash, set, &met);
        let (force, torque) = (Vector2::new(motion.spin, met.force.y), met.torque);
        push(hash, set, &Wrench { force, torque });
        let [x, y, torque] =
            [motion.velocity.x, motion.velocity.y, motion.spin].map(|x| x / (R::ONE + x.abs()));
        let force = Vector2::new(x, y);
        push(hash, set, &Wrench { force, torque });
    }
    for [x, y, torque] in triples_of_ends(every) {
        let force = Vector2::new(x, y);
        push(hash, set, &Wrench { force, torque });
    }
    for motion in crate::planes::ends_of_twists(every) {
        hash.number(set.support(&motion));
        hash.wrench(&set.wrench(&motion));
    }
    for length in ends() {
        let force = Vector2::new(R::ONE, R::TWO);
        let torque = speed(&mut rng);
        hash.wrench(
            &set.project_with_length(&Wrench { force, torque }, length)
                .wrench,
        );
    }
}

fn push<R: Real, S: FrictionSet<R>>(hash: &mut Fnv, set: &S, at: &Wrench<R>) {
    hash.number(set.gauge(at));
    hash.feed(u64::from(set.contains(at)));
    hash.twist(&set.twist_normal_to(at));
    hash.twist(&set.twist_resisted_by(at));
    hash.wrench(&set.scale_to_surface(at));
    let near = set.project(at);
    hash.wrench(&near.wrench);
    match near.region {
        Region::Inside => hash.feed(0),
        Region::OnSurface { normal } => hash.twist(&normal),
    }
    hash.wrench(&set.project_with_length(at, R::TWO).wrench);
}
