//! Contacts of the spheres, and spheres that bear nothing.

use super::{Assembly, KnownForces, Table};
use tribos_base::record::ContactRow;

/// Contacts of the spheres, walls included; contacts with known forces count only if they carry one.
///
/// *Rattlers* have fewer contacts than the least number, counting only those with spheres that are none
/// themselves. By default the least number is 2: with friction or cohesion two contacts can hold a sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordination {
    /// Mean number of contacts of a sphere.
    pub mean: f64,
    /// Number of spheres with 0, 1, 2, … contacts.
    pub histogram: Vec<usize>,
    /// Number of rattlers.
    pub rattlers: usize,
    /// Mean number of contacts of the other spheres with each other and with walls; NaN if all are rattlers.
    pub mean_without: f64,
}

impl Coordination {
    pub(super) fn of(assembly: &Assembly, least: usize) -> Self {
        let count = assembly.radii.len();
        let is_carrying = |row: &&ContactRow| {
            assembly.forces == KnownForces::Unknown || row.force.iter().any(|x| *x != 0.0)
        };
        let contacts: Vec<[Option<usize>; 2]> = assembly
            .contacts
            .iter()
            .filter(is_carrying)
            .map(|row| [Some(row.a as usize), row.b.particle().map(|b| b as usize)])
            .collect();
        let all = vec![true; count];
        let numbers = numbers(&contacts, &all);
        let most = numbers.iter().copied().max().unwrap_or(0);
        let mut histogram = vec![0; most + 1];
        for number in &numbers {
            histogram[*number] += 1;
        }
        let (bears, without) = bearing(&contacts, all, least);
        let kept = bears.iter().filter(|bears| **bears).count();
        Self {
            mean: numbers.iter().sum::<usize>() as f64 / count as f64,
            histogram,
            rattlers: count - kept,
            mean_without: without.iter().sum::<usize>() as f64 / kept as f64,
        }
    }

    /// Columns: number of contacts, number of spheres.
    pub fn table(&self) -> Table {
        let rows = self.histogram.iter().enumerate();
        Table {
            name: "coordination",
            columns: &["contacts", "spheres"],
            rows: rows.map(|(n, k)| vec![n as f64, *k as f64]).collect(),
        }
    }
}

/// Removes spheres with fewer contacts than the least number until none is left; returns which bear, and
/// their numbers of contacts.
fn bearing(
    contacts: &[[Option<usize>; 2]],
    mut bears: Vec<bool>,
    least: usize,
) -> (Vec<bool>, Vec<usize>) {
    loop {
        let numbers = numbers(contacts, &bears);
        let mut is_done = true;
        for (bears, number) in bears.iter_mut().zip(&numbers) {
            if *bears && *number < least {
                *bears = false;
                is_done = false;
            }
        }
        if is_done {
            return (bears, numbers);
        }
    }
}

/// Contacts of each sphere whose partners bear too; 0 for those that do not.
fn numbers(contacts: &[[Option<usize>; 2]], bears: &[bool]) -> Vec<usize> {
    let mut numbers = vec![0; bears.len()];
    for pair in contacts {
        if pair.iter().flatten().all(|&index| bears[index]) {
            for &index in pair.iter().flatten() {
                numbers[index] += 1;
            }
        }
    }
    numbers
}
