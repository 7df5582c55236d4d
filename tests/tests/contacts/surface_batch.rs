//! Batches on a limit surface answer bit for bit as one call after the other does.

use std::fmt::Debug;
use tribos_core::Real;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::{Annulus, DryReducedFriction, coulomb};
use tribos_core::internals::COLLAR_ULPS;
use tribos_core::limit_surface::{FrictionSet, Projection, Region, RoundLimitSurface};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::surfaces::{FORCE_LIMIT, RADIUS, random_wrench};
use tribos_tests::sweep::{Lcg, special_f64};

/// No multiple of the group of searches that go on side by side.
const BATCH: usize = 203;
/// What a slot holds that no call has written.
const UNTOUCHED: f64 = -77.0;

/// Every number by its bits; what is NaN must be NaN.
fn bits<R: Real>(values: impl IntoIterator<Item = R>) -> Vec<u64> {
    let bits = |x: R| {
        if x.is_nan() {
            u64::MAX
        } else {
            x.to_f64().to_bits()
        }
    };
    values.into_iter().map(bits).collect()
}

fn wrench_bits<R: Real>(w: &Wrench<R>) -> Vec<u64> {
    bits([w.force.x, w.force.y, w.torque])
}

fn twist_bits<R: Real>(t: &Twist<R>) -> Vec<u64> {
    bits([t.velocity.x, t.velocity.y, t.spin])
}

fn projection_bits<R: Real>(p: &Projection<R>) -> Vec<u64> {
    let mut all = wrench_bits(&p.wrench);
    if let Region::OnSurface { normal } = &p.region {
        all.extend(twist_bits(normal));
    }
    all
}

/// Compares one batch with the calls for each of its wrenches.
fn assert_same<R: Real, C: DryReducedFriction<R> + Debug>(
    set: &RoundLimitSurface<R, C>,
    length: R,
    loads: &[R],
    wrenches: &[Wrench<R>],
) {
    let count = wrenches.len();
    let mut gauges = vec![R::ZERO; count];
    let mut motions = vec![Twist::ZERO; count];
    let blank = Projection {
        wrench: Wrench::ZERO,
        region: Region::Inside,
    };
    let mut nearest = vec![blank; count];
    set.gauge_batch(loads, wrenches, &mut gauges);
    set.twist_normal_to_batch(wrenches, &mut motions);
    set.project_batch(length, loads, wrenches, &mut nearest);
    for (n, (load, given)) in loads.iter().zip(wrenches).enumerate() {
        let place = || format!("{given:?} under {load:?}, length {length:?}");
        let motion = set.twist_normal_to(given);
        assert_eq!(twist_bits(&motions[n]), twist_bits(&motion), "{}", place());
        let limit = set.force_limit() * *load;
        let alone = RoundLimitSurface::new(set.coupling(), limit, set.radius());
        let alone = alone.unwrap_or_else(|error| panic!("{error}: {}", place()));
        let [gauge, wanted] = [gauges[n], alone.gauge(given)].map(|gauge| bits([gauge]));
        assert_eq!(gauge, wanted, "{}", place());
        let wanted = alone.project_with_length(given, length);
        let got = projection_bits(&nearest[n]);
        assert_eq!(got, projection_bits(&wanted), "{}", place());
    }
}

/// A wrench of any region under the force limit `limit`, as often as not next to the surface.
fn any_wrench<C: DryReducedFriction<f64>>(
    rng: &mut Lcg,
    set: &RoundLimitSurface<f64, C>,
    load: f64,
) -> Wrench<f64> {
    let size = match rng.bits() >> 61 {
        0 => rng.between(0.0, 1.0),
        1 => rng.log_between(1.0, 1e4),
        2 => rng.log_between(1e-300, 1e300),
        _ => rng.between(0.6, 1.4),
    };
    let wrench = random_wrench(rng, size) * load;
    match rng.bits() >> 62 {
        // In the collar and next to it.
        0 => {
            let ulps = rng.between(-2.0 * COLLAR_ULPS, 2.0 * COLLAR_ULPS);
            set.scale_to_surface(&wrench) * (load * (1.0 + ulps * f64::EPSILON))
        }
        // A projection again.
        1 => {
            let alone = RoundLimitSurface::new(set.coupling(), set.force_limit() * load, RADIUS);
            alone.map_or(wrench, |alone| alone.project(&wrench).wrench)
        }
        _ => wrench,
    }
}

/// Batches of wrenches of all regions.
fn assert_all_regions<C: DryReducedFriction<f64> + Debug>(coupling: C, batches: u32) {
    let set = RoundLimitSurface::new(coupling, FORCE_LIMIT, RADIUS).expect("valid");
    let mut rng = Lcg::new(51);
    for _ in 0..batches {
        let loads: Vec<f64> = (0..BATCH).map(|_| rng.log_between(1e-3, 1e3)).collect();
        let wrenches: Vec<_> = loads
            .iter()
            .map(|load| any_wrench(&mut rng, &set, *load))
            .collect();
        let length = RADIUS * [1.0, rng.log_between(0.03, 30.0)][(rng.bits() >> 63) as usize];
        assert_same(&set, length, &loads, &wrenches);
    }
}

#[test]
fn two_million_wrenches_get_the_bits_of_single_calls() {
    assert_all_regions(CoulombDisk, 10_000);
}

#[test]
fn other_pressures_get_the_bits_of_single_calls() {
    assert_all_regions(coulomb::CoulombRing, 100);
    assert_all_regions(coulomb::CoulombPunch, 100);
    assert_all_regions(coulomb::CoulombHertz, 100);
    assert_all_regions(coulomb::CoulombParaboloid, 100);
    assert_all_regions(Annulus::new(CoulombDisk, 0.6).expect("valid"), 100);
}

#[test]
fn single_precision_gets_the_bits_of_single_calls() {
    let wide = RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT, RADIUS).expect("valid");
    let set =
        RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT as f32, RADIUS as f32).expect("valid");
    let mut rng = Lcg::new(52);
    for _ in 0..500 {
        let loads: Vec<f32> = (0..BATCH)
            .map(|_| rng.log_between(1e-3, 1e3) as f32)
            .collect();
        let narrow = |load: &f32| {
            let w = any_wrench(&mut rng, &wide, f64::from(*load));
            Wrench::new(w.force.x as f32, w.force.y as f32, w.torque as f32)
        };
        let wrenches: Vec<_> = loads.iter().map(narrow).collect();
        assert_same(&set, RADIUS as f32, &loads, &wrenches);
    }
}

#[test]
fn special_numbers_get_the_bits_of_single_calls() {
    let set = RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT, RADIUS).expect("valid");
    let special = special_f64();
    let mut wrenches = Vec::new();
    for &x in &special {
        for &y in &special {
            wrenches.extend(special.iter().map(|&torque| Wrench::new(x, y, torque)));
        }
    }
    // Zero, subnormal, ordinary and large.
    for load in [0.0, -0.0, 5e-324, 1e-310, 1e-300, 1.0, 1e300] {
        let loads = vec![load; wrenches.len()];
        for length in [RADIUS, 0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_same(&set, length, &loads, &wrenches);
        }
    }
}

#[test]
fn what_no_wrench_is_given_for_stays() {
    let set = RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT, RADIUS).expect("valid");
    let mut rng = Lcg::new(53);
    let wrenches: Vec<_> = (0..20).map(|_| random_wrench(&mut rng, 1.5)).collect();
    for (loads, given) in [(20, 9), (9, 20), (8, 8), (0, 20)] {
        let mut gauges = [UNTOUCHED; 20];
        set.gauge_batch(&vec![1.0; loads], &wrenches[..given], &mut gauges);
        let least = loads.min(given);
        assert!(gauges[..least].iter().all(|gauge| *gauge > 0.0));
        assert!(gauges[least..].iter().all(|gauge| *gauge == UNTOUCHED));
    }
}

#[test]
fn a_load_that_is_negative_or_no_number_gives_none() {
    let set = RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT, RADIUS).expect("valid");
    let push = Wrench::new(0.3, 0.1, 0.002);
    let mut gauge = [0.0];
    let blank = Projection {
        wrench: Wrench::ZERO,
        region: Region::Inside,
    };
    for load in [f64::NAN, -1.0, -1e-300, f64::NEG_INFINITY] {
        let mut nearest = [blank];
        set.gauge_batch(&[load], &[push], &mut gauge);
        set.project_batch(RADIUS, &[load], &[push], &mut nearest);
        assert!(
            gauge[0].is_nan() && nearest[0].wrench.torque.is_nan(),
            "{load}"
        );
    }
}
