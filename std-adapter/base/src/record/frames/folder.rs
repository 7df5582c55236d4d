//! The folder of a run's frames, filled and thinned while it runs.

use super::{Bodies, FEWEST, Frame, spacing};
use crate::record::{RecordError, is_unfinished, write_atomically, write_atomically_there};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// File with the data that all frames share.
const BODIES: &str = "bodies.json";
/// File extension of a frame.
const ENDING: &str = ".frame";
/// Frames of one run. New ones stay in memory until they must be on disk, as most are discarded
/// again.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::record::frames::{Bodies, Frame, FrameFolder, Kind};
/// # let bodies = Bodies {
/// #     kind: Kind::Powder,
/// #     scene: serde_json::json!({}),
/// #     limit: 20,
/// #     stride: 1,
/// #     sides: [10.0; 2],
/// #     periods: [Some(10.0), Some(10.0), None],
/// #     radii: vec![1.0],
/// #     materials: Vec::new(),
/// #     densities: Vec::new(),
/// #     layers: Vec::new(),
/// #     parts: Vec::new(),
/// #     marked: Vec::new(),
/// # };
/// # let frame = |step| Frame {
/// #     step,
/// #     corners: [[0.0; 3], [10.0; 3]],
/// #     places: vec![Vector3::zeros()],
/// #     speeds: vec![0.0],
/// #     ..Frame::default()
/// # };
/// # let home = tempfile::tempdir()?;
/// # let path = home.path().join("frames");
/// let mut film = FrameFolder::begin(&path, &bodies)?;
/// film.add(&frame(0));
/// film.save()?; // the run is broken off here, and goes on:
/// let mut film = FrameFolder::resume(&path, 0)?.ok_or("no frames")?;
/// assert_eq!(film.limit(), 20);
/// film.add(&frame(1));
/// film.finish(&frame(2))?;
/// assert_eq!(FrameFolder::steps(&path)?, [0, 1, 2]);
/// assert_eq!(FrameFolder::bodies(&path)?, Some(bodies));
///
/// FrameFolder::clear(&path)?;
/// assert!(FrameFolder::resume(&path, 2)?.is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct FrameFolder {
    path: PathBuf,
    /// Digest that identifies the frames of this run.
    run: u128,
    limit: u64,
    stride: u64,
    /// Steps from one frame to the next.
    apart: u64,
    /// Bytes of frames by their steps.
    held: BTreeMap<u64, Vec<u8>>,
    /// Step of the frame added last.
    newest: u64,
}

impl FrameFolder {
    /// An empty folder for the frames of these bodies; frames of an earlier run are removed.
    pub fn begin(path: &Path, bodies: &Bodies) -> Result<Self, RecordError> {
        Self::clear(path)?;
        write_atomically(&path.join(BODIES), bodies.text().as_bytes())?;
        Ok(Self::of(path, bodies))
    }

    /// The folder of a run resumed after this many steps; `None` if it has no frames. Refuses damaged and missing
    /// frames: the run would not make them again.
    pub fn resume(path: &Path, after: u64) -> Result<Option<Self>, RecordError> {
        let steps = if path.exists() {
            there(path)?
        } else {
            Vec::new()
        };
        let Some(bodies) = Self::bodies(path)? else {
            return match steps[..] {
                [] => Ok(None),
                _ => Err(RecordError::Missing(path.join(BODIES))),
            };
        };
        for step in &steps {
            Self::read(path, &bodies, *step)?;
        }
        // Frames that were saved after the checkpoint say how far apart those before it are by now.
        let newest = steps.last().map_or(after, |last| after.max(*last));
        refuse_gap(path, &bodies, &steps, (newest, after))?;
        Ok(Some(Self::of(path, &bodies)))
    }

    fn of(path: &Path, bodies: &Bodies) -> Self {
        Self {
            path: path.to_path_buf(),
            run: bodies.run(),
            limit: bodies.limit.max(FEWEST),
            stride: bodies.stride.max(1),
            apart: 1,
            held: BTreeMap::new(),
            newest: 0,
        }
    }

    /// Largest number of frames.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// Removes frames, if there are any, and the folder if nothing else is in it.
    pub fn clear(path: &Path) -> Result<(), RecordError> {
        if !path.exists() {
            return Ok(());
        }
        remove(&path.join(BODIES))?;
        remove_where(path, |_| true)?;
        // Not empty: the folder contains other files.
        let _ = std::fs::remove_dir(path);
        Ok(())
    }

    /// Whether the state after this many steps is to be kept for now.
    pub fn wants(&self, step: u64) -> bool {
        let states = step / self.stride;
        step.is_multiple_of(self.stride) && states.is_multiple_of(spacing(states, self.limit))
    }

    /// Adds a frame that is [wanted](Self::wants), and discards those no longer wanted.
    pub fn add(&mut self, frame: &Frame) {
        self.thin(frame.step);
        self.hold(frame);
    }

    fn hold(&mut self, frame: &Frame) {
        self.held.insert(frame.step, frame.bytes(self.run));
        self.newest = frame.step;
    }

    /// Writes all frames so far to disk, except those no longer wanted. Call it before each
    /// checkpoint: a resumed run does not make earlier frames again.
    pub fn save(&mut self) -> Result<(), RecordError> {
        for (step, bytes) in std::mem::take(&mut self.held) {
            write_atomically_there(&file(&self.path, step), &bytes)?;
        }
        // The newest frame is there before old ones go: it says how far apart they are. Later ones are those of an
        // interruption.
        let (apart, newest) = (self.apart, self.newest);
        remove_where(&self.path, |step| {
            step < newest && !step.is_multiple_of(apart)
        })
    }

    /// Adds the last state, wanted or not, and writes all frames.
    pub fn finish(mut self, frame: &Frame) -> Result<(), RecordError> {
        self.thin(frame.step);
        // Frames from steps after the last checkpoint of an interrupted run.
        remove_where(&self.path, |step| step > frame.step)?;
        self.hold(frame);
        self.save()
    }

    /// Discards frames in memory that are not wanted after `steps`.
    fn thin(&mut self, steps: u64) {
        let apart = spacing(steps / self.stride, self.limit).saturating_mul(self.stride);
        if apart != self.apart {
            self.apart = apart;
            self.held.retain(|step, _| step.is_multiple_of(apart));
        }
    }

    /// The data that the frames of a folder share; `None` if there are no frames.
    pub fn bodies(path: &Path) -> Result<Option<Bodies>, RecordError> {
        let file = path.join(BODIES);
        let text = match std::fs::read_to_string(&file) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            text => text.map_err(|cause| access(&file, cause))?,
        };
        match Bodies::parse(&text) {
            Some(bodies) => Ok(Some(bodies)),
            None => Err(RecordError::Damaged(file)),
        }
    }

    /// Steps of the existing frames, in order. Refuses a gap: the number of steps determines which
    /// frames are kept.
    pub fn steps(path: &Path) -> Result<Vec<u64>, RecordError> {
        let steps = there(path)?;
        if let (Some(bodies), Some(&last)) = (Self::bodies(path)?, steps.last()) {
            refuse_gap(path, &bodies, &steps, (last, last))?;
        }
        Ok(steps)
    }

    /// Reads the frame of a step and checks its number of bodies.
    pub fn read(path: &Path, bodies: &Bodies, step: u64) -> Result<Frame, RecordError> {
        let file = file(path, step);
        let bytes = std::fs::read(&file).map_err(|cause| access(&file, cause))?;
        let frame = Frame::parse(&bytes, bodies.run());
        frame
            .filter(|frame| frame.step == step && frame.places.len() == bodies.radii.len())
            .ok_or(RecordError::Damaged(file))
    }
}

/// Path of the frame of a step.
fn file(path: &Path, step: u64) -> PathBuf {
    path.join(format!("{step:012}{ENDING}"))
}

fn access(path: &Path, cause: std::io::Error) -> RecordError {
    RecordError::Access {
        path: path.to_path_buf(),
        cause,
    }
}

/// Names of all files in a folder that are readable as text.
fn names(path: &Path) -> Result<Vec<String>, RecordError> {
    let fail = |cause| access(path, cause);
    let mut names = Vec::new();
    for entry in std::fs::read_dir(path).map_err(fail)? {
        names.extend(entry.map_err(fail)?.file_name().into_string().ok());
    }
    Ok(names)
}

/// Steps of the frames in a folder, in order.
fn there(path: &Path) -> Result<Vec<u64>, RecordError> {
    let mut steps: Vec<u64> = names(path)?.iter().filter_map(|name| step(name)).collect();
    steps.sort_unstable();
    Ok(steps)
}

/// Refuses a gap among the frames that are kept of a run up to its `newest` step, as far as `end`.
fn refuse_gap(
    path: &Path,
    bodies: &Bodies,
    steps: &[u64],
    (newest, end): (u64, u64),
) -> Result<(), RecordError> {
    let apart = spacing(newest / bodies.stride, bodies.limit).saturating_mul(bodies.stride);
    let mut kept = (0..=end).step_by(usize::try_from(apart).unwrap_or(usize::MAX));
    match kept.find(|wanted| steps.binary_search(wanted).is_err()) {
        Some(wanted) => Err(RecordError::Missing(file(path, wanted))),
        None => Ok(()),
    }
}

/// The step in a frame's name.
fn step(name: &str) -> Option<u64> {
    name.strip_suffix(ENDING)?.parse().ok()
}

/// Removes the frames of some steps, and half-written files of a killed run.
fn remove_where(path: &Path, is_old: impl Fn(u64) -> bool) -> Result<(), RecordError> {
    for name in names(path)? {
        if is_unfinished(&name) || step(&name).is_some_and(&is_old) {
            remove(&path.join(name))?;
        }
    }
    Ok(())
}

/// Removes a file, if it is there.
fn remove(file: &Path) -> Result<(), RecordError> {
    match std::fs::remove_file(file) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(access(file, error)),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::frames::Kind;

    fn bodies(limit: u64, stride: u64) -> Bodies {
        Bodies {
            kind: Kind::Tip,
            scene: serde_json::json!({"lambda": 0.02}),
            limit,
            stride,
            sides: [3.0, 4.0],
            periods: [Some(3.0), Some(4.0), None],
            radii: vec![0.5],
            materials: Vec::new(),
            densities: Vec::new(),
            layers: vec![9],
            parts: vec![5],
            marked: vec![0],
        }
    }

    fn frame(step: u64) -> Frame {
        Frame {
            step,
            corners: [[0.0; 3], [1.0; 3]],
            places: vec![nalgebra::Vector3::new(0.25, 0.5, 0.75)],
            speeds: vec![1.0],
            ..Frame::default()
        }
    }

    /// Runs over some steps.
    fn run(folder: &mut FrameFolder, steps: std::ops::Range<u64>) {
        for step in steps {
            if folder.wants(step) {
                folder.add(&frame(step));
            }
        }
    }

    #[test]
    fn a_run_broken_anywhere_leaves_the_same_frames() -> Result<(), Box<dyn std::error::Error>> {
        let home = tempfile::tempdir()?;
        let whole = home.path().join("whole");
        let mut folder = FrameFolder::begin(&whole, &bodies(10, 2))?;
        run(&mut folder, 0..77);
        folder.finish(&frame(77))?;
        let steps = FrameFolder::steps(&whole)?;
        assert_eq!(steps, [0, 16, 32, 48, 64, 77]);

        for (checkpoint, killed) in [(0, 5), (30, 31), (30, 44), (31, 77), (76, 77)] {
            for written in [0, 1, 9] {
                let path = home.path().join("broken");
                let mut folder = FrameFolder::begin(&path, &bodies(10, 2))?;
                run(&mut folder, 0..checkpoint + 1);
                folder.save()?;
                // On the way to the next checkpoint some new frames are written, and old ones go once all are.
                run(&mut folder, checkpoint + 1..killed);
                let new: Vec<u64> = folder.held.keys().copied().collect();
                if let Some(&unwritten) = new.get(written) {
                    folder.held.retain(|step, _| *step < unwritten);
                    folder.apart = 1;
                    folder.save()?;
                } else if killed == 77 {
                    folder.finish(&frame(77))?;
                } else {
                    folder.save()?;
                }
                std::fs::write(path.join(".tribos-x7.tmp"), "half")?;
                // It goes on twice.
                let middle = checkpoint.midpoint(76);
                let mut folder = FrameFolder::resume(&path, checkpoint)?.ok_or("no frames")?;
                assert_eq!(folder.limit(), 10);
                run(&mut folder, checkpoint..middle + 1);
                folder.save()?;
                let mut folder = FrameFolder::resume(&path, middle)?.ok_or("no frames")?;
                run(&mut folder, middle..77);
                folder.finish(&frame(77))?;
                assert_eq!(
                    FrameFolder::steps(&path)?,
                    steps,
                    "{checkpoint} {killed} {written}"
                );
                assert_eq!(std::fs::read_dir(&path)?.count(), 1 + steps.len());
            }
        }
        Ok(())
    }

    #[test]
    fn a_run_does_not_go_on_without_a_frame_that_it_made() -> Result<(), Box<dyn std::error::Error>>
    {
        let home = tempfile::tempdir()?;
        let path = home.path().join("frames");
        let mut folder = FrameFolder::begin(&path, &bodies(10, 2))?;
        run(&mut folder, 0..31);
        folder.save()?;
        for step in FrameFolder::steps(&path)? {
            let (gone, kept) = (file(&path, step), home.path().join("kept"));
            std::fs::rename(&gone, &kept)?;
            let refused = FrameFolder::resume(&path, 30).map(|_| ());
            assert!(
                matches!(&refused, Err(RecordError::Missing(missing)) if *missing == gone),
                "{step}: {refused:?}"
            );
            std::fs::rename(&kept, &gone)?;
        }
        std::fs::remove_file(path.join(BODIES))?;
        let refused = FrameFolder::resume(&path, 30);
        assert!(matches!(refused, Err(RecordError::Missing(_))));
        Ok(())
    }

    #[test]
    fn a_folder_tells_what_it_holds() -> Result<(), Box<dyn std::error::Error>> {
        let home = tempfile::tempdir()?;
        let path = home.path().join("frames");
        assert!(FrameFolder::resume(&path, 0)?.is_none());
        let given = bodies(5, 1);
        let mut film = FrameFolder::begin(&path, &given)?;
        film.add(&frame(0));
        film.add(&frame(2));
        film.finish(&frame(3))?;
        assert_eq!(FrameFolder::bodies(&path)?, Some(given.clone()));
        assert_eq!(FrameFolder::read(&path, &given, 3)?.step, 3);
        std::fs::write(path.join("000000000004.frame"), "TrFr")?;
        let refused = FrameFolder::read(&path, &given, 4);
        assert!(matches!(refused, Err(RecordError::Damaged(_))));
        // A run does not go on beside it.
        let refused = FrameFolder::resume(&path, 3);
        assert!(matches!(refused, Err(RecordError::Damaged(_))));
        // A frame of the same step from another run, and one that is not there.
        let other = home.path().join("other");
        let scene = serde_json::json!({"lambda": 0.03});
        let mut film = FrameFolder::begin(
            &other,
            &Bodies {
                scene,
                ..given.clone()
            },
        )?;
        film.add(&frame(0));
        film.finish(&frame(2))?;
        std::fs::copy(file(&other, 2), file(&path, 2))?;
        let refused = FrameFolder::read(&path, &given, 2);
        assert!(matches!(refused, Err(RecordError::Damaged(_))));
        std::fs::remove_file(file(&path, 0))?;
        assert!(matches!(
            FrameFolder::steps(&path),
            Err(RecordError::Missing(_))
        ));
        std::fs::write(path.join(BODIES), "{}")?;
        assert!(matches!(
            FrameFolder::bodies(&path),
            Err(RecordError::Damaged(_))
        ));
        // Other people's files stay.
        std::fs::write(path.join("notes.txt"), "mine")?;
        FrameFolder::clear(&path)?;
        assert_eq!(std::fs::read_dir(&path)?.count(), 1);
        Ok(())
    }
}
