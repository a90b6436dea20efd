//! Small maps made by hand, each for one thing that lane links may look like.

use std::f64::consts::{FRAC_PI_2, PI};

/// A map with the edges that its lane graph must have: `from > to to …`, each a lane key with the direction of travel
/// along s.
pub struct GraphMap {
    /// What it is about.
    pub name: &'static str,
    /// The document.
    pub text: String,
    /// All edges between lanes, by the node that is left.
    pub edges: &'static [&'static str],
}

/// A document of these elements.
pub fn document(elements: &str) -> String {
    format!("<OpenDRIVE>\n<header revMajor=\"1\" revMinor=\"8\"/>\n{elements}</OpenDRIVE>\n")
}

/// Where a road lies: start, heading, length, curvature.
#[derive(Clone, Copy)]
pub struct Line(pub f64, pub f64, pub f64, pub f64, pub f64);

/// A road: its attributes beyond id and length, its link, its lane sections.
pub fn road(id: &str, attributes: &str, line: Line, link: &str, sections: &str) -> String {
    let Line(x, y, hdg, length, curvature) = line;
    let shape = match curvature {
        0.0 => "<line/>".to_owned(),
        _ => format!("<arc curvature=\"{curvature}\"/>"),
    };
    format!(
        "<road id=\"{id}\" length=\"{length}\" {attributes}>\n<link>{link}</link>\n\
         <planView><geometry s=\"0\" x=\"{x}\" y=\"{y}\" hdg=\"{hdg}\" length=\"{length}\">{shape}</geometry></planView>\n\
         <lanes>\n{sections}</lanes>\n</road>\n"
    )
}

/// A lane section from its left and right lanes.
pub fn section(s: f64, left: &str, right: &str) -> String {
    let side = |name: &str, lanes: &str| match lanes {
        "" => String::new(),
        lanes => format!("<{name}>\n{lanes}</{name}>\n"),
    };
    format!(
        "<laneSection s=\"{s}\">\n{}<center><lane id=\"0\" type=\"none\"/></center>\n{}</laneSection>\n",
        side("left", left),
        side("right", right)
    )
}

/// A driving lane of 3.5 m with its links, written as in `p-1 s2 s3`.
pub fn lane(id: i32, links: &str) -> String {
    wide(id, "", links, "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"", "")
}

/// A lane with more attributes, a width and more elements.
pub fn wide(id: i32, attributes: &str, links: &str, width: &str, more: &str) -> String {
    let links: String = links
        .split_whitespace()
        .map(|link| {
            let (kind, id) = link.split_at(1);
            let name = if kind == "p" { "predecessor" } else { "successor" };
            format!("<{name} id=\"{id}\"/>")
        })
        .collect();
    format!(
        "<lane id=\"{id}\" type=\"driving\"{attributes}><link>{links}</link><width sOffset=\"0\" {width}/>{more}</lane>\n"
    )
}

/// `predecessor` or `successor` of a road: `p road 1 end`, `s junction 9`.
pub fn link(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    let name = if words[0] == "p" { "predecessor" } else { "successor" };
    let contact = words.get(3).map(|end| format!(" contactPoint=\"{end}\"")).unwrap_or_default();
    format!("<{name} elementType=\"{}\" elementId=\"{}\"{contact}/>", words[1], words[2])
}

/// A link to a place inside a road.
fn link_inside(name: &str, road: &str, s: f64) -> String {
    format!("<{name} elementType=\"road\" elementId=\"{road}\" elementS=\"{s}\" elementDir=\"+\"/>")
}

/// A connection: attributes and lane links as `-1>-1`.
pub fn connection(attributes: &str, links: &str) -> String {
    let links: String = links
        .split_whitespace()
        .filter_map(|link| link.split_once('>'))
        .map(|(from, to)| format!("<laneLink from=\"{from}\" to=\"{to}\"/>"))
        .collect();
    format!("<connection {attributes}>{links}</connection>\n")
}

/// A junction of these connections.
pub fn junction(id: &str, attributes: &str, connections: &str) -> String {
    format!("<junction id=\"{id}\" {attributes}>\n{connections}</junction>\n")
}

const PLAIN: &str = "junction=\"-1\"";

/// All maps.
pub fn all() -> Vec<GraphMap> {
    let mut all = direct_junctions();
    all.extend([
        virtual_junction(),
        virtual_connections(),
        path_across(),
        left_hand_traffic(),
        ring_road(),
        roundabout(),
        connecting_road_backwards(),
        both_ends_at_one_junction(),
        no_lane_links(),
        both_directions(),
        merge_and_split(),
    ]);
    all
}

/// A direct junction of these connections: incoming road, linked road, the linked one's end, links.
pub fn direct(connections: &[(&str, &str, &str, &str)]) -> String {
    let one = |(id, (from, to, end, links)): (usize, &(&str, &str, &str, &str))| {
        let ends = format!("incomingRoad=\"{from}\" linkedRoad=\"{to}\" contactPoint=\"{end}\"");
        connection(&format!("id=\"{id}\" {ends}"), links)
    };
    junction("9", "type=\"direct\"", &connections.iter().enumerate().map(one).collect::<String>())
}

/// Road 1 leads to direct junction 9, roads 2 and 3 lead on behind it, the latter from the outer lane. Numbers of lanes have the sign of their side:
/// `side` is −1 where traffic keeps to the right.
pub fn exit_road(side: i32, connections: &str) -> String {
    let attributes = if side < 0 { PLAIN.to_owned() } else { format!("{PLAIN} rule=\"LHT\"") };
    let lanes = |numbers: &[i32]| {
        let of = |left: bool| {
            let mut own: Vec<_> = numbers.iter().filter(|n| (**n > 0) == left).collect();
            own.sort_by_key(|n| -**n);
            own.iter().map(|n| lane(**n, "")).collect::<String>()
        };
        section(0.0, &of(true), &of(false))
    };
    let beside = 3.5 * f64::from(side);
    let roads = [
        road(
            "1",
            &attributes,
            Line(0.0, 0.0, 0.0, 100.0, 0.0),
            &link("s junction 9"),
            &lanes(&[-side, side, 2 * side]),
        ),
        road(
            "2",
            &attributes,
            Line(100.0, 0.0, 0.0, 100.0, 0.0),
            &link("p junction 9"),
            &lanes(&[-side, side]),
        ),
        road(
            "3",
            &attributes,
            Line(100.0, beside, 0.0, 100.0, 0.005 * f64::from(side)),
            &link("p junction 9"),
            &lanes(&[side]),
        ),
    ];
    document(&(roads.concat() + connections))
}

fn direct_junctions() -> Vec<GraphMap> {
    let edges = &["1:0:-1+ > 2:0:-1+", "1:0:-2+ > 3:0:-1+", "2:0:1- > 1:0:1-"];
    let exit = ("1", "3", "start", "-2>-1");
    let right = |name, connections: &[_]| GraphMap {
        name,
        text: exit_road(-1, &direct(connections)),
        edges,
    };
    let two_way = || section(0.0, &lane(1, ""), &lane(-1, ""));
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let shared = || section(0.0, "", &wide(-1, " direction=\"both\"", "", width, ""));
    let straight = |id: &str, x: f64, hdg: f64, links: &str, lanes: &str| {
        road(id, PLAIN, Line(x, 0.0, hdg, 100.0, 0.0), &link(links), lanes)
    };
    let into = || straight("1", 0.0, 0.0, "s junction 9", &two_way());
    let half = 20.0 * PI;
    vec![
        right(
            "direct junction, oncoming lanes in the one connection",
            &[("1", "2", "start", "1>1 -1>-1"), exit],
        ),
        right(
            "direct junction, oncoming lanes in a connection of their own",
            &[("1", "2", "start", "-1>-1"), exit, ("2", "1", "end", "1>1")],
        ),
        right(
            "direct junction, every link written twice",
            &[
                ("1", "2", "start", "1>1 -1>-1"),
                exit,
                ("2", "1", "end", "1>1 -1>-1"),
                ("3", "1", "end", "-1>-2"),
            ],
        ),
        right("direct junction without lane links", &[("1", "2", "start", ""), exit]),
        GraphMap {
            name: "direct junction in left-hand traffic",
            text: exit_road(
                1,
                &direct(&[("1", "2", "start", "-1>-1 1>1"), ("1", "3", "start", "2>1")]),
            ),
            edges: &["1:0:1+ > 2:0:1+", "1:0:2+ > 3:0:1+", "2:0:-1- > 1:0:-1-"],
        },
        GraphMap {
            name: "direct junction of roads that both end there",
            text: document(
                &(into()
                    + &straight("2", 200.0, PI, "s junction 9", &two_way())
                    + &road(
                        "3",
                        PLAIN,
                        Line(100.0, 0.0, 0.0, 100.0, -0.005),
                        &link("p junction 9"),
                        &section(0.0, "", &lane(-1, "")),
                    )
                    + &direct(&[("1", "2", "end", "1>-1 -1>1"), ("1", "3", "start", "-1>-1")])),
            ),
            edges: &["1:0:-1+ > 2:0:1- 3:0:-1+", "2:0:-1+ > 1:0:1-"],
        },
        GraphMap {
            name: "direct junction, lanes in both directions",
            text: document(
                &(straight("1", 0.0, 0.0, "s junction 9", &shared())
                    + &straight("2", 100.0, 0.0, "p junction 9", &shared())
                    + &direct(&[("1", "2", "start", "-1>-1")])),
            ),
            edges: &["1:0:-1+ > 2:0:-1+", "2:0:-1- > 1:0:-1-"],
        },
        GraphMap {
            name: "direct junction at either end of a road",
            text: document(
                &(road(
                    "1",
                    PLAIN,
                    Line(20.0, 0.0, FRAC_PI_2, half, 0.05),
                    &(link("p junction 9") + &link("s junction 9")),
                    &two_way(),
                ) + &road(
                    "2",
                    PLAIN,
                    Line(-20.0, 0.0, -FRAC_PI_2, 50.0, 0.0),
                    &link("p junction 9"),
                    &two_way(),
                ) + &road(
                    "3",
                    PLAIN,
                    Line(20.0, -50.0, FRAC_PI_2, 50.0, 0.0),
                    &link("s junction 9"),
                    &two_way(),
                ) + &direct(&[("1", "2", "start", "1>1 -1>-1"), ("1", "3", "end", "1>1 -1>-1")])),
            ),
            edges: &[
                "1:0:-1+ > 2:0:-1+",
                "1:0:1- > 3:0:1-",
                "2:0:1- > 1:0:1-",
                "3:0:-1+ > 1:0:-1+",
            ],
        },
        GraphMap {
            name: "direct junction where a ring closes",
            text: document(
                &(road(
                    "1",
                    PLAIN,
                    Line(40.0, 0.0, FRAC_PI_2, 80.0 * PI, 0.025),
                    &(link("p junction 9") + &link("s junction 9")),
                    &two_way(),
                ) + &road(
                    "2",
                    PLAIN,
                    Line(40.0, 0.0, FRAC_PI_2, 50.0, 0.0),
                    &link("p junction 9"),
                    &two_way(),
                ) + &direct(&[
                    ("1", "1", "start", "1>1 -1>-1"),
                    ("1", "2", "start", "1>1 -1>-1"),
                ])),
            ),
            edges: &["1:0:-1+ > 1:0:-1+ 2:0:-1+", "1:0:1- > 1:0:1-", "2:0:1- > 1:0:1-"],
        },
    ]
}

fn virtual_junction() -> GraphMap {
    let quarter = 15.0 * FRAC_PI_2;
    let two_way = section(0.0, &lane(1, ""), &lane(-1, ""));
    let inside = "junction=\"555\"";
    let roads = [
        road("1", PLAIN, Line(0.0, 0.0, 0.0, 120.0, 0.0), "", &two_way),
        road(
            "2",
            PLAIN,
            Line(60.0, -15.0, -FRAC_PI_2, 50.0, 0.0),
            &link("p junction 555"),
            &two_way,
        ),
        road(
            "5",
            inside,
            Line(45.0, 0.0, 0.0, quarter, -1.0 / 15.0),
            &(link_inside("predecessor", "1", 45.0) + &link("s road 2 start")),
            &section(0.0, "", &lane(-1, "p-1 s-1")),
        ),
        road(
            "6",
            inside,
            Line(60.0, -15.0, FRAC_PI_2, quarter, -1.0 / 15.0),
            &(link("p road 2 start") + &link_inside("successor", "1", 75.0)),
            &section(0.0, "", &lane(-1, "p1 s-1")),
        ),
    ];
    let connections = connection(
        "id=\"0\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"start\"",
        "-1>-1",
    ) + &connection(
        "id=\"1\" incomingRoad=\"2\" connectingRoad=\"6\" contactPoint=\"start\"",
        "1>-1",
    );
    let attributes = "type=\"virtual\" mainRoad=\"1\" sStart=\"45\" sEnd=\"75\" orientation=\"+\"";
    GraphMap {
        name: "virtual junction with a side road",
        text: document(&(roads.concat() + &junction("555", attributes, &connections))),
        edges: &["1:0:-1+ > 5:0:-1+", "2:0:1- > 6:0:-1+", "5:0:-1+ > 2:0:-1+", "6:0:-1+ > 1:0:-1+"],
    }
}

/// A side road without connecting roads (OpenDRIVE 1.5 to 1.7): into it at `successor` from s = 60 m, and out of it again.
pub fn side_road(successor: &str) -> String {
    let two_way = section(0.0, &lane(1, ""), &lane(-1, ""));
    let roads = road("1", PLAIN, Line(0.0, 0.0, 0.0, 120.0, 0.0), "", &two_way)
        + &road("2", PLAIN, Line(60.0, -3.5, -FRAC_PI_2, 50.0, 0.0), "", &two_way);
    let end = |name: &str, place: &str| format!("<{name} elementType=\"road\" {place}/>");
    let main = "elementId=\"1\" elementS=\"60\" elementDir=\"+\"";
    let out = "elementId=\"2\" elementS=\"0\" elementDir=\"-\"";
    let one_way = |id: usize, from: &str, to: &str, links: &str| {
        let ends = end("predecessor", from) + &end("successor", to);
        let empty = connection(&format!("id=\"{id}\" type=\"virtual\""), links);
        empty.replace("</connection>", &(ends + "</connection>"))
    };
    let connections = one_way(0, main, successor, "-1>-1") + &one_way(1, out, main, "1>-1");
    let attributes = "type=\"virtual\" mainRoad=\"1\" sStart=\"55\" sEnd=\"65\" orientation=\"+\"";
    document(&(roads + &junction("555", attributes, &connections)))
        .replace("revMinor=\"8\"", "revMinor=\"7\"")
}

fn virtual_connections() -> GraphMap {
    GraphMap {
        name: "virtual connections of a side road",
        text: side_road("elementId=\"2\" elementS=\"0\" elementDir=\"+\""),
        edges: &["1:0:-1+ > 2:0:-1+", "2:0:1- > 1:0:-1+"],
    }
}

/// A lane of 2 m for a class of travellers.
fn narrow(id: i32, kind: &str) -> String {
    wide(id, "", "", "a=\"2\" b=\"0\" c=\"0\" d=\"0\"", "")
        .replace("type=\"driving\"", &format!("type=\"{kind}\""))
}

/// A road with ways for walking or cycling on both sides and a path across it at s = 54 m, to whose end `from` on the road
/// leads.
pub fn crossing_path(kind: &str, from: i32) -> String {
    let left = narrow(2, kind) + &lane(1, "");
    let right = lane(-1, "") + &narrow(-2, kind);
    let roads = road("1", PLAIN, Line(0.0, 0.0, 0.0, 120.0, 0.0), "", &section(0.0, &left, &right))
        + &road(
            "2",
            "junction=\"555\"",
            Line(54.0, -4.5, FRAC_PI_2, 9.0, 0.0),
            "",
            &section(0.0, "", &narrow(-1, kind)),
        );
    let path = format!(
        "<crossPath id=\"0\" crossingRoad=\"2\" roadAtStart=\"1\" roadAtEnd=\"1\">\n\
         <startLaneLink s=\"54\" from=\"-2\" to=\"-1\"/>\n<endLaneLink s=\"54\" from=\"{from}\" to=\"-1\"/>\n</crossPath>\n"
    );
    let attributes =
        "type=\"virtual\" mainRoad=\"1\" sStart=\"52\" sEnd=\"58\" orientation=\"none\"";
    document(&(roads + &junction("555", attributes, &path)))
}

fn path_across() -> GraphMap {
    GraphMap {
        name: "path across a road",
        text: crossing_path("walking", 2),
        edges: &[
            "1:0:-2+ > 2:0:-1+",
            "1:0:-2- > 2:0:-1+",
            "1:0:2+ > 2:0:-1-",
            "1:0:2- > 2:0:-1-",
            "2:0:-1+ > 1:0:2+ 1:0:2-",
            "2:0:-1- > 1:0:-2+ 1:0:-2-",
        ],
    }
}

/// Two lanes of a ramp that leaves a road: both follow one lane and part slowly. `zone` goes to the lane links.
pub fn slow_exit(zone: &str) -> String {
    let roads = [
        road(
            "1",
            PLAIN,
            Line(0.0, 0.0, 0.0, 100.0, 0.0),
            &link("s junction 100"),
            &section(0.0, "", &lane(-1, "")),
        ),
        road(
            "2",
            PLAIN,
            Line(100.0, 0.0, 0.0, 200.0, 0.0),
            &link("p junction 100"),
            &section(0.0, "", &lane(-1, "")),
        ),
        road(
            "3",
            PLAIN,
            Line(100.0, 0.0, 0.0, 200.0, -0.001),
            &link("p junction 100"),
            &section(0.0, "", &lane(-1, "")),
        ),
    ];
    let connection = |id: usize, road: usize| {
        let attributes = "contactPoint=\"start\" incomingRoad=\"1\"";
        connection(&format!("id=\"{id}\" linkedRoad=\"{road}\" {attributes}"), "-1>-1")
            .replace("to=\"-1\"", &format!("to=\"-1\"{zone}"))
    };
    let connections = connection(0, 2) + &connection(1, 3);
    document(&(roads.concat() + &junction("100", "type=\"direct\"", &connections)))
}

fn left_hand_traffic() -> GraphMap {
    let attributes = "junction=\"-1\" rule=\"LHT\"";
    let inside = "junction=\"7\" rule=\"LHT\"";
    let roads = [
        road(
            "1",
            attributes,
            Line(0.0, 0.0, 0.0, 50.0, 0.0),
            &link("s junction 7"),
            &section(0.0, &lane(1, ""), &lane(-1, "")),
        ),
        road(
            "2",
            attributes,
            Line(70.0, 0.0, 0.0, 50.0, 0.0),
            &link("p junction 7"),
            &section(0.0, &lane(1, ""), &lane(-1, "")),
        ),
        road(
            "5",
            inside,
            Line(50.0, 0.0, 0.0, 20.0, 0.0),
            &(link("p road 1 end") + &link("s road 2 start")),
            &section(0.0, &lane(1, "p1 s1"), ""),
        ),
        road(
            "6",
            inside,
            Line(70.0, 0.0, PI, 20.0, 0.0),
            &(link("p road 2 start") + &link("s road 1 end")),
            &section(0.0, &lane(1, "p-1 s-1"), ""),
        ),
    ];
    let connections = connection(
        "id=\"0\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"start\"",
        "1>1",
    ) + &connection(
        "id=\"1\" incomingRoad=\"2\" connectingRoad=\"6\" contactPoint=\"start\"",
        "-1>1",
    );
    GraphMap {
        name: "left-hand traffic",
        text: document(&(roads.concat() + &junction("7", "", &connections))),
        edges: &["1:0:1+ > 5:0:1+", "2:0:-1- > 6:0:1+", "5:0:1+ > 2:0:1+", "6:0:1+ > 1:0:-1-"],
    }
}

/// Roads apart from each other that turn so tightly to the left that their lane comes near the centre of the turn.
pub fn tight_turns() -> String {
    let turn = |i: u32| {
        let line = Line(50.0 * f64::from(i), 0.0, 0.0, 8.0, 0.16 + 0.01 * f64::from(i));
        road(&i.to_string(), "junction=\"-1\"", line, "", &section(0.0, &lane(1, ""), ""))
    };
    document(&(0..8).map(turn).collect::<String>())
}

/// A circle that begins where it ends.
pub fn circle(radius: f64) -> String {
    let lanes = section(0.0, &lane(1, "p1 s1"), &lane(-1, "p-1 s-1"));
    let links = link("p road 1 end") + &link("s road 1 start");
    let line = Line(radius, 0.0, FRAC_PI_2, 2.0 * PI * radius, 1.0 / radius);
    document(&road("1", PLAIN, line, &links, &lanes))
}

fn ring_road() -> GraphMap {
    GraphMap {
        name: "ring road that links to itself",
        text: circle(40.0),
        edges: &["1:0:-1+ > 1:0:-1+", "1:0:1- > 1:0:1-"],
    }
}

fn roundabout() -> GraphMap {
    let arc = |i: usize| {
        let (here, before, after) = (i + 1, (i + 3) % 4 + 1, (i + 1) % 4 + 1);
        let angle = i as f64 * FRAC_PI_2;
        let line =
            Line(20.0 * angle.cos(), 20.0 * angle.sin(), angle + FRAC_PI_2, 10.0 * PI, 1.0 / 20.0);
        let links = link(&format!("p road {before} end")) + &link(&format!("s road {after} start"));
        road(&here.to_string(), PLAIN, line, &links, &section(0.0, "", &lane(-1, "p-1 s-1")))
    };
    GraphMap {
        name: "roundabout",
        text: document(&(0..4).map(arc).collect::<String>()),
        edges: &[
            "1:0:-1+ > 2:0:-1+",
            "2:0:-1+ > 3:0:-1+",
            "3:0:-1+ > 4:0:-1+",
            "4:0:-1+ > 1:0:-1+",
        ],
    }
}

/// Two roads in a line with a junction between them; the connecting road as given.
fn through_junction(connecting: &str, connection: &str) -> String {
    let right = section(0.0, "", &lane(-1, ""));
    let roads = road("1", PLAIN, Line(0.0, 0.0, 0.0, 100.0, 0.0), &link("s junction 7"), &right)
        + &road("2", PLAIN, Line(120.0, 0.0, 0.0, 100.0, 0.0), &link("p junction 7"), &right);
    document(&(roads + connecting + &junction("7", "", connection)))
}

fn connecting_road_backwards() -> GraphMap {
    let connecting = road(
        "5",
        "junction=\"7\"",
        Line(120.0, 0.0, PI, 20.0, 0.0),
        &(link("p road 2 start") + &link("s road 1 end")),
        &section(0.0, &lane(1, "p-1 s-1"), ""),
    );
    let attributes = "id=\"0\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"end\"";
    GraphMap {
        name: "connecting road with contactPoint end",
        text: through_junction(&connecting, &connection(attributes, "-1>1")),
        edges: &["1:0:-1+ > 5:0:1-", "5:0:1- > 2:0:-1+"],
    }
}

fn no_lane_links() -> GraphMap {
    let connecting = road(
        "5",
        "junction=\"7\"",
        Line(100.0, 0.0, 0.0, 20.0, 0.0),
        &(link("p road 1 end") + &link("s road 2 start")),
        &section(0.0, "", &lane(-1, "p-1 s-1")),
    );
    let attributes = "id=\"0\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"start\"";
    GraphMap {
        name: "connection without lane links",
        text: through_junction(&connecting, &connection(attributes, "")),
        edges: &["1:0:-1+ > 5:0:-1+", "5:0:-1+ > 2:0:-1+"],
    }
}

fn both_ends_at_one_junction() -> GraphMap {
    let half = 20.0 * PI;
    let inside = "junction=\"9\"";
    let roads = [
        road(
            "1",
            PLAIN,
            Line(20.0, 0.0, FRAC_PI_2, half, 0.05),
            &(link("p junction 9") + &link("s junction 9")),
            &section(0.0, &lane(1, ""), &lane(-1, "")),
        ),
        road(
            "5",
            inside,
            Line(-20.0, 0.0, -FRAC_PI_2, half, 0.05),
            &(link("p road 1 end") + &link("s road 1 start")),
            &section(0.0, "", &lane(-1, "p-1 s-1")),
        ),
        road(
            "6",
            inside,
            Line(20.0, 0.0, -FRAC_PI_2, half, -0.05),
            &(link("p road 1 start") + &link("s road 1 end")),
            &section(0.0, "", &lane(-1, "p1 s1")),
        ),
    ];
    let connections = connection(
        "id=\"0\" incomingRoad=\"1\" connectingRoad=\"5\" contactPoint=\"start\"",
        "-1>-1",
    ) + &connection(
        "id=\"1\" incomingRoad=\"1\" connectingRoad=\"6\" contactPoint=\"start\"",
        "1>-1",
    );
    GraphMap {
        name: "both ends of a road at one junction",
        text: document(&(roads.concat() + &junction("9", "", &connections))),
        edges: &["1:0:-1+ > 5:0:-1+", "1:0:1- > 6:0:-1+", "5:0:-1+ > 1:0:-1+", "6:0:-1+ > 1:0:1-"],
    }
}

fn both_directions() -> GraphMap {
    let width = "a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"";
    let both = |links| section(0.0, "", &wide(-1, " direction=\"both\"", links, width, ""));
    let reversed = |links| section(0.0, "", &wide(-1, " direction=\"reversed\"", links, width, ""));
    let roads = [
        road("1", PLAIN, Line(0.0, 0.0, 0.0, 50.0, 0.0), &link("s road 2 start"), &both("s-1")),
        road(
            "2",
            PLAIN,
            Line(50.0, 0.0, 0.0, 50.0, 0.0),
            &(link("p road 1 end") + &link("s road 3 start")),
            &both("p-1 s-1"),
        ),
        road("3", PLAIN, Line(100.0, 0.0, 0.0, 50.0, 0.0), &link("p road 2 end"), &reversed("p-1")),
    ];
    GraphMap {
        name: "lanes in both directions",
        text: document(&roads.concat()),
        // The third road's lane runs towards the others: only their other way is entered from it, and the way towards it
        // ends.
        edges: &["1:0:-1+ > 2:0:-1+", "2:0:-1- > 1:0:-1-", "3:0:-1- > 2:0:-1-"],
    }
}

fn merge_and_split() -> GraphMap {
    let narrowing = "a=\"3.5\" b=\"-0.07\" c=\"0\" d=\"0\"";
    let opening = "a=\"0\" b=\"0.07\" c=\"0\" d=\"0\"";
    let sections = [
        section(0.0, "", &(lane(-1, "s-1") + &wide(-2, "", "s-1", narrowing, ""))),
        section(50.0, "", &lane(-1, "p-1 p-2 s-1 s-2")),
        section(100.0, "", &(lane(-1, "p-1") + &wide(-2, "", "p-1", opening, ""))),
    ];
    GraphMap {
        name: "merge and split",
        text: document(&road("1", PLAIN, Line(0.0, 0.0, 0.0, 150.0, 0.0), "", &sections.concat())),
        edges: &["1:0:-1+ > 1:1:-1+", "1:0:-2+ > 1:1:-1+", "1:1:-1+ > 1:2:-1+ 1:2:-2+"],
    }
}
