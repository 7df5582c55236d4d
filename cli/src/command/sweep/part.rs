//! A share of the runs, for one of several machines.

use std::str::FromStr;

/// Part `index` of `count`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 0.
    pub index: usize,
    /// At least 1.
    pub count: usize,
}

impl Shard {
    /// Everything.
    pub const WHOLE: Self = Self { index: 0, count: 1 };

    /// Whether a run belongs to this part: runs are dealt out in turn, so that parts are as long
    /// as each other where the effort changes along the keys.
    pub fn has(self, run: usize) -> bool {
        run % self.count == self.index
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(index, count)| {
            let [index, count] = [index, count].map(|n| n.trim().parse::<usize>().ok());
            Some((index?, count?))
        });
        match numbers {
            Some((index, count)) if index < count => Ok(Self { index, count }),
            _ => Err("give I/K, part I of K counted from 0, such as 0/2 and 1/2".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_belongs_to_one_part() {
        let parts: Vec<Shard> = ["0/3", "1/3", " 2 / 3"]
            .iter()
            .filter_map(|text| text.parse().ok())
            .collect();
        assert_eq!(parts.len(), 3);
        for run in 0..10 {
            assert_eq!(parts.iter().filter(|part| part.has(run)).count(), 1);
            assert!(Shard::WHOLE.has(run));
        }
        for bad in ["3/3", "0/0", "1", "-1/2", "a/b", ""] {
            assert!(bad.parse::<Shard>().is_err(), "{bad}");
        }
    }
}
