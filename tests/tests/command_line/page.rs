//! `mapd export --format html`: one page, whole, that lets nothing in and nothing out.

use ct_codecs::{Base64, Decoder, Encoder};
use mapd_tests::maps::{Random, carried_and, open, open_text};
use mapd_web::{Kind, Layer, Link, Question};
use sha2::{Digest, Sha256};
use std::io::Read;
use std::path::Path;
use std::process::Command;

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
    let answer = Question::Find("script").answer(snapshot.map()).json;
    let found: serde_json::Value = serde_json::from_str(&answer).expect("JSON");
    assert!(found[0]["text"].as_str().expect("text").contains(HOSTILE), "{answer}");
}

/// Every question has an answer that is JSON, whatever is asked; what is drawn lies within the map.
#[test]
fn whatever_is_asked_is_answered() {
    for path in carried_and(&["esmini/soderleden"]) {
        let snapshot = open(&path);
        let (map, mut random) = (snapshot.map(), Random(7));
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
            let answer = question.answer(map).json;
            let read: Result<serde_json::Value, _> = serde_json::from_str(&answer);
            assert!(read.is_ok(), "{question:?}: {answer}");
        }
        for layer in Layer::ALL {
            let drawing = layer.draw(map);
            let corners = drawing.corners.len() as u32;
            assert!(drawing.triangles.iter().all(|corner| *corner < corners), "{layer:?}");
            let strokes: u32 = drawing.chunks.iter().map(|chunk| chunk.strokes[1]).sum();
            let triangles: u32 = drawing.chunks.iter().map(|chunk| chunk.triangles[1]).sum();
            assert_eq!(strokes as usize, drawing.strokes.len(), "{layer:?}");
            assert_eq!(triangles as usize, drawing.triangles.len(), "{layer:?}");
        }
    }
}
