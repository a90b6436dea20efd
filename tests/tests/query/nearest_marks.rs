//! The nearest road mark: worked out by hand on marks of every form, and against places all along all marks.

use mapd_client::compiling::ByRow as _;
use mapd_client::glam::DVec2;
use mapd_client::localisation::{MarkFilter, MarkKinds, MarkPoint, MarkSource, Side};
use mapd_client::vocabulary::{LaneType, RoadMarkColor, RoadMarkKind};
use mapd_client::{LaneTypes, Map, QueryError, Region, Track};
use mapd_tests::carried;
use mapd_tests::maps::{self, Random};

/// Between places along a mark `[m]`.
const STEP: f64 = 0.02;

/// Between places of a grid `[m]`: corners and middles of lanes among them.
const GRID: f64 = 0.25;

/// A place of a mark: lane's key, the line's offset with where it begins and ends, s, and where.
type Place = (String, [f64; 3], f64, DVec2);

/// Every line of every mark, place by place.
fn places(map: Map<'_>) -> Vec<Place> {
    let mut all = Vec::new();
    for row in 0..map.tables().lanes.len() as u32 {
        let lane = map.lane_by_row(row).expect("a lane");
        for mark in lane.road_marks().filter(|mark| mark.kind() != RoadMarkKind::None) {
            let whole = [0.0, 0.0, mark.s_end() - mark.s()];
            let lines: Vec<[f64; 3]> = mark
                .lines()
                .map(|l| {
                    let end = if l.space.is_none() { l.s_offset + l.length } else { whole[2] };
                    [l.t_offset, l.s_offset, end.min(whole[2])]
                })
                .collect();
            let lines = if lines.is_empty() { vec![whole] } else { lines };
            for [t_offset, from, to] in lines {
                let line = [t_offset, mark.s() + from, mark.s() + to];
                let count = ((to - from) / STEP).ceil().max(0.0) as usize;
                for i in 0..=count {
                    let s = mark.s() + (from + STEP * i as f64).min(to);
                    let track = Track { s, t: mark.t_at(s) + t_offset, h: 0.0 };
                    let at = lane.road().to_inertial(track).expect("a place").position;
                    all.push((lane.key().to_string(), line, s, at.truncate()));
                }
            }
        }
    }
    all
}

/// Half a step on either side of a place, narrowed down to where the mark is nearest: by public answers about its lane alone.
fn narrowed(map: Map<'_>, (key, line, s, _): &Place, point: DVec2) -> f64 {
    let lane = map.lane_by_key(&key.parse().expect("a key")).expect("a lane");
    let mark = lane.road_marks().filter(|mark| mark.kind() != RoadMarkKind::None);
    let mark = mark.min_by_key(|mark| u8::from(!(mark.s() <= *s && *s <= mark.s_end())));
    let mark = mark.expect("a mark");
    let [t_offset, from, to] = *line;
    let distance = |s: f64| {
        let track = Track { s, t: mark.t_at(s) + t_offset, h: 0.0 };
        let at = lane.road().to_inertial(track).expect("a place").position;
        at.truncate().distance(point)
    };
    let (mut low, mut high) = ((s - STEP).max(from), (s + STEP).min(to));
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if distance(a) < distance(b) { high = b } else { low = a }
    }
    distance(low).min(distance(from.max(*s).min(to)))
}

/// Random points against all places; how many had a mark.
fn check_places(map: Map<'_>, questions: usize) -> usize {
    let (all, mut random, mut seen) = (places(map), Random(21), 0);
    let filter = MarkFilter { radius: 4.0, ..MarkFilter::default() };
    let (mut points, mut answers) = (Vec::new(), Vec::new());
    for _ in 0..questions {
        let Some((_, _, _, near)) = all.get((random.unit() * all.len() as f64) as usize) else {
            break;
        };
        let point = *near + DVec2::new(random.between(-3.0, 3.0), random.between(-6.0, 6.0));
        let distance = |place: &Place| place.3.distance(point);
        let least = all.iter().map(distance).fold(f64::INFINITY, f64::min);
        let near = all.iter().filter(|place| distance(place) <= least + STEP);
        let expected = near.map(|place| narrowed(map, place, point)).fold(least, f64::min);
        let found = map.nearest_mark(point, &filter).expect("an answer");
        match &found {
            Some(found) => {
                seen += 1;
                let off = (found.distance - expected).abs();
                assert!(off <= 1e-9, "{point}: {found:?}, not {expected}");
                assert!((found.place.distance(point) - found.distance).abs() < 1e-9);
                let lane = map.lane(found.lane).expect("a lane");
                // The place lies beside the reference line at the s that is told.
                let line = lane.road().to_inertial(Track { s: found.s, t: 0.0, h: 0.0 });
                let line = line.expect("a place");
                let ahead = DVec2::from_angle(line.heading);
                let off = (found.place - line.position.truncate()).dot(ahead);
                assert!(off.abs() < 1e-6, "{point}: {found:?} is {off} m off");
            }
            None => assert!(expected > filter.radius - 1e-9, "{point}: none, not {expected}"),
        }
        points.push(point);
        answers.push(found);
    }
    let mut out = Vec::new();
    map.nearest_marks(&points, &filter, &mut out).expect("answers");
    assert_eq!(out, answers);
    seen
}

/// The carried road with bends and banks, with marks that sway along its lanes of 3.5 m.
fn bent() -> String {
    let road = std::fs::read_to_string(carried("one_road.xodr")).expect("the map can be read");
    let width = r#"a="3.5" b="0" c="0" d="0"/></lane>"#;
    let sway = r#"<sway ds="0" a="0.1" b="0.01" c="-0.0002" d="0"/>"#;
    let mark =
        format!(r#"<roadMark sOffset="0" type="broken" color="white">{sway}</roadMark></lane>"#);
    road.replace(width, &width.replace("</lane>", &mark))
}

/// Arcs from nearly straight to tight ones in either direction, on a bank, with a lane that grows evenly on the line between them, and lines of marks beside the borders.
fn round() -> String {
    let (mut geometry, mut s) = (String::new(), 0.0);
    let (mut x, mut y, mut heading) = (10.0f64, 20.0f64, 0.3f64);
    for (length, curvature) in
        [(20.0f64, 1e-9f64), (25.0, 0.0), (20.0, 0.02), (15.0, -0.15), (30.0, -1e-5), (20.0, 0.13)]
    {
        let shape = match curvature {
            0.0 => "<line/>".to_owned(),
            _ => format!(r#"<arc curvature="{curvature:?}"/>"#),
        };
        geometry += &format!(
            r#"<geometry s="{s:?}" x="{x:?}" y="{y:?}" hdg="{heading:?}" length="{length:?}">{shape}</geometry>"#
        );
        let half = 0.5 * curvature * length;
        let chord = if half == 0.0 { length } else { length * half.sin() / half };
        (x, y) = (x + chord * (heading + half).cos(), y + chord * (heading + half).sin());
        // The next one begins a little later than this one ends, as rounded lengths have it.
        (s, heading) = (s + length + 3e-7, heading + 2.0 * half);
    }
    let mark = |lines: &str| {
        format!(
            r#"<roadMark sOffset="0" type="custom" color="white"><type name="" width="0.1">{lines}</type></roadMark>"#
        )
    };
    let beside = mark(
        r#"<line length="3" space="6" tOffset="0.15" sOffset="0"/><line length="3" space="6" tOffset="-0.15" sOffset="1"/>"#,
    );
    let lane = |id: i32, mark: &str| {
        format!(
            r#"<lane id="{id}" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/><width sOffset="22" a="3.5" b="0.05" c="0" d="0"/><width sOffset="42" a="4.5" b="0" c="0" d="0"/>{mark}</lane>"#
        )
    };
    let solid = r#"<roadMark sOffset="0" type="solid" color="white"/>"#;
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="{s:?}" junction="-1"><planView>{geometry}</planView>
<lateralProfile><superelevation s="0" a="0.05" b="0" c="0" d="0"/></lateralProfile>
<lanes><laneSection s="0"><left>{}</left><center><lane id="0" type="none" level="false">{beside}</lane></center><right>{}{}</right></laneSection></lanes></road></OpenDRIVE>"#,
        lane(1, solid),
        lane(-1, &beside),
        lane(-2, solid),
    )
}

#[test]
fn no_place_of_a_mark_is_nearer() {
    let straight = std::fs::read_to_string(carried("marks.xodr")).expect("the map can be read");
    for text in [straight, bent(), round()] {
        assert!(check_places(maps::open_text(&text).map(), 300) > 150);
    }
}

/// On `marks.xodr`: along x, lane 1 to the left from y = 0 to 3.5, lane −1 to the right.
#[test]
fn marks_of_every_form_answer_as_written() {
    let snapshot = maps::open(&carried("marks.xodr"));
    let map = snapshot.map();
    let check =
        |x: f64, y: f64, expected: (f64, Side, RoadMarkKind, RoadMarkColor, &str, Option<bool>)| {
            let found =
                map.nearest_mark(DVec2::new(x, y), &MarkFilter::default()).expect("an answer");
            let found = found.expect("a mark");
            let lane = map.lane(found.lane).expect("a lane").key().to_string();
            let got = (
                found.side_of_reference_line,
                found.kind,
                found.color,
                lane.as_str(),
                found.painted,
            );
            let (distance, side, kind, color, lane, painted) = expected;
            assert_eq!(got, (side, kind, color, lane, painted), "{x}, {y}");
            assert!((found.distance - distance).abs() < 1e-9, "{x}, {y}: {}", found.distance);
            found.s
        };
    use RoadMarkColor::{White, Yellow};
    use RoadMarkKind::{Broken, Custom, Edge, Solid, SolidBroken};
    let (left, right) = (Side::Left, Side::Right);
    // Dashes of a metre, gaps of two.
    for (x, painted) in [(30.5, true), (31.5, false), (32.9, false), (33.5, true)] {
        let s = check(x, -3.0, (0.5, right, Broken, White, "1:0:-1", Some(painted)));
        assert!((s - x).abs() < 1e-9, "{x}: {s}");
    }
    check(30.5, -3.7, (0.2, left, Broken, White, "1:0:-1", Some(true)));
    check(10.0, 0.5, (0.5, right, SolidBroken, Yellow, "1:0:0", None));
    check(10.0, 3.0, (0.5, left, Solid, White, "1:0:1", Some(true)));
    check(10.0, 6.0, (1.0, right, Edge, White, "1:0:2", Some(true)));
    // A line from 62 to 67, 0.2 m to the left of the border.
    check(65.0, -3.5, (0.2, left, Custom, White, "1:0:-1", Some(true)));
    // Sway puts the centre's mark at 0.8 where s is 70; there it rises by 8 %.
    let slope = (1.0f64 + 0.08 * 0.08).sqrt();
    let s = check(
        70.0 - 0.08 * 0.1 / slope,
        0.8 + 0.1 / slope,
        (0.1, right, Broken, Yellow, "1:0:0", None),
    );
    assert!((s - 70.0).abs() < 1e-6, "{s}");
    // The right one of two kinds, where another is nearer.
    let filter = MarkFilter { kinds: MarkKinds::NONE.with(Edge), ..MarkFilter::default() };
    let found =
        map.nearest_mark(DVec2::new(10.0, 3.4), &filter).expect("an answer").expect("a mark");
    assert_eq!((found.kind, (found.distance - 1.6).abs() < 1e-9), (Edge, true));
}

#[test]
fn many_points_answer_as_each_does() {
    let snapshot = maps::open(&carried("marks.xodr"));
    let (map, filter, mut random) = (snapshot.map(), MarkFilter::default(), Random(5));
    let mut points: Vec<DVec2> = (0..100).map(|_| random.point(map)).collect();
    let mut out = Vec::new();
    map.nearest_marks(&points, &filter, &mut out).expect("answers");
    let single = |point: &DVec2| map.nearest_mark(*point, &filter).expect("an answer");
    assert_eq!(out, points.iter().map(single).collect::<Vec<_>>());
    points[42].y = f64::NAN;
    assert_eq!(map.nearest_marks(&points, &filter, &mut out), Err(QueryError::NotFiniteAt(42)));
    let endless = MarkFilter { radius: f64::INFINITY, ..filter };
    let refused = Err(QueryError::Option("radius"));
    assert_eq!(map.nearest_mark(DVec2::ZERO, &endless), refused.map(|()| None));
    assert_eq!(map.nearest_marks(&points[..1], &endless, &mut out), refused);
}

/// In clouds, in junctions too, where marks of many lanes cross: the same bits as one by one, in whatever order the points come.
#[test]
fn clouds_answer_as_each_point_does() {
    for path in maps::carried_and(&["carla/Town05", "Scenic/Issue189"]) {
        let snapshot = maps::open(&path);
        let (map, mut random, mut out) = (snapshot.map(), Random(37), Vec::new());
        let roads: Vec<_> = map.roads().collect();
        for (radius, filter) in [
            (5.0, MarkFilter::default()),
            (1.0, MarkFilter { radius: 20.0, ..MarkFilter::default() }),
            (
                8.0,
                MarkFilter {
                    types: LaneTypes::NONE.with(LaneType::Driving),
                    ..MarkFilter::default()
                },
            ),
        ] {
            let mut points = Vec::new();
            for _ in 0..6 {
                let road = roads.get((random.unit() * roads.len() as f64) as usize);
                let road = road.expect("a road");
                let track = Track { s: random.unit() * road.length(), t: 0.0, h: 0.0 };
                let middle = road.to_inertial(track).expect("a place").position.truncate();
                points.extend((0..100).map(|_| {
                    let away = DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
                    middle + radius * away
                }));
            }
            map.nearest_marks(&points, &filter, &mut out).expect("answers");
            for (point, found) in points.iter().zip(&out) {
                let single = map.nearest_mark(*point, &filter).expect("an answer");
                assert_eq!(*found, single, "{}: {point}", path.display());
            }
        }
    }
}

/// A grid over marks, its places as far from two of them as from one: alone and together the same one.
fn check_grid(map: Map<'_>, low: DVec2, high: DVec2, name: &str) {
    let filter = MarkFilter::default();
    let steps = ((high - low) / GRID).floor();
    let row = |y: f64| (0..=steps.x as usize).map(move |x| low + GRID * DVec2::new(x as f64, y));
    let points: Vec<DVec2> = (0..=steps.y as usize).flat_map(|y| row(y as f64)).collect();
    let mut out = Vec::new();
    map.nearest_marks(&points, &filter, &mut out).expect("answers");
    assert!(out.iter().flatten().count() > 100, "{name}");
    for (point, found) in points.iter().zip(&out) {
        let single = map.nearest_mark(*point, &filter).expect("an answer");
        assert_eq!(*found, single, "{name}: {point}");
    }
}

#[test]
fn of_marks_equally_near_the_same_one_is_found() {
    let marks = carried("marks.xodr");
    let (low, high) = (DVec2::new(0.0, -6.0), DVec2::new(100.0, 6.0));
    check_grid(maps::open(&marks).map(), low, high, "as it is");
    // A line far from its border.
    let text = std::fs::read_to_string(&marks).expect("a map");
    for (offset, name) in [("-5", "far from its border"), ("1e9", "farther than any road is wide")]
    {
        let far = text.replacen("tOffset=\"0\"", &format!("tOffset=\"{offset}\""), 1);
        assert_ne!(far, text, "a line has an offset");
        check_grid(maps::open_text(&far).map(), low - DVec2::Y * 8.0, high, name);
    }
}

/// Points lie on marks, painted places have one at every multiple of the spacing, and each comes once, by whatever rectangle.
#[test]
fn points_of_marks_are_every_painted_place_once() {
    let snapshot = maps::open(&carried("marks.xodr"));
    let (map, mut random) = (snapshot.map(), Random(23));
    let (filter, mut out) = (MarkFilter::default(), Vec::new());
    let whole = Region { low: DVec2::splat(-1e4), high: DVec2::splat(1e4) };
    map.mark_points(whole, 0.25, &filter, &mut out).expect("an answer");
    let all = out.clone();
    assert!(all.len() > 500, "only {} points", all.len());
    let bits = |point: &MarkPoint| point.position.to_array().map(f64::to_bits);
    let mut places: Vec<_> = all.iter().map(bits).collect();
    places.sort_unstable();
    places.dedup();
    assert_eq!(places.len(), all.len(), "some points come twice");
    for point in &all {
        let near = map.nearest_mark(point.position.truncate(), &filter).expect("an answer");
        let near = near.expect("a mark");
        assert!(near.distance < 1e-6 && near.painted != Some(false), "{point:?}: {near:?}");
    }
    // The nearest mark is no farther than the nearest of them, and by no more nearer than they are apart; gaps have none.
    let (mut asked, mut questions) = (0, Random(29));
    for _ in 0..300 {
        let point = questions.point(map);
        let distance = |one: &MarkPoint| one.position.truncate().distance(point);
        let least = all.iter().map(distance).fold(f64::INFINITY, f64::min);
        let near = map.nearest_mark(point, &filter).expect("an answer");
        let Some(near) = near.filter(|near| near.painted == Some(true)) else { continue };
        assert!(
            near.distance <= least + 1e-9 && near.distance >= least - 0.26,
            "{point}: {near:?}"
        );
        asked += 1;
    }
    assert!(asked > 50, "{asked}");
    // A solid line has its length over the spacing; of the broken one a third is painted.
    let lane = map.lane_by_key(&"1:0:1".parse().expect("a key")).expect("a lane");
    let lane = MarkSource::Lane(lane.lane_id());
    let solid = all.iter().filter(|point| point.source == lane && point.s < 40.0).count();
    assert_eq!(solid, 160);
    let lane = map.lane_by_key(&"1:0:-1".parse().expect("a key")).expect("a lane");
    let lane = MarkSource::Lane(lane.lane_id());
    let broken = all.iter().filter(|p| p.source == lane && (30.0..39.0).contains(&p.s)).count();
    assert!((12..=15).contains(&broken), "{broken}");
    for _ in 0..50 {
        let low = random.point(map);
        let size = DVec2::new(random.between(0.1, 30.0), random.between(0.1, 8.0));
        let region = Region { low, high: low + size };
        map.mark_points(region, 0.25, &filter, &mut out).expect("an answer");
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
    assert!(map.mark_points(whole, f64::NAN, &filter, &mut out).is_err());
}
