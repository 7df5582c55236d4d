//! Friction of contact manifolds.

use crate::{Input, Verdict};
use tribos_core::manifold_friction::{
    AnisotropicFriction, DirectionalLimitCurve, FrictionImpulse, FrictionLimits,
    InverseEffectiveMasses, IsotropicLimitCurve, Lanes, LimitCurve, ManifoldArea,
    manifold_friction_in, project_friction, project_rolling,
};
use tribos_core::real::Real;

/// One manifold.
pub fn manifold<R: Real + Lanes>(input: &mut Input<'_>) -> Verdict {
    let mut corners = [[R::ZERO; 2]; 5];
    let count = input.below(6);
    for corner in &mut corners[..count] {
        *corner = [input.number(), input.number()];
    }
    let area = ManifoldArea::of_corners(&corners[..count]);
    let candidate = FrictionImpulse {
        tangential: [input.number(), input.number()],
        angular: input.number(),
    };
    let budget = FrictionLimits {
        impulse: input.size(),
        torsion_radius: input.size(),
        dynamic_over_static: if input.one_in(2) {
            R::ONE
        } else {
            R::HALF + R::HALF * input.unit::<R>()
        },
    };
    let inverse = InverseEffectiveMasses {
        tangential: input.positive(),
        angular: input.size(),
    };
    input.give(area.centre);
    input.give([area.torsion_radius]);
    let DirectionalLimitCurve { spinning, slipping } = area.outline;
    let outline = spinning.into_iter().chain(slipping);
    input.give(outline.clone());
    for outline in [
        IsotropicLimitCurve::area(),
        IsotropicLimitCurve::points(),
        IsotropicLimitCurve::ellipsoid(),
    ] {
        carried(input, &candidate, &budget, &inverse, &outline)?;
    }
    // Corners may cross: the outline of nothing, but its friction stays within the limits.
    if outline.clone().all(|x| x.is_finite()) {
        carried(input, &candidate, &budget, &inverse, &area.outline)?;
    }
    let in_steps = manifold_friction_in::<5, _, _>(&candidate, &budget, &inverse, &area.outline);
    input.give(parts(&in_steps));
    let rolling = project_rolling(candidate.tangential, budget.impulse);
    input.finite("rolling impulse", rolling)?;
    let grooved = AnisotropicFriction::new([input.positive(), input.positive()]);
    input.finite("larger coefficient", [grooved.largest()])?;
    let velocity = [input.number(), input.number()];
    let stretched = grooved.candidate(&candidate, velocity, input.number(), &inverse);
    let back = grooved.unstretched(&stretched);
    input.give([stretched.angular, back.angular]);
    let [[x, y], [z, w]] = [stretched.tangential, back.tangential];
    input.finite("stretched impulse", [x, y, z, w])
}

fn parts<R: Real>(impulse: &FrictionImpulse<R>) -> [R; 3] {
    let [x, y] = impulse.tangential;
    [x, y, impulse.angular]
}

/// Friction is within both limits and, if they bind, does not exceed the candidate.
fn carried<R: Real + Lanes, O: LimitCurve<R>>(
    input: &mut Input<'_>,
    candidate: &FrictionImpulse<R>,
    budget: &FrictionLimits<R>,
    inverse: &InverseEffectiveMasses<R>,
    outline: &O,
) -> Verdict {
    let friction = project_friction(candidate, budget, inverse, outline);
    let one_step = manifold_friction_in::<1, _, _>(candidate, budget, inverse, outline);
    input.give(parts(&one_step));
    input.give_bits(u64::from(O::TURNS));
    input.finite("friction impulse", parts(&friction))?;
    if !input.is_mild() {
        return Ok(());
    }
    let rounding = R::ONE + R::from_f64(64.0) * R::EPSILON;
    let norm = |[x, y]: [R; 2]| x.hypot(y);
    let (force, before) = (norm(friction.tangential), norm(candidate.tangential));
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
    input.holds(force <= held * rounding, "force within its limit", &numbers)?;
    input.holds(
        force <= before * rounding,
        "force within the candidate",
        &numbers,
    )?;
    let (twist, before) = (Real::abs(friction.angular), Real::abs(candidate.angular));
    input.holds(
        twist <= held * budget.torsion_radius * rounding,
        "twist within its limit",
        &numbers,
    )?;
    input.holds(twist <= before, "twist within the candidate", &numbers)
}
