//! A sweep as a job array of Slurm.

use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::record::write_atomically;
use tribos::run::program;

/// Name of the script in a sweep's folder.
pub const SCRIPT: &str = "job.sh";
/// Folder of what the tasks say; Slurm does not make it.
const LOGS: &str = "logs";
/// Most tasks unless told otherwise: arrays of more than 1001 are refused by default.
const MOST_TASKS: usize = 100;

/// How the array is made.
#[derive(Debug)]
pub struct JobArray {
    tasks: usize,
    options: Vec<String>,
}

impl JobArray {
    /// An array of so many tasks for `runs` runs; one a run, at most [`MOST_TASKS`], if left out.
    pub fn new(tasks: Option<usize>, runs: usize, options: &[String]) -> Result<Self, Failure> {
        for option in options {
            let name = option.split(['=', ' ']).next().unwrap_or_default();
            let refusal = match name {
                "--array" | "-a" => "the tasks are numbered here; give --slurm-tasks",
                name if !name.starts_with('-') => {
                    "write it as sbatch takes it, such as --time=2:00:00"
                }
                _ if option.contains('\n') => "one option at a time, on one line",
                _ => continue,
            };
            return Err(Failure::input(format!(
                "--slurm-option: `{option}`: {refusal}"
            )));
        }
        Ok(Self {
            tasks: tasks.unwrap_or(MOST_TASKS).min(runs).max(1),
            options: options.to_vec(),
        })
    }

    /// Number of tasks.
    pub fn tasks(&self) -> usize {
        self.tasks
    }

    /// Writes the script into the folder: its place.
    pub fn write(&self, out: &Path) -> Result<PathBuf, Failure> {
        let logs = out.join(LOGS);
        let fail = |what: &Path, error| {
            let name = what.display();
            Failure::run(format!("cannot use {name}: {error}"))
        };
        std::fs::create_dir_all(&logs).map_err(|error| fail(&logs, error))?;
        // Slurm starts a copy of the script elsewhere: every place is a whole one.
        let folder = out.canonicalize().map_err(|error| fail(out, error))?;
        let program = program::command().map_err(|error| fail(Path::new("tribos"), error))?;
        let script = folder.join(SCRIPT);
        let text = self.script(&plain(&folder)?, &plain(&program)?);
        write_atomically(&script, text.as_bytes())?;
        Ok(script)
    }

    fn script(&self, folder: &str, program: &str) -> String {
        let last = self.tasks - 1;
        let tasks = self.tasks;
        let log = folder.replace('%', "%%");
        let mut text = format!(
            "#!/usr/bin/env bash\n\
             # A sweep of tribos: each task takes its part of the runs in sweep.json, and goes on\n\
             # where it stopped if it is started again. Another program: TRIBOS=/path/to/tribos.\n\
             #SBATCH --job-name=tribos-sweep\n\
             #SBATCH --array=0-{last}\n\
             #SBATCH --output=\"{log}/{LOGS}/%a.log\"\n\
             #SBATCH --open-mode=append\n\
             #SBATCH --requeue\n"
        );
        for option in &self.options {
            text += &format!("#SBATCH {option}\n");
        }
        let [folder, program] = [folder, program].map(quoted);
        text += &format!(
            "set -euo pipefail\n\
             cores=${{SLURM_CPUS_PER_TASK:-1}}\n\
             export RAYON_NUM_THREADS=$cores\n\
             program={program}\n\
             exec \"${{TRIBOS:-$program}}\" sweep --plan {folder} \\\n    \
             --part \"$SLURM_ARRAY_TASK_ID/{tasks}\" --jobs \"$cores\"\n"
        );
        text
    }
}

/// A path as text that a line of the script can hold.
fn plain(path: &Path) -> Result<String, Failure> {
    let text = path.to_str().filter(|text| !text.contains(['\n', '"']));
    text.map(str::to_owned).ok_or_else(|| {
        let name = path.display();
        Failure::input(format!(
            "{name}: a job script needs a plainer name of the folder"
        ))
    })
}

/// One word of the shell.
fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', r"'\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_script_hands_each_task_its_part() -> Result<(), Failure> {
        let options = ["--time=1:00".to_owned(), "-p short".to_owned()];
        let array = JobArray::new(Some(3), 10, &options)?;
        let text = array.script("/a b/it's 5%", "/bin/tribos");
        for line in [
            "#SBATCH --array=0-2",
            "#SBATCH --output=\"/a b/it's 5%%/logs/%a.log\"",
            "#SBATCH --time=1:00",
            "#SBATCH -p short",
            r#"exec "${TRIBOS:-$program}" sweep --plan '/a b/it'\''s 5%' \"#,
            r#"    --part "$SLURM_ARRAY_TASK_ID/3" --jobs "$cores""#,
        ] {
            assert!(text.lines().any(|found| found == line), "{line}\n{text}");
        }
        assert_eq!(JobArray::new(Some(30), 10, &[])?.tasks(), 10);
        assert_eq!(JobArray::new(None, 1000, &[])?.tasks(), MOST_TASKS);
        for bad in ["--array=0-9", "time=3", "--a\n--b"] {
            assert!(JobArray::new(None, 1, &[bad.into()]).is_err(), "{bad}");
        }
        Ok(())
    }
}
