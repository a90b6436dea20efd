//! Walks over the elements of `junction`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/junction.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Junction {
    fn kind(&self) -> &'static str {
        "Junction"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("mainRoad", &self.main_road, to);
        keep("sStart", &self.s_start, to);
        keep("sEnd", &self.s_end, to);
        keep("orientation", &self.orientation, to);
    }
    fn children(&self, visit: Visit<'_>) {
        children("connection", &self.connection, visit);
        children("roadSection", &self.road_section, visit);
        children("crossPath", &self.cross_path, visit);
        children("priority", &self.priority, visit);
        children("controller", &self.controller, visit);
        child("surface", &self.surface, visit);
        child("planView", &self.plan_view, visit);
        child("objects", &self.objects, visit);
        child("boundary", &self.boundary, visit);
        child("elevationGrid", &self.elevation_grid, visit);
    }
}

impl Written for Connection {
    fn kind(&self) -> &'static str {
        "Connection"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("connectionMaster", &self.connection_master, to);
    }
    fn children(&self, visit: Visit<'_>) {
        children("laneLink", &self.lane_link, visit);
        child("predecessor", &self.predecessor, visit);
        child("successor", &self.successor, visit);
    }
}

impl Written for JunctionLaneLink {
    fn kind(&self) -> &'static str {
        "JunctionLaneLink"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("fromLayer", &self.from_layer, to);
        keep("toLayer", &self.to_layer, to);
    }
}

impl Written for ConnectionEnd {
    fn kind(&self) -> &'static str {
        "ConnectionEnd"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("elementType", &self.element_type, to);
    }
}

impl Written for RoadSection {
    fn kind(&self) -> &'static str {
        "RoadSection"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("id", &self.id, to);
        keep("roadId", &self.road_id, to);
        keep("sStart", &self.s_start, to);
        keep("sEnd", &self.s_end, to);
    }
}

impl Written for CrossPath {
    fn kind(&self) -> &'static str {
        "CrossPath"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("id", &self.id, to);
    }
    fn children(&self, visit: Visit<'_>) {
        child("startLaneLink", &self.start_lane_link, visit);
        child("endLaneLink", &self.end_lane_link, visit);
    }
}

impl Written for CrossPathLaneLink {
    fn kind(&self) -> &'static str {
        "CrossPathLaneLink"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Priority {
    fn kind(&self) -> &'static str {
        "Priority"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for JunctionController {
    fn kind(&self) -> &'static str {
        "JunctionController"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for Boundary {
    fn kind(&self) -> &'static str {
        "Boundary"
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

impl Written for BoundarySegment {
    fn kind(&self) -> &'static str {
        "BoundarySegment"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn kept(&self, to: Keep<'_>) {
        keep("boundaryLane", &self.boundary_lane, to);
        keep("sStart", &self.s_start, to);
        keep("sEnd", &self.s_end, to);
    }
}

impl Written for ElevationGrid {
    fn kind(&self) -> &'static str {
        "ElevationGrid"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("elevation", &self.elevation, visit);
    }
}

impl Written for GridElevation {
    fn kind(&self) -> &'static str {
        "GridElevation"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for JunctionGroup {
    fn kind(&self) -> &'static str {
        "JunctionGroup"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("junctionReference", &self.junction_reference, visit);
    }
}

impl Written for JunctionReference {
    fn kind(&self) -> &'static str {
        "JunctionReference"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}

impl Written for JunctionSurface {
    fn kind(&self) -> &'static str {
        "JunctionSurface"
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

impl Written for JunctionCrg {
    fn kind(&self) -> &'static str {
        "JunctionCrg"
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
