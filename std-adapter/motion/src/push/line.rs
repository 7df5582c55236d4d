//! A pusher that touches a body along a line.

use super::PushError;
use super::contact::{PointContact, cross};
use tribos_core::limit_surface::FrictionSet;
use tribos_core::nalgebra::Vector2;
use tribos_core::twist::{Twist, Wrench};

/// A straight pusher along a straight side of a body, between two ends.
///
/// Its forces are those of point contacts at the two ends, added up: four edges of a cone of wrenches
/// (Lynch and Mason, Int. J. Robotics Research 15 (1996) 533). *Units*: m.
///
/// ```
/// use tribos::friction::Area;
/// use tribos::prelude::*;
/// use tribos::push::LineContact;
/// let table = Area::named(&"box:0.2x0.1".parse()?, 1.0, None)?.limit_surface(2.0)?; // N
/// // A fence under the lower side; the body lies to the left of the way from its first end to its second.
/// let fence = LineContact::new([[-0.08, -0.05], [0.08, -0.05]], 0.4)?;
/// let straight = fence.stable_push(&*table, &Twist::new(0.0, 1.0, 0.0));
/// assert!(straight.is_stable && (straight.place - 0.5).abs() < 1e-9);
/// // A rotation about a centre far to the right is one too, about a near one it is not.
/// let about = |x: f64| Twist::new(0.0, -x, 1.0);
/// assert!(fence.stable_push(&*table, &about(-0.5)).is_stable);
/// assert!(!fence.stable_push(&*table, &about(-0.02)).is_stable);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineContact {
    ends: [PointContact; 2],
}

/// What a line contact has to give for a motion of the body together with the pusher.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StablePush {
    /// True if the contact can give it: the body keeps its place at the pusher.
    pub is_stable: bool,
    /// The push that the motion needs, about the origin. *Units*: N and N m.
    pub wrench: Wrench<f64>,
    /// Where the force acts along the line: 0 at the first end, 1 at the second.
    pub place: f64,
    /// Friction to the left over normal force, at most the coefficient. Infinite if the pusher would have to pull.
    pub friction: f64,
}

impl LineContact {
    /// *Domain*: two finite ends apart, in such order that the body lies to the left of the way from the first to
    /// the second; friction coefficient of the pusher ≥ 0.
    pub fn new(ends: [[f64; 2]; 2], coefficient: f64) -> Result<Self, PushError> {
        let [[x0, y0], [x1, y1]] = ends;
        let along = [x1 - x0, y1 - y0];
        if along == [0.0; 2] {
            return Err(PushError::Line);
        }
        let normal = [-along[1], along[0]];
        let [first, second] = ends;
        let end = |place| PointContact::new(place, normal, coefficient);
        Ok(Self {
            ends: [end(first)?, end(second)?],
        })
    }

    /// Its ends, as point contacts.
    pub fn ends(&self) -> [PointContact; 2] {
        self.ends
    }

    /// What the contact has to give for this motion of body and pusher, and whether it can.
    ///
    /// *Accuracy*: that of the set's wrench. *Special values*: a body at rest needs nothing, which is stable.
    pub fn stable_push(&self, set: &dyn FrictionSet<f64>, twist: &Twist<f64>) -> StablePush {
        let [first, second] = self.ends;
        let wrench = -set.wrench(twist);
        if wrench == Wrench::ZERO {
            return StablePush {
                is_stable: true,
                wrench,
                place: 0.5,
                friction: 0.0,
            };
        }
        let force = wrench.force;
        let pressing = force.dot(&first.normal());
        let along = second.position() - first.position();
        // The force times its arm from the first end is the torque about that end.
        let torque = wrench.torque - cross(&first.position(), &force);
        let place = torque / cross(&along, &force);
        let friction = if pressing > 0.0 {
            force.dot(&first.tangent()) / pressing
        } else {
            f64::INFINITY
        };
        let is_stable =
            pressing > 0.0 && friction.abs() <= first.coefficient() && (0.0..=1.0).contains(&place);
        StablePush {
            is_stable,
            wrench,
            place,
            friction,
        }
    }

    /// Motions on the boundary of the stable ones: `count` a face of the cone of wrenches, in order around it.
    ///
    /// The cone has four faces: friction at one edge while the force moves along the line, then a force at an
    /// end while its friction changes. Every motion has the length that [`FrictionSet::twist_normal_to`] gives; its
    /// centre of rotation is (−v_y, v_x)/spin.
    ///
    /// ```
    /// use tribos::friction::Area;
    /// use tribos::push::LineContact;
    /// let table = Area::named(&"box:0.2x0.1".parse()?, 1.0, None)?.limit_surface(2.0)?; // N
    /// let fence = LineContact::new([[-0.08, -0.05], [0.08, -0.05]], 0.4)?;
    /// let boundary = fence.stable_boundary(&*table, 10);
    /// assert_eq!(boundary.len(), 40);
    /// assert!(boundary.iter().all(|motion| motion.velocity.y > 0.0 || motion.spin != 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stable_boundary(&self, set: &dyn FrictionSet<f64>, count: usize) -> Vec<Twist<f64>> {
        let [first, second] = self.ends;
        let [right, left] = first.edges();
        let corners: [(PointContact, Vector2<f64>); 4] = [
            (first, right),
            (second, right),
            (second, left),
            (first, left),
        ];
        let wrenches = corners.map(|(end, force)| end.wrench(force));
        let mut boundary = Vec::with_capacity(4 * count);
        for (from, to) in wrenches.iter().zip(wrenches.iter().cycle().skip(1)) {
            for i in 0..count {
                let part = i as f64 / count as f64;
                let push = *from * (1.0 - part) + *to * part;
                boundary.push(set.twist_normal_to(&push));
            }
        }
        boundary
    }
}
