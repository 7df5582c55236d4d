//! A foot under a body.

use crate::area::{Area, Element};
use crate::footprint::Footprint;

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
