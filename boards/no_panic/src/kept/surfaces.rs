//! Limit surfaces.

use super::{Keeper, keep};
use tribos_core::Real;
use tribos_core::coupling::table::CoulombTable;
use tribos_core::coupling::{DryCoupling, closed, compact, table};
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};

/// Sets of one precision.
pub fn all<R: CoulombTable>(keeper: &mut impl Keeper) {
    exact::<R, table::Coulomb>(keeper);
    exact::<R, compact::CompactCoulomb>(keeper);
    exact::<R, closed::Ring>(keeper);
    keep!(keeper: Ellipsoid::<R>::new, Ellipsoid::<R>::torque_limit);
    set::<R, Ellipsoid<R>>(keeper);
}

fn exact<R: Real, C: DryCoupling<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        LimitSurface::<R, C>::new,
        LimitSurface::<R, C>::coupling,
        LimitSurface::<R, C>::torque_limit,
        LimitSurface::<R, C>::ellipsoid,
    );
    set::<R, LimitSurface<R, C>>(keeper);
}

fn set<R: Real, S: FrictionSet<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <S as FrictionSet<R>>::force_limit,
        <S as FrictionSet<R>>::radius,
        <S as FrictionSet<R>>::support,
        <S as FrictionSet<R>>::wrench,
        <S as FrictionSet<R>>::gauge,
        <S as FrictionSet<R>>::twist_normal_to,
        <S as FrictionSet<R>>::scale_to_surface,
        <S as FrictionSet<R>>::project_with_length,
        <S as FrictionSet<R>>::project,
        <S as FrictionSet<R>>::twist_resisted_by,
        <S as FrictionSet<R>>::contains,
    );
}
