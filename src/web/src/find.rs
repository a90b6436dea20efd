//! Looking for things by their names.

use crate::sheet::{Kind, Link, Words};
use mapd_query::vocabulary::QuarantinedKind;
use mapd_query::{LaneKey, Map};

/// Things that are found at most.
pub const MOST_FOUND: usize = 30;

/// Things whose id or name is the text, then such whose id or name begins with it, then such that have it somewhere; all
/// without regard to upper and lower case.
pub fn find(map: Map<'_>, text: &str) -> Vec<Words> {
    let text = text.trim();
    if text.is_empty() {
        return Vec::new();
    }
    let mut found: Vec<(u8, Words)> = Vec::new();
    let lane = text.parse::<LaneKey<'_>>().ok().and_then(|key| map.lane_by_key(&key));
    found.extend(lane.map(|lane| (0, prefixed("lane", Words::from(&lane)))));
    let wanted = text.to_lowercase();
    let mut consider = |names: [&str; 2], words: &dyn Fn() -> Words| {
        if let Some(rank) = names.iter().filter_map(|name| rank(name, &wanted)).min() {
            found.push((rank, words()));
        }
    };
    for road in map.roads() {
        consider([road.id(), road.name()], &|| prefixed("road", Words::from(&road)));
    }
    for junction in map.junctions() {
        let words = || prefixed("junction", Words::from(&junction));
        consider([junction.id(), junction.name()], &words);
    }
    for signal in map.signals() {
        let names = [signal.id(), signal.name()];
        consider(names, &|| prefixed("signal", Words::from(&signal)));
    }
    for object in map.objects() {
        let names = [object.id(), object.name()];
        consider(names, &|| prefixed("object", Words::from(&object)));
    }
    for (number, part) in map.quarantined().enumerate() {
        let words = || prefixed("left out:", left_out(number, part.kind(), part.id()));
        consider([part.id(), part.rule()], &words);
    }
    // Sorting keeps the order of the file among equals.
    found.sort_by_key(|(rank, _)| *rank);
    found.truncate(MOST_FOUND);
    found.into_iter().map(|(_, words)| words).collect()
}

fn rank(name: &str, wanted: &str) -> Option<u8> {
    // Long names are compared as they are written: most do not match, and none need be copied.
    let name = name.to_lowercase();
    if name.is_empty() {
        None
    } else if name == wanted {
        Some(1)
    } else if name.starts_with(wanted) {
        Some(2)
    } else if name.contains(wanted) {
        Some(3)
    } else {
        None
    }
}

fn prefixed(kind: &str, words: Words) -> Words {
    Words { text: format!("{kind} {}", words.text), link: words.link }
}

fn left_out(number: usize, kind: QuarantinedKind, id: &str) -> Words {
    let link = Link { kind: Kind::Quarantine, row: number as u32 };
    Words { text: format!("{} {id}", kind.name()), link: Some(link) }
}
