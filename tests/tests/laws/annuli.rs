//! Annuli of every width: their factors and their limit surfaces are consistent.
use tribos_core::Real;
use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::coupling::{
    Annulus, DryReducedFriction, PowerLawFriction, ReducedFriction, compact, coulomb,
};
use tribos_core::internals::Speeds;
use tribos_core::limit_surface::{FrictionSet, Projection, RoundLimitSurface};
use tribos_core::twist::Wrench;
use tribos_tests::surfaces::{FORCE_LIMIT, RADIUS, random_wrench};
use tribos_tests::sweep::Lcg;

/// Inner over outer radius; the wrench is a mean over rings above 15/16.
const RATIOS: [f64; 10] = [
    0.0, 0.5, 0.9, 0.937, 0.938, 0.95, 0.99, 0.999, 0.9999, 0.999_999,
];

#[test]
fn factors_of_thin_bands_make_their_wrenches() {
    let mut rng = Lcg::new(46);
    for alpha in [-0.5, 0.0, 0.5, 1.0, 3.0] {
        let disk = compact::CompactPower::new(alpha).expect("in range");
        for inner in RATIOS {
            let band = Annulus::new(disk, inner).expect("in range");
            for _ in 0..200 {
                let near = rng.between(0.9, 1.1);
                let ratio = if rng.unit() < 0.5 {
                    near
                } else {
                    rng.log_between(1e-9, 1e9)
                };
                let wrench = band.reduced_wrench(ratio, 1.0);
                let [phi, chi] = band.factors(&Speeds::new(ratio, 1.0));
                let scale = ratio.max(1.0).powf(alpha - 1.0);
                let bound = 2e-14 * (2.0 / (1.0 - inner)).min(32.0);
                for (got, wanted) in [
                    (scale * ratio * phi, wrench.force),
                    (scale * chi, wrench.torque),
                ] {
                    let error = (got / wanted - 1.0).abs();
                    assert!(
                        error <= bound,
                        "k {inner}, alpha {alpha}, eps {ratio:e}: {error:e}"
                    );
                }
            }
        }
    }
}

/// How many of 10,000 wrenches a second projection moves or finds beyond the surface.
fn moved<R: Real, C: DryReducedFriction<R>>(disk: C, inner: f64) -> u32 {
    let band = Annulus::new(disk, R::from_f64(inner)).expect("in range");
    let [force, radius] = [FORCE_LIMIT, RADIUS].map(R::from_f64);
    let set = RoundLimitSurface::new(band, force, radius).expect("in range");
    let mut rng = Lcg::new(47);
    let mut count = 0;
    for n in 0..10_000 {
        let size = match n % 2 {
            0 => rng.between(0.5, 3.0),
            _ => rng.log_between(0.5, 1e4),
        };
        let Wrench { force, torque } = random_wrench(&mut rng, size);
        let given = Wrench::new(
            R::from_f64(force.x),
            R::from_f64(force.y),
            R::from_f64(torque),
        );
        let once = set.project(&given).wrench;
        count += u32::from(set.project(&once).wrench != once || !set.contains(&once));
    }
    count
}

#[test]
fn projecting_again_moves_no_wrench() {
    for inner in RATIOS {
        let counts = [
            moved::<f64, _>(coulomb::CoulombDisk, inner),
            moved::<f32, _>(coulomb::CoulombDisk, inner),
        ];
        assert_eq!(counts, [0; 2], "k {inner}: f64 and f32");
    }
}

/// The distance of a projection to the projection by the ring itself, of the limits.
fn off_the_ring<R: Real>(inner: f64) -> f64
where
    coulomb::CoulombDisk: DryReducedFriction<R>,
{
    let [force, radius] = [FORCE_LIMIT, RADIUS].map(R::from_f64);
    let band = Annulus::new(coulomb::CoulombDisk, R::from_f64(inner)).expect("in range");
    let band = RoundLimitSurface::new(band, force, radius).expect("in range");
    let ring = RoundLimitSurface::<f64, _>::new(CoulombRing, FORCE_LIMIT, RADIUS);
    let ring = ring.expect("in range");
    let mut rng = Lcg::new(48);
    let mut worst = 0.0_f64;
    for _ in 0..10_000 {
        let size = rng.between(0.5, 3.0);
        let given = random_wrench(&mut rng, size);
        let [x, y, torque] = [given.force.x, given.force.y, given.torque].map(R::from_f64);
        let near: Projection<R> = band.project(&Wrench::new(x, y, torque));
        let wanted = ring.project(&given).wrench;
        let across = (near.wrench.force.x.to_f64() - wanted.force.x)
            .hypot(near.wrench.force.y.to_f64() - wanted.force.y);
        let around = (near.wrench.torque.to_f64() - wanted.torque) / RADIUS;
        worst = worst.max(across.hypot(around) / FORCE_LIMIT);
    }
    worst
}

#[test]
fn thin_bands_project_as_the_ring_does() {
    for inner in [0.999, 0.9999, 0.999_999] {
        // Half a width, the change of the mean radius, and rounding.
        let width = 1.0 - inner;
        let (wide, narrow) = (off_the_ring::<f64>(inner), off_the_ring::<f32>(inner));
        println!("k {inner}: f64 {wide:e}, f32 {narrow:e}");
        // In f32 a step of the search is right to the digits of the slopes.
        assert!(
            wide <= width && narrow <= width + 3e-5,
            "k {inner}: {wide:e}, {narrow:e}"
        );
    }
}
