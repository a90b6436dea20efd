//! `mapd query`: CSV in, CSV out.
//!
//! Columns are found by name. The input's columns are echoed first, except those that the answer itself has; then come
//! the answer's columns and `error`, which is empty where the row has an answer. Kinds that list things give a row for each of
//! them, none where there are none. Numbers are in shortest round-trip form.

mod besides;
pub(super) mod command;
pub(super) mod earth;
mod heeded;
mod holes;
pub(super) mod input;
pub(super) mod kinds;
mod landmarks;
mod localising;
mod matching;
mod objects;
pub(super) mod output;
mod path;
mod route;
pub(super) mod row;
mod signals;

pub(crate) use command::{HELP, QueryCommand};
pub use kinds::Kind;
use kinds::Tools;
use mapd_client::Map;
use mapd_client::localisation::VehicleOutline;
use mapd_query::NearestOptions;
use mapd_query::view::View;
pub use output::Format;
pub use route::{RouteArgs, RouteBy};
use row::Row;
use std::io::{Read, Write};
use std::time::UNIX_EPOCH;
use thiserror::Error;

/// Column of the parts in quarantine that are near.
const HOLES: &str = "quarantined";

/// Why a whole query cannot run; single rows fail in their `error` column instead.
#[derive(Debug, Error)]
pub enum QueryRunError {
    /// The input lacks columns.
    #[error("kind {kind} needs the columns {needed}, the input has {found}")]
    Columns {
        /// The kind of query.
        kind: &'static str,
        /// Columns that the kind needs.
        needed: String,
        /// Columns of the input.
        found: String,
    },
    /// Options that mean nothing.
    #[error("{0}")]
    Options(String),
    /// Reading or writing failed.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// Writing failed.
    #[error(transparent)]
    Io(#[from] std::io::Error),
}

/// How questions are answered and written.
#[derive(Clone, Copy)]
pub struct Asking<'a> {
    /// What messages call the OpenDRIVE file that the map was made from.
    pub document: &'a str,
    /// What counts as near.
    pub options: &'a NearestOptions,
    /// Plan view of the vehicles whose poses are matched.
    pub outline: Option<VehicleOutline>,
    /// How routes are searched.
    pub route: &'a RouteArgs,
    /// How answers are written.
    pub format: Format,
}

/// Answers every row of `input`.
///
/// Errors: missing columns; a lane to avoid that there is not; a quote that is not closed, a row beyond 1 MiB;
/// reading or writing fails.
pub fn run(
    map: Map<'_>,
    kind: Kind,
    asking: Asking<'_>,
    input: impl Read,
    output: impl Write,
) -> Result<(), QueryRunError> {
    run_under(View::of(map, None, UNIX_EPOCH), kind, asking, input, output)
}

/// As [`run`], heeding what is laid over the map where routes are asked for.
///
/// Errors: as [`run`].
pub fn run_under(
    view: View<'_>,
    kind: Kind,
    asking: Asking<'_>,
    input: impl Read,
    output: impl Write,
) -> Result<(), QueryRunError> {
    let Asking { document, options, outline, route, format } = asking;
    let map = view.map();
    let mut reader = input::reader(input);
    let mut writer = output::Output::new(format, output);
    let headers = reader.headers()?.clone();
    let has = |names: &&[&str]| names.iter().all(|name| headers.iter().any(|h| h == *name));
    if !kind.needs().iter().any(has) {
        return Err(QueryRunError::Columns {
            kind: kind.name(),
            needed: kind
                .needs()
                .iter()
                .map(|names| names.join(","))
                .collect::<Vec<_>>()
                .join(" or "),
            found: if headers.is_empty() {
                "none".to_owned()
            } else {
                headers.iter().collect::<Vec<_>>().join(",")
            },
        });
    }
    let router = route::Router::new(route, view).map_err(QueryRunError::Options)?;
    // Where the map has holes, answers about places say which concern them.
    let tells_holes = kind.concerns_places() && map.quarantined().len() > 0;
    let mut answers = kind.answers().to_vec();
    if tells_holes {
        answers.push(HOLES);
    }
    let echoed: Vec<usize> = (0..headers.len())
        .filter(|i| !answers.contains(&&headers[*i]) && &headers[*i] != "error")
        .collect();
    let head = echoed.iter().map(|i| &headers[*i]).chain(answers.iter().copied()).chain(["error"]);
    writer.head(head)?;
    let mut record = csv::StringRecord::new();
    let mut answer = Vec::new();
    let mut tools = Tools {
        router,
        paths: path::Paths::default(),
        earth: earth::Earth::new(map),
        holes: holes::Holes::new(map, document),
        outline,
    };
    while reader.read_record(&mut record)? {
        answer.clear();
        let row = Row::new(&headers, &record);
        let mut error = kind.answer(map, options, &mut tools, &row, &mut answer).err();
        if error.is_some() {
            answer.clear();
        }
        let lacks = match tells_holes {
            true => tools.holes.of(kind, options, &row, &tools),
            false => String::new(),
        };
        if kind.lists() && answer.is_empty() && error.is_none() && !lacks.is_empty() {
            error = Some("nothing found, but something is left out of the map there".to_owned());
        }
        // Kinds that list things answer with as many rows as there are, none where there is nothing.
        if error.is_some() || !kind.lists() {
            answer.resize(kind.answers().len(), String::new());
        }
        let error = error.unwrap_or_default();
        for one in answer.chunks(kind.answers().len()) {
            let echo = echoed.iter().map(|i| record.get(*i).unwrap_or(""));
            let last = tells_holes.then_some(lacks.as_str()).into_iter().chain([error.as_str()]);
            writer.row(echo.chain(one.iter().map(String::as_str)).chain(last))?;
        }
    }
    writer.finish()?;
    Ok(())
}
