//! Which bodies there are, which keys each has, and the least that a scene of each must say.

use super::body::BODY;
use super::entries::Entries;
use super::key::{Domain, Key};
use super::{PlanarBody, PlanarScene, PowderScene, Scene, SliderScene, TipScene, parse_scene};
use serde_json::{Map, Value};

/// A body that scenes can be about.
///
/// ```
/// use tribos::scene::{Vocabulary, bodies, parse_scene, vocabulary};
/// for body in bodies() {
///     let known: Vocabulary = vocabulary(body).ok_or(body)?;
///     let scene = parse_scene("least.toml", &known.least_text(), &[])?;
///     assert_eq!(scene.body(), body);
///     // What it leaves out holds by default.
///     let values = scene.json();
///     assert!(known.defaults().iter().all(|(name, value)| values[name] == *value));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vocabulary {
    /// Value of the key `body`.
    pub body: &'static str,
    /// Its keys, in the order of the documentation.
    pub keys: &'static [Key],
    /// Keys and values, as TOML, of a scene that says as little as possible.
    pub least: &'static [(&'static str, &'static str)],
}

/// The vocabulary of a body, if there is one of that name.
///
/// ```
/// let tip = tribos::scene::vocabulary("tip").ok_or("no tip")?;
/// assert!(tip.keys.iter().any(|key| key.name == "lambda" && key.unit == "eps/sigma^2"));
/// # Ok::<(), &str>(())
/// ```
pub fn vocabulary(body: &str) -> Option<Vocabulary> {
    let body = bodies().find(|&known| known == body)?;
    let keys = match body {
        "disk" => SliderScene::KEYS,
        "powder" => PowderScene::KEYS,
        "tip" => TipScene::KEYS,
        _ => PlanarScene::keys(body)?,
    };
    Some(Vocabulary {
        body,
        keys,
        least: least(body),
    })
}

/// All bodies, the default one first.
pub fn bodies() -> impl Iterator<Item = &'static str> {
    let words: &'static [&'static str] = match BODY.domain {
        Domain::OneOf(words) => words,
        _ => &[],
    };
    words.iter().copied()
}

/// A scene of each body that leaves out what may be left out.
fn least(body: &str) -> &'static [(&'static str, &'static str)] {
    match body {
        "disk" => &[
            ("speed", "1.0"),
            ("spin", "5.0"),
            ("coefficient", "0.3"),
            ("alpha", "0.0"),
            ("gravity", "9.81"),
            ("radius", "0.08"),
            ("mass", "0.1"),
            ("inertia_ratio", "0.5"),
        ],
        "cylinder" => &[
            ("body", "\"cylinder\""),
            ("speed", "1.0"),
            ("spin", "5.0"),
            ("coefficient", "0.2"),
            ("gravity", "9.81"),
            ("radius", "0.08"),
            ("height", "0.16"),
            ("mass", "1.0"),
        ],
        "pipe" => &[
            ("body", "\"pipe\""),
            ("speed", "1.74"),
            ("spin", "10.2"),
            ("coefficient", "0.2"),
            ("gravity", "9.81"),
            ("radius", "0.05"),
            ("inner_radius", "0.046"),
            ("height", "0.15"),
            ("mass", "0.5"),
        ],
        "curling" => &[("body", "\"curling\""), ("speed", "2.0"), ("spin", "1.5")],
        "powder" => &[("body", "\"powder\""), ("width", "20"), ("height", "61.5")],
        "tip" => &[("body", "\"tip\""), ("lambda", "0.017")],
        _ => &[],
    }
}

impl Vocabulary {
    /// The least scene as a file.
    pub fn least_text(&self) -> String {
        let lines = self
            .least
            .iter()
            .map(|(key, value)| format!("{key} = {value}\n"));
        lines.collect()
    }

    /// Values that keys have where they are left out of the least scene. Keys whose absence means
    /// that something is chosen or switched off are not there.
    pub fn defaults(&self) -> Map<String, Value> {
        let mut values = resolved(&self.least_text());
        values.retain(|name, value| {
            !value.is_null() && !self.least.iter().any(|(given, _)| given == name)
        });
        values
    }
}

/// Values in force in a scene; none if it cannot be read.
pub(super) fn resolved(text: &str) -> Map<String, Value> {
    match parse_scene("scene", text, &[]).map(|scene| scene.json()) {
        Ok(Value::Object(values)) => values,
        _ => Map::new(),
    }
}

/// Names of the keys that stand in a file.
pub(super) fn given(text: &str) -> Vec<String> {
    let entries = Entries::parse(text, &[]).map(|(entries, _)| entries.values);
    entries.unwrap_or_default().into_keys().collect()
}

impl Scene {
    /// What it is about: the value of the key `body`.
    pub fn body(&self) -> &'static str {
        match self {
            Self::Disk(_) => "disk",
            Self::Planar(scene) => match scene.body {
                PlanarBody::Cylinder(_) => "cylinder",
                PlanarBody::Pipe(_) => "pipe",
                PlanarBody::Curling(..) => "curling",
            },
            Self::Powder(_) => "powder",
            Self::Tip(_) => "tip",
        }
    }

    /// The scene with everything that was left to defaults, as JSON; null for what is off.
    pub fn json(&self) -> Value {
        match self {
            Self::Disk(scene) => scene.json(),
            Self::Planar(scene) => scene.json(),
            Self::Powder(scene) => scene.json(),
            Self::Tip(scene) => scene.json(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_scene_of_every_body_is_accepted_and_says_nothing_in_vain() {
        for body in bodies() {
            let known = vocabulary(body).unwrap();
            let scene = parse_scene(body, &known.least_text(), &[]);
            assert_eq!(scene.unwrap().body(), body);
            for (left_out, _) in known.least.iter().filter(|(key, _)| *key != "body") {
                let rest = known.least.iter().filter(|(key, _)| key != left_out);
                let text: String = rest
                    .map(|(key, value)| format!("{key}={value}\n"))
                    .collect();
                assert!(parse_scene(body, &text, &[]).is_err(), "{body}: {left_out}");
            }
        }
        assert_eq!(vocabulary("brick"), None);
    }

    #[test]
    fn defaults_are_those_of_the_reader() {
        let powder = vocabulary("powder").unwrap().defaults();
        assert_eq!(powder["capture_radius"].as_f64(), Some(3.0));
        assert_eq!(powder["coupling"], "independent");
        assert!(!powder.contains_key("duration") && !powder.contains_key("width"));
    }
}
