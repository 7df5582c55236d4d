//! A foot under a body.

use crate::area::{Area, Element};
use crate::footprint::Footprint;

/// Length of a direction's part in the plane below which the direction is undefined there: within a hundredth of the
/// normal.
const LEAST_AXIS: f64 = 1e-2;

/// Where a foot stands in the plane.
///
/// ```
/// let stance = tribos_feet::Stance::new([0.1, 0.0], [2.0, 0.0]);
/// assert_eq!(stance.axis, [1.0, 0.0]);
/// assert!((stance.turned(0.05).place[1] - 0.1 * 0.1_f64.sin()).abs() < 1e-5);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Stance {
    /// The foot's centre from the centre of mass in metres.
    pub place: [f64; 2],
    /// Direction of its x axis, of length 1.
    pub axis: [f64; 2],
}

impl Stance {
    /// At a place in metres; `along` is the part of the foot's x axis in the plane.
    pub fn new(place: [f32; 2], along: [f32; 2]) -> Self {
        let [c, s] = along.map(f64::from);
        let length = (c * c + s * s).sqrt();
        let axis = match length > LEAST_AXIS {
            true => [c / length, s / length],
            false => [1.0, 0.0],
        };
        Self {
            place: place.map(f64::from),
            axis,
        }
    }

    /// The stance turned about the centre of mass by an angle, given half of it in radians; accurate to third order.
    pub fn turned(self, half: f32) -> Self {
        let half = f64::from(half);
        let scale = 1.0 / (1.0 + half * half);
        let [cos, sin] = [(1.0 - half * half) * scale, 2.0 * half * scale];
        let turn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        Self {
            place: turn(self.place),
            axis: turn(self.axis),
        }
    }
}

/// A foot under a body.
///
/// ```
/// use tribos_feet::{Foot, Footprint};
/// let blade = Footprint::bar(0.14)?;
/// let aside = Foot { axis: [0.0, 1.0], ..Foot::new(&blade, 8.0, [0.0, 0.1]) }; // along the second axis
/// assert_eq!(aside.place, [0.0, 0.1]);
/// # Ok::<(), tribos_feet::FootprintError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Foot<'a> {
    /// The shape.
    pub footprint: &'a Footprint,
    /// Friction limit μN in newtons.
    pub limit: f32,
    /// The foot's centre from the centre of mass in metres, in the plane.
    pub place: [f64; 2],
    /// Direction of its x axis in the plane, of length 1.
    pub axis: [f64; 2],
    /// Motion of the foot relative to its ground minus that of the first foot relative to its own, at the
    /// centre of mass: two velocities in m/s and the spin in rad/s.
    pub drift: [f64; 3],
}

impl<'a> Foot<'a> {
    /// A foot whose x axis is the plane's, on the ground of the first foot.
    pub fn new(footprint: &'a Footprint, limit: f32, place: [f64; 2]) -> Self {
        Self {
            footprint,
            limit,
            place,
            axis: [1.0, 0.0],
            drift: [0.0; 3],
        }
    }

    /// Adds the elements of the foot, labelled with its index. A foot without friction has none.
    pub(crate) fn add_elements(&self, number: usize, to: &mut Vec<Element<'a>>) {
        let limit = f64::from(self.limit);
        let presses = limit > 0.0;
        if !presses {
            return;
        }
        let one = |area: Area<'a>, place: [f64; 2], share: f32| Element {
            place,
            area,
            limit: limit * f64::from(share),
            foot: number,
        };
        let (place, [c, s]) = (self.place, self.axis);
        let point = |&[x, y, share]: &[f32; 3]| {
            let [x, y] = [x, y].map(f64::from);
            let place = [place[0] + c * x - s * y, place[1] + s * x + c * y];
            one(Area::Point, place, share)
        };
        match self.footprint.round_friction() {
            Some(round) => to.push(one(Area::Round(round), place, 1.0)),
            None => to.extend(self.footprint.points().iter().map(point)),
        }
    }
}
