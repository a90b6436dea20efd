//! What is known of roads, junctions, signals, objects, and parts that are left out.

use super::{Kind, Link, Sheet, Words, metres};
use mapd_query::Region;
use mapd_query::document::Quarantined;
use mapd_query::document::SourcePosition;
use mapd_query::glam::DVec3;
use mapd_query::objects::Object;
use mapd_query::rules::Turn;
use mapd_query::signals::Signal;
use mapd_query::signals::WrittenValue;
use mapd_query::view::View;
use mapd_query::{Junction, Road};
use std::f64::consts::PI;

/// `line 12, column 5` of the document.
fn place_in_file(SourcePosition { line, column }: SourcePosition) -> String {
    format!("line {line}, column {column}")
}

fn degrees(angle: f64) -> String {
    format!("{:.1}° ({angle:.4} rad)", angle * 180.0 / PI)
}

fn say(text: impl Into<String>) -> Words {
    Words { text: text.into(), link: None }
}

pub(super) fn road(road: &Road<'_>) -> Sheet {
    let link = Link { kind: Kind::Road, row: road.road_id().row() };
    let mut sheet = Sheet::new(link, format!("Road {}", road.id()));
    sheet.say("name", road.name());
    sheet.say("length", metres(road.length()));
    sheet.say("traffic", if road.is_left_hand_traffic() { "left-hand" } else { "right-hand" });
    sheet.add("junction", road.junction().iter().map(Words::from));
    sheet.add(
        "types",
        road.types().map(|one| say(format!("{} from s {:.2} m", one.kind.name(), one.s))),
    );
    sheet.say("sections", road.sections().count().to_string());
    let lanes = road.sections().flat_map(|section| section.lanes());
    sheet.add(
        "lanes",
        lanes
            .filter(|lane| lane.number() != 0)
            .map(|lane| Words::from(&lane).with(&format!(" {}", lane.kind().name()))),
    );
    sheet.say("in the file", place_in_file(road.source_position()));
    for section in road.sections() {
        if let Some(center) = section.lane(0) {
            center.border().positions().for_each(|point| sheet.reach(point));
        }
    }
    sheet
}

pub(super) fn junction(junction: &Junction<'_>) -> Sheet {
    let link = Link { kind: Kind::Junction, row: junction.junction_id().row() };
    let mut sheet = Sheet::new(link, format!("Junction {}", junction.id()));
    sheet.say("name", junction.name());
    let mut roads: Vec<Road<'_>> =
        junction.connections().filter_map(|one| one.connecting_road()).collect();
    roads.dedup_by_key(|road| road.road_id());
    sheet.add("connecting roads", roads.iter().map(Words::from));
    for road in &roads {
        for center in road.sections().filter_map(|section| section.lane(0)) {
            center.border().positions().for_each(|point| sheet.reach(point));
        }
    }
    sheet
}

pub(super) fn signal(view: View<'_>, signal: &Signal<'_>) -> Sheet {
    let link = Link { kind: Kind::Signal, row: signal.signal_id().row() };
    let mut sheet = Sheet::new(link, format!("Signal {}", signal.id()));
    sheet.say("meaning", signal.class().name());
    let off = view.signal_out_of_service(signal.signal_id()).ok().flatten();
    sheet.add("today", off.map(Words::from));
    sheet.say("name", signal.name());
    sheet.say("code", signal.code().join(" ").trim().to_owned());
    sheet.say("text", signal.shown_text());
    if let Some(WrittenValue { value, unit }) = signal.written_value() {
        sheet.say("value", format!("{value} {unit}"));
    }
    if let Some(light) = signal.light() {
        let turns = [(Turn::Left, "left"), (Turn::Straight, "straight"), (Turn::Right, "right")];
        let turns = turns.iter().filter(|(turn, _)| light.governs(*turn));
        sheet.say("light for", turns.map(|(_, name)| *name).collect::<Vec<_>>().join(", "));
    }
    let [s, t, z_offset, _] = signal.track();
    sheet.add("road", signal.road().iter().map(Words::from));
    sheet.say("place", format!("s {s:.2} m, t {t:.2} m, {z_offset:.2} m above the road"));
    sheet.say("facing", degrees(signal.facing()));
    sheet.say("orientation", signal.orientation().name());
    let size = |name: &str, size: Option<f64>| size.map(|size| say(format!("{name} {size:.2} m")));
    let [width, height, length] = signal.size();
    sheet.add(
        "size",
        [size("width", width), size("height", height), size("length", length)]
            .into_iter()
            .flatten(),
    );
    let places = signal.places().flat_map(|place| place.lanes());
    sheet.add(
        "for lanes",
        places.filter_map(|one| {
            Some(Words::from(&one.lane()?).with(&format!(" by {}", one.method().name())))
        }),
    );
    sheet.add("stands on", signal.carrier().iter().map(Words::from));
    sheet.say("in the file", place_in_file(signal.source_position()));
    sheet.reach(signal.position());
    sheet
}

pub(super) fn object(object: &Object<'_>) -> Sheet {
    let link = Link { kind: Kind::Object, row: object.object_id().row() };
    let mut sheet = Sheet::new(link, format!("Object {}", object.id()));
    sheet.say("meaning", object.class().name());
    sheet.say("name", object.name());
    sheet.say("type", [object.type_name(), object.subtype()].join(" ").trim().to_owned());
    sheet.add("road", object.road().iter().map(Words::from));
    sheet.add("junction", object.junction().iter().map(Words::from));
    sheet.say("place", format!("s {:.2} m, t {:.2} m", object.s(), object.t()));
    sheet.say("heading", degrees(object.heading()));
    let sizes = [
        ("length", object.length()),
        ("width", object.width()),
        ("height", object.height()),
        ("radius", object.radius()),
    ];
    let known = sizes.into_iter().filter(|(_, size)| *size > 0.0);
    sheet.add("size", known.map(|(name, size)| say(format!("{name} {size:.2} m"))));
    let count = object.placements().count();
    if count > 1 {
        sheet.say("places", count.to_string());
    }
    sheet.add("lanes", object.lanes().filter_map(|one| Some(Words::from(&one.lane()?))));
    sheet.say("in the file", place_in_file(object.source_position()));
    object.placements().for_each(|place| sheet.reach(place.position()));
    sheet
}

pub(super) fn quarantine(part: &Quarantined<'_>, about: Link) -> Sheet {
    let mut sheet = Sheet::new(about, format!("Left out: {} {}", part.kind().name(), part.id()));
    sheet.say("why", part.message());
    sheet.say("rule", part.rule());
    if part.owner() != part.id() || part.owner_kind() != part.kind() {
        sheet.say("belongs to", format!("{} {}", part.owner_kind().name(), part.owner()));
    }
    let file = part.source_file().map_or(String::new(), |file| format!(" of {file}"));
    sheet.say("in the file", place_in_file(part.source_position()) + &file);
    if part.is_reference_line() {
        sheet.say("kept", "its reference line, without lanes");
    }
    if let Some(Region { low, high }) = part.extent() {
        sheet.reach(low.extend(0.0));
        sheet.reach(DVec3::new(high.x, high.y, 0.0));
    }
    sheet
}
