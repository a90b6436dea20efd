//! The string table while it is filled: each text once.

use crate::hashed::{ByHash, KeyedHash};

/// Collects the strings that rows name and gives each a number, in the order in which they are added. String 0 is empty.
///
/// This is what an archive stores: texts of all kinds, ids among them. The rules number ids in a table of their own
/// (`mapd_rules::network`), with ids that no row names.
#[derive(Debug)]
pub struct StringTable {
    /// Numbers by the hashes of their texts; where one is taken by another text, by the next that is not.
    numbers: ByHash<u32>,
    hasher: KeyedHash,
    bytes: Vec<u8>,
    offsets: Vec<u32>,
}

impl Default for StringTable {
    fn default() -> Self {
        let (numbers, hasher) = (ByHash::default(), KeyedHash::default());
        Self { numbers, hasher, bytes: Vec::new(), offsets: vec![0; 2] }
    }
}

/// The tables of an archive's strings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StringTables {
    /// UTF-8 text of all strings, one after the other.
    pub bytes: Vec<u8>,
    /// Start of each string, and the end of the last.
    pub offsets: Vec<u32>,
}

impl StringTable {
    /// Number of a text; adds it if it is new.
    ///
    /// Numbers and offsets have 32 bits. A text that no longer fits gets number 0: the caller refuses such a map by
    /// [`StringTable::is_full`].
    pub fn add(&mut self, text: &str) -> u32 {
        self.add_bytes(text.as_bytes())
    }

    fn add_bytes(&mut self, text: &[u8]) -> u32 {
        self.find(text).unwrap_or_else(|hash| self.insert(text, hash))
    }

    /// Adds a new text, where it would be entered.
    fn insert(&mut self, text: &[u8], hash: u64) -> u32 {
        let (Ok(number), Ok(end)) =
            (u32::try_from(self.offsets.len() - 1), u32::try_from(self.bytes.len() + text.len()))
        else {
            return 0;
        };
        self.bytes.extend_from_slice(text);
        self.offsets.push(end);
        self.numbers.insert(hash, number);
        number
    }

    /// Adds the texts of another table in its order; the number here of each number there.
    pub fn append(&mut self, other: &Self) -> Vec<u32> {
        let texts = || (0..other.len() as u32).map(|number| other.bytes_of(number));
        // The table is larger than caches: what hashes lead to is looked up for all of them at once, so that one does not wait for
        // the other.
        let led_to = texts().map(|text| {
            let hash = self.hasher.of(text);
            (hash, self.numbers.get(&hash).copied())
        });
        let led_to: Vec<(u64, Option<u32>)> = led_to.collect();
        let add = |(text, (hash, known)): (&[u8], (u64, Option<u32>))| {
            let known = known.filter(|number| self.bytes_of(*number) == text);
            known.unwrap_or_else(|| match self.find_hashed(text, hash) {
                Ok(number) => number,
                Err(hash) => self.insert(text, hash),
            })
        };
        // The first one is empty.
        std::iter::once(0).chain(texts().zip(led_to).skip(1).map(add)).collect()
    }

    /// Number of a text that has been added before.
    pub fn number(&self, text: &str) -> Option<u32> {
        self.find(text.as_bytes()).ok()
    }

    /// Number of a text that has been added before, by its bytes.
    pub fn number_of(&self, text: &[u8]) -> Option<u32> {
        self.find(text).ok()
    }

    /// How many texts there are, the empty one among them.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there are no texts; never so, for there is the empty one.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of a text, or where it would be entered.
    fn find(&self, text: &[u8]) -> Result<u32, u64> {
        // Half of the texts that are asked for are empty.
        if text.is_empty() {
            return Ok(0);
        }
        self.find_hashed(text, self.hasher.of(text))
    }

    /// As [`Self::find`], of a text that is not empty and whose hash is known.
    fn find_hashed(&self, text: &[u8], mut hash: u64) -> Result<u32, u64> {
        while let Some(number) = self.numbers.get(&hash) {
            if self.bytes_of(*number) == text {
                return Ok(*number);
            }
            hash = hash.wrapping_add(1);
        }
        Err(hash)
    }

    /// Bytes of the text with a number; empty if there is none.
    pub fn bytes_of(&self, number: u32) -> &[u8] {
        let at = number as usize;
        match (self.offsets.get(at), self.offsets.get(at + 1)) {
            (Some(start), Some(end)) => {
                self.bytes.get(*start as usize..*end as usize).unwrap_or(&[])
            }
            _ => &[],
        }
    }

    /// Whether a text of the longest kind might no longer fit 32-bit offsets.
    pub fn is_full(&self) -> bool {
        const HEADROOM: usize = 1 << 24;
        self.bytes.len() > u32::MAX as usize - HEADROOM
    }

    /// The two tables.
    pub fn into_tables(self) -> StringTables {
        StringTables { bytes: self.bytes, offsets: self.offsets }
    }
}
