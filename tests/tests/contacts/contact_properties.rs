//! What every update of a contact promises, over random meetings of spheres.

use nalgebra::{Rotation3, Unit, Vector3};
use tribos_core::contact::{
    ContactBody, ContactFriction, ContactGeometry, ContactVector, CoupledFriction,
    IndependentFriction, SphereBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::internals::Masses;
use tribos_core::internals::project_on_disc;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::real::Real;
use tribos_core::twist::Wrench;
use tribos_tests::contacts::{Meeting, components, radii, size, vector};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const CASES: usize = 40_000;
/// Projections of projections.
const REPEATS: usize = 3_000_000;

type Exact<R> = RoundLimitSurface<R, CoulombDisk>;

fn exact(mu: f64, ratio: f64) -> Exact<f64> {
    RoundLimitSurface::new(CoulombDisk, mu, ratio).unwrap()
}

/// Does something with a random friction of every kind.
macro_rules! for_every_friction {
    ($rng:ident, $name:ident, $friction:ident => $body:block) => {{
        let mut coefficient = || $rng.log_between(1e-3, 10.0);
        let [mu, mu_t, mu_n] = [coefficient(), coefficient(), coefficient()];
        let ellipsoid = LimitEllipsoid::new(mu, mu_n, 2.0 / 3.0).unwrap();
        {
            let ($name, $friction) = ("frictionless", IndependentFriction::none());
            $body
        }
        {
            let ($name, $friction) = ("sliding", IndependentFriction::sliding(mu).unwrap());
            $body
        }
        {
            let ($name, $friction) = (
                "torsion",
                IndependentFriction::sliding_torsion(mu, mu_n).unwrap(),
            );
            $body
        }
        {
            let ($name, $friction) = (
                "rolling",
                IndependentFriction::sliding_rolling(mu, mu_t).unwrap(),
            );
            $body
        }
        {
            let ($name, $friction) = ("all", IndependentFriction::all(mu, mu_t, mu_n).unwrap());
            $body
        }
        {
            let friction = CoupledFriction::sliding_torsion(exact(mu, mu_n));
            let ($name, $friction) = ("exact", friction);
            $body
        }
        {
            let friction = CoupledFriction::all(exact(mu, mu_n), mu_t).unwrap();
            let ($name, $friction) = ("exact, rolling", friction);
            $body
        }
        {
            let friction = CoupledFriction::all(ellipsoid, mu_t).unwrap();
            let ($name, $friction) = ("ellipsoid, rolling", friction);
            $body
        }
    }};
}

#[test]
fn thresholds_are_obeyed() {
    let mut rng = Lcg::new(51);
    let mut worst = Worst::of("friction beyond its threshold");
    for _ in 0..CASES {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        let [mu, mu_t, mu_n] = [(); 3].map(|()| rng.log_between(1e-3, 10.0));
        let all = IndependentFriction::all(mu, mu_t, mu_n).unwrap();
        let (contact, _) = meeting.updated(&all);
        let (p, lever) = (contact.bound(), contact.effective_radius());
        assert!(p >= 0.0 && contact.impulse().normal >= -contact.cohesion());
        for (got, limit) in [
            (contact.impulse().sliding().norm(), mu * p),
            (contact.impulse().rolling().norm(), mu_t * p * lever),
            (contact.impulse().torsion().abs(), mu_n * p * lever),
        ] {
            if limit == 0.0 {
                assert_eq!(got, 0.0);
            } else {
                worst.see(got / limit - 1.0, || format!("{meeting:?}"));
            }
        }
        let coupled = CoupledFriction::all(exact(mu, mu_n), mu_t).unwrap();
        let (contact, _) = meeting.updated(&coupled);
        if p > 0.0 {
            let force = contact.impulse().sliding().norm() / p;
            let torque = contact.impulse().torsion() / (p * lever);
            let carried = Wrench::new(force, 0.0, torque);
            let gauge = coupled.set().gauge(&carried);
            worst.see(gauge - 1.0, || format!("{meeting:?}"));
        }
    }
    worst.assert_within(&tolerance::CONTACT_THRESHOLD);
}

#[test]
fn a_second_update_changes_nothing() {
    let mut rng = Lcg::new(52);
    let mut worst = Worst::of("change by a second update");
    for _ in 0..CASES / 4 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        for_every_friction!(rng, name, friction => {
            let (mut contact, [mut a, mut b]) = meeting.updated(&friction);
            let scale = meeting.scale(&friction);
            let change = contact.update(&friction, &mut a, &mut b);
            let change = size(&change, contact.effective_radius());
            worst.see(change / scale, || format!("{name} {friction:?} {meeting:?}"));
        });
    }
    worst.assert_within(&tolerance::CONTACT_AGAIN);
}

#[test]
fn projections_of_projections_stay_to_the_bit() {
    let mut rng = Lcg::new(53);
    for _ in 0..REPEATS {
        let bound = rng.log_between(1e-6, 1e6);
        let q = vector::<f64>(&mut rng, 4.0 * bound);
        let once = project_on_disc(&q, bound);
        assert_eq!(project_on_disc(&once, bound), once, "{q:?} {bound}");
        let (q, bound) = (q.map(|x| x as f32), bound as f32);
        let once = project_on_disc(&q, bound);
        assert_eq!(project_on_disc(&once, bound), once, "{q:?} {bound}");
    }
    // The coupled set: its own outputs, with any metric.
    let set = CoupledFriction::sliding_torsion(exact(0.3, 0.7));
    for _ in 0..REPEATS / 20 {
        let [bound, lever, gyration] = [(); 3].map(|()| rng.log_between(1e-3, 1e3));
        let masses = Masses {
            sliding: 1.0,
            torsion: gyration * gyration,
        };
        let trial = tribos_core::internals::TangentialLoad {
            sliding: vector(&mut rng, bound),
            torsion: rng.between(-1.0, 1.0) * bound * lever,
        };
        let once = set.hold(&trial, bound, lever, &masses);
        assert_eq!(
            set.hold(&once, bound, lever, &masses),
            once,
            "{trial:?} {bound}"
        );
    }
}

#[test]
fn friction_never_drives() {
    let mut rng = Lcg::new(54);
    let mut worst = Worst::of("power of friction");
    for _ in 0..CASES / 4 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        for_every_friction!(rng, name, friction => {
            let (contact, [a, b]) = meeting.updated(&friction);
            let (mut impulse, mut after) = (*contact.impulse(), contact.velocity(&a, &b));
            (impulse.normal, after.normal) = (0.0, 0.0);
            let power = impulse.dot(&after);
            let most = meeting.scale(&friction) * meeting.speed();
            worst.see(power / most, || format!("{name} {friction:?} {meeting:?}"));
        });
    }
    worst.assert_within(&tolerance::CONTACT_POWER);
}

#[test]
fn momentum_and_angular_momentum_stay() {
    let mut rng = Lcg::new(55);
    let mut worst = Worst::of("momentum created");
    for _ in 0..CASES {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        let all = IndependentFriction::all(0.5, 0.2, 0.2).unwrap();
        let (contact, after) = meeting.updated(&all);
        // Places of the centres, the contact point in the origin.
        let [arm_a, arm_b] = meeting.touch.arms;
        let places = [meeting.touch.normal * -arm_a, meeting.touch.normal * arm_b];
        let mut sums = [Vector3::zeros(); 2];
        let mut exchanged = 0.0_f64;
        for ((before, after), place) in meeting.spheres.iter().zip(&after).zip(&places) {
            let momentum = (after.velocity - before.velocity) / before.inv_mass;
            let own = (after.spin - before.spin) / before.inv_inertia;
            sums[0] += momentum;
            sums[1] += own + place.cross(&momentum);
            let rounding = (before.velocity.norm() + after.velocity.norm()) / before.inv_mass;
            let turned = (before.spin.norm() + after.spin.norm()) / before.inv_inertia;
            exchanged = exchanged.max(rounding).max(turned / (arm_a + arm_b));
        }
        let created = sums[0].norm().max(sums[1].norm() / (arm_a + arm_b));
        exchanged += size(contact.impulse(), contact.effective_radius());
        worst.see(created / exchanged, || format!("{meeting:?}"));
    }
    worst.assert_within(&tolerance::CONTACT_MOMENTUM);
}

/// The meeting in units in which length, time and mass are powers of two as large.
fn scaled(m: &Meeting<f64>, [length, time, mass]: [f64; 3]) -> Meeting<f64> {
    let speed = length / time;
    let force = mass * speed / time;
    let cohesion = m.law.cohesion();
    let cohesion = tribos_core::contact::Cohesion::new(
        cohesion.strength() * force,
        cohesion.range() * length,
        cohesion.attraction(),
    );
    Meeting {
        touch: ContactGeometry {
            normal: m.touch.normal,
            gap: m.touch.gap * length,
            arms: m.touch.arms.map(|arm| arm * length),
            lever: m.touch.lever * length,
        },
        spheres: m.spheres.map(|s| SphereBody {
            velocity: s.velocity * speed,
            spin: s.spin / time,
            inv_mass: s.inv_mass / mass,
            inv_inertia: s.inv_inertia / (mass * length * length),
        }),
        law: tribos_core::contact::NormalLaw::new(cohesion.unwrap(), m.law.restitution()).unwrap(),
        dt: m.dt * time,
    }
}

#[test]
fn other_units_change_no_bit() {
    let mut rng = Lcg::new(56);
    let power = |rng: &mut Lcg| 2.0_f64.powi((rng.bits() % 81) as i32 - 40);
    for _ in 0..CASES / 8 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        // Even powers where a root is taken of the square of a length.
        let [length, time, mass] = [(); 3].map(|()| power(&mut rng));
        let other = scaled(&meeting, [length, time, mass]);
        let momentum = mass * length / time;
        for_every_friction!(rng, name, friction => {
            let (small, _) = meeting.updated(&friction);
            let (large, _) = other.updated(&friction);
            let wanted = components(small.impulse()).map(|x| x * momentum);
            let got = components(large.impulse());
            for (index, (mut wanted, got)) in wanted.into_iter().zip(got).enumerate() {
                if index > 3 {
                    wanted *= length;
                }
                assert_eq!(got, wanted, "{name} {friction:?} {meeting:?}");
            }
        });
    }
}

#[test]
fn the_axes_of_space_do_not_matter() {
    let mut rng = Lcg::new(57);
    let mut worst = Worst::of("impulses turned in space");
    for _ in 0..CASES / 8 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        let axis = Unit::new_normalize(vector(&mut rng, 1.0));
        let turn = Rotation3::from_axis_angle(&axis, rng.between(0.0, 6.0));
        let mut other = meeting;
        other.touch.normal = turn * meeting.touch.normal;
        for sphere in &mut other.spheres {
            sphere.velocity = turn * sphere.velocity;
            sphere.spin = turn * sphere.spin;
        }
        for_every_friction!(rng, name, friction => {
            let (here, there) = (meeting.updated(&friction).0, other.updated(&friction).0);
            let (h, t) = (components(here.impulse()), components(there.impulse()));
            let part = |all: &[f64; 8], at: usize| Vector3::new(all[at], all[at + 1], all[at + 2]);
            let turned = |at: usize| (turn * part(&h, at) - part(&t, at)).norm();
            let lever = here.effective_radius();
            let miss = (h[0] - t[0]).abs() + turned(1) + (turned(4) + (h[7] - t[7]).abs()) / lever;
            worst.see(miss / meeting.scale(&friction), || format!("{name} {friction:?} {meeting:?}"));
        });
    }
    worst.assert_within(&tolerance::CONTACT_TURNED);
}

#[test]
fn no_friction_and_boundless_friction_are_the_limits() {
    let mut rng = Lcg::new(58);
    for _ in 0..CASES / 8 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        let smooth = meeting.updated(&IndependentFriction::none()).1;
        for (before, after) in meeting.spheres.iter().zip(&smooth) {
            assert_eq!(before.spin, after.spin, "a smooth contact turns nothing");
        }
        let slippery = meeting.updated(&IndependentFriction::all(0.0, 0.0, 0.0).unwrap());
        assert_eq!(components(slippery.0.impulse())[1..], [0.0_f64; 7]);
        assert_eq!(slippery.1, smooth);
        let rough = IndependentFriction::all(1e300, 1e300, 1e300).unwrap();
        let (contact, [a, b]) = meeting.updated(&rough);
        if contact.bound() > 0.0 {
            let left = contact.velocity(&a, &b);
            assert!(left.sliding().norm() < 1e-12, "{meeting:?}");
            let rim = left.rolling().norm() + left.torsion().abs();
            assert!(rim * contact.effective_radius() < 1e-12, "{meeting:?}");
        }
    }
}

#[test]
fn modes_without_a_threshold_are_as_if_not_named() {
    let mut rng = Lcg::new(59);
    for _ in 0..CASES / 8 {
        let meeting = Meeting::<f64>::random(&mut rng, [1.0, 1.0]);
        let [mu, mu_n] = [(); 2].map(|()| rng.log_between(1e-3, 10.0));
        let named = meeting.updated(&IndependentFriction::all(mu, 0.0, mu_n).unwrap());
        let plain = meeting.updated(&IndependentFriction::sliding_torsion(mu, mu_n).unwrap());
        assert_eq!(named.1, plain.1);
        assert_eq!(components(named.0.impulse()), components(plain.0.impulse()));
        let plain = meeting.updated(&IndependentFriction::sliding(mu).unwrap());
        let named = meeting.updated(&IndependentFriction::sliding_torsion(mu, 0.0).unwrap());
        assert_eq!(named.1, plain.1);
        let named = meeting.updated(&IndependentFriction::sliding_rolling(mu, 0.0).unwrap());
        assert_eq!(named.1, plain.1);
        let coupled = CoupledFriction::all(exact(mu, mu_n), 0.0).unwrap();
        let plain = CoupledFriction::sliding_torsion(exact(mu, mu_n));
        assert_eq!(meeting.updated(&coupled).1, meeting.updated(&plain).1);
    }
}

/// Optimality of the coupled projection: no pair of the set lies beyond the plane through the
/// answer that stands on the displacement, in the metric of the contact's work.
#[test]
fn the_coupled_update_is_the_exact_local_solution() {
    let mut rng = Lcg::new(60);
    let mut worst = Worst::of("work against any admissible grasp");
    for _ in 0..CASES / 8 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        let [mu, ratio] = [rng.log_between(1e-2, 3.0), rng.log_between(0.1, 2.0)];
        let friction = CoupledFriction::sliding_torsion(exact(mu, ratio));
        let (contact, [a, b]) = meeting.updated(&friction);
        let (p, lever) = (contact.bound(), contact.effective_radius());
        if p == 0.0 {
            continue;
        }
        // Velocity left: −v is the outward normal, so that v·(q − r) ≥ 0 for all q of the set.
        let left = contact.velocity(&a, &b);
        let held = contact.impulse();
        let most = meeting.speed() * meeting.scale(&friction);
        for _ in 0..20 {
            let turn = rng.between(0.0, 1.6);
            let at = friction.set().wrench(&tribos_core::twist::Twist::new(
                turn.cos(),
                0.0,
                turn.sin() / ratio,
            ));
            let direction = project_on_plane(&vector(&mut rng, 1.0), contact.normal());
            let sliding = direction * (at.force.x.abs() * p);
            let torsion = at.torque * p * lever * (1.0 - 2.0 * (rng.bits() % 2) as f64);
            let work = left.sliding().dot(&(sliding - held.sliding()))
                + left.torsion() * (torsion - held.torsion());
            worst.see(-work / most, || format!("{meeting:?}"));
        }
    }
    worst.assert_within(&tolerance::CONTACT_POWER);
}

fn project_on_plane(v: &Vector3<f64>, normal: &Vector3<f64>) -> Vector3<f64> {
    (v - normal * v.dot(normal)).normalize()
}

#[test]
fn guesses_become_admissible_and_stay_in_the_plane() {
    let mut rng = Lcg::new(61);
    for _ in 0..CASES / 8 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f64>::random(&mut rng, radii);
        let friction = IndependentFriction::all(0.3, 0.1, 0.1).unwrap();
        let mut contact = meeting.contact(&friction);
        let normal = rng.between(-2.0, 2.0);
        let [sliding, rolling] = [(); 2].map(|()| vector(&mut rng, 1.0));
        let torsion = contact.impulse().torsion();
        contact.set_impulse(&ContactVector::new(normal, sliding, rolling, torsion));
        contact.project_impulse(&friction);
        let (impulse, p) = (contact.impulse(), contact.bound());
        assert!(p >= 0.0);
        assert!(impulse.sliding().norm() <= 0.3 * p * (1.0 + 1e-14));
        assert!(impulse.rolling().norm() <= 0.1 * p * contact.effective_radius() * (1.0 + 1e-14));
        assert!(impulse.sliding().dot(contact.normal()).abs() < 1e-15);
        let again = *impulse;
        contact.project_impulse(&friction);
        assert_eq!(*contact.impulse(), again);
    }
}

#[test]
fn single_precision_follows() {
    let mut rng = Lcg::new(62);
    let mut worst = Worst::of("second update, f32");
    for _ in 0..CASES / 4 {
        let radii = radii(&mut rng);
        let meeting = Meeting::<f32>::random(&mut rng, radii);
        let friction = IndependentFriction::all(0.3_f32, 0.1, 0.1).unwrap();
        let (mut contact, [mut a, mut b]) = meeting.updated(&friction);
        let scale = meeting.scale(&friction);
        let change = contact.update(&friction, &mut a, &mut b);
        let change = size(&change, contact.effective_radius()) / scale;
        worst.see(change, || format!("{meeting:?}"));
        assert!(
            a.velocity()
                .iter()
                .chain(b.angular_velocity().iter())
                .all(|x| x.is_finite())
        );
        assert!(Real::is_finite(contact.bound()));
    }
    worst.assert_within(&tolerance::CONTACT_AGAIN_SINGLE);
}
