//! Sweeps over the pairs of spheres: one after the other, four at a time, or a colour on several threads.

use super::aligned::Aligned;
use super::four;
use super::groups::Groups;
use super::image::{Image, ImageVelocity};
use super::mixture::PairFriction;
use super::operator::Monitor;
use super::spheres::Link;
use rayon::prelude::*;
use std::marker::PhantomData;
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
pub(super) const WORTHWHILE: usize = 2_000;

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
    let number = |body: u32| (body - first) as usize;
    match groups {
        Some(groups) => tribos_lanes::run(Grouped {
            links,
            groups,
            spheres,
            first,
            friction,
            way,
            watch,
            law: PhantomData::<F>,
        }),
        None => {
            let count = links.len();
            let mut update = |at: usize, ahead: usize| {
                fetch(links.get(ahead), spheres, number);
                solve_one(links, at, spheres, number, friction, watch);
            };
            if way == Way::Forward {
                (0..count).for_each(|at| update(at, at + AHEAD));
            } else {
                (0..count)
                    .rev()
                    .for_each(|at| update(at, at.wrapping_sub(AHEAD)));
            }
        }
    }
}

/// Asks for the bodies of a link, which lie anywhere in memory, before they are needed.
#[inline(always)]
fn fetch<M: ContactModes<f64>>(
    soon: Option<&Link<M>>,
    spheres: &[Aligned],
    number: impl Fn(u32) -> usize,
) {
    if let Some(soon) = soon {
        for body in soon.bodies {
            if let Some(sphere) = spheres.get(number(body)) {
                prefetch(sphere);
            }
        }
    }
}

/// Solves one pair.
#[inline(always)]
fn solve_one<F: ContactFriction<f64>, W: Monitor>(
    links: &mut [Link<F::Modes>],
    at: usize,
    spheres: &mut [Aligned],
    number: impl Fn(u32) -> usize,
    friction: &impl PairFriction<F>,
    watch: &mut W,
) {
    let Some(link) = links.get_mut(at) else {
        return;
    };
    let bodies = link.bodies.map(number);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        let friction = friction.of(link.bodies);
        let change = link.contact.update(friction, &mut a.0, &mut b.0);
        report(&link.contact, &change, watch);
    }
}

/// A sweep over pairs of which most are solved four at a time.
struct Grouped<'a, F: ContactFriction<f64>, P, W> {
    links: &'a mut [Link<F::Modes>],
    groups: Groups<'a>,
    spheres: &'a mut [Aligned],
    first: u32,
    friction: &'a P,
    way: Way,
    watch: &'a mut W,
    law: PhantomData<F>,
}

impl<F: ContactFriction<f64>, P: PairFriction<F>, W: Monitor> Task for Grouped<'_, F, P, W> {
    type Output = ();

    #[inline(always)]
    fn run<L: Four>(self) {
        let Self {
            links,
            groups,
            spheres,
            first,
            friction,
            way,
            watch,
            ..
        } = self;
        let number = |body: u32| (body - first) as usize;
        let count = links.len();
        let mut done = 0;
        while done < count {
            // The next pair, and the first of its group.
            let (at, start) = if way == Way::Forward {
                (done, done)
            } else {
                (count - 1 - done, (count - 1 - done).wrapping_sub(3))
            };
            let four = if groups.begins(start) {
                links
                    .get_mut(start..)
                    .and_then(|rest| rest.first_chunk_mut::<4>())
            } else {
                None
            };
            let Some(four) = four else {
                let ahead = if way == Way::Forward {
                    at + AHEAD
                } else {
                    at.wrapping_sub(AHEAD)
                };
                fetch(links.get(ahead), spheres, number);
                solve_one(links, at, spheres, number, friction, watch);
                done += 1;
                continue;
            };
            let places = [0, 1].map(|end| {
                let [a, b, c, d] = &*four;
                [a, b, c, d].map(|link| number(link.bodies[end]))
            });
            let records = four::update::<L, F::Modes>(four, spheres, places, groups.common);
            if let Some([change_sq, bound, speed]) = records {
                let mut see = |lane: usize| watch.see(change_sq[lane], bound[lane], speed[lane]);
                if way == Way::Forward {
                    (0..4).for_each(&mut see);
                } else {
                    (0..4).rev().for_each(&mut see);
                }
            }
            let ahead = if way == Way::Forward {
                start + AHEAD
            } else {
                start.wrapping_sub(AHEAD)
            };
            for lane in 0..4 {
                fetch(links.get(ahead.wrapping_add(lane)), spheres, number);
            }
            done += 4;
        }
    }
}

/// Number of pairs of one colour below which threads cost more than they gain.
const WORTHWHILE_COLOUR: usize = 500;
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
