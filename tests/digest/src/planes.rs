//! Bits of wrenches in the plane in both precisions, upright and leaning, and at the ends.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, arguments, ends, speed, triples_of_ends, twist};
use nalgebra::Vector3;
use tribos_core::coupling::closed::CoulombHertz;
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::table;
use tribos_core::coupling::{LateralFriction, RoundFriction};
use tribos_core::internals::leaning_wrench;
use tribos_core::law::PowerLaw;
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{NodePatch, Nodes};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Digest of patches in the plane, f64 and f32.
pub fn planes() -> u64 {
    in_both(planes_of::<f64>, planes_of::<f32>)
}

fn planes_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let puck = RoundFriction::new(table::CoulombDisk, real(0.3), real(0.04)).expect("in range");
    hash.numbers([puck.radius(), puck.coefficient()]);
    hash.number::<R>(puck.coupling().mean_square_radius());
    let power = PowerLaw::new(real(0.5), real(0.75)).expect("in range");
    let feet = [[0.0, 0.0], [1.0, 0.125], [0.5, 0.75]].map(|foot: [f64; 2]| foot.map(real));
    let stool = Nodes::tripod(feet, [real(0.5), real(0.25)]).expect("upright");
    let stool = NodeFriction::new(power, stool);
    hash.number(stool.law().alpha());
    hash.number(stool.patch().total_weight());
    let mut rng = Lcg::new(137);
    let random = [(); 48].map(|()| twist::<R>(&mut rng));
    for motion in random.into_iter().chain(ends_of_twists(23)) {
        hash.wrench(&puck.wrench(real(1.7), &motion));
        hash.numbers(puck.wrench_jacobian(real(1.7), &motion).iter().copied());
        hash.wrench(&stool.wrench(real(1.7), &motion));
        hash.numbers(stool.wrench_jacobian(real(1.7), &motion).iter().copied());
        let (v, spin) = (motion.speed(), motion.spin);
        let sizes = puck.magnitudes(real(1.7), v, spin);
        let slopes = puck.magnitudes_jacobian(real(1.7), v, spin);
        hash.numbers([sizes.force, sizes.torque]);
        hash.numbers([slopes.force_speed, slopes.force_spin]);
        hash.numbers([slopes.torque_speed, slopes.torque_spin]);
    }
    let mut wrenches = [Wrench::ZERO; 48];
    puck.wrench_batch(real(0.25), &random, &mut wrenches);
    for (wrench, motion) in wrenches.into_iter().zip(random) {
        let as_vector = Vector3::from(wrench);
        hash.twist(&Twist::from(as_vector));
        hash.wrench(&puck.wrench(motion.spin, &motion));
    }
    for load in ends() {
        hash.wrench(&puck.wrench(load, &random[0]));
        hash.verdict(&RoundFriction::<R, _>::new(
            table::CoulombDisk,
            load,
            R::ONE,
        ));
        hash.verdict(&RoundFriction::<R, _>::new(
            table::CoulombDisk,
            R::ONE,
            load,
        ));
    }
}

/// One in `every` of the twists from [`ends`].
pub(crate) fn ends_of_twists<R: Real>(every: usize) -> impl Iterator<Item = Twist<R>> {
    triples_of_ends(every).map(|[x, y, spin]| Twist::new(x, y, spin))
}

/// Digest of tall bodies in both precisions.
pub fn leaning() -> u64 {
    in_both(leaning_of::<f64>, leaning_of::<f32>)
}

fn leaning_of<R: Real>(hash: &mut Fnv) {
    for height in [0.0, 0.1, 0.5] {
        tall::<R, _, FullGradient>(hash, table::CoulombDisk, height);
        tall::<R, _, LongitudinalGradient>(hash, CoulombHertz, height);
    }
    for (slide, rim) in arguments::<R>(139, 30) {
        let leans = [0.125, -0.25].map(R::from_f64);
        let got = leaning_wrench(&table::CoulombDisk, [slide, rim], leans);
        hash.numbers([got.force, got.lateral, got.torque]);
    }
    for [x, y, z] in triples_of_ends::<R>(61) {
        let got = leaning_wrench(&CoulombHertz, [x, y], [z, R::ZERO]);
        hash.numbers([got.force, got.lateral, got.torque]);
        let (got, leans) = FullGradient::balance(&table::CoulombDisk, [x, y], z);
        hash.numbers([got.force, got.lateral, got.torque]);
        hash.numbers(leans);
        let (got, leans) = LongitudinalGradient::balance(&table::CoulombDisk, [x, y], z);
        hash.numbers([got.force, got.lateral, got.torque]);
        hash.numbers(leans);
    }
}

fn tall<R: Real, C: LateralFriction<R>, L: PressureGradient>(
    hash: &mut Fnv,
    coupling: C,
    height: f64,
) {
    let [coefficient, radius] = [0.25, 0.0625].map(R::from_f64);
    let foot = RoundFriction::new(coupling, coefficient, radius).expect("in range");
    let body = LoadTransferFriction::<R, C, L>::new(foot, R::from_f64(height)).expect("in range");
    hash.numbers([body.lean(), body.foot().radius()]);
    let mut rng = Lcg::new(149);
    let random = [(); 60].map(|()| twist::<R>(&mut rng));
    for motion in random.into_iter().chain(ends_of_twists(97)) {
        let got = body.wrench(speed(&mut rng), &motion);
        hash.wrench(&got.wrench);
        hash.numbers([got.lean.x, got.lean.y]);
        hash.feed(u64::from(!got.is_lifting));
        match got.whole() {
            Ok(wrench) => hash.wrench(&wrench),
            Err(PatchError::Tips { lean }) => hash.number(lean),
            Err(other) => panic!("{other}"),
        }
    }
}
