//! The checked-in header is what the sources yield.

#[path = "../examples/header/text.rs"]
mod text;

#[test]
fn the_header_is_what_the_sources_yield() {
    let found = std::fs::read_to_string(text::path()).unwrap_or_default();
    assert!(found == text::header(), "run `cargo run -p mapd-c --example header`");
}

#[test]
fn every_function_of_the_sources_stands_in_the_header() {
    let header = text::header();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut functions = 0;
    for file in std::fs::read_dir(folder).unwrap().flatten() {
        let source = std::fs::read_to_string(file.path()).unwrap();
        for line in source
            .lines()
            .filter(|line| line.starts_with("pub ") && line.contains("extern \"C\" fn "))
        {
            let name = line.split("fn ").nth(1).and_then(|rest| rest.split('(').next()).unwrap();
            assert!(header.contains(&format!("{name}(")), "{name} of {:?}", file.path());
            functions += 1;
        }
    }
    assert!(functions > 90, "{functions}");
}

/// A file of this crate.
fn read(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// C without its comments, word by word.
fn without_comments(text: &str) -> Vec<String> {
    let mut code = String::new();
    for (i, part) in text.split("/*").enumerate() {
        let after = if i == 0 { part } else { part.split_once("*/").unwrap().1 };
        code += after;
        code.push(' ');
    }
    let lines = code.lines().filter_map(|line| line.split("//").next());
    lines.flat_map(str::split_whitespace).map(str::to_owned).collect()
}

const ACCEPT: &str = "if that is meant: src/c/install PREFIX && src/c/abi PREFIX --write";

#[test]
fn the_accepted_header_is_this_one() {
    let (header, accepted) = (without_comments(&read("include/mapd.h")), read("abi.h"));
    let accepted: Vec<&str> = accepted.split_whitespace().collect();
    let other = header.iter().zip(&accepted).position(|(own, accepted)| own != accepted);
    let at = other.unwrap_or(header.len().min(accepted.len()));
    let of = |all: String| all.split(' ').skip(at).take(12).collect::<Vec<_>>().join(" ");
    let (own, old) = (of(header.join(" ")), of(accepted.join(" ")));
    assert!(header == accepted, "mapd.h has `{own}` where abi.h has `{old}`; {ACCEPT}");
}

#[test]
fn the_accepted_abi_has_the_headers_functions_and_structs() {
    let header = without_comments(&read("include/mapd.h"));
    let functions = header.iter().filter_map(|word| word.split_once('(')).map(|(name, _)| name);
    let mut expected: Vec<String> = functions
        .map(|name| name.trim_start_matches('*'))
        .filter(|name| name.starts_with("mapd_"))
        .map(str::to_owned)
        .collect();
    // Those with fields; handles have none.
    let structs = header.windows(4).filter(|words| words[..2] == ["typedef", "struct"]);
    expected.extend(
        structs.filter(|words| words[3] == "{").map(|words| format!("struct {}", words[2])),
    );
    expected.sort();
    let abi = read("abi.txt");
    let mut accepted: Vec<String> = abi
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| match line.strip_prefix("struct ") {
            Some(rest) => format!("struct {}", rest.split(' ').next().unwrap_or_default()),
            None => line.to_owned(),
        })
        .collect();
    accepted.sort();
    assert!(expected.len() > 300, "{}", expected.len());
    let lacks: Vec<_> = expected.iter().filter(|one| !accepted.contains(one)).collect();
    let has: Vec<_> = accepted.iter().filter(|one| !expected.contains(one)).collect();
    assert!(expected == accepted, "abi.txt lacks {lacks:?}, and has besides {has:?}; {ACCEPT}");
}
