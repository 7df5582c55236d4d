//! `tribos completions`: what a shell needs to complete commands and options.

use crate::failure::Failure;
use clap_complete::{Shell, generate};

/// Print the completions of a shell: commands, options and their values.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// The shell.
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  bash, in this shell, and in all later ones:
    source <(tribos completions bash)
    tribos completions bash > ~/.local/share/bash-completion/completions/tribos
  zsh, in a folder of $fpath:
    tribos completions zsh > ~/.zfunc/_tribos
  fish:
    tribos completions fish > ~/.config/fish/completions/tribos.fish
  PowerShell, in the profile:
    tribos completions powershell | Out-String | Invoke-Expression
  elvish, in rc.elv:
    eval (tribos completions elvish | slurp)";

impl Arguments {
    /// Prints.
    pub fn execute(self) -> Result<(), Failure> {
        let mut text = Vec::new();
        generate(self.shell, &mut super::program(), "tribos", &mut text);
        super::print(&String::from_utf8_lossy(&text))
    }
}
