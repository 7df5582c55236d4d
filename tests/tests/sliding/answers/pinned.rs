//! The scenes of the command that are pinned in `scenes/golden-answers.toml` arrive at the reference answers.

use super::deviation;
use std::path::Path;
use tribos::golden::{Golden, Pinned, Quantity, Verdict, measure};
use tribos::scene::Scene;
use tribos_tests::tables::Table;

/// The scenes follow a motion to a tolerance of their own.
const CLOSE: f64 = 1e-10;

/// The problem that a scene with these settings is.
fn problem(pinned: &Pinned) -> &'static str {
    let has = |setting: &str| pinned.overrides.iter().any(|set| set == setting);
    match pinned.path.as_str() {
        "disk.toml" if has("speed=0") => "spin_down",
        "disk.toml" => "puck",
        "cylinder.toml" => "tall",
        "plate.toml" if has("patch=box:0.1x0.1") => "box",
        "plate.toml" if has("patch=box:0.2x0.05") => "plank",
        "plate.toml" if has("patch=bar:0.2") => "bar",
        other => panic!("{other} {:?} is no problem", pinned.overrides),
    }
}

/// Launches of the problems that have scenes: six problems at five spins, but spin-down at three.
const LAUNCHES: usize = 28;

#[test]
fn pinned_scenes_arrive_at_the_reference_answers() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a file");
    let golden =
        Golden::parse("golden-answers.toml", &read("golden-answers.toml")).expect("a golden file");
    let table = Table::read("../answers/v1/answers.csv");
    assert_eq!(golden.scenes.len(), LAUNCHES);
    for pinned in &golden.scenes {
        let spin = pinned
            .overrides
            .iter()
            .find_map(|set| set.strip_prefix("spin="));
        let (problem, spin) = (problem(pinned), spin.expect("a spin"));
        let scene = Scene::parse(&pinned.path, &read(&pinned.path), &pinned.overrides);
        let measured = measure(&scene.expect("a scene"), || ()).expect("a run");
        assert_eq!(
            pinned.compare(&measured),
            Verdict::Same,
            "{problem} at {spin}"
        );
        let number = |names: &[&str]| {
            let is_named = |(name, _): &&(String, _)| names.contains(&name.as_str());
            let (_, quantity) = measured.summary.iter().find(is_named)?;
            match quantity {
                Quantity::Number(number) => Some(*number),
                Quantity::Text(_) => None,
            }
        };
        let launch = table
            .rows()
            .filter(|row| row.text("scene") == problem && row.text("spin_rad_s") == spin);
        let wanted: Vec<f64> = launch.map(|row| row.number("value")).collect();
        let aside = number(&["y"]).or(Some(0.0));
        let got = [
            number(&["distance", "x"]),
            aside,
            number(&["angle"]),
            number(&["end_time"]),
        ];
        let got = got.map(|x| x.expect("a number"));
        assert_eq!(wanted.len(), got.len(), "{problem} at {spin}");
        for place in 0..wanted.len() {
            let off = deviation(&wanted, &got, place);
            println!("{problem} at {spin}, {place}: {off:.1e}");
            assert!(off <= CLOSE, "{problem} at {spin}, {place}: {off:.1e}");
        }
    }
}
