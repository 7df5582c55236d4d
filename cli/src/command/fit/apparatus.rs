//! The machine of a measurement.

use crate::command::number;
use std::str::FromStr;
use tribos::fit::Apparatus;

/// What belongs to the machine and not to friction.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub struct Machine {
    /// Load [N] at which forces were measured: parameters are coefficients then. A column `load` does the same row by row.
    #[arg(long, value_name = "N", value_parser = number::positive)]
    pub load: Option<f64>,
    /// Fit the inertia of the drive as well: the force holds inertia times the acceleration of the column a, or of the velocity's
    /// differences.
    #[arg(long)]
    pub inertia: bool,
    /// Speed [m/s] up to which rows count as rest, and are left out under laws of sliding: friction of a joint that hardly turns
    /// is not yet that of sliding.
    #[arg(long, value_name = "V", default_value = "0", hide_default_value = true, value_parser = number::not_negative)]
    pub slowest: f64,
    /// Fit a constant force as well: the zero of a sensor, or friction that differs between the directions.
    #[arg(long)]
    pub offset: bool,
    /// Under rate-state, v is the speed of the load point, and between it and the contact lies a spring of this stiffness per
    /// load [1/m], or one that is fitted.
    #[arg(long, value_name = "K|fit")]
    pub spring: Option<Spring>,
}

/// The spring of the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spring {
    /// Its stiffness per load, in 1/m.
    Given(f64),
    /// Its stiffness is fitted.
    Fitted,
}

impl FromStr for Spring {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "fit" => Ok(Self::Fitted),
            text => number::positive(text)
                .map(Self::Given)
                .map_err(|why| format!("{why}; or give `fit`")),
        }
    }
}

impl Machine {
    /// What is fitted beside the law.
    pub fn apparatus(&self) -> Apparatus {
        Apparatus {
            inertia: self.inertia,
            offset: self.offset,
            spring: self.spring.is_some(),
        }
    }

    /// Parameters that the options keep.
    pub fn fixed(&self) -> Option<(String, f64)> {
        match self.spring {
            Some(Spring::Given(stiffness)) => Some(("spring".into(), stiffness)),
            _ => None,
        }
    }
}
