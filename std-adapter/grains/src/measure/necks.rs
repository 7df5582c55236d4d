//! Levers of the torques at the contacts, and the sinter necks that they stand for (thesis, fig. 4.4).

use super::{Assembly, Table};
use tribos_base::record::{ContactRow, Partner};

/// Torque of pure spinning over force limit and radius, under uniform pressure.
const SPIN_TORQUE: f64 = 2.0 / 3.0;

/// Contact between two spheres as a neck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neck {
    /// The spheres.
    pub spheres: [u32; 2],
    /// r_eff = r₁ r₂/(r₁ + r₂).
    pub effective_radius: f64,
    /// Lever μ_n r_eff of the largest torsion torque μ_n r_eff P.
    pub torsion_lever: f64,
    /// Lever μ_t r_eff of the largest rolling torque μ_t r_eff P.
    pub rolling_lever: f64,
    /// Radius R_c of a round neck under uniform pressure that slides at μ P and turns at μ_n r_eff P:
    /// 2/3 μ R_c = μ_n r_eff. NaN without sliding friction.
    pub radius: f64,
}

/// Necks of all contacts between spheres. *Units*: lengths of the packing.
///
/// The model is meant for necks smaller than the spheres; [`Necks::beyond`] counts the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Necks {
    /// Coefficients of sliding, rolling and torsion of the scene; `None` without one.
    pub coefficients: Option<[f64; 3]>,
    /// The necks in the order of the contacts.
    pub necks: Vec<Neck>,
    /// Number of necks whose radius exceeds that of the smaller sphere.
    pub beyond: usize,
}

impl Necks {
    pub(super) fn of(assembly: &Assembly) -> Self {
        let coefficient = |name: &str| assembly.scene[name].as_f64();
        let coefficients = match ["mu", "mu_rolling", "mu_torsion"].map(coefficient) {
            [Some(sliding), Some(rolling), Some(torsion)] => Some([sliding, rolling, torsion]),
            _ => None,
        };
        let [mu, mu_t, mu_n] = coefficients.unwrap_or([f64::NAN; 3]);
        let mut beyond = 0;
        let neck = |row: &ContactRow| {
            let Partner::Particle(b) = row.b else {
                return None;
            };
            let [r1, r2] = [row.a, b].map(|index| assembly.radii[index as usize]);
            let effective_radius = r1 * r2 / (r1 + r2);
            let torsion_lever = mu_n * effective_radius;
            let radius = if mu > 0.0 {
                torsion_lever / (SPIN_TORQUE * mu)
            } else {
                f64::NAN
            };
            beyond += usize::from(radius > r1.min(r2));
            Some(Neck {
                spheres: [row.a, b],
                effective_radius,
                torsion_lever,
                rolling_lever: mu_t * effective_radius,
                radius,
            })
        };
        Self {
            coefficients,
            necks: assembly.contacts.iter().filter_map(neck).collect(),
            beyond,
        }
    }

    /// Mean of a property; NaN without necks.
    pub fn mean(&self, property: impl Fn(&Neck) -> f64) -> f64 {
        self.necks.iter().map(property).sum::<f64>() / self.necks.len() as f64
    }

    /// Columns: spheres, r_eff, levers, radius of the neck.
    pub fn table(&self) -> Table {
        let row = |neck: &Neck| {
            let [a, b] = neck.spheres.map(f64::from);
            vec![
                a,
                b,
                neck.effective_radius,
                neck.torsion_lever,
                neck.rolling_lever,
                neck.radius,
            ]
        };
        Table {
            name: "necks",
            columns: &[
                "a",
                "b",
                "r_eff",
                "torsion_lever",
                "rolling_lever",
                "neck_radius",
            ],
            rows: self.necks.iter().map(row).collect(),
        }
    }
}
