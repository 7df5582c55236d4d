//! Impulses of a contact against a table that knows no effective masses and no cases.

use nalgebra::Vector3;
use tribos_core::contact::{
    AllModes, Attraction, Cohesion, Contact, ContactFriction, CoupledFriction, Modal, NormalLaw,
    SlidingTorsion, Sphere, Thresholds, Touch,
};
use tribos_core::coupling::table::Coulomb;
use tribos_core::limit_surface::LimitSurface;
use tribos_core::real::Real;
use tribos_tests::contacts::size;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

fn number<R: Real>(row: &Row, column: &str) -> R {
    R::from_f64(row.number(column))
}

fn vector<R: Real>(row: &Row, name: &str) -> Vector3<R> {
    Vector3::from(["x", "y", "z"].map(|axis| number(row, &format!("{name}{axis}"))))
}

fn sphere<R: Real>(row: &Row, index: u32) -> Sphere<R> {
    Sphere {
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

/// The error of one row, of all its impulses, P, the momentum that meets and, at an open gap,
/// the momentum that would take the spheres through each other.
fn error<R: Real, F: ContactFriction<R>>(row: &Row, friction: &F) -> f64 {
    let radii = [number(row, "r1"), number(row, "r2")];
    let touch = Touch::spheres(&vector(row, "d"), radii).unwrap();
    let (mut a, mut b) = (sphere(row, 1), sphere(row, 2));
    // An open gap is known to the rounding of the distance.
    let open = touch.gap > R::ZERO;
    let [arm_a, arm_b] = touch.arms.map(R::to_f64);
    let closing = f64::from(open) * (arm_a + arm_b) / row.number("dt");
    let met = (b.velocity - a.velocity).map(R::to_f64).norm() + closing;
    let mut contact = Contact::new(&touch, &law(row), &a, &b, number(row, "dt"));
    contact.update(friction, &mut a, &mut b);
    let wanted = Modal::<R, F::Modes>::new(
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
    kind: &str,
    friction: impl Fn(&Row) -> F,
) -> Worst {
    let mut worst = Worst::of(name);
    let table = Table::read("contacts.csv");
    for (number, row) in table.rows().enumerate() {
        if row.text("kind") == kind {
            let error = error::<R, F>(&row, &friction(&row));
            worst.see(error, || format!("row {number}, {}", row.text("case")));
        }
    }
    worst
}

fn thresholds<R: Real>(row: &Row) -> Thresholds<R, AllModes> {
    let [mu, mu_rolling, mu_torsion] = ["mu", "mu_t", "mu_n"].map(|name| number(row, name));
    Thresholds::all(mu, mu_rolling, mu_torsion).unwrap()
}

fn exact<R: Real>(row: &Row) -> CoupledFriction<R, LimitSurface<R, Coulomb>, SlidingTorsion> {
    let set = LimitSurface::new(Coulomb, number(row, "mu"), number(row, "mu_n")).unwrap();
    CoupledFriction::sliding_torsion(set)
}

#[test]
fn sliding_and_rolling_of_unequal_spheres_are_solved_together() {
    let worst = worst::<f64, _>("contact of unequal spheres", "thresholds", thresholds);
    worst.assert_within(&tolerance::CONTACT);
}

#[test]
fn sliding_and_torsion_meet_the_exact_set() {
    let worst = worst::<f64, _>("contact, coupled torsion", "coupled", exact);
    worst.assert_within(&tolerance::CONTACT);
}

#[test]
fn single_precision_keeps_its_digits() {
    let name = "contact of unequal spheres, f32";
    worst::<f32, _>(name, "thresholds", thresholds).assert_within(&tolerance::CONTACT_SINGLE);
    let name = "contact, coupled torsion, f32";
    worst::<f32, _>(name, "coupled", exact).assert_within(&tolerance::CONTACT_SINGLE);
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
