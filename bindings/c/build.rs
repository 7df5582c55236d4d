//! Writes the single-precision interface: the double-precision one with other names of types.

use std::path::Path;
use std::{env, fs};

include!("modules.rs");

fn main() -> std::io::Result<()> {
    let source = Path::new("src/double");
    println!("cargo::rerun-if-changed={}", source.display());
    let mut single = String::new();
    for module in MODULES {
        let double = fs::read_to_string(source.join(module).with_extension("rs"))?;
        let text = double.replace("f64", "f32").replace("Table64", "Table32");
        single += &format!("pub mod {module} {{\n{text}}}\n");
    }
    let out = env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(Path::new(&out).join("single.rs"), single)
}
