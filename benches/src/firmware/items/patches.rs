//! Other patches than the uniform disk.

use super::{BOTH, Code, Item, NARROW, WIDE, item, round};

const HERTZ_TABLE: &str = "static TABLE: RoundTable = match RoundTable::new(0.0, PowerPressure::HERTZ) { Ok(table) => table, Err(_) => panic!() };";

/// A round patch, without dimensions.
const fn coupled(
    name: &'static str,
    precisions: &'static [&'static str],
    modules: &'static str,
    prepare: &'static str,
) -> Item {
    item(
        ["patch", name],
        precisions,
        modules,
        Code::new(prepare, "couple(object, a, b)"),
    )
}

/// A patch of nodes or edges under Coulomb's law, one twist in.
const fn dry(
    name: &'static str,
    precisions: &'static [&'static str],
    modules: &'static str,
    prepare: &'static str,
) -> Item {
    let call = "whole(&object.wrench(given.load, &given.twist))";
    item(
        ["patch", name],
        precisions,
        modules,
        Code::new(prepare, call),
    )
}

/// Modules of every exact patch with straight edges.
macro_rules! flat {
    ($more:literal) => {
        concat!(
            "coupling::flat coupling::flat::far coupling::flat::motion coupling::flat::near ",
            "coupling::flat::two patch::edge patch::frame patch::outline special::legendre ",
            "special::log_quotient ",
            $more
        )
    };
}

/// One pair of speeds or one twist in.
pub const PATCHES: [Item; 19] = [
    item(
        ["patch", "Hertz: table: Coulomb"],
        BOTH,
        round!("coupling::round coupling::side coupling::batch::ways"),
        Code::new("&TABLE", "couple(object, a, b)").with_statics(HERTZ_TABLE),
    ),
    coupled(
        "Hertz: closed",
        NARROW,
        round!("coupling::closed"),
        "closed::Hertz",
    ),
    coupled(
        "punch: closed",
        NARROW,
        round!("coupling::closed"),
        "closed::FlatPunch",
    ),
    coupled(
        "ring: closed",
        NARROW,
        round!("coupling::closed special::elliptic"),
        "closed::Ring",
    ),
    coupled(
        "annulus: table: Coulomb",
        NARROW,
        round!(
            "coupling::annulus coupling::table coupling::disk coupling::tip special::log_quotient coupling::side coupling::batch::ways"
        ),
        "Annulus::new(table::Coulomb, 0.5 as R).ok()?",
    ),
    coupled(
        "polynomial: table built at run time",
        WIDE,
        round!(
            "coupling::polynomial coupling::side coupling::batch::ways coupling::member coupling::octave power power::build special::hypergeometric patch::polynomial"
        ),
        "round::PolynomialTable::new(0.0, &PolynomialPressure::new([1.0, -2.0, 1.5]).ok()?).ok()?",
    ),
    dry(
        "tripod: Coulomb",
        BOTH,
        "coupling::nodes law::coulomb patch::nodes patch::tripod",
        "dry_nodes(Nodes::tripod([[1.0, 0.0], [-0.5, 0.75], [-0.5, -0.75]], [a, 0.0]).ok()?)?",
    ),
    dry(
        "100 nodes on a disk: Coulomb",
        NARROW,
        "coupling::nodes law::coulomb patch::nodes patch::polar patch::gauss_jacobi",
        "dry_nodes(PolarRule::new(1.0 as R, 5, 20).ok()?.nodes::<100>().ok()?)?",
    ),
    dry(
        "ring of 100 nodes: Coulomb",
        NARROW,
        "coupling::nodes law::coulomb patch::nodes patch::polar",
        "dry_nodes(NodeList::<R, 100>::ring(1.0 as R, 100).ok()?)?",
    ),
    dry(
        "polygon of 28 nodes: Coulomb",
        NARROW,
        "coupling::nodes law::coulomb patch::nodes patch::polygon",
        "dry_nodes(NodeList::<R, 28>::polygon(&[[1.0, 0.0], [-0.5, 0.75], [-0.5, -a]], 2).ok()?)?",
    ),
    dry(
        "square, exact: Coulomb",
        BOTH,
        flat!("patch::flat_pressure patch::simple"),
        "FlatFriction::new(square(b)?, 0.5).ok()?",
    ),
    item(
        ["patch", "square, exact: Coulomb, Jacobian"],
        NARROW,
        flat!("patch::flat_pressure patch::simple"),
        Code::new(
            "FlatFriction::new(square(b)?, 0.5).ok()?",
            "whole_jacobian(&object.wrench_and_jacobian(given.load, &given.twist))",
        ),
    ),
    dry(
        "square, exact: square root of the speed",
        NARROW,
        flat!(
            "patch::flat_pressure patch::simple coupling::flat::power coupling::flat::power::far coupling::flat::power::fit coupling::flat::power::near coupling::flat::power::prepared special::hypergeometric"
        ),
        "FlatPowerFriction::new(square(b)?, 0.5, FlatPower::new(0.5).ok()?).ok()?",
    ),
    dry(
        "bar, exact: Coulomb",
        NARROW,
        flat!("coupling::flat::bar coupling::flat::sums patch::bar"),
        "FlatFriction::new(Bar::new([-1.0, b], [1.0, a]).ok()?, 0.5).ok()?",
    ),
    item(
        ["patch", "square, exact: limit surface, motion of a push"],
        NARROW,
        flat!(
            "patch::flat_pressure patch::simple limit_surface limit_surface::patch limit_surface::quadratic limit_surface::search"
        ),
        Code::new(
            "PatchSurface::new(square(b)?, 0.5).ok()?",
            "turned(&object.twist_normal_to(&given.push))",
        ),
    ),
    item(
        ["patch", "square, exact: torque limits at a force"],
        NARROW,
        flat!(
            "patch::flat_pressure patch::simple limit_surface limit_surface::patch limit_surface::quadratic limit_surface::search limit_surface::yaw"
        ),
        Code::new(
            "PatchSurface::new(square(b)?, 0.5).ok()?",
            "pair(object.torque_limits([given.push.force.x, given.push.force.y]))",
        ),
    ),
    item(
        ["patch", "square, any pressure: torque limits at a force"],
        NARROW,
        "limit_surface limit_surface::any_pressure limit_surface::central_path limit_surface::quadratic limit_surface::sharing",
        Code::new(
            "AnyPressure::new([[-b, -b], [b, -b], [b, b], [-b, b]], [0.1, 0.1], 0.5).ok()?",
            "pair(object.torque_limits([given.push.force.x, given.push.force.y]).map(|limits| limits.carried))",
        ),
    ),
    dry(
        "mesh of two triangles, exact: Coulomb",
        NARROW,
        "coupling::flat coupling::flat::cone coupling::flat::far coupling::flat::mesh coupling::flat::motion coupling::flat::near coupling::flat::sums coupling::flat::two patch::edge patch::mesh patch::mesh_error patch::triangle special::log_quotient special::triangle",
        "FlatFriction::new(face(b)?, 0.5).ok()?",
    ),
    item(
        ["patch", "three points: limit surface, motion of a push"],
        NARROW,
        "coupling::flat coupling::flat::far coupling::flat::motion coupling::flat::points coupling::flat::sums coupling::flat::two patch::nodes patch::points limit_surface limit_surface::kinks limit_surface::patch limit_surface::quadratic limit_surface::search",
        Code::new(
            "PatchSurface::new(spikes(b)?, 0.5).ok()?",
            "turned(&object.twist_normal_to(&given.push))",
        ),
    ),
];
