//! `tribos reproduce`
use crate::failure::Failure;
use std::path::PathBuf;
/// Reproduce.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// Folder.
    #[arg(long)]
    out: PathBuf,
}
impl Arguments {
    /// Do.
    pub fn execute(self) -> Result<(), Failure> {
        let _ = self.out;
        Ok(())
    }
}
