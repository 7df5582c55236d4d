//! Spheres as shaded disks, the far ones first.

use super::{Packing, PackingError};
use crate::report::figure::FigureError;
use crate::report::figure::axis::{Axis, Span};
use crate::report::solid::paper::Paper;
use crate::report::solid::ramp;
use crate::report::solid::view::{Frame, Point, View};

/// Spheres with a value each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Balls {
    centres: Vec<Point>,
    radii: Vec<f64>,
    axis: Axis,
    values: Vec<f64>,
}

impl Balls {
    /// The value is the height of the centre.
    pub fn by_height(packing: &Packing) -> Self {
        Self {
            centres: (0..packing.positions.len())
                .map(|at| packing.centre(at))
                .collect(),
            radii: packing.radii.to_vec(),
            axis: Axis::linear("height z"),
            values: packing.positions.iter().map(|at| at[2]).collect(),
        }
    }

    /// Takes other values.
    pub fn color_by(&mut self, axis: Axis, values: &[f64]) -> Result<(), PackingError> {
        let (given, spheres) = (values.len(), self.centres.len());
        if given != spheres {
            let values = given;
            return Err(PackingError::Values { values, spheres });
        }
        (self.axis, self.values) = (axis, values.to_vec());
        Ok(())
    }

    /// Draws the colour bar and returns the rest of the frame.
    pub fn legend(&self, paper: &mut Paper, frame: Frame) -> Result<Frame, FigureError> {
        ramp::bar(paper, (&self.axis, &self.span()?), frame)
    }

    // The span of the colours.
    fn span(&self) -> Result<Span, FigureError> {
        Span::new(&self.axis, self.values.iter().copied())
    }

    /// Draws the spheres; of two equal ones that touch, the one whose centre is nearer hides the
    /// other.
    pub fn draw(&self, paper: &mut Paper, view: &View) -> Result<(), FigureError> {
        let span = self.span()?;
        let mut order: Vec<usize> = (0..self.centres.len()).collect();
        let near = |at: usize| view.nearness(self.centres[at]);
        order.sort_by(|a, b| near(*a).total_cmp(&near(*b)));
        for at in order {
            let share = span.place(self.values[at]).unwrap_or(f64::NAN);
            let place = view.place(self.centres[at]);
            paper.ball(place, self.radii[at] * view.scale(), ramp::color(share));
        }
        Ok(())
    }
}
