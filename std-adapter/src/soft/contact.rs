//! One contact: springs and dashpots in all modes, with thresholds.

use super::law::Stiffness;
use super::transport::Transport;
use nalgebra::Vector3;
use tribos_core::contact::{Cohesion, ContactFriction, ContactModes, Modal, Touch};
use tribos_core::internals::{AxialPart, Block, Masses, PlanarPart, TangentialLoad};

/// A pair of neighbours, or a sphere near a wall, with the springs of its contact.
///
/// See [`World`](super::World) for an example.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoftContact<M: ContactModes<f64>> {
    /// First body, a sphere; second body, a sphere or a wall.
    pub bodies: [u32; 2],
    /// Unit vector from the first body to the second, at the last step in which they were in range.
    pub normal: Vector3<f64>,
    /// Distance of the surfaces, negative for overlap.
    pub gap: f64,
    /// Whether the surfaces overlap or lie within the range of cohesion.
    pub in_range: bool,
    /// Force and torque on the second body.
    pub force: Modal<f64, M>,
    /// Tangent stiffness of the normal spring at which `springs` are measured.
    pub(crate) slope: f64,
    /// Elongations of the springs across the normal: displacement of the second body against the first.
    pub(crate) springs: Modal<f64, M>,
    shares: Shares,
}

/// Effective masses of a contact: that of the normal, and those of the other modes divided by it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shares {
    mass: f64,
    sliding: f64,
    turning: f64,
}

/// Motion of the second body relative to the first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    /// Of the surfaces at the contact.
    pub velocity: Vector3<f64>,
    /// Difference of the spins.
    pub spin: Vector3<f64>,
    /// Mean of the spins: the plane of the contact turns about its normal with it.
    pub turning: Vector3<f64>,
}

/// Laws of a contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law<F> {
    pub stiffness: Stiffness,
    /// Damping ratio ζ.
    pub damping: f64,
    pub cohesion: Cohesion<f64>,
    pub friction: F,
}

/// Energies of a contact: stored now, and lost in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Energies {
    pub elastic: f64,
    pub cohesion: f64,
    pub normal: f64,
    pub sliding: f64,
    pub rolling: f64,
    pub torsion: f64,
}

impl Motion {
    /// Power that forces on the second body take from the motion, by mode.
    fn power_lost<M: ContactModes<f64>>(
        &self,
        by: &Modal<f64, M>,
        normal: &Vector3<f64>,
    ) -> [f64; 4] {
        let power = [
            by.normal * self.velocity.dot(normal),
            by.sliding().dot(&self.velocity),
            by.rolling().dot(&self.spin),
            by.torsion() * self.spin.dot(normal),
        ];
        not_gained(power.map(|power| -power))
    }
}

impl<F> Law<F> {
    /// Cohesion across a gap.
    fn pull(&self, gap: f64) -> f64 {
        if gap <= self.cohesion.range() {
            self.cohesion.strength()
        } else {
            0.0
        }
    }
}

impl<M: ContactModes<f64>> SoftContact<M> {
    /// Neighbours without springs. Every mode gets the frequency of the normal one: its stiffness is that of
    /// the normal spring times the ratio of the effective masses, 2/7 for sliding and 2/5 R² for turning of
    /// solid spheres.
    pub(super) fn apart(bodies: [u32; 2], block: &Block<f64>) -> Self {
        let mass = block.mass_normal;
        Self {
            bodies,
            normal: Vector3::zeros(),
            gap: f64::INFINITY,
            in_range: false,
            force: Modal::default(),
            slope: 0.0,
            springs: Modal::default(),
            shares: Shares {
                mass,
                sliding: block.mass_sliding / mass,
                turning: block.inertia / mass,
            },
        }
    }

    /// Takes over the springs of the same pair from an older list.
    pub(super) fn recall(&mut self, old: &Self) {
        *self = Self {
            shares: self.shares,
            ..*old
        };
    }

    /// Restores the springs of a stored state.
    pub(crate) fn restore(
        &mut self,
        touch: &Touch<f64>,
        force: Modal<f64, M>,
        springs: Modal<f64, M>,
    ) {
        self.in_range = true;
        (self.normal, self.gap) = (touch.normal, touch.gap);
        self.force = force;
        self.slope = springs.normal;
        self.springs = Modal::new(0.0, springs.sliding(), springs.rolling(), springs.torsion());
    }

    /// The springs, with the slope in place of the normal component.
    pub(crate) fn stored(&self) -> Modal<f64, M> {
        let springs = &self.springs;
        Modal::new(
            self.slope,
            springs.sliding(),
            springs.rolling(),
            springs.torsion(),
        )
    }

    /// Lets go: the energy of the springs is lost.
    pub(super) fn part<F>(&mut self, gap: f64, law: &Law<F>, lever: f64) -> Energies {
        let opened = gap - self.gap;
        let last = self.dashpots(law, lever).normal;
        self.gap = gap;
        if !self.in_range {
            return Energies::default();
        }
        // The last half of what the dashpot takes: it holds a spring back that opens faster than it may.
        let normal = -0.5 * last * opened;
        let stored = self.stored_energies();
        self.in_range = false;
        (self.force, self.springs, self.slope) = (Modal::default(), Modal::default(), 0.0);
        let [sliding, rolling, torsion] = stored;
        Energies {
            normal: if normal > 0.0 { normal } else { 0.0 },
            sliding,
            rolling,
            torsion,
            ..Energies::default()
        }
    }

    /// Elastic energies of sliding, rolling and torsion.
    fn stored_energies(&self) -> [f64; 3] {
        let (springs, slope) = (&self.springs, 0.5 * self.slope);
        let sliding = if M::Sliding::PRESENT {
            slope * self.shares.sliding * springs.sliding().norm_squared()
        } else {
            0.0
        };
        let turning = slope * self.shares.turning;
        let rolling = if M::Rolling::PRESENT {
            turning * springs.rolling().norm_squared()
        } else {
            0.0
        };
        [
            sliding,
            rolling,
            turning * springs.torsion() * springs.torsion(),
        ]
    }

    /// Brings springs and force to the end of a step of length `dt` that ended at `touch` with this motion.
    pub(super) fn advance<F: ContactFriction<f64, Modes = M>>(
        &mut self,
        touch: &Touch<f64>,
        motion: &Motion,
        law: &Law<F>,
        dt: f64,
    ) -> Energies {
        let n = &touch.normal;
        let pull = law.pull(touch.gap);
        let opening = motion.velocity.dot(n);
        let before = self.dashpots(law, touch.lever);
        self.carry(n, motion, dt);
        self.gap = touch.gap;
        self.in_range = true;

        // Spring and dashpot along the normal push, or do nothing.
        let overlap = if touch.gap < 0.0 { -touch.gap } else { 0.0 };
        let [push, slope] = law.stiffness.force(overlap, touch.lever);
        let dashpot = law.stiffness.dashpot(law.damping, slope, self.shares.mass);
        let damped = push - dashpot * opening;
        // P; NaN stays.
        let bound = if overlap == 0.0 || damped < 0.0 {
            0.0
        } else {
            damped
        };

        let slipped = self.resist(touch, motion, law, [bound, slope, dashpot], dt);
        self.force.normal = bound - pull;
        // The force at the start of a step acts until its end, at the mean of the velocities there: half of its
        // work is booked with each.
        let after = self.dashpots(law, touch.lever);
        let viscous = |by: &Modal<f64, M>| motion.power_lost(by, n).map(|rate| 0.5 * dt * rate);
        let [old, new] = [viscous(&before), viscous(&after)];
        let lost = |mode: usize| old[mode] + new[mode] + slipped[mode];
        Energies {
            elastic: law.stiffness.energy(overlap, push)
                + self.stored_energies().iter().sum::<f64>(),
            cohesion: pull * (touch.gap - law.cohesion.range()),
            normal: lost(0),
            sliding: lost(1),
            rolling: lost(2),
            torsion: lost(3),
        }
    }

    /// Forces and torques on the second body beyond those of the springs and of cohesion.
    fn dashpots<F>(&self, law: &Law<F>, lever: f64) -> Modal<f64, M> {
        if !self.in_range {
            return Modal::default();
        }
        let pull = law.pull(self.gap);
        let [push, _] = law.stiffness.force((-self.gap).max(0.0), lever);
        let (k, k_turn) = (
            self.shares.sliding * self.slope,
            self.shares.turning * self.slope,
        );
        let (force, springs) = (&self.force, &self.springs);
        Modal::new(
            force.normal + pull - push,
            force.sliding() + springs.sliding() * k,
            force.rolling() + springs.rolling() * k_turn,
            force.torsion() + springs.torsion() * k_turn,
        )
    }

    /// Turns the springs with the plane of the contact.
    #[inline]
    fn carry(&mut self, normal: &Vector3<f64>, motion: &Motion, dt: f64) {
        if self.slope > 0.0 && (M::Sliding::PRESENT || M::Rolling::PRESENT) {
            let angle = motion.turning.dot(normal) * dt;
            let transport = Transport::new(&self.normal, normal, angle);
            let sliding = transport.carry(&self.springs.sliding());
            let rolling = if M::Rolling::PRESENT {
                transport.carry(&self.springs.rolling())
            } else {
                Vector3::zeros()
            };
            self.springs = Modal::new(0.0, sliding, rolling, self.springs.torsion());
        }
        self.normal = *normal;
    }

    /// Loads the springs with the motion of the step and lets them slip at their thresholds; the dashpots
    /// beside them share the thresholds. Returns what the springs lose, by mode.
    #[inline]
    fn resist<F: ContactFriction<f64, Modes = M>>(
        &mut self,
        touch: &Touch<f64>,
        motion: &Motion,
        law: &Law<F>,
        [bound, slope, dashpot]: [f64; 3],
        dt: f64,
    ) -> [f64; 4] {
        if !(M::Sliding::PRESENT || M::Rolling::PRESENT || M::Torsion::PRESENT) {
            return [0.0; 4];
        }
        let n = &touch.normal;
        let Shares {
            sliding: share,
            turning,
            ..
        } = self.shares;
        let (k, k_turn) = (share * slope, turning * slope);
        let (c, c_turn) = (share * dashpot, turning * dashpot);
        let slip = motion.velocity - n * motion.velocity.dot(n);
        let twist = motion.spin.dot(n);
        let roll = motion.spin - n * twist;

        // A spring that stiffens keeps its force, one that softens its elongation: neither makes energy.
        let kept = if slope > self.slope {
            self.slope / slope
        } else {
            1.0
        };
        let held = [self.springs.sliding() * kept, self.springs.rolling() * kept];
        let held_twist = self.springs.torsion() * kept;
        let reached = [held[0] + slip * dt, held[1] + roll * dt];
        let reached_twist = held_twist + twist * dt;
        // Slip of the springs: the admissible force nearest in elastic energy.
        let trial = TangentialLoad {
            sliding: reached[0] * k,
            torsion: reached_twist * k_turn,
        };
        let springs = Masses {
            sliding: k,
            torsion: k_turn,
        };
        let elastic = law.friction.hold(&trial, bound, touch.lever, &springs);
        let trial_rolling = reached[1] * k_turn;
        let elastic_rolling = law
            .friction
            .hold_rolling(&trial_rolling, bound, touch.lever);
        let sliding = if elastic.sliding == trial.sliding {
            reached[0]
        } else {
            elastic.sliding / k
        };
        let rolling = if elastic_rolling == trial_rolling {
            reached[1]
        } else {
            elastic_rolling / k_turn
        };
        let torsion = if elastic.torsion == trial.torsion {
            reached_twist
        } else {
            elastic.torsion / k_turn
        };
        let old = self.stored_energies();
        self.slope = slope;
        self.springs = Modal::new(0.0, sliding, rolling, torsion);
        // Losses by change of stiffness, by slip and in the dashpots.
        let about = |x: f64| Vector3::new(x, 0.0, 0.0);
        let slipped = [
            slip_loss(k, &held[0], &reached[0], &sliding),
            slip_loss(k_turn, &held[1], &reached[1], &rolling),
            slip_loss(
                k_turn,
                &about(held_twist),
                &about(reached_twist),
                &about(torsion),
            ),
        ];
        let softened = [
            old[0] - 0.5 * k * held[0].norm_squared(),
            old[1] - 0.5 * k_turn * held[1].norm_squared(),
            old[2] - 0.5 * k_turn * held_twist * held_twist,
        ];

        // Springs and dashpots together.
        let trial = TangentialLoad {
            sliding: elastic.sliding + slip * c,
            torsion: elastic.torsion + twist * c_turn,
        };
        let dashpots = Masses {
            sliding: c,
            torsion: c_turn,
        };
        let total = law.friction.hold(&trial, bound, touch.lever, &dashpots);
        let trial_rolling = elastic_rolling + roll * c_turn;
        let total_rolling = law
            .friction
            .hold_rolling(&trial_rolling, bound, touch.lever);
        self.force = Modal::new(0.0, -total.sliding, -total_rolling, -total.torsion);
        let slipped = not_gained([0.0, slipped[0], slipped[1], slipped[2]]);
        [
            0.0,
            softened[0] + slipped[1],
            softened[1] + slipped[2],
            softened[2] + slipped[3],
        ]
    }
}

/// Energy lost by a spring that was held, was strained further to `reached` and slipped back to `kept`: the slip
/// times the mean of the forces before and after it. Straining without a load loses nothing.
#[inline]
fn slip_loss(k: f64, held: &Vector3<f64>, reached: &Vector3<f64>, kept: &Vector3<f64>) -> f64 {
    0.5 * k * (held + kept).dot(&(reached - kept))
}

/// Losses along the normal, by sliding, by rolling and by torsion without those that a late force at a turn of the
/// motion would gain, which is an error of the step. Sliding and torsion, under one threshold, may pass energy to
/// each other: their sum counts.
#[inline]
fn not_gained([normal, sliding, rolling, torsion]: [f64; 4]) -> [f64; 4] {
    let kept = |loss: f64, part: f64| if loss < 0.0 { 0.0 } else { part };
    let across = sliding + torsion;
    [
        kept(normal, normal),
        kept(across, sliding),
        kept(rolling, rolling),
        kept(across, torsion),
    ]
}

impl Energies {
    /// Adds those of another contact.
    pub fn add(&mut self, other: &Self) {
        self.elastic += other.elastic;
        self.cohesion += other.cohesion;
        self.normal += other.normal;
        self.sliding += other.sliding;
        self.rolling += other.rolling;
        self.torsion += other.torsion;
    }
}

#[cfg(test)]
mod tests;
