//! How a fact is written: one line for each part of a map, `what id name=value name=value`.

use mapd_client::glam::{DVec2, DVec3};
use mapd_query::roads::LaneRange;
use mapd_query::{Clamped, SRange};
use std::fmt::{Display, Write as _};

/// A text that grows by lines.
#[derive(Default)]
pub(in crate::releases) struct Lines(String);

/// A line that is being written; it ends with its last fact.
pub(in crate::releases) struct Line<'l>(&'l mut String);

impl Lines {
    /// Begins a line about something.
    pub(in crate::releases) fn about(&mut self, what: impl Display) -> Line<'_> {
        if !self.0.is_empty() {
            self.0.push('\n');
        }
        // Writing to a string never fails.
        let _ = write!(self.0, "{what}");
        Line(&mut self.0)
    }

    pub(in crate::releases) fn into_text(mut self) -> String {
        self.0.push('\n');
        self.0
    }
}

impl Line<'_> {
    /// One more fact.
    pub(in crate::releases) fn with(self, name: &str, value: impl Fact) -> Self {
        let _ = write!(self.0, " {name}=");
        value.write(self.0);
        self
    }

    /// One more word of a list that is the same in every release.
    pub(in crate::releases) fn word(self, name: &str, value: impl Display) -> Self {
        let _ = write!(self.0, " {name}={value}");
        self
    }
}

/// What can be the value of a fact.
pub(in crate::releases) trait Fact {
    /// Appends it. Lengths to the millimetre: the finest that is the same for ever.
    fn write(&self, out: &mut String);
}

/// An angle \[rad\], a curvature or a slope: to a millionth.
pub(in crate::releases) struct Fine(pub(in crate::releases) f64);

/// A number with so many digits; −0 is 0.
fn number(out: &mut String, value: f64, digits: usize) {
    let start = out.len();
    let _ = write!(out, "{value:.digits$}");
    let written = out.get(start..).unwrap_or_default();
    if written.starts_with('-') && written.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.')) {
        out.remove(start);
    }
}

impl Fact for f64 {
    fn write(&self, out: &mut String) {
        number(out, *self, 3);
    }
}

impl Fact for Fine {
    fn write(&self, out: &mut String) {
        number(out, self.0, 6);
    }
}

impl Fact for DVec2 {
    fn write(&self, out: &mut String) {
        self.to_array().write(out);
    }
}

impl Fact for DVec3 {
    fn write(&self, out: &mut String) {
        self.to_array().write(out);
    }
}

impl Fact for SRange {
    fn write(&self, out: &mut String) {
        [self.low, self.high].write(out);
    }
}

impl Fact for LaneRange {
    fn write(&self, out: &mut String) {
        let _ = write!(out, "{}..{}", self.from, self.to);
    }
}

impl Fact for Clamped {
    fn write(&self, out: &mut String) {
        out.push_str(self.name());
    }
}

impl Fact for str {
    fn write(&self, out: &mut String) {
        let _ = write!(out, "{self:?}");
    }
}

impl Fact for String {
    fn write(&self, out: &mut String) {
        self.as_str().write(out);
    }
}

impl<F: Fact + ?Sized> Fact for &F {
    fn write(&self, out: &mut String) {
        (**self).write(out);
    }
}

impl<F: Fact> Fact for Option<F> {
    fn write(&self, out: &mut String) {
        match self {
            Some(value) => value.write(out),
            None => out.push('-'),
        }
    }
}

impl<F: Fact> Fact for [F] {
    fn write(&self, out: &mut String) {
        out.push('[');
        for (i, value) in self.iter().enumerate() {
            if i > 0 {
                out.push(' ');
            }
            value.write(out);
        }
        out.push(']');
    }
}

impl<F: Fact, const N: usize> Fact for [F; N] {
    fn write(&self, out: &mut String) {
        self.as_slice().write(out);
    }
}

impl<F: Fact> Fact for Vec<F> {
    fn write(&self, out: &mut String) {
        self.as_slice().write(out);
    }
}

macro_rules! plain {
    ($($kind:ty)*) => {
        $(impl Fact for $kind {
            fn write(&self, out: &mut String) {
                let _ = write!(out, "{self}");
            }
        })*
    };
}

plain!(bool u8 u16 u32 i32 usize);
