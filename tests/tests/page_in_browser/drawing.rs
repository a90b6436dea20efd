//! What the page draws.

use crate::{browser, painted, under_works};
use mapd_tests::maps::open;
use serde_json::json;

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
