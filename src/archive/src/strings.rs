//! The string table while it is filled: each text once.

use std::collections::HashMap;

/// Collects strings and gives each a number. String 0 is empty.
#[derive(Debug)]
pub struct StringTable {
    numbers: HashMap<Box<str>, u32>,
    bytes: Vec<u8>,
    offsets: Vec<u32>,
}

impl Default for StringTable {
    fn default() -> Self {
        let mut table = Self { numbers: HashMap::new(), bytes: Vec::new(), offsets: vec![0] };
        table.add("");
        table
    }
}

impl StringTable {
    /// Number of a text; adds it if it is new.
    ///
    /// Numbers and offsets have 32 bits. A text that no longer fits gets number 0: the caller refuses such a map by
    /// [`StringTable::is_full`].
    pub fn add(&mut self, text: &str) -> u32 {
        if let Some(number) = self.numbers.get(text) {
            return *number;
        }
        let (Ok(number), Ok(end)) =
            (u32::try_from(self.offsets.len() - 1), u32::try_from(self.bytes.len() + text.len()))
        else {
            return 0;
        };
        self.bytes.extend_from_slice(text.as_bytes());
        self.offsets.push(end);
        self.numbers.insert(text.into(), number);
        number
    }

    /// Number of a text that has been added before.
    pub fn number(&self, text: &str) -> Option<u32> {
        self.numbers.get(text).copied()
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
    pub fn into_tables(self) -> (Vec<u8>, Vec<u32>) {
        (self.bytes, self.offsets)
    }
}
