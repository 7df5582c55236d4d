//! Contacts of spheres in memory: their geometry, which sweeps only read, apart from their impulses.

use super::quads::{Group, LANES, Quad};
use super::spheres::Link;
use std::ops::Range;
use tribos_core::contact::{Contact, ContactModes, ContactVector};
use tribos_core::internals::PreparedContact;

/// Contacts of spheres, 172 bytes each with all modes.
///
/// See [`Spheres`](super::spheres::Spheres) for an example.
#[derive(Clone, Debug)]
pub struct Pairs<M: ContactModes<f64>> {
    /// Geometry, four contacts to a record.
    quads: Vec<Quad>,
    /// Where each contact is: [`LANES`] times its record, plus its lane.
    places: Vec<u32>,
    /// What each record holds, once the contacts are in the order of a sweep.
    groups: Vec<Group>,
    /// Their impulses.
    pub impulses: Vec<ContactVector<f64, M>>,
}

impl<M: ContactModes<f64>> Default for Pairs<M> {
    fn default() -> Self {
        Self {
            quads: Vec::new(),
            places: Vec::new(),
            groups: Vec::new(),
            impulses: Vec::new(),
        }
    }
}

impl<M: ContactModes<f64>> Pairs<M> {
    /// Bytes of a contact, of which there are two copies while contacts are put in order.
    pub const BYTES: usize =
        size_of::<Quad>() / LANES + size_of::<u32>() + size_of::<ContactVector<f64, M>>();

    /// Number of contacts.
    pub fn len(&self) -> usize {
        self.impulses.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.impulses.is_empty()
    }

    /// Removes all contacts.
    pub fn clear(&mut self) {
        self.quads.clear();
        self.places.clear();
        self.groups.clear();
        self.impulses.clear();
    }

    /// Adds a contact of two spheres.
    pub fn push(&mut self, link: &Link<M>) {
        self.append(false, link.bodies, &link.contact.prepared());
        self.impulses.push(*link.contact.impulse());
    }

    /// Adds a contact without its impulse: to the last record if that has a lane left, or to a new one.
    fn append(&mut self, apart: bool, bodies: [u32; 2], contact: &PreparedContact<f64>) {
        let next = self.places.last().map_or(0, |place| place + 1);
        let lane = next as usize % LANES;
        let start = apart || lane == 0;
        if start {
            self.quads.push(Quad::default());
        }
        let record = self.quads.len() - 1;
        let lane = if start { 0 } else { lane };
        self.quads[record].set(lane, bodies, contact);
        self.places.push((LANES * record + lane) as u32);
    }

    /// A contact with its bodies.
    pub fn get(&self, at: usize) -> Option<Link<M>> {
        let view = self.view();
        let (bodies, impulse) = (view.bodies(at)?, self.impulses.get(at)?);
        let contact = view.contact(at, impulse)?;
        Some(Link { bodies, contact })
    }

    /// All contacts in order.
    pub fn iter(&self) -> impl Iterator<Item = Link<M>> {
        (0..self.len()).filter_map(|at| self.get(at))
    }

    /// Lets `change` set the impulse of every contact; nothing else of a contact is kept.
    pub fn change(&mut self, mut change: impl FnMut(&mut Link<M>)) {
        for at in 0..self.len() {
            if let Some(mut link) = self.get(at) {
                change(&mut link);
                self.impulses[at] = *link.contact.impulse();
            }
        }
    }

    /// The contacts without their impulses.
    pub(super) fn view(&self) -> View<'_> {
        View {
            quads: &self.quads,
            places: &self.places,
            groups: &self.groups,
        }
    }

    /// Contacts without impulses, and the impulses.
    pub(super) fn split(&mut self) -> (View<'_>, &mut [ContactVector<f64, M>]) {
        let view = View {
            quads: &self.quads,
            places: &self.places,
            groups: &self.groups,
        };
        (view, &mut self.impulses)
    }

    /// Puts the contacts into the order of a list of their numbers. Four that follow one another in a part and can be
    /// solved side by side share a record; between them up to four others do.
    pub(super) fn arrange(&mut self, order: &[u32], parts: impl Iterator<Item = Range<usize>>) {
        let old = std::mem::take(self);
        let kept = |number: &u32| old.impulses[*number as usize];
        self.impulses.extend(order.iter().map(kept));
        for part in parts {
            let mut at = part.start;
            while at < part.end {
                let numbers = &order[at..part.end.min(at + LANES)];
                let quad = old.quad_of(numbers);
                let together = numbers.len() == LANES && quad.are_apart();
                let count = if together { LANES } else { 1 };
                let last = self.groups.last_mut();
                let room = last.filter(|group| {
                    let is_open = !group.together && (group.count as usize) < LANES;
                    !together && is_open && at > part.start
                });
                if let Some(group) = room {
                    group.count += 1;
                } else {
                    self.groups.push(Group {
                        first: at as u32,
                        count: count as u32,
                        together,
                    });
                }
                for lane in 0..count {
                    let start = lane == 0 && self.groups.len() > self.quads.len();
                    self.append(start, quad.bodies(lane), &quad.prepared(lane));
                }
                at += count;
            }
        }
    }

    /// Up to four contacts by their numbers.
    fn quad_of(&self, numbers: &[u32]) -> Quad {
        let mut quad = Quad::default();
        for (lane, number) in numbers.iter().enumerate() {
            let (from, at) = place(self.places[*number as usize]);
            let from = &self.quads[from];
            quad.set(lane, from.bodies(at), &from.prepared(at));
        }
        quad
    }
}

/// Record and lane.
#[inline(always)]
fn place(place: u32) -> (usize, usize) {
    (place as usize / LANES, place as usize % LANES)
}

/// Contacts without their impulses.
#[derive(Clone, Copy, Debug)]
pub(super) struct View<'a> {
    quads: &'a [Quad],
    places: &'a [u32],
    groups: &'a [Group],
}

impl<'a> View<'a> {
    /// The record of a contact, and its lane in that.
    #[inline(always)]
    fn lane(self, at: usize) -> Option<(&'a Quad, usize)> {
        let (record, lane) = place(*self.places.get(at)?);
        Some((self.quads.get(record)?, lane))
    }

    /// The bodies of a contact.
    #[inline(always)]
    pub fn bodies(self, at: usize) -> Option<[u32; 2]> {
        let (quad, lane) = self.lane(at)?;
        Some(quad.bodies(lane))
    }

    /// A contact with an impulse.
    #[inline(always)]
    pub fn contact<M: ContactModes<f64>>(
        self,
        at: usize,
        impulse: &ContactVector<f64, M>,
    ) -> Option<Contact<f64, M>> {
        let (quad, lane) = self.lane(at)?;
        Some(Contact::resume(&quad.prepared(lane), impulse))
    }

    /// The records of a part of the contacts.
    pub fn records(self, part: &Range<usize>) -> Range<usize> {
        let record = |at: usize| self.places.get(at).map_or(0, |at| place(*at).0);
        if part.is_empty() {
            return 0..0;
        }
        record(part.start)..record(part.end - 1) + 1
    }

    /// A record.
    #[inline(always)]
    pub fn quad(self, record: usize) -> Option<&'a Quad> {
        self.quads.get(record)
    }

    /// The contacts of a record.
    #[inline(always)]
    pub fn group(self, record: usize) -> Option<Group> {
        self.groups.get(record).copied()
    }

    /// Number of the first of four contacts that are solved side by side, if this record has such.
    #[inline(always)]
    pub fn four(self, record: usize) -> Option<usize> {
        let group = self.group(record)?;
        group.together.then_some(group.first as usize)
    }

    /// Number of contacts that are solved side by side.
    pub fn together(self) -> usize {
        LANES * self.groups.iter().filter(|group| group.together).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;
    use tribos_core::contact::{AllModes, Attraction, Cohesion, ContactGeometry, NormalLaw};

    /// A contact at this gap of a unit sphere with one of this radius.
    fn link(number: u32, gap: f64, radius: f64) -> Link<AllModes> {
        let [a, b] = &[1.0, radius].map(|radius| crate::cd::solid(radius, 1.0));
        let cohesion = Cohesion::new(2.0, 0.1, Attraction::Resistance).expect("in range");
        let law = NormalLaw::new(cohesion, 0.0).expect("in range");
        let apart = Vector3::new(0.3, -0.2, 0.9).normalize() * (1.0 + radius + gap);
        let touch = ContactGeometry::spheres(&apart, [1.0, radius]).expect("they are apart");
        let mut contact = Contact::new(&touch, &law, a, b, 0.01);
        let vector = Vector3::repeat(f64::from(number));
        contact.set_impulse(&ContactVector::new(0.5, vector, -vector, 0.1));
        let bodies = [number, number + 1];
        Link { bodies, contact }
    }

    #[test]
    fn contacts_come_back_as_they_were_given() {
        let given: Vec<_> = [
            (0.02, 1.0),
            (0.0, 1.0),
            (-0.01, 1.0),
            (-0.01, 0.5),
            (0.0, 1.0),
        ]
        .into_iter()
        .zip(0..)
        .map(|((gap, radius), number)| link(number, gap, radius))
        .collect();
        assert!(given[0].contact.holds_gap_open() && !given[2].contact.holds_gap_open());
        let mut pairs = Pairs::default();
        // Twice: once with the memory of before.
        for _ in 0..2 {
            pairs.clear();
            for (number, link) in given.iter().enumerate() {
                pairs.push(link);
                assert_eq!(pairs.iter().collect::<Vec<_>>(), given[..=number]);
            }
        }
        // In another order, in which the contacts of a part fill one record after another.
        let order = [4, 2, 0, 1, 3];
        pairs.arrange(&order, [0..2, 2..5].into_iter());
        let turned: Vec<_> = order.iter().map(|at| given[*at as usize]).collect();
        assert_eq!(pairs.iter().collect::<Vec<_>>(), turned);
        let view = pairs.view();
        assert_eq!([view.records(&(0..2)), view.records(&(2..5))], [0..1, 1..2]);
        assert_eq!(Pairs::<AllModes>::BYTES, 172);
    }

    #[test]
    fn four_contacts_share_a_record_where_no_two_share_a_sphere_and_no_gap_rests_open() {
        // Spheres 0 and 1, 1 and 2, and so on; contact 6 rests open.
        let gap = |number| if number == 6 { 0.02 } else { 0.0 };
        for (order, kinds) in [
            (
                [6, 0, 2, 4, 8, 1, 3, 5, 7, 9],
                [(0, 1, false), (1, 4, true), (5, 4, true), (9, 1, false)],
            ),
            (
                [1, 0, 2, 4, 8, 3, 6, 5, 7, 9],
                [(0, 1, false), (1, 4, true), (5, 4, false), (9, 1, false)],
            ),
        ] {
            let mut pairs = Pairs::default();
            (0..10).for_each(|number| pairs.push(&link(number, gap(number), 1.0)));
            pairs.arrange(&order, std::iter::once(0..10));
            let groups = (0..).map_while(|record| pairs.view().group(record));
            let found: Vec<_> = groups
                .map(|group| (group.first, group.count, group.together))
                .collect();
            assert_eq!(found, kinds);
        }
    }
}
