//! Colours for people at a terminal; none where output is piped, where `NO_COLOR` is set, or where the terminal has none.

use anstream::{AutoStream, ColorChoice, stream::RawStream};
use anstyle::{AnsiColor, Style};
use mapd_xodr::Severity;
use std::fmt::{self, Display};

/// Whether what goes to a stream is coloured.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Colours {
    on: bool,
}

impl Colours {
    /// As the stream and the environment want it. What is piped stays plain also under `CLICOLOR_FORCE`: programs read it.
    pub(crate) fn of<S: RawStream>(stream: &S) -> Self {
        Self { on: stream.is_terminal() && AutoStream::choice(stream) != ColorChoice::Never }
    }

    /// A severity's word, or what else is as grave.
    pub(crate) fn severity<'a>(self, severity: Severity, word: &'a str) -> Painted<'a> {
        let colour = match severity {
            Severity::Error => AnsiColor::Red,
            Severity::Warning => AnsiColor::Yellow,
            Severity::Info => AnsiColor::Cyan,
        };
        let style = if self.on { colour.on_default().bold() } else { Style::new() };
        Painted { style, word }
    }
}

/// A word in a style.
pub(crate) struct Painted<'a> {
    style: Style,
    word: &'a str,
}

impl Display for Painted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { style, word } = self;
        write!(f, "{style}")?;
        f.pad(word)?;
        write!(f, "{style:#}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_those_who_want_colours_get_them() {
        let word = |on| Colours { on }.severity(Severity::Error, "error").to_string();
        assert_eq!(word(false), "error");
        assert_eq!(word(true), "\u{1b}[1m\u{1b}[31merror\u{1b}[0m");
        let padded = format!("{:<7}|", Colours { on: false }.severity(Severity::Info, "ok"));
        assert_eq!(padded, "ok     |");
    }
}
