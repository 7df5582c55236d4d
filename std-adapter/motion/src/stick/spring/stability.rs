//! The stiffness at which steady sliding under rate and state becomes unstable.

use tribos_core::law::RateStateParameters;

/// Stiffness below which a spring cannot pull a body steadily with `speed`.
///
/// ```text
/// k_c = N (b − a − ηV)/D_c · ( 1 + m V²/(N (a + ηV) D_c) )
/// ```
///
/// With v ∝ e^(λt) around steady sliding, both evolution laws give
/// m λ³ + (A + mV/D_c) λ² + (k + (AV − Nb)/D_c) λ + kV/D_c = 0 with A = N (a/V + η); a pair of roots
/// crosses the imaginary axis where the product of the inner coefficients is that of the outer ones.
///
/// *Units*: load in N, mass in kg, `speed` in m/s; the result in N/m, negative where friction strengthens and
/// every spring pulls steadily. *Domain*: V far above the speed q at which the law is regularised.
/// *Source*: Ruina 1983 for m = η = 0; Rice and Ruina 1983 for the mass.
///
/// ```
/// use tribos::kernel::law::RateStateParameters;
/// use tribos::stick::spring::critical_stiffness;
/// let rock = RateStateParameters {
///     mu: 0.6, a: 0.010, b: 0.015, reference_speed: 1e-6, slip_distance: 1e-5, viscous: 0.0,
/// };
/// let slow = critical_stiffness(&rock, 10.0, 1.0, 1e-6); // N, kg, m/s
/// assert!((slow - 5000.0).abs() < 1e-2); // N (b - a)/D_c, in N/m
/// // At 0.3 mm/s the mass adds m V²/(N a D_c) = 9 %.
/// let fast = critical_stiffness(&rock, 10.0, 1.0, 3e-4);
/// assert!((fast / slow - 1.09).abs() < 1e-5);
/// ```
pub fn critical_stiffness(law: &RateStateParameters<f64>, load: f64, mass: f64, speed: f64) -> f64 {
    let strengthening = law.a + law.viscous * speed;
    let quasi_static = load * (law.b - strengthening) / law.slip_distance;
    let inertia = mass * speed * speed / (load * strengthening * law.slip_distance);
    quasi_static * (1.0 + inertia)
}
