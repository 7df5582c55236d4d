//! The tier for local laws without a closed form: fixed nodes, any law.
//!
//! With ρ² = (v − w)² + 4vw sin²(θ/2) the force of the uniform disk under *any* local law g is a
//! one-dimensional mean over the rim,
//!
//! ```text
//! F = v ⟨2 sin²θ g(ρ)/ρ⟩                                   mean over θ in [0, π]
//! ```
//!
//! because the area integral of a field that scales from the instantaneous centre of rotation
//! reduces to its rim. The torque needs the inside of the disk as well. For v ≤ 2w it follows from
//! the dissipated power, swept from that centre:
//!
//! ```text
//! P = 2 ⟨(1 − v/w cosθ) S(ρ)/ρ²⟩,   S = ∫s² g(s) ds up to ρ,    T = (P − v F)/w
//! ```
//!
//! from s = 0 if the centre is on the disk; if not, from any speed, because ⟨(1 − v/w cosθ)/ρ²⟩ is
//! then 0, and the slowest on the disk is the one taken. The integral is carried on from one angle to
//! the next, so that it sees the law as finely as the rim does;
//! and for v > 2w, where the field is smooth on the whole disk, from rings of radius r with
//! s = v sinθ/ρ: T = w ∫2r³ ⟨(1 − s²) g/ρ + s² g'⟩ dr. The derivatives are integrals of the same
//! kinds. Nothing divides by a small number, and no singular point is ever a node.

use super::extended_range::{ExtendedRange, is_in_normal_range};
use super::{ReducedFriction, ReducedJacobian, ReducedWrench};
use crate::law::LocalLaw;
use crate::real::Real;

/// Uniform disk under an arbitrary local law, by 32 angles.
///
/// The reduced wrench includes the law's own coefficient.
///
/// *Accuracy*: for laws as smooth as |v|^α, relative error of F and T at most 1e-8 for 0 ≤ α ≤ 5
/// and 2e-6 for α ≥ −0.5; Jacobian 1e-5 for 0 ≤ α ≤ 5, absolute in units of F/v. Laws with several
/// regimes 1e-8 of the largest friction on the disk in F and T, where their features are wider than 1/10
/// of the range of speeds there; one narrower than 1/32 of it is averaged over.
/// *Domain*: all finite speeds of which the larger is at least 10¹⁰ times the smallest normal number
/// (the law is asked for slower elements too) and meets friction in range; NaN for infinite speeds.
/// *Cost*: 32 law evaluations for the force, 152 for the torque (256 where v > 2w).
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, quadrature::DiskQuadrature};
/// use tribos_core::law::CoulombLaw;
/// let disk = DiskQuadrature::new(CoulombLaw::new(1.0_f64)?);
/// assert!((disk.reduced_wrench(1.0, 1.0).force - 8.0 / (3.0 * core::f64::consts::PI)).abs() < 1e-8);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiskQuadrature<L> {
    law: L,
}

impl<L> DiskQuadrature<L> {
    /// Couples `law` with a uniform disk.
    pub fn new(law: L) -> Self {
        Self { law }
    }

    /// The local law.
    pub fn law(&self) -> &L {
        &self.law
    }
}

/// Up to this ratio v/w the torque comes from the dissipated power.
const POWER_FORM_UP_TO: f64 = 2.0;

/// One angle on the rim, or on a ring inside.
struct RimAngle<R> {
    weight: R,
    /// Speed of the surface element there, also in units of the larger of both speeds.
    speed: R,
    relative: R,
    cos: R,
    sin_sq: R,
}

/// The 32 angles for sliding speed `slide` and ring speed `rim`.
fn angles<R: Real>(slide: R, rim: R) -> impl Iterator<Item = RimAngle<R>> {
    // Squares of speeds in units of the larger one neither overflow nor vanish.
    let major = if slide > rim { slide } else { rim };
    let (a, b) = (slide / major, rim / major);
    let four = R::TWO + R::TWO;
    ANGLES.iter().map(move |&[half_sin_sq, weight]| {
        let u = R::from_f64(half_sin_sq);
        let relative = ((a - b) * (a - b) + four * a * b * u).sqrt();
        RimAngle {
            weight: R::from_f64(weight),
            speed: major * relative,
            relative,
            cos: R::ONE - R::TWO * u,
            sin_sq: four * u * (R::ONE - u),
        }
    })
}

/// Sums a function of the angle with the nodes' weights.
fn mean<R: Real>(slide: R, rim: R, f: impl Fn(&RimAngle<R>) -> R) -> R {
    angles(slide, rim).fold(R::ZERO, |sum, at| sum + at.weight * f(&at))
}

/// ∫2r³ f(r) dr over [0, 1].
fn over_radius<R: Real>(f: impl Fn(R) -> R) -> R {
    RADII.iter().fold(R::ZERO, |sum, &[r, weight]| {
        sum + R::from_f64(2.0 * r * r * r * weight) * f(R::from_f64(r))
    })
}

/// ∫t² g(t) dt over [`from`, `from` + `width`] by the rule of `nodes` on [0, 1].
fn swept<R: Real>(nodes: &[[f64; 2]], from: R, width: R, g: impl Fn(R) -> R) -> R {
    let sum = nodes.iter().fold(R::ZERO, |sum, &[x, weight]| {
        let t = from + width * R::from_f64(x);
        sum + R::from_f64(weight) * t * t * g(t)
    });
    width * sum
}

impl<L> DiskQuadrature<L> {
    /// F/v for the stress function `g`.
    fn drag<R: Real>(slide: R, rim: R, g: impl Fn(R) -> R) -> R {
        mean(slide, rim, |at| R::TWO * at.sin_sq * g(at.speed) / at.speed)
    }

    /// T for `g` from the dissipated power; `force` is F of the same `g`.
    fn torque_from_power<R: Real>(slide: R, rim: R, force: R, g: impl Fn(R) -> R) -> R {
        let ratio = slide / rim;
        let major = if ratio > R::ONE { slide } else { rim };
        let g = |relative: R| g(major * relative);
        let mut at = (slide - rim).abs() / major;
        // From the slowest element on the disk.
        let mut sum = if ratio > R::ONE || at == R::ZERO {
            R::ZERO
        } else {
            swept(&FROM_REST, R::ZERO, at, g)
        };
        let mut power = R::ZERO;
        for next in angles(slide, rim) {
            sum += swept(&ONWARD, at, next.relative - at, g);
            at = next.relative;
            power += next.weight * (R::ONE - ratio * next.cos) * sum / (at * at);
        }
        let power = R::TWO * major * power;
        power / rim - ratio * force
    }

    /// ⟨a g/ρ + b g'⟩ on rings, with (a, b) from s².
    fn over_rings<R: Real>(&self, slide: R, rim: R, weights: impl Fn(R) -> (R, R)) -> R
    where
        L: LocalLaw<R>,
    {
        over_radius(|r| {
            mean(slide, rim * r, |at| {
                let along = slide / at.speed;
                let s_sq = along * along * at.sin_sq;
                let (a, b) = weights(s_sq);
                a * self.law.friction(at.speed) / at.speed + b * self.law.slope(at.speed)
            })
        })
    }

    /// ∂F/∂v, ∂F/∂w.
    fn force_derivatives<R: Real>(&self, slide: R, rim: R) -> [R; 2]
    where
        L: LocalLaw<R>,
    {
        let mut sums = [R::ZERO; 2];
        for at in angles(slide, rim) {
            let weight = at.weight * R::TWO * at.sin_sq;
            let secant = self.law.friction(at.speed) / at.speed;
            let bend = (self.law.slope(at.speed) - secant) * (slide / at.speed);
            sums[0] += weight * (secant + bend * ((slide - rim * at.cos) / at.speed));
            sums[1] += weight * bend * ((rim - slide * at.cos) / at.speed);
        }
        sums
    }
}

impl<L> DiskQuadrature<L> {
    /// The law's secant at the smallest normal speed stands for its damping at rest.
    fn damping_at_rest<R: Real>(&self) -> ReducedJacobian<R>
    where
        L: LocalLaw<R>,
    {
        let drag = self.law.friction(R::MIN_POSITIVE) / R::MIN_POSITIVE;
        ReducedJacobian {
            force_per_slide: drag,
            force_slide: drag,
            mixed: R::ZERO,
            torque_rim: R::HALF * drag,
        }
    }
}

impl<L> DiskQuadrature<L> {
    /// F and T for speeds of which the powers that the sums contain are numbers.
    fn wrench<R: Real>(&self, slide: R, rim: R) -> ReducedWrench<R>
    where
        L: LocalLaw<R>,
    {
        let g = |speed| self.law.friction(speed);
        let force = slide * Self::drag(slide, rim, g);
        let torque = if slide <= R::from_f64(POWER_FORM_UP_TO) * rim {
            Self::torque_from_power(slide, rim, force, g)
        } else {
            rim * self.over_rings(slide, rim, |s_sq| (R::ONE - s_sq, s_sq))
        };
        ReducedWrench { force, torque }
    }

    /// The derivatives for such speeds.
    fn jacobian<R: Real>(&self, slide: R, rim: R) -> ReducedJacobian<R>
    where
        L: LocalLaw<R>,
    {
        let drag = Self::drag(slide, rim, |speed| self.law.friction(speed));
        let [force_slide, mixed] = self.force_derivatives(slide, rim);
        let torque_rim = if slide <= R::from_f64(POWER_FORM_UP_TO) * rim {
            // w ∂T/∂w = T[g' ρ] − v ∂F/∂w
            let tangent = |speed| self.law.slope(speed) * speed;
            let force = slide * Self::drag(slide, rim, tangent);
            let along = Self::torque_from_power(slide, rim, force, tangent);
            (along - slide * mixed) / rim
        } else {
            self.over_rings(slide, rim, |s_sq| (s_sq, R::ONE - s_sq))
        };
        ReducedJacobian {
            force_per_slide: drag,
            force_slide,
            mixed,
            torque_rim,
        }
    }
}

/// A law of the speed in units of another one and of the friction there: all of order 1 where the
/// law is like a power.
struct NormalisedLaw<'a, L, R> {
    law: &'a L,
    speed: R,
    friction: R,
}

impl<L: LocalLaw<R>, R: Real> LocalLaw<R> for NormalisedLaw<'_, L, R> {
    fn friction(&self, speed: R) -> R {
        self.law.friction(speed * self.speed) / self.friction
    }
    fn slope(&self, speed: R) -> R {
        let own = self.law.slope(speed * self.speed);
        if is_in_normal_range(own.abs()) {
            let own = ExtendedRange::new(own).times(ExtendedRange::new(self.speed));
            return own.over(ExtendedRange::new(self.friction)).value();
        }
        // The law's own slope leaves the range that its product with the speed keeps.
        let step = R::from_f64(DIFFERENCE);
        let across = |n: R| {
            self.friction(speed * (R::ONE + n * step)) - self.friction(speed * (R::ONE - n * step))
        };
        (R::from_f64(8.0) * across(R::ONE) - across(R::TWO)) / (R::from_f64(12.0) * step * speed)
    }
}

/// Step of a difference of fourth order, of the speed: 1e-12 times the fifth derivative remains, and
/// a thousand rounding errors.
const DIFFERENCE: f64 = 1.0 / 1024.0;

impl<L> DiskQuadrature<L> {
    /// The larger speed and the friction there.
    #[inline]
    fn units<R: Real>(&self, slide: R, rim: R) -> [R; 2]
    where
        L: LocalLaw<R>,
    {
        let speed = if slide > rim { slide } else { rim };
        [speed, self.law.friction(speed)]
    }

    /// The disk in such units, with its speeds; `None` if nothing is to be gained: no friction, or
    /// none that is a number.
    #[cold]
    fn in_units<R: Real>(
        &self,
        [speed, friction]: [R; 2],
    ) -> Option<DiskQuadrature<NormalisedLaw<'_, L, R>>>
    where
        L: LocalLaw<R>,
    {
        let known = speed.is_finite() && is_in_normal_range(friction);
        known.then_some(DiskQuadrature::new(NormalisedLaw {
            law: &self.law,
            speed,
            friction,
        }))
    }
}

impl<L> DiskQuadrature<L> {
    /// F and T of a disk in units `speed` and `friction`; the ratio of the speeds may leave the range.
    fn dimensioned<R: Real>(&self, [speed, friction]: [R; 2], slide: R, rim: R) -> ReducedWrench<R>
    where
        L: LocalLaw<R>,
    {
        let (a, b) = (slide / speed, rim / speed);
        let g = |speed| self.law.friction(speed);
        let friction = ExtendedRange::new(friction);
        let rate = |x: R, of: R| {
            let product = ExtendedRange::new(x)
                .times(ExtendedRange::new(of))
                .over(ExtendedRange::new(speed));
            product.times(friction).value()
        };
        let drag = Self::drag(a, b, g);
        let torque = if a <= R::from_f64(POWER_FORM_UP_TO) * b {
            let torque = Self::torque_from_power(a, b, a * drag, g);
            ExtendedRange::new(torque).times(friction).value()
        } else {
            rate(rim, self.over_rings(a, b, |s_sq| (R::ONE - s_sq, s_sq)))
        };
        ReducedWrench {
            force: rate(slide, drag),
            torque,
        }
    }
}

/// True if products of `friction` with `speed` and quotients by it stay far from the ends of the
/// range.
#[inline]
fn are_moderate<R: Real>([speed, friction]: [R; 2]) -> bool {
    let room = R::EPSILON * R::EPSILON;
    let is_moderate = |x: R| x * room >= R::MIN_POSITIVE && (x / room).is_finite();
    is_moderate(friction * speed) && is_moderate(friction / speed)
}

impl<R: Real, L: LocalLaw<R>> ReducedFriction<R> for DiskQuadrature<L> {
    fn reduced_wrench(&self, slide: R, rim: R) -> ReducedWrench<R> {
        let (slide, rim) = (slide.abs(), rim.abs());
        if slide == R::ZERO && rim == R::ZERO {
            return ReducedWrench {
                force: R::ZERO,
                torque: R::ZERO,
            };
        }
        let units = self.units(slide, rim);
        if are_moderate(units) {
            return self.wrench(slide, rim);
        }
        let [speed, friction] = units;
        let Some(disk) = self.in_units(units) else {
            return self.wrench(slide, rim);
        };
        disk.dimensioned([speed, friction], slide, rim)
    }

    fn reduced_jacobian(&self, slide: R, rim: R) -> ReducedJacobian<R> {
        let (slide, rim) = (slide.abs(), rim.abs());
        if slide == R::ZERO && rim == R::ZERO {
            return self.damping_at_rest();
        }
        let units = self.units(slide, rim);
        if are_moderate(units) {
            return self.jacobian(slide, rim);
        }
        let [speed, friction] = units;
        let Some(disk) = self.in_units(units) else {
            return self.jacobian(slide, rim);
        };
        let j = disk.jacobian(slide / speed, rim / speed);
        let scale = ExtendedRange::new(friction).over(ExtendedRange::new(speed));
        let scaled = |x: R| ExtendedRange::new(x).times(scale).value();
        ReducedJacobian {
            force_per_slide: scaled(j.force_per_slide),
            force_slide: scaled(j.force_slide),
            mixed: scaled(j.mixed),
            torque_rim: scaled(j.torque_rim),
        }
    }
}

/// [sin²(θ/2), weight] with θ = πτ³ and τ the 32-point Gauss–Legendre nodes of [0, 1]; weights
/// 3τ² w, sum 1. The cube crowds the nodes where equal speeds make ρ small. Roots by Newton's
/// method on the Legendre recurrence with 40 digits (mpmath), rounded to f64.
#[rustfmt::skip]
const ANGLES: [[f64; 2]; 32] = [
    [1.6176624689027037e-17, 1.9704182547479475e-08],
    [3.420982212026037e-13, 1.2634744339429494e-06],
    [7.380884125334185e-11, 1.1823484777458263e-05],
    [2.932935399013247e-09, 5.4459698032012815e-05],
    [4.7885128426737835e-08, 0.00017267101351985838],
    [4.5037041254752844e-07, 0.00043393195119833427],
    [2.9049307109595614e-06, 0.0009294880431418866],
    [1.4226404090605809e-05, 0.0017704470874171535],
    [5.642722737640809e-05, 0.0030802804238407853],
    [0.00018932710329154165, 0.004984224460574165],
    [0.0005541024184076607, 0.007596413528480275],
    [0.0014465726647604935, 0.011005849201771566],
    [0.0034255833501660032, 0.01526249240781784],
    [0.007452495940565813, 0.02036483463796161],
    [0.015040966784879862, 0.026250254468548687],
    [0.02837190806731794, 0.03278929678990797],
    [0.05030051735154581, 0.03978473627205917],
    [0.08416134776655805, 0.04697592470822993],
    [0.1332840411760303, 0.05404850271523551],
    [0.20019311214110844, 0.060649113938922965],
    [0.28559607727110053, 0.06640433106616159],
    [0.3874415826644537, 0.07094262373389243],
    [0.5004672125769665, 0.07391790147172908],
    [0.6166288454826807, 0.07503297645441939],
    [0.7265287670218374, 0.0740612288863051],
    [0.8215094370969653, 0.07086483006778863],
    [0.8956945722167524, 0.06540808180221329],
    [0.9472051787141453, 0.05776475344885831],
    [0.9781280286563037, 0.04811872372289336],
    [0.9933606359041456, 0.03675778278746086],
    [0.9988675154867276, 0.024061609659752375],
    [0.9999585519832865, 0.01049912888847191],
];

/// [node, weight] of the 8-point Gauss–Legendre rule on [0, 1], made the same way.
#[rustfmt::skip]
const RADII: [[f64; 2]; 8] = [
    [0.019855071751231884, 0.05061426814518813],
    [0.10166676129318664, 0.11119051722668724],
    [0.2372337950418355, 0.15685332293894363],
    [0.4082826787521751, 0.181341891689181],
    [0.591717321247825, 0.181341891689181],
    [0.7627662049581645, 0.15685332293894363],
    [0.8983332387068134, 0.11119051722668724],
    [0.9801449282487681, 0.05061426814518813],
];

/// [node, weight] on [0, 1] from rest: σ² and 2σ w with the 24-point Gauss–Legendre rule for σ, which
/// makes fractional powers smooth. Made the same way.
#[rustfmt::skip]
const FROM_REST: [[f64; 2]; 24] = [
    [5.790712839267769e-06, 2.9697811996771237e-05],
    [0.0001596614708238092, 0.00036051469539845685],
    [0.0009525077326158356, 0.0013665223735884141],
    [0.0032253581264219877, 0.0033676992585023307],
    [0.00809982126333476, 0.006601110494898251],
    [0.016883858950674978, 0.011199368953045671],
    [0.030959519451763624, 0.0171763116823968],
    [0.05166040966857191, 0.02442092910850787],
    [0.08014744800160435, 0.032700029579005176],
    [0.11729163265945317, 0.04166954054836435],
    [0.16357217163929128, 0.05089377210203092],
    [0.21899737494950003, 0.059871436037195074],
    [0.28305426781210563, 0.06806675930955708],
    [0.35469103911290756, 0.07494368424479737],
    [0.43233431235561653, 0.08000093237943903],
    [0.5139409556276495, 0.08280563847472043],
    [0.5970818810574114, 0.08302334100745777],
    [0.6790531713887392, 0.08044234042171709],
    [0.7570080505292294, 0.0749907925789076],
    [0.8281018072372377, 0.06674537091618206],
    [0.8896408851308231, 0.05593088565693445],
    [0.9392270597353486, 0.04291091644383139],
    [0.9748882174421333, 0.028170873933535207],
    [0.9951930107098607, 0.012311531987990428],
];

/// [node, weight] of the 4-point Gauss–Legendre rule on [0, 1], made the same way.
#[rustfmt::skip]
const ONWARD: [[f64; 2]; 4] = [
    [0.06943184420297371, 0.17392742256872692],
    [0.33000947820757187, 0.32607257743127305],
    [0.6699905217924281, 0.32607257743127305],
    [0.9305681557970263, 0.17392742256872692],
];
