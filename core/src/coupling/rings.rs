//! A thin annulus as a stack of rings.
//!
//! With F and T of the uniform disk the ring of radius r has the force and the torque
//!
//! ```text
//! F(v, rw) + (rw/2) ∂F/∂w,      r (3T(v, rw)/2 + (rw/2) ∂T/∂w)
//! ```
//!
//! the derivatives of r²F and r³T with respect to u = r². Uniform pressure gives every u the same
//! weight, so that the annulus is their mean, without the cancellation of a difference of disks.
//! About the ring on which the centre of rotation lies, u = (v/w)², both behave like x log|x|.

use super::Speeds;
use super::speeds::DominantSpeed;
use crate::real::Real;
use crate::special::legendre::HALF;

/// A centre of rotation within this distance of the band, in widths of the band, counts as near.
const NEAR: f64 = 0.25;

/// The band between `inner` and 1 radii.
pub(super) struct Rings<R> {
    /// 1 − k²
    width: R,
}

/// Places y = `from` + `step` s⁴ with s from `start` to 1, where y is (1 − u) over the width.
struct RingSegment<R> {
    from: R,
    step: R,
    start: R,
}

/// A sum with weights.
struct Weighted<R, const N: usize> {
    sums: [R; N],
    weight: R,
}

impl<R: Real, const N: usize> Weighted<R, N> {
    fn add(&mut self, weight: R, values: [R; N]) {
        self.weight += weight;
        for (sum, value) in self.sums.iter_mut().zip(values) {
            *sum += weight * value;
        }
    }
}

impl<R: Real> Rings<R> {
    pub fn new(inner: R) -> Self {
        Self {
            width: (R::ONE - inner) * (R::ONE + inner),
        }
    }

    /// Mean of `ring`, a function of the radius.
    ///
    /// *Accuracy*: 3e-15 of the width for x log|x| about the centre of rotation. *Cost*: 16 rings,
    /// or 32 with the centre of rotation inside the band.
    pub fn mean<const N: usize>(&self, [slide, rim]: [R; 2], ring: impl Fn(R) -> [R; N]) -> [R; N] {
        let mut total = Weighted {
            sums: [R::ZERO; N],
            weight: R::ZERO,
        };
        let mut add = |weight, place| {
            let radius = (R::ONE - self.width * place).sqrt();
            total.add(weight, ring(radius));
        };
        let (slide, rim) = (slide.abs(), rim.abs());
        let centre = (rim - slide) / rim * (R::ONE + slide / rim) / self.width;
        let near = R::from_f64(NEAR);
        if centre > -near && centre < R::ONE + near {
            // Towards the outer edge of the band, and towards the inner one.
            if centre > R::ZERO {
                RingSegment::new(centre, -centre, centre - R::ONE).visit(&mut add);
            }
            if centre < R::ONE {
                RingSegment::new(centre, R::ONE - centre, -centre).visit(&mut add);
            }
        } else {
            each_node(|node, weight| add(weight, node));
        }
        total.sums.map(|sum| sum / total.weight)
    }
}

impl<R: Real> RingSegment<R> {
    /// From a distance of `gap` from the singularity at `from`, if it is positive, to its `step`.
    fn new(from: R, step: R, gap: R) -> Self {
        let start = if gap > R::ZERO {
            (gap / step.abs()).sqrt().sqrt()
        } else {
            R::ZERO
        };
        Self { from, step, start }
    }

    /// Weights and places.
    fn visit(&self, mut add: impl FnMut(R, R)) {
        let rest = R::ONE - self.start;
        each_node(|node, weight| {
            let s = self.start + rest * node;
            let cube = s * s * s;
            // dy = 4 |step| s³ ds; the four is left to the sum of the weights of all pieces.
            add(
                weight * rest * self.step.abs() * cube,
                self.from + self.step * cube * s,
            );
        });
    }
}

/// Nodes of [0, 1] and weights of sum 2.
fn each_node<R: Real>(mut visit: impl FnMut(R, R)) {
    let half = R::HALF;
    for [node, weight] in HALF.map(|pair| pair.map(R::from_f64)) {
        visit(half - half * node, weight);
        visit(half + half * node, weight);
    }
}

/// Φ of the ring with the disk's Φ and Φ', and Χ with its three factors.
pub(super) fn ring_factors<R: Real>(alpha: R, at: &Speeds<R>, [phi, slope, chi]: [R; 3]) -> [R; 2] {
    let (x, _) = at.square_and_complement();
    let torque = R::HALF * (R::ONE + R::TWO + alpha) * chi;
    match at.lead() {
        DominantSpeed::Sliding => [phi + x * slope, torque - slope],
        DominantSpeed::Spinning => {
            let beta = R::ONE - alpha;
            let bend = x * slope;
            [
                R::HALF * (R::ONE + alpha) * phi - bend,
                torque + R::HALF * x * (beta * phi) + x * bend,
            ]
        }
    }
}
