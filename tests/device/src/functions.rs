//! The functions of the list: what the numbers of a row are, and the kernel's call. Units are SI.

use tribos_core::Real;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::limit_surface::{
    FrictionSet, Projection, Region, RoundLimitSurface, ShapeLimitSurface,
};
use tribos_core::manifold_friction::{
    FrictionImpulse, FrictionLimits, InverseEffectiveMasses, IsotropicLimitCurve, Lanes,
    LimitCurve, ManifoldArea, project_friction,
};
use tribos_core::patch::outline::Polygon;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// Coefficient, radius, load, twist → wrench.
fn round<R: Real, C: ReducedFriction<R>>(coupling: C, row: [R; 6]) -> [R; 3] {
    let [coefficient, radius, load, x, y, spin] = row;
    match RoundFriction::new(coupling, coefficient, radius) {
        Ok(friction) => components(&friction.wrench(load, &Twist::new(x, y, spin))),
        Err(_) => [R::NAN; 3],
    }
}

macro_rules! rounds {
    ($($name:ident $coupling:ident)*) => {
        $(pub(crate) fn $name<R: Real>(row: [R; 6]) -> [R; 3] {
            round($coupling, row)
        })*
    };
}
rounds!(disk CoulombDisk ring CoulombRing punch CoulombPunch hertz CoulombHertz paraboloid CoulombParaboloid);

/// Coefficient, load, twist, four corners → wrench.
pub(crate) fn polygon<R: Real>(row: [R; 13]) -> [R; 3] {
    let [coefficient, load, x, y, spin, corners @ ..] = row;
    let Ok(patch) = Polygon::new(places(corners)) else {
        return [R::NAN; 3];
    };
    match ShapeFriction::new(patch, coefficient) {
        Ok(friction) => components(&friction.wrench(load, &Twist::new(x, y, spin))),
        Err(_) => [R::NAN; 3],
    }
}

/// Force limit, length of the metric, wrench, four corners → the polygon's wrench nearest to it.
pub(crate) fn polygon_project<R: Real>(row: [R; 13]) -> [R; 3] {
    let [limit, length, x, y, torque, corners @ ..] = row;
    let Ok(patch) = Polygon::new(places(corners)) else {
        return [R::NAN; 3];
    };
    match ShapeLimitSurface::new(patch, limit) {
        Ok(set) => components(
            &set.project_with_length(&Wrench::new(x, y, torque), length)
                .wrench,
        ),
        Err(_) => [R::NAN; 3],
    }
}

/// Force limit, radius, length of the metric, wrench → the disk's wrench nearest to it and the motion, zero inside.
pub(crate) fn project<R: Real>(row: [R; 6]) -> [R; 6] {
    let [limit, radius, length, x, y, torque] = row;
    let Ok(set) = RoundLimitSurface::new(CoulombDisk, limit, radius) else {
        return [R::NAN; 6];
    };
    let Projection { wrench, region } = set.project_with_length(&Wrench::new(x, y, torque), length);
    let normal = match region {
        Region::OnSurface { normal } => normal,
        _ => Twist::ZERO,
    };
    let [x, y, torque] = components(&wrench);
    let [u, v] = normal.velocity.into();
    [x, y, torque, u, v, normal.spin]
}

/// Force limit, radius, mass, moment of inertia, time step, twist, push → twist, friction, 1 at rest, of a disk.
pub(crate) fn step<R: Real>(row: [R; 11]) -> [R; 7] {
    let [limit, radius, mass, inertia, dt, motion @ ..] = row;
    let [x, y, spin, push @ ..] = motion;
    let (set, body, dt) = (
        RoundLimitSurface::new(CoulombDisk, limit, radius),
        PlanarBody::new(mass, inertia),
        TimeStep::new(dt),
    );
    let (Ok(set), Ok(body), Ok(dt)) = (set, body, dt) else {
        return [R::NAN; 7];
    };
    let push = Wrench::new(push[0], push[1], push[2]);
    let after = body.step(&set, &Twist::new(x, y, spin), &push, dt);
    let (twist, [x, y, torque]) = (after.twist, components(&after.friction));
    let [u, v] = twist.velocity.into();
    let rest = if after.is_at_rest { R::ONE } else { R::ZERO };
    [u, v, twist.spin, x, y, torque, rest]
}

/// Candidate, limit, mean lever, dynamic over static, inverse masses → the impulse of a compact area.
pub(crate) fn manifold<R: Real + Lanes>(row: [R; 8]) -> [R; 3] {
    let [x, y, angular, impulse, lever, ratio, k, kt] = row;
    impulses(
        [x, y, angular],
        [impulse, lever, ratio],
        [k, kt],
        &IsotropicLimitCurve::area(),
    )
}

/// Candidate, limit, dynamic over static, inverse masses, four corners → the impulse of their area.
pub(crate) fn plank<R: Real + Lanes>(row: [R; 15]) -> [R; 3] {
    let [x, y, angular, impulse, ratio, k, kt, corners @ ..] = row;
    let area = ManifoldArea::of_corners(&places(corners));
    let limits = [impulse, area.torsion_radius, ratio];
    impulses([x, y, angular], limits, [k, kt], &area.outline)
}

fn impulses<R: Lanes, O: LimitCurve<R>>(
    [x, y, angular]: [R; 3],
    [impulse, torsion_radius, dynamic_over_static]: [R; 3],
    [k, kt]: [R; 2],
    outline: &O,
) -> [R; 3] {
    let carried = project_friction(
        &FrictionImpulse {
            tangential: [x, y],
            angular,
        },
        &FrictionLimits {
            impulse,
            torsion_radius,
            dynamic_over_static,
        },
        &InverseEffectiveMasses {
            tangential: k,
            angular: kt,
        },
        outline,
    );
    let [x, y] = carried.tangential;
    [x, y, carried.angular]
}

fn components<R: Real>(wrench: &Wrench<R>) -> [R; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

fn places<R: Copy>([ax, ay, bx, by, cx, cy, dx, dy]: [R; 8]) -> [[R; 2]; 4] {
    [[ax, ay], [bx, by], [cx, cy], [dx, dy]]
}
