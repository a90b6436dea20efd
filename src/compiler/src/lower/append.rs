//! Appends what a part of the document was lowered to, so that the whole is as if it had been lowered in one go.

use super::{Links, Lowering, interned};
use mapd_archive::{Moved, Range, Rows};
use mapd_ontology::Ontology;
use std::sync::Arc;

impl Lowering {
    /// Of a part of the document, to be appended to what comes before it.
    pub(crate) fn part(ontology: Arc<Ontology>) -> Self {
        let interned = interned::Interned::of_part();
        Self { rows: Rows::part(), interned, ..Self::new(ontology) }
    }

    /// Takes the part of the document that comes next. Strings, cubics and styles that are known already stand for its own;
    /// each new one comes where it would if the part had been lowered here.
    pub(crate) fn append(&mut self, part: Self) {
        let mut moves = self.rows.moves();
        moves.strings = Moved::To(self.strings.append(&part.strings));
        let its_cubics = (&part.interned, part.rows.cubics.as_slice());
        moves.cubics = self.interned.append(&mut self.rows.cubics, its_cubics);
        let grids = self.rows.elevation_grids.len();
        moves.road_mark_styles = self.styles.append(&mut self.rows, &part.rows, &moves);
        moves.road_marks =
            self.styles.append_marks(&mut self.rows, &part.rows, &moves.road_mark_styles);
        // The styles' lines are there with them.
        moves.road_mark_lines = Moved::To(Vec::new());
        self.rows.append(&part.rows, &moves);
        self.links.append(part.links, grids);
        self.permissions.append(part.permissions, &moves.lanes);
        self.objects.append(part.objects, &moves);
        self.signals.append(part.signals, &moves);
    }
}

impl Links {
    /// Takes those of the part that comes next; so many elevation grids come before its own.
    fn append(&mut self, part: Self, grids: usize) {
        let by = self.lane_links.len() as u32;
        let lanes = part.lanes.into_iter().map(|links| {
            links.map(|link| Range { first: link.first.wrapping_add(by), count: link.count })
        });
        self.lanes.extend(lanes);
        self.lane_links.extend(part.lane_links);
        self.roads.extend(part.roads);
        self.road_junctions.extend(part.road_junctions);
        self.road_spans.extend(part.road_spans);
        self.junctions.extend(part.junctions);
        // Row 0 of a part is not used.
        self.joints.extend(part.joints.into_iter().map(|mut joint| {
            joint.grid = joint.grid + grids - 1;
            joint
        }));
    }
}
