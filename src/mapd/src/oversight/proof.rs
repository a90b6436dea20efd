//! Proving what is served: the bytes that readers see, against what was published.

use crate::control::{Board, GenerationStatus};
use crate::report::hex;
use crate::serve::reserving;
use mapd_archive::{LAYOUT_ID, verify};
use mapd_client::{Attach, AttachError};
use mapd_transport::{Domain, GenerationInfo, Observer, Pinned, Subscription};
use std::time::{Duration, Instant};

/// Longest wait for a map.
const WAIT: Duration = Duration::from_secs(2);

/// Attempts to meet a generation that the board names: one may be published just now.
const ATTEMPTS: usize = 3;

/// Pause between them: the board is written right after a generation is sent.
const PAUSE: Duration = Duration::from_millis(50);

/// The outcome.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// This generation is what was published.
    Sound(u64),
    /// Readers see something else, or nothing.
    Damaged {
        /// The generation that was served according to the board before the examination; another one may be served by now.
        generation: Option<u64>,
        reason: String,
    },
    /// It was not examined: there was too little room or time.
    NotExamined(String),
}

/// Proves what a map's readers see, through mappings like theirs: what is said about the generation, its header, its hash
/// and every row, as subscribers have it, where there may be any; and that observers, who find it by its record, have the same. The serving thread must connect new clients meanwhile.
pub(crate) fn prove(domain: &Domain, board: &Board, map: &str) -> Proof {
    let (mut found, mut named) = (None, None);
    for attempt in 0..ATTEMPTS {
        if attempt > 0 {
            std::thread::sleep(PAUSE);
        }
        let before = served(board, map);
        named = before.as_ref().map(|served| served.generation);
        // Nothing is created for it, and no other process is needed: what is served is found at once, or not at all.
        let observed = match Observer::idle(domain, map).wait_newer(0, Instant::now() + WAIT) {
            Ok(observed) => observed,
            Err(error) if has_no_room(&error) || named.is_none() => {
                return Proof::NotExamined(error.to_string());
            }
            Err(error) => {
                let reason = format!("new readers cannot attach: {error}");
                return Proof::Damaged { generation: named, reason };
            }
        };
        let attached = match board.attach() {
            Attach::Subscriber => {
                let until = Instant::now() + WAIT;
                reserving(|| Subscription::connect_in_reserve(domain, map, until))
                    .map(|subscription| subscription.current())
            }
            _ => Ok(observed.clone()),
        };
        let pinned = match attached {
            Ok(pinned) => pinned,
            Err(error) if says_nothing(&error) => return Proof::NotExamined(error.to_string()),
            // Nothing stands in the way but what is in memory.
            Err(error) => {
                return Proof::Damaged { generation: named, reason: error.to_string() };
            }
        };
        let generation = pinned.info().generation;
        let known = [before, served(board, map)].into_iter().flatten();
        let same = observed.info().generation == generation;
        match { known }.find(|served| same && served.generation == generation) {
            Some(published) => {
                return match compare(&pinned, &observed, &published) {
                    Ok(()) => Proof::Sound(generation),
                    Err(reason) => Proof::Damaged { generation: Some(generation), reason },
                };
            }
            None => found = Some((generation, observed.info().generation)),
        }
    }
    let (found, observed) = found.unwrap_or_default();
    let reason = match found == observed {
        true => format!("readers see generation {found}, which was never published"),
        false => format!("subscribers see generation {found}, and observers {observed}"),
    };
    Proof::Damaged { generation: named, reason }
}

fn served(board: &Board, map: &str) -> Option<GenerationStatus> {
    board.status().maps.into_iter().find(|state| state.name == map)?.served
}

/// Whether there is too little room to look.
fn has_no_room(error: &AttachError) -> bool {
    matches!(
        error,
        AttachError::NoRoom { .. }
            | AttachError::NoDescriptors { .. }
            | AttachError::LockLimit { .. }
    )
}

/// Whether bytes that were not examined may be sound, of a subscriber.
fn says_nothing(error: &AttachError) -> bool {
    has_no_room(error)
        || matches!(
            error,
            AttachError::TooManySubscribers { .. }
                | AttachError::Busy { .. }
                | AttachError::Stuck { .. }
                | AttachError::NoDaemon { .. }
                | AttachError::NoSuchMap { .. }
                | AttachError::NoGeneration { .. }
        )
}

fn compare(pinned: &Pinned, observed: &Pinned, published: &GenerationStatus) -> Result<(), String> {
    let GenerationInfo { length, layout_id, content_hash, input_hash, .. } = pinned.info();
    let said = layout_id.starts_with(&LAYOUT_ID)
        && (*length, hex(content_hash), hex(input_hash))
            == (published.bytes, published.content_hash.clone(), published.input_hash.clone());
    if !said {
        return Err("what is said about the generation is not what was published".to_owned());
    }
    if observed.info() != pinned.info() || observed.bytes() != pinned.bytes() {
        return Err("observers see something else than subscribers".to_owned());
    }
    let archive = verify(pinned.bytes()).map_err(|error| error.to_string())?;
    let header = &archive.header;
    let hashes = (hex(&header.content_hash), hex(&header.provenance.input_hash));
    match hashes == (published.content_hash.clone(), published.input_hash.clone()) {
        true => Ok(()),
        false => Err("the archive is not the one that was published".to_owned()),
    }
}
