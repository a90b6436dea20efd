//! Overlays of signed entries, proved by who reads them.
//!
//! The daemon makes an overlay of the entries, anew for each map, and has no secret key to sign it with. A reader that trusts a key and not the daemon has the
//! signed documents, as it has a map's signature, and makes the overlay of them itself: it must be the same, byte for byte.

use crate::error::ClientError;
use crate::snapshot::Snapshot;
use crate::trust::{TrustError, TrustedKey};
use mapd_archive::encode_overlay;
use mapd_overlay::{Document, Entry, Limits, Policy, resolve};
use std::collections::BTreeMap;
use std::time::UNIX_EPOCH;

/// The signer of a document decides how long it is and what it allows.
const UNLIMITED: Limits = Limits { entries: usize::MAX, bytes: usize::MAX };
const ALL: Policy = Policy { may_loosen: true };

/// A document of entries with its signature, both as text.
#[derive(Clone, Copy, Debug)]
pub struct SignedEntries<'a> {
    /// For messages, such as the file's name.
    pub name: &'a str,
    /// The document, as it was signed.
    pub document: &'a str,
    /// In minisign's format.
    pub signature: &'a str,
}

impl Snapshot {
    /// Verifies that the overlay is what these documents say of this map: each of its entries is in one of them, unaltered, and holds where the document says.
    /// For clients that trust a key and not the daemon. Documents in the order in which they were applied: of entries of one id the last is meant.
    ///
    /// Returns the ids of signed entries that the overlay does not have: they were removed, have ended, do not fit the map, or are withheld. Without an
    /// overlay these are all. Takes about as long as the daemon needs to resolve the entries, and a reader of the daemon's release: another one may cut lanes
    /// elsewhere, which is [`TrustError::OtherOverlay`].
    ///
    /// Errors: [`ClientError::Trust`].
    pub fn verify_overlay_signatures(
        &self,
        key: &TrustedKey,
        documents: &[SignedEntries<'_>],
    ) -> Result<Vec<String>, ClientError> {
        let mut signed: BTreeMap<String, Entry> = BTreeMap::new();
        for SignedEntries { name, document, signature } in documents {
            key.verify(name, document.as_bytes(), signature)?;
            let wrong = |error: mapd_overlay::DocumentError| TrustError::Document {
                document: (*name).to_owned(),
                reason: error.to_string(),
            };
            let entries = Document::read(document.as_bytes(), &UNLIMITED).map_err(wrong)?.entries;
            signed.extend(entries.into_iter().map(|entry| (entry.id.clone(), entry)));
        }
        if !self.overlay_bytes().is_empty() {
            let map = || self.source_name().to_owned();
            let unsigned = |id: &str| TrustError::UnsignedEntry { map: map(), id: id.to_owned() };
            let view = self.view(UNIX_EPOCH);
            let entries = view
                .entries()
                .map(|entry| signed.remove(entry.id()).ok_or_else(|| unsigned(entry.id())));
            let document = Document { entries: entries.collect::<Result<_, _>>()? };
            let rows = resolve(self.map(), &document, ALL).rows;
            let made = encode_overlay(&rows, self.map().content_hash()).ok();
            if made.is_none_or(|made| made[..] != *self.overlay_bytes()) {
                return Err(TrustError::OtherOverlay { map: map() }.into());
            }
        }
        Ok(signed.into_keys().collect())
    }
}
