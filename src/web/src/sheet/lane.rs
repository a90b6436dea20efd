//! What is known of a lane.

use super::{Kind, Link, Sheet, Words, metres, speed};
use mapd_query::rules::Basis;
use mapd_query::view::View;
use mapd_query::vocabulary::VehicleClass;
use mapd_query::{Lane, Map};

pub(super) fn sheet(view: View<'_>, lane: &Lane<'_>) -> Sheet {
    let map = view.map();
    let link = Link { kind: Kind::Lane, row: lane.lane_id().row() };
    let mut sheet = Sheet::new(link, format!("Lane {}", lane.key()));
    shape(lane, &mut sheet);
    today(view, lane, &mut sheet);
    neighbours(map, lane, &mut sheet);
    traffic(lane, &mut sheet);
    things(map, lane, &mut sheet);
    for point in lane.center_line().positions() {
        sheet.reach(point);
    }
    sheet
}

fn shape(lane: &Lane<'_>, sheet: &mut Sheet) {
    let (section, road) = (lane.section(), lane.road());
    let (from, to) = (section.s_start(), section.s_end());
    sheet.say("type", lane.kind().name());
    sheet.add("road", [Words::from(&road)]);
    sheet.add("junction", road.junction().iter().map(Words::from));
    sheet.say("s", format!("{from:.3} … {to:.3} m"));
    sheet.say("length", metres(lane.length_between(from, to)));
    sheet.say("width", format!("{:.2} … {:.2} m", lane.width_at(from), lane.width_at(to)));
    let way = match (lane.is_bidirectional(), lane.is_forward()) {
        (true, _) => "both ways",
        (false, true) => "with rising s",
        (false, false) => "with falling s",
    };
    sheet.say("travelled", way);
    if lane.is_temporary() {
        sheet.say("layer", "temporary");
    }
}

/// What an overlay says of it now.
fn today(view: View<'_>, lane: &Lane<'_>, sheet: &mut Sheet) {
    let own = view.restrictions().filter(|one| one.lane == lane.lane_id());
    let told = own.map(|one| {
        Words::from(one.entry).with(&format!(", s {:.2} … {:.2} m", one.s_from, one.s_to))
    });
    sheet.add("today", told);
}

fn neighbours(map: Map<'_>, lane: &Lane<'_>, sheet: &mut Sheet) {
    let lanes = |ids: &mut dyn Iterator<Item = mapd_query::LaneId>| {
        ids.filter_map(|id| map.lane(id).ok()).map(|lane| Words::from(&lane)).collect::<Vec<_>>()
    };
    sheet.add("leads to", lanes(&mut lane.successors()));
    sheet.add("comes from", lanes(&mut lane.predecessors()));
    let node = lane.nodes().find(|node| node.is_forward() == lane.is_forward());
    let may = |may: bool| if may { " (change allowed)" } else { "" };
    let left = node.as_ref().is_some_and(|node| node.change_left().is_some());
    let right = node.as_ref().is_some_and(|node| node.change_right().is_some());
    sheet.add("left of it", lane.left().iter().map(|one| Words::from(one).with(may(left))));
    sheet.add("right of it", lane.right().iter().map(|one| Words::from(one).with(may(right))));
}

fn traffic(lane: &Lane<'_>, sheet: &mut Sheet) {
    let section = lane.section();
    let middle = 0.5 * (section.s_start() + section.s_end());
    let rule = lane.speed_rule_at(middle);
    let limit = rule.max.map_or_else(|| "unknown".to_owned(), speed);
    sheet.say("speed limit", format!("{limit}, {}", rule.origin.name()));
    let classes: Vec<&str> = lane.access_at(middle).map(VehicleClass::name).collect();
    sheet.say("open to", if classes.is_empty() { "nobody".to_owned() } else { classes.join(", ") });
    let marks = lane.road_marks().map(|mark| Words {
        text: format!(
            "{} {} from s {:.2} m, {:.2} m wide",
            mark.color().name(),
            mark.kind().name(),
            mark.s(),
            mark.width_or_default()
        ),
        link: None,
    });
    sheet.add("marks of outer border", marks);
    if lane.road().junction().is_none() {
        return;
    }
    sheet.say("turn", format!("{:?}", lane.turn()).to_lowercase());
    let yields = lane
        .yields_to()
        .map(|one| Words::from(&one.lane).with(&format!(" ({})", one.reason.name())));
    sheet.add("gives way to", yields);
    let rights = lane.right_of_way().filter_map(|right| {
        let basis = match right.basis() {
            Basis::Written => "the file says so",
            Basis::Rule => "a rule of the road would say so",
            _ => "nothing decides",
        };
        let words = format!(" {}, {}: {basis}", right.relation().name(), right.reason().name());
        Some(Words::from(&right.other()?).with(&words))
    });
    sheet.add("meets", rights);
    sheet.add("lights", lane.movement_lights().map(|one| Words::from(&one.signal())));
}

fn things(map: Map<'_>, lane: &Lane<'_>, sheet: &mut Sheet) {
    let signals = lane
        .signals()
        .map(|one| Words::from(&one.signal()).with(&format!(" at s {:.2} m", one.s_on(lane))));
    sheet.add("signals", signals);
    let lines = lane.lines_to_stop_at().map(|line| Words {
        text: format!("{} at s {:.2} m", line.class.name(), line.s),
        link: None,
    });
    sheet.add("stops at", lines);
    let crossings = lane.crossings().map(|line| Words {
        text: format!("{} at s {:.2} m", line.class.name(), line.s),
        link: None,
    });
    sheet.add("crossed by", crossings);
    let parts = map.quarantined().enumerate();
    let own = parts.filter(|(_, part)| part.owner() == lane.road().id());
    sheet.add("left out of the road", own.map(|(i, part)| Words::part(i, part.kind(), part.id())));
}
