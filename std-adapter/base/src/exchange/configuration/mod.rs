//! Atoms as in files: numbered, in a box.

mod format;

pub use format::{Format, read};
#[doc(hidden)]
pub use format::{is_lammps_data, recognised};

use super::atoms::Atoms;
use crate::space::{PeriodicBox, SpaceError};
use nalgebra::Vector3;

/// One state of numbered atoms in an orthogonal box.
///
/// ```
/// use tribos::md::configuration::{Configuration, read};
/// // The cubic cell of copper, 3.615 Å wide.
/// let text = "4\nLattice=\"3.615 0 0 0 3.615 0 0 0 3.615\"\nCu 0 0 0\nCu 0 1.8075 1.8075\n\
///             Cu 1.8075 0 1.8075\nCu 1.8075 1.8075 0\n";
/// let copper: Configuration = read(text)?;
/// assert_eq!(copper.lengths(), [3.615; 3]);
/// assert_eq!(copper.space()?.lengths(), [Some(3.615); 3]); // periodic along all axes
/// // With 63.546 g/mol it weighs 8.93 g/cm³; 0.6022 of a g/(mol Å³) is one.
/// let density = 4.0 * 63.546 / (0.602_214_076 * copper.volume());
/// assert!((density - 8.93).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Positions are those of the file, to the bit: they are not shifted to a box that begins at 0,
/// since neighbours depend only on the periods.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// The atoms in the order of the file. Velocities are 0 and masses 1 where the file has none.
    pub atoms: Atoms,
    /// Unique number of each atom.
    pub ids: Vec<u64>,
    /// Name of each species, `None` where the file has numbers.
    pub names: Option<Vec<String>>,
    /// Low and high end of the box along x, y and z.
    pub bounds: [[f64; 2]; 3],
    /// Whether the file has a box; if not, the box encloses the positions.
    pub has_box: bool,
    /// Axes along which space repeats; all for a LAMMPS data file, which does not specify them.
    pub is_periodic: [bool; 3],
    /// Step of the state, 0 if the file does not contain it.
    pub step: u64,
    /// Forces, if the file has them.
    pub forces: Option<Vec<Vector3<f64>>>,
}

impl Configuration {
    /// Edges of the box.
    pub fn lengths(&self) -> [f64; 3] {
        self.bounds.map(|[low, high]| high - low)
    }

    /// Volume of the box, including its extent along open axes.
    pub fn volume(&self) -> f64 {
        self.lengths().iter().product()
    }

    /// The box as a [`PeriodicBox`], which repeats along the periodic axes.
    pub fn space(&self) -> Result<PeriodicBox, SpaceError> {
        let lengths = self.lengths();
        PeriodicBox::new(std::array::from_fn(|axis| {
            self.is_periodic[axis].then_some(lengths[axis])
        }))
    }
}
