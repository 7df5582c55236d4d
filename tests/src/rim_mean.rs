//! An oracle for every exponent that shares no code with the kernel's series: means over the rim
//! by double-exponential quadrature.
//!
//! With rim speed 1 and d² = 1 + ε² − 2ε cosθ, the divergence theorem reduces the area means of
//! the uniform disk to the rim:
//!
//! ```text
//! F = ε ⟨2 sin²θ d^(α−1)⟩,    M = ⟨d^(α+1)⟩_disk = 2/(α+3) ⟨(1 − ε cosθ) d^(α+1)⟩,    T = M − ε F
//! ```

/// Steps of the tanh-sinh rule on either side of the middle, and their width: the last node's
/// weight is below 2⁻⁵³ of the middle one's for integrands that grow up to θ^(−1+1/5).
const STEPS: i32 = 120;
const STEP: f64 = 1.0 / 24.0;

/// F and T at ε with rim speed 1.
///
/// *Domain*: α > −1, ε ≥ 0; T loses digits to the difference M − εF beyond ε ≈ 1.
/// *Accuracy*: measured in `tests/dense.rs`.
pub fn force_and_torque(alpha: f64, ratio: f64) -> [f64; 2] {
    let gap_sq = (1.0 - ratio) * (1.0 - ratio);
    let (mut force, mut power) = (0.0, 0.0);
    for n in -STEPS..=STEPS {
        let u = f64::from(n) * STEP;
        let s = std::f64::consts::FRAC_PI_2 * u.sinh();
        // θ/π = 1/(1 + e^(−2s)), kept relative at both ends.
        let fraction = 1.0 / (1.0 + (-2.0 * s).exp());
        let weight = STEP * std::f64::consts::FRAC_PI_2 * u.cosh() / (s.cosh() * s.cosh()) * 0.5;
        let half = 0.5 * std::f64::consts::PI * fraction;
        let half_sin_sq = half.sin() * half.sin();
        let d_sq = gap_sq + 4.0 * ratio * half_sin_sq;
        if d_sq == 0.0 || weight == 0.0 {
            continue;
        }
        let sin = 2.0 * half.sin() * half.cos();
        // 1 − ε cosθ = (1 − ε) + 2ε sin²(θ/2)
        let along = (1.0 - ratio) + 2.0 * ratio * half_sin_sq;
        force += weight * 2.0 * sin * sin * d_sq.powf(0.5 * (alpha - 1.0));
        power += weight * along * d_sq.powf(0.5 * (alpha + 1.0));
    }
    let power = 2.0 / (alpha + 3.0) * power;
    [ratio * force, power - ratio * (ratio * force)]
}
