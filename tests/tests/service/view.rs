//! `mapd view`: who is answered what.

use mapd_client::{Attach, Client};
use mapd_tests::maps::open;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_tests::view::View;
use std::io::{BufRead, Read};

fn place() -> TestDomain {
    TestDomain::new(env!("CARGO_BIN_EXE_mapd_under_test"))
}

#[test]
fn only_this_machine_is_answered() {
    let (place, file) = (place(), mapd_tests::carried("one_road.xodr"));
    let view = View::start(&place, &[file.to_str().expect("a path")]);
    let get = |path: &str, host: &str| view.ask(&format!("GET {path} HTTP/1.1\r\n{host}\r\n\r\n"));
    for host in ["Host: 127.0.0.1:PORT", "host: localhost:PORT", "Host: [::1]:PORT"] {
        assert_eq!(get("/", host).0, 200, "{host}");
    }
    for host in [
        "Host: evil.example:PORT",
        "Host: 127.0.0.1.evil.example:PORT",
        "Host: 192.0.2.1:PORT",
        "Host: 127.0.0.1:1",
        "Host: 127.0.0.1",
        "Accept: */*",
        "Host: 127.0.0.1:PORT\r\nHost: evil.example:PORT",
    ] {
        assert_eq!(get("/map/0", host).0, 403, "{host}");
    }
    let us = "Host: 127.0.0.1:PORT";
    assert_eq!(get("/map/0?x", us), (200, open(&file).bytes().to_vec()));
    assert_eq!(get("/status/0", us), (200, b"null".to_vec()), "a file is served by nobody");
    for path in ["/map/1", "/map/", "/map/-1", "/../etc/passwd", "/map/0/"] {
        assert_eq!(get(path, us).0, 404, "{path}");
    }
    assert_eq!(view.ask("POST / HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n").0, 405);
    let long = format!("Host: 127.0.0.1:PORT\r\nCookie: {}", "x".repeat(20_000));
    let mut answer = Vec::new();
    // Who says too much is hung up on.
    let _ = view.send(&format!("GET / HTTP/1.1\r\n{long}")).read_to_end(&mut answer);
    assert!(answer.is_empty(), "{}", String::from_utf8_lossy(&answer));
    let page = String::from_utf8(get("/", us).1).expect("UTF-8");
    assert!(page.contains("connect-src 'self'; ") && page.contains(">[\"one_road\"]<"));
}

/// Maps of one name are told apart by their sources.
#[test]
fn maps_of_one_name_are_named_in_full() {
    let (place, file) = (place(), mapd_tests::carried("one_road.xodr"));
    let folder = tempfile::tempdir().expect("a folder");
    let (copy, other) = (folder.path().join("one_road.xodr"), folder.path().join("other.xodr"));
    for name in [&copy, &other] {
        std::fs::copy(&file, name).expect("copied");
    }
    let sources = [&file, &copy, &other].map(|path| path.to_str().expect("a path"));
    let view = View::start(&place, &sources);
    let page = view.ask("GET / HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n").1;
    let names = serde_json::json!([sources[0], sources[1], "other"]).to_string();
    assert!(String::from_utf8(page).expect("UTF-8").contains(&format!(">{names}<")), "{names}");
}

/// Names stay refused, so that DNS rebinding finds nothing there either.
#[test]
fn an_open_view_answers_every_address_and_no_name() {
    let (place, file) = (place(), mapd_tests::carried("one_road.xodr"));
    let view = View::start(&place, &["--open", file.to_str().expect("a path")]);
    for (host, expected) in [
        ("192.0.2.1:PORT", 200),
        ("[2001:db8::1]:PORT", 200),
        ("127.0.0.1:PORT", 200),
        ("localhost:PORT", 200),
        ("evil.example", 403),
        ("evil.example:PORT", 403),
        ("192.0.2.1.evil.example:PORT", 403),
        ("192.0.2.1:1", 403),
    ] {
        let (status, body) = view.ask(&format!("GET /map/0 HTTP/1.1\r\nHost: {host}\r\n\r\n"));
        assert_eq!(status, expected, "{host}");
        assert_eq!(body == open(&file).bytes(), expected == 200, "{host}");
    }
}

#[test]
fn who_listens_hears_of_every_generation_and_overlay() {
    let place = place();
    let folder = tempfile::tempdir().expect("a folder");
    let map = folder.path().join("town.xodr");
    let put =
        |name: &str| std::fs::copy(mapd_tests::carried(name), &map).map(drop).expect("copied");
    put("town.xodr");
    let _daemon = place.serve(&[&map.display().to_string()]);
    let view = View::start(&place, &["shm:town"]);
    let mut events = view.send("GET /events/0 HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n");
    let mut next = || loop {
        let mut line = String::new();
        assert_ne!(events.read_line(&mut line).expect("an event"), 0, "the events ended");
        if let Some(pair) = line.strip_prefix("data: ") {
            let (generation, revision) = pair.trim().split_once(' ').expect("two numbers");
            let number = |text: &str| text.parse::<u64>().expect("a number");
            return (number(generation), number(revision));
        }
    };
    let client =
        Client::connect_as(Attach::Observer, &place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(next(), (client.snapshot().generation(), 0));
    let overlay = || view.ask("GET /overlay/0 HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n");
    assert_eq!(overlay(), (200, Vec::new()));
    let entries = folder.path().join("works.json");
    let text = r#"{"entries":[{"id":"works","kind":"wet","lanes":[{"road":"1"}]}]}"#;
    std::fs::write(&entries, text).expect("written");
    let file = entries.to_str().expect("a path");
    for (args, is_over) in [(["apply", file], true), (["remove", "works"], false)] {
        let laid = place.command().args(["overlay", "town"]).args(args).output().expect("ends");
        assert!(laid.status.success(), "{laid:?}");
        let newest = client.refresh().expect("the newest");
        assert_eq!(next(), (newest.generation(), newest.overlay_revision()));
        assert_eq!(newest.overlay_bytes().is_empty(), !is_over);
        assert_eq!(overlay(), (200, newest.overlay_bytes().to_vec()));
    }
    put("one_road.xodr");
    place.reload("town");
    let newest = client.wait_next(PATIENCE).expect("a generation");
    assert_eq!(next(), (newest.generation(), 0));
    let answer = view.ask("GET /map/0 HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n");
    assert_eq!(answer, (200, newest.bytes().to_vec()));
    let _one = Client::connect_as(Attach::Subscriber, &place.domain(), "town", PATIENCE)
        .expect("subscribes");
    let (code, status) = view.ask("GET /status/0 HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n");
    let status: serde_json::Value = serde_json::from_slice(&status).expect("JSON");
    assert_eq!((code, &status["name"], &status["alive"]), (200, &"town".into(), &true.into()));
    assert_eq!(status["generation"], newest.generation());
    assert_eq!(status["subscribers"], 1, "the view itself only observes");
}

fn head_and_body(view: &View, request: &str) -> (String, Vec<u8>) {
    let mut answer = Vec::new();
    view.send(request).read_to_end(&mut answer).expect("an answer");
    let end = answer.windows(4).position(|end| end == b"\r\n\r\n").expect("a head") + 4;
    let body = answer.split_off(end);
    (String::from_utf8(answer).expect("text"), body)
}

/// `HEAD` was refused, without a word of what is not.
#[test]
fn head_is_answered_as_get_without_the_body() {
    let (place, file) = (place(), mapd_tests::carried("one_road.xodr"));
    let view = View::start(&place, &[file.to_str().expect("a path")]);
    let ask = |method: &str, path: &str, host: &str| {
        head_and_body(&view, &format!("{method} {path} HTTP/1.1\r\nHost: {host}:PORT\r\n\r\n"))
    };
    for path in ["/", "/map/0", "/overlay/0", "/findings/0", "/status/0", "/nothing"] {
        for host in ["127.0.0.1", "evil.example"] {
            let (head, body) = ask("GET", path, host);
            let length = head.lines().find_map(|line| line.strip_prefix("Content-Length: "));
            assert_eq!(length, Some(body.len().to_string().as_str()), "{path} {host}");
            assert_eq!(ask("HEAD", path, host), (head, Vec::new()), "{path} {host}");
        }
    }
    let (head, body) = ask("HEAD", "/events/0", "127.0.0.1");
    assert!(head.contains("text/event-stream") && body.is_empty(), "{head}");
    for method in ["POST", "PUT", "OPTIONS", "DELETE", "CONNECT"] {
        let (head, _) = ask(method, "/", "127.0.0.1");
        assert!(head.starts_with("HTTP/1.1 405 "), "{method}: {head}");
        assert!(head.contains("\r\nAllow: GET, HEAD\r\n"), "{method}: {head}");
    }
}

/// Sixty-four connections that said nothing had everybody else told 503, for ten seconds each time.
#[test]
fn who_says_nothing_keeps_nobody_out() {
    const MANY: usize = 100;
    let (place, file) = (place(), mapd_tests::carried("one_road.xodr"));
    let view = View::start(&place, &[file.to_str().expect("a path")]);
    let is_answered = || {
        let (status, body) = view.ask("GET /map/0 HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n");
        assert_eq!((status, body), (200, open(&file).bytes().to_vec()));
    };
    let mut idle: Vec<_> = (0..MANY).map(|_| view.send("GET / HTTP/1.1\r\n")).collect();
    is_answered();
    assert_eq!(idle[0].read(&mut [0]).unwrap_or(0), 0, "the oldest has made room");
    let events = "GET /events/0 HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n";
    let mut listening: Vec<_> = (0..MANY)
        .map(|_| {
            let (mut one, mut line) = (view.send(events), String::new());
            one.read_line(&mut line).expect("an answer");
            assert!(line.contains("200"), "{line}");
            one
        })
        .collect();
    is_answered();
    let mut rest = Vec::new();
    // It may be reset.
    let _ = listening[0].read_to_end(&mut rest);
    drop((idle, listening));
    is_answered();
}
