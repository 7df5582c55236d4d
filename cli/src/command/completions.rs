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
const BASH: &str = r#"_tribos() {
    local IFS=$'\013' words=() word glue= last
    for word in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
        last=$((${#words[@]} - 1))
        if [[ $last -gt 0 && ( -n $glue || $word == [=:]* ) ]]; then
            words[last]+=$word
        else
            words+=("$word")
        fi
        glue=
        [[ $word == *[=:] ]] && glue=1
    done
    last=$((${#words[@]} - 1))
    COMPREPLY=( $(
        _CLAP_IFS="$IFS" _CLAP_COMPLETE_INDEX="$last" VARIABLE=bash \
            "${COMP_WORDS[0]}" -- "${words[@]}" 2>/dev/null
    ) )
    local head=${words[last]}
    if [[ $head == *[=:]* ]]; then
        word=${head##*[=:]}
        head=${head%"$word"}
        COMPREPLY=( "${COMPREPLY[@]#"$head"}" )
    fi
    if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *[=:/] ]]; then
        compopt -o nospace 2>/dev/null
    fi
    return 0
}
complete -o bashdefault -F _tribos tribos
"#;

impl Arguments {
    /// Prints.
    pub fn execute(self) -> Result<(), Failure> {
        if self.shell == Shell::Bash {
            return super::print(&BASH.replace("VARIABLE", VARIABLE));
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
