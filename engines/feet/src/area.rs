//! Elements of area friction: the dissipation of a motion and its derivatives.
//!
//! A patch under dry friction dissipates h(v, ω), the largest power that its friction can take from
//! the twist. Its gradient is the wrench against the motion, its second derivatives are the
//! kernel's Jacobian. h has a kink where the patch does not move. With √(v² + σ²) in place of the
//! speed v it is smooth and still convex, and as σ → 0 it is h.

use tribos_core::coupling::{ReducedJacobian, ReducedWrench};
use tribos_friction::{Area as Shape, BoxedDryFriction, FrictionError, Patch, polynomial};

/// The shape of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Area<'a> {
    /// A whole foot.
    Round(&'a Round),
    /// A point of another one.
    Point,
}

/// A round foot under dry friction.
#[derive(Debug)]
pub(crate) struct Round {
    dry: Box<dyn BoxedDryFriction<f64>>,
    /// In metres.
    radius: f64,
    /// Mean square of the distance from the middle, in radii.
    mean_square: f64,
}

impl Round {
    pub(crate) fn new(patch: &Patch, radius: f32) -> Result<Self, FrictionError> {
        let radius = f64::from(radius);
        let mean_square = match patch {
            Patch::Annulus(inner) => 0.5 * (1.0 + inner * inner),
            Patch::Polynomial(coefficients) => polynomial(coefficients)?.mean_square_radius(),
            _ => patch
                .pressure()
                .ok_or(FrictionError::NoAxis)?
                .mean_square_radius(),
        };
        Ok(Self {
            dry: Shape::round(patch.clone(), radius)?.dry()?,
            radius,
            mean_square,
        })
    }
}

/// A part of a foot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element<'a> {
    /// Position relative to the centre of mass in metres, in the contact's axes.
    pub(crate) place: [f64; 2],
    pub(crate) area: Area<'a>,
    /// Friction limit μN, in newtons.
    pub(crate) limit: f64,
    /// Index of the foot.
    pub(crate) foot: usize,
}

/// Gradient and second derivatives of the dissipation by the twist (x, y, spin).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Response {
    pub(crate) wrench: [f64; 3],
    /// xx, xy, yy, xn, yn, nn
    pub(crate) slope: [f64; 6],
}

/// Relative distance from equal speeds at which a ring's infinite derivatives are taken instead.
const BESIDE: f64 = 1e-7;

impl Area<'_> {
    /// Distance from the middle to the rim, in metres.
    pub(crate) fn radius(self) -> f64 {
        match self {
            Self::Round(round) => round.radius,
            Self::Point => 0.0,
        }
    }

    /// Mean square of the distance from the middle, in m².
    pub(crate) fn mean_square(self) -> f64 {
        match self {
            Self::Round(round) => round.mean_square * round.radius * round.radius,
            Self::Point => 0.0,
        }
    }

    /// Force and torque over limit and limit × radius, and their derivatives, at a sliding speed and
    /// a speed of the rim.
    fn reduced(self, slide: f64, rim: f64) -> (ReducedWrench<f64>, ReducedJacobian<f64>) {
        match self {
            Self::Round(round) => both(&*round.dry, slide, rim),
            Self::Point => {
                let wrench = ReducedWrench {
                    force: 1.0,
                    torque: 0.0,
                };
                let jacobian = ReducedJacobian {
                    force_per_slide: 1.0 / slide,
                    ..ReducedJacobian::default()
                };
                (wrench, jacobian)
            }
        }
    }
}

fn both(
    coupling: &dyn BoxedDryFriction<f64>,
    slide: f64,
    rim: f64,
) -> (ReducedWrench<f64>, ReducedJacobian<f64>) {
    let mut jacobian = coupling.reduced_jacobian(slide, rim);
    if !(jacobian.force_slide.is_finite() && jacobian.torque_rim.is_finite()) {
        jacobian = coupling.reduced_jacobian(slide * (1.0 + BESIDE), rim);
    }
    (coupling.reduced_wrench(slide, rim), jacobian)
}

impl Element<'_> {
    /// Velocity of the element under a twist at the centre of mass.
    fn velocity(&self, twist: &[f64; 3]) -> [f64; 2] {
        let [x, y] = self.place;
        [twist[0] - twist[2] * y, twist[1] + twist[2] * x]
    }

    /// Dissipation of a twist at the centre of mass in watts, smoothed over `smoothing` in m/s.
    pub(crate) fn power(&self, twist: &[f64; 3], smoothing: f64) -> f64 {
        let [vx, vy] = self.velocity(twist);
        let slide = (vx * vx + vy * vy + smoothing * smoothing).sqrt();
        let rim = twist[2].abs() * self.area.radius();
        let reduced = match self.area {
            Area::Round(round) => round.dry.reduced_wrench(slide, rim),
            Area::Point => return self.limit * slide,
        };
        self.limit * (slide * reduced.force + rim * reduced.torque)
    }

    /// The response to a twist at the centre of mass, smoothed over `smoothing` in m/s; about the
    /// centre of mass.
    pub(crate) fn response(&self, twist: &[f64; 3], smoothing: f64) -> Response {
        let [vx, vy] = self.velocity(twist);
        let slide = (vx * vx + vy * vy + smoothing * smoothing).sqrt();
        let radius = self.area.radius();
        let rim = twist[2].abs() * radius;
        let moves = slide + rim > 0.0;
        if !moves {
            return Response::default();
        }
        let (wrench, by) = self.area.reduced(slide, rim);
        let sign = 1.0_f64.copysign(twist[2]);
        let [cx, cy] = match slide > 0.0 {
            true => [vx / slide, vy / slide],
            false => [0.0; 2],
        };
        // Along the velocity ∂F/∂v, across it and for the smoothing F/v.
        let turn = by.force_slide - by.force_per_slide;
        let xx = self.limit * (by.force_per_slide + turn * cx * cx);
        let xy = self.limit * (turn * cx * cy);
        let yy = self.limit * (by.force_per_slide + turn * cy * cy);
        let mixed = self.limit * radius * sign * by.mixed;
        let own = self.limit * radius * radius * by.torque_rim;
        let [x, y] = self.place;
        let [fx, fy] = [cx, cy].map(|c| self.limit * wrench.force * c);
        let torque = self.limit * radius * sign * wrench.torque;
        // Moved to the centre of mass.
        let [xn, yn] = [x * xy - y * xx + mixed * cx, x * yy - y * xy + mixed * cy];
        let nn = own + mixed * (x * cy - y * cx) + (x * yn - y * xn);
        Response {
            wrench: [fx, fy, x * fy - y * fx + torque],
            slope: [xx, xy, yy, xn, yn, nn],
        }
    }
}
