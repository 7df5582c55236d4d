//! Whether a packing is blocked, judged by means over windows of steps.

use crate::packing::Stress;
use crate::powder::scene::BlockedCriterion;

/// Least number of steps in a window: the pseudo-elastic waves of an iteration that stops early take
/// about ten steps to cross the thesis' systems.
pub const WINDOW_STEPS: u64 = 200;
/// Largest motion of the piston in a window, in R: 10⁻⁵ of the porosity. The thesis says "has not changed".
/// The motion that an iterative solver leaves behind, its pseudo-elastic waves, stays below this bound.
pub(super) const PISTON_MOTION: f64 = 1e-3;
/// A window is long enough for a piston without resistance to travel this multiple of that distance.
const DECISIVE: f64 = 100.0;
/// Largest deviation of the force on the piston and of σ_zz from the applied load: one per cent,
/// a tenth of the last digit of table 4.1.
pub(super) const LOAD_DEVIATION: f64 = 1e-2;
/// Largest ratio of the mean net force on a sphere to the mean contact force.
const UNBALANCED: f64 = 1e-2;

/// Sums over the steps of a window, each step weighted with its length.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use tribos::powder::{Means, Stress, Window};
/// use tribos::scene::BlockedCriterion;
/// // A piston of mass 100 on an area of 100 stands at 60 under a load of 0.5.
/// let plus = Matrix3::from_diagonal(&Vector3::new(0.0, 0.0, 0.005));
/// let stress = Stress { plus, minus: Matrix3::zeros() };
/// let mut window = Window::starting(60.0);
/// while !window.is_full(100.0, 0.5) {
///     window.add(0.1, &stress, [0.5, 0.0, 0.2]);
/// }
/// let means: Means = window.means(60.0);
/// assert!((means.piston - 0.5).abs() < 1e-12);
/// assert!(means.is_blocked(BlockedCriterion::Balance, 0.005, 100.0));
/// // Under twice the pressure the same forces would not balance.
/// assert!(!means.is_blocked(BlockedCriterion::Balance, 0.01, 100.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    /// Number of steps so far.
    pub steps: u64,
    /// Elapsed time.
    pub time: f64,
    /// Initial height of the piston.
    pub start: f64,
    /// Integral of the stress over time, ∫ σ dt.
    pub stress: Stress,
    /// Integrals of the contact force on the piston, the mean net force on a sphere and the mean
    /// normal force of a contact.
    pub forces: [f64; 3],
}

/// Means over a window.
///
/// See [`Window`] for an example.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Means {
    /// Magnitude of the change of the piston's height, a length.
    pub moved: f64,
    /// Mean contact force on the piston.
    pub piston: f64,
    /// Mean net force on a sphere.
    pub net: f64,
    /// Mean magnitude of a contact's normal force.
    pub contact: f64,
    /// Mean stress.
    pub stress: Stress,
}

impl Window {
    /// A window that begins with the piston at height `at`.
    pub fn starting(at: f64) -> Self {
        Self {
            start: at,
            ..Self::default()
        }
    }

    /// Adds a step of length `dt`; forces as in [`Window::forces`].
    pub fn add(&mut self, dt: f64, stress: &Stress, forces: [f64; 3]) {
        self.steps += 1;
        self.time += dt;
        self.stress = self.stress.plus_scaled(dt, stress);
        for (sum, force) in self.forces.iter_mut().zip(forces) {
            *sum += force * dt;
        }
    }

    /// True if the window is long enough to judge a piston of this mass under this load.
    pub fn is_full(&self, mass: f64, load: f64) -> bool {
        self.steps >= WINDOW_STEPS && self.time >= window_time(mass, load)
    }

    /// Means over the window, given the current height of the piston.
    pub fn means(&self, height: f64) -> Means {
        let [piston, net, contact] = self.forces.map(|sum| sum / self.time);
        Means {
            moved: (height - self.start).abs(),
            piston,
            net,
            contact,
            stress: Stress::default().plus_scaled(1.0 / self.time, &self.stress),
        }
    }
}

/// Time in which a piston without resistance travels far enough to be judged.
pub(super) fn window_time(mass: f64, load: f64) -> f64 {
    (2.0 * DECISIVE * PISTON_MOTION * mass / load).sqrt()
}

impl Means {
    /// The same without a part of σ_zz that does not bear the piston's load.
    pub(super) fn less(mut self, stress_zz: f64) -> Self {
        self.stress.plus.m33 -= stress_zz;
        self
    }

    /// Whether the packing is blocked under this pressure on this area.
    ///
    /// The piston must have moved by less than 10⁻³ R. The balance criterion also requires that the mean
    /// contact force on the piston and the mean σ_zz are within 1 % of the applied load, and that the mean net
    /// force on a sphere is less than 1 % of the mean contact force.
    pub fn is_blocked(&self, criterion: BlockedCriterion, pressure: f64, area: f64) -> bool {
        let stands = self.moved < PISTON_MOTION;
        let near = |value: f64, applied: f64| (value / applied - 1.0).abs() < LOAD_DEVIATION;
        let balances = near(self.piston, pressure * area)
            && near(self.stress.total().m33, pressure)
            && self.net < UNBALANCED * self.contact;
        match criterion {
            BlockedCriterion::Piston => stands,
            BlockedCriterion::Balance => stands && balances,
        }
    }
}
