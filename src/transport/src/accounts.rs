//! Users and groups by name.

use crate::regular::read_regular;
use std::io;
use std::path::Path;

/// Longest list of users or groups that is read \[bytes\].
const LONGEST: u64 = 16 << 20;

/// The id of a user: the number itself, or the id of a name in `/etc/passwd`.
///
/// Errors: the list cannot be read; it has no such name. Users that a directory service knows have to be named by number.
pub fn user_id(user: &str) -> io::Result<u32> {
    id(user, Path::new("/etc/passwd"))
}

/// The id of a group: the number itself, or the id of a name in `/etc/group`.
///
/// Errors: as [`user_id`].
pub fn group_id(group: &str) -> io::Result<u32> {
    id(group, Path::new("/etc/group"))
}

fn id(name: &str, list: &Path) -> io::Result<u32> {
    if let Ok(number) = name.parse() {
        return Ok(number);
    }
    // Both lists have the name first and the number third.
    let found = read_regular(list, LONGEST)?.lines().find_map(|line| {
        let mut fields = line.split(':');
        (fields.next() == Some(name)).then(|| fields.nth(1)?.parse().ok())?
    });
    found.ok_or_else(|| {
        let message = format!("{} has no {name:?}; give the number", list.display());
        io::Error::new(io::ErrorKind::NotFound, message)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers() {
        let [user, group] = [user_id, group_id];
        for (found, expected) in [(user("root"), 0), (group("root"), 0), (user("4711"), 4711)] {
            assert_eq!(found.ok(), Some(expected));
        }
        for none in ["", "no such user", "-1", "4294967296"] {
            assert_eq!(user(none).map_err(|e| e.kind()), Err(io::ErrorKind::NotFound), "{none}");
        }
    }
}
