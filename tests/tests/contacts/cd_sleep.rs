//! Groups at rest are left alone, wake when they are touched, and change nothing by sleeping.

use nalgebra::Vector3;
use tribos::cd::{StepReport, World, WorldMaterials, WorldSetup};
use tribos_tests::packings::{Rough, accelerated, chain, dry, rough};

/// Spheres of each of the two chains; one more falls.
const CHAIN: usize = 4;
/// Speed of stillness.
const STILL: f64 = 1e-7;

/// Two chains 8 apart, and a sphere that falls on the top of the first, off its middle.
fn scene(sleep_speed: f64) -> WorldSetup<Rough> {
    let mut setup = chain(
        2 * CHAIN + 1,
        WorldMaterials::uniform(dry(), rough(0.4, 0.1, 0.1)),
    );
    for body in CHAIN..2 * CHAIN {
        setup.positions[body] = Vector3::new(8.0, 0.0, 2.0 * (body - CHAIN) as f64 + 1.0);
    }
    setup.positions[2 * CHAIN] = Vector3::new(0.4, 0.0, 2.0 * CHAIN as f64 + 3.0);
    setup.solver = accelerated(1e-10);
    setup.sleep_speed = sleep_speed;
    setup
}

fn stepped(world: &mut World<Rough>) -> StepReport {
    world.step().expect("the chains can step")
}

#[test]
fn sleepers_have_no_contacts_and_wake_when_hit() {
    let mut world = World::new(scene(STILL)).expect("the setup is valid");
    let first = stepped(&mut world);
    assert_eq!((first.awake, first.contacts), (2 * CHAIN + 1, 2 * CHAIN));
    let mut slept = 0;
    let hit = loop {
        let report = stepped(&mut world);
        if report.awake == 1 {
            slept += 1;
            assert_eq!(report.contacts, 0);
            // Who sleeps does not move at all.
            assert!(
                world.state().spheres[..2 * CHAIN]
                    .iter()
                    .all(|s| s.velocity.norm() == 0.0)
            );
        } else if slept > 0 {
            break report;
        }
    };
    println!("asleep for {slept} steps, then {hit:?}");
    assert!(slept > 20);
    // The struck chain is awake, the other one is not.
    assert_eq!(hit.awake, CHAIN + 1);
    for _ in 0..50 {
        assert_eq!(stepped(&mut world).awake, CHAIN + 1);
    }
    let awake = world.state().sleep.awake();
    assert!(awake[..CHAIN].iter().all(|awake| *awake) && !awake[CHAIN..2 * CHAIN].contains(&true));
    assert!(world.state().spheres[CHAIN - 1].velocity.norm() > 0.01);
}

#[test]
fn sleep_changes_nothing_beyond_the_solvers_tolerance() {
    let mut worlds = [STILL, 0.0].map(|still| World::new(scene(still)).expect("valid"));
    let mut slept = 0;
    let mut apart = 0.0_f64;
    while worlds[0].state().time < 3.0 {
        let [sleepy, wakeful] = worlds.each_mut().map(stepped);
        assert!((sleepy.dt - wakeful.dt).abs() < 1e-8);
        slept += wakeful.awake - sleepy.awake;
        let [a, b] = worlds.each_ref().map(|world| &world.state().positions);
        let far = a.iter().zip(b).map(|(x, y)| (x - y).norm());
        apart = far.fold(apart, f64::max);
    }
    println!("{slept} bodies' steps saved, places differ by {apart:e}");
    assert!(slept > 500);
    // Stillness is given up to STILL for 4 steps; the collapse of the chain makes it grow.
    assert!(apart < 1e-6, "{apart:e}");
    let book = worlds[0].state().energy;
    assert!(book.imbalance().abs() < 1e-12 * book.work.abs());
    assert!(book.stilled < 1e-12);
}

#[test]
fn a_moving_wall_wakes_what_it_touches() {
    let mut world = World::new(scene(STILL)).expect("the setup is valid");
    while stepped(&mut world).awake != 1 {}
    world.state_mut().walls[0].plate.velocity.z = 0.1;
    assert_eq!(stepped(&mut world).awake, 2 * CHAIN + 1);
    let lifted = world.state().spheres[..2 * CHAIN]
        .iter()
        .map(|s| s.velocity.z);
    lifted.for_each(|speed| assert!((speed - 0.1).abs() < 1e-8, "{speed}"));
}
