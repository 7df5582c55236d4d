//! Rolling resistance beside friction: a limit of its own.

use super::{Lanes, TINY};

/// The angular impulse of rolling nearest to `candidate` within `limit` = μ_r Σλ, in N m s; μ_r is a length.
///
/// Independent of sliding and spinning, whose budget rolling does not share. *Domain*: `limit` ≥ 0; |candidate|
/// < 1e18.
///
/// ```
/// use tribos_core::manifold_friction::project_rolling;
/// assert_eq!(project_rolling([3.0_f32, 4.0], 1.0), [0.6, 0.8]);
/// assert_eq!(project_rolling([0.3_f32, 0.4], 1.0), [0.3, 0.4]);
/// ```
#[inline]
pub fn project_rolling<T: Lanes>(candidate: [T; 2], limit: T) -> [T; 2] {
    let [x, y] = candidate;
    let size = (x * x + y * y).sqrt();
    let scale = T::select(
        size.at_most(limit),
        T::splat(1.0),
        limit / size.larger(T::splat(TINY)),
    );
    [x * scale, y * scale]
}
