//! Running GROMACS in double precision: detection, input, and timing from its log.

use super::melt::{CUTOFF, Melt, SKIN, TIME_STEP};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Name of the program on the PATH, as Debian's package `gromacs` installs it.
const PROGRAM: &str = "gmx_d";

/// Output of GROMACS about a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunReport {
    /// The processor's seconds in the loop over steps.
    pub seconds: f64,
    /// Potential energy before the first step, to six digits.
    pub energy: f64,
}

/// Whether the program is on the PATH.
pub fn is_installed() -> bool {
    let output = Command::new(PROGRAM).args(["-quiet", "--version"]).output();
    output.is_ok_and(|output| output.status.success())
}

/// The melt at constant energy on one thread; its lists have our cut-off and skin and live `list_life` steps.
pub fn run(melt: &Melt, steps: u64, list_life: u64) -> Result<RunReport, String> {
    let folder = tempfile::tempdir().map_err(|error| format!("no folder for GROMACS: {error}"))?;
    let folder = folder.path();
    for (name, text) in [
        ("conf.gro", places(melt)),
        ("topol.top", topology(melt.atoms.len())),
        ("grompp.mdp", parameters(steps, list_life)),
    ] {
        fs::write(folder.join(name), text)
            .map_err(|error| format!("cannot write {name} for GROMACS: {error}"))?;
    }
    call(folder, "gmx_d -quiet grompp -maxwarn 9")?;
    let clock = Instant::now();
    let run = "gmx_d -quiet mdrun -ntmpi 1 -ntomp 1 -pin off >/dev/null 2>&1 && times";
    let times = call(folder, run)?;
    let elapsed = clock.elapsed().as_secs_f64();
    let log = fs::read_to_string(folder.join("md.log")).unwrap_or_default();
    read(&log, &times, elapsed).ok_or_else(|| format!("{PROGRAM} tells no time of its run"))
}

/// Output of a command of the shell, which knows the processor's time of what it ran.
fn call(folder: &Path, command: &str) -> Result<String, String> {
    let output = Command::new("sh")
        .args(["-c", command])
        .current_dir(folder)
        .output();
    let output = output.map_err(|error| format!("cannot run {PROGRAM}: {error}"))?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    } else {
        Err(format!("{PROGRAM} fails: {command}"))
    }
}

/// Reads the log and what the shell's `times` prints.
fn read(log: &str, times: &str, elapsed: f64) -> Option<RunReport> {
    let mut lines = log.lines();
    let heading = lines.find(|line| line.contains("LJ (SR)"))?;
    // Columns of 15 characters.
    let column = heading.find("Potential")? / 15;
    let energy = lines.next()?.split_whitespace().nth(column)?.parse().ok()?;
    let time = lines.find(|line| line.trim_start().starts_with("Time:"))?;
    let wall: f64 = time.split_whitespace().nth(2)?.parse().ok()?;
    // Minutes and seconds of children, in programs and in the system. GROMACS measures wall time.
    let busy: f64 = times.lines().nth(1)?.split_whitespace().map(seconds).sum();
    Some(RunReport {
        seconds: wall * busy / elapsed,
        energy,
    })
}

/// Seconds of a text like 1m2.34s.
fn seconds(text: &str) -> f64 {
    let parts = text.trim_end_matches('s').split_once('m');
    let parts = parts.and_then(|(minutes, seconds)| {
        Some(60.0 * minutes.parse::<f64>().ok()? + seconds.parse::<f64>().ok()?)
    });
    parts.unwrap_or(f64::NAN)
}

/// Places and velocities with all the digits that fit: units of GROMACS are σ, ε and the mass of an atom.
fn places(melt: &Melt) -> String {
    let atoms = &melt.atoms;
    let mut text = format!("melt\n{}\n", atoms.len());
    for (atom, (place, velocity)) in atoms.positions.iter().zip(&atoms.velocities).enumerate() {
        let number = (atom + 1) % 100_000;
        let _ = write!(text, "{number:5}LJ       A{number:5}");
        for x in place {
            let _ = write!(text, "{x:18.12}");
        }
        for v in velocity {
            let _ = write!(text, "{v:18.13}");
        }
        text += "\n";
    }
    let edge = melt.edge;
    let _ = writeln!(text, "{edge:.12} {edge:.12} {edge:.12}");
    text
}

fn topology(atoms: usize) -> String {
    format!(
        "[ defaults ]\n1 1 no 1.0 1.0\n[ atomtypes ]\nA A 18 1.0 0.0 A 4.0 4.0\n[ moleculetype ]\nLJ 1\n\
         [ atoms ]\n1 A 1 LJ A 1 0.0 1.0\n[ system ]\nmelt\n[ molecules ]\nLJ {atoms}\n"
    )
}

fn parameters(steps: u64, list_life: u64) -> String {
    format!(
        "integrator = md\ndt = {TIME_STEP}\nnsteps = {steps}\ncutoff-scheme = Verlet\n\
         verlet-buffer-tolerance = -1\nnstlist = {list_life}\nrlist = {}\ncoulombtype = Cut-off\n\
         rcoulomb = {CUTOFF}\nvdwtype = Cut-off\nvdw-modifier = None\nrvdw = {CUTOFF}\n\
         nstcomm = 0\ncomm-mode = None\nnstenergy = {steps}\nnstcalcenergy = {steps}\nnstlog = {steps}\n",
        CUTOFF + SKIN
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_energies_are_read() {
        let log = "\
   Energies (kJ/mol)
        LJ (SR)   Coulomb (SR)      Potential    Kinetic En.   Total Energy
   -1.83318e+05    0.00000e+00   -1.83319e+05    3.53824e+04   -1.47936e+05

               Core t (s)   Wall t (s)        (%)
       Time:        8.000        8.000      100.0
";
        // In its 10 seconds the program had the processor for a quarter of the time.
        let times = "0m0.00s 0m0.00s\n0m2.40s 0m0.10s\n";
        let told = read(log, times, 10.0).expect("all is there");
        assert!((told.seconds - 2.0).abs() < 1e-12);
        assert_eq!(told.energy, -183_319.0);
        assert_eq!(read("", times, 10.0), None);
        assert_eq!(seconds("1m2.5s"), 62.5);
    }
}
