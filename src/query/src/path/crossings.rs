//! Crosswalks and bicycle crossings over a path.

use super::Path;
use super::conflicts::Yields;
use super::settle::is_lit;
use crate::extents::SRange;
use crate::lane::Lane;
use crate::rules::{LaneLine, LineSource};
use crate::view::View;
use mapd_archive::Class;

/// A line to stop at, or a light, is for a crossing up to so far behind it `[m]`.
const REACH: f64 = 30.0;

/// A crosswalk or bicycle crossing over a path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathCrossing {
    /// S of its first and last place `[m]`; twice the same where the file gives a place alone.
    pub along: [f64; 2],
    /// The crossing, on the driven lane.
    pub line: LaneLine,
    /// [`Yields::Lights`] where a light for vehicles stands on the path up to 30 m before it, else [`Yields::Unknown`]: a rule of the road decides, nearly everywhere
    /// in favour of who crosses.
    pub yields: Yields,
    /// S at which to wait `[m]`: the last line to stop at on the path, up to 30 m before, else where it begins.
    pub wait: f64,
}

impl<'a> Path<'a, '_> {
    /// Crosswalks and bicycle crossings over the path, in ascending S, whether the file writes them as signals or as objects. `out` is emptied
    /// first; it grows only if its capacity is too small.
    pub fn crossings(&self, out: &mut Vec<PathCrossing>) {
        self.crossings_in(None, out);
    }

    /// As [`Path::crossings`], with the lights that work in a view.
    pub(crate) fn crossings_in(&self, view: Option<View<'a>>, out: &mut Vec<PathCrossing>) {
        out.clear();
        for piece in &self.buffer.pieces {
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            for line in lane.all_lines(piece.forward) {
                if !matches!(line.class, Class::Crosswalk | Class::BicycleCrossing) {
                    continue;
                }
                let range = match line.source {
                    LineSource::Object(id) => lane
                        .objects()
                        .find(|one| one.object().is_some_and(|object| object.object_id() == id))
                        .map(|one| one.s_range()),
                    LineSource::Signal(_) => None,
                };
                let point = self.along_on(piece, line.s).map(|along| [along; 2]);
                let whole = range.and_then(|SRange { low, high }| self.overlap(piece, [low, high]));
                let Some(along) = whole.or(point) else { continue };
                let wait = along[0];
                out.push(PathCrossing { along, line, yields: Yields::Unknown, wait });
            }
        }
        out.sort_unstable_by(|a, b| {
            a.along[0].total_cmp(&b.along[0]).then(a.line.source.cmp(&b.line.source))
        });
        // One over both lanes of a change counts once.
        out.dedup_by(|next, before| {
            let same = next.line.source == before.line.source && next.along[0] <= before.along[1];
            if same {
                before.along[1] = before.along[1].max(next.along[1]);
            }
            same
        });
        for piece in &self.buffer.pieces {
            let Some(lane) = Lane::new(self.map, piece.lane) else { continue };
            for line in lane.all_lines(piece.forward) {
                let Some(along) = self.along_on(piece, line.s) else { continue };
                if matches!(line.class, Class::StopLine | Class::WaitingLine) {
                    for own in behind(out, along) {
                        own.wait =
                            if own.wait < own.along[0] { own.wait.max(along) } else { along };
                    }
                }
            }
            for light in lane.signals().filter(|one| one.is_for(piece.forward)) {
                let along = self.along_on(piece, light.s_on(&lane));
                if let Some(along) = along.filter(|_| is_lit(&light, view)) {
                    behind(out, along).for_each(|own| own.yields = Yields::Lights);
                }
            }
        }
    }
}

/// The crossings that begin up to 30 m behind a place.
fn behind(all: &mut [PathCrossing], along: f64) -> impl Iterator<Item = &mut PathCrossing> {
    all.iter_mut().filter(move |own| own.along[0] >= along && own.along[0] - along <= REACH)
}
