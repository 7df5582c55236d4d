//! Round patches.

use super::stream::{Precision, Range, Stream};
use tribos_core::coupling::coulomb::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::{Annulus, ReducedFriction, RoundFriction, compact, coulomb};
use tribos_core::patch::PowerPressure;
use tribos_core::twist::Twist;

/// A patch with its load and twist.
struct Case<R: Precision> {
    coefficient: R,
    radius: R,
    load: R,
    twist: Twist<R>,
}

impl<R: Precision> Case<R> {
    /// Wrench and Jacobian.
    fn feed<C: ReducedFriction<R>, E>(&self, s: &mut Stream, coupling: Result<C, E>) {
        let friction = coupling
            .ok()
            .and_then(|c| RoundFriction::new(c, self.coefficient, self.radius).ok())
            .ok_or(());
        let friction = friction.as_ref();
        s.wrench_of(friction.map(|f| f.wrench(self.load, &self.twist)));
        s.jacobian_of(friction.map(|f| f.wrench_jacobian(self.load, &self.twist)));
    }
}

/// Twists of a batch: more than the C interface converts at once.
const TWISTS: usize = 21;

/// What C computes in batches, twist by twist.
fn feed_batch<R: Precision, C: ReducedFriction<R>>(s: &mut Stream, case: &Case<R>, coupling: C) {
    let twists = [(); TWISTS].map(|()| s.twist(Range::Wide));
    let friction = RoundFriction::new(coupling, case.coefficient, case.radius);
    for twist in &twists {
        s.wrench_of(friction.as_ref().map(|f| f.wrench(case.load, twist)));
    }
    for twist in &twists {
        s.jacobian_of(
            friction
                .as_ref()
                .map(|f| f.wrench_jacobian(case.load, twist)),
        );
    }
}

fn sound<C>(coupling: C) -> Result<C, ()> {
    Ok(coupling)
}

pub fn round<R: Precision>(s: &mut Stream) {
    let [coefficient, radius, load, inner]: [R; 4] = s.draws(Range::Fit);
    let case = Case {
        coefficient,
        radius,
        load,
        twist: s.twist(Range::Wide),
    };
    case.feed(s, sound(coulomb::CoulombDisk));
    case.feed(s, Annulus::new(coulomb::CoulombDisk, inner / R::TWO));
    case.feed(s, sound(CoulombHertz));
    case.feed(s, sound(CoulombRing));
    case.feed(s, sound(CoulombPunch));
    feed_batch(s, &case, coulomb::CoulombDisk);
}

pub fn powers<R: Precision>(s: &mut Stream) {
    let [alpha, order, coefficient, radius, load]: [R; 5] = s.draws(Range::Fit);
    let case = Case {
        coefficient,
        radius,
        load,
        twist: s.twist(Range::Mild),
    };
    let pressure = PowerPressure::new((order - R::ONE).to_f64()).ok();
    let alpha = R::TWO * alpha - R::ONE;
    let law = pressure.and_then(|p| compact::CompactPower::with_pressure(alpha, p).ok());
    let law = s.ok(law.ok_or(()));
    case.feed(s, law.ok_or(()));
}

pub fn tables<R: Precision>(s: &mut Stream) {
    for alpha in [-0.5, 0.5, 3.0, -1.0, 11.0, 1.0] {
        let Some(table) = s.ok(R::table(R::from_f64(alpha)).ok_or(())) else {
            continue;
        };
        for _ in 0..40 {
            let [coefficient, radius, load] = s.draws(Range::Fit);
            let case = Case {
                coefficient,
                radius,
                load,
                twist: s.twist(Range::Wide),
            };
            case.feed(s, sound(&table));
            feed_batch(s, &case, &table);
        }
    }
}
