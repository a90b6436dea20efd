//! The elements: attributes into fields, children by name. Unknown ones are passed over whole.

use crate::attributes::Attributes;
use crate::cursor::Cursor;
use crate::finding::{Severity, Span};
use crate::names::{LaneKind, RoadTypeKind};
use crate::rule_ids;
use crate::types::*;
use std::io::BufRead;

/// Values of `@junction` that mean none.
const NO_JUNCTION: &str = "-1";
/// Minor revisions that are known.
const KNOWN_MINORS: std::ops::RangeInclusive<u16> = 1..=9;

pub(crate) fn header<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Header {
    let context = &mut cursor.context();
    let mut text = |name| a.text(name, context).map(|(text, _)| text).unwrap_or_default();
    let mut header = Header {
        name: text("name"),
        version: text("version"),
        date: text("date"),
        vendor: text("vendor"),
        span: a.span,
        ..Header::default()
    };
    let mut revision = |name| a.optional_number(name, context).map(|n| n as u16);
    (header.rev_major, header.rev_minor) = (revision("revMajor"), revision("revMinor"));
    let mut bound = |name| a.optional_number(name, context);
    (header.north, header.south) = (bound("north"), bound("south"));
    (header.east, header.west) = (bound("east"), bound("west"));
    let message = match (header.rev_major, header.rev_minor) {
        (Some(1), Some(minor)) if KNOWN_MINORS.contains(&minor) => None,
        (Some(major), Some(minor)) => {
            Some(format!("expected revision 1.4 to 1.9, found {major}.{minor}; read as the newest"))
        }
        _ => Some("expected revMajor and revMinor, found none; read as the newest".to_owned()),
    };
    if let Some(message) = message {
        context.add(rule_ids::VERSION, Severity::Warning, a.span, message);
    }
    cursor.children(|cursor, name, a| match name {
        "geoReference" => {
            let text = cursor.text();
            header.geo_reference = Some(text.trim().to_owned()).filter(|text| !text.is_empty());
        }
        "offset" => {
            let numbers = a.numbers(["x", "y", "z", "hdg"], &mut cursor.context());
            header.offset =
                numbers.map(|[x, y, z, hdg]| HeaderOffset { x, y, z, hdg, span: a.span });
            cursor.skip();
        }
        _ => cursor.skip(),
    });
    header
}

pub(crate) fn road<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<Road> {
    let context = &mut cursor.context();
    let id = a.required_text("id", context);
    let length = a.number("length", context);
    let mut road = Road { span: a.span, length: length.unwrap_or(0.0), ..Road::default() };
    road.name = a.text("name", context).map(|(text, _)| text).unwrap_or_default();
    road.junction = a
        .optional_text("junction", context)
        .map(|(text, _)| text)
        .filter(|text| text != NO_JUNCTION);
    let rule = |word: &str| match word {
        "RHT" => Some(TrafficRule::RightHand),
        "LHT" => Some(TrafficRule::LeftHand),
        _ => None,
    };
    road.rule = a.word("rule", rule, context).unwrap_or_default();
    if length.is_some_and(|length| length < 0.0) {
        let message = "expected a length that is not negative".to_owned();
        context.add(rule_ids::VALUE, Severity::Error, a.span, message);
    }
    road.id = id.clone().unwrap_or_default();
    cursor.name_element(format!("road[@id={}]", road.id));
    let mut layers = 0;
    cursor.children(|cursor, name, a| match name {
        "link" => cursor.children(|cursor, name, a| {
            match name {
                "predecessor" => road.predecessor = road_link(cursor, &a),
                "successor" => road.successor = road_link(cursor, &a),
                _ => {}
            }
            cursor.skip();
        }),
        "type" => road.types.extend(road_type(cursor, &a)),
        "planView" => cursor.children(|cursor, name, a| match name {
            "geometry" => road.plan_view.extend(geometry(cursor, &a)),
            _ => cursor.skip(),
        }),
        "elevationProfile" => cursor.children(|cursor, name, a| {
            if name == "elevation" {
                road.elevations.extend(cubic(cursor, &a, "s"));
            }
            cursor.skip();
        }),
        "lateralProfile" => cursor.children(|cursor, name, a| {
            match name {
                "superelevation" => road.superelevations.extend(cubic(cursor, &a, "s")),
                "shape" => note(&mut road.unsupported, "lateralProfile/shape"),
                "crossfall" => note(&mut road.unsupported, "lateralProfile/crossfall"),
                "crossSectionSurface" => {
                    note(&mut road.unsupported, "lateralProfile/crossSectionSurface")
                }
                _ => {}
            }
            cursor.skip();
        }),
        "lanes" => {
            let temporary = a
                .text("layer", &mut cursor.context())
                .is_some_and(|(layer, _)| layer == "temporary");
            if temporary || layers > 0 {
                let message =
                    "lanes of another layer are not built yet; the first permanent ones are"
                        .to_owned();
                cursor.add(rule_ids::LAYER, Severity::Info, a.span, message);
                return cursor.skip();
            }
            layers += 1;
            lanes(cursor, &mut road);
        }
        _ => cursor.skip(),
    });
    for (missing, element) in [
        (road.plan_view.is_empty(), "planView/geometry"),
        (road.sections.is_empty(), "lanes/laneSection"),
    ] {
        if missing && !cursor.is_over() {
            let message = format!("expected the element {element}, found none that can be used");
            let path = format!("OpenDRIVE/road[@id={}]", road.id);
            let mut context = crate::attributes::Context { findings: &mut cursor.findings, path };
            context.add(rule_ids::ELEMENT, Severity::Error, road.span, message);
        }
    }
    // Without id or length there is nothing to hang the road on; the errors say so.
    (id.is_some() && length.is_some_and(|length| length >= 0.0)).then_some(road)
}

fn note(list: &mut Vec<&'static str>, name: &'static str) {
    if !list.contains(&name) {
        list.push(name);
    }
}

fn contact_point(word: &str) -> Option<ContactPoint> {
    match word {
        "start" => Some(ContactPoint::Start),
        "end" => Some(ContactPoint::End),
        _ => None,
    }
}

fn road_link<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<RoadLink> {
    let context = &mut cursor.context();
    let element = |word: &str| match word {
        "road" => Some(LinkElement::Road),
        "junction" => Some(LinkElement::Junction),
        _ => None,
    };
    let direction = |word: &str| match word {
        "+" => Some(Direction::Plus),
        "-" => Some(Direction::Minus),
        _ => None,
    };
    Some(RoadLink {
        // Files without the type link roads.
        element_type: a.word("elementType", element, context).unwrap_or(LinkElement::Road),
        element_id: a.optional_text("elementId", context)?.0,
        contact_point: a.word("contactPoint", contact_point, context),
        element_s: a.optional_number("elementS", context),
        element_dir: a.word("elementDir", direction, context),
        span: a.span,
    })
}

fn road_type<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<RoadType> {
    let context = &mut cursor.context();
    let s = a.number("s", context);
    let known = |word: &str| {
        Some(RoadTypeKind::from_name(word)).filter(|kind| *kind != RoadTypeKind::Other)
    };
    let kind = a.word("type", known, context).unwrap_or(RoadTypeKind::Other);
    let country = a.text("country", context).map(|(text, _)| text).unwrap_or_default();
    let mut record = RoadType { s: s.unwrap_or(0.0), kind, country, speed: None, span: a.span };
    cursor.children(|cursor, name, a| {
        if name == "speed" {
            record.speed = speed(cursor, &a);
        }
        cursor.skip();
    });
    s.map(|_| record)
}

fn speed<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<Speed> {
    let context = &mut cursor.context();
    let unit = |word: &str| match word {
        "m/s" => Some(SpeedUnit::MetersPerSecond),
        "km/h" => Some(SpeedUnit::KilometersPerHour),
        "mph" => Some(SpeedUnit::MilesPerHour),
        _ => None,
    };
    let (text, _) = a.optional_text("max", context)?;
    let max = match text.trim() {
        "no limit" => SpeedMax::NoLimit,
        "undefined" => SpeedMax::Undefined,
        _ => SpeedMax::Value(a.number("max", context)?),
    };
    let unit = a.word("unit", unit, context).unwrap_or(SpeedUnit::MetersPerSecond);
    Some(Speed { max, unit, span: a.span })
}

fn geometry<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<Geometry> {
    let numbers = a.numbers(["s", "x", "y", "hdg", "length"], &mut cursor.context());
    let mut shape = None;
    let mut broken = false;
    cursor.children(|cursor, name, a| {
        if matches!(name, "line" | "arc" | "spiral" | "poly3" | "paramPoly3") {
            let read = self::shape(cursor, name, &a);
            broken |= read.is_none();
            shape = shape.or(read);
        }
        cursor.skip();
    });
    if shape.is_none() && !broken && !cursor.is_over() {
        let message = "expected one of line, arc, spiral, poly3, paramPoly3, found none".to_owned();
        cursor.add(rule_ids::ELEMENT, Severity::Error, a.span, message);
    }
    let ([s, x, y, hdg, length], shape) = (numbers?, shape?);
    Some(Geometry { s, x, y, hdg, length, shape, span: a.span })
}

fn shape<R: BufRead>(cursor: &mut Cursor<R>, name: &str, a: &Attributes) -> Option<GeometryShape> {
    let context = &mut cursor.context();
    Some(match name {
        "line" => GeometryShape::Line,
        "arc" => GeometryShape::Arc { curvature: a.number("curvature", context)? },
        "spiral" => {
            let [curv_start, curv_end] = a.numbers(["curvStart", "curvEnd"], context)?;
            GeometryShape::Spiral { curv_start, curv_end }
        }
        "poly3" => {
            let [x, y, z, w] = a.numbers(["a", "b", "c", "d"], context)?;
            GeometryShape::Poly3 { a: x, b: y, c: z, d: w }
        }
        _ => {
            let [au, bu, cu, du, av, bv, cv, dv] =
                a.numbers(["aU", "bU", "cU", "dU", "aV", "bV", "cV", "dV"], context)?;
            let range = |word: &str| match word {
                "arcLength" => Some(PRange::ArcLength),
                "normalized" => Some(PRange::Normalized),
                _ => None,
            };
            let p_range = a.word("pRange", range, context);
            GeometryShape::ParamPoly3 { au, bu, cu, du, av, bv, cv, dv, p_range }
        }
    })
}

fn cubic<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes, s: &str) -> Option<CubicRecord> {
    let [s, x, y, z, w] = a.numbers([s, "a", "b", "c", "d"], &mut cursor.context())?;
    Some(CubicRecord { s, a: x, b: y, c: z, d: w, span: a.span })
}

fn lanes<R: BufRead>(cursor: &mut Cursor<R>, road: &mut Road) {
    cursor.children(|cursor, name, a| match name {
        "laneOffset" => {
            road.lane_offsets.extend(cubic(cursor, &a, "s"));
            cursor.skip();
        }
        "laneSection" => {
            let s = a.number("s", &mut cursor.context());
            let single_side = a.boolean("singleSide", &mut cursor.context());
            let mut section =
                LaneSection { s: s.unwrap_or(0.0), single_side, lanes: Vec::new(), span: a.span };
            cursor.children(|cursor, name, _| {
                let side = match name {
                    "left" => Side::Left,
                    "center" => Side::Center,
                    "right" => Side::Right,
                    _ => return cursor.skip(),
                };
                cursor.children(|cursor, name, a| match name {
                    "lane" => section.lanes.extend(lane(cursor, &a, side)),
                    _ => cursor.skip(),
                });
            });
            road.sections.extend(s.map(|_| section));
        }
        _ => cursor.skip(),
    });
}

fn lane<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes, side: Side) -> Option<Lane> {
    let context = &mut cursor.context();
    let id = a.integer("id", context);
    let known =
        |word: &str| Some(LaneKind::from_name(word)).filter(|kind| *kind != LaneKind::Other);
    let direction = |word: &str| match word {
        "standard" => Some(LaneDirection::Standard),
        "reversed" => Some(LaneDirection::Reversed),
        "both" => Some(LaneDirection::Both),
        _ => None,
    };
    let mut lane = Lane {
        id: id.unwrap_or(0),
        kind: a.word("type", known, context).unwrap_or(LaneKind::Other),
        level: a.boolean("level", context),
        direction: a.word("direction", direction, context).unwrap_or_default(),
        predecessors: Vec::new(),
        successors: Vec::new(),
        road_marks: Vec::new(),
        accesses: Vec::new(),
        widths: Vec::new(),
        borders: Vec::new(),
        speeds: Vec::new(),
        side,
        span: a.span,
    };
    cursor.children(|cursor, name, a| {
        match name {
            "link" => {
                return cursor.children(|cursor, name, a| {
                    let list = match name {
                        "predecessor" => Some(&mut lane.predecessors),
                        "successor" => Some(&mut lane.successors),
                        _ => None,
                    };
                    if let Some(list) = list {
                        let id = a.integer("id", &mut cursor.context());
                        list.extend(id.map(|id| LinkedLane { id, span: a.span }));
                    }
                    cursor.skip();
                });
            }
            "width" => lane.widths.extend(cubic(cursor, &a, "sOffset")),
            "border" => lane.borders.extend(cubic(cursor, &a, "sOffset")),
            "speed" => {
                let s = a.number("sOffset", &mut cursor.context());
                if let (Some(s), Some(speed)) = (s, speed(cursor, &a)) {
                    lane.speeds.push(LaneSpeed { s, speed, span: a.span });
                }
            }
            "roadMark" => {
                let context = &mut cursor.context();
                let s = a.optional_number("sOffset", context);
                let lane_change = a.word("laneChange", lane_change, context).unwrap_or_default();
                lane.road_marks.extend(s.map(|s| RoadMark { s, lane_change, span: a.span }));
            }
            "access" => {
                let access = lane_access(cursor, &a);
                lane.accesses.extend(access);
                return;
            }
            _ => {}
        }
        cursor.skip();
    });
    id.map(|_| lane)
}

fn lane_change(word: &str) -> Option<LaneChange> {
    match word {
        "increase" => Some(LaneChange::Increase),
        "decrease" => Some(LaneChange::Decrease),
        "both" => Some(LaneChange::Both),
        "none" => Some(LaneChange::None),
        _ => None,
    }
}

fn lane_access<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<LaneAccess> {
    let context = &mut cursor.context();
    let s = a.optional_number("sOffset", context);
    let rule = |word: &str| match word {
        "allow" => Some(true),
        "deny" => Some(false),
        _ => None,
    };
    let allow = a.word("rule", rule, context).unwrap_or(false);
    let mut restrictions: Vec<String> =
        a.optional_text("restriction", context).map(|(text, _)| text).into_iter().collect();
    cursor.children(|cursor, name, a| {
        if name == "restriction" {
            let kind = a.optional_text("type", &mut cursor.context());
            restrictions.extend(kind.map(|(text, _)| text));
        }
        cursor.skip();
    });
    s.map(|s| LaneAccess { s, allow, restrictions, span: a.span })
}

pub(crate) fn junction<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Option<Junction> {
    let context = &mut cursor.context();
    let id = a.required_text("id", context);
    let kind = |word: &str| match word {
        "default" => Some(JunctionKind::Default),
        "direct" => Some(JunctionKind::Direct),
        "virtual" => Some(JunctionKind::Virtual),
        "crossing" => Some(JunctionKind::Crossing),
        _ => None,
    };
    let mut junction = Junction {
        name: a.text("name", context).map(|(text, _)| text).unwrap_or_default(),
        kind: a.word("type", kind, context).unwrap_or_default(),
        id: id.clone().unwrap_or_default(),
        connections: Vec::new(),
        span: a.span,
    };
    cursor.name_element(format!("junction[@id={}]", junction.id));
    cursor.children(|cursor, name, a| match name {
        "connection" => {
            let connection = connection(cursor, &a);
            junction.connections.push(connection);
        }
        _ => cursor.skip(),
    });
    id.map(|_| junction)
}

fn connection<R: BufRead>(cursor: &mut Cursor<R>, a: &Attributes) -> Connection {
    let context = &mut cursor.context();
    let text = |name, context: &mut crate::attributes::Context<'_>| {
        a.optional_text(name, context).map(|(text, _): (String, Span)| text)
    };
    let mut connection = Connection {
        id: text("id", context).unwrap_or_default(),
        incoming_road: text("incomingRoad", context).unwrap_or_default(),
        connecting_road: text("connectingRoad", context),
        linked_road: text("linkedRoad", context),
        contact_point: a.word("contactPoint", contact_point, context),
        lane_links: Vec::new(),
        span: a.span,
    };
    cursor.children(|cursor, name, a| {
        if name == "laneLink" {
            let context = &mut cursor.context();
            if let (Some(from), Some(to)) = (a.integer("from", context), a.integer("to", context)) {
                connection.lane_links.push(LaneLink { from, to, span: a.span });
            }
        }
        cursor.skip();
    });
    connection
}
