//! Every map of the shared corpus is read to its end, and each of its known quirks is found or tolerated on purpose.

use mapd_compiler::{ReadOptions, check};
use mapd_xodr::{Item, Limits, Reader, rule_ids};
use std::collections::BTreeMap;

/// Quirks by the beginning of their tag in the corpus' manifest, and the rule that finds them.
const FOUND: [(&str, &str); 19] = [
    ("NOT-WELL-FORMED:XML declaration", rule_ids::BEFORE_DECLARATION),
    ("NOT-WELL-FORMED:Premature end", rule_ids::XML),
    ("ws-before-xmldecl", rule_ids::BEFORE_DECLARATION),
    ("NaN/Inf", rule_ids::FINITE),
    ("hdr-attrs:", rule_ids::UNKNOWN_ATTRIBUTE),
    ("toplevel-order:", rule_ids::ORDER),
    ("space-in-number", rule_ids::SPACE),
    ("revMajor=None", rule_ids::VERSION),
    ("no-planView", rule_ids::ELEMENT),
    ("no-lanes", rule_ids::ELEMENT),
    ("root=", rule_ids::ROOT),
    ("unknown-elems:ODrive", rule_ids::ROOT),
    ("non-int-road-ids e.g. 'None'", rule_ids::MISSING),
    ("non-int-road-ids e.g. '12 '", rule_ids::SPACE),
    ("road@junction-dangling", "asam.net:xodr:1.4.0:ids.only_ref_defined_ids"),
    ("dangling-road-links", "asam.net:xodr:1.4.0:ids.only_ref_defined_ids"),
    ("connection-dangling", "asam.net:xodr:1.4.0:ids.only_ref_defined_ids"),
    ("road-length!=sum(geom)", "asam.net:xodr:1.9.0:road.length_sum_geometries"),
    ("pRange:None", "mapd:compile.p_range"),
];

/// Quirks that are no violation, and why they are read without a word. docs/reading.md lists them.
const TOLERATED: [(&str, &str); 25] = [
    ("NAMED-INVALID", "what its name calls invalid is its meaning, for the rules to find"),
    ("CDATA", "XML allows it for any text"),
    ("comments", "XML allows them anywhere"),
    ("comment/PI-before-root", "XML allows it"),
    ("comment-before-header", "XML allows it"),
    ("speed-units:", "all units of speed are read; without one m/s is meant"),
    ("roads<1mm", "no version asks for more than 0"),
    ("long-decimals", "numbers of any length are rounded correctly"),
    ("3-digit-exponent", "xs:double allows it"),
    ("bare-dot-number", "xs:double allows it"),
    ("huge-xy", "the compiled map has an origin of its own"),
    ("junction-id==road-id", "roads and junctions are numbered apart"),
    ("rule:", "both rules are read, in every version"),
    ("pRange:normalized", "the standard's word"),
    ("pRange:arcLength", "the standard's word"),
    ("non-ascii", "text is Unicode"),
    ("UTF8-BOM", "XML allows it"),
    ("CRLF", "XML allows it"),
    ("single-quoted-attrs", "XML allows it"),
    ("hdr-no-north", "optional"),
    ("non-int-road-ids e.g. 'Kalle'", "ids are text"),
    ("road-id>int32", "ids are text"),
    ("lane-order/sign-odd", "lanes are ordered by their ids, wherever they stand"),
    ("lane-types-odd:None", "the center lane's type is deprecated or required as the version says"),
    ("road@junction {'missing': 1}", "1.4 requires no attribute; without one there is no junction"),
];

#[test]
fn every_quirk_is_found_or_tolerated() {
    let Some(folder) = mapd_tests::shared("maps") else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let mut manifest = csv::ReaderBuilder::new()
        .delimiter(b'\t')
        .quoting(false)
        .from_path(folder.join("manifest.tsv"))
        .expect("the manifest");
    let headers = manifest.headers().expect("headers").clone();
    let column = |name: &str| headers.iter().position(|h| h == name).expect("a column");
    let (map, notes) = (column("map"), column("notes"));
    let mut counts = (0, 0);
    for record in manifest.records() {
        let record = record.expect("a record");
        let path = folder.join(&record[map]);
        let file = std::fs::File::open(&path).expect("the map opens");
        let checked = check(file, &ReadOptions::default(), &mut |_| {}).expect("reading works");
        let rules: Vec<&str> = checked.diagnostics.iter().map(|d| d.finding.rule).collect();
        // What is no OpenDRIVE is not read further.
        if rules.contains(&rule_ids::ROOT) {
            counts.0 += 1;
            continue;
        }
        for tag in record[notes].split([';', ',']).map(str::trim).filter(|tag| is_tag(tag)) {
            let rule = FOUND.iter().find(|(start, _)| tag.starts_with(start)).map(|(_, rule)| rule);
            let tolerated = TOLERATED.iter().any(|(start, _)| tag.starts_with(start));
            match rule {
                Some(rule) => {
                    assert!(rules.contains(rule), "{}: {tag}: {rules:?}", &record[map]);
                    counts.0 += 1;
                }
                None => {
                    assert!(tolerated, "{}: nothing is said about {tag:?}", &record[map]);
                    counts.1 += 1;
                }
            }
        }
    }
    mapd_tests::say(&format!("{} quirks found, {} tolerated", counts.0, counts.1));
    assert!(counts.0 > 30 && counts.1 > 60, "{counts:?}");
}

/// Tags begin with a name; what follows commas within them goes on with other things.
fn is_tag(tag: &str) -> bool {
    let all = FOUND.iter().chain(&TOLERATED);
    let known = all.clone().any(|(start, _)| tag.starts_with(start));
    known || (tag.contains([':', '-']) && !tag.starts_with(|c: char| c.is_ascii_digit()))
}

#[test]
fn every_map_is_read_to_its_end() {
    let (Some(corpus), Some(folder)) = (mapd_tests::corpus(), mapd_tests::shared("maps")) else {
        mapd_tests::say("SKIPPED: no shared corpus beside the workspace");
        return;
    };
    let manifest = std::fs::read_to_string(folder.join("manifest.tsv")).expect("the manifest");
    let mut lines = manifest.lines().map(|line| line.split('\t').collect::<Vec<_>>());
    let headers = lines.next().expect("headers");
    let at = |name: &str| headers.iter().position(|h| *h == name).expect("a column");
    let stated: BTreeMap<&str, (usize, usize)> = lines
        .map(|row| {
            let number = |name: &str| row[at(name)].parse().unwrap_or(0);
            (row[at("map")].trim_end_matches(".xodr"), (number("roads"), number("junctions")))
        })
        .collect();
    for (name, path) in corpus {
        let mut reader = Reader::open(&path, Limits::default()).expect("the map opens");
        let (mut roads, mut junctions) = (0, 0);
        while let Some(item) = reader.next().expect("reading works") {
            roads += usize::from(matches!(item, Item::Road(_)));
            junctions += usize::from(matches!(item, Item::Junction(_)));
        }
        let findings = reader.take_findings();
        // What is no OpenDRIVE has no roads.
        if findings.iter().all(|finding| finding.rule != rule_ids::ROOT) {
            assert_eq!(Some(&(roads, junctions)), stated.get(name.as_str()), "{name}");
        }
    }
}
