//! What `mapd inspect` says about signals.

use mapd_client::Map;
use mapd_query::vocabulary::{Class, LaneMethod};
use serde::Serialize;
use std::collections::{BTreeMap, HashSet};
use std::io::{self, Write};

/// Codes without a class that are listed at most.
const MOST_CODES: usize = 20;

/// Counts of signals.
#[derive(Serialize)]
pub(crate) struct SignalFacts {
    signals: usize,
    references: usize,
    controllers: usize,
    /// Signals that are for no lane of any road.
    without_lanes: usize,
    /// By how they came to their lanes.
    lanes: Vec<(&'static str, usize)>,
    /// Signals whose value is written without a unit.
    assumed_units: usize,
    by_class: BTreeMap<&'static str, usize>,
    /// Codes that no table maps: country, type, subtype, name.
    unknown: BTreeMap<String, usize>,
}

impl SignalFacts {
    pub(crate) fn of(map: Map<'_>) -> Self {
        let (mut by_class, mut unknown) = (BTreeMap::new(), BTreeMap::new());
        let on_lanes = || map.signal_places().flat_map(|place| place.lanes());
        let with_lanes: HashSet<_> = on_lanes().map(|one| one.signal().signal_id()).collect();
        let lanes = |method| on_lanes().filter(|one| one.method() == method).count();
        for signal in map.signals() {
            *by_class.entry(signal.class().name()).or_insert(0) += 1;
            if signal.class() == Class::Unknown {
                let [country, _, kind, subtype] = signal.code();
                let code = [country, kind, subtype, signal.name()].join(" ");
                *unknown.entry(code).or_insert(0) += 1;
            }
        }
        Self {
            signals: map.signals().len(),
            references: map.signal_places().filter(|place| place.is_reference()).count(),
            controllers: map.controllers().len(),
            without_lanes: map.signals().len() - with_lanes.len(),
            lanes: LaneMethod::ALL.iter().map(|one| (one.name(), lanes(*one))).collect(),
            assumed_units: map.signals().filter(|signal| signal.is_unit_assumed()).count(),
            by_class,
            unknown,
        }
    }

    /// Prints them; nothing for a map without signals and controllers.
    ///
    /// Errors: writing fails.
    pub(crate) fn print(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.signals + self.references + self.controllers == 0 {
            return Ok(());
        }
        writeln!(
            out,
            "signals       {}, {} references, {} controllers, {} for no lane",
            self.signals, self.references, self.controllers, self.without_lanes
        )?;
        let lanes: Vec<String> =
            self.lanes.iter().map(|(name, count)| format!("{count} {name}")).collect();
        writeln!(out, "              on lanes: {}", lanes.join(", "))?;
        if self.assumed_units > 0 {
            let count = self.assumed_units;
            writeln!(out, "              {count} with a value without unit")?;
        }
        for (class, count) in &self.by_class {
            writeln!(out, "  {class:<28}{count:>6}")?;
        }
        for (code, count) in self.unknown.iter().take(MOST_CODES) {
            writeln!(out, "  no class for {code:?}: {count}")?;
        }
        Ok(())
    }
}
