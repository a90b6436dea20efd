//! Records and segments that are not what a daemon makes: an observer says so, and neither hangs nor crashes.

use mapd_client::{Client, ClientError};
use mapd_tests::say;
use mapd_tests::test_domain::{Daemon, PATIENCE, TestDomain};
use mapd_transport::AttachError;
use std::fs::File;
use std::ops::Range;
use std::os::unix::fs::{FileExt, MetadataExt};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Bytes of a record, and of one of its two slots.
const PAGE: usize = 4096;
const SLOT: usize = 55 * 8;

/// Where the parts of a record lie.
const HEARTBEAT: Range<usize> = 16..24;
const SLOTS: usize = 24;
const SEQUENCE: Range<usize> = 12..16;

/// A served map, its record, and its segment.
struct Served {
    place: TestDomain,
    _daemon: Daemon,
    record: PathBuf,
    segment: PathBuf,
    generation: u64,
}

impl Served {
    fn new() -> Self {
        let place = TestDomain::new(MAPD);
        let daemon = place.serve(&[&mapd_tests::carried("town.xodr").display().to_string()]);
        let record = place.domain().root().join("town.published");
        let is_data =
            |path: &PathBuf| path.extension().is_some_and(|extension| extension == "data");
        let segment = place.segments().into_iter().find(is_data).expect("a segment");
        let client = Client::connect_in(&place.domain(), "town", PATIENCE).expect("attaches");
        let generation = client.snapshot().generation();
        Self { place, _daemon: daemon, record, segment, generation }
    }

    /// Attaches once, without waiting.
    fn connect(&self) -> Result<Client, ClientError> {
        Client::connect_in(&self.place.domain(), "town", Duration::ZERO)
    }

    /// What is served is had whole, or nothing at all; whether it was had.
    fn is_had(&self, case: &str) -> bool {
        match self.connect() {
            Ok(client) => {
                let snapshot = client.snapshot();
                assert_eq!(snapshot.generation(), self.generation, "{case}");
                snapshot.verify().unwrap_or_else(|error| panic!("{case}: {error}"));
                true
            }
            Err(_) => false,
        }
    }
}

/// Every byte of the record, changed in several ways: an error where the reader looks, nothing elsewhere.
#[test]
fn every_byte_of_a_record_may_be_damaged() {
    let served = Served::new();
    let file = File::options().read(true).write(true).open(&served.record).expect("opens");
    let mut whole = [0; PAGE];
    file.read_exact_at(&mut whole, 0).expect("a page");
    let sequence = u32::from_le_bytes(whole[12..16].try_into().expect("four bytes"));
    let holds = SLOTS + SLOT * (sequence as usize % 2);
    let holds = holds..holds + SLOT;
    for (at, byte) in whole.into_iter().enumerate() {
        let matters = (at < SLOTS && !HEARTBEAT.contains(&at)) || holds.contains(&at);
        for change in [0xff, 0x01, 0x80] {
            file.write_all_at(&[byte ^ change], at as u64).expect("written");
            let case = format!("byte {at} xor {change:#x}");
            assert_eq!(served.is_had(&case), !matters, "{case}");
        }
        file.write_all_at(&[byte], at as u64).expect("written");
    }
    assert!(served.is_had("mended"));
}

/// Pages of noise, of nothing, of ones; and a client that follows meanwhile keeps what it holds.
#[test]
fn a_record_may_hold_anything() {
    let served = Served::new();
    let client = Client::connect_in(&served.place.domain(), "town", PATIENCE).expect("attaches");
    let file = File::options().read(true).write(true).open(&served.record).expect("opens");
    let mut whole = [0; PAGE];
    file.read_exact_at(&mut whole, 0).expect("a page");
    let held = u32::from_le_bytes(whole[SEQUENCE].try_into().expect("four bytes"));
    let mut state = 1_u64;
    let mut noise = |page: &mut [u8]| {
        for byte in page {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            *byte = (state >> 56) as u8;
        }
    };
    for round in 0..500_u32 {
        let mut page = whole;
        match round {
            0 => page.fill(0),
            1 => page.fill(0xff),
            _ if round % 3 == 0 => noise(&mut page),
            // Behind a header that is right, under another sequence or the same.
            _ => {
                noise(&mut page[SLOTS..]);
                let sequence = held + if round % 3 == 1 { round } else { 0 };
                page[SEQUENCE].copy_from_slice(&sequence.to_le_bytes());
            }
        }
        file.write_all_at(&page, 0).expect("written");
        assert!(!served.is_had("noise"), "round {round}");
        // Under the sequence of what it holds, a slot is not looked at again.
        let is_known = round > 1 && round % 3 == 2;
        assert_eq!(client.refresh().is_ok(), is_known, "round {round}");
        assert_eq!(client.snapshot().generation(), served.generation);
    }
    file.write_all_at(&whole, 0).expect("written");
    assert!(served.is_had("mended"));
    assert_eq!(client.refresh().expect("mended").generation(), served.generation);
}

/// Something else under the record's name, or the segment's.
#[test]
fn what_is_no_file_of_the_daemon_is_refused() {
    let served = Served::new();
    for name in [&served.record, &served.segment] {
        let kept = name.with_extension("kept");
        std::fs::rename(name, &kept).expect("put aside");
        let bytes = std::fs::read(&kept).expect("bytes");
        let remove = || {
            let _ = std::fs::remove_file(name).or_else(|_| std::fs::remove_dir(name));
        };
        let refused = |case: &str, make: &dyn Fn(&Path)| {
            make(name);
            assert!(!served.is_had(case), "{case} of {}", name.display());
            remove();
        };
        refused("nothing", &|_| {});
        refused("a link", &|name| std::os::unix::fs::symlink(&kept, name).expect("linked"));
        refused("a pipe", &|name| {
            let made = Command::new("mkfifo").arg(name).status();
            assert!(made.is_ok_and(|status| status.success()));
        });
        refused("a folder", &|name| std::fs::create_dir(name).expect("made"));
        refused("an empty file", &|name| std::fs::write(name, []).expect("written"));
        refused("half of it", &|name| {
            std::fs::write(name, &bytes[..bytes.len() / 2]).expect("written");
        });
        refused("a file of holes", &|name| {
            File::create(name).expect("made").set_len(bytes.len() as u64).expect("sized");
        });
        if *name == served.segment {
            refused("a copy", &|name| std::fs::write(name, &bytes).expect("written"));
        }
        std::fs::rename(&kept, name).expect("put back");
        assert!(served.is_had("put back"));
    }
}

/// Files that another user owns, in a folder of one's own.
#[test]
fn files_of_another_owner_are_refused() {
    let served = Served::new();
    let nobody = Some(65_534);
    for name in [&served.record, &served.segment] {
        let us = std::fs::metadata(name).expect("there").uid();
        if std::os::unix::fs::chown(name, nobody, None).is_err() {
            return say("SKIPPED: this user may not give files away");
        }
        let error = served.connect().err().expect("refused");
        let told = matches!(&error, ClientError::Attach(AttachError::PermissionDenied { path, owner: 65_534, .. }) if path == name);
        assert!(told, "{error}");
        std::os::unix::fs::chown(name, Some(us), None).expect("given back");
        assert!(served.is_had("given back"));
    }
}
