//! What an archive's rows say that neither [`answers`](super::answers) nor [`facts`](super::facts) show: data as written for which there is no query, places
//! in the file, and the compiler's own figures, such as those that only make searches faster.

use super::facts::{Fine, Lines};
use mapd_archive::{Tables, string};
use mapd_client::Map;

/// A line for each row that has such data, as text: the same for ever.
pub fn rows(map: Map<'_>) -> String {
    let (tables, mut lines) = (map.tables(), Lines::default());
    header(tables, &mut lines);
    places(tables, &mut lines);
    geometries(tables, &mut lines);
    graph(tables, &mut lines);
    index(tables, &mut lines);
    lengths(tables, &mut lines);
    lines.into_text()
}

fn header(tables: &Tables<'_>, lines: &mut Lines) {
    for row in tables.map {
        let stated = [row.stated_north(), row.stated_south(), row.stated_east(), row.stated_west()];
        lines
            .about("map")
            .with("version", string(tables, row.version()))
            .with("date", string(tables, row.date()))
            .with("vendor", string(tables, row.vendor()))
            .with("stated", stated)
            .with("index_tolerance", Fine(row.index_tolerance()))
            .with("bound_tolerance", Fine(row.bound_tolerance()));
    }
    for (number, block) in tables.annotation_blocks.iter().enumerate() {
        lines
            .about(format_args!("annotation block {number}"))
            .with("owner_kind", block.owner_kind());
    }
}

/// Where elements stand in the file, and what they name as written.
fn places(tables: &Tables<'_>, lines: &mut Lines) {
    for row in tables.junctions {
        let id = string(tables, row.id());
        lines.about(format_args!("junction {id:?}")).with("column", row.column());
    }
    for row in tables.signal_places {
        lines.about("signal place").with("at", [row.line(), row.column()]);
    }
    for row in tables.controllers {
        let id = string(tables, row.id());
        lines.about(format_args!("controller {id:?}")).with("at", [row.line(), row.column()]);
    }
    for row in tables.controls {
        lines
            .about(format_args!("control of signal {:?}", string(tables, row.id())))
            .with("type", string(tables, row.r#type()));
    }
    for row in tables.junction_controllers {
        lines
            .about(format_args!("controller of a junction {:?}", string(tables, row.id())))
            .with("type", string(tables, row.r#type()));
    }
}

fn geometries(tables: &Tables<'_>, lines: &mut Lines) {
    for row in tables.geometries {
        lines
            .about("geometry")
            .with("parameter_range", row.parameter_range())
            .word("error", format_args!("{:.3e}", row.error()));
    }
}

/// The graph's bounds by landmarks.
fn graph(tables: &Tables<'_>, lines: &mut Lines) {
    for row in tables.graph {
        lines
            .about("graph")
            .with("components", row.components())
            .with("landmarks", row.landmarks())
            .with("bounds", row.bounds())
            .with("steps", [row.length_step(), row.time_step()].map(Fine))
            .with("changes", [row.change_length(), row.change_time()].map(Fine));
    }
    for row in tables.lane_nodes {
        lines
            .about("node")
            .with("bound", row.bound())
            .with("anchor", [row.anchor_length(), row.anchor_time()]);
    }
    let landmarks = tables.graph.first().map_or(0, |graph| graph.landmarks() as usize);
    // To and from each.
    let of_place = (2 * landmarks).max(1);
    let of_both =
        tables.landmark_lengths.chunks(of_place).zip(tables.landmark_times.chunks(of_place));
    for (lengths, times) in of_both {
        lines.about("landmarks").with("lengths", lengths).with("times", times);
    }
}

/// How long lanes of many records are up to some of these.
fn lengths(tables: &Tables<'_>, lines: &mut Lines) {
    for row in tables.lane_lengths {
        let at = [row.s(), row.length()].map(Fine);
        lines.about("lane length").with("lane", row.lane()).with("at", at);
    }
}

/// How far lanes reach beyond the segments that the index has of them, and what is told of their rows ahead.
fn index(tables: &Tables<'_>, lines: &mut Lines) {
    for row in tables.lane_blocks {
        lines
            .about("lane block")
            .with("first", [row.section(), row.road()])
            .word("starts", format_args!("{:x},{:x}", row.section_starts(), row.road_starts()));
    }
    for row in tables.index_leaves {
        lines.about("leaf").with("overshoot", *row.overshoot()).with("z_high", *row.z_high());
    }
}
