//! Telling of files that other users have put where the domain's are: each once, and of any number a few.

use super::notice::Notice;
use mapd_transport::{DomainFiles, ForeignFile, MOST_FOREIGN};
use std::collections::BTreeSet;

/// Files of other users that have been told of.
#[derive(Debug, Default)]
pub(crate) struct Strangers {
    told: BTreeSet<ForeignFile>,
    has_told_of_more: bool,
}

impl Strangers {
    /// Tells of those that are new.
    pub(crate) fn tell(&mut self, found: &DomainFiles, notify: &dyn Fn(&Notice)) {
        for file in &found.foreign {
            if self.told.len() < MOST_FOREIGN && self.told.insert(file.clone()) {
                notify(&Notice::Foreign { file: file.clone() });
            }
        }
        if found.foreign_count > MOST_FOREIGN && !self.has_told_of_more {
            self.has_told_of_more = true;
            notify(&Notice::MoreForeign { count: found.foreign_count });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    #[test]
    fn each_is_told_of_once_and_of_any_number_a_few() {
        let told = RefCell::new(Vec::new());
        let mut strangers = Strangers::default();
        let mut tell = |names: std::ops::Range<usize>| {
            let owner = 7;
            let file = |name: usize| ForeignFile { path: name.to_string().into(), owner };
            let (foreign_count, first) = (names.len(), names.take(MOST_FOREIGN));
            let foreign = first.map(file).collect();
            let found = DomainFiles { foreign, foreign_count, ..DomainFiles::default() };
            strangers.tell(&found, &|notice| told.borrow_mut().push(notice.clone()));
            told.take().len()
        };
        assert_eq!([tell(0..2), tell(0..2), tell(1..3), tell(0..0)], [2, 0, 1, 0]);
        assert_eq!([tell(0..1000), tell(0..1000), tell(2000..3000)], [MOST_FOREIGN - 3 + 1, 0, 0]);
    }
}
