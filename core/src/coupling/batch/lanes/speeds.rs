//! The speeds of a group in units of the larger ones, and what profiles make of them.

use super::{LaneProfile, Lanes};
use crate::lanes::{Eight as _, Group, Lanes as _, Numbers};
use crate::real::Real;

/// [`crate::coupling::Speeds`] of a group.
#[derive(Clone, Copy, Debug)]
pub struct LaneSpeeds<R: Real> {
    /// A mask: v > w.
    pub slides: Lanes<R>,
    /// h
    pub ratio: Lanes<R>,
    /// |v − w|/m
    pub gap: Lanes<R>,
}

impl<R: Real> LaneSpeeds<R> {
    /// v/m
    #[inline(always)]
    pub fn slide(&self) -> Lanes<R> {
        Lanes::<R>::select(self.slides, Numbers::repeat(R::ONE), self.ratio)
    }

    /// w/m
    #[inline(always)]
    pub fn rim(&self) -> Lanes<R> {
        Lanes::<R>::select(self.slides, self.ratio, Numbers::repeat(R::ONE))
    }

    /// A mask: sliding leads, as [`crate::coupling::Speeds::lead`] tells it: not where h was rounded to 1.
    #[inline(always)]
    pub fn sliding_leads(&self) -> Lanes<R> {
        self.slides & Lanes::<R>::repeat(R::ONE).above(self.ratio)
    }

    /// The same, a bit for each lane.
    #[inline(always)]
    pub fn leads(&self) -> u32 {
        self.sliding_leads().bits()
    }

    /// z = 1 − h²
    #[inline(always)]
    pub fn complement(&self) -> Lanes<R> {
        self.gap * (Lanes::<R>::repeat(R::ONE) + self.ratio)
    }
}

/// Masks scales with which a product can be formed at once.
#[inline(always)]
pub fn are_ordinary<R: Real>(scale: Lanes<R>) -> Lanes<R> {
    scale.at_least(Numbers::repeat(R::MIN_POSITIVE)) & Lanes::<R>::repeat(R::INFINITY).above(scale)
}

/// F/v and T of ordinary speeds, from v² and w.
#[inline(always)]
pub fn drags<R: Real, P: LaneProfile<R>>(
    profile: &P,
    slide_squares: &Group<R>,
    rims: &Group<R>,
) -> Option<[Group<R>; 2]> {
    let [slide_sq, rim] = [slide_squares, rims].map(|numbers| Lanes::<R>::new(*numbers));
    Some(profile.drags(slide_sq, rim)?.map(Numbers::to_array))
}

/// The same, from v and w.
#[inline(always)]
pub fn drags_of_speeds<R: Real, P: LaneProfile<R> + ?Sized>(
    profile: &P,
    slide: Lanes<R>,
    rim: Lanes<R>,
) -> Option<[Lanes<R>; 2]> {
    let (major, minor) = (slide.larger(rim), slide.smaller(rim));
    let per_major = Lanes::<R>::repeat(R::ONE) / major;
    let at = LaneSpeeds {
        slides: slide.above(rim),
        ratio: minor * per_major,
        gap: (major - minor) * per_major,
    };
    let scale = profile.speed_scales(major)?;
    let per_speed = scale * per_major;
    let ordinary = are_ordinary::<R>(scale) & are_ordinary::<R>(per_speed);
    if !Lanes::<R>::all(scale.equal(Numbers::repeat(R::ONE)) | ordinary) {
        return None;
    }
    let [drag, torque] = profile.drags_and_torques(&at)?;
    Some([per_speed * drag, scale * torque])
}

/// The speeds of a group, divided one by one.
struct SpeedRatios<R: Real> {
    at: LaneSpeeds<R>,
    major: Lanes<R>,
    /// A mask: h and its powers have all digits.
    resolved: Lanes<R>,
}

/// None for rest, infinities and NaN.
#[inline(always)]
fn divided<R: Real>(slides: &Group<R>, rims: &Group<R>) -> Option<SpeedRatios<R>> {
    let [slide, rim] = [slides, rims].map(|speeds| Lanes::<R>::new(*speeds).abs());
    let [none, infinite] = [R::ZERO, R::INFINITY].map(Lanes::<R>::repeat);
    let finite = infinite.above(slide) & infinite.above(rim);
    let (major, minor) = (slide.larger(rim), slide.smaller(rim));
    if !Lanes::<R>::all(finite & major.above(none)) {
        return None;
    }
    let ratio = minor / major;
    let square_is_normal = (ratio * ratio).at_least(Numbers::repeat(R::MIN_POSITIVE));
    Some(SpeedRatios {
        at: LaneSpeeds {
            slides: slide.above(rim),
            ratio,
            gap: (major - minor) / major,
        },
        major,
        resolved: square_is_normal | minor.equal(none),
    })
}

/// F and T.
#[inline(always)]
pub fn wrenches<R: Real, P: LaneProfile<R>>(
    profile: &P,
    slides: &Group<R>,
    rims: &Group<R>,
) -> Option<[Group<R>; 2]> {
    let SpeedRatios {
        at,
        major,
        resolved,
    } = divided(slides, rims)?;
    let scale = profile.speed_scales(major)?;
    let may_be_scaled =
        scale.equal(Numbers::repeat(R::ONE)) | (are_ordinary::<R>(scale) & resolved);
    if !Lanes::<R>::all(may_be_scaled) {
        return None;
    }
    let [drag, torque] = profile.drags_and_torques(&at)?;
    Some([scale * (at.slide() * drag), scale * torque].map(Numbers::to_array))
}

/// F/v, ∂F/∂v, ∂F/∂w and ∂T/∂w.
#[inline(always)]
pub fn jacobians<R: Real, P: LaneProfile<R>>(
    profile: &P,
    slides: &Group<R>,
    rims: &Group<R>,
) -> Option<[Group<R>; 4]> {
    let SpeedRatios {
        at,
        major,
        resolved,
    } = divided(slides, rims)?;
    let scale = profile.rate_scales(major)?;
    if !Lanes::<R>::all(are_ordinary::<R>(scale) & resolved) {
        return None;
    }
    let [phi, slope, chi] = profile.factors_and_slopes(&at)?;
    let h = at.ratio;
    let alpha = Lanes::<R>::repeat(profile.exponent());
    let beta = Lanes::<R>::repeat(R::ONE - profile.exponent());
    let bend = Lanes::<R>::repeat(R::TWO) * slope;
    let x_bend = h * h * bend;
    let mixed = -h * (beta * phi + x_bend);
    let force_slide = Lanes::<R>::select(at.slides, alpha * phi - x_bend, phi + x_bend);
    let turned = Lanes::<R>::select(at.slides, bend, h * mixed);
    let mixed = Lanes::<R>::select(at.slides, h * bend, mixed);
    let all = [phi, force_slide, mixed, alpha * chi - turned];
    Some(all.map(|entry| (scale * entry).to_array()))
}
