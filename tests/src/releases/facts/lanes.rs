//! Lanes: neighbours, borders, heights, materials, speeds, rules, road marks.

use super::line::{Fine, Lines};
use super::{all_lanes, key, keys, lane_line, stations};
use mapd_client::Map;
use mapd_query::Lane;
use mapd_query::roads::Polyline;

pub(super) fn facts(map: Map<'_>, lines: &mut Lines) {
    for lane in all_lanes(map) {
        of_lane(map, &lane, lines);
        for (name, line) in [("border", lane.border()), ("centre", lane.center_line())] {
            of_polyline(name, line, lines);
        }
        let (from, to) = (lane.section().s_start(), lane.section().s_end());
        for s in stations(from, to) {
            at_station(map, &lane, s, lines);
        }
        records(&lane, lines);
        marks(&lane, lines);
    }
}

fn of_lane(map: Map<'_>, lane: &Lane<'_>, lines: &mut Lines) {
    let beside = [lane.left(), lane.right(), lane.inner(), lane.opposite()];
    lines
        .about(format_args!("lane {}", lane.key()))
        .word("kind", lane.kind().name())
        .with("by_key", map.lane_by_key(&lane.key()).map(|lane| lane.key().to_string()))
        .with("forward", lane.is_forward())
        .with("both_ways", lane.is_bidirectional())
        .with("temporary", lane.is_temporary())
        .with("continues", lane.continues())
        .with("beside", beside.map(|lane| lane.map(|lane| lane.key().to_string())))
        .with("to", lane.successors().map(|id| key(map, id)).collect::<Vec<_>>())
        .with("from", lane.predecessors().map(|id| key(map, id)).collect::<Vec<_>>())
        .with("breaks", lane.shape_breaks().collect::<Vec<_>>());
    let stop = lane.movement_stop().map(|line| lane_line(map, line));
    lines
        .about("movement")
        .word("turn", format_args!("{:?}", lane.turn()))
        .with("start", lane.movement_start().key().to_string())
        .with("entries", keys(lane.entries()))
        .with("lanes", keys(lane.movement_lanes()))
        .with("stop", stop)
        .with("stops", lane.lines_to_stop_at().map(|l| lane_line(map, l)).collect::<Vec<_>>())
        .with("crossings", lane.crossings().map(|l| lane_line(map, l)).collect::<Vec<_>>())
        .with(
            "movement_crossings",
            lane.movement_crossings().map(|l| lane_line(map, l)).collect::<Vec<_>>(),
        );
}

fn of_polyline(name: &str, line: Polyline<'_>, lines: &mut Lines) {
    let points: Vec<_> = line
        .points()
        .map(|point| [point.s, point.position.x, point.position.y, point.position.z])
        .collect();
    lines.about(name).with("points", points);
}

fn at_station(map: Map<'_>, lane: &Lane<'_>, s: f64, lines: &mut Lines) {
    let (edges, height, rule) = (lane.edges_at(s), lane.height_at(s), lane.speed_rule_at(s));
    let overtaking = lane.overtaking_rule_at(s);
    let signal = |id| map.signal(id).ok().map(|signal| signal.id());
    lines
        .about(format_args!("at {s:.3}"))
        .with("edges", [edges.inner, edges.outer])
        .with("width", lane.width_at(s))
        .with("bounds", lane.bounds_at(s))
        .with("edge_points", lane.edge_points_at(s))
        .with("height", [height.inner, height.outer])
        .with("material", lane.material_at(s).map(|material| material.s))
        .with("access", lane.access_at(s).map(|class| class.name()).collect::<Vec<_>>())
        .with("limit", lane.recorded_speed_limit_at(s))
        .with("max", rule.max)
        .word("origin", rule.origin.name())
        .with("sign", rule.signal.and_then(signal))
        .with("overtaking", [overtaking.all, overtaking.trucks].map(|id| id.and_then(signal)));
    if let Ok(pose) = lane.pose_at(s, 0.25) {
        let angles = [pose.heading, pose.curvature, pose.slope, pose.superelevation];
        lines.about("pose").with("place", pose.position).with("angles", angles.map(Fine));
    }
}

fn records(lane: &Lane<'_>, lines: &mut Lines) {
    for speed in lane.speeds() {
        lines
            .about(format_args!("speed {}", speed.kind.name()))
            .with("s", speed.s)
            .with("max", speed.max);
    }
    for rule in lane.rules() {
        lines.about(format_args!("rule {:?}", rule.value)).with("s", rule.s);
    }
    for one in lane.visibilities() {
        lines
            .about("visibility")
            .with("s", one.s)
            .with("distances", [one.forward, one.back, one.left, one.right]);
    }
    for s in stations(lane.section().s_start(), lane.section().s_end()) {
        if let Some(material) = lane.material_at(s) {
            lines
                .about(format_args!("material {:?}", material.surface))
                .with("s", material.s)
                .with("friction", material.friction)
                .with("roughness", material.roughness);
        }
    }
}

fn marks(lane: &Lane<'_>, lines: &mut Lines) {
    for mark in lane.road_marks() {
        let middle = (mark.s() + mark.s_end()) / 2.0;
        lines
            .about(format_args!("mark {}", mark.kind().name()))
            .with("s", [mark.s(), mark.s_end()])
            .word("color", mark.color().name())
            .word("weight", mark.weight().name())
            .word("change", mark.lane_change().name())
            .with("size", [mark.width(), mark.height()])
            .with("default_width", mark.width_or_default())
            .with("material", mark.material())
            .with("pattern", mark.pattern_name())
            .with("sway", [mark.sway_at(mark.s()), mark.sway_at(middle)])
            .with("t", [mark.t_at(mark.s()), mark.t_at(middle)]);
        for line in mark.lines() {
            lines
                .about(format_args!("mark line {}", line.color.name()))
                .word("rule", line.rule.name())
                .with("length", line.length)
                .with("space", line.space)
                .with("offset", [line.s_offset, line.t_offset])
                .with("width", line.width);
        }
    }
}
