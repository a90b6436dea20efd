//! What the page does when it is clicked, asked by keys, or given what it must not trust.

use crate::{LOOK, MESSAGE, any_browser, browser, show};
use mapd_client::Lane;
use mapd_tests::browser::Browser;
use mapd_tests::damage::seal_header;
use mapd_tests::maps::{open, open_text};
use mapd_tests::object_maps::{PLAIN, document};
use mapd_web::page::{Content, Findings};
use serde_json::{Value, json};

/// Where in an archive's header its format begins.
const FORMAT_AT: usize = 12;

/// A click on a lane's middle opens its sheet; two clicks in the other mode find a way; keys work; the address leads back.
#[test]
fn clicks_and_keys_do_what_they_say() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    let is_plain = |lane: &Lane<'_>| lane.kind().is_drivable() && lane.road().junction().is_none();
    let lane = snapshot.map().lanes().find(is_plain).expect("a lane");
    let place = |share: f64| {
        let (from, to) = (lane.section().s_start(), lane.section().s_end());
        let share = if lane.is_forward() { share } else { 1.0 - share };
        let at = lane.pose_at(from + share * (to - from), 0.0).expect("a place").position;
        [at.x, at.y]
    };
    let click = |browser: &mut Browser, [x, y]: [f64; 2]| {
        let page = browser.evaluate(&format!("viewer.camera.toPage(...viewer.near({x}, {y}))"));
        let [x, y] = [0, 1].map(|i| page[i].as_f64().expect("a number"));
        browser.click(x, y);
        // Pixels are whole: what the page was told is what counts.
        browser.evaluate(&format!("viewer.far(viewer.camera.toGround({x}, {y}))"))
    };
    let title = "document.querySelector('#panel h1')?.textContent ?? null";
    let key = lane.key().to_string();
    click(&mut browser, place(0.4));
    assert_eq!(browser.evaluate(title), json!(format!("Lane {key}")));
    browser.evaluate("viewer.writeAddress()");
    let address = browser.evaluate("location.hash");
    assert!(address.as_str().is_some_and(|address| address.contains("lane=")), "{address}");
    browser.key("Escape");
    assert_eq!(browser.evaluate(title), Value::Null);
    browser.key("r");
    click(&mut browser, place(0.3));
    click(&mut browser, place(0.7));
    let shown = browser.evaluate(title).to_string();
    let length = 0.4 * (lane.section().s_end() - lane.section().s_start());
    let said = shown.trim_start_matches("\"Route ").split(' ').next().and_then(|n| n.parse().ok());
    // A pixel is less than a metre.
    assert!(said.is_some_and(|said: f64| (said - length).abs() < 1.0), "{shown}, not {length} m");
    browser.key("Escape");
    browser.evaluate("viewer.writeAddress()");
    // What the page itself still has to write comes not in between.
    browser.evaluate(&format!("clearTimeout(viewer.writing); location.hash = {address}"));
    let then = format!(
        "new Promise(done => {{ const look = () => {title} ? done({title}) : setTimeout(look, 20); look(); }})"
    );
    assert_eq!(browser.evaluate(&then), json!(format!("Lane {key}")));
    assert_eq!(browser.complaints, [""; 0]);
}

/// A part that is left out is a red box; the list says which, why and where in the file, and leads to it.
#[test]
fn parts_that_are_left_out_are_listed_and_red() {
    let tree = |id: &str, s: u32, radius: &str| {
        format!(
            r#"<object id="{id}" type="tree" s="{s}" t="9" zOffset="0" radius="{radius}" height="3" orientation="none"/>"#
        )
    };
    let sound = tree("1", 30, "1") + &tree("2", 40, "1");
    let broken = sound.clone() + &tree("broken", 50, "round");
    for (objects, count) in [(sound, 0), (broken, 1)] {
        // From a file, which is read again where something is left out.
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("map.xodr");
        std::fs::write(&file, document(&PLAIN, &objects)).expect("written");
        let snapshot = open(&file);
        let map = snapshot.map();
        assert_eq!(map.quarantined().len(), count);
        let Some(mut browser) = browser(&snapshot) else { return };
        let red = browser.evaluate(LOOK)[1].as_u64().expect("a number");
        assert_eq!(red > 0, count > 0, "{red} red pixels");
        browser.key("f");
        let rows = "[...document.querySelectorAll('#list tbody tr')].map(row => [...row.children].map(cell => cell.textContent))";
        let expected = map.quarantined().map(|part| {
            let at = part.source_position();
            let name = format!("{} {}", part.kind().name(), part.id());
            json!([name, part.rule(), part.message(), format!("{}:{}", at.line, at.column)])
        });
        assert_eq!(browser.evaluate(rows), Value::from(expected.collect::<Vec<_>>()));
        for (part, row) in map.quarantined().zip(0..) {
            // From far away, so that the link has somewhere to lead.
            browser.evaluate("[viewer.camera.x, viewer.camera.y] = [5000, 5000]");
            browser.evaluate(&format!("document.querySelectorAll('#list td a')[{row}].click()"));
            let title = browser.evaluate("document.querySelector('#panel h1').textContent");
            assert!(title.as_str().is_some_and(|title| title.contains(part.id())), "{title}");
            let seen = browser.evaluate(
                "(() => { const [a, b, c, d] = viewer.camera.bounds();
                return [...viewer.far([a, b]), ...viewer.far([c, d])]; })()",
            );
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| seen[i].as_f64().expect("a number"));
            let extent = part.extent().expect("a place");
            assert!(a <= extent.low.x && b <= extent.low.y, "{seen}, not {extent:?}");
            assert!(extent.high.x <= c && extent.high.y <= d, "{seen}, not {extent:?}");
            // Beside its sheet the list stays, with its row marked.
            let marked = "[...document.querySelectorAll('#list tbody tr')].findIndex(row => row.ariaCurrent)";
            assert_eq!(browser.evaluate(marked), json!(row));
            assert!(!overlap(&mut browser, "panel", "list"));
        }
        assert_eq!(browser.complaints, [""; 0]);
    }
}

/// Whether two panes cover each other, both of which must be there.
fn overlap(browser: &mut Browser, one: &str, other: &str) -> bool {
    let overlap = format!(
        "(() => {{ const [a, b] = ['{one}', '{other}'].map(id => document.getElementById(id).getBoundingClientRect());
        if (!a.width || !b.width) throw new Error('a pane is closed');
        return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom; }})()"
    );
    browser.evaluate(&overlap).as_bool().expect("yes or no")
}

/// The list, the sheet and the layers lie beside each other, what is followed beside all of them; Esc closes the sheet first, then the list.
#[test]
fn the_list_and_the_sheet_have_panes_of_their_own() {
    let tree = |id: u32, s: u32| {
        format!(
            r#"<object id="{id}" type="tree" s="{s}" t="9" zOffset="0" radius="round" height="3" orientation="none"/>"#
        )
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.xodr");
    let trees = (0..20).map(|i| tree(i, 2 + 4 * i)).collect::<String>();
    std::fs::write(&file, document(&PLAIN, &trees)).expect("written");
    let snapshot = open(&file);
    let Some(mut browser) = browser(&snapshot) else { return };
    let open = "['panel', 'list', 'layers'].filter(id => !document.getElementById(id).hidden)";
    for key in ["f", "l"] {
        browser.key(key);
    }
    assert_eq!(browser.evaluate(open), json!(["list", "layers"]));
    assert!(!overlap(&mut browser, "layers", "list"));
    browser.evaluate("document.querySelectorAll('#list td a')[19].click()");
    assert_eq!(browser.evaluate(open), json!(["panel", "list", "layers"]));
    for (one, other) in [("panel", "list"), ("layers", "list"), ("panel", "layers")] {
        assert!(!overlap(&mut browser, one, other), "{one} and {other}");
    }
    let beside = "(() => { const { bounds } = viewer.queries.sheet(viewer.chosen);
        const [a, b, c, d] = bounds, at = viewer.camera.toPage(...viewer.near((a + c) / 2, (b + d) / 2));
        return document.elementFromPoint(...at).id; })()";
    assert_eq!(browser.evaluate(beside), json!("map"));
    for left in [json!(["list", "layers"]), json!(["layers"]), json!([])] {
        browser.key("Escape");
        assert_eq!(browser.evaluate(open), left);
    }
    browser.key("l");
    // The same key opens and closes it; on a phone the sheet lies over the list, which is there again without it.
    for left in [json!(["list", "layers"]), json!(["layers"]), json!(["list", "layers"])] {
        browser.key("f");
        assert_eq!(browser.evaluate(open), left);
    }
    browser.become_phone((360, 640));
    browser.wait("viewer.camera.width === 360");
    browser.key("l");
    browser.evaluate("document.querySelectorAll('#list td a')[3].click()");
    let top = "document.elementFromPoint(180, 600).closest('.card').id";
    assert_eq!(browser.evaluate(top), json!("panel"));
    assert_eq!(browser.evaluate(beside), json!("map"));
    browser.key("Escape");
    assert_eq!(browser.evaluate(top), json!("list"));
    assert_eq!(browser.complaints, [""; 0]);
}

/// An archive of another release is not shown, and the page says why.
#[test]
fn an_archive_of_another_format_is_refused_with_a_reason() {
    let snapshot = open(&mapd_tests::carried("one_road.xodr"));
    let mut bytes = snapshot.bytes().to_vec();
    bytes[FORMAT_AT] ^= 0xff;
    seal_header(&mut bytes);
    let Some(mut browser) = any_browser() else { return };
    show(
        &mut browser,
        Content::Archive { map: &bytes, overlay: &[], findings: &Findings::UNKNOWN },
    );
    let said = browser.evaluate(MESSAGE);
    let said = said.as_str().expect("text");
    assert!(said.starts_with("The map cannot be shown: ") && said.contains("format"), "{said}");
    assert_eq!(browser.evaluate("globalThis.viewer === undefined"), json!(true));
    assert_eq!(browser.complaints, [""; 0]);
}

/// The pointer's place is said as the map has it; keys change the picture and change it back; two numbers are a place.
#[test]
fn the_pointer_keys_and_numbers_do_what_they_say() {
    let snapshot = open(&mapd_tests::carried("surfaces.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    let lane = snapshot.map().lanes().find(|lane| lane.kind().is_drivable()).expect("a lane");
    let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
    let place = lane.pose_at(s, 0.0).expect("a place").position;
    let number = |value: &Value| value.as_f64().expect("a number");
    let page = browser
        .evaluate(&format!("viewer.camera.toPage(...viewer.near({}, {}))", place.x, place.y));
    let [x, y] = [number(&page[0]).round(), number(&page[1]).round()];
    let event = json!({ "type": "mouseMoved", "x": x, "y": y, "button": "none" });
    browser.call("Input.dispatchMouseEvent", event);
    let ground = browser.evaluate(&format!("viewer.far(viewer.camera.toGround({x}, {y}))"));
    let [x, y] = [number(&ground[0]), number(&ground[1])];
    let here = browser.evaluate("document.querySelector('#here').textContent");
    let here = here.as_str().expect("text");
    for words in [
        format!("x {x:.2}   y {y:.2}   z "),
        format!("   lane {} ({})   s ", lane.key(), lane.kind().name()),
        "   t ".to_owned(),
    ] {
        assert!(here.contains(&words), "{here}, not {words}");
    }
    // On a busy machine a slow picture ends smooth edges: from the start, so that pictures can be compared.
    browser.evaluate("viewer.painter.frames.samples = 0");
    for key in ["h", "d"] {
        let before = browser.evaluate(LOOK)[0].clone();
        browser.key(key);
        assert_ne!(browser.evaluate(LOOK)[0], before, "{key}");
        browser.key(key);
        assert_eq!(browser.evaluate(LOOK)[0], before, "{key} twice");
    }
    let search = format!(
        "(() => {{ const text = document.querySelector('#text');
        text.value = '{x:.3} {y:.3}';
        text.dispatchEvent(new Event('input'));
        const found = document.querySelector('#found li').textContent;
        document.querySelector('#search').requestSubmit();
        return [found, viewer.far(viewer.labels.mark)]; }})()"
    );
    let answer = browser.evaluate(&search);
    assert_eq!(answer[0], json!(format!("place x {x:.3} m, y {y:.3} m")));
    let marked = [number(&answer[1][0]), number(&answer[1][1])];
    assert!((marked[0] - x).abs() < 1e-3 && (marked[1] - y).abs() < 1e-3, "{marked:?}");
    assert_eq!(browser.complaints, [""; 0]);
}

/// Names that would be markup are shown as they are.
#[test]
fn hostile_names_do_nothing() {
    let hostile = "</script><script>document.title='run'</script><img src=x onerror=\"document.title='run'\">'&<!--";
    let escaped = hostile.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let text = std::fs::read_to_string(mapd_tests::carried("one_road.xodr")).expect("a map");
    let text = text.replacen("<road name=\"", &format!("<road name=\"{escaped}"), 1);
    let snapshot = open_text(&text);
    let Some(mut browser) = browser(&snapshot) else { return };
    browser.evaluate("viewer.choose({ kind: 'road', row: 0 })");
    let panel = browser.evaluate("document.querySelector('#panel').textContent");
    assert!(panel.as_str().is_some_and(|text| text.contains(hostile)), "{panel}");
    browser.evaluate("document.querySelector('#text').value = 'script'; document.querySelector('#text').dispatchEvent(new Event('input'))");
    let found = browser.evaluate("document.querySelector('#found').textContent");
    assert!(found.as_str().is_some_and(|text| text.contains(hostile)), "{found}");
    assert_eq!(
        browser.evaluate("[document.title, document.images.length, document.scripts.length]"),
        json!(["map", 0, 6])
    );
    assert_eq!(browser.complaints, [""; 0]);
}

/// The address is that of the last change, also while a picture takes more than one frame.
#[test]
fn the_address_follows_while_a_picture_is_drawn() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    // A picture that never ends: each frame asks for another.
    browser.evaluate("viewer.paint = () => true; viewer.changed()");
    let address = "new Promise(done => { viewer.camera.zoom(2); const scale = `,${+viewer.camera.scale.toPrecision(4)},`;
        const look = () => location.hash.includes(scale) ? done(true) : setTimeout(look, 20); look(); setTimeout(() => done(false), 5000); })";
    assert_eq!(browser.evaluate(address), json!(true));
}
