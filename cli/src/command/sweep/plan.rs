//! What a sweep is to run, in one file: a scene edited later cannot mix two sweeps.

use super::body::Body;
use super::grid::{Grid, Swept};
use super::jobs::Task;
use crate::command::scene::note_earlier_names;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tribos::record::{read_text, write_atomically};

/// Bytes of a plan at most.
const MOST_BYTES: u64 = 64 << 20;

/// Name of the file in a sweep's folder.
pub const FILE: &str = "sweep.json";

/// A scene's text, the keys that vary and the runs for each combination.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    scene_name: String,
    scene: String,
    /// The keys.
    pub grid: Grid,
    /// Runs for each combination.
    pub seeds: u32,
}

impl Plan {
    /// The scene in a file, as it is now.
    pub fn new(file: &Path, grid: Grid, seeds: u32) -> Result<Self, Failure> {
        if seeds > 1 && grid.keys.iter().any(|swept| swept.key == "seed") {
            let message = "--seeds: `seed` is among the keys already; give one or the other";
            return Err(Failure::input(message));
        }
        Ok(Self {
            scene_name: file.display().to_string(),
            scene: crate::command::scene::text(file)?,
            grid,
            seeds,
        })
    }

    /// Where the plan of a folder is.
    pub fn place(out: &Path) -> PathBuf {
        out.join(FILE)
    }

    /// The plan in a folder.
    pub fn read(out: &Path) -> Result<Self, Failure> {
        let file = Self::place(out);
        let name = file.display();
        let text = read_text(&file, MOST_BYTES).map_err(|error| {
            Failure::input(format!(
                "no plan of a sweep: {name}: {error}; make one with `tribos sweep SCENE --set … --out DIR`"
            ))
        })?;
        let value: Value = serde_json::from_str(&text)
            .map_err(|error| Failure::input(format!("{name}: not a plan of a sweep: {error}")))?;
        let version = &value["version"];
        let ours = env!("CARGO_PKG_VERSION");
        if version != ours {
            return Err(Failure::input(format!(
                "{name}: planned by tribos {version}, and this is \"{ours}\"; use the same version for all parts"
            )));
        }
        Self::of(&value).ok_or_else(|| {
            Failure::input(format!(
                "{name}: not a plan of a sweep; make a new one with `tribos sweep SCENE --set … --out DIR`"
            ))
        })
    }

    /// Whether another plan takes the same runs, wherever its scene lay.
    pub fn takes_the_runs_of(&self, other: &Self) -> bool {
        self.scene == other.scene && self.grid == other.grid && self.seeds == other.seeds
    }

    /// Writes the plan into a folder.
    pub fn write(&self, out: &Path) -> Result<(), Failure> {
        let text = format!("{:#}\n", self.json());
        Ok(write_atomically(&Self::place(out), text.as_bytes())?)
    }

    /// The plan as it stands in its file.
    pub fn json(&self) -> Value {
        let key = |swept: &Swept| json!({"key": swept.key, "values": swept.values});
        let keys: Vec<Value> = self.grid.keys.iter().map(key).collect();
        json!({
            "version": env!("CARGO_PKG_VERSION"),
            "scene_name": self.scene_name,
            "scene": self.scene,
            "keys": keys,
            "seeds": self.seeds,
        })
    }

    fn of(value: &Value) -> Option<Self> {
        let text = |value: &Value| value.as_str().map(str::to_owned);
        let swept = |key: &Value| {
            let values = key["values"].as_array()?.iter().map(text);
            Some(Swept {
                key: text(&key["key"])?,
                values: values.collect::<Option<_>>()?,
            })
        };
        let keys = value["keys"].as_array()?.iter().map(swept);
        Some(Self {
            scene_name: text(&value["scene_name"])?,
            scene: text(&value["scene"])?,
            grid: Grid {
                keys: keys.collect::<Option<_>>()?,
            },
            seeds: value["seeds"].as_u64()?.try_into().ok()?,
        })
    }

    /// All runs, seeds changing first; every scene is read before any of them starts.
    ///
    /// A combination that is refused has its place among them. A value that no combination
    /// takes is bad input.
    pub fn tasks(&self, out: &Path) -> Result<Vec<Task>, Failure> {
        let all: Vec<Vec<String>> = (0..self.grid.len())
            .map(|combination| self.grid.overrides(combination))
            .collect();
        let bodies: Vec<Result<Body, Failure>> =
            all.iter().map(|overrides| self.body(overrides)).collect();
        self.check(&bodies)?;
        if let Some(body) = bodies.iter().find_map(|body| body.as_ref().ok()) {
            let overrides = self.grid.overrides(0);
            note_earlier_names(&self.scene_name, body.keys(), &self.scene, &overrides);
        }
        let mut tasks: Vec<Task> = Vec::new();
        for (overrides, body) in all.iter().zip(bodies) {
            let body = body.map_err(|failure| failure.to_string());
            if self.seeds == 1 {
                tasks.push(Task::new(overrides, body, out));
                continue;
            }
            for run in 0..u64::from(self.seeds) {
                let mut all = overrides.clone();
                let body = match &body {
                    Ok(first) => {
                        let seed = first.seed().unwrap_or(0).saturating_add(run);
                        all.push(format!("seed={seed}"));
                        self.body(&all).map_err(|failure| failure.to_string())
                    }
                    Err(reason) => {
                        all.push(format!("run={run}"));
                        Err(reason.clone())
                    }
                };
                tasks.push(Task::new(&all, body, out));
            }
        }
        Ok(tasks)
    }

    /// Refuses a value that every combination with it refuses, bodies of two kinds, and seeds of
    /// bodies without chance.
    fn check(&self, bodies: &[Result<Body, Failure>]) -> Result<(), Failure> {
        for (at, swept) in self.grid.keys.iter().enumerate() {
            for value in 0..swept.values.len() {
                let with = || {
                    let numbered = bodies.iter().enumerate();
                    numbered.filter(move |(n, _)| self.grid.indices(*n)[at] == value)
                };
                if with().all(|(_, body)| body.is_err())
                    && let Some((_, Err(failure))) = with().next()
                {
                    return Err(failure.clone());
                }
            }
        }
        let mut accepted = bodies.iter().filter_map(|body| body.as_ref().ok());
        let Some(first) = accepted.next() else {
            // Without keys there is one combination.
            let refused = bodies.iter().find_map(|body| body.as_ref().err());
            return refused.map_or(Ok(()), |failure| Err(failure.clone()));
        };
        if accepted.any(|body| !body.kind().has_columns_of(&first.kind())) {
            let message = "--set body=…: the results of one table must be of one kind of body";
            return Err(Failure::input(message));
        }
        if self.seeds > 1 && first.seed().is_none() {
            let message = match first.starts_from() {
                true => {
                    "--seeds: what starts from `initial_state` has no seed; give several states as its values"
                }
                false => {
                    "--seeds: this body has no seed, every run of it is the same; leave --seeds out"
                }
            };
            return Err(Failure::input(message));
        }
        Ok(())
    }

    fn body(&self, overrides: &[String]) -> Result<Body, Failure> {
        Body::parse(&self.scene_name, &self.scene, overrides)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_reads_back_as_it_was() -> Result<(), Failure> {
        let plan = Plan {
            scene_name: "a \"b\".toml".into(),
            scene: "speed = 1 # ünï\n\tspin = '''2'''".into(),
            grid: Grid::parse(&["a=1,2".into(), "b=x y".into()])?,
            seeds: 3,
        };
        assert_eq!(Plan::of(&plan.json()), Some(plan.clone()));
        let mut broken = plan.json();
        broken["keys"][1]["values"][0] = 3.into();
        assert_eq!(Plan::of(&broken), None);
        Ok(())
    }
}
