//! Commands with a time limit.

use std::io::Read;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Interval at which a running command is polled.
const GLANCE: Duration = Duration::from_millis(50);

/// Output of a command, or the reason for its failure.
pub(super) fn output(command: &mut Command, limit: Duration) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let pipes = command.stdin(Stdio::null()).stdout(Stdio::piped());
    let mut child = pipes
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| format!("{name} does not start: {e}"))?;
    let (out, err) = (child.stdout.take(), child.stderr.take());
    let (out, err) = (thread::spawn(|| text(out)), thread::spawn(|| text(err)));
    let begin = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(|e| e.to_string())? {
            break Some(status);
        }
        if begin.elapsed() > limit {
            child.kill().map_err(|e| e.to_string())?;
            child.wait().map_err(|e| e.to_string())?;
            break None;
        }
        thread::sleep(GLANCE);
    };
    let [out, err] = [out, err].map(|reader| reader.join().unwrap_or_default());
    match status {
        None => Err(format!("{name}: not done after {} s", limit.as_secs())),
        Some(status) if status.success() => Ok(out),
        Some(status) => Err(format!("{name}: {status}\n{out}{err}")),
    }
}

fn text(from: Option<impl Read>) -> String {
    let mut bytes = Vec::new();
    // The output of a killed program up to that time is sufficient.
    let _ = from.map(|mut from| from.read_to_end(&mut bytes));
    String::from_utf8_lossy(&bytes).into_owned()
}
