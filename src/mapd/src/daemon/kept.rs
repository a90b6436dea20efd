//! What is laid over a map as it outlives the daemon: a file of entries, and of signed documents where only those are taken.
//!
//! Signed entries are not in the file themselves: they are read again from their document, whose signature is proved again. A process that changes the
//! file can take them away or bring back what was signed once, as the daemon's user can anyway, but not make or alter one. Proposals are not signed:
//! who changes the file of a daemon that takes them can add one.

use crate::trust::NotSignable;
use anyhow::{Result, bail};
use mapd_client::TrustedKey;
use mapd_overlay::{Document, Entry, Limits, Unplaced};
use mapd_transport::read_owned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::io;
use std::path::Path;

/// Entries that processes on board proposed begin so: a policy lets them in, not a signature.
pub(crate) const PROPOSED: &str = "proposed/";

/// Any number of entries: they were within the limits when they were taken.
const UNLIMITED: Limits = Limits { entries: usize::MAX, bytes: usize::MAX };

/// A document that is signed.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Signed {
    /// As it was given: the signature is of these bytes.
    document: String,
    signature: String,
    /// The feed that its entries bear; no signature covers it.
    feed: Option<String>,
    /// The entries that are still laid over the map.
    ids: BTreeSet<String>,
}

/// What is laid over one map.
#[derive(Clone, Default)]
pub(super) struct Kept {
    pub(super) document: Document,
    /// Where entries of the document are from, if they are signed.
    signed: Vec<Signed>,
    pub(super) unplaced: Vec<Unplaced>,
    pub(super) revision: u64,
}

/// The file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct State {
    /// Entries that are not signed.
    entries: Vec<Entry>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    signed: Vec<Signed>,
}

/// Reads a document of a feed.
///
/// Errors: what is wrong with it.
fn read(text: &str, feed: Option<&str>, limits: &Limits) -> Result<Document> {
    let mut document = Document::read(text.as_bytes(), limits)?;
    if let Some(feed) = feed {
        document.set_feed(feed);
    }
    Ok(document)
}

/// Reads a document that was sent; where a key is trusted, only one that it has signed.
///
/// Errors: it is not signed, or not by this key; what is wrong with it.
pub(super) fn take(
    text: String,
    signature: Option<String>,
    feed: Option<&str>,
    trust: Option<&TrustedKey>,
    limits: &Limits,
) -> Result<(Document, Option<Signed>)> {
    let Some(key) = trust else { return Ok((read(&text, feed, limits)?, None)) };
    let Some(signature) = signature else { bail!(NotSignable::Unsigned) };
    key.verify("the document of entries", text.as_bytes(), &signature)?;
    let document = read(&text, feed, limits)?;
    let ids = document.entries.iter().map(|entry| entry.id.clone()).collect();
    let signed = Signed { document: text, signature, feed: feed.map(str::to_owned), ids };
    Ok((document, Some(signed)))
}

impl Kept {
    /// Notes that entries of these names are laid over the map now, all from this document if they are signed; forgets documents none of whose entries is left.
    pub(super) fn settle(&mut self, applied: &[String], from: Option<Signed>) {
        if !self.signed.is_empty() {
            let applied: BTreeSet<&str> = applied.iter().map(String::as_str).collect();
            let all = self.document.entries.iter().map(|entry| entry.id.as_str());
            let left: BTreeSet<&str> = all.filter(|id| !applied.contains(id)).collect();
            for one in &mut self.signed {
                one.ids.retain(|id| left.contains(id.as_str()));
            }
        }
        self.signed.extend(from);
        self.signed.retain(|one| !one.ids.is_empty());
    }

    /// Reads the file; of none, that nothing is laid over the map. Where a key is trusted, only what it has signed, and proposals where they are taken.
    ///
    /// Errors: it is there and cannot be read, is longer than this, or not signed.
    pub(super) fn load(
        path: &Path,
        longest: u64,
        trust: Option<&TrustedKey>,
        are_proposals_taken: bool,
    ) -> Result<Self> {
        let text = match read_owned(path, rustix::process::geteuid().as_raw(), longest) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::default()),
            text => text?,
        };
        let State { entries, signed } = serde_json::from_str(&text)?;
        let mut document = Document { entries };
        document.check(&UNLIMITED)?;
        let may_be_kept = |entry: &&Entry| are_proposals_taken && entry.id.starts_with(PROPOSED);
        if trust.is_some()
            && let Some(entry) = document.entries.iter().find(|entry| !may_be_kept(entry))
        {
            bail!(NotSignable::Kept { id: entry.id.clone() });
        }
        for one in &signed {
            if let Some(key) = trust {
                key.verify("a document in it", one.document.as_bytes(), &one.signature)?;
            }
            let mut entries = read(&one.document, one.feed.as_deref(), &UNLIMITED)?;
            entries.entries.retain(|entry| one.ids.contains(&entry.id));
            document.apply(entries, &UNLIMITED)?;
        }
        Ok(Self { document, signed, ..Self::default() })
    }

    /// The text of the file.
    ///
    /// Errors: it cannot be written as JSON.
    pub(super) fn text(&self) -> Result<String> {
        let from: BTreeSet<&str> =
            self.signed.iter().flat_map(|one| one.ids.iter().map(String::as_str)).collect();
        let is_unsigned = |entry: &&Entry| !from.contains(entry.id.as_str());
        let entries = self.document.entries.iter().filter(is_unsigned).cloned().collect();
        Ok(serde_json::to_string(&State { entries, signed: self.signed.clone() })?)
    }
}
