//! One contact: springs and dashpots in all modes, with thresholds.

use super::kick::{Kick, Passage};
use super::law::Law;
use super::transport::Transport;
use nalgebra::Vector3;
use tribos_core::contact::{ContactFriction, ContactGeometry, ContactModes, ContactVector};
use tribos_core::internals::{AxialPart, Block, Masses, PlanarPart, TangentialLoad};

/// A pair of neighbours, or a sphere near a wall, with the springs of its contact.
///
/// See [`World`](super::SoftWorld) for an example.
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
    pub force: ContactVector<f64, M>,
    /// Impulse on the second body in the second half of the last step.
    pub(super) impulse: ContactVector<f64, M>,
    /// Tangent stiffness of the normal spring at which `springs` are measured.
    pub(crate) slope: f64,
    /// Elongations of the springs across the normal: displacement of the second body against the first.
    pub(crate) springs: ContactVector<f64, M>,
    shares: MassRatios,
}

/// Effective masses of a contact: that of the normal, and those of the other modes divided by it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct MassRatios {
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
    /// Energy that impulses on the second body across the normal take from the motion, by mode.
    fn lost_across<M: ContactModes<f64>>(
        &self,
        by: &ContactVector<f64, M>,
        normal: &Vector3<f64>,
    ) -> [f64; 4] {
        let work = [
            0.0,
            by.sliding().dot(&self.velocity),
            by.rolling().dot(&self.spin),
            by.torsion() * self.spin.dot(normal),
        ];
        not_gained(work.map(|work| -work))
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
            force: ContactVector::default(),
            impulse: ContactVector::default(),
            slope: 0.0,
            springs: ContactVector::default(),
            shares: MassRatios {
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
        touch: &ContactGeometry<f64>,
        force: ContactVector<f64, M>,
        springs: ContactVector<f64, M>,
    ) {
        self.in_range = true;
        (self.normal, self.gap) = (touch.normal, touch.gap);
        self.force = force;
        self.slope = springs.normal;
        self.springs =
            ContactVector::new(0.0, springs.sliding(), springs.rolling(), springs.torsion());
    }

    /// The springs, with the slope in place of the normal component.
    #[doc(hidden)]
    pub fn stored(&self) -> ContactVector<f64, M> {
        let springs = &self.springs;
        ContactVector::new(
            self.slope,
            springs.sliding(),
            springs.rolling(),
            springs.torsion(),
        )
    }

    /// Lets go in a step of length `dt`: the energy of the springs is lost.
    pub(super) fn part<F>(&mut self, gap: f64, law: &Law<F>, lever: f64, dt: f64) -> Energies {
        self.impulse = ContactVector::default();
        if !self.in_range {
            self.gap = gap;
            return Energies::default();
        }
        // A state that goes on has its forces found anew, in no time.
        let opening = if dt > 0.0 { (gap - self.gap) / dt } else { 0.0 };
        let kick = self.passage(gap, opening, law, [lever, dt]).kick(law);
        self.gap = gap;
        let [sliding, rolling, torsion] = self.stored_energies();
        self.impulse = Self::impulse_of(&self.force, &kick);
        self.in_range = false;
        (self.force, self.springs, self.slope) =
            (ContactVector::default(), ContactVector::default(), 0.0);
        let [normal, ..] = not_gained([kick.lost, 0.0, 0.0, 0.0]);
        Energies {
            normal,
            sliding,
            rolling,
            torsion,
            ..Energies::default()
        }
    }

    /// Force of spring and dashpot along the normal.
    fn push<F>(&self, law: &Law<F>) -> f64 {
        if self.in_range {
            self.force.normal + law.pull(self.gap)
        } else {
            0.0
        }
    }

    /// The way through a step to a gap.
    fn passage<F>(&self, gap: f64, opening: f64, law: &Law<F>, [lever, dt]: [f64; 2]) -> Passage {
        // Neighbours that were out of range have come from its border or farther.
        let border = law.cohesion.range().max(0.0);
        let from = if self.in_range {
            self.gap
        } else if dt > 0.0 {
            (gap - opening * dt).max(border)
        } else {
            gap
        };
        Passage {
            gaps: [from, gap],
            push: self.push(law),
            pull: if self.in_range {
                law.pull(self.gap)
            } else {
                0.0
            },
            opening,
            mass: self.shares.mass,
            lever,
            dt,
        }
    }

    /// Impulse of a kick, with the friction of a force.
    fn impulse_of(force: &ContactVector<f64, M>, kick: &Kick) -> ContactVector<f64, M> {
        let time = kick.time;
        ContactVector::new(
            kick.pushed - kick.pulled,
            force.sliding() * time,
            force.rolling() * time,
            force.torsion() * time,
        )
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
        touch: &ContactGeometry<f64>,
        motion: &Motion,
        law: &Law<F>,
        dt: f64,
    ) -> Energies {
        let n = &touch.normal;
        let opening = motion.velocity.dot(n);
        let old_force = self.force;
        let before = self.dashpots(&(self.force, 0.5 * dt), 0.5 * dt);
        let kick = self
            .passage(touch.gap, opening, law, [touch.lever, dt])
            .kick(law);
        self.carry(n, motion, dt);
        self.gap = touch.gap;
        self.in_range = true;

        // Friction at the threshold of what pushes at the end of the step.
        let overlap = if touch.gap < 0.0 { -touch.gap } else { 0.0 };
        let [elastic, slope] = law.stiffness.force(overlap, touch.lever);
        let dashpot = law.stiffness.dashpot(law.damping, slope, self.shares.mass);
        let slipped = self.resist(touch, motion, law, [kick.push, slope, dashpot], dt);
        self.force.normal = kick.push - kick.pull;
        self.impulse = if kick.push > 0.0 {
            Self::impulse_of(&self.force, &kick)
        } else {
            Self::impulse_of(&old_force, &kick)
        };
        // What friction does beyond its springs is lost, in both halves of the step.
        let after = self.dashpots(&(self.impulse, 1.0), 0.5 * dt);
        let [old, new] = [before, after].map(|by| motion.lost_across(&by, n));
        let lost = |mode: usize| old[mode] + new[mode] + slipped[mode];
        let [normal, ..] = not_gained([kick.lost, 0.0, 0.0, 0.0]);
        Energies {
            elastic: law.stiffness.energy(overlap, elastic)
                + self.stored_energies().iter().sum::<f64>(),
            cohesion: kick.pull * (touch.gap - law.cohesion.range()),
            normal,
            sliding: lost(1),
            rolling: lost(2),
            torsion: lost(3),
        }
    }

    /// Impulses of friction on the second body, a force times a time, beyond those of the springs in half a step.
    fn dashpots(
        &self,
        (force, time): &(ContactVector<f64, M>, f64),
        half: f64,
    ) -> ContactVector<f64, M> {
        let (k, k_turn) = (
            self.shares.sliding * self.slope * half,
            self.shares.turning * self.slope * half,
        );
        let springs = &self.springs;
        ContactVector::new(
            0.0,
            force.sliding() * *time + springs.sliding() * k,
            force.rolling() * *time + springs.rolling() * k_turn,
            force.torsion() * *time + springs.torsion() * k_turn,
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
            self.springs = ContactVector::new(0.0, sliding, rolling, self.springs.torsion());
        }
        self.normal = *normal;
    }

    /// Loads the springs with the motion of the step and lets them slip at their thresholds; the dashpots
    /// beside them share the thresholds. Returns what the springs lose, by mode.
    #[inline]
    fn resist<F: ContactFriction<f64, Modes = M>>(
        &mut self,
        touch: &ContactGeometry<f64>,
        motion: &Motion,
        law: &Law<F>,
        [bound, slope, dashpot]: [f64; 3],
        dt: f64,
    ) -> [f64; 4] {
        if !(M::Sliding::PRESENT || M::Rolling::PRESENT || M::Torsion::PRESENT) {
            return [0.0; 4];
        }
        let n = &touch.normal;
        let MassRatios {
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
        self.springs = ContactVector::new(0.0, sliding, rolling, torsion);
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
        self.force = ContactVector::new(0.0, -total.sliding, -total_rolling, -total.torsion);
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
