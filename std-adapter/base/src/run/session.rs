//! A long run in its own folder: checkpoints, frames, progress, cancellation, resuming.

use super::film::{FRAMES, FrameRecorder};
use super::folder::{Lock, LockMode, remove_file};
use super::long_run::{Cause, LongRun, RunError, StartMode};
use crate::record::{RecordError, read_text, with_number, write_atomically_there};
use std::fmt;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Name of a checkpoint in the folder of its run.
pub const CHECKPOINT: &str = "checkpoint.json";
/// Largest size of a checkpoint in bytes: twenty million spheres take some 15 GB.
const MOST_BYTES: u64 = 1 << 36;
/// Default time between checkpoints.
const PAUSE: Duration = Duration::from_secs(60);

/// What becomes of the state at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FinalCheckpoint {
    Written,
    Skipped,
}

/// Drives a [`LongRun`] to its end in a folder, with checkpoints and frames there.
///
/// A run interrupted for any reason (a kill, a full disk, [`Self::cancel_when`]) can be resumed, and
/// ends with the same bits as without interruption. The last checkpoint contains the final state.
///
/// ```
/// use tribos::powder::PowderSimulation;
/// use tribos::run::Session;
/// # use tribos::scene::Scene;
/// # let text = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmax_steps = 20";
/// # let Scene::Powder(scene) = Scene::parse("tiny.toml", text, &[])? else { unreachable!() };
/// let folder = std::env::temp_dir().join(format!("tribos-session-{}", std::process::id()));
/// let mut checkpoints = 0;
/// let run: PowderSimulation = Session::in_folder(&folder)?
///     .frames(0)
///     .on_checkpoint(|run: &PowderSimulation, file| {
///         checkpoints += 1;
///         assert!(file.exists() && run.steps() <= 20);
///     })
///     .run(&scene)?;
/// assert_eq!((run.steps(), checkpoints), (20, 1)); // that of the end: it took less than a minute
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Session<'a, R> {
    lock: Arc<Lock>,
    folder: PathBuf,
    start: StartMode,
    pause: Duration,
    frames: Option<u64>,
    end: FinalCheckpoint,
    growing: Box<dyn FnMut(usize) + 'a>,
    progress: Box<dyn FnMut(&R) + 'a>,
    saved: Saved<'a, R>,
    cancelled: Box<dyn Fn() -> bool + 'a>,
}

/// Callback for a written checkpoint.
type Saved<'a, R> = Box<dyn FnMut(&R, &Path) + 'a>;

impl<R> fmt::Debug for Session<'_, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Session")
            .field("folder", &self.folder)
            .field("start", &self.start)
            .field("pause", &self.pause)
            .field("frames", &self.frames)
            .finish_non_exhaustive()
    }
}

impl<'a, R: LongRun> Session<'a, R> {
    /// A run in a folder, which is created if missing and locked until the session ends.
    pub fn in_folder(folder: impl AsRef<Path>) -> Result<Self, RecordError> {
        let lock = Lock::take(folder.as_ref(), LockMode::Alone)?;
        Ok(Self::under(Arc::new(lock), folder.as_ref()))
    }

    /// A run in a folder that a held lock protects: the lock of this folder or of one above it.
    pub fn under(lock: Arc<Lock>, folder: &Path) -> Self {
        Self {
            lock,
            folder: folder.to_owned(),
            start: StartMode::Fresh,
            pause: PAUSE,
            frames: None,
            end: FinalCheckpoint::Written,
            growing: Box::new(|_| ()),
            progress: Box::new(|_| ()),
            saved: Box::new(|_, _| ()),
            cancelled: Box::new(|| false),
        }
    }

    /// Where the run starts; by default at its beginning.
    pub fn start(self, start: StartMode) -> Self {
        Self { start, ..self }
    }

    /// Time between checkpoints; by default a minute.
    pub fn checkpoint_every(self, pause: Duration) -> Self {
        Self { pause, ..self }
    }

    /// Largest number of frames, 0 for none, else 2 or more. The default is 100, or the number when
    /// the run began. Frames change no result.
    pub fn frames(self, limit: u64) -> Self {
        let frames = Some(limit);
        Self { frames, ..self }
    }

    /// Leaves no checkpoint of the end, where the caller keeps the results at once.
    pub fn without_final_checkpoint(self) -> Self {
        let end = FinalCheckpoint::Skipped;
        Self { end, ..self }
    }

    /// Callback with the number of bodies placed so far.
    pub fn on_growth(self, growing: impl FnMut(usize) + 'a) -> Self {
        let growing = Box::new(growing);
        Self { growing, ..self }
    }

    /// Callback before the first step and after every step.
    pub fn on_progress(self, progress: impl FnMut(&R) + 'a) -> Self {
        let progress = Box::new(progress);
        Self { progress, ..self }
    }

    /// Callback after a checkpoint was written to a file.
    pub fn on_checkpoint(self, saved: impl FnMut(&R, &Path) + 'a) -> Self {
        let saved = Box::new(saved);
        Self { saved, ..self }
    }

    /// Called after every step: if it returns true, the run ends with a checkpoint.
    pub fn cancel_when(self, cancelled: impl Fn() -> bool + 'a) -> Self {
        let cancelled = Box::new(cancelled);
        Self { cancelled, ..self }
    }

    /// Runs to the end.
    pub fn run(mut self, scene: &R::Scene) -> Result<R, RunError<R::Error>> {
        let first = match self.start {
            StartMode::Fresh => StartMode::Fresh,
            _ => StartMode::Resume,
        };
        let mut end = self.attempt(scene, first);
        if self.start == StartMode::ResumeIfPossible
            && end.as_ref().is_err_and(RunError::is_of_earlier_run)
        {
            end = self.attempt(scene, StartMode::Fresh);
        }
        end.map_err(|error| self.explained(error))
    }

    fn attempt(&mut self, scene: &R::Scene, start: StartMode) -> Result<R, RunError<R::Error>> {
        self.lock.check()?;
        std::fs::create_dir_all(&self.folder)
            .map_err(|error| RecordError::lost("make", &self.folder, error))?;
        let file = self.folder.join(CHECKPOINT);
        let (mut run, mut film) = {
            let kept = match start {
                StartMode::Fresh => None,
                _ => Some(read_checkpoint(&file)?),
            };
            let run = self.begin(scene, kept.as_deref())?;
            self.lock.check()?;
            let frames = self.folder.join(FRAMES);
            let film = FrameRecorder::of(&run, &frames, kept.as_deref(), self.frames)?;
            (run, film)
        };
        let mut saved = Instant::now();
        loop {
            (self.progress)(&run);
            film.offer_frame(&run);
            let is_cancelled = (self.cancelled)();
            if is_cancelled || (run.steps() > 0 && saved.elapsed() >= self.pause) {
                self.save(&run, &mut film, &file)?;
                saved = Instant::now();
            }
            if is_cancelled {
                return Err(RunError::Cancelled(run.steps()));
            }
            if !run.step().map_err(RunError::Scene)? {
                break;
            }
        }
        self.lock.check()?;
        let frames = film.limit();
        film.end(&run)?;
        if self.end == FinalCheckpoint::Written {
            self.write(&run, frames, &file)?;
        }
        Ok(run)
    }

    fn begin(&mut self, scene: &R::Scene, text: Option<&str>) -> Result<R, RunError<R::Error>> {
        let begun = R::begin(scene, text, &mut |bodies| {
            (self.growing)(bodies);
            if (self.cancelled)() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        begun.map_err(|error| match R::cause(&error) {
            Cause::Scene => RunError::Scene(error),
            Cause::Checkpoint => RunError::Checkpoint(error),
            Cause::Stopped => RunError::CancelledEarly,
        })
    }

    /// Writes frames first: a checkpoint requires all frames before it.
    fn save(
        &mut self,
        run: &R,
        film: &mut FrameRecorder,
        file: &Path,
    ) -> Result<(), RunError<R::Error>> {
        self.lock.check()?;
        film.save()?;
        self.write(run, film.limit(), file)
    }

    /// Writes the checkpoint, and how many frames are kept beside it.
    fn write(&mut self, run: &R, frames: u64, file: &Path) -> Result<(), RunError<R::Error>> {
        self.lock.check()?;
        let text = with_number(run.checkpoint(), FRAMES, frames);
        write_atomically_there(file, text.as_bytes())?;
        (self.saved)(run, file);
        Ok(())
    }

    /// Replaces a write error by the loss of the folder, if that is its cause.
    fn explained(&self, error: RunError<R::Error>) -> RunError<R::Error> {
        let is_final = matches!(
            error,
            RunError::Scene(_) | RunError::Cancelled(_) | RunError::CancelledEarly
        );
        match self.lock.check() {
            Err(lost) if !is_final && !error.is_out_of_room() => RunError::Record(lost),
            _ => error,
        }
    }
}

/// The text of a checkpoint.
pub fn read_checkpoint(file: &Path) -> Result<String, RecordError> {
    let file = file.to_owned();
    read_text(&file, MOST_BYTES).map_err(|cause| RecordError::NoCheckpoint {
        file,
        cause: Box::new(cause),
    })
}

/// Removes the checkpoint of a run whose results are written.
pub fn forget_checkpoint(folder: &Path) -> Result<(), RecordError> {
    remove_file(&folder.join(CHECKPOINT))
}
