//! Repetitions of objects as written.

use super::need::ElementContext;
use crate::draft::{Lateral, Repeat};
use mapd_rules::catalog::building;
use mapd_xodr::{self as xodr, Attribute, Value as _};

/// A repetition with the object's own sizes where it has none; none where it lacks its place or its distances.
pub(super) fn repeat(
    object: &xodr::Object,
    repeat: &xodr::ObjectRepeat,
    part: &mut ElementContext<'_>,
) -> Option<Repeat> {
    let written = [("s", &repeat.s), ("length", &repeat.length), ("distance", &repeat.distance)];
    let [Some(s), Some(length), Some(distance)] = written.map(|(_, number)| number.value()) else {
        let missing = written.iter().find(|(_, number)| number.value().is_none());
        let name = missing.map_or("", |(name, _)| *name);
        let message =
            format!("expected @{name}, found none; the object stands alone, at its own place");
        part.missed(&building::OBJECT_PART, name, message);
        return None;
    };
    // Where one end is not given, the value stays; where neither is, the object's own holds.
    let pair = |start: &Option<Attribute<f64>>, end: &Option<Attribute<f64>>, own: Option<f64>| {
        let (start, end) = (start.value(), end.value());
        match (start, end) {
            (Some(start), Some(end)) => [start, end],
            (Some(one), None) | (None, Some(one)) => [one; 2],
            (None, None) => [own.unwrap_or(0.0); 2],
        }
    };
    let between = pair(&repeat.t_start, &repeat.t_end, object.t.value());
    let cubic = [&repeat.b_t, &repeat.c_t, &repeat.d_t].map(|c| c.value());
    let t = if cubic.iter().any(Option::is_some) {
        let [b, c, d] = cubic.map(|c| c.unwrap_or(0.0));
        Lateral::Cubic([between[0], b, c, d])
    } else {
        Lateral::Between(between)
    };
    let own = object.z_offset.value();
    Some(Repeat {
        s,
        length: length.max(0.0),
        distance: distance.max(0.0),
        t,
        z_offset: pair(&repeat.z_offset_start, &repeat.z_offset_end, own),
        height: pair(&repeat.height_start, &repeat.height_end, object.height.value()),
        width: pair(&repeat.width_start, &repeat.width_end, object.width.value()),
        length_of_copy: pair(&repeat.length_start, &repeat.length_end, object.length.value()),
        radius: pair(&repeat.radius_start, &repeat.radius_end, object.radius.value()),
        is_detached: repeat.detach_from_reference_line.value() == Some(true),
        span: repeat.span,
    })
}
