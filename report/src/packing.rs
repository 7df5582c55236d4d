//! Pictures of spheres in a periodic box between a substrate and a piston: the spheres themselves,
//! or the network of forces between them.

mod forces;
mod plates;
mod spheres;
mod state;

pub use state::{Contact, Packing, PackingError};

use super::figure::axis::Axis;
use super::figure::{Color, FigureError, canvas};
use super::solid::svg_canvas::SvgCanvas;
use super::solid::view::{Frame, View, corners};
use forces::Network;
use spheres::Balls;

/// Direction of the eye: a little to the right of the front and above.
const AZIMUTH: f64 = -1.13;
const ELEVATION: f64 = 0.2;

/// A picture of one state.
#[derive(Debug, Clone, PartialEq)]
pub struct PackingPicture {
    title: String,
    hall: BoxGeometry,
    content: Content,
    headroom: f64,
    size: (u32, u32),
    surroundings: Surroundings,
    plates: Vec<[[f64; 3]; 4]>,
}

// Surroundings of the spheres.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Surroundings {
    // Substrate, piston and the edges of the box.
    Box,
    Nothing,
}

// The box and its plates.
#[derive(Debug, Clone, Copy, PartialEq)]
struct BoxGeometry {
    lengths: [f64; 2],
    piston: Option<f64>,
    // Top of the contents.
    top: f64,
    // Thickness of the plates.
    plate: f64,
}

// Contents of the box.
#[derive(Debug, Clone, PartialEq)]
enum Content {
    Spheres(Balls),
    Forces(Network),
}

impl PackingPicture {
    /// The spheres, coloured by the height of their centres.
    pub fn spheres(title: impl Into<String>, packing: &Packing) -> Self {
        let balls = Balls::by_height(packing);
        Self::new(title, packing, Content::Spheres(balls))
    }

    /// The normal forces as lines between centres, as wide as the force is large: compression and
    /// tension in two colours. A wall's contact runs from the centre straight to the nearer plate.
    /// Contacts without a force, or with one that is not finite, are left out.
    pub fn forces(
        title: impl Into<String>,
        packing: &Packing,
        contacts: &[Contact],
    ) -> Result<Self, PackingError> {
        let network = Network::new(packing, contacts)?;
        Ok(Self::new(title, packing, Content::Forces(network)))
    }

    fn new(title: impl Into<String>, packing: &Packing, content: Content) -> Self {
        Self {
            title: title.into(),
            hall: packing.hall(),
            content,
            headroom: 0.0,
            size: (430, 620),
            surroundings: Surroundings::Box,
            plates: Vec::new(),
        }
    }

    /// Adds plane plates behind the content, each a corner and two sides, and room for them: those of a hopper or a drum.
    #[must_use]
    pub fn plates(mut self, plates: &[[[f64; 3]; 3]]) -> Self {
        let corners = |[from, first, second]: &[[f64; 3]; 3]| {
            let at = |u: f64, v: f64| {
                std::array::from_fn(|axis| from[axis] + u * first[axis] + v * second[axis])
            };
            [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]
        };
        self.plates = plates.iter().map(corners).collect();
        let tops = self.plates.iter().flatten().map(|corner| corner[2]);
        self.headroom = tops.fold(self.headroom, f64::max);
        self
    }

    /// Colours the spheres by one value each instead of their height; the axis names the colours
    /// and may fix their range. A value that is not finite is grey. No effect on forces.
    pub fn color_by(mut self, axis: Axis, values: &[f64]) -> Result<Self, PackingError> {
        if let Content::Spheres(balls) = &mut self.content {
            balls.color_by(axis, values)?;
        }
        Ok(self)
    }

    /// Gives each sphere a colour of its own; no scale is drawn then. No effect on forces.
    pub fn colors(mut self, colors: &[Color]) -> Result<Self, PackingError> {
        if let Content::Spheres(balls) = &mut self.content {
            balls.colors(colors)?;
        }
        Ok(self)
    }

    /// Leaves out the plates and the edges of the box.
    #[must_use]
    pub fn bare(mut self) -> Self {
        self.surroundings = Surroundings::Nothing;
        self.hall.plate = 0.0;
        self
    }

    /// Sets the force that is drawn as wide as a sphere, instead of the largest one, and the unit
    /// written beside it: pictures to compare need the same. No effect on spheres.
    #[must_use]
    pub fn full_force(mut self, force: f64, unit: impl Into<String>) -> Self {
        if let Content::Forces(network) = &mut self.content {
            network.full_force(force, unit.into());
        }
        self
    }

    /// Leaves room for a box this high, so that pictures of one kind side by side have one scale;
    /// no effect if it is not finite.
    #[must_use]
    pub fn headroom(mut self, height: f64) -> Self {
        if height.is_finite() {
            self.headroom = self.headroom.max(height);
        }
        self
    }

    /// Sets the size in pixels.
    #[must_use]
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// Width and height in pixels.
    pub fn extent(&self) -> (u32, u32) {
        self.size
    }

    /// Draws the picture as an SVG document.
    pub fn svg(&self) -> Result<String, FigureError> {
        let mut paper = SvgCanvas::new(self.size)?;
        let frame = paper.title(&self.title);
        let frame = match &self.content {
            Content::Spheres(balls) => balls.legend(&mut paper, frame)?,
            Content::Forces(network) => network.legend(&mut paper, frame),
        };

        // From the back to the front: far edges and substrate, the content, near edges and piston.
        let view = self.view(frame);
        if self.surroundings == Surroundings::Box {
            plates::behind(&mut paper, &view, &self.hall);
            plates::inclined(&mut paper, &view, &self.plates);
        }
        match &self.content {
            Content::Spheres(balls) => balls.draw(&mut paper, &view)?,
            Content::Forces(network) => network.draw(&mut paper, &view),
        }
        if self.surroundings == Surroundings::Box {
            plates::before(&mut paper, &view, &self.hall);
        }
        Ok(paper.svg())
    }

    /// Draws the picture as a PNG file.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        canvas::png(&self.svg()?)
    }

    // The box with its plates in a frame; spheres at the border stand out by their radius.
    fn view(&self, [left, top, right, bottom]: Frame) -> View {
        // Space around the box, px.
        const ROOM: f64 = 8.0;
        let BoxGeometry {
            lengths: [x, y],
            plate,
            ..
        } = self.hall;
        let height = self.hall.top.max(self.headroom);
        let all = corners(
            [-plate, -plate, -plate],
            [x + plate, y + plate, height + plate],
        );
        let frame = [left + ROOM, top + ROOM, right - ROOM, bottom - ROOM];
        View::new(AZIMUTH, ELEVATION).fitted(&all, frame)
    }
}

#[cfg(test)]
mod tests;
