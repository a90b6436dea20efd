//! What files say beyond what has a table of its own (docs/annotations.md), by the innermost part around it that has a row.
//!
//! Elements are walked over without knowing their types. While a part is lowered, the start tags of what gets a row are
//! noted; whatever is found in a part belongs to the nearest of these.

use crate::draft::{Draft, Owner};
use mapd_archive::{AnnotationKind, AnnotationOwner, AnnotationRow};
use mapd_xodr::source::NearPlaces;
use mapd_xodr::{Extension, ExtensionKind, Span, Written};

/// Elements of one `dataQuality` that are kept value by value; the standard has three.
const MOST_QUALITY_ELEMENTS: usize = 16;

/// An element on the way down.
struct AncestorElement {
    tag: &'static str,
    /// Among those of one tag, from 1; 0 where there can be only one.
    number: u32,
    start: u64,
}

/// A walk over a top-level element.
struct Walk<'a> {
    draft: &'a mut Draft,
    places: &'a NearPlaces,
    /// Whether all stands in one file: then there is nothing to say of an element that is bare.
    is_one_file: bool,
    /// What the whole belongs to.
    owner: Owner,
    /// Path of the whole below that.
    path: &'a str,
    frames: Vec<AncestorElement>,
}

impl Draft {
    /// Takes what stands in a top-level element beyond what has a table of its own. It belongs to `owner` and stands at
    /// `path` below it, unless something in between has a row.
    pub(crate) fn annotate(
        &mut self,
        element: &dyn Written,
        owner: Owner,
        path: &str,
        places: &NearPlaces,
    ) {
        let is_one_file = places.all.is_one_file();
        if is_one_file && element.is_bare() {
            return;
        }
        self.owners.sort();
        let mut walk = Walk { draft: self, places, is_one_file, owner, path, frames: Vec::new() };
        walk.element(element, 0);
    }

    /// Takes what stands in the root.
    pub(crate) fn annotate_root(&mut self, extensions: &[Extension], places: &NearPlaces) {
        let owner = (AnnotationOwner::Document, 0);
        let is_one_file = places.all.is_one_file();
        let mut walk =
            Walk { draft: self, places, is_one_file, owner, path: "", frames: Vec::new() };
        extensions.iter().for_each(|extension| walk.extension(extension));
    }
}

/// What is said of a place.
#[derive(Default)]
struct AnnotatedValue<'a> {
    /// Path below the element.
    tail: &'a str,
    name: &'a str,
    value: &'a str,
    text: &'a str,
}

impl Walk<'_> {
    /// An element whose parent stands in a file.
    fn element(&mut self, element: &dyn Written, file: u16) {
        let span = element.span();
        let own_file = self.places.all.file_at(span.start);
        if own_file != file {
            // Its name is filled in when all files are known.
            self.add(AnnotationKind::SourceFile, span, AnnotatedValue::default());
        }
        element.kept(&mut |name, value| {
            let value = value.shown();
            self.add(
                AnnotationKind::Attribute,
                span,
                AnnotatedValue { name, value: &value, ..AnnotatedValue::default() },
            );
        });
        element.extensions().into_iter().for_each(|extension| self.extension(extension));
        element.children(&mut |tag, number, child| {
            if self.is_one_file && child.is_bare() {
                return;
            }
            self.frames.push(AncestorElement { tag, number, start: child.span().start });
            self.element(child, own_file);
            self.frames.pop();
        });
    }

    fn extension(&mut self, extension: &Extension) {
        let span = extension.span;
        let element = extension.element().unwrap_or_default();
        let attribute = |name: &str| {
            let found = element.attributes.iter().find(|(key, _)| key == name);
            found.map_or("", |(_, value)| value)
        };
        match extension.kind {
            ExtensionKind::UserData => {
                let (name, value) = (attribute("code"), attribute("value"));
                let said = AnnotatedValue {
                    name,
                    value,
                    text: extension.inner(),
                    ..AnnotatedValue::default()
                };
                self.add(AnnotationKind::UserData, span, said);
            }
            ExtensionKind::Include => {
                let said = AnnotatedValue { name: attribute("file"), ..AnnotatedValue::default() };
                self.add(AnnotationKind::Include, span, said);
            }
            ExtensionKind::DataQuality => {
                for one in extension.elements(MOST_QUALITY_ELEMENTS) {
                    for (name, value) in &one.attributes {
                        let said = AnnotatedValue { tail: &one.path, name, value, text: "" };
                        self.add(AnnotationKind::DataQuality, span, said);
                    }
                }
                let said = AnnotatedValue {
                    name: &element.path,
                    text: &extension.text,
                    ..AnnotatedValue::default()
                };
                self.add(AnnotationKind::DataQuality, span, said);
            }
            ExtensionKind::Unknown | ExtensionKind::Foreign => {
                let is_foreign = extension.kind == ExtensionKind::Foreign;
                let kind = match is_foreign {
                    true => AnnotationKind::ForeignElement,
                    false => AnnotationKind::UnknownElement,
                };
                let said = AnnotatedValue {
                    name: &element.path,
                    text: &extension.text,
                    ..AnnotatedValue::default()
                };
                self.add(kind, span, said);
            }
        }
    }

    fn add(&mut self, kind: AnnotationKind, span: Span, said: AnnotatedValue<'_>) {
        if self.draft.without.leaves_out(kind) {
            return;
        }
        let ((owner_kind, owner), mut path) = self.place();
        if !said.tail.is_empty() {
            path.push_str(if path.is_empty() { "" } else { "/" });
            path.push_str(said.tail);
        }
        let at = self.places.position(span.start);
        let strings = &mut self.draft.strings;
        let row = AnnotationRow {
            owner,
            path: strings.add(&path),
            name: strings.add(said.name),
            value: strings.add(said.value),
            text: strings.add(said.text),
            line: at.line,
            column: at.column,
            file: self.places.all.file_at(span.start),
            kind: kind.code(),
            owner_kind: owner_kind.code(),
        };
        self.draft.rows.annotations.push(row);
    }

    /// The owner of where the walk stands, and the path from it on.
    fn place(&self) -> (Owner, String) {
        let row_of = |frame: &AncestorElement| self.draft.owners.at(frame.start);
        let nearest = self.frames.iter().enumerate().rev();
        let nearest = nearest.filter_map(|(i, frame)| Some((i + 1, row_of(frame)?))).next();
        let (from, owner) = nearest.unwrap_or((0, self.owner));
        let mut path = if from == 0 { self.path.to_owned() } else { String::new() };
        for frame in self.frames.iter().skip(from) {
            if !path.is_empty() {
                path.push('/');
            }
            path.push_str(frame.tag);
            if frame.number > 0 {
                path.push_str(&format!("[{}]", frame.number));
            }
        }
        (owner, path)
    }
}
