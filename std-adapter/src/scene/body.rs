//! The one list of bodies, and scenes of any of them.

use super::entries::{Entries, Written};
use super::key::{Domain, Key};
use super::problem::{Origin, SceneProblem};
use super::table::Table;
use super::vocabulary::Vocabulary;
use super::words::meant;
use super::{Body, DEFAULT_BODY, GasScene, GrainsScene, PowderScene, SceneError, TipScene};
use crate::gas::GasSummary;
use crate::golden::MeasureError;
use crate::grains::GrainsSummary;
use crate::motion::{MotionScene, measured_motion, scene::*};
use crate::powder::PowderSummary;
use crate::slide::{PlanarSummary, SlideSummary};
use crate::stick::{
    clamp::ClampSummary, incline::InclineSummary, spring::SpringSummary,
    turntable::TurntableSummary,
};
use crate::tip::TipSummary;
use serde_json::Value;
use std::path::Path;
use tribos_base::golden::{Measure, Measurement, values};

/// A scene by what runs it.
#[doc(hidden)]
#[derive(Clone, Copy)]
#[allow(
    missing_debug_implementations,
    reason = "a view of a scene, which has one"
)]
pub enum RunBy<'a> {
    /// At once.
    Motion(&'a dyn MotionScene),
    Powder(&'a PowderScene),
    Grains(&'a GrainsScene),
    Gas(&'a GasScene),
    Tip(&'a TipScene),
}

/// A scene of a body in motion as such, any other as what it is.
macro_rules! run_by {
    ($variant:ident, $scene:ident, motion) => {
        RunBy::Motion($scene)
    };
    ($variant:ident, $scene:ident,) => {
        RunBy::$variant($scene)
    };
}

/// Declares the bodies: the enum of their scenes, and what is the same for all of them. The scene of a body in
/// motion is called so.
macro_rules! bodies {
    ($($(#[$doc:meta])+ $variant:ident($scene:ident $(in $motion:ident)?) -> $summary:ty),+ $(,)?) => {
        /// A validated scene of any body.
        #[derive(Clone, Debug, PartialEq)]
        #[allow(clippy::large_enum_variant, reason = "a run has one scene")]
        pub enum Scene {
            $($(#[$doc])+ $variant($scene)),+
        }

        /// What each body's scenes may say, the default body first.
        pub(super) const VOCABULARIES: &[Vocabulary] = &[$(Vocabulary::of::<$scene, $summary>()),+];

        impl Scene {
            /// The scene as one of any body.
            pub fn as_body(&self) -> &dyn Body {
                match self {
                    $(Self::$variant(scene) => scene),+
                }
            }

            /// What runs it.
            #[doc(hidden)]
            pub fn run_by(&self) -> RunBy<'_> {
                match self {
                    $(Self::$variant(scene) => run_by!($variant, scene, $($motion)?)),+
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
            /// use tribos::scene::{LIBRARY, Scene};
            /// let disk = &LIBRARY[0];
            /// let scene = Scene::parse(disk.name, disk.text, &[])?;
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

            /// Keys of its body, and what they say in the default scene.
            fn vocabulary(&self) -> (&'static [Key], Value) {
                match self {
                    $(Self::$variant(_) => (<$scene>::KEYS, <$scene>::default().json())),+
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

        /// The scenes of all bodies.
        pub mod scenes {
            pub use super::super::{$($scene),+};
        }

        /// Every body's default scene.
        #[cfg(test)]
        pub(super) fn defaults() -> Vec<Scene> {
            vec![$($scene::default().into()),+]
        }
    };
}

bodies! {
    /// A flat, round body: its path is straight.
    Disk(DiskScene in motion) -> SlideSummary,
    /// A tall cylinder along a path in the plane.
    Cylinder(CylinderScene in motion) -> PlanarSummary,
    /// A pipe on its end along a path in the plane.
    Pipe(PipeScene in motion) -> PlanarSummary,
    /// A flat plate of any outline along a path in the plane.
    Plate(PlateScene in motion) -> PlanarSummary,
    /// A curling rock.
    Curling(CurlingScene in motion) -> PlanarSummary,
    /// A body on a spring.
    Spring(SpringScene in motion) -> SpringSummary,
    /// A block on an incline.
    Incline(InclineScene in motion) -> InclineSummary,
    /// A body on a turntable.
    Turntable(TurntableScene in motion) -> TurntableSummary,
    /// A body in a pinch.
    Clamp(ClampScene in motion) -> ClampSummary,
    /// A powder under a piston.
    Powder(PowderScene) -> PowderSummary,
    /// Grains in a box.
    Grains(GrainsScene) -> GrainsSummary,
    /// A gas of spheres that cools.
    Gas(GasScene) -> GasSummary,
    /// A tip turned on a substrate.
    Tip(TipScene) -> TipSummary,
}

impl Scene {
    /// Runs the scene to its end for a golden file; `watch` is called after every step.
    pub(crate) fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, MeasureError> {
        let measured = match self.run_by() {
            RunBy::Motion(scene) => measured_motion(scene, watch)?,
            RunBy::Powder(scene) => scene.measured(watch)?,
            RunBy::Grains(scene) => scene.measured(watch)?,
            RunBy::Gas(scene) => scene.measured(watch)?,
            RunBy::Tip(scene) => scene.measured(watch)?,
        };
        let (keys, defaults) = self.vocabulary();
        Ok(Measurement {
            keys,
            defaults: values(&defaults),
            ..measured
        })
    }
}

/// The key that every vocabulary has, with the bodies that there are.
pub(super) const BODY: Key = Key {
    domain: Domain::OneOf(BODIES),
    ..tribos_base::scene::BODY
};

impl Scene {
    /// Reads the scene in `path` with `overrides` of the form `key=value` put over it.
    ///
    /// ```
    /// use std::path::Path;
    /// use tribos::scene::{Scene, SceneError};
    /// let scene = Scene::read(Path::new("../scenes/disk.toml"), &["speed=2".into()])?;
    /// assert!(matches!(scene, Scene::Disk(disk) if disk.speed == 2.0)); // m/s
    /// let nowhere = Scene::read(Path::new("nowhere.toml"), &[]);
    /// assert!(matches!(nowhere, Err(SceneError::Unreadable { .. })));
    /// # Ok::<(), SceneError>(())
    /// ```
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, SceneError> {
        let text = crate::record::read_text(path, super::MOST_BYTES).map_err(|cause| {
            SceneError::Unreadable {
                path: path.to_path_buf(),
                cause,
            }
        })?;
        Self::parse(&path.display().to_string(), &text, overrides)
    }

    /// Reads a scene from text; `name` stands for the file in messages.
    ///
    /// ```
    /// use tribos::scene::Scene;
    /// let text = "body = \"pipe\"\nspeed = 1.74\nspin = 10.2\ngamma = 0.2\ngravity = 9.81\n\
    ///             radius = 0.05\ninner_radius = 0.046\nheight = 0.15\nmass = 0.5";
    /// let scene = Scene::parse("pipe.toml", text, &[])?;
    /// assert!(matches!(scene, Scene::Pipe(pipe) if pipe.inner_radius == 0.046)); // m
    /// # Ok::<(), tribos::scene::SceneError>(())
    /// ```
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, SceneError> {
        Entries::parse(text, overrides)
            .and_then(|(entries, problems)| Self::of_entries(&entries, problems))
            .map_err(|problems| SceneError::invalid(name, problems))
    }

    fn of_entries(
        entries: &Entries,
        problems: Vec<SceneProblem>,
    ) -> Result<Self, Vec<SceneProblem>> {
        let (body, origin) = match entries.values.get(BODY.name) {
            None => (DEFAULT_BODY, Origin::File),
            Some((Written::Text(text), origin)) => (text.as_str(), *origin),
            Some((other, origin)) => {
                return Err(refusal(&format!("not {}", other.kind()), *origin, problems));
            }
        };
        Self::of(body, entries, problems.clone()).unwrap_or_else(|| {
            let given = format!("got \"{body}\"{}", meant(body, BODIES));
            Err(refusal(&given, origin, problems))
        })
    }
}

/// Without a body nothing else can be judged.
fn refusal(given: &str, origin: Origin, mut problems: Vec<SceneProblem>) -> Vec<SceneProblem> {
    let domain = BODY.domain.describe();
    let message = format!("`body` must be {domain}, {given}");
    problems.push(SceneProblem::new(origin, message));
    problems
}
