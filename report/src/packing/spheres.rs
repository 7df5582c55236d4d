//! Spheres as shaded disks, the far ones first.

use super::{Packing, PackingError};
use crate::figure::axis::{Axis, Span};
use crate::figure::{Color, FigureError};
use crate::solid::ramp;
use crate::solid::svg_canvas::SvgCanvas;
use crate::solid::view::{Frame, Point, View};

/// Spheres with a value each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Balls {
    centres: Vec<Point>,
    radii: Vec<f64>,
    paint: Paint,
}

// Colouring of the spheres.
#[derive(Debug, Clone, PartialEq)]
enum Paint {
    // One value per sphere, on a scale.
    Values(Axis, Vec<f64>),
    // One colour per sphere.
    Colors(Vec<Color>),
}

impl Balls {
    /// The value is the height of the centre.
    pub fn by_height(packing: &Packing) -> Self {
        Self {
            centres: (0..packing.positions.len())
                .map(|at| packing.centre(at))
                .collect(),
            radii: packing.radii.to_vec(),
            paint: Paint::Values(
                Axis::linear("height z"),
                packing.positions.iter().map(|at| at[2]).collect(),
            ),
        }
    }

    /// Colours the spheres by other values.
    pub fn color_by(&mut self, axis: Axis, values: &[f64]) -> Result<(), PackingError> {
        self.check(values.len())?;
        self.paint = Paint::Values(axis, values.to_vec());
        Ok(())
    }

    /// Gives each sphere its own colour.
    pub fn colors(&mut self, colors: &[Color]) -> Result<(), PackingError> {
        self.check(colors.len())?;
        self.paint = Paint::Colors(colors.to_vec());
        Ok(())
    }

    // Refuses a list that is not one entry per sphere.
    fn check(&self, values: usize) -> Result<(), PackingError> {
        let spheres = self.centres.len();
        if values == spheres {
            Ok(())
        } else {
            Err(PackingError::Values { values, spheres })
        }
    }

    /// Draws the colour bar, if there is a scale, and returns the rest of the frame.
    pub fn legend(&self, paper: &mut SvgCanvas, frame: Frame) -> Result<Frame, FigureError> {
        match &self.paint {
            Paint::Values(axis, values) => {
                let span = Span::new(axis, values.iter().copied())?;
                ramp::bar(paper, (axis, &span), frame)
            }
            Paint::Colors(_) => Ok(frame),
        }
    }

    // Colours of all spheres.
    fn painted(&self) -> Result<Vec<Color>, FigureError> {
        match &self.paint {
            Paint::Values(axis, values) => {
                let span = Span::new(axis, values.iter().copied())?;
                let share = |value: &f64| span.place(*value).unwrap_or(f64::NAN);
                Ok(values
                    .iter()
                    .map(|value| ramp::color(share(value)))
                    .collect())
            }
            Paint::Colors(colors) => Ok(colors.clone()),
        }
    }

    /// Draws the spheres; of two equal ones that touch, the one whose centre is nearer hides the
    /// other.
    pub fn draw(&self, paper: &mut SvgCanvas, view: &View) -> Result<(), FigureError> {
        let colors = self.painted()?;
        let mut order: Vec<usize> = (0..self.centres.len()).collect();
        let near = |at: usize| view.nearness(self.centres[at]);
        order.sort_by(|a, b| near(*a).total_cmp(&near(*b)));
        for at in order {
            let place = view.place(self.centres[at]);
            paper.ball(place, self.radii[at] * view.scale(), colors[at]);
        }
        Ok(())
    }
}
