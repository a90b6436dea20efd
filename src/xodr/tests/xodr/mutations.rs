//! One thing changed in a sound map: the finding that is due comes, at its place. Every tag and attribute of the carried maps is
//! changed in every way that it can be.

use mapd_xodr::{Finding, Limits, Reader, rule_ids};
use std::collections::BTreeMap;
use std::io::Write as _;
use std::ops::Range;
use std::path::Path;

/// Attributes of the carried maps that 1.7 does not require.
const OPTIONAL: &[&str] = &[
    "header@name",
    "header@version",
    "header@date",
    "header@north",
    "header@south",
    "header@east",
    "header@west",
    "header@vendor",
    "road@name",
    "road@rule",
    "speed@unit",
    "lane@level",
    "junction@name",
    "connection@incomingRoad",
    "connection@connectingRoad",
    "connection@contactPoint",
    "predecessor@contactPoint",
    "successor@contactPoint",
    "predecessor@elementType",
    "successor@elementType",
];
/// Attributes that take any text.
const TEXTS: &[&str] = &[
    "header@name",
    "header@version",
    "header@date",
    "header@vendor",
    "road@name",
    "road@id",
    "road@junction",
    "junction@id",
    "junction@name",
    "connection@id",
    "connection@incomingRoad",
    "connection@connectingRoad",
    "predecessor@elementId",
    "successor@elementId",
];
/// Elements that must be there.
const REQUIRED: &[&str] = &["planView", "lanes", "laneSection", "center", "header"];
/// Elements that may be there once.
const SINGLE: &[&str] = &[
    "header",
    "planView",
    "lanes",
    "elevationProfile",
    "lateralProfile",
    "center",
    "left",
    "right",
    "geoReference",
];
/// Elements that must stand behind others, and what they are put before.
const ORDER: &[(&str, &str)] = &[
    ("elevationProfile", "planView"),
    ("lateralProfile", "elevationProfile"),
    ("lanes", "elevationProfile"),
    ("laneSection", "laneOffset"),
    ("right", "left"),
    ("planView", "type"),
    ("roadMark", "width"),
    ("shape", "superelevation"),
];
/// Elements of which one is chosen.
const CHOSEN: &[&str] = &["line", "arc", "spiral", "poly3", "paramPoly3"];

/// A tag of a map.
struct Tag {
    name: String,
    /// From `<` to behind `>`.
    place: Range<usize>,
    /// From `<` to behind the end tag's `>`.
    whole: Range<usize>,
    /// Places of names and values.
    attributes: Vec<(Range<usize>, Range<usize>)>,
    parent: usize,
}

/// The tags of a well-formed map without odd characters.
fn tags(text: &str) -> Vec<Tag> {
    let mut tags: Vec<Tag> = Vec::new();
    let mut open = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find('<').map(|found| at + found) {
        if let Some(end) =
            ["<!--", "<![CDATA[", "<?"].iter().zip(["-->", "]]>", "?>"]).find_map(|(begin, end)| {
                text[start..]
                    .starts_with(begin)
                    .then(|| start + text[start..].find(end).expect("an end") + end.len())
            })
        {
            at = end;
            continue;
        }
        at = start + text[start..].find('>').expect("an end") + 1;
        if text[start..].starts_with("</") {
            let tag: usize = open.pop().expect("a start tag");
            tags[tag].whole.end = at;
            continue;
        }
        let inner = &text[start + 1..at - 1];
        let length = inner.find([' ', '/']).unwrap_or(inner.len());
        let mut attributes = Vec::new();
        let mut place = start + 1 + length;
        while let Some(equals) = text[place..at].find('=').map(|found| place + found) {
            let end = equals + 2 + text[equals + 2..].find('"').expect("a quote");
            let name = equals - text[place..equals].trim_start().len();
            attributes.push((name..equals, equals + 2..end));
            place = end + 1;
        }
        let parent = open.last().copied().unwrap_or(usize::MAX);
        if !inner.ends_with('/') {
            open.push(tags.len());
        }
        tags.push(Tag {
            name: inner[..length].to_owned(),
            place: start..at,
            whole: start..at,
            attributes,
            parent,
        });
    }
    tags
}

fn read(text: &str) -> Vec<Finding> {
    let mut reader = Reader::new(text.as_bytes(), Limits::default());
    while reader.next().expect("memory does not fail").is_some() {}
    reader.take_findings()
}

struct Check<'a> {
    map: &'a str,
    known: Vec<Finding>,
    /// How often each kind of mutation was made.
    counts: BTreeMap<&'static str, usize>,
}

impl Check<'_> {
    /// Puts `new` in `place` and expects findings: the first new one is of a rule and lies within `at`. No rule: none is due.
    fn check(
        &mut self,
        kind: &'static str,
        place: Range<usize>,
        new: &str,
        rule: Option<&str>,
        at: Range<usize>,
    ) {
        let text = format!("{}{new}{}", &self.map[..place.start], &self.map[place.end..]);
        self.whole(kind, &text, rule, at);
    }

    fn whole(&mut self, kind: &'static str, text: &str, rule: Option<&str>, at: Range<usize>) {
        *self.counts.entry(kind).or_default() += 1;
        let known = |finding: &Finding| {
            self.known.iter().any(|k| (k.rule, &k.message) == (finding.rule, &finding.message))
        };
        let findings: Vec<Finding> =
            read(text).into_iter().filter(|finding| !known(finding)).collect();
        let Some(rule) = rule else {
            assert!(findings.is_empty(), "{kind} at {at:?}: {findings:?}");
            return;
        };
        let is_it =
            |f: &Finding| f.rule == rule && (at.start..=at.end).contains(&(f.span.start as usize));
        let around = &self.map[at.start.saturating_sub(60)..(at.end + 60).min(self.map.len())];
        assert!(
            findings.iter().any(is_it),
            "{kind} at {at:?}, expected {rule} in {around}, found {findings:?}"
        );
    }

    fn attribute(&mut self, tag: &Tag, name: &Range<usize>, value: &Range<usize>) {
        let map = self.map;
        let (attribute, old) = (&map[name.clone()], &map[value.clone()]);
        let key = format!("{}@{attribute}", tag.name);
        let is = |list: &[&str]| list.contains(&key.as_str());
        let whole = name.start..value.end + 1;
        let required = (!is(OPTIONAL)).then_some(rule_ids::MISSING);
        self.check("attribute dropped", whole.clone(), "", required, tag.place.clone());
        let near = tag.place.start..tag.place.end + 1;
        self.check(
            "attribute renamed",
            name.clone(),
            &format!("{attribute}X"),
            Some(rule_ids::UNKNOWN_ATTRIBUTE),
            near.clone(),
        );
        let twice = format!("{0} {0}", &map[whole.clone()]);
        self.check(
            "attribute doubled",
            whole.clone(),
            &twice,
            Some(rule_ids::XML),
            tag.place.start..tag.place.end + twice.len(),
        );
        let bare = &map[whole.clone()].replace('"', "");
        self.check("attribute without quotes", whole, bare, Some(rule_ids::XML), tag.place.clone());
        if is(TEXTS) {
            return;
        }
        let is_number = old.parse::<f64>().is_ok();
        let rule = if is_number { rule_ids::VALUE } else { rule_ids::ENUMERATION };
        let at = value.start..value.start;
        // A lane's boolean, and the words of a road's speed, are no enumerations.
        let rule = if matches!(old, "true" | "false") { rule_ids::VALUE } else { rule };
        self.check("value mistyped", value.clone(), "abc", Some(rule), at.clone());
        self.check("value emptied", value.clone(), "", Some(rule_ids::EMPTY), at.clone());
        if is_number {
            self.check(
                "value not a number",
                value.clone(),
                "NaN",
                Some(rule_ids::FINITE),
                at.clone(),
            );
            self.check(
                "value with a space",
                value.clone(),
                &format!("{old} "),
                Some(rule_ids::SPACE),
                at.clone(),
            );
            if matches!(attribute, "s" | "length" | "sOffset") {
                self.check("value out of range", value.clone(), "-1", Some(rule_ids::RANGE), at);
            }
        }
    }

    fn element(&mut self, tag: &Tag, tags: &[Tag]) {
        let map = self.map;
        let parent = &tags[tag.parent];
        let (name, whole) = (tag.name.as_str(), tag.whole.clone());
        let siblings = tags.iter().filter(|other| other.parent == tag.parent);
        let alike = siblings.clone().filter(|other| other.name == name).count();
        let renamed = map[whole.clone()].replacen(&format!("<{name}"), "<unheardOf", 1);
        let renamed = match renamed.strip_suffix(&format!("</{name}>")) {
            Some(start) => format!("{start}</unheardOf>"),
            None => renamed,
        };
        self.check(
            "element renamed",
            whole.clone(),
            &renamed,
            Some(rule_ids::UNKNOWN_ELEMENT),
            tag.place.clone(),
        );
        let text = format!("stray{}", &map[whole.clone()]);
        self.check(
            "text put before an element",
            whole.clone(),
            &text,
            Some(rule_ids::TEXT),
            whole.start..whole.start,
        );
        let cut = map[tag.place.start..tag.place.end].trim_end_matches('>');
        self.check(
            "tag without its end",
            tag.place.clone(),
            cut,
            Some(rule_ids::XML),
            tag.place.start..map.len(),
        );
        if whole != tag.place {
            let end = map[whole.clone()].rfind("</").expect("an end tag") + whole.start;
            self.check("end tag dropped", end..whole.end, "", Some(rule_ids::XML), end..map.len());
        }
        if REQUIRED.contains(&name) && alike == 1 {
            self.check(
                "element removed",
                whole.clone(),
                "",
                Some(if name == "header" { rule_ids::HEADER } else { rule_ids::ELEMENT }),
                parent.place.clone(),
            );
        }
        if CHOSEN.contains(&name) {
            self.check(
                "choice removed",
                whole.clone(),
                "",
                Some(rule_ids::CHOICE),
                parent.place.clone(),
            );
            let other = if name == "line" { "<arc curvature=\"1\"/>" } else { "<line/>" };
            let both = format!("{}{other}", &map[whole.clone()]);
            self.check(
                "two choices",
                whole.clone(),
                &both,
                Some(rule_ids::CHOICE),
                parent.place.clone(),
            );
        }
        if SINGLE.contains(&name) {
            let twice = map[whole.clone()].repeat(2);
            self.check(
                "element doubled",
                whole.clone(),
                &twice,
                Some(rule_ids::OCCURRENCE),
                whole.end..whole.end,
            );
        }
        for (_, before) in ORDER.iter().filter(|(moved, _)| *moved == name) {
            let Some(target) = siblings
                .clone()
                .find(|other| other.name == *before && other.place.start < whole.start)
            else {
                continue;
            };
            let start = target.place.start;
            let text = format!(
                "{}{}{}{}",
                &map[..start],
                &map[whole.clone()],
                &map[start..whole.start],
                &map[whole.end..]
            );
            let at = start + whole.len();
            self.whole("element moved", &text, Some(rule_ids::ORDER), at..at);
        }
    }
}

/// Makes every mutation of every so many tags.
fn mutate(name: &str, step: usize) -> usize {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/maps").join(name);
    let map = std::fs::read_to_string(path).expect("it is carried");
    let tags = tags(&map);
    let mut check = Check { map: &map, known: read(&map), counts: BTreeMap::new() };
    for tag in tags.iter().skip(1).step_by(step) {
        check.element(tag, &tags);
        for (name, value) in &tag.attributes {
            check.attribute(tag, name, value);
        }
    }
    // The harness swallows what is not written to stderr itself.
    let _ = writeln!(std::io::stderr(), "{name}: {:?}", check.counts);
    check.counts.values().sum()
}

#[test]
fn every_mutation_is_found() {
    assert!(mutate("one_road.xodr", 1) > 500);
    assert!(mutate("town.xodr", 31) > 500);
}
