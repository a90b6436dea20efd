//! What is known of a lane.

use super::{Kind, Link, Sheet, Words, metres, speed};
use mapd_query::objects::Structure;
use mapd_query::roads::{LaneHeight, LaneVisibility, Material};
use mapd_query::rules::Basis;
use mapd_query::view::View;
use mapd_query::vocabulary::{RoadMarkKind, VehicleClass};
use mapd_query::{Lane, Map, SRange};

pub(super) fn sheet(view: View<'_>, lane: &Lane<'_>) -> Sheet {
    let map = view.map();
    let link = Link { kind: Kind::Lane, row: lane.lane_id().row() };
    let mut sheet = Sheet::new(link, format!("Lane {}", lane.key()));
    shape(lane, &mut sheet);
    today(view, lane, &mut sheet);
    neighbours(map, lane, &mut sheet);
    traffic(lane, &mut sheet);
    things(map, lane, &mut sheet);
    ground(lane, &mut sheet);
    written(lane, &mut sheet);
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

/// What is said of a lane piece by piece: those in a row that say the same are one.
fn along(said: impl Iterator<Item = ([f64; 2], String)>) -> Vec<Words> {
    let mut pieces: Vec<([f64; 2], String)> = Vec::new();
    for ([low, high], text) in said {
        match pieces.last_mut().filter(|(_, last)| *last == text) {
            Some(([_, end], _)) => *end = high,
            None => pieces.push(([low, high], text)),
        }
    }
    let is_one = pieces.len() == 1;
    let words = |([low, high], text): ([f64; 2], String)| Words {
        text: if is_one { text } else { format!("{text}, s {low:.2} … {high:.2} m") },
        link: None,
    };
    pieces.into_iter().map(words).collect()
}

fn traffic(lane: &Lane<'_>, sheet: &mut Sheet) {
    let limits = lane.speed_rules().map(|own| {
        let origin = own.rule.origin.name();
        let text = match (own.rule.max, own.lowest) {
            (Some(max), _) => format!("{}, {origin}", speed(max)),
            (None, Some(lowest)) => format!("{origin}, at least {}", speed(lowest)),
            (None, None) => origin.to_owned(),
        };
        ([own.s.low, own.s.high], text)
    });
    sheet.add("speed limit", along(limits));
    let (from, to) = (lane.section().s_start(), lane.section().s_end());
    let nodes = lane.nodes().flat_map(|node| [node.s_range().low, node.s_range().high]);
    let mut cuts: Vec<f64> = nodes.filter(|s| from < *s && *s < to).chain([from, to]).collect();
    cuts.sort_by(f64::total_cmp);
    let pieces = cuts.iter().zip(cuts.iter().skip(1)).filter(|(low, high)| low < high);
    let classes = pieces.map(|(low, high)| {
        let open = lane.access_at(0.5 * (low + high)).map(VehicleClass::name);
        let open = open.collect::<Vec<_>>().join(", ");
        ([*low, *high], if open.is_empty() { "nobody".to_owned() } else { open })
    });
    sheet.add("open to", along(classes));
    let marks = lane.road_marks().map(|mark| {
        let (color, kind) = (mark.color().name(), mark.kind());
        let width = mark.width_or_default();
        plain(match kind {
            RoadMarkKind::None => format!("none from s {:.2} m", mark.s()),
            _ => format!("{color} {} from s {:.2} m, {width:.2} m wide", kind.name(), mark.s()),
        })
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
            _ if Basis::of(right.reason()) == Basis::Rule => "a rule of the road would have to say",
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
    let objects = lane.objects().filter_map(|one| {
        let SRange { low, high } = one.s_range();
        let beside = if one.distance() > 0.0 {
            format!(", {:.2} m beside", one.distance())
        } else {
            String::new()
        };
        Some(Words::from(&one.object()?).with(&format!(" s {low:.2} … {high:.2} m{beside}")))
    });
    sheet.add("objects", objects);
    let parts = map.quarantined().enumerate();
    let own = parts.filter(|(_, part)| part.owner() == lane.road().id());
    sheet.add("left out of the road", own.map(|(i, part)| Words::part(i, part.kind(), part.id())));
}

/// What it lies on, and in.
fn ground(lane: &Lane<'_>, sheet: &mut Sheet) {
    let (from, to) = (lane.section().s_start(), lane.section().s_end());
    sheet.add(
        "surface",
        materials(lane).iter().rev().map(|one| {
            let given = |name: &str, value: Option<f64>| {
                value.map_or_else(String::new, |value| format!(", {name} {value}"))
            };
            let (friction, roughness) =
                (given("friction", one.friction), given("roughness", one.roughness));
            plain(format!("{} from s {:.2} m{friction}{roughness}", one.surface, one.s))
        }),
    );
    let [LaneHeight { inner: a, outer: b }, LaneHeight { inner: c, outer: d }] =
        [from, to].map(|s| lane.height_at(s));
    if [a, b, c, d] != [0.0; 4] {
        sheet.say(
            "above the road",
            format!("inner edge {a:.2} … {c:.2} m, outer edge {b:.2} … {d:.2} m"),
        );
    }
    let number = lane.number();
    let is_own = |structure: &Structure<'_>| {
        let SRange { low, high } = structure.s_range();
        let mut ranges = structure.validities();
        let is_for =
            ranges.len() == 0 || ranges.any(|range| (range.from..=range.to).contains(&number));
        is_for && low <= to && from <= high
    };
    let structures = lane.road().structures().filter(is_own).map(|one| {
        let SRange { low, high } = one.s_range();
        let named = [one.kind().name(), one.id(), one.name(), one.type_name()];
        let named: Vec<&str> = named.into_iter().filter(|name| !name.is_empty()).collect();
        plain(format!("{} s {low:.2} … {high:.2} m", named.join(" ")))
    });
    sheet.add("tunnel or bridge", structures);
}

/// `material` records that hold somewhere on the lane, the last one first.
fn materials<'a>(lane: &Lane<'a>) -> Vec<Material<'a>> {
    let from = lane.section().s_start();
    let at = |s: f64| lane.material_at(s);
    let before = |one: &Material<'a>| at(one.s.next_down()).filter(|_| one.s > from);
    std::iter::successors(at(lane.section().s_end()), before).collect()
}

/// What the file says of it besides.
fn written(lane: &Lane<'_>, sheet: &mut Sheet) {
    sheet.add(
        "sees",
        lane.visibilities().map(|one| {
            let LaneVisibility { s, forward, back, left, right } = one;
            let ways = [("ahead", forward), ("behind", back), ("left", left), ("right", right)];
            let ways =
                ways.iter().filter_map(|(name, far)| Some(format!("{:.0} m {name}", (*far)?)));
            plain(format!("{} from s {s:.2} m", ways.collect::<Vec<_>>().join(", ")))
        }),
    );
    sheet.add(
        "rules",
        lane.rules().map(|one| plain(format!("{} from s {:.2} m", one.value, one.s))),
    );
    sheet.add(
        "written besides",
        lane.annotations().map(|one| {
            let parts = [one.path(), one.name(), one.value(), one.text()];
            let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
            plain(parts.join(" "))
        }),
    );
}

fn plain(text: String) -> Words {
    Words { text, link: None }
}
