//! What people see on a terminal: colours where they are wanted, and lines of help that fit.

use mapd_tests::command::on_a_terminal;
use mapd_tests::{carried, say};
use std::fs;
use std::path::Path;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// Whether a text has colours or other styles; a bar of progress moves the cursor, too, by codes that end with other letters.
fn is_coloured(text: &str) -> bool {
    text.split("\u{1b}[").skip(1).any(|code| {
        let end = code.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';');
        end.starts_with('m')
    })
}

/// Columns of most terminals.
const COLUMNS: usize = 80;

/// Where there is no terminal to be had, what a test says.
const SKIPPED: &str = "SKIPPED: there is no program `script` that offers a terminal";

/// A folder with a map that has a finding, and a command on a terminal there.
struct Scene(tempfile::TempDir);

impl Scene {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let town = fs::read_to_string(carried("town.xodr")).expect("read");
        let odd = town.replacen("<road ", "<road odd=\"1\" ", 1);
        fs::write(folder.path().join("odd.xodr"), odd).expect("written");
        Self(folder)
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    /// What `mapd …` shows, and whether in colours; none without a terminal.
    fn shows(&self, args: &str, variables: &[(&str, &str)]) -> Option<(String, bool)> {
        let shown = on_a_terminal(&format!("{MAPD} {args}"), COLUMNS, self.path(), variables)?;
        let is_coloured = is_coloured(&shown);
        Some((shown, is_coloured))
    }
}

#[test]
fn colours_where_they_are_wanted() {
    let scene = Scene::new();
    for (args, said) in [
        ("check odd.xodr", "warning"),
        ("compile odd.xodr -o odd.mapd --quiet", "warning"),
        ("check missing.xodr", "mapd:"),
        ("chekc", "error:"),
        ("--help", "Usage:"),
        ("help query", "Usage:"),
    ] {
        let Some((shown, is_coloured)) = scene.shows(args, &[]) else { return say(SKIPPED) };
        assert!(shown.contains(said) && is_coloured, "{args}: {shown:?}");
        for plain in [("NO_COLOR", "1"), ("CLICOLOR", "0"), ("TERM", "dumb")] {
            let (shown, is_coloured) = scene.shows(args, &[plain]).expect("as before");
            assert!(shown.contains(said) && !is_coloured, "{args} with {plain:?}: {shown:?}");
        }
    }
}

/// What goes to a file or a pipe has none, whatever is on a terminal beside it; nor has what programs read.
#[test]
fn no_colours_for_programs() {
    let scene = Scene::new();
    let read = |name: &str| fs::read_to_string(scene.path().join(name)).expect("read");
    for forced in [&[][..], &[("CLICOLOR_FORCE", "1")]] {
        let shows = |args: &str| scene.shows(args, forced);
        let Some((shown, _)) = shows("check odd.xodr >out") else { return say(SKIPPED) };
        assert!(read("out").contains("warning") && !is_coloured(&read("out")), "{shown}");
        let _ = shows("compile odd.xodr -o odd.mapd --quiet 2>err");
        assert!(read("err").contains("warning") && !is_coloured(&read("err")), "{forced:?}");
        for args in ["check odd.xodr --json", "inspect odd.xodr --json"] {
            let (shown, is_coloured) = shows(&format!("{args} 2>err")).expect("as before");
            assert!(shown.starts_with('{') && !is_coloured, "{args} {forced:?}: {shown:?}");
        }
    }
}

/// The longest line of a help on a terminal of so many columns.
fn longest(scene: &Scene, args: &str, columns: usize) -> Option<usize> {
    let plain = [("NO_COLOR", "1")];
    let shown = on_a_terminal(&format!("{MAPD} {args}"), columns, scene.path(), &plain)?;
    assert!(shown.contains("Usage:"), "{args}: {shown:?}");
    shown.lines().map(|line| line.trim_end().chars().count()).max()
}

#[test]
fn help_is_as_wide_as_the_terminal_but_not_too_wide() {
    let scene = Scene::new();
    for args in ["-h", "status --help", "bench --help"] {
        for (columns, least) in [(60, 50), (80, 60), (100, 80), (200, 80)] {
            let Some(longest) = longest(&scene, args, columns) else { return say(SKIPPED) };
            // Lines beyond a hundred columns are hard to read.
            let most = columns.min(100);
            assert!((least..=most).contains(&longest), "{args} at {columns}: {longest}");
        }
    }
}
