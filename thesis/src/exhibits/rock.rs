//! Shots of a curling rock under every model of the library.

use anyhow::{Context, Result};
use tribos::slide::curling::{
    BackHeavy, CurlingModel, CurlingRock, Dry, Film, FrontBack, IceLaw, LeftRight, PivotSlide,
    ScratchGuide,
};
use tribos::slide::planar::{Launch, PlanarSimulation, PlanarState, Resistance};

/// Launch of a draw that stops after 28.35 m without spin under Penner's law, m/s.
pub(super) const DRAW: f64 = 1.9866;
/// Launch of a slow rock with fast spin, m/s and rad/s: about 3.5 m forward under Penner's law.
pub(super) const SLOW: (f64, f64) = (0.16, 20.0);
/// A motion below this share of its launch has ended, as far as an eye can tell.
const ENDED: f64 = 0.01;
/// A shot is looked at every so many seconds, for a minute, which is longer than any takes.
const PAUSE: f64 = 0.05;
const LOOKS: u32 = 1200;

/// All models, in the order of the library.
pub(super) fn models() -> Vec<Box<dyn CurlingModel>> {
    let ice = IceLaw::PENNER;
    vec![
        Box::new(dry()),
        Box::new(LeftRight { ice }),
        Box::new(FrontBack { ice }),
        Box::new(BackHeavy {
            ice,
            back_to_front: 10.0,
        }),
        Box::new(Film {
            ice,
            front: 1.0,
            back: 0.0,
        }),
        Box::new(pivot()),
        Box::new(ScratchGuide {
            ice,
            strength: ScratchGuide::STRENGTH,
            onset: ScratchGuide::ONSET,
        }),
    ]
}

/// Dry friction with the stop of Penner's law.
pub(super) fn dry() -> Dry {
    Dry {
        coefficient: IceLaw::DRY.coefficient,
    }
}

/// Pivots of the strength that its author gives.
pub(super) fn pivot() -> PivotSlide {
    PivotSlide {
        ice: IceLaw::PENNER,
        weight: PivotSlide::WEIGHT,
    }
}

fn journey<B: Resistance>(body: &B, (speed, spin): (f64, f64)) -> Result<PlanarSimulation<'_, B>> {
    let launch = Launch {
        velocity: [speed, 0.0],
        spin,
    };
    Ok(PlanarSimulation::new(body, &launch, 1e-4)?)
}

/// The end of a shot; x points forward, y to the left.
pub(super) fn shot(model: &dyn CurlingModel, launch: (f64, f64)) -> Result<PlanarState> {
    let body = model.resistance(&CurlingRock::STANDARD)?;
    Ok(journey(&body, launch)?.to_end()?.point)
}

/// The path of a shot.
pub(super) fn path(model: &dyn CurlingModel, launch: (f64, f64)) -> Result<Vec<PlanarState>> {
    let body = model.resistance(&CurlingRock::STANDARD)?;
    let times: Vec<f64> = (1..LOOKS).map(|look| PAUSE * f64::from(look)).collect();
    let mut seen = Vec::new();
    journey(&body, launch)?.follow(&times, |point| seen.push(*point))?;
    Ok(seen)
}

/// When the slide and the spin have ended to the eye, as shares of the time to rest.
pub(super) fn ends(path: &[PlanarState]) -> Result<[f64; 2]> {
    let (start, rest) = path.first().zip(path.last()).context("a path has ends")?;
    let slide = |point: &PlanarState| point.velocity[0].hypot(point.velocity[1]);
    let (speed, spin) = (slide(start), start.spin.abs());
    let last = |moves: &dyn Fn(&PlanarState) -> bool| {
        let moving = path.iter().rfind(|point| moves(point));
        moving.map_or(0.0, |point| point.time / rest.time)
    };
    Ok([
        last(&|point| slide(point) > ENDED * speed),
        last(&|point| point.spin.abs() > ENDED * spin),
    ])
}

/// The spin at which a draw curls by a metre, under a model whose curl is nearly in proportion to it.
pub(super) fn spin_for_a_metre(model: &dyn CurlingModel) -> Result<f64> {
    let mut spin = 3.0;
    for _ in 0..6 {
        spin /= shot(model, (DRAW, spin))?.position[1];
    }
    Ok(spin)
}
