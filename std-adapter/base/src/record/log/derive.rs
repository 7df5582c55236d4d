//! Velocities from positions, accelerations from velocities.

use super::assign::{Assigned, assign};
use super::{Log, LogOptions, LogRole};
use crate::record::heading::Heading;

/// Columns that are read, and those that are made of them.
#[derive(Debug)]
pub(super) struct Plan {
    pub assigned: Vec<Assigned>,
    pub remarks: Vec<String>,
    /// Roles, each with that whose derivative it is, and the heading of its column.
    pub derived: Vec<(LogRole, &'static str, String)>,
}

impl Plan {
    /// Whether there is a column of this role, read or made.
    pub fn has(&self, name: &str) -> bool {
        let is_read = self.assigned.iter().any(|one| one.role.name == name);
        is_read || self.derived.iter().any(|(role, ..)| role.name == name)
    }

    /// Leaves out a position that nobody named or needs where there is a velocity: its gaps would cost rows.
    pub fn without_idle_position(&mut self, roles: &[LogRole], options: &LogOptions) {
        let position = LogRole::POSITION.name;
        let is_asked_for = |role: &LogRole| role.name == position && role.is_needed;
        let is_named = options
            .columns
            .0
            .iter()
            .any(|choice| choice.role == position);
        let has_velocity = self
            .assigned
            .iter()
            .any(|one| one.role.name == LogRole::VELOCITY.name);
        if has_velocity && !is_named && !roles.iter().any(is_asked_for) {
            self.assigned.retain(|one| one.role.name != position);
        }
    }

    /// Derives a role from another one over time, if both are there; false if not.
    pub fn derives(
        &mut self,
        role: &LogRole,
        headings: &[Heading],
        width: usize,
        options: &LogOptions,
    ) -> Result<bool, String> {
        let source = match role.name {
            "v" => LogRole::POSITION,
            "a" => LogRole::VELOCITY,
            _ => return Ok(false),
        };
        if !self.has("t") || headings.is_empty() && !self.has(source.name) {
            return Ok(false);
        }
        if !self.has(source.name) {
            // Options speak of the roles that were asked for, of which it is none.
            let skip = options.skip;
            let bare = LogOptions {
                skip,
                ..LogOptions::default()
            };
            let (found, remarks) = assign(headings, width, &[source.needed()], &bare)?;
            self.assigned.extend(found);
            self.remarks.extend(remarks);
        }
        if !self.has(source.name) {
            return Ok(false);
        }
        let read = self
            .assigned
            .iter()
            .find(|one| one.role.name == source.name);
        let name = read.map_or(source.name.into(), |one| one.name.clone());
        self.derived.push((*role, source.name, name));
        Ok(true)
    }
}

/// Adds the derivatives to a log.
pub(super) fn derivatives(
    log: &mut Log,
    derived: &[(LogRole, &'static str, String)],
) -> Result<(), String> {
    for (role, source, _) in derived {
        let (Some(times), Some(values)) = (log.column("t"), log.column(source)) else {
            continue;
        };
        if times.len() < 2 {
            return Err(format!(
                "one row has no {}; give at least two",
                role.meaning
            ));
        }
        let rates = rates(times, values);
        log.columns.push((role.name, rates));
    }
    Ok(())
}

/// Derivative by differences to both neighbours, exact for parabolas; at the ends by those to one.
fn rates(times: &[f64], values: &[f64]) -> Vec<f64> {
    let steps = times.windows(2).zip(values.windows(2));
    let slopes: Vec<(f64, f64)> = steps
        .filter_map(|(t, x)| match (t, x) {
            ([t0, t1], [x0, x1]) => Some((t1 - t0, (x1 - x0) / (t1 - t0))),
            _ => None,
        })
        .collect();
    let ends = [slopes.first(), slopes.last()].map(|end| end.map(|(_, slope)| *slope));
    let inner = slopes.windows(2).filter_map(|pair| match pair {
        // The slope on the left counts with the step on the right, and the other way round.
        [(before, left), (after, right)] => {
            Some((after * left + before * right) / (before + after))
        }
        _ => None,
    });
    let [first, last] = ends.map(Option::into_iter);
    first.chain(inner).chain(last).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_have_their_slopes_at_uneven_times() {
        let times = [0.0, 0.5, 0.75, 2.0, 2.25];
        let values = times.map(|t| 3.0 * t * t - t);
        let made = rates(&times, &values);
        assert_eq!(made.len(), 5);
        for (made, t) in made.iter().zip(times).skip(1).take(3) {
            assert!((made - (6.0 * t - 1.0)).abs() < 1e-12, "{made} at {t}");
        }
        assert_eq!(made.first(), Some(&0.5));
        assert_eq!(rates(&[0.0, 2.0], &[1.0, 2.0]), [0.5, 0.5]);
    }
}
