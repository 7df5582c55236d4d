//! Deposits cut at a height.

use super::Deposit;

impl Deposit {
    /// The deposit without the spheres that reach above `height` and those that rest on them.
    pub(super) fn cut(&self, height: f64) -> Self {
        let mut low = Self {
            positions: Vec::new(),
            radii: Vec::new(),
            parents: Vec::new(),
            height: 0.0,
            ..*self
        };
        // Parents come first, so that each sphere's parent already has its new number.
        let mut numbers: Vec<Option<u32>> = Vec::with_capacity(self.positions.len());
        for (index, (&position, &radius)) in self.positions.iter().zip(&self.radii).enumerate() {
            let top = position.z + radius;
            let parent = self.parents[index].map(|parent| numbers[parent as usize]);
            let is_held = parent != Some(None);
            if top <= height && is_held {
                numbers.push(Some(low.positions.len() as u32));
                low.positions.push(position);
                low.radii.push(radius);
                low.parents.push(parent.flatten());
                low.height = low.height.max(top);
            } else {
                numbers.push(None);
            }
        }
        low
    }
}
