//! A crossing of four arms, made by hand, with signs or lights as a test wants them.
//!
//! Arm k (0 to 3) leads away from the middle at k quarter turns, from 10 m to 100 m. Its lane −1 leads out, its lane 1
//! leads in and ends at s = 0. The road `ab` leads from arm a to arm b: 20 m straight on, or a quarter turn with a
//! reference line of radius 10 m; its lane −1 is 3.5 m wide.

use crate::graph_maps::{Line, connection, document, junction, lane, link, road, section};
use std::f64::consts::{FRAC_PI_2, PI};

/// Number of arms.
pub const ARMS: usize = 4;

/// A signal of an arm: id, s, t, orientation, type, more attributes.
pub fn signal(id: &str, s: f64, t: f64, orientation: &str, kind: &str, more: &str) -> String {
    format!(
        "<signal id=\"{id}\" s=\"{s}\" t=\"{t}\" zOffset=\"2\" orientation=\"{orientation}\" dynamic=\"no\" country=\"DE\" type=\"{kind}\" subtype=\"-1\" {more}/>\n"
    )
}

/// A light of an arm for the traffic that comes in.
pub fn light(id: &str) -> String {
    format!(
        "<signal id=\"{id}\" s=\"1\" t=\"5\" zOffset=\"3\" orientation=\"-\" dynamic=\"yes\" country=\"OpenDRIVE\" type=\"1000001\" subtype=\"-1\"/>\n"
    )
}

/// The map: signals of each arm, what the junction holds beside its connections, what stands beside roads and junction.
pub fn crossroads(signals: [String; ARMS], of_junction: &str, beside: &str) -> String {
    crossing(false, signals, of_junction, beside)
}

/// The same with left-hand traffic: an arm's lane 1 leads out, its lane −1 in, and `ab` has a lane 1.
pub fn left_hand_crossroads(signals: [String; ARMS], of_junction: &str, beside: &str) -> String {
    crossing(true, signals, of_junction, beside)
}

fn crossing(
    is_left_hand: bool,
    signals: [String; ARMS],
    of_junction: &str,
    beside: &str,
) -> String {
    let rule = if is_left_hand { "rule=\"LHT\" " } else { "" };
    let mut elements = String::new();
    let mut connections = String::new();
    for (arm, signals) in signals.iter().enumerate() {
        let angle = arm as f64 * FRAC_PI_2;
        let line = Line(10.0 * angle.cos(), 10.0 * angle.sin(), angle, 90.0, 0.0);
        let lanes = section(0.0, &lane(1, ""), &lane(-1, ""));
        let plain = road(
            &arm.to_string(),
            &format!("{rule}junction=\"-1\""),
            line,
            &link("p junction 100"),
            &lanes,
        );
        elements += &plain.replace("</road>", &format!("<signals>\n{signals}</signals>\n</road>"));
    }
    for from in 0..ARMS {
        for to in (0..ARMS).filter(|to| *to != from) {
            let id = format!("{from}{to}");
            let angle = from as f64 * FRAC_PI_2;
            let quarter = 10.0 * FRAC_PI_2;
            let (length, curvature) = match (to + ARMS - from) % ARMS {
                1 => (quarter, -0.1),
                2 => (20.0, 0.0),
                _ => (quarter, 0.1),
            };
            let start = (10.0 * angle.cos(), 10.0 * angle.sin());
            let line = Line(start.0, start.1, angle + PI, length, curvature);
            let links =
                link(&format!("p road {from} start")) + &link(&format!("s road {to} start"));
            let lanes = if is_left_hand {
                section(0.0, &lane(1, "p-1 s1"), "")
            } else {
                section(0.0, "", &lane(-1, "p1 s-1"))
            };
            elements += &road(&id, &format!("{rule}junction=\"100\""), line, &links, &lanes);
            let attributes = format!(
                "id=\"{id}\" incomingRoad=\"{from}\" connectingRoad=\"{id}\" contactPoint=\"start\""
            );
            connections += &connection(&attributes, if is_left_hand { "-1>1" } else { "1>-1" });
        }
    }
    elements += &junction("100", "name=\"crossing\"", &format!("{connections}{of_junction}"));
    document(&format!("{elements}{beside}"))
}

/// The crossing with everything that signals can have: lights in two groups that a junction ties together, lines, crosswalks,
/// speed signs, boards with display areas, groups of boards, references between signals, boards and objects.
pub fn furnished() -> String {
    let linked = |id: &str, kind: &str, inside: &str| {
        signal(id, 50.0, 5.0, "-", kind, "").replace("/>", &format!(">{inside}</signal>"))
    };
    let pole = "<reference elementType=\"object\" elementId=\"pole\" type=\"carrier\"/>";
    let area = "<displayArea index=\"1\" v=\"0.5\" z=\"1\" width=\"1\" height=\"0.5\"/>";
    let vms = format!(
        "<vmsBoard displayType=\"LED\" displayWidth=\"3\" displayHeight=\"1\" v=\"0\" z=\"1\"><validity fromLane=\"1\" toLane=\"1\"/><dependency id=\"L0\"/>{pole}{area}{area}</vmsBoard>"
    );
    let sign = "<staticBoard><sign id=\"T\" v=\"1\" z=\"0.5\" orientation=\"-\" dynamic=\"no\" country=\"DE\" type=\"274\" subtype=\"55\"/></staticBoard>";
    let signals = std::array::from_fn(|arm| {
        let own = light(&format!("L{arm}"))
            + &signal(&format!("S{arm}"), 2.0, 1.75, "-", "294", "")
            + &signal(&format!("C{arm}"), 4.0, 0.0, "none", "293", "")
            + &signal(&format!("V{arm}"), 60.0, 5.0, "-", "274", "value=\"50\" unit=\"km/h\"");
        let more = match arm {
            0 => linked("B", "multiBoard", &format!("<dependency id=\"L1\"/>{pole}{sign}{vms}")),
            1 => "<signalReference id=\"V0\" s=\"30\" t=\"5\" orientation=\"-\"/>\n".to_owned(),
            2 => linked(
                "M",
                "206",
                "<semantics><priority type=\"stop\"/></semantics><positionInertial x=\"1\" y=\"2\" z=\"3\" hdg=\"0\"/>",
            ),
            _ => String::new(),
        };
        own + &more
    });
    let group = |id: &str, arms: [usize; 2]| {
        let control = |arm: usize| format!("<control signalId=\"L{arm}\" type=\"0\"/>");
        let controls: String = arms.into_iter().map(control).collect();
        format!("<controller id=\"{id}\" name=\"group {id}\">{controls}</controller>\n")
    };
    let boards = "<vmsGroup id=\"G\"><vmsBoardReference signalId=\"B\" vmsIndex=\"0\" groupIndex=\"0\"/></vmsGroup>\n";
    let of_junction = "<priority high=\"0\" low=\"1\"/><controller id=\"A\" sequence=\"0\"/><controller id=\"B\" sequence=\"1\"/>\n";
    let text =
        crossroads(signals, of_junction, &(group("A", [0, 2]) + &group("B", [1, 3]) + boards));
    let objects = "<objects><object id=\"pole\" type=\"pole\" s=\"50\" t=\"6\" zOffset=\"0\" radius=\"0.1\" height=\"5\" orientation=\"none\"/></objects>";
    text.replacen("<signals>", &format!("{objects}<signals>"), 1)
}
