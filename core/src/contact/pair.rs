//! Sliding and rolling at one contact, solved together.

use super::block::Block;
use super::friction::{ContactFriction, Grasp};
use super::modes::{AxialPart, Modal, Modes, PlanarPart};
use super::vector::{cross, dot};
use crate::real::Real;
use nalgebra::Vector3;

/// Rounds of sliding and rolling in turn. Each brings the pair nearer by k² m_t I ≤ 5/7 for solid
/// spheres and plates, so that this many leave less than 1e-14; two rounds are the rule.
const MOST_ROUNDS: usize = 96;
/// Relative change below which the rounds end, in units of rounding.
const SETTLED_ULPS: f64 = 4.0;

/// The friction impulses that obey their thresholds for normal impulse P − F_coh dt = `bound` less
/// cohesion, given `old` impulses and the relative `velocity` under them.
#[inline(never)]
pub(super) fn solve_pair<R: Real, F: ContactFriction<R>>(
    friction: &F,
    (block, normal, lever): (&Block<R>, &Vector3<R>, R),
    bound: R,
    old: &Modal<R, F::Modes>,
    velocity: &Modal<R, F::Modes>,
) -> (Grasp<R>, Vector3<R>) {
    let k = block.coupling;
    let (sliding_0, rolling_0) = (old.sliding.vector(), old.rolling.vector());
    let torsion = old.torsion.component() - block.inertia * velocity.torsion.component();
    if let Some(stick) = sticking(block, normal, old, velocity) {
        let grasp = Grasp {
            sliding: stick.0,
            torsion,
        };
        let held = friction.hold(&grasp, bound, lever, block);
        if held.sliding == stick.0 && friction.hold_rolling(&stick.1, bound, lever) == stick.1 {
            return (held, stick.1);
        }
    }
    let (mut sliding, mut rolling) = (sliding_0, rolling_0);
    let mut held = Grasp { sliding, torsion };
    for _ in 0..MOST_ROUNDS {
        let slip = velocity.sliding.vector() + cross(&(rolling - rolling_0), normal) * k;
        let trial = Grasp {
            sliding: sliding_0 - slip * block.mass_sliding,
            torsion,
        };
        held = friction.hold(&trial, bound, lever, block);
        let roll = velocity.rolling.vector() + cross(normal, &(held.sliding - sliding_0)) * k;
        let turned = friction.hold_rolling(&(rolling_0 - roll * block.inertia), bound, lever);
        let (moved, turn) = (held.sliding - sliding, turned - rolling);
        (sliding, rolling) = (held.sliding, turned);
        if negligible(&moved, &sliding) && negligible(&turn, &rolling) {
            break;
        }
    }
    (held, rolling)
}

/// The impulses that stop sliding and rolling alike, unless the block is singular.
fn sticking<R: Real, M: Modes<R>>(
    block: &Block<R>,
    normal: &Vector3<R>,
    old: &Modal<R, M>,
    velocity: &Modal<R, M>,
) -> Option<(Vector3<R>, Vector3<R>)> {
    // Δp = −m (s + c × …): the two planar equations s + Δp/m + k Δτ × n = 0 and
    // w + Δτ/I + k n × Δp = 0, solved for Δp with n × (Δτ × n) = Δτ.
    let (m, inertia, k) = (block.mass_sliding, block.inertia, block.coupling);
    let (s, w) = (velocity.sliding.vector(), velocity.rolling.vector());
    let determinant = R::ONE - k * k * m * inertia;
    if determinant <= R::ZERO || determinant.is_nan() {
        return None;
    }
    let push = (s - cross(&w, normal) * (k * inertia)) * (-m / determinant);
    let turn = (w + cross(normal, &push) * k) * -inertia;
    Some((old.sliding.vector() + push, old.rolling.vector() + turn))
}

fn negligible<R: Real>(change: &Vector3<R>, value: &Vector3<R>) -> bool {
    let ulps = R::from_f64(SETTLED_ULPS) * R::EPSILON;
    dot(change, change) <= ulps * ulps * dot(value, value)
}
