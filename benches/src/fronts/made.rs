//! Date, machine and command of a front.

use crate::args::Options;
use crate::command_line::first_line;
use std::fs;

/// Date, machine, load, compiler and command, in one line.
pub fn now(options: &Options) -> String {
    let date = first_line("date", &["+%Y-%m-%d"]).unwrap_or("on an unknown day".into());
    let compiler = std::env::var("RUSTC").unwrap_or("rustc".into());
    let compiler = first_line(&compiler, &["-V"]).unwrap_or("rustc of unknown version".into());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let load = load().map_or(String::new(), |load| {
        format!(", load average {load} at the start")
    });
    format!(
        "Made {date} on {}, cores: {cores}{load}; {compiler}; times are the processor's; by `{}`",
        processor(),
        options.command()
    )
}

/// The model that Linux reports, else the architecture.
fn processor() -> String {
    let told = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = model(&told).map(|model| format!("{model} ({})", std::env::consts::ARCH));
    model.unwrap_or(std::env::consts::ARCH.into())
}

fn model(told: &str) -> Option<String> {
    let line = told.lines().find(|line| line.starts_with("model name"))?;
    let (_, model) = line.split_once(':')?;
    Some(model.trim().to_string())
}

/// Load average of the last minute, which shows other work on the machine.
fn load() -> Option<String> {
    let told = fs::read_to_string("/proc/loadavg").ok()?;
    told.split(' ').next().map(String::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[test]
    fn the_header_tells_machine_compiler_date_and_command() {
        let words = "fronts --only kernel --quick --out somewhere";
        let options = Options::try_parse_from(words.split(' ')).unwrap();
        let made = now(&options);
        for part in ["Made 20", "cores: ", "rustc ", "--only kernel --quick"] {
            assert!(made.contains(part), "{part} is missing: {made}");
        }
        assert!(!made.contains("somewhere") && !made.contains('\n'));
    }

    #[test]
    fn a_processor_has_its_model() {
        let told = "processor\t: 0\nmodel name\t: Some CPU @ 2 GHz\n";
        assert_eq!(model(told).as_deref(), Some("Some CPU @ 2 GHz"));
        assert_eq!(model("processor : 0"), None);
    }
}
