//! `tribos completions`: what a shell needs to complete commands, options, scenes, keys and laws.

use super::completion::VARIABLE;
use crate::failure::Failure;
use clap::ValueEnum as _;
use clap_complete::Shell;
use clap_complete::env::Shells;

/// Print the completions of a shell: commands, options and their values, scenes, keys, patches,
/// laws and exhibits.
///
/// The script asks the program itself, so it stays right when the program is replaced.
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

/// bash breaks words at = and : too, so the words are put together again, and of each answer only
/// what comes after the last break is handed back.
const BASH: &str = include_str!("../../assets/completion/tribos.bash");
/// zsh gets no blank after an answer that goes on: a key, a law with parameters, a folder.
const ZSH: &str = include_str!("../../assets/completion/tribos.zsh");

impl Arguments {
    /// Prints.
    pub fn execute(self) -> Result<(), Failure> {
        let own = match self.shell {
            Shell::Bash => Some(BASH),
            Shell::Zsh => Some(ZSH),
            _ => None,
        };
        if let Some(script) = own {
            return super::print(&script.replace("VARIABLE", VARIABLE));
        }
        let name = self.shell.to_possible_value();
        let name = name.as_ref().map_or("", |value| value.get_name());
        let mut text = Vec::new();
        let shells = Shells::builtins();
        let Some(shell) = shells.completer(name) else {
            return Err(Failure::input(format!("no completions for {name}")));
        };
        shell
            .write_registration(VARIABLE, "tribos", "tribos", "tribos", &mut text)
            .map_err(Failure::run)?;
        super::print(&String::from_utf8_lossy(&text))
    }
}
