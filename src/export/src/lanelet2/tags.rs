//! What Lanelet2 says of lanelets and of their borders.

use super::network::{Lanelet, Network};
use super::report::Report;
use super::stretches::Stretch;
use mapd_client::Lane;
use mapd_client::SRange;
use mapd_client::graph::LaneNode;
use mapd_client::roads::RoadMark;
use mapd_client::rules::Turn;
use mapd_client::vocabulary::{
    LaneType, RoadMarkColor, RoadMarkKind, RoadMarkWeight, RoadType, VehicleClass,
};
use std::borrow::Cow;

/// A tag: name and value.
pub(super) type Tag<'a> = (&'static str, Cow<'a, str>);

/// Metres per second in kilometres per hour, in which Lanelet2 has speeds.
const KM_PER_HOUR: f64 = 3.6;

/// Classes of vehicles that Lanelet2 knows, with the tag that lets them in.
const PARTICIPANTS: &[(VehicleClass, &str)] = &[
    (VehicleClass::PassengerCar, "participant:vehicle:car"),
    (VehicleClass::Truck, "participant:vehicle:truck"),
    (VehicleClass::Bus, "participant:vehicle:bus"),
    (VehicleClass::Taxi, "participant:vehicle:taxi"),
    (VehicleClass::Motorcycle, "participant:vehicle:motorcycle"),
    (VehicleClass::Emergency, "participant:vehicle:emergency"),
];
/// Those that are no motor vehicles. Lanelet2 has one word for all that runs on rails.
const OTHERS: &[(&[VehicleClass], &str)] = &[
    (&[VehicleClass::Bicycle], "participant:bicycle"),
    (&[VehicleClass::Pedestrian], "participant:pedestrian"),
    (&[VehicleClass::Tram, VehicleClass::Train], "participant:train"),
];
/// Motor vehicles for which it has no word.
const UNKNOWN: &[VehicleClass] = &[
    VehicleClass::Delivery,
    VehicleClass::Hov,
    VehicleClass::Autonomous,
    VehicleClass::Through,
    VehicleClass::Simulator,
];

/// A number in as few digits as its value needs, to `digits` behind the point.
pub(super) fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = if digits > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A speed `[m/s]` as Lanelet2 has it, in km/h without a unit.
pub(super) fn speed(value: f64) -> String {
    number(value * KM_PER_HOUR, 2)
}

/// The tags of a lanelet.
pub(super) fn lanelet<'a>(
    one: &Lanelet<'a>,
    stretch: &Stretch<'a>,
    report: &mut Report,
) -> Vec<Tag<'a>> {
    let (from, to) = stretch.piece(one.piece).unwrap_or((0.0, 0.0));
    let middle = 0.5 * (from + to);
    let (lane, node) = (one.lane, one.node);
    let road_type = lane.road().types().take_while(|record| record.s <= middle).last();
    let road_type = road_type.map_or(RoadType::None, |record| record.kind);
    let nonurban = matches!(road_type, RoadType::Rural | RoadType::Motorway);
    let mut tags: Vec<Tag<'a>> = vec![
        ("type", "lanelet".into()),
        ("subtype", subtype(&lane, &node, road_type).into()),
        ("location", if nonurban { "nonurban" } else { "urban" }.into()),
        ("one_way", if one.is_two_way { "no" } else { "yes" }.into()),
    ];
    participants(&node, &mut tags, report);
    let rule = lane.speed_rule_at(middle);
    match rule.max {
        Some(max) if max.is_finite() => tags.push(("speed_limit", speed(max).into())),
        Some(_) => report.unsaid("no speed limit: the lanelet says nothing"),
        None => {}
    }
    if lane.road().junction().is_some() && node.allows(VehicleClass::PassengerCar) {
        tags.push(("turn_direction", turn(&lane).into()));
    }
    tags.push(("lane_key", lane.key().to_string().into()));
    tags.push(("s_from", number(from, 6).into()));
    tags.push(("s_to", number(to, 6).into()));
    tags
}

/// Where the movement through a lane of a junction leads. Turning back is a turn to the side of the oncoming traffic.
fn turn(lane: &Lane<'_>) -> &'static str {
    match lane.turn() {
        Turn::Left => "left",
        Turn::Straight => "straight",
        Turn::Right => "right",
        Turn::Back if lane.road().is_left_hand_traffic() => "right",
        Turn::Back => "left",
    }
}

fn subtype(lane: &Lane<'_>, node: &LaneNode<'_>, road_type: RoadType) -> &'static str {
    let motorway = road_type == RoadType::Motorway;
    match lane.kind() {
        LaneType::Bus | LaneType::Taxi => "bus_lane",
        LaneType::Biking => "bicycle_lane",
        LaneType::Sidewalk | LaneType::Walking => "walkway",
        LaneType::Shared => "shared_walkway",
        LaneType::Stop | LaneType::Shoulder | LaneType::Border | LaneType::Restricted
            if !node.allows(VehicleClass::PassengerCar) =>
        {
            "emergency_lane"
        }
        _ if road_type == RoadType::TownPlayStreet => "play_street",
        _ if motorway => "highway",
        _ => "road",
    }
}

/// Who may use a lanelet. All motor vehicles are one word; Lanelet2 wants either that or each by itself.
fn participants(node: &LaneNode<'_>, tags: &mut Vec<Tag<'_>>, report: &mut Report) {
    let allows = |class: &VehicleClass| node.allows(*class);
    let known = PARTICIPANTS.iter().filter(|(class, _)| allows(class)).count();
    if known == PARTICIPANTS.len() {
        tags.push(("participant:vehicle", "yes".into()));
    } else {
        let own = PARTICIPANTS.iter().filter(|(class, _)| allows(class));
        tags.extend(own.map(|(_, name)| (*name, "yes".into())));
    }
    let others = OTHERS.iter().filter(|(classes, _)| classes.iter().any(allows));
    tags.extend(others.map(|(_, name)| (*name, "yes".into())));
    let unknown = UNKNOWN.iter().filter(|class| allows(class)).count();
    if unknown != 0 && unknown != UNKNOWN.len() || (unknown == 0) != (known != PARTICIPANTS.len()) {
        report.unsaid("who may use a lane: delivery, HOV, autonomous, through traffic, simulators");
    }
}

/// The tags of the border of a lane along a piece. Its key names it for everybody: a border is the outer one of one lane, or the line of lane 0.
pub(super) fn border(
    network: &Network<'_>,
    stretch: &Stretch<'_>,
    border: u32,
    piece: u32,
) -> Vec<Tag<'static>> {
    let (from, to) = stretch.piece(piece).unwrap_or((0.0, 0.0));
    let middle = 0.5 * (from + to);
    let Some(lane) = stretch.lanes.get(border as usize) else { return Vec::new() };
    let mark = lane.road_mark_at(middle);
    let [left, right] = beside(stretch, border);
    let lanelet =
        |lane: &Option<&Lane<'_>>| lane.is_some_and(|lane| network.number(lane, piece).is_some());
    let is_edge = !lanelet(&left) || !lanelet(&right);
    let (kind, subtype) = kind(lane, mark.as_ref(), is_edge);
    let mut tags: Vec<Tag<'static>> =
        vec![("type", kind.into()), ("lane_key", lane.key().to_string().into())];
    tags.extend(subtype.map(|subtype| ("subtype", subtype.into())));
    let color = mark.as_ref().map_or(RoadMarkColor::NotGiven, RoadMark::color);
    if !matches!(color, RoadMarkColor::NotGiven | RoadMarkColor::Standard | RoadMarkColor::Unknown)
    {
        tags.push(("color", color.name().into()));
    }
    if let (Some(left), Some(right), false) = (left, right, is_edge) {
        tags.extend(lane_change(left, right, middle));
    }
    tags
}

/// The lanes to the left and right of a border in the reference line's direction.
fn beside<'s, 'a>(stretch: &'s Stretch<'a>, border: u32) -> [Option<&'s Lane<'a>>; 2] {
    let at = border as usize;
    let number = stretch.lanes.get(at).map_or(0, Lane::number);
    let left = if number < 0 { Some(at) } else { at.checked_sub(1) };
    let right = if number > 0 { at } else { at + 1 };
    [left, Some(right)].map(|at| at.and_then(|at| stretch.lanes.get(at)))
}

/// Type and subtype of a border with a mark.
fn kind(
    lane: &Lane<'_>,
    mark: Option<&RoadMark<'_>>,
    is_edge: bool,
) -> (&'static str, Option<&'static str>) {
    let bold = mark.is_some_and(|mark| mark.weight() == RoadMarkWeight::Bold);
    let line = if bold { "line_thick" } else { "line_thin" };
    // The line nearer to lane 0 is named first, which is the left one on the right side.
    let two = |first: &'static str, second: &'static str| {
        Some(if lane.number() > 0 { second } else { first })
    };
    match mark.map_or(RoadMarkKind::None, RoadMark::kind) {
        RoadMarkKind::Solid | RoadMarkKind::Custom => (line, Some("solid")),
        RoadMarkKind::Broken | RoadMarkKind::BottsDots => (line, Some("dashed")),
        RoadMarkKind::SolidSolid => (line, Some("solid_solid")),
        RoadMarkKind::BrokenBroken => (line, Some("dashed")),
        RoadMarkKind::SolidBroken => (line, two("solid_dashed", "dashed_solid")),
        RoadMarkKind::BrokenSolid => (line, two("dashed_solid", "solid_dashed")),
        RoadMarkKind::Curb => ("curbstone", Some("high")),
        RoadMarkKind::Grass | RoadMarkKind::Edge => ("road_border", None),
        _ if is_edge => ("road_border", None),
        _ => ("virtual", None),
    }
}

/// Which changes of lane are allowed across a border between two lanes. Lanelet2 reads one of these tags only.
fn lane_change(left: &Lane<'_>, right: &Lane<'_>, s: f64) -> Option<Tag<'static>> {
    let leads = |from: &Lane<'_>, to: &Lane<'_>, to_left: bool| {
        from.nodes().any(|node| {
            let SRange { low, high } = node.s_range();
            let side =
                if node.is_forward() == to_left { node.change_left() } else { node.change_right() };
            let target = side.and_then(|node| node.lane());
            (low..=high).contains(&s) && target.is_some_and(|lane| lane.lane_id() == to.lane_id())
        })
    };
    let name = match (leads(right, left, true), leads(left, right, false)) {
        (true, true) => return Some(("lane_change", "yes".into())),
        (false, false) => return Some(("lane_change", "no".into())),
        (true, false) => "lane_change:left",
        (false, true) => "lane_change:right",
    };
    Some((name, "yes".into()))
}
