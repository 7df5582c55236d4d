//! Vectors of four contacts or bodies, axis by axis: read, computed with, and written.
//!
//! Functions in place of closures: a closure may be left a call, which has no AVX2.

use super::aligned::Aligned;
use tribos_core::contact::{ContactModes, ContactVector};
use tribos_core::internals::{AxialPart, PlanarPart};
use tribos_core::nalgebra::Vector3;
use tribos_lanes::Four;

/// Rounding of a projected vector's own square, as in the kernel's projection on a disc.
const COLLAR: f64 = 1.0 + 8.0 * f64::EPSILON;

/// Vectors of four contacts or bodies, axis by axis.
pub(super) type Vectors<L> = [L; 3];

/// Impulses of four contacts; zero in modes that these do not have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impulses<L> {
    pub normal: L,
    pub sliding: Vectors<L>,
    pub rolling: Vectors<L>,
    pub torsion: L,
}

impl<L: Four> Impulses<L> {
    /// No impulses.
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = L::splat(0.0);
        Self {
            normal: zero,
            sliding: [zero; 3],
            rolling: [zero; 3],
            torsion: zero,
        }
    }

    /// The impulses of four contacts.
    #[inline(always)]
    pub fn read<M: ContactModes<f64>>([a, b, c, d]: [&ContactVector<f64, M>; 4]) -> Self {
        let mut read = Self::zero();
        if M::Sliding::PRESENT {
            let [normal, x, y, z] = L::columns([forces(a), forces(b), forces(c), forces(d)]);
            (read.normal, read.sliding) = (normal, [x, y, z]);
        } else {
            read.normal = L::new([a.normal, b.normal, c.normal, d.normal]);
        }
        if M::Rolling::PRESENT {
            let [x, y, z, torsion] = L::columns([torques(a), torques(b), torques(c), torques(d)]);
            (read.rolling, read.torsion) = ([x, y, z], torsion);
        } else if M::Torsion::PRESENT {
            read.torsion = L::new([a.torsion(), b.torsion(), c.torsion(), d.torsion()]);
        }
        read
    }

    /// Differences, mode by mode.
    #[inline(always)]
    pub fn minus<M: ContactModes<f64>>(&self, other: &Self) -> Self {
        let mut change = Self::zero();
        change.normal = self.normal - other.normal;
        if M::Sliding::PRESENT {
            change.sliding = minus(self.sliding, other.sliding);
        }
        if M::Rolling::PRESENT {
            change.rolling = minus(self.rolling, other.rolling);
        }
        if M::Torsion::PRESENT {
            change.torsion = self.torsion - other.torsion;
        }
        change
    }

    /// Products of impulses, with torques counted as forces at a lever, whose square this is.
    #[inline(always)]
    pub fn dot<M: ContactModes<f64>>(&self, other: &Self, lever_sq: L) -> L {
        let mut sum = self.normal * other.normal;
        if M::Sliding::PRESENT {
            sum = sum + dot(self.sliding, other.sliding);
        }
        let mut torques = L::splat(0.0);
        if M::Rolling::PRESENT {
            torques = torques + dot(self.rolling, other.rolling);
        }
        if M::Torsion::PRESENT {
            torques = torques + self.torsion * other.torsion;
        }
        if M::Rolling::PRESENT || M::Torsion::PRESENT {
            sum = sum + torques / lever_sq;
        }
        sum
    }

    /// The impulses, contact by contact.
    #[inline(always)]
    pub fn write<M: ContactModes<f64>>(self) -> [ContactVector<f64, M>; 4] {
        let [x, y, z] = self.sliding;
        let forces = if M::Sliding::PRESENT {
            L::rows([self.normal, x, y, z])
        } else {
            let [a, b, c, d] = self.normal.lanes();
            let row = |normal| [normal, 0.0, 0.0, 0.0];
            [row(a), row(b), row(c), row(d)]
        };
        let [x, y, z] = self.rolling;
        let torques = if M::Rolling::PRESENT {
            L::rows([x, y, z, self.torsion])
        } else {
            let [a, b, c, d] = self.torsion.lanes();
            let row = |torsion| [0.0, 0.0, 0.0, torsion];
            [row(a), row(b), row(c), row(d)]
        };
        let one = |lane: usize| {
            let [normal, x, y, z] = forces[lane];
            let [u, v, w, torsion] = torques[lane];
            ContactVector::new(
                normal,
                Vector3::new(x, y, z),
                Vector3::new(u, v, w),
                torsion,
            )
        };
        [one(0), one(1), one(2), one(3)]
    }
}

/// Normal impulse and sliding.
#[inline(always)]
fn forces<M: ContactModes<f64>>(one: &ContactVector<f64, M>) -> [f64; 4] {
    let sliding = one.sliding();
    [one.normal, sliding.x, sliding.y, sliding.z]
}

/// Rolling and torsion.
#[inline(always)]
fn torques<M: ContactModes<f64>>(one: &ContactVector<f64, M>) -> [f64; 4] {
    let rolling = one.rolling();
    [rolling.x, rolling.y, rolling.z, one.torsion()]
}

/// Four spheres in motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bodies<L> {
    pub velocity: Vectors<L>,
    pub spin: Vectors<L>,
    pub inv_mass: L,
    pub inv_inertia: L,
}

impl<L: Four> Bodies<L> {
    /// The spheres at four places; `None` if there is none at one of them.
    #[inline(always)]
    pub fn read(spheres: &[Aligned], [a, b, c, d]: [usize; 4]) -> Option<Self> {
        let (a, b) = (spheres.get(a)?, spheres.get(b)?);
        let (c, d) = (spheres.get(c)?, spheres.get(d)?);
        let [vx, vy, vz, wx] = L::columns([first(a), first(b), first(c), first(d)]);
        let [wy, wz, inv_mass, inv_inertia] =
            L::columns([second(a), second(b), second(c), second(d)]);
        Some(Self {
            velocity: [vx, vy, vz],
            spin: [wx, wy, wz],
            inv_mass,
            inv_inertia,
        })
    }

    /// Gives the spheres at four places these velocities and, where these have `turned`, these spins.
    #[inline(always)]
    pub fn write(self, spheres: &mut [Aligned], places: [usize; 4], turned: bool) {
        let ([vx, vy, vz], [wx, wy, wz]) = (self.velocity, self.spin);
        let (first, second) = (L::rows([vx, vy, vz, wx]), L::pairs([wy, wz]));
        for lane in 0..4 {
            if let Some(sphere) = spheres.get_mut(places[lane]) {
                let [x, y, z, spin] = first[lane];
                sphere.velocity = Vector3::new(x, y, z);
                if turned {
                    let [y, z] = second[lane];
                    sphere.spin = Vector3::new(spin, y, z);
                }
            }
        }
    }
}

/// First half of a sphere: velocity and x of the spin.
#[inline(always)]
fn first(one: &Aligned) -> [f64; 4] {
    let velocity = &one.velocity;
    [velocity.x, velocity.y, velocity.z, one.spin.x]
}

/// Second half: y and z of the spin, the inverses.
#[inline(always)]
fn second(one: &Aligned) -> [f64; 4] {
    [one.spin.y, one.spin.z, one.inv_mass, one.inv_inertia]
}

#[inline(always)]
pub(super) fn plus<L: Four>(a: Vectors<L>, b: Vectors<L>) -> Vectors<L> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(super) fn minus<L: Four>(a: Vectors<L>, b: Vectors<L>) -> Vectors<L> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
pub(super) fn scaled<L: Four>(a: Vectors<L>, s: L) -> Vectors<L> {
    [a[0] * s, a[1] * s, a[2] * s]
}

#[inline(always)]
pub(super) fn dot<L: Four>(a: Vectors<L>, b: Vectors<L>) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(super) fn cross<L: Four>(a: Vectors<L>, b: Vectors<L>) -> Vectors<L> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Numbers that all contacts have in common, four times each: a processor computes with them where they are in memory.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct Constants {
    /// Limits of friction over P, and over P r_eff: sliding, rolling, torsion.
    pub limits: [[f64; 4]; 3],
    one: [f64; 4],
    least: [f64; 4],
    infinity: [f64; 4],
    nan: [f64; 4],
    collar: [f64; 4],
}

impl Constants {
    /// Those of friction with these limits.
    pub fn new(limits: [f64; 3]) -> Self {
        Self {
            limits: limits.map(|limit| [limit; 4]),
            one: [1.0; 4],
            least: [f64::MIN_POSITIVE; 4],
            infinity: [f64::INFINITY; 4],
            nan: [f64::NAN; 4],
            collar: [COLLAR; 4],
        }
    }

    /// `x` limited to ±`bound`; NaN stays NaN.
    #[inline(always)]
    pub fn clamp<L: Four>(&self, x: L, bound: L) -> L {
        let size = x.abs();
        let beyond = bound.less(size).select(bound, L::new(self.nan));
        size.less_or_equal(bound).select(size, beyond).copysign(x)
    }

    /// The nearest points of discs, as the kernel projects, and where these are right: where neither a square nor a
    /// quotient leaves the normal numbers.
    #[inline(always)]
    pub fn project<L: Four>(&self, q: Vectors<L>, bound: L) -> (Vectors<L>, L) {
        let (zero, one, least) = (L::splat(0.0), L::new(self.one), L::new(self.least));
        let length_sq = dot(q, q);
        let in_range = least
            .less(length_sq)
            .and(length_sq.less(L::new(self.infinity)));
        let scale = bound * (length_sq.sqrt() * (one / length_sq));
        // Where nothing is to be projected, as at the start, the vector remains: no bit but signs is set.
        let nothing = q[0].or(q[1]).or(q[2]).equal(zero);
        let vanishing = scale.less(least).and(zero.less(bound));
        let inside = length_sq
            .less_or_equal(bound * bound * L::new(self.collar))
            .or(nothing);
        let nearest = scaled(q, inside.select(one, scale));
        (nearest, in_range.and_not(vanishing).or(nothing))
    }
}
