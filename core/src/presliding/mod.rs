//! Elastic friction before sliding: bonds that hold without creep, slip a little, and follow.
//!
//! A patch is bound to the floor by bonds of stiffness k_t (sliding) and k_θ (torsion). They are
//! unstrained in one pose of the patch, the [`Anchor`], which is the whole state: three numbers.
//! In the pose (x, θ) the displacement of the bonds and the wrench with which they pull are
//!
//! ```text
//! e = (x − x_a, θ − θ_a),      z = S e,      S = diag(k_t, k_t, k_θ),      friction = −z
//! ```
//!
//! and z stays in the patch's set K of wrenches that dry friction carries (any
//! [`crate::limit_surface::FrictionSet`]). Where z would leave K, bonds break and re-form: slip runs
//! along the outward normal, as plastic flow does, and the anchor follows the patch. One step to a
//! new pose is the return mapping of plasticity,
//!
//! ```text
//! z⁺ = the point of K nearest to S e in the norm √(z·S⁻¹z),      slip = S⁻¹(S e − z⁺)
//! ```
//!
//! which is [`project_with_length`](crate::limit_surface::FrictionSet::project_with_length) with the
//! length √(k_θ/k_t).
//!
//! *Hold*: inside of K the anchor keeps its bits, and friction is a function of the pose alone. There
//! is nothing that could creep, in any number of steps and under any vibration that stays inside.
//! *Frames*: e is a difference of poses. Another origin and other axes change the result by rounding
//! only. *Stability*: the nearest point depends on e without expansion, whatever the stiffness and
//! the step.
//!
//! *Energy*: the bonds store V = z·S⁻¹z/2. A step with the change Δe of their displacement, the
//! slip and the final friction gives
//!
//! ```text
//! −friction·(motion of the patch) = ΔV + z⁺·slip + Δe·S Δe/2
//! ```
//!
//! The second term is heat, the power of dry friction, and is never negative; the third is of
//! second order in the step and never negative either. With the friction of both ends averaged the
//! third term is absent while the bonds hold.
//!
//! [`Presliding`] is the law for which K is a sharp border, [`MicroslipPresliding`] lets slip begin
//! earlier (Dahl's law, LuGre's, elasto-plastic ones). What scales friction from step to step, such as age
//! or speed, enters as [`crate::limit_surface::ScaledSet`]. For a body with mass see
//! [`crate::planar::PlanarBody::step_elastic`].
//!
//! *Source*: return mapping: J. C. Simo, T. J. R. Hughes, Computational Inelasticity (1998), ch. 1–3;
//! the set as a yield surface: S. Goyal, A. Ruina, J. Papadopoulos, Wear 143 (1991) 307. The pose as a
//! state, instead of a sum of increments, is ours.
//!
//! ```
//! use tribos_core::coupling::coulomb::CoulombDisk;
//! use tribos_core::law::StickSlip;
//! use tribos_core::limit_surface::RoundLimitSurface;
//! use tribos_core::presliding::{Anchor, Pose, Presliding};
//!
//! // A fingertip: μN = 5 N on a disk of 5 mm; 10 N/mm, and k_t R²/2 about the normal.
//! let finger = RoundLimitSurface::new(CoulombDisk, 5.0_f64, 5e-3)?; // N, m
//! let bonds = Presliding::new(1e4, 0.125)?; // N/m, N m/rad
//! let touched = Anchor::at(Pose::new(0.3, 0.1, 0.0)); // m, m, rad
//! // Pulled by 0.2 mm it holds with 2 N, today and in a year.
//! let held = bonds.step(&finger, &touched, &Pose::new(0.3002, 0.1, 0.0));
//! assert!((held.friction.force.x + 2.0).abs() < 1e-9 && held.grip == StickSlip::Stick);
//! assert_eq!(held.anchor, touched);
//! // Pulled by 1 mm it slips by half of that, and its bonds follow.
//! let slid = bonds.step(&finger, &touched, &Pose::new(0.301, 0.1, 0.0));
//! assert!((slid.friction.force.x + 5.0).abs() < 1e-9 && slid.grip == StickSlip::Slip);
//! assert!((slid.anchor.pose.position.x - 0.3005).abs() < 1e-12);
//! assert!((slid.dissipated - 5.0 * 0.5e-3).abs() < 1e-12); // J
//! # Ok::<(), tribos_core::Error>(())
//! ```

mod microslip;
mod nodes;
mod pose;
mod root;
mod step;
mod stiffness;

pub use microslip::MicroslipPresliding;
pub use nodes::{PointPresliding, PointPreslidingStep};
pub(crate) use pose::Axes;
pub use pose::{Anchor, Pose};
pub(crate) use step::not_below_zero;
pub use step::{PreslidingStep, Settled};
pub use stiffness::Presliding;
pub(crate) use stiffness::Stiffness;
