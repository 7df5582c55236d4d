//! How pictures of frames are coloured.

use crate::failure::Failure;
use tribos::record::frames::{Frame, Kind};
use tribos_report::figure::{Axis, Color};
use tribos_report::packing::{Contact, PackingError, PackingPicture};
use tribos_report::player::PART_COLORS;
use tribos_report::runs::RunFrames;

/// What the colours of a picture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum ColorBy {
    /// The height in the deposit, or the atom's layer.
    Layer,
    /// The speed, on a logarithmic scale.
    Speed,
    /// The sum of a sphere's normal forces.
    Force,
    /// The number of a sphere's contacts.
    Coordination,
    /// The part of the tip or the substrate.
    Part,
}

/// The look of all pictures of a run: colours and forces mean the same in each.
#[derive(Clone, Debug)]
pub struct RenderStyle {
    paint: ColorBy,
    /// The range of the values.
    range: [f64; 2],
    /// The force of a full line; `None` where spheres are shown.
    pub full_force: Option<f64>,
}

/// Share of values that the scale covers: a few spikes do not fade all others.
const COVERED: f64 = 0.995;
/// Share of the forces that are drawn in proportion.
const COVERED_FORCES: f64 = 0.97;
/// The lowest speed on the scale, relative to the highest.
const SLOW: f64 = 1e-4;
/// Colour of marked atoms.
const MARK: Color = Color(255, 210, 31);

impl RenderStyle {
    /// Fits the scale to all frames.
    pub fn of(run: &RunFrames, paint: Option<ColorBy>, network: bool) -> Result<Self, Failure> {
        let is_tip = run.bodies.kind == Kind::Tip;
        let paint = paint.unwrap_or(match run.bodies.kind {
            Kind::Tip => ColorBy::Part,
            Kind::Powder | Kind::Grains => ColorBy::Layer,
            Kind::Gas => ColorBy::Speed,
        });
        let has_forces = matches!(paint, ColorBy::Force | ColorBy::Coordination) || network;
        if is_tip && has_forces {
            return Err(Failure::input(
                "atoms have no contacts; colour a tip by part, layer or speed",
            ));
        }
        if run.bodies.kind == Kind::Gas && (has_forces || paint == ColorBy::Part) {
            return Err(Failure::input(
                "the spheres of a gas have neither contacts nor parts; colour by speed or layer",
            ));
        }
        if !is_tip && paint == ColorBy::Part {
            return Err(Failure::input(
                "spheres of a powder have no parts; colour by layer, speed, force or coordination",
            ));
        }
        let values = run
            .frames
            .iter()
            .flat_map(|frame| values(run, frame, paint));
        let high = quantile(values.collect(), COVERED);
        let low = if paint == ColorBy::Speed {
            SLOW * high
        } else {
            0.0
        };
        let forces = || {
            let contacts = run.frames.iter().flat_map(|frame| &frame.contacts);
            let forces = contacts.map(|contact| f64::from(contact.normal_force.abs()));
            quantile(
                forces.filter(|&force| force > 0.0).collect(),
                COVERED_FORCES,
            )
        };
        Ok(Self {
            paint,
            range: [low, if high > low { high } else { low + 1.0 }],
            full_force: network.then(forces),
        })
    }

    /// Colours the balls of a picture.
    pub fn paint(
        &self,
        picture: PackingPicture,
        run: &RunFrames,
        frame: &Frame,
    ) -> Result<PackingPicture, PackingError> {
        let [low, high] = self.range;
        if self.paint == ColorBy::Part {
            let part = |&part: &u8| PART_COLORS[usize::from(part) % PART_COLORS.len()];
            let mut colors: Vec<Color> = run.bodies.parts.iter().map(part).collect();
            for &atom in &run.bodies.marked {
                colors[atom as usize] = MARK;
            }
            return picture.colors(&colors);
        }
        let axis = match (self.paint, run.bodies.kind) {
            (ColorBy::Layer, Kind::Tip) => Axis::linear("layer"),
            (ColorBy::Layer, Kind::Powder) => Axis::linear("height in the deposit [R]"),
            (ColorBy::Layer, Kind::Gas) => Axis::linear("height at the start [R]"),
            (ColorBy::Speed, Kind::Gas) => Axis::log10("speed [√(T₀/m)]"),
            (ColorBy::Speed, Kind::Tip) => Axis::log10("speed [√(ε/m)]"),
            (ColorBy::Speed, Kind::Powder) => Axis::log10("speed [√(F_coh/ρ)/R]"),
            (ColorBy::Layer, Kind::Grains) => Axis::linear("initial height [m]"),
            (ColorBy::Speed, Kind::Grains) => Axis::log10("speed [m/s]"),
            (ColorBy::Force, Kind::Grains) => Axis::linear("normal forces, sum [N]"),
            (ColorBy::Force, _) => Axis::linear("normal forces, sum [F_coh]"),
            (ColorBy::Coordination | ColorBy::Part, _) => Axis::linear("contacts"),
        };
        // Below and above the scale counts as on its ends.
        let values: Vec<f64> = values(run, frame, self.paint)
            .into_iter()
            .map(|value| value.clamp(low, high))
            .collect();
        picture.color_by(axis.range(low, high), &values)
    }
}

/// A value a body.
fn values(run: &RunFrames, frame: &Frame, paint: ColorBy) -> Vec<f64> {
    let sums = |add: fn(f32) -> f64| {
        let mut sums = vec![0.0; frame.places.len()];
        for contact in &frame.contacts {
            for body in [Some(contact.a), contact.b.particle()]
                .into_iter()
                .flatten()
            {
                sums[body as usize] += add(contact.normal_force);
            }
        }
        sums
    };
    match (paint, run.bodies.kind) {
        (ColorBy::Layer | ColorBy::Part, Kind::Tip) => run
            .bodies
            .layers
            .iter()
            .map(|&layer| f64::from(layer) + 1.0)
            .collect(),
        (ColorBy::Layer | ColorBy::Part, Kind::Powder | Kind::Grains | Kind::Gas) => {
            run.frames[0].places.iter().map(|place| place.z).collect()
        }
        (ColorBy::Speed, _) => frame.speeds.iter().map(|&speed| speed.into()).collect(),
        (ColorBy::Force, _) => sums(|force| f64::from(force.abs())),
        (ColorBy::Coordination, _) => sums(|_| 1.0),
    }
}

/// The value below which a share of all lies; 0 of none.
fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.retain(|value| value.is_finite());
    if values.is_empty() {
        return 0.0;
    }
    let at = ((values.len() - 1) as f64 * share) as usize;
    *values.select_nth_unstable_by(at, f64::total_cmp).1
}

/// Contacts as pictures take them.
pub fn contacts(frame: &Frame) -> Vec<Contact> {
    let contact = |contact: &tribos::record::frames::FrameContact| Contact {
        a: contact.a as usize,
        b: contact.b.particle().map(|b| b as usize),
        normal_force: contact.normal_force.into(),
    };
    frame.contacts.iter().map(contact).collect()
}
