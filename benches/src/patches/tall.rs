//! A tall cylinder on the uniform disk, with the lean of its pressure.

use super::area::{Moments, Pressure};
use super::laws::{self, Friction};
use super::round::{TABLE_STRIDE, rounded, table_bytes, timed};
use super::{Entry, Label, Refused, SEED, Worst};
use crate::mix;
use crate::reference::Wide;
use core::marker::PhantomData;
use tribos::friction::{Patch, Precision, RoundPower, Tier, Visitor, visit};
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::{LateralFriction, RoundFriction};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// λ: half of what would make the cylinder tip when it slides without spin.
const LEAN: f64 = 0.5;
/// Pairs judged.
const PAIRS: usize = 48;
/// Their ratios: outside, the judge loses digits.
const RATIOS: core::ops::Range<f64> = 1e-3..1e3;

/// Force, lateral force and torque, all against the motion, for γ = N = R = 1.
fn components<R: Real, C: LateralFriction<R>, L: PressureGradient>(
    body: &LoadTransferFriction<R, C, L>,
    slide: R,
    rim: R,
) -> [R; 3] {
    let tall = body.wrench(R::ONE, &Twist::new(slide, R::ZERO, rim));
    let wrench = tall.wrench;
    [-wrench.force.x, -wrench.force.y, -wrench.torque]
}

/// The larger speed is 1, so that no law tips the body.
fn pairs<R: Real>() -> Vec<[f64; 2]> {
    let all = mix::pairs(SEED).into_iter();
    let all = all.filter(|[v, w]| RATIOS.contains(&(v / w))).take(PAIRS);
    let unit = |[v, w]: [f64; 2]| rounded::<R>([v, w].map(|speed| speed / v.max(w)));
    all.map(unit).collect()
}

/// Forces of a leaning pressure from moments that share nothing with the kernel.
fn exact(all_round: bool, friction: &Friction, speeds: [f64; 2]) -> [f64; 3] {
    let Moments {
        force,
        torque,
        lateral,
        across,
    } = Moments::new(Pressure::Power(0.0), friction, speeds);
    let force = if all_round {
        force / (1.0 - LEAN * LEAN * lateral * across[0])
    } else {
        force
    };
    let side = LEAN * force * lateral;
    let tipped = if all_round { LEAN * side } else { 0.0 };
    [force, side, torque + tipped * across[1]]
}

fn row<R: Real, C: LateralFriction<R> + 'static, L: PressureGradient + 'static>(
    (law, tier, friction): (&'static str, &'static str, &Friction),
    bytes: usize,
    coupling: C,
) -> Result<Entry, Refused> {
    let all_round = tier == "table all round";
    let foot = RoundFriction::new(coupling, R::ONE, R::ONE)?;
    // λ = 2 γ h/(R ⟨r²⟩) with ⟨r²⟩ = 1/2.
    let height = R::from_f64(LEAN / 4.0);
    let body = LoadTransferFriction::<R, C, L>::new(foot, height)?;
    let mut worst = Worst::default();
    for speeds in pairs::<R>() {
        let [slide, rim] = speeds.map(R::from_f64);
        let found = components(&body, slide, rim).map(R::to_f64);
        let exact = exact(all_round, friction, speeds);
        worst.include([found[0], found[2]], [exact[0], exact[2]].map(Wide::new));
        let side = (found[1] - exact[1]).abs() / exact[0].max(exact[2]);
        worst.of_larger = worst.of_larger.max(side);
    }
    let label = Label {
        patch: "tall cylinder",
        law,
        tier,
        judge: "area",
    };
    let timed = timed(TABLE_STRIDE);
    let mut entry = Entry::new(label, bytes, &[], &timed, move |slide, rim| {
        let [force, side, torque] = components(&body, slide, rim);
        [force + side, torque]
    });
    entry.worst = worst;
    Ok(entry)
}

/// The row of the kernel's own type, chosen at run time.
struct Row<'a, L> {
    about: (&'static str, &'static str, &'a Friction),
    lean: PhantomData<L>,
}

impl<R: Precision, L: PressureGradient + 'static> Visitor<R> for Row<'_, L> {
    type Output = Result<Entry, Refused>;
    fn visit<P: RoundPower<R> + 'static>(self, friction: P) -> Self::Output {
        row::<R, _, L>(self.about, table_bytes::<R, P>(), friction)
    }
}

/// Both ways of leaning under power laws.
pub fn rows<R: Precision>() -> Result<Vec<Entry>, Refused> {
    fn of<R: Precision, L: PressureGradient + 'static>(
        alpha: f64,
        about: (&'static str, &'static str, &Friction),
    ) -> Result<Entry, Refused> {
        let lean = PhantomData::<L>;
        visit::<R, _>(&Patch::Disk, alpha, Tier::Exact, Row { about, lean })?
    }
    let mut rows = Vec::new();
    let frictions = laws::frictions()?;
    for ((alpha, law), (_, friction)) in laws::POWERS.into_iter().zip(&frictions) {
        rows.push(of::<R, LongitudinalGradient>(
            alpha,
            (law, "table front-back", friction),
        )?);
        rows.push(of::<R, FullGradient>(
            alpha,
            (law, "table all round", friction),
        )?);
    }
    Ok(rows)
}
