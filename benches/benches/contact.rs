//! Update of one contact, by modes and by state: sticking, slipping, or either.
//!
//! The baseline is an engine without torques: a normal impulse, and sliding under a
//! friction pyramid with each direction clamped separately.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use std::hint::black_box;
use tribos_core::contact::{
    Cohesion, Contact, ContactFriction, ContactGeometry, CoupledFriction, IndependentFriction,
    NormalLaw, SphereBody,
};
use tribos_core::coupling::coulomb;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_tests::sweep::Lcg;

const SEED: u64 = 5;
const PAIRS: usize = 1000;
const MU: f64 = 0.3;
const DT: f64 = 1e-3;
/// Speeds of pairs that stick and that slip, beside a speed of approach of 1.
const SLOW: f64 = 0.01;
const FAST: f64 = 10.0;

/// Motion of the pairs.
#[derive(Clone, Copy, Debug)]
enum Motion {
    Stick,
    Slip,
    Mixed,
}

impl Motion {
    const ALL: [Self; 3] = [Self::Stick, Self::Slip, Self::Mixed];

    fn name(self) -> &'static str {
        match self {
            Self::Stick => "stick",
            Self::Slip => "slip",
            Self::Mixed => "mixed",
        }
    }

    fn speed(self, rng: &mut Lcg) -> f64 {
        match self {
            Self::Stick => SLOW,
            Self::Slip => FAST,
            Self::Mixed => rng.log_between(SLOW, FAST),
        }
    }
}

/// Two spheres that approach each other, and their geometry.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    touch: ContactGeometry<f64>,
    spheres: [SphereBody<f64>; 2],
}

fn meetings(motion: Motion, radii: [f64; 2]) -> Vec<Meeting> {
    let mut rng = Lcg::new(SEED);
    let mut one = || {
        let mut vector = |size: f64| Vector3::from([(); 3].map(|()| rng.between(-size, size)));
        let across = vector(1.0);
        let displacement = across / across.norm() * (radii[0] + radii[1]);
        let touch = ContactGeometry::spheres(&displacement, radii).expect("they touch");
        let speed = motion.speed(&mut rng);
        let mut vector = |size: f64| Vector3::from([(); 3].map(|()| rng.between(-size, size)));
        let mut sphere = |radius: f64, along: f64| {
            let inv_mass = 1.0 / radius.powi(3);
            let velocity = vector(speed);
            SphereBody {
                velocity: velocity + touch.normal * (along - velocity.dot(&touch.normal)),
                spin: vector(speed),
                inv_mass,
                inv_inertia: 2.5 * inv_mass / (radius * radius),
            }
        };
        let spheres = [sphere(radii[0], 0.5), sphere(radii[1], -0.5)];
        Meeting { touch, spheres }
    };
    (0..PAIRS).map(|_| one()).collect()
}

fn time<F: ContactFriction<f64>>(
    criterion: &mut Criterion,
    name: &str,
    radii: [f64; 2],
    friction: F,
) {
    time_after(0, criterion, name, radii, friction);
}

/// Updates of contacts that were updated that often before.
fn time_after<F: ContactFriction<f64>>(
    updates: usize,
    criterion: &mut Criterion,
    name: &str,
    radii: [f64; 2],
    friction: F,
) {
    let law = NormalLaw::new(Cohesion::NONE, 0.0).expect("in range");
    let mut group = criterion.benchmark_group("contact");
    group.throughput(Throughput::Elements(PAIRS as u64));
    for motion in Motion::ALL {
        let meetings = meetings(motion, radii);
        let prepared = |m: &Meeting| {
            let [mut a, mut b] = m.spheres;
            let mut contact = Contact::<_, F::Modes>::new(&m.touch, &law, &a, &b, DT);
            for _ in 0..updates {
                contact.update(&friction, &mut a, &mut b);
            }
            (contact, a, b)
        };
        let fresh: Vec<_> = meetings.iter().map(prepared).collect();
        for (mut contact, mut a, mut b) in fresh.iter().copied() {
            contact.update(&friction, &mut a, &mut b);
            let parting = contact.velocity(&a, &b).normal;
            assert!(parting.abs() < 1e-12, "they still approach each other");
        }
        let mut work = fresh.clone();
        group.bench_function(BenchmarkId::new(name, motion.name()), |bencher| {
            bencher.iter(|| {
                work.copy_from_slice(black_box(&fresh));
                for (contact, a, b) in &mut work {
                    contact.update(&friction, a, b);
                }
                black_box(&mut work);
            });
        });
    }
    group.finish();
}

/// A normal impulse and two tangential ones, each clamped for itself.
fn pyramid(m: &Meeting, axes: &[Vector3<f64>; 2]) -> [SphereBody<f64>; 2] {
    let [mut a, mut b] = m.spheres;
    let (n, [arm_a, arm_b]) = (m.touch.normal, m.touch.arms);
    let mass = 1.0 / (a.inv_mass + b.inv_mass);
    let pressed = (-mass * (b.velocity - a.velocity).dot(&n)).max(0.0);
    a.velocity -= n * (pressed * a.inv_mass);
    b.velocity += n * (pressed * b.inv_mass);
    let turn = arm_a * arm_a * a.inv_inertia + arm_b * arm_b * b.inv_inertia;
    let mass = 1.0 / (a.inv_mass + b.inv_mass + turn);
    for axis in axes {
        let slip = b.velocity - a.velocity - (a.spin * arm_a + b.spin * arm_b).cross(&n);
        let wanted = -mass * slip.dot(axis);
        let held = axis * wanted.clamp(-MU * pressed, MU * pressed);
        let moment = n.cross(&held);
        a.velocity -= held * a.inv_mass;
        b.velocity += held * b.inv_mass;
        a.spin -= moment * (arm_a * a.inv_inertia);
        b.spin -= moment * (arm_b * b.inv_inertia);
    }
    [a, b]
}

fn baseline(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("contact");
    group.throughput(Throughput::Elements(PAIRS as u64));
    let meetings = meetings(Motion::Mixed, [1.0, 1.0]);
    let frame = |m: &Meeting| {
        let n = m.touch.normal;
        let axis = if n.x.abs() < 0.5 {
            Vector3::x()
        } else {
            Vector3::y()
        };
        let first = n.cross(&axis).normalize();
        (*m, [first, n.cross(&first)])
    };
    let framed: Vec<_> = meetings.iter().map(frame).collect();
    let mut results: Vec<_> = framed.iter().map(|(m, axes)| pyramid(m, axes)).collect();
    let parted = |[a, b]: &[SphereBody<f64>; 2], m: &Meeting| {
        (b.velocity - a.velocity).dot(&m.touch.normal).abs() < 1e-12
    };
    assert!(results.iter().zip(&meetings).all(|(s, m)| parted(s, m)));
    group.bench_function(BenchmarkId::new("pyramid", "mixed"), |bencher| {
        bencher.iter(|| {
            for ((m, axes), result) in black_box(&framed).iter().zip(&mut results) {
                *result = pyramid(m, axes);
            }
            black_box(&mut results);
        });
    });
    group.finish();
}

/// Copies the prepared contacts and does nothing to them: what every figure contains.
fn copying(criterion: &mut Criterion) {
    let law = NormalLaw::new(Cohesion::NONE, 0.0).expect("in range");
    let prepared = |m: &Meeting| {
        let [a, b] = m.spheres;
        let modes = IndependentFriction::all(MU, 0.1, 0.1).expect("in range");
        let contact = contact_for(&modes, m, &law, [&a, &b]);
        (contact, a, b)
    };
    let fresh: Vec<_> = meetings(Motion::Mixed, [1.0, 1.0])
        .iter()
        .map(prepared)
        .collect();
    let mut work = fresh.clone();
    criterion.bench_function("contact/copy alone", |bencher| {
        bencher.iter(|| {
            work.copy_from_slice(black_box(&fresh));
            black_box(&mut work);
        });
    });
}

fn contact_for<F: ContactFriction<f64>>(
    _: &F,
    m: &Meeting,
    law: &NormalLaw<f64>,
    [a, b]: [&SphereBody<f64>; 2],
) -> Contact<f64, F::Modes> {
    Contact::new(&m.touch, law, a, b, DT)
}

fn contacts(criterion: &mut Criterion) {
    let equal = [1.0, 1.0];
    let all = IndependentFriction::all(MU, 0.1, 0.1).expect("in range");
    let exact = RoundLimitSurface::new(coulomb::CoulombDisk, MU, 0.5).expect("in range");
    let usual = LimitEllipsoid::new(MU, 0.5, 2.0 / 3.0).expect("in range");
    let sliding = IndependentFriction::sliding(MU).expect("in range");
    let torsion = IndependentFriction::sliding_torsion(MU, 0.1).expect("in range");
    let rolling = IndependentFriction::sliding_rolling(MU, 0.1).expect("in range");
    time(
        criterion,
        "frictionless",
        equal,
        IndependentFriction::none(),
    );
    time(criterion, "sliding", equal, sliding);
    time(criterion, "sliding torsion", equal, torsion);
    time(criterion, "sliding rolling", equal, rolling);
    time(criterion, "all modes", equal, all);
    let unequal = [1.0, 0.5];
    time(criterion, "all modes, unequal", unequal, all);
    time_after(2, criterion, "all modes, unequal, solved", unequal, all);
    let coupled = CoupledFriction::sliding_torsion(exact);
    time(criterion, "coupled exact", equal, coupled);
    let coupled = CoupledFriction::sliding_torsion(usual);
    time(criterion, "coupled ellipsoid", equal, coupled);
    baseline(criterion);
    copying(criterion);
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = contacts
}
criterion_main!(benches);
