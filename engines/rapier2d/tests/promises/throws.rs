//! Thrown bodies against exact solutions.

use crate::exact;
use crate::game::*;
use rapier2d::prelude::*;
use tribos_core::coupling::closed::CoulombRing;
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_rapier2d::{Footprint, PlacedFoot};

const SPINS: [f32; 6] = [0.0, 5.0, 12.5, 20.0, 30.0, 50.0];
/// Relative error of travel and stop.
const NEAR: f64 = 1e-3;

#[track_caller]
fn assert_near(what: &str, is: [f64; 2], exact: [f64; 2]) {
    let errors = [0, 1].map(|i| is[i] / exact[i] - 1.0);
    println!("{what}: {errors:.5?} of {exact:.5?}");
    assert!(
        errors.iter().all(|error| error.abs() < NEAR),
        "{what}: {is:?} for {exact:?}"
    );
}

macro_rules! exact_disk {
    ($profile:expr, $spin:expr) => {{
        let parameters = SliderParameters {
            deceleration: f64::from(MU) * f64::from(GRAVITY),
            radius: f64::from(RADIUS),
            inertia_ratio: 0.5,
        };
        let slider = Slider::new($profile, parameters).unwrap();
        let end = slider
            .to_rest(&SliderState::launched(1.0, f64::from($spin)))
            .unwrap()
            .motion;
        [end.distance, end.time]
    }};
}

#[test]
fn a_disk_stops_where_and_when_the_exact_one_does() {
    for spin in SPINS {
        let mut game = Game::level();
        let puck = game.put(thrown(1.0, spin), disk());
        assert_near(
            &format!("disk, {spin} rad/s"),
            game.run_to_rest(puck),
            exact_disk!(CoulombDisk, spin),
        );
    }
}

#[test]
fn a_disk_on_a_ring_stops_where_and_when_the_exact_one_does() {
    for spin in SPINS {
        let mut game = Game::level();
        let cup = game.put(thrown(1.0, spin), disk());
        let ring = PlacedFoot::new(Footprint::ring(RADIUS).unwrap(), Pose::identity());
        game.floor.set_feet(cup, vec![ring]).unwrap();
        assert_near(
            &format!("ring, {spin} rad/s"),
            game.run_to_rest(cup),
            exact_disk!(CoulombRing, spin),
        );
    }
}

#[test]
fn boxes_stop_where_and_when_their_cells_do() {
    let deceleration = f64::from(MU) * f64::from(GRAVITY);
    for half in [[0.1, 0.1], [0.2, 0.05]] {
        let cells = exact::rectangle(half, 60, deceleration);
        let gyration = ((half[0] * half[0] + half[1] * half[1]) / 3.0).sqrt();
        for spin in [0.0, 5.0, 12.5, 25.0] {
            let mut game = Game::level();
            let shape = ColliderBuilder::cuboid(half[0] as f32, half[1] as f32);
            let body = game.put(thrown(1.0, spin), shape);
            let exact = exact::to_rest(&cells, gyration, 1.0, f64::from(spin));
            assert_near(
                &format!("box {half:?}, {spin} rad/s"),
                game.run_to_rest(body),
                exact,
            );
        }
    }
}

#[test]
fn a_body_of_two_boxes_stops_where_and_when_their_cells_do() {
    // A T of a bar across and a bar along, of one density: its centre of mass is between them.
    let deceleration = f64::from(MU) * f64::from(GRAVITY);
    let half = [[0.05, 0.2], [0.15, 0.05]];
    let middles = [0.0, 0.2];
    let areas = half.map(|[a, b]| 4.0 * a * b);
    let whole = areas[0] + areas[1];
    let centre = (areas[0] * middles[0] + areas[1] * middles[1]) / whole;
    let mut cells = Vec::new();
    let mut square = 0.0;
    for i in [0, 1] {
        let part = deceleration * areas[i] / whole;
        let off = middles[i] - centre;
        let moved = |cell: exact::Cell| exact::Cell {
            x: cell.x + off,
            ..cell
        };
        cells.extend(exact::rectangle(half[i], 40, part).into_iter().map(moved));
        let [a, b] = half[i];
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
        let exact = exact::to_rest(&cells, square.sqrt(), 1.0, f64::from(spin));
        assert_near(&format!("T, {spin} rad/s"), game.run_to_rest(body), exact);
    }
}
