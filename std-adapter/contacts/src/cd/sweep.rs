//! Sweeps over the pairs of spheres: one after the other, or four at a time.

use super::aligned::Aligned;
use super::four_contacts::{self, Records};
use super::groups::{Groups, LANES};
use super::identical_spheres::AlikePair;
use super::image::{Image, ImageVelocity};
use super::mixture::PairFriction;
use super::operator::Monitor;
use super::pairs::View;
use tribos_core::contact::{Contact, ContactBody, ContactFriction, ContactModes, ContactVector};
use tribos_core::internals::PreparedContact;
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

/// Pairs that are swept together.
pub(super) struct Stretch<'a, M: ContactModes<f64>> {
    /// They themselves, and those that come after them, whose bodies are fetched.
    pub pairs: View<'a>,
    pub impulses: &'a mut [ContactVector<f64, M>],
    /// Their impulses after the sweep before, if a monitor follows the steps; empty else.
    pub swept: &'a [ContactVector<f64, M>],
    /// Which of them are solved four at a time.
    pub groups: Option<Groups<'a>>,
}

/// Solves pairs one after the other, or four at a time where they are grouped; the first element of `spheres`
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
        impulses,
        swept,
        groups,
    } = stretch;
    let count = impulses.len();
    let mut records = [Records::default(); RUN];
    let mut done = 0;
    while done < count {
        let at = way.place(done, count);
        if let View::Alike(_, pairs) = pairs
            && let Some(groups) = groups.filter(|groups| groups.begins(way.start(at)))
        {
            let solved = solve_run(Run {
                pairs,
                impulses: &mut *impulses,
                swept,
                groups,
                spheres: &mut *spheres,
                first,
                way,
                at,
                records: &mut records,
            });
            for group in records.iter().take(solved) {
                show(group, way, watch);
            }
            done += LANES * solved;
            if solved > 0 {
                continue;
            }
        }
        fetch(pairs.bodies(way.ahead(at)), spheres, first);
        let one = (pairs, at, &mut *impulses, swept.get(at));
        solve_one(one, (first, spheres), friction, watch);
        done += 1;
    }
}

impl SweepDirection {
    /// Position of the pair that comes after so many others.
    #[inline(always)]
    fn place(self, done: usize, count: usize) -> usize {
        match self {
            Self::Forward => done,
            Self::Backward => count - 1 - done,
        }
    }

    /// Position of the first pair of a group, from that of the pair which comes first on this way.
    #[inline(always)]
    fn start(self, at: usize) -> usize {
        match self {
            Self::Forward => at,
            Self::Backward => at.wrapping_sub(LANES - 1),
        }
    }

    /// Position of the pair whose bodies are to be fetched, if there is one.
    #[inline(always)]
    fn ahead(self, at: usize) -> usize {
        match self {
            Self::Forward => at + AHEAD,
            Self::Backward => at.wrapping_sub(AHEAD),
        }
    }
}

/// Lets a monitor see the contacts of a group in the order of the sweep.
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
type Steps<'a, M> = (
    &'a mut ContactVector<f64, M>,
    Option<&'a ContactVector<f64, M>>,
);

/// The place of one pair among others, all impulses, and its own after the sweep before if a monitor follows it.
pub(super) type ScalarPair<'a, M> = (
    View<'a>,
    usize,
    &'a mut [ContactVector<f64, M>],
    Option<&'a ContactVector<f64, M>>,
);

/// Solves one pair; the first element of `spheres` has the number `first`.
#[inline(always)]
pub(super) fn solve_one<F: ContactFriction<f64>, W: Monitor>(
    (pairs, at, impulses, swept): ScalarPair<'_, F::Modes>,
    bodies: (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    watch: &mut W,
) {
    let Some(impulse) = impulses.get_mut(at) else {
        return;
    };
    // Apart: a contact that comes from either kind would go through memory.
    match pairs {
        View::Alike(common, pairs) => {
            if let Some(pair) = pairs.get(at) {
                let contact = (pair.bodies(), &pair.prepared(common));
                solve_contact(contact, (impulse, swept), bodies, friction, watch);
            }
        }
        View::Any(pairs) => {
            if let Some((numbers, prepared)) = pairs.get(at) {
                let contact = (*numbers, prepared);
                solve_contact(contact, (impulse, swept), bodies, friction, watch);
            }
        }
    }
}

#[inline(always)]
fn solve_contact<F: ContactFriction<f64>, W: Monitor>(
    (numbers, prepared): ([u32; 2], &PreparedContact<f64>),
    (impulse, swept): Steps<'_, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    watch: &mut W,
) {
    let bodies = numbers.map(|body| (body - first) as usize);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        let mut contact = Contact::resume(prepared, impulse);
        let friction = friction.of(numbers);
        update(&mut contact, swept, friction, &mut a.0, &mut b.0).tell(watch);
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

/// Solves a contact; the step before led from `swept` to its impulse.
#[inline(always)]
pub(super) fn update<F: ContactFriction<f64>>(
    contact: &mut Contact<f64, F::Modes>,
    swept: Option<&ContactVector<f64, F::Modes>>,
    friction: &F,
    a: &mut impl ContactBody<f64>,
    b: &mut impl ContactBody<f64>,
) -> PairRecord {
    let before = swept.map(|swept| contact.impulse().minus(swept));
    let change = contact.update(friction, a, b);
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

/// Number of groups that are solved before a monitor sees them.
const RUN: usize = 16;

/// Solves groups one after the other, the first of which has the pair at `at`, as far as there is one after
/// another; gives what a monitor records, and returns their number. Apart from monitors and frictions: a copy for each
/// of these would take minutes to compile.
#[inline(never)]
fn solve_run<M: ContactModes<f64>>(run: Run<'_, M>) -> usize {
    tribos_lanes::run(run)
}

/// Groups one after the other.
struct Run<'a, M: ContactModes<f64>> {
    pairs: &'a [AlikePair],
    impulses: &'a mut [ContactVector<f64, M>],
    swept: &'a [ContactVector<f64, M>],
    groups: Groups<'a>,
    spheres: &'a mut [Aligned],
    first: u32,
    way: SweepDirection,
    at: usize,
    records: &'a mut [Records; RUN],
}

impl<M: ContactModes<f64>> Task for Run<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let Self {
            pairs,
            impulses,
            swept,
            groups,
            spheres,
            first,
            way,
            at,
            records,
        } = self;
        let mut start = way.start(at);
        for (solved, record) in records.iter_mut().enumerate() {
            if !groups.begins(start) {
                return solved;
            }
            let four = pairs.get(start..).and_then(<[_]>::first_chunk);
            let now = impulses.get_mut(start..).and_then(<[_]>::first_chunk_mut);
            let (Some(four), Some(now)) = (four, now) else {
                return solved;
            };
            let old = swept.get(start..).and_then(<[_]>::first_chunk);
            let bodies = (first, &mut *spheres);
            let Some(seen) = four_contacts::update::<L, M>(four, now, old, bodies, groups.common)
            else {
                return solved;
            };
            *record = seen;
            for lane in 0..LANES {
                let ahead = pairs.get(way.ahead(start).wrapping_add(lane));
                fetch(ahead.map(AlikePair::bodies), spheres, first);
            }
            start = match way {
                SweepDirection::Forward => start + LANES,
                SweepDirection::Backward => start.wrapping_sub(LANES),
            };
        }
        RUN
    }
}

/// Solves pairs with an image one after the other.
pub(super) fn sweep_images<F: ContactFriction<f64>, W: Monitor>(
    stretch: Stretch<'_, F::Modes>,
    images: &[ImageVelocity],
    spheres: &mut [Aligned],
    friction: &impl PairFriction<F>,
    way: SweepDirection,
    watch: &mut W,
) {
    let Stretch {
        pairs,
        impulses,
        swept,
        ..
    } = stretch;
    let mut solve =
        |(at, (impulse, (_, velocity))): (usize, (&mut ContactVector<_, _>, &ImageVelocity))| {
            let (Some(numbers), Some(mut contact)) = (pairs.bodies(at), pairs.contact(at, impulse))
            else {
                return;
            };
            let bodies = numbers.map(|body| body as usize);
            if let Ok([a, sphere]) = spheres.get_disjoint_mut(bodies) {
                let (velocity, friction) = (*velocity, friction.of(numbers));
                let sphere = &mut sphere.0;
                let mut image = Image { sphere, velocity };
                let seen = update(&mut contact, swept.get(at), friction, &mut a.0, &mut image);
                seen.tell(watch);
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
