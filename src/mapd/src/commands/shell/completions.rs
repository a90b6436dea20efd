//! `mapd completions`.

use crate::exit::Exit;
use anyhow::Result;
use clap::{Args, Command};
use clap_complete::Shell;
use std::io::Write;

/// Which shell completes.
#[derive(Args)]
pub(crate) struct CompletionsCommand {
    /// Shell that the script is for
    shell: Shell,
}

impl CompletionsCommand {
    /// Writes the script.
    ///
    /// Errors: writing fails.
    pub(crate) fn run(self, program: Command, out: &mut dyn Write) -> Result<Exit> {
        let name = program.get_name().to_owned();
        let mut shown = shown(program);
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut shown, name, &mut script);
        out.write_all(&script)?;
        if self.shell == Shell::Fish {
            words_of_fish(&shown, out)?;
        }
        Ok(Exit::Done)
    }
}

/// The program without commands that are hidden: the scripts would offer them.
fn shown(program: Command) -> Command {
    let commands = program.get_subcommands().filter(|command| !command.is_hide_set());
    Command::new(program.get_name().to_owned())
        .version(program.get_version().unwrap_or_default().to_owned())
        .disable_help_subcommand(true)
        .args(program.get_arguments().cloned())
        .subcommands(commands.cloned().collect::<Vec<_>>())
}

/// What the script for fish lacks: words that arguments without an option's name can be, such as kinds of queries.
fn words_of_fish(program: &Command, out: &mut dyn Write) -> Result<()> {
    let program_name = program.get_name();
    for command in program.get_subcommands() {
        for argument in command.get_positionals() {
            let words = argument.get_possible_values();
            let words: Vec<&str> = words.iter().map(|word| word.get_name()).collect();
            if !words.is_empty() {
                let (name, words) = (command.get_name(), words.join(" "));
                writeln!(
                    out,
                    "complete -c {program_name} -n \"__fish_{program_name}_using_subcommand {name}\" -a \"{words}\""
                )?;
            }
        }
    }
    Ok(())
}
