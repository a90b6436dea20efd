//! Walks over the elements of `objects`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/objects.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Keep, Visit, Written, child, children, keep};

impl Written for Objects {
    fn kind(&self) -> &'static str {
        "Objects"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.object.iter().all(Written::is_bare)
            && self.object_reference.iter().all(Written::is_bare)
            && self.tunnel.iter().all(Written::is_bare)
            && self.bridge.iter().all(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("object", &self.object, visit);
        children("objectReference", &self.object_reference, visit);
        children("tunnel", &self.tunnel, visit);
        children("bridge", &self.bridge, visit);
    }
}

impl Written for Object {
    fn kind(&self) -> &'static str {
        "Object"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty()
            && self.repeat.iter().all(Written::is_bare)
            && self.outline.as_deref().is_none_or(Written::is_bare)
            && self.outlines.as_deref().is_none_or(Written::is_bare)
            && self.material.iter().all(Written::is_bare)
            && self.validity.iter().all(Written::is_bare)
            && self.parking_space.as_deref().is_none_or(Written::is_bare)
            && self.markings.as_deref().is_none_or(Written::is_bare)
            && self.borders.as_deref().is_none_or(Written::is_bare)
            && self.surface.as_deref().is_none_or(Written::is_bare)
            && self.skeleton.as_deref().is_none_or(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("repeat", &self.repeat, visit);
        child("outline", &self.outline, visit);
        child("outlines", &self.outlines, visit);
        children("material", &self.material, visit);
        children("validity", &self.validity, visit);
        child("parkingSpace", &self.parking_space, visit);
        child("markings", &self.markings, visit);
        child("borders", &self.borders, visit);
        child("surface", &self.surface, visit);
        child("skeleton", &self.skeleton, visit);
    }
}

impl Written for ObjectRepeat {
    fn kind(&self) -> &'static str {
        "ObjectRepeat"
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

impl Written for ObjectMaterial {
    fn kind(&self) -> &'static str {
        "ObjectMaterial"
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

impl Written for LaneValidity {
    fn kind(&self) -> &'static str {
        "LaneValidity"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.layer.is_none()
    }
    fn kept(&self, to: Keep<'_>) {
        keep("layer", &self.layer, to);
    }
}

impl Written for ParkingSpace {
    fn kind(&self) -> &'static str {
        "ParkingSpace"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.marking.iter().all(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("marking", &self.marking, visit);
    }
}

impl Written for ParkingSpaceMarking {
    fn kind(&self) -> &'static str {
        "ParkingSpaceMarking"
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

impl Written for ObjectSurface {
    fn kind(&self) -> &'static str {
        "ObjectSurface"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.crg.as_deref().is_none_or(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        child("CRG", &self.crg, visit);
    }
}

impl Written for ObjectCrg {
    fn kind(&self) -> &'static str {
        "ObjectCrg"
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
            && self.hide_road_surface_crg.is_none()
            && self.z_scale.is_none()
    }
    fn kept(&self, to: Keep<'_>) {
        keep("file", &self.file, to);
        keep("hideRoadSurfaceCRG", &self.hide_road_surface_crg, to);
        keep("zScale", &self.z_scale, to);
    }
}

impl Written for ObjectReference {
    fn kind(&self) -> &'static str {
        "ObjectReference"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.validity.iter().all(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
    }
}

impl Written for Tunnel {
    fn kind(&self) -> &'static str {
        "Tunnel"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.validity.iter().all(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
    }
}

impl Written for Bridge {
    fn kind(&self) -> &'static str {
        "Bridge"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn is_bare(&self) -> bool {
        self.extensions.as_slice().is_empty() && self.validity.iter().all(Written::is_bare)
    }
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
    }
}
