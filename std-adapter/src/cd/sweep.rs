//! Sweeps over the pairs of spheres: one after the other, four at a time, or a colour on several threads.

use super::aligned::Aligned;
use super::four::{self, Records};
use super::groups::{Groups, LANES};
use super::image::{Image, ImageVelocity};
use super::mixture::PairFriction;
use super::operator::Monitor;
use super::spheres::Link;
use rayon::prelude::*;
use tribos_core::contact::{Contact, ContactFriction, ContactModes, Modal, Sphere};
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

/// Solves pairs one after the other, or four at a time where they are grouped; the first element of `spheres`
/// has the number `first`. Both give the same bits.
pub(super) fn sweep_links<F: ContactFriction<f64>, W: Monitor>(
    links: &mut [Link<F::Modes>],
    groups: Option<Groups<'_>>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    way: Way,
    watch: &mut W,
) {
    let count = links.len();
    let mut records = [Records::default(); RUN];
    let mut done = 0;
    while done < count {
        let at = way.place(done, count);
        if let Some(groups) = groups.filter(|groups| groups.begins(way.start(at))) {
            let bodies = (first, &mut *spheres);
            let solved = solve_run(links, groups, bodies, (way, at), &mut records);
            for group in records.iter().take(solved) {
                show(group, way, watch);
            }
            done += LANES * solved;
            if solved > 0 {
                continue;
            }
        }
        fetch(links.get(way.ahead(at)), spheres, first);
        solve_one(links, at, (first, spheres), friction, watch);
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
fn show<W: Monitor>([change_sq, bound, speed]: &Records, way: Way, watch: &mut W) {
    for turn in 0..LANES {
        let lane = way.place(turn, LANES);
        watch.see(change_sq[lane], bound[lane], speed[lane]);
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

/// Solves one pair; the first element of `spheres` has the number `first`.
#[inline(always)]
pub(super) fn solve_one<F: ContactFriction<f64>, W: Monitor>(
    links: &mut [Link<F::Modes>],
    at: usize,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    watch: &mut W,
) {
    let Some(link) = links.get_mut(at) else {
        return;
    };
    let bodies = link.bodies.map(|body| (body - first) as usize);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        let friction = friction.of(link.bodies);
        let change = link.contact.update(friction, &mut a.0, &mut b.0);
        report(&link.contact, &change, watch);
    }
}

/// Number of groups that are solved before a monitor sees them.
const RUN: usize = 16;

/// Solves groups one after the other, the first of which has the pair at `at`, as far as there is one after
/// another; gives what a monitor records, and returns their number. Apart from monitors and frictions: a copy for each
/// of these would take minutes to compile.
#[inline(never)]
fn solve_run<M: ContactModes<f64>>(
    links: &mut [Link<M>],
    groups: Groups<'_>,
    (first, spheres): (u32, &mut [Aligned]),
    (way, at): (Way, usize),
    records: &mut [Records; RUN],
) -> usize {
    tribos_lanes::run(Run {
        links,
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
            let Some(seen) = four::update::<L, M>(four, (first, spheres), groups.common) else {
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

/// Number of pairs of one colour below which threads cost more than they gain.
const WORTHWHILE_COLOUR: usize = 4_000;
/// Least number of pairs for a thread.
const SHARE: usize = 200;

/// Solves the pairs of a colour, which have no sphere in common: on several threads, if they are many.
pub(super) fn sweep_colour<F: ContactFriction<f64>, W: Monitor>(
    links: &mut [Link<F::Modes>],
    groups: Option<Groups<'_>>,
    spheres: &mut [Aligned],
    friction: &impl PairFriction<F>,
    way: Way,
    watch: &mut W,
) {
    if links.len() < WORTHWHILE_COLOUR || rayon::current_num_threads() == 1 {
        return sweep_links(links, groups, (0, spheres), friction, way, watch);
    }
    // Copies of the bodies are solved in parallel; then each body takes its motion in turn.
    let mut solved = Vec::with_capacity(links.len());
    let solve = |link: &mut Link<F::Modes>| {
        let [mut a, mut b] = link.bodies.map(|body| spheres[body as usize].0);
        let friction = friction.of(link.bodies);
        let change = link.contact.update(friction, &mut a, &mut b);
        (link.bodies, [a, b], watched(&link.contact, &change))
    };
    let shares = links.par_iter_mut().with_min_len(SHARE);
    shares.map(solve).collect_into_vec(&mut solved);
    let mut take = |(bodies, moved, seen): &([u32; 2], [Sphere<f64>; 2], [f64; 3])| {
        for (body, moved) in bodies.iter().zip(moved) {
            spheres[*body as usize].0 = *moved;
        }
        let [change_sq, bound, speed] = *seen;
        watch.see(change_sq, bound, speed);
    };
    if way == Way::Forward {
        solved.iter().for_each(take);
    } else {
        solved.iter().rev().for_each(&mut take);
    }
}

/// Solves pairs with an image one after the other.
pub(super) fn sweep_images<F: ContactFriction<f64>, W: Monitor>(
    (links, images): (&mut [Link<F::Modes>], &[ImageVelocity]),
    spheres: &mut [Aligned],
    friction: &impl PairFriction<F>,
    way: Way,
    watch: &mut W,
) {
    let mut update = |(link, (_, velocity)): (&mut Link<F::Modes>, &ImageVelocity)| {
        let bodies = link.bodies.map(|body| body as usize);
        if let Ok([a, sphere]) = spheres.get_disjoint_mut(bodies) {
            let (velocity, friction) = (*velocity, friction.of(link.bodies));
            let sphere = &mut sphere.0;
            let change = link
                .contact
                .update(friction, &mut a.0, &mut Image { sphere, velocity });
            report(&link.contact, &change, watch);
        }
    };
    let pairs = links.iter_mut().zip(images);
    if way == Way::Forward {
        pairs.for_each(update);
    } else {
        pairs.rev().for_each(&mut update);
    }
}

#[inline(always)]
pub(super) fn report<M: ContactModes<f64>, W: Monitor>(
    contact: &Contact<f64, M>,
    change: &Modal<f64, M>,
    watch: &mut W,
) {
    let [change_sq, bound, speed] = watched(contact, change);
    watch.see(change_sq, bound, speed);
}

/// What a monitor records of a contact whose impulse has changed.
#[inline(always)]
fn watched<M: ContactModes<f64>>(contact: &Contact<f64, M>, change: &Modal<f64, M>) -> [f64; 3] {
    let change_sq = change.dot_with_lever(change, contact.lever());
    let speed = change.normal.abs() / contact.block().mass_normal;
    [change_sq, contact.bound(), speed]
}
