//! Mixing rules: Lennard-Jones parameters of unlike species.

/// How ε and σ of two species are mixed.
///
/// ```
/// use tribos::md::pair::Mixing;
/// let [argon, krypton] = [[119.8, 3.405], [164.0, 3.83]]; // ε in K, σ in Å
/// // The means of σ have the powers 0, 1 and 6: the higher, the larger.
/// let sigmas = Mixing::WORDS.map(|(_, rule)| rule.mix(argon, krypton)[1]);
/// assert!(sigmas.is_sorted() && 3.405 < sigmas[0] && sigmas[2] < 3.83);
/// let [epsilon, _] = Mixing::Geometric.mix(argon, krypton);
/// assert!((epsilon * epsilon - 119.8 * 164.0).abs() < 1e-10);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mixing {
    /// Geometric means of ε and σ (Good & Hope 1970).
    #[default]
    Geometric,
    /// ε geometric, σ arithmetic (Lorentz 1881, Berthelot 1898).
    Arithmetic,
    /// Means of σ⁶ and of εσ⁶ (Waldman & Hagler 1993).
    SixthPower,
}

impl Mixing {
    /// Names of the rules in scenes, in the order of the variants.
    pub const WORDS: [(&'static str, Self); 3] = [
        ("geometric", Self::Geometric),
        ("arithmetic", Self::Arithmetic),
        ("sixthpower", Self::SixthPower),
    ];

    /// ε and σ of a pair from those of its species. *Domain*: > 0.
    pub fn mix(self, [epsilon_a, sigma_a]: [f64; 2], [epsilon_b, sigma_b]: [f64; 2]) -> [f64; 2] {
        let epsilon = (epsilon_a * epsilon_b).sqrt();
        match self {
            Self::Geometric => [epsilon, (sigma_a * sigma_b).sqrt()],
            Self::Arithmetic => [epsilon, 0.5 * (sigma_a + sigma_b)],
            Self::SixthPower => {
                let [a, b] = [sigma_a, sigma_b].map(|sigma| sigma * sigma * sigma);
                let mean = 0.5 * (a * a + b * b);
                [epsilon * a * b / mean, libm::cbrt(mean).sqrt()]
            }
        }
    }
}
