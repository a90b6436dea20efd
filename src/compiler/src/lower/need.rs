//! What rows are built from: it is there, or a finding says that the map cannot be built without it.

use mapd_rules::Rule;
use mapd_rules::catalog::building;
use mapd_xodr::{Finding, Severity, Span};

/// Largest number that a lane may have, to either side: more lanes than a section can have points, and small enough that numbers
/// can be subtracted from each other.
pub(crate) const MOST_LANES: i32 = 65_535;

/// Largest distance along a road or beside it, and length of one `[m]`: up to here doubles tell micrometres apart, and single precision, in which
/// places on a section are stored, holds them.
pub(crate) const FARTHEST: f64 = 1e9;

/// Largest coefficient of a polynomial, to either side: its values and slopes over [`FARTHEST`] stay numbers.
pub(crate) const MOST_COEFFICIENT: f64 = 1e12;

/// Path of an element that rows are built from.
#[derive(Clone, Copy)]
pub(crate) struct ElementPath<'a> {
    /// Path of the road or junction, or of what else it belongs to.
    pub(crate) owner: &'a str,
    /// From there to the element; empty for the owner itself.
    pub(crate) inside: &'a str,
}

impl<'a> ElementPath<'a> {
    /// The path of an element inside of an owner.
    pub(crate) fn new(owner: &'a str, inside: &'a str) -> Self {
        Self { owner, inside }
    }

    /// The path of the owner itself.
    pub(crate) fn of_owner(owner: &'a str) -> Self {
        Self { owner, inside: "" }
    }
}

/// An element that rows are built from, and where findings about it go.
pub(crate) struct ElementContext<'a> {
    /// The element's start tag.
    pub(crate) span: Span,
    pub(crate) path: ElementPath<'a>,
    pub(crate) findings: &'a mut Vec<Finding>,
}

impl ElementContext<'_> {
    /// The value of an attribute without which nothing can be built.
    pub(crate) fn need<T>(&mut self, value: Option<T>, name: &str) -> Option<T> {
        if value.is_none() {
            let message = format!("expected @{name}, found none that can be used");
            self.unusable(name, message);
        }
        value
    }

    /// As [`ElementContext::need`], for a distance along or beside the road, or a length `[m]`: within [`FARTHEST`].
    pub(crate) fn need_along(&mut self, value: Option<f64>, name: &str) -> Option<f64> {
        let value = self.need(value, name)?;
        if value.abs() <= FARTHEST {
            return Some(value);
        }
        let message = format!("expected @{name} from -{FARTHEST} to {FARTHEST} m, found {value}");
        self.unusable(name, message);
        None
    }

    /// As [`ElementContext::need`], for the number of a lane: within [`MOST_LANES`].
    pub(crate) fn need_lane(&mut self, value: Option<i32>, name: &str) -> Option<i32> {
        let value = self.need(value, name)?;
        if value.unsigned_abs() <= MOST_LANES.unsigned_abs() {
            return Some(value);
        }
        let message = format!("expected @{name} from -{MOST_LANES} to {MOST_LANES}, found {value}");
        self.unusable(name, message);
        None
    }

    /// What is wrong with a place in the plane `[m]`; none within [`FARTHEST`]. The local origin lies amid all places: one far away
    /// would take the digits of all others.
    pub(super) fn too_far(&self, [x, y]: [f64; 2]) -> Option<Finding> {
        let is_near = x.abs() <= FARTHEST && y.abs() <= FARTHEST;
        let message =
            || format!("expected @x and @y from -{FARTHEST} to {FARTHEST} m, found {x} and {y}");
        (!is_near).then(|| self.finding(&building::UNUSABLE, Severity::Error, message()))
    }

    /// Adds the finding that something cannot be used: an attribute or child by its name, or with no name the element. Where the
    /// reader or a rule has a finding about the same, that one stands for this one; see `Collector`.
    pub(crate) fn unusable(&mut self, subject: &str, message: String) {
        let finding = self.finding(&building::UNUSABLE, Severity::Error, message);
        self.findings.push(Finding { subject: subject.into(), ..finding });
    }

    /// Adds a warning about an attribute. Where the reader has a finding about the same, that one stands for this one; see `Collector`.
    pub(crate) fn missed(&mut self, rule: &'static Rule, subject: &str, message: String) {
        let finding = self.finding(rule, Severity::Warning, message);
        self.findings.push(Finding { subject: subject.into(), ..finding });
    }

    /// Adds a finding about the element.
    pub(crate) fn add(&mut self, rule: &'static Rule, severity: Severity, message: String) {
        let finding = self.finding(rule, severity, message);
        self.findings.push(finding);
    }

    fn finding(&self, rule: &'static Rule, severity: Severity, message: String) -> Finding {
        let ElementPath { owner, inside } = self.path;
        let path = if inside.is_empty() { owner.to_owned() } else { format!("{owner}/{inside}") };
        crate::findings::finding(rule, severity, self.span, path, message, "")
    }
}
