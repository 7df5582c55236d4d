//! Four contacts of alike spheres solved side by side: the operations of [`Contact::update`] in the same order,
//! with selections in place of branches, so that every bit is the same.

use super::aligned::Aligned;
use super::spheres::Link;
use tribos_core::contact::{Contact, ContactModes, Modal};
use tribos_core::internals::{AxialPart, PlanarPart, project_on_disc};
use tribos_core::nalgebra::Vector3;
use tribos_lanes::Four;

/// Rounding of a projected vector's own square, as in the kernel's projection on a disc.
const COLLAR: f64 = 1.0 + 8.0 * f64::EPSILON;

/// What the contacts that are solved side by side have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Alike {
    /// Inverse mass and inertia of the spheres.
    pub inv_mass: f64,
    pub inv_inertia: f64,
    /// r_eff
    pub lever: f64,
    /// Effective masses along the normal, and of rolling and torsion.
    pub mass_normal: f64,
    pub inertia: f64,
}

impl Alike {
    /// What a contact of two spheres would have in common with others.
    pub fn of<M: ContactModes<f64>>(contact: &Contact<f64, M>, sphere: &Aligned) -> Self {
        Self {
            inv_mass: sphere.inv_mass,
            inv_inertia: sphere.inv_inertia,
            lever: contact.lever(),
            mass_normal: contact.block().mass_normal,
            inertia: contact.block().inertia,
        }
    }

    /// Whether a contact is one of these, to the bit.
    pub fn includes<M: ContactModes<f64>>(
        &self,
        contact: &Contact<f64, M>,
        spheres: [&Aligned; 2],
    ) -> bool {
        let [first, second] = contact.arms();
        let alike = spheres
            .iter()
            .all(|sphere| *self == Self::of(contact, sphere));
        alike && first == second && contact.block().coupling == 0.0 && !contact.rests_open()
    }
}

/// Limits of friction, as [`Thresholds`](tribos_core::contact::Thresholds) has them: sliding, rolling, torsion.
pub(super) type Limits = [f64; 3];

/// Vectors of four contacts or bodies, axis by axis.
type Vectors<L> = [L; 3];

/// What a monitor records of each contact: change², P, speed.
pub(super) type Records = [[f64; 4]; 3];

/// Solves four links without a common sphere, the first of `spheres` having the number `first`; returns what
/// monitors record.
///
/// `None`, and nothing is done, if there is no such sphere.
#[inline(always)]
pub(super) fn update<L: Four, M: ContactModes<f64>>(
    links: &mut [Link<M>; 4],
    (first, spheres): (u32, &mut [Aligned]),
    (alike, limits): &(Alike, Limits),
) -> Option<Records> {
    let place = |lane: usize, end: usize| (links[lane].bodies[end] - first) as usize;
    let places = [
        [place(0, 0), place(1, 0), place(2, 0), place(3, 0)],
        [place(0, 1), place(1, 1), place(2, 1), place(3, 1)],
    ];
    let n: Vectors<L> = gather_vectors(links, |contact| *contact.normal());
    let arm: L = gather(links, |contact| contact.arms()[0]);
    let mass_sliding: L = gather(links, |contact| contact.block().mass_sliding);
    let cohesion: L = gather(links, |contact| contact.cohesion());
    let allowance: L = gather(links, |contact| contact.allowance());
    let old_normal: L = gather(links, |contact| contact.impulse().normal);
    let old_sliding: Vectors<L> = gather_vectors(links, |contact| contact.impulse().sliding());
    let old_rolling: Vectors<L> = gather_vectors(links, |contact| contact.impulse().rolling());
    let old_torsion: L = gather(links, |contact| contact.impulse().torsion());
    let [va, wa] = motions::<L>(spheres, places[0])?;
    let [vb, wb] = motions::<L>(spheres, places[1])?;
    let zero = L::splat(0.0);
    let (mass_normal, inertia) = (L::splat(alike.mass_normal), L::splat(alike.inertia));
    let lever = L::splat(alike.lever);

    // Relative velocity, mode by mode.
    let drift = minus(vb, va);
    let approach = dot(drift, n);
    let turning = minus(wb, wa);
    let spin = dot(turning, n);

    // The impulse along the normal.
    let trial = old_normal - mass_normal * approach;
    let wanted = trial - mass_normal * allowance;
    let new_normal = wanted.less(-cohesion).select(-cohesion, wanted);
    let bound = new_normal + cohesion;
    let change_normal = new_normal - old_normal;
    let mut force = scaled(n, change_normal);
    let mut change_sq = change_normal * change_normal;

    // Sliding.
    let mut new_sliding = [zero; 3];
    let mut moment = [zero; 3];
    if M::Sliding::PRESENT {
        let rim = plus(scaled(wa, arm), scaled(wb, arm));
        let slip = minus(minus(drift, scaled(n, approach)), cross(rim, n));
        let trial = minus(old_sliding, scaled(slip, mass_sliding));
        new_sliding = project(trial, L::splat(limits[0]) * bound);
        let change = minus(new_sliding, old_sliding);
        force = plus(force, change);
        moment = cross(n, change);
        change_sq = change_sq + dot(change, change);
    }

    // Rolling and torsion.
    let turns = M::Rolling::PRESENT || M::Torsion::PRESENT;
    let (mut new_rolling, mut new_torsion) = ([zero; 3], zero);
    let (mut torque, mut torques) = ([zero; 3], zero);
    if turns {
        let mut change_torsion = zero;
        let leverage = bound * lever;
        if M::Torsion::PRESENT {
            let trial = old_torsion - inertia * spin;
            new_torsion = clamp(trial, L::splat(limits[2]) * leverage);
            change_torsion = new_torsion - old_torsion;
        }
        torque = scaled(n, change_torsion);
        if M::Rolling::PRESENT {
            let rolling = minus(turning, scaled(n, spin));
            let trial = minus(old_rolling, scaled(rolling, inertia));
            new_rolling = project(trial, L::splat(limits[1]) * leverage);
            let change = minus(new_rolling, old_rolling);
            torque = plus(torque, change);
            torques = torques + dot(change, change);
        }
        if M::Torsion::PRESENT {
            torques = torques + change_torsion * change_torsion;
        }
        change_sq = change_sq + torques / (lever * lever);
    }

    // The bodies move.
    let push = L::splat(alike.inv_mass);
    let turn = L::splat(alike.inv_inertia);
    let va = plus(va, scaled(force, -push));
    let vb = plus(vb, scaled(force, push));
    let (mut wa, mut wb) = (wa, wb);
    if M::Sliding::PRESENT {
        let answer = -arm * turn;
        wa = plus(wa, scaled(moment, answer));
        wb = plus(wb, scaled(moment, answer));
    }
    if turns {
        wa = plus(wa, scaled(torque, -turn));
        wb = plus(wb, scaled(torque, turn));
    }
    let turned = M::Sliding::PRESENT || turns;
    store(spheres, places[0], va, turned, wa);
    store(spheres, places[1], vb, turned, wb);

    let normals = new_normal.lanes();
    let slidings = axes(new_sliding);
    let rollings = axes(new_rolling);
    let torsions = new_torsion.lanes();
    let vector = |axes: &[[f64; 4]; 3], lane: usize| {
        Vector3::new(axes[0][lane], axes[1][lane], axes[2][lane])
    };
    for (lane, link) in links.iter_mut().enumerate() {
        link.contact.set_impulse_in_plane(&Modal::new(
            normals[lane],
            vector(&slidings, lane),
            vector(&rollings, lane),
            torsions[lane],
        ));
    }
    let speed = change_normal.abs() / mass_normal;
    Some([change_sq.lanes(), bound.lanes(), speed.lanes()])
}

/// A vector of each contact.
#[inline(always)]
fn gather_vectors<L: Four, M: ContactModes<f64>>(
    links: &[Link<M>; 4],
    value: impl Fn(&Contact<f64, M>) -> Vector3<f64>,
) -> Vectors<L> {
    let [a, b, c, d] = links;
    vectors([
        &value(&a.contact),
        &value(&b.contact),
        &value(&c.contact),
        &value(&d.contact),
    ])
}

/// Four vectors, axis by axis. Written out, as `map` of an array may be left a call, which has no AVX2.
#[inline(always)]
fn vectors<L: Four>([a, b, c, d]: [&Vector3<f64>; 4]) -> Vectors<L> {
    [
        L::new([a.x, b.x, c.x, d.x]),
        L::new([a.y, b.y, c.y, d.y]),
        L::new([a.z, b.z, c.z, d.z]),
    ]
}

/// The numbers of four vectors, axis by axis.
#[inline(always)]
fn axes<L: Four>([x, y, z]: Vectors<L>) -> [[f64; 4]; 3] {
    [x.lanes(), y.lanes(), z.lanes()]
}

/// A number of each contact.
#[inline(always)]
fn gather<L: Four, M: ContactModes<f64>>(
    links: &[Link<M>; 4],
    value: impl Fn(&Contact<f64, M>) -> f64,
) -> L {
    let [a, b, c, d] = links;
    L::new([
        value(&a.contact),
        value(&b.contact),
        value(&c.contact),
        value(&d.contact),
    ])
}

/// Velocities and spins of four spheres.
#[inline(always)]
fn motions<L: Four>(spheres: &[Aligned], [a, b, c, d]: [usize; 4]) -> Option<[Vectors<L>; 2]> {
    let (a, b) = (spheres.get(a)?, spheres.get(b)?);
    let (c, d) = (spheres.get(c)?, spheres.get(d)?);
    let velocity = vectors([&a.velocity, &b.velocity, &c.velocity, &d.velocity]);
    let spin = vectors([&a.spin, &b.spin, &c.spin, &d.spin]);
    Some([velocity, spin])
}

/// Gives four spheres their new velocities, and their spins if these have changed.
#[inline(always)]
fn store<L: Four>(
    spheres: &mut [Aligned],
    places: [usize; 4],
    velocity: Vectors<L>,
    turned: bool,
    spin: Vectors<L>,
) {
    let (velocity, spin) = (axes(velocity), axes(spin));
    for lane in 0..4 {
        if let Some(sphere) = spheres.get_mut(places[lane]) {
            sphere.velocity = Vector3::new(velocity[0][lane], velocity[1][lane], velocity[2][lane]);
            if turned {
                sphere.spin = Vector3::new(spin[0][lane], spin[1][lane], spin[2][lane]);
            }
        }
    }
}

#[inline(always)]
fn plus<L: Four>(a: Vectors<L>, b: Vectors<L>) -> Vectors<L> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn minus<L: Four>(a: Vectors<L>, b: Vectors<L>) -> Vectors<L> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn scaled<L: Four>(a: Vectors<L>, s: L) -> Vectors<L> {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline(always)]
fn dot<L: Four>(a: Vectors<L>, b: Vectors<L>) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<L: Four>(a: Vectors<L>, b: Vectors<L>) -> Vectors<L> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// `x` limited to ±`bound`; NaN stays NaN.
#[inline(always)]
fn clamp<L: Four>(x: L, bound: L) -> L {
    let size = x.abs();
    let beyond = bound.less(size).select(bound, L::splat(f64::NAN));
    size.less_or_equal(bound).select(size, beyond).copysign(x)
}

/// The nearest points of discs, as the kernel projects.
#[inline(always)]
fn project<L: Four>(q: Vectors<L>, bound: L) -> Vectors<L> {
    let (zero, one, least) = (L::splat(0.0), L::splat(1.0), L::splat(f64::MIN_POSITIVE));
    let length_sq = dot(q, q);
    let in_range = least
        .less(length_sq)
        .and(length_sq.less(L::splat(f64::INFINITY)));
    let scale = bound * (length_sq.sqrt() * (one / length_sq));
    // Where nothing is to be projected, as at the start, the vector remains.
    let nothing = q[0].equal(zero).and(q[1].equal(zero)).and(q[2].equal(zero));
    let vanishing = scale.less(least).and(zero.less(bound));
    let everywhere = zero.equal(zero);
    let ordinary = in_range.and_not(vanishing).or(nothing);
    if everywhere.and_not(ordinary).any() {
        return project_each(q, bound);
    }
    let inside = length_sq
        .less_or_equal(bound * bound * L::splat(COLLAR))
        .or(nothing);
    scaled(q, inside.select(one, scale))
}

/// Squares and quotients beyond the normal numbers.
#[inline(always)]
fn project_each<L: Four>(q: Vectors<L>, bound: L) -> Vectors<L> {
    let [x, y, z] = nearest_each(axes(q), bound.lanes());
    [L::new(x), L::new(y), L::new(z)]
}

#[cold]
#[inline(never)]
fn nearest_each(q: [[f64; 4]; 3], bounds: [f64; 4]) -> [[f64; 4]; 3] {
    let mut nearest = q;
    for (lane, bound) in bounds.into_iter().enumerate() {
        let one = project_on_disc(&Vector3::new(q[0][lane], q[1][lane], q[2][lane]), bound);
        for (axis, component) in nearest.iter_mut().zip(one.iter()) {
            axis[lane] = *component;
        }
    }
    nearest
}
