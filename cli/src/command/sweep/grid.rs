//! Keys with several values, and their combinations.

use super::range::expand;
use crate::failure::Failure;
use tribos::scene::{Key, present_name};

/// A key and the values that it takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Swept {
    /// Name of the key.
    pub key: String,
    /// Values as written.
    pub values: Vec<String>,
}

impl Swept {
    /// The values, if all are numbers and there are two or more.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        let numbers: Option<Vec<f64>> = self.values.iter().map(|v| v.parse().ok()).collect();
        numbers.filter(|numbers| numbers.len() > 1)
    }
}

/// Keys of a sweep in the order given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    /// The keys.
    pub keys: Vec<Swept>,
}

impl Grid {
    /// Reads items of the form key=value,value, where a value may be a [range](super::range), or a text in quotes that has
    /// commas.
    pub fn parse(items: &[String]) -> Result<Self, Failure> {
        let mut keys: Vec<Swept> = Vec::new();
        for item in items {
            let Some((key, values)) = item.split_once('=') else {
                let message = format!("--set: `{item}` is not of the form key=value,value");
                return Err(Failure::input(message));
            };
            let key = key.trim().to_owned();
            let mut is_quoted = false;
            let splits = |c: char| {
                is_quoted ^= c == '"';
                c == ',' && !is_quoted
            };
            let expanded: Result<Vec<_>, _> =
                values.split(splits).map(|v| expand(v.trim())).collect();
            let values = expanded.map_err(|why| Failure::input(format!("--set {key}: {why}")))?;
            let values = values.concat();
            let twice = (1..values.len()).find(|&at| values[..at].contains(&values[at]));
            if let Some(at) = twice {
                let message = format!("--set: `{key}` takes {} twice", values[at]);
                return Err(Failure::input(message));
            }
            if keys.iter().any(|swept| swept.key == key) {
                let message = format!("--set: give all values of `{key}` at once");
                return Err(Failure::input(message));
            }
            keys.push(Swept { key, values });
        }
        Ok(Self { keys })
    }

    /// The grid with the present names of its keys.
    pub fn with_present_names(&self, keys: &[Key]) -> Self {
        let named = |swept: &Swept| Swept {
            key: present_name(keys, &swept.key).to_owned(),
            values: swept.values.clone(),
        };
        Self {
            keys: self.keys.iter().map(named).collect(),
        }
    }

    /// Number of combinations.
    pub fn len(&self) -> usize {
        self.keys.iter().map(|swept| swept.values.len()).product()
    }

    /// Indices of the values in a combination; the last key changes first.
    pub fn indices(&self, mut combination: usize) -> Vec<usize> {
        let mut indices = vec![0; self.keys.len()];
        for (index, swept) in indices.iter_mut().zip(&self.keys).rev() {
            *index = combination % swept.values.len();
            combination /= swept.values.len();
        }
        indices
    }

    /// A combination as overrides of a scene.
    pub fn overrides(&self, combination: usize) -> Vec<String> {
        let indices = self.indices(combination);
        let chosen = self.keys.iter().zip(indices);
        chosen
            .map(|(swept, index)| format!("{}={}", swept.key, swept.values[index]))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_come_in_the_order_of_nested_loops() -> Result<(), Failure> {
        let grid = Grid::parse(&["a=1,2".into(), "b=x".into(), "c = 3, 4:5:1".into()])?;
        assert_eq!(grid.len(), 6);
        let all: Vec<_> = (0..6).map(|n| grid.overrides(n).join(" ")).collect();
        let first = ["a=1 b=x c=3", "a=1 b=x c=4", "a=1 b=x c=5", "a=2 b=x c=3"];
        assert_eq!(all[..4], first);
        assert_eq!(grid.keys[1].numbers(), None);
        assert_eq!(grid.keys[2].numbers(), Some(vec![3.0, 4.0, 5.0]));
        assert_eq!(Grid::parse(&[])?.len(), 1);
        let texts = Grid::parse(&["materials=\"a: mu=1, share=0; b\",\"c: mu=2\"".into()])?;
        assert_eq!(
            texts.keys[0].values,
            ["\"a: mu=1, share=0; b\"", "\"c: mu=2\""]
        );
        for bad in [vec!["a"], vec!["a=1", "a=2"], vec!["a=1,2,1"]] {
            let items: Vec<String> = bad.iter().map(|item| (*item).into()).collect();
            assert!(Grid::parse(&items).is_err(), "{items:?}");
        }
        Ok(())
    }
}
