//! `mapd query` on the command line.

use super::input::InputError;
use super::output::FormatArgs;
use super::{Asking, Kind, QueryRunError, RouteArgs, heeded, run_under};
use crate::args::{Opening, lane_types, not_negative};
use crate::clock::since_epoch;
use crate::exit::{Exit, UsageError};
use crate::source::Source;
use anyhow::{Result, bail};
use clap::{ArgMatches, Args};
use mapd_client::localisation::{MarkFilter, VehicleOutline};
use mapd_client::view::View;
use mapd_client::{NearestOptions, Snapshot};
use std::io::{self, Write};
use std::time::{Duration, UNIX_EPOCH};

/// Said at the end of `mapd help query`.
pub(crate) const HELP: &str = include_str!("columns.txt").trim_ascii_end();

/// What is asked of which map.
#[derive(Args)]
pub(crate) struct QueryCommand {
    /// .xodr, .mapd or shm:NAME
    source: Source,
    /// Kind of question
    #[arg(value_enum)]
    kind: Kind,
    /// nearest: largest distance from a lane's area [m]; nearest-marks: from a mark [m] [default: 10; nearest-marks: 5]
    #[arg(long, value_name = "M", value_parser = not_negative)]
    radius: Option<f64>,
    /// nearest, match, nearest-marks: lane types to consider, separated by commas, `drivable` or `routable` [default: all]
    #[arg(long, value_name = "TYPES", value_delimiter = ',')]
    types: Vec<String>,
    /// nearest, match: largest difference in z [m], if the input has z
    #[arg(long, value_name = "M", value_parser = not_negative)]
    z_tolerance: Option<f64>,
    /// nearest: largest difference from the lane's driving direction [rad], if the input has hdg
    #[arg(long, value_name = "RAD", value_parser = not_negative)]
    heading_tolerance: Option<f64>,
    /// match: how far the vehicle reaches ahead, back, left and right of x, y [m]: a lane counts by the share of the vehicle in it
    #[arg(long, value_name = "FRONT,BACK,LEFT,RIGHT", value_parser = super::matching::outline)]
    outline: Option<VehicleOutline>,
    #[command(flatten)]
    route: RouteArgs,
    #[command(flatten)]
    format: FormatArgs,
    #[command(flatten)]
    opening: Opening,
}

impl QueryCommand {
    /// Answers what stdin asks.
    ///
    /// Errors: the source cannot be opened; wrong usage, such as an option that the kind does not heed; reading or writing fails.
    pub(crate) fn run(self, matches: &ArgMatches, out: &mut dyn Write) -> Result<Exit> {
        heeded::check(self.kind, matches)?;
        let usual_radius = match self.kind {
            Kind::NearestMarks => MarkFilter::default().radius,
            _ => NearestOptions::default().radius,
        };
        let options = NearestOptions {
            radius: self.radius.unwrap_or(usual_radius),
            types: lane_types(&self.types)?,
            // Routes are some vehicle's in any case; places are all, where none is named.
            vehicle: heeded::is_given(matches, "vehicle").then_some(self.route.vehicle),
            z_tolerance: self.z_tolerance,
            heading_tolerance: self.heading_tolerance,
            ..NearestOptions::default()
        };
        let Some(snapshot) = self.opening.open(&self.source)? else { return Ok(Exit::Rejected) };
        let document = match self.source.is_compiled() {
            true => "the document".to_owned(),
            false => self.source.to_string(),
        };
        let asking = Asking {
            document: &document,
            options: &options,
            outline: self.outline,
            route: &self.route,
            format: self.format.get(),
        };
        let view = self.view(&snapshot)?;
        run_under(view, self.kind, asking, io::stdin().lock(), out).map_err(usage_of)?;
        Ok(Exit::Done)
    }
}

impl QueryCommand {
    /// What is asked: the map, or with `--overlay` the map under what is laid over it.
    fn view<'a>(&self, snapshot: &'a Snapshot) -> Result<View<'a>> {
        if !self.route.overlay {
            return Ok(View::of(snapshot.map(), None, UNIX_EPOCH));
        }
        if self.source.file().is_some() {
            bail!(UsageError("--overlay goes with a map that is served, shm:NAME".to_owned()));
        }
        let at = self.route.at.map_or_else(since_epoch_signed, |at| at.unix_seconds);
        let from_epoch = Duration::try_from_secs_f64(at.abs()).unwrap_or_default();
        let at = if at < 0.0 { UNIX_EPOCH - from_epoch } else { UNIX_EPOCH + from_epoch };
        Ok(snapshot.view(at))
    }
}

fn since_epoch_signed() -> f64 {
    since_epoch().as_secs_f64()
}

/// What is wrong with how a query is asked is wrong usage.
pub(in crate::commands) fn usage_of(error: QueryRunError) -> anyhow::Error {
    match error {
        QueryRunError::Columns { .. } | QueryRunError::Options(_) => {
            UsageError(error.to_string()).into()
        }
        QueryRunError::Csv(error) if InputError::is_about_input(&error) => {
            UsageError(error.to_string()).into()
        }
        // As itself, so that a closed pipe is known as one.
        QueryRunError::Csv(error) => error.into(),
        QueryRunError::Io(error) => error.into(),
    }
}
