//! The vocabulary of a curling rock and of the models of its ice.

use super::body::BODY;
use super::key::{Domain, Key};
use super::planar::{PlanarBody, SAMPLE_COUNT, SPEED, SPIN, Taker, Tipping};
use super::slider::key;
use crate::slide::curling::{
    BackHeavy, CurlingModel, CurlingRock, Dry, Film, FrontBack, IceLaw, LeftRight, PivotSlide,
    ScratchGuide,
};

/// Mass of a rock, kg.
const ROCK: f64 = 20.0;
/// Penner's lower bound of the ratio that a curl of 1 m would need.
const RATIO: f64 = 10.0;

const MODEL: Key = key(
    "model",
    "-",
    "why the rock curls; see docs/curling.md (default left-right)",
    Domain::OneOf(&[
        "left-right",
        "dry",
        "front-back",
        "back-heavy",
        "film",
        "pivot-slide",
        "scratch-guide",
    ]),
);
const COEFFICIENT: Key = key(
    "coefficient",
    "(s/m)^alpha",
    "friction of the ice (default 0.008; dry 0.007095)",
    Domain::Positive,
);
const ALPHA: Key = key(
    "alpha",
    "-",
    "exponent of the ice (default -0.5; dry 0)",
    Domain::Between {
        above: -1.0,
        // A rock comes to rest.
        up_to: 0.9,
    },
);
const GRAVITY: Key = key(
    "gravity",
    "m/s^2",
    "acceleration that presses the rock down (default 9.81)",
    Domain::Positive,
);
const MASS: Key = key(
    "mass",
    "kg",
    "mass of the rock (default 20)",
    Domain::Positive,
);
const RADIUS: Key = key(
    "radius",
    "m",
    "outer radius of the running band (default 0.0625)",
    Domain::Positive,
);
const WIDTH: Key = key(
    "band_width",
    "m",
    "width of the band, 0 for a thin ring (default 0)",
    Domain::NotNegative,
);
const HEIGHT: Key = key(
    "centre_height",
    "m",
    "height of the centre of mass (default 0.057)",
    Domain::NotNegative,
);
const INERTIA: Key = key(
    "inertia_ratio",
    "-",
    "C = I/(M R^2), R of the band (default 2.69, solid of 29 cm)",
    Domain::Positive,
);
const BACK_TO_FRONT: Key = key(
    "back_to_front",
    "-",
    "model back-heavy: friction at the back over that in front (default 10)",
    Domain::Positive,
);
const FILM_FRONT: Key = key(
    "film_front",
    "-",
    "model film: fraction of the band's rotation that the film takes in front (default 1)",
    Domain::Fraction,
);
const FILM_BACK: Key = key(
    "film_back",
    "-",
    "model film: the same at the back (default 0)",
    Domain::Fraction,
);
const PIVOT: Key = key(
    "pivot",
    "-",
    "model pivot-slide: weight of the pull (default 0.014)",
    Domain::NotNegative,
);
const SCRATCH: Key = key(
    "scratch",
    "-",
    "model scratch-guide: guiding force over load (default 0.0006)",
    Domain::NotNegative,
);
const ONSET: Key = key(
    "scratch_onset",
    "rad",
    "model scratch-guide: half the crossing angle from which scratches guide (default 0.01)",
    Domain::Positive,
);

/// The vocabulary.
pub(super) const CURLING: &[Key] = &[
    BODY,
    MODEL,
    SPEED,
    SPIN,
    COEFFICIENT,
    ALPHA,
    GRAVITY,
    MASS,
    RADIUS,
    WIDTH,
    HEIGHT,
    INERTIA,
    BACK_TO_FRONT,
    FILM_FRONT,
    FILM_BACK,
    PIVOT,
    SCRATCH,
    ONSET,
    SAMPLE_COUNT,
];

/// Dimensions of a rock under their keys.
pub(super) fn rock_numbers(rock: &CurlingRock) -> [(Key, f64); 4] {
    [
        (RADIUS, rock.band_radius),
        (WIDTH, rock.band_width),
        (HEIGHT, rock.height),
        (INERTIA, rock.inertia_ratio),
    ]
}

/// A model with its parameters as text.
pub(super) fn model_text(model: &dyn CurlingModel) -> String {
    format!("{model:?}")
}

/// The rock with its model, gravity and mass. Where γ v^α would tip it, below 1 mm/s, the gradient
/// is held.
pub(super) fn body(take: &mut Taker) -> (PlanarBody, f64, f64, Tipping) {
    let standard = CurlingRock::STANDARD;
    let rock = CurlingRock {
        band_radius: take.or(RADIUS, standard.band_radius),
        band_width: take.or(WIDTH, standard.band_width),
        height: take.or(HEIGHT, standard.height),
        inertia_ratio: take.or(INERTIA, standard.inertia_ratio),
        gravity: take.or(GRAVITY, standard.gravity),
    };
    if rock.band_width > rock.band_radius {
        let message = format!(
            "`band_width` must not exceed `radius`, {}",
            rock.band_radius
        );
        take.reader.object("band_width", message);
    }
    let mass = take.or(MASS, ROCK);
    let model = model(take);
    let gravity = rock.gravity;
    (
        PlanarBody::Curling(rock, model),
        gravity,
        mass,
        Tipping::Clamp,
    )
}

fn model(take: &mut Taker) -> Box<dyn CurlingModel> {
    let index = take.word(MODEL);
    refuse_strangers(take, index);
    if index == 1 {
        return dry(take);
    }
    let ice = IceLaw {
        coefficient: take.or(COEFFICIENT, IceLaw::PENNER.coefficient),
        alpha: take.or(ALPHA, IceLaw::PENNER.alpha),
    };
    match index {
        2 => Box::new(FrontBack { ice }),
        3 => Box::new(BackHeavy {
            ice,
            back_to_front: take.or(BACK_TO_FRONT, RATIO),
        }),
        4 => Box::new(Film {
            ice,
            front: take.or(FILM_FRONT, 1.0),
            back: take.or(FILM_BACK, 0.0),
        }),
        5 => Box::new(PivotSlide {
            ice,
            weight: take.or(PIVOT, PivotSlide::WEIGHT),
        }),
        6 => Box::new(ScratchGuide {
            ice,
            strength: take.or(SCRATCH, ScratchGuide::STRENGTH),
            onset: take.or(ONSET, ScratchGuide::ONSET),
        }),
        _ => Box::new(LeftRight { ice }),
    }
}

fn dry(take: &mut Taker) -> Box<dyn CurlingModel> {
    let coefficient = take.or(COEFFICIENT, IceLaw::DRY.coefficient);
    if take.or(ALPHA, 0.0) != 0.0 {
        let message = "`alpha` is 0 for model \"dry\"; leave it out, or use \"front-back\"";
        take.reader.object("alpha", message.into());
    }
    Box::new(Dry { coefficient })
}

/// Keys that another model than the chosen one would read.
fn refuse_strangers(take: &mut Taker, index: usize) {
    for (key, owner, name) in [
        (BACK_TO_FRONT, 3, "back-heavy"),
        (FILM_FRONT, 4, "film"),
        (FILM_BACK, 4, "film"),
        (PIVOT, 5, "pivot-slide"),
        (SCRATCH, 6, "scratch-guide"),
        (ONSET, 6, "scratch-guide"),
    ] {
        if index != owner && take.reader.is_given(key.name) {
            let message = format!("`{}` is for model \"{name}\" only; leave it out", key.name);
            take.reader.object(key.name, message);
        }
    }
}
