//! Slip that begins before the surface is reached: Dahl's law and its kin for any patch.

use super::pose::{Anchor, Axes, Pose};
use super::root::{BracketPoint, falling_root};
use super::{Presliding, PreslidingStep, Settled};
use crate::law::{LawError, validated_not_negative, validated_positive};
use crate::limit_surface::{FrictionSet, without_gain};
use crate::real::Real;
use crate::twist::{Displacement, Twist, Wrench};

/// Bonds that break one after the other as the wrench approaches the surface of the set.
///
/// With g the gauge of the bonds' wrench z in the set K, n the outward normal there, scaled to
/// z·n = g, and D the power of dry friction,
///
/// ```text
/// d(slip) = D(dq) h(g) n,     h(g) = ((g − g₀)/(1 − g₀))ᵐ above g₀, 0 below
/// ```
///
/// A steady motion ends with g = 1 where it dissipates most, as dry friction does. In one
/// direction with g₀ = 0 and m = 1 this is Dahl's law, F = F_c (1 − e^(−kx/F_c)). Under a vibrating
/// push Dahl's law creeps, because every small reversal slips a little; a break-away share g₀ > 0
/// makes all below it purely elastic, and a push that stays below it is held for good.
///
/// The step to a new pose is implicit: z⁺ is where |z − S e|²/2 + D(Δq) H(g(z)), with H′ = h, is
/// least in K. That function is strictly convex: the step has one answer, depends on e without
/// expansion, and dissipates z⁺·slip = D g h(g) ≥ 0.
///
/// *Accuracy*: first order in the step, of which z⁺ is the answer to rounding; with m < 1 h rises without bound at
/// g₀, and the law read back from z⁺ there, slip = D h(g), holds to εᵐ (2 % for m = 0.1). *Cost*: two projections at most where nothing slips or all
/// does, about ten between.
/// *Source*: P. R. Dahl, Aerospace Corp. TOR-0158 (1968); P. Dupont, V. Hayward, B. Armstrong,
/// F. Altpeter, IEEE Trans. Autom. Control 47 (2002) 787 (elasto-plastic). The form for three
/// directions, by the gauge, is ours.
///
/// ```
/// use tribos_core::limit_surface::LimitEllipsoid;
/// use tribos_core::presliding::{MicroslipPresliding, Presliding};
/// use tribos_core::twist::Displacement;
/// let (set, bonds) = (LimitEllipsoid::new(10.0_f64, 0.1, 0.6)?, Presliding::new(1e4, 50.0)?); // N, m; N/m, N m
/// let dahl = MicroslipPresliding::new(bonds, 0.0, 1.0)?;
/// let (mut strain, mut friction) = (Displacement::ZERO, 0.0);
/// for _ in 0..1000 {
///     let end = dahl.advance(&set, &strain, &Displacement::new(1e-6, 0.0, 0.0)); // m
///     (strain, friction) = (end.strain, end.friction.force.x);
/// }
/// // After 1 mm: Dahl's curve, to the order of the step.
/// assert!((friction + 10.0 * (1.0 - (-1.0_f64).exp())).abs() < 3e-3); // N
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MicroslipPresliding<R> {
    bonds: Presliding<R>,
    /// g₀
    breakaway: R,
    /// m
    exponent: R,
}

/// A trial wrench, and what decides how much of it slips away.
struct TrialWrench<'a, R: Real, S: ?Sized> {
    law: &'a MicroslipPresliding<R>,
    set: &'a S,
    wanted: Wrench<R>,
    /// D(Δq)
    driven: R,
}

impl<R: Real> MicroslipPresliding<R> {
    /// Bonds that slip above the share `breakaway` = g₀ of the set, with the exponent m.
    ///
    /// *Domain*: 0 ≤ `breakaway` < 1, 0 < `exponent` < ∞.
    pub fn new(bonds: Presliding<R>, breakaway: R, exponent: R) -> Result<Self, LawError> {
        let parameter = "break-away share";
        let breakaway = validated_not_negative(parameter, breakaway)?;
        if breakaway >= R::ONE {
            let given = breakaway.to_f64();
            return Err(LawError::NotAFraction { parameter, given });
        }
        Ok(Self {
            bonds,
            breakaway,
            exponent: validated_positive("exponent of slip", exponent)?,
        })
    }

    /// The bonds.
    pub fn bonds(&self) -> &Presliding<R> {
        &self.bonds
    }

    /// The share of the set below which nothing slips, g₀.
    pub fn breakaway(&self) -> R {
        self.breakaway
    }

    /// The exponent m.
    pub fn exponent(&self) -> R {
        self.exponent
    }

    /// Friction on a patch that has gone from one pose to another: [`Presliding::step`] with slip that
    /// begins early.
    ///
    /// *Units*, axes, *Special values*: as for [`Presliding::step`].
    ///
    /// ```
    /// use tribos_core::law::StickSlip;
    /// use tribos_core::limit_surface::LimitEllipsoid;
    /// use tribos_core::presliding::{Anchor, MicroslipPresliding, Pose, Presliding};
    /// let (set, bonds) = (LimitEllipsoid::new(10.0_f64, 0.1, 0.6)?, Presliding::new(1e4, 50.0)?);
    /// let joint = MicroslipPresliding::new(bonds, 0.7, 1.0)?;
    /// let path = [0.0, 6e-4, 9e-4].map(|x| Pose::new(x, 0.0, 0.0)); // m
    /// let touched = Anchor::at(path[0]);
    /// let held = joint.step(&set, &touched, [&path[0], &path[1]]); // 6 N, below 7 N
    /// assert!(held.grip == StickSlip::Stick && held.anchor == touched);
    /// let slipped = joint.step(&set, &held.anchor, [&path[1], &path[2]]); // 9 N, above
    /// assert!(slipped.grip == StickSlip::Slip && slipped.friction.force.x > -9.0);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        anchor: &Anchor<R>,
        [from, to]: [&Pose<R>; 2],
    ) -> PreslidingStep<R> {
        let axes = Axes::at(to.angle);
        let strain = anchor.deflection(to);
        let local = axes.displacement_to_patch(&strain);
        let moved = axes.displacement_to_patch(&to.since(from));
        let settled = self.settled(set, &local, &moved);
        settled.on_floor(self.bonds.factors(), axes, anchor, to)
    }

    /// Friction after the patch has `moved`: [`Presliding::advance`] with slip that begins early.
    #[doc(hidden)]
    pub fn advance<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        strain: &Displacement<R>,
        moved: &Displacement<R>,
    ) -> Settled<R> {
        self.settled(set, &(*strain + *moved), moved)
    }

    fn settled<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        strain: &Displacement<R>,
        moved: &Displacement<R>,
    ) -> Settled<R> {
        let stiffness = self.bonds.factors();
        let wanted = stiffness.wrench(strain);
        let gauge = set.gauge(&wanted);
        let motion = Twist {
            velocity: moved.shift,
            spin: moved.turn,
        };
        let driven = set.support(&motion);
        if gauge <= self.breakaway || (gauge <= R::ONE && driven == R::ZERO) {
            return Settled::held(strain, &wanted);
        }
        // All that is beyond the set slips whatever the law.
        let trial = TrialWrench {
            law: self,
            set,
            wanted,
            driven,
        };
        let (carried, beyond) = trial.at(R::ONE);
        let answered = beyond >= driven || !(gauge.is_finite() && driven.is_finite());
        let carried = if answered {
            carried
        } else {
            trial.within(gauge)
        };
        if carried == wanted {
            return Settled::held(strain, &wanted);
        }
        Settled::slipped(stiffness, &wanted, &carried)
    }

    /// h(g) for g₀ ≤ g
    #[inline]
    fn share(&self, gauge: R) -> R {
        let above = (gauge - self.breakaway) / (R::ONE - self.breakaway);
        if above <= R::ZERO {
            return R::ZERO;
        }
        if self.exponent == R::ONE {
            return above;
        }
        above.pow(self.exponent)
    }
}

impl<R: Real, S: FrictionSet<R> + ?Sized> TrialWrench<'_, R, S> {
    /// The point of g K nearest to the trial, and the factor λ of slip = λ n; λ falls with g.
    fn at(&self, g: R) -> (Wrench<R>, R) {
        let w = &self.wanted;
        let stiffness = self.law.bonds.factors();
        let reduced = Wrench::new(w.force.x / g, w.force.y / g, w.torque / g);
        let nearest = self.set.project_with_length(&reduced, stiffness.length);
        if nearest.wrench == reduced {
            return (*w, R::ZERO);
        }
        let nearest = without_gain(&nearest.wrench, &reduced, stiffness.length);
        let slip = stiffness.strain(&(*w - nearest * g));
        // z·n = g makes λ of the work along the slip, z·slip = λ g.
        (nearest * g, slip.work(&nearest))
    }

    /// The wrench whose slip is what the law asks for, λ = D h(g), inside the set.
    fn within(&self, gauge: R) -> Wrench<R> {
        let law = self.law;
        let excess = |g| self.at(g).1 - self.driven * law.share(g);
        // λ of the smallest set, whose normals point along the strain, is the largest of all.
        let strain = law.bonds.factors().strain(&self.wanted);
        let most = self.set.support(&Twist {
            velocity: strain.shift,
            spin: strain.turn,
        });
        let highest = if gauge < R::ONE { gauge } else { R::ONE };
        let ends = [
            BracketPoint::new(law.breakaway, most),
            BracketPoint::new(highest, excess(highest)),
        ];
        self.at(falling_root(excess, ends, most + self.driven)).0
    }
}
