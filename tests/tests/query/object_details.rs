//! What is written in and beside objects: markings, borders, skeletons, parking, repetitions, references, bridges, tunnels,
//! railways; and what is wrong with objects is a finding.

use mapd_client::glam::DVec3;
use mapd_compiler::{Compilation, Verdict};
use mapd_query::objects::Object;
use mapd_query::roads::LaneRange;
use mapd_query::vocabulary::{
    LaneMethod, ObjectShape, ObjectSide, Orientation, PlatformSide, StructureKind, SwitchPosition,
};
use mapd_tests::ends;
use mapd_tests::object_maps::{ObjectRoad, PLAIN, compile, document, open};

/// Corners lie in single precision `[m]`.
const SINGLE: f64 = 2e-6;

fn near(found: impl Iterator<Item = DVec3>, expected: &[[f64; 3]]) {
    let found: Vec<DVec3> = found.collect();
    let fits = found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| a.distance(DVec3::from_array(*b)) < SINGLE);
    assert!(fits, "found {found:?}, expected {expected:?}");
}

#[test]
fn markings_and_borders_name_corners() {
    let object = r#"<object id="1" type="crosswalk" s="30" t="0" zOffset="0" orientation="none"><outlines>
<outline id="3" closed="true"><cornerLocal id="0" u="1" v="-2" z="0" height="0"/><cornerLocal id="1" u="1" v="2" z="0" height="0"/><cornerLocal id="2" u="-1" v="2" z="0" height="0"/><cornerLocal id="5" u="-1" v="-2" z="0" height="0"/></outline></outlines>
<markings><marking width="0.1" color="white" weight="bold" lineLength="0.5" spaceLength="0.25" startOffset="0.1" stopOffset="0.2"><cornerReference id="1"/><cornerReference id="5"/></marking></markings>
<borders><border width="0.2" type="concrete" outlineId="3" useCompleteOutline="true"/></borders></object>
<object id="2" type="parkingSpace" s="50" t="-4.75" zOffset="0" length="5" width="2.4" orientation="none"><material surface="asphalt" friction="0.8"/><parkingSpace access="women" restrictions="till 8"/><markings><marking side="left" width="0.12" color="yellow" lineLength="0.2" spaceLength="0" startOffset="0" stopOffset="0"/></markings></object>"#;
    let snapshot = open(&document(&PLAIN, object));
    let map = snapshot.map();
    let crosswalk = map.object_by_id("1").expect("there").template();
    let marking = crosswalk.markings().next().expect("a marking");
    near(marking.corners(), &[[31.0, 2.0, 0.0], [29.0, -2.0, 0.0]]);
    assert_eq!(marking.outline().and_then(|outline| outline.id()), Some(3));
    assert_eq!((marking.color(), marking.weight(), marking.side()), ("white", "bold", None));
    assert_eq!((marking.stroke_length(), marking.gap_length()), (0.5, 0.25));
    let border = crosswalk.borders().next().expect("a border");
    assert_eq!((border.kind(), border.corners().len()), ("concrete", 0));
    assert_eq!(border.outline().map(|outline| outline.len()), Some(4));
    let space = map.object_by_id("2").expect("there");
    let parking = space.parking_space().expect("a parking space");
    assert_eq!((parking.access(), parking.restrictions()), ("women", "till 8"));
    let material = space.materials().next().expect("a material");
    assert_eq!((material.surface(), material.roughness()), ("asphalt", None));
    let side = space.template().markings().next().and_then(|marking| marking.side());
    assert_eq!(side, Some(ObjectSide::Left));
    assert!(map.object_by_id("1").is_some_and(|object| object.parking_space().is_none()));
}

#[test]
fn a_skeleton_moves_with_its_object() {
    let object = r#"<object id="1" type="pole" s="30" t="4" zOffset="0" orientation="none" length="1" width="1" height="5"><skeleton><polyline id="1"><vertexLocal id="1" u="0" v="0" z="0" radius="0.1" intersectionPoint="true"/><vertexLocal id="2" u="0" v="-2" z="5" radius="0.1"/></polyline></skeleton><repeat s="20" length="20" distance="20" tStart="4" tEnd="4" heightStart="5" heightEnd="5" zOffsetStart="1" zOffsetEnd="1"/></object>"#;
    let snapshot = open(&document(&PLAIN, object));
    let pole = snapshot.map().objects().next().expect("an object");
    let last = pole.placements().last().expect("a copy");
    let line = last.skeletons().next().expect("a line");
    near(line.vertices().map(|vertex| vertex.position), &[[40.0, 4.0, 1.0], [40.0, 2.0, 6.0]]);
    let ground: Vec<bool> = line.vertices().map(|vertex| vertex.is_on_ground).collect();
    assert_eq!(ground, [true, false]);
}

/// Places of the first object: s, t, z and shape.
fn places(road: &ObjectRoad<'_>, object: &str) -> Vec<(f64, f64, f64, ObjectShape)> {
    let snapshot = open(&document(road, object));
    let first: Object<'_> = snapshot.map().objects().next().expect("an object");
    first.placements().map(|p| (p.s(), p.t(), p.position().z, p.shape())).collect()
}

#[test]
fn instances_change_linearly_or_by_a_cubic() {
    let repeat = |attributes: &str| {
        format!(
            r#"<object id="1" type="pole" s="0" t="4" zOffset="0" radius="0.2" orientation="none"><repeat s="10" length="20" distance="10" tStart="4" zOffsetStart="0" zOffsetEnd="1" heightStart="1" heightEnd="3" {attributes}/></object>"#
        )
    };
    // t from 4 to 6, z from 0 to 1, at 0, half and all of the way.
    let round = ObjectShape::Cylinder;
    let expected = [(10.0, 4.0, 0.0, round), (20.0, 5.0, 0.5, round), (30.0, 6.0, 1.0, round)];
    assert_eq!(places(&PLAIN, &repeat(r#"tEnd="6""#)), expected);
    // 4 + 0.1·ds + 0.01·ds²: 4, 6, 10 (OpenDRIVE 1.9).
    let new = ObjectRoad { version: "1.9", ..PLAIN };
    let t: Vec<f64> = places(&new, &repeat(r#"tEnd="6" bT="0.1" cT="0.01" dT="0""#))
        .iter()
        .map(|p| p.1)
        .collect();
    assert!(t.iter().zip([4.0, 6.0, 10.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{t:?}");
    // Two repetitions are independent; the object itself is only their pattern.
    let two = repeat(r#"tEnd="6""#).replace(
        "</object>",
        r#"<repeat s="50" length="0" distance="1" tStart="-4" tEnd="-4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/></object>"#,
    );
    assert_eq!(places(&PLAIN, &two).len(), 4);
}

#[test]
fn a_swept_object_covers_the_stretch() {
    // A rail of 0.2 m from (10, 4) to (30, 6).
    let rail = r#"<object id="1" type="railing" s="0" t="4" zOffset="0" orientation="none"><repeat s="10" length="20" distance="0" tStart="4" tEnd="6" widthStart="0.2" widthEnd="0.2" heightStart="1" heightEnd="1" zOffsetStart="0.5" zOffsetEnd="0.5"/></object>"#;
    let snapshot = open(&document(&PLAIN, rail));
    let place =
        snapshot.map().objects().next().and_then(|o| o.placements().next()).expect("a place");
    let mut corners = vec![];
    place.footprint(&mut corners);
    near(
        corners.iter().copied(),
        &[[10.0, 4.1, 0.5], [30.0, 6.1, 0.5], [30.0, 5.9, 0.5], [10.0, 3.9, 0.5]],
    );
    assert!(place.is_swept() && place.height() == 1.0);
    // Around a bend of 50 m radius the edge stays within a centimetre of its arc: 46 m from the centre (0, 50).
    let bend = ObjectRoad { geometry: r#"<arc curvature="0.02"/>"#, ..PLAIN };
    let thin = rail
        .replace(r#"widthStart="0.2" widthEnd="0.2""#, "")
        .replace(r#"tEnd="6""#, r#"tEnd="4""#);
    let snapshot = open(&document(&bend, &thin));
    let place =
        snapshot.map().objects().next().and_then(|o| o.placements().next()).expect("a place");
    place.footprint(&mut corners);
    let centre = DVec3::new(0.0, 50.0, 0.5);
    assert!(corners.len() > 4 && !place.outlines().any(|outline| outline.is_closed()));
    assert!(corners.iter().all(|c| (c.distance(centre) - 46.0).abs() < 1e-5), "{corners:?}");
    // Detached from the line, it is the chord.
    let chord = rail.replace("distance=", r#"detachFromReferenceLine="true" distance="#);
    let snapshot = open(&document(&bend, &chord));
    let place =
        snapshot.map().objects().next().and_then(|o| o.placements().next()).expect("a place");
    place.footprint(&mut corners);
    assert_eq!(corners.len(), 4);
}

#[test]
fn bridges_tunnels_and_references_are_stored() {
    let objects = r#"<object id="1" type="crosswalk" s="30" t="0" zOffset="0" orientation="none" length="3" width="7"/>
<objectReference id="1" s="80" t="-1" zOffset="0.5" validLength="4" orientation="-"><validity fromLane="-2" toLane="-2"/></objectReference>
<objectReference id="9" s="80" t="-1" orientation="+"/>
<tunnel id="t" name="under" s="10" length="5" type="underpass" lighting="0.5"><validity fromLane="-1" toLane="-1"/></tunnel>
<bridge id="b" s="60" length="20" type="steel"/>"#;
    let snapshot = open(&document(&PLAIN, objects));
    let map = snapshot.map();
    let road = map.road_by_id("1").expect("there");
    let kinds: Vec<_> =
        road.structures().map(|s| (s.kind(), s.id(), s.type_name(), ends(s.s_range()))).collect();
    let bridge = (StructureKind::Bridge, "b", "steel", (60.0, 80.0));
    let tunnel = (StructureKind::Tunnel, "t", "underpass", (10.0, 15.0));
    assert_eq!(kinds, [bridge, tunnel]);
    let light: Vec<_> = road.structures_at(12.0).map(|s| (s.lighting(), s.daylight())).collect();
    assert_eq!(light, [(Some(0.5), None)]);
    assert_eq!(
        map.structures().flat_map(|s| s.validities()).collect::<Vec<_>>(),
        [LaneRange { from: -1, to: -1 }]
    );
    let references: Vec<_> = road.object_references().collect();
    assert_eq!(references.len(), 2);
    assert_eq!(references[0].object().map(|object| object.id()), Some("1"));
    assert_eq!(
        (references[0].orientation(), references[0].valid_length()),
        (Orientation::Against, 4.0)
    );
    assert!(references[1].object().is_none() && references[1].id() == "9");
    // The reference adds lane −2, which it names, over its length.
    let lanes: Vec<_> = map
        .object_by_id("1")
        .expect("there")
        .lanes()
        .map(|at| (at.lane().expect("a lane").number(), at.method()))
        .collect();
    let on = LaneMethod::Track;
    assert_eq!(lanes, [(1, on), (-1, on), (-2, LaneMethod::Validity)]);
}

#[test]
fn railways_are_stored_with_their_tracks() {
    let road = |id: &str, y: f64, more: &str| {
        format!(
            r#"<road id="{id}" length="100" junction="-1"><planView><geometry s="0" x="0" y="{y}" hdg="0" length="100"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="rail"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>{more}</road>"#
        )
    };
    let switches = r#"<railroad><switch name="W1" id="1" position="dynamic"><mainTrack id="a" s="20" dir="+"/><sideTrack id="b" s="5" dir="-"/><partner name="W2" id="2"/></switch><switch name="W2" id="2" position="turn"><mainTrack id="a" s="80" dir="-"/><sideTrack id="b" s="95" dir="+"/><partner id="1"/></switch></railroad>"#;
    let text = format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="8"/>{}{}<station name="Mitte" id="s" type="small"><platform name="1" id="p"><segment roadId="b" sStart="30" sEnd="60" side="left"/><segment roadId="x" sStart="0" sEnd="1" side="right"/></platform></station></OpenDRIVE>"#,
        road("a", 0.0, switches),
        road("b", 10.0, "")
    );
    let snapshot = open(&text);
    let map = snapshot.map();
    let all: Vec<_> = map.switches().collect();
    assert_eq!(all.len(), 2);
    assert_eq!((all[0].name(), all[0].position()), ("W1", Some(SwitchPosition::Dynamic)));
    assert_eq!(all[0].partner().map(|partner| partner.id()), Some("2"));
    let side = all[1].side_track();
    assert_eq!((side.road.map(|road| road.id()), side.s), (Some("b"), 95.0));
    assert_eq!(
        (side.direction, all[1].main_track().direction),
        (Orientation::Along, Orientation::Against)
    );
    let station = map.stations().next().expect("a station");
    let platform = station.platforms().next().expect("a platform");
    let segments: Vec<_> = platform
        .segments()
        .map(|segment| (segment.road.map(|road| road.id()), segment.side))
        .collect();
    assert_eq!((station.name(), platform.id()), ("Mitte", "p"));
    assert_eq!(segments, [(Some("b"), PlatformSide::Left), (None, PlatformSide::Right)]);
}

/// Compiles a document with an object that has something wrong; a finding of this rule must say so.
fn check_broken(object: &str, rule: &str, verdict: Verdict) -> Compilation {
    let compiled = compile(&document(&PLAIN, object));
    let rules: Vec<_> = compiled.diagnostics.iter().map(|d| d.finding.rule).collect();
    assert!(rules.contains(&rule), "{object}: {rule} is not among {rules:?}");
    assert_eq!(compiled.verdict, verdict, "{object}: {rules:?}");
    let rows = compiled.rows.as_ref().expect("the map itself is sound");
    let archive = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
    mapd_archive::verify(&archive).unwrap_or_else(|error| panic!("{object}: {error}"));
    compiled
}

#[test]
fn what_is_wrong_with_an_object_is_a_finding() {
    use Verdict::{Accepted, Quarantined};
    let object = |attributes: &str, inside: &str| {
        format!(
            r#"<object id="1" type="pole" s="30" t="4" zOffset="0" orientation="none" {attributes}>{inside}</object>"#
        )
    };
    let repeat = |s: &str, length: &str, distance: &str| {
        let inside = format!(
            r#"<repeat s="{s}" length="{length}" distance="{distance}" tStart="4" tEnd="4" heightStart="1" heightEnd="1" zOffsetStart="0" zOffsetEnd="0"/>"#
        );
        object(r#"radius="0.1""#, &inside)
    };
    // Lanes the wrong way round; lanes that are none.
    let rule = "asam.net:xodr:1.7.0:road.object.validty.from_lower_equal_to";
    check_broken(&object("", r#"<validity fromLane="-1" toLane="-2"/>"#), rule, Accepted);
    let rule = "mapd:xodr:1.4.0:ref.validity_lanes";
    check_broken(&object("", r#"<validity fromLane="-9" toLane="-7"/>"#), rule, Accepted);
    // Beyond the road's end: cut there.
    let rule = "asam.net:xodr:1.9.0:road.object.repeating.valid_s_length";
    let cut = check_broken(&repeat("90", "40", "5"), rule, Accepted);
    assert_eq!(cut.rows.expect("rows").object_copies.len(), 3);
    check_broken(&repeat("120", "40", "5"), "mapd:compile.object_repeat", Accepted);
    // So close together that no machine could hold them all.
    let many = check_broken(&repeat("0", "90", "1e-7"), "mapd:compile.object_repeat", Accepted);
    assert_eq!(many.rows.expect("rows").object_copies.len(), 100_000);
    // An outline of one corner is none.
    let outline = r#"<outlines><outline id="0"><cornerLocal id="0" u="1" v="1" z="0" height="1"/></outline></outlines>"#;
    let one = check_broken(&object("", outline), "mapd:compile.object_part", Accepted);
    assert_eq!(one.rows.expect("rows").object_outlines.len(), 0);
    // Beside a place that the road does not have: at its end.
    let beyond = object("", "").replace(r#"s="30""#, r#"s="130""#);
    let moved = check_broken(&beyond, "mapd:xodr:1.4.0:object.on_road", Accepted);
    assert!((moved.rows.expect("rows").objects[0].x - 100.0).abs() < 1e-12);
    // Without a place, or with one that is no number: left out alone.
    let beside = object("", "").replace(r#"id="1""#, r#"id="2""#);
    for (attribute, other) in [(r#"s="30""#, ""), (r#"t="4""#, r#"t="left""#)] {
        let broken = object("", "").replace(attribute, other) + &beside;
        let compiled = compile(&document(&PLAIN, &broken));
        assert_eq!(compiled.verdict, Quarantined, "{broken}: {:?}", compiled.diagnostics);
        assert_eq!(compiled.quarantined.iter().map(|part| &*part.id).collect::<Vec<_>>(), ["1"]);
        assert_eq!(compiled.rows.expect("rows").objects.len(), 1);
    }
    // Numbers that no coordinate can hold, in every place that has one.
    let huge = object(
        r#"length="1e300" width="1e300" height="1e300""#,
        r#"<outlines><outline id="0"><cornerLocal id="0" u="1e308" v="-1e308" z="0" height="1e300"/><cornerLocal id="1" u="-1e308" v="0" z="0" height="1"/><cornerRoad id="2" s="1e300" t="1e200" dz="0" height="0"/></outline></outlines>"#,
    );
    let compiled = compile(&document(&PLAIN, &huge));
    if let Some(rows) = &compiled.rows {
        let archive = mapd_archive::encode(rows, &compiled.provenance).expect("encodes");
        mapd_archive::verify(&archive).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn an_object_of_a_junction_stands_along_its_line() {
    let snapshot = mapd_tests::maps::open(&mapd_tests::carried("objects.xodr"));
    let map = snapshot.map();
    let junction = map.junction_by_id("10").expect("there");
    let fountain = junction.objects().next().expect("an object");
    // Northward from (120, 10): 5 m ahead, 2 m to the left, 1 m up.
    near([fountain.position()].into_iter(), &[[118.0, 15.0, 1.0]]);
    assert_eq!((fountain.road().is_none(), fountain.lanes().len()), (true, 1));
    // The street's end at (100, 0) is the nearest lane: its left edge lies at y = 5.5.
    let at = fountain.lanes().next().expect("a lane");
    assert_eq!((at.method(), at.lane().expect("a lane").number()), (LaneMethod::Nearest, 2));
    let away = (18.0f64 * 18.0 + 9.5 * 9.5).sqrt() - 1.5;
    assert!((at.distance() - away).abs() < 1e-5, "{}", at.distance());
}

/// The square of the carried map with an elevation grid that rises by 0.1 along its line and by 0.05 to the left of it.
fn with_grid(height: f64, object: &str) -> String {
    let text = std::fs::read_to_string(mapd_tests::carried("objects.xodr")).expect("the map");
    let rows: String = (0..5)
        .map(|i| {
            let z = height + 0.5 * f64::from(i);
            format!(r#"<elevation left="{:?}" center="{z:?}" right="{:?}"/>"#, z + 0.25, z - 0.25)
        })
        .collect();
    let grid = format!(r#"<elevationGrid sStart="0" gridSpacing="5">{rows}</elevationGrid>"#);
    let (before, behind) = text.split_once("<junction id=\"10\"").expect("the junction");
    let behind = behind.replacen("</objects>", &format!("{object}</objects>{grid}"), 1);
    format!("{before}<junction id=\"10\"{behind}")
}

#[test]
fn a_junctions_grid_lifts_its_objects() {
    let leaning = r#"<object id="stone" type="obstacle" s="10" t="-2" zOffset="0" perpToRoad="true" length="1" width="1" height="1" orientation="none"/>"#;
    let snapshot = open(&with_grid(2.0, leaning));
    let junction = snapshot.map().junction_by_id("10").expect("there");
    let objects: Vec<_> = junction.objects().collect();
    // 5 m ahead on the line the grid is 0.5 m higher; 2 m to the left of it by another 0.1 m.
    near([objects[0].position()].into_iter(), &[[118.0, 15.0, 3.5]]);
    near([objects[0].position_on_surface().expect("a place")].into_iter(), &[[118.0, 15.0, 3.6]]);
    near([objects[1].position()].into_iter(), &[[122.0, 20.0, 3.0]]);
    let (pitch, roll) = (objects[1].pitch(), objects[1].roll());
    assert!((pitch + 0.1f64.atan()).abs() < 1e-6 && (roll - 0.05f64.atan()).abs() < 1e-6);
    assert_eq!(objects[0].lanes().len(), 1, "the street is on its level");
    // Ten metres above the street, it belongs to none of its lanes.
    let above = open(&with_grid(10.0, ""));
    let junction = above.map().junction_by_id("10").expect("there");
    assert_eq!(junction.objects().next().expect("an object").lanes().len(), 0);
}
