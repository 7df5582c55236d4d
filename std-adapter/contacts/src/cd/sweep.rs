//! Sweeps over the pairs of spheres: one after the other, or four at a time.

use super::aligned::Aligned;
use super::cell::CellBody;
use super::four_contacts::{self, Records};
use super::image::{Image, ImageVelocity};
use super::mixture::PairFriction;
use super::operator::Monitor;
use super::pairs::View;
use super::quads::{LANES, Quad};
use super::vectors::Constants;
use std::ops::Range;
use tribos_core::contact::{Contact, ContactFriction, ContactModes, ContactVector};
use tribos_lanes::{Four, Task};
use tribos_prefetch::prefetch;

/// Direction of a sweep.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum SweepDirection {
    Forward,
    Backward,
}

/// Number of contacts below which threads cost more than they gain.
pub(super) const WORTHWHILE: usize = 10_000;

/// How many pairs ahead bodies are fetched: the work of that many takes longer than the memory.
pub(super) const AHEAD: usize = 24;

/// How many records ahead that is.
pub(super) const RECORDS_AHEAD: usize = AHEAD / LANES;

/// Pairs that are swept together.
pub(super) struct Stretch<'a, M: ContactModes<f64>> {
    /// All pairs of the problem.
    pub pairs: View<'a>,
    /// Which of them these are.
    pub part: Range<usize>,
    /// Their own impulses.
    pub impulses: &'a mut [ContactVector<f64, M>],
    /// Their impulses after the sweep before, if a monitor follows the steps; empty else.
    pub swept: &'a [ContactVector<f64, M>],
    /// What four at a time need; without it each is solved by itself.
    pub lanes: Option<&'a Constants>,
}

/// Solves pairs one after the other, or four at a time where these are together; the first element of `spheres`
/// has the number `first`. Both give the same bits.
pub(super) fn sweep_pairs<F: ContactFriction<f64>, W: Monitor>(
    stretch: Stretch<'_, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    way: SweepDirection,
    watch: &mut W,
) {
    let Stretch {
        pairs,
        part,
        impulses,
        swept,
        lanes,
    } = stretch;
    let all = pairs.records(&part);
    let mut records = [Records::default(); RUN];
    let mut done = 0;
    while done < all.len() {
        let record = all.start + way.place(done, all.len());
        if let Some(constants) = lanes {
            let solved = solve_run(Run {
                pairs,
                start: part.start,
                impulses: &mut *impulses,
                swept,
                watched: W::WATCHES,
                spheres: &mut *spheres,
                first,
                way,
                record,
                most: all.len() - done,
                records: &mut records,
                constants,
            });
            if W::WATCHES {
                let seen = records.iter().take(solved);
                seen.for_each(|four| show(four, way, watch));
            }
            done += solved;
            if solved > 0 {
                continue;
            }
        }
        let contacts = pairs.group(record).unwrap_or_default().contacts();
        for turn in 0..contacts.len() {
            let at = contacts.start + way.place(turn, contacts.len());
            fetch(pairs.bodies(way.ahead(at, AHEAD)), spheres, first);
            let own = at - part.start;
            if let Some(impulse) = impulses.get_mut(own) {
                let steps = (impulse, swept.get(own));
                solve_one((pairs, at), steps, (first, &mut *spheres), friction, watch);
            }
        }
        done += 1;
    }
}

impl SweepDirection {
    /// Position of what comes after so many others.
    #[inline(always)]
    fn place(self, done: usize, count: usize) -> usize {
        match self {
            Self::Forward => done,
            Self::Backward => count - 1 - done,
        }
    }

    /// Position of what comes so much later, if there is such.
    #[inline(always)]
    fn ahead(self, at: usize, later: usize) -> usize {
        match self {
            Self::Forward => at + later,
            Self::Backward => at.wrapping_sub(later),
        }
    }
}

/// Lets a monitor see four contacts in the order of the sweep.
#[inline(always)]
fn show<W: Monitor>(
    [change_sq, bound, speed, along]: &Records,
    way: SweepDirection,
    watch: &mut W,
) {
    for turn in 0..LANES {
        let lane = way.place(turn, LANES);
        watch.record(change_sq[lane], bound[lane], speed[lane]);
        watch.follow(along[lane]);
    }
}

/// Asks for the bodies of a pair, which lie anywhere in memory, before they are needed: those of the next block, too.
#[inline(always)]
pub(super) fn fetch(soon: Option<[u32; 2]>, spheres: &[Aligned], first: u32) {
    if let Some(bodies) = soon {
        for body in bodies {
            let place = body as isize - first as isize;
            prefetch(spheres.as_ptr().wrapping_offset(place));
        }
    }
}

/// A pair's impulse, and the one after the sweep before if a monitor follows it.
pub(super) type Steps<'a, M> = (
    &'a mut ContactVector<f64, M>,
    Option<&'a ContactVector<f64, M>>,
);

/// Solves one pair of all; the first element of `spheres` has the number `first`.
#[inline(always)]
pub(super) fn solve_one<F: ContactFriction<f64>, W: Monitor>(
    (pairs, at): (View<'_>, usize),
    (impulse, swept): Steps<'_, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    watch: &mut W,
) {
    let (Some(numbers), Some(mut contact)) = (pairs.bodies(at), pairs.contact(at, impulse)) else {
        return;
    };
    let bodies = numbers.map(|body| (body - first) as usize);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        let friction = friction.of(numbers);
        let turn = |contact: &mut Contact<_, _>| contact.take_turn(friction, &mut a.0, &mut b.0);
        visit(&mut contact, swept, turn).tell(watch);
        *impulse = *contact.impulse();
    }
}

/// What a monitor records of a contact.
pub(super) struct PairRecord {
    /// change², P, speed
    change: [f64; 3],
    /// Product of the change with the step before, if that is followed.
    along: Option<f64>,
}

impl PairRecord {
    #[inline(always)]
    pub fn tell<W: Monitor>(&self, watch: &mut W) {
        let [change_sq, bound, speed] = self.change;
        watch.record(change_sq, bound, speed);
        if let Some(along) = self.along {
            watch.follow(along);
        }
    }
}

/// Lets a contact take a change, and records it; the step before led from `swept` to the contact's impulse.
#[inline(always)]
pub(super) fn visit<M: ContactModes<f64>>(
    contact: &mut Contact<f64, M>,
    swept: Option<&ContactVector<f64, M>>,
    take: impl FnOnce(&mut Contact<f64, M>) -> ContactVector<f64, M>,
) -> PairRecord {
    let before = swept.map(|swept| contact.impulse().minus(swept));
    let change = take(contact);
    let lever = contact.effective_radius();
    let speed = change.normal.abs() / contact.block().mass_normal;
    PairRecord {
        change: [
            change.dot_with_lever(&change, lever),
            contact.bound(),
            speed,
        ],
        along: before.map(|before| change.dot_with_lever(&before, lever)),
    }
}

/// Number of records that are solved before a monitor sees them.
const RUN: usize = 16;

/// Solves records four contacts at a time, from one on, as far as there is one after another; gives what a monitor
/// records, and returns their number. Apart from monitors and frictions: a copy for each of these would take minutes
/// to compile.
#[inline(never)]
fn solve_run<M: ContactModes<f64>>(run: Run<'_, M>) -> usize {
    tribos_lanes::run(run)
}

/// Records one after the other.
struct Run<'a, M: ContactModes<f64>> {
    pairs: View<'a>,
    /// Number of the pair with the first of the impulses.
    start: usize,
    impulses: &'a mut [ContactVector<f64, M>],
    swept: &'a [ContactVector<f64, M>],
    /// Whether a monitor records.
    watched: bool,
    spheres: &'a mut [Aligned],
    first: u32,
    way: SweepDirection,
    record: usize,
    /// Number of records that are left.
    most: usize,
    records: &'a mut [Records; RUN],
    constants: &'a Constants,
}

impl<M: ContactModes<f64>> Task for Run<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let Self {
            pairs,
            start,
            impulses,
            swept,
            watched,
            spheres,
            first,
            way,
            record,
            most,
            records,
            constants,
        } = self;
        let most = most.min(RUN);
        for (solved, seen) in records.iter_mut().enumerate().take(most) {
            let record = way.ahead(record, solved);
            let (Some(at), Some(quad)) = (pairs.four(record), pairs.quad(record)) else {
                return solved;
            };
            let own = at - start;
            let Some(now) = impulses.get_mut(own..).and_then(<[_]>::first_chunk_mut) else {
                return solved;
            };
            let old = watched.then(|| swept.get(own..).and_then(<[_]>::first_chunk));
            let bodies = (first, &mut *spheres);
            let Some(four) = four_contacts::update::<L, M>(quad, now, old, bodies, constants)
            else {
                return solved;
            };
            *seen = four;
            fetch_four(pairs.quad(way.ahead(record, RECORDS_AHEAD)), spheres, first);
        }
        most
    }
}

/// Asks for the bodies of four pairs before they are needed.
#[inline(always)]
pub(super) fn fetch_four(soon: Option<&Quad>, spheres: &[Aligned], first: u32) {
    for lane in 0..LANES {
        fetch(soon.map(|quad| quad.bodies(lane)), spheres, first);
    }
}

/// Images that pairs are solved with, and the cell that they move with if it deforms.
pub(super) struct Border<'a> {
    pub images: &'a [ImageVelocity],
    pub cell: Option<&'a mut CellBody>,
    /// Number of the first of the images among all.
    pub first: usize,
}

/// Solves pairs with an image one after the other.
pub(super) fn sweep_images<F: ContactFriction<f64>, W: Monitor>(
    stretch: Stretch<'_, F::Modes>,
    Border {
        images,
        mut cell,
        first,
    }: Border<'_>,
    spheres: &mut [Aligned],
    friction: &impl PairFriction<F>,
    way: SweepDirection,
    watch: &mut W,
) {
    let Stretch {
        pairs,
        part,
        impulses,
        swept,
        ..
    } = stretch;
    let mut solve =
        |(own, (impulse, (_, velocity))): (usize, (&mut ContactVector<_, _>, &ImageVelocity))| {
            let at = part.start + own;
            let (Some(numbers), Some(mut contact)) = (pairs.bodies(at), pairs.contact(at, impulse))
            else {
                return;
            };
            let bodies = numbers.map(|body| body as usize);
            if let Ok([a, sphere]) = spheres.get_disjoint_mut(bodies) {
                let friction = friction.of(numbers);
                let mut moves = cell.as_deref_mut().and_then(|cell| {
                    let periods = *cell.periods.get(first + own)?;
                    Some((cell, periods))
                });
                let velocity = match &moves {
                    None => *velocity,
                    Some((cell, periods)) => cell.image(periods),
                };
                let sphere = &mut sphere.0;
                let mut image = Image { sphere, velocity };
                let turn =
                    |contact: &mut Contact<_, _>| contact.take_turn(friction, &mut a.0, &mut image);
                visit(&mut contact, swept.get(own), turn).tell(watch);
                if let Some((cell, periods)) = &mut moves {
                    let change = contact.impulse().minus(impulse);
                    cell.push(periods, &change.linear(contact.normal()));
                }
                *impulse = *contact.impulse();
            }
        };
    let all = impulses.iter_mut().zip(images).enumerate();
    if way == SweepDirection::Forward {
        all.for_each(solve);
    } else {
        all.rev().for_each(&mut solve);
    }
}
