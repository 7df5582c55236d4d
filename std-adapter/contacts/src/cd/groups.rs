//! Which pairs are solved four at a time.

use super::four_contacts::Limits;
use super::identical_spheres::{Alike, AlikePair};
use super::pairs::View;
use std::ops::Range;

/// Number of pairs solved at a time.
pub(super) const LANES: usize = 4;

/// The groups of a problem: four consecutive pairs of alike spheres, no two of which share one.
#[derive(Clone, Debug, Default)]
pub(super) struct Grouping {
    /// Whether a group begins at a pair.
    begins: Vec<bool>,
    /// What the contacts have in common, and the limits of their friction.
    common: Option<(Alike, Limits)>,
}

/// The groups of some of the pairs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Groups<'a> {
    begins: &'a [bool],
    /// What the contacts have in common, and the limits of their friction.
    pub common: &'a (Alike, Limits),
}

impl Groups<'_> {
    /// The groups from a pair on, which counts as the first.
    #[inline(always)]
    pub fn after(self, at: usize) -> Self {
        let begins = self.begins.get(at..).unwrap_or_default();
        Groups { begins, ..self }
    }

    /// Whether a group begins here.
    #[inline(always)]
    pub fn begins(&self, at: usize) -> bool {
        self.begins.get(at).is_some_and(|begins| *begins)
    }
}

impl Grouping {
    /// Groups the pairs of each part, greedily in their order. Without `limits` there are no groups.
    pub fn arrange(
        &mut self,
        limits: Option<Limits>,
        parts: impl Iterator<Item = Range<usize>>,
        pairs: View<'_>,
    ) {
        self.clear();
        let (Some(limits), View::Alike(alike, pairs)) = (limits, pairs) else {
            return;
        };
        self.common = Some((*alike, limits));
        self.begins.resize(pairs.len(), false);
        for part in parts {
            let mut at = part.start;
            while let Some(four) = pairs[..part.end].get(at..at + LANES) {
                let grouped = are_apart(four) && !four.iter().any(AlikePair::rests_open);
                self.begins[at] = grouped;
                at += if grouped { LANES } else { 1 };
            }
        }
    }

    /// Leaves every pair by itself.
    pub fn clear(&mut self) {
        self.begins.clear();
        self.common = None;
    }

    /// Number of pairs in groups.
    pub fn count(&self) -> usize {
        LANES * self.begins.iter().filter(|begins| **begins).count()
    }

    /// The groups of a part.
    pub fn of(&self, part: Range<usize>) -> Option<Groups<'_>> {
        let (begins, common) = (self.begins.get(part)?, self.common.as_ref()?);
        Some(Groups { begins, common })
    }
}

/// Whether no two of these pairs share a sphere.
fn are_apart(four: &[AlikePair]) -> bool {
    four.iter().enumerate().all(|(at, pair)| {
        let others = four.iter().take(at).flat_map(AlikePair::bodies);
        others
            .into_iter()
            .all(|body| !pair.bodies().contains(&body))
    })
}
