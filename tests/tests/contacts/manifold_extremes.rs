//! Manifolds in all units and at all sizes: the same bits, or numbers that say that there is no answer.

use nalgebra::Vector3;
use tribos_core::Real;
use tribos_core::contact::{
    Attraction, Cohesion, ContactBody, ContactFriction, ContactGeometry, CoupledFriction,
    IndependentFriction, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::coupling::DryReducedFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::RoundLimitSurface;
use tribos_core::manifold::{ContactSystem, InitialGuess, SolverReport, SolverSettings};
use tribos_tests::sweep::Lcg;

const BALLS: usize = 3;

/// Exponents of two of the units of mass, length and time.
#[derive(Clone, Copy, Debug, Default)]
struct Units {
    mass: i32,
    length: i32,
    time: i32,
}

impl Units {
    /// A quantity of the dimension mass^m length^l time^t in these units.
    fn of<R: Real>(self, [m, l, t]: [i32; 3], x: f64) -> R {
        let exponent = m * self.mass + l * self.length + t * self.time;
        // Two factors: 2^exponent alone may be out of range where the product is not.
        let half = exponent / 2;
        R::from_f64(x)
            * R::from_f64(2.0_f64.powi(half))
            * R::from_f64(2.0_f64.powi(exponent - half))
    }

    fn vector<R: Real>(self, dimension: [i32; 3], v: [f64; 3]) -> Vector3<R> {
        Vector3::from(v.map(|x| self.of(dimension, x)))
    }
}

const MASS: [i32; 3] = [1, 0, 0];
const LENGTH: [i32; 3] = [0, 1, 0];
const TIME: [i32; 3] = [0, 0, 1];
const VELOCITY: [i32; 3] = [0, 1, -1];
const SPIN: [i32; 3] = [0, 0, -1];
const ACCELERATION: [i32; 3] = [0, 1, -2];
const FORCE: [i32; 3] = [1, 1, -2];
const TORQUE: [i32; 3] = [1, 2, -2];
const IMPULSE: [i32; 3] = [1, 1, -1];
const TURN: [i32; 3] = [1, 2, -1];

/// A column of balls on a floor under a piston, in units of order 1.
#[derive(Clone, Debug)]
struct Column {
    /// Mass, radius, velocity, spin, force and torque of each ball.
    balls: [(f64, f64, [[f64; 3]; 4]); BALLS],
    gaps: [f64; BALLS + 1],
    tilts: [[f64; 2]; BALLS],
    /// Mass and push of the piston.
    piston: [f64; 2],
    gravity: [f64; 3],
    /// Strength and range.
    cohesion: [f64; 2],
    restitution: f64,
    dt: f64,
}

impl Column {
    /// `size` draws the sizes of masses, lengths and so on.
    fn random(rng: &mut Lcg, mut size: impl FnMut(&mut Lcg) -> f64) -> Self {
        let mut signed = |rng: &mut Lcg| (2.0 * rng.unit() - 1.0).signum() * size(rng);
        let mut vector = |rng: &mut Lcg| [(); 3].map(|()| signed(rng));
        let balls = [(); BALLS].map(|()| {
            let [mass, radius, _] = vector(rng).map(f64::abs);
            (mass, radius, [(); 4].map(|()| vector(rng)))
        });
        let gaps = [(); BALLS + 1].map(|()| {
            let [gap, ..] = vector(rng);
            1e-3 * gap
        });
        let tilts = [(); BALLS].map(|()| [(); 2].map(|()| rng.between(-0.5, 0.5)));
        let [piston, gravity, others] = [(); 3].map(|()| vector(rng));
        Self {
            balls,
            gaps,
            tilts,
            piston: [piston[0].abs(), -piston[1].abs()],
            gravity,
            cohesion: [0.1 * others[0].abs(), 1e-3 * others[1].abs()],
            restitution: [0.0, 0.5][usize::from(rng.unit() < 0.5)],
            dt: 1e-3 * others[2].abs(),
        }
    }

    /// Two steps of it in these units: every number of the answers with its dimension, and the
    /// reports. `None` where the geometry or a law is refused.
    fn solve<R: Real, F: ContactFriction<R>>(
        &self,
        units: Units,
        friction: F,
    ) -> Option<Answer<R>> {
        let cohesion = Cohesion::new(
            units.of(FORCE, self.cohesion[0]),
            units.of(LENGTH, self.cohesion[1]),
            Attraction::Pull,
        );
        let law = NormalLaw::new(cohesion.ok()?, R::from_f64(self.restitution)).ok()?;
        let mut column = ContactSystem::<R, F, 8, 8>::new(law, friction);
        let (zero, up) = (units.vector(VELOCITY, [0.0; 3]), [0.0, 0.0, 1.0]);
        let up = Vector3::from(up.map(R::from_f64));
        let floor = column
            .push_plate(WallBody {
                velocity: zero,
                inv_mass: R::ZERO,
            })
            .ok()?;
        let mut bodies = Vec::new();
        for (mass, radius, [velocity, spin, force, torque]) in self.balls {
            let inertia = 0.4 * mass * radius * radius;
            let ball = column.push_sphere(SphereBody {
                velocity: units.vector(VELOCITY, velocity),
                spin: units.vector(SPIN, spin),
                inv_mass: R::ONE / units.of(MASS, mass),
                inv_inertia: R::ONE / units.of([1, 2, 0], inertia),
            });
            let ball = ball.ok()?;
            let (force, torque) = (units.vector(FORCE, force), units.vector(TORQUE, torque));
            column.set_force(ball, force, torque).ok()?;
            bodies.push(ball);
        }
        let [mass, push] = self.piston;
        let piston = WallBody {
            velocity: zero,
            inv_mass: R::ONE / units.of(MASS, mass),
        };
        let piston = column.push_plate(piston).ok()?;
        column
            .set_force(piston, units.vector(FORCE, [0.0, 0.0, push]), zero)
            .ok()?;
        column.set_gravity(units.vector(ACCELERATION, self.gravity));

        let mut contacts = Vec::new();
        let length = |x: f64| units.of::<R>(LENGTH, x);
        let radius = |ball: usize| self.balls[ball].1;
        let floor_touch =
            ContactGeometry::plate(length(radius(0) + self.gaps[0]), &up, length(radius(0)));
        contacts.push(
            column
                .push_contact(bodies[0], floor, floor_touch.ok()?)
                .ok()?,
        );
        for below in 0..BALLS - 1 {
            let radii = [radius(below), radius(below + 1)];
            let apart = radii[0] + radii[1] + self.gaps[below + 1];
            let [x, y] = self.tilts[below].map(|tilt| tilt * apart);
            let z = (apart * apart - x * x - y * y).sqrt();
            let touch =
                ContactGeometry::spheres(&units.vector(LENGTH, [x, y, z]), radii.map(length));
            contacts.push(
                column
                    .push_contact(bodies[below], bodies[below + 1], touch.ok()?)
                    .ok()?,
            );
        }
        let top = ContactGeometry::plate(
            length(radius(BALLS - 1) + self.gaps[BALLS]),
            &-up,
            length(radius(BALLS - 1)),
        );
        contacts.push(
            column
                .push_contact(bodies[BALLS - 1], piston, top.ok()?)
                .ok()?,
        );
        bodies.push(piston);

        let stop = SolverSettings {
            max_iterations: 60,
            tolerance: R::from_f64(8.0) * R::EPSILON,
        };
        let mut answer = Answer {
            numbers: Vec::new(),
            reports: Vec::new(),
        };
        for (start, dt) in [
            (InitialGuess::Zero, self.dt),
            (InitialGuess::Last, 0.75 * self.dt),
        ] {
            let step = TimeStep::new(units.of(TIME, dt)).ok()?;
            answer.reports.push(column.solve(step, start, stop));
            for &body in &bodies {
                let body = column.body(body)?;
                answer.put(VELOCITY, body.velocity());
                answer.put(SPIN, body.angular_velocity());
            }
            for &contact in &contacts {
                let impulse = *column.contact(contact)?.impulse();
                let across = |x: R| Vector3::new(x, R::ZERO, R::ZERO);
                answer.put(IMPULSE, across(impulse.normal));
                answer.put(IMPULSE, impulse.sliding());
                answer.put(TURN, impulse.rolling());
                answer.put(TURN, across(impulse.torsion()));
                answer.put(FORCE, across(column.force(contact)?.normal));
            }
        }
        Some(answer)
    }
}

/// What two steps gave.
#[derive(Clone, Debug)]
struct Answer<R> {
    numbers: Vec<([i32; 3], R)>,
    reports: Vec<SolverReport<R>>,
}

impl<R: Real> Answer<R> {
    fn put(&mut self, dimension: [i32; 3], v: Vector3<R>) {
        self.numbers.extend(v.iter().map(|x| (dimension, *x)));
    }

    /// Its largest difference from the answer in units of order 1, over the largest number of the
    /// same dimension; infinite if one of them is a number and the other is not.
    fn error(&self, plain: &Self, units: Units) -> f64 {
        let wanted =
            |(dimension, x): &([i32; 3], R)| units.of::<R>(*dimension, x.to_f64()).to_f64();
        let mut worst = 0.0_f64;
        for (got, number) in self.numbers.iter().zip(&plain.numbers) {
            let same = plain
                .numbers
                .iter()
                .filter(|(dimension, _)| *dimension == number.0);
            let scale = same.map(|x| wanted(x).abs()).fold(0.0, f64::max);
            let (got, wanted) = (got.1.to_f64(), wanted(number));
            if got != wanted {
                let error = (got - wanted).abs() / scale;
                // NaN is the worst.
                worst = if error <= worst { worst } else { error };
            }
        }
        worst
    }
}

fn all<R: Real>() -> impl ContactFriction<R> {
    IndependentFriction::all(R::from_f64(0.3), R::from_f64(0.1), R::from_f64(0.05)).unwrap()
}

fn coupled<R: Real>() -> impl ContactFriction<R>
where
    CoulombDisk: DryReducedFriction<R>,
{
    let set = RoundLimitSurface::new(CoulombDisk, R::from_f64(0.3), R::from_f64(0.5)).unwrap();
    CoupledFriction::sliding_torsion(set)
}

/// Columns in units drawn by `units`, against themselves in units of order 1, to a relative error.
fn assert_same_in<R: Real>(most: f64, units: impl Fn(&mut Lcg) -> Units)
where
    CoulombDisk: DryReducedFriction<R>,
{
    let mut rng = Lcg::new(71);
    let (mut worst, mut met) = ((0.0, String::new()), 0);
    for _ in 0..1_000 {
        let column = Column::random(&mut rng, |rng| rng.log_between(0.1, 10.0));
        let units = units(&mut rng);
        let plain = Units::default();
        let pairs = [
            [plain, units].map(|units| column.solve::<R, _>(units, all())),
            [plain, units].map(|units| column.solve::<R, _>(units, coupled())),
        ];
        for [plain, scaled] in pairs {
            let (Some(plain), Some(scaled)) = (plain, scaled) else {
                panic!("{column:?} in {units:?} is refused");
            };
            assert!(
                plain.numbers.iter().all(|(_, x)| x.is_finite()),
                "{column:?}"
            );
            met += usize::from(plain.reports[0].converged);
            let mut error = scaled.error(&plain, units);
            if most == 0.0 && scaled.reports != plain.reports {
                error = f64::INFINITY;
            }
            // NaN is the worst.
            if error.is_nan() || error > worst.0 {
                worst = (error, format!("{units:?}: {plain:?} and {scaled:?}"));
            }
        }
    }
    println!("worst {:e} of {most:e}, {met} converged", worst.0);
    assert!(met > 1_000, "{met}");
    assert!(worst.0 <= most, "{:e}: {}", worst.0, worst.1);
}

/// An exponent up to `most` in size.
fn exponent(rng: &mut Lcg, most: i32) -> i32 {
    rng.between(-f64::from(most), f64::from(most)) as i32
}

/// All units at once, in which a torque and the square of each quantity are numbers.
fn moderate(most: i32) -> impl Fn(&mut Lcg) -> Units {
    move |rng| Units {
        mass: exponent(rng, most),
        length: exponent(rng, most),
        time: exponent(rng, most),
    }
}

/// One unit, as far as the quantities themselves are numbers: masses, lengths, or times.
fn far([mass, length, time]: [i32; 3]) -> impl Fn(&mut Lcg) -> Units {
    move |rng| match (3.0 * rng.unit()) as usize {
        0 => Units {
            mass: exponent(rng, mass),
            ..Units::default()
        },
        1 => Units {
            length: exponent(rng, length),
            ..Units::default()
        },
        _ => Units {
            time: exponent(rng, time),
            ..Units::default()
        },
    }
}

#[test]
fn units_do_not_change_a_bit() {
    assert_same_in::<f64>(0.0, moderate(80));
    assert_same_in::<f32>(0.0, moderate(8));
}

/// Where squares are out of range lengths and quotients are rounded in other places.
#[test]
fn extreme_masses_lengths_and_times_change_rounding_alone() {
    assert_same_in::<f64>(1e-12, far([900, 400, 400]));
    assert_same_in::<f32>(1e-4, far([90, 40, 40]));
}

/// So many columns of any sizes: what the answers are worth.
fn faults_at_any_size<R: Real, F: ContactFriction<R>>(
    columns: usize,
    decades: f64,
    friction: impl Fn() -> F,
) -> [usize; 3] {
    let mut rng = Lcg::new(72);
    let [mut refused, mut met, mut unmet] = [0; 3];
    for _ in 0..columns {
        let column = Column::random(&mut rng, |rng| {
            10.0_f64.powf(rng.between(-decades, decades))
        });
        let Some(answer) = column.solve::<R, F>(Units::default(), friction()) else {
            refused += 1;
            continue;
        };
        // Forces, and the impulses of several impacts together, may be out of range where what they
        // do to the bodies is not.
        let finite = answer.numbers.iter().all(|(dimension, x)| {
            let moves = *dimension == VELOCITY || *dimension == SPIN;
            !x.is_nan() && (x.is_finite() || !moves)
        });
        let converged = answer.reports.iter().all(|report| report.converged);
        met += usize::from(converged);
        unmet += usize::from(!converged);
        // What has no answer does not converge, and what converges is one.
        assert!(
            finite || !converged,
            "{:?}: {column:?}: {:?}",
            answer.reports,
            answer.numbers
        );
    }
    [refused, met, unmet]
}

#[test]
fn numbers_of_any_size_never_panic_and_converge_to_numbers_alone() {
    never_panic(1_000);
}

#[test]
#[ignore = "for its breadth: cargo test --release -p tribos-tests --test contacts manifold_ext -- --ignored"]
fn numbers_of_any_size_in_more_columns_never_panic_and_converge_to_numbers_alone() {
    never_panic(3_000);
}

fn never_panic(columns: usize) {
    for decades in [3.0, 30.0, 150.0, 300.0] {
        let told = [
            faults_at_any_size::<f64, _>(columns, decades, all),
            faults_at_any_size::<f64, _>(columns, decades, coupled),
        ];
        println!("f64, 1e±{decades}: refused, met, unmet {told:?}");
    }
    for decades in [3.0, 15.0, 37.0] {
        let told = [
            faults_at_any_size::<f32, _>(columns, decades, all),
            faults_at_any_size::<f32, _>(columns, decades, coupled),
        ];
        println!("f32, 1e±{decades}: refused, met, unmet {told:?}");
    }
}
