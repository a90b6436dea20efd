//! What depends on what.

use crate::example::Example::{Document, Road as InRoad, Signals};
use crate::network::{Name, NamedAt, Network, PartKind, Reference};
use crate::rule::Check::Network as All;
use crate::rule::Rule;
use crate::sink::{PartOf, Sink};
use std::collections::{HashMap, HashSet};
use std::fmt;

pub(super) static RULES: &[Rule] = &[
    Rule::warning(
        "mapd:xodr:1.4.0:topology.dependency_cycle",
        "No signal depends on itself through others.",
        All(cycles),
        [
            Signals(
                r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><dependency id="2"/></signal><signal id="2" s="20" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"/>"#,
            ),
            Signals(
                r#"<signal id="1" s="10" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><dependency id="2"/></signal><signal id="2" s="20" t="-4" zOffset="2" dynamic="no" orientation="+" type="274" subtype="50" country="DE" hOffset="0" pitch="0" roll="0"><dependency id="1"/></signal>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.9.0:road.signal.gantry.all_variable_boards_same_gantry",
        "The boards of a group are on one gantry: their signals refer to the same object.",
        All(gantry),
        [
            group(),
            Document(
                r#"<road id="1" length="90" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="90"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><objects><object id="20" type="gantry" s="5" t="0" zOffset="0" orientation="none"/><object id="21" type="gantry" s="50" t="0" zOffset="0" orientation="none"/></objects><signals><signal id="1" s="5" t="-4" zOffset="6" dynamic="yes" orientation="+" country="DE" type="vmsBoard" subtype="-1" hOffset="0" pitch="0" roll="0"><reference elementType="object" elementId="20"/></signal><signal id="2" s="5" t="-2" zOffset="6" dynamic="yes" orientation="+" country="DE" type="vmsBoard" subtype="-1" hOffset="0" pitch="0" roll="0"><reference elementType="object" elementId="21"/></signal></signals></road><vmsGroup id="8"><vmsBoardReference signalId="1" vmsIndex="0" groupIndex="0"/><vmsBoardReference signalId="2" vmsIndex="0" groupIndex="1"/></vmsGroup>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.railroad.switch.single_switch_no_partner",
        "A switch has a partner only if each of the two names the other.",
        All(partners),
        [
            InRoad(
                r#"<railroad><switch name="a" id="5" position="straight"><mainTrack id="1" s="10" dir="+"/><sideTrack id="1" s="0" dir="+"/></switch></railroad>"#,
            ),
            InRoad(
                r#"<railroad><switch name="a" id="5" position="straight"><mainTrack id="1" s="10" dir="+"/><sideTrack id="1" s="0" dir="+"/><partner id="6"/></switch><switch name="b" id="6" position="straight"><mainTrack id="1" s="20" dir="+"/><sideTrack id="1" s="0" dir="+"/></switch></railroad>"#,
            ),
        ],
    ),
    Rule::warning(
        "asam.net:xodr:1.7.0:road.railroad.switch.check_switch_conn",
        "Two partner switches are joined by their side track, not by the main track of one of them.",
        All(joined),
        [
            pair(),
            Document(
                r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><railroad><switch name="a" id="5" position="straight"><mainTrack id="1" s="1" dir="+"/><sideTrack id="2" s="0" dir="+"/><partner id="6"/></switch></railroad></road>
<road id="2" length="9" junction="-1"><planView><geometry s="0" x="0" y="50" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><railroad><switch name="b" id="6" position="straight"><mainTrack id="2" s="1" dir="+"/><sideTrack id="1" s="0" dir="+"/><partner id="5"/></switch></railroad></road>"#,
            ),
        ],
    ),
];

const fn group() -> crate::example::Example {
    Document(
        r#"<road id="1" length="90" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="90"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><objects><object id="20" type="gantry" s="5" t="0" zOffset="0" orientation="none"/></objects><signals><signal id="1" s="5" t="-4" zOffset="6" dynamic="yes" orientation="+" country="DE" type="vmsBoard" subtype="-1" hOffset="0" pitch="0" roll="0"><reference elementType="object" elementId="20"/></signal><signal id="2" s="5" t="-2" zOffset="6" dynamic="yes" orientation="+" country="DE" type="vmsBoard" subtype="-1" hOffset="0" pitch="0" roll="0"><reference elementType="object" elementId="20"/></signal></signals></road><vmsGroup id="8"><vmsBoardReference signalId="1" vmsIndex="0" groupIndex="0"/><vmsBoardReference signalId="2" vmsIndex="0" groupIndex="1"/></vmsGroup>"#,
    )
}

const fn pair() -> crate::example::Example {
    Document(
        r#"<road id="1" length="9" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><railroad><switch name="a" id="5" position="straight"><mainTrack id="1" s="1" dir="+"/><sideTrack id="3" s="0" dir="+"/><partner id="6"/></switch></railroad></road>
<road id="2" length="9" junction="-1"><planView><geometry s="0" x="0" y="50" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes><railroad><switch name="b" id="6" position="straight"><mainTrack id="2" s="1" dir="+"/><sideTrack id="3" s="0" dir="+"/><partner id="5"/></switch></railroad></road>
<road id="3" length="9" junction="-1"><planView><geometry s="0" x="0" y="90" hdg="0" length="9"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes></road>"#,
    )
}

fn of(network: &Network, at: NamedAt) -> impl Iterator<Item = &Reference> {
    network.references.iter().filter(move |reference| reference.at == at)
}

/// A loop in words. It may be as long as the map, and there may be as many: only those that are told are put into words.
struct Around<'a> {
    network: &'a Network,
    path: &'a [(Name, usize)],
    /// The first one again.
    last: Name,
}

impl fmt::Display for Around<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (signal, _) in self.path {
            write!(f, "{} on ", self.network.name(*signal))?;
        }
        f.write_str(self.network.name(self.last))
    }
}

/// Each loop once, at the dependency that closes it. Every dependency is followed once, so that long chains cost what they hold.
fn cycles(network: &Network, sink: &mut Sink<'_>) {
    let mut next: HashMap<Name, Vec<&Reference>> = HashMap::new();
    for reference in of(network, NamedAt::SignalDependency) {
        next.entry(reference.from).or_default().push(reference);
    }
    let mut done: HashSet<Name> = HashSet::new();
    for reference in of(network, NamedAt::SignalDependency) {
        // The signals from the first one to where the search is, with how many dependencies of each were followed.
        let mut path: Vec<(Name, usize)> = Vec::new();
        // Where in it each of them is.
        let mut places: HashMap<Name, usize> = HashMap::new();
        if done.insert(reference.from) {
            places.insert(reference.from, 0);
            path.push((reference.from, 0));
        }
        while let Some((signal, followed)) = path.last_mut() {
            let Some(link) = next.get(signal).and_then(|links| links.get(*followed)) else {
                places.remove(signal);
                path.pop();
                continue;
            };
            *followed += 1;
            if let Some(&first) = places.get(&link.id) {
                let around = Around { network, path: &path[first..], last: link.id };
                let place = || link.path(network);
                sink.add_at(place, sink.severity, link.span, "no way back to the signal", around);
            } else if done.insert(link.id) {
                places.insert(link.id, path.len());
                path.push((link.id, 0));
            }
        }
    }
}

fn gantry(network: &Network, sink: &mut Sink<'_>) {
    let mut objects: HashMap<Name, Vec<Name>> = HashMap::new();
    for reference in of(network, NamedAt::SignalLink) {
        if reference.kinds.all().contains(&PartKind::Object) {
            objects.entry(reference.from).or_default().push(reference.id);
        }
    }
    let mut shared: HashMap<Name, HashSet<Name>> = HashMap::new();
    for board in of(network, NamedAt::Board) {
        let own: HashSet<Name> = objects.get(&board.id).into_iter().flatten().copied().collect();
        let group = shared.entry(board.from).or_insert_with(|| own.clone());
        group.retain(|object| own.contains(object));
        if group.is_empty() && !own.is_empty() {
            sink.add_in(
                PartOf {
                    element: "vmsGroup",
                    id: network.name(board.from),
                    path: "vmsBoardReference",
                },
                board.span,
                "boards of one gantry",
                format_args!("signal {} at another", network.name(board.id)),
            );
        }
    }
}

fn partners(network: &Network, sink: &mut Sink<'_>) {
    let pairs: HashSet<(Name, Name)> =
        of(network, NamedAt::Partner).map(|r| (r.from, r.id)).collect();
    for reference in of(network, NamedAt::Partner) {
        if !pairs.contains(&(reference.id, reference.from)) || reference.id == reference.from {
            let place = reference.path(network);
            let name = network.name(reference.id);
            let found = format_args!("switch {name}, which does not");
            sink.add_at(
                || place,
                sink.severity,
                reference.span,
                "a partner that names this switch",
                found,
            );
        }
    }
}

fn joined(network: &Network, sink: &mut Sink<'_>) {
    let main: HashMap<Name, Name> =
        of(network, NamedAt::MainTrack).map(|r| (r.from, r.id)).collect();
    let side: HashMap<Name, Name> =
        of(network, NamedAt::SideTrack).map(|r| (r.from, r.id)).collect();
    for reference in of(network, NamedAt::Partner) {
        let (from, partner) = (reference.from, reference.id);
        if let (Some(side), Some(main)) = (side.get(&from), main.get(&partner))
            && side == main
        {
            let place = reference.path(network);
            let [main, partner] = [*main, partner].map(|id| network.name(id));
            let found = format_args!("road {main}, the main track of switch {partner}");
            sink.add_at(
                || place,
                sink.severity,
                reference.span,
                "a side track between the two",
                found,
            );
        }
    }
}
