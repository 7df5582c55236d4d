//! Torque of a patch that slides and spins, beside what the torsional coefficients of engines make of it.
//!
//! All torques are about the centre of pressure and divided by μN: lengths.

use crate::failure::Failure;
use tribos::friction::Area;
use tribos_core::Real;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::twist::Twist;

/// How an engine limits force and torque of a contact, with the length l = torsional coefficient/μ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// (force/μN)² + (torque/(μN l))² ≤ 1.
    Ellipsoid,
    /// Force and torque each within limits of its own.
    Separate,
    /// |force_x| + |force_y| + |torque|/l ≤ μN, in the axes of the contact.
    Pyramid,
}

/// All of them.
pub const MODELS: [Model; 3] = [Model::Ellipsoid, Model::Separate, Model::Pyramid];

impl Model {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ellipsoid => "ellipsoid",
            Self::Separate => "separate",
            Self::Pyramid => "pyramid",
        }
    }

    /// The torque of most dissipation at `turn` = spin/speed, sliding along an axis of the contact; the limit of
    /// spinning alone for an infinite one.
    fn torque(self, length: f64, turn: f64) -> f64 {
        match self {
            Self::Ellipsoid if turn.is_infinite() => length,
            Self::Ellipsoid => length * (length * turn) / Real::hypot(length * turn, 1.0),
            Self::Separate => length,
            Self::Pyramid if length * turn > 1.0 => length,
            Self::Pyramid => 0.0,
        }
    }
}

/// One ratio of spin to sliding, and the exact torque in some directions of sliding.
struct Sample {
    /// Spin over speed, in 1/m.
    turn: f64,
    torques: Vec<f64>,
}

impl Sample {
    fn largest_error(&self, torque: f64) -> f64 {
        let errors = self.torques.iter().map(|exact| (torque - exact).abs());
        errors.fold(0.0, f64::max)
    }
}

/// A patch whose torque is known over all ratios of spin to sliding.
pub struct Torsion {
    /// Torque of spinning alone, T₀/(μN), in m.
    pub arm: f64,
    /// Distance of the farthest point from the centre of pressure, in m.
    pub radius: f64,
    samples: Vec<Sample>,
    set: Box<dyn FrictionSet<f64> + Send + Sync>,
    centre: [f64; 2],
    is_round: bool,
}

/// Directions of sliding on patches that are not round.
const DIRECTIONS: u32 = 24;
/// Ratios of spin·R to speed: so many from 10⁻³ to 10³, beside sliding and spinning alone.
const RATIOS: u32 = 241;
const DECADES: f64 = 3.0;
/// Lengths that a fit tries first, up to twice the arm, and halvings after that.
const TRIED: u32 = 400;
const HALVINGS: u32 = 60;
/// Share of a bracket that a step of the golden section keeps.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// How well a length serves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// l, in m.
    pub length: f64,
    /// Largest error of the torque over all motions, as a share of T₀.
    pub error: f64,
}

impl Torsion {
    /// That of an area.
    pub fn new(area: &Area) -> Result<Self, Failure> {
        let mut torsion = Self {
            arm: 0.0,
            radius: area.radius(),
            samples: Vec::new(),
            set: area.limit_surface(1.0)?,
            centre: area.centre(),
            is_round: area.is_round(),
        };
        torsion.arm = torsion.torque([0.0; 2], 1.0);
        let ratio = |i: u32| {
            let share = f64::from(i) / f64::from(RATIOS - 1);
            Real::pow(10.0, DECADES * (2.0 * share - 1.0))
        };
        torsion.samples = (0..RATIOS)
            .map(|i| torsion.sample(ratio(i) / torsion.radius))
            .collect();
        Ok(torsion)
    }

    fn sample(&self, turn: f64) -> Sample {
        let count = if self.is_round { 1 } else { DIRECTIONS };
        let torque = |i: u32| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(count);
            self.torque([Real::cos(angle), Real::sin(angle)], turn)
        };
        Sample {
            turn,
            torques: (0..count).map(torque).collect(),
        }
    }

    /// The exact torque against `spin` about the centre of pressure, which slides.
    fn torque(&self, [x, y]: [f64; 2], spin: f64) -> f64 {
        let [cx, cy] = self.centre;
        let friction = self
            .set
            .wrench(&Twist::new(x + spin * cy, y - spin * cx, spin));
        -(friction.torque - (cx * friction.force.y - cy * friction.force.x))
    }

    /// The torque at a ratio of spin·R to speed, the mean over directions of sliding, as a share of T₀.
    pub fn share_at(&self, ratio: f64) -> f64 {
        let torques = self.sample(ratio / self.radius).torques;
        torques.iter().sum::<f64>() / torques.len() as f64 / self.arm
    }

    /// Error of a model at a ratio, as a share of T₀: that of the direction in which it is largest.
    pub fn error_at(&self, model: Model, length: f64, ratio: f64) -> f64 {
        let sample = self.sample(ratio / self.radius);
        let made = model.torque(length, sample.turn);
        let errors = sample.torques.iter().map(|exact| (made - exact) / self.arm);
        errors.fold(0.0, |worst: f64, error| {
            if error.abs() > worst.abs() {
                error
            } else {
                worst
            }
        })
    }

    /// The largest error of a length over all ratios and directions.
    fn judged(&self, model: Model, length: f64) -> Fit {
        // Sliding with hardly any spin, where the exact torque vanishes, and spinning alone.
        let mut error = model.torque(length, 0.0).max((length - self.arm).abs());
        for sample in &self.samples {
            error = error.max(sample.largest_error(model.torque(length, sample.turn)));
        }
        // A pyramid's torque jumps from none to all of it.
        if model == Model::Pyramid {
            let jump = self.sample(1.0 / length);
            error = error
                .max(jump.largest_error(0.0))
                .max(jump.largest_error(length));
        }
        Fit {
            length,
            error: error / self.arm,
        }
    }

    /// The length that is exact where the patch spins alone: T₀/(μN).
    pub fn exact_at_spin(&self, model: Model) -> Fit {
        self.judged(model, self.arm)
    }

    /// The length with the least largest error.
    ///
    /// Every error falls to its least and rises again over the length, and so does the largest of them: a
    /// golden section within the best of some lengths ends at the least.
    pub fn least_error(&self, model: Model) -> Fit {
        let cell = 2.0 * self.arm / f64::from(TRIED);
        let tried = (1..=TRIED).map(|i| self.judged(model, cell * f64::from(i)));
        let first = self.judged(model, self.arm);
        let better = |best: Fit, fit: Fit| if fit.error < best.error { fit } else { best };
        let mut best = tried.fold(first, better);
        let (mut low, mut high) = ((best.length - cell).max(0.0), best.length + cell);
        for _ in 0..HALVINGS {
            let (left, right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
            let [left, right] = [left, right].map(|length| self.judged(model, length));
            best = better(better(best, left), right);
            if left.error < right.error {
                high = right.length;
            } else {
                low = left.length;
            }
        }
        best
    }
}
