//! The state of a packing for pictures: borrowed, checked once.

use super::BoxGeometry;

/// Spheres in a box that is periodic in x and y, with a substrate at z = 0; one unit of length.
#[derive(Debug, Clone, Copy)]
pub struct Packing<'a> {
    pub(super) positions: &'a [[f64; 3]],
    pub(super) radii: &'a [f64],
    lengths: [f64; 2],
    piston: Option<f64>,
}

/// A contact between two spheres, or between a sphere and the nearer plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Index of one sphere.
    pub a: usize,
    /// Index of the other sphere, `None` at a plate.
    pub b: Option<usize>,
    /// Normal force, positive in compression and negative in tension.
    pub normal_force: f64,
}

/// Reasons a packing cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PackingError {
    /// The lists differ in length.
    #[error("{positions} positions, but {radii} radii")]
    Radii {
        /// Number of positions.
        positions: usize,
        /// Number of radii.
        radii: usize,
    },
    /// A centre is not finite, or a radius not positive and finite.
    #[error("sphere {0}: give a finite centre and a positive radius")]
    Sphere(usize),
    /// A side of the box is not positive and finite.
    #[error("a box of {} by {} has no room: give positive sides", .0[0], .0[1])]
    Box([f64; 2]),
    /// The piston's height is not positive and finite.
    #[error("a piston at height {0}: give a positive height")]
    Piston(f64),
    /// A contact names a sphere that does not exist, or one sphere twice.
    #[error("contact {0} does not join two spheres of the packing")]
    Contact(usize),
    /// The number of values differs from that of spheres.
    #[error("{values} values for {spheres} spheres")]
    Values {
        /// Number of values.
        values: usize,
        /// Number of spheres.
        spheres: usize,
    },
}

impl<'a> Packing<'a> {
    /// Centres and radii, sides of the box in x and y, height of the piston's face if there is one.
    pub fn new(
        positions: &'a [[f64; 3]],
        radii: &'a [f64],
        lengths: [f64; 2],
        piston: Option<f64>,
    ) -> Result<Self, PackingError> {
        if positions.len() != radii.len() {
            let (positions, radii) = (positions.len(), radii.len());
            return Err(PackingError::Radii { positions, radii });
        }
        let positive = |length: &f64| *length > 0.0 && length.is_finite();
        let sound = |(at, radius): (&[f64; 3], &f64)| {
            at.iter().all(|part| part.is_finite()) && positive(radius)
        };
        if let Some(bad) = positions
            .iter()
            .zip(radii)
            .position(|sphere| !sound(sphere))
        {
            return Err(PackingError::Sphere(bad));
        }
        if !lengths.iter().all(positive) {
            return Err(PackingError::Box(lengths));
        }
        if let Some(height) = piston.filter(|height| !positive(height)) {
            return Err(PackingError::Piston(height));
        }
        Ok(Self {
            positions,
            radii,
            lengths,
            piston,
        })
    }

    /// Number of contacts of each sphere, plates included; `color_by` shows them.
    pub fn coordination(&self, contacts: &[Contact]) -> Result<Vec<f64>, PackingError> {
        self.check(contacts)?;
        let mut numbers = vec![0.0; self.positions.len()];
        for contact in contacts {
            for sphere in [Some(contact.a), contact.b].into_iter().flatten() {
                numbers[sphere] += 1.0;
            }
        }
        Ok(numbers)
    }

    /// Refuses contacts of spheres that do not exist.
    pub(super) fn check(&self, contacts: &[Contact]) -> Result<(), PackingError> {
        let count = self.positions.len();
        let sound = |contact: &Contact| {
            let other = contact.b.is_none_or(|b| b < count && b != contact.a);
            contact.a < count && other
        };
        match contacts.iter().position(|contact| !sound(contact)) {
            Some(bad) => Err(PackingError::Contact(bad)),
            None => Ok(()),
        }
    }

    /// The centre of a sphere moved into the box.
    pub(super) fn centre(&self, sphere: usize) -> [f64; 3] {
        let [x, y, z] = self.positions[sphere];
        [
            x.rem_euclid(self.lengths[0]),
            y.rem_euclid(self.lengths[1]),
            z,
        ]
    }

    /// Vector from one centre to the nearest image of another.
    pub(super) fn branch(&self, from: usize, to: usize) -> [f64; 3] {
        let (a, b) = (self.positions[from], self.positions[to]);
        let nearest = |axis: usize| {
            let (apart, side) = (b[axis] - a[axis], self.lengths[axis]);
            apart - side * (apart / side).round()
        };
        [nearest(0), nearest(1), b[2] - a[2]]
    }

    /// Vector from a centre straight to the nearer plate.
    pub(super) fn branch_to_plate(&self, sphere: usize) -> [f64; 3] {
        let height = self.positions[sphere][2];
        let up = self.piston.map(|piston| piston - height);
        let up = up.filter(|up| up.abs() < height.abs());
        [0.0, 0.0, up.unwrap_or(-height)]
    }

    /// The box around the spheres.
    pub(super) fn hall(&self) -> BoxGeometry {
        let spheres = self.positions.iter().zip(self.radii);
        let highest = spheres
            .map(|(at, radius)| at[2] + radius)
            .fold(0.0, f64::max);
        let largest = self.radii.iter().copied().fold(0.0, f64::max);
        let side = self.lengths[0].max(self.lengths[1]);
        BoxGeometry {
            lengths: self.lengths,
            piston: self.piston,
            top: self.piston.map_or(highest, |piston| piston.max(highest)),
            // A third of the largest radius, but something to see in any box.
            plate: (largest / 3.0).max(side / 100.0),
        }
    }
}
