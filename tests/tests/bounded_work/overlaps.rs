//! Roads that lie over one another: not every pair is compared.

use super::*;

/// Each pair of stretches of two roads looked through all junctions of one road for each of the other's.
#[test]
fn junctions_of_overlapping_roads_are_looked_up() {
    const JUNCTIONS: usize = 20_000;
    let overlaps = |is_shared: bool| {
        let mut text = String::from(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>"#);
        for (id, y) in [(1, 0.0), (2, 1.0)] {
            let _ = write!(
                text,
                r#"<road id="{id}" length="1000" junction="-1"><planView><geometry s="0" x="0" y="{y:?}" hdg="0" length="1000"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
            );
        }
        for junction in 0..JUNCTIONS {
            for road in [1, 2] {
                let _ = write!(
                    text,
                    r#"<junction id="{}"><connection id="0" incomingRoad="{road}" connectingRoad="{road}"/></junction>"#,
                    2 * junction + road
                );
            }
        }
        if is_shared {
            text.push_str(
                r#"<junction id="both"><connection id="0" incomingRoad="1" connectingRoad="2"/></junction>"#,
            );
        }
        text.push_str("</OpenDRIVE>");
        let compiled = soon("roads of many junctions", &text);
        let rules = compiled.diagnostics.iter().map(|told| told.finding.rule);
        rules.filter(|rule| rule.ends_with(":road.no_overlap_outside_junction")).count()
    };
    assert_eq!([true, false].map(overlaps), [0, 1]);
}

const OVERLAPS: &str = "mapd:compile.overlaps";

/// Each pair was compared and kept: 32 million, in gigabytes.
#[test]
fn roads_over_one_another_are_not_all_compared() {
    let at = |x: fn(u32) -> f64| {
        map_of(&(0..8000).map(|id| metre(&id.to_string(), x(id))).collect::<String>())
    };
    let before = peak();
    let compiled = soon("roads at one place", &at(|_| 0.0));
    assert!(peak() - before < 400 << 20, "{} bytes", peak() - before);
    assert_eq!(count(&compiled, OVERLAPS), 1);
    assert_eq!(rows(compiled).roads.len(), 8000);
    // Beside one another, nothing is cut short.
    let compiled = soon("roads in a row", &at(|id| f64::from(id) * 2.0));
    assert_eq!(count(&compiled, OVERLAPS), 0);
}

/// So were those that share an id, of which all but none are left out.
#[test]
fn roads_of_one_id_are_not_all_compared() {
    let text = map_of(&metre("1", 0.0).repeat(4000));
    let compiled = soon("roads of one id", &text);
    assert!(compiled.rows.is_none());
    assert!(count(&compiled, "asam.net:xodr:1.4.0:ids.id_unique_in_class") > 0);
}

/// Roads without anything, each of which is left out.
#[test]
fn empty_roads_are_left_out_at_once() {
    let roads: String =
        (0..25_000).map(|id| format!(r#"<road id="{id}" length="1" junction="-1"/>"#)).collect();
    let compiled = soon("empty roads", &map_of(&roads));
    assert!(compiled.rows.is_none());
}

/// Roads that lead to one junction lie over one another, and it is no fault: their pairs were looked at all the same.
#[test]
fn roads_of_one_junction_are_not_all_compared() {
    const EACH: usize = 3000;
    let mut text = String::new();
    for id in 0..EACH {
        let link = r#"<link><successor elementType="junction" elementId="9"/></link><planView>"#;
        text += &metre(&format!("in{id}"), -1.0).replace("<planView>", link);
        let link = format!(
            r#"<link><predecessor elementType="road" elementId="in{id}" contactPoint="end"/></link><planView>"#
        );
        let road = metre(&id.to_string(), 0.0).replace("<planView>", &link);
        text += &road.replace(r#"junction="-1""#, r#"junction="9""#);
    }
    text += r#"<junction id="9" name="">"#;
    for id in 0..EACH {
        let _ = write!(
            text,
            r#"<connection id="{id}" incomingRoad="in{id}" connectingRoad="{id}" contactPoint="start"><laneLink from="-1" to="-1"/></connection>"#
        );
    }
    let compiled = soon("connections of a junction", &map_of(&(text + "</junction>")));
    // Of one junction all of them are known to be of no interest at once: nothing is cut short.
    assert_eq!(count(&compiled, OVERLAPS), 0);
    assert_eq!(rows(compiled).connections.len(), EACH);
}
