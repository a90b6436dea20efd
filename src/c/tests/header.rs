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
