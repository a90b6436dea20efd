//! The page of `mapd export --format html` and `mapd view` in a browser: what it draws, says and answers. Needs Chromium, with which `.ci/run page`
//! runs it.

// What the page does when it is clicked, asked by keys, or given what it must not trust.
mod actions;
// What the page answers is what the native build answers.
mod answers;
// What the page draws.
mod drawing;
// What was found in a file, as its page lists it.
mod findings;
// What is chosen stands out: lanes around a lane, a route with its room and its tables.
mod lit;
// The page of `mapd view`: it follows what a daemon serves, without being loaded again.
mod live;
// Moving and measuring by keys and clicks, the place under the pointer, and how marks are painted.
mod looking;
// Where the page paints: layer by layer and pixel by pixel.
mod painted;
// The search field finds everything that has a name or a place.
mod searching;
// The page on a phone: a small screen, and fingers.
mod touch;

use mapd_client::{Road, Snapshot};
use mapd_tests::browser::Browser;
use mapd_tests::overlays::over;
use mapd_web::page::{Content, Findings};
use serde_json::json;

/// Size of the page.
const SIZE: (u32, u32) = (1000, 700);

/// What the page says in the middle of the screen.
const MESSAGE: &str = "document.querySelector('#message').textContent";

/// A browser; none, said aloud, where there is none.
fn any_browser() -> Option<Browser> {
    let browser = Browser::start(SIZE);
    if browser.is_none() {
        mapd_tests::say("SKIPPED: there is no Chromium");
    }
    browser
}

/// Opens the page of an archive, and waits until it shows the map or says why it cannot.
fn show(browser: &mut Browser, content: Content<'_>) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.html");
    let mut page = std::fs::File::create(&file).expect("a file");
    mapd_web::page::write(content, "map", &mut page).expect("written");
    browser.open(&file, "globalThis.viewer?.ready || document.querySelector('#message')?.textContent.includes('cannot')");
}

/// A browser with the page of a map; none, said aloud, where there is no browser.
fn browser(map: &Snapshot) -> Option<Browser> {
    let mut browser = any_browser()?;
    show(
        &mut browser,
        Content::Archive {
            map: map.bytes(),
            overlay: map.overlay_bytes(),
            findings: &Findings::UNKNOWN,
        },
    );
    assert_eq!(browser.evaluate(MESSAGE), json!(""));
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

/// The town with what has a layer of its own, and with one part that is left out.
fn town_with_everything() -> Snapshot {
    let object = |id: &str, more: &str| {
        format!(r#"<object id="{id}" zOffset="0" hdg="0" orientation="none" {more}/>"#)
    };
    let signal = |id: &str, more: &str| {
        format!(
            r#"<signal id="{id}" dynamic="no" orientation="+" zOffset="2" country="DE" subtype="-1" {more}/>"#
        )
    };
    let things = [
        "<objects>".to_owned(),
        object("zebra", r#"type="crosswalk" s="30" t="0" length="3" width="7""#),
        object("oak", r#"type="tree" s="20" t="8" radius="1" height="9""#),
        object("broken", r#"type="tree" s="50" t="9" radius="round" height="3""#),
        "</objects><signals>".to_owned(),
        signal("sign of 30", r#"s="20" t="-5" type="274" value="30" unit="km/h""#),
        signal("stop", r#"s="70" t="-5" type="294" value="-1""#),
        "</signals></road>".to_owned(),
    ];
    let text = std::fs::read_to_string(mapd_tests::carried("town.xodr")).expect("a map");
    // In the second junction, turns of roads with lower numbers go first.
    let turns = 100_100..100_106;
    let pairs = turns.clone().flat_map(|high| (high + 1..turns.end).map(move |low| (high, low)));
    let priority = |(high, low)| format!(r#"<priority high="{high}" low="{low}"/>"#);
    let priorities = pairs.map(priority).collect::<String>() + "</junction>";
    let junction = text.find(r#"id="1001""#).expect("the junction");
    let (before, after) = text.split_at(junction);
    let text = before.replacen("</road>", &things.concat(), 1)
        + &after.replacen("</junction>", &priorities, 1);
    // From a file, which is read again where something is left out.
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("town.xodr");
    std::fs::write(&file, text).expect("written");
    mapd_tests::maps::open(&file)
}

/// Pixels that differ from the background with only these layers shown.
fn painted(browser: &mut Browser, layers: &[&str]) -> f64 {
    let shown = json!(layers);
    let painted =
        format!("viewer.shown = new Set({shown}); viewer.paint(); viewer.painter.painted()");
    browser.evaluate(&painted).as_f64().expect("a number")
}

/// The whole picture as one number, and how many of its pixels are much more red than green.
const LOOK: &str = "(() => { viewer.painter.changes++; viewer.paint();
    const { gl, canvas } = viewer.painter, all = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    let sum = 0, red = 0;
    for (const value of all) sum = (Math.imul(sum, 31) + value) | 0;
    for (let i = 0; i < all.length; i += 4) red += all[i] > all[i + 1] + 60 && all[i] > all[i + 2] + 60;
    return [sum, red]; })()";
