//! What is compiled is proved: a map whose numbers lie at the ends of their types is rejected or loses the part that has them,
//! or its archive is sound and answers. Builds of tests check for overflow.

use mapd_archive::{AlignedBytes, Rows, VerifyError, encode, verify};
use mapd_compiler::{Compilation, CompileOptions, ReadOptions, Verdict, compile_from};
use mapd_tests::damage::ask_everything;

/// Values that arithmetic may leave its type with.
const EXTREMES: [&str; 10] = [
    "-2147483648",
    "2147483647",
    "4294967295",
    "-1e308",
    "1e308",
    "-1e9",
    "1e9",
    "1e-308",
    "0",
    "-1",
];

/// Of the larger maps one in so many is tried.
const STEP: usize = 7;

fn compiled(text: &str) -> Compilation {
    let open = || Ok(text.as_bytes());
    compile_from(open, &ReadOptions::default(), &CompileOptions::default(), &mut |_| {})
        .expect("reading works")
}

/// The archive, if the map is accepted, and what it does not prove for.
fn archive(compiled: &Compilation) -> Option<(AlignedBytes, Option<VerifyError>)> {
    let bytes = encode(compiled.rows.as_ref()?, &compiled.provenance).expect("encodes");
    let error = verify(&bytes).err();
    Some((bytes, error))
}

/// Where values of attributes that are numbers lie in a text.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find("=\"").map(|found| at + found + 2) {
        let end = start + text[start..].find('"').expect("values end");
        if text[start..end].parse::<f64>().is_ok() {
            found.push(start..end);
        }
        at = end + 1;
    }
    found
}

fn check(name: &str, step: usize) {
    let text = std::fs::read_to_string(mapd_tests::carried(name)).expect("the map can be read");
    let numbers = numbers(&text);
    let all = numbers.iter().flat_map(|range| EXTREMES.map(|value| (range.clone(), value)));
    let (mut tried, mut accepted, mut unsound) = (0, 0, Vec::new());
    for (range, value) in all.step_by(step) {
        let mut changed = text.clone();
        changed.replace_range(range.clone(), value);
        let before = text[..range.start].rfind('<').unwrap_or_default();
        let what = format!("{name}: {}{value}", &text[before..range.start]);
        tried += 1;
        if let Some((bytes, error)) = archive(&compiled(&changed)) {
            accepted += 1;
            unsound.extend(error.map(|error| format!("{what}: {error}")));
            ask_everything(bytes);
        }
    }
    mapd_tests::say(&format!("{name}: {tried} changed maps, {accepted} of them accepted"));
    assert!(unsound.is_empty(), "{unsound:#?}");
    // Most numbers matter to a part or to nothing; some to the map.
    assert!(accepted > tried / 4 && accepted < tried, "{name}: {accepted} of {tried}");
}

#[test]
fn what_is_accepted_proves_and_answers() {
    check("one_road.xodr", 1);
    for name in ["surfaces.xodr", "objects.xodr", "marks.xodr"] {
        check(name, STEP);
    }
}

/// A road of 100 m with this section.
fn road(section: &str) -> String {
    format!(
        r#"<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="100" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView><lanes>{section}</lanes></road></OpenDRIVE>"#
    )
}

/// A section at s with a lane on its own side.
fn section(s: &str, lane: &str, level: bool) -> String {
    let side = if lane.starts_with('-') { "right" } else { "left" };
    let center = r#"<center><lane id="0" type="none"/></center>"#;
    let lane = format!(
        r#"<{side}><lane id="{lane}" type="driving" level="{level}"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></{side}>"#
    );
    let lanes = if side == "left" { lane + center } else { center.to_owned() + &lane };
    road(&format!(r#"<laneSection s="{s}">{lanes}</laneSection>"#))
}

/// A map that is rejected for what stands at a path that begins so, which is told what there may be.
fn check_rejected(text: &str, path: &str, expected: &str) {
    let compiled = compiled(text);
    assert_eq!(compiled.verdict, Verdict::Rejected, "{path}");
    let told = compiled.diagnostics.iter().find(|told| {
        told.rejects
            && told.finding.path.starts_with(path)
            && told.finding.message.contains(expected)
    });
    let told = told.unwrap_or_else(|| panic!("{path}: {:?}", compiled.diagnostics));
    assert!(told.line == 1 && told.column > 1, "{}:{}", told.line, told.column);
}

/// The archive was written, and its own check refused it.
#[test]
fn lanes_of_huge_numbers_have_a_finding() {
    let lane = "OpenDRIVE/road[@id=1]/lanes/laneSection/lane";
    for id in ["2147483647", "-2147483648", "65536", "-65536"] {
        check_rejected(&section("0", id, false), lane, "from -65535 to 65535");
    }
    for id in ["65535", "-65535"] {
        let (_, error) = archive(&compiled(&section("0", id, false))).expect("accepted");
        assert_eq!(error.map(|error| error.to_string()), None, "lane {id}");
    }
}

/// A station was infinite in single precision.
#[test]
fn stations_beyond_measure_have_a_finding() {
    let place = "OpenDRIVE/road[@id=1]/lanes/laneSection";
    for s in ["1e308", "1.1e9"] {
        check_rejected(&section(s, "1", false), place, "from -1000000000 to 1000000000 m");
    }
    check_rejected(&section("-1e308", "1", false), place, "at least 0");
}

/// The absolute value of the smallest number overflows.
#[test]
fn level_lanes_of_the_smallest_number_do_not_panic() {
    let two = section("0", "-1", false).replace(
        "</right>",
        r#"<lane id="-2147483648" type="driving" level="true"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>"#,
    );
    check_rejected(&two, "OpenDRIVE/road[@id=1]/lanes/laneSection/lane", "-2147483648");
    // As a damaged archive may have it.
    let fine = two.replace("-2147483648", "-65535");
    let mut compiled = compiled(&fine);
    let rows = compiled.rows.as_mut().expect("accepted");
    let lane = rows.lanes.iter_mut().last().expect("a lane");
    lane.number = i32::MIN;
    let (bytes, error) = archive(&compiled).expect("rows");
    assert_eq!(error.map(|error| error.to_string()), None);
    ask_everything(bytes);
}

/// Tables that contradict themselves, as a defect of the compiler would make them.
fn unsound() -> Rows {
    let mut rows = compiled(&section("0", "1", false)).rows.expect("accepted");
    rows.lanes.iter_mut().for_each(|lane| lane.section = 7);
    rows
}

#[test]
fn no_archive_is_written_that_does_not_prove() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("unsound.mapd");
    let (rows, provenance) = (unsound(), Default::default());
    let bytes = encode(&rows, &provenance).expect("encodes");
    assert!(matches!(verify(&bytes), Err(VerifyError::Row { .. })));
    let error = mapd::archive_file::write(&path, &rows, &provenance).expect_err("refused");
    assert!(format!("{error:#}").contains("fails verification"), "{error:#}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0);
}
