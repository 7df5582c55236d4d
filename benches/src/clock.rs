//! The clock of all samples: processor time of this program.
//!
//! On a shared machine wall time includes other programs' work: a sample of a millisecond waits for
//! them and one of a microsecond does not, which distorts ratios. If the system does not provide
//! processor time, wall time is used.

/// A point in time.
#[derive(Clone, Copy, Debug)]
pub struct Clock(Instant);

#[cfg(unix)]
type Instant = rustix::time::Timespec;
#[cfg(not(unix))]
type Instant = std::time::Instant;

impl Clock {
    /// Now.
    pub fn start() -> Self {
        #[cfg(unix)]
        let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        #[cfg(not(unix))]
        let now = Instant::now();
        Self(now)
    }

    /// Seconds of the processor since the start, on all threads together.
    pub fn seconds(self) -> f64 {
        #[cfg(unix)]
        let seconds = {
            let (now, start) = (Self::start().0, self.0);
            (now.tv_sec - start.tv_sec) as f64 + 1e-9 * (now.tv_nsec - start.tv_nsec) as f64
        };
        #[cfg(not(unix))]
        let seconds = self.0.elapsed().as_secs_f64();
        seconds
    }
}
