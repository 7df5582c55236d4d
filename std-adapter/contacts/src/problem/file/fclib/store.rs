//! Datasets of a file, checked before memory is taken for them.

use super::super::error::{Fault, FilePosition, LocatedFault};
use hdf5_pure::{DType, Dataset, File};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// A file in memory and the group of its problem.
pub(super) struct Store {
    file: File,
    /// Bytes of the file: no dataset without compression has more.
    bytes: usize,
    group: &'static str,
}

impl Store {
    /// Opens the file and the first of the groups that it has.
    pub fn open(bytes: &[u8], groups: &[&'static str]) -> Result<Self, LocatedFault> {
        let opened = guarded(|| {
            let file = File::from_bytes(bytes.to_vec())?;
            let names = file.root().groups()?;
            Ok((file, names))
        });
        let (file, names) = opened.map_err(|message| (FilePosition::File, Fault::Hdf5(message)))?;
        if let Some(length) = length(bytes).filter(|&length| length > bytes.len() as u64) {
            let message = format!("it has {} bytes of {length}", bytes.len());
            return Err((FilePosition::File, Fault::Hdf5(message)));
        }
        let found = groups
            .iter()
            .find(|group| names.iter().any(|name| name == *group));
        let Some(group) = found else {
            let wanted = "a problem of FCLib has a group fclib_local or fclib_global, with or without _rolling";
            return Err((FilePosition::File, Fault::Missing(wanted)));
        };
        Ok(Self {
            file,
            bytes: bytes.len(),
            group,
        })
    }

    pub fn group(&self) -> &'static str {
        self.group
    }

    fn path(&self, name: &str) -> String {
        format!("{}/{name}", self.group)
    }

    /// Where a dataset or a group is.
    pub fn place(&self, name: &str) -> FilePosition {
        FilePosition::Dataset(self.path(name))
    }

    fn refusal(&self, name: &str, message: String) -> LocatedFault {
        (self.place(name), Fault::Hdf5(message))
    }

    /// Whether the group has a part of this path; a part that cannot be read counts as one.
    pub fn has(&self, name: &str) -> Result<bool, LocatedFault> {
        let (folder, last) = match name.rsplit_once('/') {
            Some((folder, last)) => (self.path(folder), last),
            None => (self.group.to_string(), name),
        };
        let listed = guarded(|| {
            let group = self.file.group(&folder)?;
            let mut names = group.datasets()?;
            names.extend(group.groups()?);
            Ok(names)
        });
        let names = listed.map_err(|message| self.refusal(name, message))?;
        Ok(names.iter().any(|other| other == last))
    }

    /// Numbers of a dataset.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, LocatedFault> {
        let dataset = self.dataset(name, "floating-point numbers", |kind| {
            matches!(kind, DType::F32 | DType::F64)
        })?;
        let numbers = guarded(|| dataset.read_f64());
        numbers.map_err(|message| self.refusal(name, message))
    }

    /// Integers of a dataset.
    pub fn integers(&self, name: &str) -> Result<Vec<i64>, LocatedFault> {
        let dataset = self.dataset(name, "integers", |kind| {
            use DType::{I8, I16, I32, I64, U8, U16, U32};
            matches!(kind, I8 | I16 | I32 | I64 | U8 | U16 | U32)
        })?;
        let integers = guarded(|| dataset.read_i64());
        integers.map_err(|message| self.refusal(name, message))
    }

    /// The only integer of a dataset.
    pub fn integer(&self, name: &str) -> Result<i64, LocatedFault> {
        match self.integers(name)?.as_slice() {
            [integer] => Ok(*integer),
            many => Err(self.wrong_count(name, "the number of elements", many.len(), "1")),
        }
    }

    pub fn wrong_count(
        &self,
        name: &str,
        what: &str,
        found: impl TryInto<i128>,
        wanted: impl ToString,
    ) -> LocatedFault {
        let fault = Fault::Count {
            what: what.to_string(),
            found: found.try_into().unwrap_or(i128::MAX),
            wanted: wanted.to_string(),
        };
        (self.place(name), fault)
    }

    /// A dataset of a kind of elements, none larger than the file.
    fn dataset(
        &self,
        name: &str,
        wanted: &'static str,
        fits: impl Fn(&DType) -> bool,
    ) -> Result<Dataset, LocatedFault> {
        if !self.has(name)? {
            return Err((
                self.place(name),
                Fault::Missing("a problem needs this dataset"),
            ));
        }
        let opened = guarded(|| {
            let dataset = self.file.dataset(&self.path(name))?;
            let (kind, shape, size) = (dataset.dtype()?, dataset.shape()?, dataset.element_size()?);
            let filtered = !dataset.filters().is_empty();
            Ok((dataset, kind, shape, size, filtered))
        });
        let (dataset, kind, shape, size, filtered) =
            opened.map_err(|message| self.refusal(name, message))?;
        if !fits(&kind) {
            let message = format!("its elements are {kind:?}, not {wanted}");
            return Err(self.refusal(name, message));
        }
        if filtered {
            let advice = "compressed data are not read; h5repack -f NONE takes the compression off";
            return Err((self.place(name), Fault::Unsupported(advice)));
        }
        let bytes = shape.iter().try_fold(size, |all, &n| all.checked_mul(n));
        if bytes.is_none_or(|bytes| bytes > self.bytes as u64) {
            let most = format!("at most the {} of the file", self.bytes);
            let found = bytes.map_or(i128::MAX, i128::from);
            return Err(self.wrong_count(name, "the number of bytes", found, most));
        }
        Ok(dataset)
    }
}

/// Length of a whole file, as its superblock at the beginning has it: with addresses of eight bytes, versions 0 to 3.
fn length(bytes: &[u8]) -> Option<u64> {
    let (width, end) = match bytes.get(8)? {
        0 => (13, 40),
        1 => (13, 44),
        2 | 3 => (9, 28),
        _ => return None,
    };
    let address = bytes.get(end..end + 8)?.try_into().ok()?;
    (*bytes.get(width)? == 8).then(|| u64::from_le_bytes(address))
}

/// What the library answers, its errors in words. A panic of the library is an error as well: its files may be damaged.
fn guarded<T>(read: impl FnOnce() -> Result<T, hdf5_pure::Error>) -> Result<T, String> {
    match catch_unwind(AssertUnwindSafe(read)) {
        Ok(Ok(value)) => Ok(value),
        Ok(Err(error)) => Err(error.to_string()),
        Err(_) => Err("the file is damaged".to_string()),
    }
}
