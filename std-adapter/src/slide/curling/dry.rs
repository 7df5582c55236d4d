//! A dry rock.

use super::{CurlingModel, CurlingRock, IceLaw};
use crate::slide::SlideError;
use crate::slide::planar::Resistance;

/// Coulomb friction under a rock that leans forward, as under a cylinder on a table.
///
/// *Formula*: pressure p (1 + l·r) with l = −2 h F/(N R), friction μ against each element's
/// velocity. *Source*: eqs. 3.37 and 3.38 of the thesis. *How sure*: certain physics, and the
/// right answer for a cylinder; refuted for ice, where rocks go the other way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dry {
    /// μ
    pub coefficient: f64,
}

impl CurlingModel for Dry {
    fn name(&self) -> &'static str {
        "dry"
    }

    fn resistance(&self, rock: &CurlingRock) -> Result<Box<dyn Resistance>, SlideError> {
        let ice = IceLaw {
            coefficient: self.coefficient,
            alpha: 0.0,
        };
        Ok(Box::new(rock.body(ice, rock.height)?))
    }
}
