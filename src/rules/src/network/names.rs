//! Ids, each kept once: a map names a road a dozen times.

use std::hash::{BuildHasher as _, Hasher as _, RandomState};

/// An id by its number in the [`Network`](super::Network) that has it. The first one is the empty one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Name(u32);

impl Name {
    /// Its number, from 0.
    pub fn number(self) -> usize {
        self.0 as usize
    }
}

/// Ids by number, and numbers by id, while a document is examined.
///
/// Not the archive's `StringTable`: that one has the texts of all kinds that rows name, in the order of the archive, and is written to
/// it. This one also has ids that nothing has but something names, is never written, and is forgotten once links are resolved.
/// Parts of a document are numbered on many threads; the hashes that are kept make putting them together cheap.
#[derive(Clone, Debug, Default)]
pub(crate) struct IdTable {
    /// All of them, one behind the other.
    text: String,
    /// Where each ends, from the second on: the first is empty.
    ends: Vec<u32>,
    /// Their hashes, of which growing and appending need nothing else.
    hashes: Vec<u32>,
    /// Their numbers where their hashes lead, or behind; 0 where there is none. As many as a power of two.
    table: Vec<u32>,
    hasher: RandomState,
    /// Whether one no longer fitted.
    is_incomplete: bool,
}

/// Bytes of all ids together at most: 4 GiB.
const MOST_BYTES: usize = u32::MAX as usize;

/// Places in the smallest table.
const FEWEST: usize = 64;

impl IdTable {
    /// None yet, with the same hashes.
    pub(crate) fn another(&self) -> Self {
        Self { hasher: self.hasher.clone(), ..Self::default() }
    }

    /// How many there are, the empty one among them.
    pub(crate) fn len(&self) -> usize {
        self.ends.len() + 1
    }

    /// Number of an id; adds it if it is new. One that no longer fits 4 GiB counts as empty, of which
    /// [`IdTable::is_incomplete`] tells: such maps are rejected.
    pub(crate) fn add(&mut self, text: &str) -> Name {
        if text.is_empty() {
            return Name::default();
        }
        self.enter(text, self.hash(text), MOST_BYTES)
    }

    /// Whether an id did not fit, so that it counts as empty.
    pub(crate) fn is_incomplete(&self) -> bool {
        self.is_incomplete
    }

    /// Number of an id that was added.
    pub(crate) fn find(&self, text: &str) -> Option<Name> {
        if text.is_empty() {
            return Some(Name::default());
        }
        self.look_up(text, self.hash(text)).ok()
    }

    /// The id.
    pub(crate) fn text(&self, name: Name) -> &str {
        let Some(last) = name.number().checked_sub(1) else { return "" };
        let end = self.ends.get(last).map_or(0, |end| *end as usize);
        let start = last.checked_sub(1).and_then(|at| self.ends.get(at));
        self.text.get(start.map_or(0, |start| *start as usize)..end).unwrap_or_default()
    }

    /// Adds all ids of another table in its order; the number here of each number there.
    pub(crate) fn append(&mut self, other: &Self) -> Vec<Name> {
        let is_hashed_alike = self.hasher.hash_one(0_u8) == other.hasher.hash_one(0_u8);
        let texts = || (1..).map(|number| other.text(Name(number)));
        let own_hash = |(hash, text): (&u32, &str)| {
            if is_hashed_alike { *hash } else { self.hash(text) }
        };
        let hashes: Vec<u32> = other.hashes.iter().zip(texts()).map(own_hash).collect();
        // The table is larger than caches: where hashes lead, and then what is there, is looked up for all of them at once, so that
        // one does not wait for the other.
        let last = self.table.len().wrapping_sub(1);
        let led_to = hashes.iter().map(|hash| self.table.get(*hash as usize & last).copied());
        let led_to: Vec<Name> = led_to.map(|number| Name(number.unwrap_or_default())).collect();
        let hash_of = |name: &Name| Some(*self.hashes.get(name.number().checked_sub(1)?)?);
        let known: Vec<Option<u32>> = led_to.iter().map(hash_of).collect();
        let mut names = Vec::with_capacity(other.len());
        names.push(Name::default());
        for (((text, hash), name), known) in texts().zip(hashes).zip(led_to).zip(known) {
            let is_it = known == Some(hash) && self.text(name) == text;
            names.push(if is_it { name } else { self.enter(text, hash, MOST_BYTES) });
        }
        self.is_incomplete |= other.is_incomplete;
        names
    }

    fn hash(&self, text: &str) -> u32 {
        let mut hasher = self.hasher.build_hasher();
        hasher.write(text.as_bytes());
        hasher.finish() as u32
    }

    fn enter(&mut self, text: &str, hash: u32, most_bytes: usize) -> Name {
        // A quarter of the places is free.
        if 4 * self.len() > 3 * self.table.len() {
            self.grow();
        }
        let place = match self.look_up(text, hash) {
            Ok(name) => return name,
            Err(place) => place,
        };
        let end = self.text.len() + text.len();
        let (Ok(number), Ok(end), true) =
            (u32::try_from(self.len()), u32::try_from(end), end <= most_bytes)
        else {
            self.is_incomplete = true;
            return Name::default();
        };
        self.text.push_str(text);
        self.ends.push(end);
        self.hashes.push(hash);
        if let Some(free) = self.table.get_mut(place) {
            *free = number;
        }
        Name(number)
    }

    /// Number of an id, or the place in the table that it would take.
    fn look_up(&self, text: &str, hash: u32) -> Result<Name, usize> {
        let last = self.table.len().wrapping_sub(1);
        let mut place = hash as usize & last;
        while let Some(number) = self.table.get(place).filter(|number| **number != 0) {
            let name = Name(*number);
            let own = self.hashes.get(name.number() - 1);
            if own == Some(&hash) && self.text(name) == text {
                return Ok(name);
            }
            place = (place + 1) & last;
        }
        Err(place)
    }

    fn grow(&mut self) {
        let places = (2 * self.table.len()).max(FEWEST);
        self.table = vec![0; places];
        for (at, hash) in self.hashes.iter().enumerate() {
            let mut place = *hash as usize & (places - 1);
            while self.table[place] != 0 {
                place = (place + 1) & (places - 1);
            }
            self.table[place] = at as u32 + 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ids of two parts of a document, some in both, become those of the whole in the order in which they come.
    #[test]
    fn appended_names_are_those_of_one_table() {
        let texts: Vec<String> = (0..1_000).map(|n: u32| (n * n % 701).to_string()).collect();
        let mut whole = IdTable::default();
        let numbers: Vec<Name> = texts.iter().map(|text| whole.add(text)).collect();
        for is_alike in [true, false] {
            let mut first = IdTable::default();
            texts[..500].iter().for_each(|text| _ = first.add(text));
            let mut second = if is_alike { first.another() } else { IdTable::default() };
            let own: Vec<Name> = texts[500..].iter().map(|text| second.add(text)).collect();
            let moved = first.append(&second);
            let there: Vec<Name> = own.iter().map(|name| moved[name.number()]).collect();
            assert_eq!(there, numbers[500..]);
            assert_eq!(first.len(), whole.len());
            for (text, number) in texts.iter().zip(&numbers) {
                assert_eq!(first.text(*number), text);
                assert_eq!(first.find(text), Some(*number));
            }
            assert_eq!(first.find("none"), None);
            assert_eq!(first.find(""), Some(Name::default()));
        }
    }

    /// An id that does not fit is told of, also once the part that had it is appended; those before stay what they are.
    #[test]
    fn an_id_beyond_the_limit_is_told_of() {
        let mut names = IdTable::default();
        let enter = |names: &mut IdTable, text: &str| names.enter(text, names.hash(text), 5);
        let [one, two] = ["one", "22"].map(|text| enter(&mut names, text));
        assert!(!names.is_incomplete());
        assert_eq!(enter(&mut names, "3"), Name::default());
        assert!(names.is_incomplete());
        assert_eq!([names.text(one), names.text(two)], ["one", "22"]);
        assert_eq!(enter(&mut names, "one"), one);
        let mut whole = IdTable::default();
        whole.append(&names);
        assert!(whole.is_incomplete());
    }
}
