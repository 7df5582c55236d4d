//! The tip on its substrate is a piece of one crystal, whatever its size and outline.

use nalgebra::Vector3;
use std::collections::HashMap;
use tribos::scene::TipScene;
use tribos::tip::{AtomRole, Shape, Site, TipOutline};
use tribos_tests::tips::scene;

type Error = Box<dyn std::error::Error>;

/// Roundings of places of some tens of spacings, relative to the spacing.
const ROUNDING: f64 = 1e-12;

/// A tip at rest with some more lines.
fn tip(text: &str) -> Result<TipScene, Error> {
    scene(&format!("body = \"tip\"\nlambda = 0\n{text}"))
}

/// Shapes of several sizes and outlines, in registry.
fn shapes() -> Result<Vec<Shape>, Error> {
    let mut shapes = vec![tip("")?.shape()];
    for [columns, rows, below, above, side] in [
        [12, 14, 4, 4, 3],
        [13, 16, 5, 7, 4],
        [17, 18, 6, 5, 5],
        [11, 12, 7, 4, 1],
        [21, 24, 4, 8, 7],
    ] {
        for outline in ["hexagon", "disk", "cone"] {
            let text = format!(
                "substrate_columns = {columns}\nsubstrate_rows = {rows}\nsubstrate_layers = {below}\n\
                 tip_layers = {above}\ntip_side_atoms = {side}\noutline = \"{outline}\"\nspacing = 1.1"
            );
            shapes.push(tip(&text)?.shape());
        }
    }
    Ok(shapes)
}

/// Atoms of the tip's layer: sites with their outline's reach, from the lowest layer of all.
fn reach(shape: &Shape, layer: usize) -> f64 {
    let lost = match shape.outline {
        TipOutline::Cone => (shape.layers() - 1 - layer).min(shape.side - 1),
        _ => 0,
    };
    (shape.side - 1 - lost) as f64 * shape.spacing
}

/// Whether a place in a layer, from its middle, is within the outline of a reach.
fn is_within(outline: TipOutline, reach: f64, way: &Vector3<f64>, rounding: f64) -> bool {
    if outline == TipOutline::Disk {
        return way.norm() <= reach + rounding;
    }
    // Three pairs of sides, at a distance of √3/2 of the corners'.
    [30.0_f64, 90.0, 150.0].into_iter().all(|angle| {
        let normal = Vector3::new(angle.to_radians().cos(), angle.to_radians().sin(), 0.0);
        normal.dot(way).abs() <= reach * 0.75_f64.sqrt() + rounding
    })
}

/// All points n₁a₁ + n₂a₂ + n₃a₃ of the face-centred cubic lattice in the box and in the tip.
fn lattice(shape: &Shape) -> Vec<Vector3<f64>> {
    let d = shape.spacing;
    let a1 = Vector3::new(d, 0.0, 0.0);
    let a2 = Vector3::new(0.5 * d, 0.75_f64.sqrt() * d, 0.0);
    let a3 = Vector3::new(0.0, d / 3.0_f64.sqrt(), (2.0_f64 / 3.0).sqrt() * d);
    let [x, y] = shape.periods();
    let [x0, y0] = shape.axis();
    let rounding = 1e-9 * d;
    let inside = |at: f64, period: f64| at > -rounding && at < period - rounding;
    let most = 2 * (shape.columns + shape.rows + shape.layers()) as i64;
    let mut points = Vec::new();
    for layer in 0..shape.layers() {
        // Each third layer stands above the first: the one between leads, the next one lags.
        let aside = [0.0, 1.0, -1.0][layer % 3] * d / 3.0_f64.sqrt();
        let middle = Vector3::new(x0, y0 + aside, layer as f64 * a3.z);
        for n1 in -most..=most {
            for n2 in -most..=most {
                let point = a1 * n1 as f64 + a2 * n2 as f64 + a3 * layer as f64;
                let is_in = if layer < shape.substrate_layers {
                    inside(point.x, x) && inside(point.y, y)
                } else {
                    let reach = reach(shape, layer);
                    is_within(shape.outline, reach, &(point - middle), rounding)
                };
                if is_in {
                    points.push(point);
                }
            }
        }
    }
    points
}

/// A place on a fine grid, whole periods taken away.
fn on_grid(shape: &Shape, place: &Vector3<f64>) -> [i64; 3] {
    const FINE: f64 = 1e6;
    let [x, y] = shape.periods();
    let cell = |x: f64| (x / shape.spacing * FINE).round() as i64;
    [
        cell(place.x).rem_euclid(cell(x)),
        cell(place.y).rem_euclid(cell(y)),
        cell(place.z),
    ]
}

/// Calls `see` with the distance of every pair, over the nearest images.
fn each_pair(shape: &Shape, sites: &[Site], mut see: impl FnMut(usize, usize, f64)) {
    let [x, y] = shape.periods();
    for (i, one) in sites.iter().enumerate() {
        for (j, other) in sites.iter().enumerate().skip(i + 1) {
            let way = other.place - one.place;
            if way.z.abs() < 1.5 * shape.spacing {
                let nearest = |way: f64, period: f64| way - period * (way / period).round();
                let flat = Vector3::new(nearest(way.x, x), nearest(way.y, y), way.z);
                see(i, j, flat.norm());
            }
        }
    }
}

#[test]
fn the_default_is_the_tip_of_the_thesis() -> Result<(), Error> {
    let shape = tip("")?.shape();
    let sites = shape.sites();
    assert_eq!(sites.len(), 6330);
    let parts = [
        AtomRole::Base,
        AtomRole::SubstrateBath,
        AtomRole::Surface,
        AtomRole::Apex,
        AtomRole::TipBath,
        AtomRole::Driven,
    ];
    for layer in 0..12 {
        let own: Vec<&Site> = sites.iter().filter(|site| site.layer == layer).collect();
        assert_eq!(own.len(), if layer < 6 { 784 } else { 271 }, "{layer}");
        assert!(own.iter().all(|site| site.part == parts[layer / 2]));
    }
    // Neighbours stand at the minimum of the potential, 2^(1/6).
    assert!((shape.spacing.powi(6) - 2.0).abs() < 1e-14);
    Ok(())
}

#[test]
fn all_atoms_are_on_one_lattice() -> Result<(), Error> {
    for shape in shapes()? {
        let sites = shape.sites();
        let grid: HashMap<[i64; 3], Vector3<f64>> = lattice(&shape)
            .into_iter()
            .map(|point| (on_grid(&shape, &point), point))
            .collect();
        assert_eq!(sites.len(), grid.len(), "{shape:?}");
        let [x, y] = shape.periods();
        for site in &sites {
            let point = grid.get(&on_grid(&shape, &site.place));
            let off = point.ok_or(format!("{site:?} is not of {shape:?}"))? - site.place;
            let off = [off.x % x, off.y % y, off.z].map(|off| off / shape.spacing);
            assert!(
                off.iter().all(|off| off.abs() < 100.0 * ROUNDING),
                "{off:?}"
            );
        }
        // Layers come from below, each of one part.
        assert!(sites.is_sorted_by_key(|site| site.layer));
        assert!(sites.iter().all(|site| site.part == shape.part(site.layer)));
    }
    Ok(())
}

#[test]
fn every_inner_atom_has_its_twelve_neighbours_and_no_two_are_nearer() -> Result<(), Error> {
    for shape in shapes()? {
        let (sites, d) = (shape.sites(), shape.spacing);
        let mut neighbours = vec![0; sites.len()];
        each_pair(&shape, &sites, |i, j, distance| {
            assert!(distance > d * (1.0 - ROUNDING), "{i} {j} {shape:?}");
            if distance < d * (1.0 + ROUNDING) {
                neighbours[i] += 1;
                neighbours[j] += 1;
            } else {
                assert!(distance > 1.4 * d, "{i} {j} {distance} {shape:?}");
            }
        });
        let [x0, y0] = shape.axis();
        let (top, surface) = (shape.layers() - 1, shape.substrate_layers - 1);
        for (site, &count) in sites.iter().zip(&neighbours) {
            let expected = match site.layer {
                0 => 9..=9,
                layer if layer < surface => 11..=12,
                // Three more under the tip.
                layer if layer == surface => 9..=12,
                layer if layer == top => 1..=9,
                layer => {
                    // Two spacings from the rim all neighbours in layers of the same size are there.
                    let way = Vector3::new(site.place.x - x0, site.place.y - y0, 0.0);
                    let inner = reach(&shape, layer) * 0.75_f64.sqrt() - 2.0 * d;
                    let is_inner = shape.outline != TipOutline::Cone && way.norm() < inner;
                    if is_inner { 11..=12 } else { 1..=12 }
                }
            };
            assert!(expected.contains(&count), "{count} {site:?} {shape:?}");
        }
    }
    Ok(())
}

#[test]
fn an_orientation_turns_the_tip_as_a_rigid_body() -> Result<(), Error> {
    for outline in ["hexagon", "disk", "cone"] {
        for degrees in [17.0, -90.0, 60.0, 180.0] {
            let text = format!(
                "substrate_columns = 17\nsubstrate_rows = 18\ntip_side_atoms = 5\noutline = \"{outline}\""
            );
            let plain = tip(&text)?.shape();
            let turned = tip(&format!("{text}\ntip_orientation = {degrees:?}"))?.shape();
            let [x0, y0] = plain.axis();
            let (sin, cos) = f64::to_radians(degrees).sin_cos();
            for (before, after) in plain.sites().iter().zip(&turned.sites()) {
                let expected = if before.layer < plain.substrate_layers {
                    before.place
                } else {
                    let [x, y] = [before.place.x - x0, before.place.y - y0];
                    let [x, y] = [cos * x - sin * y, sin * x + cos * y];
                    Vector3::new(x0 + x, y0 + y, before.place.z)
                };
                let off = (after.place - expected).norm() / plain.spacing;
                assert!(off < 10.0 * ROUNDING, "{off} {before:?} {after:?}");
                assert_eq!((before.layer, before.part), (after.layer, after.part));
            }
        }
    }
    Ok(())
}

#[test]
fn a_cone_loses_one_atom_a_side_from_each_layer_to_the_one_below() -> Result<(), Error> {
    let shape = tip("outline = \"cone\"\ntip_side_atoms = 4\ntip_layers = 6")?.shape();
    let count = |layer: usize| shape.sites().iter().filter(|s| s.layer == layer).count();
    // Hexagons of 1, 2, 3 and 4 atoms a side; an end stays.
    assert_eq!([6, 7, 8, 9, 10, 11].map(count), [1, 1, 1, 7, 19, 37]);
    Ok(())
}

#[test]
fn a_raise_lifts_the_driven_layers_only() -> Result<(), Error> {
    for raise in [0.3, -0.25] {
        let plain = tip("")?.shape().sites();
        let raised = tip(&format!("raise = {raise:?}"))?.shape().sites();
        for (before, after) in plain.iter().zip(&raised) {
            let lift = if before.part == AtomRole::Driven {
                raise
            } else {
                0.0
            };
            let expected = before.place + Vector3::new(0.0, 0.0, lift);
            assert_eq!(expected, after.place);
        }
    }
    Ok(())
}

#[test]
fn no_tip_that_is_accepted_reaches_its_own_images() -> Result<(), Error> {
    let mut tightest = f64::INFINITY;
    for outline in ["hexagon", "disk", "cone"] {
        for side in [1, 3, 5, 7, 9] {
            for orientation in [0.0, 11.0, 30.0, 90.0] {
                let text = format!(
                    "tip_side_atoms = {side}\noutline = \"{outline}\"\ntip_orientation = {orientation:?}\n\
                     cutoff = 2.5\nspacing = 1"
                );
                // The narrowest box along each axis.
                let narrow = |key: &str, step: usize, other: &str| {
                    let fits =
                        (1..40).map(|n| tip(&format!("{text}\n{key} = {}\n{other}", step * n)));
                    fits.filter_map(Result::ok)
                        .next()
                        .map(|scene| scene.shape())
                };
                let columns = narrow("substrate_columns", 1, "substrate_rows = 40");
                let rows = narrow("substrate_rows", 2, "substrate_columns = 40");
                for shape in [columns, rows] {
                    let shape = shape.ok_or("no box is wide enough")?;
                    tightest = tightest.min(nearest_image(&shape));
                }
            }
        }
    }
    // Not wider than needed by more than a row and the corners.
    assert!((2.5..4.5).contains(&tightest), "{tightest}");
    Ok(())
}

/// Distance of the tip from its nearest image.
fn nearest_image(shape: &Shape) -> f64 {
    let mut sites = shape.sites();
    sites.retain(|site| site.layer >= shape.substrate_layers);
    let [x, y] = shape.periods();
    let mut nearest = f64::INFINITY;
    for one in &sites {
        for other in &sites {
            for shift in [[x, 0.0], [0.0, y], [x, y], [x, -y]] {
                let way = other.place - one.place + Vector3::new(shift[0], shift[1], 0.0);
                nearest = nearest.min(way.norm());
            }
        }
    }
    nearest
}
