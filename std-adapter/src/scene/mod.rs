//! What a user writes: a TOML file and overrides become a typed, validated scene.
//!
//! All refusals happen here, before any work, and all at once: each names the file and line (or
//! the override), what is wrong and what would be valid.

mod body;
mod curling;
mod entries;
mod hint;
mod in_force;
mod key;
mod library;
mod planar;
mod powder;
mod powder_keys;
mod problem;
mod schema;
mod slider;
mod template;
mod tip;
mod tip_keys;
mod vocabulary;

pub use body::{Scene, parse_scene, read_scene};
pub use hint::{nearest, number_hint};
pub use key::{Domain, Key};
pub use library::{LIBRARY, LibraryScene, library_scene};
pub use planar::{PlanarBody, PlanarScene, Tipping};
pub use powder::{Coupling, Criterion, PowderScene, WallLaw};
pub use problem::{Problem, SceneError};
pub use schema::schema;
pub use slider::{SliderScene, Stepper, Units};
pub use template::{template, toml_value, with_all_keys};
pub use tip::{Bath, Lift, Reading, TipScene};
pub use vocabulary::{Vocabulary, bodies, vocabulary};

use crate::record::read_text;
use entries::Entries;
use std::path::Path;

/// Bytes of a scene file at most; those of this crate have a thousand.
///
/// ```
/// use tribos::scene::{LIBRARY, MOST_BYTES};
/// assert!(LIBRARY.iter().all(|scene| 1000 * (scene.text.len() as u64) < MOST_BYTES));
/// ```
pub const MOST_BYTES: u64 = 16 << 20;

/// Reads the scene in `path` with `overrides` of the form `key=value` put over it.
///
/// ```
/// use std::path::Path;
/// use tribos::{scene::read_slider, slide::run};
/// // Spin lengthens the way: 17 cm without.
/// let ways = ["spin=0", "spin=50"].map(|spin| {
///     let scene = read_slider(Path::new("../scenes/disk.toml"), &[spin.into()])?;
///     Ok::<_, Box<dyn std::error::Error>>(run(&scene, |_| ())?.outcome.distance)
/// });
/// let [slid, spun] = ways;
/// assert!((slid? - 0.170).abs() < 1e-3 && spun? > 3.0 * 0.170);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_slider(path: &Path, overrides: &[String]) -> Result<SliderScene, SceneError> {
    parse_slider(&path.display().to_string(), &text_of(path)?, overrides)
}

fn text_of(path: &Path) -> Result<String, SceneError> {
    read_text(path, MOST_BYTES).map_err(|cause| SceneError::Unreadable {
        path: path.to_path_buf(),
        cause,
    })
}

/// As [`read_slider`], from text; `name` stands for the file in messages.
///
/// ```
/// use tribos::scene::{SceneError, parse_slider};
/// let text = "speed = 1.0\nspin = 5.0\ncoefficient = 0.3\nalpha = 0\ngravity = 9.81\n\
///             radius = 0.08\nmass = 0.1\ninertia_ratio = 0.5";
/// assert_eq!(parse_slider("disk.toml", text, &["spin=-5".into()])?.spin, -5.0); // clockwise
/// let pipe = parse_slider("disk.toml", text, &["body=pipe".into()]);
/// assert!(matches!(pipe, Err(SceneError::Invalid { problems, .. }) if problems.len() == 1));
/// # Ok::<(), SceneError>(())
/// ```
pub fn parse_slider(
    name: &str,
    text: &str,
    overrides: &[String],
) -> Result<SliderScene, SceneError> {
    Entries::parse(text, overrides)
        .and_then(|(entries, problems)| SliderScene::from_entries(entries, problems))
        .map_err(|problems| SceneError::Invalid {
            name: name.to_owned(),
            problems,
        })
}
