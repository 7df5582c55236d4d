//! The stress carried by the contacts (thesis, eq. 4.10).

use nalgebra::{Matrix3, Vector3};
use tribos_base::record::ContactRow;

/// Stress tensor, positive for compression. *Units*: force over area.
///
/// *Formula*: σ_ij = Σ F_i l_j/V over all contacts, F the force on the second body, l the vector from the
/// first centre to the second, or perpendicular to the wall. The sign is opposite to the thesis, so that the
/// piston's pressure is positive. With wall contacts in the sum, σ_zz is the pressure on the piston
/// if all forces balance.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::powder::Stress;
/// use tribos::record::{ContactRow, Partner};
/// // One sphere of radius 1 between plates of 10 × 10 that press it with 3 F_coh.
/// let (up, torque) = (Vector3::z(), Vector3::zeros());
/// let plate = |wall, normal| {
///     let (b, force) = (Partner::Wall(wall), normal * 3.0);
///     ContactRow { a: 0, b, normal, gap: 0.0, force, torque }
/// };
/// let contacts = [plate(0, -up), plate(1, up)];
/// let stress = Stress::of(&contacts, |row| row.normal, 10.0 * 10.0 * 2.0);
/// assert!((stress.total().m33 - 0.03).abs() < 1e-15); // force over area
/// assert_eq!(stress.total(), stress.plus); // nothing pulls
/// // The mean of this state and one without forces.
/// let mean = Stress::default().plus_scaled(0.5, &stress);
/// assert!((mean.total().m33 - 0.015).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress {
    /// Contribution of contacts whose normal force pushes.
    pub plus: Matrix3<f64>,
    /// Contribution of contacts whose normal force pulls.
    pub minus: Matrix3<f64>,
}

impl Stress {
    /// Stress in a volume; `branch` gives the vector l of a contact.
    pub fn of(
        contacts: &[ContactRow],
        branch: impl Fn(&ContactRow) -> Vector3<f64>,
        volume: f64,
    ) -> Self {
        let mut stress = Self::default();
        for contact in contacts {
            let share = contact.force * branch(contact).transpose() / volume;
            if contact.normal_force() < 0.0 {
                stress.minus += share;
            } else {
                stress.plus += share;
            }
        }
        stress
    }

    /// Sum of both contributions.
    pub fn total(&self) -> Matrix3<f64> {
        self.plus + self.minus
    }

    /// `self` + `factor` · `other`
    #[must_use]
    pub fn plus_scaled(&self, factor: f64, other: &Self) -> Self {
        Self {
            plus: self.plus + other.plus * factor,
            minus: self.minus + other.minus * factor,
        }
    }
}
