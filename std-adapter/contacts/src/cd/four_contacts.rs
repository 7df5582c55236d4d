//! Four contacts of spheres solved side by side: the operations of `Contact::take_turn` in the same order, with
//! selections in place of branches, so that every bit is the same.

use super::aligned::Aligned;
use super::quads::{LANES, Quad};
use super::vectors::{Bodies, Constants, Impulses, Vectors, cross, dot, minus, plus, scaled};
use tribos_core::contact::{ContactModes, ContactVector};
use tribos_core::internals::{AxialPart, PlanarPart};
use tribos_lanes::Four;

/// What a monitor records of each contact: change², P, speed, and the product with the step before.
pub(super) type Records = [[f64; 4]; 4];

/// Where four contacts are, and between which spheres.
struct Places<L> {
    /// Numbers of the first and of the second spheres.
    bodies: [[usize; 4]; 2],
    normal: Vectors<L>,
    /// Distances of the first and of the second centres from the contacts.
    arms: [L; 2],
}

impl<L: Four> Places<L> {
    /// Those of four pairs; the first of the spheres has the number `first`.
    #[inline(always)]
    fn of(quad: &Quad, first: u32) -> Self {
        let place = |lane: usize, end: usize| (quad.bodies(lane)[end] - first) as usize;
        let [x, y, z] = &quad.normal;
        Self {
            bodies: [
                [place(0, 0), place(1, 0), place(2, 0), place(3, 0)],
                [place(0, 1), place(1, 1), place(2, 1), place(3, 1)],
            ],
            normal: [L::new(*x), L::new(*y), L::new(*z)],
            arms: [L::new(quad.arms[0]), L::new(quad.arms[1])],
        }
    }

    /// The spheres, the first and the second ones.
    #[inline(always)]
    fn bodies(&self, spheres: &[Aligned]) -> Option<[Bodies<L>; 2]> {
        let a = Bodies::read(spheres, self.bodies[0])?;
        Some([a, Bodies::read(spheres, self.bodies[1])?])
    }

    /// Lets impulses move the spheres.
    #[inline(always)]
    fn apply<M: ContactModes<f64>>(
        &self,
        impulses: &Impulses<L>,
        [mut a, mut b]: [Bodies<L>; 2],
        spheres: &mut [Aligned],
    ) {
        let n = self.normal;
        let mut force = scaled(n, impulses.normal);
        if M::Sliding::PRESENT {
            force = plus(force, impulses.sliding);
        }
        a.velocity = plus(a.velocity, scaled(force, -a.inv_mass));
        b.velocity = plus(b.velocity, scaled(force, b.inv_mass));
        if M::Sliding::PRESENT {
            let moment = cross(n, impulses.sliding);
            let [arm_a, arm_b] = self.arms;
            a.spin = plus(a.spin, scaled(moment, -arm_a * a.inv_inertia));
            b.spin = plus(b.spin, scaled(moment, -arm_b * b.inv_inertia));
        }
        if turns::<M>() {
            let mut torque = scaled(n, impulses.torsion);
            if M::Rolling::PRESENT {
                torque = plus(torque, impulses.rolling);
            }
            a.spin = plus(a.spin, scaled(torque, -a.inv_inertia));
            b.spin = plus(b.spin, scaled(torque, b.inv_inertia));
        }
        let turned = M::Sliding::PRESENT || turns::<M>();
        a.write(spheres, self.bodies[0], turned);
        b.write(spheres, self.bodies[1], turned);
    }
}

/// Whether contacts have torques of their own.
#[inline(always)]
fn turns<M: ContactModes<f64>>() -> bool {
    M::Rolling::PRESENT || M::Torsion::PRESENT
}

/// Solves four pairs without a common sphere, the first of `spheres` having the number `first`; returns what
/// monitors record, if these are `watched`. A step before led from these impulses, if there are such, to the ones now.
///
/// `None`, and nothing is done, if there is no such sphere, or where numbers need the kernel's care.
#[inline(always)]
pub(super) fn update<L: Four, M: ContactModes<f64>>(
    quad: &Quad,
    impulses: &mut [ContactVector<f64, M>; LANES],
    watched: Option<Option<&[ContactVector<f64, M>; LANES]>>,
    (first, spheres): (u32, &mut [Aligned]),
    constants: &Constants,
) -> Option<Records> {
    let places = Places::<L>::of(quad, first);
    let old = read::<L, M>(impulses);
    let [a, b] = places.bodies(spheres)?;
    let (n, [arm_a, arm_b]) = (places.normal, places.arms);
    let (mass_normal, inertia) = (L::new(quad.mass_normal), L::new(quad.inertia));

    // Relative velocity, mode by mode.
    let drift = minus(b.velocity, a.velocity);
    let approach = dot(drift, n);
    let turning = minus(b.spin, a.spin);
    let spin = dot(turning, n);

    let mut new = Impulses::zero();
    let trial = old.normal - mass_normal * approach;
    new.normal = trial - mass_normal * L::new(quad.allowance);
    let mut limits = Limits::new(&mut new, quad, constants);
    if M::Sliding::PRESENT {
        let rim = plus(scaled(a.spin, arm_a), scaled(b.spin, arm_b));
        let slip = minus(minus(drift, scaled(n, approach)), cross(rim, n));
        let trial = minus(old.sliding, scaled(slip, L::new(quad.mass_sliding)));
        new.sliding = limits.slide(trial);
    }
    if M::Torsion::PRESENT {
        new.torsion = limits.twist(old.torsion - inertia * spin);
    }
    if M::Rolling::PRESENT {
        let mut roll = minus(turning, scaled(n, spin));
        if M::Sliding::PRESENT {
            let push = minus(new.sliding, old.sliding);
            roll = coupled(roll, n, push, L::new(quad.coupling));
        }
        new.rolling = limits.roll(minus(old.rolling, scaled(roll, inertia)));
    }
    if limits.need_care() {
        return None;
    }

    let change = new.minus::<M>(&old);
    places.apply::<M>(&change, [a, b], spheres);
    let mut seen = Records::default();
    if let Some(swept) = watched {
        let lever = L::new(quad.lever);
        let lever_sq = lever * lever;
        let change_sq = change.dot::<M>(&change, lever_sq);
        let along = match swept {
            Some(swept) => {
                let before = old.minus::<M>(&read::<L, M>(swept));
                change.dot::<M>(&before, lever_sq)
            }
            None => L::splat(0.0),
        };
        let speed = change.normal.abs() / mass_normal;
        seen = [
            change_sq.lanes(),
            limits.bound.lanes(),
            speed.lanes(),
            along.lanes(),
        ];
    }
    *impulses = new.write();
    Some(seen)
}

/// Rolling velocities after pushes, where the two are coupled.
#[inline(always)]
fn coupled<L: Four>(roll: Vectors<L>, n: Vectors<L>, push: Vectors<L>, coupling: L) -> Vectors<L> {
    let zero = L::splat(0.0);
    let alone = coupling.equal(zero);
    // Of alike spheres none is: what rolls need not wait for what slides.
    if !zero.equal(zero).and_not(alone).any() {
        return roll;
    }
    let [x, y, z] = plus(roll, scaled(cross(n, push), coupling));
    [
        alone.select(roll[0], x),
        alone.select(roll[1], y),
        alone.select(roll[2], z),
    ]
}

/// Moves the impulses of four pairs without a common sphere on by `beta` times their last step, to what the
/// contacts admit, and applies them to the spheres. `swept` are the impulses before that step, then those further on.
///
/// `None`, and nothing is done, if there is no such sphere, or where numbers need the kernel's care.
#[inline(always)]
pub(super) fn extrapolate<L: Four, M: ContactModes<f64>>(
    quad: &Quad,
    now: &[ContactVector<f64, M>; LANES],
    swept: &mut [ContactVector<f64, M>; LANES],
    (first, spheres): (u32, &mut [Aligned]),
    beta: f64,
    constants: &Constants,
) -> Option<()> {
    let places = Places::<L>::of(quad, first);
    let bodies = places.bodies(spheres)?;
    let (now, old) = (read::<L, M>(now), read::<L, M>(swept));
    let mut new = Impulses::zero();
    new.normal = ahead(now.normal, old.normal, beta);
    let mut limits = Limits::new(&mut new, quad, constants);
    if M::Sliding::PRESENT {
        new.sliding = limits.slide(all_ahead(now.sliding, old.sliding, beta));
    }
    if M::Torsion::PRESENT {
        new.torsion = limits.twist(ahead(now.torsion, old.torsion, beta));
    }
    if M::Rolling::PRESENT {
        new.rolling = limits.roll(all_ahead(now.rolling, old.rolling, beta));
    }
    if limits.need_care() {
        return None;
    }
    places.apply::<M>(&new, bodies, spheres);
    *swept = new.write();
    Some(())
}

/// A number that goes on by `beta` times the step to it, as `ContactVector::plus_scaled` rounds.
#[inline(always)]
fn ahead<L: Four>(now: L, old: L, beta: f64) -> L {
    now + L::splat(beta) * (now - old)
}

#[inline(always)]
fn all_ahead<L: Four>(now: Vectors<L>, old: Vectors<L>, beta: f64) -> Vectors<L> {
    [
        ahead(now[0], old[0], beta),
        ahead(now[1], old[1], beta),
        ahead(now[2], old[2], beta),
    ]
}

/// What friction admits under the normal impulses.
struct Limits<'a, L> {
    /// P
    bound: L,
    /// P r_eff
    leverage: L,
    constants: &'a Constants,
    /// Where nothing needs the kernel's care so far.
    ordinary: L,
}

impl<'a, L: Four> Limits<'a, L> {
    /// Those of normal impulses, which are first raised to what cohesion admits.
    #[inline(always)]
    fn new(impulses: &mut Impulses<L>, quad: &Quad, constants: &'a Constants) -> Self {
        let (normal, cohesion) = (impulses.normal, L::new(quad.cohesion));
        impulses.normal = normal.less(-cohesion).select(-cohesion, normal);
        let (bound, zero) = (impulses.normal + cohesion, L::splat(0.0));
        Self {
            bound,
            leverage: bound * L::new(quad.lever),
            constants,
            ordinary: zero.equal(zero),
        }
    }

    #[inline(always)]
    fn slide(&mut self, trial: Vectors<L>) -> Vectors<L> {
        self.project(trial, L::new(self.constants.limits[0]) * self.bound)
    }

    #[inline(always)]
    fn roll(&mut self, trial: Vectors<L>) -> Vectors<L> {
        self.project(trial, L::new(self.constants.limits[1]) * self.leverage)
    }

    #[inline(always)]
    fn twist(&self, trial: L) -> L {
        let bound = L::new(self.constants.limits[2]) * self.leverage;
        self.constants.clamp(trial, bound)
    }

    #[inline(always)]
    fn project(&mut self, trial: Vectors<L>, bound: L) -> Vectors<L> {
        let (nearest, ordinary) = self.constants.project(trial, bound);
        self.ordinary = self.ordinary.and(ordinary);
        nearest
    }

    /// Whether a projection is right for the kernel alone.
    #[inline(always)]
    fn need_care(&self) -> bool {
        let zero = L::splat(0.0);
        zero.equal(zero).and_not(self.ordinary).any()
    }
}

/// The impulses of four pairs.
#[inline(always)]
fn read<L: Four, M: ContactModes<f64>>(
    [a, b, c, d]: &[ContactVector<f64, M>; LANES],
) -> Impulses<L> {
    Impulses::read([a, b, c, d])
}
