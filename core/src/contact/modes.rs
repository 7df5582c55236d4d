//! The relative motions that a contact resists. Modes that are not named are neither stored nor computed.

use super::vector::{dot, zero};
use crate::real::Real;
use core::fmt::Debug;
use nalgebra::Vector3;

/// The share of a [`ContactVector`] that lies in the contact plane: [`InPlane`] or [`Absent`].
pub trait PlanarPart<R: Real>: Copy + Debug + Default + PartialEq + Send + Sync {
    /// False for [`Absent`].
    const PRESENT: bool;
    /// The vector, zero if absent.
    fn vector(&self) -> Vector3<R>;
    /// Keeps the vector, or drops it if absent.
    fn of(vector: Vector3<R>) -> Self;
}

/// The share of a [`ContactVector`] about the normal: [`AboutNormal`] or [`Absent`].
pub trait AxialPart<R: Real>: Copy + Debug + Default + PartialEq + Send + Sync {
    /// False for [`Absent`].
    const PRESENT: bool;
    /// The component, zero if absent.
    fn component(&self) -> R;
    /// Keeps the component, or drops it if absent.
    fn of(component: R) -> Self;
}

/// A mode that the contact does not have. It takes no room.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Absent;

impl<R: Real> PlanarPart<R> for Absent {
    const PRESENT: bool = false;
    #[inline(always)]
    fn vector(&self) -> Vector3<R> {
        zero()
    }
    #[inline(always)]
    fn of(_: Vector3<R>) -> Self {
        Self
    }
}

impl<R: Real> AxialPart<R> for Absent {
    const PRESENT: bool = false;
    #[inline(always)]
    fn component(&self) -> R {
        R::ZERO
    }
    #[inline(always)]
    fn of(_: R) -> Self {
        Self
    }
}

/// A vector in the contact plane, in the axes of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InPlane<R>(pub Vector3<R>);

impl<R: Real> Default for InPlane<R> {
    fn default() -> Self {
        Self(zero())
    }
}

impl<R: Real> PlanarPart<R> for InPlane<R> {
    const PRESENT: bool = true;
    #[inline(always)]
    fn vector(&self) -> Vector3<R> {
        self.0
    }
    #[inline(always)]
    fn of(vector: Vector3<R>) -> Self {
        Self(vector)
    }
}

/// A component about the normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AboutNormal<R>(pub R);

impl<R: Real> AxialPart<R> for AboutNormal<R> {
    const PRESENT: bool = true;
    #[inline(always)]
    fn component(&self) -> R {
        self.0
    }
    #[inline(always)]
    fn of(component: R) -> Self {
        Self(component)
    }
}

/// A set of modes, named by a type.
///
/// ```
/// use tribos_core::contact::{AllModes, ContactModes, Frictionless, ContactVector, SlidingTorsion};
/// // What is not named takes no room.
/// assert_eq!(size_of::<ContactVector<f32, Frictionless>>(), size_of::<f32>());
/// assert_eq!(<AllModes as ContactModes<f32>>::UNKNOWNS, 6); // all relative motions of two bodies
/// assert_eq!(<SlidingTorsion as ContactModes<f32>>::UNKNOWNS, 4);
/// ```
pub trait ContactModes<R: Real>:
    Copy + Debug + Default + PartialEq + Send + Sync + 'static
{
    /// Unknowns of a contact, the normal one included.
    const UNKNOWNS: usize;
    /// Two directions of sliding.
    #[doc(hidden)]
    type Sliding: PlanarPart<R>;
    /// Two axes of rolling.
    #[doc(hidden)]
    type Rolling: PlanarPart<R>;
    /// Spinning about the normal.
    #[doc(hidden)]
    type Torsion: AxialPart<R>;
}

macro_rules! modes {
    ($($(#[$doc:meta])* $name:ident: $unknowns:literal, $sliding:ty, $rolling:ty, $torsion:ty;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            #[cfg_attr(feature = "defmt", derive(defmt::Format))]
            pub struct $name;

            impl<R: Real> ContactModes<R> for $name {
                const UNKNOWNS: usize = $unknowns;
                type Sliding = $sliding;
                type Rolling = $rolling;
                type Torsion = $torsion;
            }
        )*
    };
}

modes! {
    /// Only the normal force: 1 unknown.
    Frictionless: 1, Absent, Absent, Absent;
    /// Normal force and sliding friction: 3 unknowns.
    SlidingOnly: 3, InPlane<R>, Absent, Absent;
    /// Sliding and torsion friction: 4 unknowns.
    SlidingTorsion: 4, InPlane<R>, Absent, AboutNormal<R>;
    /// Sliding and rolling friction: 5 unknowns.
    SlidingRolling: 5, InPlane<R>, InPlane<R>, Absent;
    /// Sliding, rolling and torsion friction: 6 unknowns.
    AllModes: 6, InPlane<R>, InPlane<R>, AboutNormal<R>;
}

/// One number or vector a mode: an impulse, or the relative velocity that it does work on.
///
/// *Units*: momentum and angular momentum as impulse; length/time and 1/time as velocity. *Sign*:
/// an impulse acts on the second body, its opposite on the first; a velocity is that of the second
/// body less that of the first.
///
/// ```
/// use tribos_core::contact::{ContactVector, SlidingTorsion};
/// use tribos_core::nalgebra::Vector3;
/// type Turning = ContactVector<f64, SlidingTorsion>;
/// let (x, zero) = (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 0.0));
/// let impulse = Turning::new(2.0, x * -0.5, zero, -0.25); // N s, N m s
/// let velocity = Turning::new(0.0, x * 4.0, zero, 8.0); // m/s, rad/s
/// assert_eq!(impulse.dot(&velocity), -0.5 * 4.0 - 0.25 * 8.0); // friction's work, J
/// // As vectors in space, with the normal up.
/// let up = Vector3::new(0.0, 0.0, 1.0);
/// assert_eq!(impulse.linear(&up), Vector3::new(-0.5, 0.0, 2.0));
/// assert_eq!(impulse.angular(&up), Vector3::new(0.0, 0.0, -0.25));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactVector<R: Real, M: ContactModes<R>> {
    /// Along the normal, which points from the first body to the second: positive pushes apart.
    pub normal: R,
    pub(crate) sliding: M::Sliding,
    pub(crate) rolling: M::Rolling,
    pub(crate) torsion: M::Torsion,
}

impl<R: Real, M: ContactModes<R>> ContactVector<R, M> {
    /// From all modes, of which those that `M` does not name are dropped.
    #[inline(always)]
    pub fn new(normal: R, sliding: Vector3<R>, rolling: Vector3<R>, torsion: R) -> Self {
        Self {
            normal,
            sliding: M::Sliding::of(sliding),
            rolling: M::Rolling::of(rolling),
            torsion: M::Torsion::of(torsion),
        }
    }

    /// Force impulse in the contact plane, or sliding velocity; zero without that mode.
    #[inline(always)]
    pub fn sliding(&self) -> Vector3<R> {
        self.sliding.vector()
    }

    /// Torque impulse in the contact plane, or rolling velocity; zero without that mode.
    #[inline(always)]
    pub fn rolling(&self) -> Vector3<R> {
        self.rolling.vector()
    }

    /// Torque impulse about the normal, or spin; zero without that mode.
    #[inline(always)]
    pub fn torsion(&self) -> R {
        self.torsion.component()
    }

    /// `self` + `factor` · `other`
    ///
    /// ```
    /// use tribos_core::contact::{ContactVector, SlidingTorsion};
    /// let zero = tribos_core::nalgebra::Vector3::zeros();
    /// let a = ContactVector::<f64, SlidingTorsion>::new(2.0, zero, zero, 0.5);
    /// assert_eq!(a.plus_scaled(1.0, &a).minus(&a), a);
    /// assert_eq!(a.plus_scaled(-1.0, &a), ContactVector::default());
    /// ```
    #[inline(always)]
    pub fn plus_scaled(&self, factor: R, other: &Self) -> Self {
        Self {
            normal: self.normal + factor * other.normal,
            sliding: M::Sliding::of(self.sliding() + other.sliding() * factor),
            rolling: M::Rolling::of(self.rolling() + other.rolling() * factor),
            torsion: M::Torsion::of(self.torsion() + factor * other.torsion()),
        }
    }

    /// `self` − `other`
    #[inline(always)]
    pub fn minus(&self, other: &Self) -> Self {
        Self {
            normal: self.normal - other.normal,
            sliding: M::Sliding::of(self.sliding() - other.sliding()),
            rolling: M::Rolling::of(self.rolling() - other.rolling()),
            torsion: M::Torsion::of(self.torsion() - other.torsion()),
        }
    }

    /// Sum over the modes of the products with `other`: work, if one is an impulse and one a
    /// velocity.
    #[inline(always)]
    pub fn dot(&self, other: &Self) -> R {
        let mut sum = self.normal * other.normal;
        if M::Sliding::PRESENT {
            sum += dot(&self.sliding(), &other.sliding());
        }
        if M::Rolling::PRESENT {
            sum += dot(&self.rolling(), &other.rolling());
        }
        if M::Torsion::PRESENT {
            sum += self.torsion() * other.torsion();
        }
        sum
    }

    /// Two impulses compared: torques count by the force at the distance `lever`.
    ///
    /// ```
    /// use tribos_core::contact::{ContactVector, SlidingTorsion};
    /// let zero = tribos_core::nalgebra::Vector3::zeros();
    /// let twist = ContactVector::<f64, SlidingTorsion>::new(0.0, zero, zero, 0.5); // N m s
    /// // At a lever of 0.25 m that is as much as 2 N s.
    /// assert_eq!(twist.dot_with_lever(&twist, 0.25), 2.0 * 2.0);
    /// ```
    #[inline(always)]
    pub fn dot_with_lever(&self, other: &Self, lever: R) -> R {
        let mut sum = self.normal * other.normal;
        if M::Sliding::PRESENT {
            sum += dot(&self.sliding(), &other.sliding());
        }
        let mut torques = R::ZERO;
        if M::Rolling::PRESENT {
            torques += dot(&self.rolling(), &other.rolling());
        }
        if M::Torsion::PRESENT {
            torques += self.torsion() * other.torsion();
        }
        if M::Rolling::PRESENT || M::Torsion::PRESENT {
            sum += torques / (lever * lever);
        }
        sum
    }

    /// Force (or velocity) along the normal and in the plane, as one vector.
    #[inline(always)]
    pub fn linear(&self, normal: &Vector3<R>) -> Vector3<R> {
        let along = normal * self.normal;
        if M::Sliding::PRESENT {
            along + self.sliding()
        } else {
            along
        }
    }

    /// Torque (or angular velocity) about the normal and in the plane, as one vector.
    #[inline(always)]
    pub fn angular(&self, normal: &Vector3<R>) -> Vector3<R> {
        let about = normal * self.torsion();
        if M::Rolling::PRESENT {
            about + self.rolling()
        } else {
            about
        }
    }
}
