//! The outcome of a collision of two equal solid spheres.
//!
//! With the normal n from the first centre to the second and the velocity of the second surface point relative
//! to the first, u = v₂ − v₁ − (ω₁ + ω₂) × n (R = 1), the impulse on the second sphere is (m = 1)
//!
//! ```text
//! J = −½ (1 + e) u_n n − ½ q/(1 + q) (1 + β) u_t,      q = I/(m R²) = 2/5
//! ```
//!
//! and its torque turns both spheres alike, ω' = ω − n × J/q. Under Coulomb's limit |J_t| ≤ μ J_n the tangential
//! restitution is the smaller of β₀ and −1 + μ (1 + e)(1 + 1/q) |u_n|/|u_t| (Walton 1993).

use nalgebra::Vector3;

/// Moment of inertia of a solid sphere, in m R².
pub(super) const INERTIA: f64 = 0.4;
/// Share of ½ u_t that a tangential impulse without slip takes: q/(1 + q).
pub(super) const GRIP: f64 = INERTIA / (1.0 + INERTIA);

/// What a collision does along the tangent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tangential {
    /// Nothing: smooth spheres.
    Smooth,
    /// Reverses a constant share of the tangential velocity.
    Rough {
        /// Tangential restitution β, from −1 (smooth) to 1 (perfectly rough).
        restitution: f64,
    },
    /// Slides with Coulomb friction, or sticks and rebounds (Walton 1993).
    Coulomb {
        /// Sliding coefficient.
        mu: f64,
        /// Tangential restitution β₀ of impacts that stick.
        restitution: f64,
    },
}

/// The law of a collision: e along the normal, and the tangent.
///
/// *Units*: masses in m, lengths in R. *Domain*: 0 ≤ e ≤ 1, −1 ≤ β ≤ 1, μ ≥ 0. *Accuracy*: momentum, angular momentum
/// and the energy balance to 1e-14, relative to the speeds. *Source*: Walton (1993).
///
/// ```
/// use tribos::event::{Impact, Motion, Tangential};
/// use tribos::nalgebra::Vector3;
/// let law = Impact::new(0.5, Tangential::Smooth)?;
/// let at = |speed| Motion { velocity: Vector3::x() * speed, spin: Vector3::zeros() };
/// let (mut a, mut b) = (at(1.0), at(-1.0));
/// let loss = law.collide(&Vector3::x(), &mut a, &mut b);
/// assert_eq!((a.velocity.x, b.velocity.x), (-0.5, 0.5));
/// assert_eq!(loss, 0.75); // (1 - e²) u_n²/4
/// # Ok::<(), tribos::event::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    restitution: f64,
    tangential: Tangential,
}

/// Velocity and spin of a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Velocity of the centre.
    pub velocity: Vector3<f64>,
    /// Angular velocity.
    pub spin: Vector3<f64>,
}

/// A coefficient of an impact is outside its domain.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the {name} of an impact must be {valid}, not {given}")]
pub struct ImpactError {
    /// Name of the coefficient.
    pub name: &'static str,
    /// What would be valid.
    pub valid: &'static str,
    /// The value.
    pub given: f64,
}

impl Impact {
    /// Without any loss: what a collision within the contact time does.
    pub(super) const ELASTIC: Self = Self {
        restitution: 1.0,
        tangential: Tangential::Smooth,
    };

    /// A law with these coefficients.
    pub fn new(restitution: f64, tangential: Tangential) -> Result<Self, ImpactError> {
        let check = |is_valid: bool, name, valid, given| {
            let error = ImpactError { name, valid, given };
            if is_valid { Ok(()) } else { Err(error) }
        };
        let fraction = (0.0..=1.0).contains(&restitution);
        check(fraction, "restitution", "from 0 to 1", restitution)?;
        if let Tangential::Coulomb { mu, .. } = tangential {
            let valid = mu >= 0.0 && mu.is_finite();
            check(valid, "sliding coefficient", "finite and >= 0", mu)?;
        }
        if let Tangential::Rough { restitution: beta }
        | Tangential::Coulomb {
            restitution: beta, ..
        } = tangential
        {
            let valid = (-1.0..=1.0).contains(&beta);
            check(valid, "tangential restitution", "from -1 to 1", beta)?;
        }
        Ok(Self {
            restitution,
            tangential,
        })
    }

    /// Coefficient of restitution along the normal.
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// What happens along the tangent.
    pub fn tangential(&self) -> Tangential {
        self.tangential
    }

    /// Tangential restitution of a collision with these speeds of approach and of sliding.
    pub(super) fn beta(&self, approach: f64, sliding: f64) -> f64 {
        match self.tangential {
            Tangential::Smooth => -1.0,
            Tangential::Rough { restitution } => restitution,
            Tangential::Coulomb { mu, restitution } => {
                let slips = mu * (1.0 + self.restitution) / GRIP * approach - sliding;
                // A sliding speed of 0 sticks.
                if slips < restitution * sliding {
                    slips / sliding
                } else {
                    restitution
                }
            }
        }
    }

    /// Applies a collision with the unit `normal` from `a` to `b`; gives the energy that is lost. Spheres that
    /// do not approach are left as they are.
    pub fn collide(&self, normal: &Vector3<f64>, a: &mut Motion, b: &mut Motion) -> f64 {
        let centres = b.velocity - a.velocity;
        let approach = -centres.dot(normal);
        if approach <= 0.0 {
            return 0.0;
        }
        // Normal impulse on b, with the reduced mass 1/2.
        let mut impulse = normal * (0.5 * (1.0 + self.restitution) * approach);
        let mut loss = 0.25 * (1.0 - self.restitution * self.restitution) * approach * approach;
        if self.tangential != Tangential::Smooth {
            let surface = centres - (a.spin + b.spin).cross(normal);
            let sliding = surface - normal * surface.dot(normal);
            let beta = self.beta(approach, sliding.norm());
            let tangential = sliding * (-0.5 * GRIP * (1.0 + beta));
            let turned = normal.cross(&tangential) / INERTIA;
            a.spin -= turned;
            b.spin -= turned;
            impulse += tangential;
            loss += 0.25 * GRIP * (1.0 - beta * beta) * sliding.norm_squared();
        }
        a.velocity -= impulse;
        b.velocity += impulse;
        loss
    }
}
