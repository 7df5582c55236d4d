//! The limit surface against reference tables and its own definition: support, gauge, normal.

use std::f64::consts::PI;
use std::hint::black_box;
use tribos_core::Error;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::{DryReducedFriction, ReducedFriction};
use tribos_core::law::LawError;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, Region, RoundLimitSurface};
use tribos_core::patch::PatchError;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::reference::Reference;
use tribos_tests::surfaces::{Counting, FORCE_LIMIT, RADIUS, Ring, norm, random_wrench, same_bits};
use tribos_tests::sweep::{Lcg, ratios};
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
    recovered("ratio, disk", CoulombDisk).assert_within(&tolerance::NORMAL);
    recovered("ratio, ring", Ring).assert_within(&tolerance::NORMAL_RING);
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
