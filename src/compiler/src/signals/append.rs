//! Appends the signals of a part of a map to those of the whole.

use super::{Pending, Position, Reference, Written};
use mapd_archive::Moves;

impl Pending {
    /// Takes what is written in the part of the document that comes next.
    pub(crate) fn append(&mut self, part: Self, moves: &Moves) {
        let signals = part.signals.into_iter().map(|written| {
            let position = match written.position {
                Position::Road(mut place) => {
                    place.0 = moves.strings.row(place.0);
                    Position::Road(place)
                }
                other => other,
            };
            Written { position, ..written }
        });
        self.signals.extend(signals);
        self.references.extend(part.references.into_iter().map(|reference| Reference {
            road: moves.roads.row(reference.road),
            id: moves.strings.row(reference.id),
            ..reference
        }));
        self.controllers.extend(part.controllers.into_iter().map(
            |(mut row, mut controls, span)| {
                row.move_by(moves);
                controls.iter_mut().for_each(|control| control.move_by(moves));
                (row, controls, span)
            },
        ));
        self.board_groups.extend(part.board_groups.into_iter().map(|mut row| {
            row.move_by(moves);
            row
        }));
    }
}
