//! Contacts whose factors leave the number range while force and torque need not.
//!
//! Under |v|^α force and torque are homogeneous in the speeds. With v = 2^e v' and w = 2^e w', the
//! larger one of v' and w' of order 1,
//!
//! ```text
//! F = 2^(e α) γ N F(v', w'),     T = 2^(e α) γ N R T(v', w')
//! ```
//!
//! and what the smaller speed alone causes (F where the rim leads, else T and the lateral force)
//! is linear in it as soon as its square is below rounding: it is evaluated at 2^-[`TINY`] of the
//! larger one and taken down. All products are formed as [`ExtendedRange`]s.

use super::contact::{Contact, Kind, Resistance};
use super::extended_range::ExtendedRange;
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::friction::Precision;
use tribos_core::Real;
use tribos_core::coupling::ReducedFriction;
use tribos_core::internals::leaning_wrench;
use tribos_core::twist::Twist;

/// Ratio of the speeds, 2^-TINY, whose square is below rounding and a normal number.
fn tiny<R: Real>() -> i64 {
    least_exponent::<R>() / 4
}

/// Digits of the smallest normal number: 1022, or 126 for f32.
fn least_exponent<R: Real>() -> i64 {
    -ExtendedRange::new(R::MIN_POSITIVE.to_f64()).exponent()
}

/// Two speeds in units of 2^e.
struct Scaled<R> {
    speeds: [R; 2],
    /// e, zero if the law is not homogeneous.
    unit: i64,
    /// By how much the smaller one is less than what stands for it, a power of two.
    lift: ExtendedRange,
    slides: bool,
}

impl<R: Precision> Contact<R> {
    /// True if no product of the evaluation comes near the ends of the range.
    pub fn is_ordinary(&self, load: R, speed: R, spin: R) -> bool {
        let size = |x: R| ExtendedRange::new(x.to_f64()).exponent().abs();
        let radius = size(self.radius);
        let speeds = size(speed) + size(spin) + radius;
        let degree = self.alpha.map_or(2.0, |alpha| alpha.abs() + 2.0);
        let strength = size(self.coefficient) + size(load) + 2 * radius;
        let worst = strength as f64 + degree * speeds as f64;
        // A quarter of the range is left for what is summed on the way.
        worst < 0.75 * least_exponent::<R>() as f64
    }

    /// [`Contact::resistance`] from products without ends.
    pub fn extreme_resistance(
        &self,
        load: R,
        speed: R,
        spin: R,
    ) -> Result<Resistance<ExtendedRange>, Failure> {
        let at = self.scaled(speed, spin)?;
        let [v, w] = at.speeds;
        // In units of the radius, for unit load and coefficient.
        let [force, lateral, torque] = match &self.kind {
            Kind::Round {
                friction,
                tilt: None,
            } => {
                let reduced = friction.coupling().reduced_wrench(v, w);
                [reduced.force, R::ZERO, reduced.torque]
            }
            Kind::Round {
                friction,
                tilt: Some(tilt),
            } => {
                let reduced = leaning_wrench(friction.coupling(), [v, w], [*tilt, R::ZERO]);
                [reduced.force, reduced.lateral, reduced.torque]
            }
            Kind::Nodes(friction) => {
                let reduced = friction.wrench(R::ONE, &Twist::new(v, R::ZERO, w));
                [reduced.force.x, reduced.force.y, reduced.torque].map(|x| R::ZERO - x)
            }
        };
        let power = ExtendedRange::power_of_two(at.unit, self.alpha.unwrap_or(0.0));
        let [coefficient, load, radius] = [self.coefficient, load, self.radius].map(product);
        let strength = power.times(coefficient).times(load);
        // What the smaller speed alone causes.
        let [by_slide, by_rim] = if at.slides {
            [ExtendedRange::ONE, at.lift]
        } else {
            [at.lift, ExtendedRange::ONE]
        };
        Ok(Resistance {
            force: strength.times(by_slide).times(product(force)),
            lateral: strength.times(by_rim).times(product(lateral)),
            torque: strength.times(by_rim).times(product(torque)).times(radius),
        })
    }

    /// [`Contact::jacobian`] from products without ends, for speed ≥ 0 and spin ≥ 0: ∂F/∂v,
    /// ∂F/∂ω and ∂T/∂ω.
    pub fn extreme_jacobian(
        &self,
        load: R,
        speed: R,
        spin: R,
    ) -> Result<Option<[ExtendedRange; 3]>, Failure> {
        let at = self.scaled(speed, spin)?;
        let [v, w] = at.speeds;
        let reduced = match &self.kind {
            Kind::Round { friction, .. } => friction.coupling().reduced_jacobian(v, w),
            Kind::Nodes(_) => return Ok(None),
        };
        let rate = self.alpha.map_or(ExtendedRange::ONE, |alpha| {
            ExtendedRange::power_of_two(at.unit, alpha - 1.0)
        });
        let [coefficient, load, radius] = [self.coefficient, load, self.radius].map(product);
        let strength = rate.times(coefficient).times(load);
        // Dry friction does not feel the larger speed alone: its slope goes with the square of the
        // smaller one.
        let square = match self.alpha {
            Some(0.0) => at.lift.times(at.lift),
            _ => ExtendedRange::ONE,
        };
        let [by_slide, by_rim] = if at.slides {
            [square, ExtendedRange::ONE]
        } else {
            [ExtendedRange::ONE, square]
        };
        let slope = |x: R| strength.times(product(x));
        Ok(Some([
            slope(reduced.force_slide).times(by_slide),
            slope(reduced.mixed).times(at.lift).times(radius),
            slope(reduced.torque_rim)
                .times(by_rim)
                .times(radius)
                .times(radius),
        ]))
    }

    /// The speeds of centre and rim in a unit that suits them.
    fn scaled(&self, speed: R, spin: R) -> Result<Scaled<R>, Failure> {
        let slide = product(speed);
        let rim = product(spin).times(product(self.radius));
        let slides = slide.exceeds(rim);
        let (major, minor) = if slides { (slide, rim) } else { (rim, slide) };
        let unit = match self.alpha {
            Some(_) if !major.is_zero() => major.exponent(),
            _ => 0,
        };
        let down = |x: ExtendedRange| x.shifted(-unit);
        let is_round = !matches!(self.kind, Kind::Nodes(_));
        let least = -tiny::<R>();
        let (minor, lift) = if is_round
            && self.alpha.is_some()
            && !minor.is_zero()
            && down(minor).exponent() < least
        {
            let by = down(minor).exponent() - least;
            (down(minor).shifted(-by), ExtendedRange::ONE.shifted(by))
        } else {
            (down(minor), ExtendedRange::ONE)
        };
        let [major, minor] = [down(major), minor].map(ExtendedRange::narrowed::<R>);
        if !(major.1 && minor.1) {
            return Err(Failure::input(format!(
                "speed {} and spin {} at radius {}: the speed of the rim, or its ratio to the other, \
                 leaves the number range, and this law or patch needs both; change the units",
                shown(speed.to_f64()),
                shown(spin.to_f64()),
                shown(self.radius.to_f64())
            )));
        }
        let speeds = if slides {
            [major.0, minor.0]
        } else {
            [minor.0, major.0]
        };
        Ok(Scaled {
            speeds,
            unit,
            lift,
            slides,
        })
    }
}

fn product<R: Real>(x: R) -> ExtendedRange {
    ExtendedRange::new(x.to_f64())
}
