//! Appends what a part of the document was lowered to, so that the whole is as if it had been lowered in one go.

use super::owners::{Before, move_owners};
use super::{Draft, Interned, joints};
use crate::options::Lowering;
use mapd_archive::{RowMapping, Rows};
use mapd_ontology::Ontology;
use std::mem::take;
use std::sync::Arc;

impl Draft {
    /// Of a part of the document, to be appended to what comes before it.
    pub(crate) fn part(ontology: Arc<Ontology>, lowering: Lowering) -> Self {
        let [cubics, coefficients] = [Interned::of_part(), Interned::of_part()];
        Self { rows: Rows::part(), cubics, coefficients, ..Self::new(ontology, lowering) }
    }

    /// Takes the part of the document that comes next. Strings, cubics, coefficients and styles that are known already stand for its own;
    /// each new one comes where it would if the part had been lowered here. What is left of the part is of no use but takes time to free.
    pub(crate) fn append(&mut self, part: &mut Self) {
        let mut moves = self.rows.moves();
        moves.strings = RowMapping::To(self.strings.append(&part.strings));
        let its_cubics = (&part.cubics, part.rows.cubics.as_slice());
        moves.cubics = self.cubics.append(&mut self.rows.cubics, its_cubics);
        let its_coefficients = (&part.coefficients, part.rows.coefficients.as_slice());
        moves.coefficients =
            self.coefficients.append(&mut self.rows.coefficients, its_coefficients);
        let grids = self.rows.elevation_grids.len();
        moves.road_mark_styles = self.styles.append(&mut self.rows, &part.rows, &moves);
        moves.road_marks =
            self.styles.append_marks(&mut self.rows, &part.rows, &moves.road_mark_styles);
        // The styles' lines are there with them.
        moves.road_mark_lines = RowMapping::To(Vec::new());
        let annotated = self.rows.annotations.len();
        self.rows.append(&part.rows, &moves);
        let before = Before {
            connections: self.connections,
            objects: self.objects.objects.len(),
            controllers: self.signals.controllers(),
            stations: self.objects.stations.len(),
        };
        if let Some(new) = self.rows.annotations.get_mut(annotated..) {
            move_owners(new, before, &moves);
        }
        self.road_spans.append(&mut part.road_spans);
        self.too_far.append(&mut part.too_far);
        self.connections += part.connections;
        self.joints.extend(joints::behind(take(&mut part.joints), grids));
        self.permissions.append(take(&mut part.permissions), &moves.lanes);
        self.objects.append(take(&mut part.objects), &moves);
        self.signals.append(take(&mut part.signals), &moves);
    }
}
