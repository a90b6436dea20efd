//! Moving and measuring by keys and clicks, the place under the pointer, and how marks are painted.

use crate::browser;
use mapd_client::Track;
use mapd_client::glam::DVec2;
use mapd_client::localisation::MarkFilter;
use mapd_client::vocabulary::RoadMarkColor;
use mapd_tests::browser::Browser;
use mapd_tests::maps::{open, open_text};
use serde_json::{Value, json};

/// Where the camera is `[m]`, pixels a metre, its turn `[rad]`.
const CAMERA: &str = "[viewer.camera.x, viewer.camera.y, viewer.camera.scale, viewer.camera.turn]";

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let numbers = value.as_array().expect("a list").iter();
    let numbers: Vec<f64> = numbers.map(|one| one.as_f64().expect("a number")).collect();
    numbers.try_into().expect("so many numbers")
}

/// Each key does what the list of keys says, and nothing else to the camera.
#[test]
fn keys_move_zoom_and_turn() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    let camera = |browser: &mut Browser| numbers::<4>(&browser.evaluate(CAMERA));
    let whole = camera(&mut browser);
    for (key, change) in [
        ("+", [0.0, 0.0, 1.4, 0.0]),
        ("-", [0.0, 0.0, 1.0 / 1.4, 0.0]),
        ("ArrowLeft", [-60.0, 0.0, 1.0, 0.0]),
        ("ArrowRight", [60.0, 0.0, 1.0, 0.0]),
        ("ArrowUp", [0.0, 60.0, 1.0, 0.0]),
        ("ArrowDown", [0.0, -60.0, 1.0, 0.0]),
        (",", [0.0, 0.0, 1.0, 0.1]),
        (".", [0.0, 0.0, 1.0, -0.1]),
    ] {
        let before = camera(&mut browser);
        browser.key(key);
        let after = camera(&mut browser);
        let moved = [0, 1].map(|i| (after[i] - before[i]) * before[2]);
        let found = [moved[0], moved[1], after[2] / before[2], after[3] - before[3]];
        let is_near = found.iter().zip(change).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(is_near, "{key}: {found:?}, not {change:?}");
        browser.evaluate("viewer.camera.turn = 0; viewer.fit()");
        assert_eq!(camera(&mut browser), whole, "{key}");
    }
    for key in ["+", ",", "n"] {
        browser.key(key);
    }
    assert_eq!(camera(&mut browser)[3], 0.0);
    browser.key("0");
    assert_eq!(camera(&mut browser), whole);
    browser.key("?");
    assert_eq!(browser.evaluate("document.querySelector('#panel h1').textContent"), "Keys");
    browser.key("Escape");
    browser.key("/");
    assert_eq!(browser.evaluate("document.activeElement.id"), "text");
    // Buttons zoom as keys do.
    let scale = |browser: &mut Browser| {
        browser.evaluate("viewer.camera.scale").as_f64().unwrap_or_default()
    };
    let before = scale(&mut browser);
    browser.evaluate("document.querySelector('#zoom-in').click()");
    assert!((scale(&mut browser) / before - 1.4).abs() < 1e-9);
    browser.evaluate("document.querySelector('#zoom-out').click()");
    assert!((scale(&mut browser) / before - 1.0).abs() < 1e-9);
    browser.evaluate("document.querySelector('#help').click()");
    assert_eq!(browser.evaluate("document.querySelector('#panel h1').textContent"), "Keys");
    browser.key("Escape");
    browser.key("/");
    // In the search field letters are letters.
    browser.key("m");
    assert_eq!(browser.evaluate("viewer.mode"), "look");
    assert_eq!(browser.complaints, [""; 0]);
}

/// The place under the pointer on Earth is that of the map's projection, and what is measured is what lies between the clicks.
#[test]
fn places_on_earth_and_measures_are_right() {
    let snapshot = open(&mapd_tests::carried("one_road.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    let projector = snapshot.map().projector().expect("a georeference");
    browser.evaluate("viewer.texts = []; { const write = viewer.labels.text;
        viewer.labels.text = function (text, ...rest) { viewer.texts.push(text); write.call(this, text, ...rest); }; } 0");
    browser.key("m");
    let mut clicked: Vec<DVec2> = Vec::new();
    for [x, y] in [[300.0, 200.0], [500.0, 320.0], [640.0, 410.0]] {
        browser.click(x, y);
        let ground = format!("viewer.far(viewer.camera.toGround({x}, {y}))");
        let place = DVec2::from_array(numbers(&browser.evaluate(&ground)));
        clicked.push(place);
        let here = browser.evaluate("document.querySelector('#here').textContent");
        let here = here.as_str().expect("text").to_owned();
        let number = |before: &str, after: &str| {
            let rest = here.split_once(before).unwrap_or_else(|| panic!("{here}")).1;
            rest.split(after)
                .next()
                .and_then(|number| number.parse::<f64>().ok())
                .expect("a number")
        };
        let said = [number("lat ", "\u{b0}"), number("lon ", "\u{b0}")];
        let geodetic = projector.to_geodetic(place.extend(0.0)).expect("a place");
        // Shown to seven digits behind the point: a centimetre.
        let away = [said[0] - geodetic.latitude, said[1] - geodetic.longitude];
        assert!(away.iter().all(|away| away.abs() < 1e-7), "{here}, not {geodetic:?}");
    }
    browser.evaluate("viewer.texts.length = 0; viewer.paint()");
    let texts = browser.evaluate("viewer.texts");
    let mut sum = 0.0;
    for pair in clicked.windows(2) {
        sum += pair[0].distance(pair[1]);
        let expected = json!(format!("{sum:.2} m"));
        assert!(texts.as_array().expect("texts").contains(&expected), "{texts}, not {expected}");
    }
    // Esc ends it, and a click says again what is there.
    browser.key("Escape");
    assert_eq!(browser.evaluate("[viewer.mode, viewer.labels.measure.length]"), json!(["look", 0]));
    assert_eq!(browser.complaints, [""; 0]);
}

/// The page begins as dark as the rest of the machine; without a pointer, Enter says what is in the middle of the screen.
#[test]
fn the_machine_chooses_the_theme_and_enter_the_middle() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    for theme in ["dark", "light"] {
        let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": theme }] });
        browser.call("Emulation.setEmulatedMedia", media);
        browser.evaluate("delete globalThis.viewer; start()");
        browser.wait("globalThis.viewer?.ready");
        let said = "[document.documentElement.dataset.theme, viewer.dark]";
        assert_eq!(browser.evaluate(said), json!([theme, theme == "dark"]));
    }
    let lane = snapshot.map().lanes().find(|lane| lane.kind().is_drivable()).expect("a lane");
    let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
    let place = lane.pose_at(s, 0.0).expect("a place").position;
    browser.evaluate(&format!(
        "[viewer.camera.x, viewer.camera.y] = viewer.near({}, {})",
        place.x, place.y
    ));
    browser.key("Enter");
    let title = browser.evaluate("document.querySelector('#panel h1')?.textContent ?? null");
    assert_eq!(title, json!(format!("Lane {}", lane.key())));
    assert_eq!(browser.complaints, [""; 0]);
}

/// Marks are painted in their colour where the map says that they are painted, and nothing is in their gaps.
#[test]
fn marks_have_their_colours_and_gaps() {
    let text = std::fs::read_to_string(mapd_tests::carried("marks.xodr")).expect("a map");
    let dashes = r#"rule="caution" color="white""#;
    assert!(text.contains(dashes));
    for color in ["white", "yellow"] {
        check_marks(&text.replace(dashes, &dashes.replace("white", color)), color);
    }
}

/// Of a map that has dashes of a colour.
fn check_marks(text: &str, color: &str) {
    let snapshot = open_text(text);
    let Some(mut browser) = browser(&snapshot) else { return };
    let map = snapshot.map();
    let near = |point: DVec2| map.nearest_mark(point, &MarkFilter::default()).expect("finite");
    let road = map.roads().next().expect("a road");
    let (mut places, mut expected) = (Vec::new(), Vec::new());
    for (i, t) in (0..110).flat_map(|i| [0.0, -3.5].map(|t| (i, t))) {
        let track = Track { s: 1.0 + 0.87 * f64::from(i), t, h: 0.0 };
        let Ok(pose) = road.to_inertial(track) else { continue };
        let Some(mark) = near(pose.position.truncate()) else { continue };
        // Near the end of a dash a pixel may be either.
        let beside = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|step| 0.06 * step);
        let is_sure = beside.iter().all(|step| {
            near(mark.place + *step)
                .is_some_and(|one| (one.painted, one.color) == (mark.painted, mark.color))
        });
        let color = match (mark.painted, mark.color) {
            _ if !is_sure => continue,
            (Some(false), _) => "gap",
            (Some(true), RoadMarkColor::White) => "white",
            (Some(true), RoadMarkColor::Yellow) => "yellow",
            _ => continue,
        };
        places.push(mark.place.to_array());
        expected.push(color);
    }
    for color in ["gap", color] {
        let count = expected.iter().filter(|one| **one == color).count();
        assert!(count >= 10, "{count} {color}");
    }
    let pixels = format!(
        "(() => {{ viewer.shown = new Set(['lanes', 'marks']);
        const {{ gl, canvas }} = viewer.painter, pixel = new Uint8Array(4);
        return {}.map(([x, y]) => {{
            [viewer.camera.x, viewer.camera.y] = viewer.near(x, y);
            viewer.camera.scale = 60;
            viewer.painter.changes++;
            viewer.paint();
            gl.readPixels(canvas.width >> 1, canvas.height >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            const [r, g, b] = pixel;
            return r - b > 60 ? 'yellow' : Math.min(r, g, b) > 210 ? 'white' : 'gap';
        }}); }})()",
        json!(places)
    );
    let found = browser.evaluate(&pixels);
    let found = found.as_array().expect("colours");
    for ((place, expected), found) in places.iter().zip(&expected).zip(found) {
        assert_eq!(found, expected, "at {place:?}");
    }
    assert_eq!(browser.complaints, [""; 0]);
}
