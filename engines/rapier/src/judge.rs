//! Friction on the feet of a group over one step: the kernel's step for one round patch below the
//! centre of mass, elements of area for any other feet.

use crate::feet::{Feet, Solved};
use crate::group::Member;
use crate::pair::Pair;
use crate::patch::Lying;
use crate::reduced::Reduced;
use crate::stand::Stand;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};

/// Input for the friction on a group.
pub(crate) struct Judge<'a> {
    pub(crate) pairs: &'a [Pair],
    pub(crate) members: &'a [Member],
    pub(crate) stands: &'a [Stand],
    /// Motion of each foot relative to its ground minus that of the first, at the centre of mass.
    pub(crate) drifts: Vec<[f64; 3]>,
    pub(crate) reduced: &'a Reduced,
}

impl Judge<'_> {
    /// The only foot on an immovable ground with its load and position, if the kernel has its exact limit
    /// surface.
    fn exact(&self) -> Option<(&Pair, Lying)> {
        let ([member], [stand]) = (self.members, self.stands) else {
            return None;
        };
        let pair = self.pairs.get(member.pair)?;
        let is_exact = !self.reduced.moved[1] && pair.patch.is_exact(stand.place);
        let lying = Lying {
            load: member.touching.load,
            place: stand.place,
            axis: stand.axis,
        };
        is_exact.then_some((pair, lying))
    }

    fn feet(&self) -> Feet {
        let mut feet = Feet {
            elements: Vec::new(),
            places: self.stands.iter().map(|stand| stand.place).collect(),
            drifts: self.drifts.clone(),
        };
        for (number, (member, stand)) in self.members.iter().zip(self.stands).enumerate() {
            if let Some(pair) = self.pairs.get(member.pair) {
                let load = member.touching.load;
                let elements = pair.patch.elements(number, stand.place, stand.axis, load);
                feet.elements.extend(elements);
            }
        }
        feet
    }

    /// The motion after `dt`.
    pub(crate) fn step(
        &self,
        before: &Twist<f32>,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<Solved> {
        let Some((pair, lying)) = self.exact() else {
            return self.feet().step(self.reduced, before, push, dt.dt());
        };
        let step = pair
            .patch
            .step(&self.reduced.body, &lying, before, push, dt)?;
        Some(Solved {
            twist: step.twist,
            friction: step.friction,
            each: vec![step.friction],
            holds: vec![step.is_at_rest],
        })
    }

    /// The fraction of the step until rest.
    pub(crate) fn share(&self, solved: &Solved, before: &Twist<f32>) -> Option<f32> {
        let friction = &solved.friction;
        if let Some((pair, lying)) = self.exact() {
            return pair.patch.share(&lying, friction);
        }
        let power = friction.power(before);
        let share = -power / self.feet().dissipation(before);
        // No friction under no load: no fraction.
        Some(if share > 0.0 { share.min(1.0) } else { 0.0 })
    }
}
