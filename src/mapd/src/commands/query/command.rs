//! `mapd query` on the command line.

use super::output::FormatArgs;
use super::{Asking, Kind, QueryRunError, RouteArgs, run_under};
use crate::args::{Opening, lane_types, not_negative};
use crate::clock::since_epoch;
use crate::exit::{Exit, UsageError};
use crate::source;
use anyhow::{Result, bail};
use clap::Args;
use mapd_client::localisation::VehicleOutline;
use mapd_client::view::View;
use mapd_client::{NearestOptions, Snapshot};
use std::io::{self, Write};
use std::time::{Duration, UNIX_EPOCH};

/// Said at the end of `mapd help query`.
pub(crate) const HELP: &str = "\
Columns:
  inertial    road_id,s,t[,h]      x,y,z,hdg (h = 0 is the plane that superelevation rotates)
  surface     road_id,s,t          x,y,z,nx,ny,nz,friction,roughness: point and normal of the surface, the lane's material
  lane        road_id,s,lane_id    width,t_inner,t_outer,x,y,z,hdg of the lane's centre on that plane
  nearest     x,y[,z][,hdg] or lat,lon[,alt][,hdg]
                                   lane,road_id,lane_id,s,t,offset,distance
  match       x,y,hdg,sx,sy,shdg[,z]
                                   a row for each candidate lane, from the standard deviations of x, y and hdg, and one
                                   with an empty lane for none: lane,direction (+ along s, - against it),probability,s,offset,
                                   heading_difference,mahalanobis (distance from the lane's centre line, in deviations)
  ground      x,y[,z]              z,nx,ny,nz of the surface,lane,material,level (0 is the lowest; nearest to z)
  nearest-marks  x,y               distance,side (as seen along the reference line),kind,color,lane,s,
                                   painted (1, or 0 in a gap) of the nearest road mark
  geodetic    x,y[,z]              lat,lon,alt
  from-geodetic  lat,lon[,alt]     x,y,z
  track       road_id,x,y[,z]      s,t,h (h only with z),clamped (before or after, beyond an end of the road),
                                   exact (1 if s,t,h is exactly the point)
  successors  road_id,s,lane_id    successors in driving direction, joined by ;
  route       from_road,from_s,from_lane,to_road,to_s,to_lane
                                   length,lane_changes,lanes (keys in driving order, joined by ;)
  path        as route             a row for each station of the driven line:
                                   S,x,y,z,hdg,curvature,lane,left,right,speed (left, right: distances to the lane's edges)
  corridor    as route             a row for each station: S,left_x,left_y,right_x,right_y,left_mark,right_mark,left_may_cross,
                                   right_may_cross (1 if a lane change is allowed),left_edge,right_edge (lane, kerb or end of
                                   the road),speed,friction (empty if unknown)
  project     as route, and x,y[,hdg]
                                   S,d,heading_difference,lane,clamped of the nearest point of the driven line
  conflicts   as route             a row for each lane or crosswalk that meets the path: S_from,S_to,other_lane,other_s_from,other_s_to,
                                   kind,yields,reason,wait_S,basis (what yields rests on: written, rule or unknown)
  speed       road_id,s,lane_id    speed,origin
  objects     x,y,radius           a row for each placement of an object, nearest first:
                                   id,class,distance,road_id,s,t,x,y,z,value
  landmarks   x,y,radius[,classes] a row for each landmark for localisation, or of these classes (joined by ;):
                                   id,class,distance,road_id,s,t,x,y,z,hdg,length,width,height,kind (signal or object)
  signals     road_id,s,lane_id,distance
                                   a row for each signal ahead, nearest first:
                                   id,class,distance,road_id,s,t,x,y,z,state_machine,method,value (state_machine:
                                   lamps:phases[:movements]; method: why it belongs to the lane; value in m/s, m or kg)
  annotations owner[,id]           a row for each annotation: kind,path,name,value,text,file,line,column;
                                   owner is document, road, section (id road:section), lane (a key), junction, object, signal,
                                   controller, junction-group or station
  visibility  road_id,s,lane_id    forward,back,left,right: visibility range, empty if not given
  lane-rule   road_id,s,lane_id    rule as text
  junction-groups  junction_id     a row for each group of the junction: group,name,type,junctions,ring (joined by ;)
Metres and radians; latitudes and longitudes on WGS 84 in degrees. If a row has no answer, the column `error` says why; the command still exits with 0.

  printf 'x,y\\n12.5,-3\\n' | mapd query map.xodr nearest";

/// What is asked of which map.
#[derive(Args)]
pub(crate) struct QueryCommand {
    /// .xodr, .mapd or shm:NAME
    source: String,
    /// Kind of question
    #[arg(value_enum)]
    kind: Kind,
    /// nearest: largest distance from a lane's area; nearest-marks: from a mark [m]
    #[arg(long, value_name = "M", default_value_t = NearestOptions::default().radius, value_parser = not_negative)]
    radius: f64,
    /// nearest, match, nearest-marks: lane types to consider, separated by commas, or `drivable` [default: all]
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
    /// Errors: the source cannot be opened; wrong usage; reading or writing fails.
    pub(crate) fn run(self, out: &mut dyn Write) -> Result<Exit> {
        let options = NearestOptions {
            radius: self.radius,
            types: lane_types(&self.types)?,
            z_tolerance: self.z_tolerance,
            heading_tolerance: self.heading_tolerance,
            ..NearestOptions::default()
        };
        let Some(snapshot) = self.opening.open(&self.source)? else { return Ok(Exit::Rejected) };
        let is_compiled = source::is_compiled(&self.source);
        let document = if is_compiled { "the document" } else { &*self.source };
        let asking = Asking {
            document,
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
        if !self.source.starts_with(source::SHARED) {
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
        other => anyhow::Error::new(other),
    }
}
