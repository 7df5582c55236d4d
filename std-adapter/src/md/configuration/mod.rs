//! Atoms as files hold them: numbered, in a box.

mod format;

pub use format::{Format, read};

use super::atoms::Atoms;
use crate::space::{PeriodicBox, PeriodicBoxError};
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
/// Places are those of the file, to the bit: they are not moved to a box that begins at 0, since
/// only the periods matter to who is near whom.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// The atoms in the order of the file. Velocities are 0 and masses 1 where the file has none.
    pub atoms: Atoms,
    /// Number of each atom, all different.
    pub ids: Vec<u64>,
    /// Name of each species, `None` where the file has numbers.
    pub names: Option<Vec<String>>,
    /// Ends of the box, low and high, along x, y and z.
    pub bounds: [[f64; 2]; 3],
    /// False where the file has no box: its ends are then those of the places.
    pub has_box: bool,
    /// Axes along which space repeats; a LAMMPS data file does not tell, then all.
    pub is_periodic: [bool; 3],
    /// Step at which the state was, 0 where the file does not tell.
    pub step: u64,
    /// Forces, where the file has them.
    pub forces: Option<Vec<Vector3<f64>>>,
}

impl Configuration {
    /// Edges of the box.
    pub fn lengths(&self) -> [f64; 3] {
        self.bounds.map(|[low, high]| high - low)
    }

    /// Volume of the box, open axes from end to end.
    pub fn volume(&self) -> f64 {
        self.lengths().iter().product()
    }

    /// Space that repeats itself along the periodic axes.
    pub fn space(&self) -> Result<PeriodicBox, PeriodicBoxError> {
        let lengths = self.lengths();
        PeriodicBox::new(std::array::from_fn(|axis| {
            self.is_periodic[axis].then_some(lengths[axis])
        }))
    }
}
