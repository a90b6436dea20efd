//! Counts of objects for `mapd inspect`.

use crate::printable::printable;
use mapd_client::Map;
use mapd_query::vocabulary::{Class, LaneMethod};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::Write;

/// Counts of objects.
#[derive(Serialize)]
pub(crate) struct ObjectFacts {
    objects: usize,
    /// Places where they stand: more where objects are repeated.
    places: usize,
    /// By what they mean.
    classes: BTreeMap<&'static str, usize>,
    /// Types that no table of the vocabulary knows, as written, with `type/subtype`.
    unmapped: BTreeMap<String, usize>,
    /// By how they came to their lanes.
    lanes: Vec<(&'static str, usize)>,
    /// Objects that belong to no lane.
    without_lane: usize,
    /// Objects with a value, whose unit no object states.
    assumed_units: usize,
}

impl ObjectFacts {
    pub(crate) fn of(map: Map<'_>) -> Self {
        let (mut classes, mut unmapped) = (BTreeMap::new(), BTreeMap::new());
        for object in map.objects() {
            *classes.entry(object.class().name()).or_insert(0) += 1;
            if object.class() == Class::Unknown {
                let code = format!("{}/{}", object.type_name(), object.subtype());
                *unmapped.entry(code).or_insert(0) += 1;
            }
        }
        let lanes = |method: LaneMethod| {
            map.objects().flat_map(|o| o.lanes()).filter(|at| at.method() == method).count()
        };
        Self {
            objects: map.objects().count(),
            places: map.objects().map(|object| object.placements().count()).sum(),
            classes,
            unmapped,
            lanes: LaneMethod::ALL.iter().map(|m| (m.name(), lanes(*m))).collect(),
            without_lane: map.objects().filter(|object| object.lanes().len() == 0).count(),
            assumed_units: map.objects().filter(|object| object.value().is_some()).count(),
        }
    }

    pub(crate) fn print(&self, out: &mut dyn Write) -> std::io::Result<()> {
        if self.objects == 0 {
            return Ok(());
        }
        let list = |pairs: &mut dyn Iterator<Item = (&str, usize)>| {
            let all: Vec<String> = pairs.map(|(name, count)| format!("{count} {name}")).collect();
            all.join(", ")
        };
        let classes = list(&mut self.classes.iter().map(|(name, count)| (*name, *count)));
        writeln!(out, "objects       {} in {} places: {classes}", self.objects, self.places)?;
        let lanes = list(&mut self.lanes.iter().copied());
        writeln!(out, "              on lanes: {lanes}; {} on none", self.without_lane)?;
        if self.assumed_units > 0 {
            let count = self.assumed_units;
            writeln!(out, "              {count} with a value without unit")?;
        }
        if !self.unmapped.is_empty() {
            let codes = list(&mut self.unmapped.iter().map(|(code, n)| (code.as_str(), *n)));
            let codes = printable(&codes);
            writeln!(out, "              not in the vocabulary (type/subtype): {codes}")?;
        }
        Ok(())
    }
}
