//! The layers of a map as drawings.

mod lanes;
mod things;
mod today;

pub(crate) use lanes::area;
pub(crate) use things::{level_of, object};

use crate::drawing::{Drawing, level};
use mapd_query::Bounds;
use mapd_query::glam::DVec3;
use mapd_query::view::View;
use mapd_query::{LaneSection, Map};

/// Parts that one stretch is drawn in at most: none is so long but in a damaged archive.
const MOST_PARTS: usize = 1 << 14;

/// Parts of equal length that a stretch is drawn in, none longer than a step unless there were too many.
fn parts(length: f64, step: f64) -> usize {
    // Casts saturate.
    ((length / step).ceil() as usize).clamp(1, MOST_PARTS)
}

/// What can be shown and hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Layer {
    /// Areas of lanes, by type.
    Lanes,
    /// Borders of lanes.
    Borders,
    /// Reference lines.
    ReferenceLines,
    /// Road marks.
    Marks,
    /// Where traffic goes.
    Directions,
    /// Crosswalks.
    Crosswalks,
    /// Lines at which traffic stops or gives way.
    StopLines,
    /// Objects that are no crosswalks.
    Objects,
    /// Signals: one stroke each, from where it stands to where it faces; its paint is the number of a [`SignalSign`].
    ///
    /// [`SignalSign`]: crate::SignalSign
    Signals,
    /// Stretches on which lanes meet others.
    Conflicts,
    /// Boxes of the spatial index.
    IndexBoxes,
    /// What is left out.
    Quarantine,
    /// What an overlay says now: closed, opened, slower, told.
    Today,
}

impl Layer {
    /// All, by number.
    pub const ALL: &[Self] = &[
        Self::Lanes,
        Self::Borders,
        Self::ReferenceLines,
        Self::Marks,
        Self::Directions,
        Self::Crosswalks,
        Self::StopLines,
        Self::Objects,
        Self::Signals,
        Self::Conflicts,
        Self::IndexBoxes,
        Self::Quarantine,
        Self::Today,
    ];

    /// The layer of a map, with what is laid over it.
    pub fn draw(self, view: View<'_>) -> Drawing {
        let map = view.map();
        let mut drawing = Drawing::new(middle(map));
        match self {
            Self::Lanes => lanes::areas(map, &mut drawing),
            Self::Borders => lanes::borders(map, &mut drawing),
            Self::ReferenceLines => lanes::reference_lines(map, &mut drawing),
            Self::Marks => lanes::marks(map, &mut drawing),
            Self::Directions => lanes::directions(map, &mut drawing),
            Self::Crosswalks => things::crosswalks(map, &mut drawing),
            Self::StopLines => things::stop_lines(map, &mut drawing),
            Self::Objects => things::objects(map, &mut drawing),
            Self::Signals => things::signals(map, &mut drawing),
            Self::Conflicts => things::conflicts(map, &mut drawing),
            Self::IndexBoxes => things::index_boxes(map, &mut drawing),
            Self::Quarantine => things::quarantine(map, &mut drawing),
            Self::Today => today::stretches(view, &mut drawing),
        }
        drawing.finish();
        drawing
    }
}

/// What drawings are relative to: the middle of the map in plan view, at its lowest height.
pub(crate) fn middle(map: Map<'_>) -> DVec3 {
    let Bounds { low, high } = map.bounds();
    (0.5 * (low + high)).truncate().extend(low.z)
}

/// The sections of a map, square by square, each with its level.
fn sections(map: Map<'_>) -> Vec<(i64, LaneSection<'_>)> {
    let tile = |place: DVec3| {
        let tile = (place.truncate() / crate::drawing::TILE).floor();
        (tile.y as i64, tile.x as i64)
    };
    let mut sections: Vec<_> = map
        .roads()
        .flat_map(|road| road.sections())
        .map(|section| {
            let place = place(&section);
            (tile(place), level(place.z - middle(map).z), section)
        })
        .collect();
    sections.sort_by_key(|(tile, level, _)| (*tile, *level));
    sections.into_iter().map(|(_, level, section)| (level, section)).collect()
}

/// A place in the middle of a section.
pub(crate) fn place(section: &LaneSection<'_>) -> DVec3 {
    let line = section.lane(0).map(|center| center.border());
    line.and_then(|line| line.position(line.len() / 2)).unwrap_or_default()
}
