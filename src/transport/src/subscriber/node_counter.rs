//! iceoryx2's counter of nodes: the one file of a domain whose name everybody knows before it is there.
//!
//! iceoryx2 0.10 opens whatever has the name, maps it, and makes it for everybody to write. A process that truncates a file that others have mapped ends them by
//! SIGBUS. The daemon therefore makes it before iceoryx2 does, and where another user was faster, nobody maps it: `/dev/shm` is sticky, so that what has the name once
//! belongs to its owner for as long as he likes.

use crate::domain::{Domain, SHARED_MEMORY_FOLDER};
use crate::error::AttachError;
use crate::regular::{OWN_FILE, Untrusted, open_guarded};
use crate::unfinished::ForeignFile;
use crate::user::not_owned;
use rustix::fs::{Mode, OFlags, Stat};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Its name after the prefix: hash of a type name, `_node`, version, suffix.
const NAME: &str = "9204dd183d1c4d8e1ff592a30766ffa6765aa8b5_node.0_10_0.global_mgmt";

/// What a new one holds: the version of iceoryx2, of 16 bits each part, and no node yet.
const NEW: [u8; 16] = {
    const VERSION: u64 = 10 << 16;
    let ([a, b, c, d, e, f, g, h], zero) = (VERSION.to_le_bytes(), 0);
    [a, b, c, d, e, f, g, h, zero, zero, zero, zero, zero, zero, zero, zero]
};

/// Mode while it is made: as iceoryx2 has it, for which a file that cannot be read is not complete.
const MAKING: Mode = Mode::WUSR;

/// Attempts to make it, should another daemon make or remove it just then.
const ATTEMPTS: usize = 8;

/// Where the counter is.
pub fn node_counter(domain: &Domain) -> PathBuf {
    Path::new(SHARED_MEMORY_FOLDER).join(format!("{}{NAME}", domain.prefix()))
}

/// Makes the counter, or makes it anew where other users may have had it open: what is so old was made by iceoryx2. For daemons, under the exclusive attach lock.
///
/// Errors: [`AttachError::PermissionDenied`], [`AttachError::UnknownOwner`] if another user has the name; what the system says.
pub fn prepare_node_counter(domain: &Domain) -> Result<(), AttachError> {
    let path = node_counter(domain);
    let us = rustix::process::geteuid().as_raw();
    let failed = |error: io::Error| AttachError::io(&path, error);
    for _ in 0..ATTEMPTS {
        match open_guarded(&path, OFlags::RDONLY, Mode::empty(), us) {
            Ok((_, stat)) if is_sound(&stat) => return Ok(()),
            Err(Untrusted::OtherOwner(owner)) => return Err(not_owned(&path, owner, us)),
            Err(Untrusted::Io(error)) if error.kind() == io::ErrorKind::NotFound => {}
            // Processes that count by the one that goes are told apart by their ids all the same.
            Ok(_) | Err(Untrusted::Io(_)) => match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(failed(error)),
                _ => {}
            },
        }
        match create(&path, us) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            other => return other.map_err(failed),
        }
    }
    Err(failed(io::ErrorKind::AlreadyExists.into()))
}

/// What another user has under the counter's name, so that nobody can subscribe; none as a rule.
pub fn foreign_node_counter(domain: &Domain) -> Option<ForeignFile> {
    let path = node_counter(domain);
    match open_guarded(&path, OFlags::RDONLY, Mode::empty(), domain.owner()) {
        Err(Untrusted::OtherOwner(owner)) => Some(ForeignFile { path, owner }),
        _ => None,
    }
}

/// Checks that the counter is its daemon's own. For subscribers, before iceoryx2 opens it and under the attach lock.
///
/// Errors: another user has the name; [`AttachError::NoSubscribers`] if there is none.
pub(super) fn check_node_counter(domain: &Domain, map: &str) -> Result<(), AttachError> {
    let path = node_counter(domain);
    let us = rustix::process::geteuid().as_raw();
    match open_guarded(&path, OFlags::RDONLY, Mode::empty(), us) {
        Ok((_, stat)) if is_private(&stat) => Ok(()),
        Ok(_) => Err(AttachError::Stuck { file: path }),
        Err(Untrusted::OtherOwner(owner)) => Err(not_owned(&path, owner, us)),
        Err(Untrusted::Io(error)) if error.kind() == io::ErrorKind::NotFound => {
            Err(AttachError::NoSubscribers { map: map.to_owned() })
        }
        Err(Untrusted::Io(error)) => Err(AttachError::io(path, error)),
    }
}

/// Whether it is whole, and nobody else can open it.
fn is_private(stat: &Stat) -> bool {
    stat.st_size == NEW.len() as i64 && Mode::from_raw_mode(stat.st_mode) == OWN_FILE
}

/// Whether it is that, and no file of its user's that a stranger has given this name.
fn is_sound(stat: &Stat) -> bool {
    is_private(stat) && stat.st_nlink == 1
}

fn create(path: &Path, us: u32) -> io::Result<()> {
    let access = OFlags::WRONLY | OFlags::CREATE | OFlags::EXCL;
    let (file, _) = open_guarded(path, access, MAKING, us)?;
    let mut file = File::from(file);
    let made = file.write_all(&NEW).and_then(|()| Ok(rustix::fs::fchmod(&file, OWN_FILE)?));
    made.inspect_err(|_| {
        // What cannot be removed is swept by the next daemon.
        let _ = fs::remove_file(path);
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    /// A domain whose counter is removed at the end.
    struct Counted(Domain);

    impl Drop for Counted {
        fn drop(&mut self) {
            let _ = fs::remove_file(node_counter(&self.0));
        }
    }

    /// Whatever this user has under the name, in the end it is a counter that nobody else could have opened.
    #[test]
    fn a_counter_that_others_could_write_is_made_anew() {
        let place = Counted(Domain::new(&format!("count{}_", std::process::id())).expect("good"));
        let (file, linked) =
            (node_counter(&place.0), node_counter(&place.0).with_extension("linked"));
        let ino = || rustix::fs::lstat(&file).expect("there").st_ino;
        let prepare = || {
            prepare_node_counter(&place.0).expect("made");
            let stat = rustix::fs::lstat(&file).expect("there");
            assert!(is_sound(&stat), "{stat:?}");
            assert_eq!(fs::read(&file).expect("read").get(..8), NEW.get(..8));
        };
        prepare();
        let first = ino();
        prepare();
        assert_eq!(ino(), first, "a sound one stays");
        let wide = fs::Permissions::from_mode(0o666);
        fs::set_permissions(&file, wide).expect("changed");
        prepare();
        fs::write(&file, "").expect("emptied");
        prepare();
        fs::remove_file(&file).expect("removed");
        fs::write(&linked, NEW).expect("written");
        fs::set_permissions(&linked, fs::Permissions::from_mode(0o644)).expect("changed");
        fs::hard_link(&linked, &file).expect("linked");
        prepare();
        assert_eq!(fs::metadata(&linked).expect("there").permissions().mode() & 0o777, 0o644);
        fs::remove_file(&file).expect("removed");
        std::os::unix::fs::symlink(&linked, &file).expect("a link");
        prepare();
        assert_eq!(fs::metadata(&linked).expect("there").permissions().mode() & 0o777, 0o644);
        fs::remove_file(&linked).expect("removed");
    }
}
