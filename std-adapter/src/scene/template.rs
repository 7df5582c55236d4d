//! Commented scene files with every key of their body.

use super::Scene;
use super::key::{Domain, Key, Need};
use super::vocabulary::{Vocabulary, bodies, given, resolved, vocabulary};
use crate::results::{Quantity, entries};
use serde_json::Value;

/// A scene of a body with all of its keys: those that must be given have plausible values, the
/// others stand as comments with their defaults.
///
/// ```
/// use tribos::scene::{template, vocabulary, Scene};
/// let pipe = vocabulary("pipe").ok_or("no pipe")?;
/// let text = template(&pipe);
/// assert!(pipe.keys.iter().all(|key| text.contains(key.name)));
/// assert!(text.contains("# alpha = 0.0")); // Coulomb, unless it is changed
/// assert_eq!(Scene::parse("pipe.toml", &text, &[])?.body(), "pipe");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn template(known: &Vocabulary) -> String {
    let mut text = format!(
        "# A scene with body = \"{}\": values are examples, lines that begin with # are defaults.\n\n",
        known.body
    );
    for (name, value) in known.least() {
        let comment = known.keys.iter().find(|key| key.name == name).map(comment);
        text += &line(&format!("{name} = {value}"), &comment.unwrap_or_default());
    }
    with_all_keys(&text)
}

/// The file, followed by the keys that it leaves out, as comments with the values in force.
///
/// ```
/// use tribos::scene::{with_all_keys, Scene};
/// let text = "body = \"curling\"\nspeed = 2.0\nspin = 1.5";
/// let all = with_all_keys(text);
/// assert!(all.starts_with(text) && all.contains("# mass = 20.0")); // kg
/// let [before, after] = [text, &all].map(|text| Scene::parse("rock.toml", text, &[]));
/// assert_eq!(before?.json(), after?.json());
/// # Ok::<(), tribos::scene::SceneError>(())
/// ```
pub fn with_all_keys(text: &str) -> String {
    let body = Scene::parse("scene", text, &[]).map_or("", |scene| scene.body());
    let Some(known) = vocabulary(body) else {
        return text.to_owned();
    };
    let (given, values) = (given(known.keys, text), resolved(text));
    let mut all = format!(
        "{}\n\n# What else may be set, with what holds now:\n",
        text.trim_end()
    );
    for key in known.keys {
        if key.name != "body" && !given.iter().any(|name| name == key.name) {
            let value = values
                .get(key.name)
                .and_then(|value| toml_value(key, value));
            let setting = format!("# {} = {}", key.name, value.unwrap_or_default());
            all += &line(setting.trim_end(), &comment(key));
        }
    }
    all
}

/// A value of a scene's JSON as TOML; nothing for null.
///
/// ```
/// use tribos::scene::{Domain, DiskScene, toml_value};
/// let key = |name| DiskScene::KEYS.iter().find(|key| key.name == name).ok_or("no key");
/// let [speed, counted] = [key("speed")?, key("samples")?];
/// assert!(matches!(counted.domain, Domain::Count { .. }));
/// assert_eq!(toml_value(speed, &2.into()), Some("2.0".into())); // TOML tells 2.0 from 2
/// assert_eq!(toml_value(counted, &200.into()), Some("200".into()));
/// assert_eq!(toml_value(speed, &serde_json::Value::Null), None);
/// # Ok::<(), &str>(())
/// ```
pub fn toml_value(key: &Key, value: &Value) -> Option<String> {
    match (value, key.domain) {
        (Value::String(word), _) => Some(format!("\"{word}\"")),
        (Value::Number(number), Domain::Count { .. }) => number.as_f64().map(|x| format!("{x}")),
        (Value::Number(number), _) => number.as_f64().map(|x| format!("{x:?}")),
        _ => None,
    }
}

/// The keys of all bodies as a page of tables in Markdown: `docs/keys.md`.
///
/// ```
/// let page = tribos::scene::keys_page();
/// assert!(page.contains("## body = \"powder\"") && page.contains("| `pressure` | F_coh/R^2 |"));
/// ```
pub fn keys_page() -> String {
    let all: Vec<(&'static str, Vec<String>)> = bodies()
        .filter_map(vocabulary)
        .map(|known| (known.body, key_rows(&known)))
        .collect();
    let bodies_with = |row: &String| -> Vec<&'static str> {
        let have_it = all.iter().filter(|(_, rows)| rows.contains(row));
        have_it.map(|(body, _)| *body).collect()
    };
    let (mut shared, mut parts) = (String::new(), String::new());
    for (body, rows) in &all {
        let (own, common): (Vec<&String>, Vec<&String>) =
            rows.iter().partition(|row| bodies_with(row).len() == 1);
        parts += &format!("\n## body = \"{body}\"\n\n");
        let name = |row: &&String| row.split(' ').nth(1).unwrap_or_default().to_owned();
        let names: Vec<String> = common.iter().map(name).collect();
        if !names.is_empty() {
            let names = names.join(", ");
            parts += &format!("From [several bodies](#keys-of-several-bodies): {names}.\n\n");
        }
        parts += "| key | unit | meaning | value | default |\n|---|---|---|---|---|\n";
        own.iter().for_each(|row| parts += &format!("{row}\n"));
        for row in common {
            let bodies = bodies_with(row);
            if bodies.first() == Some(body) {
                shared += &format!("{row} {} |\n", bodies.join(", "));
            }
        }
    }
    format!(
        "# Scenes and keys\n\nWhat a scene of each body may say; [Runs](runs.md) has how to write, check and vary one.\n\n\
         ```console\n$ tribos scene new disk --out my-disk.toml\n$ tribos scene check my-disk.toml --set spin=50\n…\n```\n\n\
         Made from the tables that the reader uses; `tribos scene keys BODY` prints them. All numbers are finite. Keys that a file must \
         give come first; another one without a default is off, or chosen, where it is left out. *Was* names a key of earlier versions, \
         which is still read.\n\n## Keys of several bodies\n\n| key | unit | meaning | value | default | bodies |\n\
         |---|---|---|---|---|---|\n{shared}{parts}"
    )
}

/// Rows of the keys of a body, those that a file must give first.
fn key_rows(known: &Vocabulary) -> Vec<String> {
    let defaults = known.defaults();
    let keys = known.keys.iter().filter(|key| key.name != "body");
    let row = |key: &Key| key_row(key, defaults.get(key.name));
    let mut rows: Vec<String> = keys.map(row).collect();
    rows.sort_by_key(|row| !row.contains(" | required"));
    rows
}

fn key_row(key: &Key, default: Option<&Value>) -> String {
    let default = default.and_then(|value| toml_value(key, value));
    let last = match (key.need, default) {
        (_, Some(default)) => format!("`{default}`"),
        (Need::Required, None) => "required".into(),
        (Need::UnlessGiven(other), None) => format!("required, or `{other}`"),
        (Need::UnlessEither(one, two), None) => format!("required, or `{one}`, or `{two}`"),
        (Need::UnitWith(other, word), None) => format!("required; 1 with {other} = \"{word}\""),
        _ => String::new(),
    };
    let was = key
        .was
        .map_or(String::new(), |was| format!(" *Was* `{was}`."));
    let cells = [
        format!("`{}`", key.name),
        key.unit.into(),
        format!("{}{was}", key.meaning),
        in_symbols(key.domain),
        last,
    ];
    let cells = cells.map(|cell| cell.replace('|', "\\|"));
    format!("| {} |", cells.join(" | "))
}

/// What a value may be, shorter than in messages.
fn in_symbols(domain: Domain) -> String {
    const SHORTER: [(&str, &str); 7] = [
        ("a finite number >", ">"),
        ("a number >", ">"),
        (" and <", ", <"),
        ("a finite number", "a number"),
        ("a number from 0 to 1", "0 to 1"),
        ("a whole number from", "whole,"),
        ("one of \"", "\""),
    ];
    let shorter = |text: String, (long, short): &(&str, &str)| text.replace(long, short);
    SHORTER.iter().fold(domain.describe(), shorter)
}

/// The entries of the summaries of all bodies as a page of tables in Markdown: `docs/results.md`.
///
/// ```
/// let page = tribos::scene::results_page();
/// assert!(page.contains("## body = \"disk\"") && page.contains("| `distance` | m |"));
/// ```
pub fn results_page() -> String {
    let mut page = String::from(
        "# Results\n\nWhat the `summary.json` of every run has, made from the tables that it is written by; `tribos scene results BODY` \
         prints them.\n\n```console\n$ tribos scene results disk\n…\n```\n\nUnits are those of the scene where it has units of its own. A sweep averages what has a column, and of grains every column of the series, as a mean over time. What \
         a run does not have is null or \"nan\", or left out where its meaning says so. Every summary ends \
         with `scene`, the keys in force, and `version`.\n",
    );
    let all: Vec<Vocabulary> = bodies().filter_map(vocabulary).collect();
    for (at, known) in all.iter().enumerate() {
        let has_same = |other: &&Vocabulary| other.results == known.results;
        if all[..at].iter().any(|before| has_same(&before)) {
            continue;
        }
        let names = all
            .iter()
            .filter(has_same)
            .map(|same| format!("\"{}\"", same.body));
        let names: Vec<String> = names.collect();
        page += &format!("\n## body = {}\n\n", names.join(", "));
        page += "| entry | unit | meaning | column of a sweep |\n|---|---|---|---|\n";
        for (path, entry) in entries(known.results) {
            page += &entry_row(&path.join("."), entry);
        }
    }
    page
}

fn entry_row(name: &str, entry: &Quantity) -> String {
    let column = entry
        .column()
        .map_or(String::new(), |name| format!("`{name}`"));
    let cells = [
        format!("`{name}`"),
        entry.unit.into(),
        entry.meaning.into(),
        column,
    ];
    let cells = cells.map(|cell| cell.replace('|', "\\|"));
    format!("| {} |\n", cells.join(" | "))
}

/// A setting with its comment in one column.
fn line(setting: &str, comment: &str) -> String {
    format!("{setting:<32} # {comment}\n")
}

/// Unit, meaning, domain.
fn comment(key: &Key) -> String {
    let unit = match key.unit {
        "-" => String::new(),
        unit => format!("[{unit}] "),
    };
    format!("{unit}{} {}", key.meaning, key.domain.describe())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{LIBRARY, LibraryScene};

    /// Every commented setting that has a value, as a setting.
    fn uncommented(text: &str) -> String {
        let lines = text.lines().map(|line| match line.strip_prefix("# ") {
            Some(rest) if rest.split('#').next().is_some_and(is_setting) => rest,
            _ => line,
        });
        lines.collect::<Vec<_>>().join("\n")
    }

    fn is_setting(text: &str) -> bool {
        let (key, value) = text.split_once(" = ").unwrap_or_default();
        !key.contains(' ') && !value.trim().is_empty()
    }

    #[test]
    fn a_file_with_all_keys_says_what_it_said_before() {
        let templates = bodies().map(|body| template(&vocabulary(body).unwrap()));
        let files = LIBRARY.iter().map(|scene| scene.text.to_owned());
        for text in templates.chain(files) {
            let all = with_all_keys(&text);
            assert_eq!(resolved(&text), resolved(&all));
            assert!(!resolved(&all).is_empty());
            let body = Scene::parse("all", &all, &[]).unwrap().body();
            for key in vocabulary(body)
                .unwrap()
                .keys
                .iter()
                .filter(|key| key.name != "body")
            {
                let names_it = |line: &str| {
                    let rest = line.trim_start_matches("# ").strip_prefix(key.name);
                    rest.is_some_and(|rest| rest.trim_start().starts_with('='))
                };
                assert!(all.lines().any(names_it), "{body}: {}", key.name);
            }
        }
    }

    #[test]
    fn defaults_in_comments_are_values_that_hold() {
        // Some keys of these bodies may not be given beside others.
        let is_free = |scene: &&LibraryScene| !["powder", "grains"].contains(&scene.body());
        for scene in LIBRARY.iter().filter(is_free) {
            let all = uncommented(&with_all_keys(scene.text));
            assert_eq!(resolved(scene.text), resolved(&all), "{all}");
        }
    }

    /// The local laws of the catalogue, a row each.
    fn laws_table() -> String {
        let mut table =
            String::from("| law | friction per unit load | parameters |\n|---|---|---|\n");
        for law in crate::friction::LAWS
            .iter()
            .filter(|law| law.local.is_some())
        {
            let parameters = law.parameters.iter().map(|p| {
                let unit = Some(p.unit).filter(|unit| *unit != "-");
                let unit = unit.map_or(String::new(), |unit| format!(" [{unit}]"));
                let default = p
                    .default
                    .map_or(String::new(), |value| format!(" (default {value:?})"));
                format!("`{}`{unit}: {}{default}", p.name, p.meaning)
            });
            let parameters = parameters.collect::<Vec<_>>().join("; ");
            let cells = [
                format!("`{}`: {}", law.name, law.summary),
                format!("`{}`", law.formula),
                parameters,
            ];
            let cells = cells.map(|cell| cell.replace('|', "\\|"));
            table += &format!("| {} |\n", cells.join(" | "));
        }
        table
    }

    /// What a page says between this line and the next empty one.
    fn made_part<'a>(page: &'a str, mark: &str) -> Option<&'a str> {
        let (_, rest) = page.split_once(mark)?;
        rest.split_inclusive("\n\n").next()?.strip_suffix('\n')
    }

    #[test]
    fn what_pages_list_is_what_the_tables_say() {
        const LAWS: &str = "<!-- Made from the catalogue of laws. -->\n";
        let read = |name: &str| {
            let path = format!("{}/../docs/{name}.md", env!("CARGO_MANIFEST_DIR"));
            let page = std::fs::read_to_string(&path).unwrap_or_default();
            (path, page)
        };
        let laws = read("laws").1;
        let part = made_part(&laws, LAWS).expect("a table of laws");
        let laws = laws.replace(part, &laws_table());
        for (name, made) in [
            ("keys", keys_page()),
            ("results", results_page()),
            ("laws", laws),
        ] {
            let (path, page) = read(name);
            if page != made && std::env::var_os("TRIBOS_WRITE_PAGES").is_some() {
                std::fs::write(&path, &made).unwrap();
                continue;
            }
            assert!(
                page == made,
                "run this test with TRIBOS_WRITE_PAGES=1 to write {path}"
            );
        }
    }
}
