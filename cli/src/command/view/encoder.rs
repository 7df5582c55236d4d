//! Film files: frames drawn one after another and handed to ffmpeg.

use super::colors::RenderStyle;
use super::frame_images;
use crate::failure::Failure;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use tribos::record::{RecordError, write_atomically_with};
use tribos::run::in_order;
use tribos_report::runs::RunFrames;

/// Endings of films, and what ffmpeg is told for them.
const ENDINGS: [(&str, &[&str]); 3] = [
    ("mp4", &["-pix_fmt", "yuv420p", "-movflags", "+faststart"]),
    ("webm", &["-pix_fmt", "yuv420p"]),
    (
        "gif",
        &[
            "-filter_complex",
            "split[a][b];[a]palettegen[p];[b][p]paletteuse",
        ],
    ),
];
/// Frames drawn at a time, on as many threads.
const AT_ONCE: usize = 8;

/// A file name with a known ending.
pub fn film_name(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match ending(&path) {
        Some(_) => Ok(path),
        None => Err("end the name in .mp4, .webm or .gif".into()),
    }
}

fn ending(path: &Path) -> Option<(&'static str, &'static [&'static str])> {
    let given = path.extension()?.to_str()?;
    ENDINGS.into_iter().find(|(known, _)| *known == given)
}

/// Draws all frames into a film, which appears whole or not at all.
pub fn film(run: &RunFrames, look: &RenderStyle, file: &Path, rate: u32) -> Result<(), Failure> {
    let (ending, options) = ending(file).unwrap_or(ENDINGS[0]);
    let unfinished = file.with_extension(format!("unfinished.{ending}"));
    let mut encoder = begin(&unfinished, rate, options)?;
    let fed = feed(run, look, &mut encoder);
    let output = encoder.wait_with_output().map_err(Failure::run)?;
    let done = if output.status.success() {
        fed.and_then(|()| deliver(&unfinished, file))
    } else {
        let said = String::from_utf8_lossy(&output.stderr);
        let last = said.lines().last().unwrap_or("nothing");
        Err(Failure::run(format!(
            "ffmpeg could not write {}: it said: {last}",
            file.display()
        )))
    };
    let _ = std::fs::remove_file(&unfinished);
    done
}

/// Copies a film to its place, as every other output goes there.
fn deliver(film: &Path, file: &Path) -> Result<(), Failure> {
    let fail = |cause| RecordError::Write {
        path: file.to_owned(),
        cause,
    };
    Ok(write_atomically_with(file, |out| {
        let mut film = std::fs::File::open(film).map_err(fail)?;
        std::io::copy(&mut film, out).map(|_| ()).map_err(fail)
    })?)
}

/// Starts ffmpeg, which waits for pictures.
fn begin(file: &Path, rate: u32, options: &[&str]) -> Result<Child, Failure> {
    let started = Command::new("ffmpeg")
        .args([
            "-loglevel",
            "error",
            "-y",
            "-f",
            "image2pipe",
            "-c:v",
            "png",
        ])
        .args(["-framerate", &rate.to_string(), "-i", "-"])
        .args(options)
        .arg(file)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn();
    started.map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => Failure::input(
            "--film needs ffmpeg, which is not on the PATH; install it, or take --still or the page",
        ),
        _ => Failure::run(format!("cannot start ffmpeg: {error}")),
    })
}

/// Draws frames some at a time and hands them over in order.
fn feed(run: &RunFrames, look: &RenderStyle, encoder: &mut Child) -> Result<(), Failure> {
    // Dropped at the end: ffmpeg sees that no more will come.
    let Some(mut pipe) = encoder.stdin.take() else {
        return Err(Failure::run("ffmpeg takes no pictures"));
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let count = run.frames.len();
    for first in (0..count).step_by(AT_ONCE) {
        let some = AT_ONCE.min(count - first);
        let draw = |index: usize| frame_images::png(run, look, first + index);
        for picture in in_order(some, threads, draw) {
            let picture = picture.unwrap_or_else(|| Err(Failure::run("a picture was lost")))?;
            pipe.write_all(&picture)
                .map_err(|error| Failure::run(format!("ffmpeg stopped listening: {error}")))?;
        }
    }
    Ok(())
}
