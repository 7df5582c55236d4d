//! Single frames as pictures.

use super::colors::{RenderStyle, contacts};
use crate::failure::Failure;
use tribos::grains::plates;
use tribos::record::frames::{Frame, Kind};
use tribos_report::packing::{Packing, PackingPicture};
use tribos_report::runs::RunFrames;

/// Size of pictures, px: even numbers, which film files need.
const SIZES: [(u32, u32); 2] = [(520, 720), (860, 640)];

/// Which frame is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameSelector {
    /// By its number from 1.
    Number(usize),
    /// The last one.
    Last,
}

/// A frame as the command line names it.
pub fn which(text: &str) -> Result<FrameSelector, String> {
    match (text.trim(), text.trim().parse()) {
        ("last", _) => Ok(FrameSelector::Last),
        (_, Ok(number)) if number > 0 => Ok(FrameSelector::Number(number)),
        _ => Err("give numbers of frames from 1 up, or `last`".into()),
    }
}

impl FrameSelector {
    /// Its number, from 1, among so many.
    pub fn number(self, frames: usize) -> Result<usize, Failure> {
        match self {
            Self::Last => Ok(frames),
            Self::Number(number) if number <= frames => Ok(number),
            Self::Number(number) => Err(Failure::input(format!(
                "there is no frame {number}: give a number from 1 to {frames}, or `last`"
            ))),
        }
    }
}

/// A frame drawn as PNG.
pub fn png(run: &RunFrames, look: &RenderStyle, index: usize) -> Result<Vec<u8>, Failure> {
    let frame = &run.frames[index];
    let places: Vec<[f64; 3]> = frame.places.iter().map(|at| [at.x, at.y, at.z]).collect();
    let is_powder = run.bodies.kind != Kind::Tip;
    let scene = &run.bodies.scene;
    let has_lid = run.bodies.kind == Kind::Powder
        || (run.bodies.kind == Kind::Grains && scene["boundary_z"] == "walls");
    let piston = has_lid.then_some(frame.height);
    let packing = Packing::new(&places, &run.bodies.radii, run.bodies.sides, piston);
    let packing = packing.map_err(Failure::run)?;
    let title = title(frame, run.bodies.kind);
    let picture = match look.full_force {
        Some(full) => PackingPicture::forces(title, &packing, &contacts(frame))
            .map(|picture| picture.full_force(full, force_unit(run.bodies.kind))),
        None => look.paint(PackingPicture::spheres(title, &packing), run, frame),
    };
    let (width, height) = SIZES[usize::from(!is_powder)];
    let mut picture = picture.map_err(Failure::run)?.size(width, height);
    if is_powder {
        picture = picture.headroom(run.frames[0].height);
        if run.bodies.kind == Kind::Grains {
            let corners = run.frames[0].corners.map(|corner| corner.map(f64::from));
            picture = picture.plates(&plates(scene, corners));
        }
    } else {
        picture = picture.bare();
    }
    Ok(picture.png()?)
}

/// What the frame is.
fn title(frame: &Frame, kind: Kind) -> String {
    let Frame {
        step,
        time,
        measure,
        ..
    } = frame;
    match kind {
        Kind::Powder => format!(
            "step {step}, time {time:.1}, {:.1} % empty",
            100.0 * measure
        ),
        Kind::Grains => format!("step {step}, time {time:.3}"),
        Kind::Gas => format!("step {step}, time {time:.1}, temperature {measure:.3}"),
        Kind::Tip => format!("step {step}, time {time:.1}, angle {measure:.2}°"),
    }
}

/// Name of the unit of forces.
fn force_unit(kind: Kind) -> &'static str {
    match kind {
        Kind::Powder | Kind::Tip => "F_coh",
        Kind::Grains => "N",
        Kind::Gas => "T₀/R",
    }
}
