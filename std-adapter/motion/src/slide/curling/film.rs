//! A film of water dragged along by the band.

use super::ring_rule::{POINTS, points};
use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::MotionError;
use crate::slide::planar::Resistance;
use tribos_core::Real;
use tribos_core::law::LawError;

/// Step tolerance, which need not be finer than the accuracy of the quadrature rule.
const ACCURACY: f64 = 1e-9;

/// Friction against a thin film of melt water that the turning band drags along, more strongly at the front
/// than at the back.
///
/// *Formula* (our own parametrisation): the film under the element at angle φ from the direction
/// of motion moves with the fraction
///
/// ```text
/// f(φ) = (f₁ + f₂)/2 + (f₁ − f₂)/2 · v/√(v² + w²) · cos φ,    w = |ω|R
/// ```
///
/// of the band's rotational velocity ω × r; friction is γ |u|^α against u = v + (1 − f) ω × r, on
/// a thin ring under uniform pressure. Without sliding there is no front, so the difference vanishes
/// with v.
///
/// *Source of the idea*: Shegelski, Niebergall & Walton, Can. J. Phys. 74 (1996) 663, and Jensen &
/// Shegelski, Can. J. Phys. 82 (2004) 791 (arXiv 2112.09835): friction opposes the motion
/// relative to the film and not to the ice; their equations were not available. *Confidence*: a liquid
/// film is likely; that it releases the front and holds the back is assumed here to obtain the correct
/// sign, since the thesis notes that the film alone does not explain it. Even the largest
/// difference, f from 1 to 0, gives too little curl, and in proportion to the spin.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, Film, IceLaw};
/// let (rock, ice) = (CurlingRock::STANDARD, IceLaw::PENNER);
/// // A film that turns with the band leaves the spin alone.
/// let whole = Film { ice, front: 1.0, back: 1.0 }.resistance(&rock)?;
/// let [back, side, spin_down] = whole.deceleration([2.0, 0.0, 0.1]);
/// let friction = ice.coefficient * 2.0_f64.powf(ice.alpha) * rock.gravity;
/// assert!((back - friction).abs() < 1e-14 && side.abs() < 1e-14 && spin_down.abs() < 1e-14);
/// // One that goes along in front only lets the back hold: to the left.
/// let front = Film { ice, front: 1.0, back: 0.0 }.resistance(&rock)?;
/// assert!(front.deceleration([2.0, 0.0, 0.1])[1] < 0.0);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Film {
    /// Law of the ice.
    pub ice: IceLaw,
    /// f₁, the fraction at the front, from 0 to 1.
    pub front: f64,
    /// f₂, the fraction at the back, from 0 to 1.
    pub back: f64,
}

impl CurlingModel for Film {
    fn name(&self) -> &'static str {
        "film"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, MotionError> {
        Ok(Box::new(FilmRing::new(self, rock)?))
    }
}

/// A ring on a film, integrated with a fixed rule of 256 points.
///
/// *Accuracy* of force and torque for α = −1/2: 1e-12 where v and (1−f)w differ by a tenth, 1e-6 by
/// a twentieth, and 4e-2 where they meet and an element of the ring stands still.
///
/// ```
/// use tribos::slide::curling::{CurlingModel, CurlingRock, Film, FilmRing, IceLaw, LeftRight};
/// use tribos::slide::{MotionError, planar::Resistance};
/// let (rock, ice) = (CurlingRock::STANDARD, IceLaw::PENNER);
/// // Without a film it is the ring on bare ice, which the kernel integrates.
/// let ring = FilmRing::new(&Film { ice, front: 0.0, back: 0.0 }, &rock)?;
/// let bare = LeftRight { ice }.resistance(&rock)?;
/// let [a, b] = [ring.deceleration([2.0, 0.0, 0.1]), bare.deceleration([2.0, 0.0, 0.1])];
/// assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12));
/// let steep = Film { ice: IceLaw { alpha: -1.0, ..ice }, front: 0.0, back: 0.0 };
/// assert!(matches!(FilmRing::new(&steep, &rock), Err(MotionError::Law(_))));
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FilmRing {
    /// (cos φ, sin φ) of the points.
    points: Vec<[f64; 2]>,
    /// Mean (f₁ + f₂)/2 and half difference (f₁ − f₂)/2.
    film: [f64; 2],
    strength: f64,
    alpha: f64,
    radius: f64,
    inertia_ratio: f64,
}

impl FilmRing {
    /// *Domain*: α > −1.
    pub fn new(film: &Film, rock: &CurlingRock) -> Result<Self, MotionError> {
        let alpha = film.ice.alpha;
        let is_valid = alpha > -1.0 && alpha.is_finite();
        if !is_valid {
            return Err(MotionError::Law(LawError::Exponent {
                given: alpha,
                max: f64::MAX,
            }));
        }
        Ok(Self {
            points: points(),
            film: [
                0.5 * (film.front + film.back),
                0.5 * (film.front - film.back),
            ],
            strength: film.ice.coefficient * rock.gravity / POINTS as f64,
            alpha,
            radius: rock.band_radius,
            inertia_ratio: rock.inertia_ratio,
        })
    }
}

impl Resistance for FilmRing {
    fn deceleration(&self, [x, y, signed_rim]: [f64; 3]) -> [f64; 3] {
        let speed = Real::hypot(x, y);
        let (rim, sense) = (signed_rim.abs(), Real::copysign(1.0, signed_rim));
        let (mut back, mut side, mut torque) = (0.0, 0.0, 0.0);
        let [mean, half_change] = self.film;
        let whole = Real::hypot(speed, rim);
        let change = if whole > 0.0 {
            half_change * speed / whole
        } else {
            0.0
        };
        for &[cos, sin] in &self.points {
            let slip = 1.0 - mean - change * cos;
            // Velocity relative to the film, along the motion and to the left of it.
            let (along, left) = (speed - slip * rim * sin, slip * rim * cos);
            let square = along * along + left * left;
            if square > 0.0 {
                let drag = Real::pow(square, 0.5 * (self.alpha - 1.0));
                back += drag * along;
                side += drag * left;
                torque += drag * (cos * left - sin * along);
            }
        }
        let (cos, sin) = if speed == 0.0 {
            (1.0, 0.0)
        } else {
            (x / speed, y / speed)
        };
        let (side, torque) = (side * sense, torque * sense);
        [
            self.strength * (back * cos - side * sin),
            self.strength * (back * sin + side * cos),
            self.strength * torque / self.inertia_ratio,
        ]
    }

    fn accuracy(&self) -> f64 {
        ACCURACY
    }
    fn exponent(&self) -> f64 {
        self.alpha
    }
    fn inertia_ratio(&self) -> f64 {
        self.inertia_ratio
    }
    fn radius(&self) -> f64 {
        self.radius
    }
}
