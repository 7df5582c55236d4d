//! What is wrong with a scene, in words for a person.

use crate::record::RecordError;
use std::fmt;
use std::path::PathBuf;

/// Where a value was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Line of the file, from 1.
    Line(usize),
    /// An override on the command line.
    Override,
    /// Nowhere: it is missing.
    File,
}

/// One thing that is wrong, and its cure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneProblem {
    /// Where the value was written.
    #[doc(hidden)]
    pub origin: Origin,
    /// What is wrong and what would be valid.
    #[doc(hidden)]
    pub message: String,
}

impl SceneProblem {
    /// A problem at a place.
    #[doc(hidden)]
    pub fn new(origin: Origin, message: impl Into<String>) -> Self {
        Self {
            origin,
            message: message.into(),
        }
    }

    /// What is wrong and what would be valid, without the place.
    pub fn message(&self) -> &str {
        &self.message
    }
}

/// Fields of a scene that no run could start from; the rules are those of scene files.
///
/// ```
/// use tribos::scene::PowderScene;
/// let pulled = PowderScene { pressure: -1.0, ..PowderScene::default() };
/// let refused = pulled.check().map_err(|error| error.to_string());
/// let told = "the powder scene cannot be run: `pressure` must be a finite number > 0, not -1";
/// assert_eq!(refused, Err(told.into()));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the {body} scene cannot be run: {}", .problems.iter().map(SceneProblem::message).collect::<Vec<_>>().join("; "))]
pub struct InvalidScene {
    /// The body of the scene.
    pub body: &'static str,
    /// Everything that is wrong: each names the key, its value and what would be valid.
    pub problems: Vec<SceneProblem>,
}

/// A scene that cannot be run.
///
/// ```
/// use tribos::scene::{SceneProblem, SceneError, Scene};
/// let text = "body = \"curling\"\nspeed = -2\nspinn = 1.5";
/// let Err(error) = Scene::parse("rock.toml", text, &[]) else { unreachable!() };
/// assert!(error.to_string().starts_with("rock.toml:2: `speed` must be a finite number >= 0"));
/// let SceneError::Invalid { problems, .. } = error else { unreachable!() };
/// let messages: Vec<&str> = problems.iter().map(SceneProblem::message).collect();
/// assert_eq!(messages.len(), 3); // all at once, and `spin` is missing
/// assert_eq!(messages[1], "unknown key `spinn`; did you mean `spin`?");
/// ```
#[derive(Debug)]
pub enum SceneError {
    /// The file cannot be read.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system said, or what is wrong with it.
        cause: RecordError,
    },
    /// The scene says something that makes no sense.
    Invalid {
        /// Name of the file.
        name: String,
        /// Everything that is wrong, in the order of the file.
        problems: Vec<SceneProblem>,
    },
}

impl SceneError {
    /// All that is wrong with the file `name`.
    #[doc(hidden)]
    pub fn invalid(name: &str, problems: Vec<SceneProblem>) -> Self {
        let name = name.to_owned();
        Self::Invalid { name, problems }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable { path, cause } => {
                write!(f, "cannot read the scene {}: {cause}", path.display())
            }
            Self::Invalid { name, problems } => {
                for (i, SceneProblem { origin, message }) in problems.iter().enumerate() {
                    let newline = if i > 0 { "\n" } else { "" };
                    match origin {
                        Origin::Line(line) => write!(f, "{newline}{name}:{line}: {message}")?,
                        Origin::Override => write!(f, "{newline}--set: {message}")?,
                        Origin::File => write!(f, "{newline}{name}: {message}")?,
                    }
                }
                Ok(())
            }
        }
    }
}

impl std::error::Error for SceneError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Unreadable { cause, .. } => Some(cause),
            Self::Invalid { .. } => None,
        }
    }
}
