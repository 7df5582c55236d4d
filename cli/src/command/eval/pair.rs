//! Lennard-Jones on the command line, `lj:cutoff=2.5,epsilon12=1.5,…`.

use crate::command::number;
use std::str::FromStr;
use tribos::md::atoms::MOST_SPECIES;
use tribos::md::pair::{LennardJones, LennardJonesError, Mixing, Pairing, Shift};

/// What a user may give for one pair of species.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    Epsilon,
    Sigma,
    Cutoff,
}

const QUANTITIES: [(&str, Quantity); 3] = [
    ("epsilon", Quantity::Epsilon),
    ("sigma", Quantity::Sigma),
    ("cutoff", Quantity::Cutoff),
];

const NEEDS: &str = "known are cutoff, shift, mixing and, with two species behind, epsilon, sigma and \
                     cutoff, as in lj:cutoff=2.5,shift=energy,epsilon12=1.5,cutoff12=2";

/// A Lennard-Jones law for species yet to be counted.
#[derive(Clone, Debug)]
pub struct PairSpec {
    text: String,
    cutoff: f64,
    shift: Option<Shift>,
    mixing: Option<Mixing>,
    /// Pairs of species from 0, the smaller first.
    own: Vec<(Quantity, [usize; 2], f64)>,
}

impl FromStr for PairSpec {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, list) = text.split_once(':').unwrap_or((text, ""));
        if name.trim() != "lj" {
            return Err(format!("unknown pair law `{name}`; give lj:cutoff=2.5,…"));
        }
        let mut spec = Self {
            text: text.into(),
            cutoff: f64::NAN,
            shift: None,
            mixing: None,
            own: Vec::new(),
        };
        for item in list.split(',').filter(|item| !item.trim().is_empty()) {
            let (key, value) = item
                .split_once('=')
                .ok_or_else(|| format!("`{item}` is not of the form key=value"))?;
            let (key, value) = (key.trim(), value.trim());
            if spec.put(key, value)? {
                return Err(format!("`{key}` is given twice"));
            }
        }
        if spec.cutoff.is_nan() {
            return Err(format!("`cutoff` is missing; {NEEDS}"));
        }
        Ok(spec)
    }
}

impl PairSpec {
    /// Takes an entry; true if it was there before.
    fn put(&mut self, key: &str, value: &str) -> Result<bool, String> {
        let positive = || number::positive(value).map_err(|cure| format!("{key}: {cure}"));
        match key {
            "cutoff" => {
                let before = std::mem::replace(&mut self.cutoff, positive()?);
                Ok(!before.is_nan())
            }
            "shift" => Ok(self
                .shift
                .replace(word(key, value, &Shift::WORDS)?)
                .is_some()),
            "mixing" => Ok(self
                .mixing
                .replace(word(key, value, &Mixing::WORDS)?)
                .is_some()),
            _ => {
                let (quantity, pair) = quantity_and_pair(key)?;
                let is_known = self.own.iter().any(|&(q, p, _)| (q, p) == (quantity, pair));
                self.own.push((quantity, pair, positive()?));
                Ok(is_known)
            }
        }
    }

    /// As given.
    pub fn text(&self) -> &str {
        &self.text
    }

    fn own(&self, quantity: Quantity, pair: [usize; 2]) -> Option<f64> {
        let mut own = self.own.iter();
        let found = own.find(|(q, p, _)| *q == quantity && *p == pair);
        found.map(|&(_, _, value)| value)
    }

    /// The law for so many species.
    pub fn law(&self, species: usize) -> Result<LennardJones, LennardJonesError> {
        if let Some(&(_, [first, second], _)) = self.own.iter().find(|(_, [_, b], _)| *b >= species)
        {
            let (first, second, known) = (first + 1, second + 1, species);
            return Err(LennardJonesError::Pair {
                first,
                second,
                known,
            });
        }
        let filled = |pair: [usize; 2], [epsilon, sigma]: [f64; 2]| Pairing {
            epsilon: self.own(Quantity::Epsilon, pair).unwrap_or(epsilon),
            sigma: self.own(Quantity::Sigma, pair).unwrap_or(sigma),
            cutoff: self.own(Quantity::Cutoff, pair).unwrap_or(self.cutoff),
        };
        let like: Vec<Pairing> = (0..species).map(|k| filled([k, k], [1.0; 2])).collect();
        let (mixing, shift) = (
            self.mixing.unwrap_or_default(),
            self.shift.unwrap_or_default(),
        );
        let mut law = LennardJones::mixed(&like, mixing, shift)?;
        for (first, a) in like.iter().enumerate() {
            for (second, b) in like.iter().enumerate().skip(first + 1) {
                let mixed = mixing.mix([a.epsilon, a.sigma], [b.epsilon, b.sigma]);
                law.set(first, second, filled([first, second], mixed))?;
            }
        }
        Ok(law)
    }
}

fn word<T: Copy>(key: &str, value: &str, words: &[(&str, T)]) -> Result<T, String> {
    let found = words.iter().find(|(word, _)| *word == value);
    found.map(|&(_, meaning)| meaning).ok_or_else(|| {
        let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        format!("{key} is one of {}, not `{value}`", words.join(", "))
    })
}

/// `sigma12` or `sigma1-12`.
fn quantity_and_pair(key: &str) -> Result<(Quantity, [usize; 2]), String> {
    let unknown = || format!("there is no `{key}`; {NEEDS}");
    let known = QUANTITIES.iter();
    let (quantity, numbers) = known
        .filter_map(|(name, quantity)| Some((*quantity, key.strip_prefix(name)?)))
        .next()
        .ok_or_else(unknown)?;
    let words = match numbers.split_once('-') {
        Some(words) => words,
        None if numbers.len() == 2 && numbers.is_ascii() => numbers.split_at(1),
        None => return Err(unknown()),
    };
    let species = |word: &str| {
        let is_whole = word.bytes().all(|byte| byte.is_ascii_digit());
        let number = word.parse::<usize>().ok().filter(|_| is_whole);
        let number = number.filter(|number| (1..=MOST_SPECIES).contains(number));
        number.map(|number| number - 1).ok_or_else(unknown)
    };
    let mut pair = [species(words.0)?, species(words.1)?];
    pair.sort_unstable();
    Ok((quantity, pair))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(text: &str, species: usize) -> LennardJones {
        text.parse::<PairSpec>().unwrap().law(species).unwrap()
    }

    #[test]
    fn what_is_not_given_is_mixed_or_one() {
        let law = law(
            "lj:cutoff=3,mixing=arithmetic,epsilon22=4,sigma22=2,cutoff22=2.2,sigma31=1.5",
            3,
        );
        let pairing = |a, b| *law.pairing(a, b).unwrap();
        let expected = |epsilon, sigma, cutoff| Pairing {
            epsilon,
            sigma,
            cutoff,
        };
        assert_eq!(pairing(0, 0), expected(1.0, 1.0, 3.0));
        assert_eq!(pairing(1, 1), expected(4.0, 2.0, 2.2));
        assert_eq!(pairing(0, 1), expected(2.0, 1.5, 3.0));
        assert_eq!(pairing(2, 0), expected(1.0, 1.5, 3.0));
    }

    #[test]
    fn from_ten_species_on_a_dash_parts_the_numbers() {
        let law = law("lj:cutoff=3,epsilon2-12=7", 12);
        assert_eq!(law.pairing(11, 1).unwrap().epsilon, 7.0);
    }

    #[test]
    fn refusals_name_the_cure() {
        let refused = |text: &str| text.parse::<PairSpec>().unwrap_err();
        assert!(refused("morse:cutoff=2").contains("give lj:"));
        assert!(refused("lj").contains("`cutoff` is missing"));
        assert!(refused("lj:cutoff=2,cut=3").contains("no `cut`"));
        assert!(refused("lj:cutoff=2,epsilon=3").contains("no `epsilon`"));
        assert!(refused("lj:cutoff=2,epsilon01=3").contains("no `epsilon01`"));
        assert!(refused("lj:cutoff=2,epsilon+1+2=3").contains("no `epsilon"));
        assert!(refused("lj:cutoff=2,epsilon12=3,epsilon21=3").contains("twice"));
        assert!(refused("lj:cutoff=2,cutoff=2").contains("twice"));
        assert!(refused("lj:cutoff=-2").contains("> 0"));
        assert!(refused("lj:cutoff=2,shift=both").contains("none, energy, force"));
        assert!(refused("lj:cutoff=2,mixing").contains("key=value"));
        let beyond = "lj:cutoff=2,sigma13=1".parse::<PairSpec>().unwrap();
        assert!(
            beyond
                .law(2)
                .unwrap_err()
                .to_string()
                .contains("no pair 13 among 2 species")
        );
    }
}
