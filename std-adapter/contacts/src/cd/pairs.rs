//! Contacts of spheres in memory: their geometry, which sweeps only read, apart from their impulses.

use super::identical_spheres::{Alike, AlikePair};
use super::spheres::Link;
use tribos_core::contact::{Contact, ContactModes, ContactVector, SphereBody};
use tribos_core::internals::PreparedContact;

/// Contacts of spheres. As long as all of them join spheres of one mass and radius they take 120 bytes each with
/// all modes, 176 otherwise.
///
/// See [`Spheres`](super::spheres::Spheres) for an example.
#[derive(Clone, Debug)]
pub struct Pairs<M: ContactModes<f64>> {
    geometry: Geometry,
    /// Their impulses.
    pub impulses: Vec<ContactVector<f64, M>>,
}

/// What sweeps do not change.
#[derive(Clone, Debug)]
enum Geometry {
    /// Contacts of alike spheres, and what they have in common.
    Alike(Alike, Vec<AlikePair>),
    /// Contacts of any spheres.
    Any(Vec<AnyPair>),
}

/// A contact with its bodies, without its impulse.
type AnyPair = ([u32; 2], PreparedContact<f64>);

impl<M: ContactModes<f64>> Default for Pairs<M> {
    fn default() -> Self {
        Self {
            geometry: Geometry::Any(Vec::new()),
            impulses: Vec::new(),
        }
    }
}

impl<M: ContactModes<f64>> Pairs<M> {
    /// Bytes of a contact of alike spheres, and of any.
    pub const BYTES: [usize; 2] = [
        size_of::<AlikePair>() + size_of::<ContactVector<f64, M>>(),
        size_of::<AnyPair>() + size_of::<ContactVector<f64, M>>(),
    ];

    /// Number of contacts.
    pub fn len(&self) -> usize {
        self.impulses.len()
    }

    /// Bytes of each contact.
    pub fn contact_bytes(&self) -> usize {
        let [alike, any] = Self::BYTES;
        match self.geometry {
            Geometry::Alike(..) => alike,
            Geometry::Any(_) => any,
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.impulses.is_empty()
    }

    /// Removes all contacts and keeps their memory.
    pub fn clear(&mut self) {
        self.impulses.clear();
        match &mut self.geometry {
            Geometry::Alike(_, pairs) => pairs.clear(),
            Geometry::Any(pairs) => pairs.clear(),
        }
    }

    /// Adds a contact of two spheres; without them it counts as one of any spheres.
    pub fn push(&mut self, link: &Link<M>, spheres: Option<[&SphereBody<f64>; 2]>) {
        let alike = spheres.and_then(|[a, b]| Alike::of(&link.contact, [a, b]));
        if self.is_empty()
            && let Some(alike) = alike
        {
            let mut kept = match &mut self.geometry {
                Geometry::Alike(_, pairs) => std::mem::take(pairs),
                Geometry::Any(_) => Vec::new(),
            };
            kept.clear();
            self.geometry = Geometry::Alike(alike, kept);
        }
        if let Geometry::Alike(common, _) = &self.geometry
            && alike != Some(*common)
        {
            self.geometry = Geometry::Any((0..self.len()).filter_map(|at| self.any(at)).collect());
        }
        match &mut self.geometry {
            Geometry::Alike(_, pairs) => pairs.push(AlikePair::new(link.bodies, &link.contact)),
            Geometry::Any(pairs) => pairs.push((link.bodies, link.contact.prepared())),
        }
        self.impulses.push(*link.contact.impulse());
    }

    /// A contact without its impulse.
    fn any(&self, at: usize) -> Option<AnyPair> {
        let link = self.get(at)?;
        Some((link.bodies, link.contact.prepared()))
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
        self.geometry.view()
    }

    /// Contacts without impulses, and the impulses.
    pub(super) fn split(&mut self) -> (View<'_>, &mut [ContactVector<f64, M>]) {
        (self.geometry.view(), &mut self.impulses)
    }

    /// Puts the contacts into the order of a list of their numbers.
    pub(super) fn arrange(&mut self, order: impl Iterator<Item = usize> + Clone) {
        match &mut self.geometry {
            Geometry::Alike(_, pairs) => arrange(pairs, order.clone()),
            Geometry::Any(pairs) => arrange(pairs, order.clone()),
        }
        arrange(&mut self.impulses, order);
    }
}

impl Geometry {
    fn view(&self) -> View<'_> {
        match self {
            Self::Alike(common, pairs) => View::Alike(common, pairs),
            Self::Any(pairs) => View::Any(pairs),
        }
    }
}

fn arrange<T: Copy>(list: &mut Vec<T>, order: impl Iterator<Item = usize>) {
    *list = order.map(|at| list[at]).collect();
}

/// Contacts without their impulses.
#[derive(Clone, Copy, Debug)]
pub(super) enum View<'a> {
    Alike(&'a Alike, &'a [AlikePair]),
    Any(&'a [AnyPair]),
}

impl View<'_> {
    /// Those from one on.
    pub fn after(self, at: usize) -> Self {
        match self {
            Self::Alike(common, pairs) => Self::Alike(common, pairs.get(at..).unwrap_or_default()),
            Self::Any(pairs) => Self::Any(pairs.get(at..).unwrap_or_default()),
        }
    }

    /// The bodies of a contact.
    #[inline(always)]
    pub fn bodies(&self, at: usize) -> Option<[u32; 2]> {
        match self {
            Self::Alike(_, pairs) => pairs.get(at).map(AlikePair::bodies),
            Self::Any(pairs) => pairs.get(at).map(|(bodies, _)| *bodies),
        }
    }

    /// A contact with an impulse.
    #[inline(always)]
    pub fn contact<M: ContactModes<f64>>(
        &self,
        at: usize,
        impulse: &ContactVector<f64, M>,
    ) -> Option<Contact<f64, M>> {
        match self {
            Self::Alike(common, pairs) => {
                let prepared = pairs.get(at)?.prepared(common);
                Some(Contact::resume(&prepared, impulse))
            }
            Self::Any(pairs) => Some(Contact::resume(&pairs.get(at)?.1, impulse)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;
    use tribos_core::contact::{AllModes, Attraction, Cohesion, ContactGeometry, NormalLaw};

    /// A contact at this gap of a unit sphere with one of this radius, and both spheres.
    fn link(number: u32, gap: f64, radius: f64) -> (Link<AllModes>, [SphereBody<f64>; 2]) {
        let spheres = [1.0, radius].map(|radius| crate::cd::solid(radius, 1.0));
        let [a, b] = &spheres;
        let cohesion = Cohesion::new(2.0, 0.1, Attraction::Resistance).expect("in range");
        let law = NormalLaw::new(cohesion, 0.0).expect("in range");
        let apart = Vector3::new(0.3, -0.2, 0.9).normalize() * (1.0 + radius + gap);
        let touch = ContactGeometry::spheres(&apart, [1.0, radius]).expect("they are apart");
        let mut contact = Contact::new(&touch, &law, a, b, 0.01);
        let vector = Vector3::repeat(f64::from(number));
        contact.set_impulse(&ContactVector::new(0.5, vector, -vector, 0.1));
        let bodies = [number, number + 1];
        (Link { bodies, contact }, spheres)
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
        assert!(given[0].0.contact.holds_gap_open() && !given[2].0.contact.holds_gap_open());
        let mut pairs = Pairs::default();
        // Twice: memory is kept.
        for _ in 0..2 {
            pairs.clear();
            for (number, (link, [a, b])) in given.iter().enumerate() {
                pairs.push(link, Some([a, b]));
                let alike = number < 3;
                assert_eq!(pairs.contact_bytes(), if alike { 120 } else { 176 });
                let there: Vec<_> = pairs.iter().collect();
                let here: Vec<_> = given[..=number].iter().map(|(link, _)| *link).collect();
                assert_eq!(there, here);
            }
        }
    }
}
