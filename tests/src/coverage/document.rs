//! A document of the tests and where its values stand: plain XML, quotes doubled, no comments.

use mapd_schemas::opendrive::{Element, Table};
use std::ops::Range;

/// Where a value stands: of an attribute, of the text of an element, or an element as a whole.
#[derive(Clone, Debug)]
pub(super) struct ValueLocation {
    element: String,
    attribute: String,
    pub(super) range: Range<usize>,
    /// Whether it is an element as a whole.
    pub(super) is_element: bool,
}

/// A document and the places of its values.
pub(super) struct Document {
    pub(super) text: String,
    pub(super) places: Vec<ValueLocation>,
}

/// Elements that may stand anywhere.
const ANYWHERE: [(&str, &str); 3] =
    [("userData", "UserData"), ("include", "Include"), ("dataQuality", "DataQuality")];

impl Document {
    /// Finds the values of a text by the table.
    pub(super) fn read(table: &Table, text: String) -> Self {
        let (mut places, mut open): (Vec<ValueLocation>, Vec<(&Element, usize, usize)>) =
            Default::default();
        let mut at = 0;
        while let Some(start) = text[at..].find('<').map(|start| at + start) {
            let end = start + text[start..].find('>').expect("a tag ends") + 1;
            at = end;
            let tag = &text[start + 1..end - 1];
            if tag.starts_with('?') {
                continue;
            }
            if tag.starts_with('/') {
                let (element, from, inside) = open.pop().expect("an element is open");
                close(element, (from, inside, start, end), &mut places);
                continue;
            }
            let name_end = tag.find(|c: char| c.is_whitespace() || c == '/').unwrap_or(tag.len());
            let element = kind_of(table, open.last().map(|(parent, ..)| *parent), &tag[..name_end]);
            attributes(element, tag, start + 1, &mut places);
            if tag.ends_with('/') {
                close(element, (start, end, end, end), &mut places);
            } else {
                open.push((element, start, end));
            }
        }
        Self { text, places }
    }

    /// Where an attribute of a type of element stands; without a name, its text, or the element itself.
    pub(super) fn places(
        &self,
        element: &str,
        attribute: &str,
    ) -> impl Iterator<Item = &ValueLocation> {
        self.places.iter().filter(move |p| p.element == element && p.attribute == attribute)
    }

    /// The text with another value at a place.
    pub(super) fn with(&self, place: &ValueLocation, value: &str) -> String {
        let (before, behind) = (&self.text[..place.range.start], &self.text[place.range.end..]);
        // Lines stay what they are.
        let lines = self.text[place.range.clone()].matches('\n').count();
        format!(
            "{before}{value}{}{behind}",
            "\n".repeat(lines.saturating_sub(value.matches('\n').count()))
        )
    }

    /// The value at a place.
    pub(super) fn value(&self, place: &ValueLocation) -> &str {
        &self.text[place.range.clone()]
    }
}

fn close(
    element: &Element,
    (from, inside, until, end): (usize, usize, usize, usize),
    places: &mut Vec<ValueLocation>,
) {
    let (is_element, range) = match element.content {
        Some(_) => (false, inside..until),
        None => (true, from..end),
    };
    places.push(ValueLocation {
        element: element.name.clone(),
        attribute: String::new(),
        range,
        is_element,
    });
}

fn attributes(element: &Element, tag: &str, start: usize, places: &mut Vec<ValueLocation>) {
    let mut at = 0;
    while let Some(equals) = tag[at..].find("=\"").map(|equals| at + equals) {
        let name = tag[..equals].rsplit(char::is_whitespace).next().unwrap_or_default();
        let from = equals + 2;
        let until = from + tag[from..].find('"').expect("a value ends");
        places.push(ValueLocation {
            element: element.name.clone(),
            attribute: name.to_owned(),
            range: start + from..start + until,
            is_element: false,
        });
        at = until + 1;
    }
}

fn kind_of<'a>(table: &'a Table, parent: Option<&Element>, tag: &str) -> &'a Element {
    let anywhere = ANYWHERE.iter().find(|(name, _)| *name == tag).map(|(_, kind)| *kind);
    let child = parent.and_then(|parent| parent.children.iter().find(|child| child.name == tag));
    let kind = child.map(|child| child.kind.as_str()).or(anywhere).unwrap_or("OpenDrive");
    assert!(kind != "OpenDrive" || parent.is_none(), "no element {tag} here");
    table.element(kind).expect("an element of the table")
}
