//! Bits of contacts at nodes, limit surfaces and laws with memory.

use crate::ARGUMENTS;
use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, speed};
use tribos_core::coupling::closed::CoulombRing;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{DryReducedFriction, table};
use tribos_core::law::{
    AgeingLaw, Bristle, DryFriction, LocalLaw, LuGre, LuGreParameters, PlateauPowerLaw,
    PlateauPowerLawParameters, RateState, RateStateParameters, SlipLaw, StateVariable, Stribeck,
    StribeckParameters,
};
use tribos_core::limit_surface::{FrictionSet, Projection, Region, RoundLimitSurface};
use tribos_core::patch::nodes::NodeList;
use tribos_core::patch::polar::PolarQuadrature;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Hash of contacts at nodes: a rule for a leaning pressure and a polygon, f64 and f32.
pub fn nodes() -> u64 {
    in_both(nodes_of::<f64>, nodes_of::<f32>)
}

fn nodes_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let rule = PolarQuadrature::new(real(0.5), 8, 16).expect("a rule");
    let rule = rule.with_rim_exponent(R::HALF).expect("in range");
    let disk: NodeList<R, 128> = rule.nodes_tilted(real(0.25), R::ZERO).expect("128 nodes");
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75]].map(|corner| corner.map(real));
    let plate: NodeList<R, 112> = NodeList::polygon(&corners, 4).expect("a triangle");
    let dry = DryFriction::new(real(0.5), real(0.25)).expect("in range");
    let law = Stribeck::new(StribeckParameters {
        dry,
        speed: real(0.125),
        exponent: R::TWO,
        viscous: real(0.0625),
    })
    .expect("in range");
    let mut rng = Lcg::new(37);
    for _ in 0..ARGUMENTS / 20 {
        let [x, y, spin] = [(); 3].map(|()| speed::<R>(&mut rng) - speed::<R>(&mut rng));
        let twist = Twist::new(x, y, spin);
        for patch in [
            &disk as &dyn tribos_core::patch::nodes::NodePatch<R>,
            &plate,
        ] {
            let friction = NodeFriction::new(law, patch);
            let wrench = friction.wrench(real(1.5), &twist);
            for v in [wrench.force.x, wrench.force.y, wrench.torque] {
                hash.number(v);
            }
            for &v in friction.wrench_jacobian(real(1.5), &twist).iter() {
                hash.number(v);
            }
        }
    }
}

/// Hash of gauges, normals and projections, f64 and f32.
pub fn limit_surfaces() -> u64 {
    let mut hash = Fnv::new();
    surface::<f64, _>(&mut hash, table::CoulombDisk);
    surface::<f64, _>(&mut hash, CoulombRing);
    surface::<f32, _>(&mut hash, table::CoulombDisk);
    hash.0
}

fn surface<R: Real, C: DryReducedFriction<R>>(hash: &mut Fnv, coupling: C) {
    let [limit, radius] = [0.75, 0.25].map(R::from_f64);
    let set = RoundLimitSurface::new(coupling, limit, radius).expect("in range");
    let mut rng = Lcg::new(41);
    for _ in 0..ARGUMENTS / 4 {
        let [x, y, torque] = [(); 3].map(|()| speed::<R>(&mut rng) - speed::<R>(&mut rng));
        let push = Wrench::new(x, y, torque);
        let motion = set.twist_normal_to(&push);
        let projection = set.project(&push);
        for v in [
            set.gauge(&push),
            motion.velocity.x,
            motion.velocity.y,
            motion.spin,
            projection.wrench.force.x,
            projection.wrench.force.y,
            projection.wrench.torque,
        ] {
            hash.number(v);
        }
        hash.feed(u64::from(projection.region == Region::Inside));
    }
    batches(hash, &set, &mut rng);
}

/// Batches: gauges, normals and projections, with loads and a length.
fn batches<R: Real, C: DryReducedFriction<R>>(
    hash: &mut Fnv,
    set: &RoundLimitSurface<R, C>,
    rng: &mut Lcg,
) {
    const BATCH: usize = 20;
    for _ in 0..ARGUMENTS / 40 {
        let pushes = [(); BATCH].map(|()| {
            let [x, y, torque] = [(); 3].map(|()| speed::<R>(rng) - speed::<R>(rng));
            Wrench::new(x, y, torque)
        });
        let loads = [(); BATCH].map(|()| speed::<R>(rng));
        let mut gauges = [R::ZERO; BATCH];
        let mut motions = [Twist::ZERO; BATCH];
        let mut nearest = pushes.map(|wrench| Projection {
            wrench,
            region: Region::Inside,
        });
        set.gauge_batch(&loads, &pushes, &mut gauges);
        set.twist_normal_to_batch(&pushes, &mut motions);
        set.project_batch(R::HALF, &loads, &pushes, &mut nearest);
        for gauge in gauges {
            hash.number(gauge);
        }
        for motion in motions {
            hash.number(motion.velocity.x);
            hash.number(motion.spin);
        }
        for projection in nearest {
            hash.number(projection.wrench.force.y);
            hash.number(projection.wrench.torque);
        }
    }
}

/// Hash of local laws and of laws with memory, f64 and f32.
pub fn laws() -> u64 {
    in_both(laws_of::<f64>, laws_of::<f32>)
}

fn laws_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let rock = RateStateParameters {
        mu: real(0.6),
        a: real(0.01),
        b: real(0.015),
        reference_speed: real(1e-6),
        slip_distance: real(1e-5),
        viscous: real(0.1),
    };
    let ageing = RateState::<R, AgeingLaw>::new(rock).expect("in range");
    let slip = RateState::<R, SlipLaw>::new(rock).expect("in range");
    let joint = LuGre::new(LuGreParameters {
        coulomb_force: real(1.0),
        static_force: real(1.5),
        stribeck_speed: real(1e-3),
        stiffness: real(1e5),
        bristle_damping: real(316.0),
        viscous_damping: real(0.4),
    });
    let joint = joint.expect("in range");
    let ice = PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha: real(-0.5),
        coefficient: real(0.008),
        plateau_speed: real(1e-4),
        drop_speed: real(1e-7),
        rest_share: R::HALF,
    });
    let ice = ice.expect("in range");
    let mut rng = Lcg::new(43);
    let (mut young, mut old) = (
        StateVariable { theta: R::ONE },
        StateVariable { theta: R::ONE },
    );
    let mut bristle = Bristle::RELAXED;
    for _ in 0..ARGUMENTS {
        let (v, dt) = (speed::<R>(&mut rng), real(1.0 / 1024.0));
        young = ageing.advance(young, v, dt);
        old = slip.advance(old, v, dt);
        let force;
        (bristle, force) = joint.step(bristle, v - R::ONE, dt);
        for x in [
            young.theta,
            old.theta,
            ageing.coefficient(v, young),
            ageing.steady().friction(v),
            bristle.deflection,
            force,
            ice.friction(v),
            ice.slope(v),
        ] {
            hash.number(x);
        }
    }
}
