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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.connection.iter().all(Written::is_bare)
            && self.road_section.iter().all(Written::is_bare)
            && self.cross_path.iter().all(Written::is_bare)
            && self.priority.iter().all(Written::is_bare)
            && self.controller.iter().all(Written::is_bare)
            && self.surface.as_deref().is_none_or(Written::is_bare)
            && self.plan_view.as_deref().is_none_or(Written::is_bare)
            && self.objects.as_deref().is_none_or(Written::is_bare)
            && self.boundary.as_deref().is_none_or(Written::is_bare)
            && self.elevation_grid.as_deref().is_none_or(Written::is_bare)
            && self.main_road.is_none()
            && self.s_start.is_none()
            && self.s_end.is_none()
            && self.orientation.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.lane_link.iter().all(Written::is_bare)
            && self.predecessor.as_deref().is_none_or(Written::is_bare)
            && self.successor.as_deref().is_none_or(Written::is_bare)
            && self.connection_master.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.from_layer.is_none()
            && self.to_layer.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.element_type.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.id.is_none()
            && self.road_id.is_none()
            && self.s_start.is_none()
            && self.s_end.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.start_lane_link.as_deref().is_none_or(Written::is_bare)
            && self.end_lane_link.as_deref().is_none_or(Written::is_bare)
            && self.id.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.segment.iter().all(Written::is_bare)
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.boundary_lane.is_none()
            && self.s_start.is_none()
            && self.s_end.is_none()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.elevation.iter().all(Written::is_bare)
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.junction_reference.iter().all(Written::is_bare)
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.crg.iter().all(Written::is_bare)
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
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.file.is_none()
            && self.s_start.is_none()
            && self.s_end.is_none()
            && self.orientation.is_none()
            && self.mode.is_none()
            && self.purpose.is_none()
            && self.s_offset.is_none()
            && self.t_offset.is_none()
            && self.x_offset.is_none()
            && self.y_offset.is_none()
            && self.z_offset.is_none()
            && self.z_scale.is_none()
            && self.h_offset.is_none()
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
