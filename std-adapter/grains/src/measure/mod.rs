//! Measures of packings of spheres: stress, fabric, pair correlation, forces, coordination, force chains,
//! neck levers, porosity profile, layers of a flow; for runs and for the files of other programs.

mod chains;
mod coordination;
mod fabric;
mod forces;
mod layers;
mod necks;
mod pair_correlation;
mod profile;
mod series;
mod stress;
mod summary;
mod table;

pub use crate::packing::assembly::{Assembly, KnownForces};
pub use crate::packing::{
    AssemblyError, PackingColumns, PackingColumnsError, PackingFormat, WrittenPacking,
};
pub use chains::{Buckling, ForceChains};
pub use coordination::Coordination;
pub use fabric::Fabric;
pub use forces::ForceDistribution;
pub use layers::{Layer, LayerProfile};
pub use necks::{Neck, Necks};
pub use pair_correlation::PairCorrelation;
pub use profile::PorosityProfile;
pub use stress::StressTensor;
pub use table::Table;

pub use tribos_base::exchange::sphere_columns::SphereColumn;

use tribos_base::space::SpaceError;

/// What is measured, and how finely.
///
/// ```
/// use tribos::measure::MeasureOptions;
/// let fine = MeasureOptions { bins: 400, ..MeasureOptions::default() };
/// assert_eq!(fine.angle, std::f64::consts::FRAC_PI_4); // of force chains
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasureOptions {
    /// Largest gap of contacts where no forces are known, in mean radii.
    pub gap: f64,
    /// Largest distance of the pair correlation, a length; ten mean radii, or as far as the box allows, if left
    /// out.
    pub reach: Option<f64>,
    /// Number of bins of the pair correlation.
    pub bins: usize,
    /// Largest angle between a contact and the principal stresses of its spheres in a force chain, in rad.
    pub angle: f64,
    /// Fewest contacts of a sphere that is no rattler.
    pub least_contacts: usize,
    /// Number of slices of the profiles.
    pub slices: usize,
    /// Axis of the profiles: 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// Density of all spheres, for the kinetic stress; their own, that of the scene, or 1, if left out.
    pub density: Option<f64>,
}

impl Default for MeasureOptions {
    fn default() -> Self {
        Self {
            gap: 1e-3,
            reach: None,
            bins: 200,
            angle: std::f64::consts::FRAC_PI_4,
            least_contacts: 2,
            slices: 20,
            axis: 2,
            density: None,
        }
    }
}

/// Measures of one state.
///
/// ```
/// use tribos::measure::{Assembly, Measures, MeasureOptions};
/// use tribos::nalgebra::Vector3;
/// use tribos::space::PeriodicBox;
/// // Equal spheres on a cubic lattice: six neighbours each, π/6 of the space is solid.
/// let side = 2.0 * 6.0;
/// let place = |n: u32| Vector3::new(f64::from(n % 6), f64::from(n / 6 % 6), f64::from(n / 36)) * 2.0;
/// let space = PeriodicBox::new([Some(side); 3])?;
/// let crystal = Assembly::new(space, (0..216).map(place).collect(), vec![1.0; 216]);
/// let found = Measures::of(crystal, &MeasureOptions::default())?;
/// assert_eq!(found.coordination.mean, 6.0);
/// assert!((found.porosity - (1.0 - std::f64::consts::PI / 6.0)).abs() < 1e-12);
/// assert!(found.fabric.anisotropy < 1e-12 && found.chains.is_none()); // no forces are known
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Measures {
    /// The spheres, with the contacts that were measured.
    pub assembly: Assembly,
    /// Free share of the volume of the box.
    pub porosity: f64,
    /// Stress, if forces are known.
    pub stress: Option<StressTensor>,
    /// Fabric of the contacts between spheres.
    pub fabric: Fabric,
    /// Pair correlation of the centres.
    pub pairs: PairCorrelation,
    /// Distribution of the normal forces, if they are known and any pushes.
    pub forces: Option<ForceDistribution>,
    /// Contacts of the spheres.
    pub coordination: Coordination,
    /// Force chains, if forces are known.
    pub chains: Option<ForceChains>,
    /// Levers of the contacts' torques.
    pub necks: Necks,
    /// Porosity in slices.
    pub profile: PorosityProfile,
}

impl Measures {
    /// Measures a state; where it has no forces, contacts are those of the geometry. *Domain*: finite positions;
    /// a reach of at most half of every period.
    pub fn of(mut assembly: Assembly, options: &MeasureOptions) -> Result<Self, SpaceError> {
        if assembly.forces == KnownForces::Unknown {
            assembly.touch(options.gap * assembly.mean_radius())?;
        }
        let is_known = assembly.forces != KnownForces::Unknown;
        let profile = PorosityProfile::of(&assembly, options.axis, options.slices);
        Ok(Self {
            porosity: profile::porosity(&assembly),
            stress: is_known.then(|| StressTensor::of(&assembly, options.density)),
            fabric: Fabric::of(&assembly.contacts),
            pairs: PairCorrelation::of(&assembly, options.reach, options.bins)?,
            forces: ForceDistribution::of(&assembly.contacts),
            coordination: Coordination::of(&assembly, options.least_contacts),
            chains: is_known.then(|| ForceChains::of(&assembly, options.angle)),
            necks: Necks::of(&assembly),
            profile,
            assembly,
        })
    }
}

#[cfg(test)]
mod tests;
