//! What all records of cubics along a road have in common.

use crate::attribute::Value as _;
use crate::finding::Span;
use crate::generated::{Crossfall, Elevation, LaneBorder, LaneOffset, LaneWidth, Superelevation};

/// A record a + b·ds + c·ds² + d·ds³ that holds from its place on until the next one's. (OpenDRIVE 1.8.1, 7.4)
pub trait CubicRecord {
    /// Name of the attribute that says where it begins: `s` or `sOffset`.
    const START: &'static str;

    /// Where it begins `[m]`: along the reference line, or from the start of the lane section.
    fn start(&self) -> Option<f64>;

    /// a, b, c, d; each none where it is absent or cannot be read.
    fn coefficients(&self) -> [Option<f64>; 4];

    /// The start tag.
    fn span(&self) -> Span;
}

macro_rules! records {
    ($($name:ident: $start:ident = $text:literal,)*) => {$(
        impl CubicRecord for $name {
            const START: &'static str = $text;

            fn start(&self) -> Option<f64> {
                self.$start.value()
            }

            fn coefficients(&self) -> [Option<f64>; 4] {
                [self.a.value(), self.b.value(), self.c.value(), self.d.value()]
            }

            fn span(&self) -> Span {
                self.span
            }
        }
    )*};
}

records! {
    Elevation: s = "s",
    Superelevation: s = "s",
    Crossfall: s = "s",
    LaneOffset: s = "s",
    LaneWidth: s_offset = "sOffset",
    LaneBorder: s_offset = "sOffset",
}
