//! A support that moves at constant speed, forth and back, and pulls a group of atoms by springs.

use nalgebra::Vector3;

/// A rigid support that moves in the plane; each atom of a group is tied to its place in it.
///
/// The force on atom i is k (aᵢ + s e − rᵢ) along x and y: a common displacement of all N atoms
/// meets the stiffness N k, a rotation meets k Σ rᵢ². The support rests at s = 0 until `from`,
/// moves forth by `stroke`, back to 0, forth again, and rests from `until` on.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::support::Support;
/// let support = Support {
///     group: 5,
///     anchors: vec![[0.0, 0.0], [1.0, 0.0]],
///     direction: [0.6, 0.8],
///     stiffness: 2.0,
///     speed: 0.5,
///     stroke: 3.0,
///     from: 10.0,
///     until: 30.0,
/// };
/// // It rests, moves forth, turns after 6, is back after 12, and stops at 30.
/// let way = [0.0, 10.0, 12.0, 16.0, 18.0, 22.0, 24.0, 30.0, 99.0].map(|t| support.position(t));
/// assert_eq!(way, [0.0, 0.0, 1.0, 3.0, 2.0, 0.0, 1.0, 2.0, 2.0]);
/// assert_eq!([9.0, 12.0, 18.0, 24.0, 30.0].map(|t| support.velocity(t)), [0.0, 0.5, -0.5, 0.5, 0.0]);
/// // The second atom is at (1, 0), its place in the support at (1, 0) + 2 (0.6, 0.8).
/// let [x, y] = support.force(1, &Vector3::x(), 2.0);
/// assert!((x - 2.4).abs() < 1e-15 && (y - 3.2).abs() < 1e-15);
/// assert_eq!(support.energy([Vector3::zeros(), Vector3::x()].iter(), 2.0), 8.0); // two springs
/// ```
///
/// *Units*: any consistent set. *Domain*: `speed` and `stroke` > 0, `stroke` may be infinite.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// The group that is pulled.
    pub group: usize,
    /// x and y at which each atom of the group, in ascending order, is without force at s = 0.
    pub anchors: Vec<[f64; 2]>,
    /// Unit vector e along which the support moves.
    pub direction: [f64; 2],
    /// Stiffness k of the spring of one atom.
    pub stiffness: f64,
    /// Speed of the support.
    pub speed: f64,
    /// Distance from one turning point to the next.
    pub stroke: f64,
    /// Time at which the support begins to move.
    pub from: f64,
    /// Time at which the support stops.
    pub until: f64,
}

impl Support {
    /// Distance s that the support has from its start.
    pub fn position(&self, time: f64) -> f64 {
        let path = self.path(time);
        if path <= self.stroke {
            return path;
        }
        let phase = libm::fmod(path, 2.0 * self.stroke);
        if phase <= self.stroke {
            phase
        } else {
            2.0 * self.stroke - phase
        }
    }

    /// Velocity of the support along its direction; at a turning point that of the next stroke.
    pub fn velocity(&self, time: f64) -> f64 {
        if time < self.from || time >= self.until {
            0.0
        } else if self.path(time) < self.stroke
            || libm::fmod(self.path(time), 2.0 * self.stroke) < self.stroke
        {
            self.speed
        } else {
            -self.speed
        }
    }

    /// Path of the support so far.
    fn path(&self, time: f64) -> f64 {
        let end = if time < self.until { time } else { self.until };
        if end > self.from {
            self.speed * (end - self.from)
        } else {
            0.0
        }
    }

    /// Force on an atom of the group at `place` while the support is at `position`.
    #[inline]
    pub fn force(&self, number: usize, place: &Vector3<f64>, position: f64) -> [f64; 2] {
        let [x, y] = self.anchors[number];
        let [along_x, along_y] = self.direction;
        [
            self.stiffness * (x + position * along_x - place.x),
            self.stiffness * (y + position * along_y - place.y),
        ]
    }

    /// Force on the whole group, whose atoms are given in ascending order.
    pub fn total<'a>(
        &self,
        places: impl Iterator<Item = &'a Vector3<f64>>,
        position: f64,
    ) -> [f64; 2] {
        places
            .enumerate()
            .fold([0.0; 2], |[x, y], (number, place)| {
                let [more_x, more_y] = self.force(number, place, position);
                [x + more_x, y + more_y]
            })
    }

    /// Energy of all springs.
    pub fn energy<'a>(&self, places: impl Iterator<Item = &'a Vector3<f64>>, position: f64) -> f64 {
        let squares = places.enumerate().map(|(number, place)| {
            let [x, y] = self.force(number, place, position);
            x * x + y * y
        });
        0.5 * squares.sum::<f64>() / self.stiffness
    }
}
