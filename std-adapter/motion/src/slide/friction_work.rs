//! Distribution of the work of friction over sliding and spinning.

use super::path::PathRun;
use super::{PlanarScene, SlideRun};
use crate::slide::scene::DiskScene;

/// Work of friction in J, split by the motion that it slowed.
///
/// A patch has a single friction, whose force and torque depend on both motions; the work of the force
/// slows the sliding, and the work of the torque slows the spin.
///
/// ```
/// use tribos::{scene::DiskScene, slide::FrictionWork};
/// let scene = DiskScene { speed: 1.0, spin: 5.0, radius: 0.08, mass: 0.1, ..DiskScene::default() };
/// let spent: FrictionWork = scene.run()?.spent(&scene);
/// assert!((spent.sliding - 0.05).abs() < 1e-12); // m v²/2
/// assert!((spent.spinning - 0.004).abs() < 1e-12); // m R² ω²/4
/// assert!((spent.spinning_share() - 4.0 / 54.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionWork {
    /// Loss of the kinetic energy of sliding, m v²/2.
    pub sliding: f64,
    /// Loss of the kinetic energy of spinning, I ω²/2.
    pub spinning: f64,
}

impl FrictionWork {
    /// Share of spinning in the total, between 0 and 1 unless one motion gained energy from the other.
    pub fn spinning_share(&self) -> f64 {
        self.spinning / (self.sliding + self.spinning)
    }

    /// Losses between two rows of a series, each given as speed squared and kinetic energy.
    fn between(mass: f64, [first, last]: [[f64; 2]; 2]) -> Self {
        let sliding = 0.5 * mass * (first[0] - last[0]);
        let all = first[1] - last[1];
        Self {
            sliding,
            spinning: all - sliding,
        }
    }
}

impl SlideRun {
    /// Work of friction by the motion that lost the energy.
    pub fn spent(&self, scene: &DiskScene) -> FrictionWork {
        let ends = ends(&self.rows).map(|[_, speed, .., kinetic, _]| [speed * speed, kinetic]);
        FrictionWork::between(scene.mass, ends)
    }
}

impl PathRun {
    /// Work of friction by the motion that lost the energy.
    pub fn spent(&self, scene: &dyn PlanarScene) -> FrictionWork {
        let ends =
            ends(&self.rows).map(|[_, _, _, vx, vy, .., kinetic, _]| [vx * vx + vy * vy, kinetic]);
        FrictionWork::between(scene.course().mass, ends)
    }
}

/// First and last row; NaN if there are none.
fn ends<const N: usize>(series: &[[f64; N]]) -> [[f64; N]; 2] {
    [series.first(), series.last()].map(|line| line.copied().unwrap_or([f64::NAN; N]))
}
