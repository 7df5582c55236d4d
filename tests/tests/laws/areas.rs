//! Every contact area under every law is the kernel's own type, to the bit, and so are its sets.

use nalgebra::Vector3;
use tribos::friction::{
    AnyContactFriction, AnyFriction, Area, AreaFriction, ContactVisitor, FrictionError, Law, Patch,
    Precision,
};
use tribos::random::Random;
use tribos_core::contact::{
    Cohesion, Contact, ContactFriction, ContactGeometry, CoupledFriction, IndependentFriction,
    NormalLaw, SphereBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::flat::{
    PatchShape, PolygonPowerLaw, PowerLawPatch, ShapeFriction, ShapePowerFriction,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::round::{PolynomialTable, RoundTable64};
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{
    Annulus, DryProfile, DryReducedFriction, ReducedFriction, RoundFriction, coulomb,
};
use tribos_core::limit_surface::{
    FrictionSet, Projection, Region, RoundLimitSurface, ShapeLimitSurface,
};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::mesh::{Mesh, Vertex};
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::patch::points::PointPatch;
use tribos_core::patch::{PolynomialPressure, PowerPressure};
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

const ROUND: [&str; 8] = [
    "disk",
    "ring",
    "annulus:0.5",
    "hertz",
    "punch",
    "paraboloid",
    "power:0.25",
    "polynomial:1,-0.5",
];
const SHAPES: [&str; 5] = ["polygon", "leaning", "bar", "mesh", "points"];
/// Radius of round areas, in m, coefficient of laws and load in N.
const RADIUS: f64 = 0.04;
const MU: f64 = 0.3;
const LOAD: f64 = 7.0;

const OUTER: [[f64; 2]; 5] = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.3], [0.2, 0.1], [0.0, 0.3]]; // m
const HOLE: [[f64; 2]; 4] = [[0.05, 0.02], [0.1, 0.02], [0.1, 0.05], [0.05, 0.05]];
const CENTRE: [f64; 2] = [0.2, 0.11];
const ENDS: [[f64; 2]; 2] = [[-0.1, 0.0], [0.2, 0.05]];
const VERTICES: [[f64; 3]; 4] = [
    [0.0, 0.0, 1.0],
    [0.1, 0.0, 2.0],
    [0.1, 0.1, 0.5],
    [0.0, 0.1, 0.0],
];
const FEET: [[f64; 3]; 3] = [[0.1, 0.0, 1.0], [-0.1, 0.1, 2.0], [-0.1, -0.1, 1.5]];

/// An area of the room by its name here.
fn area(name: &str) -> Area {
    let vertex = |[x, y, pressure]: [f64; 3]| Vertex { x, y, pressure };
    let made = match name {
        "polygon" => Area::polygon(&[&OUTER, &HOLE], None),
        "leaning" => Area::polygon(&[&OUTER, &HOLE], Some(CENTRE)),
        "bar" => Area::bar(ENDS[0], ENDS[1]),
        "mesh" => Area::mesh(&VERTICES.map(vertex), &[[0, 1, 2], [0, 2, 3]]),
        "points" => Area::points(FEET.map(node).to_vec()),
        _ => Area::round(name.parse().unwrap(), RADIUS),
    };
    made.unwrap()
}

fn node([x, y, weight]: [f64; 3]) -> Node<f64> {
    Node { x, y, weight }
}

fn polygon() -> Polygon<f64, [Edge<f64>; 9]> {
    Polygon::with_holes(&[&OUTER, &HOLE], [Edge::default(); 9]).unwrap()
}

/// Work with the kernel's own type of a shape.
trait WithShape {
    type Output;
    fn with<P: PatchShape<f64> + Clone + 'static>(self, shape: P) -> Self::Output;
}

fn with_shape<W: WithShape>(name: &str, work: W) -> W::Output {
    match name {
        "polygon" => work.with(polygon()),
        "leaning" => work.with(polygon().with_centre_of_pressure(CENTRE).unwrap()),
        "bar" => work.with(Bar::new(ENDS[0], ENDS[1]).unwrap()),
        "mesh" => {
            let [a, b, c, d] = VERTICES.map(|[x, y, pressure]| Vertex { x, y, pressure });
            work.with(Mesh::new([[a, b, c], [a, c, d]]).unwrap())
        }
        _ => work.with(PointPatch::new(Nodes::new(FEET.map(node)).unwrap()).unwrap()),
    }
}

/// Work with the kernel's own dry friction of a round patch.
trait WithDry {
    type Output;
    fn with<C>(self, dry: C) -> Self::Output
    where
        C: DryReducedFriction<f64> + Copy + Send + Sync + 'static;
}

fn with_dry<W: WithDry>(name: &str, work: W) -> W::Output {
    match name {
        "disk" => work.with(CoulombDisk),
        "ring" => work.with(coulomb::CoulombRing),
        "hertz" => work.with(coulomb::CoulombHertz),
        "punch" => work.with(coulomb::CoulombPunch),
        "annulus:0.5" => work.with(Annulus::new(CoulombDisk, 0.5).unwrap()),
        "paraboloid" => work.with(coulomb::CoulombParaboloid),
        "power:0.25" => {
            let pressure = PowerPressure::new(0.25).unwrap();
            work.with(DryProfile::new(RoundTable64::new(0.0, pressure).unwrap()).unwrap())
        }
        _ => {
            let pressure = PolynomialPressure::new([1.0, -0.5]).unwrap();
            work.with(DryProfile::new(PolynomialTable::new(0.0, &pressure).unwrap()).unwrap())
        }
    }
}

type AtTwist = Box<dyn Fn(&Twist<f64>) -> (Wrench<f64>, WrenchJacobian<f64>)>;

struct DryAt;

impl WithShape for DryAt {
    type Output = AtTwist;
    fn with<P: PatchShape<f64> + Clone + 'static>(self, shape: P) -> AtTwist {
        let friction = ShapeFriction::new(shape, MU).unwrap();
        Box::new(move |twist| friction.wrench_and_jacobian(LOAD, twist))
    }
}

const LAWS: [&str; 3] = [
    "coulomb:mu=0.3",
    "power:gamma=0.3,alpha=0.5",
    "stribeck:mu_s=0.4,mu_d=0.2,vs=0.05",
];

/// The same of a round area: forms and tables of powers of the speed, quadrature of other laws.
fn round_kernel(name: &str, law: &Law) -> AtTwist {
    fn of_patch<C: ReducedFriction<f64> + 'static>(coupling: C, coefficient: f64) -> AtTwist {
        let friction = RoundFriction::new(coupling, coefficient, RADIUS).unwrap();
        Box::new(move |twist| {
            let wrench = friction.wrench(LOAD, twist);
            (wrench, friction.wrench_jacobian(LOAD, twist))
        })
    }
    let patch: Patch = name.parse().unwrap();
    let Some([mu, alpha]) = law.power_of_speed() else {
        // The module `friction` holds it against the kernel's quadratures.
        return of_patch(AnyFriction::<f64>::new(&patch, law, None).unwrap(), 1.0);
    };
    let polynomial = PolynomialPressure::new([1.0, -0.5]).unwrap();
    match (name, patch.pressure()) {
        ("disk", _) if alpha == 0.0 => of_patch(CoulombDisk, mu),
        ("disk", _) => of_patch(DiskTable64::new(alpha).unwrap(), mu),
        ("annulus:0.5", _) if alpha == 0.0 => of_patch(Annulus::new(CoulombDisk, 0.5).unwrap(), mu),
        ("annulus:0.5", _) => {
            let disk = DiskTable64::new(alpha).unwrap();
            of_patch(Annulus::new(disk, 0.5).unwrap(), mu)
        }
        ("ring", _) if alpha == 0.0 => of_patch(coulomb::CoulombRing, mu),
        ("hertz", _) if alpha == 0.0 => of_patch(coulomb::CoulombHertz, mu),
        ("punch", _) if alpha == 0.0 => of_patch(coulomb::CoulombPunch, mu),
        ("paraboloid", _) if alpha == 0.0 => of_patch(coulomb::CoulombParaboloid, mu),
        (_, Some(pressure)) => of_patch(RoundTable64::new(alpha, pressure).unwrap(), mu),
        (_, None) => of_patch(PolynomialTable::new(alpha, &polynomial).unwrap(), mu),
    }
}

/// The kernel's own friction of an area under a law, written down once more; `None` where there is none.
fn kernel(name: &str, law: &Law) -> Option<AtTwist> {
    fn of_power(shape: impl PowerLawPatch<f64> + 'static) -> AtTwist {
        let power = PolygonPowerLaw::new(0.5).unwrap();
        let friction = ShapePowerFriction::new(shape, MU, power).unwrap();
        Box::new(move |twist| friction.wrench_and_jacobian(LOAD, twist))
    }
    if ROUND.contains(&name) {
        return Some(round_kernel(name, law));
    }
    Some(match (name, law.name()) {
        (shape, "coulomb") => with_shape(shape, DryAt),
        ("points", _) => {
            let nodes = Nodes::new(FEET.map(node)).unwrap();
            let friction = NodeFriction::new(law.build::<f64>().unwrap(), nodes);
            Box::new(move |twist| {
                let wrench = friction.wrench(LOAD, twist);
                (wrench, friction.wrench_jacobian(LOAD, twist))
            })
        }
        ("polygon", "power") => of_power(polygon()),
        ("leaning", "power") => of_power(polygon().with_centre_of_pressure(CENTRE).unwrap()),
        _ => return None,
    })
}

/// Seeded twists over decades, at rest and without either motion.
fn twists() -> Vec<Twist<f64>> {
    let mut random = Random::new(2026, 0);
    let mut signed = |most: f64| most * (2.0 * random.unit() - 1.0);
    let mut all = vec![
        Twist::ZERO,
        Twist::new(1.0, 0.0, 0.0),
        Twist::new(0.0, 0.0, -2.0),
    ];
    for decade in [1.0, 1e-3, 1e3] {
        all.extend((0..30).map(|_| Twist::new(signed(1.0), signed(decade), signed(20.0))));
    }
    all
}

fn bits(wrench: &Wrench<f64>, jacobian: &WrenchJacobian<f64>) -> Vec<u64> {
    let parts = [wrench.force.x, wrench.force.y, wrench.torque];
    parts
        .iter()
        .chain(jacobian.iter())
        .map(|x| x.to_bits())
        .collect()
}

/// Single calls and batches have the bits of the kernel.
fn assert_bits(
    what: &str,
    kernel: &AtTwist,
    one: impl Fn(&Twist<f64>) -> (Wrench<f64>, WrenchJacobian<f64>),
    many: impl Fn(&[Twist<f64>], &mut [Wrench<f64>], &mut [WrenchJacobian<f64>]),
) {
    let twists = twists();
    let mut wrenches = vec![Wrench::ZERO; twists.len()];
    let mut jacobians = vec![WrenchJacobian::zeros(); twists.len()];
    many(&twists, &mut wrenches, &mut jacobians);
    for ((twist, wrench), jacobian) in twists.iter().zip(&wrenches).zip(&jacobians) {
        let ((expected, rate), (alone, slope)) = (kernel(twist), one(twist));
        let expected = bits(&expected, &rate);
        assert_eq!(bits(&alone, &slope), expected, "{what} at {twist:?}");
        assert_eq!(bits(wrench, jacobian), expected, "{what}, batch");
    }
}

#[test]
fn every_area_under_every_law_has_the_bits_of_the_kernel_or_is_refused() {
    for name in ROUND.iter().chain(&SHAPES) {
        let area = area(name);
        for text in LAWS {
            let law: Law = text.parse().unwrap();
            let made = AreaFriction::new(&area, &law, None);
            let (friction, kernel) = match (made, kernel(name, &law)) {
                (Ok(friction), Some(kernel)) => (friction, kernel),
                (Err(FrictionError::Unserved(_)), None) => continue,
                (made, kernel) => {
                    panic!("{text} on {name}: {made:?}, kernel {}", kernel.is_some())
                }
            };
            let one = |twist: &Twist<f64>| {
                let wrench = friction.wrench(LOAD, twist);
                (wrench, friction.wrench_jacobian(LOAD, twist))
            };
            let many = |twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>], rates: &mut [_]| {
                friction.wrench_batch(LOAD, twists, wrenches);
                friction.jacobian_batch(LOAD, twists, rates);
            };
            assert_bits(&format!("{text} on {name}"), &kernel, one, many);
        }
    }
}

#[test]
fn friction_by_name_has_the_bits_of_the_kernel() {
    for (name, text) in ROUND.iter().flat_map(|name| LAWS.map(|text| (name, text))) {
        let law: Law = text.parse().unwrap();
        let friction = AnyFriction::new(&name.parse().unwrap(), &law, None).unwrap();
        let friction = friction.with_radius(RADIUS).unwrap();
        let one = |twist: &Twist<f64>| {
            let wrench = friction.wrench(LOAD, twist);
            (wrench, friction.wrench_jacobian(LOAD, twist))
        };
        let many = |twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>], rates: &mut [_]| {
            friction.wrench_batch(LOAD, twists, wrenches);
            friction.jacobian_batch(LOAD, twists, rates);
        };
        assert_bits(
            &format!("{text} on {name}"),
            &round_kernel(name, &law),
            one,
            many,
        );
    }
}

/// Answers of a set to a wrench and a twist, in bits.
fn answers(set: &dyn FrictionSet<f64>, [x, y, n]: [f64; 3]) -> Vec<u64> {
    let (push, twist) = (Wrench::new(x, y, 0.1 * n), Twist::new(x, y, 10.0 * n));
    let Projection { wrench, region } = set.project_with_length(&push, 0.07);
    let normal = match region {
        Region::Inside => Twist::ZERO,
        Region::OnSurface { normal } => normal,
    };
    let [motion, friction] = [set.twist_normal_to(&push), normal];
    let mut all = vec![
        set.force_limit(),
        set.radius(),
        set.support(&twist),
        set.gauge(&push),
    ];
    for twist in [motion, friction] {
        all.extend([twist.velocity.x, twist.velocity.y, twist.spin]);
    }
    for wrench in [wrench, set.wrench(&twist), set.scale_to_surface(&push)] {
        all.extend([wrench.force.x, wrench.force.y, wrench.torque]);
    }
    all.iter().map(|x| x.to_bits()).collect()
}

/// Compares the surfaces of an area with the kernel's.
struct Compare<'a>(&'a str);

impl Compare<'_> {
    fn with_set(&self, limit: f64, kernel: &dyn FrictionSet<f64>) {
        let surfaces = area(self.0).limit_surfaces().unwrap();
        let mut random = Random::new(7, 0);
        for _ in 0..40 {
            let push = [(); 3].map(|()| 4.0 * random.unit() - 2.0);
            let same = surfaces.under(limit, |set| answers(set, push)).unwrap();
            assert_eq!(same, answers(kernel, push), "{} under {limit} N", self.0);
        }
    }
}

impl WithDry for Compare<'_> {
    type Output = ();
    fn with<C: DryReducedFriction<f64> + Copy + Send + Sync + 'static>(self, dry: C) {
        for limit in [1.0, 0.3] {
            self.with_set(limit, &RoundLimitSurface::new(dry, limit, RADIUS).unwrap());
        }
        // By name the same.
        let patch: Patch = self.0.parse().unwrap();
        let named = Area::named(&patch, RADIUS, None)
            .unwrap()
            .limit_surface(1.0)
            .unwrap();
        self.with_set(1.0, &*named);
        // No table where the patch has none: a pointer to what the kernel's own set has in it.
        let own = size_of::<RoundLimitSurface<f64, C>>();
        assert!(size_of_val(&*named) <= own + size_of::<&dyn FrictionSet<f64>>());
    }
}

impl WithShape for Compare<'_> {
    type Output = ();
    fn with<P: PatchShape<f64> + Clone + 'static>(self, shape: P) {
        for limit in [1.0, 0.3] {
            let kernel = ShapeLimitSurface::new(shape.clone(), limit).unwrap();
            self.with_set(limit, &kernel);
            let surfaces = area(self.0).limit_surfaces().unwrap();
            for force in [[0.1, 0.05], [0.0, 0.0], [2.0, 0.0]] {
                let limits = surfaces.torque_limits(limit, force).unwrap();
                let expected = kernel.torque_limits(force).unwrap_or([f64::NAN; 2]);
                assert_eq!(
                    limits.map(f64::to_bits),
                    expected.map(f64::to_bits),
                    "{}",
                    self.0
                );
            }
        }
    }
}

#[test]
fn every_area_has_the_limit_surfaces_of_the_kernel() {
    for name in ROUND {
        with_dry(name, Compare(name));
        let round = area(name).limit_surfaces().unwrap();
        // Beside half of the largest force, and alone.
        for force in [[0.0; 2], [0.3, -0.4]] {
            let [low, high] = round.torque_limits(1.0, force).unwrap();
            let wrench = Wrench::new(force[0], force[1], high);
            let gauge = round.under(1.0, |set| set.gauge(&wrench)).unwrap();
            assert!(
                low == -high && high > 0.0 && (gauge - 1.0).abs() < 1e-12,
                "{name}: {high} {gauge}"
            );
        }
    }
    for name in SHAPES {
        with_shape(name, Compare(name));
    }
}

/// A contact of two spheres that slide and spin, with its impulse.
struct Collide;

impl ContactVisitor for Collide {
    type Output = Vec<u64>;
    fn visit<F: ContactFriction<f64> + 'static>(self, friction: &F) -> Vec<u64> {
        let ball = |velocity, spin| SphereBody {
            velocity,
            spin,
            inv_mass: 5.0,
            inv_inertia: 2e4,
        };
        let mut a = ball(Vector3::new(0.5, 0.1, 1.0), Vector3::new(3.0, -1.0, 80.0));
        let mut b = ball(Vector3::zeros(), Vector3::new(0.0, 5.0, -20.0));
        let law = NormalLaw::new(Cohesion::NONE, 0.0).unwrap();
        let touch = ContactGeometry::spheres(&Vector3::new(0.0, 0.0, 0.06), [0.03; 2]).unwrap();
        let mut contact = Contact::<f64, F::Modes>::new(&touch, &law, &a, &b, 1e-3);
        contact.update(friction, &mut a, &mut b);
        let impulse = contact.impulse();
        let vectors = [
            a.velocity,
            a.spin,
            b.spin,
            impulse.sliding(),
            impulse.rolling(),
        ];
        let all = vectors.iter().flat_map(|vector| vector.iter().copied());
        let all = all.chain([impulse.normal, impulse.torsion()]);
        all.map(f64::to_bits).collect()
    }
}

struct Coupled<'a>(&'a str);

impl WithDry for Coupled<'_> {
    type Output = ();
    fn with<C: DryReducedFriction<f64> + Copy + Send + Sync + 'static>(self, dry: C) {
        let set = RoundLimitSurface::new(dry, MU, RADIUS).unwrap();
        let made = |rolling| AnyContactFriction::coupled(&area(self.0), MU, rolling).unwrap();
        let spinning = CoupledFriction::sliding_torsion(set);
        assert_eq!(
            made(0.0).visit(Collide),
            Collide.visit(&spinning),
            "{}",
            self.0
        );
        assert_eq!(made(0.0).mu_torsion(), spinning.mu_torsion());
        let all = CoupledFriction::all(set, 0.05).unwrap();
        assert_eq!(made(0.05).visit(Collide), Collide.visit(&all), "{}", self.0);
    }
}

#[test]
fn every_round_area_has_the_coupled_contact_of_the_kernel() {
    for name in ROUND {
        with_dry(name, Coupled(name));
    }
    for name in SHAPES {
        let refused = AnyContactFriction::coupled(&area(name), MU, 0.0);
        assert!(matches!(refused, Err(FrictionError::Unserved(_))), "{name}");
    }
    let thresholds = |given| {
        AnyContactFriction::thresholds(given)
            .unwrap()
            .visit(Collide)
    };
    let same = |given, kernel: Vec<u64>| assert_eq!(thresholds(given), kernel, "{given:?}");
    same([0.0; 3], Collide.visit(&IndependentFriction::none()));
    same(
        [MU, 0.0, 0.0],
        Collide.visit(&IndependentFriction::sliding(MU).unwrap()),
    );
    same(
        [MU, 0.1, 0.0],
        Collide.visit(&IndependentFriction::sliding_rolling(MU, 0.1).unwrap()),
    );
    same(
        [MU, 0.0, 0.1],
        Collide.visit(&IndependentFriction::sliding_torsion(MU, 0.1).unwrap()),
    );
    same(
        [MU, 0.1, 0.1],
        Collide.visit(&IndependentFriction::all(MU, 0.1, 0.1).unwrap()),
    );
    assert!(AnyContactFriction::thresholds([0.0, -1.0, 0.0]).is_err());
}

#[test]
fn areas_are_served_in_single_precision() {
    fn torque<R: Precision>(patch: &str, law: &str) -> f64 {
        let area = Area::<R>::named(&patch.parse().unwrap(), R::ONE, None).unwrap();
        let friction = AreaFriction::new(&area, &law.parse().unwrap(), None).unwrap();
        let turning = Twist::new(R::from_f64(0.5), R::ZERO, R::from_f64(3.0));
        friction.wrench(R::ONE, &turning).torque.to_f64()
    }
    for (patch, law) in [
        ("disk", LAWS[0]),
        ("hertz", LAWS[2]),
        ("box:0.3x0.2", LAWS[1]),
    ] {
        let [double, single] = [torque::<f64>(patch, law), torque::<f32>(patch, law)];
        assert!(
            (double - single).abs() < 1e-6,
            "{law} on {patch}: {single}, not {double}"
        );
    }
}

#[test]
fn a_polynomial_pressure_carries_as_much_in_single_precision() {
    // A power of two is the same radius in both.
    const LEVER: f32 = 0.03125;
    // What limit surfaces promise in single precision, over the limits.
    const SINGLE: f64 = 3e-7;
    let patch: Patch = "polynomial:1,-0.5".parse().unwrap();
    let single = Area::round(patch.clone(), LEVER).unwrap();
    let single = single.limit_surface(1.0).unwrap();
    let double = Area::round(patch, f64::from(LEVER)).unwrap();
    let double = double.limit_surface(1.0).unwrap();
    let mut random = Random::new(5, 0);
    for _ in 0..200 {
        let [x, y, n] = [(); 3].map(|()| (4.0 * random.unit() - 2.0) as f32);
        let n = LEVER * n;
        let push = Wrench::new(x, y, n);
        let wide = Wrench::new(f64::from(x), f64::from(y), f64::from(n));
        let gauge = double.gauge(&wide);
        assert!((f64::from(single.gauge(&push)) / gauge - 1.0).abs() < SINGLE);
        let (near, right) = (single.project(&push).wrench, double.project(&wide).wrench);
        let off = [
            f64::from(near.force.x) - right.force.x,
            f64::from(near.force.y) - right.force.y,
            (f64::from(near.torque) - right.torque) / f64::from(LEVER),
        ];
        assert!(
            off.iter().all(|off| off.abs() < SINGLE),
            "{push:?}: {off:?}"
        );
    }
}
