//! `mapd export --format html`: one page, whole, that lets nothing in and nothing out.

use ct_codecs::{Base64, Decoder, Encoder};
use mapd_client::Snapshot;
use mapd_tests::maps::{Random, carried_and, open, open_text};
use mapd_tests::overlays::over;
use mapd_tests::town::town;
use mapd_web::page::{Content, Findings};
use mapd_web::{Kind, Layer, Link, Paint, Question};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::io::Read;
use std::path::Path;
use std::process::Command;
use std::time::UNIX_EPOCH;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Things of each kind that are asked about, and places.
const QUESTIONS: u32 = 40;

/// What names may hold, and what none may become.
const HOSTILE: &str = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&<!--";

fn page(map: &Path) -> String {
    let mut command = Command::new(MAPD);
    let output = command.arg("export").arg(map).args(["--format", "html"]).output().expect("runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// What lies between the tags of the only element that begins so.
fn within<'a>(page: &'a str, tag: &str, end: &str) -> &'a str {
    assert_eq!(page.matches(tag).count(), 1, "{tag}");
    let (_, rest) = page.split_once(tag).expect("the element");
    rest.split_once(end).expect("its end").0
}

fn unpacked(page: &str, id: &str) -> Vec<u8> {
    let tag = format!("<script type=\"application/octet-stream\" id=\"{id}\">");
    let packed = Base64::decode_to_vec(within(page, &tag, "</script>"), None).expect("base64");
    let mut bytes = Vec::new();
    flate2::read::GzDecoder::new(&packed[..]).read_to_end(&mut bytes).expect("gzip");
    bytes
}

#[test]
fn the_page_holds_the_archive_and_allows_only_what_it_brings() {
    for path in carried_and(&["esmini/soderleden"]) {
        let page = page(&path);
        assert_eq!(unpacked(&page, "archive"), open(&path).bytes(), "{}", path.display());
        assert_eq!(&unpacked(&page, "module")[..4], b"\0asm");
        let hash = |text: &str| {
            let hash = Base64::encode_to_string(Sha256::digest(text)).expect("room");
            format!("-src 'sha256-{hash}'")
        };
        let policy = within(&page, "http-equiv=\"Content-Security-Policy\" content=\"", "\">");
        assert!(policy.starts_with("default-src 'none'; "), "{policy}");
        assert!(!policy.contains("connect-src"), "{policy}");
        assert!(policy.contains(&hash(within(&page, "<script>", "</script>"))), "{policy}");
        assert!(policy.contains(&hash(within(&page, "<style>", "</style>"))), "{policy}");
        for outside in ["http:", "https:", "//cdn", "innerHTML", "document.write"] {
            assert!(!page.contains(outside), "{outside}");
        }
    }
}

#[test]
fn a_title_is_no_markup() {
    let folder = tempfile::tempdir().expect("a folder");
    // What a file may be called: everything but a slash.
    let file = folder.path().join(format!("{}.xodr", HOSTILE.replace('/', "")));
    std::fs::copy(mapd_tests::carried("one_road.xodr"), &file).expect("copied");
    let page = page(&file);
    let title = within(&page, "<title>", "</title>");
    assert!(title.contains("&lt;script&gt;alert(1)") && !title.contains('<'), "{title}");
}

/// Names come to the page as JSON, which it sets as text.
#[test]
fn hostile_names_are_text() {
    let escaped = HOSTILE.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let text = std::fs::read_to_string(mapd_tests::carried("one_road.xodr")).expect("a map");
    let renamed = text.replacen("<road name=\"", &format!("<road name=\"{escaped}"), 1);
    assert_ne!(renamed, text, "the map's first road has a name");
    let snapshot = open_text(&renamed);
    let answer = Question::Find("script").answer(snapshot.view(UNIX_EPOCH)).json;
    let found: serde_json::Value = serde_json::from_str(&answer).expect("JSON");
    assert!(found[0]["text"].as_str().expect("text").contains(HOSTILE), "{answer}");
}

/// What is laid over the map is in the page, drawn, and said of lanes, signals and ways.
#[test]
fn what_is_laid_over_the_map_is_shown() {
    let snapshot = over_the_town();
    let mut page = Vec::new();
    let content = Content::Archive {
        map: snapshot.bytes(),
        overlay: snapshot.overlay_bytes(),
        findings: &Findings::UNKNOWN,
    };
    mapd_web::page::write(content, "town", &mut page).expect("written");
    let page = String::from_utf8(page).expect("UTF-8");
    assert_eq!(unpacked(&page, "overlay"), snapshot.overlay_bytes());
    let bare = snapshot_of_town();
    for (snapshot, is_over) in [(&snapshot, true), (&bare, false)] {
        let view = snapshot.view(UNIX_EPOCH);
        let map = view.map();
        let drawing = Layer::Today.draw(view);
        let paints: BTreeSet<u32> = drawing.corners.iter().map(|c| c.paint & 255).collect();
        let expected = [Paint::Closed, Paint::Slower, Paint::Told].map(|paint| paint as u32);
        assert_eq!(paints, expected.into_iter().filter(|_| is_over).collect());
        let lane = map.road_by_id("1").and_then(|road| road.section(0)?.lane(-1)).expect("a lane");
        let row = lane.lane_id().row();
        let sheet = Question::Sheet(Link { kind: Kind::Lane, row }).answer(view).json;
        assert_eq!(
            sheet.contains("works: closed, “cable”, from “city”, s 30.00 … 40.00 m"),
            is_over
        );
        let at = |s: f64| lane.pose_at(s, 0.0).expect("a place").position.truncate().to_array();
        let way = Question::Way(at(5.0), at(15.0)).answer(view).json;
        assert_eq!(way.contains("wet: wet"), is_over, "{way}");
        let through = Question::Way(at(5.0), at(60.0)).answer(view).json;
        assert_eq!(through.contains("no way for a passenger car"), is_over, "{through}");
    }
}

/// The town with a stretch of road 1 closed, one wet, and road 2 slower.
fn over_the_town() -> Snapshot {
    let snapshot = snapshot_of_town();
    let lanes = |s: &str| format!(r#""lanes":[{{"road":"1","s":{s},"lane":-1}}]"#);
    let (closed, wet) = (lanes("[30,40]"), lanes("[8,12]"));
    let text = format!(
        r#"{{"entries":[{{"id":"works","kind":"closed","source":"city","text":"cable",{closed}}},{{"id":"wet","kind":"wet",{wet}}},
        {{"id":"slow","kind":"speed","value":2,"lanes":[{{"road":"2"}}]}}]}}"#
    );
    let (bytes, _) = over(snapshot.map(), &text, false);
    snapshot.with_overlay(bytes).expect("its own")
}

fn snapshot_of_town() -> Snapshot {
    open_text(&town(3, 3))
}

/// Every question has an answer that is JSON, whatever is asked; what is drawn lies within the map.
#[test]
fn whatever_is_asked_is_answered() {
    for path in carried_and(&["esmini/soderleden"]) {
        let snapshot = open(&path);
        let (view, mut random) = (snapshot.view(UNIX_EPOCH), Random(7));
        let map = view.map();
        let mut questions =
            vec![Question::Map, Question::LeftOut, Question::Find("1"), Question::Find("")];
        for row in 0..QUESTIONS {
            questions
                .extend(Kind::ALL.iter().map(|kind| Question::Sheet(Link { kind: *kind, row })));
            let (from, to) = (random.point(map).to_array(), random.point(map).to_array());
            questions.extend([
                Question::Place(from),
                Question::Pick(from, 1.0),
                Question::Way(from, to),
            ]);
        }
        questions
            .extend([Question::Place([f64::NAN, 0.0]), Question::Pick([0.0; 2], f64::INFINITY)]);
        for question in questions {
            let answer = question.answer(view).json;
            let read: Result<serde_json::Value, _> = serde_json::from_str(&answer);
            assert!(read.is_ok(), "{question:?}: {answer}");
        }
        for layer in Layer::ALL {
            let drawing = layer.draw(view);
            let corners = drawing.corners.len() as u32;
            assert!(drawing.triangles.iter().all(|corner| *corner < corners), "{layer:?}");
            let strokes: u32 = drawing.chunks.iter().map(|chunk| chunk.strokes[1]).sum();
            let triangles: u32 = drawing.chunks.iter().map(|chunk| chunk.triangles[1]).sum();
            assert_eq!(strokes as usize, drawing.strokes.len(), "{layer:?}");
            assert_eq!(triangles as usize, drawing.triangles.len(), "{layer:?}");
        }
    }
}
