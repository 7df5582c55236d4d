//! Options for logs as machines write them, and the first look at one.

use crate::failure::Failure;
use std::path::Path;
use tribos::record::{ColumnChoices, LogOptions, LogRole, UnitChoices, look};

/// How a table is to be read.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct TableArguments {
    /// Columns by name or by number from 1, such as f=Force,v="v [mm/s]" or f=-3; a minus changes the sign, `none`
    /// leaves one out.
    #[arg(long, value_name = "NAME=COLUMN,…")]
    columns: Option<ColumnChoices>,
    /// Units of columns, before those in the file, such as v=mm/s,f=mN.
    #[arg(long, value_name = "NAME=UNIT,…")]
    units: Option<UnitChoices>,
    /// Leave out so many lines at the beginning of the file.
    #[arg(long, value_name = "N", default_value = "0", hide_default_value = true)]
    skip: u64,
}

/// How a log is to be read, or looked at.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct LogArguments {
    #[command(flatten)]
    table: TableArguments,
    /// Show what is understood of the file, its columns, their ranges and the first rows, and fit nothing.
    #[arg(long)]
    pub look: bool,
}

/// Form of what is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Lines for people.
    #[default]
    Text,
    /// A JSON object.
    Json,
}

impl TableArguments {
    /// Whether nothing is said of a table.
    pub fn is_silent(&self) -> bool {
        self.options() == LogOptions::default()
    }

    /// The options for the reader.
    pub fn options(&self) -> LogOptions {
        LogOptions {
            columns: self.columns.clone().unwrap_or_default(),
            units: self.units.clone().unwrap_or_default(),
            skip: self.skip,
        }
    }
}

impl LogArguments {
    /// The options for the reader.
    pub fn options(&self) -> LogOptions {
        self.table.options()
    }

    /// Prints the first look at a file.
    pub fn show(&self, file: &Path, roles: &[LogRole], format: Format) -> Result<(), Failure> {
        let seen = look(file, roles, &self.options())?;
        crate::command::print(&match format {
            Format::Text => seen.text(),
            Format::Json => format!("{:#}\n", seen.json()),
        })
    }
}
