//! Extrapolation of the impulses of pairs, with the velocities that follow: four at a time where pairs are grouped,
//! with the same bits as one after the other.

use super::aligned::Aligned;
use super::four;
use super::groups::{Groups, LANES};
use super::mixture::PairFriction;
use super::spheres::Link;
use super::sweep::{AHEAD, fetch};
use tribos_core::contact::{ContactFriction, ContactModes, Modal};
use tribos_lanes::{Four, Task};

/// Pairs and their impulses after the sweep before, which become those after this one.
pub(super) struct Moving<'a, M: ContactModes<f64>> {
    pub links: &'a mut [Link<M>],
    pub swept: &'a mut [Modal<f64, M>],
    pub groups: Option<Groups<'a>>,
}

/// Moves impulses on by `beta` times their last step, as far as friction admits, and applies them to the spheres, the
/// first of which has the number `first`.
pub(super) fn extrapolate<F: ContactFriction<f64>>(
    pairs: Moving<'_, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    beta: f64,
) {
    let Moving {
        links,
        swept,
        groups,
    } = pairs;
    let mut at = 0;
    while at < links.len() {
        if let Some(groups) = groups.filter(|groups| groups.begins(at)) {
            let done = all_groups(Run {
                links: &mut links[at..],
                swept: &mut swept[at..],
                groups: groups.after(at),
                first,
                spheres: &mut *spheres,
                beta,
            });
            at += done;
            if done > 0 {
                continue;
            }
        }
        fetch(links.get(at + AHEAD), spheres, first);
        extrapolate_one(
            &mut links[at],
            &mut swept[at],
            (first, spheres),
            friction,
            beta,
        );
        at += 1;
    }
}

#[inline(always)]
fn extrapolate_one<F: ContactFriction<f64>>(
    link: &mut Link<F::Modes>,
    swept: &mut Modal<f64, F::Modes>,
    (first, spheres): (u32, &mut [Aligned]),
    friction: &impl PairFriction<F>,
    beta: f64,
) {
    let contact = &mut link.contact;
    let now = *contact.impulse();
    let step = now.minus(swept);
    contact.set_impulse_in_plane(&now.plus_scaled(beta, &step));
    contact.admit(friction.of(link.bodies));
    *swept = now;
    let bodies = link.bodies.map(|body| (body - first) as usize);
    if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
        contact.apply(contact.impulse(), &mut a.0, &mut b.0);
    }
}

/// Extrapolates the groups at the beginning of some pairs, as far as there is one after another, and returns the
/// number of their pairs. Apart from frictions: a copy for each would take minutes to compile.
#[inline(never)]
fn all_groups<M: ContactModes<f64>>(run: Run<'_, M>) -> usize {
    tribos_lanes::run(run)
}

/// Groups one after the other.
struct Run<'a, M: ContactModes<f64>> {
    links: &'a mut [Link<M>],
    swept: &'a mut [Modal<f64, M>],
    groups: Groups<'a>,
    first: u32,
    spheres: &'a mut [Aligned],
    beta: f64,
}

impl<M: ContactModes<f64>> Task for Run<'_, M> {
    type Output = usize;

    #[inline(always)]
    fn run<L: Four>(self) -> usize {
        let Self {
            links,
            swept,
            groups,
            first,
            spheres,
            beta,
        } = self;
        let mut done = 0;
        while groups.begins(done) {
            for lane in 0..LANES {
                fetch(links.get(done + lane + AHEAD), spheres, first);
            }
            let four = links.get_mut(done..).and_then(<[_]>::first_chunk_mut);
            let old = swept.get_mut(done..).and_then(<[_]>::first_chunk_mut);
            let (Some(four), Some(old)) = (four, old) else {
                break;
            };
            let bodies = (first, &mut *spheres);
            if four::extrapolate::<L, M>(four, old, bodies, beta, groups.common).is_none() {
                break;
            }
            done += LANES;
        }
        done
    }
}
