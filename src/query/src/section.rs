//! Lane sections.

use crate::ids::LaneSectionId;
use crate::lane::Lane;
use crate::map::Map;
use crate::road::Road;
use mapd_archive::{ArchivedLaneRow, ArchivedSectionRow};

/// A lane section: a stretch of a road with the same lanes (OpenDRIVE 1.8.1, 11.3).
#[derive(Clone, Copy)]
pub struct LaneSection<'a> {
    pub(crate) map: Map<'a>,
    number: u32,
    pub(crate) row: &'a ArchivedSectionRow,
}

impl<'a> LaneSection<'a> {
    pub(crate) fn new(map: Map<'a>, number: u32) -> Option<Self> {
        Some(Self { map, number, row: map.tables().sections.get(number as usize)? })
    }

    /// Dense id.
    pub fn section_id(&self) -> LaneSectionId {
        LaneSectionId::new(self.number, self.map.content())
    }

    /// The road.
    pub fn road(&self) -> Option<Road<'a>> {
        Road::new(self.map, self.row.road())
    }

    /// Number in its road, from 0.
    pub fn number(&self) -> u32 {
        self.row.number()
    }

    /// Start on the road `[m]`.
    pub fn s_start(&self) -> f64 {
        self.row.s_start()
    }

    /// End on the road `[m]`.
    pub fn s_end(&self) -> f64 {
        self.row.s_end()
    }

    /// The lane with OpenDRIVE's number; 0 is the centre lane.
    pub fn lane(&self, number: i32) -> Option<Lane<'a>> {
        let lanes = self.rows();
        // Falling numbers from left to right.
        let at = lanes.binary_search_by(|lane| number.cmp(&lane.number())).ok()?;
        Lane::new(self.map, self.row.lanes().first + at as u32)
    }

    /// Lanes from left to right, lane 0 among them.
    pub fn lanes(&self) -> impl Iterator<Item = Lane<'a>> + use<'a> {
        let map = self.map;
        let rows = self.row.lanes().rows(map.tables().lanes.len());
        rows.filter_map(move |row| Lane::new(map, row))
    }

    /// The lane that covers lateral position t at s; `None` beside all lanes. On a shared edge the lane nearer to
    /// lane 0 wins.
    pub fn lane_at(&self, s: f64, t: f64) -> Option<Lane<'a>> {
        let mut hit: Option<Lane<'a>> = None;
        for lane in self.lanes().filter(|lane| lane.number() != 0) {
            let edges = lane.edges_at(s);
            let inside = t >= edges.inner.min(edges.outer) && t <= edges.inner.max(edges.outer);
            if inside
                && edges.width() > 0.0
                && hit.is_none_or(|h| lane.number().unsigned_abs() < h.number().unsigned_abs())
            {
                hit = Some(lane);
            }
        }
        hit
    }

    #[inline]
    pub(crate) fn rows(&self) -> &'a [ArchivedLaneRow] {
        self.row.lanes().of(self.map.tables().lanes)
    }
}
