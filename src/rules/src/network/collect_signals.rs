//! What is kept of signals: their ids, those of signs on their boards, and what both refer to.

use super::Network;
use super::collect::Text;
use super::facts::PartKind;
use crate::place::value;
use mapd_xodr::{
    BoardSign, ReferenceElementType, SignalDependency, SignalLink, Signals, StaticBoard, VmsBoard,
};

/// What a reference to a signal may name.
const SIGNALS: &[PartKind] = &[PartKind::Signal, PartKind::Sign];
/// Boards on boards that are followed at most.
const DEEPEST_BOARD: usize = 8;

/// Names of a dependency and of a reference for where they stand.
type Names = [&'static str; 2];

const OF_SIGNAL: Names = ["signal/dependency/@id", "signal/reference/@elementId"];
const OF_STATIC: Names =
    ["signal/staticBoard/dependency/@id", "signal/staticBoard/reference/@elementId"];
const OF_SIGN: Names =
    ["signal/staticBoard/sign/dependency/@id", "signal/staticBoard/sign/reference/@elementId"];
const OF_VMS: Names = ["signal/vmsBoard/dependency/@id", "signal/vmsBoard/reference/@elementId"];

impl Network {
    pub(super) fn add_signals(&mut self, signals: &Signals, from: &Text, road: usize) {
        for signal in &signals.signal {
            self.part(PartKind::Signal, &signal.id, signal.span, Some(road));
            self.add_links(OF_SIGNAL, (&signal.dependency, &signal.reference), &signal.id);
            self.add_boards((&signal.static_board, &signal.vms_board), &signal.id, DEEPEST_BOARD);
            if let Some(position) = &signal.position_road {
                self.refer(
                    &[PartKind::Road],
                    &position.road_id,
                    "signal/positionRoad/@roadId",
                    ("signal", &signal.id),
                    position.span,
                );
            }
        }
        for reference in &signals.signal_reference {
            self.refer(
                SIGNALS,
                &reference.id,
                "signals/signalReference/@id",
                ("road", from),
                reference.span,
            );
        }
    }

    fn add_links(
        &mut self,
        [dependency_name, reference_name]: Names,
        (dependencies, references): (&[SignalDependency], &[SignalLink]),
        from: &Text,
    ) {
        for dependency in dependencies {
            let from = ("signal", from);
            self.refer(SIGNALS, &dependency.id, dependency_name, from, dependency.span);
        }
        for reference in references {
            let kinds = match value(&reference.element_type) {
                Some(ReferenceElementType::Signal) => SIGNALS,
                Some(ReferenceElementType::Object) => &[PartKind::Object],
                _ => &[PartKind::Signal, PartKind::Sign, PartKind::Object],
            };
            let from = ("signal", from);
            self.refer(kinds, &reference.element_id, reference_name, from, reference.span);
        }
    }

    /// Boards of a signal, and those of the signs on them, which name the signal as where they stand.
    fn add_boards(
        &mut self,
        (static_boards, vms_boards): (&[StaticBoard], &[VmsBoard]),
        from: &Text,
        deep: usize,
    ) {
        for board in vms_boards {
            self.add_links(OF_VMS, (&board.dependency, &board.reference), from);
        }
        for board in static_boards {
            self.add_links(OF_STATIC, (&board.dependency, &board.reference), from);
        }
        let Some(deeper) = deep.checked_sub(1) else { return };
        for sign in static_boards.iter().flat_map(|board| &board.sign) {
            let sign: &BoardSign = sign;
            self.part(PartKind::Sign, &sign.id, sign.span, None);
            self.add_links(OF_SIGN, (&sign.dependency, &sign.reference), from);
            self.add_boards((&sign.static_board, &sign.vms_board), from, deeper);
        }
    }
}
