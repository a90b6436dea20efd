//! Which lanes an object belongs to (docs/objects.md): those that the file names, else those that its area lies on, else
//! the nearest one that fits.

use super::near_lanes::NearLanes;
use super::track_area::{Profile, Stretch, TrackArea};
use crate::draft::LaneNumbers;
use crate::findings::TooLarge;
use crate::sample::view;
use glam::DVec2;
use mapd_archive::{LaneMethod, NONE, ObjectLaneRow, Orientation, Range, Rows};
use mapd_query::compiling::ByRow as _;
use mapd_query::objects::{Object, ObjectPlacement};
use mapd_query::vocabulary::ObjectShape;
use mapd_query::{Lane, LanePosition, Map, Road};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;

/// A lane that lies farther above or below the road at the object's place than this `[m]` is on another level.
const LEVEL: f64 = 3.0;
/// The nearest lane must run along the object's road up to this angle `[rad]`.
const MOST_TURNED: f64 = FRAC_PI_4;
/// Distance of points along an object's edge that are looked for on lanes of other roads `[m]`, and their greatest number.
const PROBES: (f64, usize) = (1.0, 400);
/// Points of a swept object's edge that look for their nearest lane.
const SWEPT_PROBES: usize = 64;

/// Where an object lies on a lane, or beside it.
#[derive(Clone, Copy, Debug)]
struct LaneAttachment {
    stretch: Stretch,
    method: LaneMethod,
}

/// Places by row of the lane.
#[derive(Default)]
struct LaneAttachments(BTreeMap<u32, LaneAttachment>);

impl LaneAttachments {
    fn add(&mut self, lane: &Lane<'_>, stretch: Stretch, method: LaneMethod) {
        let place =
            self.0.entry(lane.lane_id().row()).or_insert(LaneAttachment { stretch, method });
        place.stretch.s[0] = place.stretch.s[0].min(stretch.s[0]);
        place.stretch.s[1] = place.stretch.s[1].max(stretch.s[1]);
        place.stretch.distance = place.stretch.distance.min(stretch.distance);
        if method.code() < place.method.code() {
            place.method = method;
        }
    }
}

/// A reference to an object from another road (`objectReference`).
pub(super) struct Reference {
    /// Row of the referring road.
    pub(super) road: u32,
    pub(super) s: f64,
    pub(super) t: f64,
    pub(super) valid_length: f64,
    pub(super) orientation: Orientation,
    pub(super) lanes: LaneNumbers,
}

/// Fills `object_lanes`, `lane_objects` and the objects' ranges. Returns the rows of objects that belong to no lane.
/// `references` are sorted by the row of their object, which stands beside them.
pub(super) fn attach(
    rows: &mut Rows,
    references: &[(u32, Reference)],
    reach: f64,
) -> Result<Vec<usize>, TooLarge> {
    let found: Vec<Vec<ObjectLaneRow>> = {
        let archive = view(rows);
        let map = Map::new(&archive, 0);
        let near = NearLanes::new(map);
        let one = |row: u32| {
            map.object_by_row(row).map_or_else(Vec::new, |object| {
                let first = references.partition_point(|(of, _)| *of < row);
                let own = references[first..].iter().take_while(|(of, _)| *of == row);
                lanes_of(
                    Lanes { map, near: &near },
                    &object,
                    own.map(|(_, reference)| reference),
                    reach,
                )
            })
        };
        (0..rows.objects.len() as u32).into_par_iter().map(one).collect()
    };
    let mut unattached = Vec::new();
    for (number, lanes) in found.into_iter().enumerate() {
        if lanes.is_empty() {
            unattached.push(number);
        }
        let before = rows.object_lanes.len();
        rows.object_lanes.extend(lanes);
        let after = rows.object_lanes.len();
        rows.objects[number].lanes =
            Range::between(before, after).ok_or_else(|| TooLarge::new("object_lanes"))?;
    }
    let mut order: Vec<u32> = (0..rows.object_lanes.len() as u32).collect();
    order.sort_by(|a, b| {
        let row = |i: u32| &rows.object_lanes[i as usize];
        let (a_row, b_row) = (row(*a), row(*b));
        a_row.lane.cmp(&b_row.lane).then(a_row.s_from.total_cmp(&b_row.s_from)).then(a.cmp(b))
    });
    rows.lane_objects = order.into();
    Ok(unattached)
}

/// All lanes of a map, and which of them are near a point.
#[derive(Clone, Copy)]
struct Lanes<'a> {
    map: Map<'a>,
    near: &'a NearLanes,
}

/// Lanes that a file says something is for.
#[derive(Clone, Copy)]
struct MeantFor<'a> {
    lanes: &'a LaneNumbers,
    /// Which way they lead.
    orientation: Orientation,
}

/// Rows of an object's lanes, nearer ones first.
fn lanes_of<'a>(
    lanes: Lanes<'_>,
    object: &Object<'_>,
    references: impl Iterator<Item = &'a Reference>,
    reach: f64,
) -> Vec<ObjectLaneRow> {
    let Lanes { map, .. } = lanes;
    let mut places = LaneAttachments::default();
    let written: Vec<(i32, i32)> =
        object.validities().map(|lanes| (lanes.from, lanes.to)).collect();
    let named = LaneNumbers::new(&written);
    let mut probes = Vec::new();
    for placement in object.placements() {
        let area = object.road().and_then(|road| Some((road, area(&road, &placement)?)));
        let mut is_named = false;
        if let Some((road, area)) = area {
            let area = area.lengthened((placement.s() + object.valid_length()).min(road.length()));
            let area = area.along(&road);
            let meant = MeantFor { lanes: &named, orientation: object.orientation() };
            is_named = by_validity(&area, meant, &mut places);
            if !is_named {
                by_position(&area, object.orientation(), &mut places);
            }
        }
        if !is_named {
            on_other_roads(lanes, &placement, &mut probes, &mut places);
        }
    }
    for reference in references {
        let Some(road) = map.road_by_row(reference.road) else { continue };
        let corner = vec![DVec2::new(reference.s, reference.t)];
        let Some(area) = TrackArea::new(corner) else { continue };
        let area = area.lengthened((reference.s + reference.valid_length).min(road.length()));
        let area = area.along(&road);
        let meant = MeantFor { lanes: &reference.lanes, orientation: reference.orientation };
        if !by_validity(&area, meant, &mut places) {
            by_position(&area, reference.orientation, &mut places);
        }
    }
    if places.0.is_empty() {
        for placement in object.placements() {
            nearest(lanes, &placement, reach, &mut probes, &mut places);
        }
    }
    let number = object.object_id().row();
    let row = |(lane, place): (u32, LaneAttachment)| {
        let start = map.lane_by_row(lane).map_or(0.0, |lane| lane.section().s_start());
        ObjectLaneRow {
            object: number,
            lane,
            s_from: (place.stretch.s[0] - start) as f32,
            s_to: (place.stretch.s[1] - start) as f32,
            distance: place.stretch.distance as f32,
            method: place.method.code(),
            reserved: [0; 3],
        }
    };
    let mut rows: Vec<ObjectLaneRow> = places.0.into_iter().map(row).collect();
    rows.sort_by(|a, b| a.distance.total_cmp(&b.distance).then(a.lane.cmp(&b.lane)));
    rows
}

/// The area of an object where it stands, in its road's coordinates.
fn area(road: &Road<'_>, placement: &ObjectPlacement<'_>) -> Option<TrackArea> {
    let center = DVec2::new(placement.s(), placement.t());
    match placement.shape() {
        ObjectShape::Point => return TrackArea::new(vec![center]),
        ObjectShape::Cylinder => {
            let around = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
            return TrackArea::new(around.map(|axis| center + axis * placement.radius()).to_vec());
        }
        _ => {}
    }
    let mut corners = Vec::new();
    placement.footprint(&mut corners);
    let track = |corner: &glam::DVec3| {
        let track = road.to_track(corner.truncate()).ok()?;
        Some(DVec2::new(track.s, track.t))
    };
    TrackArea::new(corners.iter().map(track).collect::<Option<Vec<_>>>()?)
}

/// Lanes that the file names, those that lead where the object is for, if any does. False where it names none that the road has
/// there.
fn by_validity(area: &Profile<'_>, meant: MeantFor<'_>, places: &mut LaneAttachments) -> bool {
    if meant.lanes.is_empty() {
        return false;
    }
    let named =
        area.lanes(true).into_iter().filter(|(lane, _)| meant.lanes.contains(lane.number()));
    add_leading(named, meant.orientation, LaneMethod::Validity, places)
}

/// Whether a lane leads where something is for. What nobody drives on leads everywhere.
fn leads(lane: &Lane<'_>, orientation: Orientation) -> bool {
    !lane.kind().is_drivable() || lane.is_bidirectional() || orientation.is_for(lane.is_forward())
}

/// Lanes of the object's own road that its area lies on; those that lead where it is for, if any does.
fn by_position(area: &Profile<'_>, orientation: Orientation, places: &mut LaneAttachments) {
    add_leading(area.lanes(false).into_iter(), orientation, LaneMethod::Track, places);
}

/// Adds of these lanes those that lead where something is for; all where none does. False where there are none.
fn add_leading<'a>(
    lanes: impl Iterator<Item = (Lane<'a>, Stretch)>,
    orientation: Orientation,
    method: LaneMethod,
    places: &mut LaneAttachments,
) -> bool {
    let lanes: Vec<(Lane<'_>, Stretch)> = lanes.collect();
    let any_leads = lanes.iter().any(|(lane, _)| leads(lane, orientation));
    for (lane, stretch) in &lanes {
        if !any_leads || leads(lane, orientation) {
            places.add(lane, *stretch, method);
        }
    }
    !lanes.is_empty()
}

/// Height of the road, or of the junction's elevation grid, at an object's place `[m]`, which lanes of other roads are compared
/// with; none for an object of a junction without a grid, whose line has no height.
fn ground(placement: &ObjectPlacement<'_>) -> Option<f64> {
    let object = placement.object();
    match object.road() {
        Some(road) => Some(road.elevation_at(placement.s())),
        None => Some(object.junction()?.grid_height_at(placement.position().truncate())?.height),
    }
}

/// Whether a place on a lane is on the level of the object's.
fn is_level(at: &LanePosition, ground: Option<f64>) -> bool {
    ground.is_none_or(|ground| (at.z - ground).abs() <= LEVEL)
}

/// Lanes of other roads that the object's area lies on, as in a junction, where one road's crosswalk crosses many.
fn on_other_roads(
    lanes: Lanes<'_>,
    placement: &ObjectPlacement<'_>,
    probes: &mut Vec<DVec2>,
    places: &mut LaneAttachments,
) {
    placement.probes(PROBES.0, PROBES.1, probes);
    let own = placement.object().road().map_or(NONE, |road| road.road_id().row());
    let other = |lane: &Lane<'_>| lane.road().road_id().row() != own;
    let low = probes.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = probes.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    // Most lie beside their own road alone.
    if probes.is_empty() || !lanes.near.any_within(lanes.map, [low, high], other) {
        return;
    }
    let ground = ground(placement);
    for probe in probes.iter() {
        for (lane, at) in lanes.near.around(lanes.map, *probe, 0.0, other) {
            if at.distance == 0.0 && is_level(&at, ground) {
                let stretch = Stretch { s: [at.s; 2], distance: 0.0 };
                places.add(&lane, stretch, LaneMethod::Track);
            }
        }
    }
}

/// A lane that may be the nearest.
#[derive(Clone, Copy)]
struct Candidate {
    distance: f64,
    /// Of another road than the object: of two equally near lanes, its own road's is meant.
    is_other: bool,
    row: u32,
    s: f64,
}

impl Candidate {
    fn wins_over(&self, best: Option<Self>) -> bool {
        best.is_none_or(|best| {
            let rest = (self.is_other, self.row).cmp(&(best.is_other, best.row));
            self.distance.total_cmp(&best.distance).then(rest).is_lt()
        })
    }
}

/// The nearest lane within `most` `[m]` that runs along the object's road and leads where the object is for; of what is swept along a road,
/// the nearest to each of some points.
fn nearest(
    lanes: Lanes<'_>,
    placement: &ObjectPlacement<'_>,
    most: f64,
    probes: &mut Vec<DVec2>,
    places: &mut LaneAttachments,
) {
    let object = placement.object();
    let count = if placement.is_swept() { SWEPT_PROBES } else { PROBES.1 };
    placement.probes(PROBES.0, count, probes);
    let own = object.road();
    let own_row = own.map_or(NONE, |road| road.road_id().row());
    let track = mapd_query::Track { s: placement.s(), t: 0.0, h: 0.0 };
    let road_heading = own.and_then(|road| Some(road.to_inertial(track).ok()?.heading));
    let ground = ground(placement);
    // Of a round object, the centre alone is probed.
    let round = if placement.shape() == ObjectShape::Cylinder { placement.radius() } else { 0.0 };
    let fits = |lane: &Lane<'_>, at: &LanePosition| {
        if !is_level(at, ground) {
            return false;
        }
        let Some(mine) = road_heading else { return true };
        let turned = mapd_geometry::normalize_angle(at.heading_of_reference_line - mine).abs();
        let is_opposed = turned > std::f64::consts::FRAC_PI_2;
        let parallel = turned.min(std::f64::consts::PI - turned) <= MOST_TURNED;
        // Along one road may be against the s of another.
        let written = object.orientation();
        let orientation = if is_opposed { written.turned() } else { written };
        parallel && leads(lane, orientation)
    };
    let mut best: Option<Candidate> = None;
    for probe in probes.iter() {
        let mut of_probe: Option<Candidate> = None;
        let reach = best.map_or(most, |best| most.min(best.distance));
        for (lane, at) in lanes.near.around(lanes.map, *probe, reach, |_| true) {
            let is_other = lane.road().road_id().row() != own_row;
            let row = lane.lane_id().row();
            let distance = (at.distance - round).max(0.0);
            let new = Candidate { distance, is_other, row, s: at.s };
            if at.distance <= most && new.wins_over(of_probe) && fits(&lane, &at) {
                of_probe = Some(new);
            }
        }
        if placement.is_swept() {
            add_nearest(lanes.map, of_probe, places);
        } else if of_probe.is_some_and(|new| new.wins_over(best)) {
            best = of_probe;
        }
    }
    add_nearest(lanes.map, best, places);
}

fn add_nearest(map: Map<'_>, found: Option<Candidate>, places: &mut LaneAttachments) {
    let Some(Candidate { distance, row, s, .. }) = found else { return };
    if let Some(lane) = map.lane_by_row(row) {
        places.add(&lane, Stretch { s: [s; 2], distance }, LaneMethod::Nearest);
    }
}
