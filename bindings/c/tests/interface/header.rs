//! The committed header matches the library.

use std::path::PathBuf;
use std::{env, fs};

use cbindgen::{Builder, Config, DocumentationStyle, EnumConfig, Language, RenameRule, Style};

include!("../../modules.rs");

/// Path of the committed header.
fn header() -> PathBuf {
    at("include/tribos.h")
}

fn at(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The header generated from the current source.
fn generated() -> String {
    let config = Config {
        language: Language::C,
        style: Style::Both,
        cpp_compat: true,
        header: Some(include_str!("preface.h").trim_end().to_owned()),
        include_guard: Some("TRIBOS_H".to_owned()),
        no_includes: true,
        sys_includes: vec!["stddef.h".to_owned(), "stdint.h".to_owned()],
        after_includes: Some(format!(
            "\n#define TRIBOS_VERSION \"{}\"",
            env!("CARGO_PKG_VERSION")
        )),
        usize_is_size_t: true,
        documentation_style: DocumentationStyle::C99,
        line_length: 100,
        enumeration: EnumConfig {
            rename_variants: RenameRule::QualifiedScreamingSnakeCase,
            ..EnumConfig::default()
        },
        export: cbindgen::ExportConfig {
            include: ["tribos_attraction", "tribos_pressure"]
                .map(str::to_owned)
                .to_vec(),
            ..cbindgen::ExportConfig::default()
        },
        ..Config::default()
    };
    let mut builder = Builder::new().with_config(config);
    for common in ["choice", "status", "table"] {
        builder = builder.with_src(at(&format!("src/{common}.rs")));
    }
    for double in MODULES {
        builder = builder.with_src(at(&format!("src/double/{double}.rs")));
    }
    let single = concat!(env!("OUT_DIR"), "/single.rs");
    let bindings = builder.with_src(single).generate().expect("valid source");
    let mut text = Vec::new();
    bindings.write(&mut text);
    String::from_utf8(text).expect("plain text")
}

#[test]
fn the_committed_header_is_that_of_the_source() {
    let generated = generated();
    if env::var_os("TRIBOS_WRITE_HEADER").is_some() {
        fs::write(header(), &generated).expect("a writable header");
    }
    let committed = fs::read_to_string(header()).unwrap_or_default();
    assert!(
        committed == generated,
        "bindings/c/include/tribos.h is out of date: run\n    \
         TRIBOS_WRITE_HEADER=1 cargo test -p tribos-c --test interface header"
    );
}
