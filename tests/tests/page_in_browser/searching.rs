//! The search field finds everything that has a name or a place.

use crate::{browser, town_with_everything};
use mapd_client::Lane;
use mapd_tests::browser::Browser;
use mapd_tests::maps::{open, open_text};
use serde_json::{Value, json};

/// Types words into the search field, as a user does; what is offered first, and what is shown after Enter: the sheet's title and the mark's place.
fn search(browser: &mut Browser, words: &str) -> [Value; 3] {
    browser.key("Escape");
    browser.evaluate("viewer.clear(); document.querySelector('#text').value = ''");
    browser.key("/");
    browser.call("Input.insertText", json!({ "text": words }));
    let offered = browser.evaluate("document.querySelector('#found li')?.textContent ?? null");
    browser.evaluate("document.querySelector('#search').requestSubmit()");
    let title = browser.evaluate("document.querySelector('#panel h1')?.textContent ?? null");
    let place = browser.evaluate("viewer.labels.mark && viewer.far(viewer.labels.mark)");
    [offered, title, place]
}

#[test]
fn everything_that_has_a_name_is_found() {
    let snapshot = town_with_everything();
    let Some(mut browser) = browser(&snapshot) else { return };
    for (words, offered, title) in [
        ("1:0:-1", "lane 1:0:-1", "Lane 1:0:-1"),
        ("Street 2", "road 2 “Street 2”", "Road 2"),
        ("crossing 0", "junction 1000 “Crossing 0”", "Junction 1000"),
        ("sign of 30", "signal", "Signal sign of 30"),
        ("SIGN OF 30", "signal", "Signal sign of 30"),
        ("zebra", "object", "Object zebra"),
        ("broken", "left out:", "Left out: object broken"),
    ] {
        let [said, shown, _] = search(&mut browser, words);
        let is_so =
            |value: &Value, begin: &str| value.as_str().is_some_and(|text| text.starts_with(begin));
        assert!(is_so(&said, offered), "{words}: {said}");
        assert!(is_so(&shown, title), "{words}: {shown}");
    }
    let [said, shown, _] = search(&mut browser, "nothing of this name");
    assert_eq!([said, shown], [Value::Null, Value::Null]);
    assert_eq!(browser.evaluate(crate::MESSAGE), json!("Nothing has this name."));
    assert_eq!(browser.complaints, [""; 0]);
}

/// Latitude and longitude lead to the place that the map's projection has for them.
#[test]
fn a_place_on_earth_is_found() {
    let snapshot = open(&mapd_tests::carried("one_road.xodr"));
    let map = snapshot.map();
    let Some(mut browser) = browser(&snapshot) else { return };
    let is_driven = |lane: &Lane<'_>| lane.kind().is_drivable();
    let lane = map.lanes().find(is_driven).expect("a lane");
    let s = 0.5 * (lane.section().s_start() + lane.section().s_end());
    let place = lane.pose_at(s, 0.0).expect("a place").position;
    let there = map.projector().expect("a georeference").to_geodetic(place).expect("a place");
    for between in [" ", ", ", ";"] {
        let words = format!("{:.9}{between}{:.9}", there.latitude, there.longitude);
        let [said, _, marked] = search(&mut browser, &words);
        let expected =
            format!("place at latitude {:.9}°, longitude {:.9}°", there.latitude, there.longitude);
        assert_eq!(said, json!(expected));
        let marked = [0, 1].map(|i| marked[i].as_f64().expect("a number"));
        let away = (marked[0] - place.x).hypot(marked[1] - place.y);
        // A latitude has nine digits: a tenth of a millimetre.
        assert!(away < 1e-3, "{marked:?}, not {place}");
    }
    assert_eq!(browser.complaints, [""; 0]);
}

/// A map without lanes is a page that says so, and answers whatever is clicked.
#[test]
fn a_map_without_lanes_is_shown() {
    let snapshot = open_text(r#"<OpenDRIVE><header revMajor="1" revMinor="7"/></OpenDRIVE>"#);
    let Some(mut browser) = browser(&snapshot) else { return };
    let about = browser.evaluate("document.querySelector('#about').textContent");
    assert!(about.as_str().is_some_and(|about| about.contains("0 lanes")), "{about}");
    browser.click(500.0, 350.0);
    for key in ["0", "+", "h", "l", "f", "d", "Enter", "r"] {
        browser.key(key);
    }
    browser.click(300.0, 300.0);
    browser.click(600.0, 400.0);
    let said = browser.evaluate(crate::MESSAGE);
    assert!(said.as_str().is_some_and(|said| said.starts_with("No route: ")), "{said}");
    let here = browser.evaluate("document.querySelector('#here').textContent");
    assert!(
        here.as_str().is_some_and(|here| here.starts_with("x ") && !here.contains("NaN")),
        "{here}"
    );
    assert_eq!(browser.complaints, [""; 0]);
}
