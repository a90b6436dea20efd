//! Places that are too short to be cut out of a lane: each holds somewhere or is told, never neither.

use mapd_archive::open_overlay;
use mapd_client::Snapshot;
use mapd_query::view::View;
use mapd_tests::graph_maps::{Line, document, lane, road, section};
use mapd_tests::maps::{Random, open_text};
use mapd_tests::overlays::over;
use std::collections::BTreeSet;
use std::time::UNIX_EPOCH;

/// Road A, 100 m, whose two lanes have sections of 50 m.
fn two_sections() -> Snapshot {
    let line = Line(0.0, 0.0, 0.0, 100.0, 0.0);
    let right = |links: [&str; 2]| lane(-1, links[0]) + &lane(-2, links[1]);
    let [first, second] = [(0.0, ["s-1", "s-2"]), (50.0, ["p-1", "p-2"])]
        .map(|(s, links)| section(s, "", &right(links)));
    open_text(&document(&road("A", "", line, "", &(first + &second))))
}

/// An entry about these stretches of lane −1.
fn entry(id: &str, stretches: &[[f64; 2]]) -> String {
    let one = |[from, to]: &[f64; 2]| format!(r#"{{"road":"A","s":[{from},{to}],"lane":-1}}"#);
    let lanes: Vec<String> = stretches.iter().map(one).collect();
    format!(r#"{{"id":"{id}","kind":"closed","lanes":[{}]}}"#, lanes.join(","))
}

/// What is told of entries, as `id field`, with ` in part` where the rest holds. Each place of an entry holds on a lane or is told, and what is told to be left out is left out.
fn check(snapshot: &Snapshot, all: &[(&str, &[[f64; 2]])]) -> Vec<String> {
    let text: Vec<String> = all.iter().map(|(id, stretches)| entry(id, stretches)).collect();
    let text = format!(r#"{{"entries":[{}]}}"#, text.join(","));
    let (bytes, resolved) = over(snapshot.map(), &text, false);
    let overlay = open_overlay(&bytes).expect("opens");
    let view = View::new(snapshot.map(), Some(&overlay), UNIX_EPOCH).expect("its own");
    let kept: BTreeSet<&str> = view.entries().map(|entry| entry.id()).collect();
    for (id, stretches) in all {
        let own = || resolved.unplaced.iter().filter(|unfit| unfit.id == **id);
        let is_left_out = own().any(|unfit| !unfit.is_part);
        assert_eq!(kept.contains(id), !is_left_out, "{id}: {text}");
        for (i, [from, to]) in stretches.iter().enumerate() {
            // A piece reaches beyond what it is about by less than the shortest piece.
            let holds = view.restrictions().any(|one| {
                let (low, high) = (one.s_from.min(one.s_to), one.s_from.max(one.s_to));
                one.entry.id() == *id && low < *to && high > *from
            });
            let field = format!("lanes[{i}].s");
            let is_told = own().any(|unfit| unfit.field == field);
            assert!(
                holds || is_told || is_left_out,
                "{id} {field}: {text}: {:?}",
                resolved.unplaced
            );
        }
        assert!(
            !is_left_out || !view.restrictions().any(|one| one.entry.id() == *id),
            "{id}: {text}"
        );
    }
    let told = resolved.unplaced.iter().map(|unfit| {
        assert!(unfit.why.contains("0.1 m"), "{unfit:?}");
        format!("{} {}{}", unfit.id, unfit.field, if unfit.is_part { " in part" } else { "" })
    });
    told.collect()
}

/// Once it vanished in silence.
#[test]
fn what_is_too_short_on_both_sides_of_a_sections_end_is_told() {
    let snapshot = two_sections();
    let check = |all: &[(&str, &[[f64; 2]])]| check(&snapshot, all);
    assert_eq!(check(&[("a", &[[49.95, 50.06]])]), ["a lanes[0].s"]);
    assert_eq!(check(&[("a", &[[10.0, 20.0], [49.95, 50.06]])]), ["a lanes[1].s in part"]);
    let both = [("a", &[[49.95, 50.06]][..]), ("b", &[[10.0, 20.0]])];
    assert_eq!(check(&both), ["a lanes[0].s"]);
    // Enough is left on one side.
    assert_eq!(check(&[("a", &[[49.89, 50.06]])]), [""; 0]);
    assert_eq!(check(&[("a", &[[20.0, 20.11]])]), [""; 0]);
}

/// Others begin and end so near that nothing is left of it; without them it holds.
#[test]
fn what_others_leave_no_room_for_is_told() {
    let snapshot = two_sections();
    let all: [(&str, &[[f64; 2]]); 3] =
        [("a", &[[10.0, 20.0]]), ("b", &[[20.07, 20.17]]), ("c", &[[20.1, 30.0]])];
    assert_eq!(check(&snapshot, &all), ["b lanes[0].s"]);
    assert_eq!(check(&snapshot, &all[..2]), [""; 0]);
}

/// Whatever is said near the end of a section holds or is told.
#[test]
fn none_vanishes_in_silence() {
    let snapshot = two_sections();
    let mut random = Random(7);
    let (mut whole, mut parts) = (0, 0);
    for _ in 0..500 {
        let mut stretches = || -> Vec<[f64; 2]> {
            let count = 1 + (random.unit() * 3.0) as usize;
            let one = |_| {
                let from = random.between(49.5, 50.3);
                [from, from + random.between(0.101, 0.25)]
            };
            (0..count).map(one).collect()
        };
        let all = [stretches(), stretches(), stretches()];
        let all: Vec<(&str, &[[f64; 2]])> =
            ["a", "b", "c"].into_iter().zip(all.iter().map(Vec::as_slice)).collect();
        let told = check(&snapshot, &all);
        parts += told.iter().filter(|one| one.ends_with("part")).count();
        whole += told.iter().filter(|one| !one.ends_with("part")).count();
    }
    assert!(whole > 20 && parts > 20, "{whole} entries, {parts} parts");
}
