//! Status codes.

use core::ffi::{CStr, c_char};
use tribos_core::Error;
use tribos_core::contact::ContactError;
use tribos_core::law::LawError;
use tribos_core::manifold::ContactSystemError;
use tribos_core::patch::PatchError;
use tribos_core::patch::mesh::MeshError;
use tribos_core::patch::outline::OutlineError;

/// 0 after success; any other value gives the reason why the results were not written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum tribos_status {
    /// The result has been written.
    Ok = 0,
    /// A pointer is null.
    NullPointer = 1,
    /// A number of elements exceeds the address space.
    Count = 2,
    /// An enumerator has no valid value.
    Choice = 3,
    /// The memory of a table was not filled by its build function.
    NotBuilt = 4,
    /// A friction coefficient is negative, infinite or NaN.
    Coefficient = 10,
    /// An exponent alpha is NaN or not between -1 (excluded) and the largest one of the tier.
    Exponent = 11,
    /// A parameter that must be positive and finite is not.
    NotPositive = 12,
    /// A parameter that must be finite and not negative is not.
    Negative = 13,
    /// A fraction is NaN or not between 0 and 1.
    NotAFraction = 14,
    /// Two parameters are in the wrong order, such as a dynamic coefficient above the static one.
    Order = 15,
    /// The law has no minimum at a positive speed.
    NoMinimum = 16,
    /// The radius of the contact is not positive and finite.
    Radius = 20,
    /// The order q of the pressure is not between -1 and 8.
    PressureOrder = 21,
    /// The inner over the outer radius of an annulus is not between 0 and 0.999999.
    InnerRatio = 22,
    /// A semi-axis is not positive and finite, or one is more than 1e6 times as long as the other.
    SemiAxes = 23,
    /// A node has a position that is not finite.
    NodePosition = 30,
    /// A node's weight is negative or NaN, or makes the sum infinite.
    NodeWeight = 31,
    /// No node, or no foot, carries load.
    Unloaded = 32,
    /// The nodes do not fit into the given memory.
    Full = 33,
    /// Three feet lie on a line.
    FeetInLine = 34,
    /// A body on three feet tips over.
    Tips = 35,
    /// A loop of a polygon has fewer than 3 corners.
    Corners = 36,
    /// No corner of the polygon sees all of it, or its area is zero.
    Hidden = 37,
    /// The number of divisions is not between 1 and 1024.
    Divisions = 38,
    /// The number of rings or angles is not between 1 and 1024.
    Rings = 39,
    /// The rim exponent of a pressure is not between -1 (excluded) and 64.
    RimExponent = 40,
    /// The pressure on a polygon is linear already.
    Leans = 41,
    /// Edges of a polygon touch or cross, a hole lies outside, or a loop has no area.
    Outline = 42,
    /// The patch has two coefficients already.
    Axes = 43,
    /// The force limit is negative, infinite or NaN.
    ForceLimit = 50,
    /// The reduced torque of pure spinning is not positive and finite.
    SpinTorque = 51,
    /// The deceleration of a slider is not positive and finite.
    Deceleration = 60,
    /// The inertia ratio of a slider is not positive and finite.
    Inertia = 61,
    /// The motion does not come to rest, or is not finite.
    NoRest = 62,
    /// The push is more than friction of all feet carries: no motion is steady.
    Accelerates = 63,
    /// The search for a steady motion ended before friction balanced the push, or the push is NaN.
    Missed = 64,
    /// There is no normal: centres coincide, or one lies in the plate.
    NoNormal = 70,
    /// A position, a radius or the motion of a surface is not finite, or a radius is not positive.
    NotFinite = 71,
    /// A time step is not positive and finite.
    TimeStep = 72,
}

impl tribos_status {
    /// All statuses; each has a name in C.
    pub const fn all() -> [Self; 40] {
        [
            Self::Ok,
            Self::NullPointer,
            Self::Count,
            Self::Choice,
            Self::NotBuilt,
            Self::Coefficient,
            Self::Exponent,
            Self::NotPositive,
            Self::Negative,
            Self::NotAFraction,
            Self::Order,
            Self::NoMinimum,
            Self::Radius,
            Self::PressureOrder,
            Self::InnerRatio,
            Self::SemiAxes,
            Self::NodePosition,
            Self::NodeWeight,
            Self::Unloaded,
            Self::Full,
            Self::FeetInLine,
            Self::Tips,
            Self::Corners,
            Self::Hidden,
            Self::Divisions,
            Self::Rings,
            Self::RimExponent,
            Self::Leans,
            Self::Outline,
            Self::Axes,
            Self::ForceLimit,
            Self::SpinTorque,
            Self::Deceleration,
            Self::Inertia,
            Self::NoRest,
            Self::Accelerates,
            Self::Missed,
            Self::NoNormal,
            Self::NotFinite,
            Self::TimeStep,
        ]
    }

    fn text(self) -> &'static CStr {
        match self {
            Self::Ok => c"no error",
            Self::NullPointer => c"a pointer is null",
            Self::Count => c"a count is larger than any memory",
            Self::Choice => c"a choice is none of those listed for it",
            Self::NotBuilt => c"the memory was not filled by its build function",
            Self::Coefficient => c"the coefficient must be finite and not negative",
            Self::Exponent => c"the exponent alpha must be above -1 and not above the largest one",
            Self::NotPositive => c"a parameter must be positive and finite",
            Self::Negative => c"a parameter must be finite and not negative",
            Self::NotAFraction => c"a fraction must be between 0 and 1",
            Self::Order => c"two parameters are in the wrong order",
            Self::NoMinimum => c"the law has no minimum at a positive speed",
            Self::Radius => c"the contact radius must be positive and finite",
            Self::PressureOrder => c"the order of the pressure must be between -1 and 8",
            Self::InnerRatio => c"inner radius / outer radius must be between 0 and 0.999999",
            Self::SemiAxes => {
                c"semi-axes must be positive and finite, one at most 1e6 times the other"
            }
            Self::NodePosition => c"a node must lie at a finite place",
            Self::NodeWeight => c"a node must carry a finite weight, not negative",
            Self::Unloaded => c"at least one node or foot must carry load",
            Self::Full => c"the nodes do not fit: give more memory",
            Self::FeetInLine => c"three feet must span a triangle",
            Self::Tips => c"the body tips over: a foot would have to pull",
            Self::Corners => c"a polygon has at least 3 corners",
            Self::Hidden => c"a corner must see all of the polygon: cut it into several",
            Self::Divisions => c"divisions must be from 1 to 1024",
            Self::Rings => c"rings and angles must be from 1 to 1024",
            Self::RimExponent => c"the exponent at the rim must be above -1 and not above 64",
            Self::Leans => c"only a polygon under uniform pressure can lean",
            Self::Outline => c"edges must not touch, holes lie inside, each loop has an area",
            Self::Axes => c"the patch has two coefficients already",
            Self::ForceLimit => c"the force limit must be finite and not negative",
            Self::SpinTorque => c"the reduced torque of spinning must be positive and finite",
            Self::Deceleration => c"the deceleration must be positive and finite",
            Self::Inertia => c"the inertia ratio must be positive and finite",
            Self::NoRest => c"the motion has no rest, or is not finite",
            Self::Accelerates => c"the push is more than friction of all feet carries",
            Self::Missed => c"the search for the steady motion missed it",
            Self::NoNormal => c"centres coincide or lie in the plate: there is no normal",
            Self::NotFinite => c"positions and surfaces must be finite, radii positive and finite",
            Self::TimeStep => c"a time step must be positive and finite",
        }
    }
}

/// The meaning of a status as a line of English text. The text is a constant of the program.
///
/// *Special values*: a number that is no status gives "no such status".
#[unsafe(no_mangle)]
pub extern "C" fn tribos_status_text(status: i32) -> *const c_char {
    let known = tribos_status::all()
        .into_iter()
        .find(|s| *s as i32 == status);
    known.map_or(c"no such status", |s| s.text()).as_ptr()
}

impl From<LawError> for tribos_status {
    fn from(error: LawError) -> Self {
        match error {
            LawError::Coefficient { .. } => Self::Coefficient,
            LawError::Exponent { .. } | LawError::NotDry { .. } => Self::Exponent,
            LawError::NotPositive { parameter, .. } => match parameter {
                // What has a status of its own.
                "reduced torque of pure spinning" => Self::SpinTorque,
                "deceleration (coefficient x gravity)" => Self::Deceleration,
                "inertia ratio C = I/(M R^2)" => Self::Inertia,
                "time step" => Self::TimeStep,
                _ => Self::NotPositive,
            },
            LawError::Negative { parameter, .. } => match parameter {
                "force limit" | "friction limit of a foot" => Self::ForceLimit,
                _ => Self::Negative,
            },
            LawError::NotFinite { parameter, .. } => match parameter {
                "motion of a surface" => Self::NotFinite,
                _ => Self::Negative,
            },
            LawError::NotAFraction { .. } => Self::NotAFraction,
            LawError::Order { .. } => Self::Order,
        }
    }
}

impl From<PatchError> for tribos_status {
    fn from(error: PatchError) -> Self {
        match error {
            PatchError::Radius { .. } => Self::Radius,
            PatchError::Order { .. } => Self::PressureOrder,
            PatchError::InnerRatio { .. } => Self::InnerRatio,
            PatchError::SemiAxes { .. } | PatchError::NoImage => Self::SemiAxes,
            PatchError::Height { .. } | PatchError::Lean { .. } | PatchError::Negative => {
                Self::Negative
            }
            PatchError::NodePosition { .. } | PatchError::CornerPosition { .. } => {
                Self::NodePosition
            }
            PatchError::Centre | PatchError::CornerDistance => Self::NotFinite,
            PatchError::CentreOutside => Self::Outline,
            PatchError::NodeWeight { .. } => Self::NodeWeight,
            PatchError::NoLoad | PatchError::Unloaded => Self::Unloaded,
            PatchError::OnePlace => Self::FeetInLine,
            PatchError::Full { .. } => Self::Full,
            PatchError::FeetInLine => Self::FeetInLine,
            PatchError::FootPulls { .. } | PatchError::Tips { .. } => Self::Tips,
            PatchError::Corners { .. } | PatchError::NoCorners => Self::Corners,
            PatchError::Hidden => Self::Hidden,
            PatchError::Divisions { .. } => Self::Divisions,
            PatchError::RuleOrder { .. } => Self::Rings,
            PatchError::RimExponent { .. } => Self::RimExponent,
            // Of elastic ellipses alone, which C does not have.
            PatchError::CurvatureRatio { .. } | PatchError::Unsolved => Self::NotPositive,
        }
    }
}

impl From<OutlineError> for tribos_status {
    fn from(error: OutlineError) -> Self {
        match error {
            OutlineError::Corners { .. } => Self::Corners,
            OutlineError::Position { .. } => Self::NodePosition,
            OutlineError::Repeated { .. }
            | OutlineError::Crossing { .. }
            | OutlineError::Flat { .. }
            | OutlineError::Hole { .. }
            | OutlineError::Open => Self::Outline,
            OutlineError::Extent | OutlineError::Slope => Self::NotFinite,
            OutlineError::Room { .. } => Self::Full,
            OutlineError::LiftOff { .. } => Self::Negative,
        }
    }
}

impl From<MeshError> for tribos_status {
    fn from(error: MeshError) -> Self {
        match error {
            MeshError::Empty | MeshError::Unloaded => Self::Unloaded,
            MeshError::Room { .. } => Self::Full,
            MeshError::Index { .. } => Self::Choice,
            MeshError::Position { .. } => Self::NodePosition,
            MeshError::Pressure { .. } => Self::NodeWeight,
            MeshError::Extent => Self::NotFinite,
        }
    }
}

impl From<ContactError> for tribos_status {
    fn from(error: ContactError) -> Self {
        match error {
            ContactError::NoNormal => Self::NoNormal,
            ContactError::NotFinite => Self::NotFinite,
        }
    }
}

impl From<Error> for tribos_status {
    fn from(error: Error) -> Self {
        match error {
            Error::Law(error) => error.into(),
            Error::Patch(error) => error.into(),
            Error::Outline(error) => error.into(),
            Error::Mesh(error) => error.into(),
            Error::Touch(error) => error.into(),
            Error::Manifold(ContactSystemError::Full { .. }) => Self::Full,
            Error::Manifold(_) => Self::Choice,
        }
    }
}
