//! What was found in a file, as its page lists it.

use crate::any_browser;
use mapd_tests::browser::Browser;
use mapd_tests::test_domain::TestDomain;
use mapd_tests::view::View;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// An id that would be markup, and that has in it what ends one in a path.
const HOSTILE: &str = "</script><img src=x onerror=\"document.title='run'\">]/lane";

const ROWS: &str = "[...document.querySelectorAll('#list tbody tr')].map(row => [...row.children].map(cell => cell.textContent))";

/// A road with a signal whose value has no unit and whose id is hostile, and one that is left out.
fn file(folder: &Path) -> PathBuf {
    let text = std::fs::read_to_string(mapd_tests::carried("one_road.xodr")).expect("a map");
    let id = HOSTILE.replace('<', "&lt;").replace('"', "&quot;");
    let signal = |id: &str, s: &str| {
        format!(
            r#"<signal id="{id}" s="{s}" t="3" dynamic="no" orientation="+" zOffset="1" country="DE" type="274" subtype="-1" value="4"/>"#
        )
    };
    let signals = format!(
        "<signals>\n{}\n{}\n</signals></road>",
        signal(&id, "10"),
        signal("broken", "&lt;b&gt;")
    );
    let file = folder.join("map.xodr");
    std::fs::write(&file, text.replacen("</road>", &signals, 1)).expect("written");
    file
}

/// What `mapd check` says of a file.
fn checked(place: &TestDomain, file: &str) -> Vec<Value> {
    let output = place.command().args(["check", "--json", file]).output().expect("runs");
    let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    report["findings"].as_array().expect("a list").clone()
}

/// Lists one view of what was found.
fn choose(browser: &mut Browser, view: &str) {
    browser.evaluate(&format!(
        "(() => {{ const choice = document.querySelector('#list select'); choice.value = '{view}'; choice.onchange(); }})()"
    ));
}

/// The same rows as `mapd check` has findings, in a page that is a file and in one that is served; links lead to what they name; text is text.
#[test]
fn all_findings_are_listed_and_lead_to_their_places() {
    let Some(mut browser) = any_browser() else { return };
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let folder = tempfile::tempdir().expect("a folder");
    let source = file(folder.path());
    let source = source.to_str().expect("a path");
    let found = checked(&place, source);
    let of = |name: &str, one: &Value| one[name].as_str().unwrap_or_default().to_owned();
    let expected = |one: &Value| {
        let hint = of("hint", one);
        let hint = if hint.is_empty() { hint } else { format!(". Hint: {hint}") };
        let why = of("message", one) + &hint;
        json!([
            of("severity", one),
            of("rule", one),
            why,
            format!("{}:{}", one["line"], one["column"])
        ])
    };
    let expected: Vec<Value> = found.iter().map(expected).collect();
    assert!(expected.len() >= 3, "{found:?}");

    let page = folder.path().join("map.html");
    let mut command = place.command();
    command.args(["export", source, "--format", "html", "-o"]).arg(&page);
    assert!(command.status().expect("runs").success());
    let view = View::start(&place, &[source]);
    for is_served in [false, true] {
        match is_served {
            false => browser.open(&page, "globalThis.viewer?.ready"),
            true => browser.open_served(&view.address(), "globalThis.viewer?.ready"),
        }
        let button = browser.evaluate("document.querySelector('#show-list').textContent");
        assert_eq!(button, json!(format!("1 left out, {} findings", found.len())));
        browser.key("f");
        assert_eq!(browser.evaluate(ROWS)[0][0], "signal broken");
        choose(&mut browser, "all");
        let rows = browser.evaluate(ROWS);
        let rows = rows.as_array().expect("rows");
        let own: Vec<Value> =
            rows.iter().map(|row| json!(row.as_array().expect("cells")[1..])).collect();
        assert_eq!(own, expected, "served: {is_served}");
        for (severity, title) in
            [("warning", "Warnings"), ("error", "Errors"), ("info", "Information")]
        {
            let count = found.iter().filter(|one| one["severity"] == severity).count();
            let named = browser.evaluate(&format!(
                "document.querySelector('#list option[value={severity}]')?.textContent ?? null"
            ));
            let expected =
                if count > 0 { json!(format!("{title} ({count})")) } else { Value::Null };
            assert_eq!(named, expected);
        }

        // What is left out, the signal, and the road, by their rows.
        let links = "[...document.querySelectorAll('#list tbody tr')].map(row => row.querySelector('a')?.textContent ?? null)";
        let links = browser.evaluate(links);
        let links: Vec<&str> =
            links.as_array().expect("a list").iter().flat_map(Value::as_str).collect();
        assert!(links.contains(&"signal broken"), "{links:?}");
        let signal = links.iter().position(|text| text.contains(HOSTILE)).expect("its link");
        browser.evaluate(&format!("document.querySelectorAll('#list tbody a')[{signal}].click()"));
        let title = browser.evaluate("document.querySelector('#panel h1').textContent");
        assert_eq!(title, json!(format!("Signal {HOSTILE}")));
        let words = "(() => { const words = document.querySelector('#list input'); words.value = 'UNIT onerror'; words.oninput(); })()";
        browser.evaluate(words);
        let rows = browser.evaluate(ROWS);
        assert_eq!(rows.as_array().map(Vec::len), Some(1), "{rows}");
        assert!(
            rows[0][2].as_str().is_some_and(|rule| rule.ends_with("signal.value_unit")),
            "{rows}"
        );
        assert_eq!(
            browser.evaluate("[document.title === 'run', document.images.length]"),
            json!([false, 0])
        );
        assert_eq!(browser.complaints, [""; 0]);
    }
}

/// Many findings are listed piece by piece, each once; a map that nobody compiled just now has the parts that are left out only.
#[test]
fn many_findings_are_listed_in_pieces() {
    let Some(mut browser) = any_browser() else { return };
    let place = TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"));
    let folder = tempfile::tempdir().expect("a folder");
    let text = std::fs::read_to_string(mapd_tests::carried("one_road.xodr")).expect("a map");
    // Of each rule so many are kept; these have three.
    let signal = |i: u32| {
        let (s, country) =
            (f64::from(i) * 0.25, if i.is_multiple_of(2) { "" } else { "country=\"x\"" });
        format!(
            "<signal id=\"{i}\" s=\"{s}\" t=\"3\" dynamic=\"no\" orientation=\"+\" zOffset=\"1\" {country} type=\"274\" subtype=\"-1\" value=\"4\"/>\n"
        )
    };
    let signals = format!("<signals>{}</signals></road>", (0..500).map(signal).collect::<String>());
    let source = folder.path().join("many.xodr");
    std::fs::write(&source, text.replacen("</road>", &signals, 1)).expect("written");
    let source = source.to_str().expect("a path");
    let count = checked(&place, source).len();
    assert!(count > 200, "{count}");
    let page = folder.path().join("map.html");
    let export = |source: &str| {
        let mut command = place.command();
        command.args(["export", source, "--format", "html", "-o"]).arg(&page);
        assert!(command.status().expect("runs").success());
    };
    export(source);
    browser.open(&page, "globalThis.viewer?.ready");
    browser.key("f");
    choose(&mut browser, "all");
    let pieces = "(() => { const counts = [], more = document.querySelector('#list .body button');
        for (;;) {
            counts.push(document.querySelectorAll('#list tbody tr').length);
            if (more.hidden) break;
            more.click();
        }
        return [counts, new Set([...document.querySelectorAll('#list tbody td:last-child')].map(cell => cell.textContent)).size]; })()";
    let pieces = browser.evaluate(pieces);
    let expected: Vec<usize> =
        (1..).map(|piece| 200 * piece).take_while(|at| *at < count).chain([count]).collect();
    assert_eq!(pieces[0], json!(expected));
    assert!(pieces[1].as_u64() > Some(200), "{pieces}");

    let archive = folder.path().join("many.mapd");
    let mut command = place.command();
    command.args(["compile", source, "-o"]).arg(&archive);
    assert!(command.status().expect("runs").success());
    export(archive.to_str().expect("a path"));
    browser.open(&page, "globalThis.viewer?.ready");
    assert_eq!(browser.evaluate("document.querySelector('#show-list').hidden"), json!(true));
    browser.key("f");
    assert_eq!(browser.evaluate("document.querySelector('#list').hidden"), json!(true));
    assert_eq!(browser.complaints, [""; 0]);
}
