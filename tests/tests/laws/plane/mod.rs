//! Patches in the plane under dry friction and powers of the speed: one list of them, and what the
//! wrench and the Jacobian of each must obey.

mod accuracy;
mod invariants;
mod shape;

use nalgebra::{Matrix3, Vector2, Vector3};
use shape::PlaneLaw::{self, Dry, Power};
use shape::{AtTwist, Shape};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::meshes::{Faces, meshes};
use tribos_tests::outlines::{Outline, outlines};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

/// Patches of one kind with the accuracy that is promised of them.
struct Family {
    name: &'static str,
    shapes: Vec<(String, Shape)>,
    laws: &'static [PlaneLaw],
    /// Of the wrench, of its scale, and of the Jacobian, of its largest entry.
    bounds: [Bound; 2],
    /// The same in f32, where it is promised.
    single: Option<[Bound; 2]>,
}

const DRY: &[PlaneLaw] = &[Dry];
const FALLING: &[PlaneLaw] = &[Power(-0.5), Power(-0.25), Power(0.0)];
const RISING: &[PlaneLaw] = &[
    Power(0.0625),
    Power(0.5),
    Power(1.0),
    Power(2.25),
    Power(3.0),
];
const STEEP: &[PlaneLaw] = &[Power(-0.75), Power(4.0), Power(7.5)];
const POWERS: &[PlaneLaw] = &[
    Power(-0.5),
    Power(0.0),
    Power(0.5),
    Power(1.0),
    Power(2.5),
    Power(6.0),
];

/// All patches, a line a kind: name, shapes, laws, bounds in f64 and in f32.
fn families() -> Vec<Family> {
    use tolerance::*;
    let uniform = |is_sliver| outlined(is_sliver, None);
    // Half of the mean pressure from the centroid to the farthest corner, or less.
    let linear = |is_sliver| outlined(is_sliver, Some([0.4, -0.3]));
    let even = [POLYGON, POLYGON_JACOBIAN];
    let leaning = [POLYGON_LINEAR, POLYGON_LINEAR_JACOBIAN];
    let thin = [SLIVER, SLIVER_JACOBIAN];
    let leaning_thin = [SLIVER_LINEAR, SLIVER_LINEAR_JACOBIAN];
    let bar = [BAR, BAR_JACOBIAN];
    let power = [POLYGON_POWER, POLYGON_POWER_JACOBIAN];
    let powers = [POLYGON_POWER_LINEAR, POLYGON_POWER_LINEAR_JACOBIAN];
    let steep = [POLYGON_POWER_ENDS, POLYGON_POWER_ENDS_JACOBIAN];
    let mesh = [MESH, MESH_JACOBIAN];
    let uneven = [MESH_UNEVEN, MESH_UNEVEN_JACOBIAN];
    let sums = [NODES, NODES_JACOBIAN];
    let single = Some([POLYGON_SINGLE, POLYGON_SINGLE_JACOBIAN]);
    let leaning_single = Some([POLYGON_LINEAR_SINGLE, POLYGON_SINGLE_JACOBIAN]);
    let of_power = Some([POLYGON_POWER_SINGLE, POLYGON_POWER_SINGLE_JACOBIAN]);
    let of_mesh = Some([MESH_SINGLE, MESH_SINGLE_JACOBIAN]);
    let (nodes, points) = (scattered(Shape::Nodes), scattered(Shape::Points));
    let lines = [
        ("polygon", uniform(false), DRY, even, single),
        (
            "leaning polygon",
            linear(false),
            DRY,
            leaning,
            leaning_single,
        ),
        ("layer, leaning across", layer(), DRY, leaning, None),
        ("sliver", uniform(true), DRY, thin, None),
        ("leaning sliver", linear(true), DRY, leaning_thin, None),
        ("falling law, polygon", uniform(false), FALLING, power, None),
        (
            "rising law, polygon",
            uniform(false),
            RISING,
            power,
            of_power,
        ),
        ("steep law, polygon", uniform(false), STEEP, steep, None),
        (
            "falling law, leaning polygon",
            linear(false),
            FALLING,
            powers,
            None,
        ),
        (
            "rising law, leaning polygon",
            linear(false),
            RISING,
            powers,
            None,
        ),
        (
            "steep law, leaning polygon",
            linear(false),
            STEEP,
            steep,
            None,
        ),
        ("mesh", meshed(false), DRY, mesh, of_mesh),
        ("uneven mesh", meshed(true), DRY, uneven, None),
        ("bar", bars(), DRY, bar, None),
        ("points", points, DRY, bar, None),
        ("nodes", nodes.clone(), DRY, sums, None),
        ("power law at nodes", nodes, POWERS, sums, None),
        (
            "round patch",
            rounds(),
            POWERS,
            [IDENTITY, JACOBIAN_DENSE],
            None,
        ),
    ];
    let family = |(name, shapes, laws, bounds, single)| Family {
        name,
        shapes,
        laws,
        bounds,
        single,
    };
    lines.into_iter().map(family).collect()
}

fn outlined(is_sliver: bool, lean: Option<[f64; 2]>) -> Vec<(String, Shape)> {
    let kept = outlines()
        .into_iter()
        .filter(|one| (one.name == "sliver") == is_sliver);
    let with_lean = |outline: Outline| {
        let radius = Shape::Outline(outline.clone(), None).radius();
        let lean = lean.map(|lean| lean.map(|part| part / radius));
        (outline.name.clone(), Shape::Outline(outline, lean))
    };
    kept.map(with_lean).collect()
}

/// Patches whose pressure is almost nothing at one long edge: on a strip it is twice the mean at the other one, on the
/// stem of a T eight times.
fn layer() -> Vec<(String, Shape)> {
    let across = |name, lean| {
        let mut across = outlined(false, Some(lean));
        across.retain(|(of, _)| of == name);
        across
    };
    [across("plank", [0.05, 9.5]), across("tee", [0.01, 7.0])].concat()
}

/// Needles, and triangles that are much smaller than their mesh but carry a good part of its load, are uneven.
fn meshed(is_uneven: bool) -> Vec<(String, Shape)> {
    // Polygons in triangles are judged by the rows of the polygon.
    let dissected = |name: &str, triangles: &[[usize; 3]]| {
        let outline = outlines().into_iter().find(|one| one.name == name);
        let corners = outline.expect(name).loops.remove(0);
        let corner = |n: usize| [corners[n][0], corners[n][1], 2.0];
        Faces {
            name: name.to_owned(),
            triangles: triangles.iter().map(|named| named.map(corner)).collect(),
        }
    };
    let square = dissected("square", &[[0, 1, 2], [0, 2, 3]]);
    let ell = dissected("ell", &[[0, 1, 2], [0, 2, 3], [3, 4, 0], [0, 4, 5]]);
    let uneven = ["graded", "needles", "spike"];
    let all = meshes().into_iter().chain([square, ell]);
    let kept = all.filter(|faces| uneven.contains(&faces.name.as_str()) == is_uneven);
    kept.map(|faces| (faces.name.clone(), Shape::Faces(faces)))
        .collect()
}

fn bars() -> Vec<(String, Shape)> {
    let [even, odd] = [
        [[-0.5, -0.25], [0.5, 0.25]],
        [[-0.125, 0.0], [0.25, 0.0625]],
    ];
    let named = [("centred", even), ("beside", odd)];
    named
        .map(|(name, ends)| (name.to_owned(), Shape::Bar(ends)))
        .into()
}

/// Places in a square of side 2.
fn scattered(of: fn(Vec<[f64; 3]>) -> Shape) -> Vec<(String, Shape)> {
    let mut rng = Lcg::new(8);
    let nodes = |seed: u32| {
        let mut nodes = [(); 12].map(|()| [(); 3].map(|()| rng.between(-1.0, 1.0)));
        nodes
            .iter_mut()
            .for_each(|[.., weight]| *weight = weight.abs());
        nodes[3][2] = 0.0;
        (format!("nodes {seed}"), of(nodes.into()))
    };
    (0..8).map(nodes).collect()
}

fn rounds() -> Vec<(String, Shape)> {
    let tiers = [
        "round table",
        "round compact",
        "disk table",
        "form disk",
        "form Hertz",
    ];
    let all = tiers
        .into_iter()
        .flat_map(|tier| [0.0, 0.5].map(|order| (tier, order)));
    all.map(|(tier, order)| (format!("{tier}, q {order}"), Shape::Round { order, tier }))
        .collect()
}

/// A patch of a family under one of its laws.
struct Case<'a> {
    family: &'a Family,
    name: &'a str,
    shape: &'a Shape,
    law: PlaneLaw,
    at: AtTwist<f64>,
    centre: Vector2<f64>,
    radius: f64,
}

const COEFFICIENT: f64 = 0.7;
const LOAD: f64 = 3.0;

impl<'a> Case<'a> {
    /// `None` where the kernel has no such coupling.
    fn new(
        family: &'a Family,
        (name, shape): (&'a str, &'a Shape),
        law: PlaneLaw,
        coefficient: f64,
    ) -> Option<Self> {
        Some(Self {
            family,
            name,
            shape,
            law,
            at: shape.friction(law, coefficient)?,
            centre: shape.centre(),
            radius: shape.radius(),
        })
    }

    /// The unit of length of torques and Jacobians: the reach from the origin.
    fn arm(&self) -> f64 {
        self.radius + self.centre.norm()
    }

    /// Velocity of the centre plus rim speed.
    fn speed(&self, twist: &Twist<f64>) -> f64 {
        let turned = Vector2::new(-self.centre.y, self.centre.x) * twist.spin;
        (twist.velocity + turned).norm() + (twist.spin * self.radius).abs()
    }

    /// Scale of the forces.
    fn limit(&self, twist: &Twist<f64>) -> f64 {
        COEFFICIENT * LOAD * self.speed(twist).powf(self.law.alpha())
    }

    /// Difference of two wrenches, of their scale.
    fn apart(&self, twist: &Twist<f64>, [one, other]: [&Wrench<f64>; 2]) -> f64 {
        let force = (one.force - other.force).amax();
        force.max((one.torque - other.torque).abs() / self.arm()) / self.limit(twist)
    }

    /// A Jacobian with the reach as the unit of length, so that all entries have one.
    fn even(&self, jacobian: &Matrix3<f64>) -> Matrix3<f64> {
        let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / self.arm()));
        unit * jacobian * unit
    }

    /// Difference of two Jacobians, of the largest entry of the second.
    fn jacobians_apart(&self, [one, other]: [&Matrix3<f64>; 2]) -> f64 {
        (self.even(one) - self.even(other)).amax() / self.even(other).amax()
    }

    /// A twist whose centre of rotation is anywhere from the patch to 10⁶ radii away, at any speed.
    fn anyhow(&self, rng: &mut Lcg) -> Twist<f64> {
        let speed = 10_f64.powf(rng.between(-6.0, 6.0));
        let turn = speed / self.radius * 10_f64.powf(rng.between(-6.0, 1.0));
        let angle = rng.between(0.0, core::f64::consts::TAU);
        let sense = 1.0_f64.copysign(rng.between(-1.0, 1.0));
        Twist::new(speed * angle.cos(), speed * angle.sin(), sense * turn)
    }

    /// One of both, in turn.
    fn either(&self, n: usize, rng: &mut Lcg) -> Twist<f64> {
        if n.is_multiple_of(2) {
            self.anyhow(rng)
        } else {
            self.clear(rng).0
        }
    }

    /// A twist with rim speed 1 about a place on the patch or beside it, and the distance of that place from
    /// the nearest one where friction is not smooth, in radii.
    fn clear(&self, rng: &mut Lcg) -> (Twist<f64>, f64) {
        loop {
            let away = Vector2::new(rng.between(-2.0, 2.0), rng.between(-2.0, 2.0));
            let pole = self.centre + away * self.radius * rng.log_between(0.3, 30.0);
            let clearance = self.shape.clearance(&pole);
            if clearance > LEAST_CLEARANCE {
                let spin = 1.0_f64.copysign(rng.between(-1.0, 1.0)) / self.radius;
                return (Twist::new(pole.y * spin, -pole.x * spin, spin), clearance);
            }
        }
    }
}

/// Radii; a rounding error of a place is 1e-14 of it.
const LEAST_CLEARANCE: f64 = 0.01;

/// Patches under the laws of their families.
const ALL: usize = 401;

/// Visits every patch under every law of its family, with a random stream; what `check` reports as errors
/// of the wrench and of the Jacobian must stay within `bounds` of the family, where there are any. `cases`
/// of them have something to judge.
fn hold(
    what: &str,
    cases: usize,
    bounds: impl Fn(&Family) -> Option<[Bound; 2]>,
    check: impl Fn(&Case, &mut Lcg, &mut dyn FnMut([Option<f64>; 2], &Twist<f64>)),
) {
    let mut judged = 0;
    for family in families() {
        let Some(bounds) = bounds(&family) else {
            continue;
        };
        let names = ["wrench", "Jacobian"].map(|part| format!("{what}: {}, {part}", family.name));
        let mut worst = names.map(Worst::of);
        for (name, shape) in &family.shapes {
            let of_law = |&law: &_| Case::new(&family, (name, shape), law, COEFFICIENT);
            for case in family.laws.iter().filter_map(of_law) {
                let mut is_judged = false;
                check(&case, &mut Lcg::new(1), &mut |errors, twist| {
                    is_judged = true;
                    for (worst, error) in worst.iter_mut().zip(errors) {
                        let place = || format!("{name}, {:?}, {twist:?}", case.law);
                        error.into_iter().for_each(|error| worst.see(error, place));
                    }
                });
                judged += usize::from(is_judged);
            }
        }
        for (worst, bound) in worst.iter().zip(&bounds) {
            worst.assert_if_seen(bound);
        }
    }
    assert_eq!(judged, cases, "{what}: patches under laws that were judged");
}

/// What is promised of the family.
fn once(family: &Family) -> Option<[Bound; 2]> {
    Some(family.bounds)
}

/// Both sides of a comparison may be wrong by as much.
fn twice(family: &Family) -> Option<[Bound; 2]> {
    Some(family.bounds.map(|Bound { limit, reason }| Bound {
        limit: 2.0 * limit,
        reason,
    }))
}
