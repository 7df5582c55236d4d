//! Exact dry friction of meshes: against line integrals of 150 digits, polygons, and refinement.

use crate::polygon_friction::{Errors, anyhow, errors, of_twist, twist_of};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::patch::mesh::{Mesh, MeshError, Triangle, Vertex};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::meshes::{Faces, meshes};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// Needles, and triangles that are much smaller than their mesh but carry a good part of its load.
fn is_uneven(faces: &Faces) -> bool {
    ["graded", "needles", "spike"].contains(&faces.name.as_str())
}

#[test]
fn the_wrench_and_the_jacobian_are_those_of_150_digits() {
    let table = Table::read("meshes.csv");
    let mut worst = [
        ("mesh, wrench", tolerance::MESH),
        ("mesh, Jacobian", tolerance::MESH_JACOBIAN),
        ("uneven mesh, wrench", tolerance::MESH_UNEVEN),
        ("uneven mesh, Jacobian", tolerance::MESH_UNEVEN_JACOBIAN),
    ]
    .map(|(name, bound)| (Worst::of(name), bound));
    for faces in meshes() {
        let first = if is_uneven(&faces) { 2 } else { 0 };
        let patch = faces.patch::<f64>();
        let friction = ShapeFriction::new(&patch, 1.0).expect("valid");
        let name = &faces.name;
        let rows = table.rows().filter(|row| row.text("mesh") == name);
        for (number, row) in rows.enumerate() {
            let twist = twist_of::<f64>(&row);
            let found = friction.wrench_and_jacobian(1.0, &twist);
            let Errors { wrench, jacobian } = errors(&row, &patch, found);
            let place = || format!("{name}, row {number}, {twist:?}");
            worst[first].0.see(wrench, place);
            worst[first + 1].0.see(jacobian, place);
        }
    }
    for (worst, bound) in &worst {
        worst.assert_within(bound);
    }
}

#[test]
fn the_jacobian_is_symmetric_without_power_along_the_twist_and_takes_power_elsewhere() {
    let mut rng = Lcg::new(11);
    for faces in meshes() {
        let (patch, name) = (faces.patch::<f64>(), &faces.name);
        let arm = patch.radius() + patch.centre().norm();
        let friction = ShapeFriction::new(&patch, 0.7).expect("valid");
        for _ in 0..200 {
            let twist = anyhow(&mut rng, &patch);
            let (wrench, jacobian) = friction.wrench_and_jacobian(3.0, &twist);
            assert_eq!(wrench, friction.wrench(3.0, &twist), "{name}");
            assert!(wrench.power(&twist) < 0.0);
            let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / arm));
            let even = unit * jacobian * unit;
            let size = even.amax();
            assert_eq!(even, even.transpose());
            let at = of_twist(&twist, arm);
            assert!(
                (even * at).amax() < 1e-11 * size * at.amax(),
                "{name} {twist:?}"
            );
            let most = SymmetricEigen::new(even).eigenvalues.max();
            assert!(most < 1e-11 * size, "{name} {most} of {size}");
        }
    }
}

#[test]
fn single_precision_follows_double_precision() {
    let mut wrenches = Worst::of("f32, mesh, wrench");
    let mut jacobians = Worst::of("f32, mesh, Jacobian");
    let mut rng = Lcg::new(12);
    for faces in meshes().iter().filter(|faces| !is_uneven(faces)) {
        let (single, double) = (faces.patch::<f32>(), faces.patch::<f64>());
        let arm = double.radius() + double.centre().norm();
        let of_single = ShapeFriction::new(&single, 1.0).expect("valid");
        let of_double = ShapeFriction::new(&double, 1.0).expect("valid");
        for _ in 0..500 {
            let twist = anyhow(&mut rng, &double);
            let [x, y, spin] =
                [twist.velocity.x, twist.velocity.y, twist.spin].map(|part| part as f32);
            let (wrench, jacobian) = of_single.wrench_and_jacobian(1.0, &Twist::new(x, y, spin));
            let twist = Twist::new(f64::from(x), f64::from(y), f64::from(spin));
            let (expected, expected_jacobian) = of_double.wrench_and_jacobian(1.0, &twist);
            let error = (f64::from(wrench.force.x) - expected.force.x)
                .abs()
                .max((f64::from(wrench.force.y) - expected.force.y).abs())
                .max((f64::from(wrench.torque) - expected.torque).abs() / arm);
            wrenches.see(error, || format!("{}, {twist:?}", faces.name));
            let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / arm));
            let expected = unit * expected_jacobian * unit;
            let error = (unit * jacobian.map(f64::from) * unit - expected).amax() / expected.amax();
            jacobians.see(error, || format!("{}, {twist:?}", faces.name));
        }
    }
    wrenches.assert_within(&tolerance::MESH_SINGLE);
    jacobians.assert_within(&tolerance::MESH_SINGLE_JACOBIAN);
}

/// Largest difference of two wrenches and Jacobians, the latter over its largest entry.
fn differences(
    one: &ShapeFriction<f64, impl PatchShape<f64>>,
    other: &ShapeFriction<f64, impl PatchShape<f64>>,
    twist: &Twist<f64>,
) -> [f64; 2] {
    let ((a, j), (b, k)) = (
        one.wrench_and_jacobian(1.0, twist),
        other.wrench_and_jacobian(1.0, twist),
    );
    let arm = one.patch().radius() + one.patch().centre().norm();
    let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / arm));
    let (j, k) = (unit * j * unit, unit * k * unit);
    let wrench = (a.force - b.force)
        .norm()
        .max((a.torque - b.torque).abs() / arm);
    [wrench, (j - k).amax() / k.amax()]
}

/// Each triangle cut into four, its pressure linear in all of them.
fn refined(faces: &Faces) -> Faces {
    let half = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|part| 0.5 * (a[part] + b[part]));
    let cut = |&[a, b, c]: &[[f64; 3]; 3]| {
        let (d, e, f) = (half(a, b), half(b, c), half(c, a));
        [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
    };
    Faces {
        name: faces.name.clone(),
        triangles: faces.triangles.iter().flat_map(cut).collect(),
    }
}

#[test]
fn an_ell_cut_into_triangles_is_the_ell() {
    let corners = [
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ];
    let ell = Polygon::with_holes(&[&corners], vec![Edge::default(); 6]).expect("valid");
    let ell = ell.with_slope([0.25, -0.375]).expect("carried");
    let centroid = 5.0 / 6.0;
    let corner = |n: usize| {
        let [x, y]: [f64; 2] = corners[n];
        [x, y, 1.0 + 0.25 * (x - centroid) - 0.375 * (y - centroid)]
    };
    let mut faces = Faces {
        name: "ell".to_owned(),
        triangles: [[0, 1, 2], [0, 2, 3], [3, 4, 0], [0, 4, 5]]
            .map(|named| named.map(corner))
            .to_vec(),
    };
    let exact = ShapeFriction::new(&ell, 1.0).expect("valid");
    let mut rng = Lcg::new(13);
    for _ in 0..4 {
        let patch = faces.patch::<f64>();
        assert!((patch.centre() - ell.centre()).norm() < 1e-15);
        assert!((patch.load() - 3.0).abs() < 1e-14);
        let mesh = ShapeFriction::new(&patch, 1.0).expect("valid");
        for _ in 0..300 {
            let twist = anyhow(&mut rng, &patch);
            let [wrench, jacobian] = differences(&mesh, &exact, &twist);
            assert!(wrench < 5e-14, "{wrench:e} {twist:?}");
            assert!(jacobian < 5e-13, "{jacobian:e} {twist:?}");
        }
        faces = refined(&faces);
    }
}

#[test]
fn cutting_every_triangle_into_four_changes_nothing() {
    let mut rng = Lcg::new(14);
    for faces in meshes() {
        let (coarse, fine) = (faces.patch::<f64>(), refined(&faces).patch::<f64>());
        let coarse = ShapeFriction::new(&coarse, 1.0).expect("valid");
        let fine = ShapeFriction::new(&fine, 1.0).expect("valid");
        let (mut wrench, mut jacobian) = (0.0_f64, 0.0_f64);
        for _ in 0..100 {
            let twist = anyhow(&mut rng, coarse.patch());
            let [w, j] = differences(&coarse, &fine, &twist);
            (wrench, jacobian) = (wrench.max(w), jacobian.max(j));
        }
        let [most, most_jacobian] = if is_uneven(&faces) {
            [tolerance::MESH_UNEVEN, tolerance::MESH_UNEVEN_JACOBIAN]
        } else {
            [tolerance::MESH, tolerance::MESH_JACOBIAN]
        };
        // Both may be wrong by as much.
        let fine = wrench < 2.0 * most.limit && jacobian < 2.0 * most_jacobian.limit;
        assert!(fine, "{}: {wrench:e} {jacobian:e}", faces.name);
    }
}

#[test]
fn a_small_torque_keeps_its_digits_and_rest_is_rest() {
    let vertex = |x: f64, y: f64| Vertex {
        x,
        y,
        pressure: 2.0,
    };
    let [a, b, c, d] = [
        vertex(-1.0, -1.0),
        vertex(1.0, -1.0),
        vertex(1.0, 1.0),
        vertex(-1.0, 1.0),
    ];
    let friction = ShapeFriction::new(Mesh::new([[a, b, c], [a, c, d]]).expect("valid"), 1.0);
    let friction = friction.expect("valid");
    for spin in [1e-300, 1e-200, 1e-30, 1e-9] {
        let torque = friction.wrench(1.0, &Twist::new(0.6, 0.8, spin)).torque;
        assert!((torque / spin + 1.0 / 3.0).abs() < 2e-15, "{spin} {torque}");
    }
    assert_eq!(friction.wrench(1.0, &Twist::ZERO), Wrench::ZERO);
    let nan = friction.wrench(1.0, &Twist::new(f64::NAN, 0.0, 1.0));
    assert!(nan.force.x.is_nan() && nan.torque.is_nan());
}

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
