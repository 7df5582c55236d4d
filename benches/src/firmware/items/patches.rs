//! Other patches than the uniform disk.

use super::{BOTH, Code, Item, NARROW, WIDE, item, round};

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
            "coupling::flat coupling::flat::uniform coupling::flat::moving_edge lanes special::log_part coupling::flat::pole_far ",
            "coupling::flat::motion coupling::flat::pole_near coupling::flat::pair_of_numbers patch::edge patch::outline_extent patch::outline special::legendre ",
            "special::log_quotient ",
            $more
        )
    };
}

/// Modules of every patch with curved sides.
macro_rules! elliptic {
    ($more:literal) => {
        concat!(
            "coupling::flat coupling::flat::ellipse coupling::flat::ellipse_closed coupling::flat::panels coupling::flat::motion ",
            "special::elliptic special::legendre ",
            $more
        )
    };
}

/// One pair of speeds or one twist in.
pub const PATCHES: [Item; 27] = [
    coupled(
        "Hertz: form",
        BOTH,
        round!(
            "coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        "coulomb::CoulombHertz",
    ),
    coupled(
        "punch: form",
        NARROW,
        round!(
            "coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        "coulomb::CoulombPunch",
    ),
    coupled(
        "ring: form",
        NARROW,
        round!(
            "coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        "coulomb::CoulombRing",
    ),
    coupled(
        "annulus: form",
        NARROW,
        round!(
            "coupling::annulus coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        "Annulus::new(coulomb::CoulombDisk, 0.5 as R).ok()?",
    ),
    coupled(
        "polynomial: table built at run time",
        WIDE,
        round!(
            "coupling::round coupling::polynomial coupling::regime_table coupling::batch::ways coupling::family_member coupling::half_octave_table power power::build special::hypergeometric patch::polynomial"
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
        "dry_nodes(PolarQuadrature::new(1.0 as R, 5, 20).ok()?.nodes::<100>().ok()?)?",
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
        flat!("patch::flat_pressure patch::outline_check"),
        "ShapeFriction::new(square(b)?, 0.5).ok()?",
    ),
    item(
        ["patch", "square, exact: Coulomb, Jacobian"],
        NARROW,
        flat!("patch::flat_pressure patch::outline_check"),
        Code::new(
            "ShapeFriction::new(square(b)?, 0.5).ok()?",
            "whole_jacobian(&object.wrench_and_jacobian(given.load, &given.twist))",
        ),
    ),
    dry(
        "square, exact: square root of the speed",
        NARROW,
        flat!(
            "patch::flat_pressure patch::outline_check coupling::flat::power coupling::flat::power::far coupling::flat::power::fit coupling::flat::power::near coupling::flat::power::prepared special::hypergeometric"
        ),
        "ShapePowerFriction::new(square(b)?, 0.5, PolygonPowerLaw::new(0.5).ok()?).ok()?",
    ),
    dry(
        "bar, exact: Coulomb",
        NARROW,
        flat!("coupling::flat::bar coupling::flat::sums patch::bar"),
        "ShapeFriction::new(Bar::new([-1.0, b], [1.0, a]).ok()?, 0.5).ok()?",
    ),
    item(
        ["patch", "square, exact: limit surface, motion of a push"],
        NARROW,
        flat!(
            "patch::flat_pressure patch::outline_check limit_surface limit_surface::shape limit_surface::quadratic limit_surface::search"
        ),
        Code::new(
            "ShapeLimitSurface::new(square(b)?, 0.5).ok()?",
            "turned(&object.twist_normal_to(&given.push))",
        ),
    ),
    item(
        ["patch", "square, exact: torque limits at a force"],
        NARROW,
        flat!(
            "patch::flat_pressure patch::outline_check limit_surface limit_surface::shape limit_surface::quadratic limit_surface::search limit_surface::torque_range"
        ),
        Code::new(
            "ShapeLimitSurface::new(square(b)?, 0.5).ok()?",
            "pair(object.torque_limits([given.push.force.x, given.push.force.y]))",
        ),
    ),
    item(
        ["patch", "square, any pressure: torque limits at a force"],
        NARROW,
        "limit_surface limit_surface::any_pressure limit_surface::central_path limit_surface::quadratic limit_surface::load_sharing",
        Code::new(
            "UnknownPressureSet::new([[-b, -b], [b, -b], [b, b], [-b, b]], [0.1, 0.1], 0.5).ok()?",
            "pair(object.torque_limits([given.push.force.x, given.push.force.y]).map(|limits| limits.certain))",
        ),
    ),
    dry(
        "mesh of two triangles, exact: Coulomb",
        NARROW,
        "coupling::flat coupling::flat::cone coupling::flat::pole_far coupling::flat::mesh coupling::flat::motion coupling::flat::pole_near coupling::flat::sums coupling::flat::pair_of_numbers patch::edge patch::mesh patch::mesh_error patch::triangle special::log_quotient special::triangle",
        "ShapeFriction::new(face(b)?, 0.5).ok()?",
    ),
    item(
        ["patch", "three points: limit surface, motion of a push"],
        NARROW,
        "coupling::flat coupling::flat::pole_far coupling::flat::motion coupling::flat::points coupling::flat::sums coupling::flat::pair_of_numbers patch::nodes patch::points limit_surface limit_surface::nonsmooth_search limit_surface::shape limit_surface::quadratic limit_surface::search",
        Code::new(
            "ShapeLimitSurface::new(spikes(b)?, 0.5).ok()?",
            "turned(&object.twist_normal_to(&given.push))",
        ),
    ),
    coupled(
        "worn annulus",
        NARROW,
        round!(
            "coupling::worn coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient special::legendre"
        ),
        "WornAnnulus::new(0.6 as R).ok()?",
    ),
    dry(
        "ellipse, Hertz: Coulomb",
        NARROW,
        elliptic!("patch::ellipse"),
        "ShapeFriction::new(Ellipse::new([0.0, 0.0], [1.0, b], EllipsePressure::Hertz).ok()?, 0.5).ok()?",
    ),
    dry(
        "half a disk: Coulomb",
        NARROW,
        elliptic!(
            "patch::ellipse patch::arcs patch::arcs_cut patch::arcs_maker patch::edge coupling::flat::arcs coupling::flat::uniform coupling::flat::moving_edge lanes patch::outline special::log_part special::log_quotient"
        ),
        "ShapeFriction::new(half_disk(b)?, 0.5).ok()?",
    ),
    dry(
        "square, two coefficients",
        NARROW,
        flat!(
            "patch::flat_pressure patch::outline_check patch::anisotropic patch::affine_image coupling::flat::anisotropic"
        ),
        "ShapeFriction::new(AnisotropicPatch::new(square(b)?, AxisCoefficients::new([0.5, 1.0], [1.0, a]).ok()?).ok()?, 0.5).ok()?",
    ),
    item(
        ["patch", "half a square on a belt"],
        NARROW,
        flat!(
            "patch::flat_pressure patch::outline_check patch::piece floor floor::group coupling::flat::feet patch::feet"
        ),
        Code::new(
            "half_square(b)?",
            "Feet::new(core::slice::from_ref(object)).map_or(0.0, |feet| whole(&feet.wrench(&given.twist)))",
        ),
    ),
    item(
        ["patch", "disk on a belt: steady motion"],
        NARROW,
        round!(
            "patch::round coupling::flat coupling::flat::round coupling::flat::motion coupling::flat::feet patch::feet floor floor::group floor::search floor::steady limit_surface limit_surface::shape limit_surface::quadratic limit_surface::search limit_surface::nonsmooth_search coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        Code::new(
            "belted(b)?",
            "Feet::new(core::slice::from_ref(object)).map_or(0.0, |feet| steady(&feet.steady_motion(&given.push)))",
        ),
    ),
    item(
        ["patch", "Hertz' sphere: friction and its slope by the load"],
        NARROW,
        round!(
            "coupling::loaded patch::elastic coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways"
        ),
        Code::new(
            "LoadedFriction::new(coulomb::CoulombHertz, 0.5, HertzSphere::new(1e6, b).ok()?).ok()?",
            "whole(&object.slope_by_load(given.load, &given.twist))",
        ),
    ),
    item(
        ["patch", "JKR: radius"],
        NARROW,
        "patch::elastic patch::elastic::adhesive",
        Code::new(
            "AdhesiveSphere::new(1e6, b, 0.05).ok()?",
            "object.radius(given.load)",
        ),
    ),
    item(
        ["patch", "elliptic Hertz: semi-axes"],
        NARROW,
        "patch::elastic patch::elastic::ellipse special::elliptic",
        Code::new(
            "HertzEllipse::new(1e6, [1.0, b]).ok()?",
            "object.semi_axes(given.load)[0]",
        ),
    ),
];
