//! A row of spheres under too few sweeps rings as diffusion of information says.

use tribos::cd::{IterationOrder, World};
use tribos_tests::sound::{expected, measured, pushed, random_q};

#[test]
fn a_row_under_random_sweeps_rings_as_diffusion_says() {
    let (period, damping) = expected(random_q());
    let mut means = [0.0; 2];
    const SEEDS: u64 = 8;
    for seed in 0..SEEDS {
        let got = measured(IterationOrder::Random { seed });
        println!("seed {seed}: period {:.3}, damping {:.5}", got.0, got.1);
        means[0] += got.0 / SEEDS as f64;
        means[1] += got.1 / SEEDS as f64;
    }
    println!("mean {means:?}; theory: period {period:.3}, damping {damping:.5}");
    // The links are 1/200 of the wave, its ends half a link uncertain: 1 % in k, 2 % in the damping,
    // whose scatter over seeds leaves 1 % in the mean.
    assert!((means[0] / period - 1.0).abs() < 0.015, "period");
    assert!((means[1] / damping - 1.0).abs() < 0.03, "damping");
}

#[test]
fn orders_differ_in_the_speed_of_sound() {
    let random = expected(random_q()).0;
    for order in [IterationOrder::Fixed, IterationOrder::Alternating] {
        let (period, damping) = measured(order);
        let q = random_q() * (random / period).powi(2);
        println!("{order:?}: period {period:.3}, damping {damping:.5}, q {q:.3}");
        assert!((period / random - 1.0).abs() > 0.05, "{order:?}");
    }
}

#[test]
fn enough_sweeps_make_the_row_rigid() {
    let mut setup = pushed(IterationOrder::Alternating);
    // Far more than (L/d)² = 2,500.
    setup.solver.most_sweeps = 40_000;
    let mut world = World::new(setup).expect("the setup is valid");
    for _ in 0..5 {
        world.step().expect("the row can step");
        assert!(world.state().walls[1].plate.velocity.norm() < 1e-9);
    }
}
