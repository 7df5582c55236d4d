//! The step of feet in MuJoCo, attached to a simulation by the addresses of its arrays.
//!
//! The step itself is in C, that of the plugin `tribos.patch`. MuJoCo lays its structures out anew in each version; the
//! plugin is compiled for one, whoever attaches feet from outside serves all.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::fmt;

/// All friction (N, N, N m) that an area can carry, under each force limit in N.
pub trait Carry: Send + Sync {
    /// The largest torque per force, in m.
    fn arm(&self) -> f64;
    /// The friction nearest to a wrench, where torques are divided by a length in m; NaN for what is not finite.
    fn project(&self, force_limit: f64, wrench: [f64; 3], length: f64) -> [f64; 3];
    /// The friction that opposes a motion (m/s, m/s, rad/s); none opposes rest, and NaN what is not finite.
    fn oppose(&self, force_limit: f64, motion: [f64; 3]) -> [f64; 3];
}

/// A foot, by MuJoCo's indices.
#[derive(Clone, Debug)]
pub struct FootModel {
    /// Geoms that share the patch.
    pub geoms: Vec<c_int>,
    /// Geom that they stand on.
    pub ground: c_int,
    /// Bodies of the foot and of its ground that joints move.
    pub bodies: [c_int; 2],
    /// What has the frame of the patch: 0 a geom, 1 a body, 2 a site; and its index.
    pub frame: [c_int; 2],
    /// Coefficient of friction.
    pub mu: f64,
}

/// A simulation by addresses.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Simulation {
    /// Address of the addresses of the arrays that [`arrays`] names, in its order.
    pub arrays: *const usize,
    /// MuJoCo's function `mj_solveM`, which raises none of its errors: nothing unwinds or jumps through a step.
    pub solve: usize,
    /// The `mjModel`.
    pub model: usize,
    /// The `mjData`.
    pub data: usize,
    /// Address of its `body_awake`, or 0 where bodies do not sleep.
    pub awake: usize,
    /// Degrees of freedom, bodies and geoms.
    pub counts: [c_int; 3],
    /// Bytes from one contact to the next; then where in it are, in bytes, distance, position, axes, margin, geoms,
    /// dimension, first row, and the motion of a conveyor's surface, negative where contacts have none.
    pub layout: [c_int; 9],
}

/// Contacts and constraints of a step.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Contacts {
    /// Address of the first contact.
    pub first: *const c_void,
    /// Number of contacts.
    pub count: usize,
    /// Of each row: the inverse of its regularisation.
    pub stiffness: *const f64,
    /// Of each row: stiffness, damping, impedance and its derivative of its reference.
    pub springs: *const f64,
    /// Number of rows.
    pub rows: usize,
}

/// A foot in the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct FootReport {
    /// Sum of its normal forces of the step before, in N.
    pub load: f64,
    /// Friction on it along the patch's x and y in N, about its normal in N m.
    pub friction: [f64; 3],
    /// Its velocity on its ground in m/s, its spin in rad/s, before the step.
    pub twist: [f64; 3],
    /// The patch's x, y and normal in the rows.
    pub axes: [f64; 9],
    /// Origin of the patch, in m.
    pub centre: [f64; 3],
    /// 1 where friction holds it, else 0.
    pub is_held: f64,
    /// Steps so far in which a search for its friction stopped at its count.
    pub missed: f64,
}

/// Why feet are not those of one model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkError {
    /// There is no memory for them.
    NoMemory,
    /// Neither this foot's body nor its ground has a joint.
    NeverMoves {
        /// The foot.
        foot: usize,
    },
    /// Two feet have the friction of the same geoms.
    ClaimedTwice {
        /// The second foot.
        foot: usize,
        /// The first.
        other: usize,
    },
}

/// The set of a foot as C has it.
#[repr(C)]
struct FrictionSet {
    project: extern "C" fn(*const Self, f64, *const [f64; 3], f64, *mut [f64; 3]),
    oppose: extern "C" fn(*const Self, f64, *const [f64; 3], *mut [f64; 3]),
    arm: f64,
    within: Box<dyn Carry>,
}

extern "C" fn project(
    set: *const FrictionSet,
    force_limit: f64,
    wrench: *const [f64; 3],
    length: f64,
    nearest: *mut [f64; 3],
) {
    // SAFETY: C hands the set on that `Feet::new` gave it, and two arrays of its own, which may be one.
    unsafe { *nearest = (*set).within.project(force_limit, *wrench, length) }
}

extern "C" fn oppose(
    set: *const FrictionSet,
    force_limit: f64,
    motion: *const [f64; 3],
    friction: *mut [f64; 3],
) {
    // SAFETY: as in `project`.
    unsafe { *friction = (*set).within.oppose(force_limit, *motion) }
}

#[repr(C)]
struct GivenFoot {
    geoms: *const c_int,
    geom_count: c_int,
    ground: c_int,
    bodies: [c_int; 2],
    frame: [c_int; 2],
    mu: f64,
    set: *const c_void,
}

#[repr(C)]
#[derive(Default)]
struct LinkFault {
    foot: c_int,
    other: c_int,
    geom: c_int,
    ground: c_int,
}

#[repr(C)]
struct Attached {
    _private: [u8; 0],
}

unsafe extern "C" {
    fn attached_arrays() -> *const c_char;
    fn attached_new(
        of: *const Simulation,
        feet: *const GivenFoot,
        count: c_int,
        result: *mut c_int,
        fault: *mut LinkFault,
    ) -> *mut Attached;
    fn attached_free(attached: *mut Attached);
    fn attached_step(
        attached: *mut Attached,
        time: f64,
        timestep: f64,
        contacts: *const Contacts,
    ) -> *const c_char;
    fn attached_report(attached: *const Attached, foot: c_int, out: *mut FootReport);
}

/// Of `link_result`.
const NEVER_MOVES: c_int = 2;
const CLAIMED_TWICE: c_int = 3;

/// Types and names of the arrays of a [`Simulation`], as "type name;" of each.
#[must_use]
pub fn arrays() -> &'static str {
    // SAFETY: a constant text of ASCII.
    let text = unsafe { CStr::from_ptr(attached_arrays()) };
    text.to_str().unwrap_or_default()
}

/// Feet of one simulation.
pub struct Feet {
    attached: *mut Attached,
    /// Where C finds them.
    sets: Box<[FrictionSet]>,
}

// SAFETY: C keeps nothing outside of what `attached` points to, and the methods that change it borrow it alone.
unsafe impl Send for Feet {}
// SAFETY: as above; a report reads.
unsafe impl Sync for Feet {}

impl fmt::Debug for Feet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Feet")
            .field("count", &self.sets.len())
            .finish_non_exhaustive()
    }
}

impl Feet {
    /// Feet with their sets.
    ///
    /// # Safety
    ///
    /// The addresses are those of a simulation, whose arrays have the types and sizes of MuJoCo's and outlive the feet; so are
    /// the indices.
    ///
    /// # Errors
    ///
    /// A [`LinkError`] where feet never move, or have the same geoms.
    pub unsafe fn new(
        simulation: &Simulation,
        feet: Vec<(FootModel, Box<dyn Carry>)>,
    ) -> Result<Self, LinkError> {
        let (mut models, mut sets) = (Vec::new(), Vec::new());
        for (model, within) in feet {
            models.push(model);
            sets.push(FrictionSet {
                project,
                oppose,
                arm: within.arm(),
                within,
            });
        }
        let sets = sets.into_boxed_slice();
        let each = models.iter().zip(sets.iter());
        let given: Vec<GivenFoot> = each.map(|(model, set)| model.given(set)).collect();
        let (mut result, mut fault) = (0, LinkFault::default());
        let count = given.len() as c_int;
        // SAFETY: the caller's promise; C copies what `given` points to but the sets, which `Feet` keeps.
        let attached =
            unsafe { attached_new(simulation, given.as_ptr(), count, &mut result, &mut fault) };
        let foot = fault.foot.cast_unsigned() as usize;
        if !attached.is_null() {
            return Ok(Self { attached, sets });
        }
        Err(match result {
            NEVER_MOVES => LinkError::NeverMoves { foot },
            CLAIMED_TWICE => LinkError::ClaimedTwice {
                foot,
                other: fault.other.cast_unsigned() as usize,
            },
            _ => LinkError::NoMemory,
        })
    }

    /// Adds the friction of a step, in s, that begins at a time, in s, to MuJoCo's passive forces.
    ///
    /// # Safety
    ///
    /// The contacts are those of the simulation that the feet were made for, in its step.
    ///
    /// # Errors
    ///
    /// The reason why there is no friction.
    pub unsafe fn step(
        &mut self,
        time: f64,
        timestep: f64,
        contacts: &Contacts,
    ) -> Result<(), &'static str> {
        // SAFETY: the caller's promise.
        let why = unsafe { attached_step(self.attached, time, timestep, contacts) };
        if why.is_null() {
            return Ok(());
        }
        // SAFETY: a constant text of ASCII.
        Err(unsafe { CStr::from_ptr(why) }.to_str().unwrap_or_default())
    }

    /// A foot in the last step; none for an index beyond the last.
    #[must_use]
    pub fn report(&self, foot: usize) -> Option<FootReport> {
        let mut report = FootReport::default();
        if foot >= self.sets.len() {
            return None;
        }
        // SAFETY: there is such a foot.
        unsafe { attached_report(self.attached, foot as c_int, &mut report) };
        Some(report)
    }
}

impl Drop for Feet {
    fn drop(&mut self) {
        // SAFETY: made by `attached_new`, and freed once.
        unsafe { attached_free(self.attached) }
    }
}

impl FootModel {
    fn given(&self, set: &FrictionSet) -> GivenFoot {
        GivenFoot {
            geoms: self.geoms.as_ptr(),
            geom_count: self.geoms.len() as c_int,
            ground: self.ground,
            bodies: self.bodies,
            frame: self.frame,
            mu: self.mu,
            set: std::ptr::from_ref(set).cast(),
        }
    }
}
