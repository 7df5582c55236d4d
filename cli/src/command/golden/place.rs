//! Paths of scenes as seen from the folder of a golden file.

use std::path::Path;

/// The folder that a file is in.
pub fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// `file` relative to `folder`, with `/` between its parts; both must exist. As it was given where
/// there is no such path, as between drives.
pub fn relative(file: &Path, folder: &Path) -> String {
    let as_given = || file.display().to_string();
    match (file.canonicalize(), folder.canonicalize()) {
        (Ok(file), Ok(folder)) => between(&folder, &file).unwrap_or_else(as_given),
        _ => as_given(),
    }
}

/// Up from `from` to the folder that both share, and down to `to`.
fn between(from: &Path, to: &Path) -> Option<String> {
    let (from, to): (Vec<_>, Vec<_>) = (from.components().collect(), to.components().collect());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return None;
    }
    let down = to[shared..].iter().map(|part| part.as_os_str().to_str());
    let path: Option<Vec<&str>> = from[shared..]
        .iter()
        .map(|_| Some(".."))
        .chain(down)
        .collect();
    path.map(|parts| parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_leads_up_and_down() {
        let between = |from, to| between(Path::new(from), Path::new(to));
        assert_eq!(between("/a/b", "/a/b/c.toml").as_deref(), Some("c.toml"));
        assert_eq!(
            between("/a/b", "/a/d/c.toml").as_deref(),
            Some("../d/c.toml")
        );
        assert_eq!(between("a", "/a/c.toml"), None);
        assert_eq!(folder_of(Path::new("golden.toml")), Path::new("."));
    }
}
