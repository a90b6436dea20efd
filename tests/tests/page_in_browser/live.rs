//! The page of `mapd view`: it follows what a daemon serves, without being loaded again.

use crate::{any_browser, painted};
use mapd_client::{Attach, Client, Snapshot};
use mapd_tests::browser::Browser;
use mapd_tests::object_maps::{PLAIN, document};
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::view::View;
use serde_json::{Value, json};
use std::path::Path;

/// Where the camera is `[m]`.
const PLACE: &str = "viewer.far([viewer.camera.x, viewer.camera.y])";
const CLIENTS: &str = "document.querySelector('#clients').textContent";
const ABOUT: &str = "document.querySelector('#about').textContent";
const NOTE: &str = "document.querySelector('#message').textContent";

fn copy(name: &str, to: &Path) {
    std::fs::copy(mapd_tests::carried(name), to).expect("copied");
}

/// Waits until the page shows what is served, and says whether it draws an overlay.
fn wait_for(browser: &mut Browser, served: &Snapshot) -> bool {
    let (generation, revision) = (served.generation(), served.overlay_revision());
    browser.wait(&format!(
        "viewer.map.generation === {generation} && viewer.queries.revision === {revision}"
    ));
    // What is chosen is drawn, too.
    painted(browser, &["today"]) > painted(browser, &[])
}

#[test]
fn a_served_page_follows_its_map() {
    let Some(mut browser) = any_browser() else { return };
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("live.xodr");
    copy("town.xodr", &file);
    let daemon = place.serve(&[&file.display().to_string()]);
    let connect = |attach| Client::connect_as(attach, &place.domain(), "live", PATIENCE);
    let client = connect(Attach::Observer).expect("attaches");
    let view = View::start(&place, &["shm:live"]);
    browser.open_served(&view.address(), "globalThis.viewer?.ready");
    assert_eq!(browser.evaluate(NOTE), "");
    assert!(!wait_for(&mut browser, &client.snapshot()));

    // Who serves and reads it.
    let clients = |count: &str| json!(format!("daemon {} · {count}", daemon.id()));
    browser.wait(&format!("{CLIENTS} === {}", clients("0 subscribers")));
    let subscriber = connect(Attach::Subscriber).expect("subscribes");
    browser.wait(&format!("{CLIENTS} === {}", clients("1 subscriber")));
    drop(subscriber);
    browser.wait(&format!("{CLIENTS} === {}", clients("0 subscribers")));

    // An overlay is drawn, said on the sheet that is open, and gone again.
    browser.evaluate("viewer.choose({ kind: 'lane', row: viewer.queries.find('1:0:-1')[0].link.row }, { isWhole: true })");
    let sheet = "document.querySelector('#panel dl').textContent";
    let entries = folder.path().join("works.json");
    let text = r#"{"entries":[{"id":"works","kind":"closed","text":"burst pipe","lanes":[{"road":"1"}]}]}"#;
    std::fs::write(&entries, text).expect("written");
    let entries = entries.to_str().expect("a path");
    for (arguments, is_over) in [(["apply", entries], true), (["remove", "works"], false)] {
        let mut command = place.command();
        let laid = command.args(["overlay", "live"]).args(arguments).output().expect("ends");
        assert!(laid.status.success(), "{laid:?}");
        let newest = client.refresh().expect("the newest");
        assert_eq!(wait_for(&mut browser, &newest), is_over);
        browser.wait(&format!("{NOTE} === 'What is laid over the map has changed.'"));
        let said = browser.evaluate(sheet);
        assert_eq!(said.as_str().is_some_and(|said| said.contains("burst pipe")), is_over);
    }

    // Another generation takes the place of the last one under the same view.
    browser.evaluate("viewer.shown.add('lanes'); viewer.camera.zoom(1.5)");
    let before = browser.evaluate(&format!("[...{PLACE}, viewer.camera.scale]"));
    copy("one_road.xodr", &file);
    place.reload("live");
    let newest = client.wait_next(PATIENCE).expect("a generation");
    wait_for(&mut browser, &newest);
    let after = browser.evaluate(&format!("[...{PLACE}, viewer.camera.scale]"));
    let moved = |i: usize| before[i].as_f64().zip(after[i].as_f64()).map(|(a, b)| (a - b).abs());
    assert!((0..3).all(|i| moved(i).is_some_and(|by| by < 1e-6)), "{before}, {after}");
    let about = browser.evaluate(ABOUT);
    let words =
        format!("generation {} · {} lanes", newest.generation(), newest.map().lanes().count());
    assert!(about.as_str().is_some_and(|about| about.contains(&words)), "{about}, not {words}");

    assert_eq!(daemon.stop(), 0);
    browser.wait(&format!("{CLIENTS} === 'no daemon'"));
    assert_eq!(browser.complaints, [""; 0]);
    drop(view);
    browser.wait(&format!("{NOTE} === 'mapd view does not answer; trying again …'"));
}

/// With several maps the address names the one that is shown, and leads back to it.
#[test]
fn an_address_names_its_map() {
    let Some(mut browser) = any_browser() else { return };
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let folder = tempfile::tempdir().expect("a folder");
    let names = ["first", "<b>&second"];
    let sources = names.map(|name| folder.path().join(name).with_extension("xodr"));
    copy("town.xodr", &sources[0]);
    copy("one_road.xodr", &sources[1]);
    let sources = [0, 1].map(|i| sources[i].to_str().expect("a path"));
    let view = View::start(&place, &sources);
    browser.open_served(&view.address(), "globalThis.viewer?.ready");
    let choices = "[...document.querySelectorAll('#maps option')].map(one => one.textContent)";
    assert_eq!(browser.evaluate(choices), json!(names));
    let lanes =
        sources.map(|source| mapd_tests::maps::open(Path::new(source)).map().lanes().count());
    let shown = |number: usize| {
        format!(
            "viewer.map.lanes === {} && document.querySelector('#maps').value === '{number}'",
            lanes[number]
        )
    };
    browser.wait(&shown(0));
    let choose = |number: usize| {
        format!(
            "(() => {{ const maps = document.querySelector('#maps'); maps.value = {number}; maps.onchange(); }})()"
        )
    };
    browser.evaluate(&choose(1));
    browser.wait(&shown(1));
    browser.evaluate("viewer.choose({ kind: 'road', row: 0 }); viewer.writeAddress()");
    let address = browser.evaluate("location.hash");
    let words = ["#map=%3Cb%3E%26second&at=", "&road=0"];
    assert!(
        words.iter().all(|words| address.as_str().is_some_and(|a| a.contains(words))),
        "{address}"
    );
    browser.evaluate(&choose(0));
    browser.wait(&shown(0));

    // In the page that is open, and in one that is opened by it.
    let title = "document.querySelector('#panel h1')?.textContent.startsWith('Road ')";
    browser.evaluate(&format!(
        "viewer.writeAddress(); clearTimeout(viewer.writing); location.hash = {address}"
    ));
    browser.wait(&format!("{} && {title}", shown(1)));
    let address = format!("{}{}", view.address(), address.as_str().expect("text"));
    browser.call("Page.navigate", json!({ "url": "about:blank" }));
    browser.open_served(&address, "globalThis.viewer?.ready");
    browser.wait(&format!("{} && {title}", shown(1)));

    // One that cannot be had leaves the other shown.
    browser.evaluate("viewer.live.load = async () => { throw new Error('gone'); }");
    browser.evaluate(&choose(0));
    browser.wait(&format!("{} && {NOTE} === 'gone'", shown(1)));
    assert_eq!(browser.evaluate("document.title"), Value::from(names.join(", ")));
    assert_eq!(browser.complaints, [""; 0]);
}

/// What a served map has left out is red, and listed with its rule and its place in the file, in each generation anew; an open list follows.
#[test]
fn what_a_served_map_has_left_out_is_listed() {
    let Some(mut browser) = any_browser() else { return };
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("live.xodr");
    let write = |radii: &[&str]| {
        let tree = |(i, radius): (usize, &&str)| {
            let s = 10 + 5 * i;
            format!(
                r#"<object id="{i}" type="tree" s="{s}" t="9" zOffset="0" radius="{radius}" height="3" orientation="none"/>"#
            )
        };
        let trees: String = radii.iter().enumerate().map(tree).collect();
        std::fs::write(&file, document(&PLAIN, &trees)).expect("written");
    };
    write(&["2"]);
    let daemon = place.serve(&[&file.display().to_string()]);
    let client = Client::connect_as(Attach::Observer, &place.domain(), "live", PATIENCE);
    let client = client.expect("attaches");
    let view = View::start(&place, &["shm:live"]);
    browser.open_served(&view.address(), "globalThis.viewer?.ready");
    // A part, none, two parts; the list is opened, closes because nothing is to be listed, and is opened again.
    for (radii, opens) in
        [(&["1", "round"][..], true), (&["1", "1"], false), (&["flat", "round"], true)]
    {
        write(radii);
        place.reload("live");
        let newest = client.wait_next(PATIENCE).expect("a generation");
        browser.wait(&format!("viewer.map.generation === {}", newest.generation()));
        if opens {
            browser.key("f");
        }
        let parts: Vec<Value> = newest
            .map()
            .quarantined()
            .map(|part| {
                let at = part.source_position();
                let name = format!("{} {}", part.kind().name(), part.id());
                json!([name, part.rule(), part.message(), format!("{}:{}", at.line, at.column)])
            })
            .collect();
        let count = radii.iter().filter(|radius| radius.parse::<f64>().is_err()).count();
        assert_eq!(parts.len(), count);
        let red = painted(&mut browser, &["left out"]) - painted(&mut browser, &[]);
        assert_eq!(red > 0.0, count > 0, "{red} pixels of {radii:?}");
        let button = browser.evaluate("document.querySelector('#show-list').textContent");
        let words = if count > 0 { format!("{count} left out") } else { String::new() };
        assert_eq!(button, json!(words));
        let rows = "[...document.querySelectorAll('#list tbody tr')].map(row => [...row.children].map(cell => cell.textContent))";
        assert_eq!(browser.evaluate(rows), json!(parts), "{radii:?}");
        let is_hidden = browser.evaluate("document.querySelector('#list').hidden");
        assert_eq!(is_hidden, json!(count == 0));
        if count > 0 {
            // An archive does not tell more, and the page says so.
            let note = browser.evaluate("document.querySelector('#list p').textContent");
            assert!(
                note.as_str()
                    .is_some_and(|note| note.ends_with("known only of an OpenDRIVE file.")),
                "{note}"
            );
            browser.evaluate("document.querySelectorAll('#list td a')[0].click()");
            let title = browser.evaluate("document.querySelector('#panel h1').textContent");
            assert!(
                title.as_str().is_some_and(|title| title.starts_with("Left out: object ")),
                "{title}"
            );
        }
    }
    assert_eq!(daemon.stop(), 0);
    assert_eq!(browser.complaints, [""; 0]);
}
