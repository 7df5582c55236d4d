//! Frames of a film of a compaction.

use super::compaction::Compaction;
use crate::packing::Limits;
use crate::record::frames::{Bodies, Frame, FrameContact, Hold, Kind};

impl Compaction {
    /// Data common to all frames of the film, which keeps at most `limit` of them.
    pub fn bodies(&self, limit: u64) -> Bodies {
        Bodies {
            kind: Kind::Powder,
            scene: self.scene().json(),
            limit,
            stride: 1,
            periods: [self.scene().width; 2],
            radii: self.deposit().radii.clone(),
            layers: Vec::new(),
            parts: Vec::new(),
            marked: Vec::new(),
        }
    }

    /// The current state; before the first step the contacts of the deposit carry no force.
    ///
    /// ```
    /// use tribos::powder::Compaction;
    /// # use tribos::scene::PowderScene;
    /// # let scene = PowderScene {
    /// #     width: 6.0,
    /// #     height: 8.0,
    /// #     pressure: 0.02,
    /// #     ..PowderScene::default()
    /// # };
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
        let limits = Limits::of(&scene.material());
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
                    hold: limits.reached(row, radii).map_or(Hold::OPEN, Hold::of),
                })
                .collect(),
        })
    }
}
