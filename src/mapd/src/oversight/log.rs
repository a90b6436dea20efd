//! Logs: events with fields, as lines of text or of JSON, on stderr.

use crate::printable::printable;
use crate::serve::Notice;
use clap::{Args, ValueEnum};
use std::fmt;
use std::io;
use tracing::field::{Field, Visit};
use tracing::level_filters::LevelFilter;
use tracing::{Event, Level, Subscriber};
use tracing_subscriber::fmt::format::Writer;
use tracing_subscriber::fmt::{FmtContext, FormatEvent, FormatFields};
use tracing_subscriber::registry::LookupSpan;

/// How a daemon logs.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct LogArgs {
    /// Format of the daemon's log on stderr
    #[arg(long, value_enum, default_value_t = LogFormat::Text)]
    log: LogFormat,

    /// Lowest level to log
    #[arg(long, value_enum, default_value_t = LogLevel::Info)]
    log_level: LogLevel,
}

/// Form of a log.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogFormat {
    /// Lines for people
    #[default]
    Text,
    /// An object per line: timestamp, level, message, and the event's fields
    Json,
}

/// Severity of an event.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogLevel {
    /// Failures
    Error,
    /// Problems that may cause failures
    Warn,
    /// Normal events
    #[default]
    Info,
    /// Internal events
    Debug,
}

impl LogArgs {
    /// Whether every line of the log is an object.
    pub(crate) fn is_json(&self) -> bool {
        self.log == LogFormat::Json
    }

    /// Logs from now on, in all threads. The first call in a process counts.
    pub(crate) fn init(&self) {
        let level = match self.log_level {
            LogLevel::Error => LevelFilter::ERROR,
            LogLevel::Warn => LevelFilter::WARN,
            LogLevel::Info => LevelFilter::INFO,
            LogLevel::Debug => LevelFilter::DEBUG,
        };
        // A closed stderr is no reason to stop serving: errors of the log are not logged.
        let builder = tracing_subscriber::fmt()
            .with_max_level(level)
            .log_internal_errors(false)
            .with_writer(io::stderr);
        // Fails only if there is one already.
        let _ = match self.log {
            LogFormat::Text => {
                tracing::subscriber::set_global_default(builder.event_format(Plain).finish())
            }
            LogFormat::Json => tracing::subscriber::set_global_default(
                builder
                    .json()
                    .flatten_event(true)
                    .with_current_span(false)
                    .with_span_list(false)
                    .with_target(false)
                    .finish(),
            ),
        };
    }
}

/// Logs a message for the operator.
pub(crate) fn say(message: &str) {
    tracing::info!("{message}");
}

/// Target of lines that another process has written.
const RELAYED: &str = "relayed";

/// Relays a line of the compiler unchanged; in JSON it is the message of an event. What it says of itself is why it failed.
pub(crate) fn relay(line: &str) {
    if let Some(failure) = line.strip_prefix("mapd: ") {
        tracing::error!("{failure}");
    } else if line.contains(": error[") {
        tracing::error!(target: RELAYED, "{line}");
    } else if line.contains(": warning[") {
        tracing::warn!(target: RELAYED, "{line}");
    } else {
        tracing::info!(target: RELAYED, "{line}");
    }
}

/// Logs what the server has noticed.
pub(crate) fn notice(notice: &Notice) {
    match notice {
        Notice::LockHeld { lock } => tracing::warn!(lock = %lock.display(), "{notice}"),
        Notice::Removed { file } => tracing::info!(file = %file.display(), "{notice}"),
        Notice::Foreign { file } | Notice::WithoutSubscribers { file } => {
            tracing::warn!(file = %file.path.display(), owner = file.owner, "{notice}")
        }
        Notice::MoreForeign { count } => tracing::warn!(count, "{notice}"),
        Notice::CleanedUp { nodes } => tracing::info!(nodes, "{notice}"),
        Notice::CleanUpFailed { nodes } => tracing::warn!(nodes, "{notice}"),
        Notice::Unconnected { map, error } => tracing::warn!(%map, %error, "{notice}"),
        Notice::Failed { what, error } => tracing::warn!(%what, %error, "{notice}"),
    }
}

/// `mapd: ` and the message, with the level where it is a warning or worse; lines of another process as they are. Time and process are added by what keeps the
/// log, such as journald.
struct Plain;

impl<S, N> FormatEvent<S, N> for Plain
where
    S: Subscriber + for<'a> LookupSpan<'a>,
    N: for<'a> FormatFields<'a> + 'static,
{
    fn format_event(
        &self,
        _context: &FmtContext<'_, S, N>,
        mut writer: Writer<'_>,
        event: &Event<'_>,
    ) -> fmt::Result {
        let level = match *event.metadata().level() {
            Level::ERROR => "error: ",
            Level::WARN => "warning: ",
            _ => "",
        };
        if event.metadata().target() != RELAYED {
            write!(writer, "mapd: {level}")?;
        }
        event.record(&mut Message(&mut writer));
        writeln!(writer)
    }
}

/// Writes the message on one line and leaves out the fields, which it repeats in words.
struct Message<'a, 'b>(&'a mut Writer<'b>);

impl Visit for Message<'_, '_> {
    fn record_debug(&mut self, field: &Field, value: &dyn fmt::Debug) {
        if field.name() == "message" {
            // Fails if the log cannot be written; there is nowhere to report that.
            let _ = self.0.write_str(&printable(&format!("{value:?}")));
        }
    }
}
