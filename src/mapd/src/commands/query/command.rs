//! `mapd query` on the command line.

use super::{Format, Kind, QueryRunError, RouteArgs, run};
use crate::args::{Opening, lane_types, not_negative};
use crate::exit::{Exit, UsageError};
use crate::source;
use anyhow::Result;
use clap::Args;
use mapd_client::NearestOptions;
use std::io::{self, Write};

/// Said at the end of `mapd help query`.
pub(crate) const HELP: &str = "\
Columns:
  inertial    road_id,s,t[,h]      x,y,z,hdg (h = 0 is the plane rolled by superelevation)
  surface     road_id,s,t          x,y,z,nx,ny,nz,friction,roughness: point and normal of the surface, the lane's material
  lane        road_id,s,lane_id    width,t_inner,t_outer,x,y,z,hdg of the lane's centre on that plane
  nearest     x,y[,z][,hdg] or lat,lon[,alt][,hdg]
                                   lane,road_id,lane_id,s,t,offset,distance
  match       x,y,hdg,sx,sy,shdg[,z]
                                   a row for each lane that the pose may be in, by standard deviations of x, y and hdg, and one
                                   with an empty lane for none: lane,direction (+ along s, - against it),probability,s,offset,
                                   heading_difference
  ground      x,y[,z]              z,nx,ny,nz of the surface there,lane,material,level (0 the lowest; the one nearest to z)
  nearest-marks  x,y               distance,side (where the mark lies, looking along the reference line),kind,color,lane,s,
                                   painted (1, or 0 in a gap) of the nearest road mark
  geodetic    x,y[,z]              lat,lon,alt
  from-geodetic  lat,lon[,alt]     x,y,z
  track       road_id,x,y[,z]      s,t,h (h only with z)
  successors  road_id,s,lane_id    successors in driving direction, joined by ;
  route       from_road,from_s,from_lane,to_road,to_s,to_lane
                                   length,lane_changes,lanes (keys in driving order, joined by ;)
  objects     x,y,radius           a row for each place of an object, the nearest first:
                                   id,class,distance,road_id,s,t,x,y,z,value
  landmarks   x,y,radius[,classes] a row for each signal or object that localisers use, or of these classes (joined by ;):
                                   id,class,distance,road_id,s,t,x,y,z,hdg,length,width,height,kind (signal or object)
  signals     road_id,s,lane_id,distance
                                   a row for each signal ahead, the nearest first, none where there is none:
                                   id,class,distance,road_id,s,t,x,y,z,state_machine,method,value (state_machine:
                                   lamps:phases[:movements]; method: how it came to the lane; value in m/s, m or kg)
  annotations owner[,id]           a row for each thing that the file says of it besides: kind,path,name,value,text,file,line,column;
                                   owner is document, road, section (id road:section), lane (a key), junction, object, signal,
                                   controller, junction-group or station
  visibility  road_id,s,lane_id    forward,back,left,right: how far one sees, empty where not given
  lane-rule   road_id,s,lane_id    rule in words
  junction-groups  junction_id     a row for each group of the junction: group,name,type,junctions,ring (joined by ;)
Metres and radians; latitudes and longitudes on WGS 84 in degrees. A row that has no answer says why in the column `error`; the command still ends with 0.

  printf 'x,y\\n12.5,-3\\n' | mapd query map.xodr nearest";

/// What is asked of which map.
#[derive(Args)]
pub(crate) struct QueryCommand {
    /// .xodr, .mapd or shm:NAME
    source: String,
    /// What is asked
    #[arg(value_enum)]
    kind: Kind,
    /// nearest: largest distance from a lane's area; nearest-marks: from a mark [m]
    #[arg(long, value_name = "M", default_value_t = NearestOptions::default().radius, value_parser = not_negative)]
    radius: f64,
    /// nearest, match, nearest-marks: lane types that count, separated by commas, or `drivable` [default: all]
    #[arg(long, value_name = "TYPES", value_delimiter = ',')]
    types: Vec<String>,
    /// nearest, match: largest difference in z [m], where the input has z
    #[arg(long, value_name = "M", value_parser = not_negative)]
    z_tolerance: Option<f64>,
    /// nearest: largest difference from the lane's driving direction [rad], where the input has hdg
    #[arg(long, value_name = "RAD", value_parser = not_negative)]
    heading_tolerance: Option<f64>,
    #[command(flatten)]
    route: RouteArgs,
    /// How answers are written
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,
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
        let how = (&options, &self.route, self.format);
        run((snapshot.map(), document), self.kind, how, io::stdin().lock(), out)
            .map_err(usage_of)?;
        Ok(Exit::Done)
    }
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
