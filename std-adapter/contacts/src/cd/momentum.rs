//! Extrapolation of the impulses of pairs, with the velocities that follow: four at a time where pairs are grouped,
//! with the same bits as one after the other.

use super::aligned::Aligned;
use super::four_contacts;
use super::groups::{Groups, LANES};
use super::identical_spheres::AlikePair;
use super::mixture::PairFriction;
use super::pairs::View;
use super::sweep::{AHEAD, fetch};
use tribos_core::contact::{ContactFriction, ContactModes, ContactVector};
use tribos_lanes::{Four, Task};

/// Pairs, their impulses, and those after the sweep before, which become the impulses further on.
pub(super) struct Moving<'a, M: ContactModes<f64>> {
    /// They themselves, and those that come after them, whose bodies are fetched.
    pub pairs: View<'a>,
    pub now: &'a [ContactVector<f64, M>],
    pub swept: &'a mut [ContactVector<f64, M>],
    pub groups: Option<Groups<'a>>,
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
        now,
        swept,
        groups,
    } = moving;
    let mut at = 0;
    while at < now.len() {
        if let View::Alike(_, pairs) = pairs
            && let Some(groups) = groups.filter(|groups| groups.begins(at))
        {
            let done = all_groups(Run {
                pairs: &pairs[at..],
                now: &now[at..],
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
        fetch(pairs.bodies(at + AHEAD), spheres, first);
        let (now, swept) = (&now[at], &mut swept[at]);
        let further = now.plus_scaled(beta, &now.minus(swept));
        if let (Some(numbers), Some(mut contact)) = (pairs.bodies(at), pairs.contact(at, &further))
        {
            contact.project_impulse(friction.of(numbers));
            *swept = *contact.impulse();
            let bodies = numbers.map(|body| (body - first) as usize);
            if let Ok([a, b]) = spheres.get_disjoint_mut(bodies) {
                contact.apply(swept, &mut a.0, &mut b.0);
            }
        }
        at += 1;
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
    pairs: &'a [AlikePair],
    now: &'a [ContactVector<f64, M>],
    swept: &'a mut [ContactVector<f64, M>],
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
            pairs,
            now,
            swept,
            groups,
            first,
            spheres,
            beta,
        } = self;
        let mut done = 0;
        while groups.begins(done) {
            for lane in 0..LANES {
                let ahead = pairs.get(done + lane + AHEAD);
                fetch(ahead.map(AlikePair::bodies), spheres, first);
            }
            let four = pairs.get(done..).and_then(<[_]>::first_chunk);
            let new = now.get(done..).and_then(<[_]>::first_chunk);
            let old = swept.get_mut(done..).and_then(<[_]>::first_chunk_mut);
            let (Some(four), Some(new), Some(old)) = (four, new, old) else {
                break;
            };
            let bodies = (first, &mut *spheres);
            if four_contacts::extrapolate::<L, M>(four, new, old, bodies, beta, groups.common)
                .is_none()
            {
                break;
            }
            done += LANES;
        }
        done
    }
}
