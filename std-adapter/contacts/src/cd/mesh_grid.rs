//! Cells of a mesh: which triangles lie near a point.

use nalgebra::Vector3;

/// Most cells along an axis.
const MOST: f64 = 64.0;

/// Triangles by the cells that their boxes reach into.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// Low and high ends of all boxes.
    ends: [Vector3<f64>; 2],
    /// Lengths of a cell.
    cell: Vector3<f64>,
    counts: [usize; 3],
    /// Where the triangles of each cell start, and one more.
    starts: Vec<u32>,
    triangles: Vec<u32>,
}

impl Grid {
    /// Cells about as large as the boxes of the triangles; `None` without any.
    pub fn new(boxes: &[[Vector3<f64>; 2]]) -> Option<Self> {
        let [low, high] = boxes
            .iter()
            .copied()
            .reduce(|[low, high], [l, h]| [low.inf(&l), high.sup(&h)])?;
        let sides: f64 = boxes.iter().map(|[low, high]| (high - low).max()).sum();
        let side = sides / boxes.len() as f64;
        let mut grid = Self {
            ends: [low, high],
            cell: high - low,
            counts: [1; 3],
            starts: Vec::new(),
            triangles: Vec::new(),
        };
        for axis in 0..3 {
            let count = ((high - low)[axis] / side).floor().clamp(1.0, MOST);
            grid.counts[axis] = count as usize;
            grid.cell[axis] /= count;
        }
        // How many each cell has, then which.
        let cells = grid.counts.iter().product::<usize>();
        let mut starts = vec![0_u32; cells + 1];
        for ends in boxes {
            grid.each_cell(ends, |cell| starts[cell + 1] += 1);
        }
        for cell in 0..cells {
            starts[cell + 1] += starts[cell];
        }
        let mut next = starts.clone();
        let mut triangles = vec![0_u32; starts[cells] as usize];
        for (triangle, ends) in (0_u32..).zip(boxes) {
            grid.each_cell(ends, |cell| {
                triangles[next[cell] as usize] = triangle;
                next[cell] += 1;
            });
        }
        (grid.starts, grid.triangles) = (starts, triangles);
        Some(grid)
    }

    /// Calls `visit` with each cell that a box reaches into.
    fn each_cell(&self, ends: &[Vector3<f64>; 2], mut visit: impl FnMut(usize)) {
        let place = |x: &Vector3<f64>| {
            [0, 1, 2].map(|axis: usize| {
                let cell = (x[axis] - self.ends[0][axis]) / self.cell[axis];
                // The cast saturates; a flat mesh has cells without thickness.
                (cell.max(0.0) as usize).min(self.counts[axis] - 1)
            })
        };
        let [low, high] = [place(&ends[0]), place(&ends[1])];
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                for x in low[0]..=high[0] {
                    visit(x + self.counts[0] * (y + self.counts[1] * z));
                }
            }
        }
    }

    /// Whether a point lies within a distance of the box of all triangles.
    pub fn is_near(&self, x: &Vector3<f64>, within: f64) -> bool {
        let [low, high] = &self.ends;
        (0..3).all(|axis| x[axis] >= low[axis] - within && x[axis] <= high[axis] + within)
    }

    /// Triangles that may lie within a distance of a point, each once, in ascending order.
    pub fn around(&self, x: &Vector3<f64>, within: f64) -> Vec<u32> {
        let reach = Vector3::repeat(within);
        let mut found = Vec::new();
        self.each_cell(&[x - reach, x + reach], |cell| {
            let [start, end] = [self.starts[cell], self.starts[cell + 1]];
            found.extend_from_slice(&self.triangles[start as usize..end as usize]);
        });
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Largest side of the box of all triangles.
    pub fn size(&self) -> f64 {
        (self.ends[1] - self.ends[0]).max()
    }

    /// Middle of that box.
    pub fn middle(&self) -> Vector3<f64> {
        (self.ends[0] + self.ends[1]) * 0.5
    }

    /// Corners of that box.
    pub fn corners(&self) -> [Vector3<f64>; 8] {
        [0, 1, 2, 3, 4, 5, 6, 7].map(|corner: usize| {
            let end = |axis: usize| self.ends[(corner >> axis) & 1][axis];
            Vector3::new(end(0), end(1), end(2))
        })
    }
}
