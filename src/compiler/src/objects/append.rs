//! Appends the objects of a part of a map to those of the whole.

use super::written::{Details, Objects};
use mapd_archive::Moves;

impl Objects {
    /// Takes what is written in the part of the document that comes next.
    pub(crate) fn append(&mut self, part: Self, moves: &Moves) {
        self.objects.extend(part.objects.into_iter().map(|mut object| {
            object.row.move_by(moves);
            object.outlines.iter_mut().for_each(|outline| outline.row.move_by(moves));
            if let Some(details) = &mut object.details {
                details.move_by(moves);
            }
            object
        }));
        let lines = part.junction_lines.into_iter();
        let lines = lines
            .map(|(junction, line)| (moves.junctions.row(junction), moves.geometries.range(line)));
        self.junction_lines.extend(lines);
        self.references.extend(part.references.into_iter().map(|mut reference| {
            reference.row.move_by(moves);
            reference
        }));
        self.structures.extend(part.structures.into_iter().map(|mut structure| {
            structure.row.move_by(moves);
            structure
        }));
        self.switches.extend(part.switches.into_iter().map(|mut switch| {
            switch.row.move_by(moves);
            switch
        }));
        self.stations.extend(part.stations.into_iter().map(|mut station| {
            station.row.move_by(moves);
            for platform in &mut station.platforms {
                platform.row.move_by(moves);
                platform.segments.iter_mut().for_each(|(_, segment)| segment.move_by(moves));
            }
            station
        }));
    }
}

impl Details {
    fn move_by(&mut self, moves: &Moves) {
        self.markings.iter_mut().for_each(|marking| marking.row.move_by(moves));
        self.borders.iter_mut().for_each(|border| border.row.move_by(moves));
        self.materials.iter_mut().for_each(|row| row.move_by(moves));
        if let Some(row) = &mut self.parking {
            row.move_by(moves);
        }
        if let Some(row) = &mut self.value {
            row.move_by(moves);
        }
    }
}
