//! A map as Lanelet2 has it: lanelets between borders that neighbours share, and the rules that hold on them.

mod align;
mod areas;
mod crossings;
mod joints;
mod lights;
mod model;
mod network;
mod osm;
mod report;
mod right_of_way;
mod signs;
mod stretches;
mod tags;
mod unsaid;

use crate::{Progress, Result};
use mapd_client::Map;
use mapd_client::geodesy::Projector;
use model::Model;
use network::Network;
pub use report::Report;
use std::io::Write;

/// Writes a map, and returns what could not be kept as it is. With `autoware` there is also what Autoware reads and Lanelet2's own
/// loader refuses.
///
/// Errors: a point outside the area of the map's projection; what writing gives.
pub(super) fn write(
    map: Map<'_>,
    projector: &Projector,
    autoware: bool,
    progress: &mut dyn FnMut(Progress),
    out: &mut dyn Write,
) -> Result<Report> {
    let mut report = Report::default();
    progress(Progress { doing: "joining lanes", done: 0 });
    let network = Network::of(map, &mut report);
    let mut model = Model::new(map, network);
    progress(Progress { doing: "aligning borders", done: 0 });
    model.align(&mut report);
    progress(Progress { doing: "rules", done: 0 });
    crossings::add(map, autoware, &mut model, &mut report);
    lights::add(map, &mut model, &mut report);
    signs::add(map, autoware, &mut model, &mut report);
    right_of_way::add(&mut model);
    areas::add(map, &mut model, &mut report);
    unsaid::add(map, &mut report);
    osm::write(&model, projector, &mut report, progress, out)?;
    Ok(report)
}
