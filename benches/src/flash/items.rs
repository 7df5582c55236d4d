//! The items whose price in flash is told: what each program calls.

/// Something that a program may name.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// Law, tier, patch, …
    pub group: &'static str,
    /// As it appears in reports.
    pub name: &'static str,
    /// Modules of the kernel that the program may contain, beside [`PLUMBING`].
    pub modules: &'static [&'static str],
    /// Statics of the program.
    pub statics: &'static str,
    /// An `Option<R>` from two numbers `a` and `b` unknown to the compiler.
    pub body: &'static str,
    /// In which precisions it is built.
    pub precisions: &'static [&'static str],
}

const NARROW: &[&str] = &["f32"];
const WIDE: &[&str] = &["f64"];
const BOTH: &[&str] = &["f32", "f64"];

/// Modules that are no feature of their own; `coupling` itself has its traits only.
pub const PLUMBING: [&str; 6] = [
    "coupling",
    "real",
    "twist",
    "law::error",
    "law::limits",
    "coupling::speeds",
];

/// Modules of every round patch under a power law.
macro_rules! round {
    ($($more:literal),* $(,)?) => {
        &[
            "coupling::profile",
            "coupling::family",
            "coupling::lateral",
            "coupling::friction",
            "patch::power",
            $($more),*
        ]
    };
}

const HALF_TABLE: &str =
    "static TABLE: Table = match Table::new(0.5) { Ok(table) => table, Err(_) => panic!() };";
const HERTZ_TABLE: &str = "static TABLE: RoundTable = match RoundTable::new(0.0, PowerPressure::HERTZ) { Ok(table) => table, Err(_) => panic!() };";

const fn law(name: &'static str, modules: &'static [&'static str], body: &'static str) -> Item {
    Item {
        group: "law",
        name,
        modules,
        statics: "",
        body,
        precisions: NARROW,
    }
}

const fn item(
    [group, name]: [&'static str; 2],
    precisions: &'static [&'static str],
    modules: &'static [&'static str],
    [statics, body]: [&'static str; 2],
) -> Item {
    Item {
        group,
        name,
        modules,
        statics,
        body,
        precisions,
    }
}

/// Local laws: one friction, or one step of a state.
pub const LAWS: [Item; 13] = [
    law("Coulomb", &["law::coulomb"], "Some(Coulomb::new(b).ok()?.friction(a))"),
    law("dry friction", &["law::dry", "law::grip"], "Some(DryFriction::new(0.5, 0.25).ok()?.net_drive(a))"),
    law("power", &["law::power"], "Some(PowerLaw::new(0.5, b).ok()?.friction(a))"),
    law("plateau", &["law::plateau"], "Some(PlateauPower::new(-0.5, b, 1e-2, 1e-4, 0.5).ok()?.friction(a))"),
    law(
        "Stribeck",
        &["law::stribeck", "law::dry"],
        "Some(Stribeck::new(DryFriction::new(0.5, 0.25).ok()?, b, 2.0, 0.125).ok()?.friction(a))",
    ),
    law("ageing", &["law::ageing", "law::grip"], "let law = Ageing::new(0.25, 0.125, b).ok()?;
    Some(law.mu_static(Age::default().advance(a, law.at_rest(Age::default(), b))))"),
    law(
        "rate and state",
        &["law::rate_state", "law::contact_age"],
        "let law = RateState::<R, Dieterich>::new(RateStateParameters { mu: 0.5, a: 0.01, b: 0.02, reference_speed: b, slip_distance: 1e-5, viscous: 0.0 }).ok()?;
    let age = law.advance(ContactAge { theta: b }, a, b);
    Some(law.coefficient(a, age))",
    ),
    law(
        "rate and state: steady",
        &["law::rate_state", "law::steady_rate_state", "law::contact_age"],
        "let law = RateState::<R, Dieterich>::new(RateStateParameters { mu: 0.5, a: 0.01, b: 0.02, reference_speed: b, slip_distance: 1e-5, viscous: 0.0 }).ok()?;
    Some(law.steady().friction(a))",
    ),
    law(
        "LuGre",
        &["law::lugre"],
        "let law = LuGre::new(LuGreParameters { coulomb_force: 1.0, static_force: 1.5, stribeck_speed: b, stiffness: 1e5, bristle_damping: 300.0, viscous_damping: 0.5 }).ok()?;
    Some(law.step(Bristle { deflection: b }, a, b).1)",
    ),
    law(
        "LuGre: steady",
        &["law::lugre"],
        "let law = LuGre::new(LuGreParameters { coulomb_force: 1.0, static_force: 1.5, stribeck_speed: b, stiffness: 1e5, bristle_damping: 300.0, viscous_damping: 0.5 }).ok()?;
    Some(law.steady_force(a))",
    ),
    law(
        "Bowden-Tabor on Hertz",
        &["law::bowden_tabor", "law::real_area"],
        "Some(BowdenTabor::new(1e6, HertzSphere::new(b, 1e9).ok()?).ok()?.force(a))",
    ),
    law("Stokes", &["law::drag"], "Some(Stokes::new(b, 1e-3).ok()?.force(a))"),
    law("inertial drag", &["law::drag"], "Some(InertialDrag::new(b, 1.25, 1e-3).ok()?.force(a))"),
];

/// Force and torque of the uniform disk.
pub const TIERS: [Item; 6] = [
    item(
        ["tier", "table: Coulomb"],
        BOTH,
        round!["coupling::table", "coupling::side"],
        ["", "couple(&table::Coulomb, a, b)"],
    ),
    item(
        ["tier", "table: alpha 0.5"],
        BOTH,
        round!["coupling::table", "coupling::side"],
        [HALF_TABLE, "couple(&TABLE, a, b)"],
    ),
    item(
        ["tier", "compact: Coulomb"],
        BOTH,
        round!["coupling::compact", "special::elliptic"],
        ["", "couple(&compact::Coulomb, a, b)"],
    ),
    item(
        ["tier", "compact: alpha 0.5"],
        BOTH,
        round![
            "coupling::compact",
            "coupling::member",
            "coupling::octave",
            "special::hypergeometric"
        ],
        ["", "couple(&compact::Power::new(0.5 as R).ok()?, a, b)"],
    ),
    item(
        ["tier", "quadrature: Coulomb"],
        BOTH,
        &["coupling::quadrature", "law::coulomb"],
        [
            "",
            "couple(&DiskQuadrature::new(Coulomb::new(1.0 as R).ok()?), a, b)",
        ],
    ),
    item(
        ["tier", "quadrature: Stribeck"],
        NARROW,
        &["coupling::quadrature", "law::stribeck", "law::dry"],
        [
            "",
            "couple(&DiskQuadrature::new(Stribeck::new(DryFriction::new(0.5 as R, 0.25).ok()?, 0.5, 2.0, 0.125).ok()?), a, b)",
        ],
    ),
];

/// Other patches.
pub const PATCHES: [Item; 10] = [
    item(
        ["patch", "Hertz: table: Coulomb"],
        BOTH,
        round!["coupling::round", "coupling::side"],
        [HERTZ_TABLE, "couple(&TABLE, a, b)"],
    ),
    item(
        ["patch", "Hertz: closed"],
        NARROW,
        round!["coupling::closed"],
        ["", "couple(&closed::Hertz, a, b)"],
    ),
    item(
        ["patch", "punch: closed"],
        NARROW,
        round!["coupling::closed"],
        ["", "couple(&closed::FlatPunch, a, b)"],
    ),
    item(
        ["patch", "ring: closed"],
        NARROW,
        round!["coupling::closed", "special::elliptic"],
        ["", "couple(&closed::Ring, a, b)"],
    ),
    item(
        ["patch", "annulus: table: Coulomb"],
        NARROW,
        round!["coupling::annulus", "coupling::table", "coupling::side"],
        [
            "",
            "couple(&Annulus::new(table::Coulomb, 0.5 as R).ok()?, a, b)",
        ],
    ),
    item(
        ["patch", "polynomial: table built at run time"],
        WIDE,
        round![
            "coupling::polynomial",
            "coupling::side",
            "coupling::member",
            "coupling::octave",
            "special::hypergeometric",
            "patch::polynomial"
        ],
        [
            "",
            "couple(&round::PolynomialTable::new(0.0, &PolynomialPressure::new([1.0, -2.0, 1.5]).ok()?).ok()?, a, b)",
        ],
    ),
    item(
        ["patch", "tripod: Coulomb"],
        BOTH,
        &[
            "coupling::nodes",
            "law::coulomb",
            "patch::nodes",
            "patch::tripod",
        ],
        [
            "",
            "on_nodes(tripod([[1.0, 0.0], [-0.5, 0.75], [-0.5, -0.75]], [a, 0.0]).ok()?, a, b)",
        ],
    ),
    item(
        ["patch", "100 nodes on a disk: Coulomb"],
        NARROW,
        &[
            "coupling::nodes",
            "law::coulomb",
            "patch::nodes",
            "patch::polar",
            "patch::gauss_jacobi",
        ],
        [
            "",
            "let nodes: NodeList<R, 100> = PolarRule::new(1.0 as R, 5, 20).ok()?.nodes().ok()?;\n    on_nodes(nodes, a, b)",
        ],
    ),
    item(
        ["patch", "ring of 100 nodes: Coulomb"],
        NARROW,
        &[
            "coupling::nodes",
            "law::coulomb",
            "patch::nodes",
            "patch::polar",
        ],
        [
            "",
            "let nodes: NodeList<R, 100> = polar::ring(1.0 as R, 100).ok()?;\n    on_nodes(nodes, a, b)",
        ],
    ),
    item(
        ["patch", "polygon: Coulomb"],
        NARROW,
        &[
            "coupling::nodes",
            "law::coulomb",
            "patch::nodes",
            "patch::polygon",
        ],
        [
            "",
            "let nodes: NodeList<R, 28> = polygon(&[[1.0, 0.0], [-0.5, 0.75], [-0.5, -a]], 2).ok()?;\n    on_nodes(nodes, a, b)",
        ],
    ),
];

/// Modules of everything that stands on the disk's Coulomb table.
macro_rules! on_table {
    ($($more:literal),* $(,)?) => {
        round!["coupling::table", "coupling::side", $($more),*]
    };
}

/// What stands on a coupling: each with the Coulomb table of its precision.
pub const BODIES: [Item; 10] = [
    item(
        ["body", "disk with dimensions"],
        BOTH,
        on_table![],
        ["", "Some(disk()?.wrench(a, &Twist::new(a, b, b)).force.x)"],
    ),
    item(
        ["body", "tall: front-back"],
        NARROW,
        on_table!["coupling::tall"],
        [
            "",
            "Some(TallFriction::<_, _, FrontBack>::new(disk()?, 0.25).ok()?.wrench(a, &Twist::new(a, b, b)).wrench.force.x)",
        ],
    ),
    item(
        ["body", "tall: all round"],
        NARROW,
        on_table!["coupling::tall"],
        [
            "",
            "Some(TallFriction::<_, _, AllRound>::new(disk()?, 0.25).ok()?.wrench(a, &Twist::new(a, b, b)).wrench.force.x)",
        ],
    ),
    item(
        ["limit surface", "gauge"],
        NARROW,
        on_table![
            "limit_surface",
            "limit_surface::exact",
            "limit_surface::meridian",
            "limit_surface::polar"
        ],
        [
            "",
            "Some(LimitSurface::new(table::Coulomb, 1.0 as R, 1.0).ok()?.gauge(&push(a, b)))",
        ],
    ),
    item(
        ["limit surface", "projection"],
        BOTH,
        on_table![
            "limit_surface",
            "limit_surface::exact",
            "limit_surface::meridian",
            "limit_surface::polar"
        ],
        [
            "",
            "Some(LimitSurface::new(table::Coulomb, 1.0 as R, 1.0).ok()?.project(&push(a, b)).wrench.torque)",
        ],
    ),
    item(
        ["limit surface", "ellipsoid: projection"],
        NARROW,
        &[
            "limit_surface",
            "limit_surface::ellipsoid",
            "limit_surface::exact",
            "limit_surface::meridian",
            "limit_surface::polar",
        ],
        [
            "",
            "Some(Ellipsoid::new(1.0 as R, 1.0, 0.625).ok()?.project(&push(a, b)).wrench.torque)",
        ],
    ),
    item(
        ["motion", "final modes"],
        NARROW,
        on_table!["modes"],
        [
            "",
            "Modes::new(table::Coulomb, b).ok()?.finite_fixed_point()",
        ],
    ),
    item(
        ["motion", "slider to rest"],
        BOTH,
        on_table!["modes", "slider", "slider::rest", "slider::runge_kutta"],
        [
            "",
            "Some(slider()?.to_rest(&Motion::launched(a, b))?.motion.time)",
        ],
    ),
    item(
        ["motion", "slider: a given time"],
        NARROW,
        on_table![
            "modes",
            "slider",
            "slider::rest",
            "slider::advance",
            "slider::runge_kutta"
        ],
        [
            "",
            "Some(slider()?.advance(&Motion::launched(a, b), b).motion.time)",
        ],
    ),
    item(
        ["motion", "slider: Verlet step"],
        NARROW,
        on_table!["slider", "slider::verlet"],
        [
            "",
            "Some(slider()?.verlet_step(&Motion::launched(a, b), b).speed)",
        ],
    ),
];

/// Modules of one contact under thresholds.
macro_rules! impulse {
    ($($more:literal),* $(,)?) => {
        &[
            "contact",
            "contact::block",
            "contact::body",
            "contact::update",
            "contact::disc",
            "contact::friction",
            "contact::modes",
            "contact::normal",
            "contact::touch",
            "contact::vector",
            $($more),*
        ]
    };
}

/// Impulses of contacts: one update of a ball on a plate, and a manifold of two such.
pub const IMPULSES: [Item; 7] = [
    item(
        ["impulse", "frictionless"],
        NARROW,
        impulse![],
        ["", "struck(Thresholds::none(), a, b)"],
    ),
    item(
        ["impulse", "sliding"],
        BOTH,
        impulse![],
        ["", "struck(Thresholds::sliding(b).ok()?, a, b)"],
    ),
    item(
        ["impulse", "sliding, torsion"],
        NARROW,
        impulse![],
        ["", "struck(Thresholds::sliding_torsion(b, b).ok()?, a, b)"],
    ),
    item(
        ["impulse", "sliding, rolling, torsion"],
        BOTH,
        impulse!["contact::pair"],
        ["", "struck(Thresholds::all(b, b, a).ok()?, a, b)"],
    ),
    item(
        ["impulse", "coupled: exact"],
        NARROW,
        round![
            "coupling::table",
            "coupling::side",
            "limit_surface",
            "limit_surface::exact",
            "limit_surface::meridian",
            "limit_surface::polar",
            "contact",
            "contact::block",
            "contact::body",
            "contact::update",
            "contact::coupled",
            "contact::friction",
            "contact::modes",
            "contact::normal",
            "contact::pair",
            "contact::touch",
            "contact::vector"
        ],
        [
            "",
            "struck(CoupledFriction::sliding_torsion(LimitSurface::new(table::Coulomb, b, 0.5).ok()?), a, b)",
        ],
    ),
    item(
        ["impulse", "coupled: ellipsoid"],
        NARROW,
        impulse![
            "limit_surface",
            "limit_surface::ellipsoid",
            "limit_surface::exact",
            "limit_surface::meridian",
            "limit_surface::polar",
            "contact::coupled",
            "contact::pair"
        ],
        [
            "",
            "struck(CoupledFriction::sliding_torsion(Ellipsoid::new(b, 0.5, 0.625).ok()?), a, b)",
        ],
    ),
    item(
        ["impulse", "manifold: sliding"],
        BOTH,
        impulse![
            "manifold",
            "manifold::member",
            "manifold::solve",
            "contact::time_step"
        ],
        ["", "gripped(Thresholds::sliding(b).ok()?, a, b)"],
    ),
];

/// Names nothing of the kernel.
pub const BASELINE: Item = Item {
    group: "baseline",
    name: "nothing",
    modules: &[],
    statics: "",
    body: "Some(a + b)",
    precisions: BOTH,
};
