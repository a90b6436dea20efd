//! `mapd match`: the lanes of a recorded trace, CSV in, CSV out.

use super::query::QueryRunError;
use super::query::command::usage_of;
use super::query::earth::Earth;
use super::query::input::reader as rows_of;
use super::query::kinds::{number, point_in};
use super::query::output::{FormatArgs, Output};
use super::query::row::Row;
use crate::args::{Opening, lane_types, not_negative, vehicle};
use crate::exit::Exit;
use crate::source::Source;
use clap::Args;
use csv::StringRecord;
use mapd_client::localisation::{TraceFix, TraceMatch, TraceOptions, TracePosition, TraceScratch};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{LaneTypes, Map};
use std::io::{self, Read, Write};

/// Said at the end of `mapd help match`.
pub(crate) const HELP: &str = "\
In: time [s] and x,y[,z] or lat,lon[,alt], in the order of time; hdg if known. Out: lane,s,offset (from the lane's centre, positive to \
the left of the reference line) and the probability of the lane given the whole trace; lane is empty if the trace is on no lane.";

/// Columns of the answer.
const COLUMNS: [&str; 4] = ["lane", "s", "offset", "probability"];
/// Columns that the input must have: those of one of these.
const NEEDS: [[&str; 3]; 2] = [["time", "x", "y"], ["time", "lat", "lon"]];

/// Whose lanes, and how.
#[derive(Args)]
pub(crate) struct TraceCommand {
    /// .xodr, .mapd or shm:NAME
    source: Source,
    #[command(flatten)]
    trace: TraceArgs,
    #[command(flatten)]
    format: FormatArgs,
    #[command(flatten)]
    opening: Opening,
}

impl TraceCommand {
    /// Matches the trace on stdin.
    ///
    /// Errors: the source cannot be opened; wrong usage; reading or writing fails.
    pub(crate) fn run(self, out: &mut dyn Write) -> anyhow::Result<Exit> {
        let options = self.trace.options(lane_types(&self.trace.types)?);
        let Some(snapshot) = self.opening.open(&self.source)? else { return Ok(Exit::Rejected) };
        let out = Output::new(self.format.get(), out);
        answer(snapshot.map(), &options, io::stdin().lock(), out).map_err(usage_of)?;
        Ok(Exit::Done)
    }
}

/// How a trace is matched.
#[derive(Args, Clone, Debug)]
struct TraceArgs {
    /// Standard deviation of x and y [m]
    #[arg(long, value_name = "M", default_value_t = TraceOptions::default().deviation, value_parser = not_negative)]
    deviation: f64,
    /// Standard deviation of hdg [rad], for rows that have it
    #[arg(long, value_name = "RAD", default_value_t = TraceOptions::default().heading_deviation, value_parser = not_negative)]
    heading_deviation: f64,
    /// Mean time between lane changes [s]
    #[arg(long, value_name = "S", default_value_t = TraceOptions::default().change_interval, value_parser = not_negative)]
    change_interval: f64,
    /// Kind of vehicle, in the words of access/restriction
    #[arg(long, value_name = "CLASS", default_value = VehicleClass::PassengerCar.name(), value_parser = vehicle)]
    vehicle: VehicleClass,
    /// Lane types to consider, separated by commas, `drivable` or `routable`
    #[arg(long, value_name = "TYPES", value_delimiter = ',', default_value = "routable")]
    types: Vec<String>,
}

impl TraceArgs {
    /// As options, with these lane types.
    fn options(&self, types: LaneTypes) -> TraceOptions {
        TraceOptions {
            deviation: self.deviation,
            heading_deviation: self.heading_deviation,
            vehicle: self.vehicle,
            change_interval: self.change_interval,
            types,
        }
    }
}

/// Answers a whole trace: a row for each of its rows. Rows that are no fix say why and are no part of the trace.
///
/// Errors: missing columns; options out of their domain; reading or writing fails.
fn answer(
    map: Map<'_>,
    options: &TraceOptions,
    input: impl Read,
    output: Output<impl Write>,
) -> Result<(), QueryRunError> {
    let mut reader = rows_of(input);
    let headers = reader.headers()?.clone();
    let has = |names: &[&str; 3]| names.iter().all(|name| headers.iter().any(|h| h == *name));
    if !NEEDS.iter().any(has) {
        return Err(QueryRunError::Columns {
            kind: "match",
            needed: NEEDS.map(|names| names.join(",")).join(" or "),
            found: headers.iter().collect::<Vec<_>>().join(","),
        });
    }
    let earth = Earth::new(map);
    let (mut rows, mut fixes) = (Vec::new(), Vec::<TraceFix>::new());
    for record in reader.records() {
        let record = record?;
        let last = fixes.last().map_or(f64::NEG_INFINITY, |fix| fix.time);
        let fix = fix(&Row::new(&headers, &record), &earth, last);
        rows.push((record, fix.as_ref().err().cloned()));
        fixes.extend(fix.ok());
    }
    let mut matches = Vec::new();
    map.match_trace(&fixes, options, &mut TraceScratch::default(), &mut matches)
        .map_err(|error| QueryRunError::Options(error.to_string()))?;
    write(map, &headers, &rows, &matches, output)
}

/// The fix of a row, not before the last one.
fn fix(row: &Row<'_>, earth: &Earth, last: f64) -> Result<TraceFix, String> {
    let time = row.number("time")?;
    if time < last {
        return Err(format!("time must not decrease, found {time:?} after {last:?}"));
    }
    Ok(TraceFix { time, position: point_in(row, earth)?, heading: row.optional("hdg")? })
}

fn write(
    map: Map<'_>,
    headers: &StringRecord,
    rows: &[(StringRecord, Option<String>)],
    matches: &[TraceMatch],
    mut output: Output<impl Write>,
) -> Result<(), QueryRunError> {
    let is_own = |name: &str| COLUMNS.contains(&name) || name == "error";
    let echoed: Vec<usize> = (0..headers.len()).filter(|i| !is_own(&headers[*i])).collect();
    let head = echoed.iter().map(|i| &headers[*i]).chain(COLUMNS).chain(["error"]);
    output.head(head)?;
    let mut matches = matches.iter();
    for (record, error) in rows {
        let found = if error.is_none() { matches.next() } else { None };
        let mut answer = [const { String::new() }; COLUMNS.len()];
        if let Some(found) = found {
            answer[3] = number(found.probability);
            if let Some(TracePosition { lane: id, position }) = found.place {
                answer[0] =
                    map.lane(id).map_or_else(|_| String::new(), |lane| lane.key().to_string());
                answer[1] = number(position.s);
                answer[2] = number(position.offset_of_reference_line);
            }
        }
        let echo = echoed.iter().map(|i| record.get(*i).unwrap_or(""));
        let answer = answer.iter().map(String::as_str);
        output.row(echo.chain(answer).chain([error.as_deref().unwrap_or("")]))?;
    }
    output.finish()?;
    Ok(())
}
