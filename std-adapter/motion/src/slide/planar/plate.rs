//! A flat plate of any outline.

use super::Resistance;
use crate::slide::MotionError;
use tribos_core::Real;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::law::LawError;
use tribos_core::twist::Twist;
use tribos_friction::{Area, Coefficients, Flat};

/// A plate that lies flat and slides under Coulomb friction, with its centre of mass above the centre of
/// its outline. Unless it is symmetric, its spin drives it aside and its slide turns it.
///
/// The wrench is exact to rounding ([`ShapeFriction`]). *Units*: SI; the radius is that of gyration, so that the
/// inertia ratio is 1.
///
/// ```
/// use tribos::friction::FlatPatch;
/// use tribos::slide::planar::{PlanarSimulation, Launch, Plate};
/// let tile: FlatPatch = "box:0.3x0.2".parse()?; // m
/// let tile = Plate::new(tile.loaded(None)?, 0.3, 9.81)?; // mu, m/s²
/// let launch = Launch { velocity: [1.0, 0.0], spin: 5.0 };
/// let end = PlanarSimulation::new(&tile, &launch, 1e-4)?.to_end()?;
/// // Without spin it would stop after v²/(2 mu g).
/// assert!(end.point.distance > 1.0 / (2.0 * 0.3 * 9.81));
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Debug)]
pub struct Plate {
    friction: ShapeFriction<f64, Flat<f64>>,
    gravity: f64,
    gyration: f64,
    orientation: f64,
}

impl Plate {
    /// A plate of uniform thickness on `patch`, under friction with this coefficient.
    ///
    /// *Domain*: coefficient ≥ 0, gravity > 0, in m/s²; meshes are refused.
    pub fn new(patch: Flat<f64>, coefficient: f64, gravity: f64) -> Result<Self, MotionError> {
        let gyration = patch.radius_of_gyration()?;
        Ok(Self {
            friction: ShapeFriction::new(patch, coefficient)?,
            gravity: positive("gravity", gravity)?,
            gyration,
            orientation: 0.0,
        })
    }

    /// The plate under friction that differs along two axes of its outline.
    pub fn with_coefficients(self, mu: &Coefficients) -> Result<Self, MotionError> {
        let area = mu.on(Area::Flat(self.friction.patch().clone()))?;
        let friction = ShapeFriction::new(area.into_flat()?, mu.largest())?;
        Ok(Self { friction, ..self })
    }

    /// The plate with another radius of gyration about its upright axis, in m.
    pub fn with_radius_of_gyration(self, radius: f64) -> Result<Self, MotionError> {
        let gyration = positive("radius of gyration", radius)?;
        Ok(Self { gyration, ..self })
    }

    /// The plate with its outline turned by this angle at the launch, in rad.
    pub fn with_orientation(self, orientation: f64) -> Self {
        Self {
            orientation,
            ..self
        }
    }
}

fn positive(parameter: &'static str, given: f64) -> Result<f64, MotionError> {
    if given > 0.0 && given.is_finite() {
        Ok(given)
    } else {
        Err(MotionError::Law(LawError::NotPositive { parameter, given }))
    }
}

impl Resistance for Plate {
    fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3] {
        self.deceleration_at(velocity, 0.0)
    }

    fn deceleration_at(&self, [x, y, rim]: [f64; 3], angle: f64) -> [f64; 3] {
        let turned = self.orientation + angle;
        let (sin, cos) = (Real::sin(turned), Real::cos(turned));
        let spin = rim / self.gyration;
        let centre = self.friction.patch().centre();
        let twist = Twist::new(
            cos * x + sin * y + spin * centre.y,
            cos * y - sin * x - spin * centre.x,
            spin,
        );
        let wrench = self.friction.wrench(self.gravity, &twist);
        let (fx, fy) = (wrench.force.x, wrench.force.y);
        let torque = wrench.torque - (centre.x * fy - centre.y * fx);
        [
            sin * fy - cos * fx,
            -(sin * fx + cos * fy),
            -torque / self.gyration,
        ]
    }

    fn is_round(&self) -> bool {
        false
    }

    fn exponent(&self) -> f64 {
        0.0
    }

    fn inertia_ratio(&self) -> f64 {
        1.0
    }

    fn radius(&self) -> f64 {
        self.gyration
    }
}
