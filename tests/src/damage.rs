//! Damaged archives: making hashes fit, and asking everything.

mod paths;
mod places;
pub mod random;
mod views;

pub use views::ask_under;

use mapd_archive::{AlignedBytes, HEADER_LENGTH};
use mapd_client::{LaneTypes, Map, NearestOptions, Region, Snapshot, Track, glam::DVec2};
use mapd_query::route::{
    LaneSequences, PositionOnLane, RouteScratch, ShortestLength, ShortestTime, next_lane_change,
};
use mapd_query::signals::SignalsAhead;
use mapd_query::vocabulary::{ClassSet, VehicleClass};

/// Lanes for questions that take long.
const FEW: usize = 3;

/// Asks everything of a map that may be damaged; only the absence of a panic counts.
pub fn ask_everything(bytes: AlignedBytes) {
    let Ok(snapshot) = Snapshot::from_bytes(bytes) else { return };
    ask_rows_of(&snapshot);
    places::ask(snapshot.map());
    paths::ask(snapshot.map());
}

/// As [`ask_everything`], but for batches, matches and paths: what takes long.
pub fn ask_rows(bytes: AlignedBytes) {
    if let Ok(snapshot) = Snapshot::from_bytes(bytes) {
        ask_rows_of(&snapshot);
    }
}

fn ask_rows_of(snapshot: &Snapshot) {
    let map = snapshot.map();
    for x in [-5.0, 20.0, 120.0] {
        let _ = map.nearest_lane(DVec2::new(x, 1.0), &NearestOptions::default());
    }
    let _ = (map.geodetic_bounds(), map.header_offset(), map.projection());
    if let Some(frame) = map.file_frame() {
        let _ = (frame.target(), frame.projection(), frame.offset(), frame.bounds());
        let _ = (frame.scale_min(), frame.error(), frame.height_shift(), frame.height_error());
    }
    for projector in [map.projector(), map.file_projector()].into_iter().flatten() {
        let _ = projector.to_geodetic(map.bounds().low);
    }
    for road in map.roads() {
        let _ = (
            road.id(),
            road.name(),
            road.junction().map(|j| j.id()),
            road.predecessor(),
            road.successor(),
        );
        let _ = road.to_inertial(Track { s: 10.0, t: 1.0, h: 0.0 });
        let _ = road.to_track(DVec2::new(3.0, 4.0));
        let _ = (road.surface_at(10.0, 1.0), road.surface_at(100.0, -30.0));
        let _ = road.temporary_sections().flat_map(|section| section.lanes()).count();
        let _ = (road.section_at(5.0).map(|s| s.lane_at(5.0, 1.0).is_some()), road.types().count());
    }
    for lane in map.lanes() {
        let _ = (
            lane.key().to_string(),
            lane.left_bound().positions().count(),
            lane.right_bound().len(),
        );
        let _ = (
            lane.successors().count(),
            lane.left().is_some(),
            lane.right().is_some(),
            lane.speeds().count(),
        );
        let _ = lane.pose_at(1.0, 0.0);
        let _ =
            (lane.opposite().is_some(), lane.length_between(0.0, 9.0), lane.speed_rules().count());
        for mark in lane.road_marks() {
            let _ = (mark.kind(), mark.material(), mark.lines().count(), mark.t_at(mark.s()));
        }
        for conflict in lane.conflicts() {
            let _ = (conflict.other().is_some(), conflict.other_range(), conflict.s_range());
        }
        let _ =
            (lane.material_at(1.0).is_some(), lane.height_at(1.0), lane.waypoint_at(1.0).is_ok());
    }
    for lane in map.lanes().take(FEW) {
        let _ = lane.position_of(DVec2::new(3.0, 4.0));
    }
    let (region, mut lanes, mut segments) =
        (Region::around(DVec2::new(20.0, 1.0), 30.0), vec![], vec![]);
    let _ = map.boundary_segments(region, LaneTypes::routable(), &mut lanes, &mut segments);
    let _ = map.road_mark_segments(region, LaneTypes::ALL, &mut lanes, &mut segments, &mut vec![]);
    ask_graph(map);
    ask_signals(map);
    ask_objects(map);
    for junction in map.junctions() {
        let _ = junction.connections().map(|c| c.lane_links().count()).sum::<usize>();
    }
    let _ = map.road_by_id("1");
    let _ = snapshot.verify();
}

fn ask_signals(map: Map<'_>) {
    for signal in map.signals() {
        let _ = (signal.id(), signal.code(), signal.class(), signal.value(), signal.position());
        let _ = signal.dependencies().map(|link| link.id.len()).sum::<usize>();
        for board in signal.boards() {
            let _ = (board.position(), board.validities().count(), board.display_type());
            let _ = (board.links().count(), board.dependencies().filter_map(|l| l.signal).count());
            let _ = board.areas().map(|area| (area.position(), area.size())).last();
        }
        let _ = (signal.links().filter_map(|link| link.signal).count(), signal.size());
        let _ = (signal.semantics().count(), signal.controllers().count(), signal.light());
        let _ = (signal.road().is_some(), signal.carrier().is_some(), signal.places().count());
        let _ = (map.signal_by_id(signal.id()).is_some(), signal.movements().count());
    }
    for place in map.signal_places() {
        let _ = place.lanes().filter(|one| one.distance() > 1.0).map(|one| one.method()).last();
    }
    for member in map.board_groups() {
        let _ = (member.group(), member.board().is_some(), member.id(), member.rank());
    }
    for controller in map.controllers() {
        let _ = (controller.id(), controller.signals().count(), controller.junctions().count());
    }
    for junction in map.junctions() {
        let _ = junction.controllers().filter_map(|one| one.controller()).count();
    }
    let (point, mut landmarks) = (DVec2::new(20.0, 1.0), vec![]);
    let _ = map.signals_near(point, 30.0, &mut vec![]);
    let _ = map.signals_in(Region::around(point, 1e9), &mut vec![]);
    let _ = map.landmarks_near(point, 30.0, ClassSet::ALL, &mut landmarks);
    let _ = map.landmarks_in(Region::around(point, 1e9), ClassSet::LANDMARKS, &mut landmarks);
    let mut ahead = SignalsAhead::default();
    for lane in map.lanes() {
        let _ = lane.overtaking_rule_at(1.0);
        let _ = (lane.speed_rule_at(1.0), lane.turn(), lane.movement_stop_line().is_some());
        let _ = (lane.movement_lights().count(), lane.yields_to().count(), lane.entries().count());
        let _ = (lane.movement_crossings().count(), lane.movement_lanes().count());
        let _ = (lane.lines_to_stop_at().count(), lane.crossings().count(), lane.movement_stop());
        let _ = (lane.stop_lines().count(), lane.crosswalks().count(), lane.access_at(1.0).count());
        let from = PositionOnLane { lane: lane.lane_id(), s: 1.0 };
        let _ = map.signals_ahead(from, 50.0, VehicleClass::PassengerCar, &mut ahead);
    }
}

fn ask_objects(map: Map<'_>) {
    let (mut near, mut inside, mut corners) = (Vec::new(), Vec::new(), Vec::new());
    let point = DVec2::new(20.0, 1.0);
    let _ = map.objects_near(point, 30.0, &mut near);
    let _ = map.objects_in(Region::around(point, 30.0), &mut inside);
    for id in inside.iter().chain(near.iter().map(|found| &found.place)).take(200) {
        let Ok(place) = map.placement(*id) else { continue };
        place.footprint(&mut corners);
        let _ = (place.height(), place.bounds(), place.distance(point), place.item());
    }
    for object in map.objects().take(200) {
        let _ = (object.id(), object.class().name(), object.type_name(), object.validities().len());
        let _ = object.signals().map(|signal| signal.id().len()).sum::<usize>();
        let _ = (object.position_on_surface().is_ok(), object.is_repeated(), object.height());
        for outline in object.outlines() {
            let _ = (outline.positions().count(), outline.heights().count(), outline.fill());
        }
        for at in object.lanes() {
            let _ = (at.lane().is_some(), at.object().is_some(), at.s_range(), at.method());
        }
        let _ = object.placements().take(200).map(|place| place.outlines().len()).sum::<usize>();
    }
    for place in map.objects().take(200).map(|object| object.template()) {
        for marking in place.markings() {
            let _ = (marking.corners().count(), marking.outline().is_some(), marking.color());
        }
        for border in place.borders() {
            let _ = (border.corners().count(), border.outline().is_some(), border.kind());
        }
        let _ = place.skeletons().map(|line| line.vertices().count()).sum::<usize>();
        let _ =
            (place.object().parking_space().map(|p| p.access()), place.object().materials().len());
    }
    for reference in map.object_references().take(200) {
        let _ = (reference.object().is_some(), reference.road().is_some(), reference.id());
        let _ = reference.validities().count();
    }
    for structure in map.structures().take(200) {
        let _ = (structure.kind(), structure.road().is_some(), structure.validities().count());
    }
    for switch in map.switches().take(200) {
        let _ = (switch.main_track().road.is_some(), switch.partner().is_some(), switch.position());
    }
    for platform in map.stations().take(200).flat_map(|station| station.platforms().take(200)) {
        let _ = (platform.segments().take(200).count(), platform.id());
    }
    let _ = map.lanes().map(|lane| lane.objects().count()).sum::<usize>();
    let _ = map.roads().map(|road| road.objects().count()).sum::<usize>();
    let _ = map.junctions().map(|junction| junction.objects().count()).sum::<usize>();
    let _ = map.object_by_id("1").map(|object| object.source_position());
}

fn ask_graph(map: Map<'_>) {
    for node in map.lane_nodes().take(200) {
        let _ = (node.s_range(), node.change_left().is_some(), node.predecessors().count());
        for edge in node.edges() {
            let _ = (edge.kind(), edge.closes_loop(), edge.source_position());
        }
    }
    let (mut scratch, mut steps, mut reached) = (RouteScratch::default(), Vec::new(), Vec::new());
    let mut sequences = LaneSequences::default();
    let (car, length) = (VehicleClass::PassengerCar, ShortestLength::default());
    let mut places = map.lanes().map(|lane| PositionOnLane { lane: lane.lane_id(), s: 5.0 });
    let (Some(first), Some(last)) = (places.next(), places.nth(20).or(places.last())) else {
        return;
    };
    for (from, to) in [(first, last), (last, first)] {
        let _ = map.route(from, to, car, &length, &mut scratch, &mut steps);
        let _ = next_lane_change(map, &steps, 0, from);
        let _ = map.route(from, to, car, &ShortestTime::default(), &mut scratch, &mut steps);
        let _ = map.reachable(from, 60.0, car, &length, &mut scratch, &mut reached);
        let _ = map.lane_sequences_ahead(from, 60.0, car, &mut scratch, &mut sequences);
        let _ =
            std::iter::repeat_with(|| sequences.next_sequence().is_some()).take(200).all(|is| is);
        let _ = map.lane_sequences_behind(from, 60.0, car, &mut scratch, &mut sequences);
        let _ =
            std::iter::repeat_with(|| sequences.next_sequence().is_some()).take(200).all(|is| is);
        let _ = map.next_junction(from, 60.0, car);
        let _ = map.signals_along(&steps, &mut SignalsAhead::default());
        let _ = map.lines_along(&steps, &mut vec![]);
    }
}

/// Makes hashes fit again, as a faulty or hostile writer would: what is left to find damage are the checks of rows.
pub fn seal(bytes: &mut [u8]) {
    let content = blake3::hash(&bytes[HEADER_LENGTH..]);
    bytes[40..72].copy_from_slice(content.as_bytes());
    seal_header(bytes);
}

/// As [`seal`], for the header alone.
pub fn seal_header(bytes: &mut [u8]) {
    let sum = blake3::hash(&bytes[..120]);
    bytes[120..HEADER_LENGTH].copy_from_slice(&sum.as_bytes()[..8]);
}
