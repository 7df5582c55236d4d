//! What is prepared and kept: patches, laws, contact laws, floors, supports of any pressure.
//!
//! | module | contents |
//! |---|---|
//! | [`store`] | prepared things by their handles |
//! | [`prepared`] | friction of a patch under a law, with its limit surfaces and free motions |
//! | [`separate`] | force and torque limited each by itself |
//! | [`floor`] | several surfaces under a patch, several feet, two coefficients |
//! | [`launches`] | launches that end at a wanted pose |
//! | [`contact`] | contacts of spheres and plates |
//! | [`catalogue`] | the laws of the library |

pub mod catalogue;
pub mod contact;
pub mod floor;
pub mod launches;
pub mod prepared;
pub mod separate;
pub mod store;
