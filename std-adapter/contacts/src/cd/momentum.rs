//! Extrapolation of the impulses of pairs, with the velocities that follow: four at a time where these are together,
//! with the same bits as one after the other.

use super::aligned::Aligned;
use super::four_contacts;
use super::mixture::PairFriction;
use super::pairs::View;
use super::sweep::{AHEAD, RECORDS_AHEAD, fetch, fetch_four};
use super::vectors::Constants;
use std::ops::Range;
use tribos_core::contact::{ContactFriction, ContactModes, ContactVector};
use tribos_lanes::{Four, Task};

/// Pairs, their impulses, and those after the sweep before, which become the impulses further on.
pub(super) struct Moving<'a, M: ContactModes<f64>> {
    /// All pairs of the problem.
    pub pairs: View<'a>,
    /// Which of them these are.
    pub part: Range<usize>,
    pub now: &'a [ContactVector<f64, M>],
    pub swept: &'a mut [ContactVector<f64, M>],
    /// What four at a time need; without it each is moved by itself.
    pub lanes: Option<&'a Constants>,
}

/// Moves impulses on by `beta` times their last step, as far as friction admits, and applies them to the spheres, the
/// first of which has the number `first`.
pub(super) fn extrapolate<F: ContactFriction<f64>>(
    moving: Moving<'_, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    beta: f64,
) {
    let Moving {
        pairs,
        part,
        now,
        swept,
        lanes,
    } = moving;
    let mut records = pairs.records(&part);
    while !records.is_empty() {
        if let Some(constants) = lanes {
            let done = all_fours(Run {
                pairs,
                start: part.start,
                now,
                swept: &mut *swept,
                records: records.clone(),
                first,
                spheres: &mut *spheres,
                beta,
                constants,
            });
            records.start += done;
            if done > 0 {
                continue;
            }
        }
        let group = pairs.group(records.start).unwrap_or_default();
        for at in group.contacts() {
            fetch(pairs.bodies(at + AHEAD), spheres, first);
            let own = at - part.start;
            let (now, swept) = (&now[own], &mut swept[own]);
            let further = now.plus_scaled(beta, &now.minus(swept));
            if let (Some(numbers), Some(mut contact)) =
                (pairs.bodies(at), pairs.contact(at, &further))
            {
                contact.project_impulse(friction.of(numbers));
                *swept = *contact.impulse();
                let bodies = numbers.map(|body| (body - first) as usize);
                if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
                    contact.apply(swept, &mut a.0, &mut b.0);
                }
            }
        }
        records.start += 1;
    }
}

/// Extrapolates four contacts at a time from the first of some records on, as far as there is one after another, and
/// returns the number of these records. Apart from frictions: a copy for each would take minutes to compile.
#[inline(never)]
fn all_fours<M: ContactModes<f64>>(run: Run<'_, M>) -> usize {
    tribos_lanes::run(run)
}

/// Records one after the other.
struct Run<'a, M: ContactModes<f64>> {
    pairs: View<'a>,
    /// Number of the pair with the first of the impulses.
    start: usize,
    now: &'a [ContactVector<f64, M>],
    swept: &'a mut [ContactVector<f64, M>],
    records: Range<usize>,
    first: u32,
    spheres: &'a mut [Aligned],
    beta: f64,
    constants: &'a Constants,
}

impl<M: ContactModes<f64>> Task for Run<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let Self {
            pairs,
            start,
            now,
            swept,
            records,
            first,
            spheres,
            beta,
            constants,
        } = self;
        let count = records.len();
        for (done, record) in records.enumerate() {
            let (Some(at), Some(quad)) = (pairs.four(record), pairs.quad(record)) else {
                return done;
            };
            fetch_four(pairs.quad(record + RECORDS_AHEAD), spheres, first);
            let own = at - start;
            let new = now.get(own..).and_then(<[_]>::first_chunk);
            let old = swept.get_mut(own..).and_then(<[_]>::first_chunk_mut);
            let (Some(new), Some(old)) = (new, old) else {
                return done;
            };
            let bodies = (first, &mut *spheres);
            if four_contacts::extrapolate::<L, M>(quad, new, old, bodies, beta, constants).is_none()
            {
                return done;
            }
        }
        count
    }
}
