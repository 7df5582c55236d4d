//! Exact friction of polygons and of meshes, near the centre of rotation and far from it, beside the disk's form
//! and 504 nodes on the same square.

mod settings;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribos_core::coupling::flat::{PatchShape, PolygonPowerLaw, ShapeFriction, ShapePowerFriction};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{RoundFriction, WornAnnulus, coulomb};
use tribos_core::floor::{Feet, Foot};
use tribos_core::law::CoulombLaw;
use tribos_core::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use tribos_core::patch::arcs::{ArcOutline, Side};
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::NodeList;
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::patch::piece::HalfPlane;
use tribos_core::twist::{Twist, Wrench};

/// Largest difference between 504 nodes and the square they stand for, of the load.
const CHECK: f64 = 1e-2;
const TWISTS: usize = 1000;

const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
const TRIANGLE: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]];
const ELL: [[f64; 2]; 6] = [
    [-1.0, -1.0],
    [1.0, -1.0],
    [1.0, -0.5],
    [-0.5, -0.5],
    [-0.5, 1.0],
    [-1.0, 1.0],
];
const OCTAGON: [[f64; 2]; 8] = [
    [1.0, -0.4],
    [1.0, 0.4],
    [0.4, 1.0],
    [-0.4, 1.0],
    [-1.0, 0.4],
    [-1.0, -0.4],
    [-0.4, -1.0],
    [0.4, -1.0],
];

/// Spins of 1 about centres that are `least` to `most` away from the origin, in every direction.
fn about([least, most]: [f64; 2]) -> Vec<Twist<f64>> {
    let turn = |i: usize| {
        let part = i as f64 / TWISTS as f64;
        let (distance, angle) = (least + (most - least) * part, 2.4 * i as f64);
        Twist::new(distance * angle.sin(), -distance * angle.cos(), 1.0)
    };
    (0..TWISTS).map(turn).collect()
}

/// Times `friction` over twists with a centre of rotation on the patch or next to it, and far away.
fn time<T: Copy>(criterion: &mut Criterion, name: &str, friction: impl Fn(&Twist<f64>) -> T) {
    for (place, distances) in [("near", [0.0, 2.5]), ("far", [5.0, 50.0])] {
        let twists = about(distances);
        let mut results: Vec<T> = twists.iter().map(&friction).collect();
        let mut group = criterion.benchmark_group("polygons");
        group.throughput(Throughput::Elements(twists.len() as u64));
        group.bench_function(BenchmarkId::new(name, place), |bencher| {
            bencher.iter(|| {
                for (twist, result) in black_box(&twists).iter().zip(&mut results) {
                    *result = friction(twist);
                }
                black_box(&mut results);
            });
        });
        group.finish();
    }
}

/// A patch under friction with μ = 1.
fn dry<P: PatchShape<f64>>(patch: P) -> ShapeFriction<f64, P> {
    ShapeFriction::new(patch, 1.0).expect("1 is a valid coefficient")
}

/// The square as a grid of `cells` × `cells` squares, each of two triangles, under a pressure that bends.
fn face(cells: u32) -> Mesh<f64, Vec<Triangle<f64>>> {
    let place = |n: u32| 2.0 * f64::from(n) / f64::from(cells) - 1.0;
    let vertices: Vec<Vertex<f64>> = (0..=cells)
        .flat_map(|i| (0..=cells).map(move |j| [place(i), place(j)]))
        .map(|[x, y]| Vertex {
            x,
            y,
            pressure: 2.0 + x * y,
        })
        .collect();
    let vertex = |i: u32, j: u32| (i * (cells + 1) + j) as usize;
    let squares = (0..cells).flat_map(|i| (0..cells).map(move |j| [i, j]));
    let triangles: Vec<[usize; 3]> = squares
        .flat_map(|[i, j]| {
            let (a, b) = (vertex(i, j), vertex(i + 1, j));
            let (c, d) = (vertex(i + 1, j + 1), vertex(i, j + 1));
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let memory = vec![Triangle::default(); triangles.len()];
    Mesh::with_vertices(&vertices, &triangles, memory).expect("a mesh")
}

fn polygons(criterion: &mut Criterion) {
    let square = dry(Polygon::new(SQUARE).expect("a square"));
    let triangle = dry(Polygon::new(TRIANGLE).expect("a triangle"));
    let ell = dry(Polygon::new(ELL).expect("an L"));
    let octagon = dry(Polygon::new(OCTAGON).expect("an octagon"));
    let disk =
        RoundFriction::new(coulomb::CoulombDisk, 1.0, 1.0).expect("1 is a valid coefficient");
    let nodes: NodeList<f64, 504> = NodeList::polygon(&SQUARE, 6).expect("room for all nodes");
    let law = CoulombLaw::new(1.0).expect("1 is a valid coefficient");
    let nodes = NodeFriction::new(law, nodes);
    let twist = Twist::new(0.3, 0.4, 0.7);
    let (exact, found) = (square.wrench(1.0, &twist), nodes.wrench(1.0, &twist));
    assert!((found.force - exact.force).norm() < CHECK, "force");
    assert!((found.torque - exact.torque).abs() < CHECK, "torque");

    time(criterion, "disk", |t| disk.wrench(1.0, t));
    time(criterion, "square", |t| square.wrench(1.0, t));
    time(criterion, "triangle", |t| triangle.wrench(1.0, t));
    time(criterion, "L", |t| ell.wrench(1.0, t));
    time(criterion, "octagon", |t| octagon.wrench(1.0, t));
    time(criterion, "square, Jacobian", |t| {
        square.wrench_and_jacobian(1.0, t)
    });
    for alpha in [0.0625, 0.5, 3.0] {
        let power = PolygonPowerLaw::new(alpha).expect("in range");
        let patch = Polygon::new(SQUARE).expect("a square");
        let friction = ShapePowerFriction::new(patch, 1.0, power).expect("in range");
        let name = format!("square, power {alpha}");
        time(criterion, &name, |t| friction.wrench(1.0, t));
        let name = format!("{name}, Jacobian");
        time(criterion, &name, |t| friction.wrench_and_jacobian(1.0, t));
    }
    for cells in [4, 16] {
        let mesh = dry(face(cells));
        let name = format!("mesh of {} triangles", 2 * cells * cells);
        time(criterion, &name, |t| mesh.wrench(1.0, t));
        let name = format!("{name}, Jacobian");
        time(criterion, &name, |t| mesh.wrench_and_jacobian(1.0, t));
    }
    time(criterion, "square of 504 nodes", |t| nodes.wrench(1.0, t));
    curved(criterion);
    floors(criterion);
}

/// Ellipses, a worn annulus, half a disk.
fn curved(criterion: &mut Criterion) {
    for (name, pressure) in [
        ("ellipse 3:2", EllipsePressure::Uniform),
        ("ellipse 3:2, Hertz", EllipsePressure::Hertz),
    ] {
        let ellipse = dry(Ellipse::new([0.0; 2], [1.0, 2.0 / 3.0], pressure).expect("an ellipse"));
        time(criterion, name, |t| ellipse.wrench(1.0, t));
        let name = format!("{name}, Jacobian");
        time(criterion, &name, |t| ellipse.wrench_and_jacobian(1.0, t));
    }
    let worn = WornAnnulus::new(0.6).expect("in range");
    let worn = RoundFriction::new(worn, 1.0, 1.0).expect("1 is a valid coefficient");
    time(criterion, "worn annulus 0.6", |t| worn.wrench(1.0, t));
    let disk = Ellipse::new([0.0; 2], [1.0; 2], EllipsePressure::Uniform).expect("a disk");
    let left = [[-2.0, -2.0], [0.0, -2.0], [0.0, 2.0], [-2.0, 2.0]];
    let half = ArcOutline::cut(&disk, &left, [Side::default(); 11]).expect("half a disk");
    let half = dry(half);
    time(criterion, "half a disk", |t| half.wrench(1.0, t));
}

/// A square under two coefficients, and on two belts.
fn floors(criterion: &mut Criterion) {
    let square = Polygon::new(SQUARE).expect("a square");
    let tread = AxisCoefficients::new([0.5, 1.0], [1.0, 0.0]).expect("two coefficients");
    let tread = dry(AnisotropicPatch::new(square, tread).expect("a square"));
    time(criterion, "square, two coefficients", |t| {
        tread.wrench(1.0, t)
    });
    let seam = HalfPlane::new([0.0; 2], [1.0, 0.1]).expect("a border");
    let halves = [(seam, 0.5), (seam.other_side(), -0.5)].map(|(side, speed)| {
        let piece = square.within(&side, [Edge::default(); 8]);
        let piece = piece.expect("room for its edges").expect("half of it");
        Foot {
            patch: piece.patch,
            limit: piece.share,
            surface: Twist::new(speed, 0.0, 0.0),
        }
    });
    let belts = Feet::new(&halves).expect("two feet");
    time(criterion, "square on two belts", |t| belts.wrench(t));
    let push = |t: &Twist<f64>| Wrench::new(0.1 * t.velocity.x, 0.1 * t.velocity.y, 0.01);
    time(criterion, "square on two belts, steady motion", |t| {
        belts.steady_motion(&push(t))
    });
}

criterion_group! {
    name = benches;
    config = settings::criterion();
    targets = polygons
}
criterion_main!(benches);
