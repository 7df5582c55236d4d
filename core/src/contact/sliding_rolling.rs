//! Sliding and rolling at one contact, solved together.
//!
//! While one sticks, its equation eliminates it, and what is left is isotropic in the plane: one projection
//! with the mass that the other feels then. The problem is convex: the first case that does not contradict itself
//! is the answer.
//!
//! Where both slip one multiplier is found. A multiplier λ ≥ 0 of the rolling limit raises 1/I to
//! 1/I + λ = 1/(s I): rolling takes the share s ≤ 1 of the torque T that would stop it, this equation
//! eliminates it as where it sticks, and sliding feels the mass m/(1 − s k² m I). The function that sliding then
//! minimises holds the term −s |T|²/(2 I): a larger share has a larger |T|, whatever the masses and whatever
//! forces friction admits. So b/|T| falls as s rises, and the share at which rolling meets its limit b, s = b/|T|, lies between
//! any s and its b/|T|. Newton's method finds it on b/|T|, which is nearly linear in s (Moré & Sorensen, SIAM J. Sci. Stat.
//! Comput. 4 (1983) 553). Where the force p keeps the length of its limit, it only turns:
//!
//! ```text
//! d|T|/ds = |T| k² m I/(1 − s k² m I) (p·T)²/(p·q |T|²)
//! ```
//!
//! with q the force that would stop sliding. Where sliding sticks, the last quotient is 1; under a common limit of sliding and
//! torsion, secants take the place of the derivative.

use super::block::{Block, Masses};
use super::friction::{ContactFriction, TangentialLoad};
use super::modes::ContactVector;
use super::vector::{cross, dot, magnitude};
use crate::real::Real;
use nalgebra::Vector3;

/// What is left of one motion when the other is stopped below which the two count as the same, as
/// for a ball on an axle: rounding of the block, in units of it.
const SINGULAR_ULPS: f64 = 64.0;
/// Newton steps at most before halvings: most contacts take 3.
const MOST_STEPS: usize = 24;
/// Distance of s from b/|T|, of s, that rounding hides: the root is nearer.
const APART_ULPS: f64 = 4.0;
/// Quotient of bounds above which their logarithms are halved, not they.
const FAR_APART: f64 = 4.0;

/// One contact's sliding and rolling with everything else fixed.
pub(super) struct CoupledSlip<'a, R, F> {
    pub friction: &'a F,
    pub block: &'a Block<R>,
    pub normal: &'a Vector3<R>,
    pub lever: R,
    /// P
    pub bound: R,
    /// Impulses so far; torsion as it would be if it stuck.
    pub old: TangentialLoad<R>,
    pub old_rolling: Vector3<R>,
    /// Velocities under them.
    pub slip: Vector3<R>,
    pub roll: Vector3<R>,
}

impl<'a, R: Real, F: ContactFriction<R>> CoupledSlip<'a, R, F> {
    /// Collects the data of the contact, given its `old` impulses and the `velocity` under them.
    #[inline(always)]
    pub fn new(
        friction: &'a F,
        (block, normal, lever): (&'a Block<R>, &'a Vector3<R>, R),
        bound: R,
        old: &ContactVector<R, F::Modes>,
        velocity: &ContactVector<R, F::Modes>,
    ) -> Self {
        Self {
            friction,
            block,
            normal,
            lever,
            bound,
            old: TangentialLoad {
                sliding: old.sliding(),
                torsion: old.torsion() - block.inertia * velocity.torsion(),
            },
            old_rolling: old.rolling(),
            slip: velocity.sliding(),
            roll: velocity.rolling(),
        }
    }

    /// The impulses that obey their thresholds.
    #[inline(never)]
    pub fn solve(&self) -> (TangentialLoad<R>, Vector3<R>) {
        self.solve_sticking()
            .unwrap_or_else(|whole| self.share(whole))
    }

    /// 1 less the share of each mass' inverse that is left when the other motion is stopped: k² m I.
    fn shared_inverse(&self) -> R {
        let (m, inertia, k) = (
            self.block.mass_sliding,
            self.block.inertia,
            self.block.coupling,
        );
        // Without k² where its square is out of range, which the product is not.
        let square = k * k;
        if square > R::MIN_POSITIVE && square < R::INFINITY {
            square * m * inertia
        } else {
            (k * m) * (k * inertia)
        }
    }

    /// The impulses where one of the two motions sticks, or both. Where both slip or are one motion, those of the
    /// largest share of rolling.
    #[inline(always)]
    pub fn solve_sticking(&self) -> Result<(TangentialLoad<R>, Vector3<R>), Shared<R>> {
        let (m, inertia, k) = (
            self.block.mass_sliding,
            self.block.inertia,
            self.block.coupling,
        );
        let shared = self.shared_inverse();
        let left = R::ONE - shared;
        let least_left = R::from_f64(SINGULAR_ULPS) * R::EPSILON;
        let distinct = left > least_left;
        if !distinct {
            // What sliding feels stays finite.
            return Err(self.shared((R::ONE - least_left) / shared, shared));
        }

        // Rolling sticks: sliding feels the mass m/left.
        let slip = self.slip - cross(&self.roll, self.normal) * (k * inertia);
        let whole = self.with_share(R::ONE, &slip, m / left);
        let turned = self.hold_rolling(&whole.stopping);
        if turned == whole.stopping {
            return Ok((whole.held, turned));
        }

        // Sliding sticks: rolling feels the moment I/left.
        let roll = self.roll - cross(self.normal, &self.slip) * (k * m);
        let turned = self.hold_rolling(&(self.old_rolling - roll * (inertia / left)));
        let slip = self.slip_after(&turned);
        let sliding = self.old.sliding - slip * m;
        let held = self.hold(&sliding, m);
        if held.sliding == sliding {
            Ok((held, turned))
        } else {
            Err(whole)
        }
    }

    /// Both slip, or are one motion, whose largest share is `whole`.
    #[inline(never)]
    fn share(&self, whole: Shared<R>) -> (TangentialLoad<R>, Vector3<R>) {
        let shared = self.shared_inverse();
        let rolling = whole.rolling();
        let turned = self.hold_rolling(&rolling);
        if turned == rolling {
            return (whole.held, turned);
        }
        let limit = magnitude(&turned);
        // Nothing resists rolling, as where the contact is open.
        let resists = limit > R::ZERO;
        if !resists {
            return (self.shared(R::ZERO, shared).held, turned);
        }
        let keeps_its_length = self.friction.independent_limits().is_some();
        let (mut low, mut high) = (R::ZERO, whole.share);
        let (mut at, mut before, mut steps) = (whole, None, 0);
        // Until no number lies between the two shares.
        loop {
            // The share of this torque that meets the limit.
            let meets = limit / magnitude(&at.stopping);
            let off = at.share - meets;
            if off.abs() <= R::from_f64(APART_ULPS) * R::EPSILON * at.share {
                // As long as the limit: `stopping` itself may be longer by rounding and still count as held.
                return (at.held, self.hold_rolling(&(at.stopping * meets)));
            }
            if off > R::ZERO {
                high = at.share;
            } else {
                low = at.share;
            }
            let fall = match before {
                Some((share, met)) if !keeps_its_length => (met - meets) / (at.share - share),
                _ => meets * at.growth(shared),
            };
            let root = (meets + fall * at.share) / (R::ONE + fall);
            let next = if steps < MOST_STEPS && low < root && root < high {
                root
            } else {
                middle(low, high)
            };
            if !(low < next && next < high) {
                return self.between(&self.shared(low, shared), &self.shared(high, shared));
            }
            steps += 1;
            before = Some((at.share, meets));
            at = self.shared(next, shared);
        }
    }

    /// The impulses when rolling takes a share of the torque that would stop it.
    #[inline(always)]
    fn shared(&self, share: R, shared: R) -> Shared<R> {
        let alone = self.rolling_that_sticks(&self.old.sliding) * share;
        let mass = self.block.mass_sliding / (R::ONE - share * shared);
        self.with_share(share, &self.slip_after(&alone), mass)
    }

    /// The same, given the slip of the mass that sliding then feels.
    #[inline(always)]
    fn with_share(&self, share: R, slip: &Vector3<R>, mass: R) -> Shared<R> {
        let sliding = self.old.sliding - slip * mass;
        let held = self.hold(&sliding, mass);
        Shared {
            share,
            sliding,
            held,
            stopping: self.rolling_that_sticks(&held.sliding),
        }
    }

    /// The impulses between two that balance under one multiplier, where rolling meets its limit: all that
    /// lies between them balances as they do, and both may jump from one number to the next.
    fn between(&self, within: &Shared<R>, beyond: &Shared<R>) -> (TangentialLoad<R>, Vector3<R>) {
        let [near, far] = [within.rolling(), beyond.rolling()];
        let limit = self.hold_rolling(&far);
        let size = sum(&far);
        let way = (far - near) / size;
        let [start, limit] = [near, limit].map(|torque| torque / size);
        // |start + x way| = |limit|
        let [square, along] = [dot(&way, &way), dot(&start, &way)];
        let room = dot(&limit, &limit) - dot(&start, &start);
        let root = (along * along + square * room).sqrt();
        let part = if along > R::ZERO {
            room / (along + root)
        } else {
            (root - along) / square
        };
        let part = if part > R::ZERO && part <= R::ONE {
            part
        } else {
            R::ZERO
        };
        let [from, to] = [&within.held, &beyond.held];
        let load = TangentialLoad {
            sliding: from.sliding + (to.sliding - from.sliding) * part,
            torsion: from.torsion + (to.torsion - from.torsion) * part,
        };
        let masses = self.block.masses();
        let held = self.friction.hold(&load, self.bound, self.lever, &masses);
        // As long as the limit, to which both ends are near.
        let torque = start + way * part;
        let length = dot(&torque, &torque).sqrt();
        let rolling = if length > R::ZERO {
            torque * (dot(&limit, &limit).sqrt() / length * size)
        } else {
            torque
        };
        (held, self.hold_rolling(&rolling))
    }

    /// Sliding velocity after a rolling torque.
    #[inline(always)]
    fn slip_after(&self, rolling: &Vector3<R>) -> Vector3<R> {
        self.slip + cross(&(rolling - self.old_rolling), self.normal) * self.block.coupling
    }

    /// The rolling torque that stops rolling under a sliding force.
    #[inline(always)]
    fn rolling_that_sticks(&self, sliding: &Vector3<R>) -> Vector3<R> {
        let turn = cross(self.normal, &(sliding - self.old.sliding)) * self.block.coupling;
        self.old_rolling - (self.roll + turn) * self.block.inertia
    }

    /// The sliding force and torsion torque that a mass takes whose slip the force `sliding` would stop.
    #[inline(always)]
    fn hold(&self, sliding: &Vector3<R>, mass: R) -> TangentialLoad<R> {
        let trial = TangentialLoad {
            sliding: *sliding,
            torsion: self.old.torsion,
        };
        let masses = Masses {
            sliding: mass,
            torsion: self.block.inertia,
        };
        self.friction.hold(&trial, self.bound, self.lever, &masses)
    }

    #[inline(always)]
    fn hold_rolling(&self, trial: &Vector3<R>) -> Vector3<R> {
        self.friction.hold_rolling(trial, self.bound, self.lever)
    }
}

/// Impulses of which rolling has a given share.
pub(super) struct Shared<R> {
    /// s
    share: R,
    /// The force that would stop sliding.
    sliding: Vector3<R>,
    held: TangentialLoad<R>,
    /// T, which would stop rolling.
    stopping: Vector3<R>,
}

impl<R: Real> Shared<R> {
    /// s T, not yet limited.
    #[inline(always)]
    fn rolling(&self) -> Vector3<R> {
        self.stopping * self.share
    }

    /// d|T|/ds of |T| while sliding keeps its length, for `shared` = k² m I.
    #[inline(always)]
    fn growth(&self, shared: R) -> R {
        let alone = shared / (R::ONE - self.share * shared);
        let force = &self.held.sliding;
        if *force == self.sliding {
            return alone;
        }
        let across = dot(force, &self.stopping);
        alone
            * (across / dot(force, &self.sliding))
            * (across / dot(&self.stopping, &self.stopping))
    }
}

/// Half-way between two shares, by logarithms while that is quicker.
fn middle<R: Real>(low: R, high: R) -> R {
    if low == R::ZERO {
        // Down to 0 after a dozen.
        R::HALF * high * high
    } else if high > R::from_f64(FAR_APART) * low {
        low.sqrt() * high.sqrt()
    } else {
        R::HALF * (low + high)
    }
}

#[inline(always)]
fn sum<R: Real>(v: &Vector3<R>) -> R {
    v.x.abs() + v.y.abs() + v.z.abs()
}
