//! Meshes: what carries nothing, and what is no mesh.

use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::patch::mesh::{Mesh, MeshError, Triangle, Vertex};
use tribos_core::twist::Twist;

#[test]
fn what_carries_nothing_is_left_out_and_what_is_no_mesh_is_refused() {
    let vertex = |x: f64, y: f64, pressure: f64| Vertex { x, y, pressure };
    let (a, b, c) = (
        vertex(0.0, 0.0, 1.0),
        vertex(1.0, 0.0, 1.0),
        vertex(0.0, 1.0, 4.0),
    );
    let far = vertex(900.0, 0.0, 0.0);
    let free = vertex(1.0, 1.0, 0.0);
    let lone = Mesh::new([[a, b, c]]).expect("valid");
    // Half a square metre under a mean pressure of 2.
    assert!((lone.load() - 1.0).abs() < 1e-15);
    // A line, a triangle without pressure, and the other way round.
    let flat = vertex(0.5, 0.0, 1.0);
    for mesh in [
        Mesh::new([
            [a, flat, b],
            [far, vertex(901.0, 0.0, 0.0), free],
            [c, b, a],
        ]),
        Mesh::new([[a, c, b], [a, a, b], [b, b, b]]),
    ] {
        let mesh = mesh.expect("valid");
        assert!((mesh.centre() - lone.centre()).norm() < 1e-15 && mesh.load() == lone.load());
        assert!((mesh.radius() - lone.radius()).abs() < 1e-15);
        let twist = Twist::new(0.25, 0.5, -2.0);
        let [one, other] = [
            ShapeFriction::new(&lone as &dyn PatchShape<f64>, 1.0),
            ShapeFriction::new(&mesh as &dyn PatchShape<f64>, 1.0),
        ]
        .map(|friction| friction.expect("valid").wrench(1.0, &twist));
        let rest = one - other;
        assert!(rest.force.norm() < 1e-15 && rest.torque.abs() < 1e-15);
    }
    let refusal = |triangle| Mesh::<f64, _>::new([[a, b, c], triangle]).err();
    let bad = |corner, given| {
        Some(MeshError::Pressure {
            triangle: 1,
            corner,
            given,
        })
    };
    assert_eq!(refusal([a, b, vertex(0.0, 1.0, -0.5)]), bad(2, -0.5));
    assert_eq!(
        refusal([a, vertex(0.0, 1.0, f64::INFINITY), b]),
        bad(1, f64::INFINITY)
    );
    let away = refusal([vertex(f64::NAN, 0.0, 1.0), a, b]);
    assert_eq!(
        away,
        Some(MeshError::Position {
            triangle: 1,
            corner: 0
        })
    );
    let wide = refusal([vertex(-1e308, 0.0, 1.0), vertex(1e308, 0.0, 1.0), a]);
    assert_eq!(wide, Some(MeshError::Extent));
    let wide = refusal([vertex(-1.7e308, 0.0, 1.0), vertex(1.7e308, 1e308, 1.0), a]);
    assert_eq!(wide, Some(MeshError::Extent));
    // Seen from a line that carries nothing, 10²⁰ away, the triangle has no extent.
    let line = [
        vertex(1e20, 0.0, 1.0),
        vertex(2e20, 0.0, 1.0),
        vertex(3e20, 0.0, 1.0),
    ];
    let lost = Mesh::new([line, [a, b, c]]).err();
    assert_eq!(lost, Some(MeshError::Unloaded));
    let none = Mesh::<f64, [Triangle<f64>; 0]>::new([]).err();
    assert_eq!(none, Some(MeshError::Empty));
    let unloaded = Mesh::new([[
        vertex(0.0, 0.0, 0.0),
        vertex(1.0, 0.0, 0.0),
        vertex(0.0, 1.0, 0.0),
    ]]);
    assert_eq!(unloaded.err(), Some(MeshError::Unloaded));
    assert_eq!(Mesh::new([[a, flat, b]]).err(), Some(MeshError::Unloaded));
    let vertices = [a, b, c];
    let of = |named: &[[usize; 3]]| Mesh::with_vertices(&vertices, named, [Triangle::default(); 1]);
    let index = MeshError::Index {
        triangle: 0,
        vertex: 7,
        vertices: 3,
    };
    assert_eq!(of(&[[0, 7, 1]]).err(), Some(index));
    let room = MeshError::Room { given: 2, room: 1 };
    assert_eq!(of(&[[0, 1, 2], [0, 2, 1]]).err(), Some(room));
    assert!(of(&[[0, 1, 2]]).is_ok());
}
