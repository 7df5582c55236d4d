//! Friction of a patch under a law, with its limit surfaces and free motions.

use crate::exchange::{Refused, said};
use crate::friction::Contact;
use crate::modes::FinalMotion;
use crate::slide::{End, Free, Glides};
use alloc::boxed::Box;
use alloc::format;
use core::cell::OnceCell;
use core::fmt;
use tribos_core::slider::{SliderParameters, SliderState};
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};
use tribos_friction::{
    Area, AreaFriction, Law, LimitSurfaces, Patch, RoundPower, Tier, Visitor, upright, visit,
};

/// Friction of a patch under a law.
pub struct Prepared {
    /// Its friction at one motion.
    pub contact: AreaFriction,
    /// The patch.
    pub area: Area,
    sets: OnceCell<Result<LimitSurfaces, Refused>>,
    glides: OnceCell<Result<Box<dyn Glides>, Refused>>,
}

impl fmt::Debug for Prepared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Prepared")
            .field("area", &self.area)
            .field("contact", &self.contact)
            .finish_non_exhaustive()
    }
}

impl Prepared {
    /// Refuses a law that does not serve the patch.
    pub fn new(area: Area, law: &str) -> Result<Self, Refused> {
        let law: Law = law.parse()?;
        Ok(Self {
            contact: AreaFriction::new(&area, &law, None)?,
            area,
            sets: OnceCell::new(),
            glides: OnceCell::new(),
        })
    }

    /// The law.
    pub fn law(&self) -> &Law {
        self.contact.law()
    }

    /// Coefficient and exponent of a power of the speed; NaN for other laws.
    pub fn power(&self) -> [f64; 2] {
        self.law().power_of_speed().unwrap_or([f64::NAN; 2])
    }

    /// Its limit surfaces, of dry friction.
    pub fn sets(&self) -> Result<&LimitSurfaces, Refused> {
        let made = self.sets.get_or_init(|| {
            if self.power()[1] == 0.0 {
                Ok(self.area.limit_surfaces()?)
            } else {
                Err(said(format!(
                    "{} has no limit surface: its friction depends on the speed",
                    self.law()
                )))
            }
        });
        made.as_ref().map_err(Refused::clone)
    }

    /// Its free motions, of a power of the speed on a round patch.
    pub fn glides(&self) -> Result<&dyn Glides, Refused> {
        let made = self.glides.get_or_init(|| {
            let (patch, alpha) = self.round_power()?;
            let slide = Tier::choose::<f64>(patch, self.law(), None)
                .and_then(|tier| visit(patch, alpha, tier, BoxingVisitor))?;
            let profile = upright(patch, alpha)?;
            let powered: Box<dyn Glides> = Box::new(Powered { slide, profile });
            Ok(powered)
        });
        made.as_deref().map_err(Refused::clone)
    }

    /// The round patch and the exponent of its law.
    pub fn round_power(&self) -> Result<(&Patch, f64), Refused> {
        let Area::Round(patch, _) = &self.area else {
            return Err(Refused::Because(
                "only a round patch slides straight: give a disk, ring, annulus or the like; rollout \
                 follows the others",
            ));
        };
        match self.law().power_of_speed() {
            Some([_, alpha]) => Ok((patch, alpha)),
            None => Err(said(format!(
                "{} is not a power of the speed: this needs Coulomb's law or mu |v|^alpha",
                self.law().name()
            ))),
        }
    }
}

/// Free motions in the quickest tier, final motion from closed forms where there are any. Behind a pointer, so
/// that the module has the integrator once and not for each patch.
struct Powered {
    slide: Box<dyn RoundPower<f64>>,
    profile: Box<dyn RoundPower<f64>>,
}

impl Glides for Powered {
    fn to_rest(&self, parameters: SliderParameters<f64>, from: &SliderState<f64>) -> Free {
        End::to_rest(&*self.slide, parameters, from)
    }
    fn advance(
        &self,
        parameters: SliderParameters<f64>,
        from: &SliderState<f64>,
        time: f64,
    ) -> Free {
        End::advance(&*self.slide, parameters, from, time)
    }
    fn modes(&self, inertia_ratio: f64, initial_ratio: f64) -> Result<FinalMotion, Refused> {
        FinalMotion::new(&*self.profile, inertia_ratio, initial_ratio)
    }
}

/// Puts the kernel's type behind a pointer.
struct BoxingVisitor;

impl Visitor<f64> for BoxingVisitor {
    type Output = Box<dyn RoundPower<f64>>;
    fn visit<P: RoundPower<f64> + 'static>(self, friction: P) -> Self::Output {
        Box::new(friction)
    }
}

impl Contact for AreaFriction {
    fn wrench(&self, load: f64, twist: &Twist<f64>) -> Wrench<f64> {
        AreaFriction::wrench(self, load, twist)
    }
    fn jacobian(&self, load: f64, twist: &Twist<f64>) -> WrenchJacobian<f64> {
        self.wrench_jacobian(load, twist)
    }
    fn wrench_batch(&self, load: f64, twists: &[Twist<f64>], wrenches: &mut [Wrench<f64>]) {
        AreaFriction::wrench_batch(self, load, twists, wrenches);
    }
    fn jacobian_batch(
        &self,
        load: f64,
        twists: &[Twist<f64>],
        jacobians: &mut [WrenchJacobian<f64>],
    ) {
        AreaFriction::jacobian_batch(self, load, twists, jacobians);
    }
}

/// The profile that launches are computed from.
pub fn profile(prepared: &Prepared) -> Result<Box<dyn RoundPower<f64>>, Refused> {
    let (patch, alpha) = prepared.round_power()?;
    Ok(upright(patch, alpha)?)
}
