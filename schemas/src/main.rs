//! Writes mapd's generated code and documents from the tables of truth in this folder.
//!
//! ```text
//! cargo run -p mapd-schemas            write what has changed
//! cargo run -p mapd-schemas -- --check change nothing; end with 1 if something would change
//! ```
//!
//! Invariant: the output depends on the tables of truth alone, so that running it twice changes nothing.

mod archive;
mod archive_code;
mod archive_doc;

use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};

/// A file to be written: its path below the workspace and its whole text.
struct Output {
    path: &'static str,
    text: String,
}

fn main() -> Result<()> {
    let check = match std::env::args().skip(1).collect::<Vec<_>>().as_slice() {
        [] => false,
        [flag] if flag == "--check" => true,
        other => bail!("unknown arguments {other:?}; usage: mapd-schemas [--check]"),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .map(PathBuf::from)
        .context("the schemas folder has no parent")?;
    let layout = archive::Layout::read(&root.join("schemas/archive.toml"))?;
    let format_page = root.join("docs/format.md");
    let outputs = [
        Output { path: "src/archive/src/generated/rows.rs", text: archive_code::rows(&layout) },
        Output {
            path: "src/archive/src/generated/accessors.rs",
            text: archive_code::accessors(&layout),
        },
        Output { path: "src/archive/src/generated/tables.rs", text: archive_code::tables(&layout) },
        Output {
            path: "docs/format.md",
            text: archive_doc::splice(
                &std::fs::read_to_string(&format_page)
                    .with_context(|| format!("reading {}", format_page.display()))?,
                &layout,
            )?,
        },
    ];
    let mut stale = Vec::new();
    for output in outputs {
        let path = root.join(output.path);
        let text =
            if output.path.ends_with(".rs") { format_rust(&output.text)? } else { output.text };
        if std::fs::read_to_string(&path).ok().as_deref() == Some(text.as_str()) {
            continue;
        }
        if !check {
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder)?;
            }
            std::fs::write(&path, text).with_context(|| format!("writing {}", path.display()))?;
        }
        stale.push(output.path);
    }
    if check && !stale.is_empty() {
        bail!(
            "not what the tables of truth yield: {}; run `cargo run -p mapd-schemas`",
            stale.join(", ")
        );
    }
    Ok(())
}

/// Formats generated code as `cargo fmt` would, so that both agree on one text.
fn format_rust(text: &str) -> Result<String> {
    use std::io::Write as _;
    use std::process::{Command, Stdio};
    let mut child = Command::new("rustfmt")
        .args(["--edition", "2024", "--config", "use_small_heuristics=Max"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .context("starting rustfmt")?;
    child.stdin.take().context("rustfmt takes no input")?.write_all(text.as_bytes())?;
    let output = child.wait_with_output()?;
    if !output.status.success() {
        bail!("rustfmt refuses the generated code");
    }
    Ok(String::from_utf8(output.stdout)?)
}
