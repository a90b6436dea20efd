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
    fn children(&self, visit: Visit<'_>) {
        children("validity", &self.validity, visit);
    }
}
