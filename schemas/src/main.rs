//! Writes mapd's generated code and documents from the tables of truth in this folder; see the library.

use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};

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
    let mut stale = Vec::new();
    for (name, text) in mapd_schemas::outputs(&root)? {
        let path = root.join(&name);
        let text = if name.ends_with(".rs") {
            format_rust(&text).with_context(|| name.clone())?
        } else {
            text
        };
        if std::fs::read_to_string(&path).ok().as_deref() == Some(text.as_str()) {
            continue;
        }
        if !check {
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder)?;
            }
            std::fs::write(&path, text).with_context(|| format!("writing {}", path.display()))?;
        }
        stale.push(name);
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
