//! Impulses of a contact against a table that knows no effective masses and no cases, and against
//! the directions that friction of bodies that turn easily must have.

use nalgebra::Vector3;
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, Contact, ContactFriction, ContactGeometry, ContactVector,
    CoupledFriction, IndependentFriction, NormalLaw, SlidingTorsion, SphereBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_core::real::Real;
use tribos_tests::contacts::{size, vector as random};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn number<R: Real>(row: &Row, column: &str) -> R {
    R::from_f64(row.number(column))
}

fn vector<R: Real>(row: &Row, name: &str) -> Vector3<R> {
    Vector3::from(["x", "y", "z"].map(|axis| number(row, &format!("{name}{axis}"))))
}

fn sphere<R: Real>(row: &Row, index: u32) -> SphereBody<R> {
    SphereBody {
        velocity: vector(row, &format!("v{index}")),
        spin: vector(row, &format!("w{index}")),
        inv_mass: number(row, &format!("im{index}")),
        inv_inertia: number(row, &format!("ii{index}")),
    }
}

fn law<R: Real>(row: &Row) -> NormalLaw<R> {
    let attraction = match row.text("attraction") {
        "pull" => Attraction::Pull,
        _ => Attraction::Resistance,
    };
    let cohesion = Cohesion::new(number(row, "strength"), number(row, "range"), attraction);
    NormalLaw::new(cohesion.unwrap(), number(row, "e")).unwrap()
}

/// Turns of sliding and rolling after which the table's spheres have settled: each leaves at most 5/7 of what is left.
const TURNS: usize = 200;

/// How a contact is solved.
#[derive(Clone, Copy)]
enum Solved {
    Together,
    InTurns,
}

/// The error of one row, of all its impulses, P, the momentum that meets and, at an open gap,
/// the momentum that would take the spheres through each other.
fn error<R: Real, F: ContactFriction<R>>(row: &Row, friction: &F, solved: Solved) -> f64 {
    let radii = [number(row, "r1"), number(row, "r2")];
    let touch = ContactGeometry::spheres(&vector(row, "d"), radii).unwrap();
    let (mut a, mut b) = (sphere(row, 1), sphere(row, 2));
    // An open gap is known to the rounding of the distance.
    let open = touch.gap > R::ZERO;
    let [arm_a, arm_b] = touch.arms.map(R::to_f64);
    let closing = f64::from(open) * (arm_a + arm_b) / row.number("dt");
    let met = (b.velocity - a.velocity).map(R::to_f64).norm() + closing;
    let mut contact = Contact::new(&touch, &law(row), &a, &b, number(row, "dt"));
    match solved {
        Solved::Together => {
            contact.update(friction, &mut a, &mut b);
        }
        Solved::InTurns => {
            for _ in 0..TURNS {
                contact.take_turn(friction, &mut a, &mut b);
            }
        }
    }
    let wanted = ContactVector::<R, F::Modes>::new(
        number(row, "n"),
        vector(row, "f"),
        vector(row, "t"),
        number(row, "torsion"),
    );
    let lever = touch.lever;
    let miss = contact.impulse().minus(&wanted);
    let mass = contact.block().mass_normal.to_f64();
    let scale = size(&wanted, lever) + contact.bound().to_f64() + mass * met;
    size(&miss, lever) / scale
}

fn worst<R: Real, F: ContactFriction<R>>(
    name: &'static str,
    (kind, solved): (&str, Solved),
    friction: impl Fn(&Row) -> F,
) -> Worst {
    let mut worst = Worst::of(name);
    let table = Table::read("contacts.csv");
    for (number, row) in table.rows().enumerate() {
        if row.text("kind") == kind {
            let error = error::<R, F>(&row, &friction(&row), solved);
            worst.see(error, || format!("row {number}, {}", row.text("case")));
        }
    }
    worst
}

fn thresholds<R: Real>(row: &Row) -> IndependentFriction<R, AllModes> {
    let [mu, mu_rolling, mu_torsion] = ["mu", "mu_t", "mu_n"].map(|name| number(row, name));
    IndependentFriction::all(mu, mu_rolling, mu_torsion).unwrap()
}

fn exact<R: Real>(
    row: &Row,
) -> CoupledFriction<R, RoundLimitSurface<R, CoulombDisk>, SlidingTorsion> {
    let set = RoundLimitSurface::new(CoulombDisk, number(row, "mu"), number(row, "mu_n")).unwrap();
    CoupledFriction::sliding_torsion(set)
}

#[test]
fn sliding_and_rolling_of_unequal_spheres_are_solved_together() {
    let kind = ("thresholds", Solved::Together);
    let worst = worst::<f64, _>("contact of unequal spheres", kind, thresholds);
    worst.assert_within(&tolerance::CONTACT);
}

#[test]
fn turns_of_sliding_and_rolling_end_where_both_are_solved_together() {
    let kind = ("thresholds", Solved::InTurns);
    let worst = worst::<f64, _>("contact of unequal spheres, in turns", kind, thresholds);
    worst.assert_within(&tolerance::CONTACT_IN_TURNS);
}

#[test]
fn sliding_and_torsion_meet_the_exact_set() {
    let worst = worst::<f64, _>(
        "contact, coupled torsion",
        ("coupled", Solved::Together),
        exact,
    );
    worst.assert_within(&tolerance::CONTACT);
}

#[test]
fn single_precision_keeps_its_digits() {
    let name = "contact of unequal spheres, f32";
    worst::<f32, _>(name, ("thresholds", Solved::Together), thresholds)
        .assert_within(&tolerance::CONTACT_SINGLE);
    let name = "contact, coupled torsion, f32";
    worst::<f32, _>(name, ("coupled", Solved::Together), exact)
        .assert_within(&tolerance::CONTACT_SINGLE);
}

#[test]
fn the_table_has_every_branch_and_case() {
    let table = Table::read("contacts.csv");
    let has = |attraction: &str, case: &str| {
        let mut rows = table.rows();
        rows.any(|row| row.text("attraction") == attraction && row.text("case").starts_with(case))
    };
    for case in [
        "closed ---",
        "closed -s",
        "closed s-",
        "closed ss",
        "saturated",
    ] {
        assert!(has("pull", case), "{case}");
        assert!(has("resistance", case), "{case}");
    }
    assert!(has("resistance", "held") && has("resistance", "free"));
}

const CASES: usize = 100_000;

/// Two bodies that slide and roll on each other under the load of cohesion alone. k² m I comes as near to 1 as
/// numbers allow, and is 1 for axles, which do not give way.
fn turning<R: Real>(rng: &mut Lcg) -> (ContactGeometry<R>, [SphereBody<R>; 2]) {
    let radii = [1.0, rng.log_between(1e-3, 1e3)].map(R::from_f64);
    let normal: Vector3<f64> = random(rng, 1.0);
    let displacement = normal.normalize().map(R::from_f64) * (radii[0] + radii[1]);
    let touch = ContactGeometry::spheres(&displacement, radii).unwrap();
    let easiest = [0.0, -2.0, -6.0, -12.0, -20.0][rng.bits() as usize % 5];
    let body = |rng: &mut Lcg, radius: R| {
        let inv_inertia = R::from_f64(rng.log_between(0.1, 10.0)) / (radius * radius);
        let weight = rng.log_between(10.0_f64.powf(easiest), 1.0);
        let axle = rng.bits().is_multiple_of(8);
        let velocity = random(rng, 1.0);
        let in_plane = velocity - normal * (velocity.dot(&normal) / normal.norm_squared());
        SphereBody {
            velocity: in_plane.map(R::from_f64),
            spin: random::<R>(rng, 1.0) / radius,
            inv_mass: R::from_f64(if axle { 0.0 } else { weight }),
            inv_inertia,
        }
    };
    let bodies = [body(rng, radii[0]), body(rng, radii[1])];
    (touch, bodies)
}

/// How far the opposite of a motion is from the outward normals of a ball of impulses, where the impulse in
/// units of the ball's radius is `share`: 0 by the laws of friction, and for no other impulse in the ball.
fn off_normal(share: [f64; 4], motion: [f64; 4], collar: f64) -> f64 {
    let dot = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let length = dot(share, share).sqrt();
    assert!(length <= 1.0 + collar, "{length}");
    if length < 1.0 - collar {
        return dot(motion, motion).sqrt();
    }
    let against = (dot(share, motion) / length).min(0.0) / length;
    let off = [0, 1, 2, 3].map(|n| motion[n] - against * share[n]);
    dot(off, off).sqrt()
}

/// One update of a contact under `load`, and how far it is from the laws of friction, of all speeds that meet.
/// `ellipsoid` tells that sliding and torsion have one limit.
fn off_the_laws<R: Real, F: ContactFriction<R>>(
    (touch, bodies): &(ContactGeometry<R>, [SphereBody<R>; 2]),
    (friction, load): (&F, R),
    [mu, mu_rolling, mu_torsion]: [f64; 3],
    ellipsoid: bool,
) -> f64 {
    let cohesion = Cohesion::new(load, R::ONE, Attraction::Pull).unwrap();
    let law = NormalLaw::new(cohesion, R::ZERO).unwrap();
    let [mut a, mut b] = *bodies;
    let touch = ContactGeometry {
        gap: R::ZERO,
        ..*touch
    };
    let mut contact = Contact::<R, F::Modes>::new(&touch, &law, &a, &b, R::ONE);
    contact.update(friction, &mut a, &mut b);
    let double = |v: Vector3<R>| v.map(R::to_f64);
    let normal = double(touch.normal);
    let [force, rolling] = [contact.impulse().sliding(), contact.impulse().rolling()].map(double);
    let torsion = contact.impulse().torsion().to_f64();
    let torque = rolling + normal * torsion;
    // Newton's laws at the contact point.
    let (mut slip, mut turn) = (Vector3::zeros(), Vector3::zeros());
    let (mut speed, mut rate) = (0.0, 0.0);
    for ((body, arm), sign) in bodies.iter().zip(touch.arms).zip([-1.0, 1.0]) {
        let place = normal * (-sign * arm.to_f64());
        let [ease, light] = [body.inv_inertia, body.inv_mass].map(R::to_f64);
        let spin = double(body.spin) + (place.cross(&force) + torque) * (sign * ease);
        let velocity = double(body.velocity) + force * (sign * light);
        slip += (velocity + spin.cross(&place)) * sign;
        turn += spin * sign;
        let torques = place.norm() * force.norm() + torque.norm();
        let turned = double(body.spin).norm() + torques * ease;
        speed += double(body.velocity).norm() + force.norm() * light + turned * place.norm();
        rate += turned;
    }
    let spin = turn.dot(&normal);
    let [slip, turn] = [slip, turn].map(|v| v - normal * v.dot(&normal));
    // Bodies of next to no inverse mass take all of the cohesion to follow the rounding of their velocities.
    let load = contact.bound().to_f64();
    if load == 0.0 {
        return 0.0;
    }
    let lever = touch.lever.to_f64();
    let [most, rolls, spins] = [mu, mu_rolling * lever, mu_torsion * lever].map(|mu| mu * load);
    let collar = COLLAR * R::EPSILON.to_f64();
    let of = |v: Vector3<f64>, last: f64| [v.x, v.y, v.z, last];
    let none = Vector3::zeros();
    let turning = off_normal(of(rolling / rolls, 0.0), of(turn, 0.0), collar) / rate;
    if ellipsoid {
        let motion = of(slip * most, spin * spins);
        let off = off_normal(of(force / most, torsion / spins), motion, collar);
        return turning.max(off / (most * speed + spins * rate));
    }
    let sliding = off_normal(of(force / most, 0.0), of(slip, 0.0), collar) / speed;
    let torsion = off_normal(of(none, torsion / spins), of(none, spin), collar) / rate;
    turning.max(sliding).max(torsion)
}

/// What an impulse may be short of its limit by rounding, and beyond it.
const COLLAR: f64 = 64.0;

fn worst_off_the_laws<R: Real>(name: &'static str) -> Worst {
    let mut worst = Worst::of(name);
    let mut rng = Lcg::new(63);
    for _ in 0..CASES {
        let case = turning::<R>(&mut rng);
        let load = R::from_f64(rng.log_between(1e-3, 1e3));
        let limits = [(); 3].map(|()| R::from_f64(rng.log_between(1e-3, 1.0)));
        let [mu, mu_rolling, mu_torsion] = limits.map(R::to_f64);
        let own = IndependentFriction::all(limits[0], limits[1], limits[2]).unwrap();
        let off = off_the_laws(&case, (&own, load), [mu, mu_rolling, mu_torsion], false);
        worst.see(off, || format!("{own:?} {load:?} {case:?}"));
        let one = LimitEllipsoid::new(limits[0], limits[2], R::HALF).unwrap();
        let coupled = CoupledFriction::all(one, limits[1]).unwrap();
        let limits = [mu, mu_rolling, 0.5 * mu * mu_torsion];
        let off = off_the_laws(&case, (&coupled, load), limits, true);
        worst.see(off, || format!("{limits:?} {load:?} {case:?}"));
    }
    worst
}

#[test]
fn bodies_that_turn_easily_obey_both_limits_at_once() {
    let worst = worst_off_the_laws::<f64>("motion against friction");
    worst.assert_within(&tolerance::CONTACT_LAWS);
    let worst = worst_off_the_laws::<f32>("motion against friction, f32");
    worst.assert_within(&tolerance::CONTACT_LAWS_SINGLE);
}
