//! Lists the public API of the libraries that other programs bind to, one text file each in `docs/api`, so that a change of it shows as a diff.
//!
//! ```text
//! cargo run -p mapd-schemas --bin public_api            write what has changed
//! cargo run -p mapd-schemas --bin public_api -- --check change nothing; end with 1 if something would change
//! ```
//!
//! Of the libraries behind them, a list has the types that a user meets there: those that the public items of the former name, and those that
//! the items of these name in turn. All public items of those libraries would be thousands of lines, most of them for the compiler alone, and each
//! change of them would look like one that users notice.
//!
//! The lists have the features with which the whole workspace builds, which are all that these libraries have; a selection of packages would
//! have other ones, and everything would be built again. They have no items that are hidden from the documentation. Of a trait that is derived they have
//! the `impl`, not its methods; traits that every type has by itself (`Send`, `From<T>` for T …) are left out.
//!
//! They are made from what `rustdoc` writes as JSON, which is unstable: rustdoc is told to act like a nightly one, and nothing else is, because
//! cargo would build everything again with that variable. So this program starts itself as cargo's `rustdoc`, in one run of `cargo doc` for the whole
//! workspace: pages are made as ever, and must cause no warning; what is listed is described as JSON, too. Other selections of crates or features would
//! have cargo build their dependencies again.

use anyhow::{Context, Result, bail};
use std::collections::HashSet;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// The libraries whose API is listed.
const LIBRARIES: [&str; 8] = [
    "mapd-archive",
    "mapd-client",
    "mapd-compiler",
    "mapd-export",
    "mapd-geodesy",
    "mapd-geometry",
    "mapd-overlay",
    "mapd-query",
];

/// Libraries that are no one's to bind to, but whose types the public items of the others name.
const BEHIND: [&str; 4] = ["mapd-ontology", "mapd-rules", "mapd-transport", "mapd-xodr"];

/// Derived traits that say nothing to a user: those by which rows are laid out, and one of the compiler.
const INTERNAL: [&str; 4] = ["StructuralPartialEq", "rkyv::", "bytecheck::", "bytemuck::"];

/// Set if this program stands in for rustdoc: the path of the real one.
const RUSTDOC: &str = "MAPD_PUBLIC_API_RUSTDOC";

fn main() -> Result<ExitCode> {
    if let Some(rustdoc) = std::env::var_os(RUSTDOC) {
        return document(&rustdoc);
    }
    let check = match std::env::args().skip(1).collect::<Vec<_>>().as_slice() {
        [] => false,
        [flag] if flag == "--check" => true,
        other => bail!("unknown arguments {other:?}; usage: public_api [--check]"),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .context("the schemas folder has no parent")?;
    let described = describe(root)?;
    let lists = |libraries: &[&'static str]| -> Result<Vec<(&'static str, Vec<String>)>> {
        let read = |library: &&'static str| {
            let json = described.join(format!("{}.json", crate_of(library)));
            let lines =
                list(&json).with_context(|| format!("reading what rustdoc says of {library}"))?;
            Ok((*library, lines))
        };
        libraries.iter().map(read).collect()
    };
    let mut listed = lists(&LIBRARIES)?;
    listed.extend(met(&listed, lists(&BEHIND)?));
    let mut stale = Vec::new();
    for (library, lines) in listed {
        let text = lines.join("\n") + "\n";
        let path = root.join(format!("docs/api/{library}.txt"));
        if std::fs::read_to_string(&path).ok().as_deref() == Some(text.as_str()) {
            continue;
        }
        if !check {
            std::fs::create_dir_all(root.join("docs/api"))?;
            std::fs::write(&path, text).with_context(|| format!("writing {}", path.display()))?;
        }
        stale.push(library);
    }
    if check && !stale.is_empty() {
        bail!(
            "the public API is not what docs/api lists: {}; run `cargo run -p mapd-schemas --bin public_api`, and look at the diff",
            stale.join(", ")
        );
    }
    Ok(ExitCode::SUCCESS)
}

/// Stands in for rustdoc: makes the pages of a crate, and describes it as JSON beside them if its API is listed.
fn document(rustdoc: &OsStr) -> Result<ExitCode> {
    let args: Vec<OsString> = std::env::args_os().skip(1).collect();
    let run = |command: &mut Command| -> Result<bool> {
        Ok(command.args(&args).status().context("starting rustdoc")?.success())
    };
    let mut names = args.iter().skip_while(|arg| *arg != "--crate-name").skip(1);
    let name = names.next().and_then(|name| name.to_str()).unwrap_or_default();
    let is_listed = LIBRARIES.iter().chain(&BEHIND).any(|library| crate_of(library) == name);
    // Warnings are told by the first run.
    let json = ["--cap-lints", "allow", "-Zunstable-options", "--output-format", "json"];
    let mut described = Command::new(rustdoc);
    described.args(json).env("RUSTC_BOOTSTRAP", "1");
    let is_done = run(&mut Command::new(rustdoc))? && (!is_listed || run(&mut described)?);
    Ok(if is_done { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Lets rustdoc document the workspace; the folder with a JSON file for each library.
fn describe(root: &Path) -> Result<PathBuf> {
    let this = std::env::current_exe().context("finding this program")?;
    let target = this.ancestors().nth(2).context("this program is not in a target folder")?;
    let rustdoc = std::env::var_os("RUSTDOC").unwrap_or_else(|| "rustdoc".into());
    let status = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .current_dir(root)
        .args(["doc", "--quiet", "--workspace", "--no-deps", "--target-dir"])
        .arg(target)
        // A flag of its own, so that pages that were made without this program are made again, with JSON.
        .env("RUSTDOCFLAGS", "-D warnings --cfg listed")
        .env(RUSTDOC, rustdoc)
        .env("RUSTDOC", &this)
        .status()
        .context("starting cargo")?;
    if !status.success() {
        bail!("cargo doc has failed");
    }
    Ok(target.join("doc"))
}

/// The list of one library: a line for each item, under its module and type.
fn list(json: &Path) -> Result<Vec<String>> {
    let build = |omit_derived| {
        public_api::Builder::from_rustdoc_json(json)
            .sorted(true)
            .omit_blanket_impls(true)
            .omit_auto_trait_impls(true)
            .omit_auto_derived_impls(omit_derived)
            .build()
            .context("a rustdoc of another age needs another release of public-api: see Cargo.toml")
    };
    let written: HashSet<String> = build(true)?.items().map(|item| item.to_string()).collect();
    let lines = build(false)?;
    let lines = lines.items().map(|item| item.to_string()).filter(|line| {
        let derived = line.starts_with("impl") && !INTERNAL.iter().any(|name| line.contains(name));
        written.contains(line) || derived
    });
    Ok(lines.collect())
}

/// The lines of libraries behind others that are about types which users meet: those that a line of the others names, and those that a line about these
/// names.
fn met(
    listed: &[(&'static str, Vec<String>)],
    behind: Vec<(&'static str, Vec<String>)>,
) -> Vec<(&'static str, Vec<String>)> {
    let types_in = |line: &str| -> Vec<String> {
        behind.iter().flat_map(|(library, _)| types(line, library)).collect()
    };
    let about = |line: &str| types_in(subject(line)).into_iter().next();
    let named: HashSet<_> =
        listed.iter().flat_map(|(_, lines)| lines).flat_map(|line| types_in(line)).collect();
    let own = behind.iter().flat_map(|(_, lines)| lines);
    let about_named = own.filter(|line| about(line).is_some_and(|it| named.contains(&it)));
    let further: HashSet<_> = about_named.flat_map(|line| types_in(line)).collect();
    let is_met =
        |line: &&String| about(line).is_some_and(|it| named.contains(&it) || further.contains(&it));
    let kept = |(library, lines): &(&'static str, Vec<String>)| {
        (*library, lines.iter().filter(is_met).cloned().collect())
    };
    behind.iter().map(kept).collect()
}

/// What a line is about: the type that implements something, or the item.
fn subject(line: &str) -> &str {
    let implements = line.starts_with("impl").then(|| line.split_once(" for ")).flatten();
    implements.map_or(line, |(_, of)| of)
}

/// The types of a library that a line names, in its order, as `crate::Type`; what is no part of a type, by its own name.
/// Signatures write them with their own module, which may be private, so that modules do not count.
fn types<'a>(line: &'a str, library: &str) -> impl Iterator<Item = String> + use<'a> {
    let name = crate_of(library);
    let start = format!("{name}::");
    let paths: Vec<&str> = line.split(&start).skip(1).collect();
    paths.into_iter().filter_map(move |path| {
        let end = path.find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
        let path = path.get(..end.unwrap_or(path.len()))?;
        let is_type = |part: &&str| part.starts_with(char::is_uppercase);
        let own = path.split("::").find(is_type).or(path.split("::").last())?;
        Some(format!("{name}::{own}"))
    })
}

/// The name of a library in Rust.
fn crate_of(library: &str) -> String {
    library.replace('-', "_")
}
