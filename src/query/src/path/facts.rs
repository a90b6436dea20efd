//! What a path comes by, in the order of S.

use super::{Path, Piece};
use crate::extents::SRange;
use crate::graph::LaneNode;
use crate::ids::{JunctionId, LaneId, SignalId};
use crate::lane::Lane;
use crate::map::Map;
use crate::rules::{LaneLine, LineSource, Turn};
use crate::view::View;
use glam::DVec3;
use mapd_archive::{LaneType, RoadType, StructureKind, string};

/// A part of the document that is left out of the map is told where the driven line is this near to its extent `[m]`.
const HOLE_REACH: f64 = 10.0;

/// Something that a path comes by.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathFact {
    /// S of its beginning and end `[m]`; twice the same for what has a place alone.
    pub along: [f64; 2],
    /// The driven lane at its beginning.
    pub lane: LaneId,
    /// What it is.
    pub kind: PathFactKind,
}

/// What a path comes by.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
#[non_exhaustive]
pub enum PathFactKind {
    /// A junction, from where the path enters it to where it leaves it.
    Junction {
        /// The junction.
        junction: JunctionId,
        /// Where the movement leads.
        turn: Turn,
    },
    /// A signal for the driven lane.
    Signal {
        /// The signal.
        signal: SignalId,
        /// Whether it is for what the path does: a light with arrows is for some of the turns at the next junction only, one that is out of service for none.
        governs: bool,
    },
    /// A stop line, crosswalk or bicycle crossing.
    Line {
        /// The line.
        line: LaneLine,
        /// Left and right end on the driven lane, inertial `[m]`.
        ends: [DVec3; 2],
    },
    /// Type of the road, where the file gives one.
    RoadType(RoadType),
    /// Type of the driven lane.
    LaneType(LaneType),
    /// The country whose rules hold, where the file gives one.
    Country {
        /// Its number for [`Map::country`].
        number: u32,
    },
    /// Who may use the driven lane in its driven direction.
    Access {
        /// A bit for each class of vehicles that may: [`VehicleClass::bit`](mapd_archive::VehicleClass::bit).
        classes: u16,
    },
    /// A bridge or tunnel.
    Structure {
        /// Which of the two.
        kind: StructureKind,
        /// Its number among [`crate::Map::structures`].
        number: u32,
    },
    /// A part of the document near the path that is left out of the map.
    Hole {
        /// Its number among [`crate::Map::quarantined`].
        number: u32,
    },
}

impl<'a> Map<'a> {
    /// A country of [`PathFactKind::Country`] or of [`Road::types`](crate::Road::types), as the file writes it: two or three letters, or a name in older
    /// versions. None for a number that is not one of the map's.
    pub fn country(&self, number: u32) -> Option<&'a str> {
        Some(string(self.tables(), number)).filter(|text| !text.is_empty())
    }
}

impl<'a> Path<'a, '_> {
    /// What the path comes by, in ascending S: junctions with the turn, signals, stop lines and crossings, types of roads and lanes, countries, who
    /// may use the lane, bridges and tunnels, and holes of the map. What goes on over several lanes stands once. Speed limits are [`Path::speeds`]. `out` is emptied
    /// first; it grows only if its capacity is too small.
    pub fn facts(&self, out: &mut Vec<PathFact>) {
        self.facts_in(None, out);
    }

    /// As [`Path::facts`], with the lights that work in a view, and who may use lanes there.
    pub(crate) fn facts_in(&self, view: Option<View<'a>>, out: &mut Vec<PathFact>) {
        out.clear();
        for (number, piece) in self.buffer.pieces.iter().enumerate() {
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            self.points(number, piece, &lane, view, out);
            self.stretches(piece, &lane, view, out);
        }
        self.holes(out);
        // Sorting in place allocates nothing; what begins at one place keeps an order of its own.
        out.sort_unstable_by(|a, b| {
            let place = |fact: &PathFact| (fact.along[0], fact.along[1]);
            let ((a_from, a_to), (b_from, b_to)) = (place(a), place(b));
            a_from.total_cmp(&b_from).then(rank(a).cmp(&rank(b))).then(a_to.total_cmp(&b_to))
        });
        // A line over both lanes of a change counts once.
        out.dedup_by(|next, before| match (next.kind, before.kind) {
            (PathFactKind::Line { line: a, .. }, PathFactKind::Line { line: b, .. }) => {
                a.source == b.source && next.along == before.along
            }
            _ => false,
        });
    }

    /// Signals and lines.
    fn points(
        &self,
        number: usize,
        piece: &Piece,
        lane: &Lane<'a>,
        view: Option<View<'a>>,
        out: &mut Vec<PathFact>,
    ) {
        let own = lane.lane_id();
        for one in lane.signals().filter(|one| one.is_for(piece.forward)) {
            let signal = one.signal();
            let Some(along) = self.along_on(piece, one.s_on(lane)) else { continue };
            if signal.is_invalidated() {
                continue;
            }
            let light = signal.light();
            let works = || view.is_none_or(|view| view.is_in_service(signal.signal_id()));
            let governs = light.is_none_or(|light| {
                works() && self.next_turn(number).is_none_or(|turn| light.governs(turn))
            });
            let kind = PathFactKind::Signal { signal: signal.signal_id(), governs };
            out.push(PathFact { along: [along; 2], lane: own, kind });
        }
        for line in lane.all_lines(piece.forward) {
            let along = self.along_on(piece, line.s);
            let bounds = super::corridor::bounds(lane, piece.forward, line.s);
            if let (Some(along), Some(ends)) = (along, bounds) {
                let kind = PathFactKind::Line { line, ends };
                out.push(PathFact { along: [along; 2], lane: own, kind });
            }
        }
    }

    /// The turn at the junction that a piece lies in, or else at the next one.
    fn next_turn(&self, number: usize) -> Option<Turn> {
        let rest = self.buffer.pieces.get(number..).unwrap_or(&[]).iter();
        let mut lanes = rest.filter_map(|piece| Lane::new(self.map, piece.lane));
        lanes.find(|lane| lane.road().junction_row().is_some()).map(|lane| lane.turn())
    }

    fn stretches(
        &self,
        piece: &Piece,
        lane: &Lane<'a>,
        view: Option<View<'a>>,
        out: &mut Vec<PathFact>,
    ) {
        let road = lane.road();
        let whole = self.ends_of(piece);
        let id = lane.lane_id();
        let mut add = |along: [f64; 2], kind: PathFactKind| {
            let fact = PathFact { along, lane: id, kind };
            let goes_on = |before: &PathFact| {
                before.along[1] == along[0] && before.kind == kind && along[0] > 0.0
            };
            // What the lane before has ends where this one begins.
            match out.iter_mut().rev().take(MOST_OPEN).find(|before| goes_on(before)) {
                Some(before) => before.along[1] = along[1],
                None => out.push(fact),
            }
        };
        add(whole, PathFactKind::LaneType(lane.kind()));
        if let Some(junction) = road.junction() {
            let (junction, turn) = (junction.junction_id(), lane.turn());
            add(whole, PathFactKind::Junction { junction, turn });
        }
        let inside = |from: f64, to: f64| self.overlap(piece, [from, to]);
        let mut types = road.types().peekable();
        while let Some(own) = types.next() {
            let to = types.peek().map_or(f64::MAX, |next| next.s);
            if let Some(along) = inside(own.s, to) {
                add(along, PathFactKind::RoadType(own.kind));
                if let Some(number) = own.country {
                    add(along, PathFactKind::Country { number });
                }
            }
        }
        for node in lane.nodes().filter(|node| node.is_forward() == piece.forward) {
            let mut tell = |node: &LaneNode<'a>| {
                let SRange { low, high } = node.s_range();
                if let Some(along) = inside(low, high) {
                    add(along, PathFactKind::Access { classes: node.access() });
                }
            };
            match view {
                Some(view) => view.each_piece(&node, tell),
                None => tell(&node),
            }
        }
        let rows = self.map.tables().structures;
        let first = rows.partition_point(|row| row.road() < road.road_id().row());
        for (number, structure) in (first as u32..).zip(road.structures()) {
            let SRange { low: from, high: to } = structure.s_range();
            let lane_number = lane.number();
            let holds = structure.validities().len() == 0
                || structure
                    .validities()
                    .any(|lanes| (lanes.from..=lanes.to).contains(&lane_number));
            if let Some(along) = inside(from, to).filter(|_| holds) {
                let kind = structure.kind();
                add(along, PathFactKind::Structure { kind, number });
            }
        }
    }

    /// S of what a piece has between two s of its road; none where that has no length.
    pub(super) fn overlap(&self, piece: &Piece, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
        let spans = self.spans_of(piece);
        let (a, b) = (spans.first()?.s[0], spans.last()?.s[1]);
        let (from, to) = (low.max(a.min(b)), high.min(a.max(b)));
        let ends = if piece.forward { [from, to] } else { [to, from] };
        (from < to).then(|| ends.map(|s| self.along_in(piece, s)))
    }

    fn holes(&self, out: &mut Vec<PathFact>) {
        for (number, part) in (0u32..).zip(self.map.quarantined()) {
            let kind = PathFactKind::Hole { number };
            let mut open: Option<PathFact> = None;
            for span in &self.buffer.spans {
                let places = span.ends.map(|end| end + self.map.origin());
                let middle = 0.5 * (places[0] + places[1]);
                let reach = HOLE_REACH + 0.5 * places[0].distance(places[1]) + span.slack;
                let near = part.distance(middle).is_some_and(|distance| distance <= reach);
                match (&mut open, near, self.piece(span)) {
                    (Some(fact), true, _) => fact.along[1] = span.end(),
                    (None, true, Some((_, lane))) => {
                        let along = [span.along, span.end()];
                        open = Some(PathFact { along, lane: lane.lane_id(), kind });
                    }
                    _ => out.extend(open.take()),
                }
            }
            out.extend(open);
        }
    }
}

/// Facts of one lane that are looked through for one that goes on: its own and those of the lane before.
const MOST_OPEN: usize = 64;

/// Order of what begins at one place.
fn rank(fact: &PathFact) -> (u8, u32) {
    match fact.kind {
        PathFactKind::RoadType(_) => (0, 0),
        PathFactKind::LaneType(_) => (1, 0),
        PathFactKind::Country { .. } => (2, 0),
        PathFactKind::Access { .. } => (3, 0),
        PathFactKind::Structure { number, .. } => (4, number),
        PathFactKind::Hole { number } => (5, number),
        PathFactKind::Junction { junction, .. } => (6, junction.row()),
        PathFactKind::Line { line, .. } => match line.source {
            LineSource::Signal(id) => (7, id.row()),
            LineSource::Object(id) => (8, id.row()),
        },
        PathFactKind::Signal { signal, .. } => (9, signal.row()),
    }
}
