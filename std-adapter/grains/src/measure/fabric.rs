//! Fabric tensor: where the contacts point.

use nalgebra::{Matrix3, Vector3};
use tribos_base::record::{ContactRow, Partner};

/// Mean of n ⊗ n over the normals n of the contacts between spheres; its trace is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fabric {
    /// The tensor; NaN without contacts.
    pub tensor: Matrix3<f64>,
    /// Its eigenvalues in descending order; 1/3 each if isotropic.
    pub values: [f64; 3],
    /// Direction of the largest eigenvalue, upwards.
    pub direction: Vector3<f64>,
    /// Anisotropy a_c = √(3/2 a:a) with a = 15/2 (Φ − 1/3), so that the density of normals is
    /// (1 + n·a·n)/4π; 0 if isotropic, 7.5 if all normals are parallel.
    pub anisotropy: f64,
}

impl Fabric {
    pub(super) fn of(contacts: &[ContactRow]) -> Self {
        let mut sum = Matrix3::zeros();
        let mut count = 0.0;
        for row in contacts {
            if let Partner::Particle(_) = row.b {
                sum += row.normal * row.normal.transpose();
                count += 1.0;
            }
        }
        let tensor = sum / count;
        let (values, direction) = principal(&tensor);
        let deviatoric = (tensor - Matrix3::identity() / 3.0) * 7.5;
        Self {
            tensor,
            values,
            direction,
            anisotropy: (1.5 * deviatoric.norm_squared()).sqrt(),
        }
    }
}

/// Eigenvalues of a symmetric tensor in descending order, and the direction of the first, upwards.
pub(super) fn principal(tensor: &Matrix3<f64>) -> ([f64; 3], Vector3<f64>) {
    if !tensor.iter().all(|x| x.is_finite()) {
        return ([f64::NAN; 3], Vector3::repeat(f64::NAN));
    }
    let eigen = tensor.symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| f64::total_cmp(&eigen.eigenvalues[j], &eigen.eigenvalues[i]));
    let first = eigen.eigenvectors.column(order[0]).into_owned();
    let upwards = [first.z, first.y, first.x].into_iter().find(|x| *x != 0.0);
    let sign = if upwards.is_some_and(|x| x < 0.0) {
        -1.0
    } else {
        1.0
    };
    (order.map(|i| eigen.eigenvalues[i]), first * sign)
}
