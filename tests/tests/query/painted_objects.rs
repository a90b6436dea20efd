//! Points along what is painted as an object: worked out by hand from the document's numbers, and the same ones by whatever rectangle.

use mapd_client::glam::{DVec2, DVec3};
use mapd_client::localisation::{MarkFilter, MarkKinds, MarkPoint, MarkSource};
use mapd_client::objects::ObjectPlacement;
use mapd_client::vocabulary::{RoadMarkColor, RoadMarkKind};
use mapd_client::{Map, Region};
use mapd_tests::maps::{self, Random};
use mapd_tests::object_maps::{PLAIN, document, open};

/// Objects' corners lie in single precision `[m]`.
const SINGLE: f64 = 2e-6;

fn everywhere() -> Region {
    Region { low: DVec2::splat(-1e5), high: DVec2::splat(1e5) }
}

/// Points of objects alone.
fn points(map: Map<'_>, spacing: f64) -> Vec<MarkPoint> {
    let mut out = Vec::new();
    map.mark_points(everywhere(), spacing, &MarkFilter::default(), &mut out).expect("an answer");
    out.retain(|point| !matches!(point.source, MarkSource::Lane(_)));
    out
}

/// An object's points by its id: where, in order of x, then y; and whether they are an outline's.
fn of(map: Map<'_>, all: &[MarkPoint], id: &str) -> (Vec<DVec3>, bool) {
    let object = map.object_by_id(id).expect("an object").object_id();
    let own = all.iter().filter_map(|point| match point.source {
        MarkSource::Line(place) => (place.object == object).then_some((point.position, false)),
        MarkSource::Outline(place) => (place.object == object).then_some((point.position, true)),
        MarkSource::Lane(_) => None,
    });
    let (mut places, outlines): (Vec<DVec3>, Vec<bool>) = own.unzip();
    places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    (places, outlines.first().copied().unwrap_or(false))
}

/// A straight road along x. Places of objects' points, each as written: ((u, v) of a corner is (s + u, t + v)).
const OBJECTS: &str = r#"
<object id="stripes" type="crosswalk" s="30" t="0" zOffset="0" orientation="none"><outlines>
<outline id="0" closed="true"><cornerLocal id="0" u="1" v="-2" z="0" height="0"/><cornerLocal id="1" u="1" v="2" z="0" height="0"/><cornerLocal id="2" u="-1" v="2" z="0" height="0"/><cornerLocal id="3" u="-1" v="-2" z="0" height="0"/></outline></outlines>
<markings><marking width="0.3" color="yellow" zOffset="0.01" lineLength="0.5" spaceLength="0.75" startOffset="0.25" stopOffset="0.5"><cornerReference id="0"/><cornerReference id="1"/></marking></markings></object>
<object id="ell" type="crosswalk" s="40" t="0" zOffset="0" orientation="none"><outlines>
<outline id="0" closed="true"><cornerLocal id="0" u="0" v="0" z="0" height="0"/><cornerLocal id="1" u="1" v="0" z="0" height="0"/><cornerLocal id="2" u="1" v="1" z="0" height="0"/><cornerLocal id="3" u="0" v="1" z="0" height="0"/></outline></outlines>
<markings><marking width="0.1" color="white" lineLength="1" spaceLength="0" startOffset="0" stopOffset="0"><cornerReference id="0"/><cornerReference id="1"/><cornerReference id="2"/></marking></markings></object>
<object id="stop" type="roadMark" subtype="stopLine" s="50" t="-1.75" zOffset="0" orientation="none"><outlines>
<outline id="0"><cornerLocal id="0" u="0" v="-1.5" z="0" height="0"/><cornerLocal id="1" u="0" v="0" z="0" height="0"/><cornerLocal id="2" u="0" v="1.5" z="0" height="0"/></outline></outlines></object>
<object id="box" type="roadMark" subtype="stopLine" s="60" t="0" zOffset="0" length="0.5" width="2" orientation="none"/>
<object id="arrow" type="roadMark" subtype="arrowStraight" s="62" t="0" zOffset="0" length="4" width="1" orientation="none"/>
<object id="space" type="parkingSpace" s="70" t="-5" zOffset="0" length="4" width="2" orientation="none"><markings><marking side="left" width="0.12" color="blue" lineLength="0.2" spaceLength="0" startOffset="1" stopOffset="0"/></markings></object>
<object id="island" type="trafficIsland" subtype="island" s="80" t="0" zOffset="0" orientation="none"><outlines>
<outline id="7" closed="true"><cornerLocal id="0" u="0" v="0" z="0" height="0.1"/><cornerLocal id="1" u="2" v="0" z="0" height="0.1"/><cornerLocal id="2" u="2" v="1" z="0" height="0.1"/><cornerLocal id="3" u="0" v="1" z="0" height="0.1"/></outline></outlines>
<borders><border width="0.2" type="curb" outlineId="7" useCompleteOutline="true"/></borders></object>
<object id="bars" type="parkingSpace" s="0" t="6" zOffset="0" length="1" width="2" orientation="none"><repeat s="10" length="10" distance="5" tStart="6" tEnd="6" widthStart="2" widthEnd="2" lengthStart="1" lengthEnd="1" heightStart="0" heightEnd="0" zOffsetStart="0" zOffsetEnd="0"/><markings><marking side="front" width="0.12" color="white" lineLength="1" spaceLength="0" startOffset="0" stopOffset="0"/></markings></object>
<object id="unmarked" type="parkingSpace" s="75" t="-5" zOffset="0" length="4" width="2" orientation="none"><parkingSpace access="all"><marking type="none" side="left" width="0.12" color="white"/></parkingSpace></object>
<object id="thin" type="roadMark" subtype="stopLine" s="84" t="0" zOffset="0" length="0" width="3" orientation="none"/>
<object id="far" type="parkingSpace" s="85" t="-9" zOffset="0" length="4" width="2" orientation="none"><markings><marking side="left" width="0.12" color="white" lineLength="0.2" spaceLength="0" startOffset="-1e16" stopOffset="0"/></markings></object>
<object id="endless" type="roadMark" subtype="stopLine" s="90" t="0" zOffset="0" orientation="none"><outlines><outline id="0"><cornerLocal id="0" u="-1e18" v="0" z="0" height="0"/><cornerLocal id="1" u="1e18" v="0" z="0" height="0"/></outline></outlines></object>
<object id="rolled" type="parkingSpace" s="92" t="-9" zOffset="0" length="2" width="2" height="1" roll="0.5" orientation="none"><markings><marking side="left" width="0.12" color="white" zOffset="1" lineLength="0.2" spaceLength="0" startOffset="0" stopOffset="0"/></markings></object>
<object id="pole" type="pole" s="20" t="5" zOffset="0" radius="0.2" height="4" orientation="none"/>"#;

#[test]
fn points_lie_where_the_document_paints() {
    let snapshot = open(&document(&PLAIN, OBJECTS));
    let map = snapshot.map();
    let all = points(map, 0.5);
    let check = |id: &str, outline: bool, expected: &[[f64; 3]]| {
        let (found, is_outline) = of(map, &all, id);
        let near = |(a, b): (&DVec3, &[f64; 3])| a.distance(DVec3::from_array(*b)) < SINGLE;
        let fits = found.len() == expected.len() && found.iter().zip(expected).all(near);
        assert!(fits && is_outline == outline, "{id}: {found:?}, not {expected:?}");
    };
    // From v = −1.75 on to 1.5, at 0, 0.5, 1.5 …: strokes of half a metre, gaps of three quarters.
    let stripes = [0.0, 0.5, 1.5, 2.5, 3.0].map(|along| [31.0, -1.75 + along, 0.01]);
    check("stripes", false, &stripes);
    // Round a corner; the end belongs to nothing.
    check("ell", false, &[[40.0, 0.0, 0.0], [40.5, 0.0, 0.0], [41.0, 0.0, 0.0], [41.0, 0.5, 0.0]]);
    // A line, though it does not say that it is open.
    let stop: Vec<_> = (0..6).map(|i| [50.0, -3.25 + 0.5 * f64::from(i), 0.0]).collect();
    check("stop", true, &stop);
    // Around a box: from the front right on.
    let left: Vec<_> = (0..5).map(|i| [59.75, -1.0 + 0.5 * f64::from(i), 0.0]).collect();
    let right: Vec<_> = (0..5).map(|i| [60.25, -1.0 + 0.5 * f64::from(i), 0.0]).collect();
    check("box", true, &[left, right].concat());
    // The box of a symbol is no edge of paint.
    check("arrow", false, &[]);
    check("pole", false, &[]);
    check(
        "space",
        false,
        &(0..6).map(|i| [69.0 + 0.5 * f64::from(i), -4.0, 0.0]).collect::<Vec<_>>(),
    );
    let mut island: Vec<_> = (0..4).map(|i| [80.0 + 0.5 * f64::from(i), 0.0, 0.0]).collect();
    island.extend((0..4).map(|i| [82.0 - 0.5 * f64::from(i), 1.0, 0.0]));
    island.extend([[82.0, 0.0, 0.0], [82.0, 0.5, 0.0], [80.0, 1.0, 0.0], [80.0, 0.5, 0.0]]);
    island.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    island.dedup();
    check("island", false, &island);
    // A marking of the type none is none; a box without a length is a line.
    check("unmarked", false, &[]);
    let thin: Vec<_> = (0..6).map(|i| [84.0, -1.5 + 0.5 * f64::from(i), 0.0]).collect();
    check("thin", true, &thin);
    // What lies before the line is not part of it; what nobody could paint is no paint.
    let far: Vec<_> = (0..8).map(|i| [83.0 + 0.5 * f64::from(i), -8.0, 0.0]).collect();
    check("far", false, &far);
    check("endless", false, &[]);
    // Height is along z: the line stays above its object's foot.
    let (cos, sin) = (0.5f64.cos(), 0.5f64.sin());
    let rolled: Vec<_> =
        (0..4).map(|i| [91.0 + 0.5 * f64::from(i), -9.0 + cos, 1.0 + sin]).collect();
    check("rolled", false, &rolled);
    let bars = [10.5, 15.5, 20.5].map(|x| [5.0, 5.5, 6.0, 6.5].map(|y| [x, y, 0.0]));
    check("bars", false, &bars.concat());
}

/// Kinds, colours and widths are those of the document; filters leave out what they say.
#[test]
fn paint_looks_as_written() {
    let snapshot = open(&document(&PLAIN, OBJECTS));
    let map = snapshot.map();
    let all = points(map, 0.5);
    use RoadMarkColor::{Blue, NotGiven, Yellow};
    use RoadMarkKind::{Broken, Curb, Solid};
    for (id, kind, color, width) in [
        ("stripes", Broken, Yellow, 0.3),
        ("space", Solid, Blue, 0.12),
        ("island", Curb, NotGiven, 0.2),
        ("stop", Solid, NotGiven, 0.0),
    ] {
        let object = map.object_by_id(id).expect("an object").object_id();
        let own = all.iter().find(|point| match point.source {
            MarkSource::Line(place) | MarkSource::Outline(place) => place.object == object,
            MarkSource::Lane(_) => false,
        });
        let own = own.expect("a point");
        assert_eq!((own.kind, own.color), (kind, color), "{id}");
        assert!((own.width - width).abs() < 1e-7, "{id}: {}", own.width);
    }
    let ask = |filter: MarkFilter| {
        let mut out = Vec::new();
        map.mark_points(everywhere(), 0.5, &filter, &mut out).expect("an answer");
        out.retain(|point| !matches!(point.source, MarkSource::Lane(_)));
        out.len()
    };
    let curbs = MarkFilter { kinds: MarkKinds::NONE.with(Curb), ..MarkFilter::default() };
    assert_eq!(ask(curbs), 12);
    assert_eq!(ask(MarkFilter { objects: false, ..MarkFilter::default() }), 0);
}

/// How far away the nearest edge of an object's outlines or box is, or the line between two of its corners `[m]`.
fn edge_distance(place: &ObjectPlacement<'_>, at: DVec2) -> f64 {
    let mut least = f64::INFINITY;
    let mut corners = Vec::new();
    let mut lines = |corners: &[DVec2]| {
        for (i, a) in corners.iter().enumerate() {
            for b in &corners[i + 1..] {
                let way = *b - *a;
                let share = (at - *a).dot(way) / way.length_squared().max(1e-18);
                let share = mapd_geometry::clamp(share, 0.0, 1.0);
                least = least.min(at.distance(*a + share * way));
            }
        }
    };
    for outline in place.outlines() {
        corners.clear();
        corners.extend(outline.positions().map(DVec3::truncate));
        lines(&corners);
    }
    let mut foot = Vec::new();
    place.footprint(&mut foot);
    corners.clear();
    corners.extend(foot.iter().map(|corner| corner.truncate()));
    lines(&corners);
    least
}

/// The same points by whatever rectangle, each on an edge of its object.
fn check_regions(map: Map<'_>, spacing: f64, questions: usize) -> usize {
    let (filter, mut all, mut out) = (MarkFilter::default(), Vec::new(), Vec::new());
    map.mark_points(everywhere(), spacing, &filter, &mut all).expect("an answer");
    let bits = |point: &MarkPoint| point.position.to_array().map(f64::to_bits);
    let objects: Vec<&MarkPoint> =
        all.iter().filter(|point| !matches!(point.source, MarkSource::Lane(_))).collect();
    for point in &objects {
        let (MarkSource::Line(place) | MarkSource::Outline(place)) = point.source else { continue };
        let place = map.placement(place).expect("a place");
        // On an edge, as those of outlines and boxes: nothing within is painted.
        let away = edge_distance(&place, point.position.truncate());
        assert!(away < 0.01, "{point:?} lies {away} m off its object's edges");
    }
    let mut random = Random(31);
    for _ in 0..questions {
        let Some(near) = objects.get((random.unit() * objects.len() as f64) as usize) else {
            break;
        };
        let half = DVec2::new(random.between(0.0, 3.0), random.between(0.0, 3.0));
        let middle = near.position.truncate() + DVec2::new(random.between(-1.0, 1.0), 0.3);
        let region = Region { low: middle - half, high: middle + half };
        map.mark_points(region, spacing, &filter, &mut out).expect("an answer");
        let held = |point: &&MarkPoint| {
            let p = point.position.truncate();
            p.cmpge(region.low).all() && p.cmple(region.high).all()
        };
        let mut expected: Vec<_> = all.iter().filter(held).map(bits).collect();
        let mut got: Vec<_> = out.iter().map(bits).collect();
        expected.sort_unstable();
        got.sort_unstable();
        assert_eq!(got, expected, "{region:?}");
    }
    objects.len()
}

#[test]
fn every_rectangle_has_the_same_points() {
    let snapshot = open(&document(&PLAIN, OBJECTS));
    assert!(check_regions(snapshot.map(), 0.13, 200) > 100);
    for path in maps::carried_and(&["Scenic/Town10HD", "esmini/parking_demo", "drone_dataset/rdb2"])
    {
        let snapshot = maps::open(&path);
        let has_paint = path.components().all(|part| part.as_os_str() != "examples");
        assert_eq!(check_regions(snapshot.map(), 0.37, 40) > 0, has_paint, "{}", path.display());
    }
}
