//! Linked cells of a periodic cube: which spheres are in a cell.

/// End of a list.
const NONE: u32 = u32::MAX;
/// Fewest cells along an edge: with three, each neighbour is met once.
const FEWEST: usize = 3;
/// Cells are wider than a diameter by this share, far more than rounding takes.
const MARGIN: f64 = 1e-9;
/// Most cells along an edge, which keeps their numbers small.
const MOST: f64 = 1000.0;

/// Lists of the spheres of each cell, as links.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    /// Cells along an edge.
    pub count: usize,
    /// Edge of a cell.
    pub edge: f64,
    heads: Vec<u32>,
    next: Vec<u32>,
    before: Vec<u32>,
}

impl Cells {
    /// Smallest cube that has the fewest cells.
    pub const LEAST: f64 = 2.0 * (1.0 + MARGIN) * FEWEST as f64;

    /// Empty cells of about one sphere each, at least a diameter wide.
    pub fn new(length: f64, spheres: usize) -> Self {
        let diameter = 2.0 * (1.0 + MARGIN);
        let roomy = length / libm::cbrt(spheres.max(1) as f64);
        let widest = if roomy > diameter { roomy } else { diameter };
        let count = ((length / widest).floor().min(MOST) as usize).max(FEWEST);
        Self {
            count,
            edge: length / count as f64,
            heads: vec![NONE; count * count * count],
            next: vec![NONE; spheres],
            before: vec![NONE; spheres],
        }
    }

    /// Cell of a coordinate.
    pub fn of(&self, x: f64) -> i32 {
        (x / self.edge).floor() as i32
    }

    /// Number of the cell in the cube that this one is an image of.
    fn index(&self, cell: [i32; 3]) -> usize {
        let [x, y, z] = cell.map(|along| along.rem_euclid(self.count as i32) as usize);
        (z * self.count + y) * self.count + x
    }

    /// Puts a sphere into a cell.
    pub fn insert(&mut self, sphere: u32, cell: [i32; 3]) {
        let head = self.index(cell);
        let second = self.heads[head];
        self.next[sphere as usize] = second;
        self.before[sphere as usize] = NONE;
        if second != NONE {
            self.before[second as usize] = sphere;
        }
        self.heads[head] = sphere;
    }

    /// Takes a sphere out of its cell.
    pub fn remove(&mut self, sphere: u32, cell: [i32; 3]) {
        let (before, next) = (self.before[sphere as usize], self.next[sphere as usize]);
        if before == NONE {
            let head = self.index(cell);
            self.heads[head] = next;
        } else {
            self.next[before as usize] = next;
        }
        if next != NONE {
            self.before[next as usize] = before;
        }
    }

    /// The spheres of a cell.
    pub fn spheres(&self, cell: [i32; 3]) -> impl Iterator<Item = u32> {
        let first = self.heads[self.index(cell)];
        let known = |sphere: u32| (sphere != NONE).then_some(sphere);
        std::iter::successors(known(first), move |&sphere| {
            known(self.next[sphere as usize])
        })
    }
}
