//! Ballistic deposits: spheres that fall one by one and stick (thesis, section 4.5).

mod columns;
mod contacts;
#[doc(hidden)]
pub mod curve;
mod cut;
mod grow;
mod order;
mod porosity;

pub use crate::packing::MOST_SPHERES;
#[doc(hidden)]
pub use crate::packing::volume_between;
#[doc(hidden)]
pub use contacts::SUBSTRATE;
pub use porosity::BULK;

use crate::packing::{PlacementError, Radii};
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;

/// Random stream of a deposit. It gives x, y and, if radii differ, the share of the spheres
/// that are smaller, whose quantile is the radius, of each sphere, in this order.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, STREAM, DepositTarget};
/// use tribos::random::Random;
/// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Count(1), 7)?;
/// let mut random = Random::new(7, STREAM);
/// let [x, y] = [(); 2].map(|()| 20.0 * random.unit());
/// assert_eq!((deposit.positions[0].x, deposit.positions[0].y), (x, y));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const STREAM: u64 = 0;

/// Parameters of the growth of a deposit.
///
/// Spheres fall one by one down −z on a square base, periodic in x and y, each at a random place.
/// A falling sphere is *captured* by the first of
///
/// - a deposited sphere, as the distance of the centres falls to the capture radius,
/// - the substrate z = 0, as the height of the centre falls to the capture radius,
///
/// and moves to it by the shortest path, at once and permanently: along the line of centres until the
/// spheres touch, or straight down until it lies on the substrate. A sphere that touches another
/// on its path to the substrate sticks to that one.
///
/// *A deposit is a forest without overlaps*: every sphere touches its parent, the sphere or substrate that
/// holds it. Let the sphere be captured at p, a distance r_capt from its parent and
/// at least r_capt from every other sphere; it moves by r_capt − 2R to q. A ball of radius 2R
/// around q lies within the ball of radius r_capt around p, which contains no centre. The path to the
/// substrate is longer than that by R: on this path the program checks for spheres in the way, which exist
/// only if r_capt < 2.5 R.
///
/// *Unequal radii*: capture depends on the gap between the surfaces, r_capt − 2r̄ for every pair with
/// r̄ the mean radius, r_capt − r̄ for the substrate; the proof above remains valid (with a factor
/// of the radii instead, a sphere could be moved into a smaller one).
///
/// Any unit of length. In the thesis' units R = 1, and r_capt = 3 gives a porosity of 92 %.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, DepositTarget};
/// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Cut(61.5), 1)?;
/// assert!((deposit.porosity() - 0.92).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Ballistic {
    space: PeriodicBox,
    width: f64,
    radii: Radii,
    capture_radius: f64,
}

/// When a deposit is complete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DepositTarget {
    /// Growth ends with the first sphere whose highest point reaches this height above the substrate. That
    /// sphere remains, so that the [height](Deposit::height) of the deposit, at which a piston just
    /// touches it, lies between this height and one sphere diameter above it.
    Height(f64),
    /// The deposit is grown higher and cut at this height: spheres that reach above it are removed, so that
    /// the deposit has the density of the bulk up to the cut. Every parent remains, because it lies lower
    /// (with unequal radii, spheres that rest on a removed one are removed too). Growth ends when as many
    /// spheres in a row have come to rest above the cut as would cover the base ten times.
    ///
    /// A piston at the cut nearly touches the highest sphere (0.15R below on 20R × 20R). This rule reproduces
    /// the spheres and porosities of the thesis, 470 on 20R × 20R to 61.5R and 1015 on 25R × 25R to
    /// 87.5R; deposits that end with a [height](Self::Height) are looser below it and have 9 % fewer spheres.
    Cut(f64),
    /// Growth ends with this number of spheres.
    Count(usize),
}

/// Spheres that rest on each other.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, Deposit, SUBSTRATE, DepositTarget};
/// use tribos::record::Partner;
/// let deposit: Deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Count(200), 1)?;
/// // Every sphere touches what holds it, and that leads down to the substrate.
/// let contacts = deposit.contacts();
/// assert!(contacts.iter().all(|row| row.gap.abs() < 1e-12));
/// let lying = contacts.iter().filter(|row| row.b == Partner::Wall(SUBSTRATE)).count();
/// assert_eq!(lying, deposit.parents.iter().filter(|parent| parent.is_none()).count());
/// // Ready for a file.
/// assert_eq!(deposit.snapshot(&contacts).check(), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Deposit {
    /// Centres in the order of their arrival; x and y in [0, width).
    pub positions: Vec<Vector3<f64>>,
    /// Radii.
    pub radii: Vec<f64>,
    /// Parent of each sphere, an earlier one that it touches; `None` for the substrate. Empty where the
    /// spheres were not deposited but read from a file.
    pub parents: Vec<Option<u32>>,
    /// Side of the square base.
    pub width: f64,
    /// The space, periodic in x and y with period `width`.
    pub space: PeriodicBox,
    /// Highest point of the deposit.
    pub height: f64,
}

impl Ballistic {
    /// Equal spheres of `radius` on a base of `width` × `width`. *Domain*: all finite and
    /// positive, 2 radius ≤ `capture_radius` ≤ width/2.
    pub fn new(width: f64, radius: f64, capture_radius: f64) -> Result<Self, PlacementError> {
        Self::uneven(width, [radius; 2], capture_radius)
    }

    /// Spheres with radii uniformly distributed between two bounds. *Domain*: all finite and positive, the
    /// bounds in order, their sum ≤ `capture_radius`, and the two largest spheres captured within width/2.
    ///
    /// ```
    /// use tribos::powder::deposit::{Ballistic, DepositTarget};
    /// let deposit = Ballistic::uneven(20.0, [0.8, 1.2], 3.0)?.grow(DepositTarget::Count(100), 1)?;
    /// assert!(deposit.radii.iter().all(|radius| (0.8..=1.2).contains(radius)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn uneven(
        width: f64,
        radii: [f64; 2],
        capture_radius: f64,
    ) -> Result<Self, PlacementError> {
        let [low, high] = radii;
        if low > high {
            return Err(PlacementError::Radii { low, high });
        }
        Self::sized(width, Radii::uniform(low, high), capture_radius)
    }

    /// Spheres with radii of any distribution about a mean of 1. *Domain*: all finite and positive, two mean
    /// radii ≤ `capture_radius`, and the two largest spheres captured within width/2.
    ///
    /// ```
    /// use tribos::powder::deposit::{Ballistic, DepositTarget};
    /// use tribos::scene::SizeDistribution;
    /// let radii = SizeDistribution::LogNormal(0.2).radii()?;
    /// let deposit = Ballistic::sized(20.0, radii.clone(), 3.0)?.grow(DepositTarget::Count(100), 1)?;
    /// let [low, high] = radii.bounds();
    /// assert!(deposit.radii.iter().all(|radius| (low..=high).contains(radius)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sized(width: f64, radii: Radii, capture_radius: f64) -> Result<Self, PlacementError> {
        let [low, high] = radii.bounds();
        for (name, given) in [
            ("width", width),
            ("smallest radius", low),
            ("largest radius", high),
            ("capture radius", capture_radius),
        ] {
            if !given.is_finite() || given <= 0.0 {
                return Err(PlacementError::NotPositive { name, given });
            }
        }
        let space = PeriodicBox::new([Some(width), Some(width), None])?;
        let least = radii.two_means();
        let farthest = 2.0 * high + (capture_radius - least);
        if capture_radius < least {
            Err(PlacementError::CaptureRadius {
                given: capture_radius,
                least,
            })
        } else if farthest > 0.5 * width {
            Err(PlacementError::NarrowBase { width, farthest })
        } else {
            Ok(Self {
                space,
                width,
                radii,
                capture_radius,
            })
        }
    }

    /// The gap between surfaces at which spheres capture each other.
    fn capture_gap(&self) -> f64 {
        self.capture_radius - self.radii.two_means()
    }

    /// The gap above the substrate at which it captures.
    fn substrate_gap(&self) -> f64 {
        self.capture_radius - self.radii.mean()
    }
}
