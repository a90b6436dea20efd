//! Signals, controllers and groups as written, until every id and lane is known.

use mapd_archive::{BoardGroupRow, ControlRow, ControllerRow, RowMappings};
use mapd_ontology::{Meaning, Ontology, SignalCode};
use mapd_xodr::Span;
use std::collections::VecDeque;
use std::sync::Arc;

/// What is known of signals until every id and lane is.
#[derive(Default)]
pub(crate) struct Signals {
    /// What signals mean.
    pub(crate) ontology: Arc<Ontology>,
    /// What codes of late mean.
    known: VecDeque<KnownCode>,
    pub(crate) signals: Vec<WrittenSignal>,
    pub(crate) references: Vec<SignalReference>,
    pub(crate) controllers: Vec<(ControllerRow, Vec<ControlRow>, Span)>,
    pub(crate) board_groups: Vec<BoardGroupRow>,
}

/// Codes that are remembered: so many as signals at a crossing have.
const CODES: usize = 16;

/// A code with its meaning.
struct KnownCode {
    texts: [Box<str>; 5],
    /// Bits of its value.
    value: Option<u64>,
    meaning: Meaning,
}

/// A signal whose row stands in the table already.
pub(crate) struct WrittenSignal {
    pub(crate) span: Span,
    /// Lanes that it is written to be for, from the lower to the higher number.
    pub(crate) validity: Box<[(i32, i32)]>,
    pub(crate) position: Position,
    pub(crate) on_carrier: OnCarrier,
}

/// Lateral and upward place on the board's carrier `[m]`. Few signals have one.
pub(crate) type OnCarrier = Option<Box<(f64, f64)>>;

/// Where a signal stands: nearly all by their s and t on the road that they are written in.
pub(crate) enum Position {
    Track,
    /// Id of the road; s, t, zOffset, hOffset.
    Road(Box<(u32, [f64; 4])>),
    /// x, y, z, hdg.
    Inertial(Box<[f64; 4]>),
}

/// A `signalReference`.
pub(crate) struct SignalReference {
    pub(crate) road: u32,
    /// The signal's id.
    pub(crate) id: u32,
    pub(crate) s: f64,
    pub(crate) t: f64,
    pub(crate) orientation: u8,
    pub(crate) validity: Box<[(i32, i32)]>,
    pub(crate) span: Span,
}

impl Signals {
    /// Nothing yet, with a vocabulary.
    pub(crate) fn new(ontology: Arc<Ontology>) -> Self {
        Self { ontology, ..Self::default() }
    }

    /// What a code means. The tables are asked entry by entry, which takes longer than all else about a signal.
    pub(crate) fn meaning(&mut self, code: &SignalCode<'_>) -> Meaning {
        let SignalCode { country, r#type, subtype, name, value, unit } = *code;
        let (texts, value) = ([r#type, subtype, name, country, unit], value.map(f64::to_bits));
        let is_it = |known: &&KnownCode| {
            known.value == value && known.texts.iter().zip(texts).all(|(own, text)| **own == *text)
        };
        if let Some(known) = self.known.iter().find(is_it) {
            return known.meaning;
        }
        let meaning = self.ontology.signal(code);
        if self.known.len() == CODES {
            self.known.pop_front();
        }
        self.known.push_back(KnownCode { texts: texts.map(Box::from), value, meaning });
        meaning
    }

    /// Number of controllers so far.
    pub(crate) fn controllers(&self) -> usize {
        self.controllers.len()
    }

    /// Takes what is written in the part of the document that comes next.
    pub(crate) fn append(&mut self, part: Self, moves: &RowMappings) {
        let signals = part.signals.into_iter().map(|written| {
            let position = match written.position {
                Position::Road(mut place) => {
                    place.0 = moves.strings.row(place.0);
                    Position::Road(place)
                }
                other => other,
            };
            WrittenSignal { position, ..written }
        });
        self.signals.extend(signals);
        self.references.extend(part.references.into_iter().map(|reference| SignalReference {
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
