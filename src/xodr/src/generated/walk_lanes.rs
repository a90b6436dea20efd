//! Walks over the elements of `lanes`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/lanes.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Lanes {
    fn kind(&self) -> &'static str {
        "Lanes"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("laneOffset", &self.lane_offset, visit);
        children("laneSection", &self.lane_section, visit);
    }
}

impl Written for LaneOffset {
    fn kind(&self) -> &'static str {
        "LaneOffset"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneSection {
    fn kind(&self) -> &'static str {
        "LaneSection"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("length", &self.length, to);
    }
    fn children(&self, visit: Visit<'_>) {
        child("left", &self.left, visit);
        child("center", &self.center, visit);
        child("right", &self.right, visit);
    }
}

impl Written for LaneSectionSide {
    fn kind(&self) -> &'static str {
        "LaneSectionSide"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("lane", &self.lane, visit);
    }
}

impl Written for Lane {
    fn kind(&self) -> &'static str {
        "Lane"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("advisory", &self.advisory, to);
        keep("dynamicLaneType", &self.dynamic_lane_type, to);
        keep("dynamicLaneDirection", &self.dynamic_lane_direction, to);
        keep("roadWorks", &self.road_works, to);
    }
    fn children(&self, visit: Visit<'_>) {
        child("link", &self.link, visit);
        children("border", &self.border, visit);
        children("width", &self.width, visit);
        children("roadMark", &self.road_mark, visit);
        children("material", &self.material, visit);
        children("visibility", &self.visibility, visit);
        children("speed", &self.speed, visit);
        children("access", &self.access, visit);
        children("height", &self.height, visit);
        children("rule", &self.rule, visit);
    }
}

impl Written for LaneLink {
    fn kind(&self) -> &'static str {
        "LaneLink"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("predecessor", &self.predecessor, visit);
        children("successor", &self.successor, visit);
    }
}

impl Written for LinkedLane {
    fn kind(&self) -> &'static str {
        "LinkedLane"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("layer", &self.layer, to);
    }
}

impl Written for LaneBorder {
    fn kind(&self) -> &'static str {
        "LaneBorder"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneWidth {
    fn kind(&self) -> &'static str {
        "LaneWidth"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneMaterial {
    fn kind(&self) -> &'static str {
        "LaneMaterial"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneSpeed {
    fn kind(&self) -> &'static str {
        "LaneSpeed"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneVisibility {
    fn kind(&self) -> &'static str {
        "LaneVisibility"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneAccess {
    fn kind(&self) -> &'static str {
        "LaneAccess"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("restriction", &self.restriction_element, visit);
    }
}

impl Written for AccessRestriction {
    fn kind(&self) -> &'static str {
        "AccessRestriction"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneHeight {
    fn kind(&self) -> &'static str {
        "LaneHeight"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneRule {
    fn kind(&self) -> &'static str {
        "LaneRule"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for LaneSectionCenter {
    fn kind(&self) -> &'static str {
        "LaneSectionCenter"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("lane", &self.lane, visit);
    }
}

impl Written for CenterLane {
    fn kind(&self) -> &'static str {
        "CenterLane"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("link", &self.link, visit);
        children("border", &self.border, visit);
        children("width", &self.width, visit);
        children("roadMark", &self.road_mark, visit);
        children("material", &self.material, visit);
        children("speed", &self.speed, visit);
        children("access", &self.access, visit);
        children("height", &self.height, visit);
        children("rule", &self.rule, visit);
    }
}
