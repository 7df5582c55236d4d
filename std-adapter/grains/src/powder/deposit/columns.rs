//! Deposited spheres sorted into columns over the base.

use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;

/// Largest number of columns along one side: a million in total.
const MOST_COLUMNS: f64 = 1024.0;

/// A deposited sphere in its column.
#[derive(Clone, Copy, Debug)]
struct ColumnEntry {
    position: Vector3<f64>,
    radius: f64,
    index: u32,
}

/// Square columns over the base, each sorted by height.
#[derive(Debug)]
pub struct Columns {
    space: PeriodicBox,
    inv_width: f64,
    side: usize,
    columns: Vec<Vec<ColumnEntry>>,
    largest: f64,
}

/// Contact of a falling sphere with a deposited one.
#[derive(Clone, Copy, Debug)]
pub struct FallContact {
    /// Number of the deposited sphere.
    pub index: u32,
    /// Centre of the deposited sphere.
    pub centre: Vector3<f64>,
    /// Radius of the deposited sphere.
    pub radius: f64,
    /// Vector from its centre to that of the falling sphere.
    pub way: Vector3<f64>,
}

impl Columns {
    /// Empty columns, at least `reach` wide, over a base of `width` with the periods of `space`;
    /// spheres have radii up to `largest`.
    pub fn new(space: PeriodicBox, width: f64, reach: f64, largest: f64) -> Self {
        let side = (width / reach).floor().clamp(1.0, MOST_COLUMNS);
        Self {
            space,
            inv_width: side / width,
            side: side as usize,
            columns: vec![Vec::new(); side as usize * side as usize],
            largest,
        }
    }

    /// Inserts a sphere, in order of height.
    pub fn insert(&mut self, index: u32, position: Vector3<f64>, radius: f64) {
        let (x, y) = (self.number(position.x), self.number(position.y));
        let column = &mut self.columns[y * self.side + x];
        // The place is near the end, because deposits grow upwards.
        let place = column.partition_point(|other| other.position.z <= position.z);
        column.insert(
            place,
            ColumnEntry {
                position,
                radius,
                index,
            },
        );
    }

    /// The first sphere that another meets while falling down the vertical of `above`, at a height above
    /// `above.z`. They meet when the distance of the centres falls to the radius plus `reach`, which must not
    /// exceed the value for which the columns were made.
    pub fn first_meeting(&self, above: Vector3<f64>, reach: f64) -> Option<FallContact> {
        let mut first: Option<FallContact> = None;
        let mut floor = above.z;
        let farthest = reach + self.largest;
        for y in self.around(above.y) {
            for x in self.around(above.x) {
                // From the top, until even a sphere straight below would be met too low.
                for other in self.columns[y * self.side + x].iter().rev() {
                    if other.position.z + farthest <= floor {
                        break;
                    }
                    let mut way = self.space.displacement(&other.position, &above);
                    let distance = reach + other.radius;
                    let rise_sq = distance * distance - way.x * way.x - way.y * way.y;
                    way.z = rise_sq.max(0.0).sqrt();
                    let height = other.position.z + way.z;
                    if rise_sq >= 0.0 && height > floor {
                        floor = height;
                        first = Some(FallContact {
                            index: other.index,
                            centre: other.position,
                            radius: other.radius,
                            way,
                        });
                    }
                }
            }
        }
        first
    }

    /// Column number of a coordinate in [0, width).
    fn number(&self, x: f64) -> usize {
        ((x * self.inv_width) as usize).min(self.side - 1)
    }

    /// The column of a coordinate and its neighbours on both sides, each listed once.
    fn around(&self, x: f64) -> impl Iterator<Item = usize> + use<> {
        let (side, own) = (self.side, self.number(x));
        // Starts at the left neighbour and wraps around the period.
        (0..side.min(3)).map(move |step| (own + side - 1 + step) % side)
    }
}
