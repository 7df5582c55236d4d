//! What contacts are for: balls that begin to roll, slopes, bonds that break, rebounds, tops.

use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactFriction, ContactGeometry, CoupledFriction,
    IndependentFriction, NormalLaw, SphereBody, WallBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::RoundLimitSurface;
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.05;
const DT: f64 = 1e-4;
const MU: f64 = 0.3;

/// A solid ball of 1 kg.
fn ball() -> SphereBody<f64> {
    SphereBody {
        velocity: Vector3::zeros(),
        spin: Vector3::zeros(),
        inv_mass: 1.0,
        inv_inertia: 2.5 / (RADIUS * RADIUS),
    }
}

fn table() -> WallBody<f64> {
    WallBody {
        velocity: Vector3::zeros(),
        inv_mass: 0.0,
    }
}

fn smooth() -> NormalLaw<f64> {
    NormalLaw::new(Cohesion::NONE, 0.0).unwrap()
}

fn resting() -> ContactGeometry<f64> {
    ContactGeometry::plate(RADIUS, &Vector3::z(), RADIUS).unwrap()
}

/// Steps of a ball on a table under a pull, until `ends` or for `steps`; returns steps done.
fn on_table<F: ContactFriction<f64>>(
    ball: &mut SphereBody<f64>,
    friction: &F,
    pull: Vector3<f64>,
    steps: usize,
    ends: impl Fn(&SphereBody<f64>) -> bool,
) -> usize {
    let mut table = table();
    for step in 0..steps {
        if ends(ball) {
            return step;
        }
        ball.velocity += pull * DT;
        let mut contact = Contact::new(&resting(), &smooth(), ball, &table, DT);
        contact.update(friction, ball, &mut table);
        assert!(ball.velocity.z.abs() < 1e-15, "it stays on the table");
    }
    steps
}

fn assert_near(quantity: &'static str, got: f64, wanted: f64, bound: &Bound) {
    let mut worst = Worst::of(quantity);
    worst.see((got / wanted - 1.0).abs(), || format!("{got} for {wanted}"));
    worst.assert_within(bound);
}

#[test]
fn a_sliding_ball_ends_rolling_at_five_sevenths() {
    for friction in [0.05, 0.3, 2.0] {
        let mut ball = ball();
        ball.velocity.x = 1.0;
        let sliding = IndependentFriction::sliding(friction).unwrap();
        let down = Vector3::new(0.0, 0.0, -GRAVITY);
        on_table(&mut ball, &sliding, down, 20_000, |_| false);
        let wanted = 5.0 / 7.0;
        assert_near(
            "slip to roll",
            ball.velocity.x,
            wanted,
            &tolerance::CONTACT_MOTION,
        );
        let rim = ball.spin.y * RADIUS;
        assert_near(
            "rim of the rolling ball",
            rim,
            wanted,
            &tolerance::CONTACT_MOTION,
        );
    }
}

#[test]
fn rolling_resistance_holds_a_ball_up_to_its_angle() {
    // At the plate r_eff is the radius: the torque of the weight about the contact point is
    // m g R sin, that of rolling friction at most mu_t m g R cos.
    let mu_rolling = 0.05_f64;
    let angle = mu_rolling.atan();
    let friction = IndependentFriction::sliding_rolling(MU, mu_rolling).unwrap();
    let slope = |angle: f64| Vector3::new(angle.sin(), 0.0, -angle.cos()) * GRAVITY;
    let mut below = ball();
    on_table(
        &mut below,
        &friction,
        slope(angle * (1.0 - 1e-9)),
        10_000,
        |_| false,
    );
    assert!(below.velocity.norm() < 1e-12, "{below:?}");
    let steep = 2.0 * angle;
    let mut above = ball();
    on_table(&mut above, &friction, slope(steep), 10_000, |_| false);
    // a = 5/7 g (sin − mu_t cos)
    let wanted = 5.0 / 7.0 * GRAVITY * (steep.sin() - mu_rolling * steep.cos());
    let got = above.velocity.x / (10_000.0 * DT);
    assert_near(
        "rolling down a slope",
        got,
        wanted,
        &tolerance::CONTACT_MOTION,
    );
    let mut barely = ball();
    on_table(
        &mut barely,
        &friction,
        slope(angle * (1.0 + 1e-6)),
        10_000,
        |_| false,
    );
    assert!(barely.velocity.x > 1e-8, "it rolls just above");
}

#[test]
fn a_ball_that_sticks_rolls_down_without_slip_and_a_steep_slope_makes_it_slip() {
    // Without rolling resistance: sticks up to tan = 7/2 mu, as 2/7 of the drive is friction.
    let sliding = IndependentFriction::sliding(MU).unwrap();
    for (tangent, slips) in [(3.5 * MU - 1e-3, false), (3.5 * MU + 1e-3, true)] {
        let angle = f64::atan(tangent);
        let mut ball = ball();
        let pull = Vector3::new(angle.sin(), 0.0, -angle.cos()) * GRAVITY;
        on_table(&mut ball, &sliding, pull, 5_000, |_| false);
        let slip = ball.velocity.x - ball.spin.y * RADIUS;
        assert_eq!(slip > 1e-6, slips, "{tangent}: {slip}");
    }
}

/// A sphere below a fixed one, pulled down; returns the work of the pull until the bond breaks, or
/// none if it holds for a second.
fn hang(attraction: Attraction, pull: f64) -> Option<f64> {
    const STRENGTH: f64 = 2.0;
    const RANGE: f64 = 1e-3;
    let cohesion = Cohesion::new(STRENGTH, RANGE, attraction).unwrap();
    let law = NormalLaw::new(cohesion, 0.0).unwrap();
    let mut ball = ball();
    let mut fixed = SphereBody {
        inv_mass: 0.0,
        inv_inertia: 0.0,
        ..ball
    };
    let mut depth = 2.0 * RADIUS;
    let dt = 1e-5;
    let mut broken = 0.0;
    for _ in 0..100_000 {
        let touch = ContactGeometry::spheres(&Vector3::new(0.0, 0.0, -depth), [RADIUS; 2]).unwrap();
        let mut contact = Contact::new(&touch, &law, &fixed, &ball, dt);
        ball.velocity.z -= pull * dt;
        contact.update(
            &IndependentFriction::sliding(MU).unwrap(),
            &mut fixed,
            &mut ball,
        );
        // Work against the bond.
        broken += contact.impulse().normal * ball.velocity.z;
        depth -= ball.velocity.z * dt;
        if depth > 2.0 * RADIUS + 2.0 * RANGE {
            let scale = STRENGTH * RANGE;
            let moved = ball.velocity.z.abs() * dt * STRENGTH;
            let mut worst = Worst::of("work of a broken bond (steps)");
            worst.see((broken - scale).abs() / moved, || format!("{attraction:?}"));
            worst.assert_within(&tolerance::CONTACT_STEPS);
            return Some(broken);
        }
    }
    assert!((depth - 2.0 * RADIUS).abs() < 1e-12, "it has not moved");
    None
}

#[test]
fn a_bond_holds_below_its_strength_and_costs_its_energy_above() {
    for attraction in [Attraction::Pull, Attraction::Resistance] {
        for pull in [0.0, 1.0, 1.99, 2.0] {
            assert_eq!(hang(attraction, pull), None, "{attraction:?} {pull}");
        }
        for pull in [2.1, 4.0, 20.0] {
            assert!(hang(attraction, pull).is_some(), "{attraction:?} {pull}");
        }
    }
}

#[test]
fn a_pair_let_go_at_a_gap_closes_under_a_pull_and_stays_under_a_resistance() {
    for (attraction, closes) in [(Attraction::Pull, true), (Attraction::Resistance, false)] {
        let law = NormalLaw::new(Cohesion::new(2.0, 1e-2, attraction).unwrap(), 0.0).unwrap();
        let (mut a, mut b) = (ball(), ball());
        let touch =
            ContactGeometry::spheres(&Vector3::new(2.0 * RADIUS + 5e-3, 0.0, 0.0), [RADIUS; 2]);
        let mut contact = Contact::new(&touch.unwrap(), &law, &a, &b, 1e-4);
        contact.update(&IndependentFriction::none(), &mut a, &mut b);
        assert_eq!(
            a.velocity.x > 0.0 && b.velocity.x < 0.0,
            closes,
            "{attraction:?}"
        );
    }
}

#[test]
fn a_head_on_collision_keeps_the_coefficient_of_restitution() {
    for e in [0.0, 0.25, 0.5, 1.0] {
        for (inv_a, inv_b) in [(1.0, 1.0), (1.0, 0.1), (0.0, 3.0)] {
            let law = NormalLaw::new(Cohesion::NONE, e).unwrap();
            let mut a = ball();
            a.inv_mass = inv_a;
            a.velocity.x = 1.0;
            let mut b = SphereBody {
                inv_mass: inv_b,
                ..ball()
            };
            b.velocity.x = -0.5;
            let touch =
                ContactGeometry::spheres(&Vector3::new(2.0 * RADIUS, 0.0, 0.0), [RADIUS; 2]);
            let mut contact = Contact::new(&touch.unwrap(), &law, &a, &b, DT);
            contact.update(&IndependentFriction::none(), &mut a, &mut b);
            let parting = b.velocity.x - a.velocity.x;
            assert!((parting - 1.5 * e).abs() < 1e-15, "{e}: {parting}");
        }
    }
}

#[test]
fn an_oblique_impact_slips_or_sticks_as_the_closed_solution_does() {
    // Two solid balls (Walton 1993): of the slip 7/2 μ (1 + e) of the approach goes, or all of it.
    for restitution in [0.0, 0.3, 0.7, 1.0] {
        let law = NormalLaw::new(Cohesion::NONE, restitution).unwrap();
        let most = 3.5 * MU * (1.0 + restitution);
        for slip in [0.0, 0.5, 0.999 * most, 1.001 * most, 20.0] {
            let (mut a, mut b) = (ball(), ball());
            a.velocity = Vector3::new(0.7, 0.5 * slip, 0.0);
            b.velocity = Vector3::new(-0.3, -0.5 * slip, 0.0);
            let touch =
                ContactGeometry::spheres(&Vector3::new(2.0 * RADIUS, 0.0, 0.0), [RADIUS; 2]);
            let energy = |a: &SphereBody<f64>, b: &SphereBody<f64>| {
                [a, b]
                    .map(|ball| {
                        ball.velocity.norm_squared() + ball.spin.norm_squared() / ball.inv_inertia
                    })
                    .iter()
                    .sum::<f64>()
                    / 2.0
            };
            let before = energy(&a, &b);
            let mut contact = Contact::new(&touch.unwrap(), &law, &a, &b, DT);
            contact.update(&IndependentFriction::sliding(MU).unwrap(), &mut a, &mut b);
            // Masses 1/2 along the normal, 1/7 across it.
            assert!((contact.impulse().normal - 0.5 * (1.0 + restitution)).abs() < 1e-15);
            let stopped = slip.min(most);
            let after = contact.velocity(&a, &b);
            assert!((after.normal - restitution).abs() < 1e-15);
            assert!((after.sliding().y + (slip - stopped)).abs() < 1e-14);
            let lost =
                0.25 * (1.0 - restitution * restitution) + stopped * (2.0 * slip - stopped) / 14.0;
            assert!((before - energy(&a, &b) - lost).abs() < 1e-13 * before);
        }
    }
}

/// Steps that a spinning ball needs to stop, and the time in closed form: I ω / torque.
fn assert_spins_down<F: ContactFriction<f64>>(friction: &F, mu_torsion: f64) {
    let mut top = ball();
    top.spin.z = 20.0;
    let down = Vector3::new(0.0, 0.0, -GRAVITY);
    let steps = on_table(&mut top, friction, down, 100_000, |ball| ball.spin.z == 0.0);
    assert_eq!(top.velocity, Vector3::zeros());
    let wanted = 0.4 * RADIUS * RADIUS * 20.0 / (mu_torsion * GRAVITY * RADIUS) / DT;
    let mut worst = Worst::of("spin-down time (steps)");
    worst.see((steps as f64 - wanted).abs(), || {
        format!("{steps} for {wanted}")
    });
    worst.assert_within(&tolerance::CONTACT_STEPS);
}

#[test]
fn a_top_spins_down_under_torsion_friction() {
    assert_spins_down(
        &IndependentFriction::sliding_torsion(MU, 0.05).unwrap(),
        0.05,
    );
    assert_spins_down(&IndependentFriction::all(MU, 0.1, 0.02).unwrap(), 0.02);
    // Pure spinning of the exact set: mu R_c 2/3.
    let set = RoundLimitSurface::new(CoulombDisk, MU, 0.25).unwrap();
    assert_spins_down(
        &CoupledFriction::sliding_torsion(set),
        MU * 0.25 * 2.0 / 3.0,
    );
}

#[test]
fn a_spinning_contact_slides_more_easily_under_the_coupled_set_only() {
    let set = RoundLimitSurface::new(CoulombDisk, MU, 0.25).unwrap();
    let thresholds = IndependentFriction::sliding_torsion(MU, MU * 0.25 * 2.0 / 3.0).unwrap();
    let launched = || {
        let mut ball = ball();
        ball.velocity.x = 1.0;
        ball.spin.z = 400.0;
        ball
    };
    let down = Vector3::new(0.0, 0.0, -GRAVITY);
    let (mut coupled, mut apart) = (launched(), launched());
    on_table(
        &mut coupled,
        &CoupledFriction::sliding_torsion(set),
        down,
        100,
        |_| false,
    );
    on_table(&mut apart, &thresholds, down, 100, |_| false);
    let wanted = 1.0 - MU * GRAVITY * 100.0 * DT;
    assert_near(
        "sliding for itself",
        apart.velocity.x,
        wanted,
        &tolerance::CONTACT_MOTION,
    );
    assert!(
        coupled.velocity.x > 0.5 * (1.0 + wanted),
        "{}",
        coupled.velocity.x
    );
}
