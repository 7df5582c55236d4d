//! Turning points of a slid tip, and what had been done when they were reached.

use crate::tip::scene::{DriveKind, StageSteps, TipScene};

/// Sums since the start of a run, and the energy now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Totals {
    /// Work of the drive.
    pub work: f64,
    /// Heat that thermostats and damping took.
    pub heat: f64,
    /// Energy of atoms, springs and load.
    pub energy: f64,
}

/// What had been done at the ends of the drive and at each turning point so far.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LoopWork {
    /// At the start of the drive, then at its end.
    pub ends: Vec<Totals>,
    /// Work at each turning point.
    pub turns: Vec<f64>,
}

/// Numbers of the ends and of the turning points up to a step.
pub(super) fn counts(scene: &TipScene, steps: u64) -> [u64; 2] {
    let StageSteps { before, driven, .. } = scene.stage_steps();
    if scene.drive == DriveKind::Torque || steps < before {
        return [0; 2];
    }
    let ends = 1 + u64::from(driven > 0 && steps >= before + driven);
    let (Some(speed), Some(stroke)) = (scene.speed, scene.stroke) else {
        return [ends, 0];
    };
    // The n-th turning point is at the last step before n strokes, so that a drive of a whole number
    // of strokes ends with one however its time is rounded.
    let each = stroke / (speed * scene.time_step);
    let driven_steps = (steps - before).min(driven) as f64;
    let turns = ((driven_steps + 1.0) / each).ceil() - 1.0;
    [ends, if turns > 0.0 { turns as u64 } else { 0 }]
}

/// Whether something is noted after a step: an end of the drive, or a turning point.
pub(super) fn is_noted(scene: &TipScene, steps: u64) -> bool {
    steps > 0 && counts(scene, steps) != counts(scene, steps - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(stroke: Option<f64>) -> TipScene {
        TipScene {
            drive: DriveKind::Slide,
            speed: Some(0.5),
            stroke,
            time_step: 0.01,
            equilibration: 1.0,
            drive_time: 10.0,
            rest_time: 1.0,
            ..TipScene::default()
        }
    }

    #[test]
    fn turning_points_are_at_the_last_steps_before_whole_strokes() {
        // A stroke lasts 1.234/0.005 = 246.8 steps; the drive from step 100 to step 1100.
        let slid = scene(Some(1.234));
        let noted: Vec<u64> = (0..=1200).filter(|&step| is_noted(&slid, step)).collect();
        assert_eq!(noted, [100, 346, 593, 840, 1087, 1100]);
        assert_eq!(counts(&slid, 99), [0, 0]);
        assert_eq!(counts(&slid, 840), [1, 3]);
        assert_eq!(counts(&slid, 1200), [2, 4]);
    }

    #[test]
    fn a_turning_point_at_the_end_of_the_drive_is_one() {
        let slid = scene(Some(2.5));
        let noted: Vec<u64> = (0..=1200).filter(|&step| is_noted(&slid, step)).collect();
        assert_eq!(noted, [100, 600, 1100]);
        assert_eq!(counts(&slid, 1100), [2, 2]);
        assert_eq!(counts(&scene(None), 1200), [2, 0]);
        let turned = TipScene {
            drive: DriveKind::Torque,
            ..scene(Some(2.5))
        };
        assert!((0..=1200).all(|step| !is_noted(&turned, step)));
    }
}
