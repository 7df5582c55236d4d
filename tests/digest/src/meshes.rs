//! Bits of meshes, points and bodies on several feet: friction, limit surfaces, refusals.

use crate::hash::{Fnv, in_both};
use crate::inputs::pairs_of_ends;
use crate::polygons::{friction, surface};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::feet::{CompoundPatch, PatchPart};
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::patch::points::PointPatch;
use tribos_core::real::Real;

/// Digest of meshes, points and feet, f64 and f32.
pub fn meshes() -> u64 {
    in_both(meshes_of::<f64>, meshes_of::<f32>)
}

/// Places and pressures of a strip that narrows.
const VERTICES: [[f64; 3]; 8] = [
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 2.5],
    [1.0, 0.125, 0.5],
    [1.0, 0.875, 0.0],
    [1.5, 0.25, 3.0],
    [1.5, 0.75, 4.0],
    [1.625, 0.4375, 64.0],
    [1.625, 0.5, 32.0],
];

fn meshes_of<R: Real>(hash: &mut Fnv) {
    let vertices = VERTICES.map(|vertex| {
        let [x, y, pressure] = vertex.map(R::from_f64);
        Vertex { x, y, pressure }
    });
    let strip = [
        [0, 2, 1],
        [1, 2, 3],
        [2, 4, 3],
        [5, 3, 4],
        [4, 6, 5],
        [5, 6, 7],
    ];
    let mesh = Mesh::with_vertices(&vertices, &strip, [Triangle::default(); 6]).expect("a mesh");
    hash.numbers([mesh.centre().x, mesh.centre().y, mesh.radius(), mesh.load()]);
    friction(hash, mesh);
    surface(hash, mesh);
    let node = |[x, y, weight]: [f64; 3]| {
        let [x, y, weight] = [x, y, weight].map(R::from_f64);
        Node { x, y, weight }
    };
    let nodes = Nodes::new([[-0.5, 0.25, 1.0], [0.75, 0.25, 2.0], [0.25, -0.5, 0.5]].map(node));
    let points = PointPatch::new(nodes.expect("nodes")).expect("several places");
    friction(hash, points);
    surface(hash, points);
    let blade = |y: f64| {
        let [x, y] = [0.5, y].map(R::from_f64);
        Bar::new([-x, y], [x, y]).expect("a bar")
    };
    let runners = [(-0.25, 1.0), (0.5, 2.0)].map(|(y, weight)| PatchPart {
        patch: blade(y),
        load: R::from_f64(weight),
    });
    let feet = CompoundPatch::new(&runners).expect("loaded");
    hash.numbers([feet.centre().x, feet.centre().y, feet.radius()]);
    friction(hash, feet);
    surface(hash, feet);
    for (x, y) in pairs_of_ends::<R>().step_by(3) {
        let [a, b, _, c, ..] = vertices;
        let odd = Vertex { x, ..a };
        let pressed = Vertex { pressure: y, ..a };
        hash.verdict(&Mesh::new([[odd, b, c]]));
        hash.verdict(&Mesh::new([[a, b, c], [pressed, b, c]]));
        let place = Node {
            x,
            y,
            weight: R::ONE,
        };
        hash.verdict(&Nodes::new([place, node([0.0, 0.0, 1.0])]).and_then(PointPatch::new));
        let [near, far] = runners;
        hash.verdict(&CompoundPatch::new(&[
            PatchPart { load: x, ..near },
            PatchPart { load: y, ..far },
        ]));
    }
    hash.verdict(&Mesh::with_vertices(
        &vertices,
        &[[0, 1, 8]],
        [Triangle::default()],
    ));
    hash.verdict(&Mesh::with_vertices(
        &vertices,
        &strip,
        [Triangle::default()],
    ));
}
