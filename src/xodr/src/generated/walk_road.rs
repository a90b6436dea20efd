//! Walks over the elements of `road`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/road.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Road {
    fn kind(&self) -> &'static str {
        "Road"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("link", &self.link, visit);
        children("type", &self.r#type, visit);
        child("planView", &self.plan_view, visit);
        child("elevationProfile", &self.elevation_profile, visit);
        child("lateralProfile", &self.lateral_profile, visit);
        children("lanes", &self.lanes, visit);
        child("objects", &self.objects, visit);
        child("signals", &self.signals, visit);
        child("surface", &self.surface, visit);
        child("railroad", &self.railroad, visit);
    }
}

impl Written for RoadLink {
    fn kind(&self) -> &'static str {
        "RoadLink"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("predecessor", &self.predecessor, visit);
        child("successor", &self.successor, visit);
        children("neighbor", &self.neighbor, visit);
    }
}

impl Written for LinkedElement {
    fn kind(&self) -> &'static str {
        "LinkedElement"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Neighbor {
    fn kind(&self) -> &'static str {
        "Neighbor"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("side", &self.side, to);
        keep("elementId", &self.element_id, to);
        keep("direction", &self.direction, to);
    }
}

impl Written for RoadTypeRecord {
    fn kind(&self) -> &'static str {
        "RoadTypeRecord"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        child("speed", &self.speed, visit);
    }
}

impl Written for RoadSpeed {
    fn kind(&self) -> &'static str {
        "RoadSpeed"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for RoadSurface {
    fn kind(&self) -> &'static str {
        "RoadSurface"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("CRG", &self.crg, visit);
    }
}

impl Written for RoadCrg {
    fn kind(&self) -> &'static str {
        "RoadCrg"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("file", &self.file, to);
        keep("sStart", &self.s_start, to);
        keep("sEnd", &self.s_end, to);
        keep("orientation", &self.orientation, to);
        keep("mode", &self.mode, to);
        keep("purpose", &self.purpose, to);
        keep("sOffset", &self.s_offset, to);
        keep("tOffset", &self.t_offset, to);
        keep("xOffset", &self.x_offset, to);
        keep("yOffset", &self.y_offset, to);
        keep("zOffset", &self.z_offset, to);
        keep("zScale", &self.z_scale, to);
        keep("hOffset", &self.h_offset, to);
    }
}
