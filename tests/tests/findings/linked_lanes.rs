//! What links of lanes break, within a road, between roads and through the connections of junctions.

use mapd_compiler::{ReadOptions, check_from};

const WIDTH_AT_START: &str = "road.lane.link.zero_width_at_start";
const WIDTH_AT_END: &str = "road.lane.link.zero_width_at_end";
const OPENS: &str = "road.lane.link.new_lane_appear";
const GAP: &str = "lane_smoothness.contact_point_no_horizontal_gaps";
const ONE_LINK: &str = "junctions.connection.one_link_to_incoming";
const WITHIN: &str = "junctions.connection.connect_road_no_incoming_road";
const LEVEL: &str = "road.lane.level_true_one_side";
const REDUNDANT: &str = "performance.avoid_redundant_info";
const MIX: &str = "road.lane.access.no_mix_of_deny_or_allow";
const ORPHAN: &str = "ref.orphan_lane";
const BEYOND: &str = "lane.section_boundaries";
const ALL: [&str; 11] = [
    WIDTH_AT_START,
    WIDTH_AT_END,
    OPENS,
    GAP,
    ONE_LINK,
    WITHIN,
    LEVEL,
    REDUNDANT,
    MIX,
    ORPHAN,
    BEYOND,
];

/// Checks a document of 1.8: of [`ALL`], it breaks these rules at these lines.
fn check(what: &str, inner: &str, due: &[(&str, u32)]) {
    let text = format!("<OpenDRIVE><header revMajor=\"1\" revMinor=\"8\"/>\n{inner}\n</OpenDRIVE>");
    let checked =
        check_from(|| Ok(text.as_bytes()), &ReadOptions::default(), &mut |_| {}).expect("reads");
    let found = checked.diagnostics.iter().filter_map(|diagnostic| {
        let rule = ALL.iter().find(|rule| diagnostic.finding.rule.ends_with(*rule))?;
        Some((*rule, diagnostic.line))
    });
    let mut found: Vec<_> = found.collect();
    let mut due = due.to_vec();
    found.sort_unstable();
    due.sort_unstable();
    assert_eq!(found, due, "{what}:\n{text}");
}

/// A road along x with these links, sections in lines of their own.
fn road(id: u32, x: f64, y: f64, junction: i32, link: &str, sections: &str) -> String {
    format!(
        "<road id=\"{id}\" length=\"10\" junction=\"{junction}\"><link>{link}</link><planView><geometry s=\"0\" x=\"{x}\" y=\"{y}\" hdg=\"0\" length=\"10\"><line/></geometry></planView><lanes>{sections}</lanes></road>\n"
    )
}

/// A section at s with lanes to the right.
fn right(s: f64, lanes: &str) -> String {
    format!(
        "<laneSection s=\"{s}\"><center><lane id=\"0\" type=\"none\"/></center><right>{lanes}</right></laneSection>"
    )
}

/// A lane of so much width that grows so fast, with more before its width.
fn lane(id: i32, width: f64, growth: f64, more: &str) -> String {
    format!(
        "<lane id=\"{id}\" type=\"driving\">{more}<width sOffset=\"0\" a=\"{width}\" b=\"{growth}\" c=\"0\" d=\"0\"/></lane>"
    )
}

/// Road 1 leads into road 2 of junction 9, whose connection is in line 4: lanes of road 1, place and lanes of road 2, links.
fn entry(into: &str, y: f64, within: &str, links: &str) -> String {
    road(
        1,
        0.0,
        0.0,
        -1,
        "<successor elementType=\"junction\" elementId=\"9\"/>",
        &right(0.0, into),
    ) + &road(
        2,
        10.0,
        y,
        9,
        "<predecessor elementType=\"road\" elementId=\"1\" contactPoint=\"end\"/>",
        &right(0.0, within),
    ) + &format!(
        "<junction id=\"9\" name=\"\"><connection id=\"0\" incomingRoad=\"1\" connectingRoad=\"2\" contactPoint=\"start\">{links}</connection></junction>"
    )
}

const STRAIGHT: &str = "<laneLink from=\"-1\" to=\"-1\"/>";
const SPLIT: &str = "<laneLink from=\"-1\" to=\"-1\"/><laneLink from=\"-1\" to=\"-2\"/>";

#[test]
fn connections_are_links_of_lanes_too() {
    let whole = lane(-1, 3.0, 0.0, "");
    let two = |second| lane(-1, 3.0, 0.0, "") + &lane(-2, second, 0.0, "");
    check("lanes that meet", &entry(&whole, 0.0, &whole, STRAIGHT), &[]);
    check("lanes beside one another", &entry(&whole, 0.05, &whole, STRAIGHT), &[(GAP, 4)]);
    let opens = entry(&whole, 0.0, &(lane(-1, 3.0, 0.0, "") + &lane(-2, 0.0, 0.3, "")), SPLIT);
    check("a lane that opens", &opens, &[(OPENS, 4), (WIDTH_AT_START, 4)]);
    let ends = entry(
        &(whole.clone() + &lane(-2, 3.0, -0.3, "")),
        0.0,
        &whole,
        "<laneLink from=\"-1\" to=\"-1\"/><laneLink from=\"-2\" to=\"-1\"/>",
    );
    check("a lane that ends", &ends, &[(WIDTH_AT_END, 4)]);
    let wide = lane(-1, 6.0, 0.0, "");
    check("a lane that splits", &entry(&wide, 0.0, &two(3.0), SPLIT), &[]);
    check("a lane that splits beside a gap", &entry(&wide, 0.0, &two(2.0), SPLIT), &[(GAP, 4)]);
    let level = whole.replace("type", "level=\"true\" type");
    check("a level lane", &entry(&level, 0.0, &whole, STRAIGHT), &[(LEVEL, 4)]);
    // A pair that links itself as well is told once, where it does.
    let back = lane(-1, 3.0, 0.0, "<link><predecessor id=\"-1\"/></link>");
    check("links twice", &entry(&whole, 0.05, &back, STRAIGHT), &[(GAP, 3)]);
}

#[test]
fn a_lane_of_several_successors_meets_all_of_them() {
    let successors = "<link><successor id=\"-1\"/><successor id=\"-2\"/></link>";
    let back = "<link><predecessor id=\"-1\"/></link>";
    let split = |second: f64| {
        let behind = lane(-1, 3.0, 0.0, back) + &lane(-2, second, 0.0, back);
        road(
            1,
            0.0,
            0.0,
            -1,
            "",
            &(right(0.0, &lane(-1, 6.0, 0.0, successors)) + &right(5.0, &behind)),
        )
    };
    check("two that fill it", &split(3.0), &[]);
    check("two that leave a gap", &split(2.0), &[(GAP, 2)]);
}

#[test]
fn roads_within_junctions_lead_into_none() {
    let whole = lane(-1, 3.0, 0.0, "");
    let two = entry(&whole, 0.0, &whole, STRAIGHT)
        + "\n<junction id=\"8\" name=\"\"><connection id=\"0\" incomingRoad=\"2\" connectingRoad=\"1\" contactPoint=\"start\"/></junction>";
    check("into another junction", &two, &[(WITHIN, 5)]);
}

#[test]
fn connections_link_lanes_that_lead_in() {
    let whole = lane(-1, 3.0, 0.0, "");
    let turned = entry(&whole, 0.0, &whole, STRAIGHT)
        .replace("\"-1\" type", "\"1\" type")
        .replace("right>", "left>")
        .replace("from=\"-1\" to=\"-1\"", "from=\"1\" to=\"1\"");
    check("lanes that lead out", &turned, &[(ONE_LINK, 4)]);
    let second = "<connection id=\"1\" incomingRoad=\"1\" connectingRoad=\"2\" contactPoint=\"start\"/></junction>";
    let twice = entry(&whole, 0.0, &whole, STRAIGHT).replace("</junction>", &format!("\n{second}"));
    check("a second connection", &twice, &[(ONE_LINK, 5)]);
}

#[test]
fn records_of_lanes() {
    let border = |a: f64| format!("<border sOffset=\"5\" a=\"{a}\" b=\"0\" c=\"0\" d=\"0\"/>");
    let lanes = |a| {
        format!(
            "<lane id=\"-1\" type=\"driving\"><border sOffset=\"0\" a=\"-3\" b=\"0\" c=\"0\" d=\"0\"/>\n{}</lane>",
            border(a)
        )
    };
    check(
        "a border that says nothing new",
        &road(1, 0.0, 0.0, -1, "", &right(0.0, &lanes(-3.0))),
        &[(REDUNDANT, 3)],
    );
    check(
        "a border that goes on elsewhere",
        &road(1, 0.0, 0.0, -1, "", &right(0.0, &lanes(-3.5))),
        &[],
    );
    let access = |offsets: [(&str, &str); 3]| {
        let records: Vec<_> = offsets
            .iter()
            .map(|(s, rule)| {
                format!(
                    "\n<access sOffset=\"{s}\" rule=\"{rule}\"><restriction type=\"bus\"/></access>"
                )
            })
            .collect();
        let whole = lane(-1, 3.0, 0.0, "");
        road(
            1,
            0.0,
            0.0,
            -1,
            "",
            &right(0.0, &whole.replace("</lane>", &(records.concat() + "</lane>"))),
        )
    };
    check("rules that follow", &access([("0", "allow"), ("1", "deny"), ("2", "allow")]), &[]);
    let mixed = access([("1", "allow"), ("1.0000015", "deny"), ("1.0000009", "allow")]);
    check("rules at one place, out of order", &mixed, &[(MIX, 5)]);
}

/// The left side goes on beside sections for the right one, and the other way round: lanes meet those of the last section
/// for their side.
#[test]
fn lanes_go_on_beside_sections_of_one_side() {
    let link = |links: &str| format!("<link>{links}</link>");
    let (before, after) = ("<predecessor id=\"ID\"/>", "<successor id=\"ID\"/>");
    let of = |id: &str, links: &str| {
        lane(id.parse().expect("an id"), 3.0, 0.0, &link(&links.replace("ID", id)))
    };
    let section = |s: u32, single: &str, left: Option<&str>, right: Option<&str>| {
        let side = |name: &str, id: &str, links: Option<&str>| {
            links.map(|links| format!("<{name}>{}</{name}>", of(id, links))).unwrap_or_default()
        };
        format!(
            "\n<laneSection s=\"{s}\"{single}>{}<center><lane id=\"0\" type=\"none\"/></center>{}</laneSection>",
            side("left", "1", left),
            side("right", "-1", right)
        )
    };
    let single = " singleSide=\"true\"";
    let both = format!("{before}{after}");
    let sections = [
        section(0, "", Some(after), Some(after)),
        section(2, single, None, Some(&both)),
        section(4, single, Some(&both), None),
        section(7, "", Some(before), Some(before)),
    ];
    check("sections of one side", &road(1, 0.0, 0.0, -1, "", &sections.concat()), &[]);
    // Records of a lane that goes on beside another section are within it.
    let long = sections.concat().replacen(
        "</lane></left>",
        "<width sOffset=\"3\" a=\"3\" b=\"0\" c=\"0\" d=\"0.001\"/></lane></left>",
        1,
    );
    check("a width beside the next section", &road(1, 0.0, 0.0, -1, "", &long), &[]);
    // One that is named beyond that is not there all the same.
    let orphan = sections.concat().replacen("<successor id=\"1\"/>", "<successor id=\"2\"/>", 1);
    check("a lane that is not there", &road(1, 0.0, 0.0, -1, "", &orphan), &[(ORPHAN, 3)]);
}

/// Findings of a rule in a document: paths and messages.
fn told(text: &str, rule: &str) -> Vec<(String, String)> {
    let checked =
        check_from(|| Ok(text.as_bytes()), &ReadOptions::default(), &mut |_| {}).expect("reads");
    let own = checked.diagnostics.iter().filter(|d| d.finding.rule.ends_with(rule));
    own.map(|d| (d.finding.path.clone(), d.finding.message.clone())).collect()
}

/// Roads 2 and 3, which are linked, with lanes of these links and the same directions of traffic. Road 3 may run the other way.
fn two(turned: bool, traffic: &str, links: [&str; 2], others: [&str; 2]) -> String {
    use mapd_tests::graph_maps::{Line, document, lane, link, road, section};
    let attributes = format!("junction=\"-1\"{traffic}");
    let road = |id: &str, line, ends: &str, [left, right]: [&str; 2]| {
        let lanes = section(0.0, &lane(1, left), &lane(-1, right));
        road(id, &attributes, line, &link(ends), &lanes)
    };
    let (line, ends) = match turned {
        false => (Line(50.0, 0.0, 0.0, 50.0, 0.0), "p road 2 end"),
        true => (Line(100.0, 0.0, std::f64::consts::PI, 50.0, 0.0), "s road 2 end"),
    };
    let contact = if turned { "s road 3 end" } else { "s road 3 start" };
    document(
        &(road("2", Line(0.0, 0.0, 0.0, 50.0, 0.0), contact, links)
            + &road("3", line, ends, others)),
    )
}

/// A link that neither side has was not seen: traffic ended there in silence.
#[test]
fn lanes_that_meet_are_linked() {
    const RULE: &str = "topology.missing_link";
    for traffic in ["", " rule=\"LHT\""] {
        let lost = |turned, links, others| -> Vec<String> {
            let found = told(&two(turned, traffic, links, others), RULE).into_iter();
            let road = |path: String| path.split('/').nth(1).map(str::to_owned).expect("a road");
            let lane = |path: &str| path.rsplit('/').next().map(str::to_owned).expect("a lane");
            let mut found: Vec<_> =
                found.map(|(path, _)| format!("{} {}", road(path.clone()), lane(&path))).collect();
            found.sort_unstable();
            found
        };
        let none: [String; 0] = [];
        assert_eq!(lost(false, ["s1", "s-1"], ["p1", "p-1"]), none, "{traffic}");
        assert_eq!(
            lost(false, ["s1", ""], ["p1", ""]),
            ["road[@id=2] lane[@id=-1]", "road[@id=3] lane[@id=-1]"]
        );
        assert_eq!(
            lost(false, ["", "s-1"], ["", "p-1"]),
            ["road[@id=2] lane[@id=1]", "road[@id=3] lane[@id=1]"]
        );
        // One side says it.
        assert_eq!(lost(false, ["s1", "s-1"], ["p1", ""]), none);
        assert_eq!(lost(true, ["s-1", "s1"], ["s-1", "s1"]), none);
        assert_eq!(
            lost(true, ["s-1", ""], ["", "s1"]),
            ["road[@id=2] lane[@id=-1]", "road[@id=3] lane[@id=1]"]
        );
    }
    let text = two(false, "", ["s1", ""], ["p1", ""]);
    let messages: Vec<_> = told(&text, RULE).into_iter().map(|(_, message)| message).collect();
    assert_eq!(
        messages,
        [
            "expected a link to lane -1 of road 3, which the lane meets at its end, found none on either side",
            "expected a link to lane -1 of road 2, which the lane meets at its start, found none on either side"
        ]
    );
    // Corners apart, another direction of traffic, nobody drives there.
    for (what, from, to) in [
        ("corners", "x=\"50\" y=\"0\"", "x=\"50\" y=\"0.02\""),
        (
            "a direction",
            "<lane id=\"-1\" type=\"driving\"",
            "<lane id=\"-1\" direction=\"reversed\" type=\"driving\"",
        ),
        ("a type", "<lane id=\"-1\" type=\"driving\"", "<lane id=\"-1\" type=\"shoulder\""),
        ("a width", "a=\"3.5\" b=\"0\"", "a=\"3\" b=\"0\""),
    ] {
        let at = text.rfind(from).unwrap_or_else(|| panic!("{what}: {text}"));
        let other = format!("{}{}", &text[..at], text[at..].replacen(from, to, 1));
        assert_eq!(told(&other, RULE), [], "{what}");
    }
    // Within a road, and where the connection of a junction has the link.
    let sections = right(0.0, &lane(-1, 3.0, 0.0, "")) + &right(5.0, &lane(-1, 3.0, 0.0, ""));
    let text = mapd_tests::graph_maps::document(&road(1, 0.0, 0.0, -1, "", &sections));
    assert_eq!(told(&text, RULE).len(), 2);
}

/// The finding named the road of the lane alone, which need not be the one that lacks the link.
#[test]
fn a_dead_lane_names_the_road_that_it_meets() {
    const RULE: &str = "topology.dead_lane";
    let text = two(false, "", ["s1", ""], ["p1", ""]);
    let found = told(&text, RULE);
    let message = |id: u32, end: &str| {
        format!(
            "expected a link of the lane with lane -1 of road {id}, which it meets at its {end}, found none at either end"
        )
    };
    let messages: Vec<_> = found.into_iter().map(|(_, message)| message).collect();
    assert_eq!(messages, [message(3, "end"), message(2, "start")]);
    // A road behind a junction, whose road 7 does not lead into it.
    use mapd_tests::graph_maps::{Line, document, lane, link, road, section};
    let into = road(
        "1",
        "junction=\"-1\"",
        Line(0.0, 0.0, 0.0, 20.0, 0.0),
        &link("s junction 9"),
        &section(0.0, "", &lane(-1, "")),
    );
    let within = road(
        "7",
        "junction=\"9\"",
        Line(20.0, 0.0, 0.0, 20.0, 0.0),
        &(link("p road 1 end") + &link("s road 2 start")),
        &section(0.0, "", &lane(-1, "p-1")),
    );
    let behind = road(
        "2",
        "junction=\"-1\"",
        Line(40.0, 0.0, 0.0, 20.0, 0.0),
        &link("p junction 9"),
        &section(0.0, "", &lane(-1, "")),
    );
    let attributes = r#"id="0" incomingRoad="1" connectingRoad="7" contactPoint="start""#;
    let junction = mapd_tests::graph_maps::junction(
        "9",
        "",
        &mapd_tests::graph_maps::connection(attributes, "-1>-1"),
    );
    let text = document(&(into + &within + &behind + &junction));
    let found = told(&text, RULE);
    let [(path, message)] = &found[..] else { panic!("{found:?}") };
    assert!(path.contains("road[@id=2]") && message.contains("lane -1 of road 7"), "{found:?}");
    // The entry is linked by the connection alone; the exit by nothing.
    let text = text.replace("<predecessor id=\"-1\"/>", "");
    let missing = told(&text, "topology.missing_link");
    assert_eq!(missing.len(), 1, "{missing:?}");
    assert!(missing[0].0.contains("road[@id=7]"), "{missing:?}");
}
