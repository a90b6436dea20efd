//! Ids are unique, and what is referred to is there.

use crate::example::Example::{Document, Signals};
use crate::network::{IdentifiedPart, Name, NamedAt, Network, PartKind};
use crate::rule::Check::Network as All;
use crate::rule::Rule;
use crate::sink::{PartOf, Sink};
use mapd_xodr::Severity;
use std::collections::{HashMap, HashSet};

/// Roads of 9 m, given by their attributes, with more elements behind.
macro_rules! roads {
    ($first:literal, $second:literal, $rest:literal) => {
        Document(concat!(
            "<road ", $first, r#" length="9"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>
<road "#, $second, r#" length="9"><planView><geometry s="0" x="0" y="90" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#,
            $rest
        ))
    };
}

pub(super) static RULES: &[Rule] = &[
    Rule::error(
        "asam.net:xodr:1.4.0:ids.id_unique_in_class",
        [
            "An id is unique among the elements of a kind.",
            "it is unclear which of two roads or junctions a link means; other parts stay (warning)",
        ],
        All(unique),
        [
            roads!(r#"id="1" junction="-1""#, r#"id="2" junction="-1""#, ""),
            roads!(r#"id="1" junction="-1""#, r#"id="1" junction="-1""#, ""),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.4.0:ids.only_ref_defined_ids",
        "An id that is referred to exists.",
        All(defined),
        [
            roads!(r#"id="1" junction="-1""#, r#"id="2" junction="-1""#, r#"<junction id="8" name=""/><junctionGroup id="7" type="roundabout" name=""><junctionReference junction="8"/></junctionGroup>"#),
            roads!(r#"id="1" junction="-1""#, r#"id="2" junction="-1""#, r#"<junctionGroup id="7" type="roundabout" name=""><junctionReference junction="8"/></junctionGroup>"#),
        ],
    )
    .also(&["mapd:xodr:1.4.0:ref.orphan_element"]),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.signal.reference.used_for_signals_only",
        "A signalReference refers to a signal, not to something else with that id.",
        All(signals_only),
        [
            Signals(r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/><signalReference id="1" s="20" t="0" orientation="+"/>"#),
            crate::example::Example::Road(r#"<objects><object id="5" type="pole" s="10" t="4" zOffset="0" orientation="none"/></objects><signals><signalReference id="5" s="20" t="0" orientation="+"/></signals>"#),
        ],
    ),
];

fn unique(network: &Network, sink: &mut Sink<'_>) {
    // Signs on one board may share an id: no rule gives them a class of their own.
    let parts = || network.parts.iter().filter(|part| part.kind != PartKind::Sign);
    let mut kinds = vec![0; network.names()];
    let is_second = |part: &&IdentifiedPart| {
        let known: Option<&mut u16> = kinds.get_mut(part.id.number());
        known.is_some_and(|known| {
            let is_known = *known & part.kind.bit() != 0;
            *known |= part.kind.bit();
            is_known
        })
    };
    let repeated: HashSet<(PartKind, Name)> =
        parts().filter(is_second).map(|part| (part.kind, part.id)).collect();
    if repeated.is_empty() {
        return;
    }
    let mut first: HashMap<(PartKind, Name), &IdentifiedPart> = HashMap::new();
    let mut told: HashSet<(PartKind, Name)> = HashSet::new();
    for part in parts().filter(|part| repeated.contains(&(part.kind, part.id))) {
        let key = (part.kind, part.id);
        let Some(before) = first.get(&key) else {
            first.insert(key, part);
            continue;
        };
        // Of roads and junctions neither can be told to be the one that is meant; for other parts the id hardly matters.
        let severity = match part.kind {
            PartKind::Road | PartKind::Junction => Severity::Error,
            _ => Severity::Warning,
        };
        let severity = severity.min(sink.severity);
        let (name, id) = (part.kind.name(), network.name(part.id));
        let path = |part: &IdentifiedPart| {
            let road = network.road_along(part).map(|road| network.name(road.id));
            let above = match (road, part.kind) {
                (Some(road), PartKind::Signal) => format!("road[@id={road}]/signals/"),
                (Some(road), PartKind::Object) => format!("road[@id={road}]/objects/"),
                (Some(road), PartKind::Switch) => format!("road[@id={road}]/railroad/"),
                _ => String::new(),
            };
            format!("OpenDRIVE/{above}{name}[@id={id}]")
        };
        let expected = format!("an id that no other {name} has");
        if told.insert(key) && part.kind == PartKind::Road {
            sink.add_at(|| path(before), severity, before.span, &expected, id);
        }
        sink.add_at(|| path(part), severity, part.span, &expected, id);
    }
}

/// By the number of an id: bits of the kinds of parts that have it.
fn known(network: &Network) -> Vec<u16> {
    let mut known = vec![0; network.names()];
    for part in &network.parts {
        if let Some(kinds) = known.get_mut(part.id.number()) {
            *kinds |= part.kind.bit();
        }
    }
    known
}

/// The kinds of parts that have an id.
fn kinds_of(known: &[u16], id: Name) -> u16 {
    known.get(id.number()).copied().unwrap_or(0)
}

fn defined(network: &Network, sink: &mut Sink<'_>) {
    let known = known(network);
    for reference in &network.references {
        let (kinds, found) = (reference.kinds.all(), kinds_of(&known, reference.id));
        if kinds.iter().any(|kind| found & kind.bit() != 0) {
            continue;
        }
        let kinds: Vec<&str> = kinds.iter().map(|kind| kind.name()).collect();
        let expected = format!("the id of a {}", kinds.join(" or "));
        let name = network.name(reference.id);
        let found = format_args!("{name}, which does not exist");
        let path = || reference.path(network);
        sink.add_at(path, sink.severity, reference.span, expected, found);
    }
}

fn signals_only(network: &Network, sink: &mut Sink<'_>) {
    let known = known(network);
    for reference in network.references.iter().filter(|r| r.at == NamedAt::SignalReference) {
        let found = kinds_of(&known, reference.id);
        if found & (PartKind::Signal.bit() | PartKind::Sign.bit()) != 0 {
            continue;
        }
        if let Some(kind) = PartKind::ALL.iter().find(|kind| found & kind.bit() != 0) {
            let kind = kind.name();
            let found = format_args!("that of a {kind}");
            sink.add_in(
                PartOf::road(network.name(reference.from), reference.at.path()),
                reference.span,
                "the id of a signal",
                found,
            );
        }
    }
}
