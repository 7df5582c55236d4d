//! Running LAMMPS: detection, input, and timing from its output.

use std::fs;
use std::process::Command;

/// Name of the program on the PATH.
const PROGRAM: &str = "lmp";
/// Advice if the program is missing.
pub const MISSING: &str = "LAMMPS: no `lmp` on the PATH (Debian: apt-get install lammps)";

/// Input of LAMMPS.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name and text of the file that the script reads.
    pub data: (&'static str, String),
    /// Commands.
    pub script: String,
    /// Which `run` of the script is timed, from 0.
    pub timed: usize,
}

/// Output of LAMMPS about a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunReport {
    /// The processor's seconds in the loop over steps.
    pub seconds: f64,
    /// Shares of pair forces and of lists.
    pub shares: [f64; 2],
    /// Pairs in the last list.
    pub pairs: f64,
    /// Lists built.
    pub builds: f64,
    /// Potential energy before the first step.
    pub energy: f64,
}

/// The release, where the program is on the PATH.
pub fn release() -> Option<String> {
    let output = Command::new(PROGRAM).arg("-h").output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let line = text.lines().find(|line| line.contains(" Simulator - "))?;
    line.split_once(" - ").map(|(_, release)| release.into())
}

/// One run on one thread, with the pair styles of the package OPT.
pub fn run(input: &Input) -> Result<RunReport, String> {
    let folder = tempfile::tempdir().map_err(|error| format!("no folder for LAMMPS: {error}"))?;
    let (name, text) = &input.data;
    for (name, text) in [(*name, text), ("in.front", &input.script)] {
        fs::write(folder.path().join(name), text)
            .map_err(|error| format!("cannot write {name} for LAMMPS: {error}"))?;
    }
    let output = Command::new(PROGRAM)
        .args(["-sf", "opt", "-log", "none", "-nocite", "-in", "in.front"])
        .env("OMP_NUM_THREADS", "1")
        .current_dir(folder.path())
        .output()
        .map_err(|error| format!("cannot run {PROGRAM}: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    read(&text, input.timed).ok_or_else(|| {
        let last = text.lines().last().unwrap_or_default();
        format!("{PROGRAM} tells no time of run {}: {last}", input.timed)
    })
}

/// Reads the output of LAMMPS.
fn read(text: &str, timed: usize) -> Option<RunReport> {
    let energy = energy(text)?;
    let text = text.split("Loop time of ").nth(timed + 1)?;
    let number = |line: &str, place: usize| line.split_whitespace().nth(place)?.parse().ok();
    let line = |part: &str| text.lines().find(|line| line.contains(part));
    let wall: f64 = number(text, 0)?;
    let busy = line("% CPU use")?.split('%').next()?.trim();
    let busy: f64 = busy.parse().ok()?;
    // LAMMPS measures wall time; its shares apply to processor time too.
    let share = |part: &str| -> Option<f64> { Some(number(line(part)?, 2)? / wall) };
    Some(RunReport {
        seconds: wall * busy / 100.0,
        shares: [share("Pair  ")?, share("Neigh  ")?],
        pairs: number(line("Total # of neighbors")?, 5)?,
        builds: number(line("Neighbor list builds")?, 4)?,
        energy,
    })
}

/// The first number under the heading of the potential energy.
fn energy(text: &str) -> Option<f64> {
    let mut lines = text.lines();
    let heading = lines.find(|line| line.contains("PotEng"))?;
    let column = heading.split_whitespace().position(|w| w == "PotEng")?;
    lines.next()?.split_whitespace().nth(column)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_of_the_run_asked_for_is_read() {
        let text = "\
Step PotEng Temp
       0 -6.75 1.44
Loop time of 7 on 1 procs for 0 steps with 4000 atoms
Step PotEng Temp
       0 -5 1.44
Loop time of 0.5 on 1 procs for 100 steps with 4000 atoms

Performance: 112565.730 tau/day, 260.569 timesteps/s
80.0% CPU use with 1 MPI tasks x 1 OpenMP threads

Section |  min time  |  avg time  |  max time  |%varavg| %total
Pair    | 0.25       | 0.25       | 0.25       |   0.0 | 50.00
Neigh   | 0.125      | 0.125      | 0.125      |   0.0 | 25.00

Total # of neighbors = 150098
Neighbor list builds = 11
";
        let told = RunReport {
            seconds: 0.4,
            shares: [0.5, 0.25],
            pairs: 150_098.0,
            builds: 11.0,
            energy: -6.75,
        };
        assert_eq!(read(text, 1), Some(told));
        assert_eq!(read(text, 2), None);
        assert_eq!(read("ERROR: Unknown pair style\n", 0), None);
    }
}
