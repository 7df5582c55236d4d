//! The face-centred cubic crystal of a potential at zero temperature and pressure.

use super::Functions;
use tribos_base::bracket::Bracket;

/// Distances tried for the deepest energy, as parts of the cut-off.
const RANGE: [f64; 2] = [0.2, 0.98];
/// Number of distances tried.
const TRIED: usize = 400;
/// Halvings of the interval around the deepest one, to the last bits of a distance.
const HALVINGS: usize = 60;

/// Squares of the distances from an atom in units of the nearest one, with the number of atoms there.
fn shells(reach_sq: f64) -> Vec<(f64, f64)> {
    let most = (2.0 * reach_sq).sqrt().ceil() as i64;
    let mut counts = vec![0.0; (2.0 * reach_sq).floor() as usize / 2 + 1];
    for i in -most..=most {
        for j in -most..=most {
            for k in -most..=most {
                let square = i * i + j * j + k * k;
                // Sites of the lattice have an even sum of coordinates.
                if (i + j + k) % 2 == 0
                    && let Some(count) = counts.get_mut((square / 2) as usize)
                {
                    *count += 1.0;
                }
            }
        }
    }
    let shells = counts.into_iter().enumerate().skip(1);
    shells
        .filter(|(_, count)| *count > 0.0)
        .map(|(square, count)| (square as f64, count))
        .collect()
}

/// Energy of an atom of a crystal with this distance of nearest neighbours, and its slope against the
/// logarithm of the distance.
fn energy(law: &impl Functions, species: u8, spacing: f64) -> [f64; 2] {
    let (mut density, mut pairs) = ([0.0; 2], [0.0; 2]);
    for (square, count) in shells(law.cutoff_sq() / (spacing * spacing)) {
        let r = spacing * square.sqrt();
        if r * r < law.cutoff_sq() {
            let ([at_own, _], pair) = law.pair([species; 2], r);
            for (sum, jet) in [(&mut density, at_own), (&mut pairs, pair)] {
                sum[0] += count * jet[0];
                sum[1] += count * jet[1] * r;
            }
        }
    }
    let [embedded, slope] = law.embedding(species, density[0]);
    [
        embedded + 0.5 * pairs[0],
        slope * density[1] + 0.5 * pairs[1],
    ]
}

/// Distance of nearest neighbours and energy of an atom in the crystal of lowest energy; nothing for
/// a potential that does not bind.
pub(super) fn crystal(law: &impl Functions, species: u8) -> Option<[f64; 2]> {
    let cutoff = law.cutoff_sq().sqrt();
    let width = (RANGE[1] - RANGE[0]) / TRIED as f64;
    let at = |number: usize| cutoff * (RANGE[0] + width * number as f64);
    let depth = |number: &usize| energy(law, species, at(*number))[0];
    let deepest = (0..=TRIED).min_by(|a, b| depth(a).total_cmp(&depth(b)))?;
    let is_bound = depth(&deepest) < 0.0;
    if deepest == 0 || deepest == TRIED || !is_bound {
        return None;
    }
    // The energy falls before its least value and rises behind it.
    let rises = |distance: f64| energy(law, species, distance)[1] >= 0.0;
    let around = Bracket::new(at(deepest - 1), at(deepest + 1));
    let spacing = around.halved(HALVINGS, rises).middle();
    Some([spacing, energy(law, species, spacing)[0]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::md::eam::{SUTTON_CHEN, SuttonChen};

    #[test]
    fn shells_of_the_lattice_are_the_known_ones() {
        let expected = [
            (1.0, 12.0),
            (2.0, 6.0),
            (3.0, 24.0),
            (4.0, 12.0),
            (5.0, 24.0),
            (6.0, 8.0),
        ];
        assert_eq!(shells(6.2), expected);
    }

    /// Σ (a/r)ᵏ over the whole lattice: shells up to 60 spacings, and an integral beyond.
    fn lattice_sum(k: i32) -> f64 {
        let reach = 60.0_f64;
        let near: f64 = shells(reach * reach)
            .iter()
            .filter(|(square, _)| *square <= reach * reach)
            .map(|(square, count)| count * libm::pow(2.0 / square, 0.5 * f64::from(k)))
            .sum();
        // √2 sites a volume of a spacing cubed.
        let beyond = 2.0_f64.sqrt()
            * 4.0
            * std::f64::consts::PI
            * libm::pow(2.0, 0.5 * f64::from(k))
            * libm::pow(reach, f64::from(3 - k))
            / f64::from(k - 3);
        near + beyond
    }

    /// Sutton & Chen chose c so that the crystal has no pressure at a, and ε for the energy.
    #[test]
    fn the_parameters_of_the_metals_agree_with_each_other() {
        for metal in SUTTON_CHEN {
            let [n, m] = [metal.n, metal.m].map(|k| lattice_sum(k as i32));
            let c = f64::from(metal.n) * n / (f64::from(metal.m) * m.sqrt());
            assert!((metal.c / c - 1.0).abs() < 2e-3, "{}: {c}", metal.name);
        }
    }

    #[test]
    fn the_crystal_is_near_the_published_one_though_the_sums_end_at_the_cut_off() {
        // Cohesive energies in eV: Kittel, Introduction to Solid State Physics, table 3.1.
        for (name, cohesion) in [("Cu", 3.49), ("Ni", 4.44), ("Ag", 2.95), ("Au", 3.81)] {
            let metal = SUTTON_CHEN.iter().find(|metal| metal.name == name).unwrap();
            let law = SuttonChen::new(metal.parameters()).unwrap();
            let [spacing, energy] = crystal(&law, 0).unwrap();
            assert!(
                (spacing * 2.0_f64.sqrt() / metal.a - 1.0).abs() < 0.01,
                "{name}: {spacing}"
            );
            assert!((energy / -cohesion - 1.0).abs() < 0.05, "{name}: {energy}");
        }
    }
}
