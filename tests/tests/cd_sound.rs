//! Too few sweeps make a row of rigid spheres elastic: a damped sound wave with known speed.
//!
//! Information diffuses by D = q N_I d²/dt in a step of N_I sweeps, q = (4√e − 5)/2 for random
//! orders, which gives waves c = √(q N_I) d/dt with the rate of damping D k²/2 (Unger, Brendel,
//! Wolf and Kertész 2002).

use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos::cd::{Laws, Method, Order, Pace, Setup, Solver, Stop, Wall, World};
use tribos_tests::packings::{Smooth, dry, row};

/// Spheres in the row; the piston at its end is one more body of the same mass.
const SPHERES: usize = 49;
/// Sweeps of a step.
const SWEEPS: usize = 40;
/// Periods that are compared.
const PERIODS: usize = 3;

/// A row between a wall and a piston of one sphere's mass, pushed from time 0 by 0.05 m d/dt².
fn pushed(order: Order) -> Setup<Smooth> {
    let mut setup = row(SPHERES, 0.0, Laws::uniform(dry(), Smooth::none()));
    let mass = 1.0 / setup.spheres[0].inv_mass;
    let end = Wall::piston(-Vector3::x(), -2.0 * SPHERES as f64, mass, 0.1 * mass);
    setup.walls.push(end);
    setup.pace = Pace {
        longest: 1.0,
        motion: 0.3,
    };
    setup.solver = Solver {
        method: Method::GaussSeidel {
            order,
            stop: Stop::Fixed,
        },
        most_sweeps: SWEEPS,
        warm_start: true,
    };
    setup
}

/// Period and rate of damping of the last body's velocity, in steps: from its zeros, and from its
/// swing between them, which is that of the fundamental wave once the others are gone.
fn measured(order: Order) -> (f64, f64) {
    let mut world = World::new(pushed(order)).expect("the setup is valid");
    let (mut zeros, mut swings) = (Vec::new(), Vec::new());
    let (mut last, mut swing) = (0.0_f64, 0.0);
    for step in 1.. {
        let report = world.step().expect("the row can step");
        assert_eq!(report.dt, 1.0, "the step must not shrink");
        let speed = -world.state().walls[1].plate.velocity.x;
        if speed * last < 0.0 {
            zeros.push(f64::from(step) - speed / (speed - last));
            swings.push(swing);
            swing = 0.0;
        }
        if zeros.len() > 2 * PERIODS {
            break;
        }
        swing += speed;
        last = speed;
    }
    let halves = 2.0 * PERIODS as f64;
    let period = 2.0 * (zeros[2 * PERIODS] - zeros[0]) / halves;
    // The first swing begins at rest, before the wave has formed.
    let ratio: f64 = swings[1] / swings[2 * PERIODS];
    (period, ratio.abs().ln() / (0.5 * period * (halves - 1.0)))
}

/// Period and rate of damping by the theory, in steps.
fn expected(q: f64) -> (f64, f64) {
    let diffusion = q * SWEEPS as f64;
    let speed = diffusion.sqrt();
    // A quarter of the wave from the wall to the free end.
    let k = 0.5 * PI / (SPHERES + 1) as f64;
    let omega = k * (diffusion - 0.25 * (diffusion * k).powi(2)).sqrt();
    assert!(k < 2.0 * speed / diffusion, "the wave is not overdamped");
    (2.0 * PI / omega, 0.5 * diffusion * k * k)
}

/// q of random orders.
fn random_q() -> f64 {
    0.5 * (4.0 * 0.5_f64.exp() - 5.0)
}

#[test]
fn a_row_under_random_sweeps_rings_as_diffusion_says() {
    let (period, damping) = expected(random_q());
    let mut means = [0.0; 2];
    const SEEDS: u64 = 8;
    for seed in 0..SEEDS {
        let got = measured(Order::Random { seed });
        println!("seed {seed}: period {:.3}, damping {:.5}", got.0, got.1);
        means[0] += got.0 / SEEDS as f64;
        means[1] += got.1 / SEEDS as f64;
    }
    println!("mean {means:?}; theory: period {period:.3}, damping {damping:.5}");
    // One step is 1/36 of a period and the row 50 links: the continuum is good to a few percent.
    assert!((means[0] / period - 1.0).abs() < 0.03, "period");
    assert!((means[1] / damping - 1.0).abs() < 0.10, "damping");
}

#[test]
fn orders_differ_in_the_speed_of_sound() {
    let random = expected(random_q()).0;
    for order in [Order::Fixed, Order::Alternating] {
        let (period, damping) = measured(order);
        let q = random_q() * (random / period).powi(2);
        println!("{order:?}: period {period:.3}, damping {damping:.5}, q {q:.3}");
        assert!((period / random - 1.0).abs() > 0.05, "{order:?}");
    }
}

#[test]
fn enough_sweeps_make_the_row_rigid() {
    let mut setup = pushed(Order::Alternating);
    // Far more than (L/d)² = 2,500.
    setup.solver.most_sweeps = 40_000;
    let mut world = World::new(setup).expect("the setup is valid");
    for _ in 0..5 {
        world.step().expect("the row can step");
        assert!(world.state().walls[1].plate.velocity.norm() < 1e-9);
    }
}
