//! Ctrl-C and SIGTERM: a long run leaves what it has and says how to go on.

use crate::failure::{Failure, INTERRUPTED};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

static ASKED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// From now on the first signal is noted, and the second ends the process at once.
pub fn watch() -> Result<(), Failure> {
    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::flag::{register, register_conditional_shutdown};
    if ASKED.get().is_some() {
        return Ok(());
    }
    let fail = |error| Failure::run(format!("cannot watch for signals: {error}"));
    let asked = ASKED.get_or_init(Arc::default);
    for signal in [SIGINT, SIGTERM] {
        // In this order: the first signal finds that nobody has asked yet.
        register_conditional_shutdown(signal, INTERRUPTED.into(), asked.clone()).map_err(fail)?;
        register(signal, asked.clone()).map_err(fail)?;
    }
    Ok(())
}

/// Whether the command has been asked to end.
pub fn is_asked() -> bool {
    ASKED
        .get()
        .is_some_and(|asked| asked.load(Ordering::Relaxed))
}
