//! Walks over the elements of `signals`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/signals.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Visit, Written, child, children};

impl Written for Signals {
    fn kind(&self) -> &'static str {
        "Signals"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("signal", &self.signal, visit);
        children("signalReference", &self.signal_reference, visit);
    }
}

impl Written for Signal {
    fn kind(&self) -> &'static str {
        "Signal"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
        children("dependency", &self.dependency, visit);
        children("reference", &self.reference, visit);
        child("positionInertial", &self.position_inertial, visit);
        child("positionRoad", &self.position_road, visit);
        child("semantics", &self.semantics, visit);
        children("staticBoard", &self.static_board, visit);
        children("vmsBoard", &self.vms_board, visit);
    }
}

impl Written for SignalDependency {
    fn kind(&self) -> &'static str {
        "SignalDependency"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SignalLink {
    fn kind(&self) -> &'static str {
        "SignalLink"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for PositionInertial {
    fn kind(&self) -> &'static str {
        "PositionInertial"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for PositionRoad {
    fn kind(&self) -> &'static str {
        "PositionRoad"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for StaticBoard {
    fn kind(&self) -> &'static str {
        "StaticBoard"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
        children("dependency", &self.dependency, visit);
        children("reference", &self.reference, visit);
        children("sign", &self.sign, visit);
    }
}

impl Written for BoardSign {
    fn kind(&self) -> &'static str {
        "BoardSign"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
        children("dependency", &self.dependency, visit);
        children("reference", &self.reference, visit);
        child("positionInertial", &self.position_inertial, visit);
        child("positionRoad", &self.position_road, visit);
        child("semantics", &self.semantics, visit);
        children("staticBoard", &self.static_board, visit);
        children("vmsBoard", &self.vms_board, visit);
    }
}

impl Written for VmsBoard {
    fn kind(&self) -> &'static str {
        "VmsBoard"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
        children("dependency", &self.dependency, visit);
        children("reference", &self.reference, visit);
        children("displayArea", &self.display_area, visit);
    }
}

impl Written for DisplayArea {
    fn kind(&self) -> &'static str {
        "DisplayArea"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SignalReference {
    fn kind(&self) -> &'static str {
        "SignalReference"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
    }
}

impl Written for VmsGroup {
    fn kind(&self) -> &'static str {
        "VmsGroup"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("vmsBoardReference", &self.vms_board_reference, visit);
    }
}

impl Written for VmsBoardReference {
    fn kind(&self) -> &'static str {
        "VmsBoardReference"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}
