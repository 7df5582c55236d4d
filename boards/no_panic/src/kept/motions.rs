//! Modes of motion, sliders, and bodies on their patches.

use super::{Keeper, keep};
use tribos_core::Real;
use tribos_core::coupling::table::CoulombTable;
use tribos_core::coupling::{Coupling, Profile, compact, table};
use tribos_core::internals::runge_kutta::{judge, step, tolerance};
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use tribos_core::modes::{Modes, inertia_interval};
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::planar::{NodeFoot, PlanarBody};
use tribos_core::slider::{Motion, Slider};

/// Motions of one precision.
pub fn all<R: CoulombTable>(keeper: &mut impl Keeper) {
    keep!(keeper:
        inertia_interval::<R>,
        Motion::<R>::launched,
        Motion::<R>::is_at_rest,
        tolerance::<R>,
        judge::<R>,
    );
    keep!(keeper: step::<R, 3> => fn(&[R; 3], R, fn(&[R; 3]) -> [R; 3]) -> ([R; 3], [R; 3]));
    moving::<R, table::Coulomb>(keeper);
    moving::<R, compact::CompactPower<R>>(keeper);
    keep!(keeper:
        PlanarBody::<R>::new,
        PlanarBody::<R>::mass,
        PlanarBody::<R>::inertia,
        PlanarBody::<R>::gyration,
    );
    held::<R, LimitSurface<R, table::Coulomb>>(keeper);
    held::<R, Ellipsoid<R>>(keeper);
    standing::<R, NodeList<R, 12>>(keeper);
}

fn held<R: Real, S: FrictionSet<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: PlanarBody::<R>::step::<S>);
}

fn standing<R: Real, P: NodePatch<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        PlanarBody::<R>::step_on_foot::<P, 12>,
        NodeFoot::<R, P, 12>::new,
        NodeFoot::<R, P, 12>::set_force_limit,
        NodeFoot::<R, P, 12>::force_limit,
        NodeFoot::<R, P, 12>::patch,
        NodeFoot::<R, P, 12>::release,
        NodeFoot::<R, P, 12>::nearest,
    );
}

fn moving<R: Real, P: Profile<R> + Coupling<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Modes::<R, P>::new,
        Modes::<R, P>::growth,
        Modes::<R, P>::inertia_ratio_of,
        Modes::<R, P>::inertia_interval,
        Modes::<R, P>::finite_fixed_point,
        Modes::<R, P>::fixed_points,
        Modes::<R, P>::final_mode,
        Slider::<R, P>::new,
        Slider::<R, P>::energy_per_mass,
        Slider::<R, P>::dissipation_per_mass,
        Slider::<R, P>::ratio,
        Slider::<R, P>::profile,
        Slider::<R, P>::to_rest,
        Slider::<R, P>::advance,
        Slider::<R, P>::verlet_step,
    );
}
