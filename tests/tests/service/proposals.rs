//! What processes on board propose: taken as the policy says, told in the audit log; whatever else is sent changes nothing.

use mapd_client::overlay::{Decision, ProposeError, Proposer};
use mapd_client::vocabulary::VehicleClass;
use mapd_client::{Attach, Client};
use mapd_tests::json_schema::{schema, wrong};
use mapd_tests::test_domain::{Daemon, PATIENCE, TestDomain};
use mapd_tests::town::town;
use mapd_transport::{LONGEST_PROPOSAL, proposals_socket};
use serde_json::Value;
use std::fs;
use std::io::{Read, Write};
use std::net::Shutdown;
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

const POLICY: &str = r#"
[[allow]]
source = "camera"
kinds = ["closed", "wet"]
longest = 600
agree = 2
within = 60
confidence = 0.5

[[allow]]
source = "radar"
kinds = ["closed"]
longest = 600
agree = 2
within = 60

[[allow]]
source = "probe"
kinds = ["wet"]
longest = 600
rate = 5
most = 2

[[allow]]
source = "other"
user = 4000000000
kinds = ["wet"]
longest = 600
"#;

/// A daemon with a town.
struct Scene {
    domain: TestDomain,
    _folder: tempfile::TempDir,
    map: PathBuf,
    policy: PathBuf,
}

impl Scene {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let [map, policy] = ["town.xodr", "policy.toml"].map(|name| folder.path().join(name));
        fs::write(&map, town(3, 3)).expect("written");
        fs::write(&policy, POLICY).expect("written");
        Self { domain: TestDomain::new(MAPD), _folder: folder, map, policy }
    }

    fn serve(&self) -> Daemon {
        let [map, policy] = [&self.map, &self.policy].map(|path| path.to_str().expect("a name"));
        let daemon = self.domain.serve(&[map, "--overlay-from", policy]);
        // A map is served a moment before its daemon listens.
        let until = std::time::Instant::now() + PATIENCE;
        while !proposals_socket(&self.domain.domain(), "town").exists() {
            assert!(std::time::Instant::now() < until, "no socket");
            std::thread::yield_now();
        }
        daemon
    }

    fn propose(&self, source: &str, entry: &str) -> Decision {
        let proposer = Proposer::new(&self.domain.domain(), "town", source);
        proposer.propose(entry, PATIENCE).expect("a decision")
    }

    fn refused(&self, source: &str, entry: &str, why: &str) {
        match self.propose(source, entry) {
            Decision::Refused { reason } => assert!(reason.contains(why), "{reason}"),
            other => panic!("{source}: {entry}: {other:?}"),
        }
    }

    /// What is sent as it is, and answered.
    fn send(&self, bytes: &[u8]) -> String {
        let path = proposals_socket(&self.domain.domain(), "town");
        let mut stream = UnixStream::connect(path).expect("connects");
        // The daemon may have refused before all is sent.
        let _ = stream.write_all(bytes).and_then(|()| stream.shutdown(Shutdown::Write));
        let mut answer = String::new();
        let _ = stream.read_to_string(&mut answer);
        answer
    }

    /// Entries that lane −1 of road 1 is closed by at 15 m.
    fn closed_by(&self) -> Option<String> {
        let domain = self.domain.domain();
        let client = Client::connect_as(Attach::Observer, &domain, "town", PATIENCE);
        let snapshot = client.expect("attaches").snapshot();
        let view = snapshot.view(SystemTime::now());
        let road = snapshot.map().road_by_id("1").expect("a road");
        let lane = road.section(0).and_then(|s| s.lane(-1)).expect("a lane").lane_id();
        let answer = view.allows(lane, 15.0, VehicleClass::PassengerCar).expect("an answer");
        answer.restriction.map(|one| format!("{} by {}", one.entry.id(), one.entry.source()))
    }

    fn entries(&self) -> usize {
        let output = self.domain.command().args(["overlay", "town", "list", "--json"]).output();
        let list: Value = serde_json::from_slice(&output.expect("ends").stdout).expect("JSON");
        list["entries"].as_array().expect("a list").len()
    }

    /// The audit log: source and decision of each line.
    fn audit(&self) -> Vec<(String, String)> {
        let prefix = self.domain.domain().prefix().to_owned();
        let path = self.domain.cache().join(format!("{prefix}town.overlay.audit.jsonl"));
        let text = fs::read_to_string(path).expect("the audit log");
        let schema = schema("audit");
        let lines = text.lines().map(|line| {
            let line: Value = serde_json::from_str(line).expect("JSON");
            assert_eq!(wrong(&schema, &line), None, "{line}");
            assert!(line["time"].as_str().is_some_and(|time| time.ends_with('Z')), "{line}");
            let word = |name: &str| line[name].as_str().expect("a word").to_owned();
            (word("source"), word("decision"))
        });
        lines.collect()
    }
}

fn entry(id: &str, kind: &str, s: [u32; 2], more: &str) -> String {
    format!(
        r#"{{"id":"{id}","kind":"{kind}","lanes":[{{"road":"1","s":[{},{}],"lane":-1}}]{more}}}"#,
        s[0], s[1]
    )
}

/// Two that say the same of one place are believed; the audit log has it all.
#[test]
fn who_agrees_is_believed() {
    let scene = Scene::new();
    let _daemon = scene.serve();
    let cones = |id: &str, s| entry(id, "closed", s, "");
    let waits = Decision::Waiting { agree: 1, needed: 2 };
    assert_eq!(scene.propose("camera", &cones("cones", [10, 20])), waits);
    assert_eq!(scene.propose("camera", &cones("again", [10, 20])), waits, "one source is one");
    assert_eq!(scene.propose("radar", &cones("far", [40, 50])), waits, "another place");
    assert_eq!(scene.closed_by(), None);
    assert_eq!(scene.propose("radar", &cones("row", [12, 30])), Decision::Accepted);
    assert_eq!(scene.closed_by().as_deref(), Some("proposed/radar/row by radar, camera"));
    let output = scene.domain.command().args(["overlay", "town", "clear"]).output();
    assert!(output.expect("ends").status.success());
    assert_eq!(scene.closed_by(), None);
    let expected = [
        ("camera", "waiting"),
        ("camera", "waiting"),
        ("radar", "waiting"),
        ("radar", "accepted"),
        ("operator", "cleared"),
    ];
    let found = scene.audit();
    let found: Vec<_> = found.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
    assert_eq!(found, expected);
}

/// What is accepted ends in time, and is held to what the source may say.
#[test]
fn only_what_the_policy_allows() {
    let scene = Scene::new();
    let _daemon = scene.serve();
    let wet = |id: &str, more: &str| entry(id, "wet", [10, 20], more);
    scene.refused("nobody", &wet("a", ""), "does not know");
    scene.refused("other", &wet("a", ""), "does not know");
    scene.refused("radar", &wet("a", ""), "may not say");
    scene.refused("camera", &wet("a", r#","confidence":0.4"#), "confidence");
    scene.refused("camera", &wet("a", r#","feed":"x""#), "feed");
    scene.refused("camera", &wet("a", r#","until":1"#), "until");
    scene.refused("camera", &wet("a", "").replace("\"1\"", "\"99999\""), "lanes[0].road");
    let far = r#"{"id":"a","kind":"wet","places":[{"line":[[48,11],[49,11]]}]}"#;
    scene.refused("camera", far, "larger than");
    assert_eq!(scene.propose("probe", &wet("a", "")), Decision::Accepted);
    let begun = SystemTime::now().duration_since(UNIX_EPOCH).expect("after 1970").as_secs_f64();
    let output = scene.domain.command().args(["overlay", "town", "list", "--json"]).output();
    let list: Value = serde_json::from_slice(&output.expect("ends").stdout).expect("JSON");
    let until = list["entries"][0]["until"].as_str().expect("an end");
    let until: mapd_overlay::Moment = until.parse().expect("a moment");
    assert!(until.unix_seconds <= begun + 600.0, "{list}");
    assert_eq!(scene.propose("probe", &wet("b", "")), Decision::Accepted);
    scene.refused("probe", &wet("c", ""), "has 2 entries already");
    assert_eq!(scene.propose("probe", &wet("a", "")), Decision::Accepted, "renewed");
    assert_eq!(scene.propose("probe", &wet("b", "")), Decision::Accepted);
    scene.refused("probe", &wet("b", ""), "more than 5 proposals in a minute");
    assert_eq!(scene.entries(), 2);
    let found = scene.audit();
    let count = |decision: &str| found.iter().filter(|(_, own)| own == decision).count();
    assert_eq!((count("accepted"), count("refused")), (4, 10), "{found:?}");
}

/// A name that is too long with that of its source is refused before anything says that it is accepted, and waits for nobody.
#[test]
fn a_name_too_long_with_its_source_is_refused() {
    let scene = Scene::new();
    let _daemon = scene.serve();
    let named = |length: usize| entry(&"x".repeat(length), "wet", [10, 20], "");
    let longest = 200 - "proposed/probe/".len();
    scene.refused("probe", &named(longest + 1), "1 to 200 bytes");
    scene.refused("camera", &named(longest), "1 to 200 bytes");
    assert_eq!(scene.propose("probe", &named(longest)), Decision::Accepted);
    let decisions: Vec<_> = scene.audit().into_iter().map(|(_, decision)| decision).collect();
    assert_eq!(decisions, ["refused", "refused", "accepted"]);
}

/// Whatever comes over the socket, nothing of it is laid over the map, and the daemon goes on.
#[test]
fn hostile_proposals() {
    let scene = Scene::new();
    let _daemon = scene.serve();
    let long = vec![b'x'; 4 * LONGEST_PROPOSAL];
    let nested = [b"camera\n".to_vec(), vec![b'['; LONGEST_PROPOSAL / 2]].concat();
    let two = format!("camera\n{0},{0}", entry("a", "wet", [10, 20], ""));
    let closes = "camera\n]} {\"entries\":[";
    let all: [&[u8]; 9] = [
        b"",
        b"\n",
        b"camera",
        b"camera\n",
        b"camera\n{}",
        b"\xff\xfe\n\xff",
        &nested,
        two.as_bytes(),
        closes.as_bytes(),
    ];
    for bytes in all {
        let answer = scene.send(bytes);
        assert!(answer.starts_with("refused"), "{:?}: {answer}", String::from_utf8_lossy(bytes));
    }
    let answer = scene.send(&long);
    assert!(answer.is_empty() || answer.starts_with("refused"), "{answer}");
    let proposer = Proposer::new(&scene.domain.domain(), "town", "camera");
    let unfit = proposer.propose(&" ".repeat(LONGEST_PROPOSAL), PATIENCE);
    assert!(matches!(unfit, Err(ProposeError::Unfit)));
    // Many that connect and say nothing, and many that say too much.
    let path = proposals_socket(&scene.domain.domain(), "town");
    let silent: Vec<_> = (0..100).filter_map(|_| UnixStream::connect(&path).ok()).collect();
    drop(silent);
    for i in 0..500 {
        let _ = scene.send(format!("flood{i}\n{{}}").as_bytes());
    }
    assert_eq!(scene.entries(), 0);
    assert!(scene.audit().len() < 200, "floods do not fill the disk");
    assert_eq!(scene.closed_by(), None);
}

/// Of forty proposals beside connections that said nothing, nine were answered.
#[test]
fn who_says_nothing_keeps_no_proposal_out() {
    let scene = Scene::new();
    let _daemon = scene.serve();
    let path = proposals_socket(&scene.domain.domain(), "town");
    let mut idle = Vec::new();
    for _ in 0..40 {
        idle.extend((0..40).map(|_| UnixStream::connect(&path).expect("connects")));
        scene.refused("nobody", &entry("a", "wet", [10, 20], ""), "nobody");
        idle.drain(..idle.len() - 40);
    }
    // What has been said of one that loses its place is no proposal, however whole it looks.
    let whole = format!("probe\n{}", entry("a", "wet", [10, 20], ""));
    let mut said: Vec<_> = (0..60)
        .map(|_| {
            let mut stream = UnixStream::connect(&path).expect("connects");
            stream.write_all(whole.as_bytes()).expect("written");
            stream
        })
        .collect();
    let mut answer = String::new();
    // It may be reset.
    let _ = said[0].read_to_string(&mut answer);
    assert_eq!((answer.as_str(), scene.entries()), ("", 0));
}

/// Without a policy nobody listens; one that is wrong is told by line.
#[test]
fn by_default_nothing_is_accepted() {
    let scene = Scene::new();
    let daemon = scene.domain.serve(&[scene.map.to_str().expect("a name")]);
    let proposer = Proposer::new(&scene.domain.domain(), "town", "camera");
    let asked = proposer.propose(&entry("a", "closed", [10, 20], ""), PATIENCE);
    assert!(matches!(asked, Err(ProposeError::NoDaemon { .. })), "{asked:?}");
    assert_eq!(daemon.stop(), 0);
    fs::write(&scene.policy, POLICY.replace("agree = 2", "agree = 0")).expect("written");
    let [map, policy] = [&scene.map, &scene.policy].map(|path| path.to_str().expect("a name"));
    let mut command = scene.domain.command();
    let output = command.args(["--load", map, "--overlay-from", policy]).output().expect("ends");
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("allow, number 1") && said.contains("agree"), "{said}");
}
