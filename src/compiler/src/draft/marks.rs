//! Road marks, each style and each sequence of them once.

use super::between;
use mapd_archive::{
    KeyedHash, NONE, Range, RoadMarkRow, RoadMarkStyleRow, RowMapping, RowMappings, Rows,
};
use std::collections::HashMap;

/// Numbers of the styles that have been written, by what they and their lines hold.
#[derive(Default)]
pub(crate) struct Styles {
    known: HashMap<Vec<u8>, u32, KeyedHash>,
    /// First rows of sequences of marks, by what they hold.
    sequences: HashMap<Vec<u8>, u32, KeyedHash>,
    /// Room for what is looked up: nearly all of it is there already.
    style: Vec<u8>,
    /// The sequence that is being taken.
    sequence: Vec<RoadMarkRow>,
}

impl Styles {
    /// Begins a sequence of marks.
    pub(crate) fn begin(&mut self) {
        self.sequence.clear();
    }

    /// The next mark: where it begins behind the section's start `[m]`, and its style.
    pub(crate) fn then(&mut self, s: f64, style: u32) {
        self.sequence.push(RoadMarkRow { s_offset: s, style, last: 0, reserved: [0; 3] });
    }

    /// First row of the sequence of marks, which is written if it is a new one.
    pub(crate) fn end(&mut self, rows: &mut Rows) -> u32 {
        let Some(last) = self.sequence.last_mut() else { return NONE };
        last.last = 1;
        // Bytes are hashed at once, and rows number by number.
        let bytes: &[u8] = bytemuck::cast_slice(&self.sequence);
        if let Some(known) = self.sequences.get(bytes) {
            return *known;
        }
        let first = rows.road_marks.len() as u32;
        rows.road_marks.extend_from_slice(&self.sequence);
        self.sequences.insert(bytes.to_vec(), first);
        first
    }

    /// Row of a style whose lines have just been appended from `lines` on: an equal one that is there already takes its
    /// place.
    pub(crate) fn add(&mut self, rows: &mut Rows, style: RoadMarkStyleRow, lines: usize) -> u32 {
        self.style.clear();
        self.style.extend_from_slice(bytemuck::bytes_of(&style));
        self.style.extend_from_slice(bytemuck::cast_slice(&rows.road_mark_lines[lines..]));
        if let Some(known) = self.known.get(&self.style) {
            rows.road_mark_lines.truncate(lines);
            return *known;
        }
        let number = rows.road_mark_styles.len() as u32;
        let lines = between(lines, rows.road_mark_lines.len());
        rows.road_mark_styles.push(RoadMarkStyleRow { lines, ..style });
        self.known.insert(self.style.clone(), number);
        number
    }
}

impl Styles {
    /// Adds the styles of a part of a map, which has `moves` for what they refer to; where each comes to lie.
    pub(super) fn append(
        &mut self,
        rows: &mut Rows,
        part: &Rows,
        moves: &RowMappings,
    ) -> RowMapping {
        let places = part.road_mark_styles.iter().enumerate().map(|(row, style)| {
            // Row 0 of a part is not used.
            if row == 0 {
                return 0;
            }
            let before = rows.road_mark_lines.len();
            rows.road_mark_lines.extend_from_slice(style.lines.of(&part.road_mark_lines));
            let mut style = RoadMarkStyleRow { lines: Range::default(), ..*style };
            style.move_by(moves);
            self.add(rows, style, before)
        });
        RowMapping::To(places.collect())
    }

    /// Adds the sequences of marks of a part, whose styles have come to lie elsewhere; where each comes to lie.
    pub(super) fn append_marks(
        &mut self,
        rows: &mut Rows,
        part: &Rows,
        styles: &RowMapping,
    ) -> RowMapping {
        let mut places = vec![NONE; part.road_marks.len()];
        // Row 0 of a part is not used.
        let marks = part.road_marks.get(1..).unwrap_or_default();
        let mut at = 1;
        for own in marks.split_inclusive(|mark| mark.last != 0) {
            self.begin();
            own.iter().for_each(|mark| self.then(mark.s_offset, styles.row(mark.style)));
            if let Some(place) = places.get_mut(at) {
                *place = self.end(rows);
            }
            at += own.len();
        }
        RowMapping::To(places)
    }
}
