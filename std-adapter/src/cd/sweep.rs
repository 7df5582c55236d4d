//! Sweeps over the pairs of spheres: one after the other, or four at a time.

use super::aligned::Aligned;
use super::four::{self, Records};
use super::groups::{Groups, LANES};
use super::image::{Image, ImageVelocity};
use super::mixture::PairFriction;
use super::operator::Monitor;
use super::spheres::Link;
use tribos_core::contact::{Body, Contact, ContactFriction, ContactModes, Modal};
use tribos_lanes::{Four, Task};
use tribos_prefetch::prefetch;

/// Direction of a sweep.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Forward,
    Backward,
}

/// Number of contacts below which threads cost more than they gain.
pub(super) const WORTHWHILE: usize = 10_000;

/// How many pairs ahead bodies are fetched: the work of that many takes longer than the memory.
pub(super) const AHEAD: usize = 24;

/// Pairs that are swept together.
pub(super) struct Pairs<'a, M: ContactModes<f64>> {
    pub links: &'a mut [Link<M>],
    /// Their impulses after the sweep before, if a monitor follows the steps; empty else.
    pub swept: &'a [Modal<f64, M>],
    /// Which of them are solved four at a time.
    pub groups: Option<Groups<'a>>,
}

/// Solves pairs one after the other, or four at a time where they are grouped; the first element of `spheres`
/// has the number `first`. Both give the same bits.
pub(super) fn sweep_links<F: ContactFriction<f64>, W: Monitor>(
    pairs: Pairs<'_, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    way: Way,
    watch: &mut W,
) {
    let Pairs {
        links,
        swept,
        groups,
    } = pairs;
    let count = links.len();
    let mut records = [Records::default(); RUN];
    let mut done = 0;
    while done < count {
        let at = way.place(done, count);
        if let Some(groups) = groups.filter(|groups| groups.begins(way.start(at))) {
            let bodies = (first, &mut *spheres);
            let solved = solve_run((links, swept), groups, bodies, (way, at), &mut records);
            for group in records.iter().take(solved) {
                show(group, way, watch);
            }
            done += LANES * solved;
            if solved > 0 {
                continue;
            }
        }
        fetch(links.get(way.ahead(at)), spheres, first);
        let link = links.get_mut(at).map(|link| (link, swept.get(at)));
        solve_one(link, (first, spheres), friction, watch);
        done += 1;
    }
}

impl Way {
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
fn show<W: Monitor>([change_sq, bound, speed, along]: &Records, way: Way, watch: &mut W) {
    for turn in 0..LANES {
        let lane = way.place(turn, LANES);
        watch.see(change_sq[lane], bound[lane], speed[lane]);
        watch.follow(along[lane]);
    }
}

/// Asks for the bodies of a link, which lie anywhere in memory, before they are needed.
#[inline(always)]
pub(super) fn fetch<M: ContactModes<f64>>(soon: Option<&Link<M>>, spheres: &[Aligned], first: u32) {
    if let Some(soon) = soon {
        for body in soon.bodies {
            if let Some(sphere) = spheres.get((body - first) as usize) {
                prefetch(sphere);
            }
        }
    }
}

/// A pair, and its impulse after the sweep before if a monitor follows it.
pub(super) type One<'a, M> = (&'a mut Link<M>, Option<&'a Modal<f64, M>>);

/// Solves one pair; the first element of `spheres` has the number `first`.
#[inline(always)]
pub(super) fn solve_one<F: ContactFriction<f64>, W: Monitor>(
    pair: Option<One<'_, F::Modes>>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    watch: &mut W,
) {
    let Some((link, swept)) = pair else {
        return;
    };
    let bodies = link.bodies.map(|body| (body - first) as usize);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        let friction = friction.of(link.bodies);
        update(&mut link.contact, swept, friction, &mut a.0, &mut b.0).tell(watch);
    }
}

/// What a monitor records of a contact.
pub(super) struct Seen {
    /// change², P, speed
    change: [f64; 3],
    /// Product of the change with the step before, if that is followed.
    along: Option<f64>,
}

impl Seen {
    #[inline(always)]
    pub fn tell<W: Monitor>(&self, watch: &mut W) {
        let [change_sq, bound, speed] = self.change;
        watch.see(change_sq, bound, speed);
        if let Some(along) = self.along {
            watch.follow(along);
        }
    }
}

/// Solves a contact; the step before led from `swept` to its impulse.
#[inline(always)]
pub(super) fn update<F: ContactFriction<f64>>(
    contact: &mut Contact<f64, F::Modes>,
    swept: Option<&Modal<f64, F::Modes>>,
    friction: &F,
    a: &mut impl Body<f64>,
    b: &mut impl Body<f64>,
) -> Seen {
    let before = swept.map(|swept| contact.impulse().minus(swept));
    let change = contact.update(friction, a, b);
    let lever = contact.lever();
    let speed = change.normal.abs() / contact.block().mass_normal;
    Seen {
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
fn solve_run<M: ContactModes<f64>>(
    (links, swept): (&mut [Link<M>], &[Modal<f64, M>]),
    groups: Groups<'_>,
    (first, spheres): (u32, &mut [Aligned]),
    (way, at): (Way, usize),
    records: &mut [Records; RUN],
) -> usize {
    tribos_lanes::run(Run {
        links,
        swept,
        groups,
        spheres,
        first,
        way,
        at,
        records,
    })
}

/// Groups one after the other.
struct Run<'a, M: ContactModes<f64>> {
    links: &'a mut [Link<M>],
    swept: &'a [Modal<f64, M>],
    groups: Groups<'a>,
    spheres: &'a mut [Aligned],
    first: u32,
    way: Way,
    at: usize,
    records: &'a mut [Records; RUN],
}

impl<M: ContactModes<f64>> Task for Run<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let Self {
            links,
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
            let group = links.get_mut(start..).filter(|_| groups.begins(start));
            let Some(four) = group.and_then(|rest| rest.first_chunk_mut::<LANES>()) else {
                return solved;
            };
            let old = swept.get(start..).and_then(<[_]>::first_chunk);
            let bodies = (first, &mut *spheres);
            let Some(seen) = four::update::<L, M>(four, old, bodies, groups.common) else {
                return solved;
            };
            *record = seen;
            for lane in 0..LANES {
                let ahead = way.ahead(start).wrapping_add(lane);
                fetch(links.get(ahead), spheres, first);
            }
            start = match way {
                Way::Forward => start + LANES,
                Way::Backward => start.wrapping_sub(LANES),
            };
        }
        RUN
    }
}

/// Solves pairs with an image one after the other.
pub(super) fn sweep_images<F: ContactFriction<f64>, W: Monitor>(
    pairs: Pairs<'_, F::Modes>,
    images: &[ImageVelocity],
    spheres: &mut [Aligned],
    friction: &impl PairFriction<F>,
    way: Way,
    watch: &mut W,
) {
    let Pairs { links, swept, .. } = pairs;
    let mut solve = |(at, (link, (_, velocity))): (usize, (&mut Link<_>, &ImageVelocity))| {
        let bodies = link.bodies.map(|body| body as usize);
        if let Ok([a, sphere]) = spheres.get_disjoint_mut(bodies) {
            let (velocity, friction) = (*velocity, friction.of(link.bodies));
            let sphere = &mut sphere.0;
            let mut image = Image { sphere, velocity };
            let seen = update(
                &mut link.contact,
                swept.get(at),
                friction,
                &mut a.0,
                &mut image,
            );
            seen.tell(watch);
        }
    };
    let pairs = links.iter_mut().zip(images).enumerate();
    if way == Way::Forward {
        pairs.for_each(solve);
    } else {
        pairs.rev().for_each(&mut solve);
    }
}
