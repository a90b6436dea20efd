//! Connections by the road that leads in.

use crate::draft::Draft;
use mapd_archive::Range;

/// Connections by incoming road, with their junction.
pub(crate) struct Incoming {
    /// Per road a range of `connections`.
    ranges: Vec<Range>,
    /// (junction, connection) rows.
    connections: Vec<(u32, u32)>,
}

impl Incoming {
    pub(crate) fn new(draft: &Draft) -> Self {
        let rows = &draft.rows;
        let mut all: Vec<(u32, (u32, u32))> = Vec::new();
        for (junction, row) in rows.junctions.iter().enumerate() {
            let range = row.connections;
            for (i, connection) in range.of(&rows.connections).iter().enumerate() {
                if (connection.incoming_road as usize) < rows.roads.len() {
                    all.push((connection.incoming_road, (junction as u32, range.first + i as u32)));
                }
            }
        }
        all.sort_by_key(|(road, _)| *road);
        let mut ranges = vec![Range::default(); rows.roads.len()];
        for (i, (road, _)) in all.iter().enumerate() {
            if let Some(range) = ranges.get_mut(*road as usize) {
                if range.count == 0 {
                    range.first = i as u32;
                }
                range.count += 1;
            }
        }
        Self { ranges, connections: all.into_iter().map(|(_, connection)| connection).collect() }
    }

    /// (junction, connection) rows of the connections that a road leads into.
    pub(crate) fn of_road(&self, road: u32) -> &[(u32, u32)] {
        self.ranges.get(road as usize).copied().unwrap_or_default().of(&self.connections)
    }
}
