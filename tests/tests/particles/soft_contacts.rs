//! Single contacts of soft spheres beside closed forms.

use nalgebra::Vector3;
use tribos::cd::{Wall, WorldMaterials, solid};
use tribos::soft::{SoftSetup, SoftWorld, Stiffness};
use tribos_core::contact::{
    Attraction, Cohesion, ContactFriction, Frictionless, IndependentFriction, NormalLaw,
};

type Smooth = IndependentFriction<f64, Frictionless>;

/// Cohesion of strength 1 up to a gap.
fn sticky(range: f64) -> NormalLaw<f64> {
    let cohesion = Cohesion::new(1.0, range, Attraction::Pull).expect("cohesion is valid");
    NormalLaw::new(cohesion, 0.0).expect("the law is valid")
}

fn bouncy(restitution: f64) -> NormalLaw<f64> {
    NormalLaw::new(Cohesion::NONE, restitution).expect("the law is valid")
}

fn world<F: ContactFriction<f64>>(setup: SoftSetup<F>) -> SoftWorld<F> {
    SoftWorld::new(setup).expect("the setup is valid")
}

/// Takes steps up to a time.
fn run<F: ContactFriction<f64>>(world: &mut SoftWorld<F>, end: f64) {
    while world.state().time < end {
        world.step().expect("the step is taken");
    }
}

/// Speed after, deepest overlap and duration of a head-on impact of two equal spheres that start at a gap.
fn impact(setup: SoftSetup<Smooth>, speed: f64, gap: f64) -> [f64; 3] {
    let x = Vector3::x();
    let mut world = world(setup.sphere(Vector3::zeros(), 1.0, solid(1.0, 1.0)).sphere(
        x * (2.0 + gap),
        1.0,
        solid(1.0, 1.0),
    ));
    world.state_mut().spheres[0].velocity = x * (0.5 * speed);
    world.state_mut().spheres[1].velocity = x * (-0.5 * speed);
    let (mut deepest, mut began) = (0.0_f64, false);
    let mut start = 0.0;
    loop {
        world.step().expect("the step is taken");
        let state = world.state();
        let gap = state.positions[1].x - state.positions[0].x - 2.0;
        if gap < 0.0 && !began {
            (began, start) = (true, state.time);
        }
        deepest = deepest.max(-gap);
        if began && gap > 0.0 {
            let after = state.spheres[1].velocity.x - state.spheres[0].velocity.x;
            return [after, deepest, state.time - start];
        }
    }
}

fn smooth(law: NormalLaw<f64>, stiffness: Stiffness) -> SoftSetup<Smooth> {
    SoftSetup {
        longest: 0.1,
        ..SoftSetup::new(
            WorldMaterials::uniform(law, IndependentFriction::none()),
            stiffness,
        )
    }
}

/// One of each law.
const SPRINGS: [Stiffness; 2] = [Stiffness::Linear(1e3), Stiffness::Hertz(1e3)];

/// Gaps from which steps meet an impact at different instants, in shares of the way of a step at these speeds.
fn gaps(speed: f64) -> impl Iterator<Item = f64> {
    (0..8).map(move |index| speed * (0.05 + 1e-3 * f64::from(index)))
}

#[test]
fn impacts_have_the_restitution_that_was_asked_for_at_default_settings() {
    for stiffness in SPRINGS {
        for wanted in [1.0, 0.9, 0.7, 0.5, 0.3, 0.2, 0.1] {
            for (speed, gap) in [0.02, 0.2]
                .into_iter()
                .flat_map(|speed| gaps(speed).map(move |gap| (speed, gap)))
            {
                let setup = SoftSetup {
                    longest: 0.1,
                    ..SoftSetup::new(
                        WorldMaterials::uniform(bouncy(wanted), IndependentFriction::none()),
                        stiffness,
                    )
                };
                let [after, ..] = impact(setup, speed, gap);
                let error = after / speed / wanted - 1.0;
                assert!(
                    error.abs() < 5e-3,
                    "{stiffness:?} {wanted} {speed} {gap}: {error:e}"
                );
            }
        }
    }
}

#[test]
fn restitution_comes_closer_in_the_second_order_of_the_steps() {
    for stiffness in SPRINGS {
        for wanted in [0.7, 0.3] {
            let [coarse, fine] = [35.0, 140.0].map(|steps_per_collision| {
                let setup = SoftSetup {
                    steps_per_collision,
                    ..smooth(bouncy(wanted), stiffness)
                };
                (impact(setup, 0.1, 0.01)[0] / 0.1 - wanted).abs()
            });
            assert!(
                fine < 0.1 * coarse,
                "{stiffness:?} {wanted}: {coarse:e} {fine:e}"
            );
        }
    }
}

#[test]
fn damping_and_restitution_are_inverse() {
    for e in [1.0, 0.999, 0.7, 0.1353, 0.05, 1e-3] {
        assert!(
            (Stiffness::restitution_of(Stiffness::damping_ratio_of(e)) / e - 1.0).abs() < 1e-12,
            "{e}"
        );
    }
}

#[test]
fn an_undamped_hertzian_impact_is_as_deep_and_as_long_as_the_closed_form() {
    // 2 ∫ dx/√(1 − x^(5/2)) from 0 to 1 = (4 √π/5) Γ(2/5)/Γ(9/10), by mpmath.
    const DURATION: f64 = 2.943_275_3;
    let (modulus, radius) = (1e3_f64, 0.5_f64);
    for speed in [0.01, 0.1, 0.5] {
        let setup = SoftSetup {
            damping: 0.0,
            steps_per_collision: 300.0,
            ..smooth(bouncy(0.0), Stiffness::Hertz(modulus))
        };
        let [after, deepest, duration] = impact(setup, speed, 0.0);
        let mass = 0.5 / solid(1.0, 1.0).inv_mass;
        let expected = (15.0 / 16.0 * mass * speed * speed / (modulus * radius.sqrt())).powf(0.4);
        assert!((after / speed - 1.0).abs() < 1e-3, "{after} of {speed}");
        assert!(
            (deepest / expected - 1.0).abs() < 1e-3,
            "{deepest} {expected}"
        );
        let time = DURATION * expected / speed;
        assert!((duration / time - 1.0).abs() < 1e-2, "{duration} {time}");
    }
}

#[test]
fn cohesion_holds_up_to_its_strength_and_not_beyond() {
    for stiffness in [Stiffness::Linear(1e3), Stiffness::Hertz(1e3)] {
        for (load, holds) in [(0.5, true), (0.98, true), (1.02, false), (2.0, false)] {
            let ball = solid(1.0, 1.0);
            let up = Vector3::z();
            let mut setup = smooth(sticky(0.01), stiffness)
                .wall(Wall::fixed(up, 0.0))
                .sphere(up, 1.0, ball)
                .gravity(up * (load * ball.inv_mass));
            setup.longest = 1e-2;
            let mut world = world(setup);
            run(&mut world, 40.0);
            let height = world.state().positions[0].z - 1.0;
            assert_eq!(height < 0.0, holds, "{stiffness:?} {load}: {height}");
            if holds {
                // What is left of the pull is the spring's force.
                let expected = stiffness.overlap(1.0 - load, 1.0);
                assert!(
                    (height + expected).abs() < 1e-3 * expected,
                    "{height} {expected}"
                );
            }
        }
    }
}

#[test]
fn a_ball_that_slides_ends_rolling_with_five_sevenths_of_its_speed() {
    let (up, x) = (Vector3::z(), Vector3::x());
    for mu in [0.1, 0.4] {
        for direction in [x, -x, Vector3::new(0.6, 0.8, 0.0)] {
            let law = WorldMaterials::uniform(
                bouncy(0.0),
                IndependentFriction::sliding(mu).expect("mu is valid"),
            );
            let mut setup = SoftSetup::new(law, Stiffness::Linear(1e4))
                .wall(Wall::fixed(up, 0.0))
                .sphere(up, 1.0, solid(1.0, 1.0))
                .gravity(-up);
            setup.spheres[0].velocity = direction;
            setup.longest = 1e-2;
            let mut world = world(setup);
            run(&mut world, 1.0 / mu);
            let ball = &world.state().spheres[0];
            let error = (ball.velocity - direction * (5.0 / 7.0)).norm();
            // It sinks in at first: the friction of that moment is missing or extra.
            assert!(error < 2e-3, "{mu} {direction:?}: {error:e}");
            let slip = ball.velocity - ball.spin.cross(&up) * 1.0;
            assert!(slip.norm() < 1e-3, "{slip:?}");
        }
    }
}

#[test]
fn overlaps_fall_as_one_over_the_stiffness() {
    let up = Vector3::z();
    let mass = 1.0 / solid(1.0, 1.0).inv_mass;
    for stiffness in [1e2, 1e3, 1e4] {
        let mut setup = smooth(bouncy(0.0), Stiffness::Linear(stiffness))
            .wall(Wall::fixed(up, 0.0))
            .gravity(-up);
        for level in 0..3 {
            let at = up * (1.0 + 2.0 * f64::from(level));
            setup = setup.sphere(at, 1.0, solid(1.0, 1.0));
        }
        let mut world = world(setup);
        run(&mut world, 20.0);
        let state = world.state();
        let mut height = 0.0;
        for (level, weights) in [3.0, 2.0, 1.0].into_iter().enumerate() {
            let overlap = weights * mass / stiffness;
            height += if level == 0 { 1.0 } else { 2.0 } - overlap;
            let error = state.positions[level].z - height;
            assert!(
                error.abs() < 1e-3 * overlap,
                "{stiffness} {level}: {error:e}"
            );
        }
    }
}

#[test]
fn parameters_without_a_meaning_are_refused_by_name() {
    let refused = |change: &dyn Fn(&mut SoftSetup<Smooth>)| {
        let mut setup = smooth(bouncy(0.0), Stiffness::Linear(1.0));
        change(&mut setup);
        SoftWorld::new(setup)
            .map(|_| ())
            .expect_err("it is refused")
            .to_string()
    };
    let stiffness = refused(&|setup| setup.stiffness = Stiffness::Hertz(-1.0));
    assert!(
        stiffness.contains("stiffness") && stiffness.contains("-1"),
        "{stiffness}"
    );
    assert!(refused(&|setup| setup.damping = f64::NAN).contains("damping"));
    assert!(refused(&|setup| setup.steps_per_collision = 1.5).contains("steps"));
    assert!(refused(&|setup| setup.longest = 0.0).contains("step"));
    let resists = refused(&|setup| {
        let cohesion = Cohesion::new(1.0, 0.1, Attraction::Resistance).expect("it is valid");
        setup.laws.pairs.normal = NormalLaw::new(cohesion, 0.0).expect("it is valid");
    });
    assert!(resists.contains("Attraction::Pull"), "{resists}");
}

/// Two beads of 5 mm and 2500 kg/m³ that pull with 10 mN up to a gap of 50 µm.
const BEAD: [f64; 2] = [0.005, 2500.0];
const PULL: [f64; 2] = [0.01, 5e-5];

/// Whether two of them fly apart after they met at a speed.
fn fly_apart(stiffness: f64, restitution: f64, speed: f64, gap: f64) -> bool {
    let [radius, density] = BEAD;
    let cohesion = Cohesion::new(PULL[0], PULL[1], Attraction::Pull).expect("it is valid");
    let law = NormalLaw::new(cohesion, restitution).expect("it is valid");
    let setup = SoftSetup::new(
        WorldMaterials::uniform(law, IndependentFriction::<f64, Frictionless>::none()),
        Stiffness::Linear(stiffness),
    );
    let x = Vector3::x();
    let mut world = world(
        setup
            .sphere(Vector3::zeros(), radius, solid(radius, density))
            .sphere(x * (2.0 * radius + gap), radius, solid(radius, density)),
    );
    world.state_mut().spheres[0].velocity = x * (0.5 * speed);
    world.state_mut().spheres[1].velocity = x * (-0.5 * speed);
    run(&mut world, gap / speed + 0.05);
    world.state().positions[1].x - world.state().positions[0].x > 2.0 * radius + PULL[1]
}

/// The same by the equation of the contact, in steps of 1e-7 s of Runge and Kutta's method.
fn sticks_exactly(stiffness: f64, restitution: f64, speed: f64) -> bool {
    const DT: f64 = 1e-7;
    let [radius, density] = BEAD;
    let mass = 0.5 / solid(radius, density).inv_mass;
    let c = 2.0 * Stiffness::damping_ratio_of(restitution) * (stiffness * mass).sqrt();
    let acceleration = |x: f64, v: f64| {
        let push = if x > 0.0 {
            (stiffness * x + c * v).max(0.0)
        } else {
            0.0
        };
        (PULL[0] - push) / mass
    };
    let (mut x, mut v) = (-PULL[1], speed);
    while x >= -PULL[1] {
        let [k1, l1] = [v, acceleration(x, v)];
        let [k2, l2] = [
            v + 0.5 * DT * l1,
            acceleration(x + 0.5 * DT * k1, v + 0.5 * DT * l1),
        ];
        let [k3, l3] = [
            v + 0.5 * DT * l2,
            acceleration(x + 0.5 * DT * k2, v + 0.5 * DT * l2),
        ];
        let [k4, l4] = [v + DT * l3, acceleration(x + DT * k3, v + DT * l3)];
        x += DT / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
        let after = v + DT / 6.0 * (l1 + 2.0 * (l2 + l3) + l4);
        if x < 0.0 && v < 0.0 && after >= 0.0 {
            return true;
        }
        v = after;
    }
    false
}

#[test]
fn a_pair_that_pulls_sticks_up_to_the_speed_of_its_law_within_a_hundredth_at_default_settings() {
    for (stiffness, restitution) in [(1e4, 0.9), (1e4, 0.5), (1e6, 0.9)] {
        let [mut low, mut high] = [1e-3, 0.2];
        for _ in 0..20 {
            let middle = 0.5 * (low + high);
            if sticks_exactly(stiffness, restitution, middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        for gap in (0..8).map(|index| 1e-4 + 1.3e-7 * f64::from(index)) {
            for (share, flies) in [(0.5, false), (0.99, false), (1.01, true), (1.5, true)] {
                let speed = share * low;
                assert_eq!(
                    fly_apart(stiffness, restitution, speed, gap),
                    flies,
                    "{stiffness:e} {restitution} {share} {gap:e}"
                );
            }
        }
    }
}

#[test]
fn hard_beads_that_pull_stick_up_to_the_speed_of_rigid_ones() {
    let [radius, density] = BEAD;
    let mass = 0.5 / solid(radius, density).inv_mass;
    for restitution in [0.9_f64, 0.7] {
        // They leave the well at rest: e² (v² + w²) = w² with the well's speed w = √(2 F d/m).
        let well = (2.0 * PULL[0] * PULL[1] / mass).sqrt();
        let speed = well * (1.0 / (restitution * restitution) - 1.0).sqrt();
        for gap in [1e-4, 1.007e-4] {
            assert!(!fly_apart(1e7, restitution, 0.99 * speed, gap));
            assert!(fly_apart(1e7, restitution, 1.01 * speed, gap));
        }
    }
}

#[test]
fn an_elastic_ball_that_is_dropped_keeps_its_energy_for_seven_bounces_at_default_settings() {
    let (up, [radius, density]) = (Vector3::z(), BEAD);
    const GRAVITY: f64 = 9.81;
    let height = 0.02;
    for stiffness in [Stiffness::Linear(1e4), Stiffness::Hertz(2e6)] {
        let laws = WorldMaterials::uniform(
            bouncy(1.0),
            IndependentFriction::<f64, Frictionless>::none(),
        );
        let mut world = world(
            SoftSetup::new(laws, stiffness)
                .wall(Wall::fixed(up, 0.0))
                .gravity(up * -GRAVITY)
                .sphere(up * (radius + height), radius, solid(radius, density)),
        );
        let (mut bounces, mut was_falling) = (0, false);
        while bounces < 7 {
            world.step().expect("the step is taken");
            let state = world.state();
            let (speed, above) = (state.spheres[0].velocity.z, state.positions[0].z - radius);
            let is_falling = speed < 0.0;
            bounces += i32::from(was_falling && !is_falling);
            was_falling = is_falling;
            if above > 0.0 {
                let energy = 0.5 * speed * speed + GRAVITY * above;
                let error = energy / (GRAVITY * height) - 1.0;
                assert!(error.abs() < 1e-3, "{stiffness:?} {bounces}: {error:e}");
            }
        }
    }
}

#[test]
fn the_last_of_thirty_hertzian_spheres_takes_most_of_the_firsts_speed_at_default_settings() {
    // By Runge and Kutta's method on u" = δ^(3/2) in a chain, to five digits.
    const LAST: f64 = 0.985_7;
    const COUNT: usize = 30;
    let x = Vector3::x();
    for speed in [0.01, 0.1] {
        let mut setup = smooth(bouncy(1.0), Stiffness::Hertz(1e4));
        for index in 0..COUNT {
            setup = setup.sphere(x * (2.0 * index as f64), 1.0, solid(1.0, 1.0));
        }
        setup.spheres[0].velocity = x * speed;
        let mut world = world(setup);
        while world.state().spheres[COUNT - 1].velocity.x < 0.9 * speed
            || world.state().contacts[0].iter().any(|contact| {
                contact.bodies[1] as usize == COUNT - 1 && contact.force.normal > 0.0
            })
        {
            world.step().expect("the step is taken");
        }
        let last = world.state().spheres[COUNT - 1].velocity.x / speed;
        assert!((last - LAST).abs() < 1e-3, "{speed}: {last}");
    }
}
