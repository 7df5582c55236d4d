//! The scene of a curling rock and the models of its ice.

use super::planar::{STOP_FRACTION, Tipping, moves};
use crate::slide::curling::{
    BackHeavy, CurlingModel, CurlingRock, Dry, Film, FrontBack, IceLaw, LeftRight, PivotSlide,
    RING_POINTS, ScratchGuide,
};
use crate::slide::planar::Resistance;
use crate::slide::{MotionError, PlanarCourse, PlanarScene, of_law};
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain::*, MOST_SAMPLES, Need::*};
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::table::scene;
use tribos_base::scene::words::{Word, words};
use tribos_friction::{Evaluation, Law};

/// Answers to the question why a rock curls; each is a type in [`crate::slide::curling`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IceModel {
    /// [`LeftRight`]
    LeftRight,
    /// [`Dry`]
    Dry,
    /// [`FrontBack`]
    FrontBack,
    /// [`BackHeavy`]
    BackHeavy,
    /// [`Film`]
    Film,
    /// [`PivotSlide`]
    PivotSlide,
    /// [`ScratchGuide`]
    ScratchGuide,
}
words!(IceModel {
    LeftRight = "left-right",
    Dry = "dry",
    FrontBack = "front-back",
    BackHeavy = "back-heavy",
    Film = "film",
    PivotSlide = "pivot-slide",
    ScratchGuide = "scratch-guide",
});

/// A rock by the rules.
const ROCK: CurlingRock = CurlingRock::STANDARD;

scene! {
    /// A curling rock on ice, under a model to choose from.
    ///
    /// The default is a rock by the rules at 2 m/s and 1.5 rad/s.
    ///
    /// ```
    /// use tribos::scene::{CurlingScene, IceModel};
    /// let model = IceModel::ScratchGuide;
    /// let draw = CurlingScene { model, speed: 1.9866, ..CurlingScene::default() };
    /// let end = draw.run()?.outcome;
    /// assert!(end.x > 28.3 && end.curl > 0.9); // m, left
    /// # Ok::<(), tribos::slide::MotionError>(())
    /// ```
    #[derive(Copy)]
    pub struct CurlingScene = "curling", "A curling rock",
        rules, in_force;

    /// Initial speed, along x.
    speed: f64 = 2.0, "m/s", NotNegative, Required;
    /// Initial spin, > 0 counterclockwise.
    spin: f64 = 1.5, "rad/s", Finite, Required;
    /// Outer radius of the running band.
    radius: f64 = ROCK.band_radius, "m", Positive;
    /// Width of the band, 0 for a thin ring.
    band_width: f64 = ROCK.band_width, "m", NotNegative;
    /// Height of the centre of mass.
    centre_height: f64 = ROCK.height, "m", NotNegative;
    /// Inertia ratio C = I/(M R^2) with R of the band; the default is that of a solid of 29 cm.
    inertia_ratio: f64 = ROCK.inertia_ratio, "-", Positive;
    /// Acceleration that presses the rock down.
    gravity: f64 = ROCK.gravity, "m/s^2", Positive;
    /// Mass of the rock.
    mass: f64 = 20.0, "kg", Positive;
    /// Why the rock curls; see docs/curling.md.
    model: IceModel = IceModel::LeftRight, "-", OneOf(IceModel::WORDS);
    /// Friction coefficient of the ice; if left out that of the model: 0.007095 for dry, else 0.008.
    gamma was coefficient: Option<f64> = None, "(s/m)^alpha", Positive;
    /// Exponent of the ice; if left out that of the model: 0 for dry, else -0.5.
    // A rock comes to rest.
    alpha: Option<f64> = None, "-", Between { above: -1.0, up_to: 0.9 };
    /// Friction at the back over that in front, of the model back-heavy.
    // Penner's lower bound of the ratio that a curl of 1 m would need.
    back_to_front: f64 = 10.0, "-", Positive, PartOf("model", "back-heavy");
    /// Fraction of the band's rotation that the film takes in front, of the model film.
    film_front: f64 = 1.0, "-", Fraction, PartOf("model", "film");
    /// Fraction of the band's rotation that the film takes at the back, of the model film.
    film_back: f64 = 0.0, "-", Fraction, PartOf("model", "film");
    /// Weight of the pull, of the model pivot-slide.
    pivot_weight was pivot: f64 = PivotSlide::WEIGHT, "-", NotNegative, PartOf("model", "pivot-slide");
    /// Guiding force over load, of the model scratch-guide.
    scratch_strength was scratch: f64 = ScratchGuide::STRENGTH, "-", NotNegative, PartOf("model", "scratch-guide");
    /// Half the crossing angle from which scratches guide, of the model scratch-guide.
    scratch_onset_angle was scratch_onset: f64 = ScratchGuide::ONSET, "rad", Positive, PartOf("model", "scratch-guide");
    /// Number of intervals of time in the series.
    samples: u32 = 200, "-", Count { from: 1.0, up_to: MOST_SAMPLES };
}

fn rules(scene: &CurlingScene, judge: &mut SceneDiagnostics<'_>) {
    moves(scene.speed, scene.spin, judge);
    if scene.band_width > scene.radius {
        let message = format!("`band_width` must not exceed `radius`, {}", scene.radius);
        judge.refuse(&["band_width", "radius"], message);
    }
    if scene.model == IceModel::Dry && scene.alpha.is_some_and(|alpha| alpha != 0.0) {
        let message = "`alpha` is 0 for model \"dry\"; leave it out, or use \"front-back\"";
        judge.refuse(&["alpha", "model"], message);
    }
}

/// Coefficient and exponent are those of the model unless they are given.
fn in_force(scene: &CurlingScene, key: &str, written: Option<Written>) -> Option<Written> {
    match key {
        "gamma" => Some(Written::Number(scene.ice().coefficient)),
        "alpha" => Some(Written::Number(scene.ice().alpha)),
        _ => written,
    }
}

impl CurlingScene {
    /// The rock.
    pub fn rock(&self) -> CurlingRock {
        CurlingRock {
            band_radius: self.radius,
            band_width: self.band_width,
            height: self.centre_height,
            inertia_ratio: self.inertia_ratio,
            gravity: self.gravity,
        }
    }

    /// The law of the ice.
    pub fn ice(&self) -> IceLaw {
        let usual = match self.model {
            IceModel::Dry => IceLaw::DRY,
            _ => IceLaw::PENNER,
        };
        IceLaw {
            coefficient: self.gamma.unwrap_or(usual.coefficient),
            alpha: self.alpha.unwrap_or(usual.alpha),
        }
    }

    /// The model of the ice with its parameters.
    pub fn ice_model(&self) -> Box<dyn CurlingModel> {
        let ice = self.ice();
        match self.model {
            IceModel::LeftRight => Box::new(LeftRight { ice }),
            IceModel::Dry => Box::new(Dry {
                coefficient: ice.coefficient,
            }),
            IceModel::FrontBack => Box::new(FrontBack { ice }),
            IceModel::BackHeavy => Box::new(BackHeavy {
                ice,
                back_to_front: self.back_to_front,
            }),
            IceModel::Film => Box::new(Film {
                ice,
                front: self.film_front,
                back: self.film_back,
            }),
            IceModel::PivotSlide => Box::new(PivotSlide {
                ice,
                weight: self.pivot_weight,
            }),
            IceModel::ScratchGuide => Box::new(ScratchGuide {
                ice,
                strength: self.scratch_strength,
                onset: self.scratch_onset_angle,
            }),
        }
    }
}

impl PlanarScene for CurlingScene {
    /// Where γ v^α would tip a rock, below 1 mm/s, the gradient is held.
    fn course(&self) -> PlanarCourse {
        PlanarCourse {
            speed: self.speed,
            spin: self.spin,
            mass: self.mass,
            tipping: Tipping::Clamp,
            stop_fraction: STOP_FRACTION,
            samples: self.samples,
        }
    }

    fn resistance(&self) -> Result<Box<dyn Resistance>, MotionError> {
        self.ice_model().resistance(&self.rock())
    }

    fn evaluation(&self) -> Result<Evaluation, MotionError> {
        let points = RING_POINTS;
        match self.model {
            IceModel::Film => Ok(Evaluation::RingRule { points }),
            _ => of_law(&self.rock().patch(), &Law::power(1.0, self.ice().alpha)?),
        }
    }
}
