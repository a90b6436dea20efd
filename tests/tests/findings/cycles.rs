//! Cycles that a map must not have are errors like others: the policy decides what is left out for them.

use mapd_archive::{encode, verify};
use mapd_client::Snapshot;
use mapd_compiler::{
    Compilation, CompileOptions, CyclePolicy, OnError, PartKind, Policy, ReadOptions, Treatment,
    Verdict, check_from, compile_from,
};
use mapd_tests::graph_maps::*;

/// A road that no cycle has to do with.
fn apart() -> String {
    let line = Line(0.0, 500.0, 0.0, 100.0, 0.0);
    road("far", "junction=\"-1\"", line, "", &section(0.0, "", &lane(-1, "")))
}

/// A road with both ends at a junction, whose connecting road leads from its end to its start.
fn loop_at(name: &str, x: f64, length: f64) -> String {
    let (road_id, inside, junction_id) =
        (format!("{name}r"), format!("{name}c"), format!("{name}j"));
    let line = |x: f64| Line(x, 0.0, 0.0, length, 0.0);
    let own =
        link(&format!("p junction {junction_id}")) + &link(&format!("s junction {junction_id}"));
    let back = link(&format!("p road {road_id} end")) + &link(&format!("s road {road_id} start"));
    let attributes = format!(
        "id=\"{name}x\" incomingRoad=\"{road_id}\" connectingRoad=\"{inside}\" contactPoint=\"start\""
    );
    road(&road_id, "junction=\"-1\"", line(x), &own, &section(0.0, "", &lane(-1, "")))
        + &road(
            &inside,
            &format!("junction=\"{junction_id}\""),
            line(x + length),
            &back,
            &section(0.0, "", &lane(-1, "p-1 s-1")),
        )
        + &junction(&junction_id, "", &connection(&attributes, "-1>-1"))
}

/// Roads of a junction that lead into each other.
fn around() -> String {
    let one = |id: &str, other: &str, x: f64| {
        let links = link(&format!("p road {other} end")) + &link(&format!("s road {other} start"));
        let line = Line(x, 0.0, 0.0, 20.0, 0.0);
        road(id, "junction=\"7\"", line, &links, &section(0.0, "", &lane(-1, "p-1 s-1")))
    };
    one("5", "6", 0.0) + &one("6", "5", 20.0) + &junction("7", "", "")
}

/// A road of centimetres that is its own successor.
fn itself() -> String {
    let links = link("p road 1 end") + &link("s road 1 start");
    let line = Line(0.0, 0.0, 0.0, 0.04, 0.0);
    road("1", "junction=\"-1\"", line, &links, &section(0.0, "", &lane(-1, "p-1 s-1")))
}

fn compiled(text: &str, cycles: CyclePolicy, policy: &Policy) -> Compilation {
    let reading = ReadOptions { policy: policy.clone(), ..ReadOptions::default() };
    let options = CompileOptions { cycles, ..CompileOptions::default() };
    compile_from(|| Ok(text.as_bytes()), &reading, &options, &mut |_| {}).expect("reading works")
}

/// What a cycle is made of, under which policy of cycles it is an error by which rule, and the part that is left out for it.
type Case = (&'static str, String, CyclePolicy, &'static str, (PartKind, &'static str));

fn cases() -> Vec<Case> {
    use CyclePolicy::{All, Illegal};
    let (connection, road) = (PartKind::Connection, PartKind::Road);
    vec![
        (
            "a loop of centimetres through a junction",
            loop_at("a", 0.0, 0.04),
            Illegal,
            "mapd:graph.no_progress",
            (connection, "ax"),
        ),
        (
            "a road of centimetres that leads to itself",
            itself(),
            Illegal,
            "mapd:graph.no_progress",
            (road, "1"),
        ),
        (
            "a way around within a junction",
            around(),
            Illegal,
            "mapd:graph.junction_cycle",
            (road, "5"),
        ),
        (
            "a long loop through a junction where no cycle is allowed",
            loop_at("a", 0.0, 40.0),
            All,
            "mapd:graph.cycle",
            (connection, "ax"),
        ),
    ]
}

/// Compiles a map with a sound road beside it and proves what becomes of it.
fn check(what: &str, elements: &str, cycles: CyclePolicy, rule: &str, part: (PartKind, &str)) {
    let text = document(&(elements.to_owned() + &apart()));
    for on_error in [OnError::Quarantine, OnError::ReferenceLine, OnError::Reject] {
        let what = format!("{what}, {on_error:?}");
        let policy = Policy { on_error, ..Policy::default() };
        let compiled = compiled(&text, cycles, &policy);
        let found: Vec<_> =
            compiled.diagnostics.iter().filter(|d| d.rejects).map(|d| d.finding.rule).collect();
        assert_eq!(found, [rule], "{what}: {:#?}", compiled.diagnostics);
        if on_error == OnError::Reject {
            assert_eq!(compiled.verdict, Verdict::Rejected, "{what}");
            assert!(compiled.rows.is_none() && compiled.quarantined.is_empty(), "{what}");
            continue;
        }
        assert_eq!(compiled.verdict, Verdict::Quarantined, "{what}: {:#?}", compiled.diagnostics);
        let is_bare = on_error == OnError::ReferenceLine && part.0 == PartKind::Road;
        let treatment = if is_bare { Treatment::ReferenceLine } else { Treatment::Dropped };
        let lost: Vec<_> =
            compiled.quarantined.iter().map(|p| (p.kind, &*p.id, p.treatment, p.rule)).collect();
        assert_eq!(lost, [(part.0, part.1, treatment, rule)], "{what}");
        assert!(compiled.quarantined[0].line > 1, "{what}: no place");
        let bytes = encode(compiled.rows.as_ref().expect("a map"), &compiled.provenance);
        let bytes = bytes.expect("encodes");
        verify(&bytes).expect("verifies");
        let snapshot = Snapshot::from_bytes(bytes).expect("opens");
        assert!(snapshot.map().road_by_id("far").is_some(), "{what}");
        assert_eq!(snapshot.map().quarantined().len(), 1, "{what}");
        // Nothing leads around any more.
        let edges = snapshot.map().lane_nodes().flat_map(|node| node.edges());
        assert_eq!(edges.filter(|edge| edge.closes_loop()).count(), 0, "{what}");
    }
}

#[test]
fn a_forbidden_cycle_takes_out_the_smallest_part_that_breaks_it() {
    for (what, elements, cycles, rule, part) in cases() {
        check(what, &elements, cycles, rule, part);
    }
}

#[test]
fn a_cycle_that_is_only_reported_takes_out_nothing() {
    for (what, elements, ..) in cases() {
        let text = document(&(elements + &apart()));
        let compiled = compiled(&text, CyclePolicy::Report, &Policy::default());
        assert_eq!(compiled.verdict, Verdict::Accepted, "{what}: {:#?}", compiled.diagnostics);
    }
}

/// Errors in one map: more than are named of findings that are no errors.
const MANY: usize = 130;

#[test]
fn many_errors_of_one_rule_take_out_as_many_parts() {
    let many = |one: &dyn Fn(usize) -> String| {
        document(&((0..MANY).map(one).collect::<String>() + &apart()))
    };
    let loops = many(&|i| loop_at(&format!("l{i}"), 10.0 * i as f64, 0.04));
    let links = many(&|i| {
        let line = |x: f64| Line(x, -10.0 * i as f64, 0.0, 50.0, 0.0);
        let one = section(0.0, "", &lane(-1, ""));
        let (leads, back) = (link(&format!("s junction {i}")), link(&format!("p road r{i} end")));
        let attributes = format!(
            "id=\"x\" incomingRoad=\"r{i}\" connectingRoad=\"c{i}\" contactPoint=\"start\""
        );
        road(&format!("r{i}"), "junction=\"-1\"", line(0.0), &leads, &one)
            + &road(&format!("c{i}"), &format!("junction=\"{i}\""), line(50.0), &back, &one)
            + &junction(&i.to_string(), "", &connection(&attributes, "-1>-1 -1>-5"))
    });
    for (what, text, rule) in
        [("loops", loops, "mapd:graph.no_progress"), ("links", links, "mapd:graph.missing_lane")]
    {
        let compiled = compiled(&text, CyclePolicy::Illegal, &Policy::default());
        assert_eq!(compiled.verdict, Verdict::Quarantined, "{what}");
        let lost = compiled.quarantined.iter().filter(|part| part.rule == rule).count();
        assert_eq!((lost, compiled.quarantined.len()), (MANY, MANY), "{what}");
        // What only checks says the same.
        let checked = check_from(|| Ok(text.as_bytes()), &ReadOptions::default(), &mut |_| {})
            .expect("reads");
        assert_eq!(checked.verdict, Verdict::Quarantined, "{what}");
        assert_eq!(checked.quarantined, compiled.quarantined, "{what}");
    }
}
