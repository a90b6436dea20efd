//! What is said where an element is not as the schema has it. Nothing here runs for sound elements.

use crate::cursor::{Cursor, Open, RawAttribute};
use crate::finding::{Severity, Span};
use crate::rule_ids;
use crate::schema::{
    AttributeSchema, ChildSchema, Choice, Kind, NAMES, V1_8, Versions, alike, attribute,
};
use crate::well_formed::Fault;

/// The schema of text inside an element.
pub(crate) static CONTENT: AttributeSchema = attribute("text", Kind::Text);

/// The bits that are set, from the lowest on.
fn bits(set: u64) -> impl Iterator<Item = usize> {
    let without_lowest = |rest: &u64| Some(rest & rest.wrapping_sub(1));
    let rests = std::iter::successors(Some(set), without_lowest);
    rests.take_while(|rest| *rest != 0).map(|rest| rest.trailing_zeros() as usize)
}

/// Versions in words: "1.5 to 1.7", "1.8 on".
fn words(versions: Versions) -> String {
    let ranks: Vec<usize> = (0..NAMES.len()).filter(|rank| versions >> rank & 1 == 1).collect();
    match (ranks.first(), ranks.last()) {
        (Some(first), Some(last)) if last + 1 == NAMES.len() => format!("{} on", NAMES[*first]),
        (Some(first), Some(last)) if first == last => NAMES[*first].to_owned(),
        (Some(first), Some(last)) => format!("{} to {}", NAMES[*first], NAMES[*last]),
        _ => "no version".to_owned(),
    }
}

/// The version that is stated in words; of one that there is not, that which is checked instead.
pub(crate) fn standard(stated: &str, version: usize) -> String {
    let name = if NAMES.contains(&stated) { stated } else { NAMES[version] };
    format!("OpenDRIVE {name}")
}

impl Cursor<'_> {
    /// The version in words, as findings name it.
    pub(crate) fn standard(&self) -> String {
        standard(&self.stated, self.version)
    }

    /// The place of a raw attribute's value.
    pub(crate) fn span_of(&self, raw: RawAttribute) -> Span {
        let (from, to) = raw.value;
        Span { start: self.element.start + u64::from(from), len: to.saturating_sub(from) }
    }

    /// An attribute of the tag by its name.
    pub(crate) fn find_attribute(&self, name: &str) -> Option<RawAttribute> {
        self.tag.attributes.iter().copied().find(|raw| self.bytes(raw.name) == name.as_bytes())
    }

    /// Text of an attribute of the tag; empty where there is none.
    pub(crate) fn attribute_text(&self, name: &str) -> String {
        self.find_attribute(name)
            .map(|raw| String::from_utf8_lossy(self.bytes(raw.value)).into_owned())
            .unwrap_or_default()
    }

    /// An attribute twice in one tag.
    #[cold]
    pub(crate) fn twice(&mut self, raw: RawAttribute) {
        self.find_key();
        let start = self.element.start + u64::from(raw.name.0);
        self.fault(start, Fault::Duplicate);
    }

    /// An attribute that the schema does not have in this element.
    #[cold]
    pub(crate) fn other_attribute(&mut self, raw: RawAttribute) {
        self.find_key();
        let name = self.bytes(raw.name);
        let same = self.tag.attributes.iter().filter(|other| self.bytes(other.name) == name);
        if same.take_while(|other| other.name != raw.name).count() > 0 {
            return self.twice(raw);
        }
        // Declarations of namespaces and attributes of other namespaces are no matter of the standard's.
        if name.is_empty() || name == b"xmlns" || name.contains(&b':') {
            return;
        }
        let name = String::from_utf8_lossy(name).into_owned();
        let message =
            format!("expected no @{name}, which the standard does not have here, found it");
        let span = self.span_of(raw);
        self.add(rule_ids::UNKNOWN_ATTRIBUTE, Severity::Warning, span, &name, message);
    }

    /// Attributes that are there with a remark or missing, as bits.
    #[cold]
    pub(crate) fn check_attributes(&mut self, open: &mut Open, odd: u64, missing: u64) {
        if let Some(variant) = open.schema.variant {
            open.variant = variant(open.variant, &self.attribute_text("type"));
        }
        let attributes = open.schema.attributes;
        for slot in bits(odd) {
            let Some(a) = attributes.get(slot) else { continue };
            let span = self.find_attribute(a.name).map(|raw| self.span_of(raw));
            let facts = Facts { versions: a.versions, deprecated: a.deprecated, when: a.when };
            self.check_age(open, ("@", a.name), facts, span.unwrap_or(open.span));
        }
        let bit = 1 << self.version;
        for slot in bits(missing) {
            let Some(a) = attributes.get(slot) else { continue };
            if !self.is_for(open, a.when) {
                continue;
            }
            let is_error = a.required & bit != 0;
            let severity = if is_error { Severity::Error } else { Severity::Warning };
            self.add_by_standard(rule_ids::MISSING, severity, open.span, a.name, |standard| {
                let name = a.name;
                if is_error {
                    let but =
                        if a.not_by_text { " by its schema, though not by its text" } else { "" };
                    format!("expected @{name}, required in {standard}{but}, found none")
                } else {
                    format!(
                        "expected @{name}, required by the text of {standard}, though not by its schema, found none"
                    )
                }
            });
        }
    }

    /// Whether an element's variant has something; the schema tells variants apart from 1.8 on.
    fn is_for(&self, open: &Open, when: u8) -> bool {
        self.version < usize::from(V1_8) || when >> open.variant & 1 == 1
    }

    /// Says what there is to say about something of another version or variant.
    fn check_age(&mut self, open: &Open, (mark, name): (&str, &str), facts: Facts, span: Span) {
        let bit: Versions = 1 << self.version;
        let versions = facts.versions;
        if versions & alike(self.version as u8) == 0 {
            let rule = rule_ids::OTHER_VERSION;
            self.add_by_standard(rule, Severity::Warning, span, name, |standard| {
                let others = words(versions);
                format!(
                    "expected no {mark}{name} in {standard}, found it; the standard has it in {others}"
                )
            });
        } else if versions & bit == 0 {
            self.add_by_standard(rule_ids::OTHER_VERSION, Severity::Info, span, name, |_| {
                let others = words(versions);
                format!(
                    "expected no {mark}{name}, which {others} has but later versions do not, found it"
                )
            });
        } else if facts.deprecated & bit != 0 {
            self.add_by_standard(rule_ids::DEPRECATED, Severity::Info, span, name, |standard| {
                format!("expected no {mark}{name}, deprecated in {standard}, found it")
            });
        }
        if !self.is_for(open, facts.when) {
            let variant = open.schema.variants.get(usize::from(open.variant)).unwrap_or(&"this");
            self.add_by_standard(rule_ids::VARIANT, Severity::Warning, span, name, |standard| {
                format!(
                    "expected no {mark}{name} in an element of kind {variant} in {standard}, found it"
                )
            });
        }
    }

    /// A child that stands where or when it should not, or again.
    #[cold]
    pub(crate) fn check_child(&mut self, open: &Open, child: &ChildSchema, again: bool) {
        let span = self.tag.span;
        let facts =
            Facts { versions: child.versions, deprecated: child.deprecated, when: child.when };
        self.check_age(open, ("", child.name), facts, span);
        if again {
            let name = child.name;
            self.add_by_standard(rule_ids::OCCURRENCE, Severity::Error, span, name, |standard| {
                format!(
                    "expected {name} at most once in {standard}, found it again; the first is used"
                )
            });
        }
        if child.order < open.order {
            let message = self.misplaced(open, child);
            self.add(rule_ids::ORDER, Severity::Warning, span, child.name, message);
        }
    }

    /// What there is to say about a child behind others that it should stand before.
    pub(crate) fn misplaced(&self, open: &Open, child: &ChildSchema) -> String {
        let last = open
            .schema
            .children
            .iter()
            .rev()
            .find(|c| c.order == open.order && c.versions & alike(self.version as u8) != 0);
        let last = last.or_else(|| open.schema.children.iter().find(|c| c.order == open.order));
        let last = last.map_or("", |last| last.name);
        format!("expected {} before {last}, found it after", child.name)
    }

    /// Children of which there are too many or too few, as many as there are, and the number that is due instead.
    #[inline]
    pub(crate) fn miscounted(
        &self,
        open: &Open,
    ) -> impl Iterator<Item = (&'static ChildSchema, u16, u16)> {
        let (schema, counts) = (open.schema, open.counts);
        bits(schema.counted).filter_map(move |slot| {
            let child = schema.children.get(slot)?;
            let count = self.counts.get(counts + slot).copied().unwrap_or(0);
            let (min, max) = child.occurs[self.version];
            let due = if count > max { max } else { min };
            (count > max || (count > 0 && count < min)).then_some((child, count, due))
        })
    }

    /// Children that are missing, as bits; counts and choices.
    #[cold]
    pub(crate) fn check_children(&mut self, open: &Open, missing: u64) {
        let children = open.schema.children;
        let standard = self.standard();
        self.element = open.span;
        self.kind = open.schema;
        for slot in bits(missing) {
            let Some(child) = children.get(slot).filter(|c| self.is_for(open, c.when)) else {
                continue;
            };
            let message =
                format!("expected the element {}, required in {standard}, found none", child.name);
            let is_header = child.name == "header";
            let rule = if is_header { rule_ids::HEADER } else { rule_ids::ELEMENT };
            self.add(rule, Severity::Error, open.span, child.name, message);
        }
        let miscounted: Vec<_> = self.miscounted(open).collect();
        for (child, count, due) in miscounted {
            let bound = if count > due { "at most" } else { "at least" };
            let message =
                format!("expected {bound} {due} {} in {standard}, found {count}", child.name);
            self.add(rule_ids::OCCURRENCE, Severity::Error, open.span, child.name, message);
        }
        let chosen = (open.children & open.schema.chosen).count_ones();
        let alternatives: Vec<&str> = bits(open.schema.chosen)
            .filter_map(|slot| children.get(slot))
            .filter(|child| child.versions & alike(self.version as u8) != 0)
            .map(|child| child.name)
            .collect();
        let found = match (open.schema.choice, chosen) {
            (Choice::One, 0) => "none".to_owned(),
            (Choice::One | Choice::AtMostOne, 2..) => format!("{chosen} of them"),
            _ => return,
        };
        let message = format!("expected one of {}, found {found}", alternatives.join(", "));
        self.add(rule_ids::CHOICE, Severity::Error, open.span, "", message);
    }
}

/// In which versions and variants something may stand.
struct Facts {
    versions: Versions,
    deprecated: Versions,
    when: u8,
}
