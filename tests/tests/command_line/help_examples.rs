//! What long help and man pages show as examples does what it says.

use mapd_tests::carried;
use mapd_tests::test_domain::TestDomain;
use std::os::unix::fs::symlink;
use std::path::Path;

const MAPD: &str = env!("CARGO_BIN_EXE_mapd_under_test");

/// What serves until it is ended, and is only looked at.
const SERVING: [&str; 2] = ["mapd --load", "mapd view"];

/// The lines to type of a command and of those below it, in the order of the help.
fn examples(command: &clap::Command, names: &str) -> Vec<(String, String)> {
    let help = command.get_after_long_help().map(ToString::to_string).unwrap_or_default();
    let (_, examples_of_it) = help.split_once("Examples:").unwrap_or_default();
    let lines = examples_of_it.lines().filter_map(|line| line.strip_prefix("    "));
    let mut all: Vec<_> = lines.map(|line| (names.to_owned(), line.to_owned())).collect();
    for (below, names) in below(command, names) {
        all.extend(examples(below, &names));
    }
    all
}

/// Commands below one that people see, with the words that lead to them.
fn below<'a>(
    command: &'a clap::Command,
    names: &'a str,
) -> impl Iterator<Item = (&'a clap::Command, String)> {
    let shown = command.get_subcommands().filter(|one| !one.is_hide_set());
    shown.map(move |one| (one, format!("{names} {}", one.get_name())))
}

/// Commands without an example.
fn without(command: &clap::Command, names: &str, told: &[(String, String)]) -> Vec<String> {
    let lacks = |names: &str| told.iter().all(|(command, _)| command != names);
    let own = lacks(names).then(|| names.to_owned());
    let others = below(command, names).flat_map(|(below, names)| without(below, &names, told));
    own.into_iter().chain(others).collect()
}

/// A folder as the examples presume it: a town, a folder of maps, a configuration, a pair of keys, and mapd in the path.
fn prepare(folder: &Path) {
    let town = std::fs::read(carried("town.xodr")).expect("a map");
    let home = folder.join(".local/share/bash-completion/completions");
    let fish = folder.join(".config/fish/completions");
    for made in [&folder.join("maps"), &folder.join("bin"), &home, &fish, &folder.join(".zfunc")] {
        std::fs::create_dir_all(made).expect("a folder");
    }
    for map in ["town.xodr", "maps/north.xodr", "maps/south.xodr"] {
        std::fs::write(folder.join(map), &town).expect("written");
    }
    std::fs::write(folder.join("mapd.toml"), "[[map]]\nfile = \"town.xodr\"\n").expect("written");
    let pair = minisign::KeyPair::generate_unencrypted_keypair().expect("keys");
    let public = pair.pk.to_box().expect("a key").into_string();
    std::fs::write(folder.join("mapd.pub"), public).expect("written");
    let secret = pair.sk.to_box(None).expect("a key").into_string();
    std::fs::write(folder.join("mapd.key"), secret).expect("written");
    symlink(MAPD, folder.join("bin/mapd")).expect("a link");
}

#[test]
fn every_command_has_examples_that_work() {
    let folder = tempfile::tempdir().expect("a folder");
    prepare(folder.path());
    let domain = TestDomain::new(MAPD);
    let mut daemon = domain.command();
    daemon.current_dir(folder.path()).args(["--load", "town.xodr"]);
    let mut daemon = domain.spawn(daemon);
    daemon.wait_until_serving();
    let path = std::env::var("PATH").expect("a path");
    let path = format!("{}:{path}", folder.path().join("bin").display());
    let town = std::fs::read_to_string(carried("town.xodr")).expect("a map");
    let program = mapd::cli::command();
    let examples = examples(&program, "mapd");
    for (number, (command, line)) in examples.iter().enumerate() {
        if SERVING.iter().any(|serving| line.starts_with(serving)) {
            let parsed = mapd::cli::command().try_get_matches_from(line.split_whitespace());
            assert!(parsed.is_ok(), "{command}: {line}: {parsed:?}");
            continue;
        }
        if line.starts_with("mapd reload") {
            // Nothing is compiled again that has not changed.
            let changed = town.replace("Street 1\"", &format!("Street 1, {number}\""));
            std::fs::write(folder.path().join("town.xodr"), changed).expect("written");
        }
        let mut shell = domain.command_of("bash");
        shell.args(["-o", "pipefail", "-ec", line]).current_dir(folder.path());
        let output = shell.env("PATH", &path).env("HOME", folder.path()).output().expect("runs");
        let told = String::from_utf8_lossy(&output.stderr);
        // What a machine lacks is for doctor to find.
        let found = line.starts_with("mapd doctor") && output.status.code() == Some(1);
        assert!(output.status.success() || found, "{command}: {line}: {told}");
    }
    let without = without(&program, "mapd", &examples);
    assert!(without.is_empty(), "without examples: {without:?}");
    assert_eq!(daemon.stop(), 0);
}
