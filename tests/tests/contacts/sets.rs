//! Sets of wrenches that friction can carry: one list of them, and what each must obey.

use tribos_core::Real;
use tribos_core::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombPunch};
use tribos_core::coupling::{Annulus, DryReducedFriction};
use tribos_core::internals::COLLAR_ULPS;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, Region, RoundLimitSurface, ScaledSet, ShapeLimitSurface,
};
use tribos_core::patch::nodes::{Node, NodeList};
use tribos_core::patch::points::PointPatch;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::outlines::outlines;
use tribos_tests::surfaces::{FORCE_LIMIT, RADIUS, Ring, inner, norm, random_wrench, same_bits};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

/// A set with what is promised of it.
struct Instance {
    name: String,
    set: Box<dyn FrictionSet<f64>>,
    promise: Promise,
    /// Whether many wrenches share a normal, and many normals a wrench.
    has_facets: bool,
    /// Whether it is a solid of revolution.
    is_round: bool,
    /// Width of what counts as on its surface, of that of round patches: slender shapes have more.
    wide: f64,
    /// Wrenches of each check.
    rounds: u32,
}

/// Accuracies in parts of the set's limits.
#[derive(Clone, Copy)]
struct Promise {
    /// Gauge and support.
    gauge: Bound,
    /// Friction of a normal, against the wrench that has this normal.
    friction: Bound,
    /// Displacement by a projection, of the limits and the wrench.
    displacement: Bound,
    /// Gauge of projections against 1, in units of EPSILON.
    on_surface: Bound,
}

const ROUND: Promise = Promise {
    gauge: tolerance::GAUGE,
    friction: tolerance::FRICTION_OF_NORMAL,
    displacement: tolerance::ACROSS_NORMAL,
    on_surface: tolerance::ON_SURFACE_ULPS,
};
/// A ring, whose slope is infinite at equal speeds, and the difference of two disks.
const NOISY: Promise = Promise {
    gauge: tolerance::FRICTION_OF_NORMAL,
    on_surface: tolerance::ON_SURFACE_PLANE_ULPS,
    ..ROUND
};
const SHAPE: Promise = Promise {
    gauge: tolerance::PATCH_SURFACE,
    friction: tolerance::PATCH_SURFACE,
    displacement: tolerance::PATCH_SURFACE,
    on_surface: tolerance::ON_SURFACE_PLANE_ULPS,
};
const POINTS: Promise = Promise {
    gauge: tolerance::POINT_SURFACE,
    friction: tolerance::POINT_SURFACE,
    displacement: tolerance::POINT_PROJECTION,
    on_surface: tolerance::ON_SURFACE_POINT_ULPS,
};

/// All sets, a line a kind.
fn instances() -> Vec<Instance> {
    let mut all = vec![
        round("disk", CoulombDisk, ROUND),
        round("ring", Ring, NOISY),
        round("Hertz", CoulombHertz, ROUND),
        round("punch", CoulombPunch, ROUND),
        round(
            "annulus",
            Annulus::new(CoulombDisk, 0.6).expect("valid"),
            NOISY,
        ),
        revolved("ellipsoid", ellipsoid(), ROUND),
        revolved("stronger disk", stronger(), ROUND),
    ];
    // Beyond 10:1 a shape loses its aspect ratio.
    let shapes = outlines().into_iter().filter(|one| one.name != "sliver");
    all.extend(shapes.map(|one| Instance {
        wide: 4.0,
        ..of(&one.name, shape(one.patch()), SHAPE, 500)
    }));
    all.extend(points().map(|(name, nodes)| {
        let patch = PointPatch::new(nodes).expect("several places");
        Instance {
            has_facets: true,
            ..of(name, shape(patch), POINTS, 500)
        }
    }));
    all
}

fn of(name: &str, set: impl FrictionSet<f64> + 'static, promise: Promise, rounds: u32) -> Instance {
    Instance {
        name: name.to_owned(),
        set: Box::new(set),
        promise,
        has_facets: false,
        is_round: false,
        wide: 1.0,
        rounds,
    }
}

fn round<C: DryReducedFriction<f64> + 'static>(
    name: &str,
    coupling: C,
    promise: Promise,
) -> Instance {
    revolved(name, puck(coupling), promise)
}

fn revolved(name: &str, set: impl FrictionSet<f64> + 'static, promise: Promise) -> Instance {
    Instance {
        is_round: true,
        ..of(name, set, promise, 50_000)
    }
}

fn puck<R: Real, C: DryReducedFriction<R>>(coupling: C) -> RoundLimitSurface<R, C> {
    let [limit, radius] = [FORCE_LIMIT, RADIUS].map(R::from_f64);
    RoundLimitSurface::new(coupling, limit, radius).expect("the limits are valid")
}

/// Its reduced torque is no special number.
fn ellipsoid() -> LimitEllipsoid<f64> {
    LimitEllipsoid::new(FORCE_LIMIT, RADIUS, 0.6).expect("the limits are valid")
}

fn stronger() -> ScaledSet<'static, f64, RoundLimitSurface<f64, CoulombDisk>> {
    let disk: &'static _ = Box::leak(Box::new(puck(CoulombDisk)));
    ScaledSet::new(disk, 1.7).expect("positive")
}

fn shape<P: tribos_core::coupling::flat::PatchShape<f64>>(patch: P) -> ShapeLimitSurface<f64, P> {
    ShapeLimitSurface::new(patch, FORCE_LIMIT).expect("valid")
}

/// Places in a line, twice at the same one, with little between them, scattered over a factor of 100 in weight.
fn points() -> [(&'static str, NodeList<f64, 8>); 4] {
    let mut rng = Lcg::new(21);
    let scattered = [(); 7].map(|()| {
        let [x, y] = [(); 2].map(|()| rng.between(-1.0, 1.0));
        (x, y, 10_f64.powf(rng.between(-2.0, 0.0)))
    });
    let line = [-1.0, -0.25, 0.5, 1.0].map(|x| (x, 0.0, 1.0));
    let twice = [0.0, 0.0, 1.0, 1.0].map(|x| (x, x, 1.0));
    let light = [0.0, 1e-3, 2.0, 3.0].map(|x| (x, x * x, x));
    [
        ("points in a line", listed(&line)),
        ("points twice", listed(&twice)),
        ("light points", listed(&light)),
        ("scattered points", listed(&scattered)),
    ]
}

/// Nodes from places and weights.
fn listed(places: &[(f64, f64, f64)]) -> NodeList<f64, 8> {
    let mut nodes = NodeList::new();
    for &(x, y, weight) in places {
        nodes.push(Node { x, y, weight }).expect("room");
    }
    nodes
}

/// A wrench in any direction, its force and torque of `size` in those of the set.
fn of_size(rng: &mut Lcg, set: &dyn FrictionSet<f64>, size: f64) -> Wrench<f64> {
    let unit = random_wrench(rng, size);
    let (limit, lever) = (set.force_limit() / FORCE_LIMIT, set.radius() / RADIUS);
    if limit == 1.0 && lever == 1.0 {
        return unit;
    }
    Wrench {
        force: unit.force * limit,
        torque: unit.torque * (limit * lever),
    }
}

/// Outside, or not far from being so, over several decades.
fn outer(rng: &mut Lcg, set: &dyn FrictionSet<f64>) -> Wrench<f64> {
    let size = if rng.unit() < 0.5 {
        rng.between(0.5, 3.0)
    } else {
        rng.log_between(0.5, 1e4)
    };
    of_size(rng, set, size)
}

/// A motion of any ratio, one in two dense around equal speeds, where couplings are worst.
fn motion(rng: &mut Lcg, set: &dyn FrictionSet<f64>) -> Twist<f64> {
    if rng.bits() >> 63 == 0 {
        let apart = rng.log_between(1e-16, 1e-1) * if rng.unit() < 0.5 { 1.0 } else { -1.0 };
        let sliding = 1.0 + apart;
        return Twist::new(0.6 * sliding, -0.8 * sliding, 1.0 / set.radius());
    }
    let Wrench { force, torque } = random_wrench(rng, 1.0);
    Twist::new(force.x, force.y, torque / RADIUS / set.radius())
}

impl Instance {
    /// No errors of this set yet.
    fn worst(&self, what: &str) -> Worst {
        Worst::of(format!("{what}, {}", self.name))
    }
}

/// Of every set the largest errors, each within its bound.
fn each<const KINDS: usize>(see: impl Fn(&Instance) -> [(Worst, Bound); KINDS]) {
    for instance in instances() {
        for (worst, bound) in see(&instance) {
            worst.assert_within(&bound);
        }
    }
}

#[test]
fn friction_dissipates_most_of_all_wrenches_of_the_set() {
    each(|instance| {
        let [mut attained, mut beyond, mut gauge] =
            ["support", "other wrenches", "gauge of friction"].map(|what| instance.worst(what));
        let (set, mut rng) = (&*instance.set, Lcg::new(31));
        for _ in 0..instance.rounds {
            let twist = motion(&mut rng, set);
            let (friction, support) = (set.wrench(&twist), set.support(&twist));
            // In parts of what no patch of this size exceeds.
            let most = set.force_limit() * (twist.speed() + set.radius() * twist.spin.abs());
            let rest = (support + friction.power(&twist)) / most;
            attained.see(rest.abs(), || format!("{twist:?}"));
            gauge.see((set.gauge(&friction) - 1.0).abs(), || format!("{twist:?}"));
            let other = set.scale_to_surface(&of_size(&mut rng, set, 1.0));
            beyond.see((other.power(&twist) - support) / most, || {
                format!("{other:?}")
            });
        }
        let bound = instance.promise.gauge;
        [attained, beyond, gauge].map(|worst| (worst, bound))
    });
}

#[test]
fn gauge_is_a_norm() {
    each(|instance| {
        let [mut sum, mut scaled, mut radial] =
            ["triangle", "scaled wrench", "radial wrench"].map(|what| instance.worst(what));
        let (set, mut rng) = (&*instance.set, Lcg::new(32));
        for _ in 0..instance.rounds {
            let [a, b] = [1.0, 0.7].map(|size| of_size(&mut rng, set, size));
            let place = || format!("{a:?} {b:?}");
            let [one, other, both] = [a, b, a + b].map(|wrench| set.gauge(&wrench));
            assert!(one > 0.0);
            sum.see(both / (one + other) - 1.0, place);
            for factor in [-1.0, 3.0_f64] {
                let error = set.gauge(&(a * factor)) / (factor.abs() * one) - 1.0;
                scaled.see(error.abs(), place);
            }
            let on = set.gauge(&set.scale_to_surface(&a));
            radial.see((on - 1.0).abs(), place);
        }
        let bound = instance.promise.gauge;
        [sum, scaled, radial].map(|worst| (worst, bound))
    });
}

/// How far the friction of `normal` is from the wrench `on` that it should meet; nothing where it is one of many.
fn unlike(instance: &Instance, on: &Wrench<f64>, normal: &Twist<f64>) -> f64 {
    let set = &instance.set;
    if instance.has_facets {
        return 0.0;
    }
    norm(&(*on + set.wrench(normal)), set.radius()) / set.force_limit()
}

#[test]
fn the_motion_of_a_push_is_the_normal_above_it_and_meets_it_as_friction() {
    each(|instance| {
        let [mut attained, mut balance] = ["normal", "balance"].map(|what| instance.worst(what));
        let (set, mut rng) = (&*instance.set, Lcg::new(33));
        for _ in 0..instance.rounds {
            let push = outer(&mut rng, set);
            let (normal, on) = (set.twist_normal_to(&push), set.scale_to_surface(&push));
            let length = normal.speed().hypot(normal.spin * set.radius());
            assert!((length - 1.0).abs() <= tolerance::ROUNDING.limit);
            assert_eq!(set.twist_resisted_by(&-push), normal);
            // It attains the support: no wrench of the set lies beyond.
            let rest = (on.power(&normal) - set.support(&normal)) / set.force_limit();
            attained.see(rest.abs(), || format!("{push:?}"));
            balance.see(unlike(instance, &on, &normal), || format!("{push:?}"));
        }
        let Promise { friction, .. } = instance.promise;
        [(attained, tolerance::IDENTITY), (balance, friction)]
    });
}

/// Optimality without a search: the displacement is a multiple ≥ 0 of the normal, and the normal attains its support
/// at the projection, so that no wrench of the set is nearer.
#[test]
fn displacements_are_normal_and_lead_away_from_the_set() {
    each(|instance| {
        let [mut across, mut attained, mut balance] = [
            "displacement",
            "support of projections",
            "friction of normals",
        ]
        .map(|what| instance.worst(what));
        let (set, mut rng) = (&*instance.set, Lcg::new(42));
        let (limit, radius) = (set.force_limit(), set.radius());
        for _ in 0..instance.rounds {
            let (given, length) = (outer(&mut rng, set), radius * rng.log_between(0.03, 30.0));
            let got = set.project_with_length(&given, length);
            let Region::OnSurface { normal } = got.region else {
                assert!(set.gauge(&given) < 1.0);
                continue;
            };
            let place = || format!("{given:?}, length {length}");
            let moved = given - got.wrench;
            let [x, y] = [normal.velocity.x, normal.velocity.y];
            let along = Wrench::new(x, y, normal.spin * length * length);
            let factor = inner(&moved, &along, length) / inner(&along, &along, length);
            let scale = limit * (1.0 + radius / length) + norm(&given, length);
            across.see(norm(&(moved - along * factor), length) / scale, place);
            assert!(factor >= -1e-15 * scale, "{}", place());
            let rest = (set.support(&normal) - got.wrench.power(&normal)) / limit;
            attained.see(rest.abs(), place);
            balance.see(unlike(instance, &got.wrench, &normal), place);
            // A component that is absent stays absent.
            if instance.is_round {
                let is_forced = given.force.norm() != 0.0;
                assert!(given.torque != 0.0 || got.wrench.torque == 0.0);
                assert!(is_forced || got.wrench.force.norm() == 0.0);
            }
        }
        let Promise {
            friction,
            displacement,
            ..
        } = instance.promise;
        [
            (across, displacement),
            (attained, tolerance::IDENTITY),
            (balance, friction),
        ]
    });
}

/// A second wrench, as often near the first as anywhere.
fn partner(rng: &mut Lcg, set: &dyn FrictionSet<f64>, first: &Wrench<f64>) -> Wrench<f64> {
    if rng.unit() < 0.5 {
        return outer(rng, set);
    }
    let step = rng.log_between(1e-16, 1.0);
    *first + of_size(rng, set, 1.0) * step
}

#[test]
fn no_pair_moves_apart() {
    each(|instance| {
        let (mut worst, mut rng) = (instance.worst("expansion"), Lcg::new(43));
        let set = &*instance.set;
        let (radius, limit) = (set.radius(), set.force_limit());
        for _ in 0..10 * instance.rounds {
            let a = outer(&mut rng, set);
            let b = partner(&mut rng, set, &a);
            let near = set.project(&a).wrench - set.project(&b).wrench;
            let growth = norm(&near, radius) - norm(&(a - b), radius);
            worst.see((growth / limit).max(0.0), || format!("{a:?} {b:?}"));
        }
        [(worst, instance.promise.displacement)]
    });
}

/// Projects projections and the friction of motions.
#[test]
fn projecting_again_changes_neither_bits_nor_region() {
    each(|instance| {
        let (mut worst, mut rng) = (instance.worst("gauge - 1 of projections"), Lcg::new(45));
        let set = &*instance.set;
        for n in 0..4 * instance.rounds {
            let given = outer(&mut rng, set);
            let length = set.radius() * rng.log_between(0.1, 10.0);
            let on = if n % 2 == 0 {
                set.project_with_length(&given, length)
            } else {
                set.project(&set.wrench(&motion(&mut rng, set)))
            };
            let again = set.project_with_length(&on.wrench, length);
            assert!(same_bits(&on.wrench, &again.wrench), "{on:?} {again:?}");
            assert!(set.contains(&on.wrench));
            let [is_on, is_still_on] =
                [on.region, again.region].map(|region| region != Region::Inside);
            assert!(
                is_on == is_still_on || instance.has_facets,
                "{}: {on:?} {again:?}",
                instance.name
            );
            if let (true, Region::OnSurface { normal }, Region::OnSurface { normal: same }) =
                (instance.is_round, on.region, again.region)
            {
                let turned = (normal.velocity - same.velocity).norm();
                let twisted = (normal.spin - same.spin).abs() * set.radius();
                assert!(turned.max(twisted) <= 1e-12, "{normal:?} {same:?}");
            }
            if is_on {
                let off = (set.gauge(&on.wrench) - 1.0).abs() / f64::EPSILON;
                worst.see(off, || format!("{given:?}"));
            }
        }
        [(worst, instance.promise.on_surface)]
    });
}

fn is_nan(w: &Wrench<f64>) -> bool {
    w.force.x.is_nan() && w.force.y.is_nan() && w.torque.is_nan()
}

#[test]
fn every_bit_pattern_has_an_answer() {
    let special = special_f64();
    let pairs = || {
        special
            .iter()
            .flat_map(|x| special.iter().map(move |y| (*x, *y)))
    };
    let all: Vec<_> = pairs()
        .flat_map(|(x, y)| special.iter().map(move |torque| Wrench::new(x, y, *torque)))
        .collect();
    for Instance { name, set, .. } in instances() {
        for w in &all {
            assert_answered(&name, &*set, w);
        }
        let none = Wrench::new(0.0, 0.0, 0.0);
        assert_eq!(set.gauge(&none), 0.0);
        assert_eq!(set.twist_normal_to(&none), Twist::ZERO);
        assert_eq!(set.scale_to_surface(&none), none);
        assert_eq!(set.project(&none).region, Region::Inside);
        assert_eq!(set.wrench(&Twist::ZERO), none, "{name}");
        assert_eq!(set.support(&Twist::ZERO), 0.0, "{name}");
    }
}

fn assert_answered(name: &str, set: &dyn FrictionSet<f64>, w: &Wrench<f64>) {
    let place = || format!("{name}, {w:?}");
    let Wrench { force, torque } = *w;
    let (gauge, projection) = (set.gauge(w), set.project(w));
    let (normal, on) = (set.twist_normal_to(w), set.scale_to_surface(w));
    let friction = set.wrench(&Twist::new(force.x, force.y, torque));
    let is_carried = set.contains(&projection.wrench);
    assert_eq!(is_carried, !is_nan(&projection.wrench), "{}", place());
    let is_infinite = [force.x, force.y, torque].iter().any(|x| x.is_infinite());
    assert!(
        !is_infinite || gauge == f64::INFINITY || gauge.is_nan(),
        "{}",
        place()
    );
    if force.x.is_nan() || force.y.is_nan() || torque.is_nan() {
        let is_carried = set.contains(w);
        assert!(
            gauge.is_nan() && is_nan(&projection.wrench) && !is_carried,
            "{}",
            place()
        );
        assert!(
            normal.velocity.x.is_nan() || normal.spin.is_nan(),
            "{}",
            place()
        );
        assert!(on.force.x.is_nan() || on.torque.is_nan(), "{}", place());
        assert!(
            friction.force.x.is_nan() || friction.torque.is_nan(),
            "{}",
            place()
        );
    } else if gauge == f64::INFINITY {
        assert!(
            is_nan(&projection.wrench) && !set.contains(w),
            "{}",
            place()
        );
    } else {
        assert!(gauge >= 0.0, "{}", place());
        assert!(
            normal.speed().is_finite() && normal.spin.is_finite(),
            "{}",
            place()
        );
        let still = force.x == 0.0 && force.y == 0.0 && torque == 0.0;
        let is_some = norm(&on, set.radius()) > 0.0;
        assert!(still || is_some || gauge == 0.0, "{}", place());
    }
}

/// What a projection leaves as it is lies in the set, and what it finds inside does so by the gauge, with a collar
/// of up to `wide` times the usual one.
fn assert_judged_by_the_gauge<R: Real>(name: &str, set: &dyn FrictionSet<R>, wide: f64) {
    let real = R::from_f64;
    let collar = real(COLLAR_ULPS) * R::EPSILON;
    let (limit, lever) = (
        set.force_limit() / real(FORCE_LIMIT),
        set.radius() / real(RADIUS),
    );
    let mut rng = Lcg::new(43);
    let (mut inside, rounds) = (0, 2_000_u32);
    for round in 0..rounds {
        let size = rng.between(0.0, 1.3);
        let unit = random_wrench(&mut rng, size);
        let [x, y, torque] = [unit.force.x, unit.force.y, unit.torque].map(real);
        let mut given = Wrench::new(x * limit, y * limit, torque * limit * lever);
        if round % 2 == 0 {
            // As close to the surface as rounding tells apart.
            let below = real(f64::from(round % 512)) * R::EPSILON;
            given = set.scale_to_surface(&given) * (R::ONE - below);
        }
        let place = || format!("{name}: {given:?}");
        let (gauge, got) = (set.gauge(&given), set.project(&given));
        let is_inside = got.region == Region::Inside;
        assert!(!is_inside || gauge < R::ONE - collar, "{}", place());
        assert!(
            is_inside || gauge >= R::ONE - collar * real(wide),
            "{}",
            place()
        );
        assert_eq!(set.contains(&given), got.wrench == given, "{}", place());
        inside += u32::from(is_inside);
    }
    let most = 9 * rounds / 10;
    assert!((rounds / 5..most).contains(&inside), "{name}: {inside}");
}

#[test]
fn wrenches_deep_inside_are_told_from_others_as_the_gauge_tells_them() {
    for Instance {
        name, set, wide, ..
    } in instances()
    {
        assert_judged_by_the_gauge(&name, &*set, wide);
    }
    for (name, set) in singles() {
        assert_judged_by_the_gauge(name, &*set, 1.0);
    }
}

/// Those of which single precision is promised.
fn singles() -> [(&'static str, Box<dyn FrictionSet<f32>>); 2] {
    [
        ("disk", Box::new(puck(CoulombDisk))),
        ("Hertz", Box::new(puck(CoulombHertz))),
    ]
}

fn narrow(w: &Wrench<f64>) -> Wrench<f32> {
    Wrench::new(w.force.x as f32, w.force.y as f32, w.torque as f32)
}

fn wide(w: &Wrench<f32>) -> Wrench<f64> {
    let [x, y, torque] = [w.force.x, w.force.y, w.torque].map(f64::from);
    Wrench::new(x, y, torque)
}

#[test]
fn single_precision_follows_double_and_moves_no_pair_apart() {
    let [limit, radius] = [FORCE_LIMIT, RADIUS].map(|x| f64::from(x as f32));
    let exact = RoundLimitSurface::new(CoulombDisk, limit, radius).expect("valid");
    let hertz = RoundLimitSurface::new(CoulombHertz, limit, radius).expect("valid");
    let all: [Box<dyn FrictionSet<f64>>; 2] = [Box::new(exact), Box::new(hertz)];
    for ((name, set), exact) in singles().into_iter().zip(all) {
        let [mut error, mut growth] =
            ["projection", "expansion"].map(|what| Worst::of(format!("f32 {what}, {name}")));
        let mut rng = Lcg::new(44);
        for _ in 0..100_000 {
            let a = outer(&mut rng, &*exact);
            let (a, b) = (narrow(&a), narrow(&partner(&mut rng, &*exact, &a)));
            let [near, other] = [a, b].map(|given| set.project(&given).wrench);
            assert_eq!(set.project(&near).wrench, near);
            let rest = wide(&near) - exact.project(&wide(&a)).wrench;
            error.see(norm(&rest, RADIUS) / FORCE_LIMIT, || format!("{a:?}"));
            let [apart, after] =
                [wide(&a) - wide(&b), wide(&near) - wide(&other)].map(|w| norm(&w, RADIUS));
            growth.see(((after - apart) / FORCE_LIMIT).max(0.0), || {
                format!("{a:?} {b:?}")
            });
        }
        error.assert_within(&tolerance::SINGLE_PROJECTION);
        growth.assert_within(&tolerance::EXPANSION_SINGLE);
    }
}
