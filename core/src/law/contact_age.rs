//! Age of a sliding contact and its evolution laws.

use super::limits::ln_ratio;
use crate::real::Real;

/// State variable θ of rate-and-state friction: roughly the mean age of its junctions.
///
/// ```
/// use tribos_core::law::{StateVariable, AgeingLaw, RateState, RateStateParameters};
/// let rock = RateState::<f64, AgeingLaw>::new(RateStateParameters {
///     mu: 0.6, a: 0.010, b: 0.015,
///     reference_speed: 1e-6, slip_distance: 1e-5, viscous: 0.0, // m/s, m
/// })?;
/// let young = StateVariable { theta: 1.0 }; // s
/// let held = rock.advance(young, 0.0, 99.0); // at rest
/// let healed = rock.coefficient(1e-6, held) - rock.coefficient(1e-6, young);
/// assert!((healed - 0.015 * 100_f64.ln()).abs() < 1e-12); // b for each e-fold of the age
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StateVariable<R> {
    /// θ ≥ 0. *Units*: time.
    pub theta: R,
}

/// A law of motion of θ that sliding by D_c, the memory length, renews.
///
/// Both laws here rest at θ = D_c/V and are solved exactly while V is constant. They share the
/// decay factor e^(−V dt/D_c).
///
/// *Accuracy*: some ulp, times V dt/D_c while the start is remembered.
///
/// ```
/// use tribos_core::law::{AgeingLaw, StateEvolution, SlipLaw};
/// let memory = 1e-5_f64; // D_c in m
/// // Steady sliding with 1 um/s keeps the age of 10 s.
/// assert!((AgeingLaw::evolved(10.0, 1e-6, memory, 3.0) - 10.0).abs() < 1e-13);
/// assert!((SlipLaw::evolved(10.0, 1e-6, memory, 3.0) - 10.0).abs() < 1e-13);
/// // They differ at rest.
/// assert_eq!(AgeingLaw::evolved(10.0, 0.0, memory, 3.0), 13.0);
/// assert_eq!(SlipLaw::evolved(10.0, 0.0, memory, 3.0), 10.0);
/// ```
pub trait StateEvolution {
    /// θ after the time `dt` at constant `speed`.
    ///
    /// *Domain*: all finite, `theta`, `speed`, `dt` ≥ 0, `slip_distance` > 0. NaN gives NaN.
    fn evolved<R: Real>(theta: R, speed: R, slip_distance: R, dt: R) -> R;
}

/// Ageing law θ' = 1 − Vθ/D_c: contacts age at rest too.
///
/// *Source*: Dieterich 1979; Ruina 1983.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AgeingLaw;

impl StateEvolution for AgeingLaw {
    /// θ(dt) = D_c/V + (θ − D_c/V) e^(−V dt/D_c), and θ + dt for V = 0.
    #[inline]
    fn evolved<R: Real>(theta: R, speed: R, slip_distance: R, dt: R) -> R {
        let slid = speed * dt / slip_distance;
        let renewed = -(-slid).exp_m1();
        // (D_c/V)(1 − e^−slid) = dt (1 − e^−slid)/slid: the second form lives at rest.
        let aged = if slid > R::ONE {
            slip_distance / speed * renewed
        } else if slid == R::ZERO {
            dt
        } else {
            dt * (renewed / slid)
        };
        theta * (-slid).exp() + aged
    }
}

/// Slip law θ' = −(Vθ/D_c) ln(Vθ/D_c): contacts at rest keep their age.
///
/// *Source*: Ruina 1983.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SlipLaw;

impl StateEvolution for SlipLaw {
    /// ln(Vθ/D_c) decays by e^(−V dt/D_c); θ stays for V = 0 or θ = 0.
    #[inline]
    fn evolved<R: Real>(theta: R, speed: R, slip_distance: R, dt: R) -> R {
        let slid = speed * dt / slip_distance;
        if slid == R::ZERO || theta == R::ZERO {
            // However far it slides, no age stays none.
            if slid == R::INFINITY {
                return theta;
            }
            // Sums and products that are zero, unless one of the arguments is NaN.
            return theta + theta * slid;
        }
        let excess = ln_ratio(speed, slip_distance) + theta.ln();
        if slid > R::ONE {
            // From the new steady state, which long sliding approaches.
            slip_distance / speed * (excess * (-slid).exp()).exp()
        } else {
            // From the old age, which short sliding keeps.
            theta * (excess * (-slid).exp_m1()).exp()
        }
    }
}
