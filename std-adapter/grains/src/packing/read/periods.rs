//! Periods that the user says of a file.

use super::{Assembly, AssemblyError};
use crate::packing::SAME_PERIOD;
use tribos_base::space::{AXES, PeriodicBox};

impl Assembly {
    /// Sets the periods, `None` for an open axis, where the file does not say them. *Domain*: periods finite and
    /// positive, no sphere out of its period; those that the file says.
    pub fn with_periods(
        mut self,
        file: &str,
        periods: [Option<f64>; 3],
    ) -> Result<Self, AssemblyError> {
        for (axis, name) in AXES.iter().enumerate() {
            self.begin_at_zero(axis, periods[axis]);
            let old = self.space.lengths()[axis];
            let outside = |length: &f64| {
                let mut places = self.positions.iter();
                places.position(|place| !(0.0..=*length).contains(&place[axis]))
            };
            let reason = match (old, periods[axis]) {
                (Some(old), None) if !self.is_assumed => {
                    format!(
                        "it says that it repeats along {name} after {old}; give {old} in place of -"
                    )
                }
                (Some(old), Some(given)) if old != given => {
                    format!("its period along {name} is {old}, not {given}")
                }
                (None, Some(given)) => match outside(&given) {
                    Some(sphere) => format!(
                        "sphere {sphere} is at {name} = {}, beyond the period from 0 to {given}",
                        self.positions[sphere][axis]
                    ),
                    None => continue,
                },
                _ => continue,
            };
            return Err(AssemblyError::Content {
                file: file.into(),
                reason,
            });
        }
        self.set_periods(file, periods)?;
        Ok(self)
    }

    /// Moves the spheres so that the box of a file, which does not say whether it repeats, begins at 0 along an axis
    /// whose period is its length.
    pub(crate) fn begin_at_zero(&mut self, axis: usize, period: Option<f64>) {
        let [low, high] = self.bounds[axis];
        let is_its =
            period.is_some_and(|period| ((high - low) / period - 1.0).abs() <= SAME_PERIOD);
        if is_its
            && self.has_box
            && self.is_assumed
            && self.space.lengths()[axis].is_none()
            && low != 0.0
        {
            self.positions
                .iter_mut()
                .for_each(|place| place[axis] -= low);
            self.bounds[axis] = [0.0, high - low];
        }
    }

    /// Sets the periods; a new one begins at 0. An axis that is opened keeps the ends of its box.
    pub(crate) fn set_periods(
        &mut self,
        file: &str,
        periods: [Option<f64>; 3],
    ) -> Result<(), AssemblyError> {
        let before = self.space;
        let leans = periods[0].is_some() && periods[2].is_some();
        let space = PeriodicBox::new(periods).map_err(|cause| AssemblyError::Space {
            file: file.into(),
            cause,
        })?;
        self.space = space.sheared(if leans { before.offset() } else { 0.0 });
        for (axis, bounds) in self.bounds.iter_mut().enumerate() {
            if let (None, Some(length)) = (before.lengths()[axis], periods[axis]) {
                *bounds = [0.0, length];
            }
        }
        Ok(())
    }
}
