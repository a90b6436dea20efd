//! Elements of one name that hold different things: which one it is. The order of variants is that of the table.

/// A junction by its type: default, direct, virtual, crossing.
pub(crate) fn junction(_parent: u8, kind: &str) -> u8 {
    match kind {
        "direct" => 1,
        "virtual" => 2,
        "crossing" => 3,
        _ => 0,
    }
}

/// A connection by its junction's variant; within a virtual junction also by its own type.
pub(crate) fn connection(junction: u8, kind: &str) -> u8 {
    match (junction, kind) {
        (2, "virtual") => 3,
        (3, _) => 0,
        (junction, _) => junction,
    }
}

/// A segment of a boundary: along a lane, or a joint.
pub(crate) fn boundary_segment(_parent: u8, kind: &str) -> u8 {
    u8::from(kind == "joint")
}
