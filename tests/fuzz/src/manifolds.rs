//! Friction of contact manifolds.

use super::Source;
use super::check::{Broken, finite, holds};
use tribos_core::manifold_friction::{
    AnisotropicFriction, FrictionImpulse, FrictionLimits, InverseEffectiveMasses,
    IsotropicLimitCurve, Lanes, LimitCurve, ManifoldArea, manifold_friction_in, project_friction,
    project_rolling,
};
use tribos_core::real::Real;

/// One manifold.
pub fn manifold(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        of::<f64>(source)
    } else {
        of::<f32>(source)
    }
}

fn of<R: Real + Lanes>(source: &mut Source) -> Result<(), Broken> {
    let mut corners = [[R::ZERO; 2]; 5];
    let count = source.below(6);
    for corner in &mut corners[..count] {
        *corner = [source.number(), source.number()];
    }
    let area = ManifoldArea::of_corners(&corners[..count]);
    let candidate = FrictionImpulse {
        tangential: [source.number(), source.number()],
        angular: source.number(),
    };
    let budget = FrictionLimits {
        impulse: source.size(),
        torsion_radius: source.size(),
        dynamic_over_static: if source.one_in(2) {
            R::ONE
        } else {
            R::HALF + R::HALF * source.unit::<R>()
        },
    };
    let inverse = InverseEffectiveMasses {
        tangential: source.positive(),
        angular: source.size(),
    };
    for outline in [
        IsotropicLimitCurve::area(),
        IsotropicLimitCurve::points(),
        IsotropicLimitCurve::ellipsoid(),
    ] {
        carried(source, &candidate, &budget, &inverse, &outline)?;
    }
    // Corners may cross: the outline of nothing, but its friction stays within the limits.
    let outline = area
        .outline
        .spinning
        .into_iter()
        .chain(area.outline.slipping);
    if outline.into_iter().all(|x| x.is_finite()) {
        carried(source, &candidate, &budget, &inverse, &area.outline)?;
    }
    let _ = manifold_friction_in::<1, _, _>(&candidate, &budget, &inverse, &area.outline);
    let rolling = project_rolling(candidate.tangential, budget.impulse);
    finite(source, "rolling impulse", rolling)?;
    let grooved = AnisotropicFriction::new([source.positive(), source.positive()]);
    finite(source, "larger coefficient", [grooved.largest()])?;
    let velocity = [source.number(), source.number()];
    let stretched = grooved.candidate(&candidate, velocity, source.number(), &inverse);
    let back = grooved.unstretched(&stretched);
    finite(
        source,
        "stretched impulse",
        [stretched.tangential, back.tangential].concat(),
    )
}

/// Friction is within both limits and, if they bind, does not exceed the candidate.
fn carried<R: Real + Lanes, O: LimitCurve<R>>(
    source: &Source,
    candidate: &FrictionImpulse<R>,
    budget: &FrictionLimits<R>,
    inverse: &InverseEffectiveMasses<R>,
    outline: &O,
) -> Result<(), Broken> {
    let friction = project_friction(candidate, budget, inverse, outline);
    let [x, y] = friction.tangential;
    if !source.is_mild() {
        return Ok(());
    }
    finite(source, "friction impulse", [x, y, friction.angular])?;
    let rounding = R::ONE + R::from_f64(64.0) * R::EPSILON;
    let norm = |[x, y]: [R; 2]| x.hypot(y);
    let (force, before) = (norm([x, y]), norm(candidate.tangential));
    let held = budget.impulse / budget.dynamic_over_static;
    let numbers = [
        force,
        before,
        budget.impulse,
        friction.angular,
        candidate.angular,
        budget.torsion_radius,
        budget.dynamic_over_static,
    ];
    holds(force <= held * rounding, "force within its limit", &numbers)?;
    holds(
        force <= before * rounding,
        "force within the candidate",
        &numbers,
    )?;
    let (twist, before) = (Real::abs(friction.angular), Real::abs(candidate.angular));
    holds(
        twist <= held * budget.torsion_radius * rounding,
        "twist within its limit",
        &numbers,
    )?;
    holds(twist <= before, "twist within the candidate", &numbers)
}
