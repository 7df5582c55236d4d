//! Bits of the friction of contact manifolds, one at a time: lanes have the same ones.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, signed, speed, unit};
use tribos_core::manifold_friction::{
    AnisotropicFriction, DirectionalLimitCurve, FrictionImpulse, FrictionLimits,
    InverseEffectiveMasses, IsotropicLimitCurve, Lanes, LimitCurve, ManifoldArea,
    manifold_friction_in, project_friction, project_rolling,
};
use tribos_core::real::Real;

/// Manifolds per precision.
const MANIFOLDS: usize = 2000;

/// Digest of manifold friction, f64 and f32.
pub fn manifold_friction_bits() -> u64 {
    in_both(manifolds_of::<f64>, manifolds_of::<f32>)
}

fn impulse<R: Real>(hash: &mut Fnv, carried: &FrictionImpulse<R>) {
    hash.numbers([
        carried.tangential[0],
        carried.tangential[1],
        carried.angular,
    ]);
}

/// An area of up to six corners, lines and points among them.
fn area<R: Real>(rng: &mut Lcg) -> ManifoldArea<R> {
    let mut corners = [[R::ZERO; 2]; 6];
    let count = (rng.bits() % 7) as usize;
    for corner in &mut corners[..count] {
        *corner = [unit(rng), unit(rng)];
    }
    ManifoldArea::of_corners(&corners[..count])
}

fn manifolds_of<R: Real + Lanes>(hash: &mut Fnv) {
    let mut rng = Lcg::new(61);
    let compact = [
        IsotropicLimitCurve::area(),
        IsotropicLimitCurve::points(),
        IsotropicLimitCurve::ellipsoid(),
    ];
    for n in 0..MANIFOLDS {
        let area = area::<R>(&mut rng);
        let DirectionalLimitCurve { spinning, slipping } = area.outline;
        hash.numbers([area.centre[0], area.centre[1], area.torsion_radius]);
        hash.numbers(spinning.into_iter().chain(slipping));
        let candidate = FrictionImpulse {
            tangential: [signed(&mut rng), signed(&mut rng)],
            angular: signed(&mut rng),
        };
        let budget = FrictionLimits {
            impulse: speed(&mut rng),
            torsion_radius: if n % 5 == 0 {
                area.torsion_radius
            } else {
                unit(&mut rng)
            },
            dynamic_over_static: if n % 3 == 0 { R::HALF } else { R::ONE },
        };
        let inverse = InverseEffectiveMasses {
            tangential: unit(&mut rng),
            angular: speed(&mut rng),
        };
        for outline in &compact {
            impulse(
                hash,
                &project_friction(&candidate, &budget, &inverse, outline),
            );
            impulse(
                hash,
                &manifold_friction_in::<1, _, _>(&candidate, &budget, &inverse, outline),
            );
            hash.feed(u64::from(<IsotropicLimitCurve<R> as LimitCurve<R>>::TURNS));
        }
        impulse(
            hash,
            &project_friction(&candidate, &budget, &inverse, &area.outline),
        );
        impulse(
            hash,
            &manifold_friction_in::<5, _, _>(&candidate, &budget, &inverse, &area.outline),
        );
        hash.numbers(project_rolling(candidate.tangential, budget.impulse));
        let grooved = AnisotropicFriction::new([unit(&mut rng), unit(&mut rng)]);
        hash.number(grooved.largest());
        let velocity = [signed(&mut rng), signed(&mut rng)];
        let stretched = grooved.candidate(&candidate, velocity, signed(&mut rng), &inverse);
        impulse(hash, &stretched);
        impulse(hash, &grooved.unstretched(&stretched));
    }
}
