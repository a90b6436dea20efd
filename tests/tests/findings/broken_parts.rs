//! Every shape, reference, dependency and controller, valid and broken: what is wrong is a finding that names it, what stands
//! beside it stays, and the archive proves whatever the file says.

use mapd_compiler::{Compilation, Verdict};
use mapd_tests::damage::ask_everything;
use mapd_tests::object_maps::{ObjectRoad, PLAIN, compile, document};

use InsertionPoint::{Beside, InJunction, InObject, InObjects, InSignal, InSignals, Railway};
use Verdict::{Accepted, Quarantined};

/// Where a case's text stands.
#[derive(Clone, Copy, Debug)]
enum InsertionPoint {
    /// In the object `1`.
    InObject,
    /// In the road's `objects`.
    InObjects,
    /// In the signal `1`.
    InSignal,
    /// In the road's `signals`.
    InSignals,
    /// In the road's `railroad`.
    Railway,
    /// In the junction `7`, which has a reference line.
    InJunction,
    /// Beside the road.
    Beside,
}

/// What is tried, where, as it should be, what makes it wrong, the rule that says so, and what becomes of the map.
type Case = (
    &'static str,
    InsertionPoint,
    &'static str,
    (&'static str, &'static str),
    &'static str,
    Verdict,
);

const SIGNAL: &str = r#"s="20" t="-7" zOffset="2" orientation="+" dynamic="no" country="DE" type="274" subtype="-1" value="50" unit="km/h""#;

fn map(place: InsertionPoint, text: &str) -> String {
    let at = |wanted: InsertionPoint| {
        if std::mem::discriminant(&wanted) == std::mem::discriminant(&place) { text } else { "" }
    };
    let objects = format!(
        r#"<object id="1" type="pole" s="30" t="4" zOffset="0" length="2" width="2" height="3" orientation="none">{}</object>
<object id="beside" type="pole" s="40" t="8" zOffset="0" radius="0.2" orientation="none"/>{}"#,
        at(InObject),
        at(InObjects)
    );
    let signals = format!(
        r#"<signal id="1" {SIGNAL}>{}</signal><signal id="beside" {SIGNAL}/>{}"#,
        at(InSignal),
        at(InSignals)
    );
    let railway = match at(Railway) {
        "" => String::new(),
        railway => format!("<railroad>{railway}</railroad>"),
    };
    let junction = match at(InJunction) {
        "" => String::new(),
        inside => format!(
            r#"<junction id="7" name="square"><planView><geometry s="0" x="0" y="60" hdg="0" length="20"><line/></geometry></planView>{inside}</junction>"#
        ),
    };
    document(&ObjectRoad { version: "1.9", ..PLAIN }, &objects)
        .replace("</objects>", &format!("</objects><signals>{signals}</signals>{railway}"))
        .replace("</OpenDRIVE>", &format!("{junction}{}</OpenDRIVE>", at(Beside)))
}

fn rules(compiled: &Compilation) -> Vec<&str> {
    compiled.diagnostics.iter().map(|told| told.finding.rule).collect()
}

/// What is right is accepted without that finding; what is wrong is found, and the object and signal beside it are there.
fn check((what, place, valid, (from, to), rule, verdict): &Case) {
    let sound = compile(&map(*place, valid));
    assert_eq!(sound.verdict, Accepted, "{what}: {:?}", rules(&sound));
    assert!(!rules(&sound).contains(rule), "{what}: {rule} is told of what is right");
    assert!(valid.contains(from), "{what}: {from} is not part of it");
    let broken = compile(&map(*place, &valid.replacen(from, to, 1)));
    let told = rules(&broken);
    assert!(told.contains(rule), "{what}: {rule} is not among {told:?}");
    assert_eq!(broken.verdict, *verdict, "{what}: {told:?}");
    for compiled in [&sound, &broken] {
        let rows = compiled.rows.as_ref().expect("the map itself is sound");
        let bytes = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
        mapd_archive::verify(&bytes).unwrap_or_else(|error| panic!("{what}: {error}"));
        let snapshot = mapd_client::Snapshot::from_bytes(bytes).expect("opens");
        let map = snapshot.map();
        assert!(map.object_by_id("beside").is_some(), "{what}: the object beside it is gone");
        assert!(map.signal_by_id("beside").is_some(), "{what}: the signal beside it is gone");
        ask_everything(mapd_archive::encode(rows, &compiled.provenance).expect("encodes"));
    }
}

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Shapes.
    ("box", InObjects, r#"<object id="2" type="building" s="50" t="9" zOffset="0" length="4" width="2" height="3" orientation="none"/>"#, ("width=\"2\"", "width=\"-2\""), "mapd:xodr:1.4.0:object.size", Accepted),
    ("cylinder", InObjects, r#"<object id="2" type="tree" s="50" t="9" zOffset="0" radius="1" height="3" orientation="none"/>"#, ("radius=\"1\"", "radius=\"round\""), "mapd:value.type", Quarantined),
    ("box and cylinder", InObjects, r#"<object id="2" type="tree" s="50" t="9" zOffset="0" radius="1" height="3" orientation="none"/>"#, ("radius=\"1\"", "radius=\"1\" length=\"2\" width=\"2\""), "asam.net:xodr:1.7.0:road.object.circular_vs_angular", Accepted),
    ("corners on the road", InObject, r#"<outlines><outline id="0"><cornerRoad id="0" s="28" t="3" dz="0" height="1"/><cornerRoad id="1" s="32" t="3" dz="0" height="1"/><cornerRoad id="2" s="32" t="5" dz="0" height="1"/></outline></outlines>"#, ("s=\"32\" t=\"3\"", "s=\"far\" t=\"3\""), "mapd:value.type", Quarantined),
    ("corners of its own", InObject, r#"<outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/><cornerLocal id="1" u="-1" v="1" z="0" height="1"/><cornerLocal id="2" u="0" v="-1" z="0" height="1"/></outline></outlines>"#, ("id=\"1\"", "id=\"0\""), "asam.net:xodr:1.9.0:road.corner_local.sequential_id_values", Accepted),
    ("corners of both kinds", InObject, r#"<outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/><cornerLocal id="1" u="-1" v="1" z="0" height="1"/><cornerLocal id="2" u="0" v="-1" z="0" height="1"/></outline></outlines>"#, ("<cornerLocal id=\"2\" u=\"0\" v=\"-1\" z=\"0\"", "<cornerRoad id=\"2\" s=\"30\" t=\"2\" dz=\"0\""), "asam.net:xodr:1.x.0:road.corner_local.no_mixing_road_local", Accepted),
    ("an outline of 1.4", InObject, r#"<outline><cornerLocal u="1" v="1" z="0" height="1"/><cornerLocal u="-1" v="1" z="0" height="1"/></outline>"#, ("<cornerLocal u=\"-1\" v=\"1\" z=\"0\" height=\"1\"/>", ""), "mapd:compile.object_part", Accepted),
    ("curves", InObject, r#"<outlines><outline id="0" closed="true"><curveLocal id="0" u="0" v="-1" z="0" height="1" hdg="0" length="3.141592653589793"><arc curvature="1"/></curveLocal><curveLocal id="1" u="0" v="1" z="0" height="1" hdg="-1.5707963267948966" length="2"><line/></curveLocal></outline></outlines>"#, ("<arc curvature=\"1\"/>", ""), "mapd:structure.choice", Accepted),
    ("a cubic repetition", InObject, r#"<repeat s="10" length="20" distance="5" tStart="4" bT="0.1" cT="0" dT="0" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/>"#, ("bT=\"0.1\"", "bT=\"steep\""), "mapd:value.type", Quarantined),
    ("inner outlines", InObject, r#"<outlines><outline id="0" outer="true"><cornerLocal id="0" u="2" v="2" z="0" height="1"/><cornerLocal id="1" u="-2" v="2" z="0" height="1"/><cornerLocal id="2" u="0" v="-2" z="0" height="1"/></outline><outline id="1" outer="false"><cornerLocal id="3" u="0.5" v="0.5" z="0" height="1"/><cornerLocal id="4" u="-0.5" v="0.5" z="0" height="1"/><cornerLocal id="5" u="0" v="-0.5" z="0" height="1"/></outline></outlines>"#, ("outer=\"true\"", "outer=\"false\""), "asam.net:xodr:1.9.0:road.object.outline.exactly_one_outer", Accepted),
    ("markings", InObject, r#"<outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/><cornerLocal id="1" u="-1" v="1" z="0" height="1"/><cornerLocal id="2" u="0" v="-1" z="0" height="1"/></outline></outlines><markings><marking width="0.1" color="white" lineLength="1" spaceLength="0" startOffset="0" stopOffset="0"><cornerReference id="0"/><cornerReference id="2"/></marking></markings>"#, ("<cornerReference id=\"2\"/>", "<cornerReference id=\"9\"/>"), "asam.net:xodr:1.9.0:road.object.marking.complete_or_partial_on_outline", Accepted),
    ("borders", InObject, r#"<outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/><cornerLocal id="1" u="-1" v="1" z="0" height="1"/><cornerLocal id="2" u="0" v="-1" z="0" height="1"/></outline></outlines><borders><border width="0.2" type="concrete" outlineId="0" useCompleteOutline="true"/></borders>"#, ("outlineId=\"0\"", "outlineId=\"8\""), "mapd:xodr:1.5.0:ref.border_outline", Accepted),
    ("a skeleton", InObject, r#"<skeleton><polyline id="1"><vertexLocal id="1" u="0" v="0" z="0"/><vertexLocal id="2" u="0" v="0" z="6"/></polyline></skeleton>"#, ("<vertexLocal id=\"2\" u=\"0\" v=\"0\" z=\"6\"/>", ""), "mapd:compile.object_part", Accepted),
    ("a repetition", InObject, r#"<repeat s="10" length="20" distance="5" tStart="4" tEnd="4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/>"#, ("length=\"20\"", "length=\"200\""), "asam.net:xodr:1.9.0:road.object.repeating.valid_s_length", Accepted),
    ("a swept repetition", InObject, r#"<repeat s="10" length="20" distance="0" tStart="4" tEnd="4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/>"#, ("s=\"10\"", "s=\"many\""), "mapd:value.type", Quarantined),
    ("a parking space", InObject, r#"<parkingSpace access="all"/>"#, ("access=\"all\"", "access=\"nobody\""), "mapd:value.enumeration", Accepted),
    ("an object's validity", InObject, r#"<validity fromLane="-2" toLane="-1"/>"#, ("fromLane=\"-2\" toLane=\"-1\"", "fromLane=\"-1\" toLane=\"-2\""), "asam.net:xodr:1.7.0:road.object.validty.from_lower_equal_to", Accepted),
    ("a bridge", InObjects, r#"<bridge id="b" s="10" length="20" type="steel"/>"#, ("length=\"20\"", "length=\"200\""), "mapd:xodr:1.4.0:structure.on_road", Accepted),
    ("a tunnel", InObjects, r#"<tunnel id="t" s="10" length="20" type="standard"/>"#, ("s=\"10\"", "s=\"deep\""), "mapd:value.type", Quarantined),
    ("a reference to an object", InObjects, r#"<objectReference id="1" s="5" t="0" orientation="none"/>"#, ("id=\"1\"", "id=\"9\""), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("an object of a junction", InJunction, r#"<objects><object id="j" type="tree" s="5" t="2" zOffset="0" radius="1" orientation="none"/></objects>"#, ("s=\"5\"", "s=\"here\""), "mapd:value.type", Quarantined),
    // Signals.
    ("a signal's validity", InSignal, r#"<validity fromLane="-2" toLane="-1"/>"#, ("fromLane=\"-2\" toLane=\"-1\"", "fromLane=\"-1\" toLane=\"-2\""), "asam.net:xodr:1.7.0:road.signal.reference.from_lower_equal_to", Accepted),
    ("a validity's lanes", InSignal, r#"<validity fromLane="-1" toLane="-1"/>"#, ("fromLane=\"-1\" toLane=\"-1\"", "fromLane=\"-9\" toLane=\"-8\""), "mapd:xodr:1.4.0:ref.validity_lanes", Accepted),
    ("a light", InSignals, r#"<signal id="2" s="50" t="-700" zOffset="3" orientation="+" dynamic="yes" country="OpenDRIVE" type="1000001" subtype="-1"><validity fromLane="-1" toLane="-1"/></signal>"#, ("fromLane=\"-1\" toLane=\"-1\"", "fromLane=\"-9\" toLane=\"-9\""), "mapd:compile.signal_lanes", Accepted),
    ("a place on the road", InSignals, r#"<signal id="2" s="50" t="-7" zOffset="3" orientation="+" dynamic="no" country="DE" type="206" subtype="-1"/>"#, ("s=\"50\"", "s=\"500\""), "mapd:xodr:1.4.0:signal.on_road", Accepted),
    ("a signal's place", InSignals, r#"<signal id="2" s="50" t="-7" zOffset="3" orientation="+" dynamic="no" country="DE" type="206" subtype="-1"/>"#, ("t=\"-7\"", "t=\"right\""), "mapd:value.type", Quarantined),
    ("a dependency", InSignal, r#"<dependency id="beside"/>"#, ("beside", "nowhere"), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("a dependency on itself", InSignal, r#"<dependency id="beside"/>"#, ("beside", "1"), "mapd:xodr:1.4.0:topology.dependency_cycle", Accepted),
    ("a reference to a signal", InSignals, r#"<signalReference id="1" s="5" t="0" orientation="+"/>"#, ("id=\"1\"", "id=\"9\""), "mapd:compile.signal_reference", Accepted),
    ("a reference's lanes", InSignals, r#"<signalReference id="1" s="5" t="0" orientation="+"><validity fromLane="-2" toLane="-1"/></signalReference>"#, ("fromLane=\"-2\" toLane=\"-1\"", "fromLane=\"-1\" toLane=\"-2\""), "asam.net:xodr:1.7.0:road.signal.reference.from_lower_equal_to", Accepted),
    ("a link to an object", InSignal, r#"<reference elementType="object" elementId="beside"/>"#, ("beside", "nowhere"), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("a link to a signal", InSignal, r#"<reference elementType="signal" elementId="beside"/>"#, ("beside", "nowhere"), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("a place in space", InSignal, r#"<positionInertial x="5" y="6" z="7" hdg="1"/>"#, ("x=\"5\"", "x=\"east\""), "mapd:value.type", Quarantined),
    ("a place on another road", InSignal, r#"<positionRoad roadId="1" s="5" t="6" zOffset="7" hOffset="1"/>"#, ("roadId=\"1\"", "roadId=\"9\""), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    // Controllers and groups.
    ("a controller", Beside, r#"<controller id="c"><control signalId="1"/><control signalId="beside"/></controller>"#, ("signalId=\"1\"", "signalId=\"9\""), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("a controller without signals", Beside, r#"<controller id="c"><control signalId="1"/></controller>"#, ("<control signalId=\"1\"/>", ""), "asam.net:xodr:1.7.0:road.signal.controller.valid_for_signals", Accepted),
    ("a controller's id", Beside, r#"<controller id="c"><control signalId="1"/></controller><controller id="d"><control signalId="beside"/></controller>"#, ("id=\"d\"", "id=\"c\""), "asam.net:xodr:1.4.0:ids.id_unique_in_class", Accepted),
    ("a junction's controller", Beside, r#"<controller id="c"><control signalId="1"/></controller><junction id="8" name=""><controller id="c" type="0"/></junction>"#, ("<controller id=\"c\" type", "<controller id=\"x\" type"), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("a junction's priority", Beside, r#"<junction id="8" name=""></junction>"#, ("></junction>", "><priority high=\"1\" low=\"1\"/></junction>"), "mapd:xodr:1.4.0:topology.priority_cycle", Accepted),
    ("a group of boards", Beside, r#"<vmsGroup id="g"><vmsBoardReference signalId="1" vmsIndex="0" groupIndex="0"/></vmsGroup>"#, ("signalId=\"1\"", "signalId=\"9\""), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    // Railways.
    ("a switch", Railway, r#"<switch name="a" id="w" position="dynamic"><mainTrack id="1" s="10" dir="+"/><sideTrack id="1" s="20" dir="+"/></switch>"#, ("<sideTrack id=\"1\"", "<sideTrack id=\"9\""), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
    ("a station", Beside, r#"<station name="a" id="s" type="small"><platform id="p"><segment roadId="1" sStart="1" sEnd="9" side="left"/></platform></station>"#, ("roadId=\"1\"", "roadId=\"9\""), "asam.net:xodr:1.4.0:ids.only_ref_defined_ids", Accepted),
];

#[test]
fn what_is_wrong_is_said_and_the_rest_stays() {
    CASES.iter().for_each(check);
}

/// A curve of an outline is checked as it is built: one without one shape is left out with its line, and neither has it to begin where one ends nor
/// the next one where it or the one before it ends.
#[test]
fn a_curve_without_one_shape_is_neither_built_nor_followed() {
    let curve = |u: f64, shape: &str| {
        format!(
            "<curveLocal id=\"0\" u=\"{u}\" v=\"0\" z=\"0\" height=\"1\" hdg=\"0\" length=\"2\">{shape}</curveLocal>\n"
        )
    };
    let road = ObjectRoad { version: "1.9", ..PLAIN };
    for (shape, left_out, gaps) in [
        ("<line/>", 0, 2),
        ("", 1, 0),
        ("<line/><arc curvature=\"0.1\"/>", 1, 0),
        ("<arc/>", 1, 0),
        (
            "<paramPoly3 aU=\"0\" bU=\"1\" cU=\"0\" dU=\"0\" aV=\"0\" bV=\"0\" cV=\"0\" pRange=\"arcLength\"/>",
            1,
            0,
        ),
    ] {
        let curves = curve(-5.0, "<line/>") + &curve(0.0, shape) + &curve(9.0, "<line/>");
        let object = format!(
            "<object id=\"1\" type=\"building\" s=\"30\" t=\"9\" zOffset=\"0\" orientation=\"none\"><outlines><outline id=\"0\" closed=\"true\">\n{curves}</outline></outlines></object>"
        );
        let text = document(&road, &object);
        let line = 2 + text[..text.find("<curveLocal").expect("a curve")].matches('\n').count();
        let compiled = compile(&text);
        assert!(compiled.rows.is_some(), "{shape}: {:?}", compiled.diagnostics);
        let of = |rule: &str| {
            let found = compiled.diagnostics.iter().filter(|one| one.finding.rule.ends_with(rule));
            found.map(|one| one.line as usize).collect::<Vec<_>>()
        };
        assert_eq!(of("compile.object_part"), vec![line; left_out], "{shape}");
        assert_eq!(
            of("curve_local.continuous_curve_local").len(),
            gaps,
            "{shape}: {:?}",
            compiled.diagnostics
        );
    }
}
