//! Small text files per map: the last generation number, which outlives the daemon, and what is staged. (What is served now
//! has a record that readers wait on: `observer`.)

use crate::claim::served_by;
use crate::domain::Domain;
use crate::limits::TRANSPORT_REVISION;
use crate::payload::GenerationInfo;
use crate::regular::read_owned;
use crate::share::Share;
use std::fs::{self, File};
use std::io::{self, Write};
use std::os::unix::fs::OpenOptionsExt;
use std::path::{Path, PathBuf};

/// Suffix of the file of the last generation number of a map.
pub const GENERATION_SUFFIX: &str = ".generation";
/// Suffix of the file of a map's record: what is served; see [`super::Observer`].
pub const RECORD_SUFFIX: &str = ".published";
const STAGED: &str = ".staged";

/// Longest record that is read \[bytes\]: they have a few hundred.
const LONGEST: u64 = 4096;

/// Largest number of a generation. Numbers begin with the milliseconds since 1970 and rise by one: a larger one, of the year
/// 287,000, is nonsense that was not handed out, and to go on from it would soon leave none.
pub const LARGEST_GENERATION: u64 = 1 << 53;

/// A generation's number as a file has it.
///
/// Errors: no number, or one above [`LARGEST_GENERATION`].
pub fn parse_generation(text: &str) -> io::Result<u64> {
    let nonsense = |reason: String| io::Error::new(io::ErrorKind::InvalidData, reason);
    let number: u64 = text.trim().parse().map_err(|error| nonsense(format!("{error}")))?;
    match number <= LARGEST_GENERATION {
        true => Ok(number),
        false => Err(nonsense(format!(
            "expected the number of a generation, at most {LARGEST_GENERATION}, found {number}"
        ))),
    }
}

/// The number that a file of this process's user holds; 0 if it is not there.
///
/// Errors: it cannot be read, is no regular file of this user, or holds no number that makes sense.
pub fn read_generation_file(path: &Path) -> io::Result<u64> {
    match read_owned(path, rustix::process::geteuid().as_raw(), LONGEST) {
        Ok(text) => parse_generation(&text),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(0),
        Err(error) => Err(error),
    }
}

/// The last generation number handed out for a map; 0 if none was.
///
/// Errors: the file cannot be read, or holds no number.
pub fn read_generation(domain: &Domain, map: &str) -> io::Result<u64> {
    read_generation_file(&domain.map_file(map, GENERATION_SUFFIX))
}

/// Remembers that a generation number has been handed out. Only the daemon that has claimed the map does so.
///
/// Errors: what the system says.
pub fn write_generation(domain: &Domain, map: &str, generation: u64) -> io::Result<()> {
    replace_text(&domain.map_file(map, GENERATION_SUFFIX), &generation.to_string())
}

/// The generation that was staged; `None` if none was.
fn read_staged(domain: &Domain, map: &str) -> Option<(u32, GenerationInfo)> {
    parse(&read_owned(&domain.map_file(map, STAGED), domain.owner(), LONGEST).ok()?)
}

/// The generation that waits to be served, if a daemon that lives has staged one. Reads small files; attaches to nothing.
pub fn pending(domain: &Domain, map: &str) -> Option<GenerationInfo> {
    let (_, info) = read_staged(domain, map)?;
    served_by(domain, map).map(|_| info)
}

/// Records what is staged now, for the group that the daemon shares with.
///
/// Errors: what the system says.
pub fn write_staged(
    domain: &Domain,
    map: &str,
    info: &GenerationInfo,
    share: Share,
) -> io::Result<()> {
    let path = domain.map_file(map, STAGED);
    let new = unfinished(&path);
    let mut file = create_anew(&new)?;
    share.written(&file)?;
    file.write_all(print(info).as_bytes())?;
    fs::rename(&new, &path)
}

/// Nothing is staged any more.
///
/// Errors: what the system says.
pub fn remove_staged(domain: &Domain, map: &str) -> io::Result<()> {
    remove_text(&domain.map_file(map, STAGED))
}

/// Removes a file, and what a process that was killed while replacing it has left.
pub(super) fn remove_text(path: &Path) -> io::Result<()> {
    [unfinished(path), path.to_owned()].iter().try_for_each(|file| match fs::remove_file(file) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    })
}

/// Where a text stands until it is whole.
pub(super) fn unfinished(path: &Path) -> PathBuf {
    let mut new = path.as_os_str().to_owned();
    new.push(".new");
    new.into()
}

/// Makes a file in the place of what a killed writer has left, or of whatever else is there.
pub(super) fn create_anew(path: &Path) -> io::Result<File> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        // Whatever the umask is: nobody else writes in a folder that is shared.
        _ => File::options().write(true).create_new(true).mode(0o600).open(path),
    }
}

/// Replaces a file so that a reader sees the old text or the new one.
///
/// Errors: what the system says.
pub fn replace_text(path: &Path, text: &str) -> io::Result<()> {
    let new = unfinished(path);
    create_anew(&new)?.write_all(text.as_bytes())?;
    fs::rename(&new, path)
}

/// As [`replace_text`], and the text is on the disk when it returns: after a power cut there is the old one or the new one.
///
/// Errors: what the system says.
pub fn replace_text_durably(path: &Path, text: &str) -> io::Result<()> {
    let new = unfinished(path);
    let mut file = create_anew(&new)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()?;
    fs::rename(&new, path)?;
    match path.parent() {
        Some(folder) => File::open(folder)?.sync_all(),
        None => Ok(()),
    }
}

fn print(info: &GenerationInfo) -> String {
    format!(
        "revision {TRANSPORT_REVISION}\ngeneration {}\nlength {}\npublished_unix_ns {}\ndaemon_pid {}\nlayout_id {}\ncontent_hash {}\ninput_hash {}\n",
        info.generation,
        info.length,
        info.published_unix_ns,
        info.daemon_pid,
        hex(&info.layout_id),
        hex(&info.content_hash),
        hex(&info.input_hash)
    )
}

fn parse(text: &str) -> Option<(u32, GenerationInfo)> {
    let field =
        |name: &str| text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
    let number = |name: &str| field(name)?.parse().ok();
    let hash = |name: &str| unhex(field(name)?);
    let info = GenerationInfo {
        generation: number("generation")?,
        length: number("length")?,
        published_unix_ns: number("published_unix_ns")?,
        daemon_pid: number("daemon_pid")?,
        layout_id: hash("layout_id")?,
        content_hash: hash("content_hash")?,
        input_hash: hash("input_hash")?,
    };
    Some((u32::try_from(number("revision")?).ok()?, info))
}

/// Bytes as hexadecimal digits, two for each, as hashes are written.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn unhex(text: &str) -> Option<[u8; 32]> {
    let mut bytes = [0; 32];
    if text.len() != 2 * bytes.len() {
        return None;
    }
    for (i, byte) in bytes.iter_mut().enumerate() {
        *byte = u8::from_str_radix(text.get(2 * i..2 * i + 2)?, 16).ok()?;
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let info = GenerationInfo {
            generation: u64::MAX,
            length: 1,
            published_unix_ns: 2,
            daemon_pid: 3,
            layout_id: std::array::from_fn(|i| i as u8),
            content_hash: [0xff; 32],
            input_hash: [0xa0; 32],
        };
        let text = print(&info);
        assert_eq!(parse(&text), Some((TRANSPORT_REVISION, info)));
        for (at, _) in text.match_indices('\n').skip(1) {
            let cut = &text[..at - 1];
            assert_ne!(
                parse(cut),
                Some((TRANSPORT_REVISION, info)),
                "a cut record is not the whole one: {cut}"
            );
        }
    }

    /// A daemon that was killed while it replaced a record left the new one behind for good.
    #[test]
    fn an_unfinished_record_goes_with_the_finished_one() {
        let folder = std::env::temp_dir().join(format!("mapd-record-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let path = folder.join("town.staged");
        for left in [
            vec![],
            vec![path.clone()],
            vec![unfinished(&path)],
            vec![unfinished(&path), path.clone()],
        ] {
            left.iter().for_each(|file| fs::write(file, "text").expect("written"));
            remove_text(&path).expect("removed");
            assert_eq!(fs::read_dir(&folder).expect("the folder").count(), 0, "{left:?}");
        }
        fs::remove_dir(&folder).expect("removed");
    }
}
