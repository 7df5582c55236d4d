//! The one list of bodies, and scenes of any of them.

use super::entries::{Entries, Written};
use super::key::{Domain, Key};
use super::problem::{Origin, SceneProblem};
use super::table::Table;
use super::vocabulary::Vocabulary;
use super::words::meant;
use super::{
    Body, ClampScene, CurlingScene, CylinderScene, DEFAULT_BODY, DiskScene, GasScene, GrainsScene,
    InclineScene, PipeScene, PlateScene, PowderScene, SceneError, SpringScene, TipScene,
    TurntableScene,
};
use crate::gas::GasSummary;
use crate::golden::MeasureError;
use crate::results::Summary;
use crate::slide::{PlanarSummary, SlideSummary};
use crate::stick::{
    clamp::ClampSummary, incline::InclineSummary, spring::SpringSummary,
    turntable::TurntableSummary,
};
use crate::tip::TipSummary;
use serde_json::Value;
use std::path::Path;
use tribos_base::golden::{Measure, Measurement};

/// Declares the bodies: the enum of their scenes, and what is the same for all of them.
macro_rules! bodies {
    ($($(#[$doc:meta])+ $variant:ident($scene:ty) $(-> $summary:ty)?),+ $(,)?) => {
        /// A validated scene of any body.
        #[derive(Clone, Debug, PartialEq)]
        #[allow(clippy::large_enum_variant, reason = "a run has one scene")]
        pub enum Scene {
            $($(#[$doc])+ $variant($scene)),+
        }

        /// What each body's scenes may say, the default body first.
        pub(super) const VOCABULARIES: &[Vocabulary] = &[$(Vocabulary {
            $(results: <$summary as Summary>::QUANTITIES,)?
            ..Vocabulary::of::<$scene>()
        }),+];

        impl Scene {
            /// The scene as one of any body.
            pub fn as_body(&self) -> &dyn Body {
                match self {
                    $(Self::$variant(scene) => scene),+
                }
            }

            /// What it is about: the value of the key `body`.
            pub fn body(&self) -> &'static str {
                self.as_body().body()
            }

            /// Keys and values in force, defaults included; null for what is off.
            pub fn json(&self) -> Value {
                self.as_body().json()
            }

            /// A scene with these [values in force](Self::json), as summaries of runs have them; `None` if no
            /// scene has them. Values that followed from others are given ones in it.
            ///
            /// ```
            /// use tribos::scene::{LIBRARY, Scene, parse_scene};
            /// let disk = &LIBRARY[0];
            /// let scene = parse_scene(disk.name, disk.text, &[])?;
            /// let again = Scene::of_json(&scene.json()).expect("the values are a scene's");
            /// assert_eq!(again.json(), scene.json());
            /// # Ok::<(), tribos::scene::SceneError>(())
            /// ```
            pub fn of_json(values: &Value) -> Option<Self> {
                let body = values.get(BODY.name).map_or(Some(DEFAULT_BODY), Value::as_str)?;
                $(if body == <$scene>::BODY {
                    return <$scene>::of_values(values).map(Self::$variant);
                })+
                None
            }

            /// Runs the scene to its end for a golden file; `watch` is called after every step.
            pub(crate) fn measured(
                &self,
                watch: &mut dyn FnMut(),
            ) -> Result<Measurement, MeasureError> {
                match self {
                    $(Self::$variant(scene) => Ok(Measurement {
                        keys: <$scene>::KEYS,
                        ..scene.measured(watch)?
                    })),+
                }
            }

            /// The scene of a body's entries.
            fn of(
                body: &str,
                entries: &Entries,
                problems: Vec<SceneProblem>,
            ) -> Option<Result<Self, Vec<SceneProblem>>> {
                $(if body == <$scene>::BODY {
                    return Some(<$scene>::from_entries(entries, problems).map(Self::$variant));
                })+
                None
            }
        }

        $(impl From<$scene> for Scene {
            fn from(scene: $scene) -> Self {
                Self::$variant(scene)
            }
        })+

        const BODIES: &[&str] = &[$(<$scene>::BODY),+];
    };
}

bodies! {
    /// A flat, round body: its path is straight.
    Disk(DiskScene) -> SlideSummary,
    /// A tall cylinder along a path in the plane.
    Cylinder(CylinderScene) -> PlanarSummary,
    /// A pipe on its end along a path in the plane.
    Pipe(PipeScene) -> PlanarSummary,
    /// A flat plate of any outline along a path in the plane.
    Plate(PlateScene) -> PlanarSummary,
    /// A curling rock.
    Curling(CurlingScene) -> PlanarSummary,
    /// A body on a spring.
    Spring(SpringScene) -> SpringSummary,
    /// A block on an incline.
    Incline(InclineScene) -> InclineSummary,
    /// A body on a turntable.
    Turntable(TurntableScene) -> TurntableSummary,
    /// A body in a pinch.
    Clamp(ClampScene) -> ClampSummary,
    /// A powder under a piston.
    Powder(PowderScene),
    /// Grains in a box.
    Grains(GrainsScene),
    /// A gas of spheres that cools.
    Gas(GasScene) -> GasSummary,
    /// A tip turned on a substrate.
    Tip(TipScene) -> TipSummary,
}

/// The key that every vocabulary has, with the bodies that there are.
pub(super) const BODY: Key = Key {
    domain: Domain::OneOf(BODIES),
    ..tribos_base::scene::BODY
};

/// Reads the scene in `path` with `overrides` of the form `key=value` put over it.
///
/// ```
/// use std::path::Path;
/// use tribos::scene::{Scene, SceneError, read_scene};
/// let scene = read_scene(Path::new("../scenes/disk.toml"), &["speed=2".into()])?;
/// assert!(matches!(scene, Scene::Disk(disk) if disk.speed == 2.0)); // m/s
/// let nowhere = read_scene(Path::new("nowhere.toml"), &[]);
/// assert!(matches!(nowhere, Err(SceneError::Unreadable { .. })));
/// # Ok::<(), SceneError>(())
/// ```
pub fn read_scene(path: &Path, overrides: &[String]) -> Result<Scene, SceneError> {
    let text = crate::record::read_text(path, super::MOST_BYTES).map_err(|cause| {
        SceneError::Unreadable {
            path: path.to_path_buf(),
            cause,
        }
    })?;
    parse_scene(&path.display().to_string(), &text, overrides)
}

/// Reads a scene from text; `name` stands for the file in messages.
///
/// ```
/// use tribos::scene::{Scene, parse_scene};
/// let text = "body = \"pipe\"\nspeed = 1.74\nspin = 10.2\ngamma = 0.2\ngravity = 9.81\n\
///             radius = 0.05\ninner_radius = 0.046\nheight = 0.15\nmass = 0.5";
/// let scene = parse_scene("pipe.toml", text, &[])?;
/// assert!(matches!(scene, Scene::Pipe(pipe) if pipe.inner_radius == 0.046)); // m
/// # Ok::<(), tribos::scene::SceneError>(())
/// ```
pub fn parse_scene(name: &str, text: &str, overrides: &[String]) -> Result<Scene, SceneError> {
    Entries::parse(text, overrides)
        .and_then(|(entries, problems)| read(&entries, problems))
        .map_err(|problems| SceneError::invalid(name, problems))
}

fn read(entries: &Entries, problems: Vec<SceneProblem>) -> Result<Scene, Vec<SceneProblem>> {
    let (body, origin) = match entries.values.get(BODY.name) {
        None => (DEFAULT_BODY, Origin::File),
        Some((Written::Text(text), origin)) => (text.as_str(), *origin),
        Some((other, origin)) => {
            return Err(refusal(&format!("not {}", other.kind()), *origin, problems));
        }
    };
    Scene::of(body, entries, problems.clone()).unwrap_or_else(|| {
        let given = format!("got \"{body}\"{}", meant(body, BODIES));
        Err(refusal(&given, origin, problems))
    })
}

/// Without a body nothing else can be judged.
fn refusal(given: &str, origin: Origin, mut problems: Vec<SceneProblem>) -> Vec<SceneProblem> {
    let domain = BODY.domain.describe();
    let message = format!("`body` must be {domain}, {given}");
    problems.push(SceneProblem::new(origin, message));
    problems
}
