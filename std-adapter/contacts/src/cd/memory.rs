//! Impulses of the last step, used as the initial guess for the next.

use super::spheres::{Link, Spheres};
use tribos_core::contact::{ContactFriction, ContactModes, ContactVector};

/// The force of a former contact, with its two bodies.
///
/// See [`Memory`] for an example.
pub type StoredForce<M> = ([u32; 2], ContactVector<f64, M>);

/// Forces of the last step's contacts, in ascending order of their bodies.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::cd::{IterationOrder, StopRule};
/// # use tribos::cd::internals::{StoredForce, Link, Memory, Spheres, Sweeper, solve};
/// # use tribos::kernel::contact::{Cohesion, Contact, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// # let (up, dt) = (Vector3::z(), 1e-3);
/// # let (spin, velocity) = (Vector3::zeros(), Vector3::new(0.0, 0.0, -9.81 * dt));
/// # let ball = SphereBody { velocity, spin, inv_mass: 1.0, inv_inertia: 1e3 };
/// # let floor = WallBody { velocity: Vector3::zeros(), inv_mass: 0.0 };
/// # let touch = ContactGeometry::plate(0.05, &up, 0.05)?;
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// # let contact = Contact::new(&touch, &law, &ball, &floor, dt);
/// # let mut problem = Spheres::new([IndependentFriction::sliding(0.3)?; 2]);
/// # problem.free = (vec![ball], vec![floor]);
/// # problem.walls.push(Link { bodies: [0, 0], contact });
/// # problem.start();
/// // A ball of 1 kg that rests on the floor, after a step of 1 ms.
/// solve(&mut problem, &mut Sweeper::new(IterationOrder::Fixed, 0), StopRule::Fixed, 1);
/// let mut memory = Memory::default();
/// memory.store(&problem, dt, &[true]);
/// let (bodies, force): StoredForce<_> = memory.forces[1][0];
/// assert_eq!(bodies, [0, 0]); // sphere 0 and wall 0
/// assert!((force.normal - 9.81).abs() < 1e-12);
/// // The impulse that its next step begins with, if that is three times as long.
/// memory.warm_start(&mut problem, 3.0 * dt);
/// let guess = problem.walls[0].contact.impulse().normal;
/// assert!((guess - 9.81 * 3.0 * dt).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Memory<M: ContactModes<f64>> {
    /// Bodies and mean force (impulse over step) of pairs and of contacts with walls.
    pub forces: [Vec<StoredForce<M>>; 2],
}

impl<M: ContactModes<f64>> Default for Memory<M> {
    fn default() -> Self {
        Self {
            forces: [Vec::new(), Vec::new()],
        }
    }
}

impl<M: ContactModes<f64>> Memory<M> {
    /// The force of a contact of this kind, 0 for a pair and 1 at a wall; `None` if it was not in contact.
    #[doc(hidden)]
    pub fn force(&self, kind: usize, bodies: [u32; 2]) -> Option<&ContactVector<f64, M>> {
        find(self.forces.get(kind)?, bodies)
    }

    /// Initialises contacts that existed before with their former force.
    pub fn warm_start<F: ContactFriction<f64, Modes = M>>(
        &self,
        problem: &mut Spheres<F>,
        dt: f64,
    ) {
        let (friction, mixture) = (problem.friction, problem.mixture.as_deref());
        let pair = |bodies| mixture.map_or(friction[0], |mixture| mixture.of_pair(bodies).friction);
        let wall = |bodies| mixture.map_or(friction[1], |mixture| mixture.at_wall(bodies).friction);
        problem
            .pairs
            .change(with_stored_forces(&self.forces[0], pair, dt));
        let recall_wall = with_stored_forces(&self.forces[1], wall, dt);
        problem.walls.iter_mut().for_each(recall_wall);
    }

    /// Stores the forces of this step, and keeps those between bodies that slept through it.
    pub fn store<F: ContactFriction<f64, Modes = M>>(
        &mut self,
        problem: &Spheres<F>,
        dt: f64,
        awake: &[bool],
    ) {
        let force = |link: Link<M>| {
            let force = ContactVector::default().plus_scaled(1.0 / dt, link.contact.impulse());
            (link.bodies, force)
        };
        let sleeps = |body: u32| !awake[body as usize];
        let [pairs, walls] = &mut self.forces;
        pairs.retain(|(bodies, _)| bodies.iter().all(|&body| sleeps(body)));
        pairs.extend(problem.pairs.iter().map(force));
        walls.retain(|(bodies, _)| sleeps(bodies[0]));
        walls.extend(problem.walls.iter().copied().map(force));
        // Sleeping bodies, then the others, each in order: the list is nearly sorted.
        for forces in [pairs, walls] {
            forces.sort_by_key(|(bodies, _)| *bodies);
        }
    }
}

/// The force or impulse of a contact, from a list in ascending order of the bodies.
pub(super) fn find<M: ContactModes<f64>>(
    kept: &[StoredForce<M>],
    bodies: [u32; 2],
) -> Option<&ContactVector<f64, M>> {
    let place = kept.binary_search_by_key(&bodies, |(bodies, _)| *bodies);
    kept.get(place.ok()?).map(|(_, modal)| modal)
}

/// Gives links their former forces; these and the links that follow one another are in ascending order of their
/// bodies.
fn with_stored_forces<M: ContactModes<f64>, F: ContactFriction<f64, Modes = M>>(
    forces: &[StoredForce<M>],
    friction: impl Fn([u32; 2]) -> F,
    dt: f64,
) -> impl FnMut(&mut Link<M>) {
    let mut old = forces.iter().peekable();
    move |link| {
        while old.next_if(|(bodies, _)| *bodies < link.bodies).is_some() {}
        if let Some((_, force)) = old.next_if(|(bodies, _)| *bodies == link.bodies) {
            // The normal has turned since the last step.
            link.contact
                .set_impulse(&ContactVector::default().plus_scaled(dt, force));
            link.contact.project_impulse(&friction(link.bodies));
        }
    }
}
