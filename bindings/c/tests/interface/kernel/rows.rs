//! Rows of any numbers, and what the Rust kernel makes of them.

use super::numbers::Type;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::RoundFriction;
use tribos_core::coupling::coulomb::{
    CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch, CoulombRing,
};
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::limit_surface::{
    FrictionSet, Projection, Region, RoundLimitSurface, ShapeLimitSurface,
};
use tribos_core::patch::outline::{Edge, OutlineError, Polygon};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Names of the results of a row.
const RESULTS: [&str; 31] = [
    "wrench x",
    "wrench y",
    "wrench torque",
    "jacobian xx",
    "jacobian xy",
    "jacobian xn",
    "jacobian yy",
    "jacobian yn",
    "jacobian nn",
    "gauge",
    "normal x",
    "normal y",
    "normal spin",
    "projected x",
    "projected y",
    "projected torque",
    "projection's x",
    "projection's y",
    "projection's spin",
    "slides",
    "step x",
    "step y",
    "step spin",
    "step's friction x",
    "step's friction y",
    "step's friction torque",
    "is at rest",
    "is a patch",
    "x beside the Jacobian",
    "y beside the Jacobian",
    "torque beside the Jacobian",
];

/// The name of a result.
pub fn name(result: usize) -> &'static str {
    RESULTS.get(result).copied().unwrap_or_default()
}

/// What every row begins with: twist, push, strength, radius (of a polygon the number of its corners), length, mass,
/// inertia and time step.
const COMMON: usize = 12;
/// That, and the pressure.
pub type RoundRow<R> = [R; COMMON + 1];
/// That, and room for eight corners.
pub type PolygonRow<R> = [R; COMMON + 16];

/// The random numbers of a row.
pub struct Draw(u64);

impl Draw {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 11
    }

    fn unit(&mut self) -> f64 {
        self.bits() as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, count: u64) -> u64 {
        (self.bits() >> 20) % count
    }

    /// A positive number over so many powers of ten on both sides of 1.
    fn size(&mut self, decades: f64) -> f64 {
        power_of_ten((2.0 * self.unit() - 1.0) * decades)
    }

    /// Any number of a type whose exponents go to ±`most`: ordinary ones, ends of the range, zeros and no numbers.
    fn any(&mut self, most: f64) -> f64 {
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        let size = match self.below(48) {
            0..=2 => 0.0,
            3 => f64::INFINITY,
            4 => f64::NAN,
            5 => self.size(most),
            6 => power_of_ten(-most * (0.9 + 0.13 * self.unit())),
            7 => power_of_ten(most * (0.9 + 0.13 * self.unit())),
            8..=11 => 1.0,
            12..=18 => self.size(20.0),
            _ => self.size(2.0),
        };
        sign * size
    }

    /// A positive number, seldom near the ends of the range.
    fn positive<R: Type>(&mut self) -> R {
        let decades = if self.below(40) == 0 {
            0.8 * R::MOST
        } else {
            2.0
        };
        let size = R::from_f64(self.size(decades));
        if size > R::ZERO && size.is_finite() {
            size
        } else {
            R::ONE
        }
    }

    /// The common part, of a patch of some radius; the last five are what constructors take. `wrench` has the
    /// friction of a twist.
    fn common<R: Type>(&mut self, radius: R, wrench: impl Fn(R, [R; 3]) -> [R; 3]) -> [R; COMMON] {
        let any = |draw: &mut Self| R::from_f64(draw.any(R::MOST));
        let [strength, mass, inertia, dt]: [R; 4] = [(); 4].map(|()| self.positive());
        let is_none = self.below(100) == 0;
        let strength = if is_none { R::ZERO } else { strength };
        let is_body = PlanarBody::new(mass, inertia).is_ok();
        let inertia = if is_body { inertia } else { mass };
        let length = match self.below(20) {
            0 => any(self),
            1..=4 => radius * R::from_f64(self.size(4.0)),
            _ => radius * R::from_f64(self.size(0.5)),
        };
        let mut twist = [(); 3].map(|()| any(self));
        let nearly = R::from_f64(1.0 + self.size(1.0) * 1e-8);
        match self.below(12) {
            // Equal speeds, and nearly equal ones.
            0 => twist = [twist[0], R::ZERO, twist[0] / radius],
            1 => twist = [twist[0], R::ZERO, twist[0] / radius * nearly],
            2 => twist = [R::ZERO; 3],
            // Squares next to the end of the range.
            3 => {
                let least = (R::MIN_POSITIVE / R::EPSILON).sqrt();
                twist = [(); 3].map(|()| least * R::from_f64(2.0 * self.unit()));
            }
            _ => {}
        }
        let near = R::from_f64(2.0 * self.unit());
        let push = match self.below(6) {
            0 => [(); 3].map(|()| any(self)),
            // On the surface and beside it.
            1 | 2 => {
                let factor = match self.below(3) {
                    0 => -R::ONE,
                    1 => near,
                    _ => R::ONE + R::EPSILON * R::from_f64(400.0 * (self.unit() - 0.5)),
                };
                wrench(strength, twist).map(|part| part * factor)
            }
            _ => {
                let [x, y, n] = [(); 3].map(|()| R::from_f64(4.0 * (self.unit() - 0.5)));
                [strength * x, strength * y, strength * radius * n]
            }
        };
        if self.below(3) > 0 {
            // What friction may bring to rest within the step, or nearly.
            let at = R::from_f64(self.size(1.0)) * strength * dt;
            twist = [at / mass, near * at / mass, near * at * radius / inertia];
        }
        let ([x, y, n], [a, b, c]) = (twist, push);
        [
            x, y, n, a, b, c, strength, radius, length, mass, inertia, dt,
        ]
    }

    /// A row of a round patch.
    pub fn round<R: Type>(&mut self) -> RoundRow<R> {
        let (pressure, radius) = (R::from_f64(self.below(5) as f64), self.positive());
        let mut row = [pressure; COMMON + 1];
        let common = self.common(radius, |strength, twist| {
            of_surface(pressure, strength, radius, twist)
        });
        row[..COMMON].copy_from_slice(&common);
        row
    }

    /// A row of a polygon that is star-shaped about some place, or spoiled.
    pub fn polygon<R: Type>(&mut self) -> PolygonRow<R> {
        let mut row = [R::ZERO; COMMON + 16];
        let count = 3 + self.below(6) as usize;
        let [size, x, y] = [self.size(2.0), self.size(1.0), self.size(1.0)];
        let (stretch, sense) = (self.size(0.5), if self.below(2) == 0 { 1.0 } else { -1.0 });
        let (common, corners) = row.split_at_mut(COMMON);
        for (corner, at) in corners.chunks_mut(2).take(count).enumerate() {
            let turn = (corner as f64 + 0.8 * self.unit()) / count as f64;
            let (sin, cos) = turns(sense * turn);
            let from = size * (0.4 + self.unit());
            at[0] = R::from_f64(x + from * cos * stretch);
            at[1] = R::from_f64(y + from * sin);
        }
        match self.below(80) {
            0 => (corners[0], corners[1]) = (corners[2], corners[3]),
            1 => corners[0] = R::INFINITY,
            2 => corners.fill(R::from_f64(self.unit())),
            3 => corners[1] *= R::from_f64(1e30),
            // All on a line.
            4 => corners
                .chunks_mut(2)
                .for_each(|corner| corner[1] = corner[0]),
            5 => corners.iter_mut().for_each(|part| *part *= R::MIN_POSITIVE),
            _ => {}
        }
        let middle = [x, y].map(R::from_f64);
        let mut memory = [Edge::default(); 8];
        let patch = patch(corners, count, &mut memory);
        let drawn = self.common(R::from_f64(size), |strength, [a, b, n]| match &patch {
            Ok(patch) => {
                let friction = ShapeFriction::new(patch, R::ONE).expect("a coefficient");
                of_wrench(&friction.wrench(strength, &Twist::new(a, b, n)))
            }
            Err(_) => [strength; 3],
        });
        common.copy_from_slice(&drawn);
        common[7] = R::from_f64(count as f64);
        match self.below(8) {
            // About a corner, and translations.
            0 => (common[0], common[1]) = (common[2] * middle[1], -(common[2] * middle[0])),
            1 => common[2] = R::ZERO,
            _ => {}
        }
        row
    }
}

/// 10 to a power, by steps that need no library: the rows do not depend on the platform's.
fn power_of_ten(power: f64) -> f64 {
    let whole = power.floor();
    let part = power - whole;
    // 10^part between 1 and 10: any smooth spread serves.
    format!("1e{whole}").parse::<f64>().expect("a power of ten") * (1.0 + 9.0 * part)
}

/// Sine and cosine of so many turns, roughly: corners of a polygon may lie anywhere.
fn turns(share: f64) -> (f64, f64) {
    let wave = |share: f64| {
        let at = share.rem_euclid(1.0);
        let hill = |x: f64| 16.0 * x * (0.5 - x);
        if at < 0.5 { hill(at) } else { -hill(at - 0.5) }
    };
    (wave(share), wave(share + 0.25))
}

macro_rules! of_pressure {
    ($number:expr, $coupling:ident => $result:expr) => {
        match $number.to_f64() as usize {
            0 => {
                let $coupling = CoulombDisk;
                $result
            }
            1 => {
                let $coupling = CoulombRing;
                $result
            }
            2 => {
                let $coupling = CoulombPunch;
                $result
            }
            3 => {
                let $coupling = CoulombHertz;
                $result
            }
            _ => {
                let $coupling = CoulombParaboloid;
                $result
            }
        }
    };
}

/// Friction of a round patch.
fn of_surface<R: Type>(pressure: R, strength: R, radius: R, [x, y, n]: [R; 3]) -> [R; 3] {
    of_wrench(&of_pressure!(pressure, coupling => {
        let friction = RoundFriction::new(coupling, R::ONE, radius).expect("a radius");
        friction.wrench(strength, &Twist::new(x, y, n))
    }))
}

fn of_wrench<R: Type>(wrench: &Wrench<R>) -> [R; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

fn of_twist<R: Type>(twist: &Twist<R>) -> [R; 3] {
    [twist.velocity.x, twist.velocity.y, twist.spin]
}

fn of_jacobian<R: Type>(jacobian: &WrenchJacobian<R>) -> [R; 6] {
    [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|at| jacobian[at])
}

/// Wrench and Jacobian, and what the kernel makes of a row on the limit surface.
fn results<R: Type, const OUT: usize>(
    row: &[R],
    wrench: &Wrench<R>,
    jacobian: &WrenchJacobian<R>,
    surface: &impl FrictionSet<R>,
) -> [R; OUT] {
    let &[x, y, n, a, b, c, _, _, length, mass, inertia, dt, ..] = row else {
        panic!("a row of {}", row.len())
    };
    let (twist, push) = (Twist::new(x, y, n), Wrench::new(a, b, c));
    let mut found = [R::ZERO; OUT];
    found[..3].copy_from_slice(&of_wrench(wrench));
    found[3..9].copy_from_slice(&of_jacobian(jacobian));
    found[9] = surface.gauge(&push);
    found[10..13].copy_from_slice(&of_twist(&surface.twist_normal_to(&push)));
    let Projection { wrench, region } = surface.project_with_length(&push, length);
    found[13..16].copy_from_slice(&of_wrench(&wrench));
    if let Region::OnSurface { normal } = region {
        found[16..19].copy_from_slice(&of_twist(&normal));
        found[19] = R::ONE;
    }
    let body = PlanarBody::new(mass, inertia).expect("a body");
    let dt = TimeStep::new(dt).expect("a time");
    let step = body.step(surface, &twist, &push, dt);
    found[20..23].copy_from_slice(&of_twist(&step.twist));
    found[23..26].copy_from_slice(&of_wrench(&step.friction));
    found[26] = if step.is_at_rest { R::ONE } else { R::ZERO };
    found
}

/// What the kernel makes of a round row.
pub fn of_round<R: Type>(row: &RoundRow<R>) -> Option<[R; 27]> {
    let [x, y, n, _, _, _, strength, radius, .., pressure] = *row;
    let twist = Twist::new(x, y, n);
    of_pressure!(pressure, coupling => {
        let friction = RoundFriction::new(&coupling, R::ONE, radius).expect("a radius");
        let surface = RoundLimitSurface::new(&coupling, strength, radius).expect("a surface");
        let (wrench, jacobian) = (friction.wrench(strength, &twist), friction.wrench_jacobian(strength, &twist));
        Some(results(row, &wrench, &jacobian, &surface))
    })
}

/// The polygon of the first corners of a row.
fn patch<'a, R: Type>(
    corners: &[R],
    count: usize,
    memory: &'a mut [Edge<R>],
) -> Result<Polygon<R, &'a mut [Edge<R>]>, OutlineError> {
    let mut places = [[R::ZERO; 2]; 8];
    for (place, given) in places.iter_mut().zip(corners.chunks(2)) {
        place.copy_from_slice(given);
    }
    Polygon::with_holes(&[&places[..count]], memory)
}

/// What the kernel makes of a polygon's row; nothing where edges cross, which the header does not look for.
pub fn of_polygon<R: Type>(row: &PolygonRow<R>) -> Option<[R; 31]> {
    let ([x, y, n, _, _, _, strength, count, ..], corners) = (*row, &row[COMMON..]);
    let mut memory = [Edge::default(); 8];
    let polygon = match patch(corners, count.to_f64() as usize, &mut memory) {
        Ok(polygon) => polygon,
        Err(OutlineError::Crossing { .. }) => return None,
        Err(_) => return Some([R::ZERO; 31]),
    };
    let friction = ShapeFriction::new(&polygon, R::ONE).expect("a coefficient");
    let twist = Twist::new(x, y, n);
    let surface = ShapeLimitSurface::new(&polygon, strength).expect("a surface");
    let (beside, jacobian) = friction.wrench_and_jacobian(strength, &twist);
    let wrench = friction.wrench(strength, &twist);
    let mut found: [R; 31] = results(row, &wrench, &jacobian, &surface);
    found[27] = R::ONE;
    found[28..].copy_from_slice(&of_wrench(&beside));
    Some(found)
}
