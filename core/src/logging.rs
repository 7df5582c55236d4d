//! What is logged of types whose fields cannot say it themselves: vectors, and tables, whose
//! numbers nobody wants to read.

use crate::contact::internals::{InPlane, PreparedContact, TangentialLoad};
use crate::contact::{Contact, ContactModes, Modal, Plate, Sphere, Touch};
use crate::coupling::round::{LateralPolynomialTable, PolynomialTable, RoundTable};
use crate::coupling::table::Table;
use crate::coupling::tall::TallWrench;
use crate::coupling::{DryCoupling, Lateral, Profile, compact};
use crate::limit_surface::{Ellipsoid, FrictionSet, LimitSurface};
use crate::patch::nodes::{NodeBuffer, NodeList, NodePatch, NodeSlice};
use crate::planar::{NodeFoot, PlanarStep};
use crate::real::Real;
use defmt::{Format, Formatter, write};
use nalgebra::Vector3;

/// A vector by its components.
struct Components<R>(Vector3<R>);

impl<R: Real + Format> Format for Components<R> {
    fn format(&self, f: Formatter) {
        write!(f, "[{}, {}, {}]", self.0.x, self.0.y, self.0.z);
    }
}

impl<R: Real + Format> Format for Sphere<R> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "sphere at velocity {}, spin {}, 1/m {}, 1/I {}",
            Components(self.velocity),
            Components(self.spin),
            self.inv_mass,
            self.inv_inertia
        );
    }
}

impl<R: Real + Format> Format for Plate<R> {
    fn format(&self, f: Formatter) {
        let velocity = Components(self.velocity);
        write!(f, "plate at velocity {}, 1/m {}", velocity, self.inv_mass);
    }
}

impl<R: Real + Format> Format for TangentialLoad<R> {
    fn format(&self, f: Formatter) {
        let sliding = Components(self.sliding);
        write!(f, "sliding {}, torsion {}", sliding, self.torsion);
    }
}

impl<R: Real + Format> Format for InPlane<R> {
    fn format(&self, f: Formatter) {
        Components(self.0).format(f);
    }
}

impl<R: Real + Format, M: ContactModes<R>> Format for Modal<R, M> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "normal {}, sliding {}, rolling {}, torsion {}",
            self.normal,
            Components(self.sliding()),
            Components(self.rolling()),
            self.torsion()
        );
    }
}

impl<R: Real + Format> Format for Touch<R> {
    fn format(&self, f: Formatter) {
        let normal = Components(self.normal);
        write!(f, "touch along {}, gap {}", normal, self.gap);
    }
}

impl<R: Real + Format, M: ContactModes<R>> Format for Contact<R, M> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "contact along {}, bound {}, impulse {}",
            Components(*self.normal()),
            self.bound(),
            self.impulse()
        );
    }
}

impl<R: Real + Format> Format for TallWrench<R> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "{}, lean [{}, {}], {}",
            self.wrench, self.lean.x, self.lean.y, self.footing
        );
    }
}

impl<R: Real + Format, C: DryCoupling<R> + Format> Format for LimitSurface<R, C> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "limit surface of {}, force {}, radius {}",
            self.coupling(),
            self.force_limit(),
            self.radius()
        );
    }
}

impl<R: Real + Format> Format for Ellipsoid<R> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "ellipsoid of force {}, torque {}, radius {}",
            self.force_limit(),
            self.torque_limit(),
            self.radius()
        );
    }
}

impl<R: Real + Format, const CAPACITY: usize> Format for NodeList<R, CAPACITY> {
    fn format(&self, f: Formatter) {
        self.nodes().format(f);
    }
}

impl<R, const CELLS: usize, const TERMS: usize> Format for Table<R, CELLS, TERMS>
where
    R: Real + Format,
{
    fn format(&self, f: Formatter) {
        write!(f, "table of the disk, exponent {}", self.exponent());
    }
}

impl<R, const CELLS: usize, const TERMS: usize> Format for RoundTable<R, CELLS, TERMS>
where
    R: Real + Format,
{
    fn format(&self, f: Formatter) {
        let (exponent, mean_square) = (self.exponent(), self.mean_square_radius());
        write!(f, "table of exponent {}, mean r² {}", exponent, mean_square);
    }
}

impl Format for PolynomialTable {
    fn format(&self, f: Formatter) {
        let exponent: f64 = self.exponent();
        write!(f, "table of a polynomial pressure, exponent {}", exponent);
    }
}

impl Format for LateralPolynomialTable {
    fn format(&self, f: Formatter) {
        let (exponent, mean_square) = (self.exponent(), self.mean_square_radius());
        write!(f, "table of exponent {}, mean r² {}", exponent, mean_square);
    }
}

impl<R: Real + Format> Format for compact::CompactPower<R> {
    fn format(&self, f: Formatter) {
        let (exponent, mean_square) = (self.exponent(), self.mean_square_radius());
        write!(f, "compact, exponent {}, mean r² {}", exponent, mean_square);
    }
}

impl<R: Real + Format> Format for PreparedContact<R> {
    fn format(&self, f: Formatter) {
        let normal = Components(self.normal);
        write!(f, "prepared contact along {}, {}", normal, self.block);
    }
}

impl<R: Real + Format> Format for NodeSlice<'_, R> {
    fn format(&self, f: Formatter) {
        write!(f, "nodes {}", self.nodes());
    }
}

impl<R: Real + Format> Format for NodeBuffer<'_, R> {
    fn format(&self, f: Formatter) {
        write!(f, "nodes {}", self.nodes());
    }
}

impl<R: Real + Format> Format for PlanarStep<R> {
    fn format(&self, f: Formatter) {
        write!(
            f,
            "{} under {}, at rest: {}",
            self.twist, self.friction, self.is_at_rest
        );
    }
}

impl<R: Real + Format, P: NodePatch<R>, const CAPACITY: usize> Format for NodeFoot<R, P, CAPACITY> {
    fn format(&self, f: Formatter) {
        let points = self.patch().nodes().len();
        write!(f, "foot of {} points, limit {}", points, self.force_limit());
    }
}
