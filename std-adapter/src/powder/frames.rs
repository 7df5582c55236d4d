//! A compaction as frames of a film.

use super::compaction::Compaction;
use super::packing::joint_set;
use super::statistics::{is_at, relative_loads};
use crate::record::frames::{Bodies, Frame, FrameContact, Hold, Kind};
use crate::record::{ContactRow, Partner};
use crate::scene::{PowderScene, WallLaw};
use nalgebra::Vector2;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::twist::Wrench;

impl Compaction {
    /// What all frames have in common, of which `limit` are kept at most.
    pub fn bodies(&self, limit: u64) -> Bodies {
        Bodies {
            kind: Kind::Powder,
            limit,
            stride: 1,
            periods: [self.scene().width; 2],
            radii: self.deposit().radii.clone(),
            layers: Vec::new(),
            parts: Vec::new(),
            marked: Vec::new(),
        }
    }

    /// The present state; the deposit's contacts before the first step carry nothing.
    ///
    /// ```
    /// use tribos::powder::Compaction;
    /// # use tribos::scene::{Scene, parse_scene};
    /// # let text = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02";
    /// # let Scene::Powder(scene) = parse_scene("tiny.toml", text, &[])? else { unreachable!() };
    /// let compaction = Compaction::new(&scene)?;
    /// let (bodies, first) = (compaction.bodies(100), compaction.frame());
    /// assert_eq!(first.places.len(), bodies.radii.len());
    /// assert_eq!((first.step, first.height), (0, compaction.height()));
    /// assert!(first.speeds.iter().all(|speed| *speed == 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn frame(&self) -> Frame {
        let (scene, radii) = (self.scene(), &self.deposit().radii);
        let [width, top] = [scene.width, self.height()].map(|side| side as f32);
        let joint = joint_set(scene);
        self.with_snapshot(|now| Frame {
            step: self.steps(),
            time: now.time,
            height: self.height(),
            measure: self.porosity(),
            corners: [[0.0; 3], [width, width, top]],
            places: now.positions.iter().map(|x| now.space.wrap(x)).collect(),
            speeds: now
                .velocities
                .into_iter()
                .flatten()
                .map(|velocity| velocity.norm() as f32)
                .collect(),
            contacts: now
                .contacts
                .iter()
                .map(|row| FrameContact {
                    a: row.a,
                    b: row.b,
                    normal_force: row.normal_force() as f32,
                    hold: hold(row, radii, scene, joint.as_deref()),
                })
                .collect(),
        })
    }
}

/// What a contact does. Where sliding and torsion have a joint threshold they reach it together.
pub(super) fn hold(
    row: &ContactRow,
    radii: &[f64],
    scene: &PowderScene,
    joint: Option<&dyn FrictionSet<f64>>,
) -> Hold {
    let has_friction = match row.b {
        Partner::Particle(_) => true,
        Partner::Wall(_) => scene.wall == WallLaw::Full,
    };
    let loads = relative_loads(row, radii, scene.cohesion_range);
    let (true, Some(loads)) = (has_friction, loads) else {
        return Hold::OPEN;
    };
    let has_own =
        |mode: usize| scene.friction[mode] > 0.0 && is_at(loads[mode], scene.friction[mode]);
    let mut at = [0, 1, 2].map(has_own);
    if let Some(set) = joint {
        let [force, _, torque] = loads;
        let wrench = Wrench {
            force: Vector2::new(force, 0.0),
            torque,
        };
        at[0] = is_at(set.gauge(&wrench), 1.0);
        at[2] = at[0];
    }
    Hold::of(at)
}
