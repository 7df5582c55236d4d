//! Runs and sweeps for programs that have this crate as a library: what the commands do, without a
//! terminal.

use crate::command::bodies;
use crate::command::run::frontend::Frontend;
use crate::command::run::request::RunRequest;
use crate::command::run::resource_check::MemoryPermission;
use crate::failure::Failure;
use std::path::Path;
use std::time::Duration;
use tribos::run::folder::InterruptedRunPolicy;
use tribos::scene::Scene;

pub use crate::command::progress::HostProgram;
pub use crate::command::run::request::Pictures;

/// A run in a folder, with the options of `tribos run`.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    /// Folder for the results.
    pub out: &'a Path,
    /// Whether the interrupted run in the folder goes on.
    pub resume: bool,
    /// Whether an interrupted run in the folder is discarded.
    pub anew: bool,
    /// Time between checkpoints.
    pub pause: Duration,
    /// Largest number of frames.
    pub frames: Option<u64>,
    /// Whether more than 4 GB of memory may be taken.
    pub allow_large: bool,
    /// Whether pictures are drawn.
    pub pictures: Pictures,
}

impl Run<'_> {
    /// Runs the scene and writes the files of `tribos run`, to the same bytes.
    pub fn run(&self, scene: &Scene, host: &dyn HostProgram) -> Result<(), Failure> {
        let body = bodies::of(scene);
        body.simulate(&RunRequest {
            out: self.out,
            broken: if self.anew {
                InterruptedRunPolicy::Replaced
            } else {
                InterruptedRunPolicy::Kept
            },
            // A run that takes a moment is done again.
            resume: self.resume && body.is_long(),
            pause: self.pause,
            frames: self.frames,
            allowed: MemoryPermission::of(self.allow_large),
            pictures: self.pictures,
            caller: Frontend::Host(host),
        })
    }
}
