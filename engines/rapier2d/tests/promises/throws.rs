//! Thrown bodies against exact solutions.

use crate::exact::{BOX_GRAVITY, Cell, HALF_SIDES, assert_stops, on_cells, rectangle};
use crate::game::*;
use rapier2d::prelude::*;
use tribos_rapier2d::{Footprint, PlacedFoot};

/// Relative error of travel and stop.
const NEAR: f64 = 1e-3;

#[test]
fn a_puck_stops_where_and_when_it_should() {
    assert_stops("puck", NEAR, |spin| {
        let mut game = Game::level();
        let puck = game.put(thrown(1.0, spin), disk());
        game.run_to_rest(puck)
    });
}

#[test]
fn a_cup_on_its_rim_stops_where_and_when_it_should() {
    assert_stops("ring", NEAR, |spin| {
        let mut game = Game::level();
        let cup = game.put(thrown(1.0, spin), disk());
        let ring = PlacedFoot::new(Footprint::ring(RADIUS).unwrap(), Pose::identity());
        game.floor.set_feet(cup, vec![ring]).unwrap();
        game.run_to_rest(cup)
    });
}

#[test]
fn boxes_stop_where_and_when_they_should() {
    for (scene, [x, y]) in HALF_SIDES {
        assert_stops(scene, NEAR, |spin| {
            let mut game = Game::under(BOX_GRAVITY);
            let body = game.put(thrown(1.0, spin), ColliderBuilder::cuboid(x, y));
            game.run_to_rest(body)
        });
    }
}

#[test]
fn a_body_of_two_boxes_stops_where_and_when_their_cells_do() {
    // A T of a bar across and a bar along, of one density: its centre of mass is between them.
    let half = [[0.05, 0.2], [0.15, 0.05]];
    let middles = [0.0, 0.2];
    let areas = half.map(|[a, b]| 4.0 * a * b);
    let whole = areas[0] + areas[1];
    let centre = (areas[0] * middles[0] + areas[1] * middles[1]) / whole;
    let mut cells = Vec::new();
    let mut square = 0.0;
    for i in [0, 1] {
        let off = middles[i] - centre;
        let [a, b] = half[i];
        let moved = |([x, y], share): Cell| ([x + off, y], share * areas[i] / whole);
        cells.extend(rectangle(half[i], 40).into_iter().map(moved));
        square += areas[i] / whole * ((a * a + b * b) / 3.0 + off * off);
    }
    for spin in [0.0, 12.5] {
        let mut game = Game::level();
        let box_of = |i: usize| ColliderBuilder::cuboid(half[i][0] as f32, half[i][1] as f32);
        let body = thrown(1.0, spin).translation(Vector::new(-centre as f32, 0.0));
        let body = game.put(body, box_of(0));
        let along = box_of(1).translation(Vector::new(0.2, 0.0)).friction(0.2);
        game.world.insert_collider(along, Some(body));
        // The velocity is that of the centre of mass.
        game.world.bodies[body].recompute_mass_properties_from_colliders(&game.world.colliders);
        let exact = on_cells(&cells, square, spin);
        game.run_to_rest(body)
            .assert_near(&exact, NEAR, &format!("T, {spin} rad/s"));
    }
}
