//! Four contacts of alike spheres solved side by side: the operations of [`Contact::update`] in the same order,
//! with selections in place of branches, so that every bit is the same.

use super::aligned::Aligned;
use super::identical_spheres::{Alike, AlikePair};
use super::vectors::{Bodies, Impulses, Vectors, clamp, cross, dot, minus, plus, project, scaled};
use tribos_core::contact::{ContactModes, ContactVector};
use tribos_core::internals::{AxialPart, PlanarPart};
use tribos_lanes::Four;

/// Limits of friction, as [`IndependentFriction`](tribos_core::contact::Thresholds) has them: sliding, rolling, torsion.
pub(super) type Limits = [f64; 3];

/// What a monitor records of each contact: change², P, speed, and the product with the step before.
pub(super) type Records = [[f64; 4]; 4];

/// Where four contacts are, and between which spheres.
struct Places<L> {
    /// Numbers of the first and of the second spheres.
    bodies: [[usize; 4]; 2],
    normal: Vectors<L>,
    /// Distance of both centres from the contact.
    arm: L,
}

impl<L: Four> Places<L> {
    /// Those of four pairs; the first of the spheres has the number `first`.
    #[inline(always)]
    fn of(pairs: &[AlikePair; 4], first: u32) -> Self {
        let place = |lane: usize, end: usize| (pairs[lane].bodies()[end] - first) as usize;
        let [a, b, c, d] = pairs;
        let [x, y, z, arm] = L::transpose([place_row(a), place_row(b), place_row(c), place_row(d)]);
        Self {
            bodies: [
                [place(0, 0), place(1, 0), place(2, 0), place(3, 0)],
                [place(0, 1), place(1, 1), place(2, 1), place(3, 1)],
            ],
            normal: [x, y, z],
            arm,
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
        alike: &Alike,
        [mut a, mut b]: [Bodies<L>; 2],
        spheres: &mut [Aligned],
    ) {
        let n = self.normal;
        let (push, turn) = (L::splat(alike.inv_mass), L::splat(alike.inv_inertia));
        let mut force = scaled(n, impulses.normal);
        if M::Sliding::PRESENT {
            force = plus(force, impulses.sliding);
        }
        a.velocity = plus(a.velocity, scaled(force, -push));
        b.velocity = plus(b.velocity, scaled(force, push));
        if M::Sliding::PRESENT {
            let moment = cross(n, impulses.sliding);
            let answer = -self.arm * turn;
            a.spin = plus(a.spin, scaled(moment, answer));
            b.spin = plus(b.spin, scaled(moment, answer));
        }
        if turns::<M>() {
            let mut torque = scaled(n, impulses.torsion);
            if M::Rolling::PRESENT {
                torque = plus(torque, impulses.rolling);
            }
            a.spin = plus(a.spin, scaled(torque, -turn));
            b.spin = plus(b.spin, scaled(torque, turn));
        }
        let turned = M::Sliding::PRESENT || turns::<M>();
        a.write(spheres, self.bodies[0], turned);
        b.write(spheres, self.bodies[1], turned);
    }
}

/// Normal and arm of a pair.
#[inline(always)]
fn place_row<L: Four>(pair: &AlikePair) -> L {
    let normal = &pair.normal;
    L::new([normal.x, normal.y, normal.z, pair.arm])
}

/// Whether contacts have torques of their own.
#[inline(always)]
fn turns<M: ContactModes<f64>>() -> bool {
    M::Rolling::PRESENT || M::Torsion::PRESENT
}

/// Solves four pairs without a common sphere, the first of `spheres` having the number `first`; returns what
/// monitors record. The step before led from `swept` to the impulses.
///
/// `None`, and nothing is done, if there is no such sphere.
#[inline(always)]
pub(super) fn update<L: Four, M: ContactModes<f64>>(
    pairs: &[AlikePair; 4],
    impulses: &mut [ContactVector<f64, M>; 4],
    swept: Option<&[ContactVector<f64, M>; 4]>,
    (first, spheres): (u32, &mut [Aligned]),
    (alike, limits): &(Alike, Limits),
) -> Option<Records> {
    let places = Places::<L>::of(pairs, first);
    let [cohesion, allowance] = limits_of::<L>(pairs);
    let old = read::<L, M>(impulses);
    let [a, b] = places.bodies(spheres)?;
    let (n, arm) = (places.normal, places.arm);
    let (mass_normal, inertia) = (L::splat(alike.mass_normal), L::splat(alike.inertia));

    // Relative velocity, mode by mode.
    let drift = minus(b.velocity, a.velocity);
    let approach = dot(drift, n);
    let turning = minus(b.spin, a.spin);
    let spin = dot(turning, n);

    let mut new = Impulses::zero();
    let trial = old.normal - mass_normal * approach;
    new.normal = trial - mass_normal * allowance;
    if M::Sliding::PRESENT {
        let rim = plus(scaled(a.spin, arm), scaled(b.spin, arm));
        let slip = minus(minus(drift, scaled(n, approach)), cross(rim, n));
        new.sliding = minus(old.sliding, scaled(slip, mass_sliding(alike, arm)));
    }
    if M::Torsion::PRESENT {
        new.torsion = old.torsion - inertia * spin;
    }
    if M::Rolling::PRESENT {
        let rolling = minus(turning, scaled(n, spin));
        new.rolling = minus(old.rolling, scaled(rolling, inertia));
    }
    let bound = admit::<L, M>(&mut new, cohesion, alike.lever, limits);

    let change = new.minus::<M>(&old);
    let lever_sq = L::splat(alike.lever * alike.lever);
    let change_sq = change.dot::<M>(&change, lever_sq);
    let along = match swept {
        Some(swept) => {
            let before = old.minus::<M>(&read::<L, M>(swept));
            change.dot::<M>(&before, lever_sq)
        }
        None => L::splat(0.0),
    };

    places.apply::<M>(&change, alike, [a, b], spheres);
    *impulses = new.write();
    let speed = change.normal.abs() / mass_normal;
    Some([
        change_sq.lanes(),
        bound.lanes(),
        speed.lanes(),
        along.lanes(),
    ])
}

/// Moves the impulses of four pairs without a common sphere on by `beta` times their last step, to what the
/// contacts admit, and applies them to the spheres. `swept` are the impulses before that step, then those further on.
///
/// `None`, and nothing is done, if there is no such sphere.
#[inline(always)]
pub(super) fn extrapolate<L: Four, M: ContactModes<f64>>(
    pairs: &[AlikePair; 4],
    now: &[ContactVector<f64, M>; 4],
    swept: &mut [ContactVector<f64, M>; 4],
    (first, spheres): (u32, &mut [Aligned]),
    beta: f64,
    (alike, limits): &(Alike, Limits),
) -> Option<()> {
    let places = Places::<L>::of(pairs, first);
    let bodies = places.bodies(spheres)?;
    let (now, old) = (read::<L, M>(now), read::<L, M>(swept));
    let mut new = Impulses::zero();
    new.normal = ahead(now.normal, old.normal, beta);
    if M::Sliding::PRESENT {
        new.sliding = all_ahead(now.sliding, old.sliding, beta);
    }
    if M::Rolling::PRESENT {
        new.rolling = all_ahead(now.rolling, old.rolling, beta);
    }
    if M::Torsion::PRESENT {
        new.torsion = ahead(now.torsion, old.torsion, beta);
    }
    let [cohesion, _] = limits_of::<L>(pairs);
    admit::<L, M>(&mut new, cohesion, alike.lever, limits);
    places.apply::<M>(&new, alike, bodies, spheres);
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

/// Replaces impulses by the nearest ones that cohesion and friction admit; returns P.
#[inline(always)]
fn admit<L: Four, M: ContactModes<f64>>(
    impulses: &mut Impulses<L>,
    cohesion: L,
    lever: f64,
    limits: &Limits,
) -> L {
    let normal = impulses.normal;
    impulses.normal = normal.less(-cohesion).select(-cohesion, normal);
    let bound = impulses.normal + cohesion;
    if M::Sliding::PRESENT {
        impulses.sliding = project(impulses.sliding, L::splat(limits[0]) * bound);
    }
    let leverage = bound * L::splat(lever);
    if M::Torsion::PRESENT {
        impulses.torsion = clamp(impulses.torsion, L::splat(limits[2]) * leverage);
    }
    if M::Rolling::PRESENT {
        impulses.rolling = project(impulses.rolling, L::splat(limits[1]) * leverage);
    }
    bound
}

/// Effective masses of sliding, as the kernel computes them.
#[inline(always)]
fn mass_sliding<L: Four>(alike: &Alike, arm: L) -> L {
    let turning = arm * arm * L::splat(alike.inv_inertia);
    let inverse = L::splat(alike.inv_mass + alike.inv_mass) + turning + turning;
    L::splat(1.0) / inverse
}

/// Cohesion and allowance of four pairs.
#[inline(always)]
fn limits_of<L: Four>([a, b, c, d]: &[AlikePair; 4]) -> [L; 2] {
    [
        L::new([a.cohesion, b.cohesion, c.cohesion, d.cohesion]),
        L::new([a.allowance, b.allowance, c.allowance, d.allowance]),
    ]
}

/// The impulses of four pairs.
#[inline(always)]
fn read<L: Four, M: ContactModes<f64>>([a, b, c, d]: &[ContactVector<f64, M>; 4]) -> Impulses<L> {
    Impulses::read([a, b, c, d])
}
