//! What a map has and Lanelet2 has no words for at all, counted for the report. What it can say in part is counted where it is written.

use super::areas::of_object;
use super::report::Report;
use mapd_client::objects::Object;
use mapd_client::rules::Basis;
use mapd_client::vocabulary::Class;
use mapd_client::{Lane, Map, Track};

/// A lane whose surface is farther than this from the plane h = 0 lies above or below it `[m]`.
const LEVEL: f64 = 1e-3;

/// Counts all of it.
pub(super) fn add(map: Map<'_>, report: &mut Report) {
    let sum = |of: &dyn Fn(&Lane<'_>) -> usize| map.lanes().map(|lane| of(&lane)).sum::<usize>();
    let by_rule =
        |lane: &Lane<'_>| lane.right_of_way().filter(|one| one.basis() == Basis::Rule).count();
    let temporary = map.roads().map(|road| road.temporary_sections().count()).sum();
    let counts = [
        ("controllers of signals", map.controllers().count()),
        ("surfaces: lanes above or below the plane h = 0", sum(&|lane| is_uneven(lane).into())),
        ("materials of lanes", sum(&|lane| lane.material_at(middle(lane)).is_some().into())),
        ("visibility of lanes", sum(&|lane| lane.visibilities().len())),
        ("rules of lanes in words", sum(&|lane| lane.rules().len())),
        ("right of way by rules of the road", sum(&by_rule)),
        ("objects that are neither crosswalks nor areas", map.objects().filter(is_other).count()),
        ("temporary sections of lanes", temporary),
        ("temporary signals", map.signals().filter(|one| one.is_temporary()).count()),
        ("tunnels and bridges", map.structures().len()),
        ("switches of railways", map.switches().len()),
        ("stations of railways", map.stations().len()),
        ("groups of junctions", map.junction_groups().len()),
        ("other data of the file", map.annotations().len()),
    ];
    for (what, count) in counts {
        report.unsaid_times(what, count);
    }
}

fn middle(lane: &Lane<'_>) -> f64 {
    0.5 * (lane.section().s_start() + lane.section().s_end())
}

fn is_other(object: &Object<'_>) -> bool {
    let is_crossing = matches!(object.class(), Class::Crosswalk | Class::BicycleCrossing);
    object.is_temporary() || !is_crossing && of_object(object.class()).is_none()
}

/// Whether the surface of a lane is off the plane h = 0 at its ends or its middle.
fn is_uneven(lane: &Lane<'_>) -> bool {
    let (section, road) = (lane.section(), lane.road());
    // At its end the next section begins.
    let end = section.s_end() - LEVEL * (section.s_end() - section.s_start());
    [section.s_start(), middle(lane), end].into_iter().any(|s| {
        let edges = lane.edges_at(s);
        let t = 0.5 * (edges.inner + edges.outer);
        let plane = road.to_inertial(Track { s, t, h: 0.0 });
        let surface = road.surface_at(s, t);
        surface
            .ok()
            .zip(plane.ok())
            .is_some_and(|(surface, plane)| surface.position.distance(plane.position) > LEVEL)
    })
}
