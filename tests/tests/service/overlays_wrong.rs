//! What is wrong with entries: refused whole, with the entry and the field, or the limit; what is served stays.

use super::overlays::{Scene, closed};
use mapd::control::{OverlayAction, Request, Response};
use std::fs;

/// What is wrong is refused whole: by 2; where there is no daemon, by 1.
#[test]
fn what_is_wrong() {
    let scene = Scene::new();
    let refused = |daemon: bool| {
        let none = if daemon { 2 } else { 1 };
        scene.ends(&["apply", "-"], "{", none);
        scene.ends(&["remove", "x"], "", none);
        scene.ends(&["show", "x"], "", none);
        scene.ends(&["list", "--at", "soon"], "", 2);
        scene.ends(&["apply", "/no/such/file"], "", 1);
    };
    refused(false);
    let _daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    refused(true);
    let mut half = closed("more", -1).replace("]}]}", "]},");
    half += r#"{"id":"far","kind":"closed","lanes":[{"road":"99999"}]}]}"#;
    let said = scene.ends(&["apply", "-"], &half, 2);
    assert!(said.contains("\"far\"") && said.contains("lanes[0].road"), "{said}");
    let opens = closed("opens", -1).replace("closed", "open");
    assert!(scene.ends(&["apply", "-"], &opens, 2).contains("--overlay-may-loosen"));
    let long = closed("long", -1).replace("works", &"x".repeat(5 << 20)) + &" ".repeat(5 << 20);
    assert!(scene.ends(&["apply", "-"], &long, 2).contains("bytes"));
    // Too short where others begin and end.
    let near = [("a", "[10,20]"), ("b", "[20.07,20.17]"), ("c", "[20.1,30]")].map(|(id, s)| {
        let one = closed(id, -1).replace("[10,20]", s);
        let own = one.strip_prefix(r#"{"entries":["#).and_then(|one| one.strip_suffix("]}"));
        own.expect("an entry").to_owned()
    });
    let near = format!(r#"{{"entries":[{}]}}"#, near.join(","));
    let said = scene.ends(&["apply", "-"], &near, 2);
    assert!(said.contains("\"b\", lanes[0].s: too short to be cut out"), "{said}");
    let list = scene.list();
    assert_eq!(list["entries"].as_array().map(Vec::len), Some(1));
    assert_eq!(list["entries"][0]["id"], "works");
}

/// Megabytes of entries, each of them right: refused whole where they are too long or too many, and where the last of them is wrong, by its name and field.
#[test]
fn megabytes_of_entries_are_refused_whole() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    let before = scene.list();
    let document = |entries: usize, text: usize, last: &str| {
        let text = "cable works ".repeat(text);
        let all = (0..entries).map(|i| {
            let road = if i + 1 == entries { last } else { "1" };
            // Beside each other: only so many are taken at one place.
            let (from, to) = (5.0 + 0.5 * (i % 100) as f64, 5.4 + 0.5 * (i % 100) as f64);
            format!(
                r#"{{"id":"entry {i}","kind":"closed","text":"{text}","lanes":[{{"road":"{road}","s":[{from},{to}],"lane":-1}}]}}"#
            )
        });
        format!(r#"{{"entries":[{}]}}"#, all.collect::<Vec<_>>().join(","))
    };
    let file = scene.folder.path().join("many.json");
    let refused = |document: &str, words: &[&str]| {
        fs::write(&file, document).expect("written");
        let said = scene.ends(&["apply", file.to_str().expect("a name")], "", 2);
        assert!(words.iter().all(|words| said.contains(words)), "{said}");
        assert_eq!(scene.list(), before);
    };
    // Few long ones, and many short ones.
    for (entries, text) in [(9_000, 90), (100_000, 1)] {
        let long = document(entries, text, "1");
        assert!(long.len() > 10_000_000, "{}", long.len());
        let found = format!("{} bytes", long.len());
        refused(&long, &[&found, "at most 5242880", "--overlay-bytes"]);
        // The daemon itself, whoever sends them.
        let (feed, unread, ended) = (None, Vec::new(), Vec::new());
        let action = OverlayAction::Apply { document: long, feed, unread, ended, signature: None };
        let request = Request::Overlay { map: "town".to_owned(), action };
        let reason = match scene.place.ask("town", &request) {
            Some(Response::Wrong { reason }) => reason,
            other => panic!("{other:?}"),
        };
        let at_most = "at most 4194304 are taken (--overlay-bytes)";
        assert!(reason.contains(&found) && reason.contains(at_most), "{reason}");
        assert_eq!(scene.list(), before);
    }
    let many = document(10_001, 1, "1");
    refused(&many, &["10001 entries; at most 10000 are taken (--overlay-entries)"]);
    let wrong = document(9_999, 24, "99999");
    assert!(wrong.len() > 3_500_000 && wrong.len() < 4 << 20, "{}", wrong.len());
    refused(&wrong, &["entry \"entry 9998\", lanes[0].road", "no road \"99999\""]);
}

/// What cannot be, on its own or on this map, beside an entry that is right.
#[test]
fn each_fault_is_named_by_entry_and_field() {
    let scene = Scene::new();
    let _daemon = scene.place.serve(&scene.args());
    scene.ends(&["apply", "-"], &closed("works", -1), 0);
    let before = scene.list();
    let refused = |what: &str, with: &str, words: &[&str]| {
        let wrong = closed("wrong", -1).replace(what, with);
        assert_ne!(wrong, closed("wrong", -1));
        let own = wrong.strip_prefix(r#"{"entries":["#).expect("an entry");
        let both = closed("right", 1).strip_suffix("]}").expect("an entry").to_owned() + "," + own;
        let said = scene.ends(&["apply", "-"], &both, 2);
        assert!(words.iter().all(|words| said.contains(words)), "{said}");
        assert!(said.contains("nothing is changed"), "{said}");
        assert_eq!(scene.list(), before);
    };
    // The entries alone, as serde takes a document's fields in their order.
    for entries in ["[]", " [[]]", &format!("[{}]", closed("own", 1))] {
        let said = scene.ends(&["apply", "-"], entries, 2);
        let words = "expected an object with the field `entries`, found an array";
        assert!(said.contains(words), "{said}");
        assert_eq!(scene.list(), before);
    }
    let kind = r#""kind":"closed""#;
    refused(r#""lane":-1"#, r#""lane":-9"#, &["\"wrong\", lanes[0].lane", "no lane -9"]);
    refused("[10,20]", "[10,2000]", &["\"wrong\", lanes[0].s", "reaches from 0 m to 76 m"]);
    refused("[10,20]", "[20,10]", &["\"wrong\" (number 1), lanes[0].s"]);
    refused("[10,20]", r#""all""#, &["entries[1].lanes[0].s"]);
    refused(kind, r#""kind":"closed","from":20,"until":10"#, &["\"wrong\" (number 1), until"]);
    refused(kind, r#""kind":5"#, &["entries[1].kind"]);
    refused(kind, r#""kind":"speed","value":"fast""#, &["entries[1].value"]);
    refused(kind, r#""kind":"closed","colour":"red""#, &["entries[1].colour"]);
    refused(r#""id":"wrong""#, r#""id":"right""#, &["\"right\" (number 1), id", "another entry"]);
}

/// Limits are options of the daemon.
#[test]
fn limits_are_options() {
    let scene = Scene::new();
    let options = ["--overlay-entries", "2", "--overlay-bytes", "1KiB"];
    let _daemon = scene.place.serve(&[&scene.args()[..], &options].concat());
    for id in ["a", "b"] {
        scene.ends(&["apply", "-"], &closed(id, -1), 0);
    }
    let before = scene.list();
    let said = scene.ends(&["apply", "-"], &closed("c", -1), 2);
    assert!(said.contains("3 entries; at most 2 are taken (--overlay-entries)"), "{said}");
    let text = format!(r#""text":"{}","kind""#, "x".repeat(1024));
    let said = scene.ends(&["apply", "-"], &closed("b", -1).replace(r#""kind""#, &text), 2);
    assert!(said.contains("at most 1024 are taken (--overlay-bytes)"), "{said}");
    assert_eq!(scene.list(), before);
    scene.ends(&["apply", "-"], &closed("b", 1), 0);
}
