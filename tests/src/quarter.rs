//! A generated quarter of a town: what a map can have, on half a square kilometre.
//!
//! ```text
//!            ╭──── Station Street, one way ────╮
//!            │                                 ▼
//!   ── Main ─┼── Main Street ──────────────────◯── Lake Road ──
//!     bus    │ lights                          ▲ roundabout
//!     bay    │                                 ╰── exit ──╮
//!   ═════════╪═══ motorway, on a bridge ══════════════════╧════
//!            │ South Street
//! ```

use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

/// Width of a driving lane in town and of one of the motorway `[m]`.
const LANE: f64 = 3.5;
const FAST: f64 = 3.75;
/// Width of a sidewalk, a parking lane and a shoulder `[m]`.
const WALK: f64 = 2.5;
const PARK: f64 = 2.2;
const SHOULDER: f64 = 2.5;
/// Distance from the middle of the crossing at which its arms end `[m]`.
const REACH: f64 = 22.0;
/// The roundabout: its middle `[m]`, the inner radius of its lane, the lane's width, and the angle between an arm and where its ways meet the ring.
const RING: (f64, f64) = (260.0, 0.0);
const RADIUS: f64 = 14.0;
const RING_LANE: f64 = 5.0;
const SPREAD: f64 = 35.0 * PI / 180.0;
/// Where the motorway's carriageways lie `[m]` northwards, how high the bridge is `[m]`, and half its length.
const WESTBOUND: f64 = -160.0;
const EASTBOUND: f64 = -166.0;
const BRIDGE: f64 = 7.0;
const DECK: f64 = 25.0;
/// Where the ramps of the eastbound carriageway meet South Street `[m]` northwards, and where they leave and join it, either way from the bridge.
const RAMPS_AT: f64 = -300.0;
const RAMPS_LEAVE: f64 = 320.0;
/// Length of the slope on either side of the bridge `[m]`.
const SLOPE: f64 = 215.0;

const CROSSING: u32 = 1000;
const EXIT: u32 = 1100;
/// The eastbound carriageway's: where its exit leaves, where its entry joins, and the junction of both with South Street.
const EAST_EXIT: u32 = 1101;
const EAST_ENTRY: u32 = 1102;
const RAMPS: u32 = 1103;
/// Junctions of the roundabout, one for each arm: west, south, east, north.
const ARMS: u32 = 1200;

/// A number to the nanometre: the C library's last digits are its own.
fn n(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Where a line is and where it leads.
#[derive(Clone, Copy)]
struct Pose {
    x: f64,
    y: f64,
    hdg: f64,
}

impl Pose {
    /// The pose so far along this heading and so far to its left `[m]`.
    fn moved(self, ahead: f64, left: f64) -> Self {
        let (sin, cos) = self.hdg.sin_cos();
        let (x, y) = (self.x + ahead * cos - left * sin, self.y + ahead * sin + left * cos);
        Self { x, y, hdg: self.hdg }
    }

    /// Behind a piece whose curvature goes from one value to another, by Simpson's rule.
    fn after(self, length: f64, from: f64, to: f64) -> Self {
        const STEPS: usize = 256;
        let heading = |u: f64| self.hdg + from * u + (to - from) * u * u / (2.0 * length);
        let (mut x, mut y) = (0.0, 0.0);
        for i in 0..=STEPS {
            let weight = match i {
                0 | STEPS => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let (sin, cos) = heading(length * i as f64 / STEPS as f64).sin_cos();
            x += weight * cos;
            y += weight * sin;
        }
        let scale = length / STEPS as f64 / 3.0;
        Self { x: self.x + x * scale, y: self.y + y * scale, hdg: heading(length) }
    }
}

/// A reference line.
struct Line {
    end: Pose,
    length: f64,
    /// Length of the straight piece that it ends with, which is not written yet `[m]`.
    straight: f64,
    text: String,
}

impl Line {
    fn at(start: Pose) -> Self {
        Self { end: start, length: 0.0, straight: 0.0, text: String::new() }
    }

    fn write(&mut self, length: f64, from: f64, to: f64) {
        let Pose { x, y, hdg } = self.end;
        let shape = match (from == 0.0 && to == 0.0, from == to) {
            (true, _) => "<line/>".to_owned(),
            (_, true) => format!("<arc curvature=\"{}\"/>", n(from)),
            _ => format!("<spiral curvStart=\"{}\" curvEnd=\"{}\"/>", n(from), n(to)),
        };
        let _ = writeln!(
            self.text,
            "      <geometry s=\"{}\" x=\"{}\" y=\"{}\" hdg=\"{}\" length=\"{}\">{shape}</geometry>",
            n(self.length),
            n(x),
            n(y),
            n(hdg),
            n(length)
        );
        self.end = self.end.after(length, from, to);
        self.length += length;
    }

    /// Goes on with a curvature from one value to another `[1/m]`.
    fn piece(self, length: f64, from: f64, to: f64) -> Self {
        let mut line = self.ended();
        line.write(length, from, to);
        line
    }

    /// Goes on straight. Straight pieces in a row are one.
    fn straight(mut self, length: f64) -> Self {
        self.straight += length;
        self
    }

    /// Written to its end.
    fn ended(mut self) -> Self {
        let length = std::mem::take(&mut self.straight);
        if length > 1e-6 {
            self.write(length, 0.0, 0.0);
        }
        self
    }

    /// Goes on to a pose: straight, by spiral, arc and spiral, straight. `share` of the turn is each spiral's.
    fn to(self, goal: Pose, share: f64) -> Self {
        let Pose { x, y, hdg } = self.end.moved(self.straight, 0.0);
        let (sin, cos) = hdg.sin_cos();
        let (ahead, left) =
            ((goal.x - x) * cos + (goal.y - y) * sin, (goal.y - y) * cos - (goal.x - x) * sin);
        let turn = (goal.hdg - hdg + 3.0 * PI).rem_euclid(2.0 * PI) - PI;
        if turn.abs() < 1e-9 {
            assert!(left.abs() < 1e-6, "a straight way leads {left} m to the side");
            return self.straight(ahead);
        }
        // From here and from the goal to where both tangents meet.
        let behind = left / turn.sin();
        let before = ahead - behind * turn.cos();
        let tangent = before.min(behind);
        assert!(
            tangent > 1.0,
            "no turn of {turn} rad leads {ahead} m ahead and {left} m to the left"
        );
        // With curvature 1, then scaled.
        let (spiral, arc) = (2.0 * share * turn.abs(), (1.0 - 2.0 * share) * turn.abs());
        let unit = Pose { x: 0.0, y: 0.0, hdg: 0.0 }
            .after(spiral, 0.0, 1.0)
            .after(arc, 1.0, 1.0)
            .after(spiral, 1.0, 0.0);
        let scale = tangent * turn.abs().sin() / unit.y;
        let curvature = turn.signum() / scale;
        self.straight(before - tangent)
            .piece(spiral * scale, 0.0, curvature)
            .piece(arc * scale, curvature, curvature)
            .piece(spiral * scale, curvature, 0.0)
            .straight(behind - tangent)
    }
}

/// Coefficients from some place on: s or sOffset, a, b, c, d.
type Record = [f64; 5];

/// From one value to another, level at both ends.
fn smooth(s: f64, from: f64, to: f64, length: f64) -> Record {
    let rise = to - from;
    [s, from, 0.0, 3.0 * rise / length.powi(2), -2.0 * rise / length.powi(3)]
}

fn constant(s: f64, value: f64) -> Record {
    [s, value, 0.0, 0.0, 0.0]
}

/// Elements of one kind with coefficients.
fn records(element: &str, key: &str, all: &[Record]) -> String {
    let one = |[s, a, b, c, d]: &Record| {
        format!(
            "<{element} {key}=\"{}\" a=\"{}\" b=\"{}\" c=\"{}\" d=\"{}\"/>",
            n(*s),
            n(*a),
            n(*b),
            n(*c),
            n(*d)
        )
    };
    all.iter().map(one).collect()
}

/// A road mark with its line.
fn mark(kind: &str, change: &str) -> String {
    let (width, line) = match kind {
        "broken" => {
            (0.12, "<line length=\"3\" space=\"6\" tOffset=\"0\" sOffset=\"0\" width=\"0.12\"/>")
        }
        "dots" => (
            0.25,
            "<line length=\"1.5\" space=\"1.5\" tOffset=\"0\" sOffset=\"0\" width=\"0.25\"/>",
        ),
        _ => (0.12, ""),
    };
    if kind == "curb" {
        return "<roadMark sOffset=\"0\" type=\"curb\" weight=\"standard\" color=\"standard\" width=\"0.15\" laneChange=\"none\"/>".to_owned();
    }
    let name = if line.is_empty() { "solid" } else { "broken" };
    let inside = if line.is_empty() {
        "/>".to_owned()
    } else {
        format!("><type name=\"broken\" width=\"{width}\">{line}</type></roadMark>")
    };
    format!(
        "<roadMark sOffset=\"0\" type=\"{name}\" weight=\"standard\" color=\"white\" width=\"{width}\" laneChange=\"{change}\"{inside}"
    )
}

/// A lane. `links`: its predecessor and successor, 0 for none.
struct Lane<'a> {
    id: i32,
    kind: &'a str,
    links: [i32; 2],
    width: Vec<Record>,
    mark: String,
    more: &'a str,
}

fn lane(id: i32, kind: &str, links: [i32; 2], width: f64, mark: String) -> Lane<'_> {
    Lane { id, kind, links, width: vec![constant(0.0, width)], mark, more: "" }
}

/// A lane section, from lanes in the order from left to right.
fn section(s: f64, center: &str, lanes: &[Lane<'_>]) -> String {
    let side = |name: &str, all: &[&Lane<'_>]| {
        if all.is_empty() {
            return String::new();
        }
        let mut out = format!("        <{name}>\n");
        for Lane { id, kind, links, width, mark, more } in all {
            let link = |name: &str, id: i32| {
                if id == 0 { String::new() } else { format!("<{name} id=\"{id}\"/>") }
            };
            let links = link("predecessor", links[0]) + &link("successor", links[1]);
            let links = if links.is_empty() { links } else { format!("<link>{links}</link>") };
            let width = records("width", "sOffset", width);
            let _ = writeln!(
                out,
                "          <lane id=\"{id}\" type=\"{kind}\" level=\"false\">{links}{width}{mark}{more}</lane>"
            );
        }
        out + &format!("        </{name}>\n")
    };
    let left: Vec<_> = lanes.iter().filter(|lane| lane.id > 0).collect();
    let right: Vec<_> = lanes.iter().filter(|lane| lane.id < 0).collect();
    format!(
        "      <laneSection s=\"{}\">\n{}        <center><lane id=\"0\">{center}</lane></center>\n{}      </laneSection>\n",
        n(s),
        side("left", &left),
        side("right", &right)
    )
}

/// A road, as it is collected.
#[derive(Default)]
struct Road<'a> {
    id: u32,
    name: &'a str,
    junction: Option<u32>,
    links: String,
    /// Type and limit `[km/h]`.
    kind: Option<(&'a str, u32)>,
    elevation: Vec<Record>,
    offset: Vec<Record>,
    sections: String,
    objects: String,
    signals: String,
}

impl Road<'_> {
    fn text(&self, line: &Line) -> String {
        let mut out = format!(
            "  <road name=\"{}\" length=\"{}\" id=\"{}\" junction=\"{}\" rule=\"RHT\">\n",
            self.name,
            n(line.length),
            self.id,
            self.junction.map_or("-1".to_owned(), |id| id.to_string())
        );
        if !self.links.is_empty() {
            let _ = writeln!(out, "    <link>{}</link>", self.links);
        }
        if let Some((kind, limit)) = self.kind {
            let _ = writeln!(
                out,
                "    <type s=\"0\" type=\"{kind}\" country=\"DE\"><speed max=\"{limit}\" unit=\"km/h\"/></type>"
            );
        }
        let _ = writeln!(out, "    <planView>\n{}    </planView>", line.text);
        if !self.elevation.is_empty() {
            let _ = writeln!(
                out,
                "    <elevationProfile>{}</elevationProfile>",
                records("elevation", "s", &self.elevation)
            );
        }
        let _ = writeln!(
            out,
            "    <lanes>\n{}{}    </lanes>",
            records("laneOffset", "s", &self.offset),
            self.sections
        );
        for (name, all) in [("objects", &self.objects), ("signals", &self.signals)] {
            if !all.is_empty() {
                let _ = writeln!(out, "    <{name}>\n{all}    </{name}>");
            }
        }
        out + "  </road>\n"
    }
}

/// A link of a road: what it leads to, as `predecessor road 3 end` or `successor junction 7`.
fn link(text: &str) -> String {
    let words: Vec<&str> = text.split(' ').collect();
    let contact = words.get(3).map_or(String::new(), |end| format!(" contactPoint=\"{end}\""));
    format!("<{} elementType=\"{}\" elementId=\"{}\"{contact}/>", words[0], words[1], words[2])
}

/// A signal; `more` are attributes and what stands inside, such as `value="50" unit="km/h"`.
fn signal(id: &str, [s, t, z]: [f64; 3], orientation: &str, kind: &str, more: &str) -> String {
    let (attributes, inside) = more.split_once('|').unwrap_or((more, ""));
    let (is_dynamic, country) =
        if kind.starts_with("10000") { ("yes", "OpenDRIVE") } else { ("no", "DE") };
    let (kind, subtype) = kind.split_once(':').unwrap_or((kind, "-1"));
    format!(
        "      <signal id=\"{id}\" s=\"{}\" t=\"{}\" zOffset=\"{}\" orientation=\"{orientation}\" dynamic=\"{is_dynamic}\" country=\"{country}\" countryRevision=\"2017\" type=\"{kind}\" subtype=\"{subtype}\" {attributes}>{inside}</signal>\n",
        n(s),
        n(t),
        n(z)
    )
}

fn validity(from: i32, to: i32) -> String {
    format!("<validity fromLane=\"{from}\" toLane=\"{to}\"/>")
}

/// A rectangle on the road from s and t to s and t, as an object of a type.
fn painted(id: &str, kind: &str, [s, t]: [f64; 2], [to_s, to_t]: [f64; 2], inside: &str) -> String {
    let corners = [(s, t), (to_s, t), (to_s, to_t), (s, to_t)];
    let corner = |(id, (s, t)): (usize, (f64, f64))| {
        format!("<cornerRoad id=\"{id}\" s=\"{}\" t=\"{}\" dz=\"0\" height=\"0\"/>", n(s), n(t))
    };
    let corners: String = corners.into_iter().enumerate().map(corner).collect();
    format!(
        "      <object id=\"{id}\" {kind} s=\"{}\" t=\"{}\" zOffset=\"0\" hdg=\"0\" pitch=\"0\" roll=\"0\" orientation=\"none\"><outlines><outline id=\"0\" outer=\"true\" closed=\"true\" fillType=\"paint\">{corners}</outline></outlines>{inside}</object>\n",
        n((s + to_s) / 2.0),
        n((t + to_t) / 2.0)
    )
}

/// A crosswalk over a road, 4 m wide from s on.
fn crosswalk(id: &str, s: f64, [right, left]: [f64; 2]) -> String {
    painted(id, "type=\"crosswalk\"", [s, right], [s + 4.0, left], "")
}

/// A stop line, 0.5 m wide from s on.
fn stop_line(id: &str, s: f64, [right, left]: [f64; 2]) -> String {
    painted(id, "type=\"roadMark\" subtype=\"signalLines\"", [s, right], [s + 0.5, left], "")
}

/// An arrow on a lane.
fn arrow(id: &str, which: &str, [s, t]: [f64; 2], orientation: &str) -> String {
    let hdg = if orientation == "-" { PI } else { 0.0 };
    format!(
        "      <object id=\"{id}\" type=\"roadMark\" subtype=\"arrow{which}\" s=\"{}\" t=\"{}\" zOffset=\"0\" hdg=\"{}\" pitch=\"0\" roll=\"0\" length=\"5\" width=\"1\" orientation=\"{orientation}\"/>\n",
        n(s),
        n(t),
        n(hdg)
    )
}

/// The same object again and again: from s to s, every so far, at t.
fn row(id: &str, attributes: &str, [from, to, every]: [f64; 3], t: f64) -> String {
    let t = n(t);
    format!(
        "      <object id=\"{id}\" {attributes} s=\"{0}\" t=\"{t}\" zOffset=\"0\" hdg=\"0\" pitch=\"0\" roll=\"0\" orientation=\"none\"><repeat s=\"{0}\" length=\"{1}\" distance=\"{2}\" tStart=\"{t}\" tEnd=\"{t}\" heightStart=\"0\" heightEnd=\"0\" zOffsetStart=\"0\" zOffsetEnd=\"0\"/></object>\n",
        n(from),
        n(to - from),
        n(every)
    )
}

fn building(id: &str, [s, t]: [f64; 2], [length, width, height]: [f64; 3]) -> String {
    format!(
        "      <object id=\"{id}\" type=\"building\" s=\"{}\" t=\"{}\" zOffset=\"0\" hdg=\"0\" pitch=\"0\" roll=\"0\" length=\"{length}\" width=\"{width}\" height=\"{height}\" orientation=\"none\"/>\n",
        n(s),
        n(t)
    )
}

/// A connecting road and its connection, from a lane to a lane.
#[derive(Clone, Copy)]
struct Way<'a> {
    from: (u32, &'a str, i32),
    to: (u32, &'a str, i32),
    start: Pose,
    goal: Pose,
    /// Width at both ends of the driving lane.
    width: [f64; 2],
    /// Sidewalks beside it: on the road that it comes from and on the one that it leads to.
    walks: Option<[i32; 2]>,
    /// Its only piece, of a ring.
    arc: Option<f64>,
    share: f64,
    type_and_limit: (&'a str, u32),
}

fn way(roads: &mut String, connections: &mut String, junction: u32, number: u32, way: &Way<'_>) {
    let id = junction * 10 + number;
    let (from, to) = (way.from, way.to);
    let line = match way.arc {
        Some(length) => Line::at(way.start).piece(length, 1.0 / RADIUS, 1.0 / RADIUS),
        None => Line::at(way.start).to(way.goal, way.share).ended(),
    };
    let width = if way.width[0] == way.width[1] {
        constant(0.0, way.width[0])
    } else {
        smooth(0.0, way.width[0], way.width[1], line.length)
    };
    let mut lanes = vec![Lane {
        id: -1,
        kind: "driving",
        links: [from.2, to.2],
        width: vec![width],
        mark: String::new(),
        more: "",
    }];
    if let Some(links) = way.walks {
        lanes.push(lane(-2, "walking", links, WALK, String::new()));
    }
    let road = Road {
        id,
        name: "",
        junction: Some(junction),
        links: link(&format!("predecessor road {} {}", from.0, from.1))
            + &link(&format!("successor road {} {}", to.0, to.1)),
        kind: Some(way.type_and_limit),
        sections: section(0.0, "", &lanes),
        ..Road::default()
    };
    *roads += &road.text(&line);
    let walk = way
        .walks
        .map_or(String::new(), |[from, _]| format!("<laneLink from=\"{from}\" to=\"-2\"/>"));
    let _ = writeln!(
        connections,
        "    <connection id=\"{number}\" incomingRoad=\"{}\" connectingRoad=\"{id}\" contactPoint=\"start\"><laneLink from=\"{}\" to=\"-1\"/>{walk}</connection>",
        from.0, from.2
    );
}

const TOWN: (&str, u32) = ("town", 50);
const HALF: f64 = LANE / 2.0;
/// The stretch of the approaches to the crossing with a lane for turning, and the part of it on which that lane opens `[m]`.
const TURNING: f64 = 90.0;
const OPENING: f64 = 30.0;

/// A street of one lane in each direction between sidewalks, from s on, with the links of its lanes from left to right.
fn street(s: f64, links: [[i32; 2]; 4]) -> String {
    let curb = || mark("curb", "none");
    let lanes = [
        lane(2, "walking", links[0], WALK, String::new()),
        lane(1, "driving", links[1], LANE, curb()),
        lane(-1, "driving", links[2], LANE, curb()),
        lane(-2, "walking", links[3], WALK, String::new()),
    ];
    section(s, &mark("broken", "both"), &lanes)
}

/// Lights of an arm before its stop line: one for all its lanes, or one for each.
fn lights(arm: &str, s: f64, t: f64, orientation: &str, turning: Option<[i32; 2]>) -> String {
    let light = |name: String, t: f64, kind: &str, lanes: Option<i32>| {
        let inside = lanes.map_or(String::new(), |id| validity(id, id));
        signal(&name, [s, t, 3.0], orientation, kind, &format!("|{inside}"))
    };
    match turning {
        None => light(format!("light-{arm}"), t, "1000001", None),
        Some([left, other]) => {
            light(format!("light-{arm}"), t, "1000001", Some(other))
                + &light(
                    format!("light-{arm}-left"),
                    t - 0.5 * t.signum(),
                    "1000011:10",
                    Some(left),
                )
        }
    }
}

/// West of the crossing: a bus bay and parking, then a lane for turning left.
fn main_street_west() -> String {
    const LENGTH: f64 = 240.0;
    const BAY: [f64; 2] = [40.0, 110.0];
    let curb = || mark("curb", "none");
    let line = Line::at(Pose { x: -REACH - LENGTH, y: 0.0, hdg: 0.0 }).straight(LENGTH).ended();
    let bay = |depth: f64| {
        let length = BAY[1] - BAY[0];
        vec![
            smooth(0.0, 0.0, depth, 15.0),
            constant(15.0, depth),
            smooth(length - 15.0, depth, 0.0, 15.0),
        ]
    };
    let with_bays = [
        lane(3, "walking", [2, 2], WALK, String::new()),
        Lane { width: bay(PARK), ..lane(2, "parking", [0, 0], 0.0, curb()) },
        lane(1, "driving", [1, 1], LANE, mark("solid", "none")),
        lane(-1, "driving", [-1, -1], LANE, mark("dots", "both")),
        Lane {
            width: bay(3.0),
            more: "<access sOffset=\"0\" rule=\"allow\"><restriction type=\"bus\"/></access>",
            ..lane(-2, "parking", [0, 0], 0.0, curb())
        },
        lane(-3, "walking", [-2, -2], WALK, String::new()),
    ];
    let turn = LENGTH - TURNING;
    let approach = [
        lane(2, "walking", [2, 0], WALK, String::new()),
        lane(1, "driving", [1, 0], LANE, curb()),
        Lane {
            width: vec![smooth(0.0, 0.0, LANE, OPENING), constant(OPENING, LANE)],
            ..lane(-1, "driving", [0, 0], 0.0, mark("dots", "both"))
        },
        lane(-2, "driving", [-1, 0], LANE, curb()),
        lane(-3, "walking", [-2, 0], WALK, String::new()),
    ];
    let sections = street(0.0, [[0, 3], [0, 1], [0, -1], [0, -3]])
        + &section(BAY[0], &mark("broken", "both"), &with_bays)
        + &street(BAY[1], [[3, 2], [1, 1], [-1, -2], [-3, -3]])
        + &section(turn, &mark("solid", "none"), &approach);
    let objects = row(
        "parking",
        "type=\"parkingSpace\" length=\"5.5\" width=\"2\"",
        [58.0, 94.0, 6.0],
        LANE + PARK / 2.0,
    )
    .replace("</object>", "<parkingSpace access=\"all\"/></object>")
        + &crosswalk("crosswalk-west", LENGTH - 6.0, [-HALF - LANE, HALF + LANE])
        + &stop_line("stop-west", LENGTH - 7.5, [-HALF - LANE, HALF])
        + &arrow("arrow-west-left", "Left", [LENGTH - 20.0, 0.0], "+")
        + &arrow("arrow-west", "StraightRight", [LENGTH - 20.0, -LANE], "+")
        + &row(
            "limes",
            "type=\"tree\" name=\"lime\" radius=\"2.2\" height=\"9\"",
            [12.0, 204.0, 12.0],
            11.5,
        )
        + &row(
            "lamps-west",
            "type=\"pole\" name=\"lamp\" radius=\"0.1\" height=\"7\"",
            [6.0, 206.0, 25.0],
            -10.5,
        )
        + &building("house-1", [30.0, 23.0], [28.0, 14.0, 12.0])
        + &building("house-2", [75.0, 24.0], [36.0, 16.0, 15.0])
        + &building("house-3", [125.0, 23.0], [30.0, 14.0, 12.0])
        + &building("house-4", [185.0, 25.0], [34.0, 16.0, 18.0])
        + &building("school", [75.0, -28.0], [50.0, 22.0, 10.0])
        + &building("house-5", [165.0, -24.0], [40.0, 14.0, 12.0]);
    let signals = signal("limit-west", [10.0, -7.0, 2.2], "+", "274", "value=\"50\" unit=\"km/h\"")
        + &signal("bus-stop", [64.0, -9.4, 2.2], "+", "224", &format!("|{}", validity(-2, -2)))
        + &lights("west", LENGTH - 7.0, -8.5, "+", Some([-1, -2]));
    Road {
        id: 1,
        name: "Main Street",
        links: link(&format!("successor junction {CROSSING}")),
        kind: Some(TOWN),
        offset: vec![
            constant(0.0, 0.0),
            smooth(turn, 0.0, HALF, OPENING),
            constant(turn + OPENING, HALF),
        ],
        sections,
        objects,
        signals,
        ..Road::default()
    }
    .text(&line)
}

/// Distance from the middle of the roundabout at which its arms end `[m]`.
fn ring_reach() -> f64 {
    RADIUS / SPREAD.cos() + RADIUS * SPREAD.tan()
}

/// From the crossing to the roundabout.
fn main_street_east() -> String {
    let length = RING.0 - ring_reach() - REACH;
    let curb = || mark("curb", "none");
    let line = Line::at(Pose { x: REACH, y: 0.0, hdg: 0.0 }).straight(length).ended();
    let open = TURNING - OPENING;
    let approach = [
        lane(3, "walking", [0, 2], WALK, String::new()),
        lane(2, "driving", [0, 1], LANE, curb()),
        Lane {
            width: vec![constant(0.0, LANE), smooth(open, LANE, 0.0, OPENING)],
            ..lane(1, "driving", [0, 0], 0.0, mark("dots", "both"))
        },
        lane(-1, "driving", [0, -1], LANE, curb()),
        lane(-2, "walking", [0, -2], WALK, String::new()),
    ];
    let sections = section(0.0, &mark("solid", "none"), &approach)
        + &street(TURNING, [[3, 0], [2, 0], [-1, 0], [-2, 0]]);
    let objects = crosswalk("crosswalk-east", 2.0, [-HALF - LANE, HALF + LANE])
        + &stop_line("stop-east", 7.0, [-HALF, HALF + LANE])
        + &arrow("arrow-east-left", "Left", [20.0, 0.0], "-")
        + &arrow("arrow-east", "StraightRight", [20.0, LANE], "-")
        + &row(
            "planes",
            "type=\"tree\" name=\"plane\" radius=\"2.5\" height=\"11\"",
            [24.0, 180.0, 13.0],
            11.5,
        )
        + &row(
            "lamps-east",
            "type=\"pole\" name=\"lamp\" radius=\"0.1\" height=\"7\"",
            [30.0, 180.0, 25.0],
            -10.5,
        )
        + &building("house-6", [55.0, 25.0], [34.0, 16.0, 15.0])
        + &building("house-7", [105.0, 25.0], [40.0, 16.0, 15.0])
        + &building("market", [90.0, -34.0], [70.0, 34.0, 9.0]);
    let signals = lights("east", 7.0, 8.5, "-", Some([1, 2]))
        + &yield_to_ring("west", length - 2.0, -6.5, "+")
        + &signal(
            "limit-east",
            [length - 12.0, 6.8, 2.2],
            "-",
            "274",
            "value=\"50\" unit=\"km/h\"",
        );
    Road {
        id: 2,
        name: "Main Street",
        links: link(&format!("predecessor junction {CROSSING}"))
            + &link(&format!("successor junction {ARMS}")),
        kind: Some(TOWN),
        offset: vec![
            constant(0.0, -HALF),
            smooth(open, -HALF, 0.0, OPENING),
            constant(TURNING, 0.0),
        ],
        sections,
        objects,
        signals,
        ..Road::default()
    }
    .text(&line)
}

/// The signs at an entry of the roundabout.
fn yield_to_ring(arm: &str, s: f64, t: f64, orientation: &str) -> String {
    signal(&format!("yield-{arm}"), [s, t, 2.2], orientation, "205", "")
        + &signal(&format!("ring-{arm}"), [s, t, 1.5], orientation, "215", "")
}

/// From the crossing north, around the block and into the roundabout; one way, with parking on its right.
fn station_street() -> String {
    let goal = Pose { x: RING.0, y: ring_reach(), hdg: -FRAC_PI_2 };
    let corner = Pose { x: RING.0 / 2.0, y: 130.0, hdg: 0.0 };
    let line = Line::at(Pose { x: 0.0, y: REACH, hdg: FRAC_PI_2 })
        .straight(45.0)
        .to(corner, 0.25)
        .to(goal, 0.25)
        .ended();
    let curb = || mark("curb", "none");
    let (from, to) = (20.0, line.length - 30.0);
    let lanes = |links: [[i32; 2]; 3], parking: Option<Lane<'static>>| {
        let mut all = vec![
            lane(1, "walking", links[0], WALK, String::new()),
            lane(-1, "driving", links[1], LANE, curb()),
        ];
        let outer = if parking.is_some() { -3 } else { -2 };
        all.extend(parking);
        all.push(lane(outer, "walking", links[2], WALK, String::new()));
        all
    };
    let bay = Lane {
        width: vec![
            smooth(0.0, 0.0, PARK, 8.0),
            constant(8.0, PARK),
            smooth(to - from - 8.0, PARK, 0.0, 8.0),
        ],
        ..lane(-2, "parking", [0, 0], 0.0, curb())
    };
    let sections = section(0.0, &curb(), &lanes([[0, 1], [0, -1], [0, -3]], None))
        + &section(from, &curb(), &lanes([[1, 1], [-1, -1], [-2, -2]], Some(bay)))
        + &section(to, &curb(), &lanes([[1, 0], [-1, 0], [-3, 0]], None));
    let objects = crosswalk("crosswalk-north", 2.0, [-LANE, 0.0])
        + &arrow("arrow-north", "Straight", [30.0, -HALF], "+")
        + &row(
            "parking-north",
            "type=\"parkingSpace\" length=\"5.5\" width=\"2\"",
            [from + 12.0, from + 60.0, 6.0],
            -LANE - PARK / 2.0,
        )
        .replace("</object>", "<parkingSpace access=\"all\"/></object>")
        + &row(
            "maples",
            "type=\"tree\" name=\"maple\" radius=\"2\" height=\"8\"",
            [15.0, line.length - 15.0, 14.0],
            5.0,
        )
        + &building("station", [170.0, 22.0], [70.0, 20.0, 11.0])
        + &building("house-8", [55.0, 14.0], [26.0, 14.0, 12.0])
        + &building("house-9", [170.0, -26.0], [60.0, 18.0, 15.0])
        + &building("house-10", [line.length - 65.0, 16.0], [34.0, 16.0, 12.0]);
    let signals = signal("one-way", [6.0, -7.0, 2.2], "+", "220", "")
        + &signal("no-entry", [line.length - 8.0, 3.0, 2.2], "-", "267", "")
        + &signal("limit-north", [14.0, -7.0, 2.2], "+", "274", "value=\"30\" unit=\"km/h\"")
        + &yield_to_ring("north", line.length - 2.0, -6.5, "+");
    Road {
        id: 3,
        name: "Station Street",
        links: link(&format!("predecessor junction {CROSSING}"))
            + &link(&format!("successor junction {}", ARMS + 3)),
        kind: Some(("town", 30)),
        sections,
        objects,
        signals,
        ..Road::default()
    }
    .text(&line)
}

/// From the ramps below the motorway to the crossing.
fn south_street() -> String {
    const LENGTH: f64 = -RAMPS_AT - 2.0 * REACH;
    let line =
        Line::at(Pose { x: 0.0, y: RAMPS_AT + REACH, hdg: FRAC_PI_2 }).straight(LENGTH).ended();
    let objects = crosswalk("crosswalk-south", LENGTH - 6.0, [-LANE, LANE])
        + &stop_line("stop-south", LENGTH - 7.5, [-LANE, 0.0])
        + &row(
            "lamps-south",
            "type=\"pole\" name=\"lamp\" radius=\"0.1\" height=\"7\"",
            [10.0, 210.0, 25.0],
            -8.0,
        )
        + &building("house-11", [195.0, 20.0], [30.0, 14.0, 12.0])
        + &building("house-12", [190.0, -22.0], [30.0, 14.0, 12.0]);
    let signals =
        signal("limit-south", [10.0, -7.0, 2.2], "+", "274", "value=\"50\" unit=\"km/h\"")
            + &lights("south", LENGTH - 7.0, -6.8, "+", None);
    Road {
        id: 4,
        name: "South Street",
        links: link(&format!("predecessor junction {RAMPS}"))
            + &link(&format!("successor junction {CROSSING}")),
        kind: Some(TOWN),
        sections: street(0.0, [[0, 0]; 4]),
        objects,
        signals,
        ..Road::default()
    }
    .text(&line)
}

/// East of the roundabout.
fn lake_road() -> String {
    let line = Line::at(Pose { x: RING.0 + ring_reach(), y: RING.1, hdg: 0.0 })
        .straight(40.0)
        .to(Pose { x: 430.0, y: 60.0, hdg: 0.7 }, 0.25)
        .ended();
    let objects = row(
        "poplars",
        "type=\"tree\" name=\"poplar\" radius=\"1.5\" height=\"14\"",
        [20.0, 140.0, 10.0],
        8.5,
    );
    let signals = yield_to_ring("east", 2.0, 6.5, "-");
    Road {
        id: 5,
        name: "Lake Road",
        links: link(&format!("predecessor junction {}", ARMS + 2)),
        kind: Some(TOWN),
        sections: street(0.0, [[0, 0]; 4]),
        objects,
        signals,
        ..Road::default()
    }
    .text(&line)
}

/// The crossing with its lights.
fn crossing(roads: &mut String, junctions: &mut String, controllers: &mut String) {
    let arm = |x: f64, y: f64, hdg: f64| Pose { x, y, hdg };
    let into = [
        ("west", arm(-REACH, 0.0, 0.0)),
        ("east", arm(REACH, 0.0, PI)),
        ("south", arm(0.0, -REACH, FRAC_PI_2)),
    ];
    // Out of the crossing, from the left edge of each arm's lane.
    let to_west = arm(-REACH, HALF, PI);
    let to_east = arm(REACH, -HALF, 0.0);
    let to_north = arm(0.0, REACH, FRAC_PI_2);
    let to_south = arm(0.0, -REACH, -FRAC_PI_2);
    let (west, east, south) = (into[0].1, into[1].1, into[2].1);
    let end = |road: u32, lane: i32| (road, "end", lane);
    let start = |road: u32, lane: i32| (road, "start", lane);
    let ways = [
        (end(1, -2), start(2, -1), west.moved(0.0, -HALF), to_east, None),
        (end(1, -1), start(3, -1), west.moved(0.0, HALF), to_north, None),
        (end(1, -2), end(4, 1), west.moved(0.0, -HALF), to_south, Some([-3, 2])),
        (start(2, 2), end(1, 1), east.moved(0.0, -HALF), to_west, None),
        (start(2, 1), end(4, 1), east.moved(0.0, HALF), to_south, None),
        (start(2, 2), start(3, -1), east.moved(0.0, -HALF), to_north, Some([3, -2])),
        (end(4, -1), start(3, -1), south, to_north, None),
        (end(4, -1), end(1, 1), south, to_west, None),
        (end(4, -1), start(2, -1), south, to_east, Some([-2, -2])),
    ];
    let mut connections = String::new();
    for (number, (from, to, start, goal, walks)) in ways.into_iter().enumerate() {
        let width = [LANE, LANE];
        let one = Way {
            from,
            to,
            start,
            goal,
            width,
            walks,
            arc: None,
            share: 0.25,
            type_and_limit: TOWN,
        };
        way(roads, &mut connections, CROSSING, number as u32, &one);
    }
    let groups: [(&str, &[&str]); 3] = [
        ("main", &["light-west", "light-east"]),
        ("left", &["light-west-left", "light-east-left"]),
        ("south", &["light-south"]),
    ];
    let mut synchronised = String::new();
    for (sequence, (group, members)) in groups.into_iter().enumerate() {
        let control = |id: &&str| format!("<control signalId=\"{id}\" type=\"0\"/>");
        let control: String = members.iter().map(control).collect();
        let _ = writeln!(
            controllers,
            "  <controller id=\"{group}\" name=\"{group}\" sequence=\"{sequence}\">{control}</controller>"
        );
        let _ = writeln!(
            synchronised,
            "    <controller id=\"{group}\" type=\"0\" sequence=\"{sequence}\"/>"
        );
    }
    let _ = write!(
        junctions,
        "  <junction name=\"Main Crossing\" id=\"{CROSSING}\" type=\"default\">\n{connections}{synchronised}  </junction>\n"
    );
}

/// A pose on the ring's inner edge, at an angle from east.
fn on_ring(angle: f64) -> Pose {
    Pose {
        x: RING.0 + RADIUS * angle.cos(),
        y: RING.1 + RADIUS * angle.sin(),
        hdg: angle + FRAC_PI_2,
    }
}

/// The roundabout: a junction for each arm, and short roads of the ring between them.
fn roundabout(roads: &mut String, junctions: &mut String, groups: &mut String) {
    // Arms counter-clockwise from the west: the road, its end, the lane that leads in and the one that leads out.
    let arms: [(u32, &str, i32, Option<i32>); 4] = [
        (2, "end", -1, Some(1)),
        (22, "end", -1, None),
        (5, "start", 1, Some(-1)),
        (3, "end", -1, None),
    ];
    let names = ["West", "South", "East", "North"];
    for (k, (road, end, lane_in, lane_out)) in arms.into_iter().enumerate() {
        let angle = PI + k as f64 * FRAC_PI_2;
        let junction = ARMS + k as u32;
        let (before, after) = (10 + (k as u32 + 3) % 4, 10 + k as u32);
        let at = Pose { x: RING.0, y: RING.1, hdg: angle }.moved(ring_reach(), 0.0);
        let (leaving, coming) = (on_ring(angle - SPREAD), on_ring(angle + SPREAD));
        let limit = ("town", 30);
        let around = Way {
            from: (before, "end", -1),
            to: (after, "start", -1),
            start: leaving,
            goal: coming,
            width: [RING_LANE, RING_LANE],
            walks: None,
            arc: Some(RADIUS * 2.0 * SPREAD),
            share: 0.0,
            type_and_limit: limit,
        };
        let entry = Way {
            from: (road, end, lane_in),
            start: Pose { hdg: angle + PI, ..at },
            width: [LANE, RING_LANE],
            arc: None,
            share: 0.25,
            ..around
        };
        let mut connections = String::new();
        way(roads, &mut connections, junction, 0, &around);
        way(roads, &mut connections, junction, 1, &entry);
        if let Some(lane) = lane_out {
            let exit = Way {
                to: (road, end, lane),
                goal: at,
                width: [RING_LANE, LANE],
                arc: None,
                share: 0.25,
                ..around
            };
            way(roads, &mut connections, junction, 2, &exit);
        }
        let _ = write!(
            junctions,
            "  <junction name=\"Roundabout {}\" id=\"{junction}\" type=\"default\">\n{connections}    <priority high=\"{}\" low=\"{}\"/>\n  </junction>\n",
            names[k],
            junction * 10,
            junction * 10 + 1
        );
        let line =
            Line::at(coming).piece(RADIUS * (FRAC_PI_2 - 2.0 * SPREAD), 1.0 / RADIUS, 1.0 / RADIUS);
        let next = ARMS + (k as u32 + 1) % 4;
        *roads += &Road {
            id: after,
            name: "Roundabout",
            links: link(&format!("predecessor junction {junction}"))
                + &link(&format!("successor junction {next}")),
            kind: Some(limit),
            sections: section(
                0.0,
                &mark("curb", "none"),
                &[lane(-1, "driving", [0, 0], RING_LANE, mark("curb", "none"))],
            ),
            ..Road::default()
        }
        .text(&line);
    }
    let members: String =
        (ARMS..ARMS + 4).map(|id| format!("<junctionReference junction=\"{id}\"/>")).collect();
    let _ = writeln!(
        groups,
        "  <junctionGroup name=\"Roundabout\" id=\"1300\" type=\"roundabout\">{members}</junctionGroup>"
    );
}

/// Heights of a carriageway that climbs to the bridge over South Street, whose s there is given.
fn over_south_street(at: f64) -> Vec<Record> {
    vec![
        constant(0.0, 0.0),
        smooth(at - DECK - SLOPE, 0.0, BRIDGE, SLOPE),
        constant(at - DECK, BRIDGE),
        smooth(at + DECK, BRIDGE, 0.0, SLOPE),
        constant(at + DECK + SLOPE, 0.0),
    ]
}

const MOTORWAY: (&str, u32) = ("motorway", 120);
const ENDS: [f64; 2] = [-480.0, 560.0];
/// Where the exit leaves the motorway `[m]` eastwards.
const LEAVES: f64 = 390.0;

fn solid() -> String {
    mark("solid", "none")
}

/// Two lanes of a carriageway and its shoulder, with the links of each; no shoulder where it has no width.
fn carriageway(s: f64, links: [[i32; 2]; 3], shoulder: &[Record]) -> String {
    let mut lanes = vec![
        lane(-1, "driving", links[0], FAST, mark("broken", "both")),
        lane(-2, "driving", links[1], FAST, solid()),
    ];
    if !shoulder.is_empty() {
        lanes.push(Lane {
            width: shoulder.to_vec(),
            ..lane(-3, "shoulder", links[2], 0.0, String::new())
        });
    }
    section(s, &solid(), &lanes)
}

/// The same with a lane for leaving or joining between it and the shoulder.
fn with_ramp_lane(s: f64, kind: &str, links: [[i32; 2]; 4], width: Vec<Record>) -> String {
    let lanes = [
        lane(-1, "driving", links[0], FAST, mark("broken", "both")),
        lane(-2, "driving", links[1], FAST, mark("dots", "both")),
        Lane { width, ..lane(-3, kind, links[2], 0.0, solid()) },
        lane(-4, "shoulder", links[3], SHOULDER, String::new()),
    ];
    section(s, &solid(), &lanes)
}

/// How long a lane of a ramp takes to open, how long it is, and where the shoulder behind an exit is whole `[m]`.
const OPENS: f64 = 50.0;
const RAMP_LANE: f64 = 130.0;
const SHOULDER_OPENS: [f64; 2] = [60.0, 100.0];

/// A carriageway behind an exit: its shoulder opens beside the ramp.
fn behind_exit(to: [i32; 3]) -> String {
    let opening = [
        smooth(0.0, 0.0, SHOULDER, SHOULDER_OPENS[1] - SHOULDER_OPENS[0]),
        constant(40.0, SHOULDER),
    ];
    carriageway(0.0, [[0, -1], [0, -2], [0, 0]], &[])
        + &carriageway(SHOULDER_OPENS[0], [[-1, to[0]], [-2, to[1]], [0, to[2]]], &opening)
}

/// A carriageway before an exit whose junction is at its end.
fn before_exit(length: f64) -> String {
    let opening = vec![smooth(0.0, 0.0, FAST, OPENS), constant(OPENS, FAST)];
    carriageway(0.0, [[0, -1], [0, -2], [0, -4]], &[constant(0.0, SHOULDER)])
        + &with_ramp_lane(length - RAMP_LANE, "exit", [[-1, 0], [-2, 0], [0, 0], [-3, 0]], opening)
}

/// A ramp of one lane and a shoulder, between a motorway's lane and a street's.
fn ramp(kind: &str, line: &Line, is_exit: bool) -> String {
    let length = line.length;
    let (lane_width, shoulder) = if is_exit {
        (
            smooth(0.0, FAST, LANE, length),
            vec![
                constant(0.0, SHOULDER),
                smooth(length - 60.0, SHOULDER, 0.5, 50.0),
                constant(length - 10.0, 0.5),
            ],
        )
    } else {
        (
            smooth(0.0, LANE, FAST, length),
            vec![constant(0.0, 0.5), smooth(10.0, 0.5, SHOULDER, 50.0), constant(60.0, SHOULDER)],
        )
    };
    let lanes = [
        Lane { width: vec![lane_width], ..lane(-1, kind, [0, 0], 0.0, solid()) },
        Lane { width: shoulder, ..lane(-2, "shoulder", [0, 0], 0.0, String::new()) },
    ];
    section(0.0, &solid(), &lanes)
}

/// A direct junction: which lanes of which road lead to which of which.
fn direct(junctions: &mut String, id: u32, name: &str, all: &[(u32, u32, &[[i32; 2]])]) {
    let _ = writeln!(junctions, "  <junction name=\"{name}\" id=\"{id}\" type=\"direct\">");
    for (number, (from, to, links)) in all.iter().enumerate() {
        let links: String = links
            .iter()
            .map(|[from, to]| format!("<laneLink from=\"{from}\" to=\"{to}\"/>"))
            .collect();
        let _ = writeln!(
            junctions,
            "    <connection id=\"{number}\" incomingRoad=\"{from}\" linkedRoad=\"{to}\" contactPoint=\"start\">{links}</connection>"
        );
    }
    *junctions += "  </junction>\n";
}

fn rail(id: &str, to: f64) -> String {
    format!(
        "      <object id=\"{id}\" type=\"barrier\" name=\"guard rail\" s=\"0\" t=\"1\" zOffset=\"0\" hdg=\"0\" pitch=\"0\" roll=\"0\" height=\"0.8\" orientation=\"none\"><repeat s=\"0\" length=\"{}\" distance=\"0\" tStart=\"1\" tEnd=\"1\" widthStart=\"0.3\" widthEnd=\"0.3\" heightStart=\"0.8\" heightEnd=\"0.8\" zOffsetStart=\"0\" zOffsetEnd=\"0\"/></object>\n",
        n(to)
    )
}

fn bridge(id: &str, at: f64) -> String {
    format!(
        "      <bridge id=\"{id}\" name=\"South Street Bridge\" s=\"{}\" length=\"{}\" type=\"concrete\"/>\n",
        n(at - DECK),
        n(2.0 * DECK)
    )
}

/// The signs of a motorway's end on a ramp of this length.
fn leaving_signs(ramp: &str, length: f64) -> String {
    let limit = |s: f64, value: u32| {
        signal(
            &format!("limit-{ramp}-{value}"),
            [s, -7.5, 2.2],
            "+",
            "274",
            &format!("value=\"{value}\" unit=\"km/h\""),
        )
    };
    limit(30.0, 80)
        + &limit(length - 60.0, 50)
        + &signal(&format!("motorway-ends-{ramp}"), [length - 70.0, -7.5, 2.2], "+", "330.2", "")
}

/// Westwards, with an exit to the roundabout.
fn westbound(roads: &mut String, junctions: &mut String) {
    let length = ENDS[1] - LEAVES;
    let line = Line::at(Pose { x: ENDS[1], y: WESTBOUND, hdg: PI }).straight(length).ended();
    *roads += &Road {
        id: 20,
        name: "Motorway",
        links: link(&format!("successor junction {EXIT}")),
        kind: Some(MOTORWAY),
        sections: before_exit(length),
        objects: rail("rail-1", length),
        signals: signal("motorway", [5.0, -11.0, 2.5], "+", "330.1", ""),
        ..Road::default()
    }
    .text(&line);
    let length = LEAVES - ENDS[0];
    let line = Line::at(line.end).straight(length).ended();
    *roads += &Road {
        id: 21,
        name: "Motorway",
        links: link(&format!("predecessor junction {EXIT}")),
        kind: Some(MOTORWAY),
        elevation: over_south_street(LEAVES),
        sections: behind_exit([0; 3]),
        objects: rail("rail-2", length) + &bridge("bridge-west", LEAVES),
        ..Road::default()
    }
    .text(&line);
    let start = Pose { x: LEAVES, y: WESTBOUND + 2.0 * FAST, hdg: PI };
    let goal = Pose { x: RING.0, y: -ring_reach(), hdg: FRAC_PI_2 };
    let line = Line::at(start).to(goal, 0.45).ended();
    *roads += &Road {
        id: 22,
        name: "Exit",
        links: link(&format!("predecessor junction {EXIT}"))
            + &link(&format!("successor junction {}", ARMS + 1)),
        kind: Some(("motorway", 80)),
        sections: ramp("offRamp", &line, true),
        signals: leaving_signs("west", line.length)
            + &yield_to_ring("south", line.length - 2.0, -6.0, "+"),
        ..Road::default()
    }
    .text(&line);
    direct(
        junctions,
        EXIT,
        "Exit",
        &[(20, 21, &[[-1, -1], [-2, -2]]), (20, 22, &[[-3, -1], [-4, -2]])],
    );
}

/// Eastwards, with an exit to South Street and an entry from it.
fn eastbound(roads: &mut String, junctions: &mut String) {
    let motorway =
        |id: u32, links: String, elevation: Vec<Record>, sections: String, objects: String| Road {
            id,
            name: "Motorway",
            links,
            kind: Some(MOTORWAY),
            elevation,
            sections,
            objects,
            ..Road::default()
        };
    let length = -RAMPS_LEAVE - ENDS[0];
    let before = Line::at(Pose { x: ENDS[0], y: EASTBOUND, hdg: 0.0 }).straight(length).ended();
    *roads += &motorway(
        23,
        link(&format!("successor junction {EAST_EXIT}")),
        Vec::new(),
        before_exit(length),
        String::new(),
    )
    .text(&before);
    let between = Line::at(before.end).straight(2.0 * RAMPS_LEAVE).ended();
    // Its shoulder closes before the ramp that joins.
    let closes = 2.0 * RAMPS_LEAVE - SHOULDER_OPENS[1];
    let closing = [smooth(0.0, SHOULDER, 0.0, SHOULDER_OPENS[1] - SHOULDER_OPENS[0])];
    let sections = behind_exit([-1, -2, -3])
        + &carriageway(closes, [[-1, -1], [-2, -2], [-3, 0]], &closing)
        + &carriageway(2.0 * RAMPS_LEAVE - SHOULDER_OPENS[0], [[-1, 0], [-2, 0], [0, 0]], &[]);
    let links = link(&format!("predecessor junction {EAST_EXIT}"))
        + &link(&format!("successor junction {EAST_ENTRY}"));
    let objects = bridge("bridge-east", RAMPS_LEAVE);
    *roads +=
        &motorway(24, links, over_south_street(RAMPS_LEAVE), sections, objects).text(&between);
    let after = Line::at(between.end).straight(ENDS[1] - RAMPS_LEAVE).ended();
    let joining = vec![constant(0.0, FAST), smooth(RAMP_LANE - OPENS, FAST, 0.0, OPENS)];
    let sections = with_ramp_lane(0.0, "entry", [[0, -1], [0, -2], [0, 0], [0, -3]], joining)
        + &carriageway(RAMP_LANE, [[-1, 0], [-2, 0], [-4, 0]], &[constant(0.0, SHOULDER)]);
    *roads += &motorway(
        25,
        link(&format!("predecessor junction {EAST_ENTRY}")),
        Vec::new(),
        sections,
        String::new(),
    )
    .text(&after);

    // Both ramps are two bends of one angle, in opposite directions.
    let leaves = before.end.moved(0.0, -2.0 * FAST);
    let joins = between.end.moved(0.0, -2.0 * FAST);
    let (into, out_of) =
        (Pose { x: -REACH, y: RAMPS_AT, hdg: 0.0 }, Pose { x: REACH, y: RAMPS_AT, hdg: 0.0 });
    let middle = |a: Pose, b: Pose| {
        let (x, y) = ((a.x + b.x) / 2.0, (a.y + b.y) / 2.0);
        Pose { x, y, hdg: 2.0 * ((b.y - a.y) / (b.x - a.x)).atan() }
    };
    let exit = Line::at(leaves).to(middle(leaves, into), 0.45).to(into, 0.45).ended();
    let entry = Line::at(out_of).to(middle(out_of, joins), 0.45).to(joins, 0.45).ended();
    *roads += &Road {
        id: 26,
        name: "Exit",
        links: link(&format!("predecessor junction {EAST_EXIT}"))
            + &link(&format!("successor junction {RAMPS}")),
        kind: Some(("motorway", 80)),
        sections: ramp("offRamp", &exit, true),
        signals: leaving_signs("east", exit.length)
            + &signal("yield-exit", [exit.length - 2.0, -6.0, 2.2], "+", "205", ""),
        ..Road::default()
    }
    .text(&exit);
    *roads += &Road {
        id: 27,
        name: "Entry",
        links: link(&format!("predecessor junction {RAMPS}"))
            + &link(&format!("successor junction {EAST_ENTRY}")),
        kind: Some(("motorway", 80)),
        sections: ramp("onRamp", &entry, false),
        signals: signal("motorway-begins", [70.0, -7.5, 2.2], "+", "330.1", ""),
        ..Road::default()
    }
    .text(&entry);
    direct(
        junctions,
        EAST_EXIT,
        "East Exit",
        &[(23, 24, &[[-1, -1], [-2, -2]]), (23, 26, &[[-3, -1], [-4, -2]])],
    );
    direct(
        junctions,
        EAST_ENTRY,
        "East Entry",
        &[(24, 25, &[[-1, -1], [-2, -2]]), (27, 25, &[[-1, -3], [-2, -4]])],
    );

    // The junction of both with South Street.
    let south = Pose { x: 0.0, y: RAMPS_AT + REACH, hdg: FRAC_PI_2 };
    let straight = Way {
        from: (26, "end", -1),
        to: (27, "start", -1),
        start: into,
        goal: out_of,
        width: [LANE, LANE],
        walks: None,
        arc: None,
        share: 0.25,
        type_and_limit: TOWN,
    };
    let to_town = Way { to: (4, "start", -1), goal: south, ..straight };
    let from_town =
        Way { from: (4, "start", 1), start: Pose { hdg: -FRAC_PI_2, ..south }, ..straight };
    let mut connections = String::new();
    for (number, one) in [straight, to_town, from_town].iter().enumerate() {
        way(roads, &mut connections, RAMPS, number as u32, one);
    }
    let _ = write!(
        junctions,
        "  <junction name=\"Ramps\" id=\"{RAMPS}\" type=\"default\">\n{connections}    <priority high=\"{0}2\" low=\"{0}1\"/>\n  </junction>\n",
        RAMPS
    );
}

/// OpenDRIVE text of the quarter.
pub fn quarter() -> String {
    let mut roads =
        [main_street_west(), main_street_east(), station_street(), south_street(), lake_road()]
            .concat();
    let (mut controllers, mut junctions) = (String::new(), String::new());
    crossing(&mut roads, &mut junctions, &mut controllers);
    let mut groups = String::new();
    roundabout(&mut roads, &mut junctions, &mut groups);
    westbound(&mut roads, &mut junctions);
    eastbound(&mut roads, &mut junctions);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Written by the generator in tests/src/quarter.rs. -->\n<OpenDRIVE>\n  <header revMajor=\"1\" revMinor=\"8\" name=\"quarter\" version=\"1\" date=\"2026-01-01T00:00:00\" north=\"170\" south=\"-305\" east=\"560\" west=\"-480\" vendor=\"mapd\">\n    <geoReference><![CDATA[+proj=tmerc +lat_0=48.1 +lon_0=11.5 +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs]]></geoReference>\n  </header>\n{roads}{controllers}{junctions}{groups}</OpenDRIVE>\n"
    )
}
