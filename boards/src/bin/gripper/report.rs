//! The experiments, each reported in a line or two.

use crate::controller::{Compensation, Controller};
use crate::cost::Cost;
use crate::grasp::{Grasp, Phase, pushed};
use crate::object::{LOAD, MU_MODEL, MU_PRESENT, least_grip};
use crate::tracking;
use tribos_boards::{BOARD, Checks, Decimal, println};

/// Ratio of the grip force to the least that holds the load.
const MARGIN: f32 = 1.5;
/// Instructions that a tick may take with an FPU, a twentieth of 1 ms at 168 MHz. Without an FPU the
/// loop would be slower, and there is no guarantee.
const BUDGET: u64 = 8_400;
/// Relative tolerance of the motion that is predicted with all forces known: the controller's
/// step is ten times as long.
const NEAR: f32 = 2e-3;

/// Runs and reports everything; `None` if a parameter is refused.
pub fn print() -> Option<()> {
    let mut checks = Checks::default();
    println!("gripper, 1 kHz, f32, on {BOARD}");
    track(&mut checks)?;
    let wanted = choose_grip()?;
    drop_it(wanted, &mut checks)?;
    hold_it(wanted, &mut checks)?;
    checks.finish();
    Some(())
}

fn track(checks: &mut Checks) -> Option<()> {
    let (mut plain, mut cost) = (Cost::default(), Cost::default());
    let without = tracking::follow(Compensation::Absent, &mut plain).ok()?;
    let with = tracking::follow(Compensation::LuGre, &mut cost).ok()?;
    println!();
    println!("tracking 10 mm to and fro in 2 s");
    for (name, error) in [
        ("without compensation", &without),
        ("LuGre feed-forward", &with),
    ] {
        let [rms, worst] = [error.rms, error.worst].map(|x| Decimal::<1>(x * 1e6));
        println!("  {name}: error {rms} um rms, {worst} um at worst");
    }
    println!(
        "  state of the controller {} B; instructions a tick: mean {}, worst {}",
        size_of::<Controller>(),
        cost.mean(),
        cost.worst
    );
    checks.check(
        "compensation at least halves the rms error and the worst",
        2.0 * with.rms <= without.rms && 2.0 * with.worst <= without.worst,
    );
    Some(())
}

/// The chosen grip force, N.
fn choose_grip() -> Option<f32> {
    let least = least_grip(&LOAD)?;
    let wanted = MARGIN * least;
    println!();
    println!(
        "load on two pads: weight {} N, torque {} N m; mu {}, in truth {}",
        Decimal::<2>(-LOAD.force.y),
        Decimal::<3>(LOAD.torque),
        Decimal::<2>(MU_MODEL),
        Decimal::<2>(MU_PRESENT)
    );
    println!(
        "  least grip force {} N, times {}: {} N",
        Decimal::<2>(least),
        Decimal::<1>(MARGIN),
        Decimal::<2>(wanted)
    );
    Some(wanted)
}

/// Without compensation, friction in the joint absorbs a part of the grip force.
fn drop_it(wanted: f32, checks: &mut Checks) -> Option<()> {
    let mut cost = Cost::default();
    let mut grasp = Grasp::new(Compensation::Absent, wanted)?;
    let force = grasp.close(&mut cost);
    let phase = grasp.hang(&mut cost);
    let [is_at_rest, _] = phase.is_at_rest;
    let verdict = if is_at_rest { "held" } else { "dropped" };
    println!(
        "without compensation the pads get {} N: the object is {verdict}",
        Decimal::<2>(force)
    );
    checks.check(
        "friction of the joint costs the object its hold",
        !is_at_rest,
    );
    Some(())
}

fn hold_it(wanted: f32, checks: &mut Checks) -> Option<()> {
    let (mut closing, mut holding, mut pushing) =
        (Cost::default(), Cost::default(), Cost::default());
    let mut grasp = Grasp::new(Compensation::LuGre, wanted)?;
    let force = grasp.close(&mut closing);
    let held = grasp.hang(&mut holding);
    let [has_not_moved, _] = held.has_not_moved;
    let verdict = if has_not_moved { "held" } else { "slips" };
    println!(
        "with LuGre feed-forward the pads get {} N: the object is {verdict}",
        Decimal::<2>(force)
    );
    checks.check(
        "the grip force is right within a tenth",
        (force / wanted - 1.0).abs() < 0.1,
    );
    checks.check(
        "the held object is at rest to the last bit",
        held.has_not_moved == [true; 2],
    );
    println!();
    println!(
        "a push of 30 ms that {} N would hold: the object slides and spins",
        Decimal::<2>(least_grip(&pushed())?)
    );
    let known = grasp.push_as_known()?;
    let after = grasp.push(&mut pushing);
    tell_ways(&after, known, checks);
    println!();
    println!("instructions a tick");
    for (name, cost) in [
        ("closing", &closing),
        ("holding", &holding),
        ("pushed", &pushing),
    ] {
        println!("  {name}: mean {}, worst {}", cost.mean(), cost.worst);
    }
    println!("stack of a tick {} B, counting included", grasp.stack);
    let worst = closing.worst.max(holding.worst).max(pushing.worst);
    if cfg!(target_abi = "eabihf") {
        println!("budget of a tick {BUDGET} instructions");
        checks.check("the worst tick is within the budget", worst <= BUDGET);
    }
    Some(())
}

/// Motions of a pushed object.
fn tell_ways(after: &Phase, known: [f32; 2], checks: &mut Checks) {
    let ([travel, foreseen], [angle, foreseen_angle]) = (after.travel, after.angle);
    let [ticks, foreseen_ticks] = after.last_moving;
    tell("in truth", [travel, angle]);
    println!("    held again after {ticks} ms");
    tell("foreseen by the model", [foreseen, foreseen_angle]);
    println!("    held again after {foreseen_ticks} ms");
    tell("foreseen with the true friction and grip force", known);
    checks.check(
        "the pushed object is held again",
        after.is_at_rest == [true; 2],
    );
    let near = |known: f32, truth: f32| (known - truth).abs() <= NEAR * truth.abs();
    let [known_travel, known_angle] = known;
    checks.check(
        "with forces known its way is foreseen to 0.2 %",
        near(known_travel, travel) && near(known_angle, angle),
    );
}

fn tell(name: &str, [travel, angle]: [f32; 2]) {
    println!(
        "  {name}: {} mm, {} degrees",
        Decimal::<3>(travel * 1e3),
        Decimal::<2>(angle.to_degrees())
    );
}
