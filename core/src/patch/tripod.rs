//! A rigid body on three feet: the loads follow from statics alone.

use super::PatchError;
use super::nodes::{Node, Nodes};
use crate::real::Real;

/// Shares of the load on three `feet`, sum 1, for a body whose weight acts above `centre`.
///
/// The share of a foot is the area that `centre` spans with the other two, over the area of all
/// three. While the body accelerates, `centre` is not under the centre of mass but where gravity
/// and inertia together meet the ground (the zero-moment point).
///
/// *Units*: length in, shares out. *Domain*: feet not in a line, `centre` between them.
/// *Accuracy*: a few ulp for feet whose distances are not small against their coordinates.
#[doc(hidden)]
pub fn tripod_shares<R: Real>(feet: [[R; 2]; 3], centre: [R; 2]) -> Result<[R; 3], PatchError> {
    let [a, b, c] = feet;
    let areas = [[centre, b, c], [a, centre, c], [a, b, centre]].map(twice_area);
    let total = twice_area(feet);
    if total == R::ZERO || !total.is_finite() {
        return Err(PatchError::FeetInLine);
    }
    let shares = areas.map(|area| area / total);
    match shares.iter().position(|&share| share < R::ZERO) {
        Some(foot) => Err(PatchError::FootPulls { foot }),
        // Areas that are rounding errors, or none.
        None if !shares.iter().all(|&share| share <= R::TWO) => Err(PatchError::FeetInLine),
        None => Ok(shares),
    }
}

impl<R: Real> Nodes<R, 3> {
    /// The nodes of three `feet` that carry a body whose weight acts above `centre`, positions
    /// relative to `centre`.
    ///
    /// ```
    /// use tribos_core::patch::nodes::Nodes;
    /// let stool = Nodes::tripod([[0.0, 0.0], [0.3, 0.0], [0.0, 0.3]], [0.1, 0.1]);
    /// assert!(stool.is_ok());
    /// assert!(Nodes::tripod([[0.0, 0.0], [0.3, 0.0], [0.0, 0.3]], [0.2, 0.2]).is_err()); // it tips over
    /// ```
    pub fn tripod(feet: [[R; 2]; 3], centre: [R; 2]) -> Result<Self, PatchError> {
        let [a, b, c] = tripod_shares(feet, centre)?;
        let [first, second, third] = feet;
        let nodes = [(first, a), (second, b), (third, c)].map(|([x, y], weight)| Node {
            x: x - centre[0],
            y: y - centre[1],
            weight,
        });
        Self::new(nodes)
    }
}

/// Twice the signed area of a triangle.
fn twice_area<R: Real>([a, b, c]: [[R; 2]; 3]) -> R {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
