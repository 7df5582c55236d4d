//! Intervals of a film without the angle: the sum of squares along the ratio v/(|ω|R), against which the coefficient trades.
//!
//! A body that hardly spins and one near its final ratio both slow down uniformly, so the sum has valleys that no search
//! outwards from one of them crosses. At each ratio the other coordinates are those of nearly linear least squares: the
//! interval of each joins what they reach at all ratios that the frames allow.

use super::super::minimise::Minimum;
use super::super::parameter::{Model, Range};
use super::errors::Errors;
use super::weighted::{ROUGH, Weighted};

/// Logarithms of the ratio that are scanned to either side of 1, and from one to the next.
const REACH: f64 = 5.0;
const STRIDE: f64 = 0.2;
/// Halvings of the stride at the ends of what the frames allow, and within it.
const END_HALVINGS: usize = 5;
const INNER_HALVINGS: usize = 1;
/// Fewest ratios of a scan that the frames allow where the profile around a minimum is not enough.
const FEW: usize = 3;
/// Change of a logarithm over the last stride beyond which it goes on without a bound.
const GOES_ON: f64 = 0.05;

/// The best motion at one ratio.
#[derive(Clone, Debug)]
struct Node {
    /// Logarithm of the ratio.
    at: f64,
    /// All coordinates, and variances of the others at this ratio.
    q: Vec<f64>,
    variances: Vec<f64>,
    cost: f64,
}

/// The sum of squares along the ratio.
pub(super) struct Scan<'a> {
    film: &'a Weighted<'a>,
    /// FilmedPlace of the ratio among the coordinates.
    ratio: usize,
    /// By rising ratio.
    nodes: Vec<Node>,
}

impl<'a> Scan<'a> {
    /// Outwards from the best minimum, with the others; none where the ratio is not sought.
    pub fn new(film: &'a Weighted<'a>, minima: &[&Minimum]) -> Option<Self> {
        let from = minima.first()?;
        let ratio = film.ratio()?;
        let mut scan = Self {
            film,
            ratio,
            nodes: Vec::new(),
        };
        let middle = from.q.get(ratio)?.clamp(-REACH, REACH);
        for sign in [-1.0, 1.0] {
            let mut near = from.q.clone();
            let mut at = middle;
            loop {
                if let Some(node) = scan.node(at, &near) {
                    near.clone_from(&node.q);
                    scan.nodes.push(node);
                }
                if at.abs() >= REACH && at * sign > 0.0 {
                    break;
                }
                at = (at + sign * STRIDE).clamp(-REACH, REACH);
            }
        }
        scan.order();
        // Valleys may be narrower than a stride.
        let found: Vec<Minimum> = scan.valleys().collect();
        for minimum in found.iter().chain(minima.iter().copied()) {
            let at = minimum.q.get(ratio)?.clamp(-REACH, REACH);
            let node = scan.node(at, &minimum.q);
            scan.nodes.extend(node);
        }
        scan.order();
        Some(scan)
    }

    /// Minima from nodes that lie lower than both neighbours.
    fn valleys(&self) -> impl Iterator<Item = Minimum> {
        let threes = self.nodes.windows(3).filter_map(|three| match three {
            [a, b, c] if b.cost <= a.cost && b.cost <= c.cost => Some(b),
            _ => None,
        });
        threes.filter_map(|node| self.film.minimum(&self.film.unknowns, &node.q, ROUGH))
    }

    fn order(&mut self) {
        self.nodes
            .sort_by(|a, b| a.at.total_cmp(&b.at).then(a.cost.total_cmp(&b.cost)));
        self.nodes.dedup_by(|b, a| a.at == b.at);
    }

    /// The best motion at a ratio, searched from the coordinates of another.
    fn node(&self, at: f64, near: &[f64]) -> Option<Node> {
        let all = &self.film.unknowns;
        let held = *all.sought.get(self.ratio)?;
        let unknowns = all.keeping(held, Range::Positive.value(at));
        let mut start = near.to_vec();
        start.remove(self.ratio);
        let found = self.film.minimum(&unknowns, &start, ROUGH)?;
        let variances = Errors::of(self.film, &unknowns, &found.q, 1.0)?
            .covariance
            .diagonal();
        let (mut q, mut variances) = (found.q, variances.as_slice().to_vec());
        q.insert(self.ratio, at);
        variances.insert(self.ratio, 0.0);
        Some(Node {
            at,
            q,
            variances,
            cost: found.cost,
        })
    }

    /// The least sum of squares that was found.
    pub fn least(&self) -> f64 {
        self.nodes
            .iter()
            .map(|node| node.cost)
            .fold(f64::INFINITY, f64::min)
    }

    /// Whether the frames allow so many ratios that the profile around a minimum is not enough.
    pub fn is_wide(&self, least: f64, rise: f64) -> bool {
        self.nodes
            .iter()
            .filter(|node| node.cost <= least + rise)
            .count()
            >= FEW
    }

    /// Halves strides where the frames begin to allow a ratio, and once where they do.
    pub fn refine(&mut self, least: f64, rise: f64) {
        for halving in 0..END_HALVINGS {
            let mut added = Vec::new();
            for pair in self.nodes.windows(2) {
                let [a, b] = pair else { continue };
                let allowed = [a, b].map(|node| node.cost <= least + rise);
                let is_end = allowed[0] != allowed[1];
                if is_end || (allowed[0] && halving < INNER_HALVINGS) {
                    let from = if a.cost <= b.cost { a } else { b };
                    added.extend(self.node(0.5 * (a.at + b.at), &from.q));
                }
            }
            self.nodes.extend(added);
            self.order();
        }
    }

    /// Ends of the coordinate `k`; infinite where it goes on at the end of the scan.
    pub fn ends(&self, k: usize, least: f64, rise: f64) -> [f64; 2] {
        let reach = |node: &Node| {
            let room = least + rise - node.cost;
            let is_allowed = room >= 0.0;
            is_allowed.then(|| (room * node.variances[k]).sqrt())
        };
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for node in &self.nodes {
            if let Some(far) = reach(node) {
                ends = [ends[0].min(node.q[k] - far), ends[1].max(node.q[k] + far)];
            }
        }
        let range = self.film.model.parameters()[self.film.unknowns.sought[k]].range;
        if range != Range::Positive {
            return ends;
        }
        // A logarithm that still moves at an allowed end of the scan has no bound there.
        let count = self.nodes.len();
        for (last, before) in [(0, 1), (count.wrapping_sub(1), count.wrapping_sub(2))] {
            let pair = self.nodes.get(last).zip(self.nodes.get(before));
            let Some((last, before)) = pair.filter(|(last, _)| reach(last).is_some()) else {
                continue;
            };
            let moved = last.q[k] - before.q[k];
            let much = GOES_ON * (last.at - before.at).abs();
            if moved > much {
                ends[1] = f64::INFINITY;
            } else if moved < -much {
                ends[0] = f64::NEG_INFINITY;
            }
        }
        ends
    }
}

/// What a scan tells.
pub(super) struct Scanned {
    /// Of all unknowns.
    pub intervals: Vec<[f64; 2]>,
    /// Coordinates of a motion that hardly spins, if the interval of the ratio includes it.
    pub unspun: Option<Vec<f64>>,
}

/// Intervals of all parameters; those around minima stay where the frames allow few ratios.
pub(super) fn widened(
    film: &Weighted<'_>,
    alike: &[&Minimum],
    rises: &[f64],
    around: impl Fn() -> Vec<[f64; 2]>,
) -> Scanned {
    let most = rises.iter().copied().fold(0.0, f64::max);
    let Some(mut scan) = Scan::new(film, alike) else {
        return Scanned {
            intervals: around(),
            unspun: None,
        };
    };
    let least = alike
        .first()
        .map_or(f64::INFINITY, |best| best.cost)
        .min(scan.least());
    let is_wide = scan.is_wide(least, most);
    scan.refine(least, most);
    let mut intervals = if is_wide {
        vec![[f64::INFINITY, f64::NEG_INFINITY]; rises.len()]
    } else {
        around()
    };
    for (k, interval) in intervals.iter_mut().enumerate() {
        let range = film.model.parameters()[film.unknowns.sought[k]].range;
        let [low, high] = scan.ends(k, least, rises[k]).map(|end| range.value(end));
        *interval = [interval[0].min(low), interval[1].max(high)];
    }
    let is_allowed = |node: &&Node| node.at >= REACH && node.cost <= least + rises[scan.ratio];
    let unspun = scan.nodes.last().filter(is_allowed);
    Scanned {
        intervals,
        unspun: unspun.map(|node| node.q.clone()),
    }
}
