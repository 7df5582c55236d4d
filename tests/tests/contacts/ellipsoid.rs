//! The ellipsoid against its closed forms, and how far it is from the exact surface of a disk.

use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::surfaces::{FORCE_LIMIT, RADIUS, norm, random_wrench};
use tribos_tests::sweep::{Lcg, ratios};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// Reduced torques of a uniform disk, of a Hertz contact and of a patch wider than its radius.
const SPIN_TORQUES: [f64; 3] = [2.0 / 3.0, 3.0 * std::f64::consts::PI / 16.0, 1.7];

#[test]
fn gauge_normal_and_support_have_their_closed_forms() {
    let [mut gauge, mut normal, mut support] = [
        "ellipsoid, gauge",
        "ellipsoid, normal",
        "ellipsoid, support",
    ]
    .map(Worst::of);
    let mut rng = Lcg::new(51);
    for spin_torque in SPIN_TORQUES {
        let set = LimitEllipsoid::new(FORCE_LIMIT, RADIUS, spin_torque).unwrap();
        let torque_limit = FORCE_LIMIT * RADIUS * spin_torque;
        assert!((set.torque_limit() / torque_limit - 1.0).abs() <= tolerance::ROUNDING.limit);
        for _ in 0..20_000 {
            let size = rng.log_between(1e-6, 1e6);
            let w = random_wrench(&mut rng, size);
            let place = || format!("{w:?}");
            let (f, t) = (w.force.norm() / FORCE_LIMIT, w.torque / torque_limit);
            let wanted = (f * f + t * t).sqrt();
            gauge.see((set.gauge(&w) / wanted - 1.0).abs(), place);
            // The gradient (f/f_max², m/m_max²).
            let twist = set.twist_normal_to(&w);
            let speed = w.force.norm() / FORCE_LIMIT / FORCE_LIMIT;
            let spin = w.torque / torque_limit / torque_limit;
            let across = twist.speed() * spin - speed * twist.spin;
            let scale = speed.hypot(spin * RADIUS) / RADIUS;
            normal.see(across.abs() / scale, place);
            let power = (FORCE_LIMIT * twist.speed()).hypot(torque_limit * twist.spin);
            support.see((set.support(&twist) / power - 1.0).abs(), place);
            // Friction of the twist lies on the ray, on the surface, against the push.
            let on = set.wrench(&twist) + set.scale_to_surface(&w);
            assert!(norm(&on, RADIUS) <= tolerance::ELLIPSOID.limit * FORCE_LIMIT);
        }
    }
    for worst in [gauge, normal, support] {
        worst.assert_within(&tolerance::ELLIPSOID);
    }
}

/// A disk and its ellipsoid, both of limit and radius 1.
fn pair() -> (RoundLimitSurface<f64, CoulombDisk>, LimitEllipsoid<f64>) {
    let disk = RoundLimitSurface::new(CoulombDisk, 1.0, 1.0).unwrap();
    (disk, disk.ellipsoid().unwrap())
}

/// Velocity ratios: fine enough to find a maximum to the quoted digits.
fn fine_ratios() -> Vec<f64> {
    let mut out: Vec<f64> = (1..100_000).map(|n| f64::from(n) * 1e-4).collect();
    out.extend(ratios(1_000));
    out
}

fn friction_at<S: FrictionSet<f64>>(set: &S, ratio: f64) -> Wrench<f64> {
    set.wrench(&Twist::new(ratio, 0.0, 1.0))
}

/// (largest value, where).
fn largest(values: impl Iterator<Item = (f64, f64)>) -> (f64, f64) {
    values
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .expect("not empty")
}

#[track_caller]
fn assert_quoted(got: f64, wanted: f64) {
    let error = (got / wanted - 1.0).abs();
    assert!(error <= tolerance::QUOTED_ELLIPSOID.limit, "{got} {wanted}");
}

#[test]
fn exact_surface_of_the_disk_lies_inside_down_to_the_quoted_gauge() {
    let (disk, ellipsoid) = pair();
    let gauge = |ratio| ellipsoid.gauge(&friction_at(&disk, ratio));
    let (depth, ratio) = largest(fine_ratios().into_iter().map(|r| (-gauge(r), r)));
    println!("| smallest gauge | {} | eps {ratio} |", -depth);
    assert_quoted(-depth, 0.934);
    assert_quoted(ratio, 0.766);
    assert!(
        fine_ratios()
            .into_iter()
            .all(|r| gauge(r) <= 1.0 + tolerance::GAUGE.limit)
    );
}

#[test]
fn ratio_that_the_ellipsoid_predicts_is_as_wrong_as_quoted() {
    let (disk, ellipsoid) = pair();
    let predicted = |ratio| {
        let twist = ellipsoid.twist_resisted_by(&friction_at(&disk, ratio));
        twist.velocity.x / twist.spin
    };
    for (ratio, quoted) in [(0.2, 0.137), (0.653, 0.580), (2.0, 3.37)] {
        assert_quoted(predicted(ratio), quoted);
        println!("| eps {ratio} | predicted {} |", predicted(ratio));
    }
    // Limits from T₀ = 2/3 and the slopes at the poles, F = ε and T = 1/(4ε): T₀ and 4T₀².
    assert_quoted(predicted(1e-6) / 1e-6, 2.0 / 3.0);
    assert_quoted(predicted(1e6) / 1e6, 16.0 / 9.0);
    let (worst, at) = largest(fine_ratios().into_iter().map(|r| (predicted(r) / r, r)));
    let (least, below) = largest(fine_ratios().into_iter().map(|r| (-predicted(r) / r, r)));
    println!(
        "| predicted over true ratio | {} to {worst} | {below} {at} |",
        -least
    );
    // Nowhere worse than at the two poles.
    assert!(worst <= 16.0 / 9.0 + 1e-9 && -least >= 2.0 / 3.0 - 1e-9);
}

#[test]
fn friction_that_the_ellipsoid_predicts_is_as_wrong_as_quoted() {
    let (disk, ellipsoid) = pair();
    let error = |r| friction_at(&ellipsoid, r) - friction_at(&disk, r);
    let over = |of: &dyn Fn(f64) -> f64| largest(fine_ratios().into_iter().map(|r| (of(r), r)));
    let (force, force_at) = over(&|r| error(r).force.x.abs());
    let (torque, torque_at) = over(&|r| error(r).torque.abs());
    let (both, both_at) = over(&|r| norm(&error(r), 1.0));
    println!("| force | {force} | eps {force_at} |");
    println!(
        "| torque | {torque}, {} of T0 | eps {torque_at} |",
        1.5 * torque
    );
    println!("| both | {both} | eps {both_at} |");
    assert_quoted(force, 0.123);
    assert_quoted(1.5 * torque, 0.151);
}

#[test]
fn nearest_wrenches_of_disk_and_ellipsoid_differ_as_documented() {
    let (disk, ellipsoid) = pair();
    let mut rng = Lcg::new(52);
    let (mut worst, mut at) = (0.0, Wrench::new(0.0, 0.0, 0.0));
    for _ in 0..100_000 {
        let tilt = rng.between(0.0, std::f64::consts::FRAC_PI_2);
        let size = rng.log_between(0.5, 1e3);
        let w = Wrench::new(size * tilt.cos(), 0.0, size * tilt.sin());
        let apart = disk.project(&w).wrench - ellipsoid.project(&w).wrench;
        if norm(&apart, 1.0) > worst {
            (worst, at) = (norm(&apart, 1.0), w);
        }
    }
    println!("| projections apart | {worst} | {at:?} |");
    assert_quoted(worst, 0.1238);
}
