//! The search for an end of an interval: how far a parameter can be moved, the others following, before the sum of squares
//! has risen by what the interval allows.

/// Share of the wanted rise within which an end is found.
const CLOSE: f64 = 0.01;
/// Most trials.
const MOST_TRIALS: usize = 14;
/// A trial between two keeps this share of their distance from either.
const LEAST_SHARE: f64 = 0.05;
/// Smallest and largest factor from one trial to the next outwards.
const GROWTH: [f64; 2] = [1.1, 3.0];

/// A search outwards from a minimum. Rises are square roots of those of the sum of squares, which are nearly linear.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outwards {
    /// Distance of the first trial.
    pub first: f64,
    /// Largest distance.
    pub most: f64,
    /// Rise at the end.
    pub wanted: f64,
    /// Rise at the minimum, above a lower one.
    pub begin: f64,
}

/// What such a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End<T> {
    /// The distance of the end.
    At(f64),
    /// The sum of squares stays below the wanted rise up to the largest distance.
    Open,
    /// A place with a smaller sum of squares.
    Lower(T),
}

impl Outwards {
    /// Where the rise is the wanted one; `risen` searches the best place at a distance from that of a nearer one, and
    /// gives its rise: negative at another minimum, none where the model refuses the distance.
    pub fn end<T>(&self, place: T, risen: impl Fn(f64, &T) -> Option<(T, f64)>) -> End<T> {
        let mut near = (0.0, self.begin, place);
        let mut far: Option<[f64; 2]> = None;
        let mut at = self.first.min(self.most);
        for _ in 0..MOST_TRIALS {
            match risen(at, &near.2) {
                Some((lower, rise)) if rise < 0.0 => return End::Lower(lower),
                Some((_, rise)) if (rise - self.wanted).abs() <= CLOSE * self.wanted => {
                    return End::At(at);
                }
                Some((_, rise)) if rise < self.wanted && at >= self.most => return End::Open,
                Some((found, rise)) if rise < self.wanted => near = (at, rise, found),
                Some((_, rise)) => far = Some([at, rise]),
                None => far = Some([at, f64::INFINITY]),
            }
            at = match far {
                Some([end, rise]) if rise.is_finite() => {
                    let share = (self.wanted - near.1) / (rise - near.1);
                    near.0 + (end - near.0) * share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE)
                }
                Some([end, _]) => 0.5 * (near.0 + end),
                None => {
                    let [least, most] = GROWTH;
                    (at * (self.wanted / near.1).clamp(least, most)).min(self.most)
                }
            };
        }
        // Too long rather than too short.
        match far {
            Some([end, rise]) if rise.is_finite() => End::At(end),
            _ => End::Open,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{End, Outwards};

    const SEARCH: Outwards = Outwards {
        first: 0.1,
        most: 10.0,
        wanted: 2.0,
        begin: 0.0,
    };

    fn end(rise: impl Fn(f64) -> Option<f64>) -> End<f64> {
        SEARCH.end(0.0, |at, _| rise(at).map(|rise| (at, rise)))
    }

    #[test]
    fn ends_lie_where_the_rise_is_the_wanted_one() {
        // 2 = x, x³, √x, and a wall at 1 that nothing passes.
        for (rise, wanted) in [
            (&(|x: f64| x) as &dyn Fn(f64) -> f64, 2.0),
            (&|x| x * x * x, libm::cbrt(2.0)),
            (&|x| x.sqrt(), 4.0),
            (&|x| if x < 1.0 { 0.1 * x } else { 50.0 }, 1.0),
        ] {
            let End::At(found) = end(|x| Some(rise(x))) else {
                panic!("{wanted}")
            };
            assert!((found / wanted - 1.0).abs() < 0.04, "{found} {wanted}");
        }
    }

    #[test]
    fn what_the_data_do_not_bound_is_open_and_a_lower_place_is_told() {
        assert_eq!(end(|x| Some(0.1 * x)), End::Open);
        // Where the law refuses every distance, the data have set no bound.
        assert_eq!(end(|_| None), End::Open);
        assert!(matches!(end(|x| Some(if x > 1.0 { -0.1 } else { x })), End::Lower(x) if x > 1.0));
    }
}
