//! Thresholds and impulses of any size: what is held is finite, within bounds and along the trial.

use nalgebra::Vector3;
use tribos_core::Real;
use tribos_core::contact::{ContactFriction, CoupledFriction, IndependentFriction, SlidingTorsion};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::{DryReducedFriction, ReducedFriction};
use tribos_core::internals::project_on_disc;
use tribos_core::internals::{Masses, TangentialLoad};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_tests::sweep::Lcg;

/// Decimal exponents of the type's subnormal and largest numbers.
fn decades<R: Real>() -> [f64; 2] {
    if R::EPSILON.to_f64() > 1e-10 {
        [-44.0, 38.0]
    } else {
        [-322.0, 307.0]
    }
}

fn random<R: Real>(rng: &mut Lcg) -> R {
    let [low, high] = decades::<R>();
    R::from_f64(10.0_f64.powf(rng.between(low, high)))
}

/// Holds random trials of all sizes; the faults found.
fn faults<R: Real, F: ContactFriction<R, Modes = SlidingTorsion>>(
    name: &str,
    make: impl Fn(R, R) -> Option<(F, [R; 2])>,
) -> Vec<String> {
    let mut rng = Lcg::new(61);
    let mut out = Vec::new();
    let slack = R::from_f64(1.0) + R::from_f64(1e3) * R::EPSILON;
    for _ in 0..100_000 {
        let ratio = R::from_f64(rng.log_between(1e-3, 1e3));
        let mu = if rng.unit() < 0.5 {
            R::from_f64(rng.log_between(1e-3, 10.0))
        } else {
            // The set's own limits over ε² are numbers.
            let third: R = random(&mut rng);
            R::from_f64(third.to_f64().cbrt())
        };
        let Some((friction, [most_force, most_torque])) = make(mu, ratio) else {
            continue;
        };
        let lever = R::from_f64(rng.log_between(1e-9, 1e3));
        let gyration = lever.to_f64() * rng.log_between(1e-2, 1e2);
        let masses = Masses {
            sliding: R::ONE,
            torsion: R::from_f64(gyration * gyration),
        };
        let (bound, x, torsion): (R, R, R) = (random(&mut rng), random(&mut rng), random(&mut rng));
        let quarter = R::HALF * R::HALF;
        let sliding = Vector3::new(x * quarter, -x * R::HALF, R::ZERO);
        let trial = TangentialLoad { sliding, torsion };
        let reach = [
            trial.torsion / lever,
            most_force * bound,
            most_torque * bound * lever,
            bound * lever,
        ];
        // What the documentation calls infinite, and ratios that have no digits.
        let ratios = [reach[0] / x, x / reach[0], x / bound, reach[0] / bound];
        let rounded = |x: &R| *x < R::MIN_POSITIVE;
        if reach.iter().any(|x| !x.is_finite()) || ratios.iter().any(rounded) {
            continue;
        }
        let held = friction.hold(&trial, bound, lever, &masses);
        let force = held.sliding.x.hypot(held.sliding.y);
        let tiny = R::MIN_POSITIVE;
        let fine = force.is_finite()
            && held.torsion.is_finite()
            && held.sliding.x >= R::ZERO
            && held.sliding.y <= R::ZERO
            && held.torsion >= R::ZERO
            && held.sliding.x <= sliding.x * slack + tiny
            && held.torsion <= torsion * slack + tiny
            && force <= most_force * bound * slack + tiny
            && held.torsion <= most_torque * bound * lever * slack + tiny;
        if !fine {
            out.push(format!(
                "{name}: mu {mu:?}, ratio {ratio:?}, bound {bound:?}, lever {lever:?}, gyration {gyration:?}, {trial:?} gives {held:?}"
            ));
        }
    }
    out
}

fn faults_of<R: Real>() -> Vec<String>
where
    CoulombDisk: DryReducedFriction<R>,
{
    let thresholds = |mu: R, ratio: R| {
        let friction = IndependentFriction::sliding_torsion(mu, ratio).ok()?;
        Some((friction, [mu, ratio]))
    };
    let exact = |mu: R, ratio: R| {
        let set = RoundLimitSurface::new(CoulombDisk, mu, ratio).ok()?;
        let spinning = CoulombDisk.reduced_wrench(R::ZERO, R::ONE).torque;
        let friction = CoupledFriction::sliding_torsion(set);
        Some((friction, [mu, mu * ratio * spinning]))
    };
    let usual = |mu: R, ratio: R| {
        let set = LimitEllipsoid::new(mu, ratio, R::HALF).ok()?;
        let most = [set.force_limit(), set.torque_limit()];
        Some((CoupledFriction::sliding_torsion(set), most))
    };
    let mut out = faults::<R, _>("thresholds", thresholds);
    out.extend(faults::<R, _>("exact", exact));
    out.extend(faults::<R, _>("ellipsoid", usual));
    out
}

fn assert_none(faults: &[String]) {
    let shown: Vec<_> = faults.iter().take(6).collect();
    assert!(faults.is_empty(), "{} faults: {shown:#?}", faults.len());
}

#[test]
fn what_is_held_is_finite_bounded_and_along_the_trial() {
    assert_none(&faults_of::<f64>());
    assert_none(&faults_of::<f32>());
}

#[test]
fn projections_on_discs_of_any_size_stay_to_the_bit() {
    let mut rng = Lcg::new(62);
    for _ in 0..1_000_000 {
        let bound: f64 = random(&mut rng);
        let size: f64 = random(&mut rng);
        let q = Vector3::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), 0.5) * size;
        let once = project_on_disc(&q, bound);
        assert!(once.iter().all(|x| x.is_finite()), "{q:?} {bound:e}");
        assert_eq!(project_on_disc(&once, bound), once, "{q:?} {bound:e}");
    }
}
