//! Which states are kept when the number of steps is not known in advance.

/// The smallest number of frames that can be kept: the first state and the last.
///
/// ```
/// use tribos::record::frames::{FEWEST, spacing};
/// // So far apart that of 1000 states after the first none is kept but the last.
/// assert!(spacing(1000, FEWEST) > 1000);
/// assert_eq!(spacing(1000, 0), spacing(1000, FEWEST));
/// ```
pub const FEWEST: u64 = 2;

/// States from one kept frame to the next, a power of two, once `states` have followed the first:
/// the smallest for which those kept and the last one are not more than `limit`.
///
/// The set is halved when it is full: except for the last state, the frames kept later are a
/// subset of those kept before. *Domain*: limits below [`FEWEST`] count as that; `u64::MAX` where
/// a power of two has too many digits.
///
/// ```
/// use tribos::record::frames::spacing;
/// assert_eq!([spacing(98, 100), spacing(99, 100), spacing(1000, 100)], [1, 2, 16]);
/// ```
pub fn spacing(states: u64, limit: u64) -> u64 {
    let before_last = limit.max(FEWEST) - 1;
    let mut spacing = 1_u64;
    while states / spacing >= before_last {
        spacing = match spacing.checked_mul(2) {
            Some(double) => double,
            None => return u64::MAX,
        };
    }
    spacing
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_bounded_and_never_needed_again_once_dropped() {
        for limit in [0, 1, 2, 3, 7, 100] {
            let mut last = 1;
            for states in 0..5_000 {
                let now = spacing(states, limit);
                // Kept ones with the first, and the last state.
                let kept = states / now + 1 + u64::from(!states.is_multiple_of(now));
                assert!(kept <= limit.max(FEWEST), "{states} {limit}");
                assert!(now >= last && now.is_multiple_of(last));
                // No coarser than necessary.
                let half = now / 2;
                assert!(now == 1 || states / half + 2 > limit.max(FEWEST));
                last = now;
            }
        }
        assert_eq!(
            [2, 3].map(|limit| spacing(u64::MAX, limit)),
            [u64::MAX, 1 << 63]
        );
    }
}
