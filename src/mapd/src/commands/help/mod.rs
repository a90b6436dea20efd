//! `mapd help`: the help of a command, or a topic that concerns several.

mod examples;
mod first;

use crate::exit::{Exit, UsageError};
use crate::similar::did_you_mean;
use anyhow::Result;
use clap::builder::PossibleValuesParser;
use clap::{Args, Command};
use std::io::Write;

pub(crate) use examples::HEADING as EXAMPLES;

/// Name of the command.
pub(crate) const HELP: &str = "help";

/// Topics and their texts.
const TOPICS: [(&str, &str); 5] = [
    ("sources", include_str!("topics/sources.txt")),
    ("units", include_str!("topics/units.txt")),
    ("exit-codes", include_str!("topics/exit-codes.txt")),
    ("environment", include_str!("topics/environment.txt")),
    ("files", include_str!("topics/files.txt")),
];

/// What to explain.
#[derive(Args)]
pub(crate) struct HelpCommand {
    /// Command or topic; without one, the program
    #[arg(index = 1)]
    about: Option<String>,
    /// Command of that command
    #[arg(index = 2)]
    of: Vec<String>,
}

impl HelpCommand {
    /// Prints the topic or the command's long help.
    ///
    /// Errors: there is no such command; writing fails.
    pub(crate) fn run(self, mut program: Command, out: &mut dyn Write) -> Result<Exit> {
        let topic = |name: &String| TOPICS.iter().find(|(topic, _)| topic == name);
        if let Some((_, text)) = self.about.as_ref().and_then(topic) {
            out.write_all(text.as_bytes())?;
            return Ok(Exit::Done);
        }
        program.build();
        let mut command = &mut program;
        for name in self.about.iter().chain(&self.of) {
            let within = command.get_name().to_owned();
            let meant = did_you_mean(name, command.get_subcommands().map(Command::get_name));
            let Some(found) = command.find_subcommand_mut(name) else {
                return Err(UsageError(format!("{within} has no command {name}{meant}")).into());
            };
            command = found;
        }
        command.print_long_help()?;
        Ok(Exit::Done)
    }
}

/// Whether what ended the parsing is the program's short help, in place of which the first page is shown.
pub(crate) fn is_first_page(error: &clap::Error, mut program: Command) -> bool {
    let is_help = error.kind() == clap::error::ErrorKind::DisplayHelp;
    is_help && error.render().ansi().to_string() == program.render_help().ansi().to_string()
}

/// The program with the first page as its help, at most so many columns wide.
pub(crate) fn with_first_page(program: Command, most: usize) -> Command {
    let page = first::page(&program, most);
    program.override_help(page)
}

/// Completes the help: the words that `mapd help` takes, which shells complete and of which the nearest is suggested for another; and examples of each command.
pub(crate) fn completed(program: Command) -> Command {
    examples::with_examples(with_words(program))
}

fn with_words(program: Command) -> Command {
    let commands = program.get_subcommands().filter(|command| !command.is_hide_set());
    let commands = commands.map(|command| command.get_name().to_owned());
    let words: Vec<String> =
        commands.chain(TOPICS.iter().map(|(topic, _)| (*topic).to_owned())).collect();
    let topics: Vec<&str> = TOPICS.iter().map(|(topic, _)| *topic).collect();
    let listed = format!("Topics: {}", topics.join(", "));
    program.mut_subcommand(HELP, |help| {
        help.after_help(listed).mut_arg("about", |about| {
            about.value_parser(PossibleValuesParser::new(words)).hide_possible_values(true)
        })
    })
}
