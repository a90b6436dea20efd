//! Walks over the elements of `railroad`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/railroad.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Railroad {
    fn kind(&self) -> &'static str {
        "Railroad"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("switch", &self.switch, visit);
    }
}

impl Written for Switch {
    fn kind(&self) -> &'static str {
        "Switch"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("mainTrack", &self.main_track, visit);
        child("sideTrack", &self.side_track, visit);
        child("partner", &self.partner, visit);
    }
}

impl Written for MainTrack {
    fn kind(&self) -> &'static str {
        "MainTrack"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SideTrack {
    fn kind(&self) -> &'static str {
        "SideTrack"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for SwitchPartner {
    fn kind(&self) -> &'static str {
        "SwitchPartner"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("name", &self.name, to);
    }
}

impl Written for Station {
    fn kind(&self) -> &'static str {
        "Station"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("platform", &self.platform, visit);
    }
}

impl Written for Platform {
    fn kind(&self) -> &'static str {
        "Platform"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("segment", &self.segment, visit);
    }
}

impl Written for PlatformSegment {
    fn kind(&self) -> &'static str {
        "PlatformSegment"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}
