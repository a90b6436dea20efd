//! Where lanes of different roads may meet: the connecting roads of a junction, with the stretch of the main road that a
//! virtual one or a path across touches, the sections of roads that a crossing names, and the roads of a direct junction as
//! far as they may overlap (OpenDRIVE 1.8.1, 12).

use super::Source;
use crate::draft::Draft;
use mapd_archive::NONE;
use mapd_rules::network::{Contact, JunctionFacts};
use mapd_xodr::{Junction, JunctionType, Span, Text as _, Value as _};
use std::collections::HashMap;

/// How far `[m]` along a road the lanes are looked at that a path across it may meet: more than a path is wide.
const CROSSING_REACH: f64 = 10.0;
/// Length `[m]` over which lanes of a direct junction may overlap where the file states none (OpenDRIVE 1.8.1, 12.4.2).
const OVERLAP_ZONE: f64 = 100.0;

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
    pub(crate) kind: ZoneKind,
}

/// What is looked for in a zone.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum ZoneKind {
    /// A common or virtual junction.
    Common,
    /// A junction of type `crossing`.
    Crossing,
    /// A direct junction: lanes that part share their area for a while, and the file says for how long.
    Direct,
}

/// Stretches as they are found.
#[derive(Default)]
struct Stretches {
    all: Vec<Stretch>,
    /// By road its first one.
    first: HashMap<u32, usize>,
}

impl Stretches {
    fn add(&mut self, stretch: Stretch) {
        self.first.entry(stretch.road).or_insert(self.all.len());
        self.all.push(stretch);
    }

    /// Lets a road's stretch reach to a place.
    fn touch(&mut self, road: u32, s: f64) {
        match self.first.get(&road).and_then(|first| self.all.get_mut(*first)) {
            Some(stretch) => {
                (stretch.s_from, stretch.s_to) = (stretch.s_from.min(s), stretch.s_to.max(s));
            }
            None if road != NONE => self.add(Stretch { road, s_from: s, s_to: s }),
            None => {}
        }
    }
}

/// The zones of all junctions in their order.
pub(crate) fn zones(source: Source<'_>) -> Vec<Zone> {
    let Source { draft, links } = source;
    let rows = &draft.rows;
    let mut stretches: Vec<Stretches> = links
        .junctions()
        .map(|junction| {
            let mut stretches = Stretches::default();
            if let Some(junction) = &junction.written {
                named(draft, junction, &mut stretches);
                crossed(draft, junction, &mut stretches);
            }
            stretches
        })
        .collect();
    for (number, road) in rows.roads.iter().enumerate().filter(|(_, road)| road.junction != NONE) {
        if let Some(stretches) = stretches.get_mut(road.junction as usize) {
            let road_number = number as u32;
            stretches.add(Stretch { road: road_number, s_from: 0.0, s_to: road.length });
            // Where it attaches inside another road, that road is part of the zone.
            let ends = Contact::BOTH.into_iter().zip([road.predecessor, road.successor]);
            for (end, target) in ends {
                if let Some(s) = links.road_link(road_number, end).and_then(|link| link.s) {
                    stretches.touch(target, s);
                }
            }
        }
    }
    let zone = |(number, (junction, mut stretches)): (u32, (&JunctionFacts, Stretches))| {
        let kind = match junction.kind {
            JunctionType::Crossing => ZoneKind::Crossing,
            JunctionType::Direct => {
                overlaps(source, number, &mut stretches);
                ZoneKind::Direct
            }
            _ => ZoneKind::Common,
        };
        Zone { stretches: stretches.all, span: junction.span, kind }
    };
    (0..).zip(links.junctions().zip(stretches)).map(zone).collect()
}

/// Stretches of roads around the ends of paths across them.
fn crossed(draft: &Draft, junction: &Junction, stretches: &mut Stretches) {
    let ends = junction.cross_path.iter().flat_map(|path| {
        [
            (path.road_at_start.text(), path.start_lane_link.as_deref()),
            (path.road_at_end.text(), path.end_lane_link.as_deref()),
        ]
    });
    // Apart from those that the junction names.
    let mut crossed = Stretches::default();
    for (id, link) in ends {
        if let Some(road) = road_of(draft, id)
            && let Some(s) = link.and_then(|link| link.s.value())
        {
            crossed.touch(road, s - CROSSING_REACH);
            crossed.touch(road, s + CROSSING_REACH);
        }
    }
    crossed.all.into_iter().for_each(|stretch| stretches.add(stretch));
}

/// Stretches of the roads of a direct junction along which their lanes may overlap: the longest of each road's lane links,
/// from the joint.
fn overlaps(source: Source<'_>, junction: u32, stretches: &mut Stretches) {
    let rows = &source.draft.rows;
    let links = source.links;
    let Some(facts) = links.junction(junction) else { return };
    let Some(row) = rows.junctions.get(junction as usize) else { return };
    let written = facts.written.as_ref().map_or(&[][..], |junction| &junction.connection);
    let of_facts = links.network.connections_of(facts);
    for ((number, connection), connected) in
        row.connections.of(&rows.connections).iter().enumerate().zip(of_facts)
    {
        let own = written.get(number).map_or(&[][..], |connection| &connection.lane_link);
        let zones = own.iter().map(|link| link.overlap_zone.value());
        let longest = zones.map(|zone| zone.unwrap_or(OVERLAP_ZONE)).reduce(f64::max);
        let zone = longest.unwrap_or(OVERLAP_ZONE);
        let mut from_joint = |road: u32, at_end: bool| {
            let length = rows.roads.get(road as usize).map_or(0.0, |road| road.length);
            let (near, far) = if at_end { (length, length - zone) } else { (0.0, zone) };
            stretches.touch(road, near);
            stretches.touch(road, far);
        };
        let [incoming, linked] = links.network.connected_ends(facts, connected);
        for (road, at) in
            [(connection.connecting_road, linked), (connection.incoming_road, incoming)]
        {
            if let Some(at) = at {
                from_joint(road, at.end == Contact::End);
            }
        }
    }
}

/// Stretches that a junction names itself.
fn named(draft: &Draft, junction: &Junction, stretches: &mut Stretches) {
    let stretch = |id: &str, from: Option<f64>, to: Option<f64>| {
        let road = road_of(draft, id)?;
        let (from, to) = (from?, to?);
        Some(Stretch { road, s_from: from.min(to), s_to: from.max(to) })
    };
    let sections = junction.road_section.iter().filter_map(|section| {
        stretch(section.road_id.text(), section.s_start.value(), section.s_end.value())
    });
    let main = stretch(junction.main_road.text(), junction.s_start.value(), junction.s_end.value());
    sections.chain(main).for_each(|stretch| stretches.add(stretch));
}

/// The road of an id.
pub(crate) fn road_of(draft: &Draft, id: &str) -> Option<u32> {
    let rows = &draft.rows;
    let id_of = |row: &u32| {
        rows.roads.get(*row as usize).map_or(&[][..], |road| draft.strings.bytes_of(road.id))
    };
    let at = rows.roads_by_id.binary_search_by(|row| id_of(row).cmp(id.as_bytes())).ok()?;
    rows.roads_by_id.get(at).copied()
}
