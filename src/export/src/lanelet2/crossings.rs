//! Crosswalks and bicycle crossings: lanelets across the road.

use super::model::{Crossing, Member, Model, Rule};
use super::report::Report;
use super::tags::Tag;
use mapd_client::glam::DVec3;
use mapd_client::objects::{Object, ObjectPlacement};
use mapd_client::rules::{LaneLine, LineSource};
use mapd_client::vocabulary::{Class, ObjectShape};
use mapd_client::{Map, Track};

/// Adds a lanelet for each crosswalk that is an object, and with `autoware` the rule by which Autoware stops for it, which Lanelet2's
/// own loader does not know.
pub(super) fn add<'a>(map: Map<'a>, autoware: bool, model: &mut Model<'a>, report: &mut Report) {
    let is_crossing =
        |object: &Object<'_>| matches!(object.class(), Class::Crosswalk | Class::BicycleCrossing);
    for object in map.objects().filter(is_crossing).filter(|object| !object.is_temporary()) {
        for place in object.placements() {
            let Some([left, right]) = borders(&place) else {
                report.unsaid("crosswalks without an area");
                continue;
            };
            let tag = || vec![("type", "pedestrian_marking".into())];
            let (left, right) = (model.add_line(left, tag()), model.add_line(right, tag()));
            let tags = tags(&object);
            model.crossings.push(Crossing { left, right, tags, rule: None });
            if autoware {
                add_rule(&object, model);
            }
        }
    }
    let is_signal = |line: &LaneLine| matches!(line.source, LineSource::Signal(_));
    let lines = map.lanes().flat_map(|lane| lane.crossings()).filter(is_signal);
    (0..lines.count())
        .for_each(|_| report.unsaid("crosswalks that are signals: nobody knows how wide they are"));
}

fn tags<'a>(object: &Object<'a>) -> Vec<Tag<'a>> {
    let who = match object.class() {
        Class::BicycleCrossing => "participant:bicycle",
        _ => "participant:pedestrian",
    };
    vec![
        ("type", "lanelet".into()),
        ("subtype", "crosswalk".into()),
        ("location", "urban".into()),
        ("one_way", "no".into()),
        (who, "yes".into()),
        ("object_id", object.id().into()),
    ]
}

/// The borders of a crossing on the left and right of who crosses to the left of the road: the sides across the road
/// of the box around it that runs along the road.
fn borders(place: &ObjectPlacement<'_>) -> Option<[Vec<DVec3>; 2]> {
    let road = place.object().road()?;
    let corners = corners(place);
    let mut tracks = corners.iter().filter_map(|corner| road.to_track(*corner).ok());
    let first = tracks.next()?;
    let (mut low, mut high) = ([first.s, first.t], [first.s, first.t]);
    for track in tracks {
        low = [low[0].min(track.s), low[1].min(track.t)];
        high = [high[0].max(track.s), high[1].max(track.t)];
    }
    let at =
        |s: f64, t: f64| road.to_inertial(Track { s, t, h: 0.0 }).ok().map(|pose| pose.position);
    if !(high[0] > low[0] && high[1] > low[1]) {
        return None;
    }
    // Who walks towards rising t has rising s on the right.
    let left = vec![at(low[0], low[1])?, at(low[0], high[1])?];
    let right = vec![at(high[0], low[1])?, at(high[0], high[1])?];
    Some([left, right])
}

fn corners(place: &ObjectPlacement<'_>) -> Vec<DVec3> {
    let mut corners = Vec::new();
    if place.shape() != ObjectShape::Outlines {
        place.footprint(&mut corners);
        return corners;
    }
    let outer = place.outlines().find(|outline| outline.is_outer());
    outer.map_or(corners, |outline| outline.positions().collect())
}

/// The rule by which Autoware's vehicles heed the last crossing: they stop at the line before it.
fn add_rule<'a>(object: &Object<'a>, model: &mut Model<'a>) {
    let number = model.crossings.len().saturating_sub(1);
    let Some(crossing) = model.crossings.get(number) else { return };
    let outline = [crossing.left, crossing.right]
        .map(|at| model.lines.get(at).map(|line| line.points.clone()));
    let [Some(left), Some(right)] = outline else { return };
    let polygon = left.into_iter().chain(right.into_iter().rev()).collect();
    let tags = vec![("type", "crosswalk_polygon".into()), ("area", "yes".into())];
    let polygon = model.add_line(polygon, tags);
    let mut members =
        vec![("refers", Member::Crossing(number)), ("crosswalk_polygon", Member::Line(polygon))];
    let mut lanelets = Vec::new();
    for lane in object.lanes().filter_map(|one| one.lane()) {
        for line in
            lane.crossings().filter(|line| line.source == LineSource::Object(object.object_id()))
        {
            let lanelet = model.network.lanelet_at(&lane, line.s);
            lanelets.extend(lanelet.filter(|lanelet| !lanelets.contains(lanelet)));
        }
        let stops: Vec<LaneLine> = lane.lines_to_stop_at().collect();
        for stop in stops {
            let line = model.stop_line(&stop).map(|line| ("ref_line", Member::Line(line)));
            members.extend(line.filter(|line| !members.contains(line)));
        }
    }
    let tags = vec![("type", "regulatory_element".into()), ("subtype", "crosswalk".into())];
    model.rules.push(Rule { tags, members, lanelets });
    if let Some(crossing) = model.crossings.get_mut(number) {
        crossing.rule = Some(model.rules.len() - 1);
    }
}
