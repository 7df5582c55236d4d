//! Files written by people and programs: scenes, overrides, checkpoints, golden files.

use std::sync::OnceLock;
use tribos::golden::{Golden, Measurement, Pinned, measure};
use tribos::powder::PowderSimulation;
use tribos::record::digest;
use tribos::run::Simulation;
use tribos::scene::{PowderScene, Scene, SceneError, TipScene, bodies, vocabulary as of_body};
use tribos::tip::TipSimulation;
use tribos_subjects::Source;

/// Scenes from which inputs are derived.
const SCENES: [&str; 9] = [
    include_str!("../../../scenes/disk.toml"),
    include_str!("../../../scenes/cylinder.toml"),
    include_str!("../../../scenes/pipe-a.toml"),
    include_str!("../../../scenes/curling-draw.toml"),
    include_str!("../../../scenes/curling-slow.toml"),
    include_str!("../../../scenes/compaction-small.toml"),
    include_str!("../../../scenes/compaction-large.toml"),
    include_str!("../../../scenes/tip-reversible.toml"),
    LEAST,
];
/// Values for the keys of a scene.
const VALUES: [&str; 25] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "0.5",
    "1e-320",
    "1e308",
    "1e999",
    "nan",
    "-inf",
    "0x1F",
    "0b11",
    "1_000",
    "9223372036854775808",
    "true",
    "\"\"",
    "\"disk\"",
    "\"powder\"",
    "\"tip\"",
    "[1, 2]",
    "{ a = 1 }",
    "1979-05-27",
    "\"\\u0000\"",
    "'raw'",
    "2.0",
];
/// A powder with a short running time.
const TINY: &str =
    "body = \"powder\"\nwidth = 6\nheight = 6\npressure = 0.02\nmax_steps = 4\nsample_every = 1\n";
/// A tip with a short running time: a chain of atoms on a substrate.
const LEAST: &str = "body = \"tip\"\nlambda = 0.1\nsubstrate_columns = 4\nsubstrate_rows = 4\ntip_side_atoms = 1\n\
                     substrate_layers = 4\ntip_layers = 4\ncutoff = 1.5\nspacing = 1.1\n\
                     equilibration = 0\ndrive_time = 0.02\nrest_time = 0.02\nsample_every = 1\n";

fn vocabulary() -> &'static [&'static str] {
    static KEYS: OnceLock<Vec<&'static str>> = OnceLock::new();
    KEYS.get_or_init(|| {
        let all = bodies().filter_map(of_body).flat_map(|known| known.keys);
        all.map(|key| key.name).collect()
    })
}

/// A text with several changes: lines of the vocabulary, deleted or repeated lines, changed bytes.
fn mutated(source: &mut Source, text: &str) -> String {
    let mut lines: Vec<Vec<u8>> = text.lines().map(|line| line.as_bytes().to_vec()).collect();
    for _ in 0..1 + source.below(4) {
        let at = source.below(lines.len());
        match source.below(6) {
            0 => lines.insert(at, entry(source).into_bytes()),
            1 => {
                let line = lines[at].clone();
                lines.push(line);
            }
            2 if lines.len() > 1 => {
                lines.remove(at);
            }
            3 => lines[at] = entry(source).into_bytes(),
            _ => scramble(source, &mut lines[at]),
        }
    }
    if source.one_in(16) {
        let size = source.below(200);
        lines = vec![(0..size).map(|_| source.bits() as u8).collect()];
    }
    String::from_utf8_lossy(&lines.join(&b'\n')).into_owned()
}

fn entry(source: &mut Source) -> String {
    let (key, value) = (source.one_of(vocabulary()), value(source));
    format!("{key} = {value}")
}

fn value(source: &mut Source) -> String {
    if source.one_in(2) {
        source.one_of(&VALUES).into()
    } else {
        format!("{:?}", source.number::<f64>())
    }
}

/// Changes, deletes or inserts some bytes.
fn scramble(source: &mut Source, line: &mut Vec<u8>) {
    for _ in 0..1 + source.below(3) {
        let at = source.below(line.len() + 1);
        let byte = if source.one_in(2) {
            source.one_of(b"=\"'[]{}.-_#0189eEx,\\\n\t ")
        } else {
            source.bits() as u8
        };
        match source.below(3) {
            0 if at < line.len() => {
                line.remove(at);
            }
            1 if at < line.len() => line[at] = byte,
            _ => line.insert(at, byte),
        }
    }
}

/// A scene file is accepted with parameters that are numbers, or refused with the positions of its errors.
pub fn scenes(source: &mut Source) -> Result<(), String> {
    let base = source.one_of(&SCENES);
    let text = mutated(source, base);
    judged(Scene::parse("scene.toml", &text, &[])).map_err(|broken| format!("{broken}\n{text}"))
}

/// A valid scene with overrides of all kinds.
pub fn overrides(source: &mut Source) -> Result<(), String> {
    let text = source.one_of(&SCENES);
    let mut all = Vec::new();
    for _ in 0..1 + source.below(3) {
        let mut item = format!("{}={}", source.one_of(vocabulary()), value(source)).into_bytes();
        if source.one_in(4) {
            scramble(source, &mut item);
        }
        all.push(String::from_utf8_lossy(&item).into_owned());
    }
    judged(Scene::parse("scene.toml", text, &all)).map_err(|broken| format!("{broken}\n{all:?}"))
}

fn judged(read: Result<Scene, SceneError>) -> Result<(), String> {
    match read {
        Ok(scene) => {
            let text = scene.json().to_string();
            match ["\"nan\"", "\"inf\"", "\"-inf\""]
                .iter()
                .find(|bad| text.contains(*bad))
            {
                Some(bad) => Err(format!("a scene with {bad} was accepted: {text}")),
                None => Ok(()),
            }
        }
        Err(SceneError::Invalid { problems, .. }) if problems.is_empty() => {
            Err("a scene was refused without a reason".into())
        }
        Err(error) => {
            let said = error.to_string();
            let has_place = said.starts_with("scene.toml:") || said.starts_with("--set: ");
            if has_place {
                Ok(())
            } else {
                Err(format!("a refusal without a place: {said}"))
            }
        }
    }
}

/// The tiny powder and its checkpoint after two steps.
fn powder() -> Option<&'static (PowderScene, String)> {
    static KEPT: OnceLock<Option<(PowderScene, String)>> = OnceLock::new();
    let made = KEPT.get_or_init(|| {
        let scene = PowderScene::parse("tiny.toml", TINY, &[]).ok()?;
        let mut compaction = PowderSimulation::new(&scene).ok()?;
        for _ in 0..2 {
            compaction.step().ok()?;
        }
        Some((scene, compaction.checkpoint()))
    });
    made.as_ref()
}

/// The smallest tip and its checkpoint after two steps.
fn tip() -> Option<&'static (TipScene, String)> {
    static KEPT: OnceLock<Option<(TipScene, String)>> = OnceLock::new();
    let made = KEPT.get_or_init(|| {
        let scene = TipScene::parse("least.toml", LEAST, &[]).ok()?;
        let mut run = TipSimulation::new(&scene).ok()?;
        for _ in 0..2 {
            run.step().ok()?;
        }
        Some((scene, run.checkpoint()))
    });
    made.as_ref()
}

/// A damaged checkpoint is refused, or the run continues or ends with an error.
pub fn checkpoints(source: &mut Source) -> Result<(), String> {
    if source.one_in(2) {
        let (scene, text) = powder().ok_or("the tiny powder cannot be run")?;
        if let Ok(mut compaction) = PowderSimulation::resume(scene, &damaged(source, text)) {
            let _ = compaction.step();
            let _ = compaction.outcome();
        }
    } else {
        let (scene, text) = tip().ok_or("the least tip cannot be run")?;
        if let Ok(mut run) = TipSimulation::resume(scene, &damaged(source, text)) {
            let _ = run.step();
            let _ = run.outcome().json(scene);
        }
    }
    Ok(())
}

/// One line of JSON, cut at its commas so that single entries change; usually with a digest that matches
/// the changed text, so that the reader must find the damage in the content.
fn damaged(source: &mut Source, text: &str) -> String {
    let lines = text.replace(',', ",\n");
    let changed = mutated(source, &lines).replace(",\n", ",");
    if source.one_in(4) {
        return changed;
    }
    let (body, _) = changed.rsplit_once("\"digest\"").unwrap_or((&changed, ""));
    let digits = digest(body.as_bytes());
    format!("{body}\"digest\":\"{digits:032x}\"}}\n")
}

fn golden() -> Option<&'static (Measurement, String)> {
    static KEPT: OnceLock<Option<(Measurement, String)>> = OnceLock::new();
    let made = KEPT.get_or_init(|| {
        let scene = Scene::parse("disk.toml", SCENES[0], &["samples=20".into()]).ok()?;
        let measured = measure(&scene, || ()).ok()?;
        let scenes = vec![Pinned::new("disk.toml".into(), vec![], &measured)];
        let text = Golden { scenes }.text();
        Some((measured, text))
    });
    made.as_ref()
}

/// A damaged golden file is refused with its line number, or compared.
pub fn golden_files(source: &mut Source) -> Result<(), String> {
    let (measured, text) = golden().ok_or("the disk cannot be run")?;
    let text = mutated(source, text);
    match Golden::parse("golden.toml", &text) {
        Ok(golden) => {
            for scene in &golden.scenes {
                let _ = format!("{:?}", scene.compare(measured));
            }
            let again = Golden::parse("golden.toml", &golden.text());
            if again.as_ref() == Ok(&golden) || golden.scenes.is_empty() {
                Ok(())
            } else {
                Err(format!(
                    "written again it reads differently: {again:?}\n{text}"
                ))
            }
        }
        Err(error) if error.to_string().starts_with("golden.toml:") => Ok(()),
        Err(error) => Err(format!("a refusal without a place: {error}")),
    }
}
