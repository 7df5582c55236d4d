//! Bits of the laws of a surface element, in motion and at rest.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, speed, unit};
use tribos_core::law::{
    Age, Ageing, BowdenTabor, CoulombLaw, DragRegime, DryFriction, GreenwoodWilliamson, Grip,
    HertzSphere, Incline, InertialDrag, LawError, LocalLaw, Plastic, PlateauPower,
    PlateauPowerParameters, PowerLaw, RealArea, Savkoor, SavkoorParameters, Stokes, Stribeck,
    StribeckParameters, critical_angle, crossover_reynolds, reynolds,
};
use tribos_core::real::Real;

/// Digest of friction against speed, f64 and f32.
pub fn moving() -> u64 {
    in_both(moving_of::<f64>, moving_of::<f32>)
}

fn moving_of<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let dry = DryFriction::new(real(0.5), real(0.25)).expect("in range");
    let coulomb = CoulombLaw::new(real(0.375)).expect("in range");
    hash.numbers([dry.mu_static(), dry.mu_dynamic(), coulomb.mu()]);
    local(hash, &dry);
    local(hash, &coulomb);
    for alpha in [-0.5, 0.0, 1.0, 1.75] {
        let power = PowerLaw::new(real(alpha), real(0.3)).expect("in range");
        hash.numbers([power.alpha(), power.coefficient()]);
        hash.feed(u64::from(power.is_convex()));
        local(hash, &power);
    }
    for exponent in [0.5, 1.0, 2.0] {
        let law = Stribeck::new(StribeckParameters {
            dry,
            speed: real(0.125),
            exponent: real(exponent),
            viscous: real(0.0625),
        })
        .expect("in range");
        hash.maybe(law.minimum());
        local(hash, &law);
        for v in ends() {
            hash.numbers([law.boundary(v), law.hydrodynamic(v)]);
        }
    }
    let ice = PlateauPower::new(PlateauPowerParameters {
        alpha: real(-0.5),
        coefficient: real(0.008),
        plateau_speed: real(1e-4),
        drop_speed: real(1e-7),
        rest_share: R::HALF,
    });
    local(hash, &ice.expect("in range"));
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&DryFriction::new(x, y));
        hash.verdict(&PowerLaw::new(x, y));
        hash.verdict(&Stribeck::new(StribeckParameters {
            dry,
            speed: x,
            exponent: R::ONE,
            viscous: y,
        }));
    }
}

/// Digest of rubber, f64 and f32.
pub fn rubber() -> u64 {
    in_both(rubber_of::<f64>, rubber_of::<f32>)
}

fn rubber_of<R: Real>(hash: &mut Fnv) {
    let tread = |speed, narrowness| {
        Savkoor::new(SavkoorParameters {
            mu_base: R::from_f64(0.625),
            mu_max: R::from_f64(1.25),
            speed,
            narrowness,
        })
    };
    for narrowness in [0.375, 2.0] {
        let law = tread(R::HALF, R::from_f64(narrowness));
        local(hash, &law.expect("in range"));
    }
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&tread(x, y));
    }
}

/// Friction and slope at speeds of all sizes.
pub(crate) fn local<R: Real, L: LocalLaw<R>>(hash: &mut Fnv, law: &L) {
    let mut rng = Lcg::new(73);
    let mut at = |v| hash.numbers([law.friction(v), law.slope(v)]);
    for _ in 0..200 {
        at(speed(&mut rng));
    }
    ends().into_iter().for_each(&mut at);
}

/// Digest of starting, ageing, inclines, drag and real contact areas, f64 and f32.
pub fn resting() -> u64 {
    let mut hash = Fnv::new();
    starting::<f64>(&mut hash);
    starting::<f32>(&mut hash);
    drag::<f64>(&mut hash);
    drag::<f32>(&mut hash);
    areas::<f64>(&mut hash);
    areas::<f32>(&mut hash);
    hash.0
}

fn starting<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let dry = DryFriction::new(real(0.5), real(0.25)).expect("in range");
    let ageing = Ageing::new(real(0.4), real(0.02), real(0.125)).expect("in range");
    let mut rng = Lcg::new(79);
    let mut age = Age { time: R::ZERO };
    for _ in 0..400 {
        let drive = unit::<R>(&mut rng) - R::HALF;
        let grip = ageing.at_rest(age, drive);
        age = age.advance(speed(&mut rng), grip);
        hash.feed(u64::from(grip == Grip::Slip));
        hash.feed(u64::from(dry.at_rest(drive) == Grip::Stick));
        hash.numbers([age.time, ageing.mu_static(age), ageing.rate(age)]);
        hash.number(dry.net_drive(drive));
        let slope = Incline::new(unit(&mut rng), R::ONE).expect("a slope");
        hash.numbers([slope.angle(), slope.drive_per_load()]);
        hash.number(slope.acceleration_at_rest(&dry, real(9.81)));
        let v = speed(&mut rng);
        hash.number(slope.acceleration_downhill(&dry, real(9.81), v));
        hash.number(slope.acceleration_uphill(&dry, real(9.81), v));
        hash.number(critical_angle(v));
    }
    for x in ends::<R>() {
        let age = Age { time: x };
        hash.numbers([ageing.mu_static(age), ageing.rate(age), critical_angle(x)]);
        hash.feed(u64::from(ageing.at_rest(age, x) == Grip::Slip));
        hash.number(dry.net_drive(x));
        hash.number(age.advance(x, Grip::Stick).time);
    }
    for (x, y) in pairs_of_ends::<R>() {
        let slope = Incline::new(x, y);
        hash.verdict(&slope);
        hash.maybe(slope.ok().map(|slope| slope.angle()));
        hash.verdict(&Ageing::new(x, y, R::ONE));
    }
}

fn drag<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let viscous = Stokes::new(real(1e-3), real(0.01)).expect("in range");
    let inertial = InertialDrag::new(real(0.2), real(1000.0), real(0.01)).expect("in range");
    let mut rng = Lcg::new(83);
    let mut at = |v: R| {
        hash.numbers([viscous.force(v), viscous.slope(v)]);
        hash.numbers([inertial.force(v), inertial.slope(v)]);
        let number = reynolds(real(1000.0), v, real(0.01), real(1e-3));
        hash.numbers([number, crossover_reynolds(v)]);
        let regime = DragRegime::at(number, real(0.2));
        hash.feed(regime.map_or(2, |regime| u64::from(regime == DragRegime::Viscous)));
    };
    for _ in 0..200 {
        at(speed(&mut rng));
    }
    ends().into_iter().for_each(&mut at);
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&Stokes::new(x, y));
        hash.verdict(&InertialDrag::new(x, y, R::ONE));
    }
}

fn areas<R: Real>(hash: &mut Fnv) {
    let real = R::from_f64;
    let plastic = Plastic::new(real(1e9)).expect("in range");
    let sphere = HertzSphere::new(real(0.01), real(1e11)).expect("in range");
    let rough = GreenwoodWilliamson::new(real(1e-6), real(1e-4), real(1e11)).expect("in range");
    hash.numbers([plastic.hardness(), rough.mean_pressure()]);
    hash.number(rough.junction_area());
    hash.numbers([real(3.0), real(1e-9)].map(|load| sphere.contact_radius(load)));
    adhesion(hash, plastic);
    adhesion(hash, sphere);
    adhesion(hash, rough);
    let junctions = BowdenTabor::new(real(3e8), plastic).expect("in range");
    hash.maybe(junctions.coulomb().ok().map(|law| law.mu()));
    for (x, y) in pairs_of_ends::<R>() {
        hash.verdict(&HertzSphere::new(x, y));
        hash.verdict(&GreenwoodWilliamson::new(x, y, R::ONE));
        let soft: Result<_, LawError> = Plastic::new(x);
        let law = soft.and_then(|soft| BowdenTabor::new(y, soft));
        hash.verdict(&law.and_then(|law| law.coulomb()));
    }
}

fn adhesion<R: Real, A: RealArea<R> + Copy>(hash: &mut Fnv, contact: A) {
    let law = BowdenTabor::new(R::from_f64(3e8), contact).expect("in range");
    hash.numbers([law.shear_strength(), law.contact().area(R::ONE)]);
    let mut rng = Lcg::new(89);
    let mut at = |load: R| {
        hash.numbers([contact.area(load), contact.slope(load)]);
        hash.numbers([contact.area_per_load(load), law.force(load)]);
        hash.numbers([law.slope(load), law.effective_coefficient(load)]);
    };
    for _ in 0..120 {
        at(speed(&mut rng));
    }
    ends().into_iter().for_each(&mut at);
}
