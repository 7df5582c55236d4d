//! Friction on the feet of a body over a step, and the motion at its end.

use tribos_core::twist::{Twist, Wrench};

/// Friction on one foot.
///
/// ```
/// use tribos_core::twist::Wrench;
/// use tribos_feet::FootFriction;
/// assert_eq!(FootFriction::default().wrench, Wrench::ZERO);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FootFriction {
    /// Force and torque about the foot's own middle, as their mean over the step.
    pub wrench: Wrench<f32>,
    /// Whether the foot is at rest relative to its ground.
    pub holds: bool,
}

/// The end of a step.
///
/// ```
/// use tribos_core::contact::TimeStep;
/// use tribos_core::planar::PlanarBody;
/// use tribos_core::twist::{Twist, Wrench};
/// use tribos_feet::{Foot, Footprint, Standing};
/// let (puck, disk) = (PlanarBody::new(0.17, 1.36e-4)?, Footprint::disk(0.04)?);
/// let feet = [Foot::new(&disk, 0.5, [0.0; 2])]; // mu N is 0.5 N
/// let standing = Standing::new(&puck, None, &feet);
/// let thrown = Twist::new(1.0, 0.0, 20.0); // m/s, rad/s
/// let end = standing.step(&thrown, &Wrench::ZERO, TimeStep::new(1.0 / 60.0)?).ok_or("not finite")?;
/// assert!(!end.is_at_rest() && end.twist.velocity.x < 1.0);
/// assert_eq!(end.foot(0).wrench, end.friction);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Ended {
    /// The motion of the first foot relative to its ground after the step, at the centre of mass.
    pub twist: Twist<f32>,
    /// Friction of all feet at the centre of mass, as its mean over the step.
    pub friction: Wrench<f32>,
    /// Whether all feet are at rest.
    pub(crate) holds: bool,
    /// Each foot, where the kernel does not have the exact surface of a single one.
    pub(crate) all: Vec<FootFriction>,
}

impl Default for FootFriction {
    fn default() -> Self {
        Self {
            wrench: Wrench::ZERO,
            holds: false,
        }
    }
}

impl Ended {
    /// Friction on the foot with this number; none for a foot that was not given.
    pub fn foot(&self, number: usize) -> FootFriction {
        match (self.all.get(number), number) {
            (Some(foot), _) => *foot,
            (None, 0) => FootFriction {
                wrench: self.friction,
                holds: self.holds,
            },
            (None, _) => FootFriction::default(),
        }
    }

    /// Whether all feet are at rest relative to their ground.
    pub fn is_at_rest(&self) -> bool {
        self.holds
    }
}
