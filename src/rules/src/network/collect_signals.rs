//! What is kept of signals: their ids, those of signs on their boards, and what both refer to.

use super::facts::PartKind;
use super::references::{Kinds, NamedAt};
use super::{Name, Network};
use crate::place::value;
use mapd_xodr::{
    BoardSign, ReferenceElementType, SignalDependency, SignalLink, Signals, StaticBoard, VmsBoard,
};

/// Boards on boards that are followed at most.
const DEEPEST_BOARD: usize = 8;

/// Where dependencies and references stand.
type Places = [NamedAt; 2];

const OF_SIGNAL: Places = [NamedAt::SignalDependency, NamedAt::SignalLink];
const OF_STATIC: Places = [NamedAt::StaticDependency, NamedAt::StaticLink];
const OF_SIGN: Places = [NamedAt::SignDependency, NamedAt::SignLink];
const OF_VMS: Places = [NamedAt::VmsDependency, NamedAt::VmsLink];

impl Network {
    pub(super) fn add_signals(&mut self, signals: &Signals, from: Name, road: u32) {
        for signal in &signals.signal {
            let id = self.part(PartKind::Signal, &signal.id, signal.span, Some(road));
            self.add_links(OF_SIGNAL, &signal.dependency, &signal.reference, id);
            self.add_boards(&signal.static_board, &signal.vms_board, id, DEEPEST_BOARD);
            if let Some(position) = &signal.position_road {
                let at = NamedAt::PositionRoad.of(Kinds::Road);
                self.refer(at, &position.road_id, id, position.span);
            }
        }
        for reference in &signals.signal_reference {
            let at = NamedAt::SignalReference.of(Kinds::Signals);
            self.refer(at, &reference.id, from, reference.span);
        }
    }

    fn add_links(
        &mut self,
        [dependency_at, reference_at]: Places,
        dependencies: &[SignalDependency],
        references: &[SignalLink],
        from: Name,
    ) {
        for dependency in dependencies {
            let at = dependency_at.of(Kinds::Signals);
            self.refer(at, &dependency.id, from, dependency.span);
        }
        for reference in references {
            let kinds = match value(&reference.element_type) {
                Some(ReferenceElementType::Signal) => Kinds::Signals,
                Some(ReferenceElementType::Object) => Kinds::Object,
                _ => Kinds::SignalsAndObjects,
            };
            self.refer(reference_at.of(kinds), &reference.element_id, from, reference.span);
        }
    }

    /// Boards of a signal, and those of the signs on them, which name the signal as where they stand.
    fn add_boards(
        &mut self,
        static_boards: &[StaticBoard],
        vms_boards: &[VmsBoard],
        from: Name,
        deep: usize,
    ) {
        for board in vms_boards {
            self.add_links(OF_VMS, &board.dependency, &board.reference, from);
        }
        for board in static_boards {
            self.add_links(OF_STATIC, &board.dependency, &board.reference, from);
        }
        let Some(deeper) = deep.checked_sub(1) else { return };
        for sign in static_boards.iter().flat_map(|board| &board.sign) {
            let sign: &BoardSign = sign;
            self.part(PartKind::Sign, &sign.id, sign.span, None);
            self.add_links(OF_SIGN, &sign.dependency, &sign.reference, from);
            self.add_boards(&sign.static_board, &sign.vms_board, from, deeper);
        }
    }
}
