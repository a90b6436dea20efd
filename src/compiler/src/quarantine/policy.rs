//! What becomes of a map with errors.

/// What is done about an error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum OnError {
    /// The smallest part that holds it is left out.
    #[default]
    Quarantine,
    /// The map is rejected.
    Reject,
    /// As `Quarantine`, but a road stays as its bare reference line where that can be built.
    ReferenceLine,
}

/// How a map with errors is handled.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Policy {
    /// What is done about an error.
    pub on_error: OnError,
    /// More parts in quarantine reject the map. Default any number.
    pub max_parts: Option<usize>,
    /// A larger share of the roads' length in quarantine rejects the map: from 0 to 1. Default any share below all.
    pub max_share: Option<f64>,
}

impl Policy {
    /// What is wrong with so many parts in quarantine, in words; none where they are within the bounds. Lengths are sums `[m]`, at least 0: `dropped` of the roads that are not in the map,
    /// `bare` of those that are in it as their reference line, `length` of all that are in it, these among them.
    pub fn exceeded(&self, parts: usize, dropped: f64, bare: f64, length: f64) -> Option<String> {
        let whole = dropped + length;
        let share = if whole > 0.0 { (dropped + bare) / whole } else { 0.0 };
        if let Some(max) = self.max_parts.filter(|max| parts > *max) {
            return Some(format!("expected at most {max} parts in quarantine, found {parts}"));
        }
        let max = self.max_share.filter(|max| share > *max)?;
        Some(format!(
            "expected at most the share {max} of all roads in quarantine, found {share:.4}"
        ))
    }
}
