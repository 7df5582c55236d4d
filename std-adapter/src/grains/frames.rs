//! Frames of a film of grains.

use super::run::Grains;
use crate::packing::Limits;
use crate::record::frames::{Bodies, Frame, FrameContact, Hold, Kind};

impl Grains {
    /// Data common to all frames of the film, which keeps at most `limit` of them.
    pub fn bodies(&self, limit: u64) -> Bodies {
        let scene = self.scene();
        Bodies {
            kind: Kind::Grains,
            scene: scene.json(),
            limit,
            stride: 1,
            periods: [scene.width, scene.box_depth()],
            radii: self.now().packing.radii().to_vec(),
            layers: Vec::new(),
            parts: Vec::new(),
            marked: Vec::new(),
        }
    }

    /// The current state.
    pub fn frame(&self) -> Frame {
        let limits = Limits::of(&self.scene().material());
        let radii = self.now().packing.radii();
        let line = self.now().line();
        // Contacts between two lines of the series are found anew.
        let found = self.now().packing.contacts();
        let contacts = found.as_deref().unwrap_or(self.contacts());
        let [x, y, z] = self.corners();
        let corner = |end: usize| [x[end] as f32, y[end] as f32, z[end] as f32];
        self.with_snapshot(|now| Frame {
            step: self.steps(),
            time: now.time,
            height: line[4],
            measure: 1.0 - line[5],
            corners: [corner(0), corner(1)],
            places: now.positions.iter().map(|x| now.space.wrap(x)).collect(),
            speeds: now
                .velocities
                .into_iter()
                .flatten()
                .map(|velocity| velocity.norm() as f32)
                .collect(),
            contacts: contacts
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
