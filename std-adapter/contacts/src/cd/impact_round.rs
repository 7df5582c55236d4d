//! One round of impacts: reflection along the normals, friction, and the energies of both.

use super::accelerated::{Accelerated, Tolerance};
use super::energy::kinetic_energy;
use super::gauss_seidel::Iterations;
use super::impact::Impacts;
use super::impact_rest::{TOLERANCE, rests, settle};
use super::memory::find;
use super::operator::Operator;
use super::spheres::{Link, Spheres};
use tribos_core::contact::{Contact, ContactFriction, ContactModes, ContactVector, Frictionless};

impl<F: ContactFriction<f64>> Impacts<F> {
    /// Applies the rebound to the collected contacts.
    pub(super) fn round(&mut self, restitution: f64) {
        let reflected = self.reflect(restitution);
        self.counts.unmet += usize::from(!reflected.met);
        self.counts.impacts += self.reflection.contacts();
        let frictionless = <F::Modes as ContactModes<f64>>::UNKNOWNS
            == <Frictionless as ContactModes<f64>>::UNKNOWNS;
        if frictionless {
            self.spheres.clear();
            self.spheres.extend(self.reflection.moving());
        } else {
            let rubbed = self.apply_friction();
            self.counts.unmet += usize::from(!rubbed.met);
            self.spheres.clear();
            self.spheres.extend(self.friction.moving());
        }
        for (wall, plate) in self.walls.iter_mut().zip(&self.reflection.plates) {
            wall.plate = *plate;
        }
        self.keep(frictionless);
    }

    /// The reflection: impulses that stop the approach, followed by e times the same impulses.
    fn reflect(&mut self, restitution: f64) -> Iterations {
        let problem = &mut self.reflection;
        problem.free.0.clone_from(&self.spheres);
        problem.free.1.clear();
        problem
            .free
            .1
            .extend(self.walls.iter().map(|wall| wall.plate));
        problem.start();
        let before = normal_velocities(problem);
        let goal = Tolerance::from(TOLERANCE);
        let mut iterations = Accelerated::default().solve(problem, goal, self.most_sweeps);
        iterations.met = iterations.met || rests(problem);
        // Σ q·U(w), which is 0 for a solution, and |w − v⁻|²_M: the error in the first must not return as
        // energy.
        let (mut left, mut change) = (0.0, 0.0);
        let stopped = normal_velocities(problem);
        for (link, (before, stopped)) in problem.links().zip(before.iter().zip(stopped)) {
            let impulse = link.contact.impulse().normal;
            left += impulse * stopped;
            change += impulse * (stopped - before);
        }
        let highest = if change > 0.0 {
            1.0 - 2.0 * left / change
        } else {
            1.0
        };
        let factor = 1.0 + restitution.min(highest).max(0.0);
        let rebound = |link: &mut Link<_>| {
            let normal = factor * link.contact.impulse().normal;
            link.contact.set_impulse_in_plane(&modal(normal));
        };
        problem.pairs.change(rebound);
        problem.walls.iter_mut().for_each(rebound);
        problem.refresh();
        let after = normal_velocities(problem);
        for (link, (before, after)) in problem.links().zip(before.iter().zip(after)) {
            self.taken.normal -= 0.5 * link.contact.impulse().normal * (before + after);
        }
        self.taken.work -= drives(problem);
        iterations
    }

    /// Friction under the normal impulses of the reflection.
    fn apply_friction(&mut self) -> Iterations {
        let (source, problem) = (&self.reflection, &mut self.friction);
        problem.free.0.clear();
        problem.free.0.extend(source.moving());
        problem.free.1.clone_from(&source.plates);
        problem.pairs.clear();
        for link in source.pairs.iter() {
            problem.join(&friction_contact(&link));
        }
        problem.images.clone_from(&source.images);
        problem.surfaces.clone_from(&source.surfaces);
        problem.walls.clear();
        problem
            .walls
            .extend(source.walls.iter().map(friction_contact));
        problem.start();
        let iterations = settle(problem, self.most_sweeps);
        let slipped = slipped(problem);
        let shares = jump_shares(problem);
        self.taken.sliding += slipped[0] + shares[0];
        self.taken.rolling += slipped[1] + shares[1];
        self.taken.torsion += slipped[2] + shares[2];
        self.taken.work -= drives(problem);
        iterations
    }

    /// Adds the impulses of all rounds to those of a solved problem; velocities are unchanged.
    pub(super) fn add_to(&self, problem: &mut Spheres<F>) {
        let [pairs, walls] = &self.impulses;
        let (spheres, plates) = (&mut problem.free.0, &mut problem.free.1);
        problem.pairs.change(|link| {
            let bodies = link.bodies.map(|body| body as usize);
            if let (Some(impulse), Ok([a, b])) =
                (find(pairs, link.bodies), spheres.get_disjoint_mut(bodies))
            {
                link.contact
                    .apply(&ContactVector::default().minus(impulse), a, b);
                add(&mut link.contact, impulse);
            }
        });
        for (wall, link) in problem.walls.iter_mut().enumerate() {
            let [a, b] = link.bodies.map(|body| body as usize);
            let Some((impulse, a)) = find(walls, link.bodies).zip(spheres.get_mut(a)) else {
                continue;
            };
            let back = ContactVector::default().minus(impulse);
            if let Some(b) = plates.get_mut(b) {
                link.contact.apply(&back, a, b);
            } else if let Some(b) = problem.surfaces.get_mut(wall) {
                link.contact.apply(&back, a, b);
            }
            add(&mut link.contact, impulse);
        }
    }

    /// Stores the impulses of the round.
    fn keep(&mut self, frictionless: bool) {
        let [pairs, walls] = &mut self.impulses;
        let normal = |link: Link<_>| (link.bodies, modal(link.contact.impulse().normal));
        let rough = |link: Link<F::Modes>| (link.bodies, *link.contact.impulse());
        pairs.extend(self.reflection.pairs.iter().map(normal));
        walls.extend(self.reflection.walls.iter().copied().map(normal));
        if !frictionless {
            pairs.extend(self.friction.pairs.iter().map(rough));
            walls.extend(self.friction.walls.iter().copied().map(rough));
        }
    }
}

/// Contact of a reflection with friction under a given normal impulse: the impulse acts as a cohesion
/// on a contact that cannot move along the normal.
fn friction_contact<M: ContactModes<f64>>(link: &Link<Frictionless>) -> Link<M> {
    let mut prepared = link.contact.prepared();
    prepared.cohesion = link.contact.impulse().normal;
    prepared.block.mass_normal = 0.0;
    Link {
        bodies: link.bodies,
        contact: Contact::resume(&prepared, &ContactVector::default()),
    }
}

/// Adds an impulse to that of a contact, without applying it to the bodies.
fn add<M: ContactModes<f64>>(contact: &mut Contact<f64, M>, impulse: &ContactVector<f64, M>) {
    let sum = contact.impulse().plus_scaled(1.0, impulse);
    contact.set_impulse_in_plane(&sum);
}

/// An impulse along the normal alone.
fn modal<M: ContactModes<f64>>(normal: f64) -> ContactVector<f64, M> {
    let zero = nalgebra::Vector3::zeros();
    ContactVector::new(normal, zero, zero, 0.0)
}

/// Normal velocity of each contact, in the order of their numbers.
fn normal_velocities<F: ContactFriction<f64>>(problem: &Spheres<F>) -> Vec<f64> {
    let pairs = problem.pair_velocities().map(|(_, velocity)| velocity);
    let walls = problem.wall_velocities().map(|(_, velocity)| velocity);
    pairs.chain(walls).map(|velocity| velocity.normal).collect()
}

/// Energy transferred to the drives of walls, of spheres that keep their motion, and of a shear.
fn drives<F: ContactFriction<f64>>(problem: &Spheres<F>) -> f64 {
    let walls = (0..problem.walls.len()).map(|wall| problem.driven_by_wall(wall));
    let pairs = problem
        .pairs
        .iter()
        .map(|link| problem.driven_by_pair(&link));
    let driven = walls.sum::<f64>() + pairs.sum::<f64>();
    if problem.images.is_empty() {
        driven
    } else {
        driven + problem.shear_work()
    }
}

/// Energy −p·U⁺ taken by sliding, rolling and torsion, over all contacts.
fn slipped<F: ContactFriction<f64>>(problem: &Spheres<F>) -> [f64; 3] {
    let pairs = problem.pair_velocities();
    let walls = problem.wall_velocities();
    let mut sums = [0.0; 3];
    for (link, u) in pairs.chain(walls) {
        let p = link.contact.impulse();
        sums[0] -= p.sliding().dot(&u.sliding());
        sums[1] -= p.rolling().dot(&u.rolling());
        sums[2] -= p.torsion() * u.torsion();
    }
    sums
}

/// ½ |v⁺ − v'|²_M of friction, divided among the modes in proportion to the share ½ p²/m of each impulse
/// alone: exact for a contact of spheres whose modes are not coupled.
fn jump_shares<F: ContactFriction<f64>>(problem: &Spheres<F>) -> [f64; 3] {
    let mut jump = 0.0;
    for (old, new) in problem.free.0.iter().zip(&problem.spheres) {
        let (dv, dw) = (new.velocity - old.velocity, new.spin - old.spin);
        jump += kinetic_energy(new, &dv, &dw);
    }
    let mut shares = [0.0; 3];
    for link in problem.links() {
        let (p, block) = (link.contact.impulse(), link.contact.block());
        let torsion = p.torsion();
        shares[0] += alone(p.sliding().norm_squared(), block.mass_sliding);
        shares[1] += alone(p.rolling().norm_squared(), block.inertia);
        shares[2] += alone(torsion * torsion, block.inertia);
    }
    let sum: f64 = shares.iter().sum();
    if sum > 0.0 {
        shares.map(|share| jump * (share / sum))
    } else {
        shares
    }
}

/// ½ p²/m, or 0 if the mode cannot move.
fn alone(impulse_sq: f64, mass: f64) -> f64 {
    if mass > 0.0 {
        0.5 * impulse_sq / mass
    } else {
        0.0
    }
}
