//! `tribos push`: a body that a pusher moves over the floor.

mod picture;
mod report;

use super::{file, spool};
use crate::command::suggestions::unknown;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::push::{PUSH_BOX, PushResult};
use tribos::record::{number as shortest, read_text, series_csv};
use tribos::scene::{MOST_BYTES, Need, PushScene};

/// A body that a pusher moves over the floor, slowly enough that nothing has inertia: whether the pusher
/// sticks or slides, the motion cone, the body's path.
///
/// Friction on the floor is the exact limit surface of the patch. With a second contact (`end_x`, `end_y`)
/// the pusher is a line, and the answer says whether it holds the body: a stable push.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub struct Arguments {
    /// Scene file, or push-box, which comes with the program.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Replace or add a key of the scene, or leave one out (`KEY=`); may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Output format of the answer.
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// Write the path to this file: columns time, x, y, angle, contact, twist, push, slip.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw outline, pusher and path: FILE.svg, FILE.png or FILE.csv.
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Text,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  A box pushed by a finger off its middle, its path as a table and a picture:
    tribos push push-box --output box.csv --picture box.svg
  The same with a finger that sticks at once:
    tribos push push-box --set mu_pusher=0.8
  A straight pusher of 16 cm under the box that also turns: does it hold the box?
    tribos push push-box --set contact_x=-0.08 --set end_x=0.08 --set end_y=-0.1 --set spin=0.02
  The answer for a program:
    tribos push push-box --format json";

/// The scene that comes with the program.
const BUILT_IN: (&str, &str) = ("push-box", PUSH_BOX);

/// Examples, and the keys of a scene.
fn help() -> String {
    let mut text = format!("{EXAMPLES}\n\nKeys of a scene (places in the frame of the body):\n");
    let defaults = PushScene::default().json();
    for key in PushScene::KEYS.iter().filter(|key| key.name != "body") {
        let default = defaults.get(key.name);
        let default = default.filter(|_| matches!(key.need, Need::Optional));
        text += &super::scene::key_line(key, default);
    }
    text
}

impl Arguments {
    /// Computes, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let scene = self.read()?;
        for (name, output) in [("--output", &self.output), ("--picture", &self.picture)] {
            for (output, input) in output
                .iter()
                .zip([self.scene.as_path()].into_iter().chain(scene.patch.file()))
            {
                file::refuse_input(name, output, input)?;
            }
        }
        let answer = scene.run()?;
        if let Some(path) = &self.output {
            write(path, &answer)?;
            super::note(format_args!("written to    {}", path.display()));
        }
        if let Some(path) = &self.picture {
            picture::draw(path, &scene, &answer)?;
            super::note(format_args!("written to    {}", path.display()));
        }
        match self.format {
            Format::Json => super::print(&format!("{:#}\n", answer.json(&scene))),
            Format::Text => super::print(&report::text(&scene, &answer)),
        }
    }

    /// The scene in the file, or that of the program where there is no such file.
    fn read(&self) -> Result<PushScene, Failure> {
        let name = self.scene.display().to_string();
        let text = if name == BUILT_IN.0 && (!self.scene.exists() || self.scene.is_dir()) {
            BUILT_IN.1.to_owned()
        } else {
            read_text(&self.scene, MOST_BYTES).map_err(|error| {
                Failure::input(if error.is_missing() {
                    unknown(
                        &format!("no file and no scene `{name}`"),
                        &name,
                        [BUILT_IN.0],
                    )
                } else {
                    format!("cannot read the scene {name}: {error}")
                })
            })?
        };
        let scene = PushScene::parse(&name, &text, &self.overrides).map_err(Failure::input)?;
        super::scene::note_earlier_names(&name, PushScene::KEYS, &text, &self.overrides);
        Ok(scene)
    }
}

/// The path as a table.
fn write(path: &Path, answer: &PushResult) -> Result<(), Failure> {
    spool::deliver(Some(path), |sink| {
        sink.put(&series_csv(&PushResult::COLUMNS, []))?;
        for row in answer.rows() {
            let cells: Vec<String> = row.iter().map(|&x| shortest(x)).collect();
            sink.put(&(cells.join(",") + "\n"))?;
        }
        Ok(())
    })
}
