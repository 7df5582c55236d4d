//! Measures of many states of one run, and how its chains bend from one to the next.

use super::{Assembly, Buckling, ForceChains, MeasureOptions, Measures, Table};
use tribos_base::space::SpaceError;

/// Columns of the series.
const COLUMNS: &[&str] = &[
    "step",
    "porosity",
    "pressure",
    "deviator",
    "fabric_anisotropy",
    "coordination",
    "rattlers",
    "mean_force",
    "tail_decay",
    "chains",
    "chain_length",
    "longest_chain",
    "chain_share",
    "triples",
    "buckled",
    "mean_bend",
];

impl Measures {
    /// Measures of states in order, one row a state; `watch` is called after each.
    ///
    /// The last three columns tell how the chains of the state before have bent, in rad; NaN in the first row.
    ///
    /// ```
    /// use tribos::measure::{Assembly, MeasureOptions, Measures};
    /// use tribos::{nalgebra::Vector3, space::PeriodicBox};
    /// let space = PeriodicBox::new([Some(9.0); 3])?;
    /// let at = |x: f64| Assembly::new(space, vec![Vector3::zeros(), Vector3::x() * x], vec![1.0; 2]);
    /// let table = Measures::series([(0, at(2.0)), (10, at(3.0))], &MeasureOptions::default(), |_step| ())?;
    /// let contacts = |row: usize| table.rows[row][5];
    /// assert_eq!([contacts(0), contacts(1)], [1.0, 0.0]); // the spheres part
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn series(
        states: impl IntoIterator<Item = (u64, Assembly)>,
        options: &MeasureOptions,
        mut watch: impl FnMut(u64),
    ) -> Result<Table, SpaceError> {
        let mut rows = Vec::new();
        let mut before: Option<(ForceChains, Assembly)> = None;
        for (step, state) in states {
            let mut found = Self::of(state, options)?;
            let bent = before
                .as_ref()
                .map(|(chains, was)| chains.buckling(was, &found.assembly));
            rows.push(row(step, &found, bent));
            before = found.chains.take().map(|chains| (chains, found.assembly));
            watch(step);
        }
        Ok(Table {
            name: "series",
            columns: COLUMNS,
            rows,
        })
    }
}

fn row(step: u64, found: &Measures, bent: Option<Buckling>) -> Vec<f64> {
    let (stress, forces, chains) = (&found.stress, &found.forces, &found.chains);
    let of_stress =
        |value: fn(&super::StressTensor) -> f64| stress.as_ref().map_or(f64::NAN, value);
    let of_forces =
        |value: fn(&super::ForceDistribution) -> f64| forces.as_ref().map_or(f64::NAN, value);
    let of_chains = |value: fn(&ForceChains) -> f64| chains.as_ref().map_or(f64::NAN, value);
    let of_bends = |value: fn(&Buckling) -> f64| bent.as_ref().map_or(f64::NAN, value);
    vec![
        step as f64,
        found.porosity,
        of_stress(super::StressTensor::pressure),
        of_stress(super::StressTensor::deviator),
        found.fabric.anisotropy,
        found.coordination.mean,
        found.coordination.rattlers as f64,
        of_forces(|forces| forces.mean),
        of_forces(|forces| forces.tail[0]),
        of_chains(|chains| chains.chains.len() as f64),
        of_chains(ForceChains::mean_length),
        of_chains(|chains| chains.longest() as f64),
        of_chains(|chains| chains.share),
        of_bends(|bent| bent.triples as f64),
        of_bends(|bent| bent.buckled as f64),
        of_bends(|bent| bent.mean),
    ]
}
