//! Feeds of road authorities: read and matched here, so that the daemon gets only entries that fit the map.

use anyhow::Result;
use mapd_client::Map;
use mapd_overlay::{Document, FeedFinding, Limits, Policy, read_feed, resolve};

/// Entries of a feed that fit the map, and what is not laid over it.
pub(super) struct Matched {
    pub(super) document: Document,
    pub(super) findings: Vec<FeedFinding>,
    /// As of the feed ([`mapd_overlay::Feed::unread`]).
    pub(super) unread: Vec<String>,
}

/// Reads a feed and leaves out what the map has no place for. A feed never allows more than the map.
///
/// Errors: it is not a feed, or has too many entries.
pub(super) fn matched(map: Map<'_>, text: &str, tolerance: f64) -> Result<Matched> {
    // How many entries are taken is the daemon's to say.
    let limits = Limits { entries: usize::MAX, bytes: usize::MAX };
    let mut feed = read_feed(text, tolerance, &limits)?;
    let unplaced = resolve(map, &feed.document, Policy::default()).unplaced;
    feed.findings.extend(unplaced.iter().map(|unfit| {
        let place = feed.places.get(unfit.number).cloned().unwrap_or_default();
        let what = if unfit.is_part { "placed in part" } else { "not placed" };
        FeedFinding { place, why: format!("{what}: {}", unfit.why) }
    }));
    let mut number = 0..;
    feed.document.entries.retain(|_| {
        let own = number.next();
        !unplaced.iter().any(|unfit| !unfit.is_part && Some(unfit.number) == own)
    });
    Ok(Matched { document: feed.document, findings: feed.findings, unread: feed.unread })
}
