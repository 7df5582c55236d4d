//! Reads a scene by its table and judges it: everything that is wrong is found at once.

use super::entries::{Entries, Written};
use super::hint::nearest;
use super::key::{Key, Need};
use super::problem::{Origin, SceneProblem};
use super::table::Table;

/// Unknown keys that are named one by one; a file with more is something else than a scene.
const MOST_UNKNOWN: usize = 20;

/// What is wrong with a scene so far.
#[derive(Debug)]
pub struct SceneDiagnostics<'a> {
    /// The file; none for a scene that was made in a program.
    file: Option<&'a Entries>,
    problems: Vec<SceneProblem>,
    /// Keys whose values cannot be relied on.
    doubtful: Vec<&'static str>,
}

impl<'a> SceneDiagnostics<'a> {
    /// Notes a problem of these keys at the first of them that is given, unless one of them is wrong
    /// already: then it is no news.
    pub fn refuse(&mut self, keys: &[&'static str], message: impl Into<String>) {
        if keys.iter().any(|key| self.doubtful.contains(key)) {
            return;
        }
        let mut places = keys.iter().filter_map(|key| self.place(key));
        let origin = places.next().unwrap_or(Origin::File);
        self.problems.push(SceneProblem::new(origin, message));
        self.doubtful.extend(keys.first());
    }

    /// Where the file gives a key.
    fn place(&self, key: &str) -> Option<Origin> {
        let (_, origin) = self.file?.values.get(key)?;
        Some(*origin)
    }

    /// Whether the file gives a key.
    pub fn is_given(&self, key: &str) -> bool {
        self.place(key).is_some()
    }

    /// Complains about every key that is not in the table.
    fn strangers(&mut self, keys: &[Key], entries: &Entries) {
        let is_known = |name: &str| keys.iter().any(|key| key.name == name);
        let mut strangers = entries.values.iter().filter(|(name, _)| !is_known(name));
        for (name, (_, origin)) in strangers.by_ref().take(MOST_UNKNOWN) {
            self.problems
                .push(SceneProblem::new(*origin, unknown(keys, name)));
        }
        let more = strangers.count();
        if more > 0 {
            let message = format!("and {more} more keys that are unknown");
            self.problems.push(SceneProblem::new(Origin::File, message));
        }
    }

    /// The rules of the table about keys that depend on others.
    fn conditions<T: Table>(&mut self, scene: &mut T) {
        for (key, field) in T::rows() {
            let name = key.name;
            let is_given = match self.file {
                Some(file) => file.values.contains_key(name),
                // A field that may be left out is given where it is not; others always have a value.
                None => {
                    (field.written)(&T::default()).is_none() && (field.written)(scene).is_some()
                }
            };
            match key.need {
                Need::Required if !is_given && self.file.is_some() => {
                    self.refuse(&[name], key.missing());
                }
                Need::Required | Need::Optional => {}
                Need::UnlessGiven(other) => match [name, other].map(|key| self.place(key)) {
                    [Some(Origin::Line(_)), Some(Origin::Override)] => {}
                    [Some(_), Some(_)] => {
                        self.refuse(
                            &[other, name],
                            format!("give `{name}` or `{other}`, not both"),
                        );
                    }
                    [None, None] if self.file.is_some() => {
                        self.refuse(&[name], format!("{}; or give `{other}`", key.missing()));
                    }
                    _ => {}
                },
                Need::UnlessEither(one, two) => self.one_of_three([name, one, two], key),
                Need::UnitWith(other, word) => {
                    let is_unit = scene.says(other, word);
                    if !is_unit && !is_given && self.file.is_some() {
                        self.refuse(&[name, other], key.missing());
                    } else if is_unit && !is_given && self.file.is_some() {
                        (field.set)(scene, &Written::Number(1.0));
                    } else if is_unit && (field.written)(scene) != Some(Written::Number(1.0)) {
                        let message = format!("`{name}` is 1 in a {word} scene; leave it out");
                        self.refuse(&[name, other], message);
                    }
                }
                Need::PartOf(other, word) | Need::OnlyWith(other, word) => {
                    if is_given && !scene.says(other, word) {
                        let message = format!(
                            "`{name}` is for {other} \"{word}\" only; leave it out, or set {other} = \"{word}\""
                        );
                        self.refuse(&[name, other], message);
                    }
                }
                Need::Without(other) => {
                    if is_given && self.is_given(other) {
                        let message = format!("`{name}` is not used with `{other}`; leave it out");
                        self.refuse(&[name, other], message);
                    }
                }
                Need::NotWith(other, word) => {
                    if is_given && scene.says(other, word) {
                        let message =
                            format!("`{name}` is not used with {other} = \"{word}\"; leave it out");
                        self.refuse(&[name, other], message);
                    }
                }
            }
        }
    }

    /// A file gives exactly one of three keys, of which an override replaces the first.
    fn one_of_three(&mut self, [name, one, two]: [&'static str; 3], key: &Key) {
        let [own, first, second] = [name, one, two].map(|key| self.place(key));
        match (own, first.or(second)) {
            (Some(Origin::Line(_)), Some(Origin::Override)) => {}
            (Some(_), Some(_)) => {
                let other = if first.is_some() { one } else { two };
                let message = format!("give `{name}` or `{other}`, not both");
                self.refuse(&[other, name], message);
            }
            (None, None) if self.file.is_some() => {
                let message = format!("{}; or give `{one}` or `{two}`", key.missing());
                self.refuse(&[name], message);
            }
            _ => {}
        }
    }

    /// All problems in the order of the file.
    fn finish(mut self) -> Vec<SceneProblem> {
        self.problems.sort_by_key(|problem| match problem.origin {
            Origin::Line(line) => (0, line),
            Origin::Override => (1, 0),
            Origin::File => (2, 0),
        });
        self.problems
    }
}

/// The scene of a file's entries, or everything that is wrong with them.
pub fn read<T: Table>(
    entries: &Entries,
    problems: Vec<SceneProblem>,
) -> Result<T, Vec<SceneProblem>> {
    let mut problems = problems;
    let entries = &in_place::<T>(&with_present_names(entries, T::TABLE, &mut problems));
    let mut judge = SceneDiagnostics {
        file: Some(entries),
        problems,
        doubtful: Vec::new(),
    };
    judge.strangers(T::TABLE, entries);
    if let Some((body, _)) = entries.values.get("body")
        && *body != Written::Text(T::BODY.into())
    {
        let message = format!("only the body \"{}\" is read here", T::BODY);
        judge.refuse(&["body"], message);
    }
    let mut scene = T::default();
    for (key, field) in T::rows() {
        if let Some((value, _)) = entries.values.get(key.name) {
            match key.objection(value) {
                None => (field.set)(&mut scene, value),
                Some(message) => judge.refuse(&[key.name], message),
            }
        }
    }
    judge.conditions(&mut scene);
    scene.rules(&mut judge);
    let problems = judge.finish();
    if problems.is_empty() {
        Ok(scene)
    } else {
        Err(problems)
    }
}

/// The entries by the present names of their keys: an override replaces the value of a file under either name.
fn with_present_names(
    entries: &Entries,
    keys: &[Key],
    problems: &mut Vec<SceneProblem>,
) -> Entries {
    let mut named = entries.clone();
    for key in keys {
        let name = key.name;
        let Some((was, given)) = key.was.and_then(|was| named.values.remove_entry(was)) else {
            continue;
        };
        match (given.1, named.values.get(name).map(|(_, origin)| *origin)) {
            (Origin::Line(_), Some(Origin::Override)) => {}
            (_, None) | (Origin::Override, Some(Origin::Line(_))) => {
                named.values.insert(name.into(), given);
            }
            (origin, Some(_)) => {
                let message = format!("give `{name}` alone; `{was}` is its earlier name");
                problems.push(SceneProblem::new(origin, message));
            }
        }
    }
    named
}

/// Earlier names of keys that a file or its overrides use, each with the present one.
pub fn earlier_names(keys: &[Key], text: &str, overrides: &[String]) -> Vec<[&'static str; 2]> {
    let entries = Entries::parse(text, overrides).map(|(entries, _)| entries.values);
    let given = entries.unwrap_or_default();
    let renamed = keys.iter().filter_map(|key| Some([key.was?, key.name]));
    renamed
        .filter(|[was, _]| given.contains_key(*was))
        .collect()
}

/// The entries without the keys of a file that an override of the key they depend on has put out of use.
fn in_place<T: Table>(entries: &Entries) -> Entries {
    let mut kept = entries.clone();
    let defaults = T::default();
    // A key that falls takes those with it that depend on it.
    let mut moved: Vec<&str> = Vec::new();
    for _ in T::rows() {
        let is_out_of_use = |(key, _): &(&Key, _)| {
            let is_line = matches!(kept.values.get(key.name), Some((_, Origin::Line(_))));
            let (other, word, wanted) = match key.need {
                Need::PartOf(other, word) | Need::OnlyWith(other, word) => (other, word, true),
                Need::NotWith(other, word) => (other, word, false),
                Need::Without(other) => {
                    let place = kept.values.get(other).map(|(_, origin)| *origin);
                    return is_line && place == Some(Origin::Override);
                }
                _ => return false,
            };
            let (is_moved, says) = match kept.values.get(other) {
                Some((value, origin)) => (
                    *origin == Origin::Override,
                    *value == Written::Text(word.into()),
                ),
                None => (moved.contains(&other), defaults.says(other, word)),
            };
            is_line && is_moved && says != wanted
        };
        let Some((key, _)) = T::rows().find(is_out_of_use) else {
            break;
        };
        kept.values.remove(key.name);
        moved.push(key.name);
    }
    kept
}

/// Everything that is wrong with the fields of a scene.
pub fn check<T: Table>(scene: &T) -> Vec<SceneProblem> {
    let mut judge = SceneDiagnostics {
        file: None,
        problems: Vec::new(),
        doubtful: Vec::new(),
    };
    for (key, field) in T::rows() {
        let objection = (field.written)(scene).and_then(|value| key.objection(&value));
        if let Some(message) = objection {
            judge.refuse(&[key.name], message);
        }
    }
    judge.conditions(&mut scene.clone());
    scene.rules(&mut judge);
    judge.finish()
}

/// The complaint about an unknown key, with the nearest known one or all of them.
fn unknown(keys: &[Key], name: &str) -> String {
    match nearest(name, keys.iter().map(|key| key.name)) {
        Some(key) => format!("unknown key `{name}`; did you mean `{key}`?"),
        None => {
            let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
            format!("unknown key `{name}`; the keys are {}", names.join(", "))
        }
    }
}
