//! Several contacts at once: judged by the contacts' laws, and by statics.

use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, ContactBody, ContactGeometry, IndependentFriction, NormalLaw, SphereBody,
    TimeStep, WallBody,
};
use tribos_core::manifold::{
    BodyHandle, ContactHandle, ContactSystem, ContactSystemError, InitialGuess, SolverSettings,
    SystemBody,
};
use tribos_core::real::Real;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const GRAVITY: f64 = 9.81;
const DT: f64 = 1e-3;
const STOP: SolverSettings<f64> = SolverSettings {
    max_iterations: 5_000,
    tolerance: 1e-14,
};

fn ball<R: Real>() -> SphereBody<R> {
    let still = Vector3::new(R::ZERO, R::ZERO, R::ZERO);
    SphereBody {
        velocity: still,
        spin: still,
        inv_mass: R::ONE,
        inv_inertia: R::from_f64(2.5),
    }
}

fn floor() -> WallBody<f64> {
    WallBody {
        velocity: Vector3::zeros(),
        inv_mass: 0.0,
    }
}

fn no_bounce() -> NormalLaw<f64> {
    NormalLaw::new(Cohesion::NONE, 0.0).unwrap()
}

type All = IndependentFriction<f64, tribos_core::contact::AllModes>;

/// A column of five balls of radius 1 on a floor.
fn column(
    friction: All,
) -> (
    ContactSystem<f64, All, 6, 5>,
    Vec<BodyHandle>,
    Vec<ContactHandle>,
) {
    let mut stack = ContactSystem::new(no_bounce(), friction);
    let ground = stack.push_plate(floor()).unwrap();
    let balls: Vec<_> = (0..5).map(|_| stack.push_sphere(ball()).unwrap()).collect();
    let touch = ContactGeometry::plate(1.0, &Vector3::z(), 1.0).unwrap();
    let mut contacts = vec![stack.push_contact(balls[0], ground, touch).unwrap()];
    let above = ContactGeometry::spheres(&Vector3::new(0.0, 0.0, 2.0), [1.0, 1.0]).unwrap();
    for pair in balls.windows(2) {
        contacts.push(stack.push_contact(pair[0], pair[1], above).unwrap());
    }
    stack.set_gravity(Vector3::new(0.0, 0.0, -GRAVITY));
    (stack, balls, contacts)
}

#[test]
fn a_column_carries_its_weight() {
    let (mut stack, balls, contacts) = column(IndependentFriction::all(0.3, 0.1, 0.1).unwrap());
    let report = stack.solve(TimeStep::new(DT).unwrap(), InitialGuess::Zero, STOP);
    assert!(report.converged && report.iterations > 10, "{report:?}");
    let mut worst = Worst::of("weight in a column");
    for (level, &contact) in contacts.iter().enumerate() {
        let got = stack.force(contact).unwrap().normal;
        let wanted = (5 - level) as f64 * GRAVITY;
        worst.see((got / wanted - 1.0).abs(), || {
            format!("level {level}: {got}")
        });
    }
    for &ball in &balls {
        let left = stack.body(ball).unwrap().velocity().norm() / (GRAVITY * DT);
        worst.see(left, || format!("{ball:?}"));
    }
    worst.assert_within(&tolerance::MANIFOLD);
    // The second step begins with the answer.
    let again = stack.solve(TimeStep::new(2.0 * DT).unwrap(), InitialGuess::Last, STOP);
    assert!(again.converged && again.iterations <= 5, "{again:?}");
    let cold = stack.solve(TimeStep::new(DT).unwrap(), InitialGuess::Zero, STOP);
    assert!(cold.iterations > 10, "{cold:?}");
}

/// A sphere pushed sideways onto a row: every contact slips, sticks or opens.
#[test]
fn what_it_finds_obeys_the_laws_of_every_contact() {
    let (mut stack, balls, contacts) = column(IndependentFriction::all(0.3, 0.1, 0.1).unwrap());
    for (number, &ball) in balls.iter().enumerate() {
        let n = number as f64;
        let force = Vector3::new(3.0 * n - 4.0, 2.0 - n, 0.5 * n * n);
        stack
            .set_force(ball, force, Vector3::new(0.3, -n, 2.0 - n))
            .unwrap();
    }
    let report = stack.solve(TimeStep::new(DT).unwrap(), InitialGuess::Zero, STOP);
    assert!(report.converged, "{report:?}");
    let mut worst = Worst::of("manifold against the laws");
    let scale = GRAVITY * DT;
    let normals = [-1.0, 1.0, 1.0, 1.0, 1.0];
    for (level, &contact) in contacts.iter().enumerate() {
        // Velocities of the touching points, by hand.
        let below = if level == 0 {
            None
        } else {
            stack.body(balls[level - 1])
        };
        let own = stack.body(balls[level]).unwrap();
        let point = own.velocity() + own.angular_velocity().cross(&-Vector3::z());
        let other = below.map_or(Vector3::zeros(), |b| {
            b.velocity() + b.angular_velocity().cross(&Vector3::z())
        });
        let sign = normals[level];
        let slip = (point - other) * sign;
        let turn = (own.angular_velocity()
            - below.map_or(Vector3::zeros(), ContactBody::angular_velocity))
            * sign;
        let impulse = stack.contact(contact).unwrap().impulse();
        let (p, normal) = (impulse.normal, sign * slip.z);
        let lever = if level == 0 { 1.0 } else { 0.5 };
        // Signorini.
        worst.see((-p).max(0.0) / scale, || format!("{level}: pulls"));
        worst.see((-normal).max(0.0) / scale, || format!("{level}: overlaps"));
        worst.see((p * normal).abs() / (scale * scale), || {
            format!("{level}: pushes open")
        });
        // Coulomb: friction within its bound does the work −bound·speed.
        for (force, speed, bound) in [
            (
                impulse.sliding(),
                Vector3::new(slip.x, slip.y, 0.0),
                0.3 * p,
            ),
            (
                impulse.rolling(),
                Vector3::new(turn.x, turn.y, 0.0),
                0.1 * p * lever,
            ),
            (
                Vector3::z() * (impulse.torsion() * sign),
                Vector3::z() * turn.z,
                0.1 * p * lever,
            ),
        ] {
            let beyond = (force.norm() - bound).max(0.0) / scale;
            worst.see(beyond, || format!("{level}: more than friction can"));
            let gap = (force.dot(&speed) + bound * speed.norm()).abs() / (scale * scale);
            worst.see(gap, || format!("{level}: less than friction does"));
        }
    }
    worst.assert_within(&tolerance::MANIFOLD);
}

#[test]
#[cfg(target_pointer_width = "64")]
fn bodies_and_contacts_take_the_memory_that_the_documentation_tells() {
    let growth = |large: usize, small: usize| large - small;
    let body = growth(
        size_of::<ContactSystem<f64, All, 3, 1>>(),
        size_of::<ContactSystem<f64, All, 2, 1>>(),
    );
    let contact = growth(
        size_of::<ContactSystem<f64, All, 2, 2>>(),
        size_of::<ContactSystem<f64, All, 2, 1>>(),
    );
    assert_eq!((body, contact), (120, 312));
}

#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    let friction = IndependentFriction::sliding(0.3).unwrap();
    let mut small = ContactSystem::<f64, _, 2, 1>::new(no_bounce(), friction);
    let first = small.push_sphere(ball()).unwrap();
    let touch = ContactGeometry::spheres(&Vector3::new(2.0, 0.0, 0.0), [1.0, 1.0]).unwrap();
    assert_eq!(
        small.push_contact(first, first, touch),
        Err(ContactSystemError::SameBody)
    );
    let second = small.push_plate(floor()).unwrap();
    assert_eq!(
        small.push_sphere(ball()),
        Err(ContactSystemError::Full { capacity: 2 })
    );
    let contact = small.push_contact(first, second, touch).unwrap();
    let full = Err(ContactSystemError::Full { capacity: 1 });
    assert_eq!(small.push_contact(second, first, touch), full);
    assert!(small.force(contact).is_none(), "not solved yet");
    small.clear_contacts();
    assert_eq!(
        small.set_geometry(contact, touch),
        Err(ContactSystemError::Unknown)
    );
    assert!(small.contact(contact).is_none());
    let mut other = ContactSystem::<f64, _, 2, 1>::new(no_bounce(), friction);
    let zero = Vector3::zeros();
    assert_eq!(
        other.set_force(first, zero, zero),
        Err(ContactSystemError::Unknown)
    );
    assert_eq!(
        other.push_contact(first, second, touch),
        Err(ContactSystemError::Unknown)
    );
}

#[test]
fn nothing_to_do_is_done_at_once_and_nan_never_converges() {
    let mut empty = ContactSystem::<f64, _, 1, 1>::new(no_bounce(), IndependentFriction::none());
    let step = TimeStep::new(DT).unwrap();
    let report = empty.solve(step, InitialGuess::Last, STOP);
    assert!(report.converged && report.residual == 0.0 && report.iterations == 1);
    let none = SolverSettings {
        max_iterations: 0,
        ..STOP
    };
    assert!(!empty.solve(step, InitialGuess::Last, none).converged);
    let (mut stack, balls, _) = column(IndependentFriction::all(0.3, 0.1, 0.1).unwrap());
    let lost = Vector3::new(f64::NAN, 0.0, 0.0);
    stack.set_force(balls[2], lost, lost).unwrap();
    let report = stack.solve(
        step,
        InitialGuess::Last,
        SolverSettings {
            max_iterations: 7,
            ..STOP
        },
    );
    assert!(report.residual.is_nan() && !report.converged && report.iterations == 7);
}

#[test]
fn micrograms_converge_in_single_precision_too() {
    // Grains of 1e-15 kg: squares of their impulses vanish in f32.
    let cohesion = Cohesion::new(1e-14_f32, 1e-9, Attraction::Pull).unwrap();
    let law = NormalLaw::new(cohesion, 0.0).unwrap();
    let mut grains =
        ContactSystem::<f32, _, 3, 2>::new(law, IndependentFriction::sliding(0.3).unwrap());
    let grain = SphereBody {
        inv_mass: 1e15,
        inv_inertia: 2.5e27,
        ..ball()
    };
    let floor = WallBody {
        velocity: grain.velocity,
        inv_mass: 0.0,
    };
    let ground = grains.push_plate(floor).unwrap();
    let lower = grains.push_sphere(grain).unwrap();
    let upper = grains.push_sphere(grain).unwrap();
    let below = ContactGeometry::plate(1e-6, &Vector3::z(), 1e-6).unwrap();
    let between = ContactGeometry::spheres(&Vector3::new(0.0, 0.0, 2e-6), [1e-6, 1e-6]).unwrap();
    let below = grains.push_contact(lower, ground, below).unwrap();
    grains.push_contact(lower, upper, between).unwrap();
    grains.set_gravity(Vector3::new(0.0, 0.0, -9.81));
    let stop = SolverSettings {
        max_iterations: 200,
        tolerance: 1e-6,
    };
    let report = grains.solve(TimeStep::new(1e-5).unwrap(), InitialGuess::Zero, stop);
    assert!(report.converged && report.iterations > 5, "{report:?}");
    let weight = grains.force(below).unwrap().normal;
    assert!((weight / (2.0 * 9.81e-15) - 1.0).abs() < 1e-4, "{weight}");
}

/// Three balls that touch each other and lie on a plate, with these contacts' law.
fn heap(law: NormalLaw<f64>, friction: All) -> (ContactSystem<f64, All, 4, 6>, Vec<BodyHandle>) {
    let mut heap = ContactSystem::new(law, friction);
    let balls: Vec<_> = (0..3).map(|_| heap.push_sphere(ball()).unwrap()).collect();
    let plate = heap
        .push_plate(WallBody {
            inv_mass: 0.1,
            ..floor()
        })
        .unwrap();
    let half = 3.0_f64.sqrt();
    let places = [[0.0, 0.0], [2.0, 0.0], [1.0, half]].map(|[x, y]| Vector3::new(x, y, 1.0));
    for (first, second) in [(0, 1), (0, 2), (1, 2)] {
        let apart = places[second] - places[first];
        let touch = ContactGeometry::spheres(&apart, [1.0, 1.0]).unwrap();
        heap.push_contact(balls[first], balls[second], touch)
            .unwrap();
    }
    for &ball in &balls {
        let touch = ContactGeometry::plate(1.0, &Vector3::z(), 1.0).unwrap();
        heap.push_contact(ball, plate, touch).unwrap();
    }
    (heap, [balls, vec![plate]].concat())
}

fn kinetic(heap: &ContactSystem<f64, All, 4, 6>, bodies: &[BodyHandle]) -> f64 {
    let energy = |body: &BodyHandle| {
        let body = heap.body(*body).unwrap();
        let turning = if body.inv_inertia() > 0.0 {
            body.angular_velocity().norm_squared() / body.inv_inertia()
        } else {
            0.0
        };
        0.5 * (body.velocity().norm_squared() / body.inv_mass_normal() + turning)
    };
    bodies.iter().map(energy).sum()
}

#[test]
fn impacts_with_friction_never_add_energy() {
    let mut random = tribos_base::random::Random::new(5, 0);
    let mut signed = || 2.0 * random.unit() - 1.0;
    let mut rebounds = 0;
    for round in 0..300 {
        let restitution = [0.1, 0.5, 0.9, 1.0][round % 4];
        let mu = [0.0, 0.3, 1.0, 10.0][round / 4 % 4];
        let rolling = [0.0, 0.3][round / 16 % 2];
        let law = NormalLaw::new(Cohesion::NONE, restitution).unwrap();
        let friction = IndependentFriction::all(mu, rolling, rolling).unwrap();
        let (mut heap, bodies) = heap(law, friction);
        for &body in &bodies {
            match heap.body_mut(body) {
                Some(SystemBody::Sphere(ball)) => {
                    ball.velocity = Vector3::new(signed(), signed(), signed());
                    ball.spin = Vector3::new(signed(), signed(), signed());
                }
                Some(SystemBody::Plate(plate)) => plate.velocity.z = signed(),
                None => panic!("the body is there"),
            }
        }
        let before = kinetic(&heap, &bodies);
        heap.solve(TimeStep::new(DT).unwrap(), InitialGuess::Zero, STOP);
        let after = kinetic(&heap, &bodies);
        assert!(
            after <= before * (1.0 + 1e-12),
            "e {restitution}, mu {mu}: {before} becomes {after}"
        );
        // Without friction and loss all of it is left, whatever the impacts were.
        if restitution == 1.0 && mu == 0.0 && rolling == 0.0 {
            assert!((after / before - 1.0).abs() < 1e-11, "{before} {after}");
            rebounds += 1;
        }
    }
    assert!(rebounds > 5);
}

#[test]
fn an_impact_runs_through_a_row_in_one_step() {
    let law = NormalLaw::new(Cohesion::NONE, 1.0).unwrap();
    let mut row =
        ContactSystem::<f64, All, 4, 3>::new(law, IndependentFriction::all(0.3, 0.0, 0.0).unwrap());
    let balls: Vec<_> = (0..4).map(|_| row.push_sphere(ball()).unwrap()).collect();
    let touch = ContactGeometry::spheres(&Vector3::new(2.0, 0.0, 0.0), [1.0, 1.0]).unwrap();
    let contacts: Vec<_> = balls
        .windows(2)
        .map(|pair| row.push_contact(pair[0], pair[1], touch).unwrap())
        .collect();
    if let Some(SystemBody::Sphere(first)) = row.body_mut(balls[0]) {
        first.velocity.x = 1.0;
    }
    row.solve(TimeStep::new(DT).unwrap(), InitialGuess::Last, STOP);
    for (&ball, wanted) in balls.iter().zip([0.0, 0.0, 0.0, 1.0]) {
        assert!((row.body(ball).unwrap().velocity().x - wanted).abs() < 1e-15);
    }
    // Every contact has passed on the momentum, and remembers no force of it.
    for &contact in &contacts {
        assert!((row.contact(contact).unwrap().impulse().normal - 1.0).abs() < 1e-15);
    }
    row.solve(TimeStep::new(DT).unwrap(), InitialGuess::Last, STOP);
    for &contact in &contacts {
        assert_eq!(row.contact(contact).unwrap().impulse().normal, 0.0);
    }
}
