//! Tests of hard spheres.

use super::*;
use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::random::Random;

type Tested = Result<(), Box<dyn std::error::Error>>;

const LAWS: [(f64, Tangential); 5] = [
    (1.0, Tangential::Smooth),
    (0.8, Tangential::Smooth),
    (0.6, Tangential::Rough { restitution: 0.3 }),
    (0.9, Tangential::Rough { restitution: -0.5 }),
    (
        0.7,
        Tangential::Coulomb {
            mu: 0.2,
            restitution: 0.4,
        },
    ),
];

/// A number around zero.
fn even(numbers: &mut Random) -> f64 {
    2.0 * numbers.unit() - 1.0
}

fn vector(numbers: &mut Random) -> Vector3<f64> {
    Vector3::from([(); 3].map(|()| even(numbers)))
}

/// A cubic lattice with random motions, cells apart by `spacing`.
fn lattice(edge: usize, spacing: f64, seed: u64) -> Vec<(Vector3<f64>, Motion)> {
    let mut numbers = Random::new(seed, 0);
    let place = |k: usize| [k % edge, k / edge % edge, k / edge / edge];
    let mut motion = || Motion {
        velocity: vector(&mut numbers),
        spin: vector(&mut numbers),
    };
    (0..edge * edge * edge)
        .map(|k| {
            (
                Vector3::from(place(k).map(|i| i as f64 * spacing)),
                motion(),
            )
        })
        .collect()
}

fn energy(motion: &Motion) -> f64 {
    0.5 * motion.velocity.norm_squared() + 0.2 * motion.spin.norm_squared()
}

#[test]
fn a_collision_keeps_momenta_and_loses_what_its_law_says() -> Tested {
    let mut numbers = Random::new(3, 0);
    for (e, tangential) in LAWS {
        let law = Impact::new(e, tangential)?;
        for _ in 0..200 {
            let normal = vector(&mut numbers).normalize();
            let mut motion = || Motion {
                velocity: vector(&mut numbers),
                spin: vector(&mut numbers),
            };
            let (a, b) = (motion(), motion());
            let (mut a2, mut b2) = (a, b);
            let loss = law.collide(&normal, &mut a2, &mut b2);
            let surface = |a: &Motion, b: &Motion| {
                b.velocity + b.spin.cross(&-normal) - a.velocity - a.spin.cross(&normal)
            };
            let (before, after) = (surface(&a, &b), surface(&a2, &b2));
            let (before_n, after_n) = (before.dot(&normal), after.dot(&normal));
            if before_n >= 0.0 {
                assert_eq!((a2, b2, loss), (a, b, 0.0));
                continue;
            }
            // Momentum, and angular momentum about the point of contact.
            assert!((a2.velocity + b2.velocity - a.velocity - b.velocity).norm() < 1e-14);
            let angular = |a: &Motion, b: &Motion| {
                0.4 * (a.spin + b.spin) + normal.cross(&(b.velocity - a.velocity))
            };
            assert!((angular(&a2, &b2) - angular(&a, &b)).norm() < 1e-14);
            // Restitutions along the normal and the tangent.
            assert!((after_n + e * before_n).abs() < 1e-14);
            let [slid, slides] = [before - normal * before_n, after - normal * after_n];
            match tangential {
                Tangential::Smooth => assert!((slides - slid).norm() < 1e-14),
                Tangential::Rough { restitution } => {
                    assert!((slides + slid * restitution).norm() < 1e-14);
                }
                Tangential::Coulomb { mu, restitution } => {
                    let impulse = b2.velocity - b.velocity;
                    let push = impulse.dot(&normal);
                    let rub = (impulse - normal * push).norm();
                    let sticks = (slides + slid * restitution).norm() < 1e-14;
                    assert!(rub <= mu * push * (1.0 + 1e-12));
                    assert!(sticks || (rub / (mu * push) - 1.0).abs() < 1e-12);
                }
            }
            let kept = energy(&a2) + energy(&b2);
            assert!((energy(&a) + energy(&b) - kept - loss).abs() < 1e-14);
            assert!(loss >= 0.0);
        }
    }
    Ok(())
}

#[test]
fn coefficients_outside_their_domains_are_refused() {
    let rough = |restitution| Tangential::Rough { restitution };
    let coulomb = |mu| Tangential::Coulomb {
        mu,
        restitution: 0.0,
    };
    for (e, tangential, name) in [
        (-0.1, Tangential::Smooth, "restitution"),
        (1.1, Tangential::Smooth, "restitution"),
        (f64::NAN, Tangential::Smooth, "restitution"),
        (0.5, rough(-1.1), "tangential restitution"),
        (0.5, rough(f64::NAN), "tangential restitution"),
        (0.5, coulomb(-0.1), "sliding coefficient"),
        (0.5, coulomb(f64::INFINITY), "sliding coefficient"),
    ] {
        assert_eq!(Impact::new(e, tangential).unwrap_err().name, name);
    }
}

#[test]
fn spheres_that_cannot_be_are_refused() -> Tested {
    let law = Impact::new(1.0, Tangential::Smooth)?;
    let good = lattice(3, 3.0, 1);
    let new = |length, bodies: &[_], tc| HardSpheres::new(length, bodies, law, tc).map(|_| ());
    assert_eq!(new(9.0, &good, 0.0), Ok(()));
    assert_eq!(new(6.0, &good, 0.0), Err(EventError::Length(6.0)));
    assert!(matches!(
        new(f64::NAN, &good, 0.0),
        Err(EventError::Length(_))
    ));
    assert_eq!(new(9.0, &good, -1.0), Err(EventError::ContactTime(-1.0)));
    assert_eq!(new(9.0, &[], 0.0), Err(EventError::Count(0)));
    let mut bad = good.clone();
    bad[5].1.spin.y = f64::NAN;
    assert_eq!(new(9.0, &bad, 0.0), Err(EventError::NotFinite(5)));
    let mut bad = good;
    bad[0].0.z = 1.5;
    assert_eq!(new(9.0, &bad, 0.0), Err(EventError::Overlap(0, 9)));
    Ok(())
}

/// Brute force: of all images of all pairs, the earliest meeting from the current time on.
fn next_meeting(
    places: &[Vector3<f64>],
    motions: &[Motion],
    length: f64,
) -> Option<(f64, [usize; 2], Vector3<f64>)> {
    let mut first: Option<(f64, [usize; 2], Vector3<f64>)> = None;
    let images =
        || (0..125).map(|k| Vector3::from([k % 5 - 2, k / 5 % 5 - 2, k / 25 - 2].map(f64::from)));
    for j in 0..places.len() {
        for i in 0..j {
            for image in images() {
                let apart = places[j] - places[i] + image * length;
                let velocity = motions[j].velocity - motions[i].velocity;
                let (b, a) = (apart.dot(&velocity), velocity.norm_squared());
                let d = b * b - a * (apart.norm_squared() - 4.0);
                if b >= 0.0 || d < 0.0 {
                    continue;
                }
                let time = (-b - d.sqrt()) / a;
                if first.is_none_or(|(earliest, ..)| time < earliest) {
                    first = Some((time, [i, j], apart + velocity * time));
                }
            }
        }
    }
    first
}

#[test]
fn cells_find_the_collisions_of_brute_force() -> Tested {
    for (e, tangential) in LAWS {
        for spacing in [2.2, 3.5] {
            let law = Impact::new(e, tangential)?;
            let length = 3.0 * spacing;
            let start = lattice(3, spacing, 8);
            let mut gas = HardSpheres::new(length, &start, law, 0.0)?;
            let (mut places, mut motions): (Vec<_>, Vec<_>) = start.into_iter().unzip();
            let mut time = 0.0;
            for count in 1..=60 {
                let (after, [i, j], apart) =
                    next_meeting(&places, &motions, length).ok_or("no meeting")?;
                time += after;
                for (place, motion) in places.iter_mut().zip(&motions) {
                    *place += motion.velocity * after;
                }
                let [mut a, mut b] = [motions[i], motions[j]];
                law.collide(&apart.normalize(), &mut a, &mut b);
                (motions[i], motions[j]) = (a, b);
                assert_eq!(gas.advance(count, f64::INFINITY), Advance::Collisions);
                assert!((gas.time() - time).abs() < 1e-9, "{count}");
                for (mine, theirs) in gas.motions().zip(&motions) {
                    assert!((mine.velocity - theirs.velocity).norm() < 1e-7, "{count}");
                    assert!((mine.spin - theirs.spin).norm() < 1e-7, "{count}");
                }
            }
            let wrapped = |place: &Vector3<f64>| place.map(|x| x - length * (x / length).floor());
            for (mine, theirs) in gas.places().iter().zip(&places) {
                let off = (mine - wrapped(theirs)).map(|x| x - length * (x / length).round());
                assert!(off.norm() < 1e-7);
            }
        }
    }
    Ok(())
}

#[test]
fn an_elastic_gas_goes_back_to_its_start() -> Tested {
    let law = Impact::new(1.0, Tangential::Smooth)?;
    let start = lattice(4, 2.6, 5);
    let mut gas = HardSpheres::new(10.4, &start, law, 0.0)?;
    assert_eq!(gas.advance(u64::MAX, 1.0), Advance::Time);
    assert!(gas.collisions() > 40, "{}", gas.collisions());
    let back = |motion: &Motion| Motion {
        velocity: -motion.velocity,
        spin: -motion.spin,
    };
    let turned: Vec<_> = gas
        .places()
        .into_iter()
        .zip(gas.motions().map(back))
        .collect();
    let mut gas = HardSpheres::new(10.4, &turned, law, 0.0)?;
    gas.advance(u64::MAX, 1.0);
    for ((place, motion), (now, then)) in gas.places().iter().zip(gas.motions()).zip(&start) {
        let off = (place - now).map(|x| x - 10.4 * (x / 10.4).round());
        assert!(off.norm() < 1e-6, "{off}");
        assert!((motion.velocity + then.velocity).norm() < 1e-6);
    }
    Ok(())
}

#[test]
fn momentum_and_the_energy_balance_are_kept() -> Tested {
    for (e, tangential) in LAWS {
        let law = Impact::new(e, tangential)?;
        let start = lattice(6, 2.5, 2);
        let sum = |motions: &mut dyn Iterator<Item = Motion>| {
            motions.fold((Vector3::zeros(), 0.0), |(p, k), motion| {
                (p + motion.velocity, k + energy(&motion))
            })
        };
        let before = sum(&mut start.iter().map(|(_, motion)| *motion));
        let mut gas = HardSpheres::new(15.0, &start, law, 0.0)?;
        assert_eq!(gas.advance(4000, f64::INFINITY), Advance::Collisions);
        let after = sum(&mut gas.motions().copied());
        assert!((after.0 - before.0).norm() < 1e-11);
        assert!((before.1 - after.1 - gas.dissipated_energy()).abs() < 1e-11 * before.1);
        let places = gas.places();
        let radii = vec![1.0; places.len()];
        let space = tribos_base::space::PeriodicBox::new([Some(15.0); 3])?;
        let overlapping = tribos_base::space::pairs::neighbours(&space, &places, &radii, -1e-12)?;
        assert!(overlapping.is_empty());
    }
    Ok(())
}

#[test]
fn a_stored_gas_goes_on_with_the_same_bits() -> Tested {
    for (e, tangential) in LAWS {
        let law = Impact::new(e, tangential)?;
        let mut gas = HardSpheres::new(14.0, &lattice(5, 2.8, 4), law, 1e-4)?;
        for stop in [0, 1, 777] {
            gas.advance(stop, f64::INFINITY);
            let mut map = Map::new();
            gas.freeze().put(&mut map);
            let stored = Stored::read(&Value::Object(map), gas.count())?;
            let mut again = HardSpheres::restore(stored, 14.0, law, 1e-4);
            let mut on = gas.clone();
            for gas in [&mut on, &mut again] {
                assert_eq!(gas.advance(stop + 2000, f64::INFINITY), Advance::Collisions);
            }
            assert_eq!(on.totals, again.totals);
            assert_eq!(on.places(), again.places());
            assert!(on.motions().eq(again.motions()));
        }
    }
    Ok(())
}

#[test]
fn time_can_be_cut_anywhere() -> Tested {
    let law = Impact::new(0.9, Tangential::Smooth)?;
    let start = lattice(4, 3.0, 6);
    let mut whole = HardSpheres::new(12.0, &start, law, 0.0)?;
    let mut cut = whole.clone();
    assert_eq!(whole.advance(u64::MAX, 2.0), Advance::Time);
    for step in 1..=20 {
        cut.advance(u64::MAX, 0.1 * f64::from(step));
    }
    assert_eq!(whole.totals, cut.totals);
    assert_eq!(whole.places(), cut.places());
    Ok(())
}

#[test]
fn spheres_without_a_partner_come_to_their_end() -> Tested {
    let law = Impact::new(1.0, Tangential::Smooth)?;
    let motion = Motion {
        velocity: Vector3::zeros(),
        spin: Vector3::zeros(),
    };
    let still = [(Vector3::zeros(), motion), (Vector3::x() * 3.0, motion)];
    let mut gas = HardSpheres::new(9.0, &still, law, 0.0)?;
    assert_eq!(gas.advance(1, 5.0), Advance::Rest);
    assert_eq!(gas.time(), 5.0);
    Ok(())
}

#[test]
fn theory_follows_closed_forms() -> Tested {
    let start = Temperatures {
        translational: 1.0,
        rotational: 0.5,
    };
    let rough = |restitution| Impact::new(1.0, Tangential::Rough { restitution });
    // Perfectly rough and elastic: energy is kept and both temperatures become equal.
    let end = start.after(200.0, &rough(1.0)?);
    assert!((end.translational - 0.75).abs() < 1e-9 && (end.rotational - 0.75).abs() < 1e-9);
    // One short step against the closed means: κ = q/(1 + q)(1 + β), u_t² = 4 (T + θ/q).
    for beta in [-0.7, 0.0, 0.6] {
        let dc = 1e-6;
        let end = start.after(dc, &rough(beta)?);
        let (kappa, surface) = (2.0 / 7.0 * (1.0 + beta), 1.0 + 0.5 / 0.4);
        let moved = kappa * kappa * surface - 2.0 * kappa;
        let lost = 2.0 / 7.0 * (1.0 - beta * beta) * surface;
        assert!(((end.translational - 1.0) / dc - moved / 3.0).abs() < 1e-5);
        assert!(((end.rotational - 0.5) / dc + (moved + lost) / 3.0).abs() < 1e-5);
    }
    // Coulomb's limit far away is none, and at 0 there is no friction.
    let coulomb = |mu| {
        let restitution = 0.6;
        Impact::new(0.8, Tangential::Coulomb { mu, restitution })
    };
    let free = Impact::new(0.8, Tangential::Rough { restitution: 0.6 })?;
    let [far, near] = [&coulomb(1e6)?, &free].map(|law| start.after(3.0, law));
    assert!((far.translational - near.translational).abs() < 1e-6);
    let smooth = start.after(3.0, &coulomb(0.0)?);
    assert!((smooth.translational - libm::exp(-0.36)).abs() < 1e-9);
    assert!((smooth.rotational - 0.5).abs() < 1e-12);
    Ok(())
}
