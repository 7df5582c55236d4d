//! Folders on the command line.

use clap::Command;
use clap::builder::ValueParser;
use std::path::{Path, PathBuf};

/// What the value of an argument that takes a folder is called.
const FOLDER: &str = "DIR";

/// A folder, or what can become one.
fn folder(text: &str) -> Result<PathBuf, String> {
    let path = Path::new(text);
    match path.metadata() {
        Ok(there) if !there.is_dir() => {
            Err("that is a file; name a folder, which is made if it is missing".into())
        }
        _ => Ok(path.to_path_buf()),
    }
}

/// The command line that refuses a file where an `--out` takes a folder.
pub fn with_folders(program: Command) -> Command {
    let names: Vec<String> = program
        .get_subcommands()
        .filter(|sub| takes_a_folder(sub))
        .map(|sub| sub.get_name().to_owned())
        .collect();
    names.into_iter().fold(program, |program, name| {
        program.mut_subcommand(name, |sub| {
            sub.mut_arg("out", |arg| arg.value_parser(ValueParser::new(folder)))
        })
    })
}

fn takes_a_folder(command: &Command) -> bool {
    let mut arguments = command.get_arguments();
    arguments.any(|arg| {
        let name = arg.get_value_names().and_then(<[_]>::first);
        arg.get_id() == "out" && name.is_some_and(|name| name.as_str() == FOLDER)
    })
}
