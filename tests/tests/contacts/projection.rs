//! The nearest wrench of a friction set: against brute force, and by what defines a projection.

use std::f64::consts::FRAC_PI_2;
use tribos_core::Real;
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::coupling::{DryReducedFriction, ReducedFriction, ReducedWrench, compact};
use tribos_core::internals::COLLAR_ULPS;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, Region, RoundLimitSurface};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::surfaces::{FORCE_LIMIT, RADIUS, Ring, inner, norm, random_wrench, same_bits};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// T₀ of the ellipsoids: no special number.
const SPIN_TORQUE: f64 = 0.6;

fn puck<C: DryReducedFriction<f64>>(coupling: C) -> RoundLimitSurface<f64, C> {
    RoundLimitSurface::new(coupling, FORCE_LIMIT, RADIUS).expect("the limits are valid")
}

fn ellipsoid() -> LimitEllipsoid<f64> {
    LimitEllipsoid::new(FORCE_LIMIT, RADIUS, SPIN_TORQUE).expect("the limits are valid")
}

/// A wrench outside, or not far from being so, over several decades.
fn outer(rng: &mut Lcg) -> Wrench<f64> {
    let size = if rng.unit() < 0.5 {
        rng.between(0.5, 3.0)
    } else {
        rng.log_between(0.5, 1e4)
    };
    random_wrench(rng, size)
}

/// Distance from (f, t) to the point of `curve` at the angle θ ∈ [0, π/2].
type Curve<'a> = &'a dyn Fn(f64) -> [f64; 2];

/// The nearest point of a curve, by samples and golden section: (distance, point).
fn nearest_of_samples(curve: Curve, point: [f64; 2]) -> (f64, [f64; 2]) {
    const SAMPLES: u32 = 1000;
    const SECTIONS: usize = 60;
    let angle = |n: f64| FRAC_PI_2 * n / f64::from(SAMPLES);
    let distance = |at: f64| {
        let [f, t] = curve(at);
        (f - point[0]).hypot(t - point[1])
    };
    let best = (0..=SAMPLES)
        .map(|n| angle(f64::from(n)))
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
        .expect("samples");
    let (mut low, mut high) = (
        (best - angle(1.0)).max(0.0),
        (best + angle(1.0)).min(FRAC_PI_2),
    );
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..SECTIONS {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if distance(left) < distance(right) {
            high = right;
        } else {
            low = left;
        }
    }
    let at = [low, 0.5 * (low + high), high, best]
        .into_iter()
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
        .expect("four");
    (distance(at), curve(at))
}

/// Projections with several lengths against brute force on `curve` of (F, T), reduced.
fn assert_nearest<S: FrictionSet<f64>>(name: &'static str, set: &S, curve: Curve) {
    let mut rng = Lcg::new(41);
    let mut distance = Worst::of(name);
    let mut place = Worst::of(name);
    for _ in 0..1_500 {
        let given = outer(&mut rng);
        let length = RADIUS * [0.1, 0.7, 1.0, 3.0][rng.bits() as usize % 4];
        let got = set.project_with_length(&given, length);
        let moved = got.wrench - given;
        if got.region == Region::Inside {
            assert!(same_bits(&got.wrench, &given));
            continue;
        }
        let lever = length / RADIUS;
        let weighted = |at| {
            let [f, t] = curve(at);
            [f, t / lever]
        };
        let magnitudes = |w: &Wrench<f64>| {
            let torque = w.torque.abs() / length / FORCE_LIMIT;
            [w.force.x.hypot(w.force.y) / FORCE_LIMIT, torque]
        };
        let (wanted, at) = nearest_of_samples(&weighted, magnitudes(&given));
        let [f, t] = magnitudes(&got.wrench);
        let size = 1.0 + norm(&given, length) / FORCE_LIMIT;
        let error = (norm(&moved, length) / FORCE_LIMIT - wanted).abs() / size;
        distance.see(error, || format!("{given:?}"));
        place.see((f - at[0]).hypot(t - at[1]) / size.sqrt(), || {
            format!("{given:?}")
        });
    }
    distance.assert_within(&tolerance::NEAREST_DISTANCE);
    place.assert_within(&tolerance::NEAREST_POINT);
}

#[test]
fn no_point_of_the_disks_surface_is_nearer() {
    let curve = |at: f64| {
        let ReducedWrench { force, torque } =
            compact::CompactCoulombDisk.reduced_wrench(at.cos(), at.sin());
        [force, torque]
    };
    assert_nearest("disk to brute force", &puck(CoulombDisk), &curve);
}

#[test]
fn no_point_of_the_rings_surface_is_nearer() {
    let curve = |at: f64| {
        let ReducedWrench { force, torque } = Ring.reduced_wrench(at.cos(), at.sin());
        [force, torque]
    };
    assert_nearest("ring to brute force", &puck(Ring), &curve);
}

#[test]
fn no_point_of_the_ellipse_is_nearer() {
    let curve = |at: f64| [at.cos(), SPIN_TORQUE * at.sin()];
    assert_nearest("ellipsoid to brute force", &ellipsoid(), &curve);
}

/// Optimality without a search: the displacement is a multiple ≥ 0 of the normal, the normal's own
/// friction is the projection, and no other wrench of the set lies beyond.
fn assert_orthogonal_and_polar<S: FrictionSet<f64>>(set: &S) {
    let mut rng = Lcg::new(42);
    let mut across = Worst::of("displacement across the normal");
    let mut beyond = Worst::of("work towards the set");
    let mut friction = Worst::of("friction of the normal");
    for _ in 0..50_000 {
        let given = outer(&mut rng);
        let length = RADIUS * rng.log_between(0.03, 30.0);
        let Wrench { force, torque } = given;
        let got = set.project_with_length(&given, length);
        let Region::OnSurface { normal } = got.region else {
            assert!(set.gauge(&given) < 1.0);
            continue;
        };
        let moved = given - got.wrench;
        let along = Wrench::new(
            normal.velocity.x,
            normal.velocity.y,
            normal.spin * length * length,
        );
        let factor = inner(&moved, &along, length) / inner(&along, &along, length);
        let scale = FORCE_LIMIT * (1.0 + RADIUS / length) + norm(&given, length);
        let place = || format!("{given:?}, length {length}");
        let rest = norm(&(moved - along * factor), length);
        across.see(rest / scale, place);
        assert!(factor >= -1e-15 * scale, "{}", place());
        // The projection is the friction of the normal, turned into a push.
        let push = set.wrench(&Twist::new(
            -normal.velocity.x,
            -normal.velocity.y,
            -normal.spin,
        ));
        let error = norm(&(push - got.wrench), RADIUS);
        friction.see(error / FORCE_LIMIT, place);
        assert!(given.power(&normal) >= set.support(&normal) * (1.0 - 1e-14));
        // Never towards another wrench of the set.
        let other = set.scale_to_surface(&random_wrench(&mut rng, 1.0));
        let work = inner(&moved, &(other - got.wrench), length);
        beyond.see(work / (scale * scale), place);
        // A component that is absent stays absent.
        assert!(torque != 0.0 || got.wrench.torque == 0.0);
        assert!(force.norm() != 0.0 || got.wrench.force.norm() == 0.0);
    }
    across.assert_within(&tolerance::ACROSS_NORMAL);
    beyond.assert_within(&tolerance::POLAR);
    friction.assert_within(&tolerance::FRICTION_OF_NORMAL);
}

#[test]
fn displacements_are_normal_and_lead_away_from_the_set() {
    assert_orthogonal_and_polar(&puck(CoulombDisk));
    assert_orthogonal_and_polar(&puck(compact::CompactCoulombDisk));
    assert_orthogonal_and_polar(&puck(Ring));
    assert_orthogonal_and_polar(&ellipsoid());
}

/// A second wrench, as often near the first as anywhere.
fn partner(rng: &mut Lcg, first: &Wrench<f64>) -> Wrench<f64> {
    if rng.unit() < 0.5 {
        return outer(rng);
    }
    let step = rng.log_between(1e-16, 1.0);
    *first + random_wrench(rng, 1.0) * step
}

/// Growth of the distance of `pairs` random pairs, over the force limit.
fn expansion<S: FrictionSet<f64>>(name: &'static str, set: &S, pairs: u32) -> Worst {
    let mut rng = Lcg::new(43);
    let mut worst = Worst::of(name);
    for _ in 0..pairs {
        let a = outer(&mut rng);
        let b = partner(&mut rng, &a);
        let apart = norm(&(a - b), RADIUS);
        let (near_a, near_b) = (set.project(&a).wrench, set.project(&b).wrench);
        let growth = norm(&(near_a - near_b), RADIUS) - apart;
        worst.see((growth / FORCE_LIMIT).max(0.0), || format!("{a:?} {b:?}"));
    }
    worst
}

#[test]
fn no_pair_of_a_million_wrenches_moves_apart() {
    expansion("expansion, disk", &puck(CoulombDisk), 1_000_000)
        .assert_within(&tolerance::EXPANSION);
}

#[test]
fn other_sets_move_no_pair_apart() {
    expansion("expansion, ring", &puck(Ring), 100_000).assert_within(&tolerance::EXPANSION);
    expansion("expansion, ellipsoid", &ellipsoid(), 100_000).assert_within(&tolerance::EXPANSION);
}

#[test]
fn no_pair_moves_apart_in_single_precision() {
    let set = RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT as f32, RADIUS as f32).unwrap();
    let narrow = |w: &Wrench<f64>| Wrench::new(w.force.x as f32, w.force.y as f32, w.torque as f32);
    let wide = |w: &Wrench<f32>| {
        let [x, y, torque] = [w.force.x, w.force.y, w.torque].map(f32::to_f64);
        Wrench::new(x, y, torque)
    };
    let mut rng = Lcg::new(44);
    let mut worst = Worst::of("expansion, f32");
    for _ in 0..200_000 {
        let a = outer(&mut rng);
        let (a, b) = (narrow(&a), narrow(&partner(&mut rng, &a)));
        let apart = norm(&(wide(&a) - wide(&b)), RADIUS);
        let near = wide(&set.project(&a).wrench) - wide(&set.project(&b).wrench);
        let growth = (norm(&near, RADIUS) - apart) / FORCE_LIMIT;
        worst.see(growth.max(0.0), || format!("{a:?} {b:?}"));
    }
    worst.assert_within(&tolerance::EXPANSION_SINGLE);
}

/// Projects projections and the friction of random twists: same bits, same region.
fn settled<S: FrictionSet<f64>>(name: &'static str, set: &S) -> Worst {
    let mut rng = Lcg::new(45);
    let mut worst = Worst::of(name);
    for n in 0..200_000 {
        let given = outer(&mut rng);
        let length = RADIUS * rng.log_between(0.1, 10.0);
        let on = if n % 2 == 0 {
            set.project_with_length(&given, length)
        } else {
            // Twists dense around equal speeds, where couplings are worst.
            let rim = rng.log_between(1e-16, 1e-1);
            let sliding = 1.0 + if n % 4 == 1 { rim } else { -rim };
            let twist = Twist::new(0.6 * sliding, -0.8 * sliding, 1.0 / RADIUS);
            set.project(&set.wrench(&twist))
        };
        let again = set.project_with_length(&on.wrench, length);
        assert!(same_bits(&on.wrench, &again.wrench), "{on:?} {again:?}");
        match (on.region, again.region) {
            (Region::Inside, Region::Inside) => {}
            (Region::OnSurface { normal }, Region::OnSurface { normal: same }) => {
                let turned = (normal.velocity - same.velocity).norm();
                let twisted = (normal.spin - same.spin).abs() * RADIUS;
                assert!(turned.max(twisted) <= 1e-12, "{normal:?} {same:?}");
                let off = (set.gauge(&on.wrench) - 1.0).abs() / f64::EPSILON;
                worst.see(off, || format!("{given:?}"));
            }
            other => panic!("{other:?}"),
        }
        assert!(set.contains(&on.wrench));
    }
    worst
}

#[test]
fn projecting_again_changes_neither_bits_nor_region() {
    settled("gauge - 1 of projections, table", &puck(CoulombDisk))
        .assert_within(&tolerance::ON_SURFACE_ULPS);
    settled(
        "gauge - 1 of projections, AGM",
        &puck(compact::CompactCoulombDisk),
    )
    .assert_within(&tolerance::ON_SURFACE_AGM_ULPS);
    settled("gauge - 1 of projections, ring", &puck(Ring))
        .assert_within(&tolerance::ON_SURFACE_AGM_ULPS);
    settled("gauge - 1 of projections, ellipsoid", &ellipsoid())
        .assert_within(&tolerance::ON_SURFACE_ULPS);
}

#[test]
fn huge_and_tiny_wrenches_have_the_right_nearest_point() {
    let disk = puck(CoulombDisk);
    for huge in [1e20, 1e150, 1e290, 1e305] {
        // Far away only the direction counts: (force, torque/length²) is the normal.
        for (x, y, torque) in [(0.3, 0.4, 0.0), (0.0, 0.0, -1.0), (0.3, 0.4, 0.5 * RADIUS)] {
            for lever in [1.0, 1e-7, 1e-3, 30.0, 1e6] {
                let far = Wrench::new(0.0, 0.0, 0.0) + Wrench::new(x, y, torque) * huge;
                let length = lever * RADIUS;
                let got = disk.project_with_length(&far, length).wrench;
                let wanted = disk.wrench(&Twist::new(x, y, torque / length / length));
                let error = norm(&(got + wanted), RADIUS);
                let bound = tolerance::ACROSS_NORMAL
                    .limit
                    .max(2.0 / huge * (1.0 + lever * lever));
                assert!(
                    error <= bound * FORCE_LIMIT,
                    "{far:?}, lever {lever}: {got:?}"
                );
            }
        }
    }
    for tiny in [1e-300, 1e-310, 5e-324] {
        let given = Wrench::new(tiny, -tiny, tiny);
        let got = disk.project(&given);
        assert!(same_bits(&got.wrench, &given) && got.region == Region::Inside);
    }
    // A tiny component keeps its digits: the surface is round at its poles.
    for tiny in [1e-10, 1e-100, 1e-300] {
        let got = disk
            .project(&Wrench::new(tiny, 0.0, FORCE_LIMIT * RADIUS))
            .wrench;
        // f − F = (t − T) ε with F = ε: f = ε (1 + t − 2/3) in reduced units.
        let wanted = tiny / (1.0 + 1.0 / 3.0);
        assert!((got.force.x / wanted - 1.0).abs() < 1e-14, "{got:?}");
    }
}

#[test]
fn a_length_that_is_none_gives_nan_outside() {
    let disk = puck(CoulombDisk);
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let outside = disk.project_with_length(&Wrench::new(1.0, 0.0, 0.0), length);
        assert!(outside.wrench.force.x.is_nan() && outside.wrench.torque.is_nan());
        let inside = Wrench::new(0.1, 0.0, 0.0);
        assert_eq!(disk.project_with_length(&inside, length).wrench, inside);
    }
}

/// The quick test of wrenches deep inside says what the gauge says.
fn assert_judged_by_the_gauge<R: Real, C: DryReducedFriction<R>>(name: &str, coupling: C) {
    let real = R::from_f64;
    let set = RoundLimitSurface::new(coupling, real(FORCE_LIMIT), real(RADIUS)).expect("valid");
    let collar = real(COLLAR_ULPS) * R::EPSILON;
    let mut rng = Lcg::new(43);
    let mut inside = 0;
    for round in 0..20_000_u32 {
        let size = rng.between(0.0, 1.3);
        let wide = random_wrench(&mut rng, size);
        let [x, y, torque] = [wide.force.x, wide.force.y, wide.torque].map(real);
        let mut given = Wrench::new(x, y, torque);
        if round % 2 == 0 {
            // As close to the surface as rounding tells apart.
            let below = real(f64::from(round % 512)) * R::EPSILON;
            given = set.scale_to_surface(&given) * (R::ONE - below);
        }
        let is_inside = set.gauge(&given) < R::ONE - collar;
        let got = set.project(&given);
        assert_eq!(got.region == Region::Inside, is_inside, "{name}: {given:?}");
        assert!(!is_inside || got.wrench == given, "{name}: {given:?}");
        assert_eq!(set.contains(&given), set.gauge(&given) <= R::ONE + collar);
        inside += u32::from(is_inside);
    }
    assert!((4_000..18_000).contains(&inside), "{name}: {inside}");
}

#[test]
fn wrenches_deep_inside_are_told_from_others_as_the_gauge_tells_them() {
    assert_judged_by_the_gauge::<f64, _>("table", CoulombDisk);
    assert_judged_by_the_gauge::<f32, _>("table", CoulombDisk);
    assert_judged_by_the_gauge::<f64, _>("ring", Ring);
    assert_judged_by_the_gauge::<f64, _>("compact", compact::CompactCoulombDisk);
}
