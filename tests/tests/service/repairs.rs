//! What goes bad in shared memory is found whatever it is, and a reload repairs it.

use mapd::control::ReloadResult;
use mapd_client::Client;
use mapd_tests::test_domain::{PATIENCE, TestDomain};
use mapd_transport::GenerationInfo;
use std::fs::{self, OpenOptions, Permissions};
use std::os::unix::fs::{FileExt, PermissionsExt};
use std::time::{Duration, Instant};

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// What may go bad of a generation, and the byte of its segment where it lies.
#[derive(Clone, Copy, Debug)]
enum DamagedPart {
    /// Of what is said about it: the number.
    Generation,
    /// Its length.
    Length,
    /// Its hash.
    Said,
    /// Of the archive: the first bytes, by which it is known.
    Magic,
    /// Its header's hash.
    Hash,
    /// The places of its tables.
    Places,
    /// A row.
    Middle,
    /// The last bytes.
    End,
}

const PARTS: [DamagedPart; 8] = [
    DamagedPart::Generation,
    DamagedPart::Length,
    DamagedPart::Said,
    DamagedPart::Magic,
    DamagedPart::Hash,
    DamagedPart::Places,
    DamagedPart::Middle,
    DamagedPart::End,
];

fn find(bytes: &[u8], wanted: &[u8], from: usize) -> usize {
    let rest = bytes.get(from..).expect("a place");
    from + rest.windows(wanted.len()).position(|window| window == wanted).expect("it is there")
}

/// Changes a bit of a part of what is served; no process is told.
fn damage(place: &TestDomain, part: DamagedPart, info: &GenerationInfo) {
    let data = place.segments().into_iter().find(|path| {
        let is_data = path.extension().is_some_and(|e| e == "data");
        is_data
            && fs::read(path).is_ok_and(|bytes| {
                bytes.windows(8).any(|window| window == info.generation.to_le_bytes())
            })
    });
    let path = data.expect("the data segment of this generation");
    let bytes = fs::read(&path).expect("read");
    let said = find(&bytes, &info.generation.to_le_bytes(), 0);
    let archive = find(&bytes, &mapd_archive::MAGIC, said);
    let length = usize::try_from(info.length).expect("a length");
    let at = match part {
        DamagedPart::Generation => said,
        DamagedPart::Length => find(&bytes, &info.length.to_le_bytes(), said),
        DamagedPart::Said => find(&bytes, &info.content_hash, said),
        DamagedPart::Magic => archive,
        DamagedPart::Hash => find(&bytes, &info.content_hash, archive),
        DamagedPart::Places => archive + mapd_archive::HEADER_LENGTH,
        DamagedPart::Middle => archive + length / 2,
        DamagedPart::End => archive + length - 1,
    };
    fs::set_permissions(&path, Permissions::from_mode(0o600)).expect("our own");
    let file = OpenOptions::new().write(true).open(&path).expect("opens");
    file.write_all_at(&[bytes[at] ^ 1], at as u64).expect("written");
}

/// Damage of the header, of the places of the tables and of what is said about a generation once was "skipped", for no client
/// could attach; and a reload said that nothing had changed.
#[test]
fn damage_is_damage_and_a_reload_publishes_anew() {
    let place = TestDomain::new(MAPD);
    let town = mapd_tests::carried("town.xodr").display().to_string();
    let _daemon = place.serve(&[&town, "--scrub", "1"]);
    let newest = || Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
    assert_eq!(place.reload("town").result, ReloadResult::Unchanged);
    for part in PARTS {
        let before = place.state("town");
        let served = before.served.expect("served").generation;
        let subscription = mapd_transport::Subscription::connect(
            &place.domain(),
            "town",
            Instant::now() + PATIENCE,
        );
        let info = *subscription.expect("attaches").current().info();
        assert_eq!(info.generation, served);
        damage(&place, part, &info);
        let until = Instant::now() + PATIENCE;
        let scrubs = loop {
            let scrubs = place.state("town").scrubs;
            if scrubs.failures > before.scrubs.failures {
                break scrubs;
            }
            assert!(Instant::now() < until, "{part:?} is not found: {scrubs:?}");
            std::thread::sleep(Duration::from_millis(50));
        };
        assert_eq!(scrubs.last_failed, Some(true), "{part:?}");
        assert_eq!(scrubs.skipped, 0, "{part:?}: {scrubs:?}");
        let report = place.reload("town");
        assert_eq!(report.result, ReloadResult::Published, "{part:?}: {report:?}");
        let snapshot = newest().snapshot();
        assert!(snapshot.generation() > served, "{part:?}");
        snapshot.verify().expect("proves");
        assert_ne!(place.state("town").scrubs.last_failed, Some(true), "{part:?}");
    }
    assert_eq!(place.reload("town").result, ReloadResult::Unchanged);
}
