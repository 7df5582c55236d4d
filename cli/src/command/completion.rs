//! Words that a shell can complete: scenes, their keys, patches, laws, exhibits.

use super::reproduce;
use clap::Command;
use clap_complete::CompletionCandidate;
use clap_complete::engine::{ArgValueCompleter, PathCompleter, ValueCompleter};
use std::ffi::{OsStr, OsString};
use std::path::Path;
use tribos::friction::{LAWS, Patch, find};
use tribos::onset::Bond;
use tribos::run::program;
use tribos::scene::{Domain, Key, LIBRARY, bodies, library_scene, vocabulary};

/// Environment variable with the shell that asks.
pub const VARIABLE: &str = "TRIBOS_COMPLETE";

/// Words for a value, given what of it is there.
type Words = fn(&OsStr) -> Vec<CompletionCandidate>;

/// Which argument of which command takes which words.
const COMPLETED: &[(&[&str], &str, Words)] = &[
    (&["run"], "scene", scenes),
    (&["run"], "overrides", settings),
    (&["explain"], "scene", scenes),
    (&["explain"], "overrides", settings),
    (&["sweep"], "scene", scenes),
    (&["sweep"], "sets", settings),
    (&["golden", "write"], "scenes", scenes),
    (&["golden", "write"], "overrides", settings),
    (&["export", "lammps"], "scene", scenes),
    (&["export", "lammps"], "overrides", settings),
    (&["scene", "show"], "name", library),
    (&["scene", "check"], "scenes", scenes),
    (&["scene", "check"], "overrides", settings),
    (&["scene", "new"], "from", library_and_bodies),
    (&["scene", "keys"], "of", library_and_bodies),
    (&["scene", "schema"], "body", all_bodies),
    (&["wrench"], "patch", patches),
    (&["modes"], "patch", patches),
    (&["surface"], "patch", patches),
    (&["coefficients"], "patch", patches),
    (&["onset"], "patch", patches),
    (&["onset"], "bond", bonds),
    (&["inverse"], "patch", patches),
    (&["wrench"], "law", local_laws),
    (&["laws"], "curve", local_laws),
    (&["laws"], "names", laws),
    (&["reproduce"], "arguments", exhibits),
];

/// The command line whose arguments know their words.
pub fn with_words(program: Command) -> Command {
    COMPLETED
        .iter()
        .fold(program, |program, (path, id, words)| {
            within(program, path, &|command| {
                command.mut_arg(id, |arg| arg.add(ArgValueCompleter::new(*words)))
            })
        })
}

/// Changes the subcommand at the end of the path.
fn within(command: Command, path: &[&str], change: &dyn Fn(Command) -> Command) -> Command {
    match path {
        [] => change(command),
        [name, rest @ ..] => command.mut_subcommand(name, |sub| within(sub, rest, change)),
    }
}

/// Candidates that begin with what is there.
fn candidates<T: AsRef<str>>(
    current: &OsStr,
    words: impl IntoIterator<Item = (T, &'static str)>,
) -> Vec<CompletionCandidate> {
    let begun = current.to_string_lossy();
    words
        .into_iter()
        .filter(|(word, _)| word.as_ref().starts_with(&*begun))
        .map(|(word, help)| CompletionCandidate::new(word.as_ref()).help(Some(help.into())))
        .collect()
}

fn library(current: &OsStr) -> Vec<CompletionCandidate> {
    let scenes = LIBRARY.iter().map(|scene| (scene.name, scene.summary()));
    candidates(current, scenes)
}

fn all_bodies(current: &OsStr) -> Vec<CompletionCandidate> {
    candidates(current, bodies().map(|body| (body, "a body")))
}

fn library_and_bodies(current: &OsStr) -> Vec<CompletionCandidate> {
    let (mut words, bodies) = (library(current), all_bodies(current));
    words.extend(bodies);
    words
}

/// Scenes that come with the program, then files.
fn scenes(current: &OsStr) -> Vec<CompletionCandidate> {
    let is_scene = |path: &Path| path.is_dir() || path.extension().is_some_and(|e| e == "toml");
    let files = PathCompleter::any().filter(is_scene).complete(current);
    let mut words = library(current);
    words.extend(files);
    words
}

fn exhibits(current: &OsStr) -> Vec<CompletionCandidate> {
    let names = reproduce::names();
    candidates(
        current,
        names.iter().map(|name| (name, "an exhibit of the thesis")),
    )
}

fn laws(current: &OsStr) -> Vec<CompletionCandidate> {
    candidates(current, LAWS.iter().map(|law| (law.name, law.summary)))
}

fn bonds(current: &OsStr) -> Vec<CompletionCandidate> {
    // What follows the sign is for the user to write.
    let begun = |syntax: &'static str| syntax.split_inclusive('=').next().unwrap_or(syntax);
    let all = Bond::SYNTAX.iter();
    candidates(
        current,
        all.map(|(syntax, meaning)| (begun(syntax), *meaning)),
    )
}

fn patches(current: &OsStr) -> Vec<CompletionCandidate> {
    if let Some(file) = current.to_string_lossy().strip_prefix("points:") {
        let files = PathCompleter::file().complete(&OsString::from(file));
        return files
            .into_iter()
            .map(|file| file.add_prefix("points:"))
            .collect();
    }
    // What follows the colon is for the user to write.
    let begun = |syntax: &'static str| syntax.split_inclusive(':').next().unwrap_or(syntax);
    let patches = Patch::SYNTAX.iter();
    candidates(
        current,
        patches.map(|(syntax, meaning)| (begun(syntax), *meaning)),
    )
}

/// NAME:KEY=VALUE,…
fn local_laws(current: &OsStr) -> Vec<CompletionCandidate> {
    let text = current.to_string_lossy();
    let Some((name, list)) = text.split_once(':') else {
        let local = LAWS.iter().filter(|law| law.local.is_some());
        return candidates(
            current,
            local.map(|law| (format!("{}:", law.name), law.summary)),
        );
    };
    let given = list.rsplit_once(',').map_or("", |(given, _)| given);
    let is_free = |key: &str| {
        !given
            .split(',')
            .any(|item| item.starts_with(&format!("{key}=")))
    };
    let head = match given {
        "" => format!("{name}:"),
        given => format!("{name}:{given},"),
    };
    let parameters = find(name).map_or(&[][..], |law| law.parameters);
    let free = parameters
        .iter()
        .filter(|parameter| is_free(parameter.name));
    candidates(
        current,
        free.map(|parameter| (format!("{head}{}=", parameter.name), parameter.meaning)),
    )
}

/// KEY=VALUE of the scene that the command line names, or of any body where it names none.
fn settings(current: &OsStr) -> Vec<CompletionCandidate> {
    let text = current.to_string_lossy();
    let keys = keys(program::line().into_iter());
    let Some((name, _)) = text.split_once('=') else {
        return candidates(
            current,
            keys.iter()
                .map(|key| (format!("{}=", key.name), key.meaning)),
        );
    };
    match keys
        .iter()
        .find(|key| key.name == name)
        .map(|key| key.domain)
    {
        Some(Domain::OneOf(words)) => candidates(
            current,
            words.iter().map(|word| (format!("{name}={word}"), "")),
        ),
        _ => Vec::new(),
    }
}

/// The vocabulary of the first word that is a scene.
fn keys(words: impl Iterator<Item = OsString>) -> Vec<Key> {
    let body = words.skip(1).find_map(|word| body_of(&word));
    let mut keys: Vec<Key> = Vec::new();
    for known in bodies().filter(|known| body.as_deref().is_none_or(|body| body == *known)) {
        for key in vocabulary(known).map_or(&[][..], |known| known.keys) {
            if !keys.iter().any(|other| other.name == key.name) {
                keys.push(*key);
            }
        }
    }
    keys
}

/// What a scene is about: one that comes with the program, or a file.
fn body_of(word: &OsStr) -> Option<String> {
    if let Some(scene) = word.to_str().and_then(library_scene) {
        return Some(scene.body().to_owned());
    }
    let is_file = Path::new(word)
        .extension()
        .is_some_and(|ending| ending == "toml");
    let text = is_file
        .then(|| std::fs::read_to_string(word).ok())
        .flatten()?;
    let body = text.lines().find_map(|line| {
        let (key, value) = line.split_once('=')?;
        (key.trim() == "body").then(|| value.split('"').nth(1).unwrap_or("disk").to_owned())
    });
    Some(body.unwrap_or_else(|| "disk".into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(words: Words, current: &str) -> Vec<String> {
        let found = words(OsStr::new(current));
        let texts = found
            .iter()
            .map(|word| word.get_value().to_string_lossy().into_owned());
        texts.collect()
    }

    #[test]
    fn words_are_those_that_the_program_takes() {
        assert_eq!(values(library, "compaction-sm"), ["compaction-small"]);
        assert_eq!(values(all_bodies, "cy"), ["cylinder"]);
        assert_eq!(values(patches, "pol"), ["polynomial:", "polygon:"]);
        assert_eq!(values(local_laws, "strib"), ["stribeck:"]);
        assert_eq!(values(local_laws, "dry:mu_s=1,"), ["dry:mu_s=1,mu_d="]);
        assert_eq!(values(laws, "stok"), ["stokes"]);
        for patch in values(patches, "") {
            if !patch.ends_with(':') {
                assert!(patch.parse::<Patch>().is_ok(), "{patch}");
            }
        }
    }

    #[test]
    fn keys_are_those_of_the_scene_on_the_line() {
        let named = |words: &[&str]| {
            let words = [&["tribos"], words].concat();
            let keys = keys(words.into_iter().map(OsString::from));
            keys.iter().map(|key| key.name).collect::<Vec<_>>()
        };
        let disk = named(&["run", "disk"]);
        assert!(disk.contains(&"integrator") && !disk.contains(&"mu_rolling"));
        assert!(named(&["run", "compaction-small"]).contains(&"mu_rolling"));
        let any = named(&["run"]);
        assert!(
            any.contains(&"integrator") && any.contains(&"mu_rolling") && any.contains(&"lambda")
        );
    }
}
