//! Local laws.

use super::{Keeper, keep};
use tribos_core::Real;
use tribos_core::law::{
    Age, Ageing, BowdenTabor, CoulombLaw, Dieterich, DragRegime, DryFriction, Evolution,
    GreenwoodWilliamson, HertzSphere, Incline, InertialDrag, LocalLaw, LuGre, Plastic,
    PlateauPower, PowerLaw, RateState, RealArea, Ruina, SteadyLuGre, SteadyRateState, Stokes,
    Stribeck, critical_angle, crossover_reynolds, reynolds,
};

/// All laws of one precision.
pub fn all<R: Real>(keeper: &mut impl Keeper) {
    without_state::<R>(keeper);
    with_state::<R>(keeper);
    evolving::<R, Dieterich>(keeper);
    evolving::<R, Ruina>(keeper);
    areas::<R>(keeper);
    drags::<R>(keeper);
    local::<R, CoulombLaw<R>>(keeper);
    local::<R, DryFriction<R>>(keeper);
    local::<R, PowerLaw<R>>(keeper);
    local::<R, PlateauPower<R>>(keeper);
    local::<R, Stribeck<R>>(keeper);
    local::<R, SteadyLuGre<R>>(keeper);
    local::<R, SteadyRateState<R>>(keeper);
    local::<R, &Stribeck<R>>(keeper);
}

fn local<R: Real, L: LocalLaw<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: <L as LocalLaw<R>>::friction, <L as LocalLaw<R>>::slope);
}

fn without_state<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        CoulombLaw::<R>::new,
        CoulombLaw::<R>::mu,
        DryFriction::<R>::new,
        DryFriction::<R>::mu_static,
        DryFriction::<R>::mu_dynamic,
        DryFriction::<R>::at_rest,
        DryFriction::<R>::net_drive,
        PowerLaw::<R>::new,
        PowerLaw::<R>::alpha,
        PowerLaw::<R>::coefficient,
        PowerLaw::<R>::is_convex,
        PlateauPower::<R>::new,
        Stribeck::<R>::new,
        Stribeck::<R>::boundary,
        Stribeck::<R>::hydrodynamic,
        Stribeck::<R>::minimum,
        critical_angle::<R>,
        Incline::<R>::new,
        Incline::<R>::angle,
        Incline::<R>::drive_per_load,
        Incline::<R>::acceleration_at_rest,
    );
    keep!(keeper: Incline::<R>::acceleration_downhill => fn(&Incline<R>, &Stribeck<R>, R, R) -> R);
    keep!(keeper: Incline::<R>::acceleration_uphill => fn(&Incline<R>, &Stribeck<R>, R, R) -> R);
}

fn with_state<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Age::<R>::advance,
        Ageing::<R>::new,
        Ageing::<R>::mu_static,
        Ageing::<R>::rate,
        Ageing::<R>::at_rest,
        LuGre::<R>::new,
        LuGre::<R>::parameters,
        LuGre::<R>::largest_deflection,
        LuGre::<R>::steady_bristle_force,
        LuGre::<R>::steady_force,
        LuGre::<R>::rate,
        LuGre::<R>::force,
        LuGre::<R>::step,
        LuGre::<R>::passive_up_to,
        LuGre::<R>::steady_per_load,
        SteadyRateState::<R>::parameters,
        SteadyRateState::<R>::minimum,
        SteadyRateState::<R>::critical_stiffness,
        SteadyRateState::<R>::critical_stiffness_at,
    );
}

fn evolving<R: Real, E: Evolution>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <E as Evolution>::evolved::<R>,
        RateState::<R, E>::new,
        RateState::<R, E>::parameters,
        RateState::<R, E>::coefficient,
        RateState::<R, E>::slope,
        RateState::<R, E>::logarithmic,
        RateState::<R, E>::advance,
        RateState::<R, E>::steady_age,
        RateState::<R, E>::steady,
    );
}

fn areas<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Plastic::<R>::new,
        Plastic::<R>::hardness,
        HertzSphere::<R>::new,
        HertzSphere::<R>::contact_radius,
        GreenwoodWilliamson::<R>::new,
        GreenwoodWilliamson::<R>::mean_pressure,
        GreenwoodWilliamson::<R>::junction_area,
        BowdenTabor::<R, Plastic<R>>::coulomb,
    );
    area::<R, Plastic<R>>(keeper);
    area::<R, HertzSphere<R>>(keeper);
    area::<R, GreenwoodWilliamson<R>>(keeper);
}

fn area<R: Real, A: RealArea<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <A as RealArea<R>>::area,
        <A as RealArea<R>>::slope,
        <A as RealArea<R>>::area_per_load,
        BowdenTabor::<R, A>::new,
        BowdenTabor::<R, A>::shear_strength,
        BowdenTabor::<R, A>::contact,
        BowdenTabor::<R, A>::force,
        BowdenTabor::<R, A>::slope,
        BowdenTabor::<R, A>::effective_coefficient,
    );
}

fn drags<R: Real>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Stokes::<R>::new,
        Stokes::<R>::force,
        Stokes::<R>::slope,
        InertialDrag::<R>::new,
        InertialDrag::<R>::force,
        InertialDrag::<R>::slope,
        reynolds::<R>,
        crossover_reynolds::<R>,
        DragRegime::at::<R>,
    );
}
