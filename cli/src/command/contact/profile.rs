//! Performance profiles (Dolan and Moré, Math. Program. 91 (2002) 201).

use tribos::record::number;
use tribos_report::figure::{Axis, Figure, Series};

/// For each method the ratios of its times to the fastest ones, rising; of the problems that it solves.
pub struct Profile {
    methods: Vec<(String, Vec<f64>)>,
    problems: usize,
}

impl Profile {
    /// Of times, a row a problem and a column a method; `None` is not solved.
    pub fn of(names: &[&str], times: &[Vec<Option<f64>>]) -> Self {
        let ratio = |row: &Vec<Option<f64>>, at: usize| {
            let fastest = row.iter().flatten().copied().reduce(f64::min)?;
            let time = row[at]?;
            // The fastest may take no time that the clock tells.
            Some(if time > fastest { time / fastest } else { 1.0 })
        };
        let methods = names.iter().enumerate().map(|(at, name)| {
            let mut ratios: Vec<f64> = times.iter().filter_map(|row| ratio(row, at)).collect();
            ratios.sort_by(f64::total_cmp);
            ((*name).to_owned(), ratios)
        });
        Self {
            methods: methods.collect(),
            problems: times.len(),
        }
    }

    /// Share of the problems solved within each ratio of the fastest time: a step at each.
    fn steps(&self, ratios: &[f64]) -> Vec<(f64, f64)> {
        let share = |count: usize| count as f64 / self.problems.max(1) as f64;
        let mut steps = vec![(1.0, 0.0)];
        for (at, &ratio) in ratios.iter().enumerate() {
            steps.push((ratio, share(at)));
            steps.push((ratio, share(at + 1)));
        }
        steps.push((self.slowest(), share(ratios.len())));
        steps
    }

    fn slowest(&self) -> f64 {
        let all = self.methods.iter().flat_map(|(_, ratios)| ratios);
        // A little beyond the last, so that it is seen.
        1.2 * all.copied().fold(1.0, f64::max)
    }

    /// For the person at the terminal.
    pub fn told(&self) -> String {
        let mut text = String::new();
        for (name, ratios) in &self.methods {
            let fastest = ratios.iter().filter(|ratio| **ratio == 1.0).count();
            text += &format!(
                "{name:<10} solves {} of {}, {fastest} fastest\n",
                ratios.len(),
                self.problems
            );
        }
        text
    }

    /// The curves as a table.
    pub fn table(&self) -> String {
        let mut text = String::from("method,time_over_fastest,share_solved\n");
        for (name, ratios) in &self.methods {
            for (ratio, share) in self.steps(ratios) {
                text += &format!("{name},{},{}\n", number(ratio), number(share));
            }
        }
        text
    }

    /// The curves as a figure.
    pub fn figure(&self) -> Figure {
        let figure = Figure::new(
            "Performance profile",
            Axis::log10("time over the fastest method's"),
            Axis::linear("share of the problems solved").range(0.0, 1.05),
        );
        self.methods.iter().fold(figure, |figure, (name, ratios)| {
            figure.series(Series::line(name, self.steps(ratios)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_profile_counts_what_is_solved_within_a_ratio() {
        let times = [
            vec![Some(1.0), Some(4.0)],
            vec![Some(6.0), Some(2.0)],
            vec![None, Some(1.0)],
            vec![None, None],
        ];
        let profile = Profile::of(&["one", "other"], &times);
        assert_eq!(profile.methods[0].1, [1.0, 3.0]);
        assert_eq!(profile.methods[1].1, [1.0, 1.0, 4.0]);
        let last = |method: usize| profile.steps(&profile.methods[method].1).last().copied();
        assert_eq!(last(0).map(|step| step.1), Some(0.5));
        assert_eq!(last(1), Some((4.8, 0.75)));
        assert!(
            profile
                .told()
                .contains("other      solves 3 of 4, 2 fastest")
        );
    }
}
