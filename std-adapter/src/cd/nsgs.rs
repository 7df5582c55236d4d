//! Non-linear Gauss–Seidel: every contact in turn, until a rule says stop.

use super::operator::{Blind, Change, Operator, Restless, Visit};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// In which order a sweep goes over the contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Always as they are numbered.
    Fixed,
    /// Forwards and backwards in turn: a symmetric iteration.
    Alternating,
    /// A new random permutation for each sweep (Unger and Kertész 2003), from a seed.
    Random {
        /// Seed of the stream.
        seed: u64,
    },
}

/// When the iteration stops (thesis, section 4.4.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// After a fixed number of sweeps.
    Fixed,
    /// When no contact's impulse changes by more than this fraction of its own P.
    Local(f64),
    /// When the mean change falls below this fraction of the mean P.
    Global(f64),
}

/// Sweeps over permutations or in turn.
#[derive(Clone, Debug)]
pub struct Sweeper {
    order: Order,
    turn: u64,
    stream: Pcg64Mcg,
    permutation: Vec<u32>,
}

impl Sweeper {
    /// Starts at the first sweep of the order.
    pub fn new(order: Order) -> Self {
        let seed = match order {
            Order::Random { seed } => seed,
            _ => 0,
        };
        Self {
            order,
            turn: 0,
            stream: Pcg64Mcg::seed_from_u64(seed),
            permutation: Vec::new(),
        }
    }

    /// One sweep.
    pub fn sweep<O: Operator, W: super::operator::Watch>(&mut self, problem: &mut O, watch: &mut W) {
        self.turn += 1;
        match self.order {
            Order::Fixed => problem.sweep(Visit::Forward, watch),
            Order::Alternating if self.turn % 2 == 1 => problem.sweep(Visit::Forward, watch),
            Order::Alternating => problem.sweep(Visit::Backward, watch),
            Order::Random { .. } => {
                self.shuffle(problem.contacts());
                problem.sweep(Visit::Listed(&self.permutation), watch);
            }
        }
    }

    /// A fresh permutation (Fisher and Yates).
    fn shuffle(&mut self, count: usize) {
        self.permutation.clear();
        self.permutation.extend(0..count as u32);
        for last in (1..count).rev() {
            // The product's upper half: a bias of at most count/2⁶⁴.
            let drawn = (u128::from(self.stream.next_u64()) * (last as u128 + 1)) >> 64;
            self.permutation.swap(last, drawn as usize);
        }
    }
}

/// What an iteration did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Sweeps over all contacts, or work of the same size.
    pub sweeps: usize,
    /// Whether the rule was met; always true after a fixed number.
    pub met: bool,
}

/// Sweeps until `stop` or `most` sweeps.
pub fn solve<O: Operator>(problem: &mut O, sweeper: &mut Sweeper, stop: Stop, most: usize) -> Effort {
    for sweeps in 1..=most {
        let met = match stop {
            Stop::Fixed => {
                sweeper.sweep(problem, &mut Blind);
                false
            }
            Stop::Local(tolerance) => {
                let mut watch = Restless::above(tolerance);
                sweeper.sweep(problem, &mut watch);
                watch.count == 0
            }
            Stop::Global(tolerance) => {
                let mut watch = Change::default();
                sweeper.sweep(problem, &mut watch);
                watch.relative_mean() <= tolerance
            }
        };
        if met {
            return Effort { sweeps, met };
        }
    }
    Effort {
        sweeps: most,
        met: stop == Stop::Fixed,
    }
}
