//! How far long work is, on standard error: one line that is redrawn in a terminal, with a bar and
//! the time left; plain lines, rarer as time goes on, in a pipe or a file; nothing with --quiet.

use super::output_options::is_quiet;
use std::fmt;
use std::io::{IsTerminal, Write};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How often a line in a terminal is redrawn.
const REDRAWN: Duration = Duration::from_millis(200);
/// The shortest time from one plain line to the next, and its share of the time gone.
const LINES: Duration = Duration::from_secs(1);
const LINES_SHARE: f64 = 0.02;
/// Characters of the bar, and of the whole line in a terminal of 80.
const BAR: usize = 20;
const WIDTH: usize = 79;

/// Characters of the line that is drawn now.
static DRAWN: Mutex<usize> = Mutex::new(0);

fn drawn() -> MutexGuard<'static, usize> {
    DRAWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether standard error is a terminal that can go back to the start of a line.
fn is_terminal() -> bool {
    static ANSWER: LazyLock<bool> = LazyLock::new(|| {
        let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
        std::io::stderr().is_terminal() && !is_dumb
    });
    *ANSWER
}

/// Takes the drawn line away, before anything else is written.
pub fn erase() {
    let mut drawn = drawn();
    if *drawn > 0 {
        let blank = " ".repeat(*drawn);
        let _ = write!(std::io::stderr().lock(), "\r{blank}\r");
        *drawn = 0;
    }
}

/// Draws a line in place of the last one.
fn draw(text: &str) {
    let mut drawn = drawn();
    let text: String = text.chars().take(WIDTH).collect();
    let length = text.chars().count();
    let blank = " ".repeat(drawn.saturating_sub(length));
    // One write a line: lines of several threads do not mix.
    let line = format!("\r{text}{blank}");
    let _ = std::io::stderr().lock().write_all(line.as_bytes());
    *drawn = length;
}

/// `words` about work of which the share `done` is done: drawn with a bar in a terminal, else a
/// line.
pub fn show(done: f64, words: fmt::Arguments<'_>) {
    if is_quiet() {
    } else if is_terminal() {
        draw(&format!("{} {words}", bar(done)));
    } else {
        super::warn(words);
    }
}

/// A program that runs scenes through this crate.
pub trait HostProgram: Sync {
    /// Whether the run is to end; a long one leaves its checkpoint then. Called after every step.
    fn is_cancelled(&self) -> bool;

    /// Called a few times in a second: the share of the run that is done, if its end is known, and words.
    fn on_progress(&self, done: Option<f64>, words: fmt::Arguments<'_>);
}

/// Follows one piece of work.
pub struct Meter<'a> {
    /// The program that hears of it in place of a terminal.
    host: Option<&'a dyn HostProgram>,
    started: Instant,
    told: Instant,
    /// Share that was done before the start, known with the first message.
    before: Option<f64>,
}

impl fmt::Debug for Meter<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Meter")
            .field("started", &self.started)
            .finish_non_exhaustive()
    }
}

impl<'a> Meter<'a> {
    /// Begins now.
    pub fn new() -> Self {
        Self::told_to(None)
    }

    /// Begins now, for a program.
    pub fn of(host: &'a dyn HostProgram) -> Self {
        Self::told_to(Some(host))
    }

    fn told_to(host: Option<&'a dyn HostProgram>) -> Self {
        Self {
            host,
            started: Instant::now(),
            told: Instant::now(),
            before: None,
        }
    }

    /// Whether it is time to say how far the work is; `done` is its share now.
    pub fn is_due(&mut self, done: f64) -> bool {
        self.before.get_or_insert(done);
        if self.host.is_some() {
            return self.told.elapsed() >= REDRAWN;
        }
        let pause = if is_terminal() {
            REDRAWN
        } else {
            LINES.max(self.started.elapsed().mul_f64(LINES_SHARE))
        };
        !is_quiet() && self.told.elapsed() >= pause
    }

    /// Says that the share `done` is done, with the time left.
    pub fn tell(&mut self, done: f64, words: fmt::Arguments<'_>) {
        self.told = Instant::now();
        if let Some(host) = self.host {
            return host.on_progress(Some(done), words);
        }
        let before = self.before.unwrap_or(0.0);
        let left = match left(self.started.elapsed(), before, done) {
            Some(left) => format!("{} left", in_words(left)),
            None => format!("{} gone", in_words(self.started.elapsed())),
        };
        if is_terminal() {
            draw(&format!("{} {left}  {words}", bar(done)));
        } else {
            super::warn(format_args!("{words}  {:.1} %, {left}", 100.0 * done));
        }
    }

    /// As [`Self::tell`] for work whose end is not known: the time gone.
    pub fn report_elapsed(&mut self, words: fmt::Arguments<'_>) {
        self.told = Instant::now();
        if let Some(host) = self.host {
            return host.on_progress(None, words);
        }
        let gone = in_words(self.started.elapsed());
        if is_terminal() {
            draw(&format!("{gone}  {words}"));
        } else {
            super::warn(format_args!("{words}  {gone} gone"));
        }
    }
}

/// "[=====>        ]  25 %"
fn bar(done: f64) -> String {
    let done = done.clamp(0.0, 1.0);
    let full = (done * BAR as f64) as usize;
    let head = if full < BAR { ">" } else { "" };
    let filled = "=".repeat(full) + head;
    format!("[{filled:<BAR$}] {:3.0} %", 100.0 * done)
}

/// What is left if the rest goes at the pace of what was done since the start.
fn left(gone: Duration, before: f64, done: f64) -> Option<Duration> {
    let pace = (done - before) / gone.as_secs_f64();
    let left = Duration::try_from_secs_f64((1.0 - done) / pace);
    left.ok().filter(|_| pace > 0.0)
}

/// Seconds in a minute, and minutes in an hour.
const SIXTY: u64 = 60;

/// "12 s", "3 min 20 s" or "2 h 5 min".
pub fn in_words(time: Duration) -> String {
    let seconds = time.as_secs_f64().round() as u64;
    let minutes = seconds / SIXTY;
    match (minutes / SIXTY, minutes) {
        (0, 0) => format!("{seconds} s"),
        (0, _) => format!("{minutes} min {} s", seconds % SIXTY),
        (hours, _) => format!("{hours} h {} min", minutes % SIXTY),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_fills_up() {
        assert_eq!(bar(0.0), "[>                   ]   0 %");
        assert_eq!(bar(0.5), "[==========>         ]  50 %");
        assert_eq!(bar(1.0), "[====================] 100 %");
        assert_eq!(bar(f64::NAN).len(), bar(0.0).len());
    }

    #[test]
    fn the_time_left_counts_from_where_the_run_went_on() {
        let gone = Duration::from_secs(10);
        assert_eq!(left(gone, 0.0, 0.5), Some(gone));
        // The first half was done before.
        assert_eq!(left(gone, 0.5, 0.75), Some(gone));
        assert_eq!(left(gone, 0.5, 0.5), None);
        assert_eq!(left(Duration::ZERO, 0.0, 0.0), None);
    }

    #[test]
    fn times_have_two_units_at_most() {
        for (seconds, said) in [(59.4, "59 s"), (200.0, "3 min 20 s"), (7500.0, "2 h 5 min")] {
            assert_eq!(in_words(Duration::from_secs_f64(seconds)), said);
        }
    }
}
