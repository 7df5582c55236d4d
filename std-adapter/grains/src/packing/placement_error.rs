//! Why the spheres of a run cannot be placed.

use crate::packing::SettingError;
use tribos_base::space::SpaceError;
use tribos_contacts::event::{EventError, ImpactError};

/// Largest number of spheres, for which about 4 GB of memory are sufficient.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, MOST_SPHERES, DepositTarget};
/// use tribos::run::PlacementError;
/// let deposit = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Count(MOST_SPHERES + 1), 1);
/// assert_eq!(deposit, Err(PlacementError::TooMany));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const MOST_SPHERES: usize = 20_000_000;

/// Why a deposit cannot be grown, grains cannot be put into their box, or a gas cannot be mixed.
///
/// ```
/// use tribos::powder::deposit::{Ballistic, DepositTarget};
/// use tribos::run::{PackingRunError, PlacementError};
/// // Captured at less than a diameter, spheres would overlap.
/// let inside = Ballistic::new(20.0, 1.0, 1.5);
/// assert_eq!(inside, Err(PlacementError::CaptureRadius { given: 1.5, least: 2.0 }));
/// let nothing = Ballistic::new(20.0, 1.0, 3.0)?.grow(DepositTarget::Count(0), 1);
/// assert_eq!(nothing, Err(PlacementError::Empty));
/// # use tribos::{grains::GrainsSimulation, scene::GrainsScene};
/// // Grains as wide as their box.
/// let wide = GrainsScene { width: 0.01, radius: 0.005, ..GrainsScene::default() };
/// let refused = GrainsSimulation::new(&wide);
/// assert!(matches!(refused, Err(PackingRunError::Placement(PlacementError::NarrowBox { .. }))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlacementError {
    /// A length is not a finite positive number.
    #[error("the {name} must be finite and positive, not {given}")]
    NotPositive {
        /// Name of the length.
        name: &'static str,
        /// Value given.
        given: f64,
    },
    /// The width of the base is not a valid period.
    #[error(transparent)]
    Base(#[from] SpaceError),
    /// The distribution of the radii is refused.
    #[error(transparent)]
    Sizes(#[from] SettingError),
    /// The bounds of the radii are in the wrong order.
    #[error("the smallest radius, {low}, exceeds the largest, {high}")]
    Radii {
        /// Smallest radius.
        low: f64,
        /// Largest radius.
        high: f64,
    },
    /// Spheres would overlap when captured.
    #[error("the capture radius {given} is less than a diameter; give at least {least}")]
    CaptureRadius {
        /// Value given.
        given: f64,
        /// Smallest valid value.
        least: f64,
    },
    /// A sphere could be captured by two periodic images of another.
    #[error("spheres capture each other over {farthest}: the width {width} must be twice that")]
    NarrowBase {
        /// Side of the base.
        width: f64,
        /// Largest distance at which spheres are captured.
        farthest: f64,
    },
    /// The deposit has no sphere, or is cut below the first one.
    #[error("a deposit has one sphere or more; ask for one, or for a height above a diameter")]
    Empty,
    /// There are more spheres than fit into memory.
    #[error("the deposit needs more than {MOST_SPHERES} spheres; make it lower or narrower")]
    TooMany,
    /// The box is narrower than one place of the lattice.
    #[error(
        "the box is {given} wide along {axis}, and a grain needs {needed} there at the start; \
         make the box wider, the grains smaller or `initial_spacing` less"
    )]
    NarrowBox {
        /// Name of the axis.
        axis: &'static str,
        /// Length of the box.
        given: f64,
        /// Length of a place.
        needed: f64,
    },
    /// There are more grains than places.
    #[error(
        "`count` is {given}, and the box has room for {room} grains at the start; \
         {}, or `count` or `initial_spacing` less",
        larger(*.is_drum)
    )]
    Full {
        /// Number of grains.
        given: usize,
        /// Number of places.
        room: usize,
        /// Whether the box is a drum, whose height is its width.
        is_drum: bool,
    },
    /// The cube of a gas has no room for its spheres.
    #[error("the spheres find no place in the cube; take a smaller packing fraction")]
    Room,
    /// The law of a gas's collisions is refused.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// The spheres of a gas are refused.
    #[error(transparent)]
    Events(#[from] EventError),
    /// The caller stopped the placement.
    #[error("the placement was stopped")]
    Stopped,
}

/// What has to be larger for more grains.
fn larger(is_drum: bool) -> &'static str {
    if is_drum {
        "make the `width` of the drum more"
    } else {
        "make the box wider or higher"
    }
}
