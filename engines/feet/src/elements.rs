//! All feet of a body on the ground as elements of area, through one implicit step.

use crate::area::{Area, Element};
use crate::balance::Balance;
use crate::ended::{Ended, FootFriction};
use crate::foot::Foot;
use crate::symmetric::{dot, minus, plus, solved, times};
use tribos_core::twist::{Twist, Wrench};

/// The feet of a body, positioned relative to the centre of mass.
#[derive(Debug, Default)]
pub(crate) struct Elements<'a> {
    /// Elements of the feet that press on the ground.
    elements: Vec<Element<'a>>,
    /// Middle of each foot in metres, in the contact's axes.
    places: Vec<[f64; 2]>,
    /// Motion of each foot relative to its ground minus that of the first foot relative to its own.
    drifts: Vec<[f64; 3]>,
}

/// Factor of the friction limit beyond which rest is certainly impossible, given rounding.
const BEYOND: f64 = 1.01;

impl<'a> Elements<'a> {
    pub(crate) fn of(feet: &[Foot<'a>]) -> Self {
        let mut elements = Vec::with_capacity(feet.len());
        for (number, foot) in feet.iter().enumerate() {
            foot.add_elements(number, &mut elements);
        }
        Self {
            elements,
            places: feet.iter().map(|foot| foot.place).collect(),
            drifts: feet.iter().map(|foot| foot.drift).collect(),
        }
    }

    /// Points of one foot, whose middle is below the centre of mass.
    pub(crate) fn of_points(points: &[([f64; 2], f32)]) -> Self {
        let presses = points.iter().filter(|(_, limit)| *limit > 0.0);
        let element = |&(place, limit): &([f64; 2], f32)| Element {
            place,
            area: Area::Point,
            limit: f64::from(limit),
            foot: 0,
        };
        Self {
            elements: presses.map(element).collect(),
            places: vec![[0.0; 2]],
            drifts: vec![[0.0; 3]],
        }
    }

    /// The motion after `dt` under a constant push, in newtons and newton metres.
    ///
    /// The friction of the motion at half time, of second order; that of the motion at the end where
    /// a foot comes to rest or the body would turn about.
    pub(crate) fn step(
        &self,
        mass: &[f64; 6],
        before: &Twist<f32>,
        push: &Wrench<f32>,
        dt: f32,
    ) -> Option<Ended> {
        let dt = f64::from(dt);
        let balance = Balance {
            mass: *mass,
            elements: &self.elements,
            drifts: &self.drifts,
        };
        let start = numbers(before);
        let pushed = solved(&balance.mass, &forces(push));
        let after = |time: f64| plus(&start, &pushed.map(|x| x * time));
        let end = (!self.surely_moves(&balance, &after(dt), dt))
            .then(|| self.end(&balance, &after(dt), dt));
        if let Some(end) = end.as_ref().filter(|end| end.holds.contains(&true)) {
            return self.whole(&balance, end, &after(dt), dt);
        }
        let half = 0.5 * dt;
        let middle = self.end(&balance, &after(half), half);
        let twist = minus(&middle.twist.map(|x| 2.0 * x), &start);
        let turned = dot(&middle.twist, &times(&balance.mass, &twist)) < 0.0;
        if middle.holds.contains(&true) || turned {
            let end = end.unwrap_or_else(|| self.end(&balance, &after(dt), dt));
            return self.whole(&balance, &end, &after(dt), dt);
        }
        let mut step = self.whole(&balance, &middle, &after(half), half)?;
        // Under the same friction for the other half.
        let friction = forces(&step.friction);
        let gained = solved(&balance.mass, &friction).map(|x| x * dt);
        step.twist = twist_of(&plus(&after(dt), &gained))?;
        Some(step)
    }

    /// Power that friction takes from a motion, in watts.
    pub(crate) fn dissipation(&self, twist: &Twist<f32>) -> f32 {
        let twist = numbers(twist);
        let power = |element: &Element| {
            let drift = self.drifts.get(element.foot).copied().unwrap_or([0.0; 3]);
            element.power(&plus(&twist, &drift), 0.0)
        };
        self.elements.iter().map(power).sum::<f64>() as f32
    }

    /// Whether more than all friction is needed to come to rest.
    fn surely_moves(&self, balance: &Balance, free: &[f64; 3], dt: f64) -> bool {
        let limit: f64 = self.elements.iter().map(|element| element.limit).sum();
        let [x, y, _] = times(&balance.mass, free);
        let drifts = self.drifts.iter().any(|drift| *drift != [0.0; 3]);
        !drifts && (x * x + y * y).sqrt() > BEYOND * limit * dt
    }

    /// The end of a step whose motion would be `free` without friction.
    fn end(&self, balance: &Balance, free: &[f64; 3], dt: f64) -> End {
        if let Some(traction) = self.traction(balance, free, dt) {
            return End {
                twist: [0.0; 3],
                holds: vec![true; self.places.len()],
                by: FrictionDistribution::Traction(traction),
            };
        }
        let found = balance.solve(free, dt);
        let holds = |drift: &[f64; 3]| plus(&found.twist, drift) == [0.0; 3];
        End {
            twist: found.twist,
            holds: self.drifts.iter().map(holds).collect(),
            by: FrictionDistribution::Smoothing(found.smoothing),
        }
    }

    /// A common field of traction a + b × r that holds the feet, over pressure times coefficient:
    /// where it is nowhere larger than 1, friction holds. Most bodies at rest need no more.
    fn traction(&self, balance: &Balance, free: &[f64; 3], dt: f64) -> Option<[f64; 3]> {
        if self.elements.is_empty() || self.drifts.iter().any(|drift| *drift != [0.0; 3]) {
            return None;
        }
        let [mut s, mut sx, mut sy, mut sq] = [0.0; 4];
        for element in &self.elements {
            let ([x, y], c) = (element.place, element.limit);
            s += c;
            sx += c * x;
            sy += c * y;
            sq += c * (x * x + y * y + element.area.mean_square());
        }
        let needed = times(&balance.mass, free).map(|x| -x / dt);
        let field = solved(&[s, 0.0, s, -sy, sx, sq], &needed);
        let [ax, ay, b] = field;
        let is_carried = |element: &Element| {
            let [x, y] = element.place;
            let [tx, ty] = [ax - b * y, ay + b * x];
            (tx * tx + ty * ty).sqrt() + b.abs() * element.area.radius() <= 1.0
        };
        self.elements.iter().all(is_carried).then_some(field)
    }

    /// Friction in all, and of each foot.
    fn whole(&self, balance: &Balance, end: &End, free: &[f64; 3], dt: f64) -> Option<Ended> {
        let away = minus(&end.twist, free);
        let friction = times(&balance.mass, &away).map(|x| x / dt);
        let mut each = vec![[0.0; 3]; self.places.len()];
        for element in &self.elements {
            let part = match end.by {
                FrictionDistribution::Traction([ax, ay, b]) => {
                    let ([x, y], c) = (element.place, element.limit);
                    let [fx, fy] = [c * (ax - b * y), c * (ay + b * x)];
                    let own = c * b * element.area.mean_square();
                    [fx, fy, x * fy - y * fx + own]
                }
                FrictionDistribution::Smoothing(smoothing) => {
                    let twist = plus(&end.twist, &balance.drift(element));
                    element.response(&twist, smoothing).wrench.map(|x| -x)
                }
            };
            if let Some(sum) = each.get_mut(element.foot) {
                *sum = plus(sum, &part);
            }
        }
        // About each foot's own middle.
        let of_foot = |((of, [x, y]), &holds): ((&[f64; 3], &[f64; 2]), &bool)| {
            let wrench = wrench_of(&[of[0], of[1], of[2] - (x * of[1] - y * of[0])])?;
            Some(FootFriction { wrench, holds })
        };
        let feet = each.iter().zip(&self.places).zip(&end.holds);
        let all: Vec<FootFriction> = feet.map(of_foot).collect::<Option<_>>()?;
        Some(Ended {
            twist: twist_of(&end.twist)?,
            friction: wrench_of(&friction)?,
            holds: !all.is_empty() && all.iter().all(|foot| foot.holds),
            all,
        })
    }
}

/// How the friction of each foot follows from the end of a step.
enum FrictionDistribution {
    /// A field of traction that holds all.
    Traction([f64; 3]),
    /// The motion, with so much smoothing.
    Smoothing(f64),
}

struct End {
    twist: [f64; 3],
    holds: Vec<bool>,
    by: FrictionDistribution,
}

fn numbers(twist: &Twist<f32>) -> [f64; 3] {
    [twist.velocity.x, twist.velocity.y, twist.spin].map(f64::from)
}

fn forces(wrench: &Wrench<f32>) -> [f64; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque].map(f64::from)
}

/// Single precision; `None` for what is not finite.
fn twist_of(twist: &[f64; 3]) -> Option<Twist<f32>> {
    let [x, y, spin] = finite(twist)?;
    Some(Twist::new(x, y, spin))
}

fn wrench_of(wrench: &[f64; 3]) -> Option<Wrench<f32>> {
    let [x, y, torque] = finite(wrench)?;
    Some(Wrench::new(x, y, torque))
}

fn finite(numbers: &[f64; 3]) -> Option<[f32; 3]> {
    let numbers = numbers.map(|x| x as f32);
    numbers.iter().all(|x| x.is_finite()).then_some(numbers)
}
