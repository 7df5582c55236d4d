//! The displacement and the load at which bonds let a body go.
//!
//! Along a ray of displacements s q the strain of every bond keeps its direction and grows in proportion to s.
//! As long as no bond is past the peak of its force, the stiffness is positive definite; that gives the
//! start of the search. The body lets go where the stiffness first turns singular: to a wrench that
//! grows further there is no equilibrium nearby. Bonds that all break at one strain make it singular at
//! the first break, the farthest bond's; bonds that never weaken make it singular in the limit alone.

use super::{BondLaw, Bonds};
use crate::coupling::nodes::NodeFriction;
use crate::law::LocalLaw;
use crate::patch::nodes::NodePatch;
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use nalgebra::Matrix3;

/// How bonds let go.
///
/// ```
/// use tribos_core::bond::{Bonds, BrittleBond, FailureMode, PlasticBond};
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::twist::Twist;
/// let feet = Nodes::new([-0.1, 0.1].map(|x| Node { x, y: 0.0, weight: 0.5_f64 }))?; // m
/// let turn = Twist::new(0.0, 0.0, 1.0);
/// let brittle = Bonds::new(BrittleBond::new(5e4, 1e-5)?, feet)?.onset(60.0, &turn);
/// assert!(brittle.is_some_and(|onset| onset.release == FailureMode::Breaks));
/// let plastic = Bonds::new(PlasticBond::new(5e4, 1e-5)?, feet)?.onset(60.0, &turn);
/// assert!(plastic.is_some_and(|onset| onset.release == FailureMode::Yields));
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FailureMode {
    /// The bond that is strained most breaks, and the others follow.
    Breaks,
    /// Bonds weaken one after the other until the stiffness of the whole turns singular.
    Softens,
    /// All bonds yield and none weakens: the push is the limit of large displacements.
    Yields,
    /// They had not let go where the search ended, 4e8 times beyond the displacement at which the first bond weakens:
    /// the push there is carried, and where the body lets go is not known.
    Holds,
}

/// Where a body lets go.
///
/// ```
/// use tribos_core::bond::{Bonds, ExponentialBond};
/// use tribos_core::patch::nodes::{Node, Nodes};
/// use tribos_core::twist::Twist;
/// let feet = [[-0.1, 0.0], [0.1, 0.0]].map(|[x, y]| Node { x, y, weight: 0.5 }); // m
/// let bonds = Bonds::new(ExponentialBond::new(5e4_f64, 1e-5)?, Nodes::new(feet)?)?; // 1/m, m
/// let onset = bonds.onset(60.0, &Twist::new(0.0, 0.0, -1.0)).unwrap(); // N; turned clockwise
/// assert!((onset.displacement.spin + 1e-4).abs() < 1e-12); // rad: each foot moves by 1e-5 m
/// assert!((onset.push.torque + 60.0 * 0.1 * 0.5 / 1.0_f64.exp()).abs() < 1e-12); // N m
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SlipOnset<R: Real> {
    /// Displacement up to which the bonds hold, in length and angle; infinite parts where bonds yield.
    pub displacement: Twist<R>,
    /// The load on the body that its bonds balance there: minus their wrench.
    pub push: Wrench<R>,
    /// How they let go.
    pub release: FailureMode,
}

/// Step of the search, as a factor of the displacement: half of the peak of [`super::ReForming`] with most stages.
const STEP: f64 = 1.02;
/// Most steps: a factor of 4e8. Along the displacement nothing resists where all bonds weaken, so that more
/// steps need bonds nearer than 2e-9 of the reach to the centre of rotation, which carry nearly all.
const STEPS: u32 = 1000;
/// Most halvings of a step.
const HALVINGS: u32 = 60;

impl<R: Real, L: BondLaw<R>, P: NodePatch<R>> Bonds<R, L, P> {
    /// The onset of sliding along a direction of displacement; only ratios of its parts count.
    ///
    /// *Units*: load as the push. *Accuracy*: displacement 1e-12 (f32: 1e-5), push to the rounding of its sum;
    /// both for the nodes, see [`Bonds`]. The stiffness is looked at in steps of 2 %: a singular point is passed over
    /// where it is definite again within one. *Cost*: none for bonds of one strength, otherwise some 100 wrenches
    /// with stiffness. *Special values*: `None` for a direction that is zero, infinite or NaN, and where
    /// displacement, stiffness or push are NaN or out of range; a search without result is [`FailureMode::Holds`].
    pub fn onset(&self, load: R, direction: &Twist<R>) -> Option<SlipOnset<R>> {
        let reach = self.largest_strain(direction);
        // Only ratios count: the farthest bond moves by 1.
        let direction = *direction * (R::ONE / reach);
        if !(reach > R::ZERO && is_finite(&direction)) {
            return None;
        }
        let peak = self.law().peak();
        if !peak.is_finite() {
            return Some(self.yielding(load, &direction));
        }
        let first = direction * peak;
        let (displacement, push, release) = if self.law().is_brittle() {
            // Up to the first break the bonds are springs.
            let springs = NodeFriction::new(Spring(self.law().stiffness()), self.patch());
            (first, -springs.wrench(load, &first), FailureMode::Breaks)
        } else {
            let (factor, release) = self.definite_up_to(&first)?;
            let displacement = first * factor;
            let push = -self.wrench(load, &displacement);
            (displacement, push, release)
        };
        let parts = [push.force.x, push.force.y, push.torque];
        let is_in_range = is_finite(&displacement) && parts.iter().all(|part| part.is_finite());
        is_in_range.then_some(SlipOnset {
            displacement,
            push,
            release,
        })
    }

    /// The limit of a large displacement, in which all bonds hold alike.
    fn yielding(&self, load: R, direction: &Twist<R>) -> SlipOnset<R> {
        let held = NodeFriction::new(ConstantForce(self.law().plateau()), self.patch());
        let infinite = |part: R| {
            if part == R::ZERO {
                part
            } else {
                R::INFINITY.copysign(part)
            }
        };
        let Twist { velocity, spin } = direction;
        SlipOnset {
            displacement: Twist::new(infinite(velocity.x), infinite(velocity.y), infinite(*spin)),
            push: -held.wrench(load, direction),
            release: FailureMode::Yields,
        }
    }

    /// The factor of `first` up to which the stiffness is definite, and what follows; `None` where it is out of range.
    fn definite_up_to(&self, first: &Twist<R>) -> Option<(R, FailureMode)> {
        let holds = |factor: R| is_definite(&self.stiffness(R::ONE, &(*first * factor)));
        let (mut low, mut high) = (R::ONE, R::ONE);
        let mut steps = 0;
        while holds(high)? {
            if steps == STEPS {
                return Some((high, FailureMode::Holds));
            }
            steps += 1;
            (low, high) = (high, high * R::from_f64(STEP));
        }
        for _ in 0..HALVINGS {
            let middle = R::HALF * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if holds(middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some((low, FailureMode::Softens))
    }
}

fn is_finite<R: Real>(displacement: &Twist<R>) -> bool {
    let Twist { velocity, spin } = displacement;
    velocity.x.is_finite() && velocity.y.is_finite() && spin.is_finite()
}

/// True if a symmetric matrix is positive definite, by its pivots; `None` where it has no finite entries.
fn is_definite<R: Real>(m: &Matrix3<R>) -> Option<bool> {
    let entries = [m.m11, m.m12, m.m13, m.m22, m.m23, m.m33];
    if !entries.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let (xx, xy, xn) = (m.m11, m.m12, m.m13);
    let (ratio_y, ratio_n) = (xy / xx, xn / xx);
    let yy = m.m22 - ratio_y * xy;
    let yn = m.m23 - ratio_y * xn;
    let nn = m.m33 - ratio_n * xn;
    Some(xx > R::ZERO && yy > R::ZERO && nn - (yn / yy) * yn > R::ZERO)
}

/// k d
struct Spring<R>(R);

impl<R: Real> LocalLaw<R> for Spring<R> {
    fn friction(&self, speed: R) -> R {
        self.0 * speed
    }
    fn slope(&self, _: R) -> R {
        self.0
    }
}

/// A force that does not depend on the strain.
struct ConstantForce<R>(R);

impl<R: Real> LocalLaw<R> for ConstantForce<R> {
    fn friction(&self, _: R) -> R {
        self.0
    }
    fn slope(&self, _: R) -> R {
        R::ZERO
    }
}
