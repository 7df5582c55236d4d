//! Contents of a linked image: bytes of flash, and modules of the kernel.

use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, SectionKind, elf};
use rustc_demangle::demangle;
use std::collections::BTreeSet;

/// Bytes that an image puts into flash.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flash {
    /// Code.
    pub code: u64,
    /// Constants and the start values of variables.
    pub data: u64,
}

impl Flash {
    /// Both.
    pub fn total(self) -> u64 {
        self.code + self.data
    }

    /// The size in excess of `baseline`.
    pub fn beyond(self, baseline: Self) -> Self {
        Self {
            code: self.code.saturating_sub(baseline.code),
            data: self.data.saturating_sub(baseline.data),
        }
    }
}

/// One image.
#[derive(Clone, Debug)]
pub struct Image {
    /// Its size.
    pub flash: Flash,
    /// Modules of the kernel with at least one function or static in it, inlined or not.
    pub modules: BTreeSet<String>,
}

impl Image {
    /// Reads an ELF file; `known` are all modules of the kernel.
    pub fn read(bytes: &[u8], known: &[String]) -> Result<Self, String> {
        let file = ElfFile32::<object::Endianness>::parse(bytes)
            .map_err(|error| format!("the image cannot be read: {error}"))?;
        let mut flash = Flash::default();
        let mut modules = BTreeSet::new();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags } = section.flags() else {
                continue;
            };
            if sh_flags & u64::from(elf::SHF_ALLOC) == 0 {
                continue;
            }
            match section.kind() {
                SectionKind::UninitializedData => {}
                SectionKind::Text => flash.code += section.size(),
                _ => flash.data += section.size(),
            }
        }
        for symbol in file.symbols() {
            modules.extend(named(symbol.name_bytes().unwrap_or_default(), known));
        }
        // Linkage names of all functions that survived, in other functions' bodies too.
        let strings = file.section_by_name(".debug_str");
        let strings = strings.ok_or("the image has no debug records")?;
        let strings = strings.data().map_err(|error| error.to_string())?;
        for name in strings.split(|&byte| byte == 0) {
            modules.extend(named(name, known));
        }
        Ok(Self { flash, modules })
    }
}

/// The modules in a mangled name.
fn named(name: &[u8], known: &[String]) -> Vec<String> {
    let Ok(name) = core::str::from_utf8(name) else {
        return Vec::new();
    };
    if !(name.starts_with("_ZN") || name.starts_with("_R")) {
        return Vec::new();
    }
    let name = demangle(name).to_string();
    let is_in = |module: &&String| name.contains(&format!("tribos_core::{module}::"));
    let mut found: Vec<String> = known.iter().filter(is_in).cloned().collect();
    // The deepest module only: its parents have a prefix of its name.
    let all = found.clone();
    found.retain(|module| {
        let inside = format!("{module}::");
        !all.iter().any(|other| other.starts_with(&inside))
    });
    found
}

/// All modules of the kernel, as the compiler lists them: `law::lugre` and so on.
pub fn modules_of_kernel() -> Result<Vec<String>, String> {
    let kernel = tribos_api::Library::read("tribos-core", &[])?;
    Ok(kernel.modules().iter().cloned().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mangled_names_tell_their_modules() {
        let known = ["law", "law::lugre", "coupling"].map(String::from);
        let inlined = b"_ZN11tribos_core3law5lugre14LuGre$LT$R$GT$4step17h0123456789abcdefE";
        assert_eq!(named(inlined, &known), ["law::lugre"]);
        assert!(named(b"_ZN4core5slice17h0123456789abcdefE", &known).is_empty());
        assert!(named(b"lugre", &known).is_empty());
    }
}
