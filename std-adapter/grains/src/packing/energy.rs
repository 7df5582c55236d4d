//! Where the energy of a packing went.

use super::Method;
use tribos_base::results::{Reporting::*, summary};
use tribos_contacts::cd::EnergyBalance;

summary! {
    /// Energy that the contacts of a packing took, by their modes.
    #[derive(Copy)]
    pub struct Dissipation = part;

    /// Energy lost in collisions and in closing gaps.
    normal: f64, "energy", SweptAs("dissipation_normal");
    /// Energy lost in sliding.
    sliding: f64, "energy", SweptAs("dissipation_sliding");
    /// Energy lost in rolling.
    rolling: f64, "energy", SweptAs("dissipation_rolling");
    /// Energy lost in torsion.
    torsion: f64, "energy", SweptAs("dissipation_torsion");
    /// Work against cohesion: stored in stretched contacts, or lost in broken ones.
    cohesion: f64, "energy", SweptAs("dissipation_cohesion");
}

summary! {
    /// Energy balance of a packing beside what its contacts took.
    #[derive(Copy)]
    pub struct PackingEnergy = part;

    /// Work of the loads on walls, of prescribed wall motions, of gravity, and of a shear.
    work: f64, "energy";
    /// Kinetic energy of spheres at the moment they are put to sleep; grains do not sleep and leave it out.
    stilled: Option<f64> = optional, "energy";
    /// Kinetic energy at the end.
    kinetic: f64, "energy";
    /// Residual of the balance: rounding errors of rigid contacts, errors of the step of soft ones.
    imbalance: f64, "energy";
    /// Elastic energy of soft contacts, less that at the start; left out for rigid ones.
    elastic: Option<f64> = optional, "energy";
}

impl Dissipation {
    pub(crate) fn of(balance: &EnergyBalance) -> Self {
        Self {
            normal: balance.normal,
            sliding: balance.sliding,
            rolling: balance.rolling,
            torsion: balance.torsion,
            cohesion: balance.cohesion,
        }
    }
}

impl PackingEnergy {
    /// That of contacts so solved, where no sphere sleeps.
    pub(crate) fn of(balance: &EnergyBalance, method: &Method) -> Self {
        Self {
            work: balance.work,
            stilled: None,
            kinetic: balance.kinetic,
            imbalance: balance.imbalance(),
            elastic: matches!(method, Method::Soft(_)).then_some(balance.elastic),
        }
    }
}
