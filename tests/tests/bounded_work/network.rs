//! Rules and links of the whole network: what belongs together is looked up, not looked through.

use super::*;
use mapd_rules::{Checker, Settings};
use mapd_xodr::{Limits, Reader};

/// Every pair of lanes looked through all priorities of the map.
#[test]
fn priorities_are_looked_up_not_looked_through() {
    let mut text = String::from(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>"#);
    for id in 0..100 {
        let heading = f64::from(id) * 0.031;
        let (x, y) = (-50.0 * heading.cos(), -50.0 * heading.sin());
        let _ = write!(
            text,
            r#"<road id="{id}" length="100" junction="9"><planView><geometry s="0" x="{x:?}" y="{y:?}" hdg="{heading:?}" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        );
    }
    text.push_str(r#"<junction id="9" name="">"#);
    for road in 0..100_000 {
        let _ = write!(text, r#"<priority high="{}" low="1"/>"#, 1000 + road);
    }
    // Of two rows that contradict each other the first counts.
    text.push_str(
        r#"<priority high="3" low="5"/><priority high="5" low="3"/></junction></OpenDRIVE>"#,
    );
    let rows = rows(soon("priorities of a junction", &text));
    let found =
        rows.conflicts.iter().filter(|row| row.reason == RelationReason::JunctionPriority.code());
    let relations: Vec<u8> = found.map(|row| row.relation).collect();
    assert_eq!(relations, [Relation::Priority.code(), Relation::Yields.code()]);
    let pairs = rows.conflicts.iter().filter(|row| row.relation != NO_RELATION).count();
    assert!(pairs > 9000, "{pairs} pairs");
}

/// From each signal all that it depends on through others was searched anew.
#[test]
fn dependencies_of_signals_are_followed_once() {
    const COUNT: usize = 20_000;
    let signals = |last: &str| {
        let mut text = String::from("<signals>");
        for id in 0..COUNT {
            let next = if id + 1 < COUNT { (id + 1).to_string() } else { last.to_owned() };
            let _ = write!(
                text,
                r#"<signal id="{id}" s="0.5" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE"><dependency id="{next}"/></signal>"#
            );
        }
        let road = metre("1", 0.0).replace("</road>", &(text + "</signals></road>"));
        soon("a chain of dependencies", &map_of(&road))
    };
    const CYCLE: &str = "mapd:xodr:1.4.0:topology.dependency_cycle";
    for (last, cycles) in [("nowhere", 0), ("0", 1), ("19998", 1)] {
        let compiled = signals(last);
        assert_eq!(count(&compiled, CYCLE), cycles, "the last depends on {last}");
        assert_eq!(rows(compiled).signals.len(), COUNT, "none is lost");
    }
}

/// A road whose sections but for the first say what lies to the left alone, so that its lanes to the right go on past them.
fn going_on(lanes: usize, sections: usize) -> String {
    let lane = |id: i32| {
        format!(
            r#"<lane id="{id}" type="driving"><width sOffset="0" a="0.1" b="0" c="0" d="0"/></lane>"#
        )
    };
    let (left, center) =
        (format!("<left>{}</left>", lane(1)), r#"<center><lane id="0" type="none"/></center>"#);
    let right: String = (1..=lanes as i32).map(|id| lane(-id)).collect();
    let mut text =
        format!(r#"<laneSection s="0">{left}{center}<right>{right}</right></laneSection>"#);
    for at in 1..=sections {
        let s = at as f64 / (sections + 1) as f64;
        let _ = write!(
            text,
            r#"<laneSection s="{s:?}" singleSide="true">{left}{center}</laneSection>"#
        );
    }
    text
}

/// Each lane that went on past a section for the other side became a row there, so that rows grew with the square of the text.
#[test]
fn lanes_that_go_on_past_sections_for_the_other_side_are_limited() {
    const LIMIT: usize = 64;
    const SECTIONS: usize = 300;
    let whole = metre("1", 0.0);
    let start = whole.find("<laneSection").expect("a section");
    let end = whole.find("</lanes>").expect("an end");
    let road = |lanes| {
        let sections = going_on(lanes, SECTIONS);
        map_of(&format!("{}{sections}{}", &whole[..start], &whole[end..]))
    };
    let rows = rows(soon("lanes that go on", &road(LIMIT)));
    assert_eq!(rows.lanes.len(), (SECTIONS + 1) * (LIMIT + 2));
    let what = ("mapd:compile.too_large", "OpenDRIVE/road[@id=1]/lanes/laneSection");
    check("more lanes that go on", &road(2 * LIMIT), what);
}

/// The network that the rules examine.
fn examined(text: &str) -> mapd_rules::Whole {
    let mut reader = Reader::new(text.as_bytes(), Limits::default());
    let mut checker = Checker::new(&Settings::default());
    while let Some(mut item) = reader.next().expect("reading works") {
        checker.item(&mut item);
    }
    checker.whole()
}

/// Each lane that goes on past sections for the other side was added up in the cross-section at each of them.
#[test]
fn cross_sections_of_lanes_that_go_on_are_limited() {
    // As `LANES_OF_A_ROAD` of the rules' network.
    const LIMIT: usize = 1 << 21;
    let whole = metre("1", 0.0);
    let start = whole.find("<laneSection").expect("a section");
    let end = whole.find("</lanes>").expect("an end");
    let kept = |lanes: usize, sections: usize| {
        let road = going_on(lanes, sections);
        let text = map_of(&format!("{}{road}{}", &whole[..start], &whole[end..]));
        let whole = examined(&text);
        whole.network().stations_of(&whole.network().roads[0]).len()
    };
    // A section's start each, and the road's end.
    assert_eq!(kept(50, 1000), 1002);
    let (lanes, sections) = (2000, 3000);
    // With the lane to the left; one cross-section more at the road's end.
    assert_eq!(kept(lanes, sections), LIMIT / (lanes + 1) + 1);
}

/// For each junction with a boundary, all roads were looked at, and for each of them all segments of the boundary.
#[test]
fn roads_into_junctions_are_looked_up() {
    const COUNT: usize = 300;
    let mut text = String::new();
    for id in 0..COUNT {
        let link = format!(
            r#"<link><predecessor elementType="junction" elementId="j{id}"/><successor elementType="junction" elementId="j{}"/></link><planView>"#,
            id / 2
        );
        text += &metre(&id.to_string(), 2.0 * id as f64).replace("<planView>", &link);
    }
    for id in 0..COUNT {
        let _ = write!(
            text,
            r#"<junction id="j{id}" name=""><boundary><segment type="lane" roadId="{}" boundaryLane="-1" sStart="0" sEnd="1"/></boundary></junction>"#,
            id + usize::from(id % 2 == 1)
        );
    }
    let text = map_of(&text);
    let whole = examined(&text);
    let network = whole.network();
    // What the rule looks at: as many roads as there are links to junctions, not as many for each junction.
    let into = |id: usize| {
        let name = network.name_of(&format!("j{id}")).expect("the junction's id");
        network.roads_into(name).map(|road| network.name(road.id).to_owned()).collect::<Vec<_>>()
    };
    let looked: Vec<_> = (0..COUNT).map(into).collect();
    assert_eq!(looked.iter().map(Vec::len).sum::<usize>(), 2 * COUNT);
    assert_eq!(
        (looked[3].as_slice(), looked[COUNT - 1].len()),
        (&["3", "6", "7"].map(String::from)[..], 1)
    );
    // And what it finds: each road that leads in and has no segment, once for each end that does.
    let missing = |(id, roads): (usize, &Vec<String>)| {
        let own = (id + usize::from(id % 2 == 1)).to_string();
        roads.iter().filter(|road| **road != own).count()
    };
    let expected: usize = looked.iter().enumerate().map(missing).sum();
    let compiled = soon("junctions with boundaries", &text);
    let rule = "asam.net:xodr:1.8.0:junctions.boundary.segments_for_each_conn_road";
    let found: Vec<_> =
        compiled.diagnostics.iter().filter(|told| told.finding.rule == rule).collect();
    assert!(!found.is_empty() && found.len() <= expected, "{} of {expected}", found.len());
}

/// Points of boundaries grew with their segments, however often these go along one road.
#[test]
fn points_of_a_boundary_are_limited() {
    let segment =
        r#"<segment type="lane" roadId="1" boundaryLane="-1" sStart="start" sEnd="end"/>"#;
    let road = metre("1", 0.0).replace(r#"length="1""#, r#"length="90000""#);
    let text = map_of(&format!(
        r#"{road}<junction id="9" name=""><boundary>{}</boundary></junction>"#,
        segment.repeat(2000)
    ));
    let before = peak();
    let compiled = soon("a boundary of many segments", &text);
    assert!(peak() - before < 100 << 20, "{} bytes", peak() - before);
    let rule = "asam.net:xodr:1.8.0:junctions.boundary.segments_close_boundry";
    assert!(count(&compiled, rule) > 0);
}
