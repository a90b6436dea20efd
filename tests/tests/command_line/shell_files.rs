//! What `mapd completions` and `mapd man` write, used as shells and man use it.

use crate::shell::text;
use mapd_tests::say;
use std::path::Path;
use std::process::Command;

/// Commands that people see.
fn commands() -> Vec<clap::Command> {
    let program = mapd::cli::command();
    program.get_subcommands().filter(|command| !command.is_hide_set()).cloned().collect()
}

#[test]
fn every_shell_and_man_have_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = text(&["completions", shell]);
        for command in commands() {
            assert!(script.contains(command.get_name()), "{command} for {shell}");
        }
        assert!(!script.contains("bench-client"), "{shell} offers what is hidden");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let pages = folder.path().join("man1");
    text(&["man", pages.to_str().expect("text")]);
    for command in commands() {
        let page = std::fs::read_to_string(pages.join(format!("mapd-{command}.1")));
        assert!(page.is_ok_and(|page| page.starts_with(".ie")), "a page for {command}");
    }
    assert!(pages.join("mapd.1").exists());
    assert!(!pages.join("mapd-bench-client.1").exists());
}

/// What is typed, and what a shell then offers, all of it.
const COMPLETED: [(&str, &[&str]); 8] = [
    ("mapd ch", &["check"]),
    ("mapd bench", &["bench"]),
    ("mapd check --form", &["--format"]),
    ("mapd check --format ", &["json", "sarif", "text", "xqar"]),
    ("mapd query town.xodr near", &["nearest", "nearest-marks"]),
    ("mapd overlay town ap", &["apply"]),
    ("mapd help unit", &["units"]),
    ("mapd completions fi", &["fish"]),
];

/// What a shell's program offers, in order; none where there is no such shell.
fn offers(shell: &str, program: &str, script: &Path, typed: &str) -> Option<Vec<String>> {
    let mut command = Command::new(shell);
    command.args(["-c", program]).arg(if shell == "bash" { "complete" } else { "--" });
    let output = command.arg(typed).env("SCRIPT", script).output().ok()?;
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let words = told.lines().filter_map(|line| line.split('\t').next());
    let mut words: Vec<String> = words.map(|word| word.trim().to_owned()).collect();
    words.sort();
    Some(words)
}

/// Calls the script's function as bash does.
const BASH: &str = r#"source "$SCRIPT"; read -ra COMP_WORDS <<<"$1"
[[ "$1" != *" " ]] || COMP_WORDS+=("")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_mapd mapd "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}""#;

const FISH: &str = "source $SCRIPT; complete -C $argv[-1]";

#[test]
fn shells_complete_commands_options_and_values() {
    let folder = tempfile::tempdir().expect("a folder");
    for (shell, program) in [("bash", BASH), ("fish", FISH)] {
        let script = folder.path().join(shell);
        std::fs::write(&script, text(&["completions", shell])).expect("written");
        for (typed, expected) in COMPLETED {
            let Some(offered) = offers(shell, program, &script, typed) else {
                say(&format!("SKIPPED: there is no {shell}"));
                break;
            };
            assert_eq!(offered, expected, "{shell}: {typed:?}");
        }
    }
}

/// Checks that man shows the examples of a command, and of those below it, as they are to be typed.
fn shows_examples(folder: &Path, name: &str, command: &clap::Command) -> Option<()> {
    let mut man = Command::new("man");
    man.arg("-l").arg(folder.join(format!("{name}.1"))).env("MANWIDTH", "80");
    let output = man.env("LC_ALL", "C.UTF-8").env("MANPAGER", "cat").output().ok()?;
    // Where a stand-in says that pages are not installed, too.
    if !output.status.success() {
        return None;
    }
    let page = String::from_utf8_lossy(&output.stdout).into_owned();
    let help = command.get_after_long_help().map(ToString::to_string).unwrap_or_default();
    assert!(help.contains("Examples:"), "{name} has no examples");
    // Lines of a table or an example are not filled, adjusted or hyphenated.
    for line in help.lines().filter(|line| line.starts_with(' ')) {
        assert!(page.lines().any(|shown| shown.trim() == line.trim()), "{line:?} in {page}");
    }
    assert!(!page.contains("EXTRA"), "{page}");
    for below in command.get_subcommands() {
        shows_examples(folder, &format!("{name}-{}", below.get_name()), below)?;
    }
    Some(())
}

#[test]
fn man_shows_examples_as_they_are_typed() {
    let folder = tempfile::tempdir().expect("a folder");
    text(&["man", folder.path().to_str().expect("text")]);
    for command in commands() {
        let name = format!("mapd-{}", command.get_name());
        if shows_examples(folder.path(), &name, &command).is_none() {
            return say("SKIPPED: there is no man");
        }
    }
}
