//! Fields that were changed in Rust are what the JSON says.

use crate::cd::{Method, Order, Stop};
use crate::powder::deposit::{Ballistic, Until};
use crate::scene::*;
use crate::slide::curling::{Dry, IceLaw, LeftRight};

fn powder() -> PowderScene {
    let text = "body = \"powder\"\nwidth = 20\nheight = 61.5\nradius_spread = 0.1";
    match parse_scene("powder.toml", text, &[]) {
        Ok(Scene::Powder(scene)) => *scene,
        other => unreachable!("{other:?}"),
    }
}

fn tip() -> TipScene {
    let text = "body = \"tip\"\nlambda = 0.017\norientation = 7.3";
    match parse_scene("tip.toml", text, &[]) {
        Ok(Scene::Tip(scene)) => *scene,
        other => unreachable!("{other:?}"),
    }
}

fn planar(body: &str) -> PlanarScene {
    let text = vocabulary(body).map(|known| known.least_text());
    match parse_scene("planar.toml", &text.unwrap_or_default(), &[]) {
        Ok(Scene::Planar(scene)) => scene,
        other => unreachable!("{other:?}"),
    }
}

#[test]
fn a_scene_that_nobody_changed_says_what_was_read() {
    for body in bodies().filter(|body| *body != "disk") {
        let text = vocabulary(body)
            .map(|known| known.least_text())
            .unwrap_or_default();
        let (values, json) = match parse_scene(body, &text, &[]) {
            Ok(Scene::Powder(scene)) => (scene.values.clone(), scene.json()),
            Ok(Scene::Tip(scene)) => (scene.values.clone(), scene.json()),
            Ok(Scene::Planar(scene)) => (scene.values.clone(), scene.json()),
            other => unreachable!("{other:?}"),
        };
        assert_eq!(serde_json::Value::Object(values), json, "{body}");
    }
    assert_eq!(tip().json()["orientation"].as_f64(), Some(7.3));
    assert_eq!(powder().json()["radius_spread"].as_f64(), Some(0.1));
}

#[test]
fn every_changed_field_of_a_powder_is_told() {
    let changes: [fn(&mut PowderScene); 27] = [
        |s| s.ballistic = Ballistic::uneven(20.0, [0.9, 1.1], 3.5).unwrap(),
        |s| s.ballistic = Ballistic::uneven(20.0, [0.9, 1.2], 3.0).unwrap(),
        |s| s.ballistic = Ballistic::uneven(21.0, [0.9, 1.1], 3.0).unwrap(),
        |s| s.width = 21.0,
        |s| s.until = Until::Cut(60.0),
        |s| s.until = Until::Height(61.5),
        |s| s.until = Until::Count(100),
        |s| s.seed = u64::MAX,
        |s| s.friction[0] = 0.4,
        |s| s.friction[1] = 0.4,
        |s| s.friction[2] = 0.4,
        |s| s.coupling = Coupling::Exact,
        |s| s.pressure = 0.3,
        |s| s.cohesion_range = 0.3,
        |s| s.attraction = tribos_core::contact::Attraction::Resistance,
        |s| s.restitution = 0.3,
        |s| s.wall = WallLaw::Bare,
        |s| s.piston_mass = 1.0,
        |s| s.solver.method = Method::Accelerated { tolerance: 1e-9 },
        |s| {
            let (order, stop) = (Order::Random { seed: 7 }, Stop::Fixed);
            s.solver.method = Method::GaussSeidel { order, stop };
        },
        |s| s.solver.most_sweeps = 7,
        |s| s.solver.warm_start = false,
        |s| s.pace.motion = 0.01,
        |s| s.still_speed = 0.0,
        |s| s.blocked = Criterion::Piston,
        |s| s.steps = 7,
        |s| s.duration = Some(7.0),
    ];
    let before = powder().json();
    let mut seen = vec![before];
    for (index, change) in changes.into_iter().enumerate() {
        let mut scene = powder();
        change(&mut scene);
        let json = scene.json();
        assert!(!seen.contains(&json), "change {index}: {json}");
        seen.push(json);
    }
}

#[test]
fn every_changed_field_of_a_tip_is_told() {
    let changes: [fn(&mut TipScene); 14] = [
        |s| s.shape.columns = 30,
        |s| s.shape.orientation = s.shape.orientation.next_up(),
        |s| s.shape.outline = crate::tip::Outline::Cone,
        |s| s.lambda = 0.02,
        |s| s.reading = Reading::Largest,
        |s| s.lift = Lift::Loaded(0.0),
        |s| s.lift = Lift::Loaded(-0.5),
        |s| s.bath = Bath::None,
        |s| s.bath = Bath::Langevin(2.0),
        |s| s.stages[2] = 7.0,
        |s| s.time_step = 0.001,
        |s| s.integrator = crate::md::system::Integrator::VelocityVerlet,
        |s| s.seed = 2,
        |s| s.samples = 7,
    ];
    let mut seen = vec![tip().json()];
    for (index, change) in changes.into_iter().enumerate() {
        let mut scene = tip();
        change(&mut scene);
        let json = scene.json();
        assert!(!seen.contains(&json), "change {index}: {json}");
        seen.push(json);
    }
}

#[test]
fn every_changed_field_of_a_body_in_the_plane_is_told() {
    let mut rock = planar("curling");
    let before = rock.json();
    assert_eq!(before["model"], "left-right");
    let PlanarBody::Curling(_, model) = &mut rock.body else {
        unreachable!()
    };
    let ice = IceLaw {
        alpha: -0.4,
        ..IceLaw::PENNER
    };
    *model = Box::new(LeftRight { ice });
    let steeper = rock.json();
    assert_ne!(before, steeper);
    let PlanarBody::Curling(_, model) = &mut rock.body else {
        unreachable!()
    };
    *model = Box::new(Dry { coefficient: 0.01 });
    assert_eq!(rock.json()["model"], "dry");

    let mut pipe = planar("pipe");
    let before = pipe.json();
    pipe.speed = 3.0;
    assert_eq!(pipe.json()["speed"].as_f64(), Some(3.0));
    let PlanarBody::Pipe(body) = &mut pipe.body else {
        unreachable!()
    };
    body.inner_ratio = 0.5;
    let inner = pipe.json()["inner_radius"].as_f64();
    assert!(inner < before["inner_radius"].as_f64());
}
