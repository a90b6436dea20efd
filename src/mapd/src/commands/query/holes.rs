//! What answers say about parts of the document that are in quarantine: no row is built on a hole without a word.

use super::kinds::{Kind, Tools, lane, point_in};
use super::row::Row;
use mapd_client::roads::RoadLink;
use mapd_client::{Lane, Map, NearestOptions};
use mapd_query::document::Quarantined;
use mapd_query::glam::DVec2;
use mapd_query::vocabulary::QuarantinedKind;

/// Where a lane or route ends, parts as near as this `[m]` may be what it would lead on to.
const REACH: f64 = 1.0;

/// The parts in quarantine that the answers to one query may lack.
pub(crate) struct Holes<'a> {
    map: Map<'a>,
    /// What messages call the document.
    document: &'a str,
}

impl<'a> Holes<'a> {
    pub(crate) fn new(map: Map<'a>, document: &'a str) -> Self {
        Self { map, document }
    }

    /// Why there is no road of this id.
    pub(crate) fn no_road(&self, id: &str) -> String {
        self.because(id, format!("the map has no road {id:?}"))
    }

    /// What is wrong with a road's lanes, and that the road is in quarantine if it is.
    pub(crate) fn because(&self, road: &str, error: String) -> String {
        self.because_of(QuarantinedKind::Road, road, error)
    }

    /// What is wrong with a part, and that it is in quarantine if it is.
    pub(super) fn because_of(&self, kind: QuarantinedKind, id: &str, error: String) -> String {
        match self.map.left_out(kind, id) {
            Some(part) => format!("{error}: {}", part.explained(self.document)),
            None => error,
        }
    }

    /// The parts that an answer to a row may lack, joined by `;`.
    pub(super) fn of(
        &self,
        kind: Kind,
        options: &NearestOptions,
        row: &Row<'_>,
        tools: &Tools<'_>,
    ) -> String {
        let Tools { router, earth, .. } = tools;
        let mut parts = Parts::default();
        match kind {
            Kind::Nearest | Kind::NearestMarks => {
                if let Ok(point) = point_in(row, earth) {
                    parts.add(self.map.quarantined_near(point.xy, options.radius));
                }
            }
            Kind::Ground => {
                if let Ok(point) = point_in(row, earth) {
                    parts.add(self.map.quarantined_near(point.xy, REACH));
                }
            }
            Kind::Match => {
                if let Ok((point, radius)) = super::matching::circle(row, tools.outline) {
                    parts.add(self.map.quarantined_near(point, radius));
                }
            }
            Kind::Objects | Kind::Landmarks => {
                if let Ok((point, radius)) = row.circle() {
                    parts.add(self.map.quarantined_near(point, radius));
                }
            }
            Kind::Signals => self.of_signals(row, &mut parts),
            Kind::Successors => self.of_successors(row, &mut parts),
            Kind::Route | Kind::Path | Kind::Corridor | Kind::Project | Kind::Conflicts => {
                for column in ["from_road", "to_road"] {
                    parts.add(self.road(row, column));
                }
                for end in router.ends(self.map) {
                    parts.add(self.map.quarantined_near(end, REACH));
                }
            }
            Kind::Inertial
            | Kind::Speed
            | Kind::Surface
            | Kind::Lane
            | Kind::Track
            | Kind::Visibility
            | Kind::LaneRule => {
                parts.add(self.road(row, "road_id"));
            }
            Kind::Geodetic | Kind::FromGeodetic | Kind::Annotations | Kind::JunctionGroups => {}
        }
        parts.0.join(";")
    }

    fn road(&self, row: &Row<'_>, column: &str) -> Option<Quarantined<'a>> {
        self.map.left_out(QuarantinedKind::Road, row.text(column).ok()?)
    }

    fn of_signals(&self, row: &Row<'_>, parts: &mut Parts) {
        parts.add(self.road(row, "road_id"));
        let Ok((lane, s)) = lane(self, self.map, row) else { return };
        let Ok(distance) = row.number("distance") else { return };
        if let Ok(pose) = lane.pose_at(s, 0.0) {
            parts.add(self.map.quarantined_near(pose.position.truncate(), distance));
        }
    }

    fn of_successors(&self, row: &Row<'_>, parts: &mut Parts) {
        parts.add(self.road(row, "road_id"));
        let Ok((lane, _)) = lane(self, self.map, row) else { return };
        if let Some(end) = exit(&lane) {
            parts.add(self.map.quarantined_near(end, REACH));
        }
        let road = lane.road();
        let ahead = if lane.is_forward() { road.successor() } else { road.predecessor() };
        if let Some(RoadLink::Junction(junction)) = ahead {
            parts.add(self.map.quarantined().filter(|part| {
                part.owner_kind() == QuarantinedKind::Junction && part.owner() == junction.id()
            }));
        }
    }
}

/// Where a lane ends in driving direction.
pub(super) fn exit(lane: &Lane<'_>) -> Option<DVec2> {
    let section = lane.section();
    let s = if lane.is_forward() { section.s_end() } else { section.s_start() };
    Some(lane.pose_at(s, 0.0).ok()?.position.truncate())
}

/// Names of parts, each once.
#[derive(Default)]
struct Parts(Vec<String>);

impl Parts {
    fn add<'a>(&mut self, parts: impl IntoIterator<Item = Quarantined<'a>>) {
        for name in parts.into_iter().map(|part| part.to_string()) {
            if !self.0.contains(&name) {
                self.0.push(name);
            }
        }
    }
}
