//! Lines on the terminal of the emulator. The macros of `semihosting` contain a panic for formatters
//! that fail, so they are not used.

use core::fmt::{Arguments, Error, Result, Write};

/// Outputs of a program.
#[cfg(not(feature = "silent"))]
struct Terminal<W>(W);

#[cfg(not(feature = "silent"))]
impl<W: semihosting::io::Write> Write for Terminal<W> {
    fn write_str(&mut self, text: &str) -> Result {
        let mut left = text.as_bytes();
        while !left.is_empty() {
            let written = self.0.write(left).map_err(|_| Error)?;
            // A terminal that accepts nothing would cause endless retries.
            left = match left.get(written..) {
                Some(rest) if written > 0 => rest,
                _ => return Err(Error),
            };
        }
        Ok(())
    }
}

/// Output that is discarded: the text is still formatted, byte by byte.
#[cfg(feature = "silent")]
struct NullOutput;

#[cfg(feature = "silent")]
impl Write for NullOutput {
    fn write_str(&mut self, text: &str) -> Result {
        for byte in text.bytes() {
            core::hint::black_box(byte);
        }
        core::hint::black_box(Ok(())).map_err(|()| Error)
    }
}

/// Implementation of [`crate::print`]. Failures are ignored, since they cannot be reported.
#[doc(hidden)]
pub fn tell(text: Arguments<'_>) {
    #[cfg(not(feature = "silent"))]
    if let Ok(out) = semihosting::io::stdout() {
        let _ = Terminal(out).write_fmt(text);
    }
    #[cfg(feature = "silent")]
    let _ = NullOutput.write_fmt(text);
}

/// Implementation of [`crate::eprintln`].
#[doc(hidden)]
pub fn complain(text: Arguments<'_>) {
    #[cfg(not(feature = "silent"))]
    if let Ok(out) = semihosting::io::stderr() {
        let _ = Terminal(out).write_fmt(text);
    }
    #[cfg(feature = "silent")]
    let _ = NullOutput.write_fmt(text);
}

/// Writes to the output of the emulator.
#[macro_export]
macro_rules! print {
    ($($text:tt)*) => { $crate::console::tell(::core::format_args!($($text)*)) };
}

/// Writes a line to the output of the emulator.
#[macro_export]
macro_rules! println {
    () => { $crate::print!("\n") };
    ($($text:tt)*) => { $crate::print!("{}\n", ::core::format_args!($($text)*)) };
}

/// Writes a line to the error output of the emulator.
#[macro_export]
macro_rules! eprintln {
    ($($text:tt)*) => {
        $crate::console::complain(
            ::core::format_args!("{}\n", ::core::format_args!($($text)*))
        )
    };
}
