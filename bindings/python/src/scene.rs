//! Scenes: the library's tables of their keys, and scenes between text and values.

use crate::arrays::refused;
use pyo3::exceptions::{PyDeprecationWarning, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde_json::Value;
use std::ffi::CString;
use std::path::PathBuf;
use tribos::scene::{
    Domain, Key, LIBRARY, Need, Scene, SceneError, Vocabulary, bodies, earlier_names, vocabulary,
};

/// What every body's scenes may say: a dictionary a body, with its keys.
#[pyfunction]
pub fn vocabularies(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let all = PyList::empty(py);
    for known in bodies().filter_map(vocabulary) {
        let body = PyDict::new(py);
        body.set_item("body", known.body)?;
        body.set_item("title", known.title)?;
        let example = Scene::parse(known.body, &known.least_text(), &[]).map_err(refused)?;
        let (values, defaults) = (example.json(), known.defaults());
        let keys = PyList::empty(py);
        for key in known.keys.iter().filter(|key| key.name != "body") {
            let row = PyDict::new(py);
            row.set_item("name", key.name)?;
            row.set_item("was", key.was)?;
            row.set_item("unit", key.unit)?;
            row.set_item("meaning", key.meaning)?;
            row.set_item("values", key.domain.describe())?;
            let (kind, words) = match key.domain {
                Domain::Count { .. } => ("count", &[][..]),
                Domain::OneOf(words) => ("word", words),
                Domain::Form(form) if form.numbers.is_some() => ("ramp", &[][..]),
                Domain::Form(_) | Domain::Path => ("text", &[][..]),
                _ => ("number", &[][..]),
            };
            row.set_item("kind", kind)?;
            row.set_item("words", words)?;
            let (unless, unit_with) = match key.need {
                Need::UnlessGiven(other) => (Some(vec![other]), None),
                Need::UnlessEither(one, two) => (Some(vec![one, two]), None),
                Need::UnitWith(other, word) => (None, Some((other, word))),
                _ => (None, None),
            };
            row.set_item("needed", is_needed(key.need))?;
            row.set_item("unless", unless)?;
            row.set_item("unit_with", unit_with)?;
            let default = defaults.get(key.name).unwrap_or(&values[key.name]);
            let default = match is_chosen(&known, key, default) {
                true => &Value::Null,
                false => default,
            };
            row.set_item("default", python(py, default)?)?;
            keys.append(row)?;
        }
        body.set_item("keys", keys)?;
        all.append(body)?;
    }
    Ok(all)
}

/// Whether a file has to give the key, or one in place of it.
fn is_needed(need: Need) -> bool {
    matches!(
        need,
        Need::Required | Need::UnlessGiven(_) | Need::UnlessEither(..) | Need::UnitWith(..)
    )
}

/// Whether the value that holds where the key is left out follows from other keys.
fn is_chosen(known: &Vocabulary, key: &Key, default: &Value) -> bool {
    let settings = known.keys.iter().flat_map(|other| match other.domain {
        Domain::OneOf(words) if other.name != "body" => words
            .iter()
            .map(|word| format!("{}={word}", other.name))
            .collect(),
        _ => Vec::new(),
    });
    let values = |setting| Scene::parse("", &known.least_text(), &[setting]).ok();
    let mut held = settings.filter_map(values).map(|scene| scene.json());
    !is_needed(key.need)
        && held.any(|values| {
            let value = values.get(key.name).unwrap_or(&Value::Null);
            !value.is_null() && value != default && key.name != "body"
        })
        && !matches!(key.domain, Domain::OneOf(_))
}

/// The scenes that come with the program: names, texts and what they show.
#[pyfunction]
pub fn library_scenes() -> Vec<(&'static str, &'static str, &'static str)> {
    let scenes = LIBRARY.iter();
    scenes
        .map(|scene| (scene.name, scene.text, scene.summary()))
        .collect()
}

/// Body and values in force of a scene file's text, with overrides of the form `key=value`; `name` stands for the
/// file in refusals.
#[pyfunction]
pub fn scene_of_text(
    py: Python<'_>,
    name: &str,
    text: &str,
    overrides: Vec<String>,
) -> PyResult<(&'static str, Py<PyAny>)> {
    let scene = parse(name, text, &overrides)?;
    warn_of_earlier_names(py, &scene, text, &overrides)?;
    shown(py, &scene)
}

/// The same of a file.
#[pyfunction]
pub fn scene_of_file(
    py: Python<'_>,
    path: PathBuf,
    overrides: Vec<String>,
) -> PyResult<(&'static str, Py<PyAny>)> {
    let scene = Scene::read(&path, &overrides).map_err(|error| match error {
        SceneError::Unreadable { .. } => PyOSError::new_err(error.to_string()),
        SceneError::Invalid { .. } => plain(error),
    })?;
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    warn_of_earlier_names(py, &scene, &text, &overrides)?;
    shown(py, &scene)
}

/// The values in force of settings of a body; refusals name the class in place of a file.
#[pyfunction]
pub fn scene_of_settings(
    py: Python<'_>,
    name: &str,
    body: &str,
    settings: Vec<String>,
) -> PyResult<Py<PyAny>> {
    let text = format!("body = \"{body}\"\n");
    match Scene::parse(name, &text, &settings) {
        Ok(scene) => Ok(shown(py, &scene)?.1),
        Err(SceneError::Invalid { problems, .. }) => {
            let all = problems.iter().map(|problem| problem.message());
            let list: Vec<String> = all.map(|message| format!("{name}: {message}")).collect();
            Err(PyValueError::new_err(list.join("\n")))
        }
        Err(error) => Err(refused(error)),
    }
}

/// A scene of a text, with the library's refusal.
pub fn parse(name: &str, text: &str, overrides: &[String]) -> PyResult<Scene> {
    Scene::parse(name, text, overrides).map_err(plain)
}

/// A refusal in which overrides are not options of a command.
fn plain(error: SceneError) -> PyErr {
    PyValueError::new_err(error.to_string().replace("--set: ", "override: "))
}

/// Warns the caller's caller of keys that are given by names of earlier versions.
fn warn_of_earlier_names(
    py: Python<'_>,
    scene: &Scene,
    text: &str,
    overrides: &[String],
) -> PyResult<()> {
    let category = py.get_type::<PyDeprecationWarning>();
    for [was, now] in earlier_names(scene.as_body().keys(), text, overrides) {
        let message = CString::new(format!("`{was}` is called `{now}` now"))?;
        PyErr::warn(py, &category, &message, 2)?;
    }
    Ok(())
}

fn shown(py: Python<'_>, scene: &Scene) -> PyResult<(&'static str, Py<PyAny>)> {
    Ok((scene.body(), python(py, &scene.json())?.unbind()))
}

/// JSON as Python's values.
pub fn python<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    let json = py.import("json")?;
    json.call_method1("loads", (value.to_string(),))
}
