//! Law × patch: every tier.

use super::{Keeper, keep};
use tribos_core::Real;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::round::{
    LateralPolynomialTable, PolynomialTable, RoundTable32, RoundTable64,
};
use tribos_core::coupling::table::{self, CoulombTable, Table32, Table64};
use tribos_core::coupling::tall::{
    AllRound, FrontBack, Lean, TallFriction, TallWrench, leaning_wrench,
};
use tribos_core::coupling::{
    Annulus, Coupling, Dry, DryCoupling, Lateral, LeanProfile, PatchFriction, Profile,
    SmoothProfile, Speeds, closed, compact, unscaled_wrench,
};
use tribos_core::law::{DryFriction, LocalLaw, PowerLaw};
use tribos_core::patch::nodes::{NodeList, NodePatch, Nodes};

/// Couplings that serve both precisions.
pub fn all<R: CoulombTable>(keeper: &mut impl Keeper) {
    keep!(keeper:
        Speeds::<R>::new,
        Speeds::<R>::from_ratio,
        Speeds::<R>::at_rest,
        Speeds::<R>::lead,
        Speeds::<R>::ratio,
        Speeds::<R>::complement,
        <R as CoulombTable>::coulomb_table,
        compact::Power::<R>::new,
        compact::Power::<R>::with_pressure,
    );
    round::<R, table::Coulomb>(keeper);
    round::<R, &table::Coulomb>(keeper);
    round::<R, compact::Coulomb>(keeper);
    round::<R, compact::Power<R>>(keeper);
    round::<R, closed::Ring>(keeper);
    round::<R, closed::FlatPunch>(keeper);
    round::<R, closed::Hertz>(keeper);
    annulus::<R, table::Coulomb>(keeper);
    annulus::<R, compact::Power<R>>(keeper);
    dry::<R, table::Coulomb>(keeper);
    dry::<R, compact::Power<R>>(keeper);
    quadrature::<R, PowerLaw<R>>(keeper);
    quadrature::<R, DryFriction<R>>(keeper);
    nodes::<R, PowerLaw<R>, NodeList<R, 12>>(keeper);
    nodes::<R, DryFriction<R>, Nodes<R, 3>>(keeper);
    with_dimensions::<R, DiskQuadrature<PowerLaw<R>>>(keeper);
    tall::<R, table::Coulomb, FrontBack>(keeper);
    tall::<R, table::Coulomb, AllRound>(keeper);
    tall::<R, compact::Power<R>, AllRound>(keeper);
}

/// Tables of one precision each.
pub fn tables(keeper: &mut impl Keeper) {
    keep!(keeper:
        Table32::new,
        Table64::new,
        RoundTable32::new,
        RoundTable64::new,
        PolynomialTable::new::<4>,
        LateralPolynomialTable::new::<4>,
    );
    round::<f32, Table32>(keeper);
    round::<f32, RoundTable32>(keeper);
    round::<f64, Table64>(keeper);
    round::<f64, RoundTable64>(keeper);
    round::<f64, LateralPolynomialTable>(keeper);
    coupling::<f64, PolynomialTable>(keeper);
    smooth::<f64, PolynomialTable>(keeper);
    dry::<f32, RoundTable32>(keeper);
    dry::<f64, RoundTable64>(keeper);
    lean::<f64, Dry<RoundTable64>>(keeper);
}

/// Functions of every smooth axisymmetric coupling, without and with dimensions.
fn round<R: Real, C: Lateral<R> + SmoothProfile<R>>(keeper: &mut impl Keeper) {
    coupling::<R, C>(keeper);
    smooth::<R, C>(keeper);
    lateral::<R, C>(keeper);
    with_dimensions::<R, C>(keeper);
}

fn coupling<R: Real, C: Coupling<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: <C as Coupling<R>>::reduced_wrench, <C as Coupling<R>>::reduced_jacobian);
}

fn profile<R: Real, P: Profile<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <P as Profile<R>>::exponent,
        <P as Profile<R>>::factors,
        <P as Profile<R>>::unscaled,
        <P as Profile<R>>::inertia_excess,
        <P as Profile<R>>::inertia_ends,
        <P as Profile<R>>::speed_scale,
        <P as Profile<R>>::rate_scale,
        unscaled_wrench::<R, P>,
    );
}

fn smooth<R: Real, P: SmoothProfile<R>>(keeper: &mut impl Keeper) {
    profile::<R, P>(keeper);
    keep!(keeper: <P as SmoothProfile<R>>::factors_and_slope);
}

fn lateral<R: Real, C: Lateral<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <C as Lateral<R>>::lateral,
        <C as Lateral<R>>::lateral_jacobian,
        <C as Lateral<R>>::mean_square_radius,
        leaning_wrench::<R, C>,
    );
}

fn with_dimensions<R: Real, C: Coupling<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        PatchFriction::<R, C>::new,
        PatchFriction::<R, C>::magnitudes,
        PatchFriction::<R, C>::magnitudes_jacobian,
        PatchFriction::<R, C>::wrench,
        PatchFriction::<R, C>::wrench_jacobian,
        PatchFriction::<R, C>::wrench_batch,
        PatchFriction::<R, C>::coupling,
        PatchFriction::<R, C>::radius,
        PatchFriction::<R, C>::coefficient,
    );
}

fn annulus<R: Real, C: Lateral<R> + SmoothProfile<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: Annulus::<R, C>::new);
    coupling::<R, Annulus<R, C>>(keeper);
    profile::<R, Annulus<R, C>>(keeper);
    lateral::<R, Annulus<R, C>>(keeper);
}

fn dry<R: Real, P: SmoothProfile<R> + Lateral<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: Dry::<P>::new::<R>);
    round::<R, Dry<P>>(keeper);
    lean::<R, Dry<P>>(keeper);
}

fn lean<R: Real, P: Profile<R> + DryCoupling<R> + Lateral<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: LeanProfile::<R, P>::new);
    profile::<R, LeanProfile<R, P>>(keeper);
}

fn quadrature<R: Real, L: LocalLaw<R>>(keeper: &mut impl Keeper) {
    keep!(keeper: DiskQuadrature::<L>::new, DiskQuadrature::<L>::law);
    coupling::<R, DiskQuadrature<L>>(keeper);
}

fn nodes<R: Real, L: LocalLaw<R>, P: NodePatch<R>>(keeper: &mut impl Keeper) {
    keep!(keeper:
        NodeFriction::<L, P>::new,
        NodeFriction::<L, P>::law,
        NodeFriction::<L, P>::patch,
        NodeFriction::<L, P>::wrench::<R>,
        NodeFriction::<L, P>::wrench_jacobian::<R>,
    );
}

fn tall<R: Real, C: Lateral<R>, L: Lean>(keeper: &mut impl Keeper) {
    keep!(keeper:
        <L as Lean>::balance::<R, C>,
        TallFriction::<R, C, L>::new,
        TallFriction::<R, C, L>::wrench,
        TallFriction::<R, C, L>::foot,
        TallFriction::<R, C, L>::lean,
        TallWrench::<R>::whole,
    );
}
