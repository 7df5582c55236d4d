//! What patches in the plane are made of, their friction in either precision, and what follows from
//! their shape without the kernel: moments of the pressure and places where friction is not smooth.

use nalgebra::{Matrix2, Matrix3, Vector2};
use tribos_core::Real;
use tribos_core::coupling::flat::{
    PatchShape, PolygonPowerLaw, PowerLawPatch, ShapeFriction, ShapePowerFriction,
};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{LateralFriction, RoundFriction};
use tribos_core::law::{CoulombLaw, LocalLaw, PowerLaw};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_core::patch::outline::{Edge, LinearPressure, Polygon};
use tribos_core::patch::points::PointPatch;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};
use tribos_tests::meshes::Faces;
use tribos_tests::outlines::Outline;
use tribos_tests::patches::{self, RoundTabulated};

/// A patch with its pressure.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A polygon under uniform pressure, or under one with this slope about the centroid.
    Outline(Outline, Option<[f64; 2]>),
    Faces(Faces),
    Bar([[f64; 2]; 2]),
    /// Places and weights, summed node by node.
    Nodes(Vec<[f64; 3]>),
    /// The same as one shape.
    Points(Vec<[f64; 3]>),
    /// The pressure (1 − r²/R²)^order about the origin, by a tier of the kernel.
    Round {
        order: f64,
        tier: &'static str,
    },
}

/// Dry friction, or a power of the speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneLaw {
    Dry,
    Power(f64),
}

impl PlaneLaw {
    pub fn alpha(self) -> f64 {
        match self {
            Self::Dry => 0.0,
            Self::Power(alpha) => alpha,
        }
    }
}

/// The wrench by itself, and the one that comes with the Jacobian.
pub struct Friction<R: Real> {
    pub alone: Wrench<R>,
    pub wrench: Wrench<R>,
    pub jacobian: WrenchJacobian<R>,
}

/// Friction of a patch by load and twist.
pub type AtTwist<R> = Box<dyn Fn(R, &Twist<R>) -> Friction<R>>;

fn with<R: Real>(
    alone: Wrench<R>,
    (wrench, jacobian): (Wrench<R>, WrenchJacobian<R>),
) -> Friction<R> {
    Friction {
        alone,
        wrench,
        jacobian,
    }
}

fn dry<R: Real + 'static>(patch: impl PatchShape<R> + 'static, mu: R) -> AtTwist<R> {
    let of = ShapeFriction::new(patch, mu).expect("valid");
    Box::new(move |load, twist| with(of.wrench(load, twist), of.wrench_and_jacobian(load, twist)))
}

fn power<R: Real + 'static>(
    patch: impl PowerLawPatch<R> + 'static,
    mu: R,
    alpha: f64,
) -> AtTwist<R> {
    let power = PolygonPowerLaw::new(R::from_f64(alpha)).expect("valid");
    let of = ShapePowerFriction::new(patch, mu, power).expect("valid");
    Box::new(move |load, twist| with(of.wrench(load, twist), of.wrench_and_jacobian(load, twist)))
}

fn at_nodes<R: Real + 'static>(
    law: impl LocalLaw<R> + 'static,
    nodes: impl NodePatch<R> + 'static,
) -> AtTwist<R> {
    let of = NodeFriction::new(law, nodes);
    Box::new(move |load, twist| {
        let wrench = of.wrench(load, twist);
        with(wrench, (wrench, of.wrench_jacobian(load, twist)))
    })
}

fn round<R: RoundTabulated + 'static>(coupling: Box<dyn LateralFriction<R>>, mu: R) -> AtTwist<R> {
    // Few and small: they may live as long as the test.
    let coupling: &'static dyn LateralFriction<R> = Box::leak(coupling);
    let of = RoundFriction::new(coupling, mu, R::from_f64(RADIUS)).expect("valid");
    Box::new(move |load, twist| {
        let wrench = of.wrench(load, twist);
        with(wrench, (wrench, of.wrench_jacobian(load, twist)))
    })
}

/// Radius of round patches, no power of two.
const RADIUS: f64 = 0.04;

fn leaning<R: Real>(
    outline: &Outline,
    slope: [f64; 2],
) -> Polygon<R, Vec<Edge<R>>, LinearPressure<R>> {
    let leaning = outline.patch::<R>().with_slope(slope.map(R::from_f64));
    leaning.expect("a pressure that is nowhere negative")
}

fn list<R: Real>(nodes: &[[f64; 3]]) -> NodeList<R, 32> {
    let mut list = NodeList::new();
    for node in nodes {
        let [x, y, weight] = node.map(R::from_f64);
        list.push(Node { x, y, weight }).expect("room");
    }
    list
}

impl Shape {
    /// Its friction under a law; `None` where the kernel has no such coupling.
    pub fn friction<R: RoundTabulated + 'static>(
        &self,
        law: PlaneLaw,
        coefficient: f64,
    ) -> Option<AtTwist<R>> {
        use PlaneLaw::{Dry, Power};
        let mu = R::from_f64(coefficient);
        Some(match (self, law) {
            (Self::Outline(outline, None), Dry) => dry(outline.patch::<R>(), mu),
            (Self::Outline(outline, Some(slope)), Dry) => dry(leaning(outline, *slope), mu),
            (Self::Outline(outline, None), Power(alpha)) => power(outline.patch::<R>(), mu, alpha),
            (Self::Outline(outline, Some(slope)), Power(alpha)) => {
                power(leaning(outline, *slope), mu, alpha)
            }
            (Self::Faces(faces), Dry) => dry(faces.patch::<R>(), mu),
            (Self::Bar(ends), Dry) => {
                let [from, to] = ends.map(|end| end.map(R::from_f64));
                dry(Bar::new(from, to).expect("valid"), mu)
            }
            (Self::Points(nodes), Dry) => dry(PointPatch::new(list(nodes)).expect("valid"), mu),
            (Self::Nodes(nodes), Dry) => at_nodes(CoulombLaw::new(mu).expect("valid"), list(nodes)),
            (Self::Nodes(nodes), Power(alpha)) => {
                let law = PowerLaw::new(R::from_f64(alpha), mu).expect("valid");
                at_nodes(law, list(nodes))
            }
            (Self::Round { order, tier }, law) => {
                let tiers = patches::tiers::<R>(*order, law.alpha());
                let (_, tier) = tiers.into_iter().find(|(name, _)| name == tier)?;
                round(tier, mu)
            }
            (Self::Faces(_) | Self::Bar(_) | Self::Points(_), Power(_)) => return None,
        })
    }

    /// Places with weights under which sums of polynomials of third degree are their means.
    fn samples(&self) -> Vec<[f64; 3]> {
        match self {
            Self::Outline(outline, slope) => {
                let loops = outline.loops.iter().enumerate();
                let uniform: Vec<_> = loops.flat_map(|(n, corners)| fan(corners, n > 0)).collect();
                let [x, y, ..] = means(&uniform);
                let [along_x, along_y] = slope.unwrap_or_default();
                let lean = |[a, b, weight]: [f64; 3]| {
                    let pressure = 1.0 + along_x * (a - x) + along_y * (b - y);
                    [a, b, weight * pressure]
                };
                uniform.into_iter().map(lean).collect()
            }
            Self::Faces(faces) => {
                // Triangles may be listed in either sense.
                let samples = |corners| cubic(corners, area(corners).abs());
                faces.triangles.iter().flat_map(samples).collect()
            }
            Self::Bar([[ax, ay], [bx, by]]) => vec![
                [*ax, *ay, 1.0],
                [0.5 * (ax + bx), 0.5 * (ay + by), 4.0],
                [*bx, *by, 1.0],
            ],
            Self::Nodes(nodes) | Self::Points(nodes) => nodes.clone(),
            Self::Round { .. } => Vec::new(),
        }
    }

    /// Means of x, y, x², xy and y² under the pressure.
    pub fn moments(&self) -> [f64; 5] {
        match self {
            Self::Round { order, .. } => {
                let square = 0.5 * RADIUS * RADIUS / (order + 2.0);
                [0.0, 0.0, square, 0.0, square]
            }
            _ => means(&self.samples()),
        }
    }

    /// The centre of pressure.
    pub fn centre(&self) -> Vector2<f64> {
        let [x, y, ..] = self.moments();
        Vector2::new(x, y)
    }

    /// Straight lines across which friction is not smooth where they hold the centre of rotation.
    fn sides(&self) -> Vec<[[f64; 2]; 2]> {
        let around = |corners: &Vec<[f64; 2]>| {
            let next = corners.iter().cycle().skip(1);
            corners
                .iter()
                .zip(next)
                .map(|(a, b)| [*a, *b])
                .collect::<Vec<_>>()
        };
        match self {
            Self::Outline(outline, _) => outline.loops.iter().flat_map(around).collect(),
            Self::Faces(faces) => {
                let flat =
                    |corners: &[[f64; 3]; 3]| around(&corners.map(|[x, y, _]| [x, y]).to_vec());
                faces.triangles.iter().flat_map(flat).collect()
            }
            Self::Bar(ends) => vec![*ends],
            Self::Nodes(nodes) | Self::Points(nodes) => {
                nodes.iter().map(|&[x, y, _]| [[x, y]; 2]).collect()
            }
            Self::Round { .. } => Vec::new(),
        }
    }

    /// Distance of the farthest place from the centre of pressure.
    pub fn radius(&self) -> f64 {
        let centre = self.centre();
        let far = |corner: &[f64; 2]| (Vector2::from(*corner) - centre).norm();
        let sides = self.sides();
        let radius = sides.as_flattened().iter().map(far).fold(0.0, f64::max);
        if radius == 0.0 { RADIUS } else { radius }
    }

    /// Distance of a centre of rotation from the nearest place where friction is not smooth, in radii.
    pub fn clearance(&self, pole: &Vector2<f64>) -> f64 {
        if let Self::Round { .. } = self {
            return (pole.norm() / RADIUS - 1.0).abs();
        }
        let away = |&[from, to]: &[[f64; 2]; 2]| {
            let (from, to) = (Vector2::from(from), Vector2::from(to));
            let along = to - from;
            let share = (pole - from).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE);
            (from + along * share.clamp(0.0, 1.0) - pole).norm()
        };
        let sides = self.sides();
        let least = sides.iter().map(away).fold(f64::INFINITY, f64::min);
        least / self.radius()
    }

    /// The patch in another frame; `None` for round patches, which lie at the origin, if that moves.
    pub fn moved(&self, frame: &Frame) -> Option<Self> {
        let place = |at: [f64; 2]| <[f64; 2]>::from(frame.turn * Vector2::from(at) + frame.shift);
        let valued = |[x, y, value]: [f64; 3]| {
            let [x, y] = place([x, y]);
            [x, y, value]
        };
        Some(match self.clone() {
            Self::Outline(mut outline, slope) => {
                outline
                    .loops
                    .as_mut_slice()
                    .iter_mut()
                    .flatten()
                    .for_each(|at| *at = place(*at));
                Self::Outline(
                    outline,
                    slope.map(|slope| (frame.turn * Vector2::from(slope)).into()),
                )
            }
            Self::Faces(mut faces) => {
                let corners = faces.triangles.as_flattened_mut();
                corners.iter_mut().for_each(|at| *at = valued(*at));
                Self::Faces(faces)
            }
            Self::Bar(ends) => Self::Bar(ends.map(place)),
            Self::Nodes(nodes) => Self::Nodes(nodes.into_iter().map(valued).collect()),
            Self::Points(nodes) => Self::Points(nodes.into_iter().map(valued).collect()),
            round @ Self::Round { .. } if frame.shift == Vector2::zeros() => round,
            Self::Round { .. } => return None,
        })
    }

    /// The same patch in more pieces; `None` where there are none.
    pub fn cut(&self) -> Option<Self> {
        let halves = |nodes: &[[f64; 3]]| {
            let half = |&[x, y, weight]: &[f64; 3]| [[x, y, 0.5 * weight]; 2];
            nodes.iter().flat_map(half).collect()
        };
        Some(match self {
            Self::Outline(outline, slope) => {
                let mut outline = outline.clone();
                for corners in &mut outline.loops {
                    *corners = divided(corners);
                }
                Self::Outline(outline, *slope)
            }
            Self::Faces(faces) => Self::Faces(Faces {
                name: faces.name.clone(),
                triangles: (0..3).fold(faces.triangles.clone(), |triangles, _| {
                    triangles.iter().flat_map(in_four).collect()
                }),
            }),
            Self::Nodes(nodes) => Self::Nodes(halves(nodes)),
            Self::Points(nodes) => Self::Points(halves(nodes)),
            Self::Bar(_) | Self::Round { .. } => return None,
        })
    }
}

fn halfway<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|part| 0.5 * (a[part] + b[part]))
}

/// Each side cut into two, until the loop has as many corners as a square with 32 pieces a side.
fn divided(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if corners.len() > 64 {
        return corners.to_vec();
    }
    let next = corners.iter().cycle().skip(1);
    let cut = |(&a, &b): (&[f64; 2], &[f64; 2])| [a, halfway(a, b)];
    divided(&corners.iter().zip(next).flat_map(cut).collect::<Vec<_>>())
}

/// Each triangle cut into four, its pressure linear in all of them.
fn in_four(&[a, b, c]: &[[f64; 3]; 3]) -> [[[f64; 3]; 3]; 4] {
    let (d, e, f) = (halfway(a, b), halfway(b, c), halfway(c, a));
    [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
}

/// Weights of corners, middles of sides and the centroid that are exact for cubic polynomials.
const CUBIC: [f64; 3] = [1.0 / 20.0, 2.0 / 15.0, 9.0 / 20.0];

/// Area of a triangle, negative if its corners go clockwise.
fn area([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
}

/// Samples of a triangle with the pressure as the third coordinate of its corners.
fn cubic(&[a, b, c]: &[[f64; 3]; 3], area: f64) -> Vec<[f64; 3]> {
    let centroid = [0, 1, 2].map(|part| (a[part] + b[part] + c[part]) / 3.0);
    let places = [
        a,
        b,
        c,
        halfway(a, b),
        halfway(b, c),
        halfway(c, a),
        centroid,
    ];
    let shares = [0, 0, 0, 1, 1, 1, 2].map(|kind| CUBIC[kind]);
    let sampled = places.iter().zip(shares);
    sampled
        .map(|([x, y, p], share)| [*x, *y, area * share * p])
        .collect()
}

/// Samples of a loop, taken away if it is a hole.
fn fan(corners: &[[f64; 2]], is_hole: bool) -> Vec<[f64; 3]> {
    let of = |[x, y]: [f64; 2]| [x, y, 1.0];
    let sides = corners.windows(2).skip(1);
    let triangles = sides.map(|side| [of(corners[0]), of(side[0]), of(side[1])]);
    let samples: Vec<_> = triangles
        .flat_map(|corners| cubic(&corners, area(&corners)))
        .collect();
    let whole: f64 = samples.iter().map(|sample| sample[2]).sum();
    let sign = whole.signum() * if is_hole { -1.0 } else { 1.0 };
    samples
        .into_iter()
        .map(|[x, y, weight]| [x, y, sign * weight])
        .collect()
}

fn means(samples: &[[f64; 3]]) -> [f64; 5] {
    let sum = |of: fn(f64, f64) -> f64| -> f64 {
        samples
            .iter()
            .map(|&[x, y, weight]| weight * of(x, y))
            .sum()
    };
    let total = sum(|_, _| 1.0);
    let parts = [
        sum(|x, _| x),
        sum(|_, y| y),
        sum(|x, _| x * x),
        sum(|x, y| x * y),
        sum(|_, y| y * y),
    ];
    parts.map(|part| part / total)
}

/// Coordinates x ↦ turn · x + shift, with an orthogonal `turn` that may be a reflection.
pub struct Frame {
    pub turn: Matrix2<f64>,
    pub shift: Vector2<f64>,
}

impl Frame {
    /// What makes a wrench of the old frame one of the new; its transpose makes the new twist the old.
    pub fn of_wrenches(&self) -> Matrix3<f64> {
        let (turn, [x, y]) = (self.turn, <[f64; 2]>::from(self.shift));
        let lever = |column: usize| x * turn[(1, column)] - y * turn[(0, column)];
        Matrix3::new(
            turn.m11,
            turn.m12,
            0.0,
            turn.m21,
            turn.m22,
            0.0,
            lever(0),
            lever(1),
            turn.determinant(),
        )
    }
}
