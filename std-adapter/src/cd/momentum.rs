//! What sweeps with momentum do to all pairs at once: extrapolate impulses, apply them. Four at a time where pairs
//! are grouped, with the same bits as one after the other.

use super::aligned::Aligned;
use super::four;
use super::groups::{Groups, LANES};
use super::mixture::PairFriction;
use super::spheres::Link;
use super::sweep::{AHEAD, WORTHWHILE, fetch};
use rayon::prelude::*;
use tribos_core::contact::{ContactFriction, ContactModes, Modal};
use tribos_lanes::{Four, Task};

/// Number of pairs whose impulses a thread extrapolates at a time.
const SHARE: usize = 1_024;

/// Moves the impulses of pairs on by `beta` times their last step, as
/// [`Operator::extrapolate`](super::operator::Operator::extrapolate) does.
pub(super) fn extrapolate<F: ContactFriction<f64>>(
    links: &mut [Link<F::Modes>],
    groups: Option<Groups<'_>>,
    friction: &impl PairFriction<F>,
    beta: f64,
    [start, swept]: [&mut [Modal<f64, F::Modes>]; 2],
) {
    let share = |at: usize, links: &mut [Link<F::Modes>], start: &mut [_], swept: &mut [_]| {
        let groups = groups.map(|groups| groups.from(at * SHARE));
        extrapolate_share(links, groups, friction, beta, swept);
        for (start, link) in start.iter_mut().zip(links) {
            *start = *link.contact.impulse();
        }
    };
    if links.len() >= WORTHWHILE && rayon::current_num_threads() > 1 {
        let (starts, sweeps) = (start.par_chunks_mut(SHARE), swept.par_chunks_mut(SHARE));
        let shares = links.par_chunks_mut(SHARE).zip(starts).zip(sweeps);
        shares
            .enumerate()
            .for_each(|(at, ((links, start), swept))| share(at, links, start, swept));
    } else {
        share(0, links, start, swept);
    }
}

fn extrapolate_share<F: ContactFriction<f64>>(
    links: &mut [Link<F::Modes>],
    groups: Option<Groups<'_>>,
    friction: &impl PairFriction<F>,
    beta: f64,
    swept: &mut [Modal<f64, F::Modes>],
) {
    let mut at = 0;
    while at < links.len() {
        let rest = (&mut links[at..], &mut swept[at..]);
        let grouped = groups.map_or(0, |groups| extrapolate_run(rest, groups.from(at), beta));
        at += grouped;
        if let (0, Some(link), Some(old)) = (grouped, links.get_mut(at), swept.get_mut(at)) {
            let now = *link.contact.impulse();
            let step = now.plus_scaled(-1.0, old);
            let ahead = now.plus_scaled(beta, &step);
            link.contact.set_impulse_in_plane(&ahead);
            link.contact.admit(friction.of(link.bodies));
            *old = now;
            at += 1;
        }
    }
}

/// Extrapolates the groups at the beginning of these pairs, as far as there is one after another, and returns the
/// number of their pairs. Apart from frictions: a copy for each would take minutes to compile.
#[inline(never)]
fn extrapolate_run<M: ContactModes<f64>>(
    (links, swept): (&mut [Link<M>], &mut [Modal<f64, M>]),
    groups: Groups<'_>,
    beta: f64,
) -> usize {
    if !groups.begins(0) {
        return 0;
    }
    tribos_lanes::run(Extrapolation {
        links,
        swept,
        groups,
        beta,
    })
}

/// Groups one after the other.
struct Extrapolation<'a, M: ContactModes<f64>> {
    links: &'a mut [Link<M>],
    swept: &'a mut [Modal<f64, M>],
    groups: Groups<'a>,
    beta: f64,
}

impl<M: ContactModes<f64>> Task for Extrapolation<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let mut done = 0;
        let (links, _) = self.links.as_chunks_mut::<LANES>();
        let (swept, _) = self.swept.as_chunks_mut::<LANES>();
        for (links, swept) in links.iter_mut().zip(swept) {
            if !self.groups.begins(done) {
                break;
            }
            four::extrapolate::<L, M>(links, swept, self.beta, self.groups.common);
            done += LANES;
        }
        done
    }
}

/// Applies the impulses of pairs to their spheres, in the order of the pairs.
pub(super) fn apply<M: ContactModes<f64>>(
    links: &[Link<M>],
    groups: Option<Groups<'_>>,
    spheres: &mut [Aligned],
) {
    let mut at = 0;
    while at < links.len() {
        let rest = &links[at..];
        let grouped = groups.map_or(0, |groups| apply_run(rest, groups.from(at), spheres));
        at += grouped;
        if let (0, Some(link)) = (grouped, links.get(at)) {
            fetch(links.get(at + AHEAD), spheres, 0);
            let bodies = link.bodies.map(|body| body as usize);
            if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
                let contact = &link.contact;
                contact.apply(contact.impulse(), &mut a.0, &mut b.0);
            }
            at += 1;
        }
    }
}

/// Applies the impulses of the groups at the beginning of these pairs, and returns the number of their pairs.
#[inline(never)]
fn apply_run<M: ContactModes<f64>>(
    links: &[Link<M>],
    groups: Groups<'_>,
    spheres: &mut [Aligned],
) -> usize {
    if !groups.begins(0) {
        return 0;
    }
    tribos_lanes::run(Application {
        links,
        groups,
        spheres,
    })
}

/// Groups one after the other.
struct Application<'a, M: ContactModes<f64>> {
    links: &'a [Link<M>],
    groups: Groups<'a>,
    spheres: &'a mut [Aligned],
}

impl<M: ContactModes<f64>> Task for Application<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let mut done = 0;
        let (fours, _) = self.links.as_chunks::<LANES>();
        for links in fours {
            let (alike, _) = self.groups.common;
            if !self.groups.begins(done)
                || four::apply::<L, M>(links, self.spheres, alike).is_none()
            {
                break;
            }
            for lane in 0..LANES {
                let ahead = self.links.get(done + lane + AHEAD);
                fetch(ahead, self.spheres, 0);
            }
            done += LANES;
        }
        done
    }
}
