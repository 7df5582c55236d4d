//! The limit surface against reference tables and its own definition: support, gauge, normal.

use std::f64::consts::PI;
use std::hint::black_box;
use tribos_core::Error;
use tribos_core::coupling::table::{self, CoulombDisk};
use tribos_core::coupling::{DryReducedFriction, ReducedFriction, compact};
use tribos_core::internals::COLLAR_ULPS;
use tribos_core::law::LawError;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, Region, RoundLimitSurface, ShapeLimitSurface,
};
use tribos_core::patch::PatchError;
use tribos_core::patch::outline::Polygon;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::reference::Reference;
use tribos_tests::surfaces::{Counting, FORCE_LIMIT, RADIUS, Ring, norm, random_wrench, same_bits};
use tribos_tests::sweep::{Lcg, ratios, special_f64};
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn unit<C: DryReducedFriction<f64>>(coupling: C) -> RoundLimitSurface<f64, C> {
    RoundLimitSurface::new(coupling, 1.0, 1.0).expect("the limits are valid")
}

fn puck<C: DryReducedFriction<f64>>(coupling: C) -> RoundLimitSurface<f64, C> {
    RoundLimitSurface::new(coupling, FORCE_LIMIT, RADIUS).expect("the limits are valid")
}

#[test]
fn surface_of_the_uniform_disk_passes_through_its_closed_forms() {
    let disk = puck(CoulombDisk);
    let torque_unit = FORCE_LIMIT * RADIUS;
    let mut gauge = Worst::of("gauge of closed forms");
    for (force, torque) in [
        (1.0, 0.0),
        (0.0, 2.0 / 3.0),
        (8.0 / (3.0 * PI), 8.0 / (9.0 * PI)),
    ] {
        for size in [1e-300, 1e-9, 0.3, 1.0, 7.0, 1e250] {
            let on = Wrench::new(
                0.6 * size * force * FORCE_LIMIT,
                0.8 * size * force * FORCE_LIMIT,
                -size * torque * torque_unit,
            );
            let error = disk.gauge(&on) / size - 1.0;
            gauge.see(error.abs(), || format!("({force}, {torque}) times {size}"));
        }
    }
    gauge.assert_within(&tolerance::GAUGE);
    assert!((disk.torque_limit() - 2.0 / 3.0 * torque_unit).abs() <= 1e-15 * torque_unit);
}

#[test]
fn gauge_and_normal_of_reference_points_are_right() {
    let disk = unit(CoulombDisk);
    let mut gauge = Worst::of("gauge of reference points");
    let mut normal = Worst::of("ratio from reference points");
    for name in ["uniform.csv", "exponents.csv"] {
        for row in Table::read(name).rows() {
            let (ratio, w) = (
                row.number("eps"),
                Wrench::new(row.number("F"), 0.0, row.number("T")),
            );
            if row.number("alpha") != 0.0 || ratio.is_infinite() {
                continue;
            }
            let place = || format!("eps {ratio:e}");
            gauge.see((disk.gauge(&w) - 1.0).abs(), place);
            let twist = disk.twist_normal_to(&w);
            let got = twist.velocity.x / twist.spin;
            normal.see(Reference::exact(ratio).relative(got), place);
            assert_eq!(twist.velocity.y, 0.0);
            let length = twist.speed().hypot(twist.spin);
            assert!((length - 1.0).abs() <= tolerance::ROUNDING.limit);
        }
    }
    gauge.assert_within(&tolerance::GAUGE);
    normal.assert_within(&tolerance::NORMAL);
}

/// From twist to friction and back, over twelve decades of the ratio and densely around 1.
fn recovered<C: DryReducedFriction<f64>>(name: &'static str, coupling: C) -> Worst {
    let set = puck(coupling);
    let mut worst = Worst::of(name);
    for ratio in ratios(20_000) {
        let twist = Twist::new(-0.6 * ratio, 0.8 * ratio, -1.0 / RADIUS);
        let back = set.twist_resisted_by(&set.wrench(&twist));
        let got = back.speed() / (-back.spin * RADIUS);
        worst.see((got / ratio - 1.0).abs(), || format!("eps {ratio:e}"));
        assert!(back.velocity.x < 0.0 && back.velocity.y > 0.0);
    }
    worst
}

#[test]
fn motion_and_friction_are_each_others_inverse() {
    recovered("ratio, table", CoulombDisk).assert_within(&tolerance::NORMAL);
    recovered("ratio, AGM", compact::CompactCoulombDisk).assert_within(&tolerance::NORMAL);
    recovered("ratio, ring", Ring).assert_within(&tolerance::NORMAL_RING);
}

fn assert_support_bounds_every_wrench<C: DryReducedFriction<f64>>(coupling: C) {
    let set = puck(coupling);
    let mut rng = Lcg::new(31);
    for _ in 0..100_000 {
        let (a, b) = (random_wrench(&mut rng, 1.0), random_wrench(&mut rng, 1.0));
        let twist = Twist::new(a.force.x, a.force.y, a.torque / RADIUS / RADIUS);
        let friction = set.wrench(&twist);
        let support = set.support(&twist);
        // The friction of the twist attains the support, no other wrench of the set exceeds it.
        let given = -friction.power(&twist);
        assert!((support - given).abs() <= tolerance::IDENTITY.limit * support);
        let other = set.scale_to_surface(&b);
        assert!(other.power(&twist) <= support * (1.0 + tolerance::GAUGE.limit));
        assert!((set.gauge(&other) - 1.0).abs() <= COLLAR_ULPS * f64::EPSILON);
    }
}

#[test]
fn friction_dissipates_most_of_all_wrenches_of_the_set() {
    assert_support_bounds_every_wrench(CoulombDisk);
    assert_support_bounds_every_wrench(Ring);
}

#[test]
fn gauge_is_a_norm() {
    let disk = puck(CoulombDisk);
    let mut rng = Lcg::new(32);
    for _ in 0..100_000 {
        let (a, b) = (random_wrench(&mut rng, 1.0), random_wrench(&mut rng, 0.7));
        let sum = a + b;
        let (one, other) = (disk.gauge(&a), disk.gauge(&b));
        assert!(disk.gauge(&sum) <= (one + other) * (1.0 + tolerance::GAUGE.limit));
        assert!(one > 0.0);
    }
}

#[test]
fn quarter_turns_and_mirrors_move_no_bit() {
    let disk = puck(CoulombDisk);
    let mut rng = Lcg::new(33);
    for _ in 0..10_000 {
        let Wrench { force, torque } = random_wrench(&mut rng, 1.5);
        let (given, turned) = (
            Wrench::new(force.x, force.y, torque),
            Wrench::new(-force.y, force.x, -torque),
        );
        assert_eq!(disk.gauge(&given), disk.gauge(&turned));
        let (here, there) = (disk.project(&given).wrench, disk.project(&turned).wrench);
        let back = Wrench::new(there.force.y, -there.force.x, -there.torque);
        assert_eq!(here, back);
    }
}

#[test]
fn powers_of_two_scale_to_the_bit() {
    let mut rng = Lcg::new(34);
    let disk = puck(CoulombDisk);
    for _ in 0..20_000 {
        let scale = 2.0_f64.powi((rng.between(-300.0, 300.0)) as i32);
        let lever = 2.0_f64.powi((rng.between(-100.0, 100.0)) as i32);
        let size = rng.log_between(1e-3, 1e3);
        let w = random_wrench(&mut rng, size);
        let scaled = |w: &Wrench<f64>| Wrench {
            force: w.force * scale,
            torque: w.torque * (scale * lever),
        };
        let large =
            RoundLimitSurface::new(CoulombDisk, FORCE_LIMIT * scale, RADIUS * lever).unwrap();
        assert_eq!(disk.gauge(&w), large.gauge(&scaled(&w)));
        let (near, far) = (disk.project(&w), large.project(&scaled(&w)));
        assert!(same_bits(&scaled(&near.wrench), &far.wrench));
        let (near, far) = (disk.twist_normal_to(&w), large.twist_normal_to(&scaled(&w)));
        assert_eq!((near.velocity, near.spin), (far.velocity, far.spin * lever));
    }
}

#[test]
fn searches_are_short() {
    let counting = Counting::new(CoulombDisk);
    let set = RoundLimitSurface::new(&counting, FORCE_LIMIT, RADIUS).unwrap();
    type Call<'a> = &'a dyn Fn(&Wrench<f64>);
    let calls: [(&str, f64, f64, Call, u32); 5] = [
        (
            "gauge",
            0.1,
            10.0,
            &|w| {
                black_box(set.gauge(w));
            },
            8,
        ),
        (
            "normal",
            0.1,
            10.0,
            &|w| {
                black_box(set.twist_normal_to(w));
            },
            8,
        ),
        (
            "project inside",
            0.1,
            0.6,
            &|w| {
                black_box(set.project(w));
            },
            8,
        ),
        (
            "project near",
            1.0,
            1.5,
            &|w| {
                black_box(set.project(w));
            },
            16,
        ),
        (
            "project far",
            1.5,
            1e9,
            &|w| {
                black_box(set.project(w));
            },
            8,
        ),
    ];
    let mut rng = Lcg::new(35);
    let count = 100_000;
    for (name, low, high, call, most) in calls {
        let (mut sum, mut worst) = (0, 0);
        for _ in 0..count {
            let size = rng.log_between(low, high);
            let w = random_wrench(&mut rng, size);
            counting.take();
            call(&w);
            let used = counting.take();
            sum += used;
            worst = worst.max(used);
        }
        let mean = f64::from(sum) / f64::from(count);
        println!("| {name} | mean {mean:.2} | worst {worst} |");
        assert!(worst <= most, "{name}: {worst} wrenches and Jacobians");
    }
}

fn is_nan(w: &Wrench<f64>) -> bool {
    w.force.x.is_nan() && w.force.y.is_nan() && w.torque.is_nan()
}

fn assert_total<S: FrictionSet<f64>>(set: &S) {
    let special = special_f64();
    let inputs = special.iter().flat_map(|&x| {
        let special = &special;
        special
            .iter()
            .flat_map(move |&y| special.iter().map(move |&t| (x, y, t)))
    });
    for (x, y, torque) in inputs {
        let w = Wrench::new(x, y, torque);
        let place = format!("{w:?}");
        let (gauge, projection) = (set.gauge(&w), set.project(&w));
        let normal = set.twist_normal_to(&w);
        let on = set.scale_to_surface(&w);
        let friction = set.wrench(&Twist::new(x, y, torque));
        if x.is_nan() || y.is_nan() || torque.is_nan() {
            assert!(gauge.is_nan() && is_nan(&projection.wrench), "{place}");
            assert!(!set.contains(&w));
            assert!(
                normal.velocity.x.is_nan() || normal.spin.is_nan(),
                "{place}"
            );
            assert!(on.force.x.is_nan() || on.torque.is_nan(), "{place}");
            assert!(friction.force.x.is_nan() || friction.torque.is_nan());
        } else if gauge == f64::INFINITY {
            assert!(is_nan(&projection.wrench), "{place}");
            assert!(!set.contains(&w));
        } else {
            assert!(gauge >= 0.0, "{place}");
            let inside = set.gauge(&projection.wrench);
            assert!(
                inside <= 1.0 + COLLAR_ULPS * f64::EPSILON,
                "{place}: {inside}"
            );
            assert!(normal.speed().is_finite() && normal.spin.is_finite());
            let still = x == 0.0 && y == 0.0 && torque == 0.0;
            assert!(
                still || norm(&on, set.radius()) > 0.0 || gauge == 0.0,
                "{place}"
            );
        }
        assert_eq!(
            set.contains(&projection.wrench),
            !is_nan(&projection.wrench)
        );
    }
}

#[test]
fn every_bit_pattern_has_an_answer() {
    assert_total(&puck(CoulombDisk));
    assert_total(&unit(compact::CompactCoulombDisk));
    assert_total(&unit(Ring));
    assert_total(&LimitEllipsoid::new(FORCE_LIMIT, RADIUS, 0.6).unwrap());
    let tile = Polygon::new([[0.0, 0.0], [0.05, 0.0], [0.01, 0.03]]).unwrap();
    assert_total(&ShapeLimitSurface::new(tile, FORCE_LIMIT).unwrap());
}

#[test]
fn random_bits_never_panic() {
    let mut rng = Lcg::new(36);
    for _ in 0..50_000 {
        let [a, b, c, d, e] = std::array::from_fn(|_| f64::from_bits(rng.bits()));
        let Ok(set) = RoundLimitSurface::new(CoulombDisk, d.abs(), e.abs()) else {
            continue;
        };
        let w = Wrench::new(a, b, c);
        let projected = set.project_with_length(&w, f64::from_bits(rng.bits()));
        let finite = norm(&projected.wrench, 1.0).is_finite();
        assert!(finite || projected.region != Region::Inside || norm(&w, 1.0).is_infinite());
        set.twist_normal_to(&w);
        set.wrench(&Twist::new(a, b, c));
    }
}

#[test]
fn without_force_limit_nothing_is_carried() {
    let slick = RoundLimitSurface::new(CoulombDisk, 0.0, RADIUS).unwrap();
    let none = Wrench::new(0.0, 0.0, 0.0);
    assert_eq!(slick.gauge(&none), 0.0);
    assert_eq!(slick.project(&none).region, Region::Inside);
    for push in [Wrench::new(1e-300, 0.0, 0.0), Wrench::new(3.0, -4.0, 0.1)] {
        assert_eq!(slick.gauge(&push), f64::INFINITY);
        assert!(!slick.contains(&push));
        let projection = slick.project(&push);
        assert_eq!(projection.wrench, none);
        let Region::OnSurface { normal } = projection.region else {
            panic!("{projection:?}");
        };
        let length = normal.speed().hypot(normal.spin * RADIUS);
        assert!((length - 1.0).abs() <= tolerance::ROUNDING.limit);
        assert!(push.power(&normal) > 0.0);
    }
    let nan = slick.project(&Wrench::new(f64::NAN, 0.0, 0.0));
    assert!(is_nan(&nan.wrench));
    assert_eq!(slick.support(&Twist::new(1.0, 2.0, 3.0)), 0.0);
}

#[test]
fn nothing_moves_nothing() {
    let disk = puck(CoulombDisk);
    let none = Wrench::new(0.0, 0.0, 0.0);
    assert_eq!(disk.twist_normal_to(&none), Twist::ZERO);
    assert_eq!(disk.scale_to_surface(&none), none);
    assert_eq!(disk.wrench(&Twist::ZERO), none);
    assert_eq!(disk.support(&Twist::ZERO), 0.0);
}

#[test]
fn wrong_limits_are_refused_with_what_was_given() {
    for given in [-1.0, -5e-324, f64::INFINITY] {
        assert_eq!(
            RoundLimitSurface::new(CoulombDisk, given, 1.0).unwrap_err(),
            Error::Law(LawError::Negative {
                parameter: "force limit",
                given
            })
        );
    }
    for given in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(
            RoundLimitSurface::new(CoulombDisk, 1.0, given).unwrap_err(),
            Error::Patch(PatchError::Radius { given })
        );
        assert_eq!(
            LimitEllipsoid::new(1.0, 1.0, given).unwrap_err(),
            Error::Law(LawError::NotPositive {
                parameter: "reduced torque of pure spinning",
                given
            })
        );
    }
    assert!(RoundLimitSurface::new(CoulombDisk, f64::NAN, 1.0).is_err());
    assert!(RoundLimitSurface::new(CoulombDisk, 1.0, f64::NAN).is_err());
    assert!(LimitEllipsoid::new(1.0, 1.0, f64::NAN).is_err());
}

#[test]
fn single_precision_follows_double() {
    let (narrow, wide) = (
        RoundLimitSurface::new(table::CoulombDisk, FORCE_LIMIT as f32, RADIUS as f32).unwrap(),
        RoundLimitSurface::new(
            table::CoulombDisk,
            f64::from(FORCE_LIMIT as f32),
            f64::from(RADIUS as f32),
        )
        .unwrap(),
    );
    let compact = RoundLimitSurface::new(
        compact::CompactCoulombDisk,
        FORCE_LIMIT as f32,
        RADIUS as f32,
    )
    .unwrap();
    let mut rng = Lcg::new(37);
    let mut projection = Worst::of("f32 projection (of the limits)");
    for _ in 0..100_000 {
        let size = rng.log_between(1e-2, 1e4);
        let Wrench { force, torque } = random_wrench(&mut rng, size);
        let given = Wrench::new(force.x as f32, force.y as f32, torque as f32);
        let exact = Wrench::new(
            f64::from(given.force.x),
            f64::from(given.force.y),
            f64::from(given.torque),
        );
        let (got, wanted) = (narrow.project(&given).wrench, wide.project(&exact).wrench);
        let error = Wrench::new(
            f64::from(got.force.x) - wanted.force.x,
            f64::from(got.force.y) - wanted.force.y,
            f64::from(got.torque) - wanted.torque,
        );
        projection.see(norm(&error, RADIUS) / FORCE_LIMIT, || format!("{given:?}"));
        assert_eq!(narrow.project(&got).wrench, got);
        let other = compact.project(&given).wrench;
        assert_eq!(compact.project(&other).wrench, other);
    }
    projection.assert_within(&tolerance::SINGLE_PROJECTION);
}

#[test]
fn ring_of_these_tests_is_a_dry_coupling() {
    // Euler's identity and a central difference: the oracle is not its own excuse.
    for ratio in [1e-3, 0.4, 0.99, 1.01, 2.5, 1e3] {
        let step = 1e-5 * ratio;
        let (low, high) = (
            Ring.reduced_wrench(ratio - step, 1.0),
            Ring.reduced_wrench(ratio + step, 1.0),
        );
        let j = Ring.reduced_jacobian(ratio, 1.0);
        let slope = (high.force - low.force) / (2.0 * step);
        assert!(
            (slope - j.force_slide).abs() <= 1e-7 * j.force_per_slide,
            "{ratio}"
        );
        let slope = (high.torque - low.torque) / (2.0 * step);
        assert!(
            (slope - j.mixed).abs() <= 1e-7 * j.force_per_slide,
            "{ratio}"
        );
        assert!((ratio * j.mixed + j.torque_rim).abs() <= 1e-14 * j.force_per_slide);
    }
}
