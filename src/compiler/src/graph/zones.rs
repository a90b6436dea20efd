//! Where lanes of different roads may meet: the connecting roads of a junction, with the stretch of the main road that a
//! virtual one touches, and the sections of roads that a crossing names (OpenDRIVE 1.8.1, 12).

use crate::lower::Lowering;
use mapd_archive::NONE;
use mapd_xodr::{Junction, JunctionType, Span, Text as _, Value as _};

/// A stretch of a road.
#[derive(Clone, Copy)]
pub(crate) struct Stretch {
    pub(crate) road: u32,
    pub(crate) s_from: f64,
    pub(crate) s_to: f64,
}

/// Stretches of roads whose lanes may meet each other.
pub(crate) struct Zone {
    pub(crate) stretches: Vec<Stretch>,
    /// The junction's start tag.
    pub(crate) span: Span,
    /// A junction of type `crossing`.
    pub(crate) crossing: bool,
}

/// The zones of all junctions in their order.
pub(crate) fn zones(lowering: &Lowering) -> Vec<Zone> {
    let rows = &lowering.rows;
    let mut zones: Vec<Zone> = lowering
        .links
        .junctions
        .iter()
        .map(|junction| Zone {
            stretches: named(lowering, junction),
            span: junction.span,
            crossing: junction.r#type.value() == Some(JunctionType::Crossing),
        })
        .collect();
    for (number, road) in rows.roads.iter().enumerate().filter(|(_, road)| road.junction != NONE) {
        if let Some(zone) = zones.get_mut(road.junction as usize) {
            let road_number = number as u32;
            zone.stretches.push(Stretch { road: road_number, s_from: 0.0, s_to: road.length });
            // Where it attaches inside another road, that road is part of the zone.
            let ends = [road.predecessor, road.successor];
            let links = lowering.links.roads.get(number).into_iter().flatten();
            for (link, target) in links.zip(ends) {
                if let Some(s) = link.as_ref().and_then(|link| link.element_s.value()) {
                    touch(&mut zone.stretches, target, s);
                }
            }
        }
    }
    zones
}

/// Stretches that a junction names itself.
fn named(lowering: &Lowering, junction: &Junction) -> Vec<Stretch> {
    let stretch = |id: &str, from: Option<f64>, to: Option<f64>| {
        let road = road_of(lowering, id)?;
        let (from, to) = (from?, to?);
        Some(Stretch { road, s_from: from.min(to), s_to: from.max(to) })
    };
    let sections = junction.road_section.iter().filter_map(|section| {
        stretch(section.road_id.text(), section.s_start.value(), section.s_end.value())
    });
    let main = stretch(junction.main_road.text(), junction.s_start.value(), junction.s_end.value());
    sections.chain(main).collect()
}

/// Lets a road's stretch reach to a place.
fn touch(stretches: &mut Vec<Stretch>, road: u32, s: f64) {
    match stretches.iter_mut().find(|stretch| stretch.road == road) {
        Some(stretch) => {
            (stretch.s_from, stretch.s_to) = (stretch.s_from.min(s), stretch.s_to.max(s));
        }
        None if road != NONE => stretches.push(Stretch { road, s_from: s, s_to: s }),
        None => {}
    }
}

/// The road of an id.
pub(crate) fn road_of(lowering: &Lowering, id: &str) -> Option<u32> {
    let rows = &lowering.rows;
    let id_of = |row: &u32| {
        rows.roads.get(*row as usize).map_or(&[][..], |road| lowering.strings.bytes_of(road.id))
    };
    let at = rows.roads_by_id.binary_search_by(|row| id_of(row).cmp(id.as_bytes())).ok()?;
    rows.roads_by_id.get(at).copied()
}
