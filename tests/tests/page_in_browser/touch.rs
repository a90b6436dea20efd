//! The page on a phone: a small screen, and fingers.

use crate::browser;
use mapd_client::Lane;
use mapd_tests::browser::Browser;
use mapd_tests::maps::open;
use serde_json::{Value, json};

/// Screen of a phone, upright.
const PHONE: (u32, u32) = (360, 640);
/// How far a place may lie from the finger that holds it [px].
const HELD: f64 = 1e-6;

/// Whether there were any, and lanes whose middles, once they are followed, lie outside of the screen or below their sheet.
const COVERED: &str = "(() => { let followed = 0;
    const covered = [], { map, queries, camera } = viewer;
    for (let row = 0; row < map.lanes; row++) {
        // Lane 0 has no area.
        const link = { kind: 'lane', row }, { bounds } = queries.sheet(link);
        if (!bounds) continue;
        viewer.fit();
        followed++;
        viewer.choose(link, { isFollowed: true });
        const [a, b, c, d] = bounds, [x, y] = camera.toPage(...viewer.near((a + c) / 2, (b + d) / 2));
        const { left, top, right, bottom } = document.querySelector('#panel').getBoundingClientRect();
        const isBelow = left <= x && x <= right && top <= y && y <= bottom;
        if (isBelow || x < 0 || y < 0 || x > innerWidth || y > innerHeight) covered.push(row);
        viewer.clear();
    }
    return [followed > 0, covered]; })()";

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|one| one.as_f64().expect("a number")).collect()
}

/// Where a place is on the screen [px], and how many pixels a metre has.
fn seen(browser: &mut Browser, [x, y]: [f64; 2]) -> [f64; 3] {
    let seen = format!("[...viewer.camera.toPage({x}, {y}), viewer.camera.scale]");
    numbers(&browser.evaluate(&seen)).try_into().expect("three numbers")
}

/// The place under a pixel.
fn under(browser: &mut Browser, [x, y]: [f64; 2]) -> [f64; 2] {
    let under = browser.evaluate(&format!("viewer.camera.toGround({x}, {y})"));
    numbers(&under).try_into().expect("two numbers")
}

#[test]
fn fingers_move_zoom_turn_and_choose() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    browser.become_phone(PHONE);
    browser.wait(&format!("viewer.camera.width === {}", PHONE.0));
    browser.evaluate("viewer.fit()");

    // One finger holds the place under it.
    let [from, to] = [[100.0, 300.0], [200.0, 420.0]];
    let held = under(&mut browser, from);
    let [.., scale] = seen(&mut browser, held);
    browser.touch(&[&[from, to]]);
    let [x, y, after] = seen(&mut browser, held);
    assert!((x - to[0]).hypot(y - to[1]) < HELD && after == scale, "{x}, {y}, {scale}, {after}");

    // Two hold theirs: twice as far from each other is twice as near; a quarter of a turn turns the map.
    let pair = [[130.0, 300.0], [230.0, 300.0]];
    let held = pair.map(|at| under(&mut browser, at));
    let wide = [[80.0, 300.0], [280.0, 300.0]];
    browser.touch(&[&[pair[0], wide[0]], &[pair[1], wide[1]]]);
    for (place, to) in held.into_iter().zip(wide) {
        let [x, y, zoomed] = seen(&mut browser, place);
        assert!((x - to[0]).hypot(y - to[1]) < HELD, "{x}, {y}, not {to:?}");
        assert!((zoomed / scale - 2.0).abs() < HELD, "{zoomed}, not twice {scale}");
    }
    let steep = [[180.0, 200.0], [180.0, 400.0]];
    let held = wide.map(|at| under(&mut browser, at));
    browser.touch(&[&[wide[0], steep[0]], &[wide[1], steep[1]]]);
    for (place, to) in held.into_iter().zip(steep) {
        let [x, y, _] = seen(&mut browser, place);
        assert!((x - to[0]).hypot(y - to[1]) < HELD, "{x}, {y}, not {to:?}");
    }
    let panel = "document.querySelector('#panel').hidden";
    assert_eq!(browser.evaluate(panel), json!(true), "a finger that moves chooses nothing");

    // A tap chooses; a finger beside a narrow lane finds it, too.
    let is_plain = |lane: &Lane<'_>| lane.kind().is_drivable() && lane.road().junction().is_none();
    let lane = snapshot.map().lanes().find(is_plain).expect("a lane");
    let middle = 0.5 * (lane.section().s_start() + lane.section().s_end());
    let place = lane.pose_at(middle, 0.0).expect("a place").position;
    let near = format!("viewer.near({}, {})", place.x, place.y);
    browser.evaluate(&format!(
        "(() => {{ const [x, y] = {near}; viewer.show([x - 20, y - 20, x + 20, y + 20]); }})()"
    ));
    let at = numbers(&browser.evaluate(&format!("viewer.camera.toPage(...{near})")));
    browser.touch(&[&[[at[0], at[1]]]]);
    let title = "document.querySelector('#panel h1')?.textContent ?? null";
    assert_eq!(browser.evaluate(title), json!(format!("Lane {}", lane.key())));
    let here = browser.evaluate("document.querySelector('#here').textContent");
    let words = format!("lane {} (", lane.key());
    assert!(here.as_str().is_some_and(|here| here.contains(&words)), "{here}");
    assert_eq!(browser.complaints, [""; 0]);
}

/// Nothing sticks out of the screen or covers what else is needed: the sheet leaves the upper half to the map, what does not fit scrolls.
#[test]
fn everything_fits_a_small_screen() {
    let snapshot = open(&mapd_tests::carried("town.xodr"));
    let Some(mut browser) = browser(&snapshot) else { return };
    for size in [PHONE, (PHONE.1, PHONE.0)] {
        browser.become_phone(size);
        browser.wait(&format!("viewer.camera.width === {}", size.0));
        let boxes = "(() => { const all = {};
            for (const id of ['search', 'panel', 'layers', 'fit', 'theme']) {
                document.getElementById(id).scrollIntoView({ block: 'nearest', inline: 'nearest' });
                const { left, top, right, bottom } = document.getElementById(id).getBoundingClientRect();
                all[id] = [left, top, right, bottom];
            }
            return all; })()";
        browser.evaluate("viewer.choose({ kind: 'lane', row: 1 }, { isFollowed: true })");
        browser.evaluate("if (document.querySelector('#layers').hidden) viewer.toggleLayers()");
        let all = browser.evaluate(boxes);
        let [width, height] = [size.0, size.1].map(f64::from);
        for (name, sides) in all.as_object().expect("boxes") {
            let [left, top, right, bottom] = numbers(sides)[..] else { panic!("{sides}") };
            assert!(right - left > 20.0 && bottom - top > 20.0, "{name}: {sides}");
            let is_inside = left >= 0.0 && top >= 0.0 && right <= width && bottom <= height;
            assert!(is_inside, "{name} sticks out of {size:?}: {sides}");
        }
        assert_eq!(browser.evaluate(COVERED), json!([true, []]), "{size:?}");
        assert_eq!(browser.evaluate("document.documentElement.scrollWidth"), json!(size.0));
        browser.evaluate("viewer.clear()");
    }
    assert_eq!(browser.complaints, [""; 0]);
}
