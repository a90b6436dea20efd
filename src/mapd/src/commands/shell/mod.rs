//! `mapd completions` and `mapd man`: the command line as files for shells and for man.

mod completions;
mod man;

pub(crate) use completions::CompletionsCommand;
pub(crate) use man::ManCommand;
