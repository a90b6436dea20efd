//! What the page draws.

use crate::lit::{is_same, paint, pixels};
use crate::{browser, painted, under_works};
use mapd_client::glam::{DVec2, DVec3};
use mapd_client::{Bounds, Lane, NearestOptions};
use mapd_tests::maps::open;
use mapd_web::Paint;
use serde_json::json;
use std::collections::BTreeSet;

/// Share by which the area that is seen may differ from the lanes' own: what overlaps counts once, edges are pixels.
const AREA: f64 = 0.1;

/// Lanes cover as many pixels as they have area.
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

/// From low to high, as the page's `shaders.js` has it.
const SHADES: [[f64; 3]; 3] = [[0.27, 0.0, 0.33], [0.13, 0.57, 0.55], [0.99, 0.91, 0.15]];

/// The colour of a height, 0 that of the map's lowest place, 1 that of its highest `[of 255]`.
fn shade(height: f64) -> [f64; 3] {
    let [low, high] = if height < 0.5 { [0, 1] } else { [1, 2] };
    let share = 2.0 * height - low as f64;
    [0, 1, 2].map(|i| 255.0 * (SHADES[low][i] + share * (SHADES[high][i] - SHADES[low][i])))
}

/// A lane is painted as its type, or by its height.
#[test]
fn lanes_have_the_colours_of_their_types_and_heights() {
    let (mut types, mut heights) = (BTreeSet::new(), BTreeSet::new());
    for name in ["one_road.xodr", "town.xodr", "surfaces.xodr"] {
        let snapshot = open(&mapd_tests::carried(name));
        let map = snapshot.map();
        let Some(mut browser) = browser(&snapshot) else { return };
        browser.evaluate("viewer.painter.frames.samples = 0");
        let Bounds { low, high } = map.bounds();
        let lanes = map.lanes().filter(|lane| lane.number() != 0).step_by(7).take(30);
        // Where nothing else is, at most half a metre away.
        let places = lanes.filter_map(|lane| {
            let s = lane.section().s_start()
                + 0.3 * (lane.section().s_end() - lane.section().s_start());
            let place = lane.pose_at(s, 0.0).ok()?.position;
            let options = NearestOptions { radius: 0.5, ..NearestOptions::default() };
            let mut near = Vec::new();
            map.lanes_near(place.truncate(), &options, &mut near).expect("finite");
            let is_alone = near.iter().all(|found| found.lane == lane.lane_id());
            is_alone.then_some((lane, place))
        });
        let places: Vec<(Lane<'_>, DVec3)> = places.collect();
        let at: Vec<DVec2> = places.iter().map(|(_, place)| place.truncate()).collect();
        let by_type = pixels(&mut browser, &at);
        browser.evaluate("viewer.isByHeight = true");
        let by_height = pixels(&mut browser, &at);
        for (((lane, place), by_type), by_height) in places.iter().zip(by_type).zip(by_height) {
            let kind = Paint::from(lane.kind()).name();
            let [r, g, b, _] = paint(&mut browser, kind);
            let expected = [r, g, b].map(|part| 255.0 * part);
            assert!(is_same(by_type, expected), "{kind} at {place}: {by_type:?}, not {expected:?}");
            let height = (place.z - low.z) / (high.z - low.z).max(1e-3);
            let expected = shade(height);
            assert!(
                is_same(by_height, expected),
                "{height} at {place}: {by_height:?}, not {expected:?}"
            );
            types.insert(kind);
            heights.insert((10.0 * height) as i64);
        }
        assert_eq!(browser.complaints, [""; 0]);
    }
    assert!(types.len() > 2 && heights.len() > 2, "only {types:?}, {heights:?}");
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
