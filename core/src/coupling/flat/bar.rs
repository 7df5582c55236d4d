//! Friction of a bar: the line integrals themselves.
//!
//! About a centre of rotation with ρ = h n + t τ (see [`super::pole_near`])
//!
//! ```text
//! ∫ρ/r dt = h L n + (r₁ − r₀) τ,     ∫r dt = I,     ∫ρρ/r³ dt = nn [t/r] − (nτ + τn) h [1/r] + ττ (L − [t/r])
//! ```
//!
//! and for a bar that slides more than it turns, with the velocity (g, w x) of a point as in
//! [`super::pole_far`], Gauss' rule on
//!
//! ```text
//! force along e = −1 + w² ⟨x²/(q s)⟩,   across −w² ⟨x (y − w x²/s)/q⟩,   torque −w ⟨x² (1 + q)/(q s)⟩
//! D″ = ⟨(g², x g, x²)/q³⟩
//! ```
//!
//! with means along the bar. Pressure p = p₀ + g t takes one moment more of each,
//!
//! ```text
//! ∫tρ/r dt = h (r₁ − r₀) n + (I − h² L) τ,     ∫t r dt = [r³]/3,     ∫t³/r³ dt = r₁ − r₀ + h² [1/r]
//! ```
//!
//! and is a weight in the means. Second derivatives are infinite where the centre lies on the bar: a large
//! number stands for them.

use super::motion::{Motion, SplitMotion};
use super::pair_of_numbers::Pair2;
use super::pole_far::{EdgePairs, FOR_HESSIAN, FOR_WRENCH, TranslatingMotion, by_rule};
use super::pole_near::EdgeFromPole;
use super::sums::{self, slid};
use super::{Hessian, PatchShape, Reduced};
use crate::patch::bar::Bar;
use crate::patch::outline::PressureField;
use crate::real::Real;
use nalgebra::Vector2;

impl<R: Real, K: PressureField<R>> PatchShape<R> for Bar<R, K> {
    fn centre(&self) -> Vector2<R> {
        Bar::centre(self)
    }

    fn radius(&self) -> R {
        Bar::radius(self)
    }

    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        match motion.split() {
            SplitMotion::Turns { centre, spin } => turning(self, &centre, R::ONE.copysign(spin)).0,
            SplitMotion::Slides {
                direction, turn, ..
            } => {
                let (direction, spin) = (&direction, turn);
                sliding(self, &TranslatingMotion { direction, spin })
            }
        }
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        match motion.split() {
            SplitMotion::Turns { centre, spin } => {
                let (reduced, hessian) = turning(self, &centre, R::ONE.copysign(spin));
                (reduced, hessian.scaled(R::ONE / spin.abs()))
            }
            SplitMotion::Slides {
                direction,
                turn,
                speed,
            } => {
                let (direction, spin) = (&direction, turn);
                let slide = TranslatingMotion { direction, spin };
                let hessian = bent(self, &slide).scaled(R::ONE / speed);
                (sliding(self, &slide), hessian)
            }
        }
    }
}

fn turning<R: Real, K: PressureField<R>>(
    bar: &Bar<R, K>,
    centre: &Vector2<R>,
    sense: R,
) -> (Reduced<R>, Hessian<R>) {
    let edge = bar.edge();
    let seen = EdgeFromPole::new(edge, centre);
    let (n, t, h) = (edge.normal(), edge.tangent(), seen.h);
    let share = R::ONE / edge.length();
    let inverse = |r: R| R::ONE / (r + R::MIN_POSITIVE);
    let (i0, i1) = (inverse(seen.r0), inverse(seen.r1));
    let line = if K::IS_LINEAR {
        let [sx, sy] = bar.pressure().slope();
        let slope = sx * t.x + sy * t.y;
        // Pressure next to the centre of rotation, as if the bar went on.
        let here = bar.pressure().at_centre() + slope * (centre.x * t.x + centre.y * t.y);
        linear_moments(&seen, [i0, i1], [here, slope])
    } else {
        let nn = seen.t1 * i1 - seen.t0 * i0;
        Moments {
            across: h * seen.log,
            along: seen.rise,
            turn: seen.integral,
            nn,
            nt: -(h * i1 - h * i0),
            tt: seen.log - nn,
        }
    };
    let pull = n * line.across + t * line.along;
    let force = Vector2::new(sense * pull.y, -(sense * pull.x)) * share;
    let torque = centre.x * force.y - centre.y * force.x - sense * line.turn * share;
    let Moments { nn, nt, tt, .. } = line;
    let both = R::TWO * nt;
    let xx = (nn * n.x * n.x + both * n.x * t.x + tt * t.x * t.x) * share;
    let yy = (nn * n.y * n.y + both * n.y * t.y + tt * t.y * t.y) * share;
    let xy = (nn * n.x * n.y + nt * (n.x * t.y + n.y * t.x) + tt * t.x * t.y) * share;
    (
        Reduced { force, torque },
        Hessian::about(centre, [xx, xy, yy]),
    )
}

/// ∫pρ/r, ∫p r and ∫pρρ/r³ in normal and tangent.
struct Moments<R> {
    across: R,
    along: R,
    turn: R,
    nn: R,
    nt: R,
    tt: R,
}

/// Those of the pressure `here` + `slope` t.
fn linear_moments<R: Real>(
    seen: &EdgeFromPole<R>,
    [i0, i1]: [R; 2],
    [here, slope]: [R; 2],
) -> Moments<R> {
    let EdgeFromPole {
        h,
        t0,
        t1,
        r0,
        r1,
        rise,
        log,
        integral,
    } = *seen;
    let (h_sq, third) = (h * h, R::ONE / (R::TWO + R::ONE));
    let squares = integral - h_sq * log;
    let cubes = rise * (r1 * r1 + r1 * r0 + r0 * r0) * third;
    let (flat, drop) = (t1 * i1 - t0 * i0, h * i1 - h * i0);
    let bent = rise + h * drop;
    Moments {
        across: h * (here * log + slope * rise),
        along: here * rise + slope * squares,
        turn: here * integral + slope * cubes,
        nn: here * flat - slope * h * drop,
        nt: slope * h * (log - flat) - here * drop,
        tt: here * (log - flat) + slope * bent,
    }
}

fn sliding<R: Real, K: PressureField<R>>(
    bar: &Bar<R, K>,
    slide: &TranslatingMotion<'_, R>,
) -> Reduced<R> {
    let spin = slide.spin;
    let at = |at| slid(Pair2::of(spin), at);
    let [missing, across, torque] = mean(bar, slide, at, FOR_WRENCH);
    slide.reduced_of([missing, across, torque])
}

fn bent<R: Real, K: PressureField<R>>(
    bar: &Bar<R, K>,
    slide: &TranslatingMotion<'_, R>,
) -> Hessian<R> {
    let spin = slide.spin;
    let at = |at| sums::bent(Pair2::of(spin), at);
    let [yy, yn, nn] = mean(bar, slide, at, FOR_HESSIAN);
    slide.hessian_of([yy, yn, nn])
}

/// Means of functions of a point along the bar.
fn mean<R: Real, K: PressureField<R>>(
    bar: &Bar<R, K>,
    slide: &TranslatingMotion<'_, R>,
    at: impl Fn([Pair2<R>; 2]) -> [Pair2<R>; 3],
    thresholds: [f64; 4],
) -> [R; 3] {
    let edge = bar.edge();
    let along = R::ONE / edge.length();
    let [sx, sy] = bar.pressure().slope();
    let [slope_x, slope_y] = slide.turned(&Vector2::new(sx, sy)).map(Pair2::of);
    let middle = Pair2::of(bar.pressure().at_centre());
    let sums = EdgePairs {
        slide,
        edges: core::slice::from_ref(edge),
        along: Some(along),
        at: |place| {
            let parts = at(place);
            if !K::IS_LINEAR {
                return parts;
            }
            let pressure = middle + slope_x * place[0] + slope_y * place[1];
            parts.map(|part| pressure * part)
        },
    };
    by_rule(&sums, slide.spin.abs(), thresholds)
}

#[cfg(test)]
mod tests {
    use crate::coupling::flat::ShapeFriction;
    use crate::patch::bar::Bar;
    use crate::patch::outline::{OutlineError, PressureField};
    use crate::real::Real;
    use crate::special::legendre::each_node;
    use crate::twist::{Twist, Wrench};

    /// The bar from (−0.1, 0.2) to (0.7, −0.4), whose length is 1.
    fn bar<R: Real>() -> Bar<R> {
        let place = |[x, y]: [f64; 2]| [R::from_f64(x), R::from_f64(y)];
        Bar::new(place([-0.1, 0.2]), place([0.7, -0.4])).unwrap()
    }

    fn wrench<R: Real, K: PressureField<R>>(bar: Bar<R, K>, [x, y, spin]: [f64; 3]) -> [f64; 12] {
        let friction = ShapeFriction::new(bar, R::ONE).unwrap();
        let twist = Twist::new(R::from_f64(x), R::from_f64(y), R::from_f64(spin));
        let (Wrench { force, torque }, jacobian) = friction.wrench_and_jacobian(R::ONE, &twist);
        let mut all = [0.0; 12];
        let parts = [force.x, force.y, torque]
            .into_iter()
            .chain(jacobian.iter().copied());
        for (to, part) in all.iter_mut().zip(parts) {
            *to = part.to_f64();
        }
        all
    }

    /// Wrench and Jacobian of a wedge by Gauss' rule on panels that halve towards the centre of rotation's foot.
    fn by_points(slope: f64, twist: [f64; 3]) -> [f64; 12] {
        let mut sums = [0.0; 12];
        let [vx, vy, spin] = twist;
        let foot = if spin == 0.0 {
            0.0
        } else {
            (0.8 * (-vy / spin + 0.1) - 0.6 * (vx / spin - 0.2)).clamp(0.0, 1.0)
        };
        for (end, sense) in [(1.0 - foot, 1.0), (foot, -1.0)] {
            for octave in 0..50 {
                let half = 0.5 * end * libm::exp2(-f64::from(octave + 1));
                each_node(|node: f64, weight| {
                    let along = foot + sense * half * (3.0 + node);
                    add_point(
                        &mut sums,
                        half * weight * (1.0 + slope * (along - 0.5)),
                        along,
                        twist,
                    );
                });
            }
        }
        sums
    }

    /// A point of the bar and its load.
    fn add_point(sums: &mut [f64; 12], load: f64, along: f64, [vx, vy, spin]: [f64; 3]) {
        let (x, y) = (0.8 * along - 0.1, 0.2 - 0.6 * along);
        let (qx, qy) = (vx - spin * y, vy + spin * x);
        let q = libm::hypot(qx, qy);
        let (ex, ey) = (qx / q, qy / q);
        // q changes along its normal with n = (−e_y, e_x, x·e).
        let across = [-ey, ex, x * ex + y * ey];
        let wrench = [-ex, -ey, -(x * ey - y * ex)];
        let second = across
            .iter()
            .flat_map(|a| across.iter().map(move |b| -(a * b) / q));
        for (sum, part) in sums.iter_mut().zip(wrench.into_iter().chain(second)) {
            *sum += load * part;
        }
    }

    const TWISTS: [[f64; 3]; 7] = [
        [0.0, 0.0, 1.0],
        [0.3, 0.4, -2.0],
        [1.0, 0.2, 0.7],
        [0.5, -1.0, 0.3],
        [-0.1, 1.0, 0.01],
        [1.0, 0.0, 0.0],
        [0.09, 0.31, 1.0],
    ];

    #[test]
    fn a_wedge_is_the_sum_of_its_points() {
        for slope in [2.0, -2.0, 0.6] {
            for twist in TWISTS {
                let exact = by_points(slope, twist);
                let found = wrench(bar::<f64>().with_slope(slope).unwrap(), twist);
                let single = wrench(bar::<f32>().with_slope(slope as f32).unwrap(), twist);
                let largest = exact[3..].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                for (k, exact) in exact.iter().enumerate() {
                    let scale = if k < 3 { 1.0 } else { largest };
                    let off = (found[k] - exact).abs() / scale;
                    let most = if k < 3 { [3e-14, 4e-6] } else { [1e-13, 2e-5] };
                    assert!(off < most[0], "{slope} {twist:?} {k}: {off}");
                    assert!(
                        (single[k] - found[k]).abs() < 2e-5 * scale,
                        "{slope} {twist:?} {k}"
                    );
                }
            }
        }
    }

    #[test]
    fn no_slope_is_uniform_pressure() {
        for twist in TWISTS {
            let level = wrench(bar::<f64>().with_slope(0.0).unwrap(), twist);
            let uniform = wrench(bar::<f64>(), twist);
            for (a, b) in level.iter().zip(uniform) {
                assert!(
                    (a - b).abs() <= 1e-13 * (1.0 + b.abs()),
                    "{twist:?}: {a} {b}"
                );
            }
        }
    }

    #[test]
    fn slope_and_centre_of_pressure_belong_together() {
        let by_slope = bar::<f64>().with_slope(1.2).unwrap();
        let by_centre = bar::<f64>().with_centre_of_pressure(0.1).unwrap();
        assert!((by_slope.centre() - by_centre.centre()).norm() < 1e-15);
        assert!((by_slope.radius() - 0.6).abs() < 1e-15);
        // A wedge turns about its thin end with the arm 2/3.
        let wedge = bar::<f64>().with_slope(2.0).unwrap();
        let about_its_end = [0.2, 0.1, 1.0];
        let [fx, fy, torque, ..] = wrench(wedge, about_its_end);
        let arm = -(torque - (-0.1 * fy - 0.2 * fx));
        assert!((arm - 2.0 / 3.0).abs() < 1e-15, "{arm}");
        for slope in [2.1, -2.1] {
            let lifted = bar::<f64>().with_slope(slope);
            assert!(matches!(lifted, Err(OutlineError::LiftOff { .. })));
        }
        assert_eq!(
            bar::<f64>().with_slope(f64::NAN).err(),
            Some(OutlineError::Slope)
        );
    }
}
