//! Ballistic deposits: spheres that fall one by one and stick (thesis, section 4.5).

mod columns;
mod contacts;
#[doc(hidden)]
pub mod curve;
mod cut;
mod error;
mod grow;
mod porosity;

#[doc(hidden)]
pub use contacts::SUBSTRATE;
pub use error::DepositError;
#[doc(hidden)]
pub use porosity::{BULK, volume_between};

use crate::space::PeriodicBox;
use nalgebra::Vector3;

/// Stream of random numbers that deposits draw from: x, y and, where radii differ, the radius of
/// each sphere, in this order.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, STREAM, Until};
/// use tribos::random::Random;
/// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(Until::Count(1), 7)?;
/// let mut random = Random::new(7, STREAM);
/// let [x, y] = [(); 2].map(|()| 20.0 * random.unit());
/// assert_eq!((deposit.positions[0].x, deposit.positions[0].y), (x, y));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const STREAM: u64 = 0;

/// Spheres at most, for which some 4 GB of memory are enough.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, DepositError, MOST_SPHERES, Until};
/// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(Until::Count(MOST_SPHERES + 1), 1);
/// assert_eq!(deposit, Err(DepositError::TooMany));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const MOST_SPHERES: usize = 20_000_000;

/// How deposits grow.
///
/// Spheres fall one by one down −z on a square base, periodic in x and y, each at a random place.
/// A falling sphere is *captured* by the first of
///
/// - a deposited sphere, as the distance of the centres falls to the capture radius,
/// - the substrate z = 0, as the height of the centre falls to the capture radius,
///
/// and goes the shortest way to it, at once and for good: along the line of centres until the
/// spheres touch, or straight down until it lies on the substrate. A sphere that touches another
/// on its way down to the substrate sticks to that.
///
/// *A deposit is a forest without overlaps*: every sphere touches the one that holds it, its
/// parent, or the substrate. Let the sphere be captured at p, a distance r_capt from its parent and
/// at least r_capt from every other sphere; it moves by r_capt − 2R to q. A ball of radius 2R
/// around q lies within the ball of radius r_capt around p, and no centre does. The way to the
/// substrate is R longer than that: there, spheres in the way are looked for, which there are
/// where r_capt < 2.5 R.
///
/// *Unequal radii*: capture is by the gap between the surfaces, r_capt − 2r̄ for every pair with
/// r̄ the middle of the bounds, r_capt − r̄ for the substrate; the proof above stays (a factor of
/// the radii instead would let a sphere be drawn into a smaller one).
///
/// Any unit of length. In the thesis' units R = 1, and r_capt = 3 gives a porosity of 92 %.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, Until};
/// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(Until::Cut(61.5), 1)?;
/// assert!((deposit.porosity() - 0.92).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ballistic {
    space: PeriodicBox,
    width: f64,
    radii: [f64; 2],
    capture_radius: f64,
}

/// When a deposit is complete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// With the first sphere whose highest point reaches this height above the substrate. That
    /// sphere stays, so that the [height](Deposit::height) of the deposit, where a piston just
    /// touches it, lies between this one and a sphere's diameter more.
    Height(f64),
    /// Grown higher and cut at this height: spheres that reach above it are taken away, so that the
    /// deposit has the density of the bulk up to the cut. Every parent stays, as it stands below
    /// (of unequal radii, what a removed sphere held goes too). Growth ends as soon as so many
    /// spheres in a row have come to rest above the cut as would cover the base ten times.
    ///
    /// A piston at the cut nearly touches the highest sphere (0.15R below on 20R × 20R). Spheres
    /// and porosities of the thesis come out so, 470 on 20R × 20R to 61.5R and 1015 on 25R × 25R to
    /// 87.5R; deposits that end with a [height](Self::Height) are loose below it, with 9 % less.
    Cut(f64),
    /// With so many spheres.
    Count(usize),
}

/// Spheres that rest on each other.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, Deposit, SUBSTRATE, Until};
/// use tribos::record::Partner;
/// let deposit: Deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(Until::Count(200), 1)?;
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
    /// The sphere that each one touches, an earlier one; `None` for the substrate.
    pub parents: Vec<Option<u32>>,
    /// Side of the square base.
    pub width: f64,
    /// The space, periodic in x and y after `width`.
    pub space: PeriodicBox,
    /// Highest point of all spheres.
    pub height: f64,
}

impl Ballistic {
    /// Equal spheres of `radius` on a base of `width` × `width`. *Domain*: all finite and
    /// positive, 2 radius ≤ `capture_radius` ≤ width/2.
    pub fn new(width: f64, radius: f64, capture_radius: f64) -> Result<Self, DepositError> {
        Self::uneven(width, [radius; 2], capture_radius)
    }

    /// Spheres of radii uniform between two bounds. *Domain*: all finite and positive, the bounds
    /// in order, their sum ≤ `capture_radius`, and the two largest capture within width/2.
    ///
    /// ```
    /// use tribos::powder::deposit::{Ballistic, Until};
    /// let deposit = Ballistic::uneven(20.0, [0.8, 1.2], 3.0)?.grow(Until::Count(100), 1)?;
    /// assert!(deposit.radii.iter().all(|radius| (0.8..=1.2).contains(radius)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn uneven(width: f64, radii: [f64; 2], capture_radius: f64) -> Result<Self, DepositError> {
        let [low, high] = radii;
        for (name, given) in [
            ("width", width),
            ("smallest radius", low),
            ("largest radius", high),
            ("capture radius", capture_radius),
        ] {
            if !given.is_finite() || given <= 0.0 {
                return Err(DepositError::NotPositive { name, given });
            }
        }
        let space = PeriodicBox::new([Some(width), Some(width), None])?;
        let least = low + high;
        let farthest = high - low + capture_radius;
        if low > high {
            Err(DepositError::Radii { low, high })
        } else if capture_radius < least {
            Err(DepositError::CaptureRadius {
                given: capture_radius,
                least,
            })
        } else if farthest > 0.5 * width {
            Err(DepositError::Narrow { width, farthest })
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
        self.capture_radius - (self.radii[0] + self.radii[1])
    }

    /// The gap above the substrate at which it captures.
    fn substrate_gap(&self) -> f64 {
        self.capture_radius - 0.5 * (self.radii[0] + self.radii[1])
    }
}
