//! A scene is what its fields say, whether it was read or made in Rust.

use super::body::defaults;
use super::*;
use crate::powder::PowderSimulation;
use crate::record::CheckpointError;
use crate::run::PackingRunError;
use std::time::{Duration, Instant};

#[test]
fn the_default_scene_of_a_body_is_what_its_least_file_says() {
    for scene in defaults() {
        let body = scene.body();
        let text = vocabulary(body).unwrap().least_text();
        assert_eq!(Scene::parse(body, &text, &[]).unwrap(), scene);
        scene.as_body().check().unwrap();
    }
}

#[test]
fn a_scene_comes_back_from_its_values_in_force() {
    for scene in LIBRARY {
        let read = Scene::parse(scene.name, scene.text, &[]).unwrap();
        let mut values = read.json();
        let again = Scene::of_json(&values).expect(scene.name);
        assert_eq!(again.json(), values, "{}", scene.name);
        let keys = values.as_object_mut().unwrap();
        keys.insert("unheard_of".into(), 1.into());
        assert_eq!(Scene::of_json(&values), None);
    }
    assert_eq!(Scene::of_json(&serde_json::Value::Null), None);
}

/// Keys of a slid tip, which has no torque.
fn is_of_slide(key: &Key) -> bool {
    key.need == Need::PartOf("drive", "slide")
}

/// What a file says beside a key that goes with others.
fn beside(key: &str) -> String {
    match key {
        "intruder_radius" => "intruder_position = \"0, 0, 1\"\n".into(),
        "intruder_position" => "intruder_radius = 0.01\n".into(),
        "adhesion" => "surface_energy = 0.05\n".into(),
        "poisson_ratio" => "young_modulus = 1e9\n".into(),
        "pairs" => "materials = \"glass: mu=0.5; steel: mu=0.2\"\n".into(),
        _ => {
            let moved = key.strip_prefix("wall_stress_");
            let moved = moved.or(key.strip_prefix("wall_velocity_"));
            moved.map_or(String::new(), |axis| {
                format!("boundary_{axis} = \"walls\"\n")
            })
        }
    }
}

/// The value that a file gives a key comes back from its field.
#[test]
fn every_key_sets_its_field() {
    for scene in defaults() {
        let before = scene.json();
        let known = vocabulary(scene.body()).unwrap();
        for key in known.keys.iter().filter(|key| key.name != "body") {
            let was = &before[key.name];
            let value = match key.domain {
                Domain::OneOf(words) => {
                    let other = words.iter().find(|word| was.as_str() != Some(*word));
                    format!("\"{}\"", other.unwrap())
                }
                Domain::Form(form) if form.numbers.is_none() => {
                    let text = match form.name {
                        "law" => "dry:mu_s=0.4,mu_d=0.3",
                        "patch" => "box:0.2x0.1",
                        "potential" => "sutton-chen:Ag",
                        "sizes" => "normal:0.1",
                        "columns" => "x,y,z,radius",
                        "coordinates" => "0.01, 0, 2.5",
                        "materials" => "glass: mu=0.5; steel: mu=0.2, share=0.3",
                        "pairs" => "glass-steel: mu=0.3",
                        other => unreachable!("the form {other}"),
                    };
                    format!("\"{text}\"")
                }
                Domain::Path => "\"out/powder\"".into(),
                Domain::Form(form) if form.name == "types" => "\"2, 3\"".into(),
                Domain::Count { .. } => format!("{}", was.as_u64().unwrap_or(30) + 4),
                Domain::Between { above, up_to } if was.is_null() => {
                    format!("{}", 0.5 * (above + up_to.min(above + 2.0)))
                }
                _ => format!("{}", 0.98 * was.as_f64().unwrap_or(0.8) + 0.0017),
            };
            let rest: String = known
                .least()
                .into_iter()
                .filter(|(name, _)| *name != key.name)
                .filter(|(name, _)| {
                    !(["count", "initial_state"].contains(&key.name) && *name == "height")
                })
                .filter(|(name, _)| !(key.name == "initial_state" && *name == "count"))
                .filter(|(name, _)| key.name != "law" || !["gamma", "alpha"].contains(name))
                .filter(|(name, _)| !(is_of_slide(key) && *name == "lambda"))
                .map(|(name, value)| format!("{name} = {value}\n"))
                .collect();
            let condition = match key.need {
                Need::PartOf("drive", word) if key.name != "speed" => {
                    format!("drive = \"{word}\"\nspeed = 0.2\n")
                }
                Need::PartOf(other, word) | Need::OnlyWith(other, word) => {
                    format!("{other} = \"{word}\"\n")
                }
                _ => String::new(),
            } + &beside(key.name);
            let text = format!("{rest}{condition}{} = {value}\n", key.name);
            let Ok(read) = Scene::parse("one.toml", &text, &[]) else {
                // Values that other keys would have to follow.
                assert!(
                    [
                        "units",
                        "tip_side_atoms",
                        "drive",
                        "lattice_expansion",
                        "dimension",
                        "inertial_number",
                        "shear_rate",
                        "columns"
                    ]
                    .contains(&key.name),
                    "{text}"
                );
                continue;
            };
            assert_ne!(read, scene, "{text}");
            if let Some(was) = key.was {
                let earlier = format!("{rest}{condition}{was} = {value}\n");
                assert_eq!(
                    Scene::parse("one.toml", &earlier, &[]).unwrap(),
                    read,
                    "{earlier}"
                );
                let set = [format!("{was}={}", value.trim_matches('"'))];
                assert_eq!(
                    Scene::parse("one.toml", &text, &set).unwrap(),
                    read,
                    "{set:?}"
                );
                assert_eq!(earlier_names(known.keys, &earlier, &[]), [[was, key.name]]);
                let both = format!("{text}{was} = {value}\n");
                assert!(Scene::parse("one.toml", &both, &[]).is_err(), "{both}");
            }
            let json = read.json();
            let written = toml_value(key, &json[key.name]).unwrap();
            let same = written == value || written.parse::<f64>().ok() == value.parse().ok();
            assert!(same, "{text}: {written}");
        }
    }
}

/// A word has one meaning in the files of a body, and conditions name keys that there are.
#[test]
fn every_name_of_a_key_is_that_of_one_key() {
    for known in bodies().filter_map(vocabulary) {
        let present = known.keys.iter().map(|key| key.name);
        let names: Vec<&str> = present
            .chain(known.keys.iter().filter_map(|key| key.was))
            .collect();
        for (at, name) in names.iter().enumerate() {
            assert!(!names[..at].contains(name), "{}: {name}", known.body);
        }
        for key in known.keys {
            let others = match key.need {
                Need::Required | Need::Optional => vec![],
                Need::UnlessEither(one, two) => vec![one, two],
                Need::UnlessGiven(other)
                | Need::UnitWith(other, _)
                | Need::PartOf(other, _)
                | Need::OnlyWith(other, _)
                | Need::NotWith(other, _)
                | Need::Without(other) => vec![other],
            };
            let is_key = |name: &str| known.keys.iter().any(|key| key.name == name);
            assert!(
                others.into_iter().all(is_key),
                "{}: {}",
                known.body,
                key.name
            );
        }
    }
}

#[test]
fn values_that_an_earlier_version_wrote_are_those_of_the_same_scene() {
    for scene in defaults() {
        let keys = vocabulary(scene.body()).unwrap().keys;
        let earlier = |name: &str| {
            let key = keys.iter().find(|key| key.name == name);
            key.and_then(|key| key.was).unwrap_or(name).to_owned()
        };
        let values = scene.json();
        let values = values.as_object().unwrap().iter();
        let then: serde_json::Value = values
            .map(|(name, value)| (earlier(name), value.clone()))
            .collect();
        assert_eq!(with_present_names(&then), scene.json());
        assert_eq!(Scene::of_json(&then), Scene::of_json(&scene.json()));
    }
}

/// The outermost numbers that a domain admits, and the nearest beyond them.
fn ends(domain: &Domain) -> [Vec<f64>; 2] {
    let [inside, beyond]: [&[f64]; 2] = match *domain {
        Domain::Finite => [&[f64::MIN, f64::MAX], &[f64::NEG_INFINITY, f64::INFINITY]],
        Domain::NotNegative => [&[0.0, f64::MAX], &[-f64::MIN_POSITIVE, f64::INFINITY]],
        Domain::Positive => [&[f64::MIN_POSITIVE, f64::MAX], &[0.0, f64::INFINITY]],
        Domain::Fraction => [&[0.0, 1.0], &[-f64::MIN_POSITIVE, 1.0_f64.next_up()]],
        Domain::Between { above, up_to } => [&[above.next_up(), up_to], &[above, up_to.next_up()]],
        Domain::Below { from, below } => [&[from, below.next_down()], &[from.next_down(), below]],
        // Beyond 2^53 the next number is not the next whole one.
        Domain::Count { from, up_to } => [
            &[from, up_to],
            &[from - 1.0, from + 0.5, (up_to + 1.0).max(up_to.next_up())],
        ],
        Domain::Form(Form {
            numbers: Some(numbers),
            ..
        }) => return ends(numbers),
        _ => [&[], &[]],
    };
    [inside.into(), beyond.into()]
}

#[test]
fn the_ends_that_a_domain_tells_are_the_readers() {
    let mut wrong = Vec::new();
    let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
    for known in bodies().filter_map(vocabulary) {
        for key in known.keys {
            let refusal = |value: String| {
                let mut set = vec![format!("{}={value}", key.name)];
                if let Need::PartOf(other, word) | Need::OnlyWith(other, word) = key.need {
                    set.push(format!("{other}={word}"));
                }
                let read = Scene::parse(known.body, &known.least_text(), &set);
                read.err().map(|error| error.to_string())
            };
            let [inside, beyond] = ends(&key.domain);
            // A value is a number, or the whole of a ramp.
            let texts = |x: f64| match key.domain {
                Domain::Count { .. } => vec![format!("{x}")],
                Domain::Form(form) if form.name == "ramp" => {
                    vec![format!("{x:?}"), format!("\"0:0, 1:{x:?}\"")]
                }
                _ => vec![format!("{x:?}")],
            };
            for value in inside.into_iter().flat_map(texts) {
                // What is refused all the same does not fit to other keys, which are named.
                for told in refusal(value).iter().flat_map(|told| told.lines()) {
                    let (_, told) = told.split_once(": ").unwrap();
                    let others = known.keys.iter().filter(|other| other.name != key.name);
                    let names: Vec<&str> = others.map(|other| other.name).collect();
                    let mut named = told.split(|letter| !is_word(letter));
                    if !named.any(|word| names.contains(&word)) {
                        wrong.push(told.to_owned());
                    }
                }
            }
            for value in beyond.into_iter().flat_map(texts) {
                let told = refusal(value.clone()).unwrap_or_default();
                let domain = format!("`{}` must be {}", key.name, key.domain.describe());
                // What is not finite is refused by the syntax of files or ramps already.
                if told.is_empty() || (!value.contains("inf") && !told.contains(&domain)) {
                    wrong.push(format!("{} {} = {value}: {told}", known.body, key.name));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn an_override_puts_keys_of_the_old_word_out_of_use() {
    let read = |text: &str, set: &[&str]| {
        let set: Vec<String> = set.iter().map(|item| (*item).to_owned()).collect();
        Scene::parse("one.toml", text, &set).map(|scene| scene.json())
    };
    let grains =
        "body = \"grains\"\nwidth = 0.1\ncount = 9\nradius = 0.005\ndensity = 2500\nduration = 1\n";
    let rigid = format!("{grains}sweeps = 300\ntolerance = 1e-3\n");
    let soft = read(&rigid, &["method=soft"]).unwrap();
    assert_eq!(soft, read(grains, &["method=soft"]).unwrap());
    assert!(soft.get("max_iterations").is_none());
    // What is given beside the override, or by the file alone, still contradicts.
    assert!(read(&rigid, &["method=soft", "max_iterations=20"]).is_err());
    assert!(read(&format!("{rigid}method = \"soft\"\n"), &[]).is_err());
    let hopper = format!("{grains}container = \"hopper\"\norifice_width = 0.02\n");
    assert_eq!(
        read(&hopper, &["container=box"]).unwrap(),
        read(grains, &[]).unwrap()
    );
    let uneven = format!("{grains}radius_spread = 0.2\n");
    let starts = read(&uneven, &["initial_state=out/a"]).unwrap();
    assert!(starts["radius_spread"].is_null());
    assert!(read(&uneven, &["initial_state=out/a", "radius_spread=0.1"]).is_err());
    // A key falls with the key that it depends on: without a stop there is no tolerance of one.
    let powder = "body = \"powder\"\nwidth = 20\ncount = 10\nsolver = \"gauss-seidel\"\nstop_rule = \"fixed\"\n";
    assert!(read(powder, &["tolerance=1e-3"]).is_err());
    assert!(read(powder, &["tolerance=1e-3", "stop_rule=local"]).is_ok());
}

#[test]
fn fields_out_of_their_domain_are_refused_by_name_value_and_cure_all_at_once() {
    let scene = PowderScene {
        pressure: -1.0,
        restitution: f64::NAN,
        max_iterations: 0,
        count: Some(0),
        ..PowderScene::default()
    };
    let refused = scene.check().unwrap_err();
    let told: Vec<&str> = refused.problems.iter().map(SceneProblem::message).collect();
    assert_eq!(
        told,
        [
            "`count` must be a whole number from 1 to 1000000, not 0",
            "`pressure` must be a finite number > 0, not -1",
            "`restitution` must be a number from 0 to 1, not NaN",
            "`max_iterations` must be a whole number from 1 to 1000000, not 0",
        ]
    );
    // The rules that files are read by hold for fields as well.
    let tip = TipScene {
        load: Some(1.0),
        substrate_rows: 15,
        ..TipScene::default()
    };
    let told = tip.check().unwrap_err().to_string();
    assert!(
        told.contains("`substrate_rows` must be even with face = \"fcc111\", not 15"),
        "{told}"
    );
    assert!(told.contains("driven_constraint = \"level\""), "{told}");
    let disk = DiskScene {
        units: Units::Dimensionless,
        ..DiskScene::default()
    };
    assert_eq!(disk.check().unwrap_err().problems.len(), 3);
}

#[test]
fn no_run_begins_with_fields_that_no_file_could_have() {
    let powder = PowderScene {
        pressure: 0.0,
        ..PowderScene::default()
    };
    let refused = PowderSimulation::new(&powder);
    assert!(matches!(refused, Err(PackingRunError::Scene(_))));
    let tip = TipScene {
        tip_layers: 1,
        ..TipScene::default()
    };
    let refused = crate::tip::TipSimulation::new(&tip).map(|_| ());
    assert!(
        refused
            .unwrap_err()
            .to_string()
            .contains("`tip_layers` must be a whole number from 4 to 100, not 1")
    );
    let disk = DiskScene {
        mass: f64::INFINITY,
        ..DiskScene::default()
    };
    let refused = disk.run();
    assert!(matches!(refused, Err(crate::slide::MotionError::Scene(_))));
    let pipe = PipeScene {
        inner_radius: 1.0,
        ..PipeScene::default()
    };
    let refused = pipe.run();
    assert!(matches!(refused, Err(crate::slide::MotionError::Scene(_))));
}

#[test]
fn a_checkpoint_of_edited_fields_belongs_to_no_other_scene() {
    let text = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02";
    let original = PowderScene::parse("tiny.toml", text, &[]).unwrap();
    let rough = PowderScene {
        mu: 0.9,
        ..original.clone()
    };
    let pressed = PowderScene {
        pressure: 0.2,
        ..original.clone()
    };
    for (edited, scene) in [("mu", rough), ("pressure", pressed)] {
        let kept = PowderSimulation::new(&scene).unwrap().checkpoint();
        assert!(PowderSimulation::resume(&scene, &kept).is_ok());
        match PowderSimulation::resume(&original, &kept) {
            Err(PackingRunError::Checkpoint(CheckpointError::Scene { key, .. })) => {
                assert_eq!(key, edited);
            }
            other => panic!("{other:?}"),
        }
    }
}

/// A disk with so many keys that nobody knows, and how long it takes to refuse it.
fn refused(strangers: usize) -> (String, usize, Duration) {
    let mut text = String::from("speed = 1\n");
    for key in 0..strangers {
        text += &format!("key_{key} = 1\n");
    }
    let began = Instant::now();
    let refusal = Scene::parse("many.toml", &text, &[]);
    let took = began.elapsed();
    let Err(error @ SceneError::Invalid { .. }) = refusal else {
        unreachable!("unknown keys");
    };
    let told = error.to_string();
    (told.clone(), told.lines().count(), took)
}

#[test]
fn any_number_of_unknown_keys_is_refused_in_a_time_in_proportion() {
    let (told, lines, few) = refused(20_000);
    assert!(told.contains("and 19980 more keys that are unknown"));
    let (told, more_lines, many) = refused(200_000);
    assert!(told.contains("and 199980 more keys that are unknown"));
    // Twenty are named, as with few; every missing key is named too.
    assert_eq!(lines, more_lines);
    assert!(lines < 40, "{lines}");
    // Ten times the keys: a time that grew as the square would be a hundred times as long.
    assert!(many < 50 * few, "{few:?} {many:?}");
}
