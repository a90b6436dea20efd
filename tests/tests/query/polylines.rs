//! Polylines never lie farther from the exact lines than the options say: dense comparison, several tolerances.

use mapd_client::batch::{BatchScratch, NearestLanes, Places};
use mapd_client::compiling::ByRow as _;
use mapd_client::compiling::SectionCutter;
use mapd_client::glam::DVec3;
use mapd_client::roads::Polyline;
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Lane, LaneTypes, Map, Nearest, NearestOptions, Point, Snapshot, Track};
use mapd_compiler::{CompileOptions, compile};
use mapd_tests::maps::{Random, carried_and, open_text};
use std::path::Path;

/// Maps besides the carried ones.
const MAPS: [&str; 12] = [
    "carla/Town05",
    "Scenic/Town07",
    "Scenic/Issue295a",
    "Scenic/Issue189",
    "esmini/velodrome",
    "esmini/soderleden",
    "esmini/multi_intersections",
    "esmini/tunnels",
    "drone_dataset/rdb2",
    "gdal/5g_living_lab_A39_Wolfsburg-West",
    "maliput_malidrive/ParametricCubicCurveComplexRoad",
    "sumo/adlershof_dlr_netconvert",
];
/// Places compared between two points of a polyline.
const PLACES: usize = if cfg!(debug_assertions) { 7 } else { 31 };
/// Lanes of each map with places where the nearest of several lanes is compared.
const OVERLAPS: usize = 500;
/// More than are looked at together, twice.
const ROADS_AT_ONE_PLACE: u32 = 20;
/// Two lanes whose offsets differ by less than this `[m]` are equally near but for rounding.
const TIE: f64 = 1e-9;
/// Parts of a border whose bending is told, and what rounding and the displacement of places may show besides, sixteenfold `[m]`.
const BEND_PARTS: usize = 12;
const BEND_ROUNDING: f64 = 1e-5;
/// Tolerances of centre lines and borders `[m]`: the default, a finer and a coarser pair.
const TOLERANCES: [(f64, f64); 3] = [(0.05, 0.01), (0.01, 0.002), (0.5, 0.1)];
/// Single precision of stations relative to their section's start, as a share of the section's length. What the writing of points in few bits
/// costs is no excuse.
const ROUNDING: f64 = f32::EPSILON as f64;

fn open(path: &Path, (index_tolerance, bound_tolerance): (f64, f64)) -> Snapshot {
    let options = CompileOptions { index_tolerance, bound_tolerance, ..CompileOptions::default() };
    let file = std::fs::File::open(path).expect("the map can be read");
    let compiled = compile(file, &options, &mut |_| {}).expect("reading works");
    let rows = compiled.rows.expect("the map is accepted");
    let bytes = mapd_archive::encode(&rows, &compiled.provenance).expect("encodes");
    Snapshot::from_bytes(bytes).expect("opens")
}

fn distance(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    let share = if squared > 0.0 { (point - a).dot(along) / squared } else { 0.0 };
    point.distance(a + along * mapd_geometry::clamp(share, 0.0, 1.0))
}

/// Largest distance of the exact line from its polyline, less what the single precision of s explains.
fn worst(lane: &Lane<'_>, line: Polyline<'_>, exact: impl Fn(f64) -> DVec3) -> f64 {
    let (start, end) = (lane.section().s_start(), lane.section().s_end());
    let mut worst = 0f64;
    for i in 1..line.len() {
        let (a, b) = (line.position(i - 1).expect("a point"), line.position(i).expect("a point"));
        let [from, to] = [i - 1, i].map(|i| line.station(i).expect("a point").min(end));
        // Both sides of a jump.
        if to <= from {
            continue;
        }
        let rounding = (to - start) * ROUNDING;
        for place in 0..=PLACES {
            // Where records begin, stored s is rounded: what is asked lies well within.
            let share = (place as f64 + 0.5) / (PLACES + 1) as f64;
            let point = exact(from + (to - from) * share);
            worst = worst.max(distance(point, a, b) - rounding);
        }
    }
    worst
}

/// Compares all lines of a map; yields the number of points compared.
fn check(snapshot: &Snapshot, name: &str, (center, bound): (f64, f64)) -> usize {
    let mut compared = 0;
    for row in 0..snapshot.map().tables().lanes.len() as u32 {
        let lane = snapshot.map().lane_by_row(row).expect("a lane");
        let road = lane.road();
        let at =
            |s: f64, t: f64| road.to_inertial(Track { s, t, h: 0.0 }).expect("a pose").position;
        let centers = worst(&lane, lane.center_line(), |s| at(s, lane.edges_at(s).center()));
        let bounds = worst(&lane, lane.border(), |s| at(s, lane.edges_at(s).outer));
        for (line, off, limit) in [("centre line", centers, center), ("border", bounds, bound)] {
            let key = lane.key();
            assert!(off <= limit, "{name}: {line} of {key} is {off} m off, allowed {limit}");
        }
        check_at_once(&lane, name);
        compared += lane.border().len();
    }
    compared
}

/// The nearest lane relies on the tolerance: where lanes overlap it leaves out those whose centre line is too far off. It is the first of all that
/// hold the point, found by looking at each, alone and in a batch. Yields in how many places lanes overlap.
fn check_overlaps(snapshot: &Snapshot, name: &str) -> usize {
    let map = snapshot.map();
    let lanes: Vec<_> = map.lanes().filter(|lane| lane.number() != 0).collect();
    let (mut random, mut points) = (Random(5), Vec::new());
    for _ in 0..OVERLAPS {
        let lane = &lanes[(random.unit() * lanes.len() as f64) as usize];
        let (s_start, s_end) = (lane.section().s_start(), lane.section().s_end());
        let s = random.between(s_start, s_end);
        let edges = lane.edges_at(s);
        let t = edges.inner + (edges.outer - edges.inner) * random.unit();
        let at = lane.road().to_inertial(Track { s, t, h: 0.0 }).expect("a pose");
        // With some around it, so that a batch has something in common.
        let around = DVec3::new(random.unit(), random.unit(), 0.0);
        points.extend([0.0, 0.2, 0.4, 0.6].map(|far| at.position + around * far));
    }
    let all = NearestOptions { radius: 0.0, ..NearestOptions::default() };
    let few = NearestOptions { types: LaneTypes::routable(), ..all };
    let cars = NearestOptions { vehicle: Some(VehicleClass::PassengerCar), ..all };
    let ahead = NearestOptions { heading: Some(random.unit()), ..all };
    let variants = [("", all, false), ("drivable", few, false), ("cars", cars, false)];
    let variants = variants.into_iter().chain([("heading", ahead, false), ("z", all, true)]);
    variants
        .map(|(what, options, has_z)| {
            compared(map, &points, &options, has_z, &format!("{name} {what}"))
        })
        .sum()
}

/// Compares the nearest of the lanes that hold each point, with its height or without. Yields how many hold several.
fn compared(
    map: Map<'_>,
    points: &[DVec3],
    options: &NearestOptions,
    has_z: bool,
    name: &str,
) -> usize {
    let [x, y, z]: [Vec<f64>; 3] =
        [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).collect());
    let places = Places { x: &x, y: &y, z: has_z.then_some(&z), heading: None };
    let (mut scratch, mut batch) = (BatchScratch::default(), NearestLanes::default());
    map.nearest_lanes(places, options, &mut scratch, &mut batch).expect("answers");
    let (mut near, mut overlaps) = (Vec::new(), 0);
    for (i, point) in points.iter().enumerate() {
        let point = if has_z { Point::from(*point) } else { Point::from(point.truncate()) };
        map.lanes_near(point, options, &mut near).expect("an answer");
        let found = map.nearest_lane(point, options).expect("an answer");
        assert_eq!(batch.get(i), found, "{name}: {point:?}");
        let first = near.first();
        let offset = |nearest: &Nearest| nearest.position.offset.abs();
        let is_tied = || {
            let offsets = found.as_ref().map(offset).zip(first.map(offset));
            offsets.is_some_and(|(own, first)| (own - first).abs() <= TIE)
        };
        let is_first = first.map(|nearest| nearest.lane) == found.map(|nearest| nearest.lane);
        assert!(is_first || is_tied(), "{name}: {point:?}: found {found:?}, expected {first:?}");
        overlaps += usize::from(near.len() > 1);
    }
    overlaps
}

/// More lanes at one place than are looked at together.
#[test]
fn the_nearest_of_many_lanes_at_one_place() {
    let roads = (0..ROADS_AT_ONE_PLACE).map(|id| {
        let offset = 0.3 * f64::from(id);
        format!(
            r#"<road id="{id}" length="100" junction="-1">
<planView><geometry s="0" x="0" y="0" hdg="0.1" length="100"><arc curvature="0.005"/></geometry></planView>
<lanes><laneOffset s="0" a="{offset}" b="0" c="0" d="0"/><laneSection s="0"><center><lane id="0"/></center>
<right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0.01" c="0" d="0"/></lane></right></laneSection></lanes></road>"#
        )
    });
    let map = format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/>{}</OpenDRIVE>"#,
        roads.collect::<String>()
    );
    assert!(check_overlaps(&open_text(&map), "roads at one place") > OVERLAPS);
}

/// What is computed for many places at once is what is computed for one: a section's cuts, the points of a line.
fn check_at_once(lane: &Lane<'_>, name: &str) {
    let (key, section) = (lane.key(), lane.section());
    for line in [lane.center_line(), lane.border()] {
        assert!(
            line.points().map(|at| (at.s, at.position)).eq(line.stations().zip(line.positions())),
            "{name}: {key}"
        );
    }
    let number = section.lanes().position(|other| other.key() == key).expect("its number");
    let mut cutter = SectionCutter::new(section).expect("a sound section");
    let mut all = vec![lane.edges_at(0.0); section.lanes().count()];
    let (start, end) = (section.s_start(), section.s_end());
    let [from, .., to] = [0, 1, 2, 3, 4].map(|i| {
        let s = start + (end - start) * f64::from(i) / 4.0;
        let own = lane.edges_at(s);
        assert_eq!(cutter.lane_edges(number, s), Some(own), "{name}: {key} at {s}");
        cutter.edges(s, &mut all).expect("edges");
        assert_eq!(all.get(number), Some(&own), "{name}: {key} at {s}");
        (s, own)
    });
    // Arcs are as wide at their end as where they begin.
    if cutter.arc(number, from.0, to.0).is_some() {
        assert_eq!(from.1, to.1, "{name}: {key}");
    }
}

/// What is told of how far a lane's border bends at most: places of it show no more. Yields of how many parts it is told.
fn check_bends(lane: &Lane<'_>, name: &str) -> usize {
    let (key, section) = (lane.key(), lane.section());
    let number = section.lanes().position(|other| other.key() == key).expect("its number");
    let mut cutter = SectionCutter::new(section).expect("a sound section");
    let (start, end) = (section.s_start(), section.s_end());
    let mut cuts: Vec<f64> = lane.shape_breaks().filter(|s| *s > start && *s < end).collect();
    cuts.extend([start, end]);
    cuts.sort_by(f64::total_cmp);
    let mut told = 0;
    for pair in cuts.windows(2) {
        let parallel = cutter.parallel(number, [pair[0], pair[1]], |edges| edges.outer);
        let mut bends = parallel.and_then(|line| line.from(pair[0]));
        let at = |part: f64| pair[0] + (pair[1] - pair[0]) * (part / BEND_PARTS as f64);
        for part in 0..BEND_PARTS {
            let Some(bend) = bends.as_mut().and_then(|bends| bends.up_to(at((part + 1) as f64)))
            else {
                continue;
            };
            told += 1;
            let mut place = |share: f64| {
                // Below the end, where the records of this stretch still hold.
                let s = at(part as f64 + share).min(pair[1].next_down());
                let t = cutter.lane_edges(number, s).expect("edges").outer;
                cutter.cut(s).expect("a cut").place(t)
            };
            let places = [0.0, 0.25, 0.5, 0.75, 1.0].map(&mut place);
            for three in places.windows(3) {
                let shown = 16.0 * (three[0] - 2.0 * three[1] + three[2]).length();
                assert!(shown <= bend.any + BEND_ROUNDING, "{name}: {key} at {part}: {shown}");
            }
            let chord = places[4] - places[0];
            for place in places {
                let away = place - places[0];
                let share =
                    mapd_geometry::clamp(away.dot(chord) / chord.length_squared(), 0.0, 1.0);
                let shown = 8.0 * (away - share * chord).length();
                assert!(shown <= bend.across + BEND_ROUNDING, "{name}: {key} at {part}: {shown}");
            }
        }
    }
    told
}

#[test]
fn no_border_bends_further_than_told() {
    let mut told = 0;
    for path in carried_and(&MAPS) {
        let snapshot = open(&path, TOLERANCES[0]);
        let name = path.display().to_string();
        told += snapshot.map().lanes().map(|lane| check_bends(&lane, &name)).sum::<usize>();
    }
    assert!(told > 1000, "{told} parts");
}

#[test]
fn no_polyline_exceeds_its_tolerance() {
    let mut overlaps = 0;
    for path in carried_and(&MAPS) {
        for tolerances in TOLERANCES {
            let snapshot = open(&path, tolerances);
            let name = path.display().to_string();
            assert!(check(&snapshot, &name, tolerances) > 0);
            overlaps += check_overlaps(&snapshot, &name);
        }
    }
    assert!(overlaps > OVERLAPS, "lanes overlap in {overlaps} places");
}

/// A curve that is back at the same place wherever it is looked at is no straight line: ramps of whole turns.
#[test]
fn whole_turns_are_no_segment() {
    let folder = tempfile::tempdir().expect("a folder");
    for turns in [1, 2, 3, 4, 6, 8, 16] {
        let length = f64::from(turns) * std::f64::consts::TAU * 10.0;
        let map = format!(
            r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="{length}" junction="-1">
<planView><geometry s="0" x="0" y="0" hdg="0" length="{length}"><arc curvature="0.1"/></geometry></planView>
<elevationProfile><elevation s="0" a="0" b="0.05" c="0" d="0"/></elevationProfile>
<lanes><laneSection s="0"><center><lane id="0"/></center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
</road></OpenDRIVE>"#
        );
        let path = folder.path().join(format!("{turns}.xodr"));
        std::fs::write(&path, map).expect("a file");
        for tolerances in TOLERANCES {
            let name = format!("{turns} turns");
            // Chords of a circle of 10 m that stay within half a metre are six at least.
            assert!(check(&open(&path, tolerances), &name, tolerances) > 6 * turns as usize);
        }
    }
}
