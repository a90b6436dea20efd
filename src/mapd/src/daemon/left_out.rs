//! Parts of the document that an archive is without: told wherever no compiler tells them, and perhaps too many.

use mapd_archive::Archive;
use mapd_compiler::{OnError, Policy};
use mapd_query::Map;

/// Parts that are told one by one.
const TOLD: usize = 20;

/// What people call the document that an archive was compiled from.
const DOCUMENT: &str = "its OpenDRIVE file";

/// Whether an archive that is compiled already may be without so much.
///
/// Errors: what is too much.
pub(super) fn judge(archive: &Archive<'_>, policy: &Policy) -> Result<(), String> {
    let map = Map::new(archive, 0);
    let parts = || map.quarantined();
    if let (OnError::Reject, Some(first)) = (policy.on_error, parts().next()) {
        let (count, first) = (parts().len(), first.explained(DOCUMENT));
        return Err(format!(
            "expected no part in quarantine (--on-error reject), found {count}; first: {first}"
        ));
    }
    let of = |bare: bool| {
        let roads = parts().filter(|part| part.is_reference_line() == bare);
        roads.map(|part| part.length()).filter(|length| length.is_finite()).sum()
    };
    policy.exceeded(parts().len(), of(false), of(true), map.road_length()).map_or(Ok(()), Err)
}

/// Tells what a map is without; nothing of one that is whole.
pub(super) fn tell(map: &str, archive: &Archive<'_>) {
    let parts = Map::new(archive, 0).quarantined();
    let count = parts.len();
    for part in parts.take(TOLD) {
        tracing::warn!(map, "map {map}: {}", part.explained(DOCUMENT));
    }
    if count > 0 {
        tracing::warn!(map, quarantined = count, "map {map}: {count} parts are in quarantine");
    }
}
