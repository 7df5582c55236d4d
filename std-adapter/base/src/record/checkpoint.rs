//! The common format of checkpoints: JSON, in which a list of numbers is a text of 16 hexadecimal
//! digits per number, the bits of each f64.

use super::seal::verified;
use crate::scene::table::Table;
use nalgebra::Vector3;
use serde_json::{Map, Value};

/// Hexadecimal digits of an f64.
const DIGITS: usize = 16;

/// A checkpoint from which a run cannot resume.
///
/// ```
/// use tribos::{powder::PowderSimulation, run::PackingRunError};
/// use tribos::record::CheckpointError;
/// use tribos::scene::PowderScene;
/// let light = PowderScene { width: 6.0, height: 8.0, pressure: 0.01, ..PowderScene::default() };
/// let heavy = PowderScene { pressure: 0.02, ..light.clone() };
/// let kept = PowderSimulation::new(&light)?.checkpoint();
/// let refused = PowderSimulation::resume(&heavy, &kept);
/// assert!(matches!(
///     refused,
///     Err(PackingRunError::Checkpoint(CheckpointError::Scene { key, .. })) if key == "pressure"
/// ));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CheckpointError {
    /// The text is damaged, or not a checkpoint.
    #[error("the checkpoint is damaged ({0}); start anew with --anew")]
    Format(String),
    /// The format is not supported by this version.
    #[error(
        "the checkpoint has format {found}, and this version reads format {read} only; \
         finish the run with the version that wrote it, or start anew with --anew"
    )]
    Version {
        /// Format of the checkpoint.
        found: u64,
        /// Supported format.
        read: u64,
    },
    /// The checkpoint belongs to another scene.
    #[error(
        "the checkpoint belongs to another scene: `{key}` is {kept} there and {given} here; \
         change it back, or start anew with --anew"
    )]
    Scene {
        /// The first key that differs.
        key: String,
        /// Value in the checkpoint.
        kept: String,
        /// Value in the scene.
        given: String,
    },
}

/// The object in the text of a checkpoint of a scene with these values; its first key is `name`, with its format as the
/// value.
#[doc(hidden)]
pub fn opened<T: Table>(
    text: &str,
    (name, format): (&str, u64),
    scene: &Value,
) -> Result<Value, CheckpointError> {
    let version = |found| CheckpointError::Version {
        found,
        read: format,
    };
    let Some(value) = verified(text) else {
        // Format 1 had no digest.
        let is_first = text.starts_with(&format!("{{\"{name}\":1,"));
        return Err(if is_first && !text.contains("\"digest\"") {
            version(1)
        } else {
            CheckpointError::Format("its digest is not that of its bytes".into())
        });
    };
    match value[name].as_u64() {
        Some(found) if found == format => {
            same_scene(&T::present(&value["scene"]), scene)?;
            Ok(value)
        }
        Some(found) => Err(version(found)),
        None => Err(of_other_body(&value, &scene["body"])
            .unwrap_or_else(|| CheckpointError::Format(format!("there is no `{name}`")))),
    }
}

/// The error for a whole checkpoint of a body that is not the given one.
#[doc(hidden)]
pub fn of_other_body(value: &Value, given: &Value) -> Option<CheckpointError> {
    let kept = &value["scene"]["body"];
    (kept.is_string() && kept != given).then(|| CheckpointError::Scene {
        key: "body".into(),
        kept: kept.to_string(),
        given: given.to_string(),
    })
}

/// The error for an invalid part.
#[doc(hidden)]
pub fn damaged(name: &str) -> CheckpointError {
    CheckpointError::Format(format!("`{name}` cannot be read"))
}

/// Refuses the first key that differs.
fn same_scene(kept: &Value, given: &Value) -> Result<(), CheckpointError> {
    let empty = Map::new();
    let [kept, given] = [kept, given].map(|scene| scene.as_object().unwrap_or(&empty));
    for key in given.keys().chain(kept.keys()) {
        if kept.get(key) != given.get(key) {
            let told = |scene: &Map<String, Value>| {
                scene.get(key).map_or("missing".into(), Value::to_string)
            };
            return Err(CheckpointError::Scene {
                key: key.clone(),
                kept: told(kept),
                given: told(given),
            });
        }
    }
    Ok(())
}

/// Numbers as their bits.
#[doc(hidden)]
pub fn hex(numbers: &[f64]) -> String {
    let mut text = String::with_capacity(DIGITS * numbers.len());
    for number in numbers {
        text += &format!("{:016x}", number.to_bits());
    }
    text
}

/// The numbers of a part.
#[doc(hidden)]
pub fn numbers(value: &Value, name: &str) -> Result<Vec<f64>, CheckpointError> {
    let text = value[name].as_str().ok_or_else(|| damaged(name))?;
    let (digits, rest) = text.as_bytes().as_chunks::<DIGITS>();
    let number = |digits: &[u8; DIGITS]| {
        let digits = std::str::from_utf8(digits).ok()?;
        Some(f64::from_bits(u64::from_str_radix(digits, 16).ok()?))
    };
    let numbers: Option<Vec<f64>> = digits.iter().map(number).collect();
    numbers
        .filter(|_| rest.is_empty())
        .ok_or_else(|| damaged(name))
}

/// The coordinates.
#[doc(hidden)]
pub fn triple(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z]
}

/// The numbers of a part in groups of `N`, without remainder.
#[doc(hidden)]
pub fn groups<const N: usize>(value: &Value, name: &str) -> Result<Vec<[f64; N]>, CheckpointError> {
    match numbers(value, name)?.as_chunks() {
        (groups, []) => Ok(groups.to_vec()),
        _ => Err(damaged(name)),
    }
}

/// The only number of a part.
#[doc(hidden)]
pub fn one(value: &Value, name: &str) -> Result<f64, CheckpointError> {
    match numbers(value, name)?[..] {
        [number] => Ok(number),
        _ => Err(damaged(name)),
    }
}

/// Vectors from consecutive coordinates; a remainder is ignored.
#[doc(hidden)]
pub fn vectors(numbers: &[f64]) -> Vec<Vector3<f64>> {
    let triples = numbers.as_chunks().0.iter();
    triples.map(|&[x, y, z]| Vector3::new(x, y, z)).collect()
}

/// The vectors of a part, without remainder.
#[doc(hidden)]
pub fn places(value: &Value, name: &str) -> Result<Vec<Vector3<f64>>, CheckpointError> {
    let triples = groups::<3>(value, name)?;
    Ok(triples.into_iter().map(Vector3::from).collect())
}
