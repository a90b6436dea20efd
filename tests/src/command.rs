//! Commands that are given something to read.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Runs a program to its end with this on its standard input.
pub fn run(program: &str, args: &[&str], input: impl AsRef<[u8]>) -> Output {
    let mut child = Command::new(program)
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts");
    // A command that refuses its arguments does not read.
    let _ = child.stdin.take().expect("stdin").write_all(input.as_ref());
    child.wait_with_output().expect("ends")
}

/// What a shell's command shows on a terminal of so many columns, in a folder and with these variables of the environment; none where the program
/// `script`, which offers a terminal, is missing.
pub fn on_a_terminal(
    command: &str,
    columns: usize,
    folder: &Path,
    variables: &[(&str, &str)],
) -> Option<String> {
    let mut script = Command::new("script");
    script.args(["-qec", &format!("stty rows 50 cols {columns}; {command}"), "/dev/null"]);
    for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "COLUMNS", "CI"] {
        script.env_remove(name);
    }
    script.env("TERM", "xterm").envs(variables.iter().copied()).stdin(Stdio::null());
    let output = script.current_dir(folder).output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}
