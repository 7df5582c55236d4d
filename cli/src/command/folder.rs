//! Files and folders on the command line.

use clap::builder::{OsStringValueParser, TypedValueParser, ValueParser};
use clap::{Arg, Command};
use std::any::TypeId;
use std::ffi::OsString;
use std::path::PathBuf;

/// What the value of an argument that takes a folder is called.
const FOLDER: &str = "DIR";
/// An argument that has a parser of its own, which knows its endings.
const FILM: &str = "film";

/// A file or a folder: it has a name.
fn path(name: OsString) -> Result<PathBuf, String> {
    if name.is_empty() {
        return Err("the name is empty; a variable of the shell may be unset".into());
    }
    Ok(name.into())
}

/// A folder, or what can become one.
fn folder(name: OsString) -> Result<PathBuf, String> {
    let given = path(name)?;
    match given.metadata() {
        Ok(there) if !there.is_dir() => {
            Err("that is a file; name a folder, which is created if missing".into())
        }
        Err(_) if given.is_symlink() => Err(
            "that is a symbolic link to what is not there; make the folder that it leads to, or \
             name another one"
                .into(),
        ),
        _ => Ok(given),
    }
}

/// The command line that refuses an empty name of a file or a folder, and a file where an `--out`
/// takes a folder.
pub fn with_paths(program: Command) -> Command {
    program.mut_args(with_path).mut_subcommands(with_paths)
}

fn with_path(arg: Arg) -> Arg {
    if arg.get_value_parser().type_id() != TypeId::of::<PathBuf>() || arg.get_id() == FILM {
        return arg;
    }
    let parser = OsStringValueParser::new();
    if takes_a_folder(&arg) {
        arg.value_parser(ValueParser::new(parser.try_map(folder)))
    } else {
        arg.value_parser(ValueParser::new(parser.try_map(path)))
    }
}

fn takes_a_folder(arg: &Arg) -> bool {
    let name = arg.get_value_names().and_then(<[_]>::first);
    arg.get_id() == "out" && name.is_some_and(|name| name.as_str() == FOLDER)
}
