//! Which pairs are solved four at a time.

use super::aligned::Aligned;
use super::four::{Alike, Limits};
use super::spheres::Link;
use std::ops::Range;
use tribos_core::contact::ContactModes;

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
    pub fn arrange<M: ContactModes<f64>>(
        &mut self,
        limits: Option<Limits>,
        parts: impl Iterator<Item = Range<usize>>,
        pairs: &[Link<M>],
        spheres: &[Aligned],
    ) {
        self.clear();
        let (Some(limits), Some(first)) = (limits, pairs.first()) else {
            return;
        };
        let Some(sphere) = spheres.get(first.bodies[0] as usize) else {
            return;
        };
        let alike = Alike::of(&first.contact, sphere);
        self.common = Some((alike, limits));
        self.begins.resize(pairs.len(), false);
        let is_alike = |link: &Link<M>| {
            let [a, b] = link.bodies.map(|body| spheres.get(body as usize));
            matches!((a, b), (Some(a), Some(b)) if alike.includes(&link.contact, [a, b]))
        };
        for part in parts {
            let mut at = part.start;
            while let Some(four) = pairs[..part.end].get(at..at + LANES) {
                let grouped = are_apart(four) && four.iter().all(is_alike);
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
fn are_apart<M: ContactModes<f64>>(four: &[Link<M>]) -> bool {
    four.iter().enumerate().all(|(at, link)| {
        let others = four.iter().take(at).flat_map(|other| other.bodies);
        others.into_iter().all(|body| !link.bodies.contains(&body))
    })
}
