//! What a run will take, said and judged before work starts.

use crate::failure::Failure;
use tribos::powder::deposit::MOST_SPHERES;
use tribos::run::RunSize;

/// Memory, in bytes, that a command takes without being asked to take more.
const MOST_BYTES: f64 = 4e9;

/// Whether more than 4 GB may be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MemoryPermission {
    /// 4 GB at most.
    Usual,
    /// Whatever the machine has.
    Large,
    /// 4 GB at most, whatever is asked for.
    Never,
}

impl MemoryPermission {
    /// From the option.
    pub fn of(allow_large: bool) -> Self {
        if allow_large {
            Self::Large
        } else {
            Self::Usual
        }
    }
}

/// Refuses what is too large; `what` are spheres or atoms.
pub fn check(size: &RunSize, what: &str, allowed: MemoryPermission) -> Result<(), Failure> {
    if what == "spheres" && size.bodies > 1.5 * MOST_SPHERES as f64 {
        return Err(Failure::input(format!(
            "{}: more than {MOST_SPHERES} spheres, the most that a deposit may have; make it lower \
             or narrower",
            describe_size(size, what)
        )));
    }
    let most = match allowed {
        MemoryPermission::Large => return Ok(()),
        MemoryPermission::Usual => "the 4 GB that are taken without --allow-large",
        MemoryPermission::Never => "the 4 GB that this command takes; make it smaller",
    };
    if size.bytes > MOST_BYTES {
        let size = describe_size(size, what);
        return Err(Failure::input(format!("{size}: more than {most}")));
    }
    Ok(())
}

/// The size in words.
pub fn describe_size(size: &RunSize, what: &str) -> String {
    const GIGA: f64 = 1e9;
    const MEGA: f64 = 1e6;
    let memory = if size.bytes >= GIGA {
        format!("{} GB", rounded(size.bytes / GIGA))
    } else {
        format!("{} MB", rounded((size.bytes / MEGA).max(1.0)))
    };
    format!(
        "about {} {what}, {memory} of memory, in the order of {}",
        rounded(size.bodies),
        time(size.seconds)
    )
}

/// Two digits.
fn rounded(value: f64) -> String {
    const LARGE: f64 = 1e6;
    let scale = 10_f64.powi(1 - value.abs().max(1.0).log10().floor() as i32);
    let two = (value * scale).round() / scale;
    if two < LARGE {
        format!("{}", if value < 10.0 { two } else { two.round() })
    } else {
        format!("{two:.1e}")
    }
}

fn time(seconds: f64) -> String {
    const UNITS: [(f64, &str); 5] = [
        (60.0, "seconds"),
        (60.0, "minutes"),
        (48.0, "hours"),
        (365.25 / 2.0, "days"),
        (f64::INFINITY, "years"),
    ];
    let mut value = seconds.max(1.0);
    for (next, name) in UNITS {
        if value < 1.5 * next {
            let value = rounded(value.round().max(1.0));
            let name = if value == "1" {
                name.trim_end_matches('s')
            } else {
                name
            };
            return format!("{value} {name}");
        }
        // Two days are 48 hours, two half-years a year.
        value /= match name {
            "hours" => 24.0,
            "days" => 365.25,
            _ => next,
        };
    }
    format!("{value:.0e} years")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_told_in_two_digits_and_large_ones_refused() {
        let size = |bodies: f64| RunSize {
            bodies,
            bytes: 5e3 * bodies,
            seconds: 25e-3 * bodies,
        };
        let small = describe_size(&size(449.3), "spheres");
        assert_eq!(
            small,
            "about 450 spheres, 2.2 MB of memory, in the order of 11 seconds"
        );
        let wide = describe_size(&size(194_321.0), "spheres");
        assert_eq!(
            wide,
            "about 190000 spheres, 970 MB of memory, in the order of 81 minutes"
        );
        let Err(Failure::Input(refused)) = check(&size(1e12), "spheres", MemoryPermission::Large)
        else {
            unreachable!("more than a deposit may have");
        };
        assert!(
            refused.starts_with("about 1.0e12 spheres, 5.0e6 GB") && refused.contains("790 years"),
            "{refused}"
        );
        assert!(check(&size(1e6), "atoms", MemoryPermission::Usual).is_err());
        assert!(check(&size(1e6), "atoms", MemoryPermission::Large).is_ok());
        assert!(check(&size(194_321.0), "spheres", MemoryPermission::Usual).is_ok());
    }
}
