//! Walks over the elements of `controller`.
// Written by `cargo run -p mapd-schemas` from schemas/opendrive/controller.toml; change that file instead.

use super::*;
use crate::extension::Extensions;
use crate::finding::Span;
use crate::written::{Visit, Written, children};

impl Written for Controller {
    fn kind(&self) -> &'static str {
        "Controller"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
    fn children(&self, visit: Visit<'_>) {
        children("control", &self.control, visit);
    }
}

impl Written for Control {
    fn kind(&self) -> &'static str {
        "Control"
    }
    fn span(&self) -> Span {
        self.span
    }
    fn extensions(&self) -> &Extensions {
        &self.extensions
    }
}
