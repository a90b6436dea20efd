//! The page of `mapd export --format html` in a browser: what it draws, says and answers. Needs Chromium, with which `.ci/run page`
//! runs it.

use mapd_client::{Lane, Map, Road, Snapshot};
use mapd_tests::browser::Browser;
use mapd_tests::damage::seal_header;
use mapd_tests::maps::{Random, carried_and, open, open_text};
use mapd_tests::object_maps::{PLAIN, document};
use mapd_tests::overlays::over;
use mapd_web::page::Content;
use mapd_web::{Kind, Layer, Link, Question};
use serde_json::{Value, json};
use std::time::UNIX_EPOCH;

/// Size of the page.
const SIZE: (u32, u32) = (1000, 700);
/// Places that are asked about in each map, once for each kind of question about places.
const PLACES: usize = 700;
/// Of these, pairs between which a way is looked for.
const WAYS: usize = 60;
/// Things of each kind whose sheets are compared.
const SHEETS: u32 = 60;
/// Share by which the area that is seen may differ from the lanes' own: what overlaps counts once, edges are pixels.
const AREA: f64 = 0.1;

/// Where in an archive's header its format begins.
const FORMAT_AT: usize = 12;

/// A browser with the page of a map; none, said aloud, where there is no browser.
fn browser(map: &Snapshot) -> Option<Browser> {
    let Some(mut browser) = Browser::start(SIZE) else {
        mapd_tests::say("SKIPPED: there is no Chromium");
        return None;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.html");
    let mut page = std::fs::File::create(&file).expect("a file");
    let content = Content::Archive { map: map.bytes(), overlay: map.overlay_bytes() };
    mapd_web::page::write(content, "map", &mut page).expect("written");
    browser.open(&file, "globalThis.viewer?.ready || document.querySelector('#message')?.textContent.includes('cannot')");
    assert_eq!(browser.evaluate("document.querySelector('#message').textContent"), json!(""));
    Some(browser)
}

/// The same map with some of its roads closed, slower, and told of.
fn under_works(snapshot: Snapshot) -> Snapshot {
    let what =
        [r#""kind":"closed""#, r#""kind":"speed","value":1"#, r#""kind":"wet","text":"<b>""#];
    let entry = |(i, road): (usize, Road<'_>)| {
        let (what, id) = (what[i % what.len()], json!(road.id()));
        format!(r#"{{"id":"{i}",{what},"lanes":[{{"road":{id}}}]}}"#)
    };
    let roads = snapshot.map().roads().step_by(7).enumerate();
    let text = format!(r#"{{"entries":[{}]}}"#, roads.map(entry).collect::<Vec<_>>().join(","));
    let (bytes, _) = over(snapshot.map(), &text, true);
    snapshot.with_overlay(bytes).expect("its own")
}

fn questions(map: Map<'_>) -> Vec<Question<'static>> {
    let mut random = Random(11);
    let mut questions = vec![Question::LeftOut, Question::Find("1"), Question::Find("Straße <b>")];
    for i in 0..PLACES {
        let (from, to) = (random.point(map).to_array(), random.point(map).to_array());
        questions.extend([Question::Place(from), Question::Pick(from, 2.0)]);
        let projector = map.projector().ok();
        let place = projector.and_then(|one| one.to_geodetic([from[0], from[1], 0.0].into()).ok());
        questions.extend(place.map(|place| Question::Geodetic([place.latitude, place.longitude])));
        if i < WAYS {
            questions.push(Question::Way(from, to));
        }
    }
    for row in 0..SHEETS {
        questions.extend(
            Kind::ALL.iter().map(|kind| Question::Sheet(Link { kind: *kind, row: 7 * row })),
        );
    }
    questions
}

/// The question as the page asks it: the module's function and its numbers.
fn asked(question: &Question<'_>) -> Value {
    match question {
        Question::Place([x, y]) => json!(["place", x, y]),
        Question::Geodetic([latitude, longitude]) => json!(["geodetic", latitude, longitude]),
        Question::Pick([x, y], radius) => json!(["pick", x, y, radius]),
        Question::Way([a, b], [c, d]) => json!(["way", a, b, c, d]),
        Question::Sheet(link) => json!(["sheet", link.kind as usize, link.row]),
        Question::Find(text) => json!(["find", text]),
        Question::LeftOut => json!(["left_out"]),
        Question::Map => json!([]),
    }
}

/// Maps whose frame proj4rs alone computes, which a page does not have: it names no latitudes and longitudes there.
const ONLY_BY_PROJ4RS: [&str; 1] = ["soderleden.xodr"];

/// An answer without latitudes and longitudes.
fn without_geodetic(answer: &str) -> String {
    const NAME: &str = r#""geodetic":["#;
    let Some((before, rest)) = answer.split_once(NAME) else { return answer.to_owned() };
    let (_, after) = rest.split_once(']').expect("a list");
    format!(r#"{before}"geodetic":null{after}"#)
}

/// Asks all at once.
const ASK: &str = "(questions => questions.map(([name, ...of]) => {
    const { queries } = viewer;
    queries.module[name](...of.map(one => typeof one === 'string' ? queries.put(new TextEncoder().encode(one)) : one));
    return queries.text();
}))";

/// The same answers as the native build, to the last bit: numbers are written so that they are read back exactly.
#[test]
fn the_page_answers_as_the_native_build() {
    for path in carried_and(&["carla/Town05", "esmini/soderleden"]) {
        let snapshot = under_works(open(&path));
        let Some(mut browser) = browser(&snapshot) else { return };
        let mut questions = questions(snapshot.map());
        let is_excepted = ONLY_BY_PROJ4RS.iter().any(|name| path.ends_with(name));
        questions.retain(|question| !is_excepted || !matches!(question, Question::Geodetic(_)));
        let list = Value::from(questions.iter().map(asked).collect::<Vec<_>>());
        let answers = browser.evaluate(&format!("{ASK}({list})"));
        let answers = answers.as_array().expect("answers");
        assert_eq!(answers.len(), questions.len());
        for (question, answer) in questions.iter().zip(answers) {
            let mut expected = question.answer(snapshot.view(UNIX_EPOCH)).json;
            if is_excepted {
                expected = without_geodetic(&expected);
            }
            assert_eq!(
                answer.as_str(),
                Some(expected.as_str()),
                "{question:?} of {}",
                path.display()
            );
        }
        assert_eq!(browser.complaints, [""; 0], "{}", path.display());
    }
}

/// Pixels that differ from the background with only these layers shown.
fn painted(browser: &mut Browser, layers: &[&str]) -> f64 {
    let shown = json!(layers);
    let painted =
        format!("viewer.shown = new Set({shown}); viewer.paint(); viewer.painter.painted()");
    browser.evaluate(&painted).as_f64().expect("a number")
}

/// Each layer that has something is seen, one that has nothing is not; lanes cover as many pixels as they have area.
#[test]
fn every_layer_is_seen() {
    for path in carried_and(&["esmini/soderleden"]) {
        let snapshot = under_works(open(&path));
        let Some(mut browser) = browser(&snapshot) else { return };
        let names = browser.evaluate("LAYERS");
        for (layer, name) in Layer::ALL.iter().zip(names.as_array().expect("names")) {
            let drawing = layer.draw(snapshot.view(UNIX_EPOCH));
            // So near that each layer is drawn.
            let corner = drawing.corners.first().map(|corner| corner.place);
            if let Some([x, y]) = drawing.strokes.first().map(|stroke| stroke.from).or(corner) {
                let fit = format!("viewer.show([{x} - 20, {y} - 20, {x} + 20, {y} + 20])");
                browser.evaluate(&fit);
            }
            let is_there = !drawing.triangles.is_empty() || !drawing.strokes.is_empty();
            let count = painted(&mut browser, &[name.as_str().expect("a name")]);
            assert_eq!(count > 0.0, is_there, "{layer:?} of {}: {count} pixels", path.display());
        }
        assert_eq!(browser.complaints, [""; 0]);
    }
}

#[test]
fn lanes_cover_their_area() {
    let snapshot = open(&mapd_tests::carried("one_road.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    browser.evaluate("viewer.fit()");
    let scale = browser.evaluate("viewer.camera.scale").as_f64().expect("a number");
    let area: f64 = snapshot
        .map()
        .lanes()
        .map(|lane| {
            let (from, to) = (lane.section().s_start(), lane.section().s_end());
            lane.length_between(from, to) * lane.width_at(0.5 * (from + to))
        })
        .sum();
    let count = painted(&mut browser, &["lanes"]);
    let expected = area * scale * scale;
    assert!((count / expected - 1.0).abs() < AREA, "{count} pixels, expected {expected}");
}

/// While the map moves, what is seen is what was drawn, moved; in the end it is the picture that is drawn at once.
#[test]
fn a_picture_in_pieces_is_the_picture() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    let sum = "(() => { const { gl, canvas } = viewer.painter, all = new Uint8Array(4 * canvas.width * canvas.height);
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
        let sum = 0;
        for (const value of all) sum = (Math.imul(sum, 31) + value) | 0;
        return sum; })()";
    let moves = "viewer.fit(); viewer.paint(); viewer.camera.x += 40 / viewer.camera.scale; ";
    let pieces =
        format!("{moves} let frames = 1; while (viewer.paint(false)) frames++; [frames, {sum}]");
    let pieces = browser
        .evaluate(&format!("(() => {{ {} }})()", pieces.replace("[frames", "return [frames")));
    assert!(pieces[0].as_u64() >= Some(1), "{pieces}");
    let whole = browser.evaluate(&format!(
        "(() => {{ viewer.painter.changes++; viewer.paint(); return {sum}; }})()"
    ));
    assert_eq!(pieces[1], whole);
    let shift = "(() => { const { painter } = viewer, { view } = painter.frames.front;
        painter.frames.present({ ...view, x: 1e9 }, painter.back);
        return painter.painted(); })()";
    assert_eq!(browser.evaluate(shift), json!(0), "what is far away is not seen");
    assert_eq!(browser.complaints, [""; 0]);
}

/// A browser takes the graphics card from pages in the background: until it is back, clicks say what they say, then all is drawn as before. A layer that no
/// graphics card can hold is an error, before memory is taken for it.
#[test]
fn a_lost_graphics_card_is_no_loss() {
    let snapshot = under_works(open(&mapd_tests::carried("town.xodr")));
    let Some(mut browser) = browser(&snapshot) else { return };
    let script = "new Promise(done => {
        const { painter } = viewer, { gl, canvas } = painter, taken = gl.getExtension('WEBGL_lose_context');
        const next = name => new Promise(then => canvas.addEventListener(name, () => setTimeout(then), { once: true }));
        const look = () => {
            painter.changes++;
            viewer.paint();
            const all = new Uint8Array(4 * canvas.width * canvas.height);
            gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
            return all.reduce((sum, value) => (Math.imul(sum, 31) + value) | 0, 0);
        };
        const titled = link => { viewer.choose(link); return document.querySelector('#panel h1').textContent; };
        (async () => {
            const link = { kind: 'road', row: 0 }, said = [];
            viewer.fit();
            // Whether edges are smooth depends on how fast the first pictures are.
            painter.frames.samples = 0;
            const empty = look();
            said.push(titled(link));
            const before = look(), lost = next('webglcontextlost');
            taken.loseContext();
            await lost;
            viewer.clear();
            viewer.today();
            viewer.paint();
            said.push(titled(link));
            const restored = next('webglcontextrestored');
            taken.restoreContext();
            await restored;
            const after = look();
            painter.most = 1;
            painter.table(new Float32Array(9 * painter.row));
            let refused = false;
            try { painter.table(new Float32Array(9 * (painter.row + 1))); } catch { refused = true; }
            done([said[0] === said[1], before === after, before !== empty, refused]);
        })();
    })";
    assert_eq!(browser.evaluate(script), json!([true, true, true, true]));
    assert_eq!(browser.complaints, [""; 0]);
}

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

/// The whole picture as one number, and how many of its pixels are much more red than green.
const LOOK: &str = "(() => { viewer.painter.changes++; viewer.paint();
    const { gl, canvas } = viewer.painter, all = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    let sum = 0, red = 0;
    for (const value of all) sum = (Math.imul(sum, 31) + value) | 0;
    for (let i = 0; i < all.length; i += 4) red += all[i] > all[i + 1] + 60 && all[i] > all[i + 2] + 60;
    return [sum, red]; })()";

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
        let rows = "[...document.querySelectorAll('#panel tbody tr')].map(row => [...row.children].map(cell => cell.textContent))";
        let expected = map.quarantined().map(|part| {
            let at = part.source_position();
            let name = format!("{} {}", part.kind().name(), part.id());
            json!([name, part.rule(), part.message(), format!("{}:{}", at.line, at.column)])
        });
        assert_eq!(browser.evaluate(rows), Value::from(expected.collect::<Vec<_>>()));
        for (part, row) in map.quarantined().zip(0..) {
            // From far away, so that the link has somewhere to lead.
            browser.evaluate("[viewer.camera.x, viewer.camera.y] = [5000, 5000]");
            browser.evaluate(&format!("document.querySelectorAll('#panel td a')[{row}].click()"));
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
        }
        assert_eq!(browser.complaints, [""; 0]);
    }
}

/// An archive of another release is not shown, and the page says why.
#[test]
fn an_archive_of_another_format_is_refused_with_a_reason() {
    let snapshot = open(&mapd_tests::carried("one_road.xodr"));
    let mut bytes = snapshot.bytes().to_vec();
    bytes[FORMAT_AT] ^= 0xff;
    seal_header(&mut bytes);
    let Some(mut browser) = Browser::start(SIZE) else {
        mapd_tests::say("SKIPPED: there is no Chromium");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.html");
    let mut page = std::fs::File::create(&file).expect("a file");
    let content = Content::Archive { map: &bytes, overlay: &[] };
    mapd_web::page::write(content, "map", &mut page).expect("written");
    let message = "document.querySelector('#message')?.textContent";
    browser.open(&file, &format!("{message}?.includes('cannot')"));
    let said = browser.evaluate(message);
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
        json!(["map", 0, 5])
    );
    assert_eq!(browser.complaints, [""; 0]);
}
